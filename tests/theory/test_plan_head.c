/* The planner's calculation against closed forms: rope ahead of the cable, pits, machines, wear, a push, the brake; and
 * what must hold of any of them: the last place of the head is the whole pull, sections are cut routes, a route pulled
 * back is its mirror pulled forward. */
#include "theory/plan.h"

#include "tests/support/check.h"
#include "theory/closed_form.h"

static const double PI = 3.14159265358979323846, WEIGHT = 200, MU = 0.25;

static Route route_of(int n, const RoutePieceDef *def, double slope)
{
    Route route;
    assert_int_equal(route_build(&route, n, def, v3(0, 0, 0), 0, slope, NULL), HAWSER_OK);
    return route;
}

/* Straight, quarter turn, straight, quarter turn, straight: all level. */
static Route level_route(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .name = "a", .length = 40},
        {.kind = ROUTE_BEND, .name = "first", .radius = 10, .angle = PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "b", .length = 30},
        {.kind = ROUTE_BEND, .name = "second", .radius = 10, .angle = PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "c", .length = 20},
    };
    return route_of(5, def, 0);
}

static HeadForce head_at(const PlanDef *def, int way, double s)
{
    HeadForce f;
    assert_int_equal(plan_head(def, way, s, &f, NULL), HAWSER_OK);
    return f;
}

static Plan plan_of(const PlanDef *def)
{
    Plan plan;
    assert_int_equal(plan_build(def, &plan, NULL), HAWSER_OK);
    return plan;
}

/* (PN6): a rope without weight goes round the bends ahead as round a capstan; one with weight is dragged as well. */
TEST(rope_ahead)
{
    Route route = level_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_static = 0.3, .mu_rope = 0.15};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .reel_length = 15, .rope_length = 5};
    const double start = 15 * WEIGHT, head = start + MU * WEIGHT * 25;
    const HeadForce f = head_at(&def, PLAN_FORWARD, 25);
    check_close(f.tension, head, 1e-9);
    check_share(f.force, head * exp(0.15 * PI) + 5 * WEIGHT, 1e-11);
    check_share(f.restart, (start + 0.3 * WEIGHT * 25) * exp(0.15 * PI) + 5 * WEIGHT, 1e-11);
    /* backward the same bends come from the other side: 85 m to go past both of them from 25 m short of the far end */
    const double from = route.length - 12;
    const HeadForce b = head_at(&def, PLAN_BACKWARD, from);
    check_share(b.force, (start + MU * WEIGHT * 12) * exp(0.15 * PI) + 5 * WEIGHT, 1e-11);
    /* a rope of 6 N/m on the straight between two bends: closed form of a level bend (T11) */
    def.rope_weight = 6;
    const double between = route.piece[2].s0 + 10;
    const HeadForce r = head_at(&def, PLAN_FORWARD, between);
    const double t = r.tension + 0.15 * 6 * 20, turn = 0.15 * PI / 2, wR = 60;
    const double out = t * cosh(turn) + sinh(turn) * hypot(t, wR);
    check_share(r.force, out + 0.15 * 6 * 20 + 5 * WEIGHT, 1e-11);
    route_clear(&route);
}

