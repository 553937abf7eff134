/* The integrated pulling law: an independent integration from the route's vectors, corners, directions,
 * errors. */
#include "theory/pulling.h"

#include <string.h>

#include "tests/support/check.h"
#include "theory/closed_form.h"

static const double PI = 3.14159265358979323846;

/* A route with bends in all planes, on slopes, and an S in three dimensions. */
static Route winding_route(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .length = 10},
        {.kind = ROUTE_BEND, .radius = 6, .angle = 0.8, .plane = 0.3},
        {.kind = ROUTE_BEND, .radius = 4, .angle = 0.7, .plane = PI / 2 + 0.001},
        {.kind = ROUTE_STRAIGHT, .length = 15},
        {.kind = ROUTE_BEND, .radius = 3, .angle = 1.4, .plane = 4.1},
        {.kind = ROUTE_BEND, .radius = 3, .angle = 1.4, .plane = 1.0},
        {.kind = ROUTE_BEND, .radius = 12, .angle = 0.6, .plane = PI / 2},
        {.kind = ROUTE_STRAIGHT, .length = 8},
    };
    Route route;
    assert_int_equal(route_build(&route, 8, def, v3(0, 0, 0), 0.4, -0.3, NULL), HAWSER_OK);
    return route;
}

/* N = |T kappa + weight's normal part| written out with the route's vectors. */
static double plain_rate(const Route *route, int direction, double w, double mu, double s, double T)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 weight = v3(0, 0, -w);
    const double N = v3_norm(v3_axpy(v3_reject(weight, at.tangent), T, at.curvature));
    return mu * N + direction * w * at.tangent.z;
}

/* Classical RK4 with n steps a piece. */
static double plain_integral(const Route *route, int direction, double w, double mu, double T, int n)
{
    for (int j = 0; j < route->n; j++) {
        const RoutePiece *p = &route->piece[direction > 0 ? j : route->n - 1 - j];
        const double h = p->length / n, inset = 1e-12 * p->length;
        for (int i = 0; i < n; i++) {
            const double x = direction > 0 ? i * h : p->length - i * h;
            double s[3] = {p->s0 + x, p->s0 + x + direction * h / 2, p->s0 + x + direction * h};
            for (int m = 0; m < 3; m++) s[m] = fmin(fmax(s[m], p->s0 + inset), p->s0 + p->length - inset);
            const double k1 = plain_rate(route, direction, w, mu, s[0], T);
            const double k2 = plain_rate(route, direction, w, mu, s[1], T + h / 2 * k1);
            const double k3 = plain_rate(route, direction, w, mu, s[1], T + h / 2 * k2);
            const double k4 = plain_rate(route, direction, w, mu, s[2], T + h * k3);
            T += h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
        }
    }
    return T;
}

static PullDef simple_def(const Route *route, const PullStretch *stretch, double start)
{
    return (PullDef){.route = route, .to = route->length, .start_tension = start, .n_stretches = 1, .stretch = stretch};
}

/* (LI1) written out with the route's vectors: what lies on the ground and what presses to the side. */
static double separate_rate(const Route *route, int direction, double w, double mu, double s, double T)
{
    const RoutePoint at = route_at(route, s);
    const Vec3 left = route_left(route, s), up = v3_cross(at.tangent, left);
    const Vec3 load = v3_axpy(v3(0, 0, -w), T, at.curvature);
    const double N = fabs(v3_dot(load, up)) + fabs(v3_dot(load, left));
    return mu * N + direction * w * at.tangent.z;
}

/* The rates at many places of the winding route; they exceed those of one support in bends to a side, and nowhere fall
 * below. */
TEST(separate_supports)
{
    Route route = winding_route();
    PullStretch cable = {.weight = 150, .mu = 0.2, .separate = 1};
    const PullDef def = simple_def(&route, &cable, 2000);
    Pull two, one;
    assert_int_equal(pull_solve(&def, &two, NULL), HAWSER_OK);
    cable.separate = 0;
    assert_int_equal(pull_solve(&def, &one, NULL), HAWSER_OK);
    check_above(two.end_tension, 1.01 * one.end_tension);
    for (int i = 0; i < two.n; i++) {
        const PullSpan *span = &two.span[i];
        for (int k = 1; k < 20; k++) {
            const double s = span->s0 + k / 20.0 * (span->s1 - span->s0), T = pull_at(&two, s).tension;
            check_close(span_rate(&span->law, s, T), separate_rate(&route, 1, 150, 0.2, s, T), 1e-14 * T);
            const double resultant = span_normal(&one.span[i].law, s, T), sum = span_normal(&span->law, s, T);
            check_at_least(sum, resultant * (1 - 1e-12));
            check_at_most(sum, resultant * 1.4143);
            check_at_most(span_support(&span->law, s, T), resultant * (1 + 1e-12));
        }
    }
    pull_clear(&two);
    pull_clear(&one);
    route_clear(&route);
}

