/* Shapes and forces of surfaces: distance and normal against differences, continuity along the way, every point to one
 * part; action and reaction, objectivity, a stiffness that does not depend on the segments. */
#include "tests/support/touch.h"

#include <math.h>

static const RoutePieceDef way[] = {{.kind = ROUTE_STRAIGHT, .length = 2},
                                    {.kind = ROUTE_BEND, .radius = 2, .angle = 2.5, .plane = 0},
                                    {.kind = ROUTE_BEND, .radius = 1.5, .angle = 1, .plane = 0.7},
                                    {.kind = ROUTE_STRAIGHT, .length = 3}};
enum { WAY = 4 };

static const SurfaceKind along[] = {SURFACE_DUCT, SURFACE_FLAT, SURFACE_V, SURFACE_U};

static Vec3 beside(const Route *route, double s, double left, double up)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 l = route_left(route, s), u = v3_cross(at.tangent, l);
    return v3_axpy(v3_axpy(at.position, left, l), up, u);
}

/* The normal is the direction in which the distance grows, at the rate 1 (but for the turning of twisted sections). */
TEST(test_normal)
{
    uint64_t seed = 11;
    for (int k = 0; k < 4; ++k) {
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, WAY, way, 0.1);
        SurfaceShape shape = surfaces_shape(along[k], 0.5, 9);
        shape.lift = 0.02;
        surfaces_add(&s, &shape);
        for (int trial = 0; trial < 400; ++trial) {
            const double at = 5 + 4.9 * fixture_random(&seed);
            const Vec3 p = beside(&s.route, at, 0.07 * fixture_random(&seed), -0.01 + 0.05 * fixture_random(&seed));
            for (int f = 0; f < s.model.n_patches; ++f) {
                const SurfaceProbe here = surface_probe(&s.patch[f], p);
                if (!here.owned) continue;
                const double e = 1e-6;
                const Vec3 step[3] = {{e, 0, 0}, {0, e, 0}, {0, 0, e}};
                double slope[3];
                for (int c = 0; c < 3; ++c) {
                    slope[c] = (surface_probe(&s.patch[f], v3_add(p, step[c])).distance -
                                surface_probe(&s.patch[f], v3_sub(p, step[c])).distance) /
                               (2 * e);
                }
                const Vec3 gradient = v3(slope[0], slope[1], slope[2]);
                check_close(v3_norm(here.normal), 1, 1e-14);
                check_vec(v3_unit(gradient), here.normal, 1e-7);
                check_close(v3_norm(gradient), 1, 2e-3);
            }
        }
        surfaces_free(&s);
    }
}

/* Distance of the nearest face, its normal, and how many parts of the way own the point. */
static int faces_at(const SurfaceScene *s, Vec3 p, double *nearest, Vec3 *normal)
{
    int owners = 0;
    *nearest = INFINITY;
    for (int f = 0; f < s->model.n_patches; ++f) {
        const SurfaceProbe here = surface_probe(&s->patch[f], p);
        /* another part of the way may be beside this one: it does not touch (DU13) */
        if (!here.owned || here.distance < -SURFACE_DEPTH_MAX || here.share <= 0) continue;
        ++owners;
        if (here.distance >= *nearest) continue;
        *nearest = here.distance;
        *normal = here.normal;
    }
    return owners;
}

/* Along lines beside the route nothing jumps, and each point is one part's. */
TEST(test_continuous)
{
    for (int k = 0; k < 4; ++k) {
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, WAY, way, 0);
        SurfaceShape shape = surfaces_shape(along[k], 0.5, 9);
        shape.height = 0.1;
        shape.lift = 0.03;
        surfaces_add(&s, &shape);
        const int faces = along[k] == SURFACE_FLAT ? 3 : along[k] == SURFACE_V ? 2 : 1;
        double before = 0, now;
        Vec3 normal_before = {0, 0, 0}, normal = {0, 0, 0};
        for (int i = 0; i <= 17000; ++i) {
            const Vec3 p = beside(&s.route, 0.4 + 5e-4 * i, 0.02, -0.005);
            assert_int_equal(faces_at(&s, p, &now, &normal), faces);
            if (i > 0) {
                check_close(now, before, 1e-4);
                check_vec(normal, normal_before, 2e-3);
            }
            before = now;
            normal_before = normal;
        }
        surfaces_free(&s);
    }
}

