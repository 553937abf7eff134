#include "sim/run/positions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/state.h"
#include "sim/equipment/conveyor.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/solve/relax.h"
#include "sim/watch/sample.h"
#include "sim/watch/stats.h"
#include "theory/expected.h"

/* m behind the front's way: up to the first distance the chain keeps its last position's shape segment by segment, over
 * the second this fades out (PS10) */
static const double WHOLLY = 1, PARTLY = 4;

/* m along the route, place of the centre of segment i when the winch has hauled in `travel`. */
static double lie_centre(const Scene *scene, int i, double travel)
{
    const double *const s = scene->joint_s + scene->first + i;
    return (s[0] + s[1]) / 2 + travel;
}

/* ---------------------------------------------------------------------------------------------------------- memory */

static size_t numbers_of(const Lie *lie) { return 12 * (size_t)lie->n + (size_t)lie->faces + (size_t)lie->patches; }

/* n, faces and patches determine the layout. */
static void memory_share(Lie *lie, double *memory)
{
    const size_t n = (size_t)lie->n;
    lie->memory = lie->s = memory;
    lie->shift = (Vec3 *)(memory + n);
    lie->turn = (Vec3 *)(memory + 4 * n);
    lie->frame = (Quat *)(memory + 7 * n);
    lie->tension = memory + 11 * n;
    lie->pressed = (Pressed){memory + 12 * n, memory + 12 * n + lie->faces};
}

/* Makes room for n segments; the contents are lost. */
static int lie_room(Lie *lie, const Scene *scene, int n)
{
    lie->n = n;
    lie->faces = 2 * scene->contact.n_rollers;
    lie->patches = scene->surfaces.model.n_patches;
    double *const memory = realloc(lie->memory, (numbers_of(lie) + 1) * sizeof *memory);
    if (memory) {
        memory_share(lie, memory);
    } else {
        lie->n = 0;
    }
    return memory != NULL;
}

static void lie_free(Lie *lie)
{
    free(lie->memory);
    *lie = (Lie){0};
}

/* Makes a copy with its own memory, overwriting out; lie_free follows either way. Errors: MEMORY. */
static hawser_status lie_copy(const Lie *lie, Lie *out, hawser_error *err)
{
    double *const memory = malloc((numbers_of(lie) + 1) * sizeof *memory);
    *out = (Lie){0};
    if (!memory) return error_memory(err);
    if (lie->n > 0) memcpy(memory, lie->memory, numbers_of(lie) * sizeof *memory);
    *out = *lie;
    memory_share(out, memory);
    return HAWSER_OK;
}

void lie_checkpoint(Checkpoint *c, Lie *lie, const Scene *scene)
{
    int n = lie->n;
    CHECKPOINT(c, n);
    if (!checkpoint_check(c, n >= 0 && n <= scene->total, "a position of another chain")) return;
    if (c->reading && !lie_room(lie, scene, n)) checkpoint_lack(c);
    CHECKPOINT(c, lie->first);
    CHECKPOINT(c, lie->eye);
    CHECKPOINT(c, lie->travel);
    if (c->status || n == 0) return;
    checkpoint_check(c, lie->first >= 0 && lie->first <= scene->total && abs(lie->eye) <= scene->total,
                     "a position of another chain");
    checkpoint_put(c, "lie->memory", lie->memory, numbers_of(lie) * sizeof *lie->memory);
}

/* ------------------------------------------------------------------------------------------------------------ keep */

/* m, opening of the joint before segment j along the chain. */
static double gap_before(const Chain *chain, const double *y, int j)
{
    const int n = chain->n;
    const Vec3 ahead = v3(1, 0, 0), a = quat_rotate(state_attitude(y, n, j - 1), ahead),
               b = quat_rotate(state_attitude(y, n, j), ahead);
    const Vec3 way = v3_sub(state_vector(y, n, STATE_P, j), state_vector(y, n, STATE_P, j - 1));
    const Vec3 gap = v3_axpy(v3_axpy(way, -chain->half[j - 1], a), -chain->half[j], b);
    return v3_dot(gap, v3_unit(v3_add(a, b)));
}

/* Stores the stage's state for the chain of `travel`, m. Errors: MEMORY; lie_free may follow either way. */
static hawser_status lie_keep(Lie *lie, Stage *st, double travel, hawser_error *err)
{
    const Scene *const scene = &st->scene;
    const int n = scene->chain.n;
    double *const laid = malloc(STATE_SIZE * (size_t)n * sizeof *laid);
    if (!laid || !lie_room(lie, scene, n)) {
        free(laid);
        return error_memory(err);
    }
    scene_lay(scene, travel, scene->first, n, laid);
    for (int i = 0; i < n; ++i) {
        lie->frame[i] = state_attitude(laid, n, i);
        lie->s[i] = lie_centre(scene, i, travel);
        lie->shift[i] = v3_sub(state_vector(st->y, n, STATE_P, i), state_vector(laid, n, STATE_P, i));
        lie->turn[i] = quat_log(quat_mul(state_attitude(st->y, n, i), quat_conj(lie->frame[i])));
    }
    memset(lie->tension, 0, (size_t)n * sizeof *lie->tension);
    for (int j = 1; j < n; ++j) {
        const double tension = scene->chain.stiffness[0][j] * gap_before(&scene->chain, st->y, j);
        lie->tension[j - 1] += (j > 1 ? 0.5 : 1) * tension;
        lie->tension[j] += (j + 1 < n ? 0.5 : 1) * tension;
    }
    lie->first = scene->first;
    lie->eye = scene->eye - scene->first;
    lie->travel = travel;
    dynamics_kinematics(scene, &st->ws, st->t, st->y);
    pressed_find(scene, &st->ws, &lie->pressed);
    free(laid);
    return HAWSER_OK;
}

