#include "sim/watch/position_table.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "theory/expected.h"

enum { GRID_MOST = 400, BINS_MOST = 200 };
static const double GRID = 0.5, BIN = 2; /* m, at least */
static const double SHIFT = 100;         /* N, of the back tension for its gain */

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

/* How many parts of at least `length` m, but no more than `most`. */
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

/* At x places of the grid from its first, on the line through two neighbours; of one that has none on its side of where
 * the cable leaves the drum, as it is. */
static double on_grid(const ByPosition *b, const double *of, double x)
{
    const int last = b->n_grid - 2;
    int i = x < last ? (int)x : last;
    if (i + 1 == b->left) /* nothing between them is the mean of both */
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