/* The last place of the head is the whole pull; the series holds the corners; its peak is no smaller than any row. */
TEST(the_last_place_is_the_pull)
{
    Route route = level_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_static = 0.3, .mu_rope = 0.15};
    const PullStep machine = {.at = 50, .force = 2500, .kind = STEP_TAKE};
    const PlanDef def = {.route = &route,
                         .n_stretches = 1,
                         .stretch = &cable,
                         .reel_length = 15,
                         .rope_weight = 9,
                         .n_steps = 1,
                         .step = &machine};
    Plan plan = plan_of(&def);
    for (int k = 0; k < PLAN_WAYS; k++) {
        HeadSeries s;
        assert_int_equal(plan_heads(&def, k, 5, &s, NULL), HAWSER_OK);
        check_share(s.row[s.n - 1].force, plan.way[k].force, 1e-12);
        check_share(s.row[s.n - 1].restart, plan.way[k].restart_force, 1e-12);
        check_close(s.row[0].head, k ? route.length : 0, 0);
        check_close(s.row[s.n - 1].head, k ? 0 : route.length, 0);
        int ends = 0;
        for (int i = 0; i < s.n; i++) {
            check_at_least(s.peak.force, s.row[i].force);
            check_at_least(s.restart_peak.restart, s.row[i].restart);
            ends += s.row[i].head == route.piece[3].s0 || s.row[i].head == 50;
            if (i > 0) check_below(fabs(s.row[i].head - s.row[i - 1].head), 5.001);
            /* what is taken over from another place of the head is what it would have been */
            const HeadForce alone = head_at(&def, k, s.row[i].head);
            check_equal(alone.force, s.row[i].force);
            check_equal(alone.restart, s.row[i].restart);
            check_equal(alone.tension, s.row[i].tension);
            /* the cable's tension does not know what is ahead */
            check_share(s.row[i].tension, pull_at(&plan.way[k].pull, s.row[i].head).tension, 1e-9);
        }
        assert_int_equal(ends, 2);
        plan_heads_free(&s);
    }
    plan_clear(&plan);
    route_clear(&route);
}

/* Over a crest and down a slope on which the cable runs by itself: the winch has most to do before the end. */
TEST(the_peak_lies_on_the_crest)
{
    const double up = 0.4, R = 30;
    const RoutePieceDef pieces[] = {
        {.kind = ROUTE_STRAIGHT, .name = "up", .length = 50},
        {.kind = ROUTE_BEND, .name = "crest", .radius = R, .angle = 2 * up, .plane = 3 * PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "down", .length = 80},
    };
    Route route = route_of(3, pieces, up);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable};
    HeadSeries s;
    assert_int_equal(plan_heads(&def, PLAN_FORWARD, INFINITY, &s, NULL), HAWSER_OK);
    /* with a rope that drags nothing the winch's force is the head's tension: it rises on the arc, where T/R adds to
     * the friction, and falls down the slope */
    Plan plan = plan_of(&def);
    check_share(s.peak.force, plan.way[PLAN_FORWARD].pull.max_tension, 1e-9);
    check_close(s.peak.head, plan.way[PLAN_FORWARD].pull.max_at, 1e-3);
    check_above(s.peak.force, 1.2 * plan.way[PLAN_FORWARD].force);
    assert_int_equal(plan.way[PLAN_FORWARD].pull.max_piece, 1); /* the crest, where it ends too */
    plan_clear(&plan);
    plan_heads_free(&s);
    route_clear(&route);
}

/* (PN3): what is pulled from a pit is a route that begins there. */
TEST(sections_are_cut_routes)
{
    Route route = level_route();
    const double cut = route.piece[2].s0, back = 700;
    const RoutePieceDef before[] = {
        {.kind = ROUTE_STRAIGHT, .name = "a", .length = 40},
        {.kind = ROUTE_BEND, .name = "first", .radius = 10, .angle = PI / 2},
    };
    const RoutePieceDef after[] = {
        {.kind = ROUTE_STRAIGHT, .name = "b", .length = 30},
        {.kind = ROUTE_BEND, .name = "second", .radius = 10, .angle = PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "c", .length = 20},
    };
    Route part[2] = {route_of(2, before, 0), route_of(3, after, 0)};
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_static = 0.3, .mu_rope = 0.2};
    const PullStep pit = {.at = cut, .force = back, .kind = STEP_ANEW};
    PlanDef def = {.route = &route,
                   .n_stretches = 1,
                   .stretch = &cable,
                   .back_tension = 1000,
                   .rope_force = 80,
                   .n_steps = 1,
                   .step = &pit};
    PlanDef first = {.route = &part[0], .n_stretches = 1, .stretch = &cable, .back_tension = 1000, .rope_force = 80};
    PlanDef second = {.route = &part[1], .n_stretches = 1, .stretch = &cable, .back_tension = back, .rope_force = 80};
    Plan whole = plan_of(&def), a = plan_of(&first), b = plan_of(&second);
    assert_int_equal(plan_sections(&def, PLAN_FORWARD), 2);
    check_share(whole.way[0].force, b.way[0].force, 1e-12);
    check_share(whole.way[0].restart_force, b.way[0].restart_force, 1e-12);
    check_share(whole.way[0].pull.max_tension, larger_of(a.way[0].pull.max_tension, b.way[0].pull.max_tension), 1e-12);
    check_share(head_at(&def, 0, cut).force, a.way[0].force, 1e-12);
    /* inside a section the rope goes to its pit, or to the end from the pit on */
    check_share(head_at(&def, 0, 20).force, head_at(&first, 0, 20).force, 1e-12);
    check_share(head_at(&def, 0, cut + 12).force, head_at(&second, 0, 12).force, 1e-12);
    /* the other way the pit comes after the other part */
    first.back_tension = back, second.back_tension = 1000;
    Plan c = plan_of(&first), d = plan_of(&second);
    check_share(whole.way[1].force, c.way[1].force, 1e-12);
    check_share(head_at(&def, 1, cut).force, d.way[1].force, 1e-12);
    Plan *const plans[] = {&whole, &a, &b, &c, &d};
    for (int i = 0; i < 5; i++) plan_clear(plans[i]);
    for (int i = 0; i < 2; i++) route_clear(&part[i]);
    route_clear(&route);
}

