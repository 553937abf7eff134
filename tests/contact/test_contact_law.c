/* The force laws against the formulas of references.md, their limits and their derivatives. */

#include <math.h>

#include "contact/law.h"
#include "core/profile.h"
#include "tests/support/check.h"

static const ImpactLaw impact = {.k = 3e6, .e = 1.5, .c = 5e3, .d = 1e-3};
static const FrictionLaw friction = {.mu_s = 0.25, .mu_d = 0.1, .v_s = 0.005, .v_d = 0.02};

static double impact_value(const ImpactLaw *law, double gap, double rate)
{
    double a, b;
    return impact_force(law, gap, rate, &a, &b);
}

static double mu_value(double v)
{
    double slope;
    return friction_over_speed(&friction, v, &slope) * v;
}

/* IMPACT(x, x', 0, k, e, c, d) written as in the reference, STEP over the gap. */
static double impact_reference(const ImpactLaw *law, double x, double rate)
{
    if (x >= 0) return 0;
    const double damping = step_cubic(x, -law->d, law->c, 0, 0, NULL);
    return fmax(0, law->k * pow(-x, law->e) - damping * rate);
}

TEST(test_impact_is_the_reference)
{
    const double exponents[] = {1, 1.5, 2, 2.2};
    for (int i = 0; i < 4; ++i) {
        ImpactLaw law = impact;
        law.e = exponents[i];
        for (double gap = -3e-3; gap < 1e-3; gap += 1.7e-4) {
            for (double rate = -0.5; rate <= 0.5; rate += 0.25) {
                const double expected = impact_reference(&law, gap, rate);
                check_close(impact_value(&law, gap, rate), expected, 1e-14 * (1 + expected));
            }
        }
    }
}

TEST(test_impact_never_pulls)
{
    double d_gap, d_rate;
    check_equal(impact_force(&impact, 0, -1, &d_gap, &d_rate), 0);
    check_equal(impact_force(&impact, 1e-9, -100, &d_gap, &d_rate), 0);
    check_equal(d_gap, 0);
    check_equal(d_rate, 0);
    check_equal(impact_force(&impact, -1e-3, 1e6, &d_gap, &d_rate), 0);
    check_equal(d_gap, 0);
    check_equal(d_rate, 0);
    /* however fast the bodies meet, the force begins from zero */
    check_below(impact_value(&impact, -1e-9, -1), 1e-6);
}

TEST(test_impact_derivatives)
{
    const double gaps[] = {-2e-4, -7e-4, -1.6e-3}, rates[] = {-0.2, 0.05, 0};
    const double step = 1e-8;
    for (int i = 0; i < 9; ++i) {
        const double gap = gaps[i / 3], rate = rates[i % 3];
        double d_gap, d_rate;
        if (impact_force(&impact, gap, rate, &d_gap, &d_rate) <= 0) continue;
        const double by_gap =
            (impact_value(&impact, gap + step, rate) - impact_value(&impact, gap - step, rate)) / (2 * step);
        const double by_rate =
            (impact_value(&impact, gap, rate + 1e-4) - impact_value(&impact, gap, rate - 1e-4)) / 2e-4;
        check_share(by_gap, d_gap, 5e-9);
        check_close(by_rate, d_rate, 1e-12 * fabs(d_rate) + 1e-12);
    }
}

/* A law without damping depth is damped fully from the first touch. */
TEST(test_impact_without_depth)
{
    ImpactLaw law = impact;
    law.d = 0;
    double d_gap, d_rate;
    const double force = impact_force(&law, -1e-4, -0.1, &d_gap, &d_rate);
    check_close(force, law.k * 1e-6 + 0.1 * law.c, 1e-9);
    check_equal(d_rate, -law.c);
}

TEST(test_friction_is_the_reference)
{
    for (double v = 1e-5; v < 0.03; v += 1.3e-4) {
        double expected = friction.mu_d;
        if (v < friction.v_s) {
            expected = step_cubic(v, -friction.v_s, -friction.mu_s, friction.v_s, friction.mu_s, NULL);
        } else if (v < friction.v_d) {
            expected = step_cubic(v, friction.v_s, friction.mu_s, friction.v_d, friction.mu_d, NULL);
        }
        check_close(mu_value(v), expected, 1e-15);
    }
    check_equal(mu_value(0), 0);
    check_close(mu_value(friction.v_s), friction.mu_s, 1e-15);
    check_close(mu_value(friction.v_d), friction.mu_d, 1e-15);
    check_close(mu_value(100), friction.mu_d, 1e-15);
}

