#include "sim/run/quasi.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/state.h"
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/run/look.h"
#include "sim/run/parts.h"
#include "sim/run/quasi_data.h"

static hawser_status quasi_find(Sim *s, double t, hawser_relaxation *found, hawser_error *err);

static const double SAME_SPEED = 1e-6; /* share of its largest value by which a constant speed may vary */

static const Chain *all_joints(const Stage *st) { return st->whole.n > 0 ? &st->whole : &st->scene.chain; }

/* Text of the obstacle, or NULL. */
static const char *obstacle(const Stage *st)
{
    const SceneDef *const def = &st->scene.def;
    if (def->n_beside > 0 || def->strand.present) return "several chains are moved together";
    if (def->analysis.kind != ANALYSIS_DYNAMICS) return "there is no motion";
    if (st->motion != &st->spatial.motion) return "in a plane steps cost less than positions in space";
    if (winch_travel(st->scene.winch, def->duration) >= positions_held_from(&st->scene))
        return "the cable's end is fastened to the reel and holds it before the run ends: 'reel.end: free', or a "
               "shorter 'run.duration'";
    return positions_unknown(st);
}

hawser_status quasi_new(Quasi *q, Positions *p, const Stage *st, hawser_error *err)
{
    const Scene *const scene = &st->scene;
    const MotionChoice wanted = scene->def.solver.motion;
    *q = (Quasi){.why = "solver.motion is dynamic"};
    if (wanted == MOTION_DYNAMIC) return HAWSER_OK;
    q->why = obstacle(st);
    if (q->why && wanted == MOTION_QUASI_STATIC)
        return error_set(err, HAWSER_ERR_INPUT, "key 'solver.motion': quasi-static: %s", q->why);
    if (q->why) return HAWSER_OK;
    const Chain *const chain = all_joints(st);
    const size_t joints = (size_t)chain->n + 1;
    q->damping = malloc(6 * joints * sizeof *q->damping);
    if (!q->damping) return error_memory(err);
    for (size_t c = 0; c < 6; ++c) memcpy(q->damping + c * joints, chain->damping[c], joints * sizeof *q->damping);
    positions_of(p, st);
    return HAWSER_OK;
}

void quasi_free(Quasi *q)
{
    free(q->damping);
    q->damping = NULL;
}

double quasi_steady_until(const Scene *scene, double t, double end)
{
    const WinchPhase *const now = &scene->winch->phase;
    const double speed = winch_speed(scene->winch, t), most = SAME_SPEED * scene->largest_speed;
    if (!(speed > 0) || isfinite(now->until)) return t;
    for (double from = t; from < end;) {
        const double next = fmin(end, now->since + profile_corner_before(&now->speed, from - now->since, INFINITY));
        const double inside[2] = {from + (next - from) / 3, from + (next - from) / 2};
        for (int k = 0; k < 2; ++k)
            if (!(fabs(winch_speed(scene->winch, inside[k]) - speed) <= most)) return from;
        if (!(next > from)) return from;
        from = next;
    }
    return end;
}

void quasi_damping(const Quasi *q, Stage *st, int present)
{
    const size_t joints = (size_t)all_joints(st)->n + 1;
    Scene *const scene = &st->scene;
    for (size_t c = 0; c < 6; ++c) {
        const double *const built = q->damping + c * joints;
        const int first = st->whole.n > 0 ? scene->first : 0;
        for (int j = 0; j <= scene->chain.n; ++j) {
            const int cut = first > 0 && j == 0; /* as in window_chain */
            scene->chain.damping[c][j] = present && !cut ? built[first + j] : 0;
        }
        for (int j = 0; j <= st->whole.n && st->whole.n > 0; ++j) st->whole.damping[c][j] = present ? built[j] : 0;
    }
}

hawser_status moving_keep(Moving *m, const Stage *st, hawser_error *err)
{
    const size_t bytes = (size_t)st->motion->size * sizeof *m->y;
    const Winch *const w = st->scene.winch;
    *m = (Moving){.first = st->scene.first,
                  .n = st->scene.chain.n,
                  .reel = st->scene.reel->present,
                  .t = st->t,
                  .y = malloc(bytes),
                  .origin = w->origin,
                  .attitude = w->attitude,
                  .take_in = w->take_in};
    if (!m->y) return error_memory(err);
    memcpy(m->y, st->y, bytes);
    return HAWSER_OK;
}

void moving_free(Moving *m)
{
    free(m->y);
    m->y = NULL;
}

hawser_status quasi_enter(Quasi *q, Positions *p, Stage *st, Moving *from, hawser_error *err)
{
    hawser_status status = moving_keep(from, st, err);
    if (!status) status = positions_begin(p, st, err);
    if (status) return status;
    if (st->integrator) integrator_stats(st->integrator, &q->so_far);
    if (st->balance) balance_leave(st->balance, st->motion, st->t, st->y);
    st->integrator = integrator_free(st->integrator);
    q->on = 1;
    quasi_damping(q, st, 0);
    return HAWSER_OK;
}

