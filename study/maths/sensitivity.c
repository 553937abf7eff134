#include "study/maths/sensitivity.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/maths/estimate.h"

/* ------------------------------------------------------------------------------------------------------- Morris */

/* Of trajectory t: which coordinate is changed in step k, 0 <= k < d. */
static int morris_axis(uint64_t seed, uint64_t t, int d, int k)
{
    return (int)random_order(seed ^ (t + 1) * 0x9E3779B97F4A7C15u, (uint32_t)(1 << 20), (uint64_t)k, (uint64_t)d);
}

/* Half the levels apart, so that every level is met as often as any other (Morris' choice). */
static const double MORRIS_STEP = MORRIS_LEVELS / 2 / (MORRIS_LEVELS - 1.0);

/* +1 or -1: which way coordinate j of trajectory t goes; *from: where it begins, on the grid (SE1). */
static int morris_way(uint64_t seed, uint64_t t, int j, double *from)
{
    const double coin = random_uniform(seed, RANDOM_MORRIS, t, (uint32_t)(2 * j));
    const double level = floor(random_uniform(seed, RANDOM_MORRIS, t, (uint32_t)(2 * j + 1)) * (MORRIS_LEVELS / 2));
    const int up = coin < 0.5;
    *from = level / (MORRIS_LEVELS - 1.0) + (up ? 0 : MORRIS_STEP);
    return up ? 1 : -1;
}

void morris_point(uint64_t seed, uint64_t i, int d, double *u)
{
    const uint64_t t = i / (uint64_t)(d + 1), steps = i % (uint64_t)(d + 1);
    for (int j = 0; j < d; j++) morris_way(seed, t, j, &u[j]);
    for (uint64_t k = 0; k < steps; k++) {
        double from;
        const int j = morris_axis(seed, t, d, (int)k);
        u[j] += morris_way(seed, t, j, &from) * MORRIS_STEP;
    }
}

int morris_effects(uint64_t seed, int d, int trajectories, const double *y, MorrisEffect *effect)
{
    double *const plain = malloc(2 * (size_t)trajectories * (size_t)d * sizeof *plain), from;
    if (!plain) return 0;
    double *const size = plain + (size_t)trajectories * (size_t)d;
    for (int t = 0; t < trajectories; t++) {
        const double *const row = y + (size_t)t * (size_t)(d + 1);
        for (int k = 0; k < d; k++) {
            const int j = morris_axis(seed, (uint64_t)t, d, k);
            const size_t at = (size_t)j * (size_t)trajectories + (size_t)t;
            plain[at] = (row[k + 1] - row[k]) / (morris_way(seed, (uint64_t)t, j, &from) * MORRIS_STEP);
            size[at] = fabs(plain[at]);
        }
    }
    for (int j = 0; j < d; j++) {
        const Spread a = spread_of(trajectories, plain + (size_t)j * (size_t)trajectories);
        const Spread b = spread_of(trajectories, size + (size_t)j * (size_t)trajectories);
        effect[j] = (MorrisEffect){a.n, a.mean, b.mean, a.sd, b.mean_error};
    }
    free(plain);
    return 1;
}

/* -------------------------------------------------------------------------------------------------------- Sobol */

void sobol_design_point(uint64_t seed, uint64_t i, int d, double *u)
{
    const uint64_t block = i / (uint64_t)(d + 2);
    const int member = (int)(i % (uint64_t)(d + 2)); /* 0: A, 1: B, j + 2: A with coordinate j from B */
    for (int j = 0; j < d; j++) {
        const int from_b = member == 1 || member == j + 2;
        u[j] = points_at(POINTS_SOBOL, seed, block, 0, from_b ? d + j : j);
    }
}

enum { RESAMPLES = 500 };

/* The blocks that count: y of A and B and each of the d others, and which of them a resample takes. */
typedef struct Blocks {
    int d, n;
    const double **row; /* [n] of d+2 values */
    int *take;          /* [n] */
} Blocks;

/* The variance over A and B together, then (SE4) and (SE5) for parameter j, of the blocks that are taken. */
static void indices_of(const Blocks *b, int j, double *first, double *total)
{
    double mean = 0, variance = 0, to_b = 0, to_a = 0;
    for (int k = 0; k < b->n; k++) mean += (b->row[b->take[k]][0] + b->row[b->take[k]][1]) / (2 * b->n);
    for (int k = 0; k < b->n; k++) {
        const double *const y = b->row[b->take[k]];
        variance += ((y[0] - mean) * (y[0] - mean) + (y[1] - mean) * (y[1] - mean)) / (2 * b->n - 1);
        to_b += (y[1] - y[j + 2]) * (y[1] - y[j + 2]) / (2 * b->n);
        to_a += (y[0] - y[j + 2]) * (y[0] - y[j + 2]) / (2 * b->n);
    }
    *first = variance > 0 ? 1 - to_b / variance : NAN;
    *total = variance > 0 ? to_a / variance : NAN;
}

/* Percentiles of many resamples of the blocks, with replacement. */
static void bootstrap(uint64_t seed, Blocks *b, int j, double *first, double *total, SobolIndex *index)
{
    for (uint32_t r = 0; r < RESAMPLES; r++) {
        for (int k = 0; k < b->n; k++) {
            b->take[k] = (int)(random_uniform(seed, RANDOM_BOOTSTRAP, (uint64_t)k, r) * b->n);
        }
        indices_of(b, j, &first[r], &total[r]);
    }
    const int n = sort_finite(RESAMPLES, first), m = sort_finite(RESAMPLES, total);
    index->first_low = quantile_of_sorted(n, first, 0.025);
    index->first_high = quantile_of_sorted(n, first, 0.975);
    index->total_low = quantile_of_sorted(m, total, 0.025);
    index->total_high = quantile_of_sorted(m, total, 0.975);
}

/* The blocks of which all is known. */
static void blocks_find(int n, const double *y, Blocks *b)
{
    for (int k = 0; k < n; k++) {
        const double *const row = y + (size_t)k * (size_t)(b->d + 2);
        int known = 1;
        for (int m = 0; m < b->d + 2; m++) known &= isfinite(row[m]) != 0;
        if (known) b->row[b->n++] = row;
    }
}

int sobol_indices(uint64_t seed, int d, int n, const double *y, SobolIndex *index)
{
    Blocks b = {.d = d, .row = malloc(((size_t)n + 1) * sizeof *b.row), .take = malloc(((size_t)n + 1) * sizeof(int))};
    double first[RESAMPLES], total[RESAMPLES];
    int counted = -1;
    if (b.row && b.take) {
        blocks_find(n, y, &b);
        counted = b.n;
    }
    for (int j = 0; j < d && counted >= 0; j++) {
        index[j] = (SobolIndex){NAN, NAN, NAN, NAN, NAN, NAN};
        if (counted < 2) continue;
        for (int k = 0; k < b.n; k++) b.take[k] = k;
        indices_of(&b, j, &index[j].first, &index[j].total);
        bootstrap(seed, &b, j, first, total, &index[j]);
    }
    free(b.row);
    free(b.take);
    return counted;
}
