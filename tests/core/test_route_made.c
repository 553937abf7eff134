/* Lines made of slopes, points, plan and profile, at their edges: points in a row, legs that are just long enough or
 * not, corners that turn back, roundings of steep profiles, what turns a piece aside, and the knots of curves. */
#include <stdlib.h>

#include "core/route.h"
#include "tests/support/check.h"

static Route route_of(int n, const RoutePieceDef *def, double slope)
{
    Route r;
    assert_int_equal(route_build(&r, n, def, V3_ZERO, 0, slope, NULL), HAWSER_OK);
    return r;
}

/* Points in a row make no bend, whatever radius they have: two straights of what lies between. */
TEST(points_in_a_row)
{
    const RouteCorner row[] = {{v3(1, 2, 3), NAN}, {v3(5, 2, 3), 7}, {v3(11, 2, 3), NAN}};
    RouteLine line;
    hawser_error err;
    assert_int_equal(route_from_corners(3, row, &line, &err), HAWSER_OK);
    assert_int_equal(line.n, 2);
    for (int i = 0; i < 2; ++i) {
        assert_int_equal(line.piece[i].kind, ROUTE_STRAIGHT);
        check_share(line.piece[i].length, i ? 6 : 4, 1e-15);
    }
    check_equal(line.heading, 0);
    check_equal(line.slope, 0);
    check_vec(line.start, v3(1, 2, 3), 0);
    free(line.piece);
}

/* A right angle of radius 3 takes 3 m of either leg: less is refused on either side, with the lengths; just as much is
 * a bend that begins or ends at the line's end. */
