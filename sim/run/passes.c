#include "sim/run/passes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

/* Of a difference: the first pass's error is twice as large if errors halve, the second's as large as it, or a third if
 * they fall by four. What a pass says of itself is not believed to be more than so many times too much. */
static const double FIRST = 2, SECOND = 1, SECOND_LEAST = 1.0 / 3, TOO_MUCH = 4;
/* What steps take of swings falls by a quarter a level at least: the first pass's is four times the difference. */
static const double SWINGS_FIRST = 4, SWINGS_SECOND = 3;

static double most_of(const OtherPass *o, double difference) { return (o->finer ? FIRST : SECOND) * difference; }
static double least_of(const OtherPass *o, double difference) { return (o->finer ? FIRST : SECOND_LEAST) * difference; }

/* An error bar by what the pass shows itself and by what the other one differs (EB19), (EB20). */
static double seen(const OtherPass *o, double bar, double other)
{
    const double difference = fabs(other);
    if (isnan(difference) || isnan(bar)) return bar;
    if (o->unsound) return fmax(bar, least_of(o, difference));
    return fmin(fmax(bar, least_of(o, difference)), fmax(most_of(o, difference), bar / TOO_MUCH));
}

/* In its parts, each as much as it was of the whole; swings: what of it steps took of them, N, which falls slowly
 * (EB23). What friction at rest makes does not fall with v_s in any order, and stays. */
static void bar_seen(const OtherPass *o, hawser_error_bar *bar, double other, double swings)
{
    const double known = bar->time + bar->mesh;
    if (!(known > 0)) return;
    const double slowly = (o->finer ? SWINGS_FIRST : SWINGS_SECOND) * fabs(other);
    const double by = fmax(seen(o, known, other), fmin(slowly, swings)) / known;
    bar->time *= by;
    bar->mesh *= by;
    bar->total = bar->time + bar->mesh + bar->friction;
}

/* A jolt that grows as the mesh is refined may be the largest pull in the end, though it is not in this pass: what it
 * comes to by both is in the peak's bar (EB22). */
static void jolt_seen(const OtherPass *o, double jolt, hawser_summary *figures)
{
    hawser_error_bar *const bar = &figures->pull_peak_error;
    const double grows = o->finer ? o->jolt - jolt : jolt - o->jolt; /* as the mesh is refined */
    const double above = jolt + most_of(o, grows) - figures->pull_peak_N;
    if (!(grows > 0) || above <= bar->mesh) return;
    bar->mesh = above;
    bar->total = bar->time + bar->mesh + bar->friction;
}

hawser_status other_pass_take(OtherPass *out, const Stats *stats, const hawser_summary *figures, double jolt, int finer,
                              int unsound, hawser_error *err)
{
    *out = (OtherPass){.present = 1,
                       .finer = finer,
                       .unsound = unsound,
                       .mean = figures->pull_mean_N,
                       .peak = figures->pull_peak_N,
                       .jolt = jolt,
                       .n_stations = stats->n_stations,
                       .n_rollers = stats->n_rollers,
                       .n_surfaces = stats->n_surfaces};
    out->station = malloc((2 * (size_t)out->n_stations + 1) * sizeof(double));
    out->roller = malloc((2 * (size_t)out->n_rollers + 1) * sizeof(double));
    out->line_load = malloc(((size_t)out->n_surfaces + 1) * sizeof(double));
    if (!out->station || !out->roller || !out->line_load) {
        other_pass_free(out);
        return error_memory(err);
    }
    for (int i = 0; i < out->n_stations; ++i) {
        out->station[2 * i] = stats->station_out[i].mean_N;
        out->station[2 * i + 1] = stats->station_out[i].peak_N;
    }
    for (int r = 0; r < out->n_rollers; ++r) {
        out->roller[2 * r] = stats->roller_out[r].steady_N;
        out->roller[2 * r + 1] = stats->roller_out[r].peak_N;
    }
    for (int i = 0; i < out->n_surfaces; ++i) out->line_load[i] = stats->surface_out[i].line_load_N_per_m;
    return HAWSER_OK;
}

void other_pass_free(OtherPass *other)
{
    free(other->station);
    free(other->roller);
    free(other->line_load);
    *other = (OtherPass){0};
}

void other_pass_bars(const OtherPass *o, const Stats *stats, double jolt, hawser_summary *figures)
{
    if (!o->present) return;
    bar_seen(o, &figures->pull_mean_error, o->mean - figures->pull_mean_N, 0);
    bar_seen(o, &figures->pull_peak_error, o->peak - figures->pull_peak_N, stats->faded);
    jolt_seen(o, jolt, figures);
    /* of the others the parts are not told apart */
    if (figures->pull_peak_error.friction > 0) return;
    for (int i = 0; i < o->n_stations; ++i) {
        hawser_station *const s = &stats->station_out[i];
        s->mean_error_N = seen(o, s->mean_error_N, o->station[2 * i] - s->mean_N);
        s->peak_error_N = seen(o, s->peak_error_N, o->station[2 * i + 1] - s->peak_N);
    }
    for (int r = 0; r < o->n_rollers; ++r) {
        hawser_roller *const row = &stats->roller_out[r];
        row->steady_error_N = seen(o, row->steady_error_N, o->roller[2 * r] - row->steady_N);
        row->peak_error_N = seen(o, row->peak_error_N, o->roller[2 * r + 1] - row->peak_N);
    }
    for (int i = 0; i < o->n_surfaces; ++i) {
        hawser_surface *const row = &stats->surface_out[i];
        row->line_load_error = seen(o, row->line_load_error, o->line_load[i] - row->line_load_N_per_m);
    }
}

double other_pass_share(const OtherPass *o, const hawser_summary *figures)
{
    const double mean = fabs(figures->pull_mean_N), difference = fabs(o->mean - figures->pull_mean_N);
    return o->present && !o->unsound && mean > 0 && !isnan(difference) ? most_of(o, difference) / mean : INFINITY;
}
