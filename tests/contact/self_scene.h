/* Chains that touch themselves, for the tests of cable on cable: laid along a curve, or as two straight strands. */
#ifndef TESTS_CONTACT_SELF_SCENE_H
#define TESTS_CONTACT_SELF_SCENE_H

#include "tests/contact/contact_scene.h"

#include <math.h>

#include "contact/self/self_contact.h"

static const double SELF_RADIUS = 0.04; /* m, of the cable */

typedef struct SelfScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    SelfPairs pairs;
    SelfModel model;
} SelfScene;

static inline void self_new(SelfScene *s, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n) && kinematics_alloc(&s->kin, n) && loads_alloc(&s->loads, n));
    assert_true(self_pairs_alloc(&s->pairs, n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = SELF_RADIUS;
    }
    const ImpactLaw impact = {.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    const FrictionLaw friction = {.mu_s = 0.3, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    s->model = (SelfModel){.present = 1, .law = self_law(&impact, &friction), .reach = 0.2};
}

static inline void self_free(SelfScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    loads_free(&s->loads);
    self_pairs_free(&s->pairs);
}

static inline void self_fresh(SelfScene *s)
{
    assert_int_equal(self_refresh(&s->model, &s->chain, &s->kin, &s->pairs, NULL), HAWSER_OK);
}

static inline void self_load(SelfScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    for (int part = 0; part < SELF_PARTS; ++part) {
        self_forces(&s->model, &s->chain, &s->kin, friction, part, &s->pairs, &s->loads);
    }
}

/* Segment i from a to b. */
static inline void self_place(SelfScene *s, int i, Vec3 a, Vec3 b)
{
    vector_to(s->kin.p, i, v3_scale(0.5, v3_add(a, b)));
    vector_to(s->kin.a, i, v3_unit(v3_sub(b, a)));
}

/* Segments first .. first + count - 1 along a straight line from `start`. */
static inline void self_strand(SelfScene *s, int first, int count, Vec3 start, Vec3 direction)
{
    const Vec3 along = v3_unit(direction);
    for (int k = 0; k < count; ++k) {
        const double h = 2 * s->chain.half[first + k];
        self_place(s, first + k, v3_axpy(start, k * h, along), v3_axpy(start, (k + 1) * h, along));
    }
}

/* A helix about z: radius and pitch in m. */
static inline void self_helix(SelfScene *s, double radius, double pitch)
{
    Vec3 from = v3(radius, 0, 0);
    double angle = 0;
    for (int i = 0; i < s->chain.n; ++i) {
        angle += 2 * s->chain.half[i] / radius;
        const Vec3 to = v3(radius * cos(angle), radius * sin(angle), pitch * angle / (2 * M_PI));
        self_place(s, i, from, to);
        from = to;
    }
}

/* Every segment moved, turned and set in motion at random. */
static inline void self_shake(SelfScene *s, double shift, double speed, uint64_t *seed)
{
    for (int i = 0; i < s->chain.n; ++i) {
        vector_to(s->kin.p, i, v3_axpy(vector_of(s->kin.p, i), shift, random_vector(seed)));
        vector_to(s->kin.a, i, v3_unit(v3_axpy(vector_of(s->kin.a, i), shift / s->chain.half[i], random_vector(seed))));
        vector_to(s->kin.v, i, v3_scale(speed, random_vector(seed)));
        vector_to(s->kin.w, i, v3_scale(10 * speed, random_vector(seed)));
    }
}

/* Force on segments first .. first + count - 1. */
static inline Vec3 self_force_on(const SelfScene *s, int first, int count)
{
    Vec3 sum = v3(0, 0, 0);
    for (int i = first; i < first + count; ++i) sum = v3_add(sum, vector_of(s->loads.f, i));
    return sum;
}

#endif
