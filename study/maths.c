#include "study/maths.h"

#include <assert.h>
#include <math.h>
#include <nlopt.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double normal_share(double z) { return 0.5 * erfc(-z * M_SQRT1_2); }

/* Begins with a rational approximation (M. Abramowitz, I. Stegun, Handbook of Mathematical Functions, 26.2.23; off
 * by 4.5e-4), then takes Halley's steps, each of which cubes the error. It works on the smaller tail, where shares keep
 * their digits. */
double normal_quantile(double p)
{
    const int upper = p > 0.5;
    const double tail = upper ? 1 - p : p, t = sqrt(-2 * log(tail));
    double z = (2.515517 + t * (0.802853 + t * 0.010328)) / (1 + t * (1.432788 + t * (0.189269 + t * 0.001308))) - t;
    for (int k = 0; k < 3; k++) {
        const double step = (normal_share(z) - tail) * sqrt(2 * M_PI) * exp(z * z / 2);
        z -= step / (1 + z * step / 2);
    }
    return upper ? -z : z;
}

/* Normal score at the share u of the probability between low and high, which are scores themselves. It works on the
 * side where shares are small. */
static double score_between(double low, double high, double u)
{
    if (isinf(low) && isinf(high)) return normal_quantile(u);
    if (low > 0) return -score_between(-high, -low, 1 - u);
    const double from = normal_share(low), to = normal_share(high);
    return fmin(high, fmax(low, normal_quantile(from + u * (to - from))));
}

static double triangular(double a, double b, double c, double u)
{
    const double left = (c - a) / (b - a);
    if (u < left) return a + sqrt(u * (b - a) * (c - a));
    return b - sqrt((1 - u) * (b - a) * (b - c));
}

static double discrete(int n, const double *weight, double u)
{
    double sum = 0, so_far = 0;
    for (int k = 0; k < n; k++) sum += weight[k];
    for (int k = 0; k < n; k++) {
        so_far += weight[k];
        if (u * sum < so_far) return k;
    }
    return n - 1;
}

double distribution_quantile(const Distribution *d, double u)
{
    switch (d->kind) {
    case LAW_UNIFORM:
        return d->a + u * (d->b - d->a);
    case LAW_NORMAL:
        return d->a + d->b * score_between((d->low - d->a) / d->b, (d->high - d->a) / d->b, u);
    case LAW_LOGNORMAL: {
        const double s = log(d->b), low = d->low > 0 ? log(d->low / d->a) / s : -INFINITY;
        return d->a * exp(s * score_between(low, log(d->high / d->a) / s, u));
    }
    case LAW_TRIANGULAR:
        return triangular(d->a, d->b, d->c, u);
    case LAW_DISCRETE:
        break;
    }
    return discrete(d->n, d->weight, u);
}

/* Computes Cholesky's factor. */
int correlation_factor(int n, const double *r, double *l)
{
    for (int i = 0; i < n; i++) {
        for (int j = 0; j < n; j++) {
            double sum = r[i * n + j];
            for (int k = 0; k < j && j <= i; k++) sum -= l[i * n + k] * l[j * n + k];
            if (j == i && !(sum > 1e-12)) return i;
            l[i * n + j] = j > i ? 0 : j == i ? sqrt(sum) : sum / l[j * n + j];
        }
    }
    return -1;
}

/* Applies the correlations. Rounding must not reach 0 or 1, whose quantiles are infinite. */
void correlation_apply(int n, const double *l, double *u, double *z)
{
    for (int i = 0; i < n; i++) z[i] = normal_quantile(u[i]);
    for (int i = 0; i < n; i++) {
        double score = 0;
        for (int k = 0; k <= i; k++) score += l[i * n + k] * z[k];
        u[i] = fmin(fmax(normal_share(score), 0x1p-1000), 1 - 0x1p-53);
    }
}

/* The normal score of 97.5 %. */
static const double TWO_SIDED = 1.959963984540054;

Share share_of(long hits, long n)
{
    const double z2 = TWO_SIDED * TWO_SIDED, N = (double)n, p = (double)hits / N;
    if (n <= 0) return (Share){NAN, NAN, NAN};
    const double middle = (p + z2 / (2 * N)) / (1 + z2 / N);
    const double half = TWO_SIDED / (1 + z2 / N) * sqrt(p * (1 - p) / N + z2 / (4 * N * N));
    /* the interval includes the ends exactly */
    return (Share){p, hits == 0 ? 0 : middle - half, hits == n ? 1 : middle + half};
}

Share share_percent(Share s) { return (Share){100 * s.value, 100 * s.low, 100 * s.high}; }

/* Computes the mean first, then the squares about it, so that a large mean costs no digits. */
Spread spread_of(int n, const double *x)
{
    Spread s = {.mean = NAN, .sd = NAN, .least = NAN, .most = NAN, .mean_error = NAN};
    double sum = 0, squares = 0;
    for (int i = 0; i < n; i++) {
        if (!isfinite(x[i])) continue;
        sum += x[i];
        s.least = s.n ? fmin(s.least, x[i]) : x[i];
        s.most = s.n ? fmax(s.most, x[i]) : x[i];
        s.n++;
    }
    if (s.n == 0) return s;
    s.mean = sum / (double)s.n;
    for (int i = 0; i < n; i++) squares += isfinite(x[i]) ? (x[i] - s.mean) * (x[i] - s.mean) : 0;
    if (s.n > 1) s.sd = sqrt(squares / (double)(s.n - 1));
    s.mean_error = TWO_SIDED * s.sd / sqrt((double)s.n);
    return s;
}

