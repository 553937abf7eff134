/* Edges of the pulling theory: the largest pressure inside one curve, places of the head that are corners and no more,
 * plateaus of the winch's force, wear that does not change, supports before the route's start, rollers where a cable
 * begins to lift within a bend, what a planner says of a limit that holds. */
#include <stdlib.h>
#include <string.h>

#include "def/limits.h"
#include "tests/support/check.h"
#include "theory/place.h"
#include "theory/plan.h"

static Route route_of(int n, const RoutePieceDef *def, double slope)
{
    Route route;
    assert_int_equal(route_build(&route, n, def, V3_ZERO, 0, slope, NULL), HAWSER_OK);
    return route;
}

/* A cable without friction or weight keeps its tension, and presses most at a parabola's vertex, where 1/R is k:
 * between the looks along the curve as well as at one, either way. */
TEST(pressure_at_a_vertex)
{
    for (int i = 0; i < 16; ++i) {
        const double from = 0.11 + 0.03 * i, to = -0.4, length = 30, k = (tan(from) - tan(to)) / length;
        const RoutePieceDef def = {
            .kind = ROUTE_CURVE, .length = length, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = to};
        Route route = route_of(1, &def, from);
        const double u = tan(from) / k, run = (u * hypot(1, k * u) + asinh(k * u) / k) / 2; /* to the vertex */
        const PullStretch bare = {.from = -1};
        for (int back = 0; back < 2; ++back) {
            const PullDef pull = {.route = &route,
                                  .from = back ? route.length : 0,
                                  .to = back ? 0 : route.length,
                                  .start_tension = 7000,
                                  .n_stretches = 1,
                                  .stretch = &bare};
            Pull out;
            assert_int_equal(pull_solve(&pull, &out, NULL), HAWSER_OK);
            check_share(out.end_tension, 7000, 1e-14);
            check_share(out.max_sidewall, 7000 * k, 1e-9);
            check_close(out.sidewall_at, run, 1e-3);
            assert_int_equal(out.sidewall_piece, 0);
            pull_clear(&out);
        }
        route_clear(&route);
    }
}

/* A rope without weight does not need its frame: by the reference law it grows round a bend as round a capstan, pushed
 * or pulled, by the other law it stays. */
TEST(bare_ropes_in_bends)
{
    const double mu = 0.2, angle = 1.3, tension[] = {900, -900};
    const RoutePieceDef def = {.kind = ROUTE_BEND, .radius = 5, .angle = angle, .plane = 0.7};
    Route route = route_of(1, &def, 0.1);
    for (int k = 0; k < 4; ++k) {
        const PullStretch bare = {.mu = mu};
        const PullDef pull = {.route = &route,
                              .law = k & 2 ? PULL_NO_CAPSTAN : PULL_REFERENCE,
                              .to = route.length,
                              .start_tension = tension[k & 1],
                              .n_stretches = 1,
                              .stretch = &bare};
        Pull out;
        assert_int_equal(pull_solve(&pull, &out, NULL), HAWSER_OK);
        const double by = k & 2 ? 0 : k & 1 ? -mu * angle : mu * angle;
        check_share(out.end_tension, tension[k & 1] * exp(by), 1e-11);
        check_share(out.max_sidewall, fmax(900, fabs(out.end_tension)) / 5, 1e-12);
        if (k < 2) check_equal(out.sidewall_at, k ? 0 : route.length); /* where it is pulled, or pushed, most */
        pull_clear(&out);
    }
    route_clear(&route);
}

/* Without a distance, or with one that no gap exceeds, the rows of a series are its corners: ends of pieces and of
 * stretches, machines and what is just ahead of them; with half of a gap there is one row more in it. */