/* (LI2) in a level bend; a bend in a vertical plane, whose cable lifts on the way, does not know the difference. */
TEST(separate_closed_forms)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_BEND, .radius = 8, .angle = 1.1, .plane = 0},
                                 {.kind = ROUTE_BEND, .radius = 40, .angle = 0.9, .plane = PI / 2}};
    Route route;
    assert_int_equal(route_build(&route, 2, def, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    PullStretch cable = {.weight = 200, .mu = 0.25, .separate = 1};
    const PullDef pull_def = simple_def(&route, &cable, 3000);
    Pull pull;
    double T2, lifted;
    hawser_error err;
    assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
    const double exact = (3000 + 1600) * exp(0.25 * 1.1) - 1600;
    check_close(pull.span[0].t1, exact, 1e-8);
    check_close(pull_piece_extremes(&pull, 0).down, 200, 1e-9);
    check_close(pull_piece_extremes(&pull, 0).aside, exact / 8, 1e-9);
    assert_int_equal(bend_separate_tension(3000, 200, 0.25, 8, 1.1, &T2, NULL), HAWSER_OK);
    check_close(T2, exact, 1e-10);
    assert_int_equal(piece_tension(&route.piece[1], 1, exact, 200, 0.25, 1, &lifted, NULL), HAWSER_OK);
    check_close(pull.end_tension, lifted, 1e-7);
    assert_int_equal(bend_separate_tension(-1, 200, 0.25, 8, 1.1, &T2, &err), HAWSER_ERR_INPUT);
    pull_clear(&pull);
    route_clear(&route);
}

TEST(independent_integration_agrees)
{
    Route route = winding_route();
    for (int i = 0; i < 8; i++) {
        const PullStretch cable = {.weight = 150, .mu = 0.08 + 0.05 * i};
        PullDef def = simple_def(&route, &cable, 400 + 500 * i);
        if (i % 2) def.from = route.length, def.to = 0;
        Pull pull;
        assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
        const double plain = plain_integral(&route, i % 2 ? -1 : 1, 150, cable.mu, def.start_tension, 20000);
        check_share(pull.end_tension, plain, 1e-10);
        pull_clear(&pull);
    }
    route_clear(&route);
}

/* The law has no direction of its own: what is pulled one way over a route is pulled the other way over its
 * mirror. */
TEST(mirrored_routes_agree)
{
    const RoutePieceDef there[] = {{.kind = ROUTE_STRAIGHT, .length = 10},
                                   {.kind = ROUTE_BEND, .radius = 5, .angle = 0.6, .plane = PI / 2},
                                   {.kind = ROUTE_STRAIGHT, .length = 7},
                                   {.kind = ROUTE_BEND, .radius = 3, .angle = 0.9, .plane = 0}};
    const RoutePieceDef back[] = {{.kind = ROUTE_BEND, .radius = 3, .angle = 0.9, .plane = PI},
                                  {.kind = ROUTE_STRAIGHT, .length = 7},
                                  {.kind = ROUTE_BEND, .radius = 5, .angle = 0.6, .plane = PI / 2},
                                  {.kind = ROUTE_STRAIGHT, .length = 10}};
    Route a, b;
    assert_int_equal(route_build(&a, 4, there, v3(0, 0, 0), 0, -0.2, NULL), HAWSER_OK);
    const RoutePoint end = route_at(&a, a.length);
    const double heading = atan2(-end.tangent.y, -end.tangent.x), slope = -route_slope(&a, a.length);
    /* The way back starts with a bend whose plane is the first one's, turned to the mirrored frame. */
    RoutePieceDef first = back[0];
    const Vec3 left = v3(-sin(heading), cos(heading), 0), t = v3_scale(-1, end.tangent), n = v3_unit(end.curvature);
    first.plane = atan2(v3_dot(n, v3_cross(t, left)), v3_dot(n, left));
    const RoutePieceDef mirrored[] = {first, back[1], back[2], back[3]};
    assert_int_equal(route_build(&b, 4, mirrored, end.position, heading, slope, NULL), HAWSER_OK);
    check_close(v3_norm(route_at(&b, b.length).position), 0, 1e-13);

    const PullStretch cable = {.weight = 180, .mu = 0.3};
    PullDef backward = simple_def(&a, &cable, 2000), mirror = simple_def(&b, &cable, 2000);
    backward.from = a.length;
    backward.to = 0;
    Pull one, two;
    assert_int_equal(pull_solve(&backward, &one, NULL), HAWSER_OK);
    assert_int_equal(pull_solve(&mirror, &two, NULL), HAWSER_OK);
    for (double s = 0; s <= a.length; s += 0.5) {
        const PullPoint p = pull_at(&one, a.length - s), q = pull_at(&two, s);
        check_share(p.tension, q.tension, 1e-13);
        check_close(p.slope, -q.slope, 1e-12);
    }
    pull_clear(&one);
    pull_clear(&two);
    route_clear(&a);
    route_clear(&b);
}

/* Stations between: splitting a pull anywhere changes nothing, and pull_at is the solution of the law. */
TEST(points_on_the_way)
{
    Route route = winding_route();
    const PullStretch cable = {.weight = 150, .mu = 0.2};
    PullDef def = simple_def(&route, &cable, 1200);
    Pull whole, part;
    assert_int_equal(pull_solve(&def, &whole, NULL), HAWSER_OK);
    for (double s = 0.31; s < route.length; s += 1.7) {
        def.to = s;
        assert_int_equal(pull_solve(&def, &part, NULL), HAWSER_OK);
        const PullPoint at = pull_at(&whole, s);
        check_close(at.tension, part.end_tension, 1e-13 * at.tension);
        check_close(at.slope, route_slope(&route, s), 1e-12);
        assert_int_equal(at.piece, route_at(&route, s).piece);
        check_close(at.sidewall, at.tension * v3_norm(route_at(&route, s).curvature), 1e-9);
        const double rate = plain_rate(&route, 1, 150, 0.2, s, at.tension);
        check_close(0.2 * at.normal + 150 * sin(at.slope), rate, 1e-9 * (1 + fabs(rate)));
        pull_clear(&part);
    }
    check_close(pull_at(&whole, 0).tension, 1200, 0);
    check_close(pull_at(&whole, -5).tension, 1200, 0);
    check_close(pull_at(&whole, route.length + 5).tension, whole.end_tension, 0);
    pull_clear(&whole);
    route_clear(&route);
}

/* Changes of weight and friction (a frictionless lead-in, a cable with rope ahead) and tension steps. */
TEST(stretches_and_steps)
{
    const RoutePieceDef level = {.kind = ROUTE_STRAIGHT, .length = 100};
    Route route;
    assert_int_equal(route_build(&route, 1, &level, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch stretch[] = {{.weight = 200, .mu = 0},
                                   {.from = 10, .weight = 200, .mu = 0.2, .mu_static = 0.3},
                                   {.from = 70, .weight = 8, .mu = 0.5, .mu_static = 0.1}};
    const PullStep step[] = {
        {.at = 40, .force = -900}, {.at = 0, .force = 50}, {.at = 100, .force = 25}, {.at = 200, .force = 1e6}};
    PullDef def = {.route = &route,
                   .from = -20,
                   .to = 110,
                   .start_tension = 1000,
                   .n_stretches = 3,
                   .stretch = stretch,
                   .n_steps = 4,
                   .step = step};
    Pull pull;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull_at(&pull, 5).tension, 1050, 1e-10);
    check_close(pull_at(&pull, 40).tension, 1050 + 0.2 * 200 * 30, 1e-10); /* just before the conveyor */
    check_close(pull_at(&pull, 40 + 1e-9).tension, 1050 + 0.2 * 200 * 30 - 900, 1e-6);
    check_close(pull.end_tension, 1050 + 0.2 * 200 * 60 - 900 + 0.5 * 8 * 40 + 25, 1e-9);
    check_close(pull.max_tension, 1050 + 0.2 * 200 * 60 - 900 + 0.5 * 8 * 40 + 25, 1e-9);
    check_close(pull.min_tension, 1000, 0);
    pull_clear(&pull);

    def.restart = 1; /* the second mu_static is below mu and does not count */
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.end_tension, 1050 + 0.3 * 200 * 60 - 900 + 0.5 * 8 * 40 + 25, 1e-9);
    pull_clear(&pull);

    def.from = 110, def.to = -20, def.restart = 0; /* the other way: the same steps, met in the other order */
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.end_tension, 1075 + 0.5 * 8 * 40 - 900 + 0.2 * 200 * 60, 1e-9);
    check_close(pull_at(&pull, 40).tension, 1025 + 0.5 * 8 * 40 + 0.2 * 200 * 30, 1e-9);
    pull_clear(&pull);

    def.from = 0, def.to = 40; /* steps at both ends count: 50 N at the start, the conveyor at the end */
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.span[0].t0, 1050, 1e-9);
    check_close(pull.span[pull.n - 1].t1, 1050 + 0.2 * 200 * 30, 1e-9);
    check_close(pull.end_tension, 1050 + 0.2 * 200 * 30 - 900, 1e-9);
    check_close(pull.max_tension, 1050 + 0.2 * 200 * 30, 1e-9);
    check_close(pull.min_tension, 1000, 0);
    pull_clear(&pull);

    /* what the last step makes of the tension counts among the extremes */
    const PullStep ends[] = {{.at = 40, .force = 700}, {.at = 30, .force = -2000}};
    def.n_steps = 1, def.step = ends;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.max_tension, 1000 + 0.2 * 200 * 30 + 700, 1e-9);
    check_close(pull.max_at, 40, 0);
    assert_int_equal(pull.max_piece, 0);
    pull_clear(&pull);
    route_clear(&route);
}

