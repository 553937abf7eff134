/* Boxes, edges and bell-mouths: distances that can be seen, derivatives against differences, pushes over every edge
 * without a jump, forces and blocks that agree, and a flare that meets its duct's bore without a step. */
#include "tests/support/touch.h"

#include <math.h>

#include "tests/support/contact_fd.h"

enum { N = 6 };

static const Vec3 CENTRE = {0.3, -0.2, 0.1}, AXIS = {2.0 / 3, -1.0 / 3, 2.0 / 3}, SIDE = {1.0 / 3, -2.0 / 3, -2.0 / 3};

/* 0.5 x 0.3 x 0.2 m with edges of 30 mm. */
static Shape box_shape(void)
{
    return (Shape){.kind = SHAPE_BOX,
                   .centre = CENTRE,
                   .axis = AXIS,
                   .radius = 0.1,
                   .half_width = 0.25,
                   .box = {.side = SIDE, .half = {0.15, 0.1}, .edge = 0.03}};
}

/* A flare of 0.2 m at a bore of 75 mm. */
static Shape bell_shape(void)
{
    return (Shape){
        .kind = SHAPE_BELL, .centre = CENTRE, .axis = AXIS, .radius = 0.2, .half_width = 0.2, .bell = {0.275}};
}

/* A point by its coordinates along axis, side and axis x side. */
static Vec3 point_at(double x, double y, double z)
{
    return v3_axpy(v3_axpy(v3_axpy(CENTRE, x, AXIS), y, SIDE), z, v3_cross(AXIS, SIDE));
}

TEST(test_known_distances)
{
    const Shape box = box_shape(), bell = bell_shape();
    check_close(shape_distance(&box, point_at(0.1, -0.1, 0.15)), 0.05, 1e-15);                              /* face */
    check_close(shape_distance(&box, point_at(-0.25 + 0.03 - 0.06, 0.1, -0.1 + 0.03 - 0.08)), 0.07, 1e-15); /* edge */
    check_close(shape_distance(&box, point_at(0.22 + 0.02, 0.12 + 0.03, 0.07 + 0.06)), 0.04,
                1e-15);                                                         /* corner: 2 3 6 7 */
    check_close(shape_distance(&box, point_at(0, 0.05, -0.09)), -0.01, 1e-15);  /* inside */
    check_close(shape_distance(&bell, point_at(0, 0.04, 0)), 0.035, 1e-15);     /* throat */
    check_close(shape_distance(&bell, point_at(0.2, 0, -0.275)), 0, 1e-15);     /* the flare's rim */
    check_close(shape_distance(&bell, point_at(0.15, -0.075, 0)), 0.05, 1e-15); /* 3-4-5 */
    check_close(shape_distance(&bell, point_at(0, 0, 0)), 0.075, 1e-15);
    check_finite(v3_norm(shape_probe(&bell, 0, CENTRE).normal));
}

/* Bore and flare have one tangent at the throat: what lies in the duct, touching its wall, comes no nearer than the
 * radius of the ring's section behind the throat, and leaves it by about x^2/2R. */
TEST(test_flare_continues_the_bore)
{
    const Shape bell = bell_shape();
    const ShapeProbe throat = shape_probe(&bell, 0, point_at(0, 0.075, 0));
    check_close(throat.distance, 0, 1e-15);
    check_vec(throat.normal, v3_scale(-1, SIDE), 1e-15);
    for (double x = -0.02; x < 0.021; x += 0.005) {
        check_close(shape_distance(&bell, point_at(x, 0.075, 0)), hypot(0.2, x) - 0.2, 1e-15);
        check_at_least(shape_distance(&bell, point_at(x, 0.075, 0)), 0);
    }
}