double quantile_of_sorted(int n, const double *x, double p)
{
    if (n == 0) return NAN;
    const double place = p * (n - 1);
    const int below = (int)place;
    return below + 1 < n ? x[below] + (place - below) * (x[below + 1] - x[below]) : x[n - 1];
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

int sort_finite(int n, double *x)
{
    int kept = 0;
    for (int i = 0; i < n; i++) {
        if (isfinite(x[i])) x[kept++] = x[i];
    }
    qsort(x, (size_t)kept, sizeof *x, compare);
    return kept;
}

/* Philox-4x32: multipliers, and the increment of the key per round. */
static const uint32_t MULTIPLY[2] = {0xD2511F53u, 0xCD9E8D57u}, WEYL[2] = {0x9E3779B9u, 0xBB67AE85u};

enum { ROUNDS = 10 };

RandomWords random_words(uint64_t key, const uint32_t counter[4])
{
    uint32_t k0 = (uint32_t)key, k1 = (uint32_t)(key >> 32);
    RandomWords x = {{counter[0], counter[1], counter[2], counter[3]}};
    for (int r = 0; r < ROUNDS; r++, k0 += WEYL[0], k1 += WEYL[1]) {
        const uint64_t a = (uint64_t)MULTIPLY[0] * x.word[0], b = (uint64_t)MULTIPLY[1] * x.word[2];
        const RandomWords next = {
            {(uint32_t)(b >> 32) ^ x.word[1] ^ k0, (uint32_t)b, (uint32_t)(a >> 32) ^ x.word[3] ^ k1, (uint32_t)a}};
        x = next;
    }
    return x;
}

/* Words for a use and two numbers. Counters of i with more than 32 bits and of j do not overlap. */
static RandomWords words_of(uint64_t seed, RandomUse use, uint64_t i, uint32_t j)
{
    const uint32_t counter[4] = {(uint32_t)i, (uint32_t)(i >> 32), j, (uint32_t)use};
    return random_words(seed, counter);
}

/* Offset by half a step, so that neither 0 nor 1 occurs. */
double random_uniform(uint64_t seed, RandomUse use, uint64_t i, uint32_t j)
{
    const RandomWords w = words_of(seed, use, i, j);
    const uint64_t bits = ((uint64_t)w.word[0] << 32 | w.word[1]) >> 12;
    return ((double)bits + 0.5) * 0x1p-52;
}

/* Permutes 0 ... n-1: a Feistel cipher over the least even number of bits that hold n, iterated until it is below n
 * again (J. Black, P. Rogaway, "Ciphers with arbitrary finite domains", 2002). */
uint64_t random_order(uint64_t seed, uint32_t which, uint64_t i, uint64_t n)
{
    enum { FEISTEL = 6 };
    int half = 1;
    assert(i < n && n < (uint64_t)1 << 62);
    while ((uint64_t)1 << (2 * half) < n) half++;
    const uint64_t mask = ((uint64_t)1 << half) - 1;
    do {
        uint64_t left = i >> half, right = i & mask;
        for (uint32_t r = 0; r < FEISTEL; r++) {
            const RandomWords w = words_of(seed, RANDOM_ORDER, right, which * FEISTEL + r);
            const uint64_t next = left ^ (w.word[0] & mask);
            left = right;
            right = next;
        }
        i = left << half | right;
    } while (i >= n);
    return i;
}

/* Owen's scrambling (PO4): each digit is flipped by a random bit that depends on the digits before it and on their
 * number, since 0 and 00 are different beginnings. */
static uint32_t scramble(uint64_t seed, uint32_t digits, int j)
{
    uint32_t out = 0;
    for (int k = 0; k < 32; k++) {
        const uint32_t before = k ? digits >> (32 - k) : 0;
        const RandomWords w = words_of(seed, RANDOM_SCRAMBLE, (uint64_t)k << 32 | before, (uint32_t)j);
        out = out << 1 | ((digits >> (31 - k) ^ w.word[0]) & 1);
    }
    return out;
}

double points_at(PointKind kind, uint64_t seed, uint64_t i, uint64_t n, int j)
{
    const uint32_t axis = (uint32_t)j;
    assert(kind != POINTS_SOBOL || j < SOBOL_DIMENSIONS);
    if (kind == POINTS_RANDOM) return random_uniform(seed, RANDOM_POINT, i, axis);
    double u;
    if (kind == POINTS_LATIN) {
        u = ((double)random_order(seed, axis, i, n) + random_uniform(seed, RANDOM_PLACE, i, axis)) / (double)n;
    } else {
        assert(i >> 32 == 0);
        const uint32_t digits = scramble(seed, sobol_digits((uint32_t)i, j), j);
        u = ((double)digits + random_uniform(seed, RANDOM_TAIL, digits, axis)) * 0x1p-32;
    }
    return u < 1 ? u : 1 - 0x1p-53; /* rounding */
}

/* ------------------------------------------------------------------------------------------------------- Morris */

/* Coordinate of trajectory t that changes in step k, 0 <= k < d. */
static int morris_axis(uint64_t seed, uint64_t t, int d, int k)
{
    return (int)random_order(seed ^ (t + 1) * 0x9E3779B97F4A7C15u, (uint32_t)(1 << 20), (uint64_t)k, (uint64_t)d);
}

/* Step of half the levels, so that all levels occur equally often (Morris' choice). */
static const double MORRIS_STEP = MORRIS_LEVELS / 2 / (MORRIS_LEVELS - 1.0);

/* Direction +1 or -1 of coordinate j of trajectory t; *from: its start, on the grid (SE1). */
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

/* Complete blocks: y of A and B and each of the d others, and the selection of a resample. */
typedef struct Blocks {
    int d, n;
    const double **row; /* [n] of d+2 values */
    int *take;          /* [n] */
} Blocks;

/* Computes the variance over A and B together, then (SE4) and (SE5) for parameter j, from the selected blocks. */
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

/* Computes percentiles of many resamples of the blocks, with replacement. */
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

/* Finds the complete blocks. */
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

/* Sobol's sequence. The first dimension is van der Corput's; the others use primitive polynomials and initial
 * direction numbers of S. Joe and F. Y. Kuo, "Constructing Sobol sequences with better two-dimensional projections",
 * SIAM J. Sci. Comput. 30 (2008) 2635-2654: the first 64 dimensions of their file new-joe-kuo-6.21201
 * (web.maths.unsw.edu.au/~fkuo/sobol; copyright and licence: NOTICE). */

enum { DEGREE_MAX = 9 };

/* A dimension: the polynomial x^degree + a_1 x^(degree-1) + ... + 1, its inner coefficients as the bits of a, a_1
 * first; m[degree] are odd and below 2, 4, 8 ... */
typedef struct Direction {
    uint32_t degree, a, m[DEGREE_MAX];
} Direction;

/* clang-format off */
static const Direction direction[SOBOL_DIMENSIONS - 1] = { /* dimensions 2 to 64 */
    {1, 0, {1}},
    {2, 1, {1, 3}},
    {3, 1, {1, 3, 1}},
    {3, 2, {1, 1, 1}},
    {4, 1, {1, 1, 3, 3}},
    {4, 4, {1, 3, 5, 13}},
    {5, 2, {1, 1, 5, 5, 17}},
    {5, 4, {1, 1, 5, 5, 5}},
    {5, 7, {1, 1, 7, 11, 19}},
    {5, 11, {1, 1, 5, 1, 1}},
    {5, 13, {1, 1, 1, 3, 11}},
    {5, 14, {1, 3, 5, 5, 31}},
    {6, 1, {1, 3, 3, 9, 7, 49}},
    {6, 13, {1, 1, 1, 15, 21, 21}},
    {6, 16, {1, 3, 1, 13, 27, 49}},
    {6, 19, {1, 1, 1, 15, 7, 5}},
    {6, 22, {1, 3, 1, 15, 13, 25}},
    {6, 25, {1, 1, 5, 5, 19, 61}},
    {7, 1, {1, 3, 7, 11, 23, 15, 103}},
    {7, 4, {1, 3, 7, 13, 13, 15, 69}},
    {7, 7, {1, 1, 3, 13, 7, 35, 63}},
    {7, 8, {1, 3, 5, 9, 1, 25, 53}},
    {7, 14, {1, 3, 1, 13, 9, 35, 107}},
    {7, 19, {1, 3, 1, 5, 27, 61, 31}},
    {7, 21, {1, 1, 5, 11, 19, 41, 61}},
    {7, 28, {1, 3, 5, 3, 3, 13, 69}},
    {7, 31, {1, 1, 7, 13, 1, 19, 1}},
    {7, 32, {1, 3, 7, 5, 13, 19, 59}},
    {7, 37, {1, 1, 3, 9, 25, 29, 41}},
    {7, 41, {1, 3, 5, 13, 23, 1, 55}},
    {7, 42, {1, 3, 7, 3, 13, 59, 17}},
    {7, 50, {1, 3, 1, 3, 5, 53, 69}},
    {7, 55, {1, 1, 5, 5, 23, 33, 13}},
    {7, 56, {1, 1, 7, 7, 1, 61, 123}},
    {7, 59, {1, 1, 7, 9, 13, 61, 49}},
    {7, 62, {1, 3, 3, 5, 3, 55, 33}},
    {8, 14, {1, 3, 1, 15, 31, 13, 49, 245}},
    {8, 21, {1, 3, 5, 15, 31, 59, 63, 97}},
    {8, 22, {1, 3, 1, 11, 11, 11, 77, 249}},
    {8, 38, {1, 3, 1, 11, 27, 43, 71, 9}},
    {8, 47, {1, 1, 7, 15, 21, 11, 81, 45}},
    {8, 49, {1, 3, 7, 3, 25, 31, 65, 79}},
    {8, 50, {1, 3, 1, 1, 19, 11, 3, 205}},
    {8, 52, {1, 1, 5, 9, 19, 21, 29, 157}},
    {8, 56, {1, 3, 7, 11, 1, 33, 89, 185}},
    {8, 67, {1, 3, 3, 3, 15, 9, 79, 71}},
    {8, 70, {1, 3, 7, 11, 15, 39, 119, 27}},
    {8, 84, {1, 1, 3, 1, 11, 31, 97, 225}},
    {8, 97, {1, 1, 1, 3, 23, 43, 57, 177}},
    {8, 103, {1, 3, 7, 7, 17, 17, 37, 71}},
    {8, 115, {1, 3, 1, 5, 27, 63, 123, 213}},
    {8, 122, {1, 1, 3, 5, 11, 43, 53, 133}},
    {9, 8, {1, 3, 5, 5, 29, 17, 47, 173, 479}},
    {9, 13, {1, 3, 3, 11, 3, 1, 109, 9, 69}},
    {9, 16, {1, 1, 1, 5, 17, 39, 23, 5, 343}},
    {9, 22, {1, 3, 1, 5, 25, 15, 31, 103, 499}},
    {9, 25, {1, 1, 1, 11, 11, 17, 63, 105, 183}},
    {9, 44, {1, 1, 5, 11, 9, 29, 97, 231, 363}},
    {9, 47, {1, 1, 5, 15, 19, 45, 41, 7, 383}},
    {9, 52, {1, 3, 7, 7, 31, 19, 83, 137, 221}},
    {9, 55, {1, 1, 1, 3, 23, 15, 111, 223, 83}},
    {9, 59, {1, 1, 5, 13, 31, 15, 55, 25, 161}},
    {9, 62, {1, 1, 3, 13, 25, 47, 39, 87, 257}}
};

/* clang-format on */

/* Computes v_k as 32 binary digits, k from 1: m_k / 2^k, later ones by (PO3). */
static void direction_numbers(const Direction *d, uint32_t v[33])
{
    const int s = (int)d->degree;
    for (int k = 1; k <= 32; k++) {
        if (k <= s) {
            v[k] = d->m[k - 1] << (32 - k);
            continue;
        }
        v[k] = v[k - s] ^ (v[k - s] >> s);
        for (int i = 1; i < s; i++) {
            if (d->a >> (s - 1 - i) & 1) v[k] ^= v[k - i];
        }
    }
}

uint32_t sobol_digits(uint32_t i, int j)
{
    uint32_t v[33] = {0}, x = 0;
    assert(j >= 0 && j < SOBOL_DIMENSIONS);
    if (j > 0) direction_numbers(&direction[j - 1], v);
    for (int k = 1; i; k++, i >>= 1) {
        if (i & 1) x ^= j > 0 ? v[k] : (uint32_t)1 << (32 - k);
    }
    return x;
}

/* Share of a search's points for the evolution; the rest is for neighbours of the best point. */
static const double EVOLVED = 0.6;

/* Shares of the box's sides: the first steps from a start, and from the best point of an evolution. */
static const double FIRST_STEP = 0.2, LATER_STEP = 0.05;

/* Calls of NLopt per new point: with whole numbers most points are known. */
enum { CALLS = 50, RANDOM_MIN = 20, RANDOM_A_SIDE = 8, RANDOM_SIDES_MAX = 12, BROKEN_ALL = 1 };

/* State of a search: all points so far, in a hash table by their bits. */
typedef struct Search {
    const SearchBox *box;
    const SearchPlan *plan;
    SearchTry try;
    void *user;
    nlopt_opt running; /* to be stopped; NULL: none */
    int over;          /* no more points */
    int failed;        /* no memory */
    long n, bound;     /* number of points; bound of this stage */
    long room;         /* of `place`, a power of 2 */
    long *place;       /* [room] number of a point, -1: none */
    double *x;         /* [evaluations * box->n] */
    double *value;     /* [evaluations] */
    double *broken;    /* [evaluations * constraints] */
    double *sum;       /* [evaluations] by (SR1) */
    long best;         /* -1: none */
    double worst;      /* largest value so far */
    double scale;      /* size of the first value: NLopt works with values divided by it */
    int *side;         /* [sides] of the box, those that NLopt varies */
    int sides;
    double *at; /* [box->n] a point; sides that NLopt does not vary stay unchanged */
} Search;

double search_broken(double value, const double *broken, int n)
{
    double sum = 0;
    if (isnan(value)) return INFINITY;
    for (int k = 0; k < n; k++) sum += broken[k] > 0 ? broken[k] : 0;
    return sum;
}

int search_better(double value, double broken, double than_value, double than_broken)
{
    if (broken != than_broken) return broken < than_broken;
    return value < than_value;
}

double search_points(const SearchBox *box)
{
    double n = 1;
    for (int j = 0; j < box->n; j++) {
        if (!box->whole[j] && box->from[j] < box->to[j]) return 0;
        n *= box->to[j] - box->from[j] + 1;
    }
    return n <= 1e9 ? n : 0;
}

SearchMethod search_method(const SearchBox *box, long evaluations)
{
    const double points = search_points(box);
    if (points > 0 && points <= (double)evaluations) return SEARCH_ALL;
    for (int j = 0; j < box->n; j++) {
        if (box->whole[j] && box->from[j] < box->to[j]) return SEARCH_RANDOM;
    }
    return SEARCH_LINEAR;
}

const char *search_version(char text[32])
{
    int a, b, c;
    nlopt_version(&a, &b, &c);
    snprintf(text, 32, "NLopt %d.%d.%d", a, b, c);
    return text;
}

/* ---------------------------------------------------------------------------------------------------------- points */

/* Place of the point in the table, used or free. */
static long *place_of(const Search *s, const double *x)
{
    const size_t size = (size_t)s->box->n * sizeof *x;
    uint64_t h = 14695981039346656037u; /* FNV-1a */
    for (size_t i = 0; i < size; i++) h = (h ^ ((const unsigned char *)x)[i]) * 1099511628211u;
    long k = (long)((h ^ h >> 32) & (uint64_t)(s->room - 1));
    while (s->place[k] >= 0 && memcmp(s->x + s->place[k] * s->box->n, x, size) != 0) k = (k + 1) & (s->room - 1);
    return &s->place[k];
}

/* Number of the point at x[n], which is evaluated if it is new; -1: no more points are allowed. */
static long point_at(Search *s, const double *x)
{
    const int n = s->box->n, m = s->plan->constraints;
    long *const place = place_of(s, x);
    if (*place >= 0) return *place;
    if (s->over || s->n >= s->bound) {
        s->over |= s->n >= s->plan->evaluations;
        return -1;
    }
    const long i = s->n;
    memcpy(s->x + i * n, x, (size_t)n * sizeof *x);
    for (int k = 0; k < m; k++) s->broken[i * m + k] = 0;
    if (!s->try(s->user, x, &s->value[i], s->broken + i * m)) {
        s->over = 1;
        return -1;
    }
    *place = s->n++;
    s->sum[i] = search_broken(s->value[i], s->broken + i * m, m);
    if (s->best < 0 || search_better(s->value[i], s->sum[i], s->value[s->best], s->sum[s->best])) s->best = i;
    if (isnan(s->value[i])) return i;
    if (isnan(s->worst)) s->scale = s->value[i] != 0 ? fabs(s->value[i]) : 1;
    s->worst = isnan(s->worst) ? s->value[i] : fmax(s->worst, s->value[i]);
    return i;
}

/* ----------------------------------------------------------------------------------------------------------- NLopt */

/* Evaluates coordinates u of the unit cube as the point s->at; each whole number has an equal share of the side. */
static long point_of_unit(Search *s, const double *u)
{
    const SearchBox *const b = s->box;
    for (int k = 0; k < s->sides; k++) {
        const int j = s->side[k];
        const double width = b->to[j] - b->from[j];
        s->at[j] = b->whole[j] ? fmin(b->from[j] + floor(u[k] * (width + 1)), b->to[j])
                               : fmin(fmax(b->from[j] + u[k] * width, b->from[j]), b->to[j]);
    }
    const long i = point_at(s, s->at);
    if (i < 0) nlopt_force_stop(s->running);
    return i;
}

/* Value for NLopt. A point without a value counts as the worst, with all constraints broken. */
static double value_of_unit(unsigned n, const double *u, double *gradient, void *user)
{
    Search *const s = user;
    const long i = point_of_unit(s, u);
    (void)n, (void)gradient;
    const double value = i < 0 || isnan(s->value[i]) ? s->worst : s->value[i];
    return isnan(value) ? 0 : value / s->scale;
}

static void broken_of_unit(unsigned m, double *broken, unsigned n, const double *u, double *gradient, void *user)
{
    Search *const s = user;
    const long i = point_of_unit(s, u);
    (void)n, (void)gradient;
    for (unsigned k = 0; k < m; k++) broken[k] = i < 0 || isnan(s->value[i]) ? BROKEN_ALL : s->broken[i * (long)m + k];
}

/* Runs an algorithm over the sides s->side from s->at. However it ends, its points are in the table. */
static void stage_run(Search *s, nlopt_algorithm algorithm, double step, unsigned population)
{
    double u[256], tolerance[256] = {0};
    const SearchBox *const b = s->box;
    s->running = nlopt_create(algorithm, (unsigned)s->sides);
    s->failed |= !s->running;
    if (!s->running) return;
    for (int k = 0; k < s->sides; k++) {
        const int j = s->side[k];
        const double width = b->to[j] - b->from[j];
        u[k] = b->whole[j] ? (s->at[j] - b->from[j] + 0.5) / (width + 1) : (s->at[j] - b->from[j]) / width;
    }
    nlopt_set_lower_bounds1(s->running, 0);
    nlopt_set_upper_bounds1(s->running, 1);
    nlopt_set_min_objective(s->running, value_of_unit, s);
    if (s->plan->constraints > 0)
        nlopt_add_inequality_mconstraint(s->running, (unsigned)s->plan->constraints, broken_of_unit, s, tolerance);
    nlopt_set_xtol_abs1(s->running, s->plan->tolerance);
    if (step > 0) nlopt_set_initial_step1(s->running, step);
    if (population) nlopt_set_population(s->running, population);
    const double calls = (double)CALLS * (double)s->plan->evaluations;
    nlopt_set_maxeval(s->running, calls < 1e9 ? (int)calls : 1000000000);
    double least;
    if (nlopt_optimize(s->running, u, &least) == NLOPT_OUT_OF_MEMORY) s->failed = 1;
    nlopt_destroy(s->running);
    s->running = NULL;
}

/* Selects the continuous sides, or all that can vary. */
static void sides_find(Search *s, int with_whole)
{
    s->sides = 0;
    for (int j = 0; j < s->box->n; j++) {
        if (s->box->from[j] < s->box->to[j] && (with_whole || !s->box->whole[j])) s->side[s->sides++] = j;
    }
}

/* ------------------------------------------------------------------------------------------------------- neighbours */

/* Evaluates the best point with some whole numbers changed; returns whether it is better. */
static int neighbour_is_better(Search *s, int j, double by, int other, double other_by)
{
    const SearchBox *const b = s->box;
    const long before = s->best;
    memcpy(s->at, s->x + before * b->n, (size_t)b->n * sizeof *s->at);
    s->at[j] += by;
    if (other >= 0) s->at[other] += other_by;
    if (s->at[j] < b->from[j] || s->at[j] > b->to[j]) return 0;
    if (other >= 0 && (s->at[other] < b->from[other] || s->at[other] > b->to[other])) return 0;
    return point_at(s, s->at) >= 0 && s->best != before;
}

/* Changes one whole number by 1 or 2 in either direction, then one up and another down; takes the first that is better.
 */
static int neighbours_step(Search *s)
{
    static const double moves[] = {-1, 1, -2, 2};
    const SearchBox *const b = s->box;
    for (int j = 0; j < b->n; j++) {
        for (int k = 0; k < 4 && b->whole[j]; k++) {
            if (neighbour_is_better(s, j, moves[k], -1, 0)) return 1;
        }
    }
    for (int j = 0; j < b->n; j++) {
        for (int i = 0; i < b->n; i++) {
            if (i != j && b->whole[i] && b->whole[j] && neighbour_is_better(s, j, 1, i, -1)) return 1;
        }
    }
    return 0;
}

/* Improves the best point alternately by whole neighbours and by linear models of its continuous numbers, until neither
 * finds a better one. */
static void neighbours_search(Search *s)
{
    s->bound = s->plan->evaluations;
    for (int better = 1; better && s->best >= 0 && !s->over && !s->failed;) {
        better = 0;
        while (!s->over && neighbours_step(s)) better = 1;
        const long before = s->best;
        sides_find(s, 0);
        memcpy(s->at, s->x + before * s->box->n, (size_t)s->box->n * sizeof *s->at);
        if (s->sides > 0 && !s->over) stage_run(s, NLOPT_LN_COBYLA, LATER_STEP, 0);
        better |= s->best != before;
    }
}

/* ---------------------------------------------------------------------------------------------------------- methods */

/* Finds the start of a search: the first begins at the user's point, others at Sobol points. */
static void start_find(Search *s)
{
    const SearchBox *const b = s->box;
    memcpy(s->at, b->start, (size_t)b->n * sizeof *s->at);
    for (int j = 0; j < b->n && s->plan->number > 0; j++) {
        const double u = points_at(POINTS_SOBOL, s->plan->seed, (uint64_t)s->plan->number, 0, j % SOBOL_DIMENSIONS),
                     width = b->to[j] - b->from[j];
        s->at[j] = b->from[j] + (b->whole[j] ? floor(u * (width + 1)) : u * width);
    }
}

static void linear_search(Search *s)
{
    sides_find(s, 0);
    if (point_at(s, s->at) >= 0 && s->sides > 0) stage_run(s, NLOPT_LN_COBYLA, FIRST_STEP, 0);
}

static void random_search(Search *s)
{
    sides_find(s, 1);
    const int sides = s->sides < RANDOM_SIDES_MAX ? s->sides : RANDOM_SIDES_MAX;
    s->bound = (long)ceil(EVOLVED * (double)s->plan->evaluations);
    nlopt_srand((unsigned long)(s->plan->seed * 1000003 + (uint64_t)s->plan->number));
    if (point_at(s, s->at) < 0) return;
    if (s->sides > 0) stage_run(s, NLOPT_GN_ISRES, 0, (unsigned)(RANDOM_MIN + RANDOM_A_SIDE * sides));
    neighbours_search(s);
}

/* Evaluates every point of this search, the numbers congruent to its own modulo the number of searches; the last side
 * changes fastest. */
static void all_search(Search *s)
{
    const SearchBox *const b = s->box;
    const double points = search_points(b);
    for (double i = s->plan->number; i < points; i += s->plan->of) {
        double rest = i;
        for (int j = b->n - 1; j >= 0; j--) {
            const double values = b->to[j] - b->from[j] + 1;
            s->at[j] = b->from[j] + fmod(rest, values);
            rest = floor(rest / values);
        }
        if (point_at(s, s->at) < 0) return;
    }
}

int search_run(const SearchBox *box, const SearchPlan *plan, SearchTry try, void *user)
{
    const size_t most = (size_t)plan->evaluations, n = (size_t)box->n, m = (size_t)plan->constraints;
    Search s = {.box = box,
                .plan = plan,
                .try = try,
                .user = user,
                .bound = plan->evaluations,
                .room = 16,
                .best = -1,
                .worst = NAN,
                .scale = 1};
    while (s.room < 2 * plan->evaluations) s.room *= 2;
    s.place = malloc((size_t)s.room * sizeof *s.place);
    s.side = malloc((n + 1) * sizeof *s.side);
    s.x = malloc((most * (n + m + 2) + n + 1) * sizeof *s.x);
    int ok = s.place && s.side && s.x;
    if (ok) {
        s.value = s.x + most * n;
        s.sum = s.value + most;
        s.broken = s.sum + most;
        s.at = s.broken + most * m;
        for (long k = 0; k < s.room; k++) s.place[k] = -1;
        start_find(&s);
        if (plan->method == SEARCH_LINEAR) linear_search(&s);
        if (plan->method == SEARCH_RANDOM) random_search(&s);
        if (plan->method == SEARCH_ALL) all_search(&s);
        ok = !s.failed;
    }
    free(s.place);
    free(s.side);
    free(s.x);
    return ok;
}

/* Damping of the first step, and of the last attempt. */
static const double DAMPING = 1e-3, DAMPING_MAX = 1e8;

/* State of a fit over the unit cube u = (x - from)/(to - from). */
typedef struct Fit {
    const FitPlan *plan;
    FitTry try;
    void *user;
    int evaluations, over, failed; /* over: no more evaluations; failed: required residuals are missing */
    double u[FIT_MAX], cost;
    double *r, *other, *J; /* [m], [m], [n][m] columns */
    int free[FIT_MAX], n_free;
    double s[FIT_MAX], V[FIT_MAX][FIT_MAX]; /* of J over the free parameters: J V = U S, U in J's place */
} Fit;

double student_95(double v)
{
    /* the series below is inaccurate for these */
    static const double few[] = {12.706204736, 4.302652730, 3.182446305, 2.776445105, 2.570581836};
    const double z = 1.959963984540054, z3 = z * z * z, z5 = z3 * z * z, z7 = z5 * z * z;
    if (v < 5) {
        const int k = v < 2 ? 0 : (int)v - 1;
        return few[k] + (few[k + 1] - few[k]) * (fmax(v, 1) - 1 - k);
    }
    return z + (z3 + z) / (4 * v) + (5 * z5 + 16 * z3 + 3 * z) / (96 * v * v) +
           (3 * z7 + 19 * z5 + 17 * z3 - 15 * z) / (384 * v * v * v);
}

/* Computes residuals at u; returns their sum of squares, INFINITY if there are none. */
static double cost_at(Fit *f, const double *u, double *r)
{
    const FitPlan *const p = f->plan;
    double x[FIT_MAX], sum = 0;
    for (int j = 0; j < p->n; j++) x[j] = p->from[j] + u[j] * (p->to[j] - p->from[j]);
    if (f->over || f->evaluations == p->evaluations) {
        f->over = 1;
        return INFINITY;
    }
    f->evaluations++;
    const int known = f->try(f->user, x, r);
    f->over |= known < 0;
    for (int i = 0; i < p->m && known > 0; i++) sum += r[i] * r[i];
    return known > 0 && isfinite(sum) ? sum : INFINITY;
}

/* Computes J by central differences, at a bound by one-sided ones. Returns 0 if that fails. */
static int jacobian(Fit *f)
{
    const int n = f->plan->n, m = f->plan->m;
    double u[FIT_MAX];
    for (int j = 0; j < n; j++) {
        double *const column = f->J + (size_t)j * (size_t)m;
        const double up = fmin(f->u[j] + f->plan->difference, 1), down = fmax(f->u[j] - f->plan->difference, 0);
        memcpy(u, f->u, sizeof u);
        u[j] = up;
        const double above = up > f->u[j] ? cost_at(f, u, column) : f->cost;
        if (!(up > f->u[j])) memcpy(column, f->r, (size_t)m * sizeof *column);
        u[j] = down;
        const double below = down < f->u[j] ? cost_at(f, u, f->other) : f->cost;
        if (!isfinite(above) || !isfinite(below)) return 0;
        const double *const low = down < f->u[j] ? f->other : f->r;
        for (int i = 0; i < m; i++) column[i] = (column[i] - low[i]) / (up - down);
    }
    return 1;
}

/* Finds the free parameters: those not at a bound beyond which the cost falls. */
static void free_find(Fit *f)
{
    const int m = f->plan->m;
    f->n_free = 0;
    for (int j = 0; j < f->plan->n; j++) {
        double slope = 0;
        for (int i = 0; i < m; i++) slope += f->J[(size_t)j * (size_t)m + (size_t)i] * f->r[i];
        const int held = (f->u[j] <= 0 && slope > 0) || (f->u[j] >= 1 && slope < 0);
        if (!held) f->free[f->n_free++] = j;
    }
}

static double dot(int m, const double *a, const double *b)
{
    double sum = 0;
    for (int i = 0; i < m; i++) sum += a[i] * b[i];
    return sum;
}

/* Rotates pairs of columns until they are orthogonal (one-sided Jacobi): J becomes U S, V collects the rotations. */
static void columns_turn(Fit *f)
{
    const int n = f->n_free, m = f->plan->m;
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < n; b++) f->V[a][b] = a == b;
    }
    for (int sweep = 0, turned = 1; turned && sweep < 60; sweep++) {
        turned = 0;
        for (int a = 0; a < n; a++) {
            for (int b = a + 1; b < n; b++) {
                double *const p = f->J + (size_t)f->free[a] * (size_t)m, *const q =
                                                                             f->J + (size_t)f->free[b] * (size_t)m;
                const double pp = dot(m, p, p), qq = dot(m, q, q), pq = dot(m, p, q);
                if (fabs(pq) <= 1e-15 * sqrt(pp * qq) || pq == 0) continue;
                const double zeta = (qq - pp) / (2 * pq), t = copysign(1, zeta) / (fabs(zeta) + hypot(1, zeta)),
                             c = 1 / hypot(1, t), s = c * t;
                turned = 1;
                for (int i = 0; i < m; i++) {
                    const double x = p[i], y = q[i];
                    p[i] = c * x - s * y;
                    q[i] = s * x + c * y;
                }
                for (int i = 0; i < n; i++) {
                    const double x = f->V[i][a], y = f->V[i][b];
                    f->V[i][a] = c * x - s * y;
                    f->V[i][b] = s * x + c * y;
                }
            }
        }
    }
    for (int a = 0; a < n; a++) {
        const double *const p = f->J + (size_t)f->free[a] * (size_t)m;
        f->s[a] = sqrt(dot(m, p, p));
    }
}