/* (PN2): what arrives, up to the push; the rope runs through it. */
TEST(machines_take_off)
{
    Route route = level_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_rope = 0.1};
    const PullStep strong = {.at = 20, .force = 5000, .kind = STEP_TAKE},
                   weak = {.at = 20, .force = 300, .kind = STEP_TAKE};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .n_steps = 1, .step = &strong};
    check_close(head_at(&def, 0, 30).tension, MU * WEIGHT * 10, 1e-9);
    def.step = &weak;
    check_close(head_at(&def, 0, 30).tension, MU * WEIGHT * 30 - 300, 1e-9);
    check_close(head_at(&def, 0, 19).tension, MU * WEIGHT * 19, 1e-9);
    /* just before the head reaches it the winch has 300 N more to pull than just behind it */
    check_share(head_at(&def, 0, 20 - 1e-9).force - head_at(&def, 0, 20).force, 300 * exp(0.1 * PI), 1e-6);
    HeadSeries s;
    assert_int_equal(plan_heads(&def, 0, INFINITY, &s, NULL), HAWSER_OK);
    int before = 0;
    for (int i = 0; i < s.n; i++) before += s.row[i].head < 20 && s.row[i].head > 20 - 1e-6;
    assert_int_equal(before, 1);
    plan_heads_free(&s);
    route_clear(&route);
}

/* (PN4): by the cable's way, and by what has passed. On a straight of 40 m, friction twice as much from 15 m on. */
TEST(friction_by_length)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = 40};
    Route route = route_of(1, &straight, 0);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_rope = 0.1};
    const PlanWear wear = {15, 2};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .n_wear = 1, .wear = &wear};
    const double w = MU * WEIGHT;
    for (int way = 0; way < PLAN_WAYS; way++) {
        const double at = way ? 40 - 30 : 30;
        def.wear_by = WEAR_CABLE; /* 15 m as it was, 15 m twice */
        check_close(head_at(&def, way, at).force, w * (15 + 2 * 15), 1e-9);
        def.wear_by = WEAR_PLACE; /* of the first 15 m so much has passed */
        check_close(head_at(&def, way, at).force, w * (2 * 15 + 15), 1e-9);
        check_close(head_at(&def, way, at).tension, w * 45, 1e-9);
        check_close(head_at(&def, way, way ? 30 : 10).force, w * 10, 1e-9);
    }
    route_clear(&route);
}

/* Pushed at the feed end: on the level -F + mu w s, and round a bend a pushed cable presses outward, |T| mu/R. */
TEST(pushed_at_the_feed)
{
    Route route = level_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .feed = 5000};
    Plan plan = plan_of(&def);
    const Pull *const pull = &plan.way[0].pull;
    check_close(pull_at(pull, 40).tension, -5000 + MU * WEIGHT * 40, 1e-9);
    check_close(pull->min_tension, -5000, 1e-9);
    /* (T11) from the other end: a pushed cable is a pulled one seen backward */
    const double T1 = 5000 - MU * WEIGHT * 40, turn = MU * PI / 2, wR = WEIGHT * 10;
    const double T2 = T1 * cosh(-turn) + sinh(-turn) * hypot(T1, wR);
    check_share(-pull_at(pull, 40 + 10 * PI / 2).tension, T2, 1e-9);
    check_share(plan.way[0].piece[1].sidewall, T1 / 10, 1e-9);
    plan_clear(&plan);
    route_clear(&route);
}

