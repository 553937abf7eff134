/* The peaks over all places of the head, found by following the tightest rope alone, against those of all the rows;
 * what that rope has along the route; and what bounds the work of a route with thousands of corners. */
#include "theory/plan.h"

#include <stdlib.h>

#include "tests/support/check.h"

/* Up, round, steeply down, round, a little up: the largest force lies within. */
static Route crest_route(void)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_STRAIGHT, .name = "up", .length = 60},
        {.kind = ROUTE_BEND, .name = "over", .radius = 15, .angle = 0.9, .plane = -M_PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "down", .length = 80},
        {.kind = ROUTE_BEND, .name = "aside", .radius = 10, .angle = 1.2},
        {.kind = ROUTE_BEND, .name = "under", .radius = 20, .angle = 0.8, .plane = M_PI / 2},
        {.kind = ROUTE_STRAIGHT, .name = "on", .length = 30},
    };
    Route route;
    assert_int_equal(route_build(&route, 6, def, v3(0, 0, 0), 0, 0.4, NULL), HAWSER_OK);
    return route;
}

static void check_peaks(const PlanDef *def)
{
    for (int way = 0; way < PLAN_WAYS; ++way) {
        HeadSeries rows, alone;
        assert_int_equal(plan_heads(def, way, INFINITY, &rows, NULL), HAWSER_OK);
        assert_int_equal(plan_peaks(def, way, NULL, &alone, NULL), HAWSER_OK);
        check_share(alone.peak.force, rows.peak.force, 1e-12);
        check_share(alone.restart_peak.restart, rows.restart_peak.restart, 1e-12);
        check_close(alone.peak.head, rows.peak.head, 1e-9);
        check_close(alone.restart_peak.head, rows.restart_peak.head, 1e-9);
        plan_heads_free(&rows);
        plan_heads_free(&alone);
    }
}

TEST(as_the_rows_have_them)
{
    Route route = crest_route();
    const PullStretch lies[] = {{.from = -1, .weight = 200, .mu = 0.25, .mu_static = 0.4, .mu_rope = 0.3},
                                {.from = 90, .weight = 200, .mu = 0.1, .mu_static = 0.1, .mu_rope = 0.2}};
    const PullStep step[] = {{.at = 40, .force = 2000, .kind = STEP_TAKE},
                             {.at = 120, .force = 700, .kind = STEP_ANEW},
                             {.at = 170, .force = 500, .kind = STEP_TAKE}};
    const PlanWear wear[] = {{.from = 50, .factor = 1.5}};
    PlanDef def = {.route = &route, .n_stretches = 2, .stretch = lies, .reel_length = 15, .rope_length = 5};
    check_peaks(&def);
    def.rope_weight = 8;
    def.back_tension = 3000;
    check_peaks(&def);
    def.step = step;
    def.n_steps = 3;
    check_peaks(&def);
    def.wear = wear;
    def.n_wear = 1;
    check_peaks(&def);
    def.wear_by = WEAR_PLACE;
    check_peaks(&def);
    def.beyond = -20;
    check_peaks(&def);
    route_clear(&route);
}

/* N at s with the head at `head`, and rope from there on. */
static double tension_with(const PlanDef *def, int way, int restart, double head, double s)
{
    const PlanPullDef what = {.way = way, .restart = restart, .head = head};
    Pull pull;
    assert_int_equal(plan_pull(def, &what, &pull, NULL), HAWSER_OK);
    const double tension = pull_at(&pull, s).tension;
    pull_clear(&pull);
    return tension;
}

static int is_step(const PlanDef *def, double s)
{
    int step = 0;
    for (int i = 0; i < def->n_steps; ++i) step |= fabs(def->step[i].at - s) < 1e-6;
    return step;
}

/* At each place it is the most of all heads up to there, of the same section. */
static void check_rope(const PlanDef *def, int way, int restart)
{
    RopeSeries rope;
    assert_int_equal(plan_rope(def, way, restart, way ? 200 : 0, 5, &rope, NULL), HAWSER_OK);
    int earlier = 0; /* places at which the rope was tighter before the head came there */
    for (int i = 0; i < rope.n; i += 3) {
        double most = -INFINITY;
        if (is_step(def, rope.s[i])) continue;
        const double begins = plan_section_at(def, way, rope.s[i]).from;
        for (int k = 0; k <= i; ++k) {
            if ((rope.s[k] - begins) * (way ? -1 : 1) <= 0) continue;
            most = fmax(most, tension_with(def, way, restart, rope.s[k], rope.s[i]));
        }
        if (isfinite(most)) check_close(rope.tension[i], most, 1e-9 * fabs(most) + 1e-9);
        check_close(drawn_at(&(Drawn){.rope = &rope}, rope.s[i]), rope.tension[i], 1e-9 * fabs(rope.tension[i]));
        earlier += most > tension_with(def, way, restart, rope.s[i], rope.s[i]) * (1 + 1e-9);
    }
    assert_true(way || earlier > 5);
    plan_rope_free(&rope);
}