/* Computes the step with that damping (LS1), limited by the bounds. Returns its largest component. */
static double step_make(const Fit *f, double damping, double *u)
{
    const int m = f->plan->m;
    double size = 0, most = 0;
    for (int a = 0; a < f->n_free; a++) most = fmax(most, f->s[a]);
    memcpy(u, f->u, FIT_MAX * sizeof *u);
    for (int a = 0; a < f->n_free; a++) {
        /* J's column is U S */
        const double along = dot(m, f->J + (size_t)f->free[a] * (size_t)m, f->r);
        const double by = f->s[a] * f->s[a] + damping * most * most;
        for (int b = 0; b < f->n_free && by > 0; b++) u[f->free[b]] -= f->V[b][a] * along / by;
    }
    for (int j = 0; j < f->plan->n; j++) {
        u[j] = fmin(fmax(u[j], 0), 1);
        size = fmax(size, fabs(u[j] - f->u[j]));
    }
    return size;
}

/* Takes steps until none is better, or they are small. */
static int descend(Fit *f)
{
    double u[FIT_MAX], damping = DAMPING;
    f->cost = cost_at(f, f->u, f->r);
    while (isfinite(f->cost) && !f->over) {
        int better = 0;
        if (!jacobian(f)) return 0;
        free_find(f);
        columns_turn(f);
        while (!better && damping < DAMPING_MAX && !f->over) {
            const double size = step_make(f, damping, u);
            if (size < f->plan->small) return 1;
            const double cost = cost_at(f, u, f->other);
            better = cost < f->cost;
            damping = better ? damping * 0.2 : damping * 5;
            if (!better) continue;
            const double fall = f->cost - cost;
            memcpy(f->u, u, sizeof u);
            memcpy(f->r, f->other, (size_t)f->plan->m * sizeof *f->r);
            f->cost = cost;
            if (fall < 1e-12 * cost) return 1;
        }
        if (!better) return !f->over;
    }
    return 0;
}