TEST(rows_of_a_series)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 40},
                                    {.kind = ROUTE_BEND, .radius = 10, .angle = 1, .plane = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 30}};
    Route route = route_of(3, pieces, 0);
    const PullStretch cable[] = {{.weight = 200, .mu = 0.2}, {.from = 60, .weight = 200, .mu = 0.3}};
    const PullStep machine = {.at = 10, .force = 100, .kind = STEP_TAKE};
    const PlanDef def = {
        .route = &route, .n_stretches = 2, .stretch = cable, .back_tension = 500, .n_steps = 1, .step = &machine};
    const double corner[] = {0, 10 - 80e-9, 10, 40, 50, 60, 80}, apart[] = {INFINITY, 31, 30, 29, 15};
    const int more[] = {0, 0, 0, 1, 2}; /* gaps of 10, 30, 10, 10, 20 m */
    for (int way = 0; way < PLAN_WAYS; ++way) {
        for (int k = 0; k < 5; ++k) {
            HeadSeries s;
            assert_int_equal(plan_heads(&def, way, apart[k], &s, NULL), HAWSER_OK);
            assert_int_equal(s.n, 7 + more[k]);
            for (int i = 0; i < s.n && !more[k]; ++i) {
                const int c = way == PLAN_BACKWARD ? 6 - i : i;
                /* just ahead of the machine is behind it on the way back */
                const double at = way == PLAN_BACKWARD && (c == 1 || c == 2) ? (c == 1 ? 10 : 10 + 80e-9) : corner[c];
                check_close(s.row[i].head, at, 1e-12);
            }
            for (int i = 1; i < s.n; ++i) check_at_most(fabs(s.row[i].head - s.row[i - 1].head), apart[k] + 1e-9);
            plan_heads_free(&s);
        }
    }
    route_clear(&route);
}

/* Up a ramp and along a level, where without friction the force does not change: of the places with the largest force
 * the peak is the first, at speed and from rest. One that is largest at the pull's start, or end, is there. */
TEST(plateaus_of_the_force)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 40},
                                    {.kind = ROUTE_STRAIGHT, .length = 50, .sloped = 1, .slope = 0},
                                    {.kind = ROUTE_STRAIGHT, .length = 20}};
    Route route = route_of(3, pieces, 0.3);
    const PullStretch cable = {.weight = 200};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .back_tension = 500};
    HeadSeries s;
    assert_int_equal(plan_heads(&def, PLAN_FORWARD, INFINITY, &s, NULL), HAWSER_OK);
    check_share(s.peak.force, 500 + 200 * 40 * sin(0.3), 1e-12);
    check_equal(s.peak.head, 40);
    check_equal(s.restart_peak.head, 40);
    check_equal(s.restart_peak.restart, s.peak.force);
    plan_heads_free(&s);
    /* back again: no force but at first */
    assert_int_equal(plan_heads(&def, PLAN_BACKWARD, INFINITY, &s, NULL), HAWSER_OK);
    check_equal(s.peak.head, 110);
    check_share(s.peak.force, 500, 1e-12);
    plan_heads_free(&s);
    route_clear(&route);
}

/* Wear by place may begin with a factor of 1 and may stay what it is; it may not fall. By cable it may. */
TEST(wear_that_stays)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 60};
    Route route = route_of(1, &straight, 0);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    const double factor[][3] = {{1, 1.2, 1.2}, {1, 1, 1}, {1.2, 1.3, 1.25}, {0.99, 1, 1}};
    for (int k = 0; k < 4; ++k) {
        for (int by = 0; by < 2; ++by) {
            const PlanWear wear[] = {{10, factor[k][0]}, {20, factor[k][1]}, {30, factor[k][2]}};
            const PlanDef def = {.route = &route,
                                 .n_stretches = 1,
                                 .stretch = &cable,
                                 .n_wear = 3,
                                 .wear = wear,
                                 .wear_by = by ? WEAR_CABLE : WEAR_PLACE};
            Plan plan;
            hawser_error err;
            if (k >= 2 && !by) continue; /* a case in which it falls by place is refused */
            assert_int_equal(plan_build(&def, &plan, &err), HAWSER_OK);
            const double sum = 10 + 10 * factor[k][0] + 10 * factor[k][1] + 30 * factor[k][2];
            check_share(plan.way[PLAN_FORWARD].force, 0.25 * 200 * sum, 1e-12);
            plan_clear(&plan);
        }
    }
    route_clear(&route);
}

/* Supports before the route's start and past its end bear what lies half way to their neighbours, once. */
TEST(supports_off_the_route)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 10}, {.kind = ROUTE_STRAIGHT, .length = 12}};
    Route route = route_of(2, pieces, 0);
    const PullStretch cable = {.from = -1e9, .weight = 150};
    const PullDef def = {.route = &route, .to = 22, .n_stretches = 1, .stretch = &cable};
    Pull pull;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = 150, .from = -8, .to = 30};
    Support s[] = {
        {.s = -3, .item = 0}, {.s = 4, .item = 1}, {.s = 24, .item = 2}, {.s = -5, .item = 3}, {.s = 29, .item = 4}};
    support_loads(&line, 5, s);
    const double end[] = {-6.5, -4, 0.5, 14, 26.5, 29.5};
    for (int i = 0; i < 5; ++i) check_share(s[i].load, 150 * (end[i + 1] - end[i]), 1e-12);
    /* at one place by their numbers, in whatever order they come */
    for (int k = 0; k < 2; ++k) {
        Support same[] = {{.s = 5, .item = k ? 3 : 1}, {.s = 5, .item = 2}, {.s = 5, .item = k ? 1 : 3}};
        support_loads(&line, 3, same);
        for (int i = 0; i < 3; ++i) assert_int_equal(same[i].item, i + 1);
    }
    pull_clear(&pull);
    route_clear(&route);
}

