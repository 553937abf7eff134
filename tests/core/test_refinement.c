/* What is said of an error by two and three values of a known law. */
#include "io/api/api_certify.h"
#include "tests/support/check.h"

/* A figure whose error is c h^p; h falls by `ratio` from value to value. */
static double figure(double c, double p, double ratio, int level) { return 7 + c * pow(ratio, -p * level); }

/* Where the order is the one that is assumed, the error is exact, of two values and of three. */
TEST(order_as_assumed)
{
    const double ratios[] = {2, 10}, orders[] = {0.5, 1, 2};
    for (int a = 0; a < 2; ++a) {
        for (int b = 0; b < 3; ++b) {
            const double r = ratios[a], p = orders[b], x = figure(0.3, p, r, 0), y = figure(0.3, p, r, 1),
                         z = figure(0.3, p, r, 2);
            check_share(refinement_of(NAN, y, z, r, p).error, 0.3 * pow(r, -p), 1e-12);
            const Refinement three = refinement_of(x, y, z, r, p);
            check_share(three.error, 0.3 * pow(r, -p), 1e-12);
            check_close(three.order, p, 1e-12);
            assert_int_equal(three.diverges, 0);
        }
    }
}

/* A higher order than was assumed makes the estimate too large, never too small; a lower one is used. */
TEST(other_orders)
{
    const Refinement fast = refinement_of(figure(-0.3, 2, 2, 0), figure(-0.3, 2, 2, 1), figure(-0.3, 2, 2, 2), 2, 1);
    check_close(fast.order, 2, 1e-12);
    /* the coarser difference, 3/4 of 0.3, falls by 2^1.5 at most */
    check_share(fast.error, 2 * 0.75 * 0.3 / pow(2, 1.5), 1e-12);
    check_at_least(fast.error, 0.3 / 4);
    const Refinement slow = refinement_of(figure(0.3, 0.5, 2, 0), figure(0.3, 0.5, 2, 1), figure(0.3, 0.5, 2, 2), 2, 1);
    check_close(slow.order, 0.5, 1e-12);
    check_share(slow.error, 0.3 * sqrt(0.5), 1e-12);
    assert_int_equal(slow.diverges, 0);
}

/* Values that jump about: the larger difference counts, and it is said. */
TEST(no_order)
{
    const Refinement jumps = refinement_of(1.0, 1.1, 1.0, 2, 1), drifts = refinement_of(1.0, 1.1, 1.3, 2, 1);
    assert_int_equal(jumps.diverges, 1);
    assert_int_equal(drifts.diverges, 1);
    check_nan(jumps.order);
    check_close(drifts.order, -1, 1e-12);
    check_share(jumps.error, 0.2, 1e-12);
    check_share(drifts.error, 0.4, 1e-12);
    /* from two sides, but nearer */
    const Refinement swings = refinement_of(1.4, 1.0, 1.1, 2, 1);
    assert_int_equal(swings.diverges, 0);
    check_nan(swings.order);
    check_share(swings.error, 2 * 0.4 / pow(2, 1.5), 1e-12);
}

/* Of a coarser value alone: too large by what half an order is less, never too small for a whole one. */
TEST(from_coarser)
{
    const double error = 0.3 / 2;
    for (int p = 1; p <= 2; ++p) {
        const double e = refinement_from_coarser(figure(0.3, p, 2, 0), figure(0.3, p, 2, 1), 2, 1).error;
        check_at_least(e, error / p);
        check_share(e, 0.3 * (1 - pow(2, -p)) / (sqrt(2) - 1), 1e-12);
    }
    check_share(refinement_from_coarser(figure(0.3, 0.5, 2, 0), figure(0.3, 0.5, 2, 1), 2, 1).error, 0.3 / sqrt(2),
                1e-12);
    check_nan(refinement_from_coarser(NAN, 1, 2, 1).error);
    check_nan(refinement_from_coarser(1, 1, 2, 1).order);
}

/* Nothing changed: no error. What is not known stays so. */
TEST(ends)
{
    const Refinement same = refinement_of(1, 1, 1, 2, 1);
    check_equal(same.error, 0);
    assert_int_equal(same.diverges, 0);
    /* two values that agree by luck, where the one before did not */
    check_share(refinement_of(2, 1, 1, 2, 1).error, 2 / pow(2, 1.5), 1e-12);
    check_nan(refinement_of(1, NAN, 1, 2, 1).error);
    check_nan(refinement_of(1, 1, NAN, 2, 1).error);
    check_nan(refinement_of(NAN, 1, NAN, 2, 1).error);
}
