/* What is reckoned about a scene, and the way of a rod past its critical load, with each allocation failing once: told
 * as a lack of memory, nothing left behind, and with memory the same as ever. */
#include "tests/support/lack.h"

#include <math.h>
#include <string.h>

#include "sim/run/statics.h"
#include "tests/support/kinds.h"
#include "tests/support/rig.h"
#include "theory/inverse.h"

enum { MOST = 3000 };

/* Anything that is made and given back; *sum tells what came out. */
typedef hawser_status Attempt(const Scene *scene, double *sum, hawser_error *err);

static void every_allocation(Attempt *attempt, const Scene *scene, int least)
{
    double whole = 0;
    hawser_error err = {0};
    if (attempt(scene, &whole, &err)) fail_msg("%s", err.message);
    const long live = lack_live();
    int told = 0;
    for (int k = 0, met = 1; met; ++k) {
        check_below(k, MOST);
        double sum = 0;
        err = (hawser_error){0};
        lack_after(k);
        const hawser_status status = attempt(scene, &sum, &err);
        met = lack_end();
        told += status != HAWSER_OK;
        if (!status) check_equal(sum, whole);
        assert_int_equal(lack_live(), live);
        if (status && (!met || status != HAWSER_ERR_MEMORY || !strstr(err.message, " memory")))
            fail_msg("allocation %d: status %d, '%s'", k, status, err.message);
    }
    check_at_least(told, least);
}

/* A pull over rollers and through a conveyor, with machines, pits and limits to be kept. */
static void define_limited(SceneDef *def)
{
    define_conveyor(def);
    def->n_jams = 0;
    def->limits =
        (LimitsDef){.present = 1,
                    .K = 1,
                    .grips = 1,
                    .own = {[HAWSER_LIMIT_PULL] = 3000, [HAWSER_LIMIT_SIDEWALL] = 2000, [HAWSER_LIMIT_WINCH] = 5000}};
    TheoryDef *const t = &def->theory;
    t->machine_push = 500;
    t->n_machines = t->n_pits = 1;
    t->machines = fixture_array(1, sizeof *t->machines);
    t->pits = fixture_array(1, sizeof *t->pits);
    t->machines[0] = (TheoryPlaceDef){"machine", 8, 300};
    t->pits[0] = (TheoryPlaceDef){"pit", 11, 200};
    t->n_friction = 1;
    t->friction = fixture_array(1, sizeof *t->friction);
    t->friction[0] = (TheoryFrictionDef){4, 6, 0.3, 0.35};
    def->n_script = 1; /* what it takes away is asked, too */
    def->script = fixture_array(1, sizeof *def->script);
    def->script[0].command = (Command){.kind = HAWSER_FRICTION, .value = 0.5};
    def->rollers[0].s = NAN; /* listed: its place on the route is looked for */
}

static hawser_status calculated(const Scene *scene, double *sum, hawser_error *err)
{
    Setup setup;
    Calculator c = {.cables = 0};
    hawser_status status = setup_make(&scene->def, &setup, err);
    if (!status) status = calculator_build(&setup, &(Expected){.largest_start = 500}, 0, &c, err);
    if (!status) {
        check_above(c.n_limits, 0);
        for (int way = 0; way < PLAN_WAYS; ++way) *sum += c.limit[way][0].value;
    }
    calculator_free(&c);
    setup_free(&setup);
    return status;
}

static hawser_status varied(const Scene *scene, double *sum, hawser_error *err)
{
    static const PullStep step[] = {{3, 200, STEP_TAKE}, {12, 200, STEP_TAKE}};
    Calculator base, c = {.cables = 0};
    const long left = lack_left();
    lack_after(-1);
    if (calculator_build(&scene->setup, &(Expected){.largest_start = 500}, 0, &base, err)) fail_msg("%s", err->message);
    lack_after(left);
    const Variation by = {.friction = 1.5, .radius = 2, .bend = -1, .beyond = 3, .n_steps = 2, .step = step};
    const hawser_status status = calculator_vary(&scene->setup, &base, &by, &c, err);
    if (!status) *sum = c.limit[0][0].value;
    calculator_free(&c);
    calculator_free(&base);
    return status;
}

/* What just keeps the limits is searched with very many allocations, of which the first ones fail and some of the
 * others. */
static void inverted(const Scene *scene)
{
    Calculator base;
    Inverse out;
    hawser_error err = {0};
    if (calculator_build(&scene->setup, &(Expected){.largest_start = 500}, 0, &base, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < 20000; k += k < 60 ? 1 : k / 4) {
        err = (hawser_error){0};
        lack_after(k);
        const hawser_status status = inverse_find(&scene->setup, &base, &out, &err);
        assert_true(lack_end());
        assert_int_equal(status, HAWSER_ERR_MEMORY);
        check_has(err.message, "out of memory");
    }
    calculator_free(&base);
}

TEST(test_calculators)
{
    if (!lack_works()) skip();
    SceneDef def;
    Scene scene;
    define_limited(&def);
    fixture_build(&def, &scene);
    every_allocation(calculated, &scene, 40);
    every_allocation(varied, &scene, 20);
    inverted(&scene);
    scene_clear(&scene);
}

/* ------------------------------------------------------------------------------------------------ critical loads */

/* A column that is pressed beyond its Euler load, pinned at its tail and led at its head. */
static hawser_status pressed(StabilityChoice choice, LinKind kind, double *sum, hawser_error *err)
{
    const long left = lack_left();
    lack_after(-1);
    RodFixture f = {.n = 8, .length = 1, .steps = 2, .ea = 1e7, .ga = 1e7, .gj = 100, .ei_y = 100, .ei_z = 120};
    rod_hold(&f.rod.end[ROD_TAIL], 1);
    f.rod.end[ROD_HEAD].held[1] = f.rod.end[ROD_HEAD].held[2] = 1;
    f.rod.loads = fixture_array(2, sizeof *f.rod.loads);
    rod_load(&f.rod, 1, 0, 0, v3(-1, 0, 0), 1500);
    SceneDef def;
    Stage stage;
    rod_define(&def, &f);
    def.analysis.stability = choice;
    def.solver.linear.kind = kind;
    rod_stage(&def, &stage);
    hawser_relaxation out = {0};
    lack_after(left);
    hawser_status status = statics_settle(&stage, 1e-10, &out, err);
    for (int k = 1; k <= 2 && !status; ++k) status = statics_advance(&stage, 0.5 * k, &out, err);
    if (!status) *sum = stage.stability.n + rod_front(&stage, 7).x;
    stage_free(&stage);
    return status;
}

static hawser_status followed(const Scene *none, double *sum, hawser_error *err)
{
    (void)none;
    return pressed(STABILITY_FOLLOW, LIN_AUTO, sum, err);
}

static hawser_status reported(const Scene *none, double *sum, hawser_error *err)
{
    (void)none;
    return pressed(STABILITY_REPORT, LIN_KLU, sum, err);
}

TEST(test_critical)
{
    if (!lack_works()) skip();
    double sum = 0;
    hawser_error err = {0};
    assert_int_equal(reported(NULL, &sum, &err), HAWSER_OK);
    check_close(sum, 2, 1e-3); /* one critical load; it has stayed straight, its front at 1 m, hardly less */
    every_allocation(followed, NULL, 30);
    every_allocation(reported, NULL, 30);
}
