#include "sim/scene.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/joints.h"

/* Segments of the whole chain. */
static int segments_of(const SceneDef *def)
{
    int n = 0;
    for (int p = 0; p < def->n_pieces; ++p) n += def->pieces[p].segments;
    return n;
}

static const CableDef *cable_of(const SceneDef *def, int piece) { return &def->cables[def->pieces[piece].cable]; }

/* Mass, inertia of a solid cylinder of the outside diameter, contact radius (S5). */
static void segments_fill(Scene *scene)
{
    Chain *const c = &scene->chain;
    int i = 0;
    for (int p = 0; p < scene->def.n_pieces; ++p) {
        const ChainPieceDef *const piece = &scene->def.pieces[p];
        const CableDef *const cable = cable_of(&scene->def, p);
        const double h = piece->length / piece->segments, r = cable->diameter / 2;
        for (int k = 0; k < piece->segments; ++k, ++i) {
            const double m = cable->mass * h;
            scene->piece[i] = p;
            c->half[i] = h / 2;
            c->mass[i] = m;
            c->inertia[0][i] = m * r * r / 2;
            c->inertia[1][i] = c->inertia[2][i] = m * (h * h / 12 + r * r / 4);
            c->radius[i] = r;
        }
    }
}

/* The route coordinate at distance `chord` from the point at s, ahead or behind (sign), by Newton's method. */
static double chord_step(const Route *route, double s, double chord, int sign)
{
    const Vec3 from = route_at(route, s).position;
    double next = s + sign * chord;
    for (int it = 0; it < 20; ++it) {
        const RoutePoint at = route_at(route, next);
        const Vec3 link = v3_sub(at.position, from);
        const double length = v3_norm(link), error = length - chord;
        next -= error * length / v3_dot(link, at.tangent);
        if (fabs(error) < 1e-15 * (1 + fabs(next))) break;
    }
    return next;
}

/* Route coordinates of the joints, from the eye outward. */
static void joints_place(Scene *scene)
{
    const Chain *const c = &scene->chain;
    scene->joint_s[scene->eye] = scene->def.head_at;
    for (int j = scene->eye; j > 0; --j) {
        scene->joint_s[j - 1] = chord_step(&scene->route, scene->joint_s[j], 2 * c->half[j - 1], -1);
    }
    for (int j = scene->eye; j < c->n; ++j) {
        scene->joint_s[j + 1] = chord_step(&scene->route, scene->joint_s[j], 2 * c->half[j], +1);
    }
}

/* The smallest rotation that takes unit vector a to b, applied after q: the frame is carried without twist. */
static Quat carried(Quat q, Vec3 a, Vec3 b)
{
    const Vec3 axis = v3_cross(a, b);
    const double c = v3_dot(a, b);
    if (c < -0.999999) return q;
    return quat_unit(quat_mul((Quat){1 + c, axis.x, axis.y, axis.z}, q));
}

static Quat first_attitude(const Scene *scene, Vec3 axis)
{
    const Vec3 left = v3_unit(v3_reject(route_left(&scene->route, scene->joint_s[0]), axis));
    return quat_from_axes(axis, left, v3_cross(axis, left));
}

int scene_state_size(const Scene *scene) { return STATE_SIZE * scene->chain.n + equipment_size(&scene->equipment); }

/* Where joint j is at the start: on the drum or on the route. */
static Vec3 joint_place(const Scene *scene, int j)
{
    if (j < scene->drum.joints) return scene->drum.joint[j];
    return route_at(&scene->route, scene->joint_s[j]).position;
}

void scene_initial_state(const Scene *scene, double *y)
{
    const int n = scene->total;
    if (scene->rod.present) {
        memcpy(y, scene->rod.start, (size_t)(STATE_SIZE * n) * sizeof *y);
        equipment_initial(&scene->equipment, y + STATE_SIZE * n);
        return;
    }
    memset(y, 0, (size_t)(STATE_SIZE * n) * sizeof *y);
    Quat q = {1, 0, 0, 0};
    Vec3 before = v3(0, 0, 0);
    for (int i = 0; i < n; ++i) {
        const Vec3 a = joint_place(scene, i), b = joint_place(scene, i + 1);
        const Vec3 axis = v3_unit(v3_sub(b, a)), centre = v3_scale(0.5, v3_add(a, b));
        q = i == 0 ? first_attitude(scene, axis) : carried(q, before, axis);
        before = axis;
        const double value[7] = {centre.x, centre.y, centre.z, q.w, q.x, q.y, q.z};
        for (int c = 0; c < 7; ++c) y[c * n + i] = value[c];
    }
    equipment_initial(&scene->equipment, y + STATE_SIZE * n);
}