/* Computes the correlation of adjacent residuals, and the number of independent ones (LS3). */
static void lag_find(const Fit *f, FitResult *x)
{
    const int m = f->plan->m;
    const double *const r = f->r;
    double next = 0;
    for (int i = 0; i + 1 < m; i++) next += r[i] * r[i + 1];
    x->lag = f->cost > 0 ? next / f->cost : 0;
    const double lag = x->lag > 2 / sqrt(m) ? fmin(x->lag, 0.98) : 0;
    x->effective = m * (1 - lag) / (1 + lag);
}

/* Computes intervals and correlations from the singular values at the end (LS2), (LS4). */
static void intervals_find(Fit *f, FitResult *x)
{
    const int n = f->n_free;
    double C[FIT_MAX][FIT_MAX] = {{0}}, most = 0;
    int least = 0;
    const double spare = x->effective - n, variance = f->cost / fmax(x->m - n, 1) * x->m / x->effective;
    for (int a = 0; a < n; a++) {
        most = fmax(most, f->s[a]);
        if (f->s[a] < f->s[least]) least = a;
    }
    x->least_singular = n > 0 && most > 0 ? f->s[least] / most : 0;
    for (int a = 0; a < n; a++) x->weakest[f->free[a]] = f->V[a][least];
    for (int a = 0; a < n; a++) {
        for (int b = 0; b < n; b++) {
            for (int k = 0; k < n; k++) {
                const double share =
                    f->V[a][k] * f->V[b][k]; /* an undetermined direction belongs to its own parameters only */
                if (share != 0) C[a][b] += share / (f->s[k] * f->s[k]);
            }
        }
    }
    for (int a = 0; a < n; a++) {
        const int j = f->free[a];
        const double half = student_95(fmax(spare, 1)) * sqrt(variance * C[a][a]);
        x->half[j] = isfinite(half) ? half * (f->plan->to[j] - f->plan->from[j]) : INFINITY;
        for (int b = 0; b < n; b++) x->correlation[j][f->free[b]] = C[a][b] / sqrt(C[a][a] * C[b][b]);
    }
}

