/* Lists of pieces at their edges: corners that are none, roundings that just fit or do not, straights that roundings
 * eat up, legs straight up, profiles that end early; and what pieces are called. */
#include <stdlib.h>

#include "core/route.h"
#include "tests/support/check.h"

static const double DEGREE = M_PI / 180;

static RoutePieceDef sloped(double length, double slope)
{
    return (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length, .sloped = 1, .slope = slope};
}

/* Builds the line, which it takes. */
static Route built(RouteLine *line)
{
    Route r;
    assert_int_equal(route_build(&r, line->n, line->piece, line->start, line->heading, line->slope, NULL), HAWSER_OK);
    free(line->piece);
    return r;
}

static void check_end(RouteLine *line, int n, double length, Vec3 end)
{
    assert_int_equal(line->n, n);
    Route r = built(line);
    check_close(r.length, length, 1e-12 * (1 + length));
    check_vec(route_at(&r, r.length).position, end, 1e-12 * (1 + length));
    route_clear(&r);
}

/* The same slope once more is no corner; behind a bend the rounding comes off the straight alone; a straight may be
 * eaten up, but no more. */
TEST(test_slopes)
{
    RouteLine line;
    const double a = 10 * DEGREE, off = 30 * tan(a / 2);
    const RoutePieceDef same[] = {sloped(10, a), sloped(5, a), {.kind = ROUTE_STRAIGHT, .length = 5}};
    assert_int_equal(route_round_slopes(3, same, 0, 0, 30, &line, NULL), HAWSER_OK);
    check_end(&line, 3, 20, v3(20 * cos(a), 0, 20 * sin(a)));

    const RoutePieceDef up[] = {{.kind = ROUTE_STRAIGHT, .length = 20}, sloped(2 * off, a), sloped(20, 0)};
    assert_int_equal(route_round_slopes(3, up, 0, 0, 30, &line, NULL), HAWSER_OK);
    /* up to a slope and down again, and nothing between: two arcs of 30 m */
    check_end(&line, 4, 40 - 2 * off + 2 * 30 * a, v3(40 + 2 * off * cos(a), 0, 2 * off * sin(a)));

    const RoutePieceDef behind[] = {{.kind = ROUTE_BEND, .radius = 10, .angle = M_PI / 2}, sloped(20, -a)};
    assert_int_equal(route_round_slopes(2, behind, 0, 0, 30, &line, NULL), HAWSER_OK);
    const double left = 20 - 2 * off;
    check_end(&line, 3, 5 * M_PI + 30 * a + left,
              v3(10, 10 + 30 * sin(a) + left * cos(a), -30 * (1 - cos(a)) - left * sin(a)));

    hawser_error err;
    const RoutePieceDef tight[] = {sloped(20, 0), sloped(2 * off - 1e-6, a), sloped(20, 0)};
    assert_int_equal(route_round_slopes(3, tight, 0, 0, 30, &line, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "piece 1 ('')");
    assert_null(line.piece);
    /* the first straight's own slope is the route's */
    assert_int_equal(route_round_slopes(1, tight, 0, 0.7, 30, &line, NULL), HAWSER_OK);
    check_end(&line, 1, 20, v3(20, 0, 0));
}

/* Points in a row make no bend; the first leg may go straight up, and a turn there too. */
TEST(test_corners)
{
    RouteLine line;
    const RouteCorner row[] = {{{0, 0, 0}, 1}, {{4, 0, 0}, 5}, {{9, 0, 0}, 5}, {{10, 0, 0}, 1}};
    assert_int_equal(route_from_corners(4, row, &line, NULL), HAWSER_OK);
    check_end(&line, 3, 10, v3(10, 0, 0));
    const RouteCorner two[] = {{{1, 2, 3}, 1}, {{1, 2, 7}, 1}};
    assert_int_equal(route_from_corners(2, two, &line, NULL), HAWSER_OK);
    check_end(&line, 1, 4, v3(1, 2, 7));
    /* up the shaft, aside, up again and aside: each corner takes its radius of both legs */
    const RouteCorner shaft[] = {{{0, 0, 0}, 1}, {{0, 0, 6}, 2}, {{0, 8, 6}, 3}, {{0, 8, 16}, 3}, {{7, 8, 16}, 1}};
    assert_int_equal(route_from_corners(5, shaft, &line, NULL), HAWSER_OK);
    check_end(&line, 7, 4 + 3 + 4 + 4 + (2 + 3 + 3) * M_PI / 2, v3(7, 8, 16));
}

static void refused(int n, const RouteCorner *corner, const char *said)
{
    RouteLine line;
    hawser_error err = {0};
    assert_int_equal(route_from_corners(n, corner, &line, &err), HAWSER_ERR_INPUT);
    assert_int_equal(err.status, HAWSER_ERR_INPUT);
    check_has(err.message, said);
    assert_null(line.piece);
}

TEST(test_corners_refused)
{
    const RouteCorner back[] = {{{0, 0, 0}, 1}, {{9, 0, 0}, 1}, {{2, 0, 0}, 1}};
    refused(3, back, "points 1 to 3 turn back");
    const RouteCorner later[] = {{{0, 0, 0}, 1}, {{9, 0, 0}, 2}, {{9, 9, 0}, 1}, {{9, 3, 1e-4}, 1}};
    refused(4, later, "points 2 to 4 turn back");
    const RouteCorner before[] = {{{0, 0, 0}, 1}, {{3, 0, 0}, 4}, {{3, 9, 0}, 1}};
    refused(3, before, "beside point 2 are too near for a radius of 4 m, which takes 4 m");
    const RouteCorner behind[] = {{{0, 0, 0}, 1}, {{9, 0, 0}, 4}, {{9, 3, 0}, 1}};
    refused(3, behind, "beside point 2");
    const RouteCorner both[] = {{{0, 0, 0}, 1}, {{9, 0, 0}, 3}, {{9, 5, 0}, 3}, {{18, 5, 0}, 1}};
    refused(
        4, both,
        "beside point 3 are too near for a radius of 3 m, which takes 3 m on either side: the legs are 5 m (3 m of it");
    const RouteCorner nowhere[] = {{{0, 0, 0}, 1}, {{NAN, 0, 0}, 4}, {{3, 9, 0}, 1}};
    refused(3, nowhere, "points 1 and 2 are the same"); /* no distance at all */
}

/* Profiles: sharp corners by the given radius, rounded ones by theirs, parabolas; what does not fit. */
TEST(test_profiles)
{
    RouteProfile p;
    hawser_error err = {0};
    const RouteProfileCorner just[] = {{0, 0, 0, 0}, {10, 1, 0, 20}, {30, 0, 0, 20}, {40, 0, 0, 0}};
    assert_int_equal(route_profile_from_corners(4, just, 5, &p, &err), HAWSER_OK);
    assert_int_equal(p.n, 2); /* the parabolas fill it all */
    assert_int_equal(p.element[0].kind, PROFILE_PARABOLA);
    check_close(p.element[0].length + p.element[1].length, 40, 1e-12);
    free(p.element);
    const RouteProfileCorner flat[] = {{0, 0, 0, 0}, {10, 1, 0, 0}, {30, 3, 0, 0}};
    assert_int_equal(route_profile_from_corners(3, flat, 5, &p, &err), HAWSER_OK);
    assert_int_equal(p.n, 2); /* the same grade on: nothing to round */
    assert_int_equal(p.element[1].kind, PROFILE_GRADE);
    free(p.element);
    const RouteProfileCorner tight[] = {{0, 0, 0, 0}, {10, 1, 0, 21}, {30, 0, 0, 0}};
    assert_int_equal(route_profile_from_corners(3, tight, 5, &p, &err), HAWSER_ERR_INPUT);
    check_has(err.message,
              "between points 1 and 2, 10 m, is too short for the roundings at its ends, which take 10.5 m");
    assert_null(p.element);
    for (int k = 0; k < 3; ++k) { /* standing, falling, unknown */
        const RouteProfileCorner fall[] = {{0, 0, 0, 0}, {10, 1, 0, 0}, {k == 0 ? 10 : k == 1 ? 9 : NAN, 2, 0, 0}};
        assert_int_equal(route_profile_from_corners(3, fall, 5, &p, &err), HAWSER_ERR_INPUT);
        check_has(err.message, "the stations of profile points 2 and 3 do not rise");
        assert_null(p.element);
    }
}

static hawser_status with_profile(const RouteProfileElement *element, int n, double station, double length,
                                  RouteLine *line, hawser_error *err)
{
    RouteProfileElement e[4];
    for (int k = 0; k < n; ++k) e[k] = element[k];
    const RouteProfile profile = {.station = 100, .height = 5, .n = n, .element = e};
    const RoutePlanElement plan = {"plan", length, {0, 0}};
    return route_from_plan_and_profile(1, &plan, &profile, station, V3_ZERO, 0, line, err);
}

/* A profile with a corner of its own, one that begins too late or ends too early; one that ends within rounding. */
TEST(test_plan_refused)
{
    const double a = 0.1;
    const RouteProfileElement corner[] = {{PROFILE_GRADE, 20, {0, 0}}, {PROFILE_GRADE, 20, {a, a}}};
    const RouteProfileElement arc[] = {{PROFILE_ARC, 20, {0, a}}, {PROFILE_GRADE, 20, {a, a}}};
    const RouteProfileElement down[] = {{PROFILE_GRADE, 10, {0, 0}}, {PROFILE_ARC, 30, {0, -a}}};
    RouteLine line;
    hawser_error err = {0};
    assert_int_equal(with_profile(corner, 2, 100, 30, &line, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "the profile has a corner at station 120 m: round it");
    assert_int_equal(with_profile(arc, 2, 99, 30, &line, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "the profile reaches from station 100 m to 140 m, the plan from 99 m to 129 m");
    assert_int_equal(with_profile(arc, 2, 120, 21, &line, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "to 140 m, the plan from 120 m to 141 m");
    assert_null(line.piece);
    /* half a millimetre too long: as good as its end */
    assert_int_equal(with_profile(arc, 2, 100, 40.0005, &line, &err), HAWSER_OK);
    const double rise = 20 * tan(a / 2);
    check_end(&line, 2, 20 / sin(a) * a + 20 / cos(a), v3(40, 0, 5 + rise + 20 * tan(a)));
    assert_int_equal(with_profile(down, 2, 100, 40, &line, &err), HAWSER_OK);
    assert_int_equal(line.piece[1].kind, ROUTE_BEND); /* an arc over a straight plan, downward */
    check_end(&line, 2, 10 + 30 / sin(a) * a, v3(40, 0, 5 - 30 * tan(a / 2)));
}

/* What a table calls each kind, and which of them turn aside. */
TEST(test_words)
{
    const struct {
        RoutePieceDef def;
        const char *word;
        int aside;
    } row[] = {
        {{.kind = ROUTE_STRAIGHT, .length = 1}, "straight", 0},
        {{.kind = ROUTE_BEND, .radius = 2, .angle = 0.4}, "bend", 1},
        {{.kind = ROUTE_BEND, .radius = 2, .angle = 0.4, .plane = M_PI / 2}, "bend", 0},
        {{.kind = ROUTE_CUBIC, .cubic = {{3, 1, 0}, {0, 0.2, 0}, {0, 0, 0.1}}}, "cubic", 1},
        {{.kind = ROUTE_CUBIC, .cubic = {{3, 0, 0}, {0, 0, 0.4}, {0, 0, 0.1}}}, "cubic", 0},
        {{.kind = ROUTE_CURVE, .length = 5, .upright = 1, .curvature = {0.1, 0.1}}, "helix", 1},
        {{.kind = ROUTE_CURVE, .length = 5, .upright = 1, .curvature = {0, 0.1}}, "clothoid", 1},
        {{.kind = ROUTE_CURVE,
          .length = 5,
          .upright = 1,
          .curvature = {0, 0.1},
          .profile = PROFILE_ARC,
          .slope_end = 0.2},
         "curve",
         1},
        {{.kind = ROUTE_CURVE,
          .length = 5,
          .upright = 1,
          .curvature = {0.1, 0.1},
          .profile = PROFILE_ARC,
          .slope_end = 0.2},
         "curve",
         1},
        {{.kind = ROUTE_CURVE, .length = 5, .upright = 1, .profile = PROFILE_ARC, .slope_end = 0.2}, "vertical arc", 0},
        {{.kind = ROUTE_CURVE, .length = 5, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = 0.2},
         "parabola",
         0},
        {{.kind = ROUTE_CURVE, .length = 5, .plane = M_PI / 2, .curvature = {0, 0.1}}, "clothoid", 0},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        Route r;
        assert_int_equal(route_build(&r, 1, &row[k].def, V3_ZERO, 0.3, 0, NULL), HAWSER_OK);
        assert_string_equal(route_piece_word(&r.piece[0]), row[k].word);
        if (route_turns_aside(&r.piece[0]) != row[k].aside) fail_msg("piece %zu, a %s", k, row[k].word);
        /* it says so of the way itself, too */
        double off = 0;
        for (int i = 0; i <= 20; ++i) {
            const Vec3 at = route_at(&r, r.length * i / 20).position;
            off = fmax(off, fabs(v3_cross(r.piece[0].tangent, at).z));
        }
        assert_int_equal(off > 1e-9, row[k].aside);
        check_equal(route_turn(&r, -1), 0);
        check_equal(route_turn(&r, r.length + 1), 0);
        route_clear(&r);
    }
}
