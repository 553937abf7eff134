/* A cable in grooves: both flanks of a V bear it and count as one roller; forces and moments balance and turn with the
 * scene; pushed over every edge the force never jumps; in a U a cable that lies askew finds its nearest point. */
#include "tests/support/touch.h"

#include <math.h>

enum { N = 6 };

static ContactRoller *grooved_roller(TestScene *s, Vec3 centre, Vec3 axis, Groove groove, ShapeKind kind)
{
    ContactRoller *const roller = scene_roller(s, centre, axis, 0.08, 0.25);
    roller->shape.kind = kind;
    roller->shape.groove = groove;
    return roller;
}

/* Pressed into the middle of a V by `depth`: each flank pushes with k depth^e, together along the bisector. */
TEST(test_both_flanks)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
    const double half_angle = 0.7, depth = 1e-3, radius = s.chain.radius[0];
    const double seat = 0.08 + (radius - depth) / sin(half_angle);
    grooved_roller(&s, v3(1.6, 0, -seat), v3(0, 1, 0), groove_v(half_angle, 0.1), SHAPE_V_GROOVE);
    scene_refresh(&s);
    scene_forces(&s, 1);
    ContactDetail hit[SCENE_HITS_MAX];
    assert_int_equal(contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit), 2);
    assert_int_equal(s.pairs.active, 2);
    check_equal(hit[0].face, 0);
    check_equal(hit[1].face, 1);
    check_equal(hit[0].roller, 0);
    check_equal(hit[1].roller, 0);
    const double N_flank = s.model.impact.k * pow(depth, s.model.impact.e);
    for (int h = 0; h < 2; ++h) {
        check_share(hit[h].normal, N_flank, 1e-12);
        check_close(hit[h].point.x, 1.6, 1e-9);
    }
    /* one roller, one force: 2 N sin(half angle) down on it */
    check_share(s.on_roller[0].z, -2 * N_flank * sin(half_angle), 1e-12);
    check_below(fabs(s.on_roller[0].x) + fabs(s.on_roller[0].y), 1e-12 * N_flank);
    scene_free(&s);
}

/* Sliding along it each flank rubs: mu/sin(half angle) of the load. */
TEST(test_wedge_friction)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
    const double half_angle = 0.5;
    const double seat = 0.08 + (s.chain.radius[0] - 5e-4) / sin(half_angle);
    ContactRoller *const roller =
        grooved_roller(&s, v3(1.6, 0, -seat), v3(0, 1, 0), groove_v(half_angle, 0.12), SHAPE_V_GROOVE);
    for (int i = 0; i < N; ++i) s.kin.v[0][i] = 0.1;
    scene_refresh(&s);
    scene_forces(&s, 1);
    const double effective = roller->friction.mu_d / sin(half_angle);
    check_share(s.on_roller[0].x / -s.on_roller[0].z, effective, 1e-9);
    scene_free(&s);
}

/* A crooked, moving chain in a groove, all of it turned and shifted. */
static void groove_scene(TestScene *s, ShapeKind kind, Quat turn, Vec3 shift)
{
    uint64_t seed = 3;
    scene_new(s, GEOMETRY_SMOOTH, N, 0.5);
    for (int i = 0; i < N; ++i) {
        const Vec3 a = v3_unit(v3_axpy(v3(1, 0, 0), 0.02, fixture_vector(&seed, 1)));
        vec_store(s->kin.a, i, a);
        vec_store(s->kin.v, i, quat_rotate(turn, v3_scale(0.05, fixture_vector(&seed, 1))));
        vec_store(s->kin.w, i, quat_rotate(turn, v3_scale(0.1, fixture_vector(&seed, 1))));
    }
    scene_join(s, v3(0, 0, 0));
    const Groove groove = kind == SHAPE_V_GROOVE ? groove_v(0.8, 0.12) : groove_u(0.06, 0.05);
    const Shape shape = {.kind = kind, .radius = 0.08, .groove = groove};
    for (int r = 0; r < 3; ++r) {
        const Element element = element_at(GEOMETRY_SMOOTH, N, r + 2);
        const Vec3 p = element_point(&element, &s->chain, &s->kin, 0.4);
        const Vec3 centre = v3_axpy(p, -(shape_seat(&shape, s->chain.radius[0]) - 1e-3), v3(0, 0, 1));
        grooved_roller(s, v3_add(shift, quat_rotate(turn, centre)), quat_rotate(turn, v3(0, 1, 0)), groove, kind);
    }
    for (int i = 0; i < N; ++i) {
        vec_store(s->kin.p, i, v3_add(shift, quat_rotate(turn, vec_load(s->kin.p, i))));
        vec_store(s->kin.a, i, quat_rotate(turn, vec_load(s->kin.a, i)));
    }
    scene_refresh(s);
    scene_forces(s, 1);
}

