/* The pulling calculator: both directions, reel and rope, conveyors, ducts, restart, roller loads, closed
 * forms by piece. */
#include "theory/plan.h"

#include <string.h>

#include "tests/support/check.h"

static const double PI = 3.14159265358979323846, WEIGHT = 200, MU = 0.25;

/* Up a slope, level, then a level bend and a sloping one: the two directions differ. */
static Route hill_route(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .name = "up", .length = 60},
        {.kind = ROUTE_BEND, .name = "crest", .radius = 10, .angle = 0.2, .plane = 3 * PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "level", .length = 40},
        {.kind = ROUTE_BEND, .name = "turn", .radius = 8, .angle = PI / 2, .plane = 0},
        {.kind = ROUTE_BEND, .name = "twist", .radius = 8, .angle = 0.5, .plane = 1},
    };
    Route route;
    assert_int_equal(route_build(&route, 5, def, v3(0, 0, 0), 0, 0.2, NULL), HAWSER_OK);
    return route;
}

static PlanDef hill_def(const Route *route, const PullStretch *cable)
{
    return (PlanDef){.route = route, .n_stretches = 1, .stretch = cable, .reel_length = 15, .rope_length = 5};
}

TEST(both_directions)
{
    Route route = hill_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_static = 0.3};
    PlanDef def = hill_def(&route, &cable);
    def.roller_spacing = 2;
    Plan plan;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    assert_int_equal(plan.n, 5);
    const PlanWay *there = &plan.way[PLAN_FORWARD], *back = &plan.way[PLAN_BACKWARD];
    check_close(there->start, 15 * WEIGHT, 0);
    check_close(there->rope, 5 * WEIGHT, 0);
    check_close(there->force, there->pull.end_tension + 5 * WEIGHT, 0);
    /* Uphill first and the bends last costs more than the bends first and then downhill. */
    assert_int_equal(plan.better, PLAN_BACKWARD);
    check_between(back->force, back->start, there->force);
    check_above(there->restart_force, there->force);
    check_above(back->restart_force, back->force);
    /* Pieces follow each other; the first straight is known exactly. */
    for (int i = 0; i < 4; i++) {
        check_close(there->piece[i].t_out, there->piece[i + 1].t_in, 0);
        check_close(back->piece[i + 1].t_out, back->piece[i].t_in, 0);
    }
    check_close(there->piece[0].t_out, 15 * WEIGHT + 60 * WEIGHT * (MU * cos(0.2) + sin(0.2)), 1e-9);
    for (int i = 0; i < 5; i++) { /* uphill and level it grows along each; downhill it may fall */
        check_close(there->piece[i].max_tension, there->piece[i].t_out, 0);
        check_close(back->piece[i].max_tension, fmax(back->piece[i].t_in, back->piece[i].t_out), 0);
    }
    check_close(there->piece[0].roller_load, 2 * WEIGHT * cos(0.2), 1e-10);
    check_close(there->piece[2].roller_load, 2 * WEIGHT, 1e-10);
    check_close(there->piece[3].roller_load, 2 * hypot(there->piece[3].t_out / 8, WEIGHT), 1e-9);
    check_close(there->piece[3].sidewall, there->piece[3].t_out / 8, 1e-10);
    check_close(there->pull.max_sidewall, there->pull.max_tension / 8, 1e-9);
    plan_clear(&plan);
    route_clear(&route);
}

TEST(closed_forms_by_piece)
{
    Route route = hill_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PlanDef def = hill_def(&route, &cable);
    Plan plan;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    for (int way = 0; way < PLAN_WAYS; way++) {
        for (int i = 0; i < 4; i++) {
            const PlanPiece *piece = &plan.way[way].piece[i];
            check_share(piece->closed, piece->t_out, 5e-12);
            assert_string_equal(piece->reason, "");
        }
        check_nan(plan.way[way].piece[4].closed);
        check_has(plan.way[way].piece[4].reason, "no closed form");
    }
    plan_clear(&plan);
    route_clear(&route);
}

