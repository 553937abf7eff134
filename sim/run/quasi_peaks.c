/* A thick front behind a thin rope loads a roller most as it comes to the next one, within a few centimetres of way:
 * positions farther apart would miss that. docs/model/45-quasi-static.md (QS9)-(QS12). */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/winch.h"
#include "sim/run/look.h"
#include "sim/run/quasi_run.h"

static const double BESIDE = 0.025; /* m, between a peak and the looks that enclose it */
static const double SAME = 1e-6;    /* m: the last position is one of these */
static const double NEARLY = 0.01;  /* m, from where a peak is expected: the last position does for the first look */
static const double PAIR = 0.04;    /* m: rollers nearer than that stand at one place */
static const double REACH = 0.8;    /* m, by which a peak may be away from where the front is above the next roller */
static const double GAP = 1.5;      /* times the last distance between rollers: nothing carries the front there */
static const double AS_BEFORE =
    5e-3; /* share by which a load may differ from the last roller's to be taken for its peak */
static const double WITHIN = 8e-3; /* share of a load that its peak is enclosed to */
static const double UNSEEN = 0.6;  /* share of itself by which a load may be larger where no peak was enclosed (QS10) */
static const double SURE = 0.05;   /* the same, where one was, for the next one to be taken for alike */
static const double JUMP = 0.1;    /* share by which a load differs where the front is off a bend or out of a duct */
static const double TREND = 0.15;  /* m: what a place moves by from roller to roller, and not from bend to bend */
enum { ENCLOSE_EVERY = 10, LOOKS = 7 }; /* rollers; looks at one, at most */

/* The front as far as the winch has hauled it, m: what the chain has stretched by since is behind in its place. */
static double hauled(const Scene *scene, double t)
{
    return scene->joint_s[scene->eye] + winch_travel(scene->winch, t);
}

void quasi_peaks_seen(QuasiRun *q, const Scene *scene, const hawser_sample *look)
{
    const double lag = hauled(scene, look->t) - look->head_at;
    if (isfinite(lag)) q->peak.lag = lag;
}

/* The nearest place of a roller behind s, or before it (side 1), m; NAN: there is none. */
static double beside(const SceneDef *def, double s, int side)
{
    double found = NAN;
    for (int r = 0; r < def->n_rollers; ++r) {
        const double away = side * (def->rollers[r].s - s);
        if (away > PAIR && !(away > side * (found - s))) found = def->rollers[r].s;
    }
    return found;
}

/* Where the front comes to the next roller while r bears it, or would if that were as near as the last one, m; NAN:
 * r stands where another does. */
static double landing(const SceneDef *def, int r)
{
    const double s = def->rollers[r].s, next = beside(def, s, 1), last = s - beside(def, s, -1);
    for (int k = 0; k < r; ++k)
        if (fabs(def->rollers[k].s - s) <= PAIR) return NAN;
    return next - s <= GAP * last || isnan(last) ? next : s + last;
}

hawser_status quasi_peaks_new(QuasiRun *q, const SceneDef *def, hawser_error *err)
{
    q->peak.side = 1;
    q->top = calloc((size_t)def->n_rollers + 1, sizeof *q->top);
    if (!q->top) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) q->top[r].landing = landing(def, r);
    return HAWSER_OK;
}

/* Looks that enclose the peak of one roller: places (m, of the winch's travel) and loads (N; NAN: not looked there). */
typedef struct Enclosed {
    int r, looks;
    double at[3], load[3]; /* the highest in the middle */
} Enclosed;

/* One more look, taken in for the peaks of all rollers. Where there is no position nothing is lost but a peak. */
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

/* Where to look next: a stride to one side, or half the way to what is known there; then on the other side. */
static double next_look(const Enclosed *e, double stride, int side)
{
    for (int k = 0; k < 2; ++k, side = -side) {
        const double way = fabs(e->at[1 + side] - e->at[1]);
        if (way <= 1.01 * BESIDE) continue;
        return e->at[1] + side * (way < 2 * stride ? way / 2 : stride);
    }
    return e->at[1];
}

/* A look at x has found this load. */
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

/* By how much the peak may stand above the highest look (QS11), N: the load is concave there. */
static double above(const Enclosed *e)
{
    const double *const at = e->at, *const load = e->load;
    const double rise = (load[1] - load[0]) / (at[1] - at[0]), fall = (load[1] - load[2]) / (at[2] - at[1]);
    return fmax(rise * (at[2] - at[1]), fall * (at[1] - at[0]));
}

/* There are looks on both sides, whose loads are less. */
static int is_closed(const Enclosed *e) { return e->load[0] > 0 && e->load[2] > 0; }

static int is_enclosed(const Enclosed *e)
{
    const double *const at = e->at;
    if (isnan(at[0]) || isnan(at[2])) return 0;
    return fmax(at[2] - at[1], at[1] - at[0]) < 1.01 * BESIDE || above(e) < WITHIN * e->load[1];
}

/* Looks at both sides, beyond the highest so far, until its peak is enclosed. `middle`: where none is farther away than
 * REACH. */
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

/* The peak of roller r, which is about where the front was at the last one's (QS9). */
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

hawser_status quasi_peaks(Sim *s, hawser_error *err)
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
