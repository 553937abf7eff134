#include "sim/run/stage.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/machine.h"
#include "sim/equipment/ends.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/solve/newton.h"

/* Entries -1..n of an array over segments. */
static void segments_copy(const double *from, int first, int n, double *to)
{
    memcpy(to - 1, from + first - 1, (size_t)(n + 2) * sizeof *to);
}

/* Entries 0..n of an array over joints. */
static void joints_copy(const double *from, int first, int n, double *to)
{
    memcpy(to, from + first, (size_t)(n + 1) * sizeof *to);
    if (first > 0) to[0] = 0;
}

int window_chain(const Chain *whole, int first, int n, Chain *out)
{
    if (!chain_alloc(out, n)) return 0;
    out->frame = whole->frame;
    segments_copy(whole->half, first, n, out->half);
    segments_copy(whole->mass, first, n, out->mass);
    segments_copy(whole->radius, first, n, out->radius);
    for (int c = 0; c < 3; ++c) segments_copy(whole->inertia[c], first, n, out->inertia[c]);
    if (!chain_alloc_sliders(out, whole->sliders.count)) {
        chain_free(out);
        return 0;
    }
    for (int k = 0; k < whole->sliders.count; ++k) {
        joints_copy(whole->sliders.stiffness[k], first, n, out->sliders.stiffness[k]);
        memcpy(out->sliders.limit[k], whole->sliders.limit[k] + first, (size_t)(n + 1) * sizeof(double));
    }
    for (int c = 0; c < 6; ++c) {
        joints_copy(whole->stiffness[c], first, n, out->stiffness[c]);
        joints_copy(whole->damping[c], first, n, out->damping[c]);
        joints_copy(whole->preload[c], first, n, out->preload[c]);
    }
    return 1;
}

void window_end(const Chain *whole, Chain *out)
{
    out->half[out->n] = 0;
    for (int c = 0; c < 6; ++c) {
        out->stiffness[c][out->n] = whole->stiffness[c][whole->n];
        out->damping[c][out->n] = whole->damping[c][whole->n];
        out->preload[c][out->n] = whole->preload[c][whole->n];
    }
}

WindowMove window_move(int n, int joined, int left)
{
    WindowMove m = {.from = n, .to = n + joined - left, .joined = joined, .left = left};
    for (int c = 0; c < STATE_SIZE; ++c) m.scale[c] = 1;
    return m;
}

void window_map(const WindowMove *move, int extra, int is_state, const double *from, double *to)
{
    const size_t kept = (size_t)(move->from - move->left);
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double *const old = from + c * move->from;
        double *const row = to + c * move->to;
        memcpy(row + move->joined, old, kept * sizeof *row);
        if (move->joined) row[0] = move->scale[c] * old[0] + (is_state ? move->offset[c] : 0);
    }
    memcpy(to + STATE_SIZE * move->to, from + STATE_SIZE * move->from, (size_t)extra * sizeof *to);
}

static const double NEAR = 1e-9; /* m: a joint this close before its place counts as being there */

/* ------------------------------------------------------------------------------------------- the first window */

/* The tail: the first segment whose rear end has passed the drum. */
static hawser_status first_segment(const Scene *scene, int *first, hawser_error *err)
{
    *first = 0;
    if (!scene->reel->present) return HAWSER_OK;
    const double drum = -scene->def.reel.distance;
    if (scene->joint_s[0] > drum + NEAR) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "the cable does not reach the reel: its end would lie %.6g m along the route at the start, the "
            "reel stands at %.6g m: make 'chain' longer, or 'route.head_at' or 'reel.distance' smaller",
            scene->joint_s[0], drum);
    }
    while (*first < scene->total && scene->joint_s[*first] < drum - NEAR) ++*first;
    if (*first + 2 <= scene->total) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "nothing of the chain is off the reel at the start: make 'route.head_at' larger");
}

/* One past the head: the first segment whose rear end is not before the winch. */
static hawser_status last_segment(const Scene *scene, int first, int *end, hawser_error *err)
{
    *end = scene->total;
    if (!scene->winch->take_in.present) return HAWSER_OK;
    const double place = winch_place(scene);
    int i = first;
    while (i < scene->total && scene->joint_s[i] < place - NEAR) ++i;
    *end = i;
    if (i - first >= 2) return HAWSER_OK;
    return error_set(
        err, HAWSER_ERR_INPUT,
        "nothing of the chain lies before the winch at the start: make 'drive.winch.at' larger than %.6g m", place);
}

