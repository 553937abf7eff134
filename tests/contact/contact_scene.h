/* Small scenes for the contact tests: a chain, rollers, and everything a call needs, owned by one struct. */
#ifndef TESTS_CONTACT_SCENE_H
#define TESTS_CONTACT_SCENE_H

#include <stdlib.h>
#include <string.h>

#include "contact/roller/contact.h"
#include "core/base/vec3.h"
#include "tests/support/check.h"

enum { SCENE_ROLLERS_MAX = 4, SCENE_HITS_MAX = 64 };

typedef struct TestScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    ContactPairs pairs;
    ContactModel model;
    ContactRoller roller[SCENE_ROLLERS_MAX];
    Vec3 on_roller[SCENE_ROLLERS_MAX];
} TestScene;

/* A cable of n segments of length h and radius 43.65 mm along x from the origin, at rest; no rollers yet. */
static inline void scene_new(TestScene *s, ContactGeometry geometry, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n));
    assert_true(kinematics_alloc(&s->kin, n));
    assert_true(loads_alloc(&s->loads, n));
    assert_true(contact_pairs_alloc(&s->pairs, n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = 0.04365;
        s->kin.p[0][i] = (i + 0.5) * h;
    }
    s->model = (ContactModel){
        .geometry = geometry, .impact = {.k = 2e7, .e = 1.5, .c = 2e4, .d = 1e-3}, .reach = 10, .roller = s->roller};
}

static inline void scene_free(TestScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    loads_free(&s->loads);
    contact_pairs_free(&s->pairs);
}

/* One more roller; returns it. */
static inline ContactRoller *scene_roller(TestScene *s, Vec3 centre, Vec3 axis, double radius, double half_width)
{
    ContactRoller *roller = &s->roller[s->model.n_rollers++];
    *roller = (ContactRoller){
        .shape = {.kind = SHAPE_CYLINDER, .centre = centre, .axis = axis, .radius = radius, .half_width = half_width},
        .friction = {.mu_s = 0.2, .mu_d = 0.15, .v_s = 5e-3, .v_d = 2e-2}};
    return roller;
}

/* Candidates for where the chain is now. */
static inline void scene_refresh(TestScene *s)
{
    assert_int_equal(contact_refresh(&s->model, &s->chain, &s->kin, &s->pairs, NULL), HAWSER_OK);
}

/* Loads and forces on the rollers. */
static inline void scene_forces(TestScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    contact_forces(&s->model, &s->chain, &s->kin, friction, &s->pairs, &s->loads, s->on_roller);
}

static inline Vec3 vector_of(double *const a[3], int i) { return v3(a[0][i], a[1][i], a[2][i]); }
static inline void vector_to(double *const a[3], int i, Vec3 v)
{
    a[0][i] = v.x;
    a[1][i] = v.y;
    a[2][i] = v.z;
}

/* The segments' centres joined end to end from `start`, for the axes that are there. */
static inline void scene_join(TestScene *s, Vec3 start)
{
    Vec3 end = start;
    for (int i = 0; i < s->chain.n; ++i) {
        const Vec3 arm = v3_scale(s->chain.half[i], vector_of(s->kin.a, i));
        vector_to(s->kin.p, i, v3_add(end, arm));
        end = v3_axpy(end, 2, arm);
    }
}

/* Deterministic numbers, uniform in [-1, 1]. */
static inline double random_next(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(*seed >> 11) * 0x1p-52 - 1;
}
static inline Vec3 random_vector(uint64_t *seed)
{
    const double x = random_next(seed), y = random_next(seed), z = random_next(seed);
    return v3(x, y, z);
}

#endif
