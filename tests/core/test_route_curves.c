/* Curves of a route: position against independent integrals, joints, curvature against differences, closed forms of the
 * helix, the clothoid and the parabola; lines made of slopes, points, plan and profile; large coordinates. */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/route.h"
#include "core/vec3.h"
#include "tests/support/check.h"

static const double DEGREE = M_PI / 180;

static RoutePieceDef clothoid(double length, double k0, double k1)
{
    return (RoutePieceDef){.kind = ROUTE_CURVE, .length = length, .curvature = {k0, k1}, .upright = 1};
}

/* Every kind of curve, on a grade, after one another. */
static Route all_kinds(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 4},
        clothoid(6, 0, 0.2),
        clothoid(15, 0.2, 0.2), /* a helix */
        clothoid(9, 0.2, -0.1),
        {.kind = ROUTE_CURVE, .length = 7, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = -0.3},
        {.kind = ROUTE_CURVE,
         .length = 5,
         .upright = 1,
         .profile = PROFILE_ARC,
         .slope_end = 0.4,
         .curvature = {-0.1, 0.1}},
        {.kind = ROUTE_CURVE,
         .length = 8,
         .upright = 1,
         .profile = PROFILE_PARABOLA,
         .slope_end = 0,
         .curvature = {0.1, 0}},
        {.kind = ROUTE_CURVE, .length = 3, .plane = 1.2, .curvature = {0, 0.5}},
        {.kind = ROUTE_BEND, .radius = 2, .angle = 0.4, .plane = 1.2},
    };
    Route route;
    assert_int_equal(route_build(&route, sizeof def / sizeof *def, def, v3(1, -2, 3), 0.3, 0.2, NULL), HAWSER_OK);
    return route;
}

/* Simpson's integral of the tangent over each piece, and of the curvature, against position and tangent at its end. */
TEST(positions_are_the_tangents_integral)
{
    Route r = all_kinds();
    enum { N = 4000 };
    for (int i = 0; i < r.n; ++i) {
        const RoutePiece *const p = &r.piece[i];
        const double h = p->length / N;
        Vec3 way = V3_ZERO, turn = V3_ZERO;
        for (int k = 0; k <= N; ++k) {
            const RoutePoint at = route_on_piece(&r, i, p->s0 + k * h);
            const double by = (k == 0 || k == N ? 1 : k % 2 ? 4 : 2) * h / 3;
            way = v3_axpy(way, by, at.tangent);
            turn = v3_axpy(turn, by, at.curvature);
        }
        const RoutePoint end = route_on_piece(&r, i, p->s0 + p->length);
        check_vec(v3_add(p->start, way), end.position, 1e-11);
        check_vec(v3_add(p->tangent, turn), end.tangent, 1e-11);
        if (i + 1 < r.n) {
            check_vec(r.piece[i + 1].start, end.position, 1e-13);
            check_vec(r.piece[i + 1].tangent, end.tangent, 1e-14);
        }
    }
    route_clear(&r);
}

TEST(derivatives_match_differences)
{
    Route r = all_kinds();
    const double h = 1e-4;
    for (double s = 0.0137; s < r.length; s += 0.0937) {
        const RoutePoint a = route_at(&r, s - h), at = route_at(&r, s), b = route_at(&r, s + h);
        check_close(v3_norm(at.tangent), 1, 1e-15);
        check_close(v3_dot(at.tangent, at.curvature), 0, 1e-15);
        check_close(route_turn(&r, s), v3_norm(at.curvature), 1e-14);
        if (a.piece != b.piece) continue;
        check_vec(v3_scale(0.5 / h, v3_sub(b.position, a.position)), at.tangent, 1e-9);
        check_vec(v3_scale(0.5 / h, v3_sub(b.tangent, a.tangent)), at.curvature, 1e-9);
    }
    for (int i = 0; i < r.n; ++i) {
        double least = INFINITY;
        for (int k = 0; k <= 1000; ++k) {
            const RoutePoint at = route_on_piece(&r, i, r.piece[i].s0 + r.piece[i].length * k / 1000);
            least = fmin(least, 1 / v3_norm(at.curvature));
        }
        if (r.piece[i].kind >= ROUTE_CURVE) check_close(r.piece[i].radius / least, 1, 1e-4);
    }
    route_clear(&r);
}