/* A conveyor lowers the tension where it stands and everything beyond it, in either direction. */
TEST(conveyors)
{
    Route route = hill_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PullStep conveyor = {.at = 80, .force = 3000};
    PlanDef def = hill_def(&route, &cable);
    Plan without, with;
    assert_int_equal(plan_build(&def, &without, NULL), HAWSER_OK);
    def.n_pushes = 1;
    def.push = &conveyor;
    assert_int_equal(plan_build(&def, &with, NULL), HAWSER_OK);
    const PlanWay *a = &without.way[PLAN_FORWARD], *b = &with.way[PLAN_FORWARD];
    check_close(pull_at(&b->pull, 80).tension, pull_at(&a->pull, 80).tension, 1e-9);
    check_close(pull_at(&b->pull, 90).tension, pull_at(&a->pull, 90).tension - 3000, 1e-9);
    check_below(b->force, a->force - 3000); /* the bends beyond multiply what it takes off */
    /* The other way only the crest and the slope lie beyond it. */
    check_close(with.way[PLAN_BACKWARD].force, without.way[PLAN_BACKWARD].force - 3000 * exp(MU * 0.2), 1e-9);
    check_has(b->piece[2].reason, "a push");
    check_close(b->piece[2].t_out, pull_at(&b->pull, route.piece[3].s0).tension, 0);
    plan_clear(&without);
    plan_clear(&with);
    route_clear(&route);
}

/* Pushes of their own for the way back; a belt that brakes; gaps between rollers piece by piece. */
TEST(ways_of_their_own)
{
    Route route = hill_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PullStep there = {.at = 80, .force = 3000}, back = {.at = 80, .force = -500};
    const double spacing[5] = {2, 1, 3, 0.5, 0};
    PlanDef def = hill_def(&route, &cable);
    Plan without, with;
    assert_int_equal(plan_build(&def, &without, NULL), HAWSER_OK);
    def.n_pushes = 1;
    def.push = &there;
    def.push_back = &back;
    def.spacing = spacing;
    def.rope_force = 70;
    assert_int_equal(plan_build(&def, &with, NULL), HAWSER_OK);
    check_close(pull_at(&with.way[0].pull, 90).tension, pull_at(&without.way[0].pull, 90).tension - 3000, 1e-9);
    check_close(with.way[1].force, without.way[1].force + 500 * exp(MU * 0.2) + 70, 1e-10);
    check_close(with.way[0].piece[0].roller_load, 2 * WEIGHT * cos(0.2), 1e-10);
    check_close(with.way[0].piece[2].roller_load, 3 * WEIGHT, 1e-10);
    check_close(with.way[0].piece[4].roller_load, 0, 0);
    check_close(with.way[0].rest.max_tension, with.way[0].restart_force - with.way[0].rope, 1e-9);
    plan_clear(&without);
    plan_clear(&with);
    route_clear(&route);
}

static void refuse(const PlanDef *def, const char *why)
{
    Plan plan;
    hawser_error err;
    assert_int_equal(plan_build(def, &plan, &err), HAWSER_ERR_INPUT);
    if (!strstr(err.message, why)) fail_msg("\"%s\" does not say \"%s\"", err.message, why);
    assert_null(plan.way[0].pull.span);
    assert_null(plan.way[0].piece);
}

TEST(refusals)
{
    Route route = hill_route();
    PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PlanDef good = hill_def(&route, &cable);
    const PullStep conveyor = {.at = 3, .force = NAN};
    PlanDef def = good;
    def.n_pushes = 1, def.push = &conveyor;
    refuse(&def, "push 0");
    const PullStep far = {.at = route.length + 1, .force = 5};
    def.push = &far;
    refuse(&def, "off the route");
    cable.mu = -1;
    refuse(&good, "must be >= 0");
    /* What only fails at a restart is refused too, with nothing left behind. */
    cable.mu = MU, cable.mu_static = 1e4;
    refuse(&good, "past all bounds");
    route_clear(&route);
}