TEST(legs_that_are_too_short)
{
    static const struct {
        double before, after;
        int fits, pieces;
        const char *said;
    } legs[] = {{10, 1, 0, 0, "which takes 3 m on either side: the legs are 10 m (0 m of it taken) and 1 m long"},
                {1, 10, 0, 0, "which takes 3 m on either side: the legs are 1 m (0 m of it taken) and 10 m long"},
                {10, 3, 1, 2, NULL},
                {3, 10, 1, 2, NULL},
                {4, 5, 1, 3, NULL}};
    for (int k = 0; k < 5; ++k) {
        const double a = legs[k].before, b = legs[k].after;
        const RouteCorner corner[] = {{V3_ZERO, NAN}, {v3(a, 0, 0), 3}, {v3(a, b, 0), NAN}};
        RouteLine line;
        hawser_error err;
        assert_int_equal(route_from_corners(3, corner, &line, &err), legs[k].fits ? HAWSER_OK : HAWSER_ERR_INPUT);
        if (!legs[k].fits) {
            check_has(err.message, "the points beside point 2 are too near for a radius of 3 m");
            check_has(err.message, legs[k].said);
            assert_null(line.piece);
            continue;
        }
        assert_int_equal(line.n, legs[k].pieces);
        Route r = route_of(line.n, line.piece, 0);
        check_share(r.length, a + b - 6 + 1.5 * M_PI, 1e-14);
        check_vec(route_at(&r, r.length).position, v3(a, b, 0), 1e-13);
        free(line.piece);
        route_clear(&r);
    }
    /* two corners share a leg of 8 m: 3 m and 5 m of it fit, 3 m and 6 m do not */
    for (int k = 0; k < 2; ++k) {
        const RouteCorner corner[] = {
            {V3_ZERO, NAN}, {v3(10, 0, 0), 3}, {v3(10, 8, 0), k ? 6 : 5}, {v3(20, 8, 0), NAN}};
        RouteLine line;
        hawser_error err;
        assert_int_equal(route_from_corners(4, corner, &line, &err), k ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (k) check_has(err.message, "the legs are 8 m (3 m of it taken) and 10 m long");
        if (!k) check_share(line.piece[line.n - 1].length, 5, 1e-14);
        free(line.piece);
    }
}

/* A corner that turns back by more than pi - 1e-3 is refused by the numbers of its points; one by a little less is not.
 */
TEST(corners_that_turn_back)
{
    for (int k = 0; k < 2; ++k) {
        const double off = k ? 0.9e-3 : 1.1e-3; /* of half a turn, rad */
        const RouteCorner corner[] = {{V3_ZERO, NAN},
                                      {v3(4, 0, 0), 1},
                                      {v3(4, 50, 0), 1e-3},
                                      {v3(4 + 20 * sin(off), 50 - 20 * cos(off), 0), NAN}};
        RouteLine line;
        hawser_error err;
        assert_int_equal(route_from_corners(4, corner, &line, &err), k ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (k) check_has(err.message, "the points 2 to 4 turn back on themselves");
        free(line.piece);
    }
}

/* A line that begins upright has heading 0, and its first bend goes where the points go. */
TEST(lines_that_begin_upright)
{
    const RouteCorner corner[] = {{V3_ZERO, NAN}, {v3(0, 0, 10), 2}, {v3(0, -7, 10), NAN}};
    RouteLine line;
    assert_int_equal(route_from_corners(3, corner, &line, NULL), HAWSER_OK);
    check_equal(line.heading, 0);
    check_share(line.slope, M_PI / 2, 1e-15);
    Route r = route_of(line.n, line.piece, line.slope);
    check_vec(route_at(&r, r.length).position, v3(0, -7, 10), 1e-13);
    check_vec(route_at(&r, r.length).tangent, v3(0, -1, 0), 1e-13);
    free(line.piece);
    route_clear(&r);
}

/* Roundings of a steep profile: an arc between slopes a and b takes R tan(|b - a|/2) of either grade, so its level
 * lengths before and behind the corner are that by the cosines; heights at the stations are the profile's. */
TEST(roundings_of_steep_profiles)
{
    const double R = 12, a = 0.2, b = 1.1, run = 30, on = 25;
    const RouteProfileCorner corner[] = {
        {100, 5, 0, 0}, {100 + run, 5 + run * tan(a), 0, 0}, {100 + run + on, 5 + run * tan(a) + on * tan(b), 0, 0}};
    RouteProfile p;
    assert_int_equal(route_profile_from_corners(3, corner, R, &p, NULL), HAWSER_OK);
    const double off = R * tan((b - a) / 2);
    assert_int_equal(p.n, 3);
    check_share(p.element[0].length, run - off * cos(a), 1e-14);
    check_share(p.element[1].length, off * (cos(a) + cos(b)), 1e-14);
    check_share(p.element[2].length, on - off * cos(b), 1e-14);
    assert_int_equal(p.element[1].kind, PROFILE_ARC);
    const double slopes[3][2] = {{a, a}, {a, b}, {b, b}};
    for (int i = 0; i < 3; ++i) {
        for (int k = 0; k < 2; ++k) check_share(p.element[i].slope[k], slopes[i][k], 1e-14);
    }
    /* the line along it ends where the profile does, and an arc that is upright is a bend of this radius */
    const RoutePlanElement plan = {"plan", run + on, {0, 0}};
    RouteLine line;
    assert_int_equal(route_from_plan_and_profile(1, &plan, &p, 100, V3_ZERO, 0, &line, NULL), HAWSER_OK);
    Route r = route_of(line.n, line.piece, line.slope);
    assert_int_equal(r.n, 3);
    check_share(r.piece[1].radius, R, 1e-13);
    check_share(r.piece[1].angle, b - a, 1e-13);
    const Vec3 end = route_at(&r, r.length).position;
    check_close(end.x, run + on, 1e-12);
    check_close(line.start.z + end.z, corner[2].height, 1e-12);
    free(line.piece);
    free(p.element);
    route_clear(&r);
    /* what the first rounding leaves of a grade is what the second may take */
    const RouteProfileCorner near[] = {{0, 0, 0, 0}, {20, 0, 0, 10}, {29, 3, 0, 8}, {60, 0, 0, 0}};
    hawser_error err;
    assert_int_equal(route_profile_from_corners(4, near, R, &p, &err), HAWSER_OK); /* 5 m and 4 m of 9 m */
    assert_int_equal(p.n, 4);
    check_share(p.element[1].length, 10, 1e-14);
    check_share(p.element[2].length, 8, 1e-14);
    check_share(p.element[3].length, 27, 1e-14);
    assert_int_equal(p.element[2].kind, PROFILE_PARABOLA);
    free(p.element);
    const RouteProfileCorner nearer[] = {{0, 0, 0, 0}, {20, 0, 0, 10}, {29, 3, 0, 9}, {60, 0, 0, 0}};
    assert_int_equal(route_profile_from_corners(4, nearer, R, &p, &err), HAWSER_ERR_INPUT);
    assert_string_equal(err.message, "the profile between points 2 and 3, 9 m, is too short for the roundings at its "
                                     "ends, which take 9.5 m");
    assert_null(p.element);
    const RouteProfileCorner back[] = {{0, 0, 0, 0}, {20, 0, 0, 0}, {20, 3, 0, 0}};
    assert_int_equal(route_profile_from_corners(3, back, R, &p, &err), HAWSER_ERR_INPUT);
    assert_string_equal(err.message, "the stations of profile points 2 and 3 do not rise");
}

/* A piece turns aside if its plan does: cubics by either of their two turns, curves by either end's curvature, curves
 * that lie in a plane of their own unless that stands upright. */
TEST(what_turns_aside)
{
    static const struct {
        RoutePieceDef def;
        int aside;
    } row[] = {
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, 1},
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 0, 0}, {0, 1, 0}}}, 1},
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 1, 0}, {0, -1, 0}}}, 1},
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 1, 0}, {0, -2, 0}}}, 1},
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {1, 0, 2}, {0, 0, -1}}}, 0},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .curvature = {0.1, 0.1}}, 1},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .curvature = {0.1, 0}}, 1},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .curvature = {0, -0.1}}, 1},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = 0.3}, 0},
        {{.kind = ROUTE_CURVE, .length = 9, .plane = 0, .curvature = {0.1, 0.2}}, 1},
        {{.kind = ROUTE_CURVE, .length = 9, .plane = M_PI / 2, .curvature = {0.1, 0.2}}, 0},
        {{.kind = ROUTE_BEND, .radius = 9, .angle = 0.3, .plane = M_PI / 2}, 0},
        {{.kind = ROUTE_BEND, .radius = 9, .angle = 0.3, .plane = 1.5}, 1},
        {{.kind = ROUTE_STRAIGHT, .length = 9}, 0},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        Route r = route_of(1, &row[k].def, 0.1);
        assert_int_equal(route_turns_aside(&r.piece[0]), row[k].aside);
        route_clear(&r);
    }
}

