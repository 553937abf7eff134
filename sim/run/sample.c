#include "sim/run/sample.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/winch.h"
#include "sim/joints.h"
#include "theory/expected.h"
#include "theory/setup.h"

/* ------------------------------------------------------------------------------------- strain within a segment */

/* Shares and compliances of a place whose segment and arm are known: the half-spring of its side in series with what is
 * beyond the joint, or alone where the end is held; zero where it is free (RD15). */
static void strain_fill(const Scene *scene, ProbePlace *p)
{
    const Chain *const c = &scene->chain;
    const int ahead = p->arm >= 0, j = p->segment + ahead, other = ahead ? p->segment + 1 : p->segment - 1;
    const double half = c->half[p->segment], reach = fabs(p->arm) / half;
    const Bushing own = joints_clamp(scene, p->segment);
    const int inside = other >= 0 && other < c->n;
    const Bushing beyond = inside ? joints_clamp(scene, other) : own;
    for (int k = 0; k < COMPONENTS; ++k) {
        const double share = inside ? beyond.stiffness[k] / (own.stiffness[k] + beyond.stiffness[k]) : 1;
        p->share[k] = c->stiffness[k][j] > 0 ? reach * share : 0;
        p->compliance[k] = 1 / (own.stiffness[k] * half);
    }
}

/* Place of the cable, strained like its half of the segment: by the bushing on its side, and by the loads on that half
 * (RD15). */
typedef struct Strained {
    Vec3 position; /* m */
    Quat attitude;
} Strained;

static Vec3 scaled(const double by[3], Vec3 v) { return v3(by[0] * v.x, by[1] * v.y, by[2] * v.z); }