double scene_winch_place(const Scene *scene)
{
    const double at = scene->def.winch.at;
    return isnan(at) ? fmax(scene->joint_s[scene->total], scene->route.length) : at;
}

/* The winch stands where the head's end is and pulls along the route's end direction. 0 if there is no memory. */
static int winch_place(Scene *scene)
{
    const int n = scene->chain.n;
    const double end = fmax(scene->joint_s[n], scene->route.length);
    Winch *const w = &scene->winch;
    w->origin = route_at(&scene->route, scene->joint_s[n]).position;
    w->direction = route_at(&scene->route, end).tangent;
    if (scene->def.winch.take_in) {
        const RoutePoint at = route_at(&scene->route, scene_winch_place(scene));
        scene->take_in = (TakeIn){.present = 1, .place = at.position};
        w->direction = at.tangent;
    }
    double *const y = malloc((size_t)(STATE_SIZE * n) * sizeof *y);
    if (!y) return 0;
    scene_initial_state(scene, y);
    const double *const last = y + n - 1;
    const Quat q = {last[3 * n], last[4 * n], last[5 * n], last[6 * n]};
    w->attitude = carried(q, quat_rotate(q, v3(1, 0, 0)), w->direction);
    free(y);
    return 1;
}

void scene_ghosts(const Scene *scene, double t, Kinematics *kin)
{
    if (scene->rod.present) rod_ghosts(&scene->rod, t, scene->chain.n, kin);
    if (scene->winch.present) winch_ghost(&scene->winch, t, scene->chain.n, kin);
    if (scene->take_in.present) take_in_ghost(&scene->take_in, t, scene->chain.n, kin);
}

static void weight_fill(Scene *scene)
{
    const RoutePoint start = route_at(&scene->route, 0);
    const LeadInDef *const lead = &scene->def.lead_in;
    const Vec3 g = scene->def.gravity;
    scene->weight = (Weight){.gravity = g,
                             .lead_in = lead->present || scene->def.reel.model == REEL_PAYOUT,
                             .origin = start.position,
                             .direction = start.tangent,
                             .blend = lead->blend};
    /* The lead-in gives way by 1 mm under the cable's weight, half critically damped. */
    scene->weight.hold = v3_norm(g) / 1e-3;
    scene->weight.hold_damping = sqrt(scene->weight.hold);
    if (!lead->carries_weight) {
        scene->weight.behind = v3_scale(v3_dot(g, start.tangent), start.tangent);
    }
}

void scene_drag_place(Scene *scene)
{
    const int segment = (scene->eye < scene->total ? scene->eye : scene->total - 1) - scene->first;
    scene->drag.segment = scene->drag.force > 0 && segment >= 0 && segment < scene->chain.n ? segment : -1;
}

/* The reel stands behind the route's start, on the lead-in's line. */
static void reel_fill(Scene *scene)
{
    if (scene->def.reel.model != REEL_PAYOUT) return;
    const Weight *const w = &scene->weight;
    const Vec3 left = v3_unit(v3_reject(route_left(&scene->route, -scene->def.reel.distance), w->direction));
    const Quat attitude = quat_from_axes(w->direction, left, v3_cross(w->direction, left));
    reel_init(&scene->reel, &scene->def, w->origin, w->direction, attitude);
    scene->tail = (Profile){.kind = PROFILE_CONSTANT};
}

static void drag_fill(Scene *scene)
{
    const RopeDragDef *const d = &scene->def.drag;
    scene->drag.force = d->force;
    scene->drag.law = (FrictionLaw){.mu_s = 1, .mu_d = d->ratio, .v_s = d->v_s, .v_d = d->v_d};
    scene_drag_place(scene);
}

static hawser_status contact_fill(Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    ContactRoller *const roller = calloc((size_t)def->n_rollers + 1, sizeof *roller);
    if (!roller) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const d = &def->rollers[r];
        roller[r] = (ContactRoller){.shape = roller_def_shape(d), .friction = d->friction};
    }
    scene->rollers = roller;
    scene->contact = (ContactModel){.geometry = def->geometry,
                                    .impact = def->impact,
                                    .n_rollers = def->n_rollers,
                                    .roller = roller,
                                    .reach = def->contact_reach};
    return HAWSER_OK;
}

/* Cable on cable: candidates hold for a motion of the order of the cable's own radius, so that a wound cable has its
 * neighbours as candidates and not the whole drum: they are the blocks of the matrix. */
static void self_fill(Scene *scene)
{
    const Chain *const c = &scene->chain;
    const SceneDef *const def = &scene->def;
    double thickest = 0;
    for (int i = 0; i < c->n; ++i) thickest = fmax(thickest, c->radius[i]);
    scene->self = (SelfModel){.present = def->cable_on_cable,
                              .law = self_law(&def->impact, &def->cable_friction),
                              .reach = fmin(thickest, def->contact_reach)};
}