/* Both implementations agree, and the derivatives are those of the distance. */
static int derivatives_check(const Shape *shape, Vec3 p)
{
    const double step = 1e-6;
    const ShapeProbe probe = shape_probe(shape, 0, p);
    check_close(probe.distance, shape_distance(shape, p), 2e-15);
    check_close(v3_norm(probe.normal), 1, 1e-14);
    for (int c = 0; c < 3; ++c) {
        const Vec3 e = v3(c == 0, c == 1, c == 2);
        const ShapeProbe plus = shape_probe(shape, 0, v3_axpy(p, step, e));
        const ShapeProbe minus = shape_probe(shape, 0, v3_axpy(p, -step, e));
        check_close((plus.distance - minus.distance) / (2 * step), v3_dot(probe.normal, e), 1e-8);
        const Vec3 column = v3_scale(1 / (2 * step), v3_sub(plus.normal, minus.normal));
        check_vec(column, m3_mul(&probe.hessian, e), 2e-6); /* third derivatives up to 1/(30 mm)^2 */
    }
    return 1;
}

/* Off the borders of faces, edges and corners, on the box and to 50 mm beside it. */
TEST(test_box_derivatives)
{
    const Shape box = box_shape();
    uint64_t seed = 11;
    int seen[4] = {0};
    for (int i = 0; i < 3000; ++i) {
        const double x = 0.3 * fixture_random(&seed), y = 0.2 * fixture_random(&seed), z = 0.15 * fixture_random(&seed);
        const double q[3] = {fabs(x) - 0.22, fabs(y) - 0.12, fabs(z) - 0.07};
        const Vec3 p = point_at(x, y, z);
        if (smaller_of(smaller_of(fabs(q[0]), fabs(q[1])), fabs(q[2])) < 1e-4 || shape_distance(&box, p) < -0.01)
            continue;
        seen[(q[0] > 0) + (q[1] > 0) + (q[2] > 0)] += derivatives_check(&box, p);
    }
    for (int k = 1; k < 4; ++k) check_above(seen[k], 100);
}

TEST(test_bell_derivatives)
{
    const Shape bell = bell_shape();
    uint64_t seed = 12;
    int seen = 0;
    for (int i = 0; i < 1000; ++i) {
        const Vec3 p = point_at(0.3 * fixture_random(&seed), 0.5 * fixture_random(&seed), 0.5 * fixture_random(&seed));
        const Vec3 off = v3_reject(v3_sub(p, CENTRE), AXIS);
        if (v3_norm(off) > 0.03 && shape_distance(&bell, p) > -0.05) seen += derivatives_check(&bell, p);
    }
    check_above(seen, 500);
}

/* Distance and normal are continuous all round the box, which is what keeps forces from jumping. */
TEST(test_normals_have_no_jump)
{
    const Shape box = box_shape();
    const double step = 1e-4;
    uint64_t seed = 13;
    for (int way = 0; way < 40; ++way) {
        const Vec3 at = v3_unit(fixture_vector(&seed, 1)), along = v3_unit(v3_reject(fixture_vector(&seed, 1), at));
        Vec3 before = {0};
        for (int i = 0; i < 20000; ++i) {
            const double a = i * step;
            const Vec3 p = v3_axpy(CENTRE, 0.7, v3_axpy(v3_scale(cos(a), at), sin(a), along));
            const Vec3 n = shape_probe(&box, 0, p).normal;
            if (i > 0) check_below(v3_norm(v3_sub(n, before)), 0.7 * step / 0.2);
            before = n;
        }
    }
}

/* -------------------------------------------------------------------------------------------- the cable against them
 */

static void obstacle_add(TestScene *s, Shape shape)
{
    scene_roller(s, shape.centre, shape.axis, shape.radius, shape.half_width)->shape = shape;
}

/* Largest second difference of any generalized force while a line at speed is moved in small steps, and the largest
 * force on the obstacle, N. */
