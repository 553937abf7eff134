#include "sim/run/passes.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"

/* Error bound over the difference of two passes: for the first pass 2 (errors halve); for the second 1, or 1/3 if
 * errors fall by a factor of four. TOO_MUCH: a pass's own bound is taken to be too wide by at most this factor for each
 * other pass that agrees. */
static const double FIRST = 2, SECOND = 1, SECOND_LEAST = 1.0 / 3, TOO_MUCH = 4;
/* Peaks are often those of impacts, whose error falls with the square root of what is halved (EB32). */
static const double SECOND_PEAK = 2.41421356237309505;
/* The loss of oscillations in the steps falls by at least a quarter per level: that of the first pass is four times the
 * difference. */
static const double SWINGS_FIRST = 4, SWINGS_SECOND = 3;

/* Mean and peak of the pull come first. */
enum { OF_MEAN, OF_PEAK, OF_TABLES };

/* --------------------------------------------------------------------------------------------- figures of a pass */

/* Stores one figure in its place, or leaves the place empty. */
static void figure_put(PassFigures *f, double value, double bar)
{
    f->value[f->n] = value;
    f->bar[f->n++] = bar;
}

hawser_status pass_figures_take(PassFigures *out, const Stats *stats, const hawser_summary *figures, double jolt,
                                hawser_error *err)
{
    const hawser_error_bar *const mean = &figures->pull_mean_error, *const peak = &figures->pull_peak_error;
    const size_t most =
        OF_TABLES + 2 * (size_t)stats->n_stations + 2 * (size_t)stats->n_rollers + (size_t)stats->n_surfaces;
    *out = (PassFigures){.value = malloc(2 * most * sizeof(double)), .jolt = jolt};
    if (!out->value) return error_memory(err);
    out->bar = out->value + most;
    figure_put(out, figures->pull_mean_N, mean->time + mean->mesh);
    figure_put(out, figures->pull_peak_N, peak->time + peak->mesh);
    for (int i = 0; i < stats->n_stations; ++i) {
        const hawser_station *const s = &stats->station_out[i];
        figure_put(out, s->mean_N, s->mean_error_N);
        figure_put(out, s->peak_N, s->peak_error_N);
    }
    for (int r = 0; r < stats->n_rollers; ++r) {
        const hawser_roller *const row = &stats->roller_out[r];
        figure_put(out, row->steady_N, row->steady_error_N);
        figure_put(out, row->peak_N, row->peak_error_N);
    }
    for (int i = 0; i < stats->n_surfaces; ++i)
        figure_put(out, stats->surface_out[i].line_load_N_per_m, stats->surface_out[i].line_load_error);
    return HAWSER_OK;
}

void pass_figures_free(PassFigures *f)
{
    free(f->value);
    *f = (PassFigures){0};
}

void other_passes_free(OtherPasses *others)
{
    for (int k = 0; k < PASSES_MAX - 1; ++k) pass_figures_free(&others->other[k]);
    *others = (OtherPasses){0};
}

/* -------------------------------------------------------------------------------------------- difference of passes */

/* Checks whether this is the first of three passes: the error of all is then given by the last of them. */
static int is_first_of_three(const OtherPasses *o) { return o->finer && o->n > 1; }

/* Difference of figure i from that of the finest other pass. */
static double apart(const OtherPasses *o, int i, double value) { return fabs(o->other[0].value[i] - value); }

/* Error bound of this pass over the difference of two: for the coarser one the difference plus the bound of the finer
 * one (EB19), (EB20), (EB32). */
static double of_two(const OtherPasses *o, int i)
{
    const double second = i == OF_PEAK ? SECOND_PEAK : SECOND;
    return o->finer ? 1 + second : second;
}

/* Upper bound of the error by all passes (EB19), (EB20), (EB27), (EB28); NAN: they cannot be compared. */
static double most_of(const OtherPasses *o, int i, double value)
{
    const double difference = apart(o, i, value);
    if (is_first_of_three(o)) return difference + o->other[0].bar[i];
    if (o->finer || o->n < 2) return of_two(o, i) * difference;
    const double before = fabs(o->other[1].value[i] - o->other[0].value[i]);
    return isnan(before + difference) ? NAN : fmax(SECOND * difference, SECOND_LEAST * before);
}

/* Checks whether the figure differs from the coarser pass's by more than that one's bound: such bounds are then too
 * narrow here (EB29). */
static int is_refuted(const OtherPasses *o, int i, double value)
{
    return !o->finer && apart(o, i, value) > o->other[0].bar[i];
}

static double least_of(const OtherPasses *o, int i, double value)
{
    return (o->finer ? FIRST : is_refuted(o, i, value) ? SECOND : SECOND_LEAST) * apart(o, i, value);
}