/* The cable behind the route lies on the drum, which carries its weight: nothing holds it across the route's line. */
static hawser_status drum_fill(Scene *scene, hawser_error *err)
{
    const RoutePoint start = route_at(&scene->route, 0);
    const Vec3 left = route_left(&scene->route, 0);
    scene->weight.lead_in = 1;
    scene->weight.behind = v3(0, 0, 0);
    scene->weight.hold = scene->weight.hold_damping = 0;
    return drum_lay(&scene->def, &scene->chain, scene->joint_s, start.position, start.tangent, left, &scene->drum, err);
}

/* The wound cable has taken the drum's shape: its joints rest as they lie (CC25). */
static hawser_status drum_set(Scene *scene, hawser_error *err)
{
    Chain *const c = &scene->chain;
    const int n = c->n;
    double *const y = malloc((size_t)scene_state_size(scene) * sizeof *y);
    if (!y) return error_memory(err);
    scene_initial_state(scene, y);
    for (int j = 1; j < scene->drum.joints; ++j) {
        const double *const a = y + STATE_Q * n + j - 1, *const b = a + 1;
        const Quat before = {a[0], a[n], a[2 * n], a[3 * n]}, behind = {b[0], b[n], b[2 * n], b[3 * n]};
        const Vec3 turn = quat_log(quat_mul(quat_conj(before), behind));
        const double by[3] = {turn.x, turn.y, turn.z};
        for (int k = 0; k < 3; ++k) c->preload[3 + k][j] -= c->stiffness[3 + k][j] * by[k];
    }
    chain_find_lacks(c);
    free(y);
    return HAWSER_OK;
}

static hawser_status scene_fill(Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    assert(scene->piece && scene->joint_s);
    segments_fill(scene);
    if (def->rod.present) {
        const hawser_status built = rod_build(&def->rod, def->route_start, def->route_heading, def->route_slope,
                                              &scene->chain, &scene->rod, err);
        if (built) return built;
    }
    scene->eye = def->n_pieces > 1 ? scene->chain.n - def->pieces[def->n_pieces - 1].segments : scene->chain.n;
    winch_init(&scene->winch, &def->winch);
    scene->tail = def->tail.tension;
    hawser_status status = joints_fill(scene, err);
    if (status) return status;
    joints_place(scene);
    if (!winch_place(scene)) return error_memory(err);
    weight_fill(scene);
    reel_fill(scene);
    drag_fill(scene);
    scene->cable_weight = cable_of(def, scene->piece[scene->eye - 1])->mass * v3_norm(def->gravity);
    const double speed = winch_largest_speed(&scene->winch);
    scene->largest_speed = scene->winch.present && speed > 0 ? speed : 0.1;
    self_fill(scene);
    scene->n_conveyors = def->n_conveyors;
    scene->conveyor = conveyors_new(def, &scene->route);
    if (!scene->conveyor) return error_memory(err);
    if (def->drum.present) status = drum_fill(scene, err);
    if (!status) status = contact_fill(scene, err);
    if (!status) status = surfaces_fill(&scene->surfaces, def, &scene->route, &scene->chain, err);
    if (!status) status = equipment_build(def, scene->rollers, &scene->equipment, err);
    return status || !def->drum.present ? status : drum_set(scene, err);
}

hawser_status scene_build(const SceneDef *def, Scene *scene, hawser_error *err)
{
    memset(scene, 0, sizeof *scene);
    hawser_status status = scene_def_copy(def, &scene->def, err);
    if (status) return status;
    const int n = scene->total = segments_of(def);
    scene->piece = calloc((size_t)n + 1, sizeof *scene->piece);
    scene->joint_s = calloc((size_t)n + 1, sizeof *scene->joint_s);
    if (!chain_alloc(&scene->chain, n) || !scene->piece || !scene->joint_s) {
        status = error_memory(err);
    } else {
        scene->chain.frame = def->frame;
        status = route_build(&scene->route, def->n_route, def->route, def->route_start, def->route_heading,
                             def->route_slope, err);
    }
    if (!status) status = scene_fill(scene, err);
    if (status) scene_clear(scene);
    return status;
}

void scene_clear(Scene *scene)
{
    chain_free(&scene->chain);
    free(scene->piece);
    free(scene->joint_s);
    free(scene->rollers);
    equipment_clear(&scene->equipment);
    surfaces_clear(&scene->surfaces);
    free(scene->conveyor);
    drum_clear(&scene->drum);
    rod_clear(&scene->rod);
    route_clear(&scene->route);
    scene_def_clear(&scene->def);
    memset(scene, 0, sizeof *scene);
}
