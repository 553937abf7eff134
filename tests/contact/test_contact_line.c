/* The smooth line's contact point: never missed, never doubled, and no force jumps as the line is pushed over
 * a roller in tiny steps, whatever passes: an arc's border, the line's end, the roller's rim, the pulling
 * eye. */
#include "tests/support/touch.h"

#include <math.h>

static const double ROLLER = 0.1, CABLE = 0.04365, ROPE = 0.007;

/* What was seen while a line was pushed. */
typedef struct Pushed {
    int hits_least, hits_most; /* contacts with force */
    double force_most;         /* N, on the roller */
    double jump;               /* largest second difference of any generalized force (moments over 1 m), N */
} Pushed;

static void loads_read(const TestScene *s, double *out)
{
    for (int i = 0; i < s->chain.n; ++i) {
        for (int c = 0; c < 3; ++c) {
            out[6 * i + c] = s->loads.f[c][i];
            out[6 * i + 3 + c] = s->loads.m[c][i];
        }
    }
}

/* Moves the whole line by steps * step and looks at every place. A jump of J in a force shows as a second
 * difference of J; a smooth force's is its curvature times the step squared. */
static Pushed line_push(TestScene *s, Vec3 step, int steps)
{
    const int n = s->chain.n, size = 6 * n;
    double *const past = calloc(3 * (size_t)size, sizeof *past);
    assert_non_null(past);
    Pushed seen = {.hits_least = 1000};
    for (int i = 0; i < steps; ++i) {
        scene_forces(s, 1);
        double *const now = past + i % 3 * size, *const one = past + (i + 2) % 3 * size,
                      *const two = past + (i + 1) % 3 * size;
        loads_read(s, now);
        for (int k = 0; k < size && i >= 2; ++k) {
            seen.jump = larger_of(seen.jump, fabs(now[k] - 2 * one[k] + two[k]));
        }
        seen.hits_least = s->pairs.active < seen.hits_least ? s->pairs.active : seen.hits_least;
        seen.hits_most = s->pairs.active > seen.hits_most ? s->pairs.active : seen.hits_most;
        seen.force_most = larger_of(seen.force_most, v3_norm(s->on_roller[0]));
        for (int k = 0; k < n; ++k) vec_store(s->kin.p, k, v3_add(vec_load(s->kin.p, k), step));
    }
    free(past);
    print_message("contacts %d..%d, force up to %.1f N, largest jump %.2e N\n", seen.hits_least, seen.hits_most,
                  seen.force_most, seen.jump);
    return seen;
}

/* Pushes two equal lines over the same way, the second in steps four times smaller. A kink's second
 * difference falls with the step, a jump's does not. */
static Pushed line_push_twice(TestScene *s, TestScene *same, Vec3 step, int steps)
{
    const Pushed coarse = line_push(s, step, steps);
    const Pushed fine = line_push(same, v3_scale(0.25, step), 4 * steps);
    check_below(fine.jump, 0.3 * coarse.jump);
    check_below(coarse.jump, 1e-3 * coarse.force_most);
    assert_int_equal(fine.hits_most, coarse.hits_most);
    assert_int_equal(fine.hits_least, coarse.hits_least);
    scene_free(s);
    scene_free(same);
    return fine;
}

/* A line of 8 segments that moves at 0.1 m/s, and below it a roller at x, pressed in by `depth`. */
static void line_new(TestScene *s, double x, double depth)
{
    scene_new(s, GEOMETRY_SMOOTH, 8, 0.5);
    for (int i = 0; i < 8; ++i) vec_store(s->kin.v, i, v3(0.1, 0, 0));
    scene_roller(s, v3(x, 0, -ROLLER - CABLE + depth), v3(0, 1, 0), ROLLER, 0.2);
    scene_refresh(s);
}

/* Turns every segment a little more than the one before (about y), joins them, and shears and stretches the
 * joints. */
static void line_bend(TestScene *s, double angle, double open)
{
    uint64_t seed = 5;
    const int n = s->chain.n;
    for (int i = 0; i < n; ++i) {
        const double a = angle * (i - 0.5 * (n - 1));
        vec_store(s->kin.a, i, v3(cos(a), 0, sin(a)));
    }
    scene_join(s, v3(0, 0, 0));
    const double low = s->kin.p[2][n / 2] - s->chain.half[n / 2] * s->kin.a[2][n / 2];
    for (int i = 0; i < n; ++i) {
        vec_store(s->kin.p, i, v3_axpy(v3_sub(vec_load(s->kin.p, i), v3(0, 0, low)), open, fixture_vector(&seed, 1)));
    }
}