/* Two stretches that meet share the cable: their weights add up to one. */
TEST(test_fades_meet)
{
    SurfaceScene s;
    surfaces_new(&s, 2, 0.5);
    surfaces_route(&s, WAY, way, 0);
    const SurfaceShape first = surfaces_shape(SURFACE_DUCT, 0, 3), second = surfaces_shape(SURFACE_DUCT, 3, 8);
    surfaces_add(&s, &first);
    surfaces_add(&s, &second);
    for (double at = 0.3; at < 7.5; at += 0.01) {
        double share = 0;
        for (int f = 0; f < s.model.n_patches; ++f) {
            const SurfaceProbe here = surface_probe(&s.patch[f], beside(&s.route, at, 0.01, 0.01));
            if (here.owned) share += here.share;
        }
        check_close(share, 1, 1e-12);
    }
    surfaces_free(&s);
}

/* A moving chain in a duct through all of the way. */
static void scene_moving(SurfaceScene *s, double heading)
{
    uint64_t seed = 5;
    surfaces_new(s, 18, 0.5);
    assert_int_equal(route_build(&s->route, WAY, way, v3(0, 0, 0), heading, 0.05, NULL), HAWSER_OK);
    const SurfaceShape duct = surfaces_shape(SURFACE_DUCT, 0, 5), tray = surfaces_shape(SURFACE_V, 5, 9);
    surfaces_add(s, &duct);
    surfaces_add(s, &tray);
    surfaces_points(s, GEOMETRY_SMOOTH);
    surfaces_lay(s, 0.1, 0, 0);
    const Vec3 turned = v3(cos(heading), sin(heading), 0);
    for (int i = 0; i < 18; ++i) {
        const Vec3 left = v3(-turned.y, turned.x, 0), up = v3(0, 0, 1), r = fixture_vector(&seed, 1),
                   v = fixture_vector(&seed, 1);
        Vec3 p = vec_load(s->kin.p, i);
        p = v3_axpy(p, i < 10 ? -0.0605 : -0.0005, up);
        p = v3_axpy(v3_axpy(v3_axpy(p, 2e-4 * r.x, turned), 2e-4 * r.y, left), 2e-4 * r.z, up);
        vec_store(s->kin.p, i, p);
        vec_store(s->kin.v, i, v3_axpy(v3_axpy(v3_scale(0.1 * v.x, turned), 0.1 * v.y, left), 0.01 * v.z, up));
        vec_store(s->kin.w, i, v3_scale(0.1, v3_axpy(v3_axpy(v3_scale(r.y, turned), r.z, left), r.x, up)));
    }
    surfaces_refresh(s);
}

/* What the segments feel and what the surfaces feel add up to nothing, forces and moments. */
TEST(test_action_and_reaction)
{
    SurfaceScene s;
    scene_moving(&s, 0);
    surfaces_forces(&s, 1);
    Vec3 total = {0, 0, 0};
    for (int i = 0; i < s.chain.n; ++i) total = v3_add(total, vec_load(s.loads.f, i));
    const Vec3 reaction = v3_add(s.tally[0].force, s.tally[1].force);
    const double *const sum = s.pairs.work.force;
    check_vec(v3(sum[0], sum[1], sum[2]), total,
              1e-13 * v3_norm(total)); /* another order of the same hundred numbers */
    for (int c = 0; c < 3; ++c) check_above(fabs(sum[c]), 1);
    print_message("%d points, on the cable %.3f %.3f %.3f N\n", s.pairs.active, total.x, total.y, total.z);
    check_above(s.pairs.active, 20);
    check_above(v3_norm(total), 1000);
    check_below(v3_norm(v3_add(total, reaction)), 2e-14 * v3_norm(total));
    /* friction is mu times the normal force where everything slides */
    check_at_most(s.tally[0].friction, 0.25 * s.tally[0].normal + 1e-9);
    check_above(s.tally[0].friction, 0.1 * s.tally[0].normal);
    surfaces_free(&s);
}

