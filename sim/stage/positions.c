#include "sim/stage/positions.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/conveyor.h"
#include "sim/equipment/drum.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/rod.h"
#include "sim/equipment/winch.h"
#include "sim/newton/relax_steady.h"
#include "sim/watch/sample.h"
#include "sim/watch/stats.h"

enum { POSITIONS_MOST = 200 };       /* where the case does not say how far apart */
static const double AT_SPEED = 1e-6; /* share of the speed by which it may change within a second */
static const double BEHIND = 0.5; /* share of half a segment by which the tail may lie behind its place at the drum */

enum {
    SOFTLY = 16,
    AGAIN = 6
}; /* iterations that say soft contacts were needed; positions that begin with them then */

/* ------------------------------------------------------------------------------------------- where and when */

/* The front's place at time t. */
static double head_at(const Scene *scene, double t)
{
    return scene->joint_s[scene->eye] + winch_travel(scene->winch, t);
}

/* Whether the winch runs at a constant speed from t on. */
static int at_speed(const Scene *scene, double t)
{
    const WinchPhase *const now = &scene->winch->phase;
    const double rate = profile_rate(&now->speed, t - now->since);
    return winch_speed(scene->winch, t) > 0 && fabs(rate) <= AT_SPEED * scene->largest_speed;
}

/* The first time from which on it does, s; INFINITY: never before `end`. */
static double first_at_speed(const Scene *scene, double end)
{
    double t = 0;
    while (t <= end && !at_speed(scene, t)) {
        if (!profile_next_corner(&scene->winch->phase.speed, t, &t)) return INFINITY;
    }
    return t <= end ? t : INFINITY;
}

/* When the winch has hauled the front to s, by bisection; between 0 and `end`. */
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

/* Whether a belt runs with the cable at the end: by the winch's speed, or by one of its own that is the same. */
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
    if (def->n_jams > 0) return "what jams stops at a time: 'analysis: dynamics' has that";
    if (def->n_script > 0) return "a script changes things at times: 'analysis: dynamics' has that";
    if (scene->start || def->launch.present) return "the chain begins off its route: use 'analysis: dynamics'";
    if (def->medium.density > 0) return "nothing in air or water is steady at once: use 'analysis: dynamics'";
    if (scene->chain.sliders.count > 0 || st->whole.sliders.count > 0)
        return "bending that keeps some of it depends on the way: use 'analysis: dynamics'";
    if (!def->solver.relax) return "it begins with an equilibrium: 'solver.relax' must be true";
    for (int r = 0; r < scene->n_rooms; ++r) {
        const Room *const room = &scene->room[r];
        if (room->present && room->kind->remembers && room->kind->remembers(room, &st->ws))
            return "friction that sticks depends on the way: use 'friction.law: adams'";
    }
    for (int i = 0; i < def->n_conveyors; ++i) {
        if (runs_with(scene, &def->conveyors[i]))
            return "a belt that runs with the cable pushes by what lengths decide: use 'analysis: dynamics'";
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

/* A chain whose end is fastened to an empty drum does not run on: there is no steady motion from there. */
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

/* A position that the winch passes at a constant speed. */
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

/* Adds where something that goes with time has a corner, a table of the back tension say: the worst is there, if it is
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

/* Evenly from the first to the last; so many that none is farther from the next than `step`, and where there are
 * corners. */
static hawser_status list_even(Positions *p, const Scene *scene, double end, hawser_error *err)
{
    const PositionsDef *const def = &scene->def.analysis.positions;
    const double from = isnan(def->from) ? head_at(scene, first_at_speed(scene, end)) : def->from;
    const double to = isnan(def->to) ? head_at(scene, end) : def->to, way = to - from;
    double longest = 0;
    for (int i = 0; i < scene->chain.n; ++i) longest = fmax(longest, 2 * scene->chain.half[i]);
    const double usual = longest * ceil(way / POSITIONS_MOST / longest - 1e-9); /* whole segments: (PS8) */
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
    scene->def.output.checkpoint = 0; /* they are found in seconds again */
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

/* ------------------------------------------------------------------------------------------- where the chain lies */

/* m, by which the chain as it is laid at time t has moved on. */
static double laid_travel(const Positions *p, const Stage *st, double t)
{
    return winch_travel(st->scene.winch, t) + p->hanging.ahead;
}

/* The window when the chain has moved on by `travel`: from the first segment whose rear end is not behind the drum,
 * which stretched cable lies `back` (m) behind, to the last whose rear end is before the winch. */
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

/* The segment that has passed the winch last, laid; where it takes the rope in, and there is one. */
static int taken_laid(const Scene *scene, double travel, double row[STATE_SIZE])
{
    const int taken = scene->first + scene->chain.n;
    if (!scene->winch->take_in.present || taken >= scene->total) return 0;
    scene_lay(scene, travel, taken, 1, row);
    return 1;
}

/* How segment i hangs once it has passed: as is known of one, by the geometric series that the last ones were of, and
 * behind by what the rope between is stretched as it passes (QS12), (QS15). */
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

/* The winch holds the head's front end; where it takes the rope in, by the segment that has passed it last (RL16),
 * which hangs as it is known to (QS12). */
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

/* The chain of time t laid along its route, with the moving rollers as they are. */
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

/* How far the tail is behind where it was laid, m. */
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

/* The segment of the state that is nearest to a place. */
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

/* Rollers that spin begin at the surface speed of the cable: one that stands would have to be sped up through friction
 * that does not depend on its speed (PS7). */
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

/* Steady motion from the laid chain: from the last position's shape, or from a rest without friction. */
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

/* Laid rope: so much before it has passed, that it is not taken for passed, m. */
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
    hangs(p, st, segment + 1, &held, &turn); /* by which it was found: the next ones go on from there */
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

/* ------------------------------------------------------------------------------------------- what was found */

/* The largest tension and push, and the largest sidewall pressure of the cable. */
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
