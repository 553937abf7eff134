/* Curves of bending: the series of two unlike halves, its sliders, and that these follow the two halves through any
 * history in one plane. */
#include <math.h>

#include "sim/joints.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"

static const CableDef SHEATHED = {.ei_y = 12e3,
                                  .ei_z = 12e3,
                                  .bending = {.rows = 3, .curvature = {0.03, 0.1, 0.5}, .moment = {360, 570, 890}}},
                      SOFT = {.ei_y = 5e3,
                              .ei_z = 5e3,
                              .bending = {.rows = 3, .curvature = {0.1, 0.2, 0.3}, .moment = {500, 700, 700}}},
                      ELASTIC = {.ei_y = 400, .ei_z = 900};

/* A curve as springs with sliders in one plane. */
typedef struct Springs {
    int n;
    double elastic, stiffness[SLIDERS_MAX], limit[SLIDERS_MAX], slip[SLIDERS_MAX];
} Springs;

static Springs springs_of(const LoadingCurve *curve)
{
    Springs s = {.n = curve->corners};
    s.elastic = loading_curve_sliders(curve, s.stiffness, s.limit);
    return s;
}

static double moment_of(const Springs *s, double theta)
{
    double moment = s->elastic * theta;
    for (int k = 0; k < s->n; ++k)
        moment += s->stiffness[k] * fmax(-s->limit[k], fmin(s->limit[k], theta - s->slip[k]));
    return moment;
}

static void slip_to(Springs *s, double theta)
{
    for (int k = 0; k < s->n; ++k) {
        const double spring = fmax(-s->limit[k], fmin(s->limit[k], theta - s->slip[k]));
        s->slip[k] = theta - spring;
    }
}

/* The rotation of the first half at which both have the same moment, theta together. */
static double shared(const Springs *a, const Springs *b, double theta)
{
    double low = -1, high = 1;
    for (int k = 0; k < 200; ++k) {
        const double middle = (low + high) / 2;
        if (moment_of(a, middle) > moment_of(b, theta - middle)) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return (low + high) / 2;
}

/* Two halves of one cable: its table; corners at its curvatures times the length of both. */
TEST(test_one_cable)
{
    const LoadingCurve a = loading_curve_of(&SHEATHED, 0.2), b = loading_curve_of(&SHEATHED, 0.3);
    const LoadingCurve joint = loading_curve_series(&a, &b);
    const Springs s = springs_of(&joint);
    assert_int_equal(s.n, 2);
    check_share(s.limit[0], 0.03 * 0.5, 1e-14);
    check_share(s.limit[1], 0.1 * 0.5, 1e-14);
    const double expected[] = {360, 570, 890}, curvature[] = {0.03, 0.1, 0.5};
    for (int k = 0; k < 3; ++k) check_share(moment_of(&s, curvature[k] * 0.5), expected[k], 1e-13);
    check_share(moment_of(&s, 0.5), 890 + 0.5 * 800, 1e-13); /* the last piece goes on */
}

/* A level piece ends the joint's curve; an elastic cable has none. */
TEST(test_ends)
{
    const LoadingCurve soft = loading_curve_of(&SOFT, 0.25), elastic = loading_curve_of(&ELASTIC, 0.25);
    const LoadingCurve joint = loading_curve_series(&soft, &elastic);
    const Springs s = springs_of(&joint), rope = springs_of(&elastic);
    assert_int_equal(rope.n, 0);
    check_share(rope.elastic, 600 / 0.25, 1e-14);
    assert_int_equal(s.n, 2);
    check_at_most(s.elastic, 0);
    check_at_least(s.elastic, 0);
    check_share(moment_of(&s, 5), 700, 1e-13);
    check_share(moment_of(&s, -5), -700, 1e-13);
    const LoadingCurve sheathed = loading_curve_of(&SHEATHED, 0.25), mixed = loading_curve_series(&sheathed, &soft);
    assert_int_equal(mixed.corners, 4); /* 360, 500, 570, 700 N m */
    check_infinite(mixed.compliance[4]);
}

/* The sliders of a joint of two unlike halves against the halves themselves, bent to and fro at random (HY2). */
TEST(test_history_of_unlike_halves)
{
    const CableDef *const other[] = {&ELASTIC, &SHEATHED};
    for (int o = 0; o < 2; ++o) {
        CableDef soft = SOFT;
        soft.bending.moment[2] = 750; /* so that the rotation of each half is defined */
        const LoadingCurve a = loading_curve_of(&soft, 0.25), b = loading_curve_of(other[o], 0.15);
        const LoadingCurve joint = loading_curve_series(&a, &b);
        Springs whole = springs_of(&joint), one = springs_of(&a), two = springs_of(&b);
        uint64_t seed = 5;
        double theta = 0, largest = 0;
        for (int k = 0; k < 2000; ++k) {
            theta = 0.97 * theta + 0.05 * fixture_random(&seed);
            const double first = shared(&one, &two, theta), moment = moment_of(&one, first);
            check_close(moment_of(&whole, theta), moment, 1e-13 * 700);
            largest = larger_of(largest, fabs(moment));
            slip_to(&one, first);
            slip_to(&two, theta - first);
            slip_to(&whole, theta);
        }
        check_above(largest, 360);
    }
}