/* A long sag through which the tension grows: the cable lifts with the reserve from some place of the bend on. Holding
 * rollers stand from there to its end, evenly, each in the middle of its share; more of them than the list has room for
 * at first. */
TEST(lifts_within_a_bend)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_STRAIGHT, .length = 10},
                                    {.kind = ROUTE_BEND, .radius = 30, .angle = 0.55, .plane = M_PI / 2},
                                    {.kind = ROUTE_STRAIGHT, .length = 6}};
    Route route = route_of(3, pieces, 0);
    const PullStretch cable = {.from = -1e9, .weight = 200, .mu = 0.2};
    const PullDef def = {
        .route = &route, .to = route.length, .start_tension = 4350, .n_stretches = 1, .stretch = &cable};
    Pull pull;
    assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
    double begins = 10; /* where 1.25 T/R is the weight's part */
    while (1.25 * pull_at(&pull, begins).tension / 30 < 200 * cos(route_slope(&route, begins))) begins += 1e-3;
    const double ends = 26.5, spacing = 0.1;
    check_between(begins, 10.5, ends - 2);
    const PlaceLine line = {.route = &route, .pull = &pull, .weight = 200, .to = route.length};
    const PlaceRule rule = {.straights = 1, .bends = spacing, .reserve = 1.25, .hold_downs = 1};
    PlacedRoller *r = NULL;
    int n = 0, held = 0;
    assert_int_equal(place_by_rule(&line, &rule, 1000, &r, &n, NULL), HAWSER_OK);
    double first = INFINITY, last = -INFINITY;
    for (int i = 0; i < n; ++i) {
        if (r[i].side != PLACE_ABOVE) continue;
        if (held > 0) check_between(r[i].s - last, 0.9 * spacing, spacing * (1 + 1e-9));
        first = fmin(first, r[i].s);
        last = r[i].s;
        held++;
    }
    check_above(n, 256); /* twice the room at first, and twice that */
    check_close(held, (ends - begins) / spacing, 1.5);
    check_close(first, begins + spacing / 2, 0.06); /* the bend is looked at in parts of 0.05 m */
    check_close(last, ends - spacing / 2, 0.01);
    free(r);
    pull_clear(&pull);
    route_clear(&route);
}

/* Not to be trusted, and no limit would be broken: of those nothing is said. */
TEST(nothing_broken_besides)
{
    const hawser_limit holds = {
        .name = "pull", .unit = "N", .value = 50, .limit = 100, .margin = 0.5, .judged = 1, .ok = 1};
    const hawser_condition doubt = {.name = "a", .remedy = "smaller steps"};
    char text[HAWSER_VERDICT_MAX];
    assert_int_equal(hawser_verdict(1, &doubt, 1, &holds, text, sizeof text), -2);
    assert_string_equal(text, "NOT TRUSTED: smaller steps");
}

/* What has been given back is empty, and may be given back again. */
TEST(given_back_twice)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 60};
    Route route = route_of(1, &straight, 0);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable};
    Plan plan;
    PlanChange change;
    RouteGrid grid;
    HeadSeries heads;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    assert_int_equal(plan_change(&def, &plan, PLAN_FORWARD, &change, NULL), HAWSER_OK);
    assert_int_equal(plan_heads(&def, PLAN_FORWARD, 10, &heads, NULL), HAWSER_OK);
    assert_int_equal(route_grid_build(&route, 1, &grid, NULL), HAWSER_OK);
    for (int k = 0; k < 2; ++k) {
        plan_change_free(&change);
        plan_heads_free(&heads);
        route_grid_clear(&grid);
        plan_clear(&plan);
        assert_int_equal(change.n + heads.n + grid.n + plan.n + plan.way[0].pull.n, 0);
        assert_true(!change.force && !heads.row && !grid.at && !plan.way[0].piece && !plan.way[1].pull.span);
    }
    route_clear(&route);
    assert_int_equal(route.n, 0);
}

