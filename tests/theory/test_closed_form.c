/* Closed forms: the reference numbers, agreement with the integrated law, and every refusal. */
#include "theory/closed_form.h"

#include <string.h>

#include "tests/support/check.h"
#include "theory/pulling.h"

static const double PI = 3.14159265358979323846;

#define DEG (3.14159265358979323846 / 180)

/* The integrated law over one bend from a given slope. */
static double integrated(double slope, double R, double turn, double plane, double mu, double w, double T1)
{
    const RoutePieceDef def = {.kind = ROUTE_BEND, .radius = R, .angle = turn, .plane = plane};
    const PullStretch cable = {.weight = w, .mu = mu};
    Route route;
    assert_int_equal(route_build(&route, 1, &def, v3(0, 0, 0), 0.4, slope, NULL), HAWSER_OK);
    const PullDef pull_def = {
        .route = &route, .to = route.length, .start_tension = T1, .n_stretches = 1, .stretch = &cable};
    Pull pull;
    assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
    const double end = pull.end_tension;
    pull_clear(&pull);
    route_clear(&route);
    return end;
}

/* references: mu 0.2, W 200 N/m, R 5 m, theta 40 deg, T1 5000 N. */
TEST(reference_numbers)
{
    const double expected[] = {5856.2709, 6143.4932, 5642.1698, 5354.9474};
    const double slope[] = {0, 40, 0, -40}, plane[] = {1, 3, 3, 1};
    double T2 = 0;
    for (int k = 0; k < 4; k++) {
        assert_int_equal(bend_vertical_tension((VerticalBend)k, 5000, 200, 0.2, 5, 40 * DEG, &T2, NULL), HAWSER_OK);
        check_close(T2, expected[k], 5e-5);
        check_share(integrated(slope[k] * DEG, 5, 40 * DEG, plane[k] * PI / 2, 0.2, 200, 5000), T2, 1e-11);
    }
    assert_int_equal(bend_level_tension(5000, 200, 0.2, 5, 40 * DEG, &T2, NULL), HAWSER_OK);
    check_close(T2, 5763.0910, 5e-5);
    check_share(integrated(0, 5, 40 * DEG, 0, 0.2, 200, 5000), T2, 1e-11);
    check_share(integrated(0, 5, 40 * DEG, PI, 0.2, 200, 5000), T2, 1e-11);
    check_close(capstan_tension(1, 0.2, PI / 2), 1.369108, 5e-7);
    check_close(capstan_tension(1, 0.2, PI), 1.874456, 5e-7);
    check_close(integrated(0, 5, PI, 0, 0.2, 0, 1000), capstan_tension(1000, 0.2, PI), 5e-9);
}

/* The four named forms are the general one, wherever they hold; both agree with the integrated law. */
TEST(general_form_and_law_agree)
{
    int compared = 0;
    for (int i = 0; i < 240; i++) {
        const double mu = 0.05 + 0.06 * (i % 10), turn = (5 + 85.0 * (i % 7) / 6) * DEG, R = 1.5 + i % 5;
        const double T1 = 900 + 450 * (i % 11), w = 190;
        const VerticalBend kind = (VerticalBend)(i % 4);
        const double a = kind == CREST_UP_LEVEL ? turn : kind == SAG_DOWN_LEVEL ? -turn : 0;
        const double b = kind == SAG_LEVEL_UP ? turn : kind == CREST_LEVEL_DOWN ? -turn : 0;
        double named = 0, any = 0;
        if (bend_any_vertical_tension(T1, w, mu, R, a, b, &any, NULL)) continue;
        const double plane = b > a ? PI / 2 : 3 * PI / 2;
        check_close(integrated(a, R, turn, plane, mu, w, T1), any, 1e-10 * (any + T1));
        if (bend_vertical_tension(kind, T1, w, mu, R, turn, &named, NULL)) continue;
        check_close(named, any, 1e-12 * (any + T1));
        compared++;
    }
    check_above(compared, 200);
}

/* Bends between any two slopes, sags included in which the cable lifts off or settles on the way. */
TEST(bends_between_any_slopes)
{
    int crossings = 0;
    for (int i = 0; i < 300; i++) {
        const double a = (-80 + 13.3 * (i % 12)) * DEG, b = (75 - 11.7 * (i % 13)) * DEG, mu = 0.1 * (i % 6);
        const double R = 6, w = 250, T1 = 200 * (i % 17);
        double T2 = 0;
        if (fabs(b - a) < 0.01 || bend_any_vertical_tension(T1, w, mu, R, a, b, &T2, NULL)) continue;
        if (b < a && T2 < 0.3 * T1) continue; /* the tension may have been below zero on the way */
        check_close(integrated(a, R, fabs(b - a), b > a ? PI / 2 : 3 * PI / 2, mu, w, T1), T2, 1e-10 * (T1 + w * R));
        crossings += b > a && (T1 - w * R * cos(a)) * (T2 - w * R * cos(b)) < 0;
    }
    check_above(crossings, 30);
}

