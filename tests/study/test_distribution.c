/* Quantiles against the distributions that they invert, moments of samples, and the copula's correlations. */
#include "study/maths.h"

#include "tests/support/check.h"

/* The quantile inverts the share to rounding, in both tails and far out. Values to 16 digits: M. J. Wichura's AS 241
 * gives the first two as its checks. */
TEST(normal)
{
    check_close(normal_quantile(0.25), -0.6744897501960817, 1e-15);
    check_close(normal_quantile(1e-3), -3.090232306167814, 1e-14);
    check_share(normal_quantile(1e-20), -9.262340089798408, 1e-14);
    check_close(normal_quantile(0.5), 0, 1e-16);
    double worst = 0;
    for (double p = 1e-300; p < 0.5; p *= 1.7) {
        worst = larger_of(worst, fabs(normal_share(normal_quantile(p)) / p - 1));
        if (p > 1e-10) worst = larger_of(worst, fabs(normal_quantile(1 - p) / normal_quantile(p) + 1) * 1e-7);
    }
    check_below(worst, 2e-12); /* at 1e-300, where a rounding of z is 1400 roundings of p */
}

/* The share below distribution_quantile(u) is u, by each law's own formula. */
TEST(laws)
{
    const Distribution uniform = {.kind = LAW_UNIFORM, .a = 2, .b = 6};
    const Distribution triangle = {.kind = LAW_TRIANGULAR, .a = 1, .b = 5, .c = 2};
    const Distribution lognormal = {.kind = LAW_LOGNORMAL, .a = 3, .b = 1.5, .low = -INFINITY, .high = INFINITY};
    const Distribution cut = {.kind = LAW_NORMAL, .a = 10, .b = 2, .low = 9, .high = 15};
    const Distribution tail = {.kind = LAW_NORMAL, .a = 0, .b = 1, .low = 9, .high = 10};
    const double below = normal_share(-0.5), inside = normal_share(2.5) - below;
    for (double u = 0.001; u < 1; u += 0.037) {
        check_close((distribution_quantile(&uniform, u) - 2) / 4, u, 1e-15);
        const double x = distribution_quantile(&triangle, u);
        check_close(x < 2 ? (x - 1) * (x - 1) / (4 * 1) : 1 - (5 - x) * (5 - x) / (4 * 3), u, 1e-14);
        check_close(normal_share(log(distribution_quantile(&lognormal, u) / 3) / log(1.5)), u, 1e-14);
        check_close((normal_share((distribution_quantile(&cut, u) - 10) / 2) - below) / inside, u, 1e-14);
        const double z = distribution_quantile(&tail, u); /* shares of 1e-19: from above */
        check_close((normal_share(-9) - normal_share(-z)) / (normal_share(-9) - normal_share(-10)), u, 1e-12);
    }
    check_equal(distribution_quantile(&triangle, 0.25), 2);
    check_close(distribution_quantile(&lognormal, 0.5), 3, 1e-14);
}

TEST(choices)
{
    const double weight[] = {1, 0, 2, 1};
    const Distribution d = {.kind = LAW_DISCRETE, .n = 4, .weight = weight};
    int seen[4] = {0};
    for (int i = 0; i < 400; i++) seen[(int)distribution_quantile(&d, (i + 0.5) / 400)]++;
    assert_true(seen[0] == 100 && seen[1] == 0 && seen[2] == 200 && seen[3] == 100);
}

/* Normal scores have the correlations that were asked for, ranks those that follow, 6/pi asin(r/2); margins stay
 * uniform. */
TEST(copula)
{
    enum { N = 1 << 14 };
    const double r[9] = {1, 0.8, -0.3, 0.8, 1, 0.1, -0.3, 0.1, 1};
    double l[9], scores[9] = {0}, ranks[9] = {0}, mean[3] = {0};
    assert_int_equal(correlation_factor(3, r, l), -1);
    for (uint64_t i = 0; i < N; i++) {
        double u[3], z[3];
        for (int j = 0; j < 3; j++) u[j] = points_at(POINTS_SOBOL, 1, i, N, j);
        correlation_apply(3, l, u, z);
        for (int j = 0; j < 9; j++) {
            scores[j] += normal_quantile(u[j / 3]) * normal_quantile(u[j % 3]) / N;
            ranks[j] += 12 * (u[j / 3] - 0.5) * (u[j % 3] - 0.5) / N;
        }
        for (int j = 0; j < 3; j++) mean[j] += u[j] / N;
    }
    for (int j = 0; j < 9; j++) {
        check_close(scores[j], r[j], 2e-3);
        check_close(ranks[j], 6 / M_PI * asin(r[j] / 2), 2e-3);
        check_close(mean[j / 3], 0.5, 1e-4);
    }
    const double impossible[9] = {1, 0.9, -0.9, 0.9, 1, 0.9, -0.9, 0.9, 1};
    assert_int_equal(correlation_factor(3, impossible, l), 2);
}

/* Wilson's interval: figures of R. G. Newcombe, "Two-sided confidence intervals for the single proportion", Statist.
 * Med. 17 (1998), table I: 81 of 263, 15 of 148, 0 of 20, 1 of 29. */
TEST(shares)
{
    const long row[4][2] = {{81, 263}, {15, 148}, {0, 20}, {1, 29}};
    const double expected[4][2] = {{0.2553, 0.3662}, {0.0624, 0.1605}, {0, 0.1611}, {0.0061, 0.1718}};
    for (int k = 0; k < 4; k++) {
        const Share s = share_of(row[k][0], row[k][1]);
        check_close(s.low, expected[k][0], 5e-5);
        check_close(s.high, expected[k][1], 5e-5);
    }
    check_nan(share_of(0, 0).high);
    check_equal(share_of(7, 7).high, 1);
}

/* Of 1000 studies with 100 samples each as many contain the truth as the binomial distribution says of this interval:
 * 97.2 %, within three standard deviations. */
TEST(coverage)
{
    int inside = 0;
    for (uint64_t study = 0; study < 1000; study++) {
        long hits = 0;
        for (uint64_t i = 0; i < 100; i++) hits += points_at(POINTS_RANDOM, study, i, 0, 0) < 0.07;
        const Share s = share_of(hits, 100);
        inside += s.low <= 0.07 && 0.07 <= s.high;
    }
    check_close(inside, 972, 16);
}

TEST(spreads)
{
    double x[7] = {4, NAN, 1, 3, INFINITY, 2, 5};
    const Spread s = spread_of(7, x);
    check_equal(s.n, 5);
    check_equal(s.mean, 3);
    check_close(s.sd, sqrt(2.5), 1e-15);
    assert_int_equal(sort_finite(7, x), 5);
    check_close(quantile_of_sorted(5, x, 0.1), 1.4, 1e-15);
    check_equal(quantile_of_sorted(5, x, 0.5), 3);
    check_equal(quantile_of_sorted(5, x, 1), 5);
    check_nan(quantile_of_sorted(0, x, 0.5));
    check_nan(spread_of(1, x).sd);
}