/* Of equal tensions the first is told. */
TEST(equal_tensions)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 50}, {.kind = ROUTE_STRAIGHT, .length = 30}};
    Route route;
    assert_int_equal(route_build(&route, 2, def, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 100};
    const PullDef pull_def = simple_def(&route, &cable, 3000);
    Pull pull;
    assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
    check_equal(pull.end_tension, 3000);
    check_equal(pull.min_at, 0);
    check_equal(pull.max_at, 0);
    assert_int_equal(pull.min_piece, 0);
    check_equal(pull_piece_extremes(&pull, 2).tension, 0); /* there is none */
    pull_clear(&pull);
    PullDef back = pull_def;
    back.from = route.length, back.to = 0;
    assert_int_equal(pull_solve(&back, &pull, NULL), HAWSER_OK);
    check_equal(pull.min_at, route.length);
    assert_int_equal(pull.min_piece, 1);
    assert_int_equal(pull.max_piece, 1);
    pull_clear(&pull);
    route_clear(&route);
}

/* A downhill, level, uphill trough: the least tension lies at a corner of the slope, the greatest at the end.
 */
TEST(extremes)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 50},
                                 {.kind = ROUTE_BEND, .radius = 20, .angle = 0.6, .plane = PI / 2},
                                 {.kind = ROUTE_STRAIGHT, .length = 30}};
    Route route;
    assert_int_equal(route_build(&route, 3, def, v3(0, 0, 0), 0, -0.3, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 100, .mu = 0.05};
    const PullDef pull_def = simple_def(&route, &cable, 3000);
    Pull pull;
    assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
    /* Sampling finds nothing beyond the extremes, and comes close to them. */
    double low = INFINITY, sidewall = 0;
    for (double s = 0; s <= route.length; s += 0.001) {
        const PullPoint at = pull_at(&pull, s);
        low = smaller_of(low, at.tension);
        sidewall = larger_of(sidewall, at.sidewall);
    }
    check_at_most(pull.min_tension, low * (1 + 1e-10));
    check_close(pull.min_tension, low, 2e-7);
    check_between(pull.min_at, 50, 62);
    check_close(pull.max_tension, 3000, 0);
    check_close(pull.max_at, 0, 0);
    check_close(pull.max_sidewall, sidewall, 1e-8);
    assert_int_equal(pull.max_piece, 0);
    assert_int_equal(pull.min_piece, 1);
    assert_int_equal(pull.sidewall_piece, 1);
    check_close(pull_at(&pull, 25).support, 100 * cos(0.3), 1e-9); /* on the straight slope: the weight across it */
    const PieceExtremes most = pull_piece_extremes(&pull, 1);
    check_close(most.sidewall, pull.max_sidewall, 0);
    check_close(most.sidewall, most.tension / 20, 1e-12);
    check_at_least(most.down, pull_at(&pull, 56).normal);
    check_equal(most.aside, 0);
    check_equal(pull_piece_extremes(&pull, 0).sidewall, 0);
    pull_clear(&pull);
    route_clear(&route);
}

