#include "sim/watch/sample.h"

#include <stdlib.h>
#include <string.h>

#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/roller_motion.h"
#include "sim/equipment/winch.h"
#include "theory/stretches.h"

/* The next `count` numbers of the memory. */
static double *piece_of(double **memory, size_t count)
{
    double *const piece = *memory;
    *memory += count;
    return piece;
}

int sample_alloc(SampleBuffers *b, const Scene *scene)
{
    const int rollers = scene->contact.n_rollers, surfaces = scene->surfaces.model.n_surfaces;
    const size_t n = (size_t)scene->total, nr = (size_t)rollers, ns = (size_t)surfaces;
    *b = (SampleBuffers){.memory = calloc(18 * n + 3 + 6 * nr + 4 * ns, sizeof(double))};
    if (!b->memory) return 0;
    double *memory = b->memory;
    b->position = piece_of(&memory, 3 * n);
    b->quaternion = piece_of(&memory, 4 * n);
    b->velocity = piece_of(&memory, 3 * n);
    b->omega = piece_of(&memory, 3 * n);
    b->axial_speed = piece_of(&memory, n);
    b->tension = piece_of(&memory, n + 1);
    b->roller_load = piece_of(&memory, nr);
    for (int k = 0; k < 2 && scene->equipment->n > 0; ++k) { /* NAN for good where a roller does not move */
        b->moving[k] = piece_of(&memory, nr);
        for (int r = 0; r < rollers; ++r) b->moving[k][r] = NAN;
    }
    for (int k = 0; k < 4; ++k) b->surface[k] = piece_of(&memory, ns);
    b->curvature = piece_of(&memory, n + 1);
    b->sidewall = piece_of(&memory, n + 1);
    b->contact_line_load = piece_of(&memory, n);
    b->roller_force = piece_of(&memory, 3 * nr);
    b->sample = (hawser_sample){.segments = scene->total,
                                .joints = scene->total + 1,
                                .rollers = rollers,
                                .position = b->position,
                                .quaternion = b->quaternion,
                                .velocity = b->velocity,
                                .omega = b->omega,
                                .tension = b->tension,
                                .axial_speed = b->axial_speed,
                                .roller_load = b->roller_load,
                                .roller_spin = b->moving[0],
                                .roller_shift = b->moving[1],
                                .head_at = NAN,
                                .reference = NAN,
                                .surfaces = surfaces,
                                .surface_normal = b->surface[0],
                                .surface_friction = b->surface[1],
                                .surface_line_load = b->surface[2],
                                .surface_at = b->surface[3],
                                .field = {b->curvature, b->sidewall, b->contact_line_load, b->roller_force}};
    return 1;
}

void sample_free(SampleBuffers *b)
{
    free(b->memory);
    *b = (SampleBuffers){0};
}

/* Structure of arrays to one row a segment. */
static void rows_from(int n, int width, double *const *column, double *row)
{
    for (int c = 0; c < width; ++c) {
        for (int i = 0; i < n; ++i) row[width * i + c] = column[c][i];
    }
}

static void state_take(SampleBuffers *b, const Kinematics *kin, int first, int n)
{
    rows_from(n, 3, kin->p, b->position + 3 * first);
    rows_from(n, 4, kin->q, b->quaternion + 4 * first);
    rows_from(n, 3, kin->v, b->velocity + 3 * first);
    rows_from(n, 3, kin->w, b->omega + 3 * first);
}

static void speed_take(SampleBuffers *b, const Kinematics *kin, int first, int n)
{
    for (int i = 0; i < n; ++i) {
        b->axial_speed[first + i] =
            kin->v[0][i] * kin->a[0][i] + kin->v[1][i] * kin->a[1][i] + kin->v[2][i] * kin->a[2][i];
    }
}

/* N along the segment of a rod's end about which it turns freely (segment 0's joint, or the last one's): the law's
 * frame lies half way between the segment and the ground, which does not turn. */
static double turned_tension(const Scene *scene, const Workspace *ws, int j)
{
    const int i = j == 0 ? 0 : j - 1;
    const Kinematics *const kin = &ws->kin;
    const Vec3 force = v3(ws->law[0][j], ws->law[1][j], ws->law[2][j]);
    const Quat before = {kin->q[0][j - 1], kin->q[1][j - 1], kin->q[2][j - 1], kin->q[3][j - 1]};
    const Quat behind = {kin->q[0][j], kin->q[1][j], kin->q[2][j], kin->q[3][j]};
    const Vec3 turn = quat_log(quat_mul(quat_conj(before), behind));
    const double share = scene->chain.frame == FRAME_SYMMETRIC ? 0.5 : 1;
    const Quat frame = quat_mul(before, quat_exp(v3_scale(share, turn)));
    return v3_dot(quat_rotate(frame, force), v3_load(kin->a, i));
}

/* Whether a rod's end turns about its joint. */
static int turns_freely(const Scene *scene, int j)
{
    const Chain *const c = &scene->chain;
    return scene->rod->present && c->stiffness[0][j] > 0 && !(c->stiffness[4][j] > 0) && !(c->stiffness[5][j] > 0);
}