typedef struct Pushed {
    double jump, most;
    int hits_most;
} Pushed;
static Pushed line_push(TestScene *s, Vec3 step, int steps)
{
    enum { SIZE = 6 * N };
    double past[3][SIZE] = {{0}};
    Pushed seen = {0};
    for (int i = 0; i < steps; ++i) {
        double *const now = past[i % 3], *const one = past[(i + 2) % 3], *const two = past[(i + 1) % 3];
        scene_refresh(s);
        scene_forces(s, 1);
        for (int k = 0; k < SIZE; ++k) now[k] = (k % 6 < 3 ? s->loads.f : s->loads.m)[k % 3][k / 6];
        for (int k = 0; k < SIZE && i >= 2; ++k) seen.jump = larger_of(seen.jump, fabs(now[k] - 2 * one[k] + two[k]));
        seen.most = larger_of(seen.most, v3_norm(s->on_roller[0]));
        seen.hits_most = s->pairs.active > seen.hits_most ? s->pairs.active : seen.hits_most;
        for (int k = 0; k < N; ++k) vec_store(s->kin.p, k, v3_add(vec_load(s->kin.p, k), step));
    }
    return seen;
}

/* A jump's second difference does not fall with the step, that of a kink and of a smooth force does. */
static void push_check(const Shape *shape, Vec3 turn, Vec3 start, Vec3 step, int steps)
{
    Pushed seen[2];
    for (int fine = 0; fine < 2; ++fine) {
        TestScene s;
        scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
        for (int i = 0; i < N; ++i) {
            vec_store(s.kin.a, i, v3_unit(turn));
            vec_store(s.kin.v, i, v3_scale(0.1, v3_unit(turn)));
        }
        scene_join(&s, start);
        obstacle_add(&s, *shape);
        seen[fine] = line_push(&s, v3_scale(fine ? 0.25 : 1, step), fine ? 4 * steps : steps);
        scene_free(&s);
    }
    print_message("force up to %.1f N, largest second difference %.2e, %.2e N\n", seen[0].most, seen[0].jump,
                  seen[1].jump);
    check_above(seen[0].most, 100);
    check_below(seen[1].jump, 0.3 * seen[0].jump);
    check_below(seen[0].jump, 2e-3 * seen[0].most);
    assert_int_equal(seen[0].hits_most, 1);
    assert_int_equal(seen[1].hits_most, 1);
}

/* A box in the cable's way, from every side: along a face over both its edges, over a corner, with the cable's head and
 * its tail, and onto an edge that is askew. */
TEST(test_pushes_over_the_box)
{
    const double r = 0.04365, in = 1e-3;
    Shape box = box_shape();
    box.centre = v3(1.6, 0, 0);
    box.axis = v3(1, 0, 0);
    box.box.side = v3(0, 1, 0);
    const double x = 1.38, top = 0.1 + r - in; /* where the box's rounded end begins, and the line just over it */
    /* across the top, a little off the level: over both long edges */
    push_check(&box, v3(1, 0, 0.02), v3(0, -0.25, top - 0.02 * x), v3(0, 2e-5, 0), 25000);
    /* the cable askew to the box: over a corner and an edge */
    push_check(&box, v3(1, 0.4, 0.1), v3(0, -0.3 - 0.4 * x, top - 0.1 * x), v3(0, 2e-5, 0), 30000);
    /* along itself, until its tail drops off the far end */
    push_check(&box, v3(1, 0.01, -0.02), v3(1.2, 0, top + 0.02 * (1.82 - 1.2)), v3(3e-5, 3e-7, -6e-7), 30000);
    /* down past an edge, sideways onto a face and off it */
    push_check(&box, v3(1, 0.02, 0), v3(0, 0.15 + r - in - 0.02 * x, -0.25), v3(0, 0, 2e-5), 25000);
}

/* Round the flare's inside from the bore outward, at a slant. */
TEST(test_pushes_through_the_bell)
{
    Shape bell = bell_shape();
    bell.centre = v3(1.6, 0, 0);
    bell.axis = v3(1, 0, 0);
    push_check(&bell, v3(1, 0.3, 0), v3(0.05, -0.45 + 0.002, 0), v3(0, 0, 2e-6), 20000);
}