TEST(test_balance_and_objectivity)
{
    const Quat turn = quat_unit((Quat){0.4, -0.3, 0.7, 0.2});
    for (ShapeKind kind = SHAPE_V_GROOVE; kind <= SHAPE_U_GROOVE; ++kind) {
        TestScene s, t;
        groove_scene(&s, kind, (Quat){1, 0, 0, 0}, v3(0, 0, 0));
        groove_scene(&t, kind, turn, v3(2, -1, 3));
        check_at_least(s.pairs.active, 3);
        check_equal(t.pairs.active, s.pairs.active);
        Vec3 sum = v3(0, 0, 0);
        double size = 0;
        for (int r = 0; r < 3; ++r) {
            sum = v3_add(sum, s.on_roller[r]);
            size += v3_norm(s.on_roller[r]);
            const Vec3 turned = quat_rotate(turn, s.on_roller[r]);
            check_vec(turned, t.on_roller[r], 1e-10 * v3_norm(turned));
        }
        for (int i = 0; i < N; ++i) {
            sum = v3_add(sum, vec_load(s.loads.f, i));
            const Vec3 f = quat_rotate(turn, vec_load(s.loads.f, i)), m = quat_rotate(turn, vec_load(s.loads.m, i));
            check_vec(f, vec_load(t.loads.f, i), 1e-11 * size);
            check_vec(m, vec_load(t.loads.m, i), 1e-11 * size);
        }
        check_below(v3_norm(sum), 1e-12 * size);
        scene_free(&s);
        scene_free(&t);
    }
}

/* The force of a straight cable that is moved sideways over the roller, 1 mm into its lips, in steps of `step`. */
static double largest_jump(ShapeKind kind, Groove groove, double step)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
    grooved_roller(&s, v3(1.6, 0, 0), v3(0, 1, 0), groove, kind);
    s.model.impact.c = 0;
    for (int i = 0; i < N; ++i) s.kin.p[2][i] = 0.08 + groove.depth + s.chain.radius[0] - 1e-3;
    scene_refresh(&s);
    double jump = 0;
    Vec3 before = v3(0, 0, 0);
    int touching = 0;
    for (double y = -0.35; y < 0.35; y += step) {
        for (int i = 0; i < N; ++i) s.kin.p[1][i] = y;
        scene_forces(&s, 0);
        touching += s.pairs.active > 0;
        if (y > -0.349) jump = larger_of(jump, v3_norm(v3_sub(s.on_roller[0], before)));
        before = s.on_roller[0];
    }
    check_above(touching, 1000);
    scene_free(&s);
    return jump;
}

/* A force that has no jump changes by half as much in half a step. */
TEST(test_pushed_over_edges)
{
    const Groove groove[2] = {groove_v(0.8, 0.12), groove_u(0.06, 0.05)};
    for (int k = 0; k < 2; ++k) {
        const ShapeKind kind = k == 0 ? SHAPE_V_GROOVE : SHAPE_U_GROOVE;
        const double coarse = largest_jump(kind, groove[k], 4e-5), fine = largest_jump(kind, groove[k], 1e-5);
        check_above(coarse, 0);
        check_below(fine, 0.3 * coarse);
    }
}

/* Askew by up to 25 deg in a U, far beyond (GR7): what is found is a minimum of the gap along the line, never the
 * maximum between two. */
TEST(test_askew_in_u)
{
    for (double skew = 0; skew < 0.45; skew += 0.01) {
        TestScene s;
        scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
        for (int i = 0; i < N; ++i) {
            vec_store(s.kin.a, i, v3(cos(skew), sin(skew), 0));
            vec_store(s.kin.p, i, v3_scale((i - 2) * 0.5, v3(cos(skew), sin(skew), 0)));
        }
        /* the middle of an arc is over the middle of the roller: the maximum, if there is one */
        grooved_roller(&s, v3(0.25 * cos(skew), 0.25 * sin(skew), -0.08 - s.chain.radius[0] + 1e-3), v3(0, 1, 0),
                       groove_u(0.05, 0.045), SHAPE_U_GROOVE);
        scene_refresh(&s);
        ContactDetail hit[SCENE_HITS_MAX];
        const int hits = contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit);
        assert_int_equal(hits, 1);
        check_above(hit[0].normal, 0);
        const Element element = element_at(GEOMETRY_SMOOTH, N, hit[0].element);
        for (int side = -1; side <= 1; side += 2) {
            const Vec3 p = element_point(&element, &s.chain, &s.kin, hit[0].u + side * 1e-3);
            check_at_least(shape_distance(&s.roller[0].shape, p) - s.chain.radius[0], hit[0].gap - 1e-12);
        }
        scene_free(&s);
    }
}

