/* What theory says of the whole way of a run, for what is judged. */
#include <math.h>
#include <stdlib.h>

#include "core/base/error.h"
#include "sim/equipment/drum.h"
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
    hawser_status status = expected_at(scene, front, expected_back(scene, stats->last_t), &out->own, err);
    if (!status) status = expected_pull(scene, &out->own, PULL_REFERENCE, &pull, err);
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
    if (!status && peaks->present) status = expected_relief(scene, peaks->reached, &relief, err);
    out->needed = fmax(of->reference_total, out->at->reference_total);
    out->beyond = scene->def.drag.force - relief;
    if (status) peaks_theory_free(out);
    return status;
}

void peaks_theory_free(PeaksTheory *theory) { expected_free(&theory->own); }

/* ------------------------------------------------------------------------------------------------- overload */

/* The least and the largest tension at the start while rollers had their peaks, N, and the pulls with them. */
typedef struct Range {
    double start[2];
    Pull pull[2];
} Range;

static hawser_status range_solve(const Peaks *peaks, const Scene *scene, const Expected *e, Range *out)
{
    *out = (Range){{INFINITY, -INFINITY}, {{0}, {0}}};
    hawser_status status = HAWSER_OK;
    for (int r = 0; r < peaks->n_rollers; ++r) {
        if (isnan(peaks->roller[r])) continue;
        out->start[0] = fmin(out->start[0], peaks->start[r]);
        out->start[1] = fmax(out->start[1], peaks->start[r]);
    }
    for (int k = 0; k < 2 && !status && isfinite(out->start[0]); ++k) {
        Expected with = *e; /* borrowed */
        with.start_tension = out->start[k];
        status = expected_pull(scene, &with, PULL_REFERENCE, &out->pull[k], NULL);
    }
    return status;
}

static void range_clear(Range *range)
{
    for (int k = 0; k < 2; ++k) pull_clear(&range->pull[k]);
}

/* The tension of the reference theory at s, N, where the pull begins with `start`: the tension there grows with it
 * evenly, but for the part of bends in which weight counts. NAN off the cable that theory counts, and where it has too
 * little of it. */
static double reference_at(const Expected *e, const Range *range, double s, double start)
{
    const double wide = range->start[1] - range->start[0];
    if (!(s >= e->from - 1e-9 && s <= e->to + 1e-9)) return NAN;
    const double low = pull_at(&range->pull[0], s).tension, high = pull_at(&range->pull[1], s).tension;
    const double reference = wide > 0 ? low + (high - low) * (start - range->start[0]) / wide : low;
    return reference >= MEASURE * range->pull[1].max_tension ? reference : NAN;
}

int peaks_overload(const Peaks *peaks, const Scene *scene, const PeaksTheory *theory, Overload **out)
{
    Range range;
    int n = 0;
    *out = malloc(((size_t)peaks->n_rollers + 1) * sizeof **out);
    if (*out && !peaks->present) return 0; /* a rod has no theory to ask */
    const hawser_status status = *out ? range_solve(peaks, scene, theory->at, &range) : HAWSER_ERR_MEMORY;
    for (int r = 0; r < peaks->n_rollers && !status; ++r) {
        const RollerDef *const roller = &scene->def.rollers[r];
        const double peak = peaks->roller[r];
        const double reference = isnan(peak) ? NAN : reference_at(theory->at, &range, roller->s, peaks->start[r]);
        if (isnan(reference)) continue;
        (*out)[n++] = (Overload){roller->name, roller->s, peak, reference, peak / reference};
    }
    if (*out) range_clear(&range);
    return status ? -1 : n;
}