/* Radius in space R/cos^2, height and heading in proportion to the length. */
TEST(helix_keeps_its_grade)
{
    const double R = 30, grade = 6 * DEGREE, turn = M_PI / 2;
    const RoutePieceDef def = clothoid(R * turn, 1 / R, 1 / R);
    Route r;
    assert_int_equal(route_build(&r, 1, &def, V3_ZERO, 0, grade, NULL), HAWSER_OK);
    check_close(r.length, R * turn / cos(grade), 1e-13);
    check_close(r.piece[0].radius, R / (cos(grade) * cos(grade)), 1e-12);
    check_close(r.piece[0].angle, turn * cos(grade), 1e-12);
    for (int k = 0; k <= 20; ++k) {
        const double a = turn * k / 20;
        const RoutePoint at = route_on_piece(&r, 0, r.length * k / 20);
        check_vec(at.position, v3(R * sin(a), R * (1 - cos(a)), R * a * tan(grade)), 2e-14 * R);
        check_close(route_slope(&r, r.length * k / 20), grade, 1e-15);
    }
    double before, after;
    assert_int_equal(route_grade_lost(&r, 1e-9, &before, &after), -1);
    route_clear(&r);
}

/* Fresnel's integrals by their power series. */
TEST(clothoid_is_fresnels)
{
    const double L = 20, k1 = 1.0 / 12;
    const RoutePieceDef def = clothoid(L, 0, k1);
    Route r;
    assert_int_equal(route_build(&r, 1, &def, V3_ZERO, 0, 0, NULL), HAWSER_OK);
    for (int i = 1; i <= 10; ++i) {
        const double s = L * i / 10, q = k1 * s * s / (2 * L);
        double x = 0, y = 0, term = 1;
        for (int n = 0; n < 30; ++n) {
            (n % 2 ? &y : &x)[0] += (n / 2 % 2 ? -1 : 1) * term / (2 * n + 1);
            term *= q / (n + 1);
        }
        check_vec(route_at(&r, s < L ? s : L).position, v3(s * x, s * y, 0), 1e-13 * L);
    }
    check_close(route_on_piece(&r, 0, L).curvature.x, -sin(k1 * L / 2) * k1, 1e-15);
    route_clear(&r);
}

/* Height a square of the level length, the arc's length by its primitive. */
TEST(parabola_is_one)
{
    const double g = tan(0.3), L = 40, k = (tan(-0.5) - g) / L;
    const RoutePieceDef def = {
        .kind = ROUTE_CURVE, .length = L, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = -0.5};
    Route r;
    assert_int_equal(route_build(&r, 1, &def, V3_ZERO, 0.7, 0.3, NULL), HAWSER_OK);
    const double a = g, b = g + k * L;
    check_close(r.length, (b * hypot(1, b) + asinh(b) - a * hypot(1, a) - asinh(a)) / (2 * k), 1e-12);
    for (int i = 0; i <= 50; ++i) {
        const Vec3 p = route_on_piece(&r, 0, r.length * i / 50).position;
        const double u = hypot(p.x, p.y);
        check_close(p.z, u * (g + k * u / 2), 1e-13 * L);
        check_close(p.y, u * sin(0.7), 1e-13 * L);
    }
    check_close(route_slope(&r, r.length), -0.5, 1e-14);
    route_clear(&r);
}

/* A parabola between equal grades is a straight grade, alone and behind pieces that have knots. It was looked up among
 * knots that it does not have. */
TEST(parabola_of_no_rise)
{
    const double grades[] = {0, 0.3, -0.5}, bends[] = {0, 0.05};
    for (int k = 0; k < 6; ++k) {
        const double grade = grades[k % 3], bend = bends[k / 3];
        const RoutePieceDef def[] = {
            {.kind = ROUTE_CURVE, .length = 7, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = grade},
            {.kind = ROUTE_CURVE,
             .length = 20,
             .curvature = {bend, bend},
             .upright = 1,
             .profile = PROFILE_PARABOLA,
             .slope_end = grade},
            {.kind = ROUTE_STRAIGHT, .length = 5}};
        for (int first = 0; first < 2; ++first) {
            Route r;
            const double begins = first ? grade : 0.1;
            assert_int_equal(route_build(&r, 3 - first, def + first, V3_ZERO, 0.7, begins, NULL), HAWSER_OK);
            const int it = 1 - first;
            check_close(r.piece[it].length, 20 / cos(grade), 1e-13);
            const double at = r.piece[it].s0;
            const Vec3 from = route_on_piece(&r, it, at).position;
            const Vec3 to = route_on_piece(&r, it, at + r.piece[it].length).position;
            check_close(to.z - from.z, 20 * tan(grade), 1e-13);
            check_close(hypot(to.x - from.x, to.y - from.y), bend > 0 ? 2 / bend * sin(20 * bend / 2) : 20, 1e-13);
            check_close(route_slope(&r, r.length), grade, 1e-14);
            assert_string_equal(route_piece_word(&r.piece[it]), bend > 0 ? "helix" : "straight");
            route_clear(&r);
        }
    }
}