/* Rope ahead is tighter while the head is on the crest than when it comes down. */
TEST(the_tightest_rope)
{
    Route route = crest_route();
    const PullStretch lies[] = {{.from = -1, .weight = 200, .mu = 0.25, .mu_static = 0.4, .mu_rope = 0.3},
                                {.from = 90, .weight = 200, .mu = 0.1, .mu_static = 0.1, .mu_rope = 0.2}};
    const PullStep step[] = {{.at = 41, .force = 2000, .kind = STEP_TAKE},
                             {.at = 131, .force = 700, .kind = STEP_ANEW}};
    PlanDef def = {.route = &route, .n_stretches = 2, .stretch = lies, .reel_length = 15, .rope_weight = 8};
    for (def.n_steps = 0; def.n_steps <= 2; def.n_steps += 2) {
        def.step = step;
        for (int k = 0; k < 4; ++k) check_rope(&def, k / 2, k % 2);
    }
    route_clear(&route);
}

/* With the head at one place it is that pull's; before it, and beyond what was asked for, nothing is touched; where the
 * head begins behind all places there is none. */
TEST(the_rope_of_one_head)
{
    Route route = crest_route();
    const PullStretch lies = {.weight = 200, .mu = 0.25, .mu_static = 0.25, .mu_rope = 0.3};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &lies, .reel_length = 15, .rope_weight = 8};
    for (int way = 0; way < PLAN_WAYS; ++way) {
        const double head = way ? 150.3 : 66.7, until = way ? 31 : 161;
        RopeSeries rope;
        assert_int_equal(plan_rope(&def, way, 0, head, 4, &rope, NULL), HAWSER_OK);
        check_equal(drawn_at(&(Drawn){.rope = &rope}, way ? 170 : 20), 0);
        plan_rope_free(&rope);
        assert_int_equal(plan_rope(&def, way, 0, way ? route.length : 0, 4, &rope, NULL), HAWSER_OK);
        double *const tension = calloc((size_t)rope.n, sizeof *tension);
        assert_non_null(tension);
        const double there = rope.tension[0];
        plan_rope_ahead(&def, &rope, rope.s[0], until, tension);
        check_equal(tension[0], 0);
        for (int i = 1; i < rope.n; ++i) {
            const int asked = way ? rope.s[i] >= until : rope.s[i] <= until;
            const double with = tension_with(&def, way, 0, rope.s[0], rope.s[i]);
            if (asked) check_close(tension[i], with, 1e-9 * fabs(there) + 1e-9 * fabs(with));
            if (!asked) check_equal(tension[i], 0);
        }
        free(tension);
        plan_rope_free(&rope);
        assert_int_equal(plan_rope(&def, way, 0, way ? -5 : 1e4, 4, &rope, NULL), HAWSER_OK);
        assert_int_equal(rope.n, 0);
        check_equal(drawn_at(&(Drawn){.rope = &rope}, 20), 0);
        plan_rope_free(&rope);
    }
    route_clear(&route);
}

/* Of thousands of corners only some have a row; the peak is that of all of them. */
TEST(rows_of_many_corners)
{
    enum { PIECES = 2500 };
    RoutePieceDef *const piece = calloc(PIECES, sizeof *piece);
    assert_non_null(piece);
    for (int i = 0; i < PIECES; ++i) {
        piece[i] = (RoutePieceDef){.kind = i % 2 ? ROUTE_BEND : ROUTE_STRAIGHT, .name = "p", .length = 1};
        if (i % 2) piece[i].radius = 20;
        if (i % 2) piece[i].angle = 0.004;
        if (i % 4 == 1) piece[i].plane = M_PI;
    }
    Route route;
    assert_int_equal(route_build(&route, PIECES, piece, v3(0, 0, 0), 0, -0.05, NULL), HAWSER_OK);
    const PullStretch lies = {.weight = 150, .mu = 0.2, .mu_static = 0.2, .mu_rope = 0.2};
    const PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &lies, .reel_length = 15, .rope_weight = 5};
    HeadSeries rows, alone;
    assert_int_equal(plan_heads(&def, PLAN_FORWARD, 10, &rows, NULL), HAWSER_OK);
    assert_int_equal(plan_peaks(&def, PLAN_FORWARD, NULL, &alone, NULL), HAWSER_OK);
    assert_in_range(rows.n, 100, 500);
    check_close(rows.row[rows.n - 1].head, route.length, 0);
    check_equal(rows.peak.force, alone.peak.force);
    for (int i = 0; i < rows.n; ++i) check_at_least(rows.peak.force, rows.row[i].force);
    plan_heads_free(&rows);
    plan_heads_free(&alone);
    route_clear(&route);
    free(piece);
}

/* What is of no interest is not followed: a tension beyond `enough` ends the pull, one below it changes nothing. */
TEST(enough_is_enough)
{
    Route route = crest_route();
    const PullStretch lies = {.weight = 200, .mu = 0.25, .mu_static = 0.25, .mu_rope = 0.3};
    PlanDef def = {.route = &route, .n_stretches = 1, .stretch = &lies, .reel_length = 15};
    Plan all, some;
    hawser_error err;
    assert_int_equal(plan_build(&def, &all, NULL), HAWSER_OK);
    const double most = all.way[PLAN_FORWARD].pull.max_tension;
    def.skip[PLAN_BACKWARD] = 1;
    def.enough = 1.001 * most;
    assert_int_equal(plan_build(&def, &some, NULL), HAWSER_OK);
    check_equal(some.way[PLAN_FORWARD].force, all.way[PLAN_FORWARD].force);
    plan_clear(&some);
    def.enough = 0.999 * most;
    assert_int_equal(plan_build(&def, &some, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "grows past all bounds");
    plan_clear(&all);
    route_clear(&route);
}