/* The whole scene turned about the vertical gives the turned forces. */
TEST(test_objectivity)
{
    const double heading = 0.8;
    SurfaceScene a, b;
    scene_moving(&a, 0);
    scene_moving(&b, heading);
    surfaces_forces(&a, 1);
    surfaces_forces(&b, 1);
    const Quat turn = quat_exp(v3(0, 0, heading));
    double size = 0, off = 0;
    for (int i = 0; i < a.chain.n; ++i) {
        const Vec3 f = quat_rotate(turn, vec_load(a.loads.f, i)), m = quat_rotate(turn, vec_load(a.loads.m, i));
        off = larger_of(off, v3_norm(v3_sub(f, vec_load(b.loads.f, i))) + v3_norm(v3_sub(m, vec_load(b.loads.m, i))));
        size = larger_of(size, v3_norm(f));
    }
    print_message("off by %.2e of %.2e N\n", off, size);
    check_above(size, 100);
    check_below(off, 1e-12 * size);
    surfaces_free(&a);
    surfaces_free(&b);
}

/* In two halves by elements, as two threads share them: the same loads to the last bit but for the shared segment. */
TEST(test_halves)
{
    SurfaceScene s;
    Loads whole;
    scene_moving(&s, 0);
    surfaces_forces(&s, 1);
    assert_true(chain_struct_alloc(&whole, s.chain.n));
    for (int c = 0; c < 3; ++c) memcpy(whole.f[c], s.loads.f[c], (size_t)s.chain.n * sizeof(double));
    const int candidates = s.pairs.candidates, elements = s.points.elements;
    loads_zero(&s.loads, s.chain.n);
    int sum = 0;
    for (int half = 0; half < 2; ++half) {
        surface_pairs_free(&s.pairs);
        surface_pairs_init(&s.pairs, half ? 8 : 0, half ? elements : 8);
        surfaces_refresh(&s);
        surface_forces(&s.model, &s.chain, &s.kin, 1, &s.pairs, &s.loads, NULL);
        sum += s.pairs.candidates;
    }
    assert_int_equal(sum, candidates);
    for (int c = 0; c < 3; ++c) {
        for (int i = 0; i < s.chain.n; ++i) {
            const double off = fabs(s.loads.f[c][i] - whole.f[c][i]);
            check_at_most(off, 1e-12 * fabs(whole.f[c][i]) + 1e-12);
        }
    }
    chain_struct_free(&whole);
    surfaces_free(&s);
}

/* A level cable pressed into a floor by a depth bears its length times k p^e, however it is cut, as arcs or capsules.
 */
TEST(test_stiffness)
{
    const double depth = 2e-4;
    for (int trial = 0; trial < 8; ++trial) {
        const int n = trial / 2 % 2 ? 40 : 3;
        const double length = 6;
        SurfaceScene s;
        surfaces_new(&s, n, length / n);
        s.model.impact.e = trial / 4 ? 1 : 1.5;
        SurfaceShape floor = surfaces_shape(SURFACE_PLANE, 0, 0);
        floor.point = v3(1, 2, depth - CABLE_RADIUS);
        floor.width = 0;
        surfaces_add(&s, &floor);
        surfaces_points(&s, trial % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH);
        surfaces_refresh(&s);
        surfaces_forces(&s, 1);
        const double each = 3e8 * pow(depth, s.model.impact.e);
        check_share(s.tally[0].normal, length * each, 2e-12);
        check_share(s.tally[0].force.z, -length * each, 2e-12);
        check_share(s.tally[0].line_load, each, 2e-12);
        assert_int_equal(s.pairs.active, SURFACE_POINTS * s.points.elements);
        /* all segments but those at the ends bear alike, and none is turned */
        for (int i = 1; i < n - 1; ++i) {
            check_share(s.loads.f[2][i], each * length / n, 1e-10);
            check_close(s.loads.m[1][i], 0, 1e-13 * each);
        }
        surfaces_free(&s);
    }
}