static Quat attitude_of(const Kinematics *kin, int i)
{
    return (Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
}

/* End of segment i (or of the ground) at its joint ahead or behind, m. */
static Vec3 end_of(const Scene *scene, const Kinematics *kin, int i, int ahead)
{
    return v3_axpy(v3_load(kin->p, i), (ahead ? 1 : -1) * scene->chain.half[i], v3_load(kin->a, i));
}

static Strained place_strained(const ProbePlace *p, const Scene *scene, const Kinematics *kin, double t)
{
    const int i = p->segment, ahead = p->arm >= 0, other = ahead ? i + 1 : i - 1;
    const Quat q = attitude_of(kin, i), back = quat_conj(q);
    const Vec3 gap = v3_sub(end_of(scene, kin, other, !ahead), end_of(scene, kin, i, ahead));
    Vec3 move = scaled(p->share, quat_rotate(back, gap));
    Vec3 turn = scaled(p->share + TORSION, quat_log(quat_mul(back, attitude_of(kin, other))));
    const Rod *const rod = scene->rod;
    for (int l = 0; l < rod->n_loads; ++l) {
        const RodLoad *const load = &rod->load[l];
        if (load->segment != i || load->arm * p->arm <= 0) continue;
        const RodWrench w = rod_wrench(load, kin, t);
        const double length = fmin(fabs(p->arm), fabs(load->arm));
        const Vec3 moment = v3_sub(w.moment, v3_cross(w.arm, w.force));
        move = v3_axpy(move, length, scaled(p->compliance, quat_rotate(back, w.force)));
        turn = v3_axpy(turn, length, scaled(p->compliance + TORSION, quat_rotate(back, moment)));
    }
    return (Strained){v3_add(v3_axpy(v3_load(kin->p, i), p->arm, v3_load(kin->a, i)), quat_rotate(q, move)),
                      quat_mul(q, quat_exp(turn))};
}

/* ------------------------------------------------------------------------------------------------------- probes */

/* Attitude of segment i in the initial state y; beyond the ends that of a rod's ground, or none. */
static Quat attitude_in(const Scene *scene, const double *y, int i)
{
    const int n = scene->chain.n;
    if (scene->rod->present) return rod_attitude(scene->rod, n, i);
    const double *const q = y + STATE_Q * n + (i < 0 ? 0 : i >= n ? n - 1 : i);
    return quat_unit((Quat){q[0], q[n], q[2 * n], q[3 * n]});
}

/* Finds segment, nearest joint, share of the segment's strain, and the pose at t = 0, when joints are closed. */
static void place_fill(const Scene *scene, const double *y, double at, ProbePlace *p)
{
    const int n = scene->chain.n;
    p->segment = rod_segment_at(&scene->chain, at, &p->arm);
    p->joint = p->segment + (p->arm >= 0);
    strain_fill(scene, p);
    const Quat q = attitude_in(scene, y, p->segment);
    const Quat next = attitude_in(scene, y, p->arm >= 0 ? p->segment + 1 : p->segment - 1);
    const Vec3 centre = v3(y[p->segment], y[n + p->segment], y[2 * n + p->segment]);
    p->position = v3_axpy(centre, p->arm, quat_rotate(q, v3(1, 0, 0)));
    p->attitude = quat_mul(q, quat_exp(scaled(p->share + TORSION, quat_log(quat_mul(quat_conj(q), next)))));
}

hawser_status probes_new(Probes *probes, const Scene *scene, hawser_error *err)
{
    const OutputDef *const def = &scene->def.output;
    *probes = (Probes){.n = def->n_probes};
    if (def->n_probes == 0) return HAWSER_OK;
    probes->place = calloc((size_t)def->n_probes, sizeof *probes->place);
    probes->out = calloc((size_t)def->n_probes, sizeof *probes->out);
    double *const y = malloc((size_t)scene_state_size(scene) * sizeof *y);
    if (!probes->place || !probes->out || !y) {
        free(y);
        return error_memory(err);
    }
    scene_initial_state(scene, y);
    for (int i = 0; i < def->n_probes; ++i) {
        place_fill(scene, y, def->probes[i].at, &probes->place[i]);
        probes->out[i].name = def->probes[i].name;
        probes->out[i].at = def->probes[i].at;
    }
    free(y);
    return HAWSER_OK;
}

void probes_free(Probes *probes)
{
    free(probes->place);
    free(probes->out);
    *probes = (Probes){0};
}

static void vector_put(Vec3 v, double out[3])
{
    out[0] = v.x;
    out[1] = v.y;
    out[2] = v.z;
}

static Vec3 entry(double *const *array, int i) { return v3(array[0][i], array[1][i], array[2][i]); }

/* Force of the part ahead of the joint on the part behind it: the bushing's force on the segment before the joint, and
 * its moment about that segment's end (RD9). */
static void section_look(const ProbePlace *p, const Scene *scene, const Workspace *ws, hawser_probe *out)
{
    const int a = p->joint - 1; /* a ghost at the tail: its end is its centre */
    const Vec3 force = entry(ws->joints.force, p->joint);
    const Vec3 arm = v3_scale(scene->chain.half[a], entry(ws->kin.a, a));
    vector_put(force, out->force);
    vector_put(v3_sub(entry(ws->joints.torque_a, p->joint), v3_cross(arm, force)), out->moment);
}

void probes_look(Probes *probes, const Scene *scene, Workspace *ws, double t)
{
    if (probes->n == 0) return;
    const Kinematics *const kin = &ws->kin;
    bushing_kernels()->loads(&scene->chain, kin, 0, scene->chain.n + 1, &ws->joints);
    for (int k = 0; k < probes->n; ++k) {
        const ProbePlace *const p = &probes->place[k];
        const Strained now = place_strained(p, scene, kin, t);
        hawser_probe *const out = &probes->out[k];
        vector_put(now.position, out->position);
        vector_put(v3_sub(now.position, p->position), out->displacement);
        vector_put(quat_log(quat_mul(now.attitude, quat_conj(p->attitude))), out->rotation);
        section_look(p, scene, ws, out);
    }
}

static void machine_set(MachineRecord *r, hawser_machine *out, hawser_figure *now, const Room *room, int item,
                        const Setup *setup, const struct Expected *expected)
{
    const MachineKind *const kind = room->kind->machines;
    *r =
        (MachineRecord){.room = room, .item = item, .expected = expected_push(setup, expected, kind->name(room, item))};
    for (int k = 0; k < kind->n_now; ++k) now[k] = (hawser_figure){kind->now[k], 0};
    for (int k = 0; k < kind->n_figures; ++k) r->figure[k] = (hawser_figure){kind->figure[k], NAN};
    *out = (hawser_machine){.kind = kind->key,
                            .name = kind->name(room, item),
                            .n_now = kind->n_now,
                            .now = now,
                            .n_figures = kind->n_figures,
                            .figure = r->figure};
}

static void figures_set(MachineRecord *r)
{
    double value[MACHINE_FIGURES_MAX];
    const MachineKind *const kind = r->room->kind->machines;
    kind->figures(r->room, r->item, r->kept, r->expected, value);
    for (int k = 0; k < kind->n_figures; ++k) r->figure[k].value = value[k];
}

static int count_of(const Room *room)
{
    return room->present && room->kind->machines ? room->kind->machines->count(room) : 0;
}

hawser_status machines_new(Machines *m, const Scene *scene, const struct Expected *expected, hawser_error *err)
{
    *m = (Machines){0};
    for (int r = 0; r < scene->n_rooms; ++r) {
        const int n = count_of(&scene->room[r]);
        m->n += n;
        if (n > 0) m->n_now += n * scene->room[r].kind->machines->n_now;
    }
    m->record = calloc((size_t)m->n + 1, sizeof *m->record);
    m->out = calloc((size_t)m->n + 1, sizeof *m->out);
    m->now = calloc((size_t)m->n_now + 1, sizeof *m->now);
    if (!m->record || !m->out || !m->now) return error_memory(err);
    hawser_figure *now = m->now;
    for (int r = 0, at = 0; r < scene->n_rooms; ++r) {
        for (int i = 0; i < count_of(&scene->room[r]); ++i, ++at) {
            machine_set(&m->record[at], &m->out[at], now, &scene->room[r], i, &scene->setup, expected);
            now += m->out[at].n_now;
            figures_set(&m->record[at]);
        }
    }
    return HAWSER_OK;
}

void machines_free(Machines *m)
{
    free(m->record);
    free(m->out);
    free(m->now);
    *m = (Machines){0};
}

void machines_look(Machines *m, const Scene *scene, Workspace *ws, double t)
{
    const Moment moment = {scene, ws, t, 1};
    hawser_figure *now = m->now;
    for (int i = 0; i < m->n; ++i) {
        MachineRecord *const r = &m->record[i];
        const MachineKind *const kind = r->room->kind->machines;
        kind->keep(r->room, &moment, r->item, r->value);
        for (int k = 0; k < kind->n_now; ++k) (now++)->value = r->value[k];
    }
}

void machines_record(Machines *m, double dt, int steady)
{
    for (int i = 0; i < m->n; ++i) {
        MachineRecord *const r = &m->record[i];
        for (int k = 0; k < r->room->kind->machines->n_kept; ++k) mean_add(&r->kept[k], r->value[k], dt, steady);
        figures_set(r);
    }
}

double hawser_machine_figure(const hawser_machine *machine, const char *key)
{
    if (!machine || !key) return NAN;
    for (int k = 0; k < machine->n_now; ++k) {
        if (!strcmp(machine->now[k].key, key)) return machine->now[k].value;
    }
    for (int k = 0; k < machine->n_figures; ++k) {
        if (!strcmp(machine->figure[k].key, key)) return machine->figure[k].value;
    }
    return NAN;
}

/* Writes one row of the sample. */
static void row_set(SampleBuffers *b, int i, Vec3 p, Quat q, Vec3 v, Vec3 w)
{
    const double position[3] = {p.x, p.y, p.z}, quaternion[4] = {q.w, q.x, q.y, q.z};
    const double velocity[3] = {v.x, v.y, v.z}, omega[3] = {w.x, w.y, w.z};
    memcpy(b->position + 3 * i, position, sizeof position);
    memcpy(b->quaternion + 4 * i, quaternion, sizeof quaternion);
    memcpy(b->velocity + 3 * i, velocity, sizeof velocity);
    memcpy(b->omega + 3 * i, omega, sizeof omega);
    b->axial_speed[i] = v3_dot(v, quat_rotate(q, v3(1, 0, 0)));
}

/* The drum is below the line, level and across it, and its middle follows the place where the cable leaves. Cable at
 * the angle `back` behind that place has turned by this angle with the drum. */
static void wound_row(SampleBuffers *b, const Reel *r, int i, const WindingPoint *p, const WindingPoint *leaving,
                      double speed)
{
    const Vec3 left = quat_rotate(r->attitude, v3(0, 1, 0)), up = quat_rotate(r->attitude, v3(0, 0, 1));
    const double back = leaving->angle - p->angle, c = cos(back), s = sin(back);
    const Vec3 out = v3_axpy(v3_scale(c, up), -s, r->direction), along = v3_axpy(v3_scale(c, r->direction), s, up);
    const Vec3 middle = v3_axpy(r->drum, -leaving->radius, up);
    const Vec3 place = v3_axpy(v3_axpy(middle, p->radius, out), p->across - leaving->across, left);
    row_set(b, i, place, quat_from_axes(along, left, v3_cross(along, left)), v3_scale(speed * p->radius, along),
            v3_scale(speed, left));
}

static void wound_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts)
{
    const Reel *const r = scene->reel;
    const WindingPoint leaving = winding_point(&r->winding, sample->wound);
    /* from the tail's rear end inward; the cable between that and the drum is not part of any segment yet */
    double length = r->wound;
    for (int i = scene->first - 1; i >= 0; --i) {
        const double h = scene->joint_s[i + 1] - scene->joint_s[i];
        const double at = fmin(length - h / 2, sample->wound);
        b->axial_speed[i] = sample->reel_speed * winding_radius(&r->winding, at, NULL);
        b->tension[i] = 0;
        if (parts == SAMPLE_ALL) {
            const WindingPoint p = winding_point(&r->winding, at);
            wound_row(b, r, i, &p, &leaving, sample->reel_speed);
            b->curvature[i] = 1 / p.radius;
        }
        length -= h;
    }
}

