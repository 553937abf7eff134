/* Every allocation of the theory fails once: that is said as a lack of memory, nothing stays allocated, and the next
 * try gives the same number as if nothing had been. */
#include <stdlib.h>

#include "tests/support/lack.h"

#include <string.h>

#include "tests/support/check.h"
#include "theory/place.h"
#include "theory/plan.h"

enum { MOST = 3000 };

/* A plan over a hill with everything that a plan may have. */
typedef struct Scene {
    Route route;
    PullStretch stretch[2];
    PullStep push[1], step[2];
    PlanWear wear[1];
    PlanDef def;
    Plan plan;
} Scene;

static void scene_make(Scene *s)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 30},
                                 {.kind = ROUTE_BEND, .radius = 10, .angle = 0.8, .plane = M_PI / 2},
                                 {.kind = ROUTE_STRAIGHT, .length = 25},
                                 {.kind = ROUTE_BEND, .radius = 8, .angle = 1, .plane = 0}};
    *s = (Scene){.stretch = {{.weight = 200, .mu = 0.25, .mu_static = 0.3, .mu_rope = 0.1},
                             {.from = 35, .weight = 150, .mu = 0.2, .mu_rope = 0.1}},
                 .push = {{.at = 20, .force = 300}},
                 .step = {{.at = 40, .force = 500, .kind = STEP_TAKE}, {.at = 50, .force = 700, .kind = STEP_ANEW}},
                 .wear = {{.from = 10, .factor = 1.1}}};
    assert_int_equal(route_build(&s->route, 4, def, V3_ZERO, 0, -0.4, NULL), HAWSER_OK);
    s->def = (PlanDef){.route = &s->route,
                       .n_stretches = 2,
                       .stretch = s->stretch,
                       .back_tension = 500,
                       .n_pushes = 1,
                       .push = s->push,
                       .n_steps = 2,
                       .step = s->step,
                       .n_wear = 1,
                       .wear = s->wear,
                       .wear_by = WEAR_CABLE};
    assert_int_equal(plan_build(&s->def, &s->plan, NULL), HAWSER_OK);
}

static void scene_free(Scene *s)
{
    plan_clear(&s->plan);
    route_clear(&s->route);
}

/* Something that allocates, and gives all of it back whether it succeeded or not; *value: what it found. */
typedef hawser_status (*Allocating)(const Scene *s, double *value, hawser_error *err);

static hawser_status plans(const Scene *s, double *value, hawser_error *err)
{
    Plan plan;
    const hawser_status status = plan_build(&s->def, &plan, err);
    *value = status ? NAN : plan.way[PLAN_FORWARD].force + plan.way[PLAN_BACKWARD].restart_force;
    if (status) assert_null(plan.way[PLAN_FORWARD].pull.span);
    if (!status) plan_clear(&plan);
    return status;
}

static hawser_status one_head(const Scene *s, double *value, hawser_error *err)
{
    HeadForce force = {0};
    const hawser_status status = plan_head(&s->def, PLAN_FORWARD, 45, &force, err);
    *value = force.force;
    return status;
}

static hawser_status heads(const Scene *s, double *value, hawser_error *err)
{
    HeadSeries series;
    const hawser_status status = plan_heads(&s->def, PLAN_BACKWARD, 9, &series, err);
    *value = status ? NAN : series.peak.force + series.restart_peak.restart;
    if (status) assert_null(series.row);
    if (!status) plan_heads_free(&series);
    return status;
}

static hawser_status ropes(const Scene *s, double *value, hawser_error *err)
{
    RopeSeries rope;
    const hawser_status status = plan_rope(&s->def, PLAN_FORWARD, 1, 12, 9, &rope, err);
    *value = status ? NAN : rope.tension[rope.n - 1];
    if (status) assert_null(rope.tension);
    if (!status) plan_rope_free(&rope);
    return status;
}

static hawser_status brakes(const Scene *s, double *value, hawser_error *err)
{
    PlanDef def = s->def;
    def.back_tension = 0;
    Brake brake;
    const hawser_status status = plan_brake(&def, PLAN_FORWARD, &brake, err);
    *value = status ? NAN : brake.brake + brake.peak;
    return status;
}

static hawser_status changes(const Scene *s, double *value, hawser_error *err)
{
    PlanChange change;
    const hawser_status status = plan_change(&s->def, &s->plan, PLAN_FORWARD, &change, err);
    *value = status ? NAN : change.force[CHANGE_FRICTION];
    plan_change_free(&change);
    return status;
}

static hawser_status rollers(const Scene *s, double *value, hawser_error *err)
{
    const PlaceLine line = {
        .route = &s->route, .pull = &s->plan.way[PLAN_FORWARD].pull, .weight = 200, .to = s->route.length};
    const PlaceRule rule = {.straights = 0.4, .bends = 0.3, .reserve = 1.25, .guides = 1, .hold_downs = 1};
    PlacedRoller *r = NULL;
    int n = 0;
    const hawser_status status = place_by_rule(&line, &rule, 1000, &r, &n, err);
    *value = n;
    free(r);
    return status;
}

static hawser_status grids(const Scene *s, double *value, hawser_error *err)
{
    RouteGrid grid;
    const hawser_status status = route_grid_build(&s->route, 1, &grid, err);
    *value = status ? NAN : route_nearest(&grid, v3(20, 1, -8), 1).s;
    route_grid_clear(&grid);
    return status;
}

TEST(every_allocation)
{
    static const Allocating each[] = {plans, one_head, heads, ropes, brakes, changes, rollers, grids};
    Scene s;
    if (!lack_works()) skip();
    scene_make(&s);
    for (size_t i = 0; i < sizeof each / sizeof *each; ++i) {
        hawser_error err;
        double whole, value;
        assert_int_equal(each[i](&s, &whole, &err), HAWSER_OK);
        check_finite(whole);
        long k = 0;
        for (int met = 1; met; ++k) {
            assert_true(k < MOST);
            err = (hawser_error){0};
            const long before = lack_live();
            lack_after(k);
            const hawser_status status = each[i](&s, &value, &err);
            met = lack_end();
            assert_int_equal(status, met ? HAWSER_ERR_MEMORY : HAWSER_OK);
            assert_int_equal(err.status, status);
            assert_int_equal(lack_live(), before);
        }
        assert_true(k > 1);
        check_equal(value, whole);
    }
    scene_free(&s);
}