/* Where the points of an element are: of Gauss, and of Radau where the line ends (DU1), (DU16). */
static const double *points_of(int elements, int e)
{
    static const double u[3][SURFACE_POINTS] = {{0, 2.0 / 3}, {0.21132486540518712, 0.78867513459481288}, {1.0 / 3, 1}};
    return u[e == 0 ? 0 : e == elements - 1 ? 2 : 1];
}

/* Energy of the surfaces' springs: every point's length times k p^(e+1)/(e+1) (DU1). */
static double potential(const SurfaceScene *s)
{
    const ImpactLaw *const law = &s->model.impact;
    double sum = 0;
    for (int e = 0; e < s->points.elements; ++e) {
        const Element element = element_at(GEOMETRY_SMOOTH, s->chain.n, e);
        for (int q = 0; q < SURFACE_POINTS; ++q) {
            const Vec3 p = element_point(&element, &s->chain, &s->kin, points_of(s->points.elements, e)[q]);
            for (int f = 0; f < s->model.n_patches; ++f) {
                const SurfaceProbe at = surface_probe(&s->patch[f], p);
                const double depth = s->points.radius[q][e] - at.distance;
                if (!at.owned || depth <= 0 || at.distance < -SURFACE_DEPTH_MAX) continue;
                sum += at.share * s->points.length[q][e] * law->k * pow(depth, law->e + 1) / (law->e + 1);
            }
        }
    }
    return sum;
}

/* Without friction and damping the forces are minus the gradient of that energy, away from the fades. */
TEST(test_potential)
{
    SurfaceScene s;
    scene_moving(&s, 0);
    s.model.impact.c = 0;
    for (int f = 0; f < s.model.n_patches; ++f) s.patch[f].along.used = 0; /* one duct from end to end, one V */
    surfaces_forces(&s, 0);
    double size = 0;
    for (int i = 0; i < s.chain.n; ++i) size = larger_of(size, v3_norm(vec_load(s.loads.f, i)));
    for (int i = 0; i < s.chain.n; ++i) {
        const Vec3 axis = vec_load(s.kin.a, i);
        const double e = 1e-7;
        for (int c = 0; c < 3; ++c) {
            const double at = s.kin.p[c][i];
            s.kin.p[c][i] = at + e;
            const double plus = potential(&s);
            s.kin.p[c][i] = at - e;
            const double minus = potential(&s);
            s.kin.p[c][i] = at;
            check_close((minus - plus) / (2 * e), s.loads.f[c][i], 2e-7 * size);
            /* and the moments by turns */
            const Vec3 about = v3(c == 0, c == 1, c == 2);
            vec_store(s.kin.a, i, quat_rotate(quat_exp(v3_scale(e, about)), axis));
            const double left = potential(&s);
            vec_store(s.kin.a, i, quat_rotate(quat_exp(v3_scale(-e, about)), axis));
            const double right = potential(&s);
            vec_store(s.kin.a, i, axis);
            const Vec3 m = vec_load(s.loads.m, i);
            check_close((right - left) / (2 * e), v3_dot(m, about), 2e-8 * size);
        }
    }
    surfaces_free(&s);
}

/* (BA5), (BA6), (BA10): the forces' power is what friction and damping take, what goes into the springs, and what fades
 * and twists do besides; the springs' energy by differences along the motion. */