hawser_status quasi_leave(Quasi *q, Stage *st, hawser_error *err)
{
    q->on = 0;
    quasi_damping(q, st, 1);
    hawser_status status = st->motion->ops->renew(st->motion, st->t, st->y, err);
    if (!status) status = integrator_new(st->motion, st->t, st->y, &st->integrator, err);
    if (status) return status;
    integrator_go_on(st->integrator, &q->so_far);
    return st->balance ? balance_enter(st->balance, st->motion, st->t, st->y, err) : HAWSER_OK;
}

hawser_status moving_restore(Stage *st, const Moving *to, hawser_error *err)
{
    Scene *const scene = &st->scene;
    hawser_status status = HAWSER_OK;
    scene->reel->present = to->reel;
    if (to->first != scene->first || to->n != scene->chain.n) status = stage_window(st, to->first, to->n, err);
    if (status) return status;
    memcpy(st->y, to->y, (size_t)st->motion->size * sizeof *st->y);
    st->t = to->t;
    scene->winch->origin = to->origin;
    scene->winch->attitude = to->attitude;
    scene->winch->take_in = to->take_in;
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

hawser_status quasi_undo(Quasi *q, Stage *st, const Moving *to, hawser_error *err)
{
    const hawser_status status = moving_restore(st, to, err);
    return status ? status : quasi_leave(q, st, err);
}

/* Balance of energy over a stretch of positions, docs/theory/45-quasi-static.md (QS13), (QS14): works and losses
 * between two of them by the trapezoidal rule; segments that joined or left carry their energy. */

/* Energy stored in joint j, J. */
static double joint_holds(const Chain *chain, const Kinematics *kin, int j)
{
    const int from = j / LANES * LANES;
    const JointEnergy upto = bushing_kernels()->energy(chain, kin, from, j + 1),
                      before = bushing_kernels()->energy(chain, kin, from, j);
    return upto.elastic - before.elastic;
}

/* Kinetic and potential energy at segment i of the position, J/kg. */
static double specific(const Stage *st, int i)
{
    const int n = st->scene.chain.n;
    const Vec3 g = st->scene.weight.gravity;
    const double along[3] = {g.x, g.y, g.z};
    double energy = 0;
    for (int c = 0; c < 3; ++c) {
        const double v = st->y[(STATE_V + c) * n + i];
        energy += v * v / 2 - along[c] * st->y[(STATE_P + c) * n + i];
    }
    return energy;
}

/* Mass that the first segment has besides its own: the reel's drum (RL7), kg. */
static double drum_mass(const Stage *st)
{
    return st->whole.n > 0 ? st->scene.chain.mass[0] - st->whole.mass[st->scene.first] : 0;
}

/* (QS14): from the window of the last position to the present one. */
static double carried_since(const QuasiRun *q, const Stage *st)
{
    const Scene *const scene = &st->scene;
    const Chain *const chain = &scene->chain;
    const int n = chain->n, first = scene->first, joined = q->booked_first - first;
    if (!(st->whole.n > 0) || joined >= n || n < 2) return 0;
    double carried = 0;
    if (joined > 0) carried = drum_mass(st) * specific(st, 0) - q->booked_drum * specific(st, joined);
    for (int i = first; i < first + joined; ++i)
        carried += st->whole.mass[i] * specific(st, 0) + joint_holds(chain, &st->ws.kin, 1);
    for (int i = first + n; i < q->booked_first + q->booked_n; ++i)
        carried -= st->whole.mass[i] * specific(st, n - 1) + joint_holds(chain, &st->ws.kin, n - 1);
    return carried;
}

static void window_booked(QuasiRun *q, const Stage *st)
{
    q->booked_first = st->scene.first;
    q->booked_n = st->scene.chain.n;
    q->booked_drum = drum_mass(st);
}

/* Balance of energy at the first position of a stretch, after the state is set, and at each of the others, after the
 * stage has moved to it (QS13). Errors: MEMORY. */
static hawser_status quasi_books_begin(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    window_booked(&s->quasi, st);
    return st->balance ? balance_enter(st->balance, st->motion, st->t, st->y, err) : HAWSER_OK;
}

static hawser_status quasi_books_position(Sim *s, hawser_error *err)
{
    Stage *const st = &s->stage;
    hawser_status status = HAWSER_OK;
    if (st->balance) {
        status = balance_position(st->balance, st->motion, st->t, st->y, err);
        balance_carry(st->balance, carried_since(&s->quasi, st));
    }
    window_booked(&s->quasi, st);
    return status;
}

enum { SINGLE = 7 }; /* number of figures that are not arrays */

static size_t tail_numbers(const SampleBuffers *b, const Scene *scene)
{
    const size_t n = (size_t)scene->total, nr = (size_t)b->sample.rollers, ns = (size_t)b->sample.surfaces;
    return 4 * n + 3 + 6 * nr + 4 * ns; /* from the tensions to the end: sample_alloc */
}

int quasi_numbers(const Sim *s)
{
    int n = SINGLE + (int)tail_numbers(&s->look, &s->stage.scene);
    for (int i = 0; i < s->machines.n; ++i) n += s->machines.record[i].room->kind->machines->n_kept;
    return n;
}

double quasi_roller_load(const Sim *s, const double *numbers, int r)
{
    return numbers[SINGLE + s->stage.scene.total + 1 + r]; /* behind the tensions */
}

/* Copies the present sample to numbers, or numbers to it. */
static void look_go(Sim *s, double *numbers, int put)
{
    hawser_sample *const look = &s->look.sample;
    double *const single[SINGLE] = {&look->winch_force, &look->tail_tension, &look->reel_speed, &look->paid_out,
                                    &look->wound,       &look->head_at,      &look->reference};
    const size_t tail = tail_numbers(&s->look, &s->stage.scene);
    for (int k = 0; k < SINGLE; ++k) *(put ? single[k] : numbers + k) = *(put ? numbers + k : single[k]);
    memcpy(put ? s->look.tension : numbers + SINGLE, put ? numbers + SINGLE : s->look.tension, tail * sizeof(double));
    double *at = numbers + SINGLE + tail;
    hawser_figure *now = s->machines.now;
    for (int i = 0; i < s->machines.n; ++i) {
        MachineRecord *const r = &s->machines.record[i];
        const MachineKind *const kind = r->room->kind->machines;
        for (int k = 0; k < kind->n_kept; ++k, ++at) *(put ? &r->value[k] : at) = *(put ? at : &r->value[k]);
        for (int k = 0; k < kind->n_now; ++k) (now++)->value = r->value[k];
    }
}

void quasi_take(Sim *s, double *numbers) { look_go(s, numbers, 0); }

double quasi_step(const QuasiRun *q)
{
    return q->known > 1 ? q->t[QUASI_KEPT - 1] - q->t[QUASI_KEPT - 2] : q->stage.so_far.last_step;
}

int quasi_between(const Sim *s)
{
    const QuasiRun *const q = &s->quasi;
    return q->stage.on && !q->probing && s->stage.t < q->t[QUASI_KEPT - 1];
}

/* (QS6), instead of the last position's figures; those that only the last position has are kept. */
void quasi_mix(Sim *s)
{
    QuasiRun *const q = &s->quasi;
    const double *const a = q->look[QUASI_KEPT - 2], *const b = q->look[QUASI_KEPT - 1];
    const double from = q->t[QUASI_KEPT - 2], u = (s->stage.t - from) / (q->t[QUASI_KEPT - 1] - from);
    double *const mixed = q->look[0]; /* the slot of the oldest position is free when rows are looked at */
    hawser_sample *const look = &s->look.sample;
    for (int k = 0; k < q->numbers; ++k) mixed[k] = isnan(a[k]) || isnan(b[k]) ? b[k] : a[k] + u * (b[k] - a[k]);
    look_go(s, mixed, 1);
    look->active_contacts = q->active;
    look->max_tension_joint = look->first;
    for (int j = look->first; j <= look->first + look->active; ++j) {
        if (look->tension[j] > look->tension[look->max_tension_joint]) look->max_tension_joint = j;
    }
    look->max_tension = look->tension[look->max_tension_joint];
}

/* A thick front behind a thin rope loads a roller most as it comes to the next one, within a few centimetres of travel:
 * positions farther apart would miss that. docs/theory/45-quasi-static.md (QS9)-(QS12). */

static const double BESIDE = 0.025; /* m, between a peak and the looks that enclose it */

static const double SAME = 1e-6; /* m: a look so close to the last position is that position */

static const double NEARLY = 0.01; /* m, from the expected place of a peak: the last position serves as the first
                                    * look */

static const double PAIR = 0.04; /* m: rollers closer than this count as at one place */

static const double REACH = 0.8; /* m, largest distance of a peak from the front's place above the next roller */

static const double GAP = 1.5; /* times the last distance between rollers: beyond this nothing carries the front */

static const double AS_BEFORE =
    5e-3; /* share by which a load may differ from the last roller's and count as its peak */

static const double WITHIN = 8e-3; /* share of a load to which its peak is enclosed */

static const double UNSEEN = 0.6; /* relative error of a load for which no peak was enclosed (QS10) */

static const double SURE = 0.05; /* the same after an enclosed peak, for the next roller to count as alike */

static const double JUMP = 0.1; /* share by which a load differs where the front leaves a bend or a duct */

static const double TREND = 0.15; /* m: largest change of a peak's place from roller to roller within a bend */

enum { ENCLOSE_EVERY = 10, LOOKS = 7 }; /* rollers between enclosed peaks; largest number of looks at one */

/* Place of the front by the winch's travel, m: the stretch of the chain since then is not included. */
static double hauled(const Scene *scene, double t)
{
    return scene->joint_s[scene->eye] + winch_travel(scene->winch, t);
}

/* Updates the peaks after a look at a position: by the place of its front. */
static void quasi_peaks_seen(QuasiRun *q, const Scene *scene, const hawser_sample *look)
{
    const double lag = hauled(scene, look->t) - look->head_at;
    if (isfinite(lag)) q->peak.lag = lag;
}

/* Place of the nearest roller behind s, or ahead of it (side 1), m; NAN: there is none. */
static double beside(const SceneDef *def, double s, int side)
{
    double found = NAN;
    for (int r = 0; r < def->n_rollers; ++r) {
        const double away = side * (def->rollers[r].s - s);
        if (away > PAIR && !(away > side * (found - s))) found = def->rollers[r].s;
    }
    return found;
}

/* Place at which the front comes to the next roller while r carries it, or would if that were as near as the last one,
 * m; NAN: r is at the same place as another. */
static double landing(const SceneDef *def, int r)
{
    const double s = def->rollers[r].s, next = beside(def, s, 1), last = s - beside(def, s, -1);
    for (int k = 0; k < r; ++k)
        if (fabs(def->rollers[k].s - s) <= PAIR) return NAN;
    return next - s <= GAP * last || isnan(last) ? next : s + last;
}

/* Finds the possible places of peaks. Errors: MEMORY. */
static hawser_status quasi_peaks_new(QuasiRun *q, const SceneDef *def, hawser_error *err)
{
    q->peak.side = 1;
    q->top = calloc((size_t)def->n_rollers + 1, sizeof *q->top);
    if (!q->top) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) q->top[r].landing = landing(def, r);
    return HAWSER_OK;
}