/* ----------------------------------------------------------------------------------------------------------- apply */

/* Slope of x over s at segment k, from its neighbours. */
static Vec3 slope_at(const Lie *lie, const Vec3 *x, int k)
{
    const int a = k > 0 ? k - 1 : k, b = k + 1 < lie->n ? k + 1 : k;
    const double before = lie->s[k] - lie->s[a], behind = lie->s[b] - lie->s[k], both = before + behind;
    if (!(before > 0 && behind > 0)) return v3_scale(1 / both, v3_sub(x[b], x[a]));
    return v3_axpy(v3_scale(behind / (before * both), v3_sub(x[k], x[a])), before / (behind * both),
                   v3_sub(x[b], x[k]));
}

/* x at the share u of the distance from segment k to the next, a cubic between their slopes (PS8). */
static Vec3 between(const Lie *lie, const Vec3 *x, int k, double u)
{
    const double way = lie->s[k + 1] - lie->s[k], v = 1 - u;
    Vec3 out = v3_axpy(v3_scale(v * v * (1 + 2 * u), x[k]), u * u * (1 + 2 * v), x[k + 1]);
    out = v3_axpy(out, way * u * v * v, slope_at(lie, x, k));
    return v3_axpy(out, -way * u * u * v, slope_at(lie, x, k + 1));
}

/* Share by which segment i, at s, keeps its own shape (PS10). */
static double own_share(const Lie *lie, const Scene *scene, double s, double travel)
{
    const int eye = scene->eye - scene->first;
    if (!(lie->eye > 0 && lie->eye < lie->n && eye > 0 && eye < scene->chain.n)) return 0;
    const double away = fabs(s - (scene->joint_s[scene->eye] + travel)) - fabs(travel - lie->travel);
    return fmin(1, fmax(0, 1 - (away - WHOLLY) / PARTLY));
}

/* Moves the segments along themselves, from the head back, until the opening of each joint corresponds to the tension
 * that was there (PS14): for stiff cables the error would be many times that tension. */
static void tension_restore(const Lie *lie, const Scene *scene, double travel, double *y)
{
    const Chain *const chain = &scene->chain;
    const int n = chain->n;
    for (int j = n - 1, k = lie->n - 2; j > 0; --j) {
        const double s = scene->joint_s[scene->first + j] + travel;
        while (k > 0 && lie->s[k] > s) --k;
        const double u = fmin(1, fmax(0, (s - lie->s[k]) / (lie->s[k + 1] - lie->s[k])));
        const double tension = (1 - u) * lie->tension[k] + u * lie->tension[k + 1];
        const double ahead = gap_before(chain, y, j) - tension / chain->stiffness[0][j];
        const Vec3 axis = quat_rotate(state_attitude(y, n, j - 1), v3(1, 0, 0));
        const double add[3] = {ahead * axis.x, ahead * axis.y, ahead * axis.z};
        for (int c = 0; c < 3; ++c) y[(STATE_P + c) * n + j - 1] += add[c];
    }
}

/* Moves the chain, placed in the stage's state for `travel`, to the shape of the last position: place by place, and
 * near the front segment by segment. */
static void lie_apply(const Lie *lie, Stage *st, double travel)
{
    const Scene *const scene = &st->scene;
    const int n = scene->chain.n;
    double *const y = st->y;
    for (int i = 0, k = 0; i < n && lie->n > 1; ++i) {
        const double s = lie_centre(scene, i, travel);
        while (k + 2 < lie->n && lie->s[k + 1] <= s) ++k;
        const double u = fmin(1, fmax(0, (s - lie->s[k]) / (lie->s[k + 1] - lie->s[k])));
        const Quat laid = state_attitude(y, n, i);
        const int own = i + scene->first - lie->first;
        const double share = own >= 0 && own < lie->n ? own_share(lie, scene, s, travel) : 0;
        Vec3 shift = between(lie, lie->shift, k, u), turn = between(lie, lie->turn, k, u);
        if (share > 0) { /* the route may bend in between */
            const Quat by = quat_mul(laid, quat_conj(lie->frame[own]));
            shift = v3_axpy(v3_scale(1 - share, shift), share, quat_rotate(by, lie->shift[own]));
            turn = v3_axpy(v3_scale(1 - share, turn), share, quat_rotate(by, lie->turn[own]));
        }
        const Quat q = quat_unit(quat_mul(quat_exp(turn), laid));
        const double add[3] = {shift.x, shift.y, shift.z}, turned[4] = {q.w, q.x, q.y, q.z};
        for (int c = 0; c < 3; ++c) y[(STATE_P + c) * n + i] += add[c];
        for (int c = 0; c < 4; ++c) y[(STATE_Q + c) * n + i] = turned[c];
    }
    if (lie->n > 1) tension_restore(lie, scene, travel, y);
}

