/* Derivatives of the pulling theory: against central differences, closed forms, and their own adjoint. */
#include "theory/plan.h"

#include <stdlib.h>
#include <string.h>

#include "tests/support/check.h"

static const double PI = 3.14159265358979323846;

/* Slopes, a crest and a sag in a vertical plane (where the support changes sides), a level bend and one that climbs. */
static Route hill_route(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .name = "up", .length = 60},
        {.kind = ROUTE_BEND, .name = "crest", .radius = 10, .angle = 0.4, .plane = 3 * PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "down", .length = 40},
        {.kind = ROUTE_BEND, .name = "sag", .radius = 60, .angle = 0.9, .plane = PI / 2},
        {.kind = ROUTE_BEND, .name = "turn", .radius = 8, .angle = PI / 2, .plane = 0},
        {.kind = ROUTE_BEND, .name = "twist", .radius = 8, .angle = 0.5, .plane = 1},
    };
    Route route;
    assert_int_equal(route_build(&route, 6, def, v3(0, 0, 0), 0, 0.2, NULL), HAWSER_OK);
    return route;
}

enum { STRETCHES = 2, PUSHES = 2, CAUSES = CHANGE_OTHERS + STRETCHES + PUSHES };

/* All that a scene may vary. */
typedef struct Case {
    Route route;
    PullStretch stretch[STRETCHES];
    PullStep push[PUSHES], step[2];
    PlanWear wear[1];
    PlanDef def;
} Case;

static void case_make(Case *c, int separate, PullLaw law)
{
    c->route = hill_route();
    c->stretch[0] = (PullStretch){.weight = 200, .mu = 0.25, .separate = separate};
    c->stretch[1] = (PullStretch){.from = 75, .weight = 150, .mu = 0.15, .separate = separate};
    c->push[0] = (PullStep){.at = 30, .force = 700};
    c->push[1] = (PullStep){.at = c->route.piece[4].s0, .force = -300};
    c->wear[0] = (PlanWear){50, 1.3};
    c->def = (PlanDef){.route = &c->route,
                       .law = law,
                       .n_stretches = STRETCHES,
                       .stretch = c->stretch,
                       .reel_length = 15,
                       .rope_length = 5,
                       .back_tension = 900,
                       .n_pushes = PUSHES,
                       .push = c->push,
                       .step = c->step,
                       .n_wear = 1,
                       .wear = c->wear,
                       .wear_by = WEAR_CABLE};
}

/* A cause of a change by so much. */
static void change(Case *c, int k, double by)
{
    if (k == CHANGE_START) c->def.back_tension += by;
    for (int j = 0; j < STRETCHES; j++) {
        if (k == CHANGE_FRICTION || k == CHANGE_OTHERS + j) c->stretch[j].mu += by;
        if (k == CHANGE_WEIGHT) c->stretch[j].weight += by;
    }
    if (k == CHANGE_WEIGHT && c->def.lightest > 0) c->def.lightest += by;
    if (k >= CHANGE_OTHERS + STRETCHES) c->push[k - CHANGE_OTHERS - STRETCHES].force += by;
}

/* Winch's force, tension and support at places. */
enum { PLACES = 9 };
typedef struct Seen {
    double force, tension[PLACES], support[PLACES];
} Seen;

/* Away from corners of the route, where the support's force jumps. */
static double place(const Case *c, int i) { return c->route.length * (0.07 + i * 0.11); }

static Seen see(const Case *c, int way)
{
    Plan plan;
    Seen seen;
    assert_int_equal(plan_build(&c->def, &plan, NULL), HAWSER_OK);
    seen.force = plan.way[way].force;
    for (int i = 0; i < PLACES; i++) {
        const PullPoint at = pull_at(&plan.way[way].pull, place(c, i));
        seen.tension[i] = at.tension;
        seen.support[i] = at.normal;
    }
    plan_clear(&plan);
    return seen;
}

static double slope(double before, double after, double by) { return (after - before) / (2 * by); }