int fit_run(const FitPlan *plan, FitTry try, void *user, FitResult *x)
{
    const size_t m = (size_t)plan->m, n = (size_t)plan->n;
    Fit f = {.plan = plan, .try = try, .user = user};
    *x = (FitResult){.n = plan->n, .m = plan->m, .rms = NAN, .lag = NAN, .effective = NAN};
    f.r = malloc(m * (n + 2) * sizeof *f.r);
    if (!f.r) return 0;
    f.other = f.r + m;
    f.J = f.other + m;
    for (int j = 0; j < plan->n; j++) {
        f.u[j] = (plan->start[j] - plan->from[j]) / (plan->to[j] - plan->from[j]);
        x->half[j] = NAN;
        for (int k = 0; k < plan->n; k++) x->correlation[j][k] = NAN;
    }
    x->done = descend(&f) && jacobian(&f);
    for (int j = 0; j < plan->n; j++) x->x[j] = plan->from[j] + f.u[j] * (plan->to[j] - plan->from[j]);
    x->evaluations = f.evaluations;
    if (isfinite(f.cost)) x->rms = sqrt(f.cost / plan->m);
    if (x->done) {
        free_find(&f);
        columns_turn(&f);
        lag_find(&f, x);
        intervals_find(&f, x);
        for (int j = 0; j < plan->n; j++) {
            int held = 1;
            for (int a = 0; a < f.n_free; a++) held &= f.free[a] != j;
            x->at_bound[j] = held ? f.u[j] <= 0 ? -1 : 1 : 0;
        }
    }
    free(f.r);
    return 1;
}