enum { POSITIONS_MOST = 200 }; /* if the case gives no distance */

static const double AT_SPEED = 1e-6; /* share of the speed by which it may vary within a second */

static const double BEHIND = 0.5; /* share of half a segment by which the tail may be behind its place at the drum */

enum {
    SOFTLY = 16,
    AGAIN = 6
}; /* number of iterations from which soft contacts count as needed; number of following positions that start with
    * them */

/* --------------------------------------------------------------------------------------- places and times */

/* Place of the front at time t. */
static double head_at(const Scene *scene, double t)
{
    return scene->joint_s[scene->eye] + winch_travel(scene->winch, t);
}

/* Checks whether the winch runs at a constant speed from t on. */
static int at_speed(const Scene *scene, double t)
{
    const WinchPhase *const now = &scene->winch->phase;
    const double rate = profile_rate(&now->speed, t - now->since);
    return winch_speed(scene->winch, t) > 0 && fabs(rate) <= AT_SPEED * scene->largest_speed;
}

/* First time from which on it does, s; INFINITY: not before `end`. */
static double first_at_speed(const Scene *scene, double end)
{
    double t = 0;
    while (t <= end && !at_speed(scene, t)) {
        if (!profile_next_corner(&scene->winch->phase.speed, t, &t)) return INFINITY;
    }
    return t <= end ? t : INFINITY;
}

/* Time when the winch has hauled the front to s, by bisection; between 0 and `end`. */
static double time_of(const Scene *scene, double s, double end)
{
    double early = 0, late = end;
    for (int k = 0; k < 200 && late - early > 1e-15 * end; ++k) {
        const double middle = early + (late - early) / 2;
        if (head_at(scene, middle) < s) {
            early = middle;
        } else {
            late = middle;
        }
    }
    return late;
}

/* Checks whether a belt runs at the cable's speed at the end: at the winch's, or at an equal speed of its own. */
static int runs_with(const Scene *scene, const ConveyorDef *c)
{
    const double end = scene->def.duration, largest = scene->largest_speed;
    const double apart =
        c->sync ? (c->factor - 1) * largest : profile_value(&c->speed, end) - winch_speed(scene->winch, end);
    return fabs(apart) <= 2 * c->v_d;
}

const char *positions_unknown(const Stage *st)
{
    const Scene *const scene = &st->scene;
    const SceneDef *const def = &scene->def;
    if (scene->rod->present) return "a rod is not pulled: 'analysis: static' has its equilibria";
    if (!scene->winch->present || scene->winch->mode != WINCH_SPEED) return "it needs a winch with a speed";
    if (def->n_jams > 0) return "a jam happens at a time: use 'analysis: dynamics'";
    if (def->n_script > 0) return "a script has changes in time: use 'analysis: dynamics'";
    if (scene->start || def->launch.present) return "the chain begins off its route: use 'analysis: dynamics'";
    if (def->medium.density > 0) return "motion in air or water is not steady from the start: use 'analysis: dynamics'";
    if (scene->chain.sliders.count > 0 || st->whole.sliders.count > 0)
        return "bending with hysteresis depends on the path: use 'analysis: dynamics'";
    if (!def->solver.relax) return "it begins with an equilibrium: 'solver.relax' must be true";
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->remembers && room->kind->remembers(room, &st->ws))
            return "friction that sticks depends on the path: use 'friction.law: adams'";
    }
    for (int i = 0; i < def->n_conveyors; ++i) {
        if (runs_with(scene, &def->conveyors[i]))
            return "the push of a belt at the cable's speed depends on lengths: use 'analysis: dynamics'";
    }
    return NULL;
}

double positions_held_from(const Scene *scene)
{
    const ReelDef *const reel = &scene->def.reel;
    if (reel->model != REEL_PAYOUT || !reel->end_fixed) return INFINITY;
    const double tail = scene->joint_s[1] - scene->joint_s[0];
    return tail - reel->distance - scene->joint_s[0];
}

/* A chain whose end is fastened to an empty drum comes to a stop: no steady motion follows. */
static hawser_status held_check(const Scene *scene, double t, hawser_error *err)
{
    const double travel = winch_travel(scene->winch, t), held = positions_held_from(scene);
    if (travel < held) return HAWSER_OK;
    return error_set(
        err, HAWSER_ERR_INPUT,
        "key 'reel.end': fixed: the fastened end holds the cable from the front at %.6g m on, and there is "
        "no steady motion with the front at %.6g m: end the pull before ('run.duration', "
        "'run.positions'), or see 'analysis: dynamics'",
        scene->joint_s[scene->eye] + held, head_at(scene, t));
}

static hawser_status list_alloc(Positions *p, int n, hawser_error *err)
{
    p->n = n;
    p->time = calloc((size_t)n, sizeof *p->time);
    return p->time ? HAWSER_OK : error_memory(err);
}

/* Checks that the winch passes a position at a constant speed. */
static hawser_status place_check(const Scene *scene, double s, double end, double *t, hawser_error *err)
{
    const double begins = first_at_speed(scene, end), first = head_at(scene, begins), last = head_at(scene, end);
    const double slack = 1e-9 * fmax(1, last);
    if (s > last + slack) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'run.positions': %.6g m is never reached: at the end, %.6g s, the front is at %.6g m "
                         "('run.duration' says when that is)",
                         s, end, last);
    }
    *t = s < first ? 0 : fmax(begins, fmin(end, time_of(scene, s, end)));
    if (s >= first - slack && at_speed(scene, *t)) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "key 'run.positions': the winch is not at its speed with the front at %.6g m: there is no steady "
                     "motion before %.6g m, nor where the speed changes",
                     s, first);
}