/* Where the weight's part out of the bend's plane is small, the normal force almost vanishes: a sharp bow,
 * not a corner. */
TEST(nearly_planar_sags)
{
    const PullStretch cable = {.weight = 200, .mu = 0.3};
    double flat = 0;
    for (int i = 0; i < 14; i++) {
        const double aside = i ? pow(10, -i) : 0;
        const RoutePieceDef def = {.kind = ROUTE_BEND, .radius = 6, .angle = 1.2, .plane = PI / 2 + aside};
        Route route;
        assert_int_equal(route_build(&route, 1, &def, v3(0, 0, 0), 0, -0.2, NULL), HAWSER_OK);
        const PullDef pull_def = simple_def(&route, &cable, 900);
        Pull pull;
        assert_int_equal(pull_solve(&pull_def, &pull, NULL), HAWSER_OK);
        if (i == 0) {
            assert_int_equal(bend_any_vertical_tension(900, 200, 0.3, 6, -0.2, 1.0, &flat, NULL), HAWSER_OK);
            check_share(pull.end_tension, flat, 5e-12);
        } else if (i < 5) {
            check_close(pull.end_tension, plain_integral(&route, 1, 200, 0.3, 900, 400000), 1e-10 * flat);
        }
        check_close(pull.end_tension, flat, 40 * 200 * 6 * aside * aside + 1e-10 * flat);
        pull_clear(&pull);
        route_clear(&route);
    }
}

