/* Routes: continuity, arc length, curvature against finite differences, planes of bends, s beyond the ends.
 */
#include "core/route.h"
#include "tests/support/check.h"

static const double PI = 3.14159265358979323846;

static RoutePieceDef straight(double length) { return (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length}; }

static RoutePieceDef bend(double radius, double angle, double plane)
{
    return (RoutePieceDef){.kind = ROUTE_BEND, .radius = radius, .angle = angle, .plane = plane};
}

/* Bends in all planes, on slopes, an S in three dimensions, through the vertical and back. */
static Route winding_route(void)
{
    const RoutePieceDef def[] = {
        straight(4),
        bend(6, 0.5, 0),
        bend(3, 0.7, PI / 2),
        straight(2),
        bend(5, 1.1, PI),
        bend(2.5, 0.9, 3 * PI / 2),
        bend(4, 0.8, 0.6),
        bend(4, 0.8, 0.6 + PI),
        bend(10, 0.3, -2.2),
        straight(1.5),
        bend(3, 2 * PI / 3, PI / 2),
        bend(3, 2, 1.3),
    };
    Route route;
    assert_int_equal(route_build(&route, sizeof def / sizeof *def, def, v3(1, -2, 3), 0.3, 0.2, NULL), HAWSER_OK);
    return route;
}

TEST(starts_as_told)
{
    Route r = winding_route();
    const RoutePoint at = route_at(&r, 0);
    check_vec(at.position, v3(1, -2, 3), 0);
    check_vec(at.tangent, v3(cos(0.2) * cos(0.3), cos(0.2) * sin(0.3), sin(0.2)), 1e-16);
    check_close(route_slope(&r, 0), 0.2, 1e-15);
    check_close(r.length, 4 + 3 + 2.1 + 2 + 5.5 + 2.25 + 3.2 + 3.2 + 3 + 1.5 + 2 * PI + 6, 1e-12);
    route_clear(&r);
    assert_null(r.piece);
}

TEST(is_continuous_with_its_tangent)
{
    Route r = winding_route();
    for (int i = 1; i < r.n; i++) {
        const double s = r.piece[i].s0, e = 1e-9;
        const RoutePoint a = route_at(&r, s - e), b = route_at(&r, s + e);
        assert_int_equal(a.piece, i - 1);
        assert_int_equal(b.piece, i);
        assert_int_equal(route_at(&r, s).piece, i);
        check_vec(b.position, v3_axpy(a.position, 2 * e, a.tangent), 1e-14);
        check_vec(b.tangent, a.tangent, 1e-9);
    }
    route_clear(&r);
}

TEST(derivatives_match_differences)
{
    Route r = winding_route();
    const double h = 1e-4;
    for (double s = -2.013; s < r.length + 2; s += 0.0937) {
        const RoutePoint a = route_at(&r, s - h), at = route_at(&r, s), b = route_at(&r, s + h);
        check_close(v3_norm(at.tangent), 1, 1e-15);
        check_close(v3_dot(at.tangent, at.curvature), 0, 1e-15);
        check_close(route_turn(&r, s), v3_norm(at.curvature), 1e-14);
        if (a.piece != b.piece || (s - h) * (s + h) < 0) continue;
        check_vec(v3_scale(0.5 / h, v3_sub(b.position, a.position)), at.tangent, 1e-9);
        check_vec(v3_scale(0.5 / h, v3_sub(b.tangent, a.tangent)), at.curvature, 1e-9);
    }
    route_clear(&r);
}

TEST(goes_on_straight_beyond_its_ends)
{
    Route r = winding_route();
    const RoutePoint first = route_at(&r, 0), last = route_at(&r, r.length);
    const RoutePoint before = route_at(&r, -7), after = route_at(&r, r.length + 7);
    check_vec(before.position, v3_axpy(first.position, -7, first.tangent), 1e-14);
    check_vec(after.position, v3_axpy(last.position, 7, last.tangent), 1e-13);
    check_vec(before.tangent, first.tangent, 0);
    check_vec(after.tangent, last.tangent, 0);
    check_equal(v3_norm(before.curvature), 0);
    check_equal(v3_norm(after.curvature), 0);
    assert_int_equal(before.piece, 0);
    assert_int_equal(after.piece, r.n - 1);
    route_clear(&r);
}