static const CableDef *cable_of(const Scene *scene, int segment)
{
    return &scene->def.cables[scene->def.pieces[scene->piece[segment]].cable];
}

/* Allocates the window's arrays for the simulated part, and sets the drum on its tail. 0 if there is no memory. */
static int window_open(Stage *st, int first, int n)
{
    Scene *const scene = &st->scene;
    Chain chain;
    if (!window_chain(&st->whole, first, n, &chain)) return 0;
    if (scene->winch->mode == WINCH_TENSION && first + n < scene->total) {
        window_end(&st->whole, &chain);
        chain.mass[n - 1] += scene->winch->drum_mass;
    }
    chain_free(&scene->chain);
    scene->chain = chain;
    scene->first = first;
    if (scene->reel->present) {
        reel_hold(scene->reel, &st->whole, first, cable_of(scene, first));
        scene->chain.mass[0] += scene->reel->mass; /* (RL7) */
    }
    drag_place(scene);
    if (scene->surfaces.points.elements == 0) return 1;
    surface_points_free(&scene->surfaces.points);
    return surface_points_alloc(&scene->surfaces.points, scene->def.geometry, &scene->chain);
}

/* Front end of segment i of a state of n. */
static Vec3 state_front(const double *y, int n, int i, double half)
{
    return v3_axpy(state_vector(y, n, STATE_P, i), half, quat_rotate(state_attitude(y, n, i), v3(1, 0, 0)));
}

/* Makes segment i of a state of n segments the one that the winch holds: from its pose it moves on with the rope, and
 * its other motion fades out (RL16). A winch of set tension now pulls and guides the front end of segment i - 1; its
 * travel does not change by that. */
static void ghost_take(Stage *st, const double *y, int n, int i, int global)
{
    Winch *const w = st->scene.winch;
    if (w->mode == WINCH_TENSION) {
        const double *const half = st->whole.half + global;
        const Quat held = quat_mul(w->attitude, quat_conj(state_attitude(y, n, i)));
        w->origin = v3_add(w->origin, v3_sub(state_front(y, n, i - 1, half[-1]), state_front(y, n, i, half[0])));
        w->attitude = quat_unit(quat_mul(held, state_attitude(y, n, i - 1)));
        return;
    }
    const double travel = winch_travel(w, st->t), speed = winch_speed(w, st->t);
    w->origin = v3_axpy(state_vector(y, n, STATE_P, i), -travel, w->direction);
    w->attitude = state_attitude(y, n, i);
    winch_take_in(w, st->t, v3_axpy(state_vector(y, n, STATE_V, i), -speed, w->direction),
                  state_vector(y, n, STATE_W, i));
}