/* What is one turn: a bend that is cut, and a clothoid; not other radii, planes or kinds, nor straights. */
TEST(turns_in_parts)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 9};
    const RoutePieceDef left = {.kind = ROUTE_BEND, .radius = 9, .angle = 0.3};
    const RoutePieceDef wide = {.kind = ROUTE_BEND, .radius = 9.001, .angle = 0.3};
    const RoutePieceDef right = {.kind = ROUTE_BEND, .radius = 9.001, .angle = 0.3, .plane = M_PI};
    const RoutePieceDef in = {.kind = ROUTE_CURVE, .length = 9, .curvature = {0, 0.1}};
    const RoutePieceDef on = {.kind = ROUTE_CURVE, .length = 9, .curvature = {0.1, 0.2}};
    const RoutePieceDef def[] = {straight, straight, left, left, left, wide, right, in, on, on, straight};
    static const int last[] = {0, 1, 4, 4, 4, 5, 6, 8, 8, 9, 10};
    enum { PIECES = sizeof def / sizeof *def };
    Route r = route_of(PIECES, def, 0);
    for (int p = 0; p < PIECES; ++p) assert_int_equal(route_turn_end(&r, p), last[p]);
    route_clear(&r);
}

/* Every word of a table for a piece. */
TEST(words_of_pieces)
{
    static const struct {
        RoutePieceDef def;
        const char *word;
    } row[] = {
        {{.kind = ROUTE_STRAIGHT, .length = 9}, "straight"},
        {{.kind = ROUTE_BEND, .radius = 9, .angle = 0.3}, "bend"},
        {{.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 1, 0}, {0, 0, 0}}}, "cubic"},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .curvature = {0.1, 0.1}}, "helix"},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .curvature = {0.1, 0.2}}, "clothoid"},
        {{.kind = ROUTE_CURVE,
          .length = 9,
          .upright = 1,
          .curvature = {0.1, 0.2},
          .profile = PROFILE_ARC,
          .slope_end = 0.3},
         "curve"},
        {{.kind = ROUTE_CURVE,
          .length = 9,
          .upright = 1,
          .curvature = {0.1, 0.1},
          .profile = PROFILE_ARC,
          .slope_end = 0.3},
         "curve"},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .profile = PROFILE_ARC, .slope_end = 0.3}, "vertical arc"},
        {{.kind = ROUTE_CURVE, .length = 9, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = 0.3}, "parabola"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        Route r = route_of(1, &row[k].def, 0.1);
        assert_string_equal(route_piece_word(&r.piece[0]), row[k].word);
        route_clear(&r);
    }
}