/* Blocks against differences of the forces, where the line touches at random places. */
static double blocks_error(TestScene *s)
{
    BlockChain m[4];
    double worst = 0;
    for (int i = 0; i < 4; ++i) {
        assert_true(block_chain_alloc(&m[i], N, 6));
        block_chain_zero(&m[i]);
    }
    contact_blocks(&s->model, &s->chain, &s->kin, 1, &s->pairs, &m[0], &m[1], NULL, NULL);
    const double stray = contact_blocks_fd(&s->model, &s->chain, &s->kin, 1, &s->pairs, 2e-8, 1e-7, &m[2], &m[3]);
    check_equal(stray, 0);
    for (int which = 0; which < 2; ++which) {
        double most = 0, error = 0;
        for (int i = 0; i < 36 * N; ++i) {
            most = larger_of(most, fabs(m[which + 2].diag[i]));
            error = larger_of(error, fabs(m[which].diag[i] - m[which + 2].diag[i]));
        }
        worst = larger_of(worst, error / most);
    }
    for (int i = 0; i < 4; ++i) block_chain_free(&m[i]);
    return worst;
}

static void states_check(const Shape *shape, ContactGeometry geometry)
{
    uint64_t seed = 21;
    int active = 0;
    double worst = 0;
    for (int i = 0; i < 12000 && active < 60; ++i) {
        TestScene s;
        scene_new(&s, geometry, N, 0.5);
        for (int k = 0; k < N; ++k) {
            vec_store(s.kin.a, k, v3_unit(v3_axpy(v3(1, 0, 0), 0.1, fixture_vector(&seed, 1))));
            vec_store(s.kin.v, k, v3_scale(0.05, fixture_vector(&seed, 1)));
            vec_store(s.kin.w, k, v3_scale(0.1, fixture_vector(&seed, 1)));
        }
        scene_join(&s, v3(0, 0, 0));
        Shape here = *shape;
        here.axis = v3_unit(fixture_vector(&seed, 1));
        if (shape->kind == SHAPE_BOX) here.box.side = v3_unit(v3_reject(fixture_vector(&seed, 1), here.axis));
        here.centre = v3(1.5, 0.35 * fixture_random(&seed), 0.35 * fixture_random(&seed));
        obstacle_add(&s, here);
        scene_refresh(&s);
        ContactDetail hit[SCENE_HITS_MAX];
        const int hits = contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit);
        int fits = 0, skip = 0;
        for (int h = 0; h < hits; ++h) {
            fits |= hit[h].normal > 0;
            skip |= hit[h].gap < -5e-3 || fabs(hit[h].gap) < 1e-5 || (hit[h].u > 0 && hit[h].u < 1e-4) ||
                    (hit[h].u < 1 && hit[h].u > 1 - 1e-4);
        }
        if (fits && !skip) {
            worst = larger_of(worst, blocks_error(&s));
            ++active;
        }
        scene_free(&s);
    }
    print_message("%d states, worst %.2e\n", active, worst);
    check_equal(active, 60);
    check_below(worst, 1e-6);
}
TEST(test_blocks)
{
    const Shape box = box_shape(), bell = bell_shape();
    for (ContactGeometry g = GEOMETRY_SMOOTH; g <= GEOMETRY_CYLINDER; ++g) {
        states_check(&box, g);
        states_check(&bell, g);
    }
}

/* The head against a face: pushed back along the cable with k depth^e, and by nothing else. */
TEST(test_head_against_a_face)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
    Shape box = box_shape();
    box.axis = v3(1, 0, 0);
    box.box.side = v3(0, 1, 0);
    box.centre = v3(0.5 * N + s.chain.radius[0] + 0.25 - 1e-3, 0, 0);
    obstacle_add(&s, box);
    scene_refresh(&s);
    scene_forces(&s, 1);
    check_share(s.on_roller[0].x, s.model.impact.k * pow(1e-3, s.model.impact.e), 1e-9);
    check_below(fabs(s.on_roller[0].y) + fabs(s.on_roller[0].z), 1e-9 * s.on_roller[0].x);
    scene_free(&s);
}