/* Splits the scene's chain into the window and the whole; y is that of the whole chain. */
static hawser_status window_first(Stage *st, hawser_error *err)
{
    Scene *const scene = &st->scene;
    const int total = scene->total;
    int first, end;
    hawser_status status = first_segment(scene, &first, err);
    if (!status) status = last_segment(scene, first, &end, err);
    if (status) return status;
    const int size = scene_state_size(scene) - STATE_SIZE * (total - end + first); /* including that of the equipment */
    double *const y = aligned_array_new(size);
    st->whole = scene->chain;
    memset(&scene->chain, 0, sizeof scene->chain);
    if (!y || !window_open(st, first, end - first)) {
        free(y);
        return error_memory(err);
    }
    for (int c = 0; c < STATE_SIZE; ++c) {
        memcpy(y + c * (end - first), st->y + c * total + first, (size_t)(end - first) * sizeof *y);
    }
    memcpy(y + STATE_SIZE * (end - first), st->y + STATE_SIZE * total,
           (size_t)(size - STATE_SIZE * (end - first)) * sizeof *y);
    for (int i = total - 1; i >= end; --i) ghost_take(st, st->y, total, i, i);
    free(st->y);
    st->y = y;
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------------------- life */

/* Creates the motion in space for the present workspace. */
static hawser_status spatial_new(Stage *st, hawser_error *err)
{
    hawser_status status = newton_new(&st->newton, &st->scene, &st->options, err);
    if (!status && st->scene.self.present)
        status = newton_extra_attach(&st->newton, &st->ws.self.extras, &st->options, err);
    st->motion = spatial_init(&st->spatial, &st->scene, &st->ws, &st->newton);
    return status;
}

/* Creates a planar motion if the scene is planar and the case allows it; otherwise one in space. */
static hawser_status motion_new(Stage *st, hawser_error *err)
{
    const Scene *const scene = &st->scene;
    const int placed =
        scene->def.analysis.kind == ANALYSIS_POSITIONS || scene->def.solver.motion == MOTION_QUASI_STATIC;
    const PlanarChoice choice = placed ? PLANAR_OFF : scene->def.solver.planar;
    Plane plane;
    if (choice == PLANAR_OFF)
        snprintf(st->plane_why, sizeof st->plane_why, placed ? "positions are found in space" : "solver.planar is off");
    const int flat = choice == PLANAR_OFF ? 0 : plane_find(scene, &plane, st->plane_why);
    if (flat < 0) return error_memory(err);
    if (flat) {
        const hawser_status status = planar_new(&st->planar, scene, &plane, &st->ws, &st->options, err);
        if (!status) st->motion = &st->planar.motion;
        return status;
    }
    if (choice == PLANAR_ON)
        return error_set(err, HAWSER_ERR_INPUT, "solver.planar: on: %s; auto or off can be used", st->plane_why);
    return spatial_new(st, err);
}

/* Converts the state in space to that of the motion, and finds the first candidates. */
static hawser_status state_pack(Stage *st, hawser_error *err)
{
    double *const y = aligned_array_new(st->motion->size);
    if (!y) return error_memory(err);
    st->motion->ops->pack(st->motion, st->y, y);
    free(st->y);
    st->y = y;
    return st->motion->ops->renew(st->motion, 0, st->y, err);
}

hawser_status stage_new(Stage *st, const SceneDef *def, Team *team, hawser_error *err)
{
    memset(st, 0, sizeof *st);
    Scene *const scene = &st->scene;
    hawser_status status = scene_build(def, scene, err);
    if (status) return status;
    st->y = aligned_array_new(scene_state_size(scene));
    if (!st->y) return error_memory(err);
    scene_initial_state(scene, st->y);
    if (scene->reel->present || scene->winch->take_in.present) status = window_first(st, err);
    if (!status && !workspace_alloc(&st->ws, scene, team)) status = error_memory(err);
    st->options = scene->def.solver.linear;
    st->options.threads = team_size(team);
    st->options.team = team;
    if (!status) status = motion_new(st, err);
    return status ? status : state_pack(st, err);
}

static void critical_free(Stability *s)
{
    for (int k = 0; k < s->n; ++k) free((double *)(uintptr_t)s->critical[k].shape);
    free(s->critical);
    memset(s, 0, sizeof *s);
}

void stage_free(Stage *st)
{
    integrator_free(st->integrator);
    balance_free(st->balance);
    critical_free(&st->stability);
    newton_free(&st->newton);
    planar_free(&st->planar);
    workspace_free(&st->ws);
    chain_free(&st->whole);
    scene_clear(&st->scene);
    free(st->y);
    memset(st, 0, sizeof *st);
}

/* ------------------------------------------------------------------------------------------- joining, leaving */

static Vec3 position_of(const Stage *st, int i) { return state_vector(st->y, st->scene.chain.n, STATE_P, i); }

static Quat attitude_of(const Stage *st, int i) { return state_attitude(st->y, st->scene.chain.n, i); }

/* Free length behind the tail's centre (RL6). */
static double free_length(const Stage *st)
{
    const Reel *const r = st->scene.reel;
    return v3_dot(v3_sub(position_of(st, 0), r->drum), r->direction);
}

/* Checks whether the next segment's rear end would be off the drum (RL10). */
static int join_due(const Stage *st)
{
    const Scene *const s = &st->scene;
    if (!s->reel->present || s->first == 0) return 0;
    return free_length(st) >= s->chain.half[0] + 2 * st->whole.half[s->first - 1];
}

/* Checks whether the drum has released the free end (RL14). */
static int release_due(const Stage *st)
{
    const Reel *const r = st->scene.reel;
    return r->present && r->last && !r->fixed && free_length(st) >= 3 * r->half;
}

/* Checks whether the head's segment has its rear end at the winch or beyond (RL16). */
static int leave_due(const Stage *st)
{
    const TakeIn *const take_in = &st->scene.winch->take_in;
    const int i = st->scene.chain.n - 1;
    if (!take_in->present || i < 2) return 0;
    const Vec3 axis = quat_rotate(attitude_of(st, i), v3(1, 0, 0));
    const Vec3 rear = v3_axpy(position_of(st, i), -st->scene.chain.half[i], axis);
    return v3_dot(v3_sub(rear, take_in->place), st->scene.winch->direction) >= 0;
}

/* Tension of the cable where it leaves the drum, N: from the drum's resistance and inertia (RL11). */
static double drum_tension(Stage *st)
{
    const Scene *const scene = &st->scene;
    Workspace *const ws = &st->ws;
    dynamics_kinematics(scene, ws, st->t, st->y);
    dynamics_tail_pull(scene, ws);
    return reel_look(scene->reel, &scene->chain, &ws->kin, &ws->joints, st->t).tension;
}

/* Row of a segment that joins behind the tail: its joint opens by the tension that the drum gave, and its attitude is
 * that of the cable between drum and tail at that place (RL10), (RL12). */
static WindowMove join_move(Stage *st)
{
    const Scene *const scene = &st->scene;
    const Reel *const r = scene->reel;
    WindowMove m = window_move(scene->chain.n, 1, 0);
    const double l = free_length(st), half = scene->chain.half[0], behind = st->whole.half[scene->first - 1];
    const double rest = st->whole.preload[0][scene->first], k = st->whole.stiffness[0][scene->first];
    const double stretch = (drum_tension(st) - rest) / k, share = (l - half - behind - stretch) / l;
    const Quat q = attitude_of(st, 0), line = r->attitude;
    const double along = q.w * line.w + q.x * line.x + q.y * line.y + q.z * line.z, side = along < 0 ? -1 : 1;
    const double straight[4] = {side * line.w, side * line.x, side * line.y, side * line.z};
    const double now[4] = {q.w, q.x, q.y, q.z};
    double mixed[4];
    for (int c = 0; c < 4; ++c) {
        m.scale[STATE_Q + c] = share;
        m.offset[STATE_Q + c] = (1 - share) * straight[c];
        mixed[c] = share * now[c] + m.offset[STATE_Q + c];
    }
    for (int c = 0; c < 3; ++c) m.scale[STATE_W + c] = share;
    const Vec3 ahead = quat_rotate(q, v3(1, 0, 0));
    const Vec3 axis = quat_rotate(quat_unit((Quat){mixed[0], mixed[1], mixed[2], mixed[3]}), v3(1, 0, 0));
    const Vec3 back = v3_axpy(v3_scale(-half - stretch / 2, ahead), -behind - stretch / 2, axis);
    m.offset[0] = back.x;
    m.offset[1] = back.y;
    m.offset[2] = back.z;
    return m;
}

/* ---------------------------------------------------------------------------------------------- one event */

/* Mapping of the state's vectors: the chain's rows and the entries behind them. */
typedef struct StageMap {
    WindowMove move;
    int extra;
} StageMap;

static void stage_map(const void *user, int is_state, const double *from, double *to)
{
    const StageMap *const map = user;
    window_map(&map->move, map->extra, is_state, from, to);
}

/* Renews workspace and Newton matrix for the present window; counters and the slips of bending are kept. */
static hawser_status parts_renew(Stage *st, int joined, hawser_error *err)
{
    if (!workspace_renew(&st->ws, &st->scene, joined)) return error_memory(err);
    newton_free(&st->newton);
    hawser_status status = spatial_new(st, err);
    if (!status) status = st->motion->ops->renew(st->motion, st->t, st->y, err);
    return status ? status : newton_renew(&st->newton, st->ws.equipment, err);
}

/* Carries out a move: window, state, workspace, matrix, integrator. */
static hawser_status move_make(Stage *st, const WindowMove *move, hawser_error *err)
{
    const int size = st->motion->size;
    const StageMap map = {*move, size - STATE_SIZE * move->from};
    const Reshape reshape = {.size = STATE_SIZE * move->to + map.extra,
                             .y = malloc((size_t)(STATE_SIZE * move->to + map.extra) * sizeof(double)),
                             .map = stage_map,
                             .user = &map,
                             .forget = st->forget};
    if (!reshape.y) return error_memory(err);
    window_map(move, map.extra, 1, st->y, reshape.y);
    double *const old = st->y;
    st->y = reshape.y;
    hawser_status status = HAWSER_OK;
    if (!window_open(st, st->scene.first - move->joined, move->to)) status = error_memory(err);
    if (!status) status = parts_renew(st, move->joined, err);
    if (!status) status = integrator_reshape(st->integrator, st->t, &reshape, err);
    if (!status && st->balance) status = balance_enter(st->balance, st->motion, st->t, st->y, err);
    free(old);
    return status;
}

/* Stores what is needed before anything changes, including the winch's ghost. */
static void event_begins(Stage *st)
{
    if (st->balance) balance_leave(st->balance, st->motion, st->t, st->y);
}

/* Carries out the moves that are due after a step, one by one. */
hawser_status stage_settle(Stage *st, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (st->whole.n == 0) return status;
    const int n = st->scene.chain.n;
    if (release_due(st)) {
        event_begins(st);
        st->scene.reel->present = 0;
        const WindowMove m = window_move(n, 0, 0);
        status = move_make(st, &m, err);
    }
    while (!status && join_due(st)) {
        event_begins(st);
        const WindowMove m = join_move(st);
        status = move_make(st, &m, err);
        ++st->joined;
    }
    while (!status && leave_due(st)) {
        event_begins(st);
        const WindowMove m = window_move(st->scene.chain.n, 0, 1);
        const int i = st->scene.chain.n - 1;
        ghost_take(st, st->y, i + 1, i, st->scene.first + i);
        status = move_make(st, &m, err);
        ++st->left;
    }
    return status;
}

hawser_status stage_to_space(Stage *st, const char *why, hawser_error *err)
{
    Motion *const planar = st->motion;
    if (planar != &st->planar.motion) return HAWSER_OK;
    double *const y = aligned_array_new(scene_state_size(&st->scene)), *const old = st->y;
    if (!y) return error_memory(err);
    event_begins(st);
    planar->ops->unpack(planar, old, y);
    hawser_status status = spatial_new(st, err);
    if (!status) status = st->motion->ops->renew(st->motion, st->t, y, err);
    if (!status && st->integrator) status = integrator_renew(&st->integrator, st->motion, st->t, y, err);
    if (status) {
        newton_free(&st->newton);
        st->motion = planar;
        free(y);
        return status;
    }
    st->y = y;
    free(old);
    planar_free(&st->planar);
    snprintf(st->plane_why, sizeof st->plane_why, "%s", why);
    return st->balance ? balance_enter(st->balance, st->motion, st->t, st->y, err) : HAWSER_OK;
}

hawser_status steps_take(const Steps *s, double stop, double *t, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (!*s->integrator) {
        /* the relaxation bends the cable for the first time */
        status = s->motion->ops->accept(s->motion, *t, s->y, err);
        if (!status) status = integrator_new(s->motion, *t, s->y, s->integrator, err);
        if (!status) status = balance_new(s->motion, *t, s->y, s->balance, err);
    }
    if (!status) status = integrator_step(*s->integrator, stop, t, err);
    if (status) return status;
    const double start = clock_now();
    double h = 0;
    const double *const rates = integrator_rates(*s->integrator, &h);
    balance_step(*s->balance, s->motion, *t, s->y, rates, h);
    *s->balance_s += clock_now() - start;
    return HAWSER_OK;
}

hawser_status stage_integrate(Stage *st, double stop, hawser_error *err)
{
    const Steps steps = {st->motion, st->y, &st->integrator, &st->balance, &st->balance_s};
    return steps_take(&steps, stop, &st->t, err);
}

hawser_status stage_step(Stage *st, double stop, hawser_error *err)
{
    const hawser_status status = stage_integrate(st, stop, err);
    return status ? status : stage_settle(st, err);
}

/* ------------------------------------------------------------------------------------------------- checkpoints */

hawser_status stage_window(Stage *st, int first, int n, hawser_error *err)
{
    Scene *const scene = &st->scene;
    Team *const team = st->ws.team;
    const StopCheck stop = st->ws.stop;
    double *const y = aligned_array_new(st->motion->size + STATE_SIZE * (n - scene->chain.n));
    if (!y) return error_memory(err);
    st->integrator = integrator_free(st->integrator);
    free(st->y);
    st->y = y;
    workspace_free(&st->ws);
    if (st->whole.n > 0 && !window_open(st, first, n)) return error_memory(err);
    if (!workspace_alloc(&st->ws, scene, team)) return error_memory(err);
    st->ws.stop = stop;
    if (st->motion != &st->spatial.motion) return HAWSER_OK;
    newton_free(&st->newton);
    return spatial_new(st, err);
}

/* A command may have taken a planar scene to space; the state read may be from before or after that. */
static hawser_status motion_again(Stage *st, int planar, hawser_error *err)
{
    Plane plane;
    st->integrator = integrator_free(st->integrator);
    if (!planar) {
        planar_free(&st->planar);
        return spatial_new(st, err);
    }
    newton_free(&st->newton);
    if (plane_find(&st->scene, &plane, st->plane_why) <= 0)
        return error_set(err, HAWSER_ERR_RUN, "the scene does not lie in a plane any more: %s", st->plane_why);
    const hawser_status status = planar_new(&st->planar, &st->scene, &plane, &st->ws, &st->options, err);
    st->motion = &st->planar.motion;
    return status;
}

/* Checks whether the present window differs from the one to be read. */
static int window_differs(const Stage *st, int first, int n, int reel)
{
    const Scene *const scene = &st->scene;
    return first != scene->first || n != scene->chain.n || reel != scene->reel->present || st->newton.leaves ||
           st->newton.extra;
}

static void critical_checkpoint(Checkpoint *c, hawser_critical *k, int n)
{
    const size_t bytes = 6 * (size_t)n * sizeof *k->shape;
    int shaped = k->shape != NULL;
    CHECKPOINT_UP_TO(c, k, hawser_critical, kind);
    checkpoint_text(c, "k->kind", &k->kind);
    CHECKPOINT(c, k->unstable);
    CHECKPOINT(c, k->at);
    CHECKPOINT(c, k->direction);
    CHECKPOINT(c, shaped);
    if (c->reading && shaped) k->shape = malloc(bytes);
    if (shaped && !k->shape) checkpoint_lack(c);
    if (shaped) checkpoint_put(c, "k->shape", (double *)(uintptr_t)k->shape, bytes);
}

static void stability_checkpoint(Checkpoint *c, Stability *s, int n)
{
    int count = s->n;
    CHECKPOINT(c, count);
    if (!checkpoint_check(c, count >= 0 && count < INT16_MAX, "a number of loads is impossible")) return;
    if (c->reading) {
        critical_free(s);
        s->critical = calloc((size_t)count + 1, sizeof *s->critical);
        s->n = s->room = s->critical ? count : 0;
        if (!s->critical) checkpoint_lack(c);
    }
    CHECKPOINT_UP_TO(c, s, Stability, n);
    for (int k = 0; !c->status && k < count; ++k) critical_checkpoint(c, &s->critical[k], n);
}

hawser_status stage_state_checkpoint(Checkpoint *c, Stage *st, int beside, hawser_error *err)
{
    Scene *const scene = &st->scene;
    const int chain = scene->chain.n, moves = st->whole.n > 0;
    int first = scene->first, n = chain, reel = scene->reel->present, planar = st->motion == &st->planar.motion;
    const int was = planar;
    hawser_status status = HAWSER_OK;
    CHECKPOINT(c, st->t);
    CHECKPOINT(c, first);
    CHECKPOINT(c, n);
    CHECKPOINT(c, st->joined);
    CHECKPOINT(c, st->left);
    checkpoint_longs(c, 2, (const long[]){st->joined, st->left});
    CHECKPOINT(c, reel);
    CHECKPOINT(c, planar);
    CHECKPOINT(c, st->plane_why);
    const int fits = moves ? first >= 0 && n >= 2 && n <= scene->total - first : first == scene->first && n == chain;
    const int reeled = reel == 0 || (reel == 1 && scene->reel->winding.pitch > 0), flat = planar == 0 || planar == 1;
    if (!checkpoint_check(c, fits && reeled && flat, "another part of the chain is simulated")) return HAWSER_OK;
    const int differs = c->reading && (planar != was || window_differs(st, first, n, reel));
    if (!checkpoint_check(c, !(differs && beside), "one of several chains is simulated in another way"))
        return HAWSER_OK;
    scene->reel->present = reel;
    if (differs && planar != was) status = motion_again(st, planar, err);
    if (differs && !status) status = stage_window(st, first, n, err);
    if (!status) checkpoint_put(c, "y", st->y, (size_t)st->motion->size * sizeof *st->y);
    int finite = isfinite(st->t);
    for (int i = 0; !status && !c->status && i < st->motion->size; ++i) finite &= isfinite(st->y[i]);
    if (!status) checkpoint_check(c, finite, "its state is not finite");
    return status;
}

/* Creates an integrator to be read into. Its setup may round the state, which is restored. */
static hawser_status steps_prepare(const Steps *s, double t, hawser_error *err)
{
    const size_t bytes = (size_t)s->motion->size * sizeof *s->y;
    double *const y = malloc(bytes);
    if (!y) return error_memory(err);
    memcpy(y, s->y, bytes);
    hawser_status status = HAWSER_OK;
    if (!*s->integrator) status = integrator_new(s->motion, t, s->y, s->integrator, err);
    if (!status) status = integrator_prepare(*s->integrator, t, err);
    memcpy(s->y, y, bytes);
    free(y);
    return status;
}

hawser_status steps_checkpoint(Checkpoint *c, const Steps *s, double t, int n, Workspace *const *ws, hawser_error *err)
{
    int made = *s->integrator != NULL;
    hawser_status status = HAWSER_OK;
    CHECKPOINT(c, made);
    if (c->reading && !c->status && made) status = steps_prepare(s, t, err);
    if (status || c->status) return status;
    for (int k = 0; k < n; ++k) workspace_checkpoint(c, ws[k]);
    s->motion->ops->checkpoint(c, s->motion);
    if (made) integrator_checkpoint(c, *s->integrator);
    if (made) balance_checkpoint(c, s->balance, s->motion);
    checkpoint_put(c, "st->balance_s", s->balance_s, sizeof *s->balance_s);
    if (c->reading && !c->status && !made) {
        *s->integrator = integrator_free(*s->integrator);
        *s->balance = balance_free(*s->balance);
        s->motion->ops->look(s->motion, t, s->y, 0);
    }
    return HAWSER_OK;
}

hawser_status steps_ready(const Steps *s, double t, hawser_error *err)
{
    const char *why;
    if (*s->integrator && !integrator_known(*s->integrator, &why)) return error_set(err, HAWSER_ERR_RUN, "%s", why);
    /* before its first step a motion uses the candidates of the last evaluation: both when saving and when loading they
     * are those of the state */
    if (!*s->integrator) s->motion->ops->look(s->motion, t, s->y, 0);
    return HAWSER_OK;
}

hawser_status stage_checkpoint(Checkpoint *c, Stage *st, hawser_error *err)
{
    Workspace *const ws = &st->ws;
    Steps steps = {st->motion, st->y, &st->integrator, &st->balance, &st->balance_s};
    hawser_status status = c->reading ? HAWSER_OK : steps_ready(&steps, st->t, err);
    if (!status) status = stage_state_checkpoint(c, st, 0, err);
    steps.motion = st->motion; /* the state read may have another motion */
    steps.y = st->y;
    if (!status) status = steps_checkpoint(c, &steps, st->t, 1, &ws, err);
    if (!status && !c->status) stability_checkpoint(c, &st->stability, st->scene.chain.n);
    return status;
}