TEST(test_balance)
{
    const double step = 1e-7;
    for (int twisted = 0; twisted < 2; ++twisted) {
        SurfaceScene s;
        double power = 0, energy[2];
        scene_moving(&s, 0);
        s.model.impact.e = 2.2;
        if (twisted) { /* a V along all of the way, whose bends turn its section; faster */
            const SurfaceShape tray = surfaces_shape(SURFACE_V, 0.5, 9);
            s.model.n_surfaces = s.model.n_patches = 0;
            surfaces_add(&s, &tray);
            for (int i = 0; i < s.chain.n; ++i) {
                if (i < 10) s.kin.p[2][i] += 0.06;
                for (int c = 0; c < 3; ++c) s.kin.v[c][i] *= 5;
            }
            surfaces_refresh(&s);
        }
        surfaces_forces(&s, 1);
        check_above(s.pairs.active, 10);
        const ContactTally work = s.pairs.work;
        for (int i = 0; i < s.chain.n; ++i) {
            power += v3_dot(vec_load(s.loads.f, i), vec_load(s.kin.v, i));
            power += v3_dot(vec_load(s.loads.m, i), vec_load(s.kin.w, i));
        }
        for (int side = 0; side < 2; ++side) {
            for (int i = 0; i < s.chain.n; ++i) {
                const double h = side ? 2 * step : -step;
                vec_store(s.kin.p, i, v3_axpy(vec_load(s.kin.p, i), h, vec_load(s.kin.v, i)));
                vec_store(s.kin.a, i, quat_rotate(quat_exp(v3_scale(h, vec_load(s.kin.w, i))), vec_load(s.kin.a, i)));
            }
            surfaces_forces(&s, 1);
            energy[side] = s.pairs.work.energy;
        }
        const double rate = (energy[1] - energy[0]) / (2 * step), taken = work.friction + work.damping;
        print_message("%g W, %g by edges\n", power, work.edges);
        check_above(fabs(work.edges), twisted ? 0 : 1e-3 * taken); /* a twist does little */
        check_close(power, work.edges - taken - rate, 2e-6 * (taken + fabs(rate)));
        surfaces_free(&s);
    }
}

/* A straight cable drawn over the end of a floor at the same depth: what is borne falls evenly, without steps. */
TEST(test_floor_end)
{
    const double depth = 1e-4, each = 3e8 * pow(depth, 1.5), h = 0.5;
    SurfaceScene s;
    surfaces_new(&s, 20, h);
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    surfaces_route(&s, 1, &straight, 0);
    SurfaceShape floor = surfaces_shape(SURFACE_FLAT, 1, 5.17);
    floor.depth = CABLE_RADIUS - depth;
    floor.fade = h;
    surfaces_add(&s, &floor);
    surfaces_points(&s, GEOMETRY_SMOOTH);
    surfaces_refresh(&s);
    double before = 0, ripple = 0, step = 0;
    for (int k = 0; k < 200; ++k) {
        surfaces_forces(&s, 1);
        const double borne = s.tally[0].normal / each; /* m of cable; the floor has 4.17 */
        ripple = larger_of(ripple, fabs(borne - 4.17));
        if (k > 0) step = larger_of(step, fabs(borne - before));
        before = borne;
        for (int i = 0; i < 20; ++i) s.kin.p[0][i] += 2.5e-3;
    }
    print_message("ripple %.4f m, largest step %.5f m in 2.5 mm\n", ripple, step);
    check_below(ripple, 0.032);
    check_below(step, 1.3e-3);
    surfaces_free(&s);
}

/* A force that varies along a straight cable with the square of the place is summed without error, ends included: at
 * the tips stand a quarter of a half segment's length each, and what was given besides. */
TEST(test_ends_are_points)
{
    for (int n = 2; n <= 5; ++n) {
        for (int geometry = 0; geometry < 2; ++geometry) {
            SurfaceScene s;
            surfaces_new(&s, n, 0.5);
            s.points.tip = 0.3;
            surfaces_points(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH);
            double sum = 0, whole = 0;
            for (int e = 0; e < s.points.elements; ++e) {
                const Element element = element_at(geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH, n, e);
                for (int q = 0; q < SURFACE_POINTS; ++q) {
                    const double x = element_point(&element, &s.chain, &s.kin, points_of(s.points.elements, e)[q]).x;
                    sum += s.points.length[q][e] * x * x;
                    whole += s.points.length[q][e];
                }
            }
            const double length = 0.5 * n;
            check_share(whole, length + 2 * 0.3, 1e-14);
            /* the arcs' parameter is not the place: only straight elements of one length are exact */
            check_share(sum, length * length * length / 3 + 0.3 * length * length, 1e-13);
            surfaces_free(&s);
        }
    }
}

