/* The paper's eq. 3-10 with the reconstructed set: every term, the total, and the tension on the way. */
#include "theory/closed_form.h"

#include "tests/support/check.h"
#include "theory/pulling.h"

static const double PI = 3.14159265358979323846, W = 46.6710427, MU = 0.1, G = 9.8;

#define DEG (3.14159265358979323846 / 180)

static const PaperTermDef TERMS[] = {
    {.kind = PAPER_REEL, .name = "reel", .length = 15},
    {.kind = PAPER_SLOPE, .name = "A-B", .length = 4.0, .slope = -5 * DEG},
    {.kind = PAPER_ARC, .name = "B-C", .radius = 60, .slope = -5 * DEG, .slope_end = 0},
    {.kind = PAPER_SLOPE, .name = "C-D", .length = 21.28577, .slope = 10 * DEG},
    {.kind = PAPER_SLOPE, .name = "D-E", .length = 19.71424},
    {.kind = PAPER_SLOPE, .name = "E-F", .length = 8.264, .slope = -5 * DEG},
    {.kind = PAPER_ROPE, .name = "rope", .length = 5},
};
enum { N_TERMS = sizeof TERMS / sizeof *TERMS };

TEST(every_term)
{
    const double expected[N_TERMS] = {6860.64, 22.80, 134.75, 2649.34, 901.68, 47.11, 2286.88};
    for (int i = 0; i < N_TERMS; i++) check_close(paper_term_force(&TERMS[i], W, MU, G), expected[i], 0.005);
    check_close(paper_total(N_TERMS, TERMS, W, MU, G), 12903.21, 0.005);
}

/* (T4), length of the straight slope A-B of eq. 4 from its height h1 (m, down to the level of C), the radius R1 (m) of
 * the arc that follows and the angle theta1 (rad, > 0) between slope and level: the paper's factor in braces over sin
 * theta1. */
static double slope_length(double h1, double R1, double theta1)
{
    const double half = sin(theta1 / 2);
    return (h1 - R1 * 2 * half * half) / sin(theta1);
}

/* Eq. 4 as printed: 9.8 W {h1 - R1 [1 - sin(pi/2 - theta1)]} csc theta1 (mu cos theta1 - sin theta1). */
TEST(eq_4_from_its_height)
{
    const double h1 = 0.57694, R1 = 60, t = 5 * DEG;
    check_close(slope_length(h1, R1, t), 4.0, 1e-4);
    const double printed = G * W * (h1 - R1 * (1 - sin(PI / 2 - t))) / sin(t) * (MU * cos(t) - sin(t));
    const PaperTermDef slope = {.kind = PAPER_SLOPE, .length = slope_length(h1, R1, t), .slope = -t};
    check_close(paper_term_force(&slope, W, MU, G), printed, 1e-12);
    check_close(printed, 22.80, 0.005);
}

/* Eq. 5 as printed: 9.8 mu W R cos(pi/2 - theta) - 9.8 W R + 9.8 W sqrt(R^2 - [R cos(pi/2 - theta)]^2). */
TEST(eq_5_as_printed)
{
    const double R = 60, c = R * cos(PI / 2 - 5 * DEG);
    const double printed = G * MU * W * c - G * W * R + G * W * sqrt(R * R - c * c);
    check_close(paper_term_force(&TERMS[2], W, MU, G), printed, 1e-10);
}

/* Arcs of all kinds against the sum of many short slopes. */
TEST(arcs_are_integrals)
{
    const double ends[][2] = {{-0.3, 0}, {0, 0.5}, {0.4, -0.2}, {0.1, 0.6}, {-0.2, -0.7}};
    for (int k = 0; k < 5; k++) {
        const PaperTermDef arc = {.kind = PAPER_ARC, .radius = 7, .slope = ends[k][0], .slope_end = ends[k][1]};
        const int n = 2000;
        const double turn = ends[k][1] - ends[k][0], ds = 7 * fabs(turn) / n;
        double sum = 0;
        for (int i = 0; i < n; i++) {
            const double phi = ends[k][0] + turn * (i + 0.5) / n;
            sum += W * G * (MU * cos(phi) + sin(phi)) * ds;
        }
        check_close(paper_term_force(&arc, W, MU, G), sum, 1e-8 * W * G * 7);
        check_close(paper_term_path(&arc), 7 * fabs(turn), 1e-15);
    }
}

TEST(tension_on_the_way)
{
    const double arc = 60 * 5 * DEG;
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, 0), 6860.64, 0.005);
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, -3), 6860.64, 0.005);
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, 2), 6860.64 + 11.40, 0.01);
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, 4 + arc), 6860.64 + 22.80 + 134.75, 0.01);
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, 58.5), 12903.21 - 2286.88, 0.01);
    check_close(paper_tension(N_TERMS, TERMS, W, MU, G, 80), 12903.21 - 2286.88, 0.01);
    /* Continuous from term to term. */
    for (double s = 4; s < 60; s += 4.5) {
        const double step =
            paper_tension(N_TERMS, TERMS, W, MU, G, s + 1e-9) - paper_tension(N_TERMS, TERMS, W, MU, G, s - 1e-9);
        check_close(step, 0, 1e-5);
    }
}

/* The same theory for a route: a route of the terms' pieces gives the terms' tensions everywhere. */
TEST(route_without_capstan_agrees)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 4},
        {.kind = ROUTE_BEND, .radius = 60, .angle = 5 * DEG, .plane = PI / 2},
        {.kind = ROUTE_BEND, .radius = 60, .angle = 10 * DEG, .plane = PI / 2},
        {.kind = ROUTE_STRAIGHT, .length = 10},
        {.kind = ROUTE_BEND, .radius = 60, .angle = 15 * DEG, .plane = 3 * PI / 2},
    };
    const PaperTermDef term[] = {
        {.kind = PAPER_SLOPE, .length = 4, .slope = -5 * DEG},
        {.kind = PAPER_ARC, .radius = 60, .slope = -5 * DEG, .slope_end = 0},
        {.kind = PAPER_ARC, .radius = 60, .slope = 0, .slope_end = 10 * DEG},
        {.kind = PAPER_SLOPE, .length = 10, .slope = 10 * DEG},
        {.kind = PAPER_ARC, .radius = 60, .slope = 10 * DEG, .slope_end = -5 * DEG},
    };
    Route route;
    assert_int_equal(route_build(&route, 5, def, v3(0, 0, 0), 0.7, -5 * DEG, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = W * G, .mu = MU};
    const PullDef pull_def = {
        .route = &route, .law = PULL_NO_CAPSTAN, .to = route.length, .n_stretches = 1, .stretch = &cable};
    Pull pull;
    assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
    for (double s = 0; s <= route.length; s += 0.37) {
        check_close(pull_at(&pull, s).tension, paper_tension(5, term, W, MU, G, s), 1e-8);
    }
    pull_clear(&pull);
    route_clear(&route);
}