/* A shaft, a level, a ramp: rounded, the ends stay where the corners put them, less what a bend leaves to one side. */
TEST(slopes_are_rounded)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 20},
                                 {.kind = ROUTE_STRAIGHT, .length = 30, .sloped = 1, .slope = 0},
                                 {.kind = ROUTE_STRAIGHT, .length = 10, .sloped = 1, .slope = 10 * DEGREE},
                                 {.kind = ROUTE_STRAIGHT, .length = 25, .sloped = 1, .slope = M_PI / 2}};
    RouteLine line;
    Route r;
    hawser_error err;
    assert_int_equal(route_round_slopes(4, def, 0.4, -M_PI / 2, 3, &line, &err), HAWSER_OK);
    assert_int_equal(line.n, 7);
    assert_int_equal(route_build(&r, line.n, line.piece, V3_ZERO, line.heading, line.slope, NULL), HAWSER_OK);
    const double level = 30 + 10 * cos(10 * DEGREE);
    const RoutePoint end = route_at(&r, r.length);
    check_vec(end.position, v3(level * cos(0.4), level * sin(0.4), -20 + 10 * sin(10 * DEGREE) + 25), 1e-13);
    check_vec(end.tangent, v3(0, 0, 1), 1e-15);
    check_vec(route_left(&r, 1), v3(-sin(0.4), cos(0.4), 0), 1e-15);
    check_vec(route_left(&r, r.length), v3(-sin(0.4), cos(0.4), 0), 1e-12);
    for (int i = 1; i < r.n; ++i) {
        check_vec(route_on_piece(&r, i - 1, r.length).tangent, r.piece[i].tangent, 1e-15);
    }
    free(line.piece);
    route_clear(&r);
    assert_int_equal(route_round_slopes(4, def, 0, -M_PI / 2, 11, &line, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "too short for the changes of slope"));
    assert_null(line.piece);
}