static int by_size(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Adds the corners of quantities that depend on time, e.g. a table of the back tension: the worst is there, if it is
 * not at an end. */
static hawser_status corners_add(Positions *p, const Scene *scene, hawser_error *err)
{
    const double begins = p->time[0], end = p->time[p->n - 1], apart = 1e-6 * (end - begins);
    const int even = p->n;
    int n = 0;
    for (double t = begins; (t = scene_next_stop(scene, t, end)) < end;) ++n;
    double *const more = n > 0 ? realloc(p->time, (size_t)(p->n + n) * sizeof *more) : NULL;
    if (n > 0 && !more) return error_memory(err);
    if (more) p->time = more;
    int k = 1;
    for (double t = begins; (t = scene_next_stop(scene, t, end)) < end;) {
        while (k < even - 1 && p->time[k] < t) ++k;
        const int taken = fabs(p->time[k] - t) < apart || fabs(p->time[k - 1] - t) < apart;
        if (!taken && at_speed(scene, t)) p->time[p->n++] = t;
    }
    qsort(p->time, (size_t)p->n, sizeof *p->time, by_size);
    return HAWSER_OK;
}

/* Lists positions evenly from first to last, at distances of at most `step`, and at corners. */
static hawser_status list_even(Positions *p, const Scene *scene, double end, hawser_error *err)
{
    const PositionsDef *const def = &scene->def.analysis.positions;
    const double from = isnan(def->from) ? head_at(scene, first_at_speed(scene, end)) : def->from;
    const double to = isnan(def->to) ? head_at(scene, end) : def->to, way = to - from;
    double longest = 0;
    for (int i = 0; i < scene->chain.n; ++i) longest = fmax(longest, 2 * scene->chain.half[i]);
    const double usual = longest * ceil(way / POSITIONS_MOST / longest - 1e-9); /* a multiple of the segment length:
                                                                                 * (PS8) */
    const double step = isnan(def->step) ? fmax(longest, usual) : def->step;
    if (!(way >= 0)) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'run.positions': nothing lies between 'from', %.6g m, and 'to', %.6g m", from, to);
    }
    const int parts = (int)fmin(1e6, ceil(way / step - 1e-9));
    hawser_status status = list_alloc(p, parts + 1, err);
    for (int k = 0; !status && k <= parts; ++k) {
        const double s = k == parts ? to : from + k * step;
        status = place_check(scene, s, end, &p->time[k], err);
    }
    return status ? status : corners_add(p, scene, err);
}

static hawser_status list_given(Positions *p, const Scene *scene, double end, hawser_error *err)
{
    const PositionsDef *const def = &scene->def.analysis.positions;
    hawser_status status = list_alloc(p, def->n, err);
    for (int k = 0; !status && k < p->n; ++k) status = place_check(scene, def->at[k], end, &p->time[k], err);
    if (!status) qsort(p->time, (size_t)p->n, sizeof *p->time, by_size);
    return status;
}

void positions_of(Positions *p, const Stage *st)
{
    p->hanging = (Hanging){.segment = -1};
    p->origin = st->scene.winch->origin;
    p->attitude = st->scene.winch->attitude;
}

hawser_status positions_new(Positions *p, Stage *st, hawser_error *err)
{
    Scene *const scene = &st->scene;
    const double end = scene->def.duration;
    *p = (Positions){.worst = -1, .hanging = {.segment = -1}};
    if (scene->def.analysis.kind != ANALYSIS_POSITIONS) return HAWSER_OK;
    const char *const why = positions_unknown(st);
    if (why) return error_set(err, HAWSER_ERR_INPUT, "key 'run.analysis': positions: %s", why);
    if (isinf(first_at_speed(scene, end))) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "key 'run.analysis': positions: the winch has no constant speed within %g s", end);
    }
    positions_of(p, st);
    p->n_stations = scene->def.n_stations;
    hawser_status status =
        scene->def.analysis.positions.n > 0 ? list_given(p, scene, end, err) : list_even(p, scene, end, err);
    if (!status) status = held_check(scene, p->time[p->n - 1], err);
    if (status) return status;
    scene->def.duration = p->time[p->n - 1];
    scene->def.output.steady_from = p->time[0];
    scene->def.output.checkpoint = 0; /* they can be computed again in seconds */
    Chain *const both[] = {&scene->chain, &st->whole};
    for (int k = 0; k < 2; ++k) { /* (PS3) */
        for (int c = 0; both[k]->n > 0 && c < 6; ++c)
            memset(both[k]->damping[c], 0, ((size_t)both[k]->n + 1) * sizeof(double));
    }
    return HAWSER_OK;
}

void positions_free(Positions *p)
{
    free(p->time);
    free(p->out);
    free(p->station);
    lie_free(&p->lie);
    memset(p, 0, sizeof *p);
}