TEST(central_differences)
{
    const struct {
        int separate, steps;
        PullLaw law;
        double lightest;
    } scene[] = {{0, 0, PULL_REFERENCE, 0},  {1, 0, PULL_REFERENCE, 0},  {0, 0, PULL_NO_CAPSTAN, 0},
                 {0, 2, PULL_REFERENCE, 0},  {0, 0, PULL_REFERENCE, 70}, {1, 0, PULL_REFERENCE, 70},
                 {0, 0, PULL_NO_CAPSTAN, 70}};
    for (size_t m = 0; m < sizeof scene / sizeof *scene; m++) {
        for (int way = 0; way < PLAN_WAYS; way++) {
            Case c;
            Plan plan;
            PlanChange d;
            case_make(&c, scene[m].separate, scene[m].law);
            c.step[0] = (PullStep){.at = 50, .force = 1000, .kind = STEP_TAKE};
            c.step[1] = (PullStep){.at = 120, .force = 1500, .kind = STEP_ANEW};
            c.def.n_steps = scene[m].steps;
            c.def.lightest = scene[m].lightest;
            /* with more corners the steps' error estimate is more often zero by chance: 1e-9 of 4 kN, divided by `by`
             */
            const double share = c.def.lightest > 0 ? 3e-5 : 3e-8;
            assert_int_equal(plan_build(&c.def, &plan, NULL), HAWSER_OK);
            assert_int_equal(plan_change(&c.def, &plan, way, &d, NULL), HAWSER_OK);
            assert_int_equal(d.n, CAUSES);
            assert_false(d.one_sided);
            for (int k = 0; k < CAUSES; k++) {
                /* so small that no corner moves over a place, so large that rounding is 1e-8 of the result */
                const double by =
                    k == CHANGE_FRICTION || (k >= CHANGE_OTHERS && k < CHANGE_OTHERS + STRETCHES) ? 1e-5 : 0.1;
                change(&c, k, -by);
                const Seen before = see(&c, way);
                change(&c, k, 2 * by);
                const Seen after = see(&c, way);
                change(&c, k, -by);
                const double force = slope(before.force, after.force, by);
                check_close(d.force[k], force, share * fmax(1, fabs(force)));
                for (int i = 0; i < PLACES; i++) {
                    double tension[CAUSES], support[CAUSES], reach;
                    plan_change_at(&d, place(&c, i), tension, support, &reach);
                    const double t = slope(before.tension[i], after.tension[i], by),
                                 s = slope(before.support[i], after.support[i], by);
                    check_close(tension[k], t, share * fmax(1, fabs(t)));
                    check_close(support[k], s, share * fmax(1, fabs(s)));
                }
            }
            plan_change_free(&d);
            plan_clear(&plan);
            route_clear(&c.route);
        }
    }
}

/* The adjoint: a newton more at a place. A push there of so much takes off what the sweep from the end says, and the
 * sweep over all of the route gives the derivative by the start. */
TEST(both_ways_round)
{
    for (int way = 0; way < PLAN_WAYS; way++) {
        Case c;
        Plan plan;
        PlanChange d;
        case_make(&c, 0, PULL_REFERENCE);
        assert_int_equal(plan_build(&c.def, &plan, NULL), HAWSER_OK);
        assert_int_equal(plan_change(&c.def, &plan, way, &d, NULL), HAWSER_OK);
        check_close(d.reach[0], d.force[CHANGE_START], 1e-12);
        double tension[CAUSES], support[CAUSES], reach;
        for (int i = 0; i < PLACES; i++) {
            plan_change_at(&d, place(&c, i), tension, support, &reach);
            /* the start's change here, carried on to the winch, is its change at the winch */
            check_close(reach * tension[CHANGE_START], d.force[CHANGE_START], 1e-10);
        }
        /* a push takes off what a newton there adds */
        plan_change_at(&d, c.push[0].at, tension, support, &reach);
        check_close(-reach, d.force[CHANGE_OTHERS + STRETCHES], 1e-9);
        plan_change_free(&d);
        plan_clear(&plan);
        route_clear(&c.route);
    }
}