/* Straight: the force is the same wherever the roller is, to rounding. */
TEST(test_straight)
{
    TestScene s;
    line_new(&s, 3.1, 1e-3);
    const Pushed seen = line_push(&s, v3(1e-4, 0, 0), 16000);
    check_equal(seen.hits_least, 1);
    check_equal(seen.hits_most, 1);
    check_below(seen.jump, 5e-6 * seen.force_most);
    check_close(s.on_roller[0].z, -2e7 * pow(1e-3, 1.5), 1e-9);
    scene_free(&s);
}

/* Bent to a radius of 25 m, and then with joints open by up to 0.3 mm each way (far more than a cable's
 * shear). */
static void bent_check(double open)
{
    TestScene s[2];
    for (int i = 0; i < 2; ++i) {
        line_new(&s[i], 2.2, 6e-3);
        line_bend(&s[i], 0.02, open);
    }
    const Pushed seen = line_push_twice(&s[0], &s[1], v3(1e-4, 0, 0), 4000);
    check_equal(seen.hits_least, 1);
    check_equal(seen.hits_most, 1);
}
TEST(test_bent) { bent_check(0); }
TEST(test_sheared) { bent_check(3e-4); }

/* The line runs off the roller: with its tail, with its head, or sideways over the rim. */
static void leave_check(double x, Vec3 step, int steps)
{
    TestScene s[2];
    for (int i = 0; i < 2; ++i) line_new(&s[i], x, 1e-3);
    const Pushed seen = line_push_twice(&s[0], &s[1], step, steps);
    check_equal(seen.hits_least, 0);
    check_equal(seen.hits_most, 1);
}
TEST(test_ends)
{
    leave_check(0.1, v3(1e-5, 0, 0), 16000);
    leave_check(3.9, v3(-1e-5, 0, 0), 16000);
}
TEST(test_rim) { leave_check(1.9, v3(0, 1e-5, 0), 30000); }

/* The pulling eye: rope of radius 7 mm in front, then cable. The line is held level, so the roller is pressed
 * in by the difference; the law is soft, to make that bearable. */
TEST(test_eye_climbs)
{
    TestScene s[2];
    for (int i = 0; i < 2; ++i) {
        line_new(&s[i], 3.2, CABLE - ROPE + 5e-4);
        s[i].roller[0].shape.centre.z = -ROLLER - ROPE + 5e-4;
        s[i].model.impact = (ImpactLaw){.k = 2e5, .e = 1.5, .c = 200, .d = 1e-3};
        for (int k = 4; k < 8; ++k) s[i].chain.radius[k] = ROPE;
    }
    const Pushed seen = line_push_twice(&s[0], &s[1], v3(1e-4, 0, 0), 18000);
    check_equal(seen.hits_least, 1);
    check_equal(seen.hits_most, 1);
    check_above(seen.force_most, 1300);
}

/* ------------------------------------------- why the radius does not run linearly */

/* Contact radius of a straight line with the eye between 0 and 0.5 m. */
static double radius_at(double x, int linear)
{
    const double u = fmin(fmax(x / 0.5, 0), 1);
    return CABLE + (ROPE - CABLE) * (linear ? u : u * u * (3 - 2 * u));
}
static double gap_at(double x, double roller, int linear)
{
    return hypot(x - roller, ROLLER + ROPE) - ROLLER - radius_at(x, linear);
}

/* How many local minima the gap has along the line, looked at every 0.1 mm. */
static int minima_count(double roller, int linear)
{
    const double step = 1e-4;
    int count = 0;
    for (double x = -1; x < 1.5; x += step) {
        const double here = gap_at(x, roller, linear);
        count += here < gap_at(x - step, roller, linear) && here <= gap_at(x + step, roller, linear);
    }
    return count;
}

/* With a linear radius the gap's slope jumps at the rope's end of the eye: two minima at once, so that a
 * force that follows one of them must jump. With the cubic there is one. */