double positions_next(const Positions *p, double t, double end)
{
    for (int k = 0; k < p->n; ++k) {
        if (p->time[k] > t) return fmin(p->time[k], end);
    }
    return end;
}

/* ------------------------------------------------------------------------------------------- the laid chain */

/* m, travel of the chain as it is laid at time t. */
static double laid_travel(const Positions *p, const Stage *st, double t)
{
    return winch_travel(st->scene.winch, t) + p->hanging.ahead;
}

/* Window of the chain when it has moved on by `travel`: from the first segment whose rear end has passed the drum, with
 * the stretched cable `back` (m) behind, to the last whose rear end is before the winch. */
static void window_at(const Stage *st, double travel, double back, int *first, int *n)
{
    const Scene *const scene = &st->scene;
    const double drum = -scene->def.reel.distance;
    int from = 0, end = scene->total;
    if (scene->def.reel.model == REEL_PAYOUT)
        while (from + 2 < scene->total && scene->joint_s[from] + travel - back < drum - 1e-9) ++from;
    if (scene->winch->take_in.present)
        while (end > from + 2 && scene->joint_s[end - 1] + travel >= winch_place(scene) - 1e-9) --end;
    *first = from;
    *n = end - from;
}

/* Writes the segment that passed the winch last, as laid; for a winch that takes the rope in, if there is such a
 * segment. */
static int taken_laid(const Scene *scene, double travel, double row[STATE_SIZE])
{
    const int taken = scene->first + scene->chain.n;
    if (!scene->winch->take_in.present || taken >= scene->total) return 0;
    scene_lay(scene, travel, taken, 1, row);
    return 1;
}

/* Offset of segment i as it passes the winch: extrapolated from the known ones by their geometric series; along the
 * pull, it is behind by the stretch of the rope that passes (QS12), (QS15). */
static void hangs(const Positions *p, const Stage *st, int i, Vec3 *held, Vec3 *turn)
{
    const Hanging *const h = &p->hanging;
    const int later = h->segment - i, from = i < h->segment ? i : h->segment, to = i < h->segment ? h->segment : i;
    const double r = h->lasts, pull = p->lie.n > 0 ? p->lie.tension[p->lie.n - 1] : 0;
    const double more = later > 0 && r < 1 ? r * (1 - pow(r, later)) / (1 - r) : later;
    double stretch = 0;
    for (int j = to; j > from; --j) stretch += pull / st->whole.stiffness[0][j];
    *held = v3_axpy(v3_axpy(h->held, more, h->going), later > 0 ? -stretch : stretch, st->scene.winch->direction);
    *turn = v3_axpy(h->turn, more, h->turning);
}

/* Places the hold of the head's front end: for a winch that takes the rope in, at the segment that has passed it last
 * (RL16), with its offset (QS12). */
static void winch_put(const Positions *p, Stage *st, double travel)
{
    const Scene *const scene = &st->scene;
    Winch *const w = scene->winch;
    double row[STATE_SIZE];
    w->origin = p->origin;
    w->attitude = p->attitude;
    if (!taken_laid(scene, travel, row)) return;
    Vec3 held = V3_ZERO, turn = V3_ZERO;
    if (p->hanging.segment >= 0) hangs(p, st, scene->first + scene->chain.n, &held, &turn);
    const double hauled = travel - p->hanging.ahead;
    w->origin = v3_add(v3_axpy(state_vector(row, 1, STATE_P, 0), -hauled, w->direction), held);
    w->attitude = quat_unit(quat_mul(quat_exp(turn), state_attitude(row, 1, 0)));
    winch_take_in(w, st->t, V3_ZERO, V3_ZERO);
}

/* Lays the chain of time t along its route; moving rollers stay as they are. */
static hawser_status lay(const Positions *p, Stage *st, double t, double back, hawser_error *err)
{
    Scene *const scene = &st->scene;
    const double travel = laid_travel(p, st, t);
    const int own = scene_state_size(scene) - STATE_SIZE * scene->chain.n;
    double *const kept = malloc(((size_t)own + 1) * sizeof *kept);
    if (!kept) return error_memory(err);
    memcpy(kept, st->y + STATE_SIZE * scene->chain.n, (size_t)own * sizeof *kept);
    int first, n;
    window_at(st, travel, back, &first, &n);
    scene->reel->present = scene->def.reel.model == REEL_PAYOUT &&
                           (scene->def.reel.end_fixed ||
                            scene->joint_s[0] + travel - back < -scene->def.reel.distance + 2 * st->whole.half[0]);
    hawser_status status = HAWSER_OK;
    if (first != scene->first || n != scene->chain.n || (st->whole.n > 0 && st->t <= 0))
        status = stage_window(st, first, n, err);
    if (!status) {
        scene_lay(scene, travel, first, n, st->y);
        memcpy(st->y + STATE_SIZE * n, kept, (size_t)own * sizeof *kept);
        st->t = t;
        winch_put(p, st, travel);
    }
    free(kept);
    return status;
}

/* Distance of the tail behind the place where it was laid, m. */
static double tail_back(const Positions *p, const Stage *st)
{
    const Scene *const scene = &st->scene;
    const RoutePoint at = route_at(&scene->route, lie_centre(scene, 0, laid_travel(p, st, st->t)));
    return v3_dot(v3_sub(at.position, state_vector(st->y, scene->chain.n, STATE_P, 0)), at.tangent);
}