/* From point to point, an upright leg among them, each corner on its circle. */
TEST(corners_are_rounded)
{
    const RouteCorner c[] = {{v3(0, 0, 0), NAN},  {v3(10, 0, 0), 3},   {v3(10, 10, 2), 4},   {v3(10, 20, 2), 5},
                             {v3(10, 20, 20), 2}, {v3(25, 24, 20), 1}, {v3(30, 30, 30), NAN}};
    RouteLine line;
    Route r;
    assert_int_equal(route_from_corners(7, c, &line, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    check_vec(route_at(&r, r.length).position, c[6].point, 1e-13);
    for (int i = 1; i < 6; ++i) { /* a fillet comes as near to its corner as R (1/cos(turn/2) - 1) */
        double nearest = INFINITY;
        const Vec3 a = v3_unit(v3_sub(c[i].point, c[i - 1].point)), b = v3_unit(v3_sub(c[i + 1].point, c[i].point));
        for (int k = 0; k <= 40000; ++k)
            nearest = fmin(nearest, v3_norm(v3_sub(route_at(&r, r.length * k / 40000).position, c[i].point)));
        check_close(nearest, c[i].radius * (1 / sqrt((1 + v3_dot(a, b)) / 2) - 1), 2e-5); /* of the looks */
    }
    free(line.piece);
    route_clear(&r);
    hawser_error err;
    RouteCorner tight[3] = {c[0], c[1], c[2]};
    tight[1].radius = 11;
    assert_int_equal(route_from_corners(3, tight, &line, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "point 2"));
}

/* Through its points, with curvature that goes on from piece to piece and vanishes at the ends. */
TEST(spline_goes_through)
{
    const Vec3 point[] = {{0, 0, 0}, {10, 2, 0}, {20, 0, 1}, {27, -4, 3}, {40, -4, 2}};
    RouteLine line;
    Route r;
    assert_int_equal(route_from_spline(5, point, &line, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    for (int i = 0; i < 4; ++i) {
        const RoutePoint a = route_on_piece(&r, i, 0), b = route_on_piece(&r, i, r.length);
        check_vec(a.position, point[i], 1e-13);
        check_vec(b.position, point[i + 1], 1e-13);
        if (i == 3) continue;
        const RoutePoint next = route_on_piece(&r, i + 1, 0);
        check_vec(b.tangent, next.tangent, 1e-14);
        check_vec(b.curvature, next.curvature, 1e-14);
    }
    check_close(v3_norm(route_at(&r, 0).curvature), 0, 1e-16);
    check_close(v3_norm(route_on_piece(&r, 3, r.length).curvature), 0, 1e-15);
    free(line.piece);
    route_clear(&r);
}

/* Heights of the profile at its stations whatever the plan does, and the plan's end whatever the profile does; at a UTM
 * place the same to 1e-9 m. */
TEST(plan_and_profile)
{
    const RoutePlanElement plan[] = {
        {"a", 20, {0, 0}}, {"b", 10, {0, -0.04}}, {"c", 15, {-0.04, -0.04}}, {"d", 10, {-0.04, 0}}, {"e", 20, {0, 0}}};
    const RouteProfileCorner corner[] = {{90, 50, 0, 0}, {125, 51, 200, 0}, {150, 49, 0, 10}, {180, 50, 0, 0}};
    RouteProfile profile;
    RouteLine line, level, far;
    Route r, flat, utm;
    const Vec3 start = v3(453000.25, 6712345.5, 0);
    assert_int_equal(route_profile_from_corners(4, corner, 50, &profile, NULL), HAWSER_OK);
    assert_int_equal(route_from_plan_and_profile(5, plan, &profile, 100, V3_ZERO, 0.5, &line, NULL), HAWSER_OK);
    assert_int_equal(route_from_plan_and_profile(5, plan, &profile, 100, start, 0.5, &far, NULL), HAWSER_OK);
    assert_int_equal(route_from_plan_and_profile(5, plan, NULL, 0, V3_ZERO, 0.5, &level, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    assert_int_equal(route_build(&utm, far.n, far.piece, far.start, far.heading, far.slope, NULL), HAWSER_OK);
    assert_int_equal(route_build(&flat, level.n, level.piece, level.start, level.heading, 0, NULL), HAWSER_OK);
    check_close(flat.length, 75, 1e-12);
    check_close(line.start.z, 50 + 10.0 / 35, 1e-13);
    const Vec3 end = route_at(&r, r.length).position, below = route_at(&flat, flat.length).position;
    check_vec(v3(end.x, end.y, 0), v3(below.x, below.y, 0), 1e-12);
    check_close(end.z, 49 + 25.0 / 30, 1e-12);
    for (int i = 1; i < r.n; ++i) check_vec(route_on_piece(&r, i - 1, r.length).tangent, r.piece[i].tangent, 1e-14);
    for (double s = 0; s < r.length; s += 0.77) {
        const Vec3 a = route_at(&r, s).position, b = v3_sub(route_at(&utm, s).position, start);
        check_vec(b, a, 3e-9); /* three roundings of 7e6 m */
        check_vec(route_at(&utm, s).curvature, route_at(&r, s).curvature, 1e-15);
    }
    RouteProfile wrong = profile;
    RouteLine none;
    hawser_error err;
    wrong.n = 2;
    assert_int_equal(route_from_plan_and_profile(5, plan, &wrong, 100, V3_ZERO, 0, &none, &err), HAWSER_ERR_INPUT);
    assert_non_null(strstr(err.message, "the profile reaches from station 90 m"));
    free(profile.element);
    free(line.piece);
    free(level.piece);
    free(far.piece);
    route_clear(&r);
    route_clear(&flat);
    route_clear(&utm);
}

/* Names come along, and who made a piece says so; the same point twice is refused at its place, first or last. */
TEST(names_and_doubles)
{
    const Vec3 point[] = {{0, 0, 0}, {10, 2, 0}, {20, 0, 1}, {27, -4, 3}};
    const RouteCorner corner[] = {{point[0], NAN}, {point[1], 2}, {point[2], 2.5}, {point[3], NAN}};
    RouteLine line;
    Route r;
    hawser_error err;
    assert_int_equal(route_from_spline(4, point, &line, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    assert_int_equal(r.n, 3);
    assert_string_equal(r.piece[2].name, "points 3 to 4");
    check_vec(route_at(&r, 0).tangent, v3_unit(line.piece[0].cubic[0]), 1e-14);
    free(line.piece);
    route_clear(&r);
    assert_int_equal(route_from_corners(4, corner, &line, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    assert_int_equal(r.n, 5);
    assert_string_equal(r.piece[0].name, "");
    assert_string_equal(r.piece[1].name, "point 2");
    assert_string_equal(r.piece[3].name, "point 3");
    free(line.piece);
    route_clear(&r);
    for (int k = 1; k < 4; ++k) {
        Vec3 twice[4];
        RouteCorner twice_corner[4];
        char said[64];
        for (int i = 0; i < 4; ++i) {
            twice[i] = point[i < k ? i : i - 1];
            twice_corner[i] = (RouteCorner){twice[i], 1};
        }
        snprintf(said, sizeof said, "the points %d and %d are the same", k, k + 1);
        assert_int_equal(route_from_spline(4, twice, &line, &err), HAWSER_ERR_INPUT);
        check_has(err.message, said);
        assert_int_equal(route_from_corners(4, twice_corner, &line, &err), HAWSER_ERR_INPUT);
        check_has(err.message, said);
    }
    /* legs that the fillets beside them just fill: no straight is left between */
    const RouteCorner square[] = {{v3(0, 0, 0), NAN}, {v3(3, 0, 0), 3}, {v3(3, 6, 0), 3}, {v3(0, 6, 0), NAN}};
    assert_int_equal(route_from_corners(4, square, &line, NULL), HAWSER_OK);
    assert_int_equal(line.n, 2);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    check_close(r.length, 3 * M_PI, 1e-12);
    check_vec(route_at(&r, r.length).position, v3(0, 6, 0), 1e-12);
    free(line.piece);
    route_clear(&r);
}

/* A plan that begins behind the profile's first elements, in level and in rising ground, with circles to both sides:
 * heights by the profile alone, places by the circles. */
TEST(plan_begins_further_on)
{
    const RoutePlanElement plan[] = {{"left", 10, {0.05, 0.05}}, {"on", 12, {0, 0}}, {"right", 8, {-0.04, -0.04}}};
    const RouteProfileCorner corner[] = {{0, 7, 0, 0}, {40, 7, 0, 0}, {60, 9, 0, 0}, {100, 9, 0, 0}};
    static const double begin[] = {0, 5, 33, 45, 62, 70};
    RouteProfile profile;
    hawser_error err;
    assert_int_equal(route_profile_from_corners(4, corner, 20, &profile, &err), HAWSER_OK);
    for (int k = 0; k < 6; ++k) {
        RouteLine line;
        Route r;
        assert_int_equal(route_from_plan_and_profile(3, plan, &profile, begin[k], V3_ZERO, 0, &line, &err), HAWSER_OK);
        assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
        const Vec3 end = route_at(&r, r.length).position;
        /* from (0, 0): 0.5 rad on 20 m, straight, -0.32 rad on 25 m */
        const double a = 0.5, b = 0.32;
        const double x = 20 * sin(a) + 12 * cos(a) + 25 * (sin(a) - sin(a - b));
        const double y = 20 * (1 - cos(a)) + 12 * sin(a) + 25 * (cos(a - b) - cos(a));
        check_vec(v3(end.x, end.y, 0), v3(x, y, 0), 1e-11);
        for (int at = 0; at < 2; ++at) {
            const double station = begin[k] + 30 * at, z = at ? end.z : line.start.z;
            const double ramp = station < 50 ? fmax(0, station - 40) : 20 - fmax(0, 60 - station);
            const double far = fmin(fabs(station - 40), fabs(station - 60)); /* beyond the roundings, 1 m long */
            if (far > 1.1) check_close(z, 7 + 0.1 * ramp, 1e-11);
        }
        if (begin[k] >= 62) assert_int_equal(r.piece[0].kind, ROUTE_BEND);
        free(line.piece);
        route_clear(&r);
    }
    free(profile.element);
}