static void taken_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample)
{
    const Winch *const w = scene->winch;
    const Vec3 place = v3_axpy(w->origin, sample->winch_travel, w->direction);
    for (int i = scene->first + scene->chain.n; i < scene->total; ++i) {
        row_set(b, i, place, w->attitude, v3_scale(sample->winch_speed, w->direction), v3(0, 0, 0));
        b->tension[i + 1] = 0;
    }
}

/* Fills the rows of the segments that are not simulated, before the first and behind the last that is
 * (sim/run/sample.c). Wound segments are in their layers on the drum, which turns, and move with its surface; those
 * taken in are all at the place where the rope is held. Both have tension 0. Without SAMPLE_ALL only speeds and
 * tensions. docs/theory.md, "Reel and take-in". */
static void absent_take(SampleBuffers *b, const Scene *scene, const hawser_sample *sample, SampleParts parts)
{
    if (scene->first > 0) wound_take(b, scene, sample, parts);
    taken_take(b, scene, sample);
}

hawser_status events_add(EventLog *log, hawser_event event, hawser_error *err)
{
    if (log->n == EVENTS_MAX) {
        ++log->missed;
        return HAWSER_OK;
    }
    if (log->n == log->room) {
        const int room = 2 * log->room + 8;
        hawser_event *const grown = realloc(log->event, (size_t)room * sizeof *grown);
        if (!grown) return error_memory(err);
        log->event = grown;
        log->room = room;
    }
    log->event[log->n++] = event;
    return HAWSER_OK;
}