hawser_status positions_begin(Positions *p, Stage *st, hawser_error *err)
{
    const Winch *const w = st->scene.winch;
    const double travel = winch_travel(w, st->t);
    const Vec3 place = v3_axpy(w->origin, travel, w->direction);
    double row[STATE_SIZE];
    Hanging *const h = &p->hanging;
    *h = (Hanging){.segment = -1};
    if (taken_laid(&st->scene, travel, row)) {
        h->segment = st->scene.first + st->scene.chain.n;
        h->ahead = v3_dot(v3_sub(place, state_vector(row, 1, STATE_P, 0)), w->direction);
        taken_laid(&st->scene, travel + h->ahead, row);
        h->held = v3_sub(place, state_vector(row, 1, STATE_P, 0));
        h->turn = quat_log(quat_mul(w->attitude, quat_conj(state_attitude(row, 1, 0))));
    }
    p->back = tail_back(p, st);
    return lie_keep(&p->lie, st, laid_travel(p, st, st->t), err);
}

/* ------------------------------------------------------------------------------------------- one position */

/* Segment of the state that is nearest to a place. */
static int nearest(const Stage *st, Vec3 place)
{
    const int n = st->scene.chain.n;
    double least = INFINITY;
    int found = 0;
    for (int i = 0; i < n; ++i) {
        const double away = v3_norm(v3_sub(state_vector(st->y, n, STATE_P, i), place));
        if (away < least) {
            least = away;
            found = i;
        }
    }
    return found;
}

/* Starts spinning rollers at the surface speed of the cable: one at rest would have to be accelerated by friction that
 * does not depend on its speed (PS7). */
static void spins_start(Stage *st, double speed)
{
    const Scene *const scene = &st->scene;
    const Equipment *const q = scene->equipment;
    const int n = scene->chain.n;
    for (int k = 0; k < q->n; ++k) {
        if (q->item[k].spin < 0) continue;
        const Shape *const shape = &scene->rollers[q->item[k].roller].shape;
        const int i = nearest(st, shape->centre);
        const Vec3 axis = quat_rotate(state_attitude(st->y, n, i), v3(1, 0, 0));
        const Vec3 out = v3_reject(v3_sub(state_vector(st->y, n, STATE_P, i), shape->centre), axis);
        const double side = v3_dot(v3_cross(shape->axis, out), axis) < 0 ? -1 : 1;
        st->y[STATE_SIZE * n + q->item[k].spin] = side * speed / shape->radius;
    }
}

/* Finds steady motion from the laid chain: from the last position's shape, or from equilibrium without friction. */
static hawser_status solve(Positions *p, Stage *st, int fresh, hawser_relaxation *out, hawser_error *err)
{
    Scene *const scene = &st->scene;
    const double speed = winch_speed(scene->winch, st->t), travel = laid_travel(p, st, st->t);
    if (!fresh) lie_apply(&p->lie, st, travel);
    hawser_status status = st->motion->ops->renew(st->motion, st->t, st->y, err);
    if (!status && fresh) status = st->motion->ops->relax(st->motion, st->t, st->y, out, err);
    if (!status && fresh) spins_start(st, speed);
    const SteadyStart start = {.last = fresh ? NULL : &p->lie.pressed, .soft = p->soft > 0};
    if (!status) status = relax_steady(scene, &st->ws, &st->newton, st->t, speed, &start, st->y, out, err);
    if (start.soft) --p->soft;
    if (!start.soft && out->iterations > SOFTLY) p->soft = AGAIN;
    return status;
}

hawser_status positions_advance(Positions *p, Stage *st, double t, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double back = p->back;
    int fresh = p->lie.n == 0, behind = 1;
    if (!at_speed(&st->scene, t)) {
        return error_set(err, HAWSER_ERR_RUN, "the winch is not at a constant speed at t = %.6g s: no steady motion",
                         t);
    }
    for (int tries = 0; !status && behind && tries < 4; ++tries) {
        status = lay(p, st, t, back, err);
        if (!status) status = solve(p, st, fresh, out, err);
        if (!status && !out->reached && !fresh) {
            fresh = 1;
            continue;
        }
        if (status || !out->reached) break;
        p->back = tail_back(p, st);
        behind = st->scene.reel->present && fabs(p->back - back) > BEHIND * st->scene.chain.half[0];
        back = p->back;
        fresh = 0;
        status = lie_keep(&p->lie, st, laid_travel(p, st, t), err);
    }
    if (!status && !out->reached) {
        status = error_set(err, HAWSER_ERR_RUN,
                           "no steady motion was found with the front at %.6g m: %.3g N stay unbalanced at segment %d "
                           "(aim: %.3g N): 'analysis: dynamics' may show why",
                           head_at(&st->scene, t), out->residual_N, out->segment, out->tolerance_N);
    }
    return status;
}

hawser_status positions_keep(const Positions *p, PositionsKept *out, hawser_error *err)
{
    out->back = p->back;
    return lie_copy(&p->lie, &out->lie, err);
}

void positions_back_to(Positions *p, PositionsKept *kept)
{
    if (!kept->lie.memory) return;
    lie_free(&p->lie);
    p->lie = kept->lie;
    p->back = kept->back;
    *kept = (PositionsKept){0};
}