/* Drawn through a U as deep as its radius, a little askew and up on one wall: the contact stays whatever part of a
 * segment is at the walls' upper edge, where they stand upright, and the point found is the nearest (GR15). */
TEST(test_drawn_through_deep_u)
{
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, N, 0.5);
    const double rc = s.chain.radius[0], r_g = 1.25 * rc, up = 0.9, skew = 5e-3, depth = 1e-4;
    const Vec3 along = v3(cos(skew), sin(skew), 0);
    const double way = r_g - rc + depth; /* of the cable's middle from the arc's centre */
    grooved_roller(&s, v3(1.25, 0, 0), v3(0, 1, 0), groove_u(r_g, r_g), SHAPE_U_GROOVE);
    double least = INFINITY, most = -INFINITY;
    for (double x = 0; x < 0.5; x += 1e-4) {
        for (int i = 0; i < N; ++i) {
            vec_store(s.kin.a, i, along);
            vec_store(s.kin.p, i,
                      v3_axpy(v3(1.25, way * sin(up), 0.08 + r_g - way * cos(up)), (i - 3) * 0.5 + x, along));
        }
        scene_refresh(&s);
        ContactDetail hit[SCENE_HITS_MAX];
        const int hits = contact_details(&s.model, &s.chain, &s.kin, 0, &s.pairs, SCENE_HITS_MAX, hit);
        double gap = INFINITY;
        for (int h = 0; h < hits; ++h) gap = fmin(gap, hit[h].gap);
        least = fmin(least, gap);
        most = fmax(most, gap);
    }
    check_below(most, -depth / 2);
    check_below(most - least, 1e-9);
    scene_free(&s);
}

/* Largest penetration, m, of a line along x through (., 0, z) that is thick up to a joint and thin behind it, moved on
 * by x over the roller at 1.25 m; 0: no contact. */
static double thinning_depth(TestScene *s, double z, double x)
{
    for (int i = 0; i < N; ++i) vec_store(s->kin.p, i, v3((i - 1) * 0.5 + x, 0, z));
    scene_refresh(s);
    ContactDetail hit[SCENE_HITS_MAX];
    const int hits = contact_details(&s->model, &s->chain, &s->kin, 0, &s->pairs, SCENE_HITS_MAX, hit);
    double gap = 0;
    for (int h = 0; h < hits; ++h) gap = fmin(gap, hit[h].gap);
    return -gap;
}

/* A cable that ends in a thin rope, drawn through the middle of a U as deep as its radius: it is borne as by a flat
 * roller, wherever the segment in between stands out of the groove (GR16). */
TEST(test_thinning_in_deep_u)
{
    TestScene u, flat;
    scene_new(&u, GEOMETRY_SMOOTH, N, 0.5);
    scene_new(&flat, GEOMETRY_SMOOTH, N, 0.5);
    const double rc = u.chain.radius[0];
    const Groove groove = groove_u(1.25 * rc, 1.25 * rc);
    grooved_roller(&u, v3(1.25, 0, 0), v3(0, 1, 0), groove, SHAPE_U_GROOVE);
    scene_roller(&flat, v3(1.25, 0, 0), v3(0, 1, 0), 0.08, 0.25);
    for (int i = N / 2; i < N; ++i) u.chain.radius[i] = flat.chain.radius[i] = rc / 10;
    double deepest = 0;
    for (double x = -0.5; x < 1; x += 1e-3) {
        const double depth = thinning_depth(&u, 0.08 + rc - 1e-3, x);
        check_close(depth, thinning_depth(&flat, 0.08 + rc - 1e-3, x), 1e-9);
        deepest = fmax(deepest, depth);
    }
    check_at_least(deepest, 1e-3 - 1e-9);
    scene_free(&flat);
    scene_free(&u);
}
