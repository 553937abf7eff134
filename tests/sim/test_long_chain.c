/* Chains so long that their factors are rounded to single precision (L20), (L21): what the rounding does to a pull's
 * steps and to its force, also where steps are as long as they get, and that two threads give the bits of one. */
#include "bench/scale_scenes.h"
#include "tests/support/check.h"

enum { SEGMENTS = 3001 }; /* just above LIN_ROUND_ENTRIES */

typedef struct Outcome {
    int size;
    double *y;    /* at the end */
    double force; /* of the winch, N */
    IntegratorStats took;
} Outcome;

static void must(hawser_status status, const hawser_error *err)
{
    if (status) fail_msg("%s", err->message);
}

static void stage_begin(Stage *stage, int precise, double interval, Team *team)
{
    SceneDef def;
    hawser_error err = {0};
    hawser_relaxation relaxation = {0};
    assert_true(pull_scene(&def, SEGMENTS, -1));
    def.solver.planar = PLANAR_OFF;
    def.solver.linear.precise = precise;
    def.output.interval = interval;
    must(stage_new(stage, &def, team, &err), &err);
    must(stage->motion->ops->relax(stage->motion, 0, stage->y, &relaxation, &err), &err);
    assert_true(relaxation.reached);
    assert_true(pull_begin(stage, 2));
    must(stage->motion->ops->renew(stage->motion, stage->t, stage->y, &err), &err);
    scene_def_clear(&def);
}

static void stage_go(Stage *stage, double duration)
{
    hawser_error err = {0};
    for (const double end = stage->t + duration; stage->t < end;) must(stage_step(stage, end, &err), &err);
}

static Outcome stage_end(Stage *stage)
{
    Outcome p = {.size = stage->motion->size};
    integrator_stats(stage->integrator, &p.took);
    p.y = malloc((size_t)p.size * sizeof *p.y);
    assert_non_null(p.y);
    memcpy(p.y, stage->y, (size_t)p.size * sizeof *p.y);
    p.force = stage->motion->ops->winch_pull(stage->motion, stage->t, stage->y);
    stage_free(stage);
    return p;
}

/* Of a straight pull at constant speed, after so many s. */
static Outcome outcome_of(int precise, double interval, double duration, Team *team)
{
    Stage stage;
    stage_begin(&stage, precise, interval, team);
    stage_go(&stage, duration);
    return stage_end(&stage);
}

static void outcome_free(Outcome *p) { free(p->y); }

static int same_state(const Outcome *a, const Outcome *b)
{
    return a->size == b->size && !memcmp(a->y, b->y, (size_t)a->size * sizeof *a->y);
}

static void check_count(long rough, long precise, double share)
{
    check_between((double)rough, (1 - share) * (double)precise, (1 + share) * (double)precise);
}

/* Rounded factors take the steps and iterations that the others take, but for chance, and come to the same force; at
 * intervals of 10 s some steps are seconds long, and the matrix is all stiffness. */
TEST(test_steps)
{
    static const double interval[] = {0.05, 10}, duration[] = {1, 30}; /* s */
    for (int k = 0; k < 2; ++k) {
        Outcome rough = outcome_of(0, interval[k], duration[k], NULL);
        Outcome precise = outcome_of(1, interval[k], duration[k], NULL);
        assert_false(same_state(&rough, &precise));
        check_count(rough.took.steps, precise.took.steps, 0.1);
        check_count(rough.took.newton_iters, precise.took.newton_iters, 0.15);
        check_count(rough.took.lin_setups, precise.took.lin_setups, 0.2);
        assert_int_equal(rough.took.newton_fails, 0);
        check_close(rough.force, precise.force, 1e-4 * precise.force);
        outcome_free(&rough);
        outcome_free(&precise);
    }
}

TEST(test_threads)
{
    Team *const two = team_new(2);
    assert_non_null(two);
    Outcome one = outcome_of(0, 0.05, 0.5, NULL), both = outcome_of(0, 0.05, 0.5, two);
    assert_true(same_state(&one, &both));
    assert_int_equal(one.took.newton_iters, both.took.newton_iters);
    outcome_free(&one);
    outcome_free(&both);
    team_free(two);
}

static void stage_steps(Stage *stage, int steps)
{
    hawser_error err = {0};
    for (int k = 0; k < steps; ++k) must(stage_step(stage, 1e6, &err), &err);
}

/* What is read from a checkpoint goes on with the same bits: with rounded factors, made of the same matrix again. The
 * steps after it need no other. */
TEST(test_checkpoint)
{
    Stage first, again;
    hawser_error err = {0};
    IntegratorStats before;
    stage_begin(&first, 0, 0.05, NULL);
    stage_steps(&first, 84);
    integrator_stats(first.integrator, &before);
    Checkpoint count = {0};
    must(stage_checkpoint(&count, &first, &err), &err);
    Checkpoint c = checkpoint_new(count.size);
    must(stage_checkpoint(&c, &first, &err), &err);
    assert_int_equal(c.status, 0);
    stage_begin(&again, 0, 0.05, NULL);
    TextPool texts = {0};
    Checkpoint back = checkpoint_over(c.bytes, c.size, &texts);
    must(stage_checkpoint(&back, &again, &err), &err);
    assert_int_equal(back.status, 0);
    stage_steps(&first, 3);
    stage_steps(&again, 3);
    Outcome one = stage_end(&first), two = stage_end(&again);
    assert_int_equal(one.took.lin_setups, before.lin_setups);
    assert_true(same_state(&one, &two));
    outcome_free(&one);
    outcome_free(&two);
    checkpoint_free(&c);
    text_pool_free(&texts);
}