/* Looks that enclose the peak of one roller: places (m, of the winch's travel) and loads (N; NAN: no look there). */
typedef struct Enclosed {
    int r, looks;
    double at[3], load[3]; /* the highest in the middle */
} Enclosed;

/* Makes one more look, which counts for the peaks of all rollers. If there is no position, only a peak is lost. */
static hawser_status look_at(Sim *s, Enclosed *e, double head, double *load, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double last = q->t[QUASI_KEPT - 1], back = hauled(scene, last) - head;
    hawser_relaxation found;
    *load = NAN;
    ++e->looks;
    if (fabs(back) < SAME) {
        *load = quasi_roller_load(s, q->look[QUASI_KEPT - 1], e->r);
        return HAWSER_OK;
    }
    const hawser_status status = quasi_find(s, last - back / winch_speed(scene->winch, last), &found, err);
    q->said.iterations += found.iterations;
    if (status == HAWSER_ERR_RUN) return HAWSER_OK;
    if (status) return status;
    ++q->said.positions;
    sim_relaxation_take(s, &found);
    const hawser_sample *const look = sim_look(s, SAMPLE_ROW);
    *load = look->roller_load[e->r];
    stats_raise(&s->stats, look);
    return status;
}

/* Place of the next look: a stride to one side, or half the distance to the known look there; then on the other
 * side. */