static void tension_take(SampleBuffers *b, const Scene *scene, const Workspace *ws)
{
    const int n = scene->chain.n, first = scene->first;
    hawser_sample *const s = &b->sample;
    double *const tension = b->tension + first;
    memcpy(tension, ws->law[0], (size_t)(n + 1) * sizeof(double));
    for (int j = 0; j <= n; j += n)
        if (turns_freely(scene, j)) tension[j] = turned_tension(scene, ws, j);
    if (!scene->rod->present) tension[0] = s->tail_tension;
    if (scene->winch->mode == WINCH_TENSION || ws->led.present) tension[n] = s->winch_force; /* no bushing carries it */
    Vec3 axis[2];
    if (winch_free_axes(scene->winch, &scene->def.winch, axis) > 0)
        tension[n] = s->winch_force * v3_dot(scene->winch->direction, v3_load(ws->kin.a, n - 1));
    s->max_tension_joint = first;
    for (int j = 1; j <= n; ++j) {
        if (tension[j] > b->tension[s->max_tension_joint]) s->max_tension_joint = first + j;
    }
    s->max_tension = b->tension[s->max_tension_joint];
}

double sample_joint_place(const Scene *scene, const hawser_sample *sample, int j)
{
    return scene->joint_s[scene->first + j] + sample->winch_travel;
}

double sidewall_at(const Scene *scene, double s, double tension)
{
    const double turn = route_turn(&scene->route, s);
    return turn > 0 ? tension * turn * bundle_share(&scene->def, supports_surface(&scene->setup.supports, s)) : 0;
}

/* What there is along the chain besides tension, of the segments that are simulated; the others have none of it. A rod
 * has no route that could press on it. */
static void fields_take(SampleBuffers *b, const Scene *scene, const Workspace *ws)
{
    const int n = scene->chain.n, first = scene->first, eye = scene->eye - first;
    memset(b->curvature, 0, ((size_t)scene->total + 1) * sizeof(double));
    memset(b->sidewall, 0, ((size_t)scene->total + 1) * sizeof(double));
    memset(b->contact_line_load, 0, (size_t)scene->total * sizeof(double));
    for (int i = 1; i < n; ++i) {
        const double length = scene->chain.half[i - 1] + scene->chain.half[i];
        b->curvature[first + i] = curvature_between(v3_load(ws->kin.a, i - 1), v3_load(ws->kin.a, i), length);
    }
    for (int j = 0; j <= n && j <= eye && !scene->rod->present; ++j)
        b->sidewall[first + j] = sidewall_at(scene, sample_joint_place(scene, &b->sample, j), b->tension[first + j]);
    for (int i = 0; i < n; ++i) {
        const Vec3 force = v3_add(v3_load(ws->loads[0].f, i), v3_load(ws->loads[1].f, i));
        b->contact_line_load[first + i] = v3_norm(force) / (2 * scene->chain.half[i]);
    }
    for (int r = 0; r < b->sample.rollers; ++r) v3_put(b->roller_force + 3 * r, ws->on_roller[r]);
}

static void winch_take(hawser_sample *s, const Scene *scene, const Workspace *ws, double t)
{
    const Winch *const w = scene->winch;
    if (ws->led.present) {
        s->winch_force = ws->head_pull;
        s->winch_speed = ws->led.speed;
        s->winch_travel = ws->led.travel;
    }
    if (!w->present) return;
    const WinchMotion motion = winch_motion(w, &scene->chain, &ws->kin, t);
    s->winch_force = ws->head_pull;
    s->winch_speed = motion.speed;
    s->winch_travel = motion.travel;
}

static void surfaces_take(SampleBuffers *b, const Workspace *ws)
{
    hawser_sample *const s = &b->sample;
    for (int i = 0; i < s->surfaces; ++i) {
        const SurfaceTally *const tally = &ws->on_surface[i];
        b->surface[0][i] = tally->normal;
        b->surface[1][i] = tally->friction;
        b->surface[2][i] = tally->line_load;
        b->surface[3][i] = tally->at;
    }
}

/* The reel, and the back tension that it gives. */
static void reel_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t)
{
    hawser_sample *const s = &b->sample;
    s->tail_tension = profile_value(&scene->tail, t);
    s->reel_speed = s->paid_out = s->wound = NAN;
    if (scene->reel->winding.turns > 0) { /* empty, once its cable has left it */
        s->reel_speed = s->wound = 0;
        s->paid_out = scene->reel->total;
    }
    if (!scene->reel->present) return;
    const ReelLook look = reel_look(scene->reel, &scene->chain, &ws->kin, &ws->joints, t);
    s->tail_tension = look.tension;
    s->reel_speed = look.speed;
    s->paid_out = look.paid_out;
    s->wound = look.wound;
}

static void moving_take(SampleBuffers *b, const EquipmentWork *w)
{
    for (int k = 0; k < w->q->n; ++k) {
        const MovingRoller *const item = &w->q->item[k];
        const int r = item->roller;
        if (item->spin >= 0) b->moving[0][r] = v3_dot(w->motion[r].w, w->roller[r].shape.axis);
        if (item->mount >= 0) b->moving[1][r] = equipment_shift(w, item);
    }
}

const hawser_sample *sample_take(SampleBuffers *b, const Scene *scene, const Workspace *ws, double t, int active,
                                 SampleParts parts)
{
    hawser_sample *const s = &b->sample;
    const int n = scene->chain.n;
    s->t = t;
    s->first = scene->first;
    s->active = n;
    s->active_contacts = active;
    if (parts == SAMPLE_ALL) state_take(b, &ws->kin, scene->first, n);
    speed_take(b, &ws->kin, scene->first, n);
    winch_take(s, scene, ws, t);
    reel_take(b, scene, ws, t);
    tension_take(b, scene, ws);
    if (parts >= SAMPLE_FIELDS) fields_take(b, scene, ws);
    if (n < scene->total) absent_take(b, scene, s, parts);
    for (int r = 0; r < s->rollers; ++r) b->roller_load[r] = v3_norm(ws->on_roller[r]);
    surfaces_take(b, ws);
    if (ws->equipment) moving_take(b, ws->equipment);
    return s;
}