/* A cable that stands on its end sinks by what the tip's stiffness says, however it is cut: as long as it is cut more
 * finely than the length that the tip stands for, to second order in what is left of the half segment. */
TEST(test_tip_stiffness)
{
    const double depth = 1e-4, tip = 1;
    double before = 0;
    for (int n = 4; n <= 64; n *= 4) {
        SurfaceScene s;
        surfaces_new(&s, n, 2.0 / n);
        s.points.tip = tip;
        for (int i = 0; i < n; ++i) {
            vec_store(s.kin.a, i, v3(0.6, 0, 0.8));
            vec_store(s.kin.p, i, v3_scale((i + 0.5) * 2.0 / n, v3(0.6, 0, 0.8)));
        }
        SurfaceShape floor = surfaces_shape(SURFACE_PLANE, 0, 0);
        floor.point = v3(0, 0, depth - CABLE_RADIUS);
        floor.length = floor.width = 0;
        surfaces_add(&s, &floor);
        surfaces_points(&s, GEOMETRY_SMOOTH);
        surfaces_refresh(&s);
        surfaces_forces(&s, 0);
        assert_int_equal(s.pairs.active, 1);
        const double force = s.tally[0].normal, rigid = tip * 3e8 * pow(depth, 1.5), off = force / rigid - 1;
        print_message("segments of %g m: %g N, %.3f %% more than the tip alone\n", 2.0 / n, force, 100 * off);
        check_close(off, 1.0 / n / 4, 1e-12); /* a quarter of the half segment, over 1 m */
        if (before > 0) check_close(before / off, 4, 1e-9);
        before = off;
        surfaces_free(&s);
    }
}

/* A plane without ends has half of space behind it and pushes back at any depth; one with ends has another side. */
TEST(test_half_space)
{
    for (int bounded = 0; bounded < 2; ++bounded) {
        for (double depth = 0.1; depth < 20; depth *= 4) {
            SurfaceScene s;
            surfaces_new(&s, 4, 0.5);
            SurfaceShape floor = surfaces_shape(SURFACE_PLANE, 0, 0);
            floor.point = v3(1, 0, depth - CABLE_RADIUS);
            floor.length = bounded ? 100 : 0;
            floor.width = 0;
            surfaces_add(&s, &floor);
            surfaces_points(&s, GEOMETRY_SMOOTH);
            surfaces_refresh(&s);
            surfaces_forces(&s, 0);
            const int touches = !bounded || depth < SURFACE_DEPTH_MAX + CABLE_RADIUS;
            check_share(s.tally[0].normal, touches ? 2 * 3e8 * pow(depth, 1.5) : 0, 1e-12);
            surfaces_free(&s);
        }
    }
}

/* What is behind a floor by more than the limit is on its other side; what is beyond its edges is not borne. */
TEST(test_limits)
{
    SurfaceScene s;
    surfaces_new(&s, 4, 0.5);
    SurfaceShape floor = surfaces_shape(SURFACE_PLANE, 0, 0);
    floor.point = v3(1, 0, 0.39);
    floor.length = 3;
    floor.width = 1;
    surfaces_add(&s, &floor);
    surfaces_points(&s, GEOMETRY_SMOOTH);
    surfaces_refresh(&s);
    surfaces_forces(&s, 1);
    assert_int_equal(s.pairs.active, 0);
    s.patch[0].start.z = s.patch[0].end.z = 0.1;
    surfaces_forces(&s, 1);
    assert_int_equal(s.pairs.active, 10);
    /* beside it: the fade of 0.4 m ends 0.7 m from the middle */
    for (int i = 0; i < 4; ++i) s.kin.p[1][i] = 0.71;
    surfaces_forces(&s, 1);
    check_equal(s.tally[0].normal, 0);
    surfaces_free(&s);
}