TEST(test_friction_derivative)
{
    const double speeds[] = {1e-4, 3e-3, 6e-3, 0.015, 0.5};
    for (int i = 0; i < 5; ++i) {
        const double v = speeds[i], step = 1e-5 * v;
        double slope, unused;
        friction_over_speed(&friction, v, &slope);
        const double difference =
            (friction_over_speed(&friction, v + step, &unused) - friction_over_speed(&friction, v - step, &unused)) /
            (2 * step);
        check_share(difference / v, slope, 1e-7);
    }
    /* at rest: viscous, finite slope over speed */
    double slope;
    check_close(friction_over_speed(&friction, 0, &slope), 1.5 * friction.mu_s / friction.v_s, 1e-12);
    check_finite(slope);
}

/* (K6): all coefficients by one factor; a law with friction keeps its kind however small the factor is, one without
 * stays without. */
TEST(test_friction_scaled)
{
    static const double factors[] = {0, 1e-9, 0.5, 1, 3};
    for (int k = 0; k < 5; ++k) {
        for (int sticks = 0; sticks < 2; ++sticks) {
            FrictionLaw law = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2, .d_s = sticks ? 1e-3 : 0};
            const FrictionLaw scaled = friction_scaled(law, factors[k]);
            check_equal(scaled.mu_s, factors[k] > 0 ? factors[k] * 0.3 : FRICTION_HARDLY_ANY);
            check_equal(scaled.mu_d, factors[k] > 0 ? factors[k] * 0.2 : FRICTION_HARDLY_ANY);
            assert_int_equal(friction_kind(&scaled), sticks ? FRICTION_STICK : FRICTION_SPEED);
            check_equal(scaled.v_d, 2e-2);
            law.mu_d = 0;
            check_equal(friction_scaled(law, factors[k]).mu_d, 0);
            law.mu_s = 0;
            assert_int_equal(friction_kind(&law), FRICTION_NONE);
            const FrictionLaw none = friction_scaled(law, factors[k]);
            assert_int_equal(friction_kind(&none), FRICTION_NONE);
        }
    }
}

/* (PS12): a contact that has sunk in too deep carries a load on a soft spring. Each step solves the spring with the
 * contact's line; returns how many until the law itself balances. about: the line is about the presumed force, else a
 * tangent at the gap, Newton's method. */
static int steps_to_rest(double load, double depth, int about)
{
    static const Presume line = {.from = PRESUME_LINE, .gravity = 9.8};
    const double spring = 1e4, rest = load / spring; /* N/m; m: where it would be without the contact */
    double gap = -depth, presumed = fmin(load, impact_value(&impact, gap, 0));
    for (int step = 1; step < 50; ++step) {
        const double at = about ? pow(presumed / impact.k, 1 / impact.e) : -gap;
        const double force = impact_value(&impact, -at, 0), stiffness = impact.e * force / at;
        gap = -(load + stiffness * at - force) / (spring + stiffness);
        presumed = presume_force(&line, &impact, presumed, gap, load / 9.8);
        if (fabs(impact_value(&impact, gap, 0) - spring * (rest + gap)) < 1e-9 * load) return step;
    }
    return 50;
}

TEST(test_presumed_forces_settle)
{
    for (double load = 1; load < 1e3; load *= 10) {
        const int line = steps_to_rest(load, 4e-3, 1), tangent = steps_to_rest(load, 4e-3, 0);
        print_message("%g N: %d steps, %d by tangents at the gap\n", load, line, tangent);
        check_at_most(line, 3);
        check_at_least(tangent, line + 2); /* the depth falls by three in each */
    }
}

/* (PS12), (PS13) case by case. */
TEST(test_presumed_forces)
{
    const Presume gaps = {.from = PRESUME_GAPS}, last = {.from = PRESUME_LAST, .gravity = 10},
                  line = {.from = PRESUME_LINE, .gravity = 10, .keep = 0.1};
    const double deep = impact_value(&impact, -1e-3, 0), depth = pow(50 / impact.k, 1 / impact.e);
    check_share(presume_force(&gaps, &impact, 7, -1e-3, 2), deep, 1e-14);
    check_equal(presume_force(&gaps, &impact, 7, 1e-9, 2), 0);
    check_equal(presume_force(&last, &impact, 50, 1e-3, 2), 50); /* it pressed there */
    check_equal(presume_force(&last, &impact, 50, 0.1, 2), 0);   /* another one */
    check_equal(presume_force(&last, &impact, 0, -1e-3, 2), 20); /* its weight at most */
    check_equal(presume_force(&last, &impact, 0, -1e-3, 0), 1);  /* without weight */
    check_share(presume_force(&line, &impact, 50, -depth, 2), 50, 1e-14);
    check_share(presume_force(&line, &impact, 50, -depth * 4 / 3, 2), 75, 1e-12); /* 1.5 of a third more */
    check_share(presume_force(&line, &impact, 50, depth, 2), 5, 1e-14);           /* let go, but kept for once */
    check_equal(presume_force(&line, &impact, 0, depth, 2), 0);
    check_equal(presume_force(&line, &impact, 0, -1e-3, 2), 20);
}
