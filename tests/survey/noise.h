/* Lines that are known, as points with noise: what a surveyor has of them. */
#ifndef HAWSER_TESTS_SURVEY_NOISE_H
#define HAWSER_TESTS_SURVEY_NOISE_H

#include <math.h>

#include "tests/survey/survey_fixture.h"

/* Numbers that look random, evenly between 0 and 1. */
static __attribute__((unused)) double chance(unsigned long long *state)
{
    *state ^= *state << 13;
    *state ^= *state >> 7;
    *state ^= *state << 17;
    return (double)(*state >> 11) / 9007199254740992.0;
}

static __attribute__((unused)) double normal(unsigned long long *state)
{
    const double u = chance(state), v = chance(state);
    return sqrt(-2 * log(u + 1e-300)) * cos(2 * acos(-1) * v);
}

/* Points every `step` m along a line, each coordinate off by `sigma`. */
static __attribute__((unused)) Alignment sampled(const Alignment *a, double step, double sigma)
{
    unsigned long long state = 88172645463325252ULL;
    Alignment p = {.stated_length = NAN};
    const double length = alignment_measure(a).plan_length;
    const int n = (int)ceil(length / step);
    for (int i = 0; i <= n; ++i) {
        const Vec3 at = alignment_at(a, fmin(i * step, length)).at;
        Vec3 *const to = alignment_add_point(&p);
        assert_non_null(to);
        *to = v3_add(at, v3_scale(sigma, v3(normal(&state), normal(&state), normal(&state))));
    }
    return p;
}

/* Straights of 15 to 60 m with bends of 5 to 50 m between them that turn by 0.3 to 1.5 rad, some of which are too short
 * to be seen well; at least as long as `length`. */
static __attribute__((unused)) Alignment rough_route(unsigned long long seed, double length)
{
    unsigned long long state = 88172645463325252ULL + 7919 * seed;
    Alignment a = {.stated_length = NAN};
    double s = 0;
    for (int i = 0; i < 20; ++i) chance(&state);
    while (s < length) {
        const double straight = 15 + 45 * chance(&state), R = 5 + 45 * chance(&state);
        const double turn = 0.3 + 1.2 * chance(&state), k = (chance(&state) < 0.5 ? -1 : 1) / R;
        add(&a, straight, 0, 0);
        add(&a, R * turn, k, k);
        s += straight + R * turn;
    }
    alignment_chain(&a);
    return a;
}

#endif
