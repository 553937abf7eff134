/* What a cable that is pushed presses on its duct with: the law's regimes, its slope, and one push along a duct. */
#include "tests/support/check.h"
#include "theory/plan.h"
#include "theory/pulling.h"

static const double W = 200, EI = 1000, ROOM = 0.03, MU = 0.2;

static SpanLaw duct(void)
{
    return (SpanLaw){.law = PULL_REFERENCE,
                     .direction = 1,
                     .weight = W,
                     .mu = MU,
                     .room = ROOM,
                     .ei = EI,
                     .line = {.tz = 0, .nz = 1}};
}

/* Straight, snaking, on its way to the helix, a helix. */
TEST(regimes)
{
    const SpanLaw p = duct();
    const double snakes = 2 * sqrt(EI * W / ROOM);
    for (double share = -2; share <= 1; share += 0.25) check_equal(span_normal(&p, 0, -share * snakes), W);
    check_share(span_normal(&p, 0, -sqrt(1.5) * snakes), W * (1 + 0.18 * 0.5 + 0.1 * 0.25), 1e-12);
    /* at sqrt 2 by the energy's least: A = 0.7925, N = J0 + f^2 A^2/(8 + 6 A^2) = 1.276 */
    check_share(span_normal(&p, 0, -sqrt(2) * snakes), W * 1.276, 0.005);
    for (double share = 1.83; share < 5; share += 0.5)
        check_share(span_normal(&p, 0, -share * snakes), ROOM * share * share * snakes * snakes / (4 * EI), 1e-12);
    const double jump = 1e-9;
    for (int k = 0; k < 3; ++k) {
        const double at = (const double[]){1, sqrt(2), 2 * sqrt(2) - 1}[k] * snakes;
        check_share(span_normal(&p, 0, -at * (1 + jump)), span_normal(&p, 0, -at * (1 - jump)), 1e-7);
    }
}

/* The slope by tension and by weight against differences, on a straight and in a level bend. */
TEST(slopes)
{
    for (int bend = 0; bend < 2; ++bend) {
        SpanLaw p = duct();
        if (bend) p.line = (SpanLine){.curvature = 0.02, .turning = 0.02, .bz = 1};
        for (double T = -20e3; T < 0; T += 777) {
            SpanLaw more = p, less = p;
            const double h = 1e-3, dw = 1e-4;
            more.weight += dw, less.weight -= dw;
            const SpanSlopes by = span_slopes(&p, 0, T);
            check_close(by.by_tension, (span_normal(&p, 0, T + h) - span_normal(&p, 0, T - h)) / (2 * h), 1e-6);
            check_close(by.by_weight, (span_normal(&more, 0, T) - span_normal(&less, 0, T)) / (2 * dw), 1e-6);
        }
    }
}

/* In a bend without weight snaking begins at 4 EI/(r R), (BK4): curvature raises the load. */
TEST(in_a_bend)
{
    const double R = 40, begins = 4 * EI / (ROOM * R);
    SpanLaw p = duct();
    p.weight = 0;
    p.line = (SpanLine){.curvature = 1 / R, .turning = 1 / R, .bz = 1};
    check_share(span_normal(&p, 0, -0.999 * begins), 0.999 * begins / R, 1e-12);
    assert_true(span_normal(&p, 0, -1.01 * begins) > 1.01 * begins / R * (1 + 1e-4));
}

/* From a push of ten times the load of snaking, the length to where nothing is left: (BK9) less what the infinite push
 * has before that, 4 EI/(mu r F). */
TEST(locks_up)
{
    const SpanLaw p = duct();
    const double snakes = 2 * sqrt(EI * W / ROOM), begins = 1000 * snakes;
    double low = 0, high = 1000;
    for (int k = 0; k < 50; ++k) {
        const double middle = (low + high) / 2;
        *(span_integrate(&p, 0, -begins, middle, NULL) < 0 ? &low : &high) = middle;
    }
    check_share(low + 4 * EI / (MU * ROOM * begins), 4.26 / MU * sqrt(EI / (W * ROOM)), 2e-3);
}