static double next_look(const Enclosed *e, double stride, int side)
{
    for (int k = 0; k < 2; ++k, side = -side) {
        const double way = fabs(e->at[1 + side] - e->at[1]);
        if (way <= 1.01 * BESIDE) continue;
        return e->at[1] + side * (way < 2 * stride ? way / 2 : stride);
    }
    return e->at[1];
}

/* Adds a look at x with this load. */
static void enclose(Enclosed *e, double x, double load)
{
    const int side = x > e->at[1] ? 1 : -1;
    if (load > e->load[1]) {
        e->at[1 - side] = e->at[1];
        e->load[1 - side] = e->load[1];
        e->at[1] = x;
        e->load[1] = load;
    } else {
        e->at[1 + side] = x;
        e->load[1 + side] = load;
    }
}

/* Largest excess of the peak over the highest look (QS11), N: the load is concave there. */
static double above(const Enclosed *e)
{
    const double *const at = e->at, *const load = e->load;
    const double rise = (load[1] - load[0]) / (at[1] - at[0]), fall = (load[1] - load[2]) / (at[2] - at[1]);
    return fmax(rise * (at[2] - at[1]), fall * (at[1] - at[0]));
}

/* Checks for looks on both sides with smaller loads. */
static int is_closed(const Enclosed *e) { return e->load[0] > 0 && e->load[2] > 0; }

static int is_enclosed(const Enclosed *e)
{
    const double *const at = e->at;
    if (isnan(at[0]) || isnan(at[2])) return 0;
    return fmax(at[2] - at[1], at[1] - at[0]) < 1.01 * BESIDE || above(e) < WITHIN * e->load[1];
}

/* Looks at both sides of the highest look so far until its peak is enclosed. `middle`: centre of the range of REACH. */
static hawser_status search(Sim *s, Enclosed *e, double middle, hawser_error *err)
{
    QuasiPeak *const p = &s->quasi.peak;
    const double begun = e->at[1];
    double stride = BESIDE;
    int higher = 0;
    const int far = fabs(p->usual - (begun - middle)) > TREND && fabs(e->load[1] - p->load) > JUMP * p->load;
    hawser_status status = HAWSER_OK;
    while (!status && e->looks < LOOKS && !is_enclosed(e)) {
        const int jump = e->looks == 1 && far;
        const double x = jump ? middle + p->usual : next_look(e, stride, p->side), highest = e->load[1];
        double load = 0;
        if (fabs(x - middle) < REACH) status = look_at(s, e, x, &load, err);
        if (status || isnan(load)) break;
        enclose(e, x, load);
        if (e->load[1] > highest && !jump) {
            p->side = x > begun ? 1 : -1;
            if (++higher > 1) stride *= 2;
        } else {
            stride = BESIDE;
            higher = 0;
        }
    }
    return status;
}