/* No weight, no friction, no tension, or almost a full circle: nothing divides by zero or runs away. */
TEST(limiting_cases)
{
    Route route = winding_route();
    PullStretch cable = {.weight = 0, .mu = 0.3};
    PullDef def = simple_def(&route, &cable, 0);
    Pull pull;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_equal(pull.end_tension, 0);
    pull_clear(&pull);
    /* Without weight every bend is a capstan. */
    def.start_tension = 500;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.end_tension, capstan_tension(500, 0.3, 0.8 + 0.7 + 2.8 + 0.6), 2e-8);
    pull_clear(&pull);
    /* Nor does anything hold it back where bends do not count. */
    def.law = PULL_NO_CAPSTAN;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_equal(pull.end_tension, 500);
    def.law = PULL_REFERENCE;
    pull_clear(&pull);
    /* Without friction only the height counts. */
    cable = (PullStretch){.weight = 150, .mu = 0};
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    check_close(pull.end_tension, 500 + 150 * route_at(&route, route.length).position.z, 1e-8);
    pull_clear(&pull);
    route_clear(&route);
}

static void refuse(const PullDef *def, const char *why)
{
    hawser_error err;
    Pull pull;
    assert_int_equal(pull_solve(def, &pull, &err), HAWSER_ERR_INPUT);
    if (!strstr(err.message, why)) fail_msg("\"%s\" does not say \"%s\"", err.message, why);
    assert_null(pull.span);
}

TEST(bad_input_is_refused)
{
    Route route = winding_route();
    PullStretch cable[2] = {{.weight = 150, .mu = 0.2}, {.from = 5, .weight = 150, .mu = 0.2}};
    PullStep step = {.at = 3, .force = NAN};
    const PullDef good = simple_def(&route, cable, 100);
    PullDef def = good;
    def.to = 0;
    refuse(&def, "no length");
    def.to = NAN;
    refuse(&def, "no length");
    def = good, def.start_tension = INFINITY;
    refuse(&def, "start of the pull");
    def = good, def.n_steps = 1, def.step = &step;
    refuse(&def, "step 0");
    def = good, def.n_stretches = 2, cable[1].from = cable[0].from;
    refuse(&def, "not beyond");
    def = good, cable[0].weight = -1;
    refuse(&def, "must be >= 0");
    cable[0] = (PullStretch){.weight = 150, .mu = NAN};
    refuse(&def, "must be >= 0");
    cable[0].mu = 1e4;
    refuse(&def, "past all bounds");
    route_clear(&route);
}
