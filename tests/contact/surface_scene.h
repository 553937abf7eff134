/* Small scenes for the tests of surfaces: a chain on a route, the surfaces along it, and everything a call needs. */
#ifndef TESTS_CONTACT_SURFACE_SCENE_H
#define TESTS_CONTACT_SURFACE_SCENE_H

#include <stdlib.h>
#include <string.h>

#include "contact/surface/surface.h"
#include "core/base/vec3.h"
#include "tests/support/check.h"

enum { SURFACES_MAX = 4, PATCHES_MAX = 64 };

static const double CABLE_RADIUS = 0.04;

typedef struct SurfaceScene {
    Chain chain;
    Kinematics kin;
    Loads loads;
    Route route;
    SurfacePoints points;
    SurfacePairs pairs;
    SurfaceModel model;
    FrictionLaw friction[SURFACES_MAX];
    SurfacePatch patch[PATCHES_MAX];
    SurfaceTally tally[SURFACES_MAX];
} SurfaceScene;

/* A cable of n segments of length h along x from the origin, at rest, 40 mm thick from axis to skin; no surface yet. */
static inline void surfaces_new(SurfaceScene *s, int n, double h)
{
    memset(s, 0, sizeof *s);
    assert_true(chain_alloc(&s->chain, n));
    assert_true(kinematics_alloc(&s->kin, n));
    assert_true(loads_alloc(&s->loads, n));
    for (int i = 0; i < n; ++i) {
        s->chain.half[i] = h / 2;
        s->chain.radius[i] = CABLE_RADIUS;
        s->kin.p[0][i] = (i + 0.5) * h;
    }
    s->model = (SurfaceModel){.impact = {.k = 3e8, .e = 1.5, .c = 1e4, .d = 1e-4},
                              .reach = 1,
                              .friction = s->friction,
                              .patch = s->patch,
                              .points = &s->points};
}

/* The points, for the sizes that the chain has now. */
static inline void surfaces_points(SurfaceScene *s, ContactGeometry geometry)
{
    surface_points_free(&s->points);
    assert_true(surface_points_alloc(&s->points, geometry, &s->chain));
    surface_pairs_free(&s->pairs);
    surface_pairs_init(&s->pairs, 0, s->points.elements);
}

static inline void surfaces_free(SurfaceScene *s)
{
    chain_free(&s->chain);
    kinematics_free(&s->kin);
    loads_free(&s->loads);
    route_clear(&s->route);
    surface_points_free(&s->points);
    surface_pairs_free(&s->pairs);
}

static inline void surfaces_route(SurfaceScene *s, int n, const RoutePieceDef *piece, double slope)
{
    assert_int_equal(route_build(&s->route, n, piece, v3(0, 0, 0), 0, slope, NULL), HAWSER_OK);
}

/* A shape of a kind with every number set, for a cable of 40 mm: it bears the cable's centre on the route, but for the
 * duct, whose centre is there. */
static inline SurfaceShape surfaces_shape(SurfaceKind kind, double from, double to)
{
    return (SurfaceShape){.kind = kind,
                          .from = from,
                          .to = to,
                          .fade = 0.4,
                          .cable_radius = CABLE_RADIUS,
                          .radius = 0.1,
                          .depth = CABLE_RADIUS,
                          .width = 0.4,
                          .height = kind == SURFACE_FLAT ? 0 : 0.1,
                          .angle = 1.5,
                          .normal = {0, 0, 1},
                          .along = {1, 0, 0}};
}

/* One more surface; friction 0.25, 0.2. */
static inline void surfaces_add(SurfaceScene *s, const SurfaceShape *shape)
{
    SurfaceModel *const m = &s->model;
    const int n = surface_patch_count(shape, &s->route);
    check_below(m->n_surfaces, SURFACES_MAX);
    check_at_most(m->n_patches + n, PATCHES_MAX);
    surface_patches(shape, &s->route, m->n_surfaces, s->patch + m->n_patches);
    s->friction[m->n_surfaces++] = (FrictionLaw){.mu_s = 0.25, .mu_d = 0.2, .v_s = 5e-3, .v_d = 2e-2};
    m->n_patches += n;
}

static inline void surfaces_refresh(SurfaceScene *s)
{
    assert_int_equal(surface_refresh(&s->model, &s->chain, &s->kin, &s->pairs, NULL), HAWSER_OK);
}

/* Loads, and what every surface feels. */
static inline void surfaces_forces(SurfaceScene *s, double friction)
{
    loads_zero(&s->loads, s->chain.n);
    for (int i = 0; i < SURFACES_MAX; ++i) s->tally[i] = surface_tally_new();
    surface_forces(&s->model, &s->chain, &s->kin, friction, &s->pairs, &s->loads, s->tally);
}

static inline Vec3 vector_of(double *const a[3], int i) { return v3(a[0][i], a[1][i], a[2][i]); }
static inline void vector_to(double *const a[3], int i, Vec3 v)
{
    a[0][i] = v.x;
    a[1][i] = v.y;
    a[2][i] = v.z;
}

/* Lays the chain along the route from s0 on, moved by `off` across it (y left, z up); centres and axes only. */
static inline void surfaces_lay(SurfaceScene *s, double s0, double left, double up)
{
    double at = s0;
    for (int i = 0; i < s->chain.n; ++i, at += 2 * s->chain.half[i - 1]) {
        const double mid = at + s->chain.half[i];
        const RoutePoint p = route_at(&s->route, mid);
        const Vec3 l = route_left(&s->route, mid), u = v3_cross(p.tangent, l);
        vector_to(s->kin.p, i, v3_axpy(v3_axpy(p.position, left, l), up, u));
        vector_to(s->kin.a, i, p.tangent);
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