/* Finds the peak of roller r, which is near the front's place at the last roller's peak (QS9). */
static hawser_status peak_of(Sim *s, int r, double place, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    QuasiPeak *const p = &q->peak;
    const double middle = place + p->lag;
    Enclosed e = {.r = r, .at = {NAN, middle + p->at + p->trend, NAN}, .load = {NAN, NAN, NAN}};
    const double last = hauled(&s->stage.scene, q->t[QUASI_KEPT - 1]);
    if (fabs(e.at[1] - last) < NEARLY) e.at[1] = last;
    hawser_status status = look_at(s, &e, e.at[1], &e.load[1], err);
    if (status || !(e.load[1] > 0)) return status;
    const int as_before =
        p->open < SURE && fabs(e.load[1] - p->load) < AS_BEFORE * p->load && ++p->rollers % ENCLOSE_EVERY != 0;
    if (!as_before) status = search(s, &e, middle, err);
    const double now = e.at[1] - middle, trend = now - p->at;
    p->trend = !as_before && fabs(trend) > 1.5 * BESIDE && fabs(trend) < TREND ? trend : 0;
    p->at = now;
    if (as_before) p->usual = now;
    p->load = e.load[1];
    if (!as_before) p->open = is_closed(&e) ? above(&e) / e.load[1] : UNSEEN;
    q->top[r].load = e.load[1];
    q->top[r].open = as_before ? fmin(UNSEEN, p->open + AS_BEFORE) : p->open;
    return status;
}

double quasi_peak_error(const QuasiRun *q, int r, double peak)
{
    const QuasiTop *const top = &q->top[r];
    const int front = top->load > 0 && peak <= (1 + AS_BEFORE) * top->load;
    return peak * (front ? top->open : UNSEEN);
}

/* Finds peaks of rollers' loads between the last two positions (QS9), as separate positions that count for nothing
 * else. Errors: MEMORY, RUN, STOPPED. */
static hawser_status quasi_peaks(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double ahead = q->peak.at + q->peak.trend + q->peak.lag;
    const double from = hauled(scene, q->t[QUASI_KEPT - 2]) - 2 * REACH, to = hauled(scene, q->t[QUASI_KEPT - 1]);
    hawser_status status = HAWSER_OK;
    Moving last = {0};
    PositionsKept kept = {0};
    for (int r = 0; !status && r < scene->def.n_rollers; ++r) {
        const double place = q->top[r].landing;
        if (!(place > q->peak.done && place + ahead > from && place + ahead <= to + NEARLY)) continue;
        if (!last.y) status = moving_keep(&last, &s->stage, err);
        if (!status && !kept.lie.memory) status = positions_keep(&s->positions, &kept, err);
        q->probing = 1;
        q->peak.done = place;
        if (!status) status = peak_of(s, r, place, err);
    }
    q->probing = 0;
    if (!status && last.y) status = moving_restore(&s->stage, &last, err);
    positions_back_to(&s->positions, &kept);
    moving_free(&last);
    return status;
}

/* Shares of the pull: largest oscillation, and largest difference of a position from the mean, with which positions may
 * begin (QS2), (QS3). */
static const double SWING = 0.01, APART = 0.01;

static const double STRETCH = 3; /* windows: least duration of a stretch of positions */

/* Longest distance of two positions in segments: golden, so that they meet every phase of a segment's ripple (QS4). */
static const double GOLDEN = 2.6180339887498949;

enum {
    POSITIONS_LEAST = 40,
    CHECKS = 4
}; /* least number of positions in a stretch; number of checks by the equations
    * of motion in a run */

static const double TOLERANCE = 5e-3; /* of the pull: error of rows between positions (QS5) */

static const double SHORTEST = 1.0 / 16; /* of the longest step */

static const double TRIP = 0.9; /* of the pull at which a winch trips: the equations of motion take over from there */

static const double HANG = 4e-4; /* of half a segment: error of the expected offset of one that passes the winch */

enum { TRIES = 4, WAIT_MOST = 64, HANG_MOST = 8, HANG_RARELY = 16, NEAR_FRONT = 4 };

/* ------------------------------------------------------------------------------------------------------------ life */

hawser_status quasi_run_new(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const hawser_status status = quasi_new(&q->stage, &s->positions, &s->stage, err);
    q->window.from = -1;
    q->said.why = q->stage.why;
    if (status || !q->stage.damping) return status;
    q->numbers = quasi_numbers(s);
    q->memory = calloc(QUASI_KEPT * (size_t)q->numbers, sizeof *q->memory);
    for (int k = 0; q->memory && k < QUASI_KEPT; ++k) q->look[k] = q->memory + k * (ptrdiff_t)q->numbers;
    return q->memory ? quasi_peaks_new(q, &s->stage.scene.def, err) : error_memory(err);
}

void quasi_run_free(QuasiRun *q)
{
    quasi_free(&q->stage);
    free(q->memory);
    free(q->top);
    free(q->y);
    *q = (QuasiRun){0};
}

