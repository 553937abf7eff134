/* A thick front behind a thin rope loads a roller most as it comes to the next one, within a few centimetres of way:
 * positions farther apart would miss that. docs/model/45-quasi-static.md (QS9). */
#include <math.h>

#include "sim/equipment/winch.h"
#include "sim/run/quasi_run.h"
#include "sim/run/sim.h"

static const double BESIDE = 0.04; /* m, between two looks at a peak */
static const double SAME = 1e-6;   /* m: the last position is one of these */
static const double REACH = 0.5;   /* m, by which a peak may be away from where the front is above the roller */

/* The front as far as the winch has hauled it, m. */
static double hauled(const Scene *scene, double t)
{
    return scene->joint_s[scene->eye] + winch_travel(scene->winch, t);
}

/* The nearest roller before roller n, or -1. */
static int behind(const SceneDef *def, int n)
{
    int found = -1;
    for (int r = 0; r < def->n_rollers; ++r) {
        const double s = def->rollers[r].s;
        if (s < def->rollers[n].s - BESIDE && (found < 0 || s > def->rollers[found].s)) found = r;
    }
    return found;
}

/* Load of roller r with the front at `head`, N, taken in for the peaks; NAN: there is no such position. */
static hawser_status look_at(Sim *s, double head, int r, double *load, hawser_error *err)
{
    const QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double last = q->t[QUASI_KEPT - 1], back = hauled(scene, last) - head;
    hawser_relaxation found;
    *load = NAN;
    const hawser_status status = quasi_find(s, last - back / winch_speed(scene->winch, last), &found, err);
    s->quasi.said.iterations += found.iterations;
    if (status == HAWSER_ERR_RUN) return HAWSER_OK; /* nothing is lost but a peak */
    if (status) return status;
    ++s->quasi.said.positions;
    sim_relaxation_take(s, &found);
    const hawser_sample *const look = sim_look(s, SAMPLE_ROW);
    *load = look->roller_load[r];
    stats_raise(&s->stats, look);
    return status;
}

/* A look where the last peak has been; at every other roller one beside it, which says where to look next time. */
static hawser_status peak_of(Sim *s, int n, int r, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const double place = s->stage.scene.def.rollers[n].s;
    double here = NAN, there = NAN;
    const double *const last = q->look[QUASI_KEPT - 1];
    const int there_now = fabs(place + q->peak_at - hauled(&s->stage.scene, q->t[QUASI_KEPT - 1])) < SAME;
    hawser_status status = HAWSER_OK;
    if (there_now) here = quasi_roller_load(s, last, r);
    if (!there_now) status = look_at(s, place + q->peak_at, r, &here, err);
    const int beside = q->peak_side == 0 || ++q->peaks % 2 == 0;
    if (q->peak_side == 0) q->peak_side = 1;
    for (int k = 0; !status && beside && k < 3; ++k) {
        status = look_at(s, place + q->peak_at + q->peak_side * BESIDE, r, &there, err);
        if (!(there > here)) {
            if (k == 0) q->peak_side = -q->peak_side;
            break;
        }
        q->peak_at = fmax(-REACH, fmin(REACH, q->peak_at + q->peak_side * BESIDE));
        here = there;
    }
    return status;
}

double quasi_next_peak(const Sim *s, double from, double end)
{
    const Scene *const scene = &s->stage.scene;
    const double speed = winch_speed(scene->winch, from), first = hauled(scene, from);
    double next = end;
    for (int n = 0; n < scene->def.n_rollers; ++n) {
        const double way = scene->def.rollers[n].s + s->quasi.peak_at - first;
        if (way >= 0 && way < speed * (next - from)) next = from + way / speed;
    }
    return next;
}

hawser_status quasi_peaks(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double from = hauled(scene, q->t[QUASI_KEPT - 2]), to = hauled(scene, q->t[QUASI_KEPT - 1]);
    hawser_status status = HAWSER_OK;
    Moving last = {0};
    for (int n = 0; !status && n < scene->def.n_rollers; ++n) {
        const double place = scene->def.rollers[n].s + q->peak_at;
        const int r = place > from + SAME && place <= to + SAME ? behind(&scene->def, n) : -1;
        if (r < 0) continue;
        if (!last.y) status = moving_keep(&last, &s->stage, err);
        q->probing = 1;
        if (!status) status = peak_of(s, n, r, err);
    }
    q->probing = 0;
    if (!status && last.y) status = moving_restore(&s->stage, &last, err);
    moving_free(&last);
    return status;
}