/* A bend that is shorter than the supports are apart turns no more than it has; each part of a bend has what the whole
 * has; one support beside a level bend bears T times its angle. */
TEST(loads_of_short_bends)
{
    enum { PARTS = 3 };
    static const double angle = 0.3, radius = 4, spacing = 2;
    double load[2];
    for (int k = 0; k < 2; k++) {
        const RoutePieceDef bend = {
            .kind = ROUTE_BEND, .radius = radius, .angle = angle / (k ? PARTS : 1), .plane = 3 * M_PI / 2};
        const RoutePieceDef parts[] = {{.kind = ROUTE_STRAIGHT, .length = 20}, bend, bend, bend};
        Route route;
        hawser_error err = {0};
        Plan plan;
        assert_int_equal(route_build(&route, k ? 1 + PARTS : 2, parts, v3(0, 0, 0), 0, 0, &err), HAWSER_OK);
        const PullStretch all = {.from = -1e9, .weight = WEIGHT, .mu = MU};
        const PlanDef def = {
            .route = &route, .n_stretches = 1, .stretch = &all, .roller_spacing = spacing, .back_tension = 9e3};
        assert_int_equal(plan_build(&def, &plan, &err), HAWSER_OK);
        const PlanPiece *const piece = plan.way[PLAN_FORWARD].piece;
        load[k] = piece[1].roller_load;
        check_close(piece[1].turn, angle * radius, 1e-12);
        assert_true(isinf(piece[0].turn));
        for (int i = 2; k && i <= PARTS; i++) check_close(piece[i].roller_load, load[k], 0);
        plan_clear(&plan);
        route_clear(&route);
    }
    check_share(load[1], load[0], 1e-9);
    /* (T5) over a crest, T/R + w cos(angle) at its end, times its length; and the weight between two supports */
    check_between(load[0], (9e3 + 20 * MU * WEIGHT) * angle,
                  (9e3 + 20 * MU * WEIGHT) * exp(MU * angle) * angle + WEIGHT * (spacing + 3 * radius * angle));
}

/* Two bends close together: a roller's neighbours stand behind both, or within the other. What counts is the route, not
 * how it is cut. */
TEST(loads_of_cut_routes)
{
    enum { MOST = 24 };
    static const int cuts[] = {1, 2, 3, 5, 1, 2, 3, 5};
    double load[2] = {0};
    for (int k = 0; k < 8; k++) {
        RoutePieceDef piece[MOST];
        const double spacing = k < 4 ? 3 : 0.7, turn = k < 4 ? 0.1 : 0.075;
        int n = 0;
        for (int straight = 0; straight < 3; straight++) {
            const double length = straight == 1 ? 0.6 : 12;
            for (int i = 0; i < cuts[k]; i++)
                piece[n++] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length / cuts[k]};
            if (straight < 2)
                piece[n++] = (RoutePieceDef){.kind = ROUTE_BEND, .radius = 4, .angle = 0.05, .plane = 3 * M_PI / 2};
        }
        Route route;
        Plan plan;
        hawser_error err = {0};
        assert_int_equal(route_build(&route, n, piece, V3_ZERO, 0, 0, &err), HAWSER_OK);
        const PullStretch all = {.from = -1e9, .weight = WEIGHT, .mu = MU};
        const PlanDef def = {
            .route = &route, .n_stretches = 1, .stretch = &all, .roller_spacing = spacing, .back_tension = 9e3};
        assert_int_equal(plan_build(&def, &plan, &err), HAWSER_OK);
        const PlanPiece *const on = plan.way[PLAN_FORWARD].piece;
        for (int b = 0; b < 2; b++) {
            const PlanPiece *const bend = &on[(b + 1) * cuts[k] + b];
            if (cuts[k] > 1) check_share(bend->roller_load, load[b], 1e-9);
            load[b] = bend->roller_load;
            check_close(load[b], bend->t_out * turn + WEIGHT * spacing, WEIGHT * 0.2);
        }
        plan_clear(&plan);
        route_clear(&route);
    }
}