/* Number of other passes that narrow a bound by agreeing: for a peak those whose own bound was wider, each coarser than
 * the next. A difference that does not fall belongs to something that no mesh has resolved yet (EB30). */
static int agree(const OtherPasses *o, int i)
{
    int falls = 0;
    if (i != OF_PEAK || o->finer) return o->n;
    for (int k = 0; k < o->n; ++k) falls += o->peak_alone[k] < o->peak_alone[k + 1];
    return falls;
}

/* Error bound by the pass's own estimate and the difference of the passes. */
static double seen(const OtherPasses *o, int i, double bar, double value)
{
    const double most = most_of(o, i, value);
    if (isnan(most) || isnan(bar)) return bar;
    if (o->unsound) return fmax(bar, least_of(o, i, value));
    if (is_first_of_three(o)) return most;
    return fmin(fmax(bar, least_of(o, i, value)), fmax(most, bar / pow(TOO_MUCH, agree(o, i))));
}

/* Scales the parts of the bound in proportion; swings: the part of lost oscillations, N, which falls slowly (EB23). The
 * part of friction at rest does not fall with v_s in any order and stays. */
static void bar_seen(const OtherPasses *o, int i, hawser_error_bar *bar, double value, double swings)
{
    const double known = bar->time + bar->mesh;
    if (!(known > 0)) return;
    const double slowly = (o->finer ? SWINGS_FIRST : SWINGS_SECOND) * apart(o, i, value);
    const double swing = is_first_of_three(o) ? 0 : fmin(slowly, swings); /* included in the last pass's bound */
    const double by = fmax(seen(o, i, known, value), swing) / known;
    bar->time *= by;
    bar->mesh *= by;
    bar->total = bar->time + bar->mesh + bar->friction;
}

/* A jolt that grows with the refinement of the mesh may become the largest pull although it is not in this pass: its
 * extrapolation is included in the peak's bound (EB22). */
static void jolt_seen(const OtherPasses *o, double jolt, hawser_summary *figures)
{
    hawser_error_bar *const bar = &figures->pull_peak_error;
    if (is_first_of_three(o))
        return;                                                                        /* included in the last pass's
                                                                                        * bound */
    const double grows = o->finer ? o->other[0].jolt - jolt : jolt - o->other[0].jolt; /* per refinement of the mesh */
    const double above = jolt + (o->finer ? FIRST : SECOND) * grows - figures->pull_peak_N;
    if (!(grows > 0) || above <= bar->mesh) return;
    bar->mesh = above;
    bar->total = bar->time + bar->mesh + bar->friction;
}

void other_passes_bars(const OtherPasses *o, const Stats *stats, double jolt, hawser_summary *figures)
{
    if (o->n == 0) return;
    int i = OF_TABLES;
    bar_seen(o, OF_MEAN, &figures->pull_mean_error, figures->pull_mean_N, 0);
    bar_seen(o, OF_PEAK, &figures->pull_peak_error, figures->pull_peak_N, stats->faded);
    jolt_seen(o, jolt, figures);
    /* the others' bounds are not divided into parts */
    if (figures->pull_peak_error.friction > 0) return;
    for (int k = 0; k < stats->n_stations; ++k) {
        hawser_station *const s = &stats->station_out[k];
        s->mean_error_N = seen(o, i++, s->mean_error_N, s->mean_N);
        s->peak_error_N = seen(o, i++, s->peak_error_N, s->peak_N);
    }
    for (int r = 0; r < stats->n_rollers; ++r) {
        hawser_roller *const row = &stats->roller_out[r];
        row->steady_error_N = seen(o, i++, row->steady_error_N, row->steady_N);
        row->peak_error_N = seen(o, i++, row->peak_error_N, row->peak_N);
    }
    for (int k = 0; k < stats->n_surfaces; ++k) {
        hawser_surface *const row = &stats->surface_out[k];
        row->line_load_error = seen(o, i++, row->line_load_error, row->line_load_N_per_m);
    }
}

double other_passes_share(const OtherPasses *o, const hawser_summary *figures)
{
    const double mean = fabs(figures->pull_mean_N);
    const double most = o->n > 0 && !o->unsound ? most_of(o, OF_MEAN, figures->pull_mean_N) : NAN;
    return mean > 0 && !isnan(most) ? most / mean : INFINITY;
}

double other_passes_apart(const OtherPasses *o, int peak, const hawser_summary *figures)
{
    return o->n > 0 ? apart(o, peak ? OF_PEAK : OF_MEAN, peak ? figures->pull_peak_N : figures->pull_mean_N) : 0;
}