TEST(straights_and_slopes)
{
    check_close(slope_tension(1000, 200, 0.2, 30, 0), 1000 + 0.2 * 200 * 30, 1e-12);
    check_close(slope_tension(1000, 200, 0.2, 30, 10 * DEG), 1000 + 6000 * (0.2 * cos(10 * DEG) + sin(10 * DEG)),
                1e-12);
    check_close(slope_tension(1000, 200, 0.2, 30, -10 * DEG), 1000 + 6000 * (0.2 * cos(10 * DEG) - sin(10 * DEG)),
                1e-12);
}

TEST(rollers)
{
    double T2 = 0;
    assert_int_equal(roller_tension(1000, 0.2, 60 * DEG, &T2, NULL), HAWSER_OK);
    check_close(T2, 1000 * (1 + 0.2 / sqrt(3)) / (1 - 0.2 / sqrt(3)), 1e-9);
    assert_int_equal(roller_tension(1000, 0.8, 120 * DEG, &T2, NULL), HAWSER_ERR_INPUT);
    assert_int_equal(roller_tension(1000, 0.1, PI, &T2, NULL), HAWSER_ERR_INPUT);
    /* The friction and the normal force that the tensions leave on the roller stand in the ratio mu. */
    assert_int_equal(roller_tension(1000, 0.3, 0.5, &T2, NULL), HAWSER_OK);
    const double along = (T2 - 1000) * cos(0.25), across = (T2 + 1000) * sin(0.25);
    check_close(along / across, 0.3, 1e-14);
    check_close(roller_load(1000, T2, 0.5), hypot(along, across), 1e-10);
    /* Many small rollers make a capstan. */
    double T = 1000;
    for (int i = 0; i < 1000; i++) assert_int_equal(roller_tension(T, 0.2, PI / 2000, &T, NULL), HAWSER_OK);
    check_close(T, capstan_tension(1000, 0.2, PI / 2), 1e-3);
    /* Rollers every 2 m in a bend of 10 m: nearly T spacing / R. */
    check_close(roller_load(20000, 20000, 0.2), 4000, 8);
}