/* What holds back less at times does so where the cable is slackest; a pull begins with the reel, not with its first
 * pit. */
TEST(held_back_least)
{
    Route route = hill_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PullStep pit = {.at = 80, .force = 700, .kind = STEP_ANEW};
    PlanDef def = hill_def(&route, &cable);
    Plan plan, least;
    def.back_tension = 900;
    assert_false(plan_slackens(&def));
    def.back_fall = 500;
    assert_true(plan_slackens(&def));
    check_close(plan_slack(&def).back_tension, 400, 0);
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    PlanDef slack = def;
    slack.back_fall = 0, slack.back_tension = 400;
    assert_int_equal(plan_build(&slack, &least, NULL), HAWSER_OK);
    for (int way = 0; way < PLAN_WAYS; way++) {
        check_close(plan.way[way].pull.min_tension, least.way[way].pull.min_tension, 1e-9);
        check_above(plan.way[way].pull.max_tension, least.way[way].pull.max_tension);
    }
    plan_clear(&plan);
    plan_clear(&least);
    def.back_fall = 0, def.behind = 5, def.behind_least = 5;
    assert_false(plan_slackens(&def));
    def.behind_least = 4;
    assert_true(plan_slackens(&def));
    def.behind_least = 5, def.lightest = WEIGHT / 2;
    assert_true(plan_slackens(&def));
    def = hill_def(&route, &cable), def.n_steps = 1, def.step = &pit;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    for (int way = 0; way < PLAN_WAYS; way++) check_close(plan.way[way].start, 15 * WEIGHT, 0);
    plan_clear(&plan);
    route_clear(&route);
}

/* Over a crest without friction the lightest piece lies where weight holds and the heaviest where it runs ahead, and
 * for the largest tension the other way round (T28). */