/* A quarter turn from heading x in each plane: where it ends and where it then points. */
TEST(planes_mean_what_they_say)
{
    const Vec3 toward[] = {v3(0, 1, 0), v3(0, 0, 1), v3(0, -1, 0), v3(0, 0, -1)};
    for (int k = 0; k < 4; k++) {
        const RoutePieceDef def = bend(2, PI / 2, k * PI / 2);
        Route r;
        assert_int_equal(route_build(&r, 1, &def, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
        check_vec(route_at(&r, r.length).position, v3_scale(2, v3_add(v3(1, 0, 0), toward[k])), 1e-15);
        check_vec(route_at(&r, r.length).tangent, toward[k], 1e-15);
        check_vec(route_at(&r, 0).curvature, v3_scale(0.5, toward[k]), 1e-15);
        route_clear(&r);
    }
}

/* On a slope, a bend with a level centre direction starts without change of slope; an upward bend stays in
 * the vertical plane and changes the slope by its angle. */
TEST(bends_on_slopes)
{
    const RoutePieceDef left = bend(5, 0.4, 0), up = bend(5, 0.4, PI / 2), down = bend(5, 0.7, 3 * PI / 2);
    Route r;
    assert_int_equal(route_build(&r, 1, &left, v3(0, 0, 0), 1.1, 0.3, NULL), HAWSER_OK);
    check_close(r.piece[0].centre.z, 0, 1e-16);
    check_close((route_slope(&r, 1e-5) - 0.3) / 1e-5, 0, 1e-5);
    double before, after;
    assert_int_equal(route_grade_lost(&r, 0.01, &before, &after), 0);
    check_close(before, 0.3, 1e-15);
    check_close(sin(after), sin(0.3) * cos(0.4), 1e-15);
    assert_int_equal(route_grade_lost(&r, 0.1, &before, &after), -1);
    route_clear(&r);
    assert_int_equal(route_build(&r, 1, &up, v3(0, 0, 0), 1.1, 0.3, NULL), HAWSER_OK);
    assert_int_equal(route_grade_lost(&r, 0.01, &before, &after), -1); /* that is what it is for */
    check_close(route_slope(&r, r.length), 0.7, 1e-15);
    check_vec(route_left(&r, r.length), v3(-sin(1.1), cos(1.1), 0), 1e-15);
    route_clear(&r);
    assert_int_equal(route_build(&r, 1, &down, v3(0, 0, 0), 1.1, 0.3, NULL), HAWSER_OK);
    check_close(route_slope(&r, r.length), -0.4, 1e-15);
    route_clear(&r);
}

/* An S in three dimensions: the second bend turns about the parallel axis, so the tangent comes back. */
TEST(s_bend_restores_the_tangent)
{
    const RoutePieceDef def[] = {bend(4, 0.8, 0), bend(4, 0.8, PI)};
    Route r;
    assert_int_equal(route_build(&r, 2, def, v3(0, 0, 0), 0.2, 0, NULL), HAWSER_OK);
    check_vec(route_at(&r, r.length).tangent, route_at(&r, 0).tangent, 1e-15);
    check_vec(r.piece[1].centre,
              v3_scale(-1, v3_axpy(v3_scale(cos(0.8), r.piece[0].centre), -sin(0.8), r.piece[0].tangent)), 1e-15);
    route_clear(&r);
}

/* A shaft: level, quarter turn up, vertical straight, then left and back to level. */
TEST(left_survives_the_vertical)
{
    const RoutePieceDef def[] = {straight(2), bend(3, PI / 2, PI / 2), straight(5), bend(3, PI / 2, 0), straight(1)};
    Route r;
    assert_int_equal(route_build(&r, 5, def, v3(0, 0, 0), 0.5, 0, NULL), HAWSER_OK);
    const Vec3 left = v3(-sin(0.5), cos(0.5), 0);
    for (double s = 0.25; s < r.piece[3].s0; s += 0.25) check_vec(route_left(&r, s), left, 1e-12);
    check_vec(route_left(&r, r.piece[2].s0), left, 1e-14);
    check_vec(route_left(&r, r.piece[2].s0 + 2), left, 1e-14);
    check_vec(route_at(&r, r.length).tangent, left, 1e-14);
    check_close(route_at(&r, r.length).position.z, 3 + 5 + 3, 1e-14);
    route_clear(&r);
}

/* Through the vertical inside one bend: at the top of a loop's side the heading before counts, beyond it is
 * reversed. */
TEST(left_inside_a_bend_through_the_vertical)
{
    const RoutePieceDef def = bend(2, PI, PI / 2);
    Route r;
    assert_int_equal(route_build(&r, 1, &def, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    check_vec(route_left(&r, r.length / 2), v3(0, 1, 0), 1e-12);
    check_vec(route_left(&r, r.length / 2 - 0.1), v3(0, 1, 0), 1e-12);
    check_vec(route_left(&r, r.length), v3(0, -1, 0), 1e-12);
    check_vec(route_at(&r, r.length).position, v3(0, 0, 4), 1e-15);
    route_clear(&r);
}

/* The foot of a point beside the route is the place that the point was made from, before the start and past the end
 * too; a point in front of a bend's centre counts the turn that is near. (R4) */
TEST(foot_of_a_point)
{
    Route r = winding_route();
    for (double s = -3; s < r.length + 3; s += 0.173) {
        const RoutePoint at = route_at(&r, s);
        const Vec3 across = v3_unit(v3_cross(at.tangent, v3(0.3, -0.5, 0.8)));
        for (double guess = s - 1; guess <= s + 1; guess += 0.4) {
            RoutePoint there;
            check_close(route_foot(&r, v3_axpy(at.position, 0.3, across), guess, &there), s, 1e-9);
            check_vec(there.position, at.position, 1e-9);
        }
    }
    route_clear(&r);
    const RoutePieceDef twice[] = {bend(4, 3.5 * PI, 0)};
    assert_int_equal(route_build(&r, 1, twice, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const Vec3 p = v3_scale(1.1, route_at(&r, 2).position);
    const double first = route_foot(&r, p, 3, NULL);
    check_close(route_foot(&r, p, 8 * PI + 1, NULL) - first, 8 * PI, 1e-12);
    route_clear(&r);
}