/* A refused form says why and leaves the result alone. */
TEST(refusals_have_reasons)
{
    hawser_error err;
    double T2 = -77;
    assert_int_equal(bend_vertical_tension(SAG_LEVEL_UP, 900, 200, 0.2, 5, 0.5, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "lies on the bottom");
    assert_int_equal(bend_vertical_tension(SAG_DOWN_LEVEL, 800, 200, 0.2, 5, 0.5, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "lies on the bottom");
    assert_int_equal(bend_vertical_tension(CREST_LEVEL_DOWN, 5000, 200, 0.2, 5, 1.6, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "past the vertical");
    assert_int_equal(bend_vertical_tension(CREST_LEVEL_DOWN, 10, 200, 0.01, 5, 1.5, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "does not push");
    assert_int_equal(bend_level_tension(-1, 200, 0.2, 5, 1, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "before the bend");
    assert_int_equal(bend_any_vertical_tension(100, 200, 0.2, 5, 0, 1.7, &T2, &err), HAWSER_ERR_INPUT);
    check_equal(T2, -77);
    /* The general form takes what the named sag refuses. */
    assert_int_equal(bend_any_vertical_tension(900, 200, 0.2, 5, 0, 0.5, &T2, &err), HAWSER_OK);
    check_close(T2, integrated(0, 5, 0.5, PI / 2, 0.2, 200, 900), 2e-9);
}

/* A sag's form holds from T = w R cos on, at either end: refused just below, with the slope and the bound in words. */
TEST(the_bottom_of_a_sag)
{
    const double w = 190, R = 7, wR = w * R, turn = 30 * DEG;
    hawser_error err;
    double T2 = 0;
    for (int k = 0; k < 2; k++) {
        /* 0: where a sag begins level; 1: where it ends level: without friction the tension has lost the height,
         * T2 = T1 - w R (1 - cos) */
        const VerticalBend kind = k ? SAG_DOWN_LEVEL : SAG_LEVEL_UP;
        const double least = k ? wR * (2 - cos(turn)) : wR, mu = k ? 0 : 0.2;
        assert_int_equal(bend_vertical_tension(kind, least * (1 + 1e-12), w, mu, R, turn, &T2, &err), HAWSER_OK);
        assert_int_equal(bend_vertical_tension(kind, least * (1 - 1e-9), w, mu, R, turn, &T2, &err), HAWSER_ERR_INPUT);
        check_has(err.message, "at slope 0 deg");
        check_has(err.message, "below w R cos = 1330 N");
        /* the steep end is looked at first: lifted there, it comes down before it is level */
        const double steep = wR * cos(turn) * (k ? 1 + 1e-9 : 1 - 1e-9);
        assert_int_equal(bend_vertical_tension(SAG_DOWN_LEVEL, steep, w, 0.2, R, turn, &T2, &err), HAWSER_ERR_INPUT);
        check_has(err.message, k ? "at slope 0 deg" : "at slope -30 deg");
        check_has(err.message, k ? "below w R cos = 1330 N" : "below w R cos = 1151.81 N");
    }
    assert_int_equal(bend_vertical_tension(CREST_LEVEL_DOWN, 5000, w, 0.2, R, 100 * DEG, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "turns by 100 deg");
    assert_int_equal(bend_any_vertical_tension(5000, w, 0.2, R, -95 * DEG, 20 * DEG, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "from -95 deg to 20 deg");
    assert_int_equal(roller_tension(1000, 0.8, 120 * DEG, &T2, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "a turn of 120 deg over one roller locks at friction 0.8");
    /* quarter turns, to the vertical and not past it */
    assert_int_equal(bend_vertical_tension(CREST_LEVEL_DOWN, 5000, w, 0, R, 1.57079632679489661923, &T2, &err),
                     HAWSER_OK);
    check_share(T2, 5000 - wR, 1e-12);
    assert_int_equal(bend_any_vertical_tension(5000, w, 0, R, 0, PI / 2, &T2, &err), HAWSER_OK);
    check_share(T2, 5000 + wR, 1e-12);
}

/* Without friction tension is height, whichever regimes a sag goes through; with friction and lifted all along, or on
 * the bottom all along, each regime's own closed form joins the others where the cable lifts off. */
TEST(where_a_sag_lifts_off)
{
    const double w = 250, R = 6, wR = w * R;
    double T2 = 0, joint = 0, end = 0;
    for (int i = 0; i < 40; i++) {
        const double a = (-60 + 5 * (i % 8)) * DEG, b = (10 + 12 * (i / 8)) * DEG, T1 = 900 + 70 * i;
        assert_int_equal(bend_any_vertical_tension(T1, w, 0, R, a, b, &T2, NULL), HAWSER_OK);
        check_close(T2, T1 + wR * (cos(a) - cos(b)), 1e-11 * wR);
    }
    /* slack where it begins, level: on the bottom to the slope at which T = w R cos, lifted from there. On the bottom
     * dT/dslope = mu (w R cos - T) + w R sin, lifted + mu (T - w R cos) */
    for (int i = 0; i < 12; i++) {
        const double mu = 0.05 + 0.07 * i, T1 = 60.0 * i, m = -mu, c = wR / (1 + mu * mu);
        double low = 0, high = PI / 2;
        for (int k = 0; k < 200; k++) {
            const double x = (low + high) / 2;
            const double start = -c * (1 - m * m), there = -c * (2 * m * sin(x) + (1 - m * m) * cos(x));
            joint = there + exp(m * x) * (T1 - start);
            *(joint < wR * cos(x) ? &low : &high) = x;
        }
        const double b = low + 0.3 * (PI / 2 - low), q = 1 - mu * mu;
        end = -c * (2 * mu * sin(b) + q * cos(b)) +
              exp(mu * (b - low)) * (joint + c * (2 * mu * sin(low) + q * cos(low)));
        assert_int_equal(bend_any_vertical_tension(T1, w, mu, R, 0, b, &T2, NULL), HAWSER_OK);
        check_share(T2, end, 1e-12);
        assert_int_equal(bend_any_vertical_tension(T1, w, mu, R, 0, low, &T2, NULL), HAWSER_OK);
        check_close(T2, wR * cos(low), 1e-11 * wR);
    }
}

/* Every piece of a route that has a closed form, in both directions, against the integrated law. */
TEST(pieces_of_a_route)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 12},
        {.kind = ROUTE_BEND, .radius = 4, .angle = 0.9, .plane = 0},
        {.kind = ROUTE_BEND, .radius = 6, .angle = 0.5, .plane = PI / 2},
        {.kind = ROUTE_STRAIGHT, .length = 9},
        {.kind = ROUTE_BEND, .radius = 5, .angle = 0.8, .plane = 3 * PI / 2},
        {.kind = ROUTE_BEND, .radius = 5, .angle = 0.4, .plane = 0},
    };
    Route route;
    assert_int_equal(route_build(&route, 6, def, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    for (int direction = -1; direction <= 1; direction += 2) {
        PullDef pull_def = {
            .route = &route, .to = route.length, .start_tension = 3000, .n_stretches = 1, .stretch = &cable};
        if (direction < 0) pull_def.from = route.length, pull_def.to = 0;
        Pull pull;
        assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
        assert_int_equal(pull.n, 6);
        for (int i = 0; i < pull.n; i++) {
            const PullSpan *span = &pull.span[i];
            double T2 = 0;
            hawser_error err;
            const RoutePiece *piece = &route.piece[span->piece];
            const hawser_status status = piece_tension(piece, direction, span->t0, 200, 0.25, 0, &T2, &err);
            if (span->piece == 5) { /* the sloping bend */
                assert_int_equal(status, HAWSER_ERR_INPUT);
                check_has(err.message, "no closed form");
            } else {
                assert_int_equal(status, HAWSER_OK);
                check_share(T2, span->t1, 1e-11);
            }
        }
        pull_clear(&pull);
    }
    route_clear(&route);
}
