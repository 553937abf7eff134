/* Sobol's indices and Morris' effects of functions of which they are known. */
#include "study/maths.h"

#include <stdlib.h>

#include "tests/support/check.h"

typedef double (*Function)(const double *u);

/* T. Ishigami, T. Homma (1990), a = 7, b = 0.1, on (-pi, pi)^3. */
static double ishigami(const double *u)
{
    const double x = (2 * u[0] - 1) * M_PI, y = (2 * u[1] - 1) * M_PI, z = (2 * u[2] - 1) * M_PI;
    return sin(x) + 7 * sin(y) * sin(y) + 0.1 * z * z * z * z * sin(x);
}

/* Sobol's g function: a_j as I. Sobol' and many after him. */
static const double a[6] = {0, 0.5, 3, 9, 99, 99};
static double g_function(const double *u)
{
    double product = 1;
    for (int j = 0; j < 6; j++) product *= (fabs(4 * u[j] - 2) + a[j]) / (1 + a[j]);
    return product;
}

/* y of the whole design. */
static double *answers(uint64_t seed, int d, int n, Function f)
{
    double *const y = malloc((size_t)n * (size_t)(d + 2) * sizeof *y);
    for (int i = 0; i < n * (d + 2); i++) {
        double u[8];
        sobol_design_point(seed, (uint64_t)i, d, u);
        y[i] = f(u);
    }
    return y;
}

/* The truth lies in the interval of at least so many of the indices over all seeds, and the estimates near it. */
static void expect_indices(int d, int n, Function f, const double *first, const double *total, double near)
{
    enum { SEEDS = 8 };
    int inside = 0;
    double worst = 0;
    for (uint64_t seed = 0; seed < SEEDS; seed++) {
        SobolIndex index[8];
        double *const y = answers(seed, d, n, f);
        assert_int_equal(sobol_indices(seed, d, n, y, index), n);
        for (int j = 0; j < d; j++) {
            inside += index[j].first_low <= first[j] && first[j] <= index[j].first_high;
            inside += index[j].total_low <= total[j] && total[j] <= index[j].total_high;
            worst = larger_of(worst, fabs(index[j].first - first[j]));
            worst = larger_of(worst, fabs(index[j].total - total[j]));
        }
        free(y);
    }
    check_at_least(inside, 0.9 * 2 * SEEDS * d);
    check_below(worst, near);
}

TEST(ishigami_indices)
{
    const double p4 = pow(M_PI, 4), D = 49.0 / 8 + 0.1 * p4 / 5 + 0.01 * p4 * p4 / 18 + 0.5;
    const double one = 0.5 * (1 + 0.1 * p4 / 5) * (1 + 0.1 * p4 / 5) / D, both = 0.01 * p4 * p4 * 8 / 225 / D;
    const double first[3] = {one, 49.0 / 8 / D, 0}, total[3] = {one + both, 49.0 / 8 / D, both};
    expect_indices(3, 1024, ishigami, first, total, 0.06);
}

TEST(g_indices)
{
    double part[6], first[6], total[6], all = 1;
    for (int j = 0; j < 6; j++) {
        part[j] = 1 / (3 * (1 + a[j]) * (1 + a[j]));
        all *= 1 + part[j];
    }
    for (int j = 0; j < 6; j++) {
        first[j] = part[j] / (all - 1);
        total[j] = part[j] * all / (1 + part[j]) / (all - 1);
    }
    expect_indices(6, 1024, g_function, first, total, 0.06);
}

/* A block in which a sample failed is left out; the others are judged as before. Without variance there is nothing. */
TEST(gaps)
{
    enum { N = 256 };
    SobolIndex whole[3], with_gaps[3];
    double *const y = answers(1, 3, N, ishigami);
    sobol_indices(1, 3, N, y, whole);
    y[7] = NAN;
    y[8] = NAN; /* of the same block */
    y[5 * 100] = INFINITY;
    assert_int_equal(sobol_indices(1, 3, N, y, with_gaps), N - 2);
    check_close(with_gaps[1].first, whole[1].first, 0.02);
    for (int i = 0; i < 5 * N; i++) y[i] = 4;
    sobol_indices(1, 3, N, y, whole);
    check_nan(whole[0].first);
    check_nan(whole[0].total_high);
    free(y);
}

static double plane(const double *u) { return 3 * u[0] - 2 * u[2] + 0 * u[1]; }
static double product(const double *u) { return u[0] * u[1] + u[2]; }

/* Of a plane every effect is its slope, without spread; a product has both. */
TEST(morris)
{
    enum { D = 3, TRAJECTORIES = 40, N = TRAJECTORIES * (D + 1) };
    double y[2][N];
    MorrisEffect effect[D];
    for (int i = 0; i < N; i++) {
        double u[D], before[D];
        morris_point(9, (uint64_t)i, D, u);
        y[0][i] = plane(u);
        y[1][i] = product(u);
        int changed = 0;
        if (i % (D + 1)) morris_point(9, (uint64_t)i - 1, D, before);
        for (int j = 0; j < D; j++) {
            check_between(u[j], -1e-12, 1 + 1e-12);
            if (i % (D + 1)) changed += fabs(u[j] - before[j]) > 0.5;
        }
        assert_int_equal(changed, i % (D + 1) != 0);
    }
    assert_true(morris_effects(9, D, TRAJECTORIES, y[0], effect));
    const double slope[D] = {3, 0, -2};
    for (int j = 0; j < D; j++) {
        check_close(effect[j].mean, slope[j], 1e-12);
        check_close(effect[j].mean_size, fabs(slope[j]), 1e-12);
        check_below(effect[j].sd, 1e-12);
    }
    y[1][5] = NAN; /* the steps on both sides of it do not count */
    assert_true(morris_effects(9, D, TRAJECTORIES, y[1], effect));
    check_equal((double)(effect[0].n + effect[1].n + effect[2].n), D * TRAJECTORIES - 2);
    check_close(effect[0].mean, 0.5, 3 * 0.33 / sqrt(TRAJECTORIES));
    check_above(effect[0].sd, 0.2);
    check_below(effect[2].sd, 1e-12);
}
