/* What theory says of the whole way of a run, for what is judged. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/drum.h"
#include "sim/equipment/reel.h"
#include "sim/judge/peaks.h"

/* Overload factors are taken where theory has at least this share of its largest tension: near a slack tail a few
 * newtons would make any ratio. */
static const double MEASURE = 0.1;

/* With the front where it has come to; a route on which theory has no answer there stays with `of`. */
static hawser_status reached_find(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                                  PeaksTheory *out, hawser_error *err)
{
    const double front = fmin(peaks->reached, scene->route.length);
    const int counted = scene->weight.lead_in && !scene->def.strand.present && !scene->drum->present;
    Pull pull;
    if (!counted || !(front > of->to + 1e-9)) return HAWSER_OK;
    const Setup setup = scene_setup(scene);
    hawser_status status = expected_at(&setup, front, expected_back(&setup, stats->last_t), &out->own, err);
    if (!status) status = expected_pull(&setup, &out->own, PULL_REFERENCE, &pull, err);
    if (status) return status == HAWSER_ERR_MEMORY ? status : HAWSER_OK;
    out->own.reference_total = pull.end_tension + scene->def.drag.force;
    out->at = &out->own;
    pull_clear(&pull);
    return HAWSER_OK;
}

hawser_status peaks_theory(const Peaks *peaks, const Stats *stats, const Scene *scene, const Expected *of,
                           PeaksTheory *out, hawser_error *err)
{
    double relief = 0;
    *out = (PeaksTheory){.at = of};
    hawser_status status = peaks->present ? reached_find(peaks, stats, scene, of, out, err) : HAWSER_OK;
    if (!status && peaks->present) status = expected_relief(&scene->setup, peaks->reached, &relief, err);
    out->needed = fmax(of->reference_total, out->at->reference_total);
    out->beyond = scene->def.drag.force - relief;
    if (status) peaks_theory_free(out);
    return status;
}

void peaks_theory_free(PeaksTheory *theory) { expected_free(&theory->own); }

/* ------------------------------------------------------------------------------------------------- overload */

/* Theory with the front where it was at a moment. The last one is kept: neighbours have their peaks together. */
typedef struct Moments {
    Setup setup;
    PeakMoment at; /* of what follows; t is NAN: of none yet */
    Expected expected;
    Pull pull;
    hawser_status status;
} Moments;

static void moment_clear(Moments *m)
{
    expected_free(&m->expected);
    if (!isnan(m->at.t)) pull_clear(&m->pull);
    m->at.t = NAN;
}

static int same_moment(PeakMoment a, PeakMoment b) { return a.front == b.front && a.t == b.t; }

/* The tension of the reference theory at s at that moment, N; NAN off the cable that theory counts, and where it has
 * too little of it. */
static double moment_tension(Moments *m, PeakMoment at, double s)
{
    const Setup *const setup = &m->setup;
    if (isnan(m->at.t) || !same_moment(m->at, at)) {
        moment_clear(m);
        const double front = fmin(at.front, expected_end(setup));
        m->status = expected_at(setup, front, expected_back(setup, at.t), &m->expected, NULL);
        if (!m->status) m->status = expected_pull(setup, &m->expected, PULL_REFERENCE, &m->pull, NULL);
        if (!m->status) m->at = at;
    }
    if (m->status || !(s >= m->expected.from - 1e-9 && s <= m->expected.to + 1e-9)) return NAN;
    const double tension = pull_at(&m->pull, s).tension;
    return tension >= MEASURE * m->pull.max_tension ? tension : NAN;
}

/* The least and the largest tension at the start while rollers had their peaks, N, and the pulls with them up to where
 * the front came to: of a cable whose tail has not come in, between those two the tension anywhere goes with that at
 * the start, but for the part of bends in which weight counts. */
typedef struct Range {
    double start[2];
    Pull pull[2];
    double *of; /* [rollers] N, the start's */
} Range;

static hawser_status range_solve(const Peaks *peaks, const Scene *scene, const Expected *e, Range *out)
{
    *out = (Range){{INFINITY, -INFINITY}, {{0}, {0}}, malloc(((size_t)peaks->n_rollers + 1) * sizeof(double))};
    const Setup setup = scene_setup(scene);
    hawser_status status = out->of ? HAWSER_OK : HAWSER_ERR_MEMORY;
    for (int r = 0; r < peaks->n_rollers && !status; ++r) {
        if (isnan(peaks->roller[r])) continue;
        out->of[r] = expected_start(&setup, peaks->when[r].front, expected_back(&setup, peaks->when[r].t));
        out->start[0] = fmin(out->start[0], out->of[r]);
        out->start[1] = fmax(out->start[1], out->of[r]);
    }
    for (int k = 0; k < 2 && !status && isfinite(out->start[0]); ++k) {
        Expected with = *e; /* borrowed */
        with.start_tension = out->start[k];
        status = expected_pull(&setup, &with, PULL_REFERENCE, &out->pull[k], NULL);
    }
    return status;
}

static void range_clear(Range *range)
{
    for (int k = 0; k < 2; ++k) pull_clear(&range->pull[k]);
    free(range->of);
}

static double range_tension(const Expected *e, const Range *range, int r, double s)
{
    const double wide = range->start[1] - range->start[0];
    if (!(s >= e->from - 1e-9 && s <= e->to + 1e-9)) return NAN;
    const double low = pull_at(&range->pull[0], s).tension, high = pull_at(&range->pull[1], s).tension;
    const double tension = wide > 0 ? low + (high - low) * (range->of[r] - range->start[0]) / wide : low;
    return tension >= MEASURE * range->pull[1].max_tension ? tension : NAN;
}

/* Whether the pull begins at one place for as long as there is one: the cable's tail stays behind it. */
static int begins_at_once(const Scene *scene, const Peaks *peaks)
{
    const double length = scene->joint_s[scene->eye] - scene->joint_s[0];
    return scene->weight.lead_in && peaks->reached - length <= 0;
}

int peaks_overload(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory, Overload **out)
{
    Range range = {0};
    Moments moments = {.setup = scene_setup(scene), .at = {.t = NAN}};
    int n = 0;
    *out = malloc(((size_t)peaks->n_rollers + 1) * sizeof **out);
    /* a rod has no theory to ask, that of a rope goes without what it draws */
    if (*out && (!peaks->present || scene->def.strand.rope)) return 0;
    const int at_once = begins_at_once(scene, peaks);
    hawser_status status = *out ? HAWSER_OK : HAWSER_ERR_MEMORY;
    if (!status && at_once) status = range_solve(peaks, scene, theory->at, &range);
    for (int r = 0; r < peaks->n_rollers && !status; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double s = roller->s, peak = peaks->roller[r];
        if (isnan(s) || isnan(peak)) continue;
        const double reference =
            at_once ? range_tension(theory->at, &range, r, s) : moment_tension(&moments, peaks->when[r], s);
        status = moments.status == HAWSER_ERR_MEMORY ? moments.status : HAWSER_OK;
        if (!isnan(reference)) (*out)[n++] = (Overload){roller->name, s, peak, reference, peak / reference};
    }
    range_clear(&range);
    moment_clear(&moments);
    return status ? -1 : n;
}