/* Ducts that are alike: the first one is named, for each limit of ducts. */
TEST(ducts_that_are_alike)
{
    LimitsDef def;
    limits_defaults(&def);
    const DuctLoad load = {
        .jam_risk = JAM_SMALL, .jam_ratio = 3.1, .clearance = 0.01, .fill = 0.3, .weight_factor = 1.2};
    const hawser_limit_kind kinds[] = {HAWSER_LIMIT_JAM_RATIO, HAWSER_LIMIT_CLEARANCE, HAWSER_LIMIT_FILL,
                                       HAWSER_LIMIT_WEIGHT_CORRECTION};
    Finding f[LIMIT_KINDS] = {{0}};
    limits_duct(&def, 3, NULL, NULL, f);
    for (int k = 0; k < 4; ++k) assert_true(f[kinds[k]].absent);
    limits_duct(&def, 3, "first", &load, f);
    limits_duct(&def, 3, "second", &load, f);
    for (int k = 0; k < 4; ++k) {
        assert_false(f[kinds[k]].absent);
        assert_string_equal(f[kinds[k]].where, "first");
        assert_int_equal(f[kinds[k]].cables, 3);
    }
}

/* A cable without weight on whole carriers round a level bend: they bear what it presses with, T/R, though nothing lies
 * on them. */
TEST(carriers_of_no_weight)
{
    const RoutePieceDef def = {.kind = ROUTE_BEND, .radius = 4, .angle = 1.5, .plane = 0};
    Route route = route_of(1, &def, 0);
    const PullStretch bare = {.from = -1e9};
    const PullDef pull = {.route = &route, .to = 6, .start_tension = 800, .n_stretches = 1, .stretch = &bare};
    Pull out;
    assert_int_equal(pull_solve(&pull, &out, NULL), HAWSER_OK);
    const PlaceLine line = {.route = &route, .pull = &out, .to = 6};
    check_equal(line_load(&line, 2).up, 0);
    Support s[] = {{.s = 1, .whole = 1}, {.s = 3, .whole = 1}, {.s = 5, .whole = 0}};
    support_loads(&line, 3, s);
    check_share(s[0].load, 800 / 4. * 1.5, 1e-12); /* from half way to the end */
    check_share(s[1].load, 800 / 4. * 2, 1e-12);
    check_equal(s[2].load, 0);
    pull_clear(&out);
    route_clear(&route);
}

/* What carriers and guides of a piece bear at most is borne somewhere on it: no more than a look along the piece finds,
 * and no less than at its ends, pulled either way. */
TEST(most_is_borne_somewhere)
{
    const RoutePieceDef pieces[] = {{.kind = ROUTE_BEND, .radius = 12, .angle = 0.9, .plane = M_PI / 2},
                                    {.kind = ROUTE_BEND, .radius = 9, .angle = 1.2, .plane = 0.5},
                                    {.kind = ROUTE_BEND, .radius = 10, .angle = 1, .plane = 3 * M_PI / 2}};
    Route route = route_of(3, pieces, -0.5);
    const PullStretch cable = {.weight = 200, .mu = 0.3, .separate = 1};
    for (int back = 0; back < 2; ++back) {
        for (double start = 500; start < 6000; start *= 2) {
            const PullDef def = {.route = &route,
                                 .from = back ? route.length : 0,
                                 .to = back ? 0 : route.length,
                                 .start_tension = start,
                                 .n_stretches = 1,
                                 .stretch = &cable};
            Pull pull;
            assert_int_equal(pull_solve(&def, &pull, NULL), HAWSER_OK);
            for (int i = 0; i < pull.n; ++i) {
                const PullSpan *const span = &pull.span[i];
                const PieceExtremes most = pull_piece_extremes(&pull, span->piece);
                enum { LOOKS = 400 };
                double down = 0, aside = 0, ends[2] = {0, 0};
                for (int k = 0; k <= LOOKS; ++k) {
                    const double s = span->s0 + (span->s1 - span->s0) * k / LOOKS;
                    const double tension = k == 0 ? span->t0 : k == LOOKS ? span->t1 : pull_at(&pull, s).tension;
                    const SpanParts at = span_parts(&span->law, s, tension);
                    down = fmax(down, fabs(at.down));
                    aside = fmax(aside, fabs(at.aside));
                    if (k % LOOKS == 0) ends[0] = fmax(ends[0], fabs(at.down)), ends[1] = fmax(ends[1], fabs(at.aside));
                }
                check_between(most.down, ends[0] * (1 - 1e-12), down * (1 + 1e-4));
                check_between(most.aside, ends[1] * (1 - 1e-12), aside * (1 + 1e-4));
            }
            pull_clear(&pull);
        }
    }
    route_clear(&route);
}
