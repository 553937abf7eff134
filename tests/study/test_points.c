/* The generators: known answers, strata, and how fast the mean of a smooth function is found. */
#include "study/maths.h"

#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

/* The known answers that Random123 is distributed with (kat_vectors, philox4x32 10). */
TEST(known_words)
{
    const uint32_t counter[3][4] = {
        {0, 0, 0, 0}, {~0u, ~0u, ~0u, ~0u}, {0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}};
    const uint64_t key[3] = {0, ~(uint64_t)0, 0x299f31d0a4093822u};
    const uint32_t expected[3][4] = {{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8},
                                     {0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd},
                                     {0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}};
    for (int k = 0; k < 3; k++) {
        const RandomWords w = random_words(key[k], counter[k]);
        assert_memory_equal(w.word, expected[k], sizeof w.word);
    }
}

/* A permutation of any length, another for another seed. */
TEST(orders)
{
    enum { MOST = 1000 };
    for (uint64_t n = 1; n <= MOST; n = 2 * n + 1) {
        int seen[2 * MOST] = {0}, moved = 0;
        for (uint64_t i = 0; i < n; i++) {
            const uint64_t at = random_order(7, 0, i, n);
            assert_true(at < n);
            seen[at]++;
            moved += at != random_order(8, 0, i, n);
        }
        for (uint64_t i = 0; i < n; i++) assert_int_equal(seen[i], 1);
        if (n > 100) check_above(moved, 0.9 * (double)n);
    }
}

/* Every layer of every axis of a hypercube holds one point, whatever the number of points. */
TEST(latin_layers)
{
    enum { N = 77 };
    for (int j = 0; j < 5; j++) {
        int seen[N] = {0};
        for (uint64_t i = 0; i < N; i++) seen[(int)(points_at(POINTS_LATIN, 3, i, N, j) * N)]++;
        for (int k = 0; k < N; k++) assert_int_equal(seen[k], 1);
    }
}

/* The sequence before it is scrambled: the first points of the first dimensions, by hand from the direction numbers (1,
 * 3 of x+1 and so on), in the order of the numbers, not of Gray's code. */
TEST(plain_sobol)
{
    const double expected[8][3] = {{0, 0, 0},
                                   {0.5, 0.5, 0.5},
                                   {0.25, 0.75, 0.75},
                                   {0.75, 0.25, 0.25},
                                   {0.125, 0.625, 0.375},
                                   {0.625, 0.125, 0.875},
                                   {0.375, 0.375, 0.625},
                                   {0.875, 0.875, 0.125}};
    for (uint32_t i = 0; i < 8; i++) {
        for (int j = 0; j < 3; j++) check_equal(sobol_digits(i, j) * 0x1p-32, expected[i][j]);
    }
}

/* Every dimension by itself has one point in every one of 2^m intervals, before and after scrambling, and the first two
 * together one in every box of that volume (a (0, m, 2)-net): what the scrambling must keep. */
TEST(sobol_strata)
{
    enum { M = 10, N = 1 << M };
    for (int j = 0; j < SOBOL_DIMENSIONS; j++) {
        int plain[N] = {0}, scrambled[N] = {0};
        for (uint64_t i = 0; i < N; i++) {
            plain[sobol_digits((uint32_t)i, j) >> (32 - M)]++;
            scrambled[(int)(points_at(POINTS_SOBOL, 11, i, 0, j) * N)]++;
        }
        for (int k = 0; k < N; k++) assert_true(plain[k] == 1 && scrambled[k] == 1);
    }
    for (int wide = 0; wide <= M; wide++) {
        int seen[N] = {0};
        for (uint64_t i = 0; i < N; i++) {
            const int x = (int)(points_at(POINTS_SOBOL, 5, i, 0, 0) * (1 << wide));
            const int y = (int)(points_at(POINTS_SOBOL, 5, i, 0, 1) * (1 << (M - wide)));
            seen[x << (M - wide) | y]++;
        }
        for (int k = 0; k < N; k++) assert_int_equal(seen[k], 1);
    }
}

/* A smooth function of three coordinates with mean 1, not a sum of functions of one. */
static double smooth(const double *u)
{
    double product = 1;
    for (int j = 0; j < 3; j++) product *= 1 + (u[j] - 0.5) / (j + 1);
    return product;
}

/* A sum of functions of one coordinate each, with mean 1. */
static double additive(const double *u) { return u[0] * u[0] + u[1] + u[2] * u[2] * u[2] + 1 - 1.0 / 3 - 0.5 - 0.25; }

/* Root of the mean square error of the mean of n points, over seeds. */
static double error_of(PointKind kind, double (*f)(const double *), uint64_t n)
{
    enum { SEEDS = 40 };
    double squares = 0;
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        double sum = 0;
        for (uint64_t i = 0; i < n; i++) {
            double u[3];
            for (int j = 0; j < 3; j++) u[j] = points_at(kind, seed, i, n, j);
            sum += f(u);
        }
        squares += (sum / (double)n - 1) * (sum / (double)n - 1);
    }
    return sqrt(squares / SEEDS);
}

/* Orders of convergence: 1/2 at random; 3/2 of a hypercube for sums, where it leaves nothing but the layers' insides
 * (McKay, Beckman, Conover 1979); nearly 3/2 of scrambled nets for anything smooth (Owen 1997). Two powers of 16 apart.
 */
TEST(convergence)
{
    const struct {
        PointKind kind;
        double (*f)(const double *);
        double least, most;
    } row[] = {{POINTS_RANDOM, smooth, 0.35, 0.65},
               {POINTS_LATIN, smooth, 0.35, 0.65},
               {POINTS_LATIN, additive, 1.35, 1.65},
               {POINTS_SOBOL, smooth, 1.2, 1.65},
               {POINTS_SOBOL, additive, 1.35, 1.65}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const double order = log(error_of(row[k].kind, row[k].f, 32) / error_of(row[k].kind, row[k].f, 512)) / log(16);
        check_between(order, row[k].least, row[k].most);
    }
    /* and at one size: the hypercube is better than chance even where its order is not */
    check_below(error_of(POINTS_LATIN, smooth, 256), 0.5 * error_of(POINTS_RANDOM, smooth, 256));
    check_below(error_of(POINTS_SOBOL, smooth, 256), 0.1 * error_of(POINTS_LATIN, smooth, 256));
}

/* Strictly inside, other for another seed, the same again. */
TEST(pure)
{
    for (int kind = POINTS_RANDOM; kind <= POINTS_SOBOL; kind++) {
        for (uint64_t i = 0; i < 200; i++) {
            const double u = points_at((PointKind)kind, 1, i, 200, 4);
            check_between(u, 0, 1);
            check_equal(points_at((PointKind)kind, 1, i, 200, 4), u);
            check_differs(points_at((PointKind)kind, 2, i, 200, 4), u);
        }
    }
}