/* (PN8): down a slope the brake is the whole loss of tension, w L (sin - mu cos), and lifts the winch by as much. */
TEST(brake_on_a_slope)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "shaft", .length = 60};
    Route route = route_of(1, &straight, -1.2);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .rope_force = 40};
    const double loss = WEIGHT * 60 * (sin(1.2) - MU * cos(1.2));
    Brake brake;
    assert_int_equal(plan_brake(&def, PLAN_FORWARD, &brake, NULL), HAWSER_OK);
    check_share(brake.brake, loss, 1e-8);
    check_close(brake.where, 60, 1e-9);
    check_share(brake.peak, loss + 40, 1e-8);
    check_share(brake.max_tension, loss, 1e-8); /* at the brake */
    check_close(brake.force, 40, 1e-4);
    /* up it there is none */
    assert_int_equal(plan_brake(&def, PLAN_BACKWARD, &brake, NULL), HAWSER_OK);
    check_close(brake.brake, 0, 0);
    check_share(brake.force, WEIGHT * 60 * (sin(1.2) + MU * cos(1.2)) + 40, 1e-9);
    check_share(brake.max_tension, brake.force - 40, 1e-9); /* at the head */
    route_clear(&route);
}

/* A mirror of the route, forward, is the route backward. */
TEST(mirrored)
{
    const RoutePieceDef there[] = {
        {.kind = ROUTE_STRAIGHT, .name = "a", .length = 40},
        {.kind = ROUTE_BEND, .name = "turn", .radius = 8, .angle = 1.1, .plane = 0},
        {.kind = ROUTE_STRAIGHT, .name = "b", .length = 17},
    };
    const RoutePieceDef back[] = {there[2], there[1], there[0]};
    Route one = route_of(3, there, 0), other = route_of(3, back, 0);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_static = 0.3, .mu_rope = 0.12};
    const PlanDef a = {.route = &one, .n_stretches = 1, .stretch = &cable, .reel_length = 3, .rope_weight = 7};
    PlanDef b = a;
    b.route = &other;
    for (int i = 0; i <= 10; i++) {
        const double s = one.length * i / 10;
        check_share(head_at(&a, PLAN_BACKWARD, one.length - s).force, head_at(&b, PLAN_FORWARD, s).force, 1e-9);
        check_share(head_at(&a, PLAN_FORWARD, s).restart, head_at(&b, PLAN_BACKWARD, one.length - s).restart, 1e-9);
    }
    route_clear(&one);
    route_clear(&other);
}

/* Where the tension over a crest is largest: dT/ds = mu (T/R + w cos) + w sin is 0 there; from slope `a` down to `b`.
 */
static double crest_top(double T1, double mu, double R, double a, double b, double *most)
{
    double rises = a, falls = b;
    for (int i = 0; i < 60; i++) {
        const double middle = (rises + falls) / 2;
        assert_int_equal(bend_any_vertical_tension(T1, WEIGHT, mu, R, a, middle, most, NULL), HAWSER_OK);
        const double growth = mu * (*most / R + WEIGHT * cos(middle)) + WEIGHT * sin(middle);
        *(growth > 0 ? &rises : &falls) = middle;
    }
    return R * (a - rises);
}

/* A crest that is steeper on one side, gone over both ways, with few rows and with many: the peak lies behind the
 * largest row one time and ahead of it another; at speed and from rest by the closed form of a crest. */