hawser_status events_say(EventLog *log, hawser_event event, hawser_error *err)
{
    if (log->n < EVENTS_MAX && log->n_texts == log->texts_room) {
        const int room = 2 * log->texts_room + 8;
        char **const grown = realloc(log->text, (size_t)room * sizeof *grown);
        if (!grown) return error_memory(err);
        log->text = grown;
        log->texts_room = room;
    }
    if (log->n < EVENTS_MAX) {
        char *const own = strdup(event.what);
        if (!own) return error_memory(err);
        log->text[log->n_texts++] = own;
        event.what = own;
    }
    return events_add(log, event, err);
}

void events_free(EventLog *log)
{
    for (int i = 0; i < log->n_texts; ++i) free(log->text[i]);
    free(log->text);
    free(log->event);
    memset(log, 0, sizeof *log);
}

/* cos(150 deg / 2): half the angle between two orientations q and p has the cosine |q.p|; cos 30 deg. */
static const double HALF_FAR = 0.25881904510252076, HEAD_FAR = 0.8660254037844386;

static int joint_turned(const Chain *chain, const Kinematics *kin)
{
    for (int j = 0; j <= chain->n; ++j) {
        double dot = 0;
        for (int c = 0; c < 4; ++c) dot += kin->q[c][j - 1] * kin->q[c][j];
        if (fabs(dot) < HALF_FAR && chain->stiffness[3][j] > 0) return TURNED_JOINT;
    }
    return 0;
}

static int head_turned(const Scene *scene, const Kinematics *kin)
{
    const Winch *const w = scene->winch;
    const int i = scene->chain.n - 1;
    if (!w->present || !scene->def.winch.axial_only || w->mode != WINCH_SPEED) return 0;
    const double along = v3_dot(w->direction, v3(kin->a[0][i], kin->a[1][i], kin->a[2][i]));
    return along < HEAD_FAR ? TURNED_HEAD : 0;
}

int turned(const Scene *scene, int planar, const Kinematics *kin)
{
    return (planar ? 0 : joint_turned(&scene->chain, kin)) | head_turned(scene, kin);
}

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
    for (int k = 0; k < 2 && scene->equipment->n > 0; ++k) { /* NAN for good for rollers that do not move */
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

/* Tension, N, along the segment at a rod's end about which it turns freely (segment 0's joint, or the last one's): the
 * law's frame is half way between the segment and the ground, which does not turn. */
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

/* Checks whether a rod's end turns about its joint. */
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

/* Fields along the chain besides tension, for the simulated segments; the others have none. A rod has no route that
 * could exert a sidewall pressure. */
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

/* Figures of the reel, and the back tension that it gives. */
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