/* m before the winch at which laid rope does not count as passed yet. */
static const double BEFORE = 1e-6;

int positions_passing(const Positions *p, const Stage *st, double *t)
{
    const Scene *const scene = &st->scene;
    const double speed = winch_speed(scene->winch, st->t);
    const int head = scene->first + scene->chain.n - 1, known = p->hanging.segment,
              next = known >= 0 && known <= head ? known - 1 : head;
    *t = INFINITY;
    if (!scene->winch->take_in.present || next - scene->first < 2 || !(speed > 0)) return -1;
    const double rear = scene->joint_s[next] + laid_travel(p, st, st->t);
    *t = st->t + (winch_place(scene) - BEFORE - rear) / speed;
    return next;
}

hawser_status positions_pass(Positions *p, Stage *st, int segment, double t, hawser_relaxation *out, double *off,
                             hawser_error *err)
{
    Hanging *const h = &p->hanging;
    const Vec3 along = st->scene.winch->direction;
    const int first = h->segment < 0;
    Vec3 thought, turned, held, turn;
    const hawser_status status = positions_advance(p, st, t, out, err);
    if (status) return status;
    hangs(p, st, segment, &thought, &turned);
    hangs(p, st, segment + 1, &held, &turn); /* offsets as found: the next ones continue from there */
    const int i = segment - st->scene.first, passed = h->segment - segment;
    const Vec3 going = v3_reject(v3_sub(p->lie.shift[i], held), along);
    const double before = v3_norm(h->going), now = v3_norm(going), ahead = v3_dot(p->lie.shift[i], along);
    *off = v3_norm(v3_reject(v3_sub(p->lie.shift[i], thought), along));
    *h = (Hanging){.segment = segment,
                   .ahead = h->ahead + ahead,
                   .held = v3_axpy(p->lie.shift[i], -ahead, along),
                   .turn = p->lie.turn[i],
                   .going = first ? V3_ZERO : going,
                   .turning = first ? V3_ZERO : v3_sub(p->lie.turn[i], turn),
                   .lasts = before > 0 && passed > 0 ? fmin(1, pow(now / before, 1. / passed)) : 0};
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------- results */

/* Largest tension and compression, and largest sidewall pressure of the cable. */
static void place_chain(const Scene *scene, const hawser_sample *look, hawser_place *out)
{
    const int eye = scene->eye - scene->first;
    const double *const tension = look->tension + scene->first;
    for (int j = 0; j <= scene->chain.n; ++j) {
        const double s = sample_joint_place(scene, look, j);
        if (j == eye) out->front_N = tension[j];
        if (tension[j] > out->tension_N) {
            out->tension_N = tension[j];
            out->tension_at_m = s;
        }
        if (-tension[j] > out->push_N) {
            out->push_N = -tension[j];
            out->push_at_m = s;
        }
        const double wall = j <= eye ? sidewall_at(scene, s, tension[j]) : 0;
        if (wall > out->sidewall_N_per_m) {
            out->sidewall_N_per_m = wall;
            out->sidewall_at_m = s;
        }
    }
}

static int room_for(Positions *p)
{
    if (p->done < p->room) return 1;
    const size_t room = p->room > 0 ? 2 * (size_t)p->room : (size_t)(p->n > 8 ? p->n : 8);
    hawser_place *const out = realloc(p->out, room * sizeof *out);
    if (out) p->out = out;
    double *const station = realloc(p->station, (room * (size_t)p->n_stations + 1) * sizeof *station);
    if (station) p->station = station;
    if (!out || !station) return 0;
    p->room = (int)room;
    return 1;
}

hawser_status positions_record(Positions *p, const Stage *st, const hawser_sample *look, const hawser_relaxation *found,
                               hawser_error *err)
{
    const Scene *const scene = &st->scene;
    if (!room_for(p)) return error_memory(err);
    hawser_place *const out = &p->out[p->done];
    *out = (hawser_place){.head_m = head_at(scene, st->t),
                          .time_s = st->t,
                          .pull_N = look->winch_force,
                          .reference_N = look->reference,
                          .front_N = NAN,
                          .tension_at_m = NAN,
                          .push_at_m = NAN,
                          .sidewall_at_m = NAN,
                          .residual_N = found->residual_N,
                          .tolerance_N = found->tolerance_N,
                          .iterations = found->iterations};
    place_chain(scene, look, out);
    for (int r = 0; r < look->rollers; ++r) {
        if (!(look->roller_load[r] > out->roller_N)) continue;
        out->roller_N = look->roller_load[r];
        out->roller = scene->def.rollers[r].name;
    }
    double *const station = p->station + (size_t)p->done * (size_t)p->n_stations;
    for (int k = 0; k < p->n_stations; ++k)
        station[k] = stats_tension_at(scene, &st->ws.kin, look, scene->def.stations[k].s);
    if (p->worst < 0 || out->pull_N > p->out[p->worst].pull_N) p->worst = p->done;
    if (out->tension_N > 0) p->push_share = fmax(p->push_share, out->push_N / out->tension_N);
    ++p->done;
    return HAWSER_OK;
}

enum { GRID_MOST = 400, BINS_MOST = 200 };

static const double GRID = 0.5, BIN = 2; /* m, least distances */

static const double SHIFT = 100; /* N, change of the back tension for its gain */

double by_position_theory(const Setup *setup, PullLaw law, double s, double back, int *no_memory)
{
    Expected e;
    Pull pull;
    hawser_error quiet = {0};
    double force = NAN;
    const hawser_status status = expected_at(setup, s, back, &e, &quiet);
    if (!status && !(e.rope_to > e.from)) { /* a rope that has left the route */
        force = e.start_tension + setup->def->drag.force;
    } else if (!status && !expected_pull(setup, &e, law, &pull, &quiet)) {
        force = pull.end_tension + setup->def->drag.force;
        pull_clear(&pull);
    }
    *no_memory = *no_memory || quiet.status == HAWSER_ERR_MEMORY;
    expected_free(&e);
    return force;
}

/* Number of parts of at least `length` m, at most `most`. */
static int parts_of(const ByPosition *b, double length, int most)
{
    const double parts = ceil((b->to - b->from) / length);
    return parts < most ? (int)fmax(parts, 1) : most;
}

hawser_status by_position_new(ByPosition *b, const Setup *setup, hawser_error *err)
{
    memset(b, 0, sizeof *b);
    b->last_t = -1;
    if (!expected_range(setup, &b->from, &b->to)) return HAWSER_OK;
    b->n_grid = parts_of(b, GRID, GRID_MOST) + 1;
    b->n_bins = parts_of(b, BIN, BINS_MOST);
    b->theory = calloc((size_t)b->n_grid, sizeof(double));
    b->gain = calloc((size_t)b->n_grid, sizeof(double));
    b->bin = calloc((size_t)b->n_bins, sizeof *b->bin);
    b->out = calloc((size_t)b->n_bins, sizeof *b->out);
    if (!b->theory || !b->gain || !b->bin || !b->out) {
        by_position_free(b);
        return error_memory(err);
    }
    b->back = expected_back(setup, setup->def->duration);
    b->leaves = starts_leaves(setup);
    b->left = -1;
    int no_memory = 0;
    for (int i = 0; i < b->n_grid; ++i) {
        const double s = b->from + (b->to - b->from) * i / (b->n_grid - 1);
        if (b->left < 0 && starts_left(setup, s)) b->left = i;
        b->theory[i] = by_position_theory(setup, PULL_REFERENCE, s, b->back, &no_memory);
        b->gain[i] = (by_position_theory(setup, PULL_REFERENCE, s, b->back + SHIFT, &no_memory) - b->theory[i]) / SHIFT;
    }
    if (!no_memory) return HAWSER_OK;
    by_position_free(b);
    return error_memory(err);
}

void by_position_free(ByPosition *b)
{
    free(b->theory);
    free(b->gain);
    free(b->bin);
    free(b->out);
    memset(b, 0, sizeof *b);
}

/* Value at x places of the grid from its first, on the line through two neighbours on the same side of the place at
 * which the cable leaves the drum; the value of the end itself if it has no such neighbour. */
static double on_grid(const ByPosition *b, const double *of, double x)
{
    const int last = b->n_grid - 2;
    int i = x < last ? (int)x : last;
    if (i + 1 == b->left) /* their mean would be wrong */
        i += b->from + (b->to - b->from) * x / (b->n_grid - 1) < b->leaves ? -1 : 1;
    if (i < 0) return of[0];
    return i > last ? of[last + 1] : of[i] + (x - i) * (of[i + 1] - of[i]);
}

double by_position_reference(const ByPosition *b, double s, double back)
{
    if (b->n_grid == 0 || !(s >= b->from - 1e-6) || !(s <= b->to + 1e-6)) return NAN;
    const double x = fmin(fmax((s - b->from) / (b->to - b->from), 0), 1) * (b->n_grid - 1);
    return on_grid(b, b->theory, x) + (back - b->back) * on_grid(b, b->gain, x);
}

void by_position_record(ByPosition *b, double t, double s, double force, double reference, int steady)
{
    const double dt = b->last_t >= 0 ? t - b->last_t : 0;
    b->last_t = t;
    if (b->n_bins == 0 || !steady || !(dt > 0) || isnan(reference)) return;
    const double x = (s - b->from) / (b->to - b->from) * b->n_bins;
    const int i = x < 0 ? 0 : x < b->n_bins ? (int)x : b->n_bins - 1;
    PositionBin *const bin = &b->bin[i];
    bin->front += s * dt;
    bin->force += force * dt;
    bin->reference += reference * dt;
    bin->time += dt;
}

void by_position_window(ByPosition *b, double reference, double dt)
{
    if (isnan(reference) || !(dt > 0)) return;
    b->mean[0] += reference * dt;
    b->mean[1] += dt;
}

double by_position_mean(const ByPosition *b) { return b->mean[1] > 0 ? b->mean[0] / b->mean[1] : NAN; }

int by_position_table(const ByPosition *b)
{
    int n = 0;
    for (int i = 0; i < b->n_bins; ++i) {
        const PositionBin *const bin = &b->bin[i];
        if (!(bin->time > 0)) continue;
        const double force = bin->force / bin->time, reference = bin->reference / bin->time;
        b->out[n++] = (hawser_position){.head_m = bin->front / bin->time,
                                        .pull_N = force,
                                        .reference_N = reference,
                                        .error_pct = 100 * (force / reference - 1)};
    }
    return n;
}