TEST(peaks_between_rows)
{
    const double up = 0.2, down = 0.6, R = 30, arc = R * (up + down), before = 50, after = 80, reel = 4;
    const RoutePieceDef pieces[] = {
        {.kind = ROUTE_STRAIGHT, .name = "up", .length = before},
        {.kind = ROUTE_BEND, .name = "crest", .radius = R, .angle = up + down, .plane = 3 * PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "down", .length = after},
    };
    Route route = route_of(3, pieces, up);
    int behind = 0, ahead = 0;
    for (int k = 0; k < 16; k++) {
        const int way = k & 1, restarts_differ = k & 2;
        const double mu = k & 4 ? 0.01 : 0.03, apart = k & 8 ? 9 : INFINITY;
        const PullStretch cable = {.weight = WEIGHT, .mu = mu, .mu_static = restarts_differ ? 1.5 * mu : 0};
        const PlanDef def = {
            .route = &route, .n_stretches = 1, .stretch = &cable, .reel_length = reel, .rope_force = 70};
        HeadSeries s;
        assert_int_equal(plan_heads(&def, way, apart, &s, NULL), HAWSER_OK);
        for (int rest = 0; rest < 2; rest++) {
            const double m = rest && restarts_differ ? 1.5 * mu : mu, a = way ? down : up, b = way ? -up : -down;
            const double start = slope_tension(reel * WEIGHT, WEIGHT, m, way ? after : before, a);
            const HeadForce *const peak = rest ? &s.restart_peak : &s.peak;
            double most = 0;
            const double along = (way ? after : before) + crest_top(start, m, R, a, b, &most);
            check_between(along - (way ? after : before), 0.05 * arc, 0.95 * arc);
            check_share(rest ? peak->restart : peak->force, most + 70, 1e-9);
            check_close(way ? route.length - peak->head : peak->head, along, 2.5e-3); /* 24 cuts of 130 m at most */
            int top = 0;
            for (int i = 1; i < s.n; i++) {
                if (rest ? s.row[i].restart > s.row[top].restart : s.row[i].force > s.row[top].force) top = i;
            }
            const int short_of = (way ? route.length - s.row[top].head : s.row[top].head) < along;
            behind += short_of;
            ahead += !short_of;
            Plan plan = plan_of(&def);
            const PlanWay *const w = &plan.way[way];
            check_share(rest ? w->rest.max_tension : w->pull.max_tension, most, 1e-9);
            const double at = rest ? w->rest.max_at : w->pull.max_at;
            check_close(way ? route.length - at : at, along, 1e-4);
            assert_int_equal(rest ? w->rest.max_piece : w->pull.max_piece, 1);
            plan_clear(&plan);
        }
        plan_heads_free(&s);
    }
    check_at_least(behind, 8);
    check_at_least(ahead, 8);
    route_clear(&route);
}

/* A row a billionth of the route ahead of what pushes, either way, and none behind it. */
TEST(a_row_just_ahead)
{
    for (int k = 0; k < 8; k++) {
        const int way = k & 1, conveyor = k & 2;
        const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = k & 4 ? 4000 : 3};
        Route route = route_of(1, &straight, 0);
        const PullStretch cable = {.weight = WEIGHT, .mu = MU};
        const PullStep helper = {.at = 0.25 * straight.length, .force = 30, .kind = STEP_TAKE};
        PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable};
        if (conveyor) def.n_pushes = 1, def.push = &helper;
        if (!conveyor) def.n_steps = 1, def.step = &helper;
        HeadSeries s;
        assert_int_equal(plan_heads(&def, way, INFINITY, &s, NULL), HAWSER_OK);
        assert_int_equal(s.n, 4);
        const double sign = way ? -1 : 1, length = straight.length, gap = 1e-9 * length;
        const double expected[] = {way ? length : 0, helper.at - sign * gap, helper.at, way ? 0 : length};
        const double come = way ? length - helper.at : helper.at, w = MU * WEIGHT;
        const double force[] = {0, w * come, w * come - 30, w * length - 30};
        for (int i = 0; i < 4; i++) {
            check_close(s.row[i].head, expected[i], 1e-3 * gap);
            check_close(s.row[i].force, force[i], 2 * w * gap + 1e-9);
        }
        check_close(s.peak.force, larger_of(force[1], force[3]), 2 * w * gap + 1e-9);
        plan_heads_free(&s);
        route_clear(&route);
    }
}