static int room_for(QuasiRun *q, int size)
{
    if (size == q->size) return 1;
    double *const y = realloc(q->y, (size_t)size * sizeof *y);
    if (!y) return 0;
    q->y = y;
    q->size = size;
    return 1;
}

/* s, in which the longest segment passes a point. */
static double passing_time(const Scene *scene, double speed)
{
    double longest = 0;
    for (int i = 0; i < scene->chain.n; ++i) longest = fmax(longest, 2 * scene->chain.half[i]);
    return longest / speed;
}

/* ------------------------------------------------------------------------------------------------------- positions */

/* Sets the last position's state back to an earlier travel of the winch (QS7). */
static void state_at(Sim *s, double t)
{
    const QuasiRun *const q = &s->quasi;
    Stage *const st = &s->stage;
    const int n = st->scene.chain.n;
    const double back = t - q->t[QUASI_KEPT - 1];
    memcpy(st->y, q->y, (size_t)q->size * sizeof *st->y);
    st->t = t;
    for (int c = 0; c < 3 * n && back < 0; ++c) st->y[c] += back * st->y[STATE_V * n + c];
}

/* Stores a position as the last one. */
static hawser_status keep(Sim *s, const hawser_relaxation *found, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    double *const oldest = q->look[0];
    if (!room_for(q, s->stage.motion->size)) return error_memory(err);
    for (int k = 1; k < QUASI_KEPT; ++k) {
        q->t[k - 1] = q->t[k];
        q->look[k - 1] = q->look[k];
    }
    q->t[QUASI_KEPT - 1] = s->stage.t;
    q->look[QUASI_KEPT - 1] = oldest;
    const hawser_sample *const look = sim_look(s, SAMPLE_FIELDS);
    quasi_take(s, oldest);
    quasi_peaks_seen(q, &s->stage.scene, look);
    q->active = look->active_contacts;
    memcpy(q->y, s->stage.y, (size_t)q->size * sizeof *q->y);
    ++q->known;
    ++q->said.positions;
    q->said.iterations += found->iterations;
    double push = 0, most = 0;
    for (int j = look->first; j <= look->first + look->active; ++j) {
        push = fmax(push, -look->tension[j]);
        most = fmax(most, look->tension[j]);
    }
    if (most > 0) s->positions.push_share = fmax(s->positions.push_share, push / most);
    return HAWSER_OK;
}

/* Error of linear interpolation of the pull between the last two positions, in tolerances (QS5). */
static double line_error(const QuasiRun *q)
{
    const double *const t = q->t;
    const double h1 = t[1] - t[0], h2 = t[2] - t[1], d1 = q->look[1][0] - q->look[0][0],
                 d2 = q->look[2][0] - q->look[1][0];
    const double allowed = TOLERANCE * fmax(fabs(q->look[1][0]), fabs(q->look[2][0]));
    return h2 / (4 * (h1 + h2)) * fabs(d2 - d1 * h2 / h1) / fmax(allowed, 1e-300);
}

/* Finds the position of time t; the stage is then at t. Errors: as positions_advance. */
static hawser_status quasi_find(Sim *s, double t, hawser_relaxation *found, hawser_error *err)
{
    const double start = clock_now();
    *found = (hawser_relaxation){0};
    const hawser_status status = positions_advance(&s->positions, &s->stage, t, found, err);
    s->relax_s += clock_now() - start;
    return status;
}

/* Checks whether the winch might trip before the next position. */
static int may_trip(const Sim *s, double pull)
{
    const double trip = s->stage.scene.winch->trip_force;
    return trip > 0 && pull > TRIP * trip;
}

/* Time until which positions may go on, s; the present time: they end here. */
static double goes_until(Sim *s, double t)
{
    const QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double now = s->stage.t, end = fmax(t, scene->def.duration);
    const double apart = (scene->def.duration - q->said.first_s) / (CHECKS + 1);
    if (s->calls.law || s->calls.stop || may_trip(s, q->look[QUASI_KEPT - 1][0])) return now;
    if (apart > STRETCH * passing_time(scene, winch_speed(scene->winch, now)) && now > q->checked + apart) return now;
    return quasi_steady_until(scene, now, scene_next_stop(scene, now, end));
}

/* Finds the next position, at most one step ahead of the present time. If none is found even close by, *on is 0 and the
 * state is the present one. */
static hawser_status next_position(Sim *s, double until, int *on, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const double now = s->stage.t, speed = winch_speed(s->stage.scene.winch, now);
    const double longest = fmin(GOLDEN * passing_time(&s->stage.scene, speed),
                                (s->stage.scene.def.duration - q->said.first_s) / POSITIONS_LEAST);
    hawser_status status = HAWSER_OK;
    *on = 0;
    q->step = fmin(q->step > 0 ? q->step : longest, longest);
    for (int tries = 0; !status && !*on && tries < TRIES; ++tries) {
        const double rest = until - now, h = q->step < 0.7 * rest ? q->step : q->step < rest ? rest / 2 : rest;
        hawser_relaxation found;
        status = quasi_find(s, now + h, &found, err);
        if (status == HAWSER_ERR_RUN) {
            status = HAWSER_OK;
            q->step = h / 4;
            continue;
        }
        if (status) break;
        sim_relaxation_take(s, &found);
        status = keep(s, &found, err);
        *on = 1;
        if (q->known < QUASI_KEPT) break;
        const double off = line_error(q);
        q->step = fmax(SHORTEST * longest, h * fmin(2, fmax(0.3, 0.8 / sqrt(off + 1e-9))));
    }
    return status;
}