/* A level bend without weight: F = T exp(mu angle). */
TEST(capstan)
{
    const double mu = 0.3, angle = 1.1;
    const RoutePieceDef piece[] = {{.kind = ROUTE_BEND, .name = "turn", .radius = 5, .angle = angle, .plane = 0}};
    Route route;
    assert_int_equal(route_build(&route, 1, piece, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch rope = {.weight = 0, .mu = mu};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &rope, .back_tension = 1000};
    Plan plan;
    PlanChange d;
    assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
    assert_int_equal(plan_change(&def, &plan, PLAN_FORWARD, &d, NULL), HAWSER_OK);
    check_close(d.force[CHANGE_START], exp(mu * angle), 1e-11);
    check_close(d.force[CHANGE_FRICTION], 1000 * angle * exp(mu * angle), 1e-8);
    check_close(d.reach[0], exp(mu * angle), 1e-11);
    plan_change_free(&d);
    plan_clear(&plan);
    route_clear(&route);
}

/* A machine that takes just what arrives: its values are for less tension, and that is said. With a little less or
 * more the derivative is 0 or that of the rest of the way. */
TEST(at_a_corner)
{
    const RoutePieceDef piece[] = {{.kind = ROUTE_STRAIGHT, .name = "level", .length = 100}};
    Route route;
    assert_int_equal(route_build(&route, 1, piece, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    static const struct {
        double more, by_start;
        int one_sided;
    } row[] = {{-1, 1, 0}, {0, 0, 1}, {1, 0, 0}};
    for (int i = 0; i < 6; i++) { /* of a cable, and of a thread */
        const double scale = i < 3 ? 1 : ldexp(1, -13), arrives = 1000 + 50 * 100 * 0.25;
        const PullStretch cable = {.weight = 100 * scale, .mu = 0.25};
        const PullStep machine = {.at = 50, .force = (arrives + row[i % 3].more) * scale, .kind = STEP_TAKE};
        const PlanDef def = {.route = &route,
                             .n_stretches = 1,
                             .stretch = &cable,
                             .back_tension = 1000 * scale,
                             .n_steps = 1,
                             .step = &machine};
        Plan plan;
        PlanChange d;
        assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
        assert_int_equal(plan_change(&def, &plan, PLAN_FORWARD, &d, NULL), HAWSER_OK);
        check_close(d.force[CHANGE_START], row[i % 3].by_start, 1e-12);
        assert_int_equal(d.one_sided, row[i % 3].one_sided);
        plan_change_free(&d);
        plan_clear(&plan);
    }
    route_clear(&route);
}

/* A frame with these vertical components, a bend of 10 m's radius. */
static SpanLaw bend_law(double tz, double nz, double bz, int separate)
{
    return (SpanLaw){.law = PULL_REFERENCE,
                     .direction = 1,
                     .weight = 200,
                     .mu = 0.3,
                     .separate = separate,
                     .line = {.curvature = 0.1, .turning = 0.1, .tz = tz, .nz = nz, .bz = bz}};
}

/* (SN2), (SN3) against differences of the support forces, in frames of all directions, pulled and pushed; and their
 * limits: an upright bend, no tension, no bend. */
TEST(slopes_of_supports)
{
    const double by = 1e-3;
    for (int i = 0; i < 400; i++) {
        const double up = 0.1 + 2.9 * (i % 20) / 20, turn = 0.2 + 6.2 * (i / 20) / 20, T = (i % 7 - 3.3) * 700;
        const int law = i % 3 ? PULL_REFERENCE : PULL_NO_CAPSTAN;
        for (int separate = 0; separate < 2; separate++) {
            SpanLaw p = bend_law(cos(up), sin(up) * cos(turn), sin(up) * sin(turn), separate);
            p.law = (PullLaw)law;
            const SpanSlopes found = span_slopes(&p, 0, T);
            const double tension = slope(span_normal(&p, 0, T - by), span_normal(&p, 0, T + by), by);
            SpanLaw light = p, heavy = p;
            light.weight -= by, heavy.weight += by;
            check_close(found.by_tension, tension, 1e-6);
            check_close(found.by_weight, slope(span_normal(&light, 0, T), span_normal(&heavy, 0, T), by), 1e-6);
        }
    }
    for (int sign = -1; sign <= 1; sign += 2) { /* upright: no weight on anything, the bend's force alone */
        const SpanLaw p = bend_law(1, 0, 0, 1);
        check_close(span_slopes(&p, 0, sign * 500).by_tension, sign * 0.1, 1e-15);
        check_equal(span_slopes(&p, 0, sign * 500).by_weight, 0);
    }
    const SpanLaw aside = bend_law(0, 0, 1, 1), sag = bend_law(0, 1, 0, 0), crest = bend_law(0, -1, 0, 0);
    check_close(span_slopes(&aside, 0, 0).by_tension, 0.1, 1e-15); /* as it begins */
    check_close(span_slopes(&aside, 0, 0).by_weight, 1, 1e-15);
    check_close(span_slopes(&sag, 0, 0).by_tension, -0.1, 1e-15);
    check_close(span_slopes(&crest, 0, 0).by_tension, 0.1, 1e-15);
    SpanLaw bare = bend_law(1, 0, 0, 0);
    bare.weight = 0;
    check_close(span_slopes(&bare, 0, 0).by_tension, 0.1, 1e-15);
    /* a sag in which the tension just carries the weight: on neither side */
    check_equal(span_slopes(&sag, 0, 2000).by_tension, 0);
    check_equal(span_slopes(&sag, 0, 2000).by_weight, 0);
}

/* (SN4) against differences of the integrated law, where a cable lifts off, settles, and is pushed before it is pulled;
 * either way along the route. */
TEST(gains_across_corners)
{
    const double L = 11;
    int lifts = 0, tightens = 0;
    for (int i = 0; i < 120; i++) {
        const int separate = i & 1, back = i & 2;
        const double up = 0.3 + 0.11 * (i % 24), turn = separate ? 0.4 + 0.26 * (i / 5 % 24) : i & 4 ? 0 : PI;
        SpanLaw p = bend_law(cos(up), sin(up) * cos(turn), sin(up) * sin(turn), separate);
        const double s0 = back ? L : 0, s1 = back ? 0 : L, T = (i % 9 - 3) * 450 + 17;
        p.direction = back ? -1 : 1;
        const SpanGain gain = span_gain(&p, s0, T, s1);
        const double end = span_integrate(&p, s0, T, s1, NULL);
        SpanLaw less = p, more = p;
        less.mu -= 1e-5, more.mu += 1e-5;
        const double friction =
            slope(span_integrate(&less, s0, T, s1, NULL), span_integrate(&more, s0, T, s1, NULL), 1e-5);
        less = more = p;
        less.weight -= 0.01, more.weight += 0.01;
        const double weight =
            slope(span_integrate(&less, s0, T, s1, NULL), span_integrate(&more, s0, T, s1, NULL), 0.01);
        const double tension =
            slope(span_integrate(&p, s0, T - 0.1, s1, NULL), span_integrate(&p, s0, T + 0.1, s1, NULL), 0.1);
        check_close(gain.tension, tension, 1e-4);
        check_close(gain.friction, friction, 1e-4 * (fabs(end) + 2000));
        check_close(gain.weight, weight, 1e-4 * (fabs(weight) + 10));
        const SpanParts first = span_parts(&p, s0, T), last = span_parts(&p, s1, end);
        lifts += separate && first.down * last.down < 0;
        tightens += T * end < 0;
    }
    check_above(lifts, 5);
    check_above(tightens, 10);
}

/* A pit forgets what came before it, a machine that takes all too, one that takes less forgets nothing: on a straight,
 * where every derivative is a length. */
TEST(steps_forget)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = 60};
    Route route;
    assert_int_equal(route_build(&route, 1, &straight, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    const PullStep step[] = {{.at = 24, .force = 500, .kind = STEP_ANEW},
                             {.at = 24, .force = 5000, .kind = STEP_TAKE},
                             {.at = 24, .force = 400, .kind = STEP_TAKE}};
    for (int k = 0; k < 3; k++) {
        for (int way = 0; way < PLAN_WAYS; way++) {
            const PlanDef def = {.route = &route,
                                 .n_stretches = 1,
                                 .stretch = &cable,
                                 .back_tension = 100,
                                 .n_steps = 1,
                                 .step = &step[k]};
            Plan plan;
            PlanChange c;
            assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
            assert_int_equal(plan_change(&def, &plan, way, &c, NULL), HAWSER_OK);
            const double after = way ? 24 : 36, counts = k < 2 ? after : 60;
            check_equal(c.force[CHANGE_START], k == 2);
            check_close(c.force[CHANGE_FRICTION], 200 * counts, 1e-8);
            check_close(c.force[CHANGE_WEIGHT], 0.25 * counts, 1e-10);
            assert_int_equal(c.pull->n, 2);
            check_equal(c.reach[0], k == 2);
            check_equal(c.reach[1], 1);
            assert_int_equal(c.one_sided, 0);
            plan_change_free(&c);
            plan_clear(&plan);
        }
    }
    route_clear(&route);
}

/* A machine at the very end of the pull: one that takes all that arrives leaves nothing of any cause, one that takes
 * less leaves all of it, and just as much as arrives is a corner. */
TEST(machine_at_the_end)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = 60};
    Route route;
    assert_int_equal(route_build(&route, 1, &straight, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    const double arrives = 100 + 200 * 0.25 * 60, takes[] = {arrives + 1, arrives, arrives - 1};
    for (int k = 0; k < 3; k++) {
        for (int way = 0; way < PLAN_WAYS; way++) {
            const PullStep end = {.at = way == PLAN_BACKWARD ? 0 : 60, .force = takes[k], .kind = STEP_TAKE};
            const PlanDef def = {
                .route = &route, .n_stretches = 1, .stretch = &cable, .back_tension = 100, .n_steps = 1, .step = &end};
            Plan plan;
            PlanChange c;
            assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
            check_close(plan.way[way].force, k == 2 ? 1 : 0, 1e-9);
            assert_int_equal(plan_change(&def, &plan, way, &c, NULL), HAWSER_OK);
            assert_int_equal(c.one_sided, k == 1);
            check_close(c.force[CHANGE_START], k == 2, 1e-12);
            check_close(c.force[CHANGE_FRICTION], k == 2 ? 200 * 60 : 0, 1e-8);
            check_close(c.force[CHANGE_WEIGHT], k == 2 ? 0.25 * 60 : 0, 1e-10);
            assert_int_equal(c.pull->n, 1);
            check_close(c.reach[0], k == 2, 1e-12);
            double tension[CHANGE_OTHERS + 1], support[CHANGE_OTHERS + 1], reach;
            plan_change_at(&c, 30, tension, support, &reach);
            check_close(tension[CHANGE_START], 1, 1e-12); /* on the way all of it is there */
            check_close(tension[CHANGE_FRICTION], 200 * 30, 1e-8);
            check_close(reach, k == 2, 1e-12);
            plan_change_free(&c);
            plan_clear(&plan);
        }
    }
    route_clear(&route);
}

/* On separate supports a level bend has T' = mu (w + |T|/R): from a push to a pull, and back along the route, gains by
 * the closed form, across the corner at T = 0. */
TEST(gains_by_closed_forms)
{
    const double mu = 0.3, w = 200, R = 10, c = w * R;
    const double starts[] = {-1500, -400, 0, 300};
    for (int i = 0; i < 4; i++) {
        for (int back = 0; back < 2; back++) {
            SpanLaw p = bend_law(0, 0, 1, 1);
            p.direction = back ? -1 : 1;
            const double T = starts[i], L = 25, e = exp(mu * L / R);
            const SpanGain gain = span_gain(&p, back ? L : 0, T, back ? 0 : L);
            double end, by_tension, by_friction, by_weight;
            if (T >= 0) { /* T2 = (T + wR) e - wR */
                end = (T + c) * e - c;
                by_tension = e;
                by_friction = L / R * (T + c) * e;
                by_weight = R * (e - 1);
            } else { /* |T| + wR falls to wR, then grows: T2 = c^2 e/(|T| + c) - c */
                const double a = -T + c;
                end = c * c * e / a - c;
                by_tension = c * c * e / (a * a);
                by_friction = L / R * c * c * e / a;
                by_weight = R * (2 * c * e / a - c * c * e / (a * a) - 1);
            }
            check_close(span_integrate(&p, back ? L : 0, T, back ? 0 : L, NULL), end, 1e-6);
            check_share(gain.tension, by_tension, 1e-11);
            check_share(gain.friction, by_friction, 1e-11);
            check_close(gain.weight, by_weight, 1e-10);
        }
    }
}

/* Where nothing arrives at a machine, as at the reel without a brake, it takes what more would come, and has nothing to
 * take of less: a corner too. Not for one that takes nothing, and not behind another one that takes all. */
TEST(machine_without_work)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .name = "s", .length = 60};
    Route route;
    assert_int_equal(route_build(&route, 1, &straight, v3(0, 0, 0), 0, 0, NULL), HAWSER_OK);
    const PullStretch cable = {.weight = 200, .mu = 0.25};
    const struct {
        double back_tension, takes[2];
        int one_sided;
        double by_start;
    } row[] = {{0, {500, 0}, 1, 1},   {0, {0, 0}, 0, 1},       {100, {500, 0}, 0, 0},  {100, {500, 300}, 0, 0},
               {600, {500, 0}, 0, 1}, {600, {500, 100}, 1, 0}, {600, {500, 300}, 0, 0}};
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const PullStep machine[] = {{.force = row[k].takes[0], .kind = STEP_TAKE},
                                    {.force = row[k].takes[1], .kind = STEP_TAKE}};
        const PlanDef def = {.route = &route,
                             .n_stretches = 1,
                             .stretch = &cable,
                             .back_tension = row[k].back_tension,
                             .n_steps = 2,
                             .step = machine};
        Plan plan;
        PlanChange c;
        assert_int_equal(plan_build(&def, &plan, NULL), HAWSER_OK);
        assert_int_equal(plan_change(&def, &plan, PLAN_FORWARD, &c, NULL), HAWSER_OK);
        assert_int_equal(c.one_sided, row[k].one_sided);
        check_close(c.force[CHANGE_START], row[k].by_start, 1e-12);
        check_close(c.force[CHANGE_FRICTION], 200 * 60, 1e-8);
        plan_change_free(&c);
        plan_clear(&plan);
    }
    route_clear(&route);
}