TEST(unlike_pieces_over_a_crest)
{
    const RoutePieceDef crest = {.kind = ROUTE_BEND, .radius = 50, .angle = 0.6, .plane = 3 * M_PI / 2};
    Route route;
    assert_int_equal(route_build(&route, 1, &crest, V3_ZERO, 0, 0.3, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = WEIGHT};
    const PlanDef def = {
        .route = &route, .n_stretches = 1, .stretch = &cable, .back_tension = 1000, .lightest = WEIGHT / 4};
    Plan plan;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    const double rise = 50 * (1 - cos(0.3));
    for (int way = 0; way < PLAN_WAYS; way++) {
        check_close(plan.way[way].pull.end_tension, 1000 + rise * (WEIGHT - WEIGHT / 4), 1e-8);
        check_close(plan.way[way].pull.min_tension, 1000 + rise * (WEIGHT / 4 - WEIGHT), 1e-8);
    }
    plan_clear(&plan);
    route_clear(&route);
}

/* In a valley out of which the tension lifts the cable, a metre holds back the less the more it weighs: for the largest
 * tension the lightest counts all the way, for the least one the heaviest. */
TEST(unlike_pieces_in_a_lifted_sag)
{
    const RoutePieceDef sag = {.kind = ROUTE_BEND, .radius = 50, .angle = 0.6, .plane = M_PI / 2};
    Route route;
    assert_int_equal(route_build(&route, 1, &sag, V3_ZERO, 0, -0.3, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = WEIGHT, .mu = 0.35}, light = {.weight = WEIGHT / 4, .mu = 0.35};
    PlanDef def = {
        .route = &route, .n_stretches = 1, .stretch = &cable, .back_tension = 100 * WEIGHT, .lightest = WEIGHT / 4};
    Plan both, heavy, lightest;
    assert_int_equal(plan_build(&def, &both, NULL), HAWSER_OK);
    def.lightest = 0;
    assert_int_equal(plan_build(&def, &heavy, NULL), HAWSER_OK);
    def.stretch = &light;
    assert_int_equal(plan_build(&def, &lightest, NULL), HAWSER_OK);
    for (int way = 0; way < PLAN_WAYS; way++) {
        check_close(both.way[way].pull.end_tension, lightest.way[way].pull.end_tension, 1e-8);
        check_close(both.way[way].pull.span[0].least, heavy.way[way].pull.span[0].least, 1e-8);
        check_above(both.way[way].pull.end_tension, heavy.way[way].pull.end_tension + WEIGHT);
    }
    plan_clear(&both);
    plan_clear(&heavy);
    plan_clear(&lightest);
    route_clear(&route);
}

/* dT/ds of (T5) by its words, with the weight of many, a 600th of the heaviest apart, that makes it largest or least.
 */
static double best_rate(const SpanLaw *law, double s, double tension)
{
    enum { WEIGHTS = 400 };
    double best = law->least ? INFINITY : -INFINITY;
    for (int i = 0; i <= WEIGHTS; i++) {
        SpanLaw one = *law;
        one.lightest = 0;
        one.weight = law->lightest + (law->weight - law->lightest) * i / WEIGHTS;
        const double rate = span_rate(&one, s, tension);
        best = law->least ? fmin(best, rate) : fmax(best, rate);
    }
    return best;
}

/* (T28), (T28a) in bends that lie in any plane, whatever the tension: no weight between makes more, or less. */
TEST(unlike_weights_one_by_one)
{
    const double planes[] = {0, 0.4, M_PI / 2, 2, 4, 3 * M_PI / 2};
    int between = 0;
    for (size_t p = 0; p < sizeof planes / sizeof *planes; p++) {
        const RoutePieceDef bend = {.kind = ROUTE_BEND, .radius = 20, .angle = 1.2, .plane = planes[p]};
        Route route;
        assert_int_equal(route_build(&route, 1, &bend, V3_ZERO, 0, 0.2, NULL), HAWSER_OK);
        for (int k = 0; k < 160; k++) {
            const double s = route.length * (k % 8 + 0.5) / 8, tension = WEIGHT * 2 * (k / 8 - 3);
            const SpanLaw law = {.direction = k % 3 ? 1 : -1,
                                 .weight = WEIGHT,
                                 .lightest = WEIGHT / 3,
                                 .mu = k % 5 ? 0.4 : 0.1,
                                 .least = k % 2,
                                 .separate = k % 7 == 0,
                                 .line = span_line(&route, s)};
            const double counts = span_weighed(&law, s, tension).weight, best = best_rate(&law, s, tension);
            between += counts > law.lightest && counts < law.weight;
            if (law.least) {
                check_between(span_rate(&law, s, tension), best - law.mu * WEIGHT / 600, best + 1e-12 * WEIGHT);
            } else {
                check_close(span_rate(&law, s, tension), best, 1e-12 * WEIGHT);
            }
        }
        route_clear(&route);
    }
    assert_in_range(between, 8, 400);
}

/* A span in one go is as good as in two, whatever the tension: the steps' estimate may be zero by chance, and corners
 * are met. Largest differences of the tension that were seen: 3e-9 of it, of unlike weights 1e-8. */
TEST(spans_in_two)
{
    const RoutePieceDef bend = {.kind = ROUTE_BEND, .radius = 60, .angle = 0.9, .plane = M_PI / 2};
    Route route;
    assert_int_equal(route_build(&route, 1, &bend, V3_ZERO, 0, -0.4, NULL), HAWSER_OK);
    for (int k = 0; k < 2400; k++) {
        const SpanLaw law = {.direction = 1,
                             .weight = 150,
                             .lightest = k % 2 ? 70 : 0,
                             .mu = 0.2,
                             .least = k % 4 == 3,
                             .separate = k % 8 >= 4,
                             .line = span_line(&route, 5)};
        const double end = route.length, cut = 0.37 * end, tension = 5 + 5 * k;
        const double two = span_integrate(&law, cut, span_integrate(&law, 0, tension, cut, NULL), end, NULL);
        check_close(span_integrate(&law, 0, tension, end, NULL), two,
                    (law.lightest > 0 ? 1e-8 : 3e-9) * (tension + 150 * end));
    }
    route_clear(&route);
}