/* Finds the offsets of the segments by which the winch holds the rope: of the next one to pass, and of those behind it
 * until one is as expected (QS15). The stage's time is arbitrary afterwards. */
static hawser_status hang(Sim *s, double until, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    Stage *const st = &s->stage;
    const double near = HANG * st->scene.chain.half[st->scene.chain.n - 1], start = clock_now();
    double off = INFINITY, t = 0;
    PositionsKept kept = {0};
    hawser_status status = positions_keep(&s->positions, &kept, err);
    for (int k = 0; !status && k < HANG_MOST && off > near; ++k) {
        const int next = positions_passing(&s->positions, st, &t);
        if (!(t < until)) break;
        hawser_relaxation found = {0};
        status = positions_pass(&s->positions, st, next, t, &found, &off, err);
        q->said.iterations += found.iterations;
        if (k == 0) q->hangs = off > near ? q->hangs / 2 : 2 * q->hangs;
        q->hangs = q->hangs < 1 ? 1 : q->hangs < HANG_RARELY ? q->hangs : HANG_RARELY;
    }
    positions_back_to(&s->positions, &kept);
    s->relax_s += clock_now() - start;
    return status == HAWSER_ERR_RUN ? HAWSER_OK : status;
}

/* Checks whether the segment at the head is far enough behind the last whose offset was found; the distance falls as
 * the front comes to the winch. */
static int hang_due(const Sim *s)
{
    const Scene *const scene = &s->stage.scene;
    const int head = scene->first + scene->chain.n - 1, known = s->positions.hanging.segment;
    const int near = (head - scene->eye) / NEAR_FRONT, after = near < s->quasi.hangs ? near : s->quasi.hangs;
    return scene->winch->take_in.present && (known < 0 || known - head >= after);
}

static hawser_status look_ahead(Sim *s, double until, int *on, hawser_error *err)
{
    const double now = s->stage.t;
    Moving here;
    hawser_status status = moving_keep(&here, &s->stage, err);
    if (!status && hang_due(s)) {
        status = hang(s, until, err);
        if (!status) status = moving_restore(&s->stage, &here, err);
    }
    if (!status) status = next_position(s, until, on, err);
    if (!status && !*on) status = moving_restore(&s->stage, &here, err);
    if (!status && *on && s->quasi.known > 1) status = quasi_peaks(s, err);
    if (!status && *on) state_at(s, now);
    moving_free(&here);
    return status;
}

/* ------------------------------------------------------------------------------------------- the change of method */

static void window_begin(QuasiRun *q) { q->window.from = -1; }

hawser_status quasi_end(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.on) return HAWSER_OK;
    hawser_status status = HAWSER_OK;
    hawser_relaxation found;
    if (quasi_between(s)) {
        status = quasi_find(s, s->stage.t, &found, err);
        if (!status) status = quasi_books_position(s, err);
    }
    if (!status) status = quasi_leave(&q->stage, &s->stage, err);
    s->stats.swings.steps = s->stats.swings.downward = 0;
    s->stats.swings.third = s->stats.swings.bound = 0;
    q->known = 0;
    window_begin(q);
    return status;
}

hawser_status quasi_move(Sim *s, double t, int *arrived, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const double now = s->stage.t;
    hawser_status status = HAWSER_OK;
    *arrived = 0;
    if (!quasi_between(s)) {
        const double until = goes_until(s, t);
        int on = 0;
        if (until > now) status = look_ahead(s, until, &on, err);
        if (status || !on) return status ? status : quasi_end(s, err);
    }
    const double ahead = q->t[QUASI_KEPT - 1], to = fmin(t, ahead);
    state_at(s, to);
    q->said.time_s += to - now;
    *arrived = !(to < ahead);
    return *arrived ? quasi_books_position(s, err) : HAWSER_OK;
}

/* Adds the last step; 1: a window has ended (QS1). */
static int window_step(QuasiRun *q, const Scene *scene, double t, double pull)
{
    PullWindow *const w = &q->window;
    const double speed = winch_speed(scene->winch, t), until = quasi_steady_until(scene, t, scene->def.duration);
    const double lasts = speed > 0 ? passing_time(scene, speed) : INFINITY;
    if (!(until - t > STRETCH * lasts)) {
        w->from = -1;
        return 0;
    }
    if (w->from < 0 || !(fabs(speed - w->speed) <= 1e-6 * speed)) {
        *w = (PullWindow){.from = t, .last = t, .speed = speed, .least = pull, .most = pull, .before = pull};
        return 0;
    }
    w->sum += (t - w->last) * (w->before + pull) / 2;
    w->last = t;
    w->before = pull;
    w->least = fmin(w->least, pull);
    w->most = fmax(w->most, pull);
    return t - w->from >= lasts;
}