/* (PN8): what holds back already is counted once; where a pit begins anew no brake at the reel helps, and what is said
 * then is the pull without one. */
TEST(brakes_on_top)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "shaft", .length = 60};
    Route route = route_of(1, &straight, -1.2);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .back_tension = 900};
    const double loss = WEIGHT * 60 * (sin(1.2) - MU * cos(1.2));
    Brake brake;
    assert_int_equal(plan_brake(&def, PLAN_FORWARD, &brake, NULL), HAWSER_OK);
    check_share(brake.brake, loss - 900, 1e-8);
    check_share(brake.max_tension, loss, 1e-8);
    check_equal(brake.force, 0); /* what is left of it is rounding */
    const PullStep pit = {.at = 24, .force = 500, .kind = STEP_ANEW};
    def.n_steps = 1, def.step = &pit, def.rope_force = 40;
    assert_int_equal(plan_brake(&def, PLAN_FORWARD, &brake, NULL), HAWSER_OK);
    check_nan(brake.brake);
    check_close(brake.where, 60, 1e-9);
    check_share(brake.force, 500 - loss * 36 / 60 + 40, 1e-9);
    check_share(brake.max_tension, 900, 1e-9);
    check_share(brake.peak, 900 + 40, 1e-9);
    /* the head just behind a pit that holds back more than all before: that is where the winch has most to pull */
    const PullStep strong = {.at = 24, .force = 5000, .kind = STEP_ANEW};
    def.step = &strong;
    HeadSeries s;
    assert_int_equal(plan_heads(&def, PLAN_FORWARD, INFINITY, &s, NULL), HAWSER_OK);
    check_share(s.peak.force, 5000 + 40, 1e-6);
    check_close(s.peak.head, 24, 1e-6);
    plan_heads_free(&s);
    route_clear(&route);
}

/* A push counts as soon as the head is there, a pit once the head is past it; wear and a duct's factors do not reach
 * the rope, and a stretch's own share does. */
TEST(what_the_head_has_reached)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = 60};
    Route route = route_of(1, &straight, 0);
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_rope = 0.1};
    const PullStep push = {.at = 20, .force = 300}, back = {.at = 20, .force = -150};
    const PullStep pits[] = {{.at = 30, .force = 700, .kind = STEP_ANEW}, {.at = 60, .force = 80, .kind = STEP_ANEW}};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &cable, .n_pushes = 1, .push = &push};
    const double w = MU * WEIGHT;
    check_close(head_at(&def, 0, 20).force, w * 20 - 300, 1e-9);
    check_close(head_at(&def, 1, 20).force, w * 40 - 300, 1e-9);
    check_close(head_at(&def, 0, 19.5).force, w * 19.5, 1e-9);
    check_close(head_at(&def, 1, 20.5).force, w * 39.5, 1e-9);
    def.push_back = &back;
    check_close(head_at(&def, 0, 20).force, w * 20 - 300, 1e-9);
    check_close(head_at(&def, 1, 20).force, w * 40 + 150, 1e-9);
    /* a pit at an end is no section: at the pull's end it does nothing, where it begins it is what holds back */
    def.n_pushes = 0, def.n_steps = 2, def.step = pits;
    assert_int_equal(plan_sections(&def, 0), 2);
    assert_int_equal(plan_sections(&def, 1), 2);
    check_close(head_at(&def, 0, 30).force, w * 30, 1e-9);
    check_close(head_at(&def, 0, 31).force, 700 + w, 1e-9);
    check_close(head_at(&def, 0, 60).force, 700 + w * 30, 1e-9);
    check_close(head_at(&def, 1, 30).force, 80 + w * 30, 1e-9);
    check_close(head_at(&def, 1, 0).force, 700 + w * 30, 1e-9);
    Plan plan = plan_of(&def);
    for (int way = 0; way < PLAN_WAYS; way++) {
        check_close(plan.way[way].pull.end_tension, 700 + w * 30, 1e-9);
        check_close(pull_at(&plan.way[way].pull, way ? 40 : 20).tension, (way ? 80 : 0) + w * 20, 1e-9);
        check_close(pull_at(&plan.way[way].pull, way ? 20 : 40).tension, 700 + w * 10, 1e-9);
    }
    plan_clear(&plan);
    /* rope of 9 N/m over the rest: its own friction alone */
    const PlanWear wear = {0, 1.2};
    HeadForce f;
    def.n_steps = 0, def.rope_weight = 9, def.n_wear = 1, def.wear = &wear;
    for (int way = 0; way < PLAN_WAYS; way++) {
        assert_int_equal(plan_head(&def, way, way ? 45 : 15, &f, NULL), HAWSER_OK);
        check_close(f.tension, 1.2 * w * 15, 1e-9);
        check_close(f.force, f.tension + 0.1 * 9 * 45, 1e-9);
    }
    route_clear(&route);
}

