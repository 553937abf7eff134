/* Steps by what a pull does: swings bound them by what the method takes of a fall (EB25); ramps and ripples do not. */
#include <math.h>

#include "sim/solve/scales.h"
#include "tests/support/scene.h"

static const double LONGEST = 0.05, USUAL = 1e-3; /* s; accuracy */
static const Scene scene = {.def = {.solver = {.accuracy = 1e-3}, .output = {.interval = 0.05}}};

/* Steps of h for `until` seconds, in which the pull is mean + slope t + top sin(omega t). */
static Swings followed(const Scene *of, double h, double until, double mean, double slope, double top, double omega)
{
    Swings s = {0};
    for (int k = 1; k * h < until; k++) {
        const double t = k * h;
        swings_step(&s, of, t, mean + slope * t + top * sin(omega * t));
    }
    return s;
}

/* A method of second order takes pi x^3/4 of a fall f in steps of x/omega, and f x^3/2 is the third difference: where
 * the steps are short the bound is the h that loses a hundredth of the pull, times 0.9; at finer accuracies less. */
TEST(a_swing_bounds_steps)
{
    const double mean = 1000, top = 200, omega = 40;
    for (double share = 1; share > 0.2; share /= 2) {
        Scene of = scene;
        of.def.solver.accuracy = share * USUAL;
        const Swings s = followed(&of, 12e-3, 2, mean, 0, top, omega);
        const double lost = 0.01 * share * (mean + top), h = cbrt(lost / (M_PI / 4 * 2 * top)) / omega;
        check_share(s.bound, 0.9 * h, 0.08); /* tops lie between steps, of which none is infinitely short */
        check_above(12e-3, s.bound);
    }
}

/* The one-step method keeps a swing: what is missing of its top lies between the steps, 0.6 to 7 % of the fall in ten
 * to three of them, where the loss of a method of second order was allowed for, 2.4 to 90 % (EB35). */
TEST(one_step_misses_what_lies_between)
{
    const double top = 200, omega = 40;
    Scene one = scene;
    one.def.solver.method = METHOD_ESDIRK;
    for (int n = 3; n <= 10; n++) {
        const double h = 1.001 * M_PI / omega / n; /* steps drift through the swing */
        double missed = 0, most = 0;
        for (int k = 1; k * h < 2; k++) {
            most = fmax(most, top * sin(omega * k * h));
            if (cos(omega * k * h) < 0 && cos(omega * (k - 1) * h) >= 0 && most > 0) {
                missed = fmax(missed, top - most);
                most = 0;
            }
        }
        const double allowed = followed(&one, h, 2, 1000, 0, top, omega).fades;
        check_at_least(allowed, 0.9 * missed);
        check_at_most(allowed, followed(&scene, h, 2, 1000, 0, top, omega).fades / 3);
    }
}

/* The scene's own longest step stays where nothing swings, or by less than a hundredth, in however few steps. */
TEST(ramps_and_ripples_bound_nothing)
{
    for (int n = 1; n < 12; n++) {
        const Swings s = followed(&scene, LONGEST, 5, 1000, 0, 4.9, M_PI / (n * LONGEST) + 0.1);
        check_equal(s.bound, 0);
    }
    check_equal(followed(&scene, LONGEST, 5, 10, 500, 0, 1).bound, 0);
    check_equal(followed(&scene, LONGEST, 5, 1000, -100, 0, 1).bound, 0);
}

/* What jumps from step to step shortens them to a sixteenth at most; what has settled lets them be long again. */
TEST(a_bound_has_an_end)
{
    Swings s = {0};
    double t = 0;
    for (int k = 0; k < 50; k++) swings_step(&s, &scene, t += s.bound > 0 ? s.bound : LONGEST, k % 2 ? 500 : 1000);
    check_share(s.bound, LONGEST / 16, 1e-12);
    int steps = 0;
    for (; s.bound > 0; steps++) swings_step(&s, &scene, t += s.bound, 700);
    check_at_most(steps, 100); /* the third derivative fades by 16^3 in 37 of them */
}

/* The last rise: from where it began, and at its steepest; a fall behind it leaves both. */
TEST(what_a_rise_was)
{
    static const double pull[] = {10, 8, 9, 15, 17, 16, 12};
    Swings s = {0};
    for (int k = 0; k < 7; k++) swings_step(&s, &scene, 0.1 * k, pull[k]);
    check_close(swings_rise(&s), 17 - 8, 1e-12);
    check_close(s.steepest, 60, 1e-9);
    check_close(s.risen_at, 0.1, 1e-12);
    swings_step(&s, &scene, 0.7, 13);
    check_close(swings_rise(&s), 1, 1e-12);
    check_close(s.steepest, 10, 1e-9);
    check_close(s.risen_at, 0.6, 1e-12);
}