/* Starts positions from here on, if the first of them agrees with the motion (QS3). */
static hawser_status attempt(Sim *s, double mean, double swing, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    Moving from = {0};
    hawser_relaxation found;
    hawser_status status = quasi_enter(&q->stage, &s->positions, &s->stage, &from, err);
    if (status == HAWSER_OK) status = quasi_find(s, s->stage.t, &found, err);
    int fits = status == HAWSER_OK;
    if (status == HAWSER_ERR_RUN && q->stage.on) status = HAWSER_OK;
    if (!status && fits) {
        if (!(q->said.stretches > 0)) q->said.first_s = s->stage.t;
        status = keep(s, &found, err);
        const double apart = fabs(q->look[QUASI_KEPT - 1][0] / mean - 1);
        fits = apart <= APART;
        if (fits) {
            sim_relaxation_take(s, &found);
            q->said.apart = fmax(q->said.apart, apart);
            q->said.swing = fmax(q->said.swing, swing);
            q->said.stretches++;
            q->checked = s->stage.t;
            q->step = 0;
            q->hangs = 1;
            q->known = 1;
            q->failed = 0;
            if (!status) status = quasi_books_begin(s, err);
        }
    }
    if (!status && !fits) {
        status = quasi_undo(&q->stage, &s->stage, &from, err);
        q->waits = q->failed < 6 ? 1 << q->failed : WAIT_MOST;
        q->failed++;
        q->said.refused++;
    }
    moving_free(&from);
    return status;
}

hawser_status quasi_begin(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.damping || q->stage.on || q->told || s->calls.law) return HAWSER_OK;
    const double pull = s->stats.swings.pull[SWINGS_STEPS - 1];
    if (!window_step(q, &s->stage.scene, s->stage.t, pull)) return HAWSER_OK;
    const PullWindow *const w = &q->window;
    const double mean = w->sum / (w->last - w->from), swing = (w->most - w->least) / 2 / fmax(mean, 1e-300);
    const int settled = mean > 0 && swing <= SWING && !may_trip(s, (1 + 2 * swing) * mean);
    window_begin(q);
    if (!settled) return HAWSER_OK;
    if (q->waits > 0) {
        --q->waits;
        return HAWSER_OK;
    }
    return attempt(s, mean, swing, err);
}

/* ----------------------------------------------------------------------------------------------------- checkpoints */

void quasi_checkpoint_before(Checkpoint *c, Sim *s)
{
    QuasiRun *const q = &s->quasi;
    int on = q->stage.on;
    CHECKPOINT(c, on);
    if (!checkpoint_check(c, on == 0 || (on == 1 && q->stage.damping), "positions move a scene that they cannot move"))
        return;
    if (c->reading && !c->status && q->stage.damping && on != q->stage.on) quasi_damping(&q->stage, &s->stage, !on);
    q->stage.on = on;
}

hawser_status quasi_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.damping) return HAWSER_OK;
    int books = q->stage.on && s->stage.balance;
    CHECKPOINT(c, q->stage.so_far);
    CHECKPOINT(c, q->t);
    CHECKPOINT(c, q->known);
    CHECKPOINT(c, q->active);
    CHECKPOINT(c, q->booked_first);
    CHECKPOINT(c, q->booked_n);
    CHECKPOINT(c, q->booked_drum);
    CHECKPOINT(c, q->step);
    CHECKPOINT(c, q->hangs);
    CHECKPOINT(c, q->checked);
    CHECKPOINT(c, q->peak);
    checkpoint_put(c, "q->top", q->top, (size_t)s->stage.scene.def.n_rollers * sizeof *q->top);
    CHECKPOINT(c, q->window);
    CHECKPOINT(c, q->told);
    CHECKPOINT(c, q->waits);
    CHECKPOINT(c, q->failed);
    CHECKPOINT_UP_TO(c, &q->said, hawser_quasi_static, why);
    const hawser_quasi_static *const said = &q->said;
    checkpoint_counts(c, 4, (const int[]){q->known, q->waits, q->failed, q->peak.rollers});
    checkpoint_longs(c, 4, (const long[]){said->positions, said->iterations, said->stretches, said->refused});
    CHECKPOINT(c, s->positions.back);
    CHECKPOINT(c, s->positions.hanging);
    const int hung = s->positions.hanging.segment;
    checkpoint_check(c, hung >= -1 && hung < s->stage.scene.total, "a rope of another chain");
    CHECKPOINT(c, s->positions.soft);
    checkpoint_counts(c, 1, &s->positions.soft);
    CHECKPOINT(c, s->positions.push_share);
    CHECKPOINT(c, books);
    lie_checkpoint(c, &s->positions.lie, &s->stage.scene);
    if (c->status || !q->stage.on) return HAWSER_OK;
    for (int k = 0; k < QUASI_KEPT; ++k) checkpoint_put(c, "q->look", q->look[k], (size_t)q->numbers * sizeof(double));
    if (!room_for(q, s->stage.motion->size)) return error_memory(err);
    checkpoint_put(c, "q->y", q->y, (size_t)q->size * sizeof *q->y);
    if (books) balance_checkpoint(c, &s->stage.balance, s->stage.motion);
    return HAWSER_OK;
}
