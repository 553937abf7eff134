/* Profiles: values, rates against finite differences, integrals against quadrature, corners. */
#include "core/profile.h"
#include "tests/support/check.h"

#include <math.h>

static double TABLE_T[] = {-1, 0.5, 2, 5}, TABLE_V[] = {3, -1, 4, 2.5};

/* One of each kind, with the ramps placed before, across and after t = 0. */
static const Profile PROFILES[] = {
    {.kind = PROFILE_CONSTANT, .v1 = 4.5},
    {.kind = PROFILE_STEP, .t0 = 0, .v0 = 0, .t1 = 13, .v1 = 0.1},
    {.kind = PROFILE_STEP, .t0 = 1, .v0 = 2, .t1 = 4, .v1 = -3},
    {.kind = PROFILE_STEP, .t0 = -2, .v0 = 2, .t1 = 1, .v1 = 7},
    {.kind = PROFILE_STEP5, .t0 = 1, .v0 = 2, .t1 = 4, .v1 = -3},
    {.kind = PROFILE_STEP5, .t0 = -5, .v0 = 2, .t1 = -1, .v1 = -3},
    {.kind = PROFILE_TABLE, .n = 4, .time = TABLE_T, .value = TABLE_V},
    {.kind = PROFILE_TABLE, .n = 1, .time = TABLE_T, .value = TABLE_V},
};
enum { N_PROFILES = sizeof PROFILES / sizeof *PROFILES };

/* Gauss-Legendre, 5 points: exact up to degree 9, more than any profile between corners. */
static double quadrature(const Profile *p, double a, double b)
{
    static const double x[] = {0, 0.53846931010568309104, 0.90617984593866399280};
    static const double w[] = {0.56888888888888888889, 0.47862867049936646804, 0.23692688505618908751};
    const double m = (a + b) / 2, h = (b - a) / 2;
    double sum = w[0] * profile_value(p, m);
    for (int i = 1; i < 3; i++) sum += w[i] * (profile_value(p, m - h * x[i]) + profile_value(p, m + h * x[i]));
    return sum * h;
}

TEST(step_values)
{
    double slope;
    check_close(step_cubic(0.25, 0, 1, 1, 5, &slope), 1 + 4 * 0.0625 * 2.5, 1e-15);
    check_close(slope, 4 * 6 * 0.25 * 0.75, 1e-15);
    check_close(step_quintic(0.25, 0, 1, 1, 5, &slope), 1 + 4 * (10 / 64.0 - 15 / 256.0 + 6 / 1024.0), 1e-15);
    check_close(slope, 4 * 30 * 0.0625 * 0.5625, 1e-14);
    /* Beyond the ends: the end values exactly, without slope. */
    check_equal(step_cubic(-3, 0, 0.3, 1, 0.7, &slope), 0.3);
    check_equal(slope, 0);
    check_close(step_cubic(9, 0, 0.3, 1, 0.7, &slope), 0.7, 1e-16);
    check_equal(slope, 0);
    /* ADAMS' friction uses STEP through zero: odd, and zero in the middle. */
    check_close(step_cubic(0, -0.005, 0.2, 0.005, -0.2, NULL), 0, 1e-17);
}

TEST(rates_match_differences)
{
    for (int k = 0; k < N_PROFILES; k++) {
        for (double t = -6.03; t < 15; t += 0.17) {
            const double h = 1e-5;
            double corner;
            if (profile_next_corner(&PROFILES[k], t - 2 * h, &corner) && corner < t + 2 * h) continue;
            const double rise = profile_value(&PROFILES[k], t + h) - profile_value(&PROFILES[k], t - h);
            check_close(profile_rate(&PROFILES[k], t), rise / (2 * h), 1e-9);
        }
    }
}

TEST(rate_at_a_corner_is_the_right_one)
{
    const Profile *table = &PROFILES[6];
    check_close(profile_rate(table, 0.5), 5 / 1.5, 1e-14);
    check_close(profile_rate(table, 2), -0.5, 1e-14);
    check_equal(profile_rate(table, 5), 0);
    check_equal(profile_rate(table, -1.5), 0);
}

