/* The surfaces' analytic derivatives against finite differences on random states, for every kind of surface, on
 * straights, in level, upright and twisted bends, at the ends of stretches and at the edges of sides; both geometries.
 */
#include "tests/support/touch.h"

#include <math.h>

#include "tests/support/contact_fd.h"

enum { N = 12 };

/* Straight, a level bend, a bend up to the left (it twists the sections), a straight. */
static const RoutePieceDef way[] = {{.kind = ROUTE_STRAIGHT, .length = 1},
                                    {.kind = ROUTE_BEND, .radius = 2, .angle = 1, .plane = 0},
                                    {.kind = ROUTE_BEND, .radius = 1.5, .angle = 1.2, .plane = 0.7},
                                    {.kind = ROUTE_STRAIGHT, .length = 3}};

/* A crooked, moving chain along the route, to the left and above it. */
static void chain_disturb(SurfaceScene *s, ContactGeometry geometry, double left, double up, double speed,
                          uint64_t *seed)
{
    for (int i = 0; i < N; ++i) {
        s->chain.half[i] = 0.25 + 0.05 * fixture_random(seed);
        s->chain.radius[i] = CABLE_RADIUS + 0.004 * fixture_random(seed);
    }
    surfaces_points(s, geometry);
    surfaces_lay(s, 0.1, left, up);
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.a, i, v3_unit(v3_axpy(vec_load(s->kin.a, i), 0.05, fixture_vector(seed, 1))));
        vec_store(s->kin.p, i, v3_axpy(vec_load(s->kin.p, i), 0.01, fixture_vector(seed, 1)));
        vec_store(s->kin.v, i, v3_scale(speed, fixture_vector(seed, 1)));
        vec_store(s->kin.w, i, v3_scale(2 * speed, fixture_vector(seed, 1)));
    }
}

/* Largest difference of two block chains, and the largest entry of the second. */
static void blocks_compare(const BlockChain *a, const BlockChain *b, double *difference, double *size)
{
    const double *const pa[3] = {a->lower, a->diag, a->upper}, *const pb[3] = {b->lower, b->diag, b->upper};
    for (int part = 0; part < 3; ++part) {
        for (int i = 0; i < 36 * a->n; ++i) {
            *difference = larger_of(*difference, fabs(pa[part][i] - pb[part][i]));
            *size = larger_of(*size, fabs(pb[part][i]));
        }
    }
}

static int presumes; /* whether points are lines about presumed forces (PS11) */

/* Between a third and three times what presses. */
static void presume(SurfaceScene *s, SurfacePresumed *out)
{
    static const Presume how = {.from = PRESUME_GAPS};
    uint64_t seed = 11;
    assert_true(surface_presume(&s->model, &s->chain, &s->kin, &s->pairs, &how, NULL, out));
    for (int b = 0; b < out->n_beds; ++b) {
        for (int q = 0; q < SURFACE_POINTS && out->bed[b][q]; ++q) {
            for (int e = 0; e <= N; ++e) out->bed[b][q][e] *= exp(fixture_random(&seed));
        }
    }
    s->pairs.presumed = out;
}

/* One random state; returns how many points touched. */
static int compare(SurfaceScene *s, double friction, double tolerance)
{
    BlockChain k, d, k_fd, d_fd;
    assert_true(block_chain_alloc(&k, N, 6) && block_chain_alloc(&d, N, 6));
    assert_true(block_chain_alloc(&k_fd, N, 6) && block_chain_alloc(&d_fd, N, 6));
    surfaces_refresh(s);
    surfaces_forces(s, friction);
    SurfacePresumed presumed = {0};
    if (presumes) presume(s, &presumed);
    /* in two halves, as two threads do */
    surface_blocks(&s->model, &s->chain, &s->kin, friction, &s->pairs, 0, N / 2, &k, &d);
    surface_blocks(&s->model, &s->chain, &s->kin, friction, &s->pairs, N / 2, N + 1, &k, &d);
    const double stray =
        surface_blocks_fd(&s->model, &s->chain, &s->kin, friction, &s->pairs, 1e-7, 1e-7, &k_fd, &d_fd);
    check_equal(stray, 0);
    double k_off = 0, k_size = 1, d_off = 0, d_size = 1;
    blocks_compare(&k, &k_fd, &k_off, &k_size);
    blocks_compare(&d, &d_fd, &d_off, &d_size);
    check_at_most(k_off, tolerance * k_size);
    check_at_most(d_off, tolerance * d_size);
    s->pairs.presumed = NULL;
    surface_presumed_free(&presumed);
    block_chain_free(&k);
    block_chain_free(&d);
    block_chain_free(&k_fd);
    block_chain_free(&d_fd);
    return s->pairs.active;
}