/* Sections one by one, pits in no order, either way; and what carries the rope presses with the rope's own tension. */
TEST(sections_in_order)
{
    Route route = level_route();
    const PullStretch cable = {.weight = WEIGHT, .mu = MU, .mu_rope = 0.1, .share = 0.5};
    const PullStep step[] = {{.at = 90, .force = 90, .kind = STEP_ANEW},
                             {.at = 50, .force = 7, .kind = STEP_TAKE},
                             {.at = 30, .force = 30, .kind = STEP_ANEW},
                             {.at = 70, .force = 70, .kind = STEP_ANEW}};
    PlanDef def = {.route = &route,
                   .n_stretches = 1,
                   .stretch = &cable,
                   .reel_length = 2,
                   .back_tension = 11,
                   .feed = 5,
                   .beyond = 6,
                   .n_steps = 4,
                   .step = step};
    static const int order[PLAN_WAYS][5] = {{-1, 2, 3, 0, -1}, {-1, 0, 3, 2, -1}};
    for (int way = 0; way < PLAN_WAYS; way++) {
        const double first = way ? route.length : 0, last = way ? -6 : route.length + 6;
        assert_int_equal(plan_sections(&def, way), 4);
        for (int i = 0; i < 4; i++) {
            const PlanSection s = plan_section(&def, way, i);
            const int begins = order[way][i], ends = order[way][i + 1];
            assert_int_equal(s.begins, begins);
            assert_int_equal(s.ends, ends);
            check_equal(s.from, begins < 0 ? first : step[begins].at);
            check_equal(s.to, ends < 0 ? last : step[ends].at);
            check_close(s.start, begins < 0 ? 2 * WEIGHT + 11 - 5 : step[begins].force, 1e-12);
            const double inside = (s.from + s.to) / 2;
            check_equal(plan_section_at(&def, way, inside).to, s.to);
            check_equal(plan_section_at(&def, way, s.to).to, s.to);
        }
        check_equal(plan_section(&def, way, 9).to, last);
    }
    /* the head in the middle of the first bend: cable behind it, with its share; rope ahead */
    def.n_steps = 0;
    const double head = route.piece[1].s0 + 7;
    for (int way = 0; way < PLAN_WAYS; way++) {
        const PlanPullDef what = {.way = way, .head = head};
        const double toward = way ? -1 : 1;
        Pull pull;
        assert_int_equal(plan_pull(&def, &what, &pull, NULL), HAWSER_OK);
        const PullPoint behind = pull_at(&pull, head - toward), ahead = pull_at(&pull, head + toward);
        check_close(behind.sidewall, 0.5 * behind.tension / 10, 1e-9);
        check_close(ahead.sidewall, ahead.tension / 10, 1e-9);
        check_share(ahead.tension, pull_at(&pull, head).tension * exp(0.1 * 0.1), 1e-10);
        pull_clear(&pull);
        HeadSeries s;
        int at_end = 0;
        assert_int_equal(plan_heads(&def, way, INFINITY, &s, NULL), HAWSER_OK);
        for (int i = 0; i < s.n; i++) at_end += s.row[i].head == (way ? 0 : route.length);
        assert_int_equal(at_end, 1); /* a corner of the route, though the pull goes on */
        check_equal(s.row[s.n - 1].head, way ? -6 : route.length + 6);
        check_equal(s.row[0].head, way ? route.length : 0);
        plan_heads_free(&s);
    }
    route_clear(&route);
}