TEST(integrals_are_exact)
{
    for (int k = 0; k < N_PROFILES; k++) {
        const Profile *p = &PROFILES[k];
        double sum = 0, t = 0, corner;
        check_equal(profile_integral(p, 0), 0);
        while (t < 20) {
            const double next = profile_next_corner(p, t, &corner) ? corner : 20;
            sum += quadrature(p, t, (t + next) / 2) + quadrature(p, (t + next) / 2, next);
            check_close(profile_integral(p, next), sum, 1e-13 * (1 + fabs(sum)));
            t = next;
        }
    }
    /* The paper's ramp to 6 m/min by 13 s: half of it is lost. */
    check_close(profile_integral(&PROFILES[1], 30), 0.1 * (30 - 6.5), 1e-14);
}

TEST(corners_come_in_order)
{
    double corner;
    assert_int_equal(profile_next_corner(&PROFILES[0], 0, &corner), 0);
    assert_int_equal(profile_next_corner(&PROFILES[2], 0, &corner), 1);
    check_equal(corner, 1);
    assert_int_equal(profile_next_corner(&PROFILES[2], 1, &corner), 1);
    check_equal(corner, 4);
    assert_int_equal(profile_next_corner(&PROFILES[2], 4, &corner), 0);
    double t = -9;
    for (int i = 0; i < 4; i++) {
        assert_int_equal(profile_next_corner(&PROFILES[6], t, &corner), 1);
        check_equal(corner, TABLE_T[i]);
        t = corner;
    }
    assert_int_equal(profile_next_corner(&PROFILES[6], t, &corner), 0);
}

TEST(table_is_constant_beyond_its_ends)
{
    check_equal(profile_value(&PROFILES[6], -7), 3);
    check_equal(profile_value(&PROFILES[6], 99), 2.5);
    check_close(profile_value(&PROFILES[6], 1.25), 1.5, 1e-15);
    check_equal(profile_value(&PROFILES[7], -7), 3);
    check_equal(profile_value(&PROFILES[7], 7), 3);
}

/* A table that begins after 0 or before it: its integral counts from 0, whatever lies between; corners come only
 * before the last point. */
TEST(tables_that_begin_elsewhere)
{
    static double time[] = {1, 2, 4, 50}, value[] = {2, 6, 0, 9}; /* the fourth is not the table's */
    const Profile late = {.kind = PROFILE_TABLE, .n = 3, .time = time, .value = value};
    static const struct {
        double t, area, rate;
    } late_at[] = {{-1, -2, 0},   {0, 0, 0},  {0.5, 1, 0},   {1, 2, 4},
                   {1.5, 3.5, 4}, {2, 6, -3}, {3, 10.5, -3}, {4, 12, 0}};
    for (size_t k = 0; k < sizeof late_at / sizeof *late_at; k++) {
        check_close(profile_integral(&late, late_at[k].t), late_at[k].area, 1e-14);
        check_close(profile_rate(&late, late_at[k].t), late_at[k].rate, 1e-14);
    }
    check_close(profile_integral(&late, 9), 12, 1e-14); /* it stays at 0 */
    static double early_time[] = {-3, -1, 2}, early_value[] = {1, 3, 0};
    const Profile early = {.kind = PROFILE_TABLE, .n = 3, .time = early_time, .value = early_value};
    check_close(profile_integral(&early, 0), 0, 1e-15);
    check_close(profile_integral(&early, 2), 2.0 * 2 / 2, 1e-14);
    check_close(profile_integral(&early, -1), -2.5, 1e-14);
    check_close(profile_integral(&early, -3), -2.5 - 4, 1e-14);
    check_close(profile_integral(&early, -5), -2.5 - 4 - 2, 1e-14);
    check_equal(profile_largest(&late), 6);
    check_equal(profile_least_risen(&late), 0);
    check_equal(profile_largest(&early), 3);
    const Profile rises = {.kind = PROFILE_TABLE, .n = 2, .time = time, .value = value};
    check_equal(profile_least_risen(&rises), 6);
    const Profile ramp = {.kind = PROFILE_STEP, .v0 = 7, .t1 = 1, .v1 = 2};
    check_equal(profile_largest(&ramp), 7);
    check_equal(profile_least_risen(&ramp), 2);
    check_equal(profile_corner_before(&late, 0, 7), 1);
    check_equal(profile_corner_before(&late, 1, 1.5), 1.5);
    check_equal(profile_corner_before(&late, 2, 7), 4);
    check_equal(profile_corner_before(&late, 4, 99), 99);
    check_equal(profile_corner_before(&late, 2, 4), 4);
}