TEST(test_linear_radius_doubles)
{
    int doubled = 0;
    for (double roller = 0.35; roller < 0.65; roller += 0.001) {
        doubled += minima_count(roller, 1) == 2;
        assert_int_equal(minima_count(roller, 0), 1);
    }
    check_above(doubled, 5);
    /* With the roller under the rope's end of the eye, the minimum on the eye's arc is deeper than the one at
     * the node by R' s^2/2, for the eye's slope s and R' = roller and rope radius: so much would the gap jump
     * as the arc's nodes change their signs. */
    const double slope = (CABLE - ROPE) / 0.5, both = ROLLER + ROPE;
    const double jump = gap_at(0.5, 0.5, 1) - gap_at(0.5 - slope * both, 0.5, 1);
    check_close(jump, 2.87e-4, 2e-6);
    check_close(jump, both * slope * slope / 2, 0.01 * jump);
}

/* ------------------------------------------- minima against brute force */

/* A centre exactly above the roller (slope exactly 0), and one just before and after: one contact each. */
TEST(test_node_above_roller)
{
    for (int side = -1; side <= 1; ++side) {
        TestScene s;
        line_new(&s, 1.75 + side * 1e-17 + side * 2e-16, 1e-3);
        scene_forces(&s, 1);
        assert_int_equal(s.pairs.n_hits, 1);
        assert_int_equal(s.pairs.active, 1);
        scene_free(&s);
    }
}

/* Least gap over the whole line by sampling. */
static double least_gap(const TestScene *s)
{
    double least = 1e9;
    for (int e = 0; e < element_count(s->model.geometry, s->chain.n); ++e) {
        const Element element = element_at(s->model.geometry, s->chain.n, e);
        for (int i = 0; i <= 2000; ++i) {
            const double u = i / 2000.0;
            const Vec3 p = element_point(&element, &s->chain, &s->kin, u);
            least = smaller_of(least, shape_distance(&s->roller[0].shape, p) - element_radius(&element, &s->chain, u));
        }
    }
    return least;
}

/* Crooked lines past rollers anywhere: the nearest of the hits is the nearest point of the line. */
static void nearest_check(ContactGeometry geometry)
{
    uint64_t seed = 77;
    for (int i = 0; i < 100; ++i) {
        TestScene s;
        scene_new(&s, geometry, 8, 0.5);
        for (int k = 0; k < 8; ++k) {
            s.chain.radius[k] = 0.04 + 0.01 * fixture_random(&seed);
            vec_store(s.kin.a, k, v3_unit(v3_axpy(v3(1, 0, 0), 0.2, fixture_vector(&seed, 1))));
        }
        scene_join(&s, v3(0, 0, 0));
        const Vec3 centre =
            v3(2 + 2.2 * fixture_random(&seed), 0.1 * fixture_random(&seed), 0.3 * fixture_random(&seed));
        const Vec3 axis = v3_unit(v3_axpy(v3(0, 1, 0), 0.5, fixture_vector(&seed, 1)));
        scene_roller(&s, centre, axis, 0.05, 0.2);
        scene_refresh(&s);
        ContactDetail hit[SCENE_HITS_MAX];
        const int hits = contact_details(&s.model, &s.chain, &s.kin, 1, &s.pairs, SCENE_HITS_MAX, hit);
        double least = 1e9;
        for (int h = 0; h < hits; ++h) least = smaller_of(least, hit[h].gap);
        const double sampled = least_gap(&s);
        /* lines through the roller mean nothing, and capsules that do not touch are not looked at */
        if (sampled > -0.03 && (geometry == GEOMETRY_SMOOTH || sampled < 0)) {
            check_at_most(least, sampled + 1e-9);
            check_above(least, sampled - 1e-5);
        }
        scene_free(&s);
    }
}
TEST(test_hits_hold_the_nearest)
{
    nearest_check(GEOMETRY_SMOOTH);
    nearest_check(GEOMETRY_CYLINDER);
}

/* Closed joints: the arc is the quadratic Bezier curve whose control point is the joint. */
TEST(test_arc_is_bezier)
{
    TestScene s;
    line_new(&s, 2, 1e-3);
    line_bend(&s, 0.1, 0);
    const Element arc = element_at(GEOMETRY_SMOOTH, 8, 4);
    const Vec3 a = vec_load(s.kin.p, 3), c = vec_load(s.kin.p, 4);
    const Vec3 b = v3_axpy(a, s.chain.half[3], vec_load(s.kin.a, 3));
    for (double u = 0; u <= 1; u += 0.125) {
        const Vec3 bezier = v3_axpy(v3_axpy(v3_scale((1 - u) * (1 - u), a), 2 * u * (1 - u), b), u * u, c);
        check_vec(bezier, element_point(&arc, &s.chain, &s.kin, u), 1e-15);
    }
    scene_free(&s);
}