/* Legs that rise steeply and then stand upright, or lie at 45 degrees before they do: whichever way is left there, the
 * line goes on through the points. */
TEST(legs_that_become_upright)
{
    static const double slopes[] = {20, 45, 60, 80, -30, -45, -70};
    for (int k = 0; k < 7; ++k) {
        const double a = slopes[k] * M_PI / 180, up = a > 0 ? 1 : -1;
        const Vec3 foot = v3(30 * cos(a), 0, 30 * sin(a)), top = v3_add(foot, v3(0, 0, up * 30));
        for (int way = 0; way < 4; ++way) {
            const Vec3 on = v3(30 * cos(way * M_PI / 2 + 0.2), 30 * sin(way * M_PI / 2 + 0.2), 0);
            const RouteCorner corner[] = {{V3_ZERO, NAN}, {foot, 3}, {top, 3}, {v3_add(top, on), NAN}};
            RouteLine line;
            assert_int_equal(route_from_corners(4, corner, &line, NULL), HAWSER_OK);
            Route r = route_of(line.n, line.piece, line.slope);
            check_vec(route_at(&r, r.length).position, corner[3].point, 1e-11);
            check_vec(route_at(&r, r.length).tangent, v3_unit(on), 1e-12);
            free(line.piece);
            route_clear(&r);
        }
    }
}

/* A spline begins on the heading and slope of its first piece, from which the left of its start follows. */
TEST(splines_begin)
{
    const Vec3 point[] = {{1, 2, 3}, {-6, 8, 5}, {-11, 20, 4}, {-10, 33, 4}};
    RouteLine line;
    Route r;
    assert_int_equal(route_from_spline(4, point, &line, NULL), HAWSER_OK);
    assert_int_equal(route_build(&r, line.n, line.piece, line.start, line.heading, line.slope, NULL), HAWSER_OK);
    const Vec3 t = route_at(&r, 0).tangent, level = v3_unit(v3(t.x, t.y, 0));
    check_vec(v3(cos(line.heading), sin(line.heading), 0), level, 1e-14);
    check_share(line.slope, asin(t.z), 1e-14);
    check_vec(r.left, v3(-level.y, level.x, 0), 1e-14);
    check_vec(line.start, point[0], 0);
    free(line.piece);
    route_clear(&r);
    /* two points: a straight line, whose cubic has no curvature */
    assert_int_equal(route_from_spline(2, point, &line, NULL), HAWSER_OK);
    assert_int_equal(line.n, 1);
    check_vec(line.piece[0].cubic[0], v3_sub(point[1], point[0]), 0);
    check_vec(line.piece[0].cubic[1], V3_ZERO, 0);
    check_vec(line.piece[0].cubic[2], V3_ZERO, 0);
    free(line.piece);
    /* three: at the middle one second derivatives by chord length have the closed form 3 (right - left)/(h0 + h1) */
    assert_int_equal(route_from_spline(3, point, &line, NULL), HAWSER_OK);
    const Vec3 back = v3_sub(point[1], point[0]), on = v3_sub(point[2], point[1]);
    const double h0 = v3_norm(back), h1 = v3_norm(on);
    const Vec3 bend = v3_scale(3 / (h0 + h1), v3_sub(v3_scale(1 / h1, on), v3_scale(1 / h0, back)));
    check_vec(line.piece[0].cubic[0], v3_axpy(back, -h0 * h0 / 6, bend), 1e-12);
    check_vec(line.piece[0].cubic[1], V3_ZERO, 0);
    check_vec(line.piece[0].cubic[2], v3_scale(h0 * h0 / 6, bend), 1e-12);
    check_vec(line.piece[1].cubic[0], v3_axpy(on, -h1 * h1 / 3, bend), 1e-12);
    check_vec(line.piece[1].cubic[1], v3_scale(h1 * h1 / 2, bend), 1e-12);
    check_vec(line.piece[1].cubic[2], v3_scale(-h1 * h1 / 6, bend), 1e-12);
    free(line.piece);
}