static void check_kind(SurfaceKind kind, double left, double up, double height)
{
    uint64_t seed = 7;
    int touched = 0;
    for (int trial = 0; trial < 24; ++trial) {
        SurfaceScene s;
        const double speed = trial % 3 == 0 ? 1e-3 : trial % 3 == 1 ? 0.01 : 0.3;
        surfaces_new(&s, N, 0.5);
        s.points.tip = 0.4 * (trial % 2);
        /* soft and gentle, so that finite differences see every term */
        s.model.impact = (ImpactLaw){.k = 1e5, .e = trial % 2 ? 1.5 : 2.2, .c = 500, .d = 0.02};
        surfaces_route(&s, 4, way, 0);
        SurfaceShape shape = surfaces_shape(kind, 0.3, 5);
        shape.lift = trial % 4 == 3 ? 0.03 : 0;
        if (height >= 0) shape.height = height;
        if (kind == SURFACE_FLAT) shape.width = 0.16;
        surfaces_add(&s, &shape);
        chain_disturb(&s, trial % 5 == 4 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, left, up, speed, &seed);
        /* the weights' second derivatives jump where a fade begins or ends (DU8): differences across a jump are off by
         * half the step times the jump */
        touched += compare(&s, trial % 4 ? 1 : 0, 5e-6);
        surfaces_free(&s);
    }
    print_message("%d points touched\n", touched);
    check_above(touched, 100);
}

TEST(test_duct) { check_kind(SURFACE_DUCT, 0.02, -0.06, -1); }

TEST(test_presumed)
{
    presumes = 1;
    check_kind(SURFACE_DUCT, 0.02, -0.06, -1);
    check_kind(SURFACE_FLAT, 0.035, -0.005, 0.06);
    presumes = 0;
}

TEST(test_floor) { check_kind(SURFACE_FLAT, 0.05, -0.008, 0); }

TEST(test_floor_with_walls) { check_kind(SURFACE_FLAT, 0.035, -0.005, 0.06); }

TEST(test_v) { check_kind(SURFACE_V, 0.01, -0.005, -1); }

TEST(test_u)
{
    check_kind(SURFACE_U, 0.02, -0.005, -1);
    /* above the half tube its sides are upright, up to the top and its edge */
    check_kind(SURFACE_U, -0.065, 0.08, 0.13);
}

/* A plane by point and normal, bounded. */
TEST(test_plane)
{
    uint64_t seed = 3;
    int touched = 0;
    for (int trial = 0; trial < 12; ++trial) {
        SurfaceScene s;
        surfaces_new(&s, N, 0.5);
        s.points.tip = 0.4 * (trial % 2);
        s.model.impact = (ImpactLaw){.k = 1e5, .e = 1.5, .c = 500, .d = 0.02};
        surfaces_route(&s, 4, way, 0);
        SurfaceShape shape = surfaces_shape(SURFACE_PLANE, 0, 0);
        shape.point = v3(0.8, 0, -0.04);
        shape.normal = v3_unit(v3(0.02, -0.03, 1));
        shape.along = v3_unit(v3_reject(v3(1, 0.1, 0), shape.normal));
        shape.length = trial % 2 ? 1.5 : 0;
        shape.width = trial % 3 ? 0.7 : 0;
        surfaces_add(&s, &shape);
        chain_disturb(&s, GEOMETRY_SMOOTH, 0, -0.008, 0.02, &seed);
        touched += compare(&s, 1, 2e-6);
        surfaces_free(&s);
    }
    check_above(touched, 30);
}

/* Without friction and damping no force depends on a velocity: D is zero to the last bit, and the cable's motion
 * changes no force. */
TEST(test_no_speeds)
{
    uint64_t seed = 4;
    for (int k = 0; k < 4; ++k) {
        SurfaceScene s;
        surfaces_new(&s, N, 0.5);
        s.model.impact = (ImpactLaw){.k = 1e5, .e = 1.5, .d = 0.02};
        surfaces_route(&s, 4, way, 0);
        SurfaceShape shape = surfaces_shape(SURFACE_PLANE, 0, 0);
        shape.point = v3(0.8, 0, -0.04);
        surfaces_add(&s, &shape);
        chain_disturb(&s, GEOMETRY_SMOOTH, 0, -0.008, 0.02 * k, &seed);
        surfaces_refresh(&s);
        BlockChain stiff, damp;
        assert_true(block_chain_alloc(&stiff, N, 6) && block_chain_alloc(&damp, N, 6));
        surface_blocks(&s.model, &s.chain, &s.kin, 0, &s.pairs, 0, s.points.elements, &stiff, &damp);
        double most = 0;
        const double *const part[3] = {damp.lower, damp.diag, damp.upper};
        for (int e = 0; e < 36 * N; ++e) {
            most = larger_of(most, fabs(stiff.diag[e]));
            for (int p = 0; p < 3; ++p) check_equal(part[p][e], 0);
        }
        check_above(most, 1e3);
        block_chain_free(&stiff);
        block_chain_free(&damp);
        surfaces_free(&s);
    }
}