/* ------------------------------------------- capsules */

/* Under a joint of a straight line both capsules touch: the force is twice that under a segment's middle, as
 * in the programs that the paper's model was made with. */
TEST(test_capsules_double_at_joints)
{
    double force[2];
    for (int i = 0; i < 2; ++i) {
        TestScene s;
        scene_new(&s, GEOMETRY_CYLINDER, 8, 0.5);
        scene_roller(&s, v3(2 + 0.25 * i, 0, -ROLLER - CABLE + 1e-3), v3(0, 1, 0), ROLLER, 0.2);
        scene_refresh(&s);
        scene_forces(&s, 0);
        assert_int_equal(s.pairs.active, 2 - i);
        force[i] = -s.on_roller[0].z;
        scene_free(&s);
    }
    check_close(force[0], 2 * force[1], 1e-13 * force[0]);
}

/* The slope of the way from p: a product of the place and the axis of each segment, the first and the last too; before
 * the first it falls, behind the last it rises. */
TEST(test_slope)
{
    TestScene s;
    line_new(&s, 3.1, 1e-3);
    line_bend(&s, 0.1, 1e-3);
    const Vec3 p = v3(0.3, -0.2, 0.1);
    assert_true(line_slope(&s.chain, &s.kin, -1, p) < 0);
    assert_true(line_slope(&s.chain, &s.kin, s.chain.n, p) > 0);
    for (int i = 0; i < s.chain.n; ++i) {
        const Vec3 way = v3_sub(vec_load(s.kin.p, i), p);
        check_close(line_slope(&s.chain, &s.kin, i, p), v3_dot(way, vec_load(s.kin.a, i)), 1e-15);
    }
    scene_free(&s);
}

/* A foot just at a node is one element's only, and what is before the line or behind it is held at its ends. */
TEST(test_foot_at_nodes)
{
    enum { SEGMENTS = 5 };
    TestScene s;
    scene_new(&s, GEOMETRY_SMOOTH, SEGMENTS, 0.5);
    for (int node = 0; node < SEGMENTS; ++node) {
        const Vec3 p = v3(0.25 + 0.5 * node, 0.3, -0.1);
        int owners = 0;
        for (int e = 0; e <= SEGMENTS; ++e) {
            int inside;
            const double v = line_foot(&s.chain, &s.kin, e, p, &inside);
            owners += inside;
            assert_int_equal(inside, e == node);
            check_equal(v, e <= node ? 1 : 0);
        }
        assert_int_equal(owners, 1);
    }
    for (int head = 0; head < 2; ++head) {
        int inside;
        check_equal(line_foot(&s.chain, &s.kin, head ? SEGMENTS : 0, v3(head ? 2.7 : -0.2, 0.1, 0), &inside), head);
        assert_false(inside);
    }
    scene_free(&s);
}

/* A foot is where the line runs at right angles to what points at it; sharply bent, and seen from near its centre of
 * curvature, Newton's method would leave the element. */
TEST(test_foot_where_bent)
{
    enum { SEGMENTS = 4 };
    TestScene s;
    int feet = 0;
    double worst = 0;
    scene_new(&s, GEOMETRY_SMOOTH, SEGMENTS, 0.5);
    line_bend(&s, 1, 0);
    for (int k = 0; k < 40 * 40; ++k) {
        const Vec3 p = v3(-0.5 + 0.05 * (k % 40), 0.01, -0.2 + 0.05 * (k / 40));
        for (int e = 1; e < SEGMENTS; ++e) {
            int inside;
            if (!(line_slope(&s.chain, &s.kin, e - 1, p) < 0 && line_slope(&s.chain, &s.kin, e, p) >= 0)) continue;
            const LineSpot at = line_spot(&s.chain, &s.kin, e, line_foot(&s.chain, &s.kin, e, p, &inside));
            assert_true(inside);
            worst = larger_of(worst, fabs(v3_dot(v3_sub(at.p, p), at.p1)));
            ++feet;
        }
    }
    print_message("%d feet\n", feet);
    check_at_least(feet, 100);
    check_at_most(worst, 1e-12);
    scene_free(&s);
}