/* The least radius of a parabola is at its vertex, 1/k, between two looks as well as at one; a clothoid's jerk is by
 * how much its curvature grows, and its whole turn is the mean of its curvatures times its length. */
TEST(measures_of_curves)
{
    for (int i = 0; i < 12; ++i) {
        const double from = 0.3 + 0.01 * i, to = -0.5, length = 40, k = (tan(from) - tan(to)) / length;
        const RoutePieceDef def = {
            .kind = ROUTE_CURVE, .length = length, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = to};
        Route r = route_of(1, &def, from);
        check_share(r.piece[0].radius, 1 / k, 2e-8);
        check_share(r.piece[0].angle, from - to, 1e-9);
        route_clear(&r);
    }
    const double ends[][2] = {{0, 0.1}, {0.1, 0}, {-0.05, 0.1}, {0.04, 0.04}};
    for (int i = 0; i < 4; ++i) {
        const RoutePieceDef def = {
            .kind = ROUTE_CURVE, .length = 12, .upright = 1, .curvature = {ends[i][0], ends[i][1]}};
        Route r = route_of(1, &def, 0);
        check_close(r.piece[0].curve.jerk, fabs(ends[i][1] - ends[i][0]) / 12, 1e-4);
        check_share(r.piece[0].radius, 1 / fmax(fabs(ends[i][0]), fabs(ends[i][1])), 1e-12);
        if (ends[i][0] >= 0) check_share(r.piece[0].angle, 6 * (ends[i][0] + ends[i][1]), 1e-12);
        route_clear(&r);
    }
}

/* A long clothoid and a plan with profile, which turn by many radians: places along them against Simpson's integral of
 * their own tangents, from end to end. */
TEST(long_curves)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_CURVE, .length = 300, .upright = 1, .curvature = {-0.02, 0.1}},
                                 {.kind = ROUTE_CURVE,
                                  .length = 200,
                                  .upright = 1,
                                  .curvature = {0.1, 0.02},
                                  .profile = PROFILE_PARABOLA,
                                  .slope_end = 0.6}};
    Route r = route_of(2, def, -0.3);
    for (int i = 0; i < 2; ++i) {
        const RoutePiece *const p = &r.piece[i];
        enum { N = 20000 };
        const double h = p->length / N;
        Vec3 at = p->start;
        double off = 0;
        for (int k = 0; k < N; k += 2) {
            const Vec3 a = route_on_piece(&r, i, p->s0 + k * h).tangent,
                       m = route_on_piece(&r, i, p->s0 + (k + 1) * h).tangent;
            const RoutePoint b = route_on_piece(&r, i, p->s0 + (k + 2) * h);
            at = v3_axpy(at, h / 3, v3_add(v3_axpy(a, 4, m), b.tangent));
            off = larger_of(off, v3_norm(v3_sub(at, b.position)));
        }
        check_at_most(off, 1e-9);
    }
    route_clear(&r);
}
