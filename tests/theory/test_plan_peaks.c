/* The peaks over all places of the head, found by following the tightest rope alone, against those of all the rows; and
 * what bounds the work of a route with thousands of corners. */
#include "theory/plan.h"
#include "theory/plan_head.h"

#include <stdlib.h>

#include "tests/support/check.h"

static const DuctLoad SINGLE = {.weight_factor = 1, .sidewall_factor = 1};

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
        assert_int_equal(plan_heads(def, &SINGLE, way, INFINITY, &rows, NULL), HAWSER_OK);
        assert_int_equal(plan_peaks(def, &SINGLE, way, &alone, NULL), HAWSER_OK);
        check_share(alone.peak.force, rows.peak.force, 1e-12);
        check_share(alone.restart_peak.restart, rows.restart_peak.restart, 1e-12);
        check_close(alone.peak.head, rows.peak.head, 1e-9);
        check_close(alone.restart_peak.head, rows.restart_peak.head, 1e-9);
        plan_heads_free(&rows);
        plan_heads_free(&alone);
    }
}

static void as_the_rows_have_them(void **state)
{
    (void)state;
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

/* Of thousands of corners only some have a row; the peak is that of all of them. */
static void rows_of_many_corners(void **state)
{
    enum { PIECES = 2500 };
    (void)state;
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
    assert_int_equal(plan_heads(&def, &SINGLE, PLAN_FORWARD, 10, &rows, NULL), HAWSER_OK);
    assert_int_equal(plan_peaks(&def, &SINGLE, PLAN_FORWARD, &alone, NULL), HAWSER_OK);
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
static void enough_is_enough(void **state)
{
    (void)state;
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

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(as_the_rows_have_them), cmocka_unit_test(rows_of_many_corners),
                                       cmocka_unit_test(enough_is_enough)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
