/* A simulation of every kind of scene, with each allocation failing once: while it is built, while it is relaxed and
 * makes its first steps, and while it is read from a checkpoint. A lack of memory is told as that and as nothing else,
 * and what is left can be freed. */
#define _GNU_SOURCE /* RTLD_NEXT */
#include "tests/support/lack.h"

#include <dlfcn.h>
#include <string.h>
#include <sundials/sundials_context.h>

#include "sim/run/sim.h"
#include "tests/support/kinds.h"

enum { MOST = 4000 };
static const double MOMENT = 0.01; /* s that are simulated */

/* It does not look whether its logger has got memory: that is not what is tried here. */
int SUNContext_Create(void *communicator, SUNContext *context)
{
    int (*const create)(void *, SUNContext *) = (int (*)(void *, SUNContext *))dlsym(RTLD_NEXT, "SUNContext_Create");
    const long left = lack_left;
    lack_after(-1);
    const int status = create(communicator, context);
    lack_after(left);
    return status;
}

/* --------------------------------------------------------------------------------------------------------- trials */

/* One attempt with the k-th allocation failing; *s is what is left of it, to be freed. */
typedef hawser_status Attempt(int scene, long k, Sim **s, hawser_error *err);

static hawser_status built(int scene, long k, Sim **s, hawser_error *err)
{
    SceneDef def;
    scenes[scene].define(&def);
    lack_after(k);
    const hawser_status status = sim_new(&def, 1, s, err);
    if (status) assert_null(*s);
    const long left = lack_left; /* of the copy of the definition nothing is left */
    lack_after(-1);
    scene_def_clear(&def);
    lack_after(left);
    return status;
}

static hawser_status moved(Sim *s, hawser_error *err)
{
    hawser_status status = sim_relax(s, NULL, err);
    const double until = fmax(MOMENT, hawser_sim_end_time(s) / 4);
    const int stepped = s->stage.scene.def.analysis.kind != ANALYSIS_DYNAMICS;
    if (!status) status = sim_advance(s, stepped ? until : MOMENT, 0, err);
    return status;
}

static hawser_status relaxed_and_moved(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    return moved(*s, err);
}

static Checkpoint written(int scene)
{
    Sim *s = NULL;
    hawser_error err = {0};
    if (built(scene, -1, &s, &err) || moved(s, &err)) fail_msg("%s: %s", scenes[scene].name, err.message);
    Checkpoint count = checkpoint_new(0);
    assert_int_equal(sim_checkpoint(&count, s, &err), HAWSER_OK);
    Checkpoint c = checkpoint_new(count.size);
    assert_int_equal(sim_checkpoint(&c, s, &err), HAWSER_OK);
    assert_int_equal(c.status, HAWSER_OK);
    sim_free(s);
    return c;
}

static Checkpoint kept; /* what is read */

static hawser_status read_back(int scene, long k, Sim **s, hawser_error *err)
{
    hawser_status status = built(scene, -1, s, err);
    if (status) fail_msg("%s: %s", scenes[scene].name, err->message);
    lack_after(k);
    Checkpoint c = checkpoint_over(kept.bytes, kept.size, &(*s)->texts);
    status = sim_checkpoint(&c, *s, err);
    if (!status && c.status) status = error_set(err, c.status, "%s", c.fault);
    return status;
}

/* Every allocation of an attempt fails once; how many were missed. */
static long every_allocation(int scene, Attempt *attempt, const char *what)
{
    long told = 0, without = 0;
    for (long k = 0, met = 1; met; ++k) {
        check_below(k, MOST);
        Sim *s = NULL;
        hawser_error err = {0};
        const hawser_status status = attempt(scene, k, &s, &err);
        met = lack_end();
        if (!met && status) fail_msg("%s: %s", scenes[scene].name, err.message);
        if (met && !status) ++without; /* qsort() and the like */
        if (status) {
            if (status != HAWSER_ERR_MEMORY || !strstr(err.message, " memory"))
                fail_msg("%s, %s, allocation %ld: status %d, '%s'", scenes[scene].name, what, k, status, err.message);
            ++told;
        }
        sim_free(s);
    }
    print_message("%s, %s: %ld allocations missed, %ld done without\n", scenes[scene].name, what, told, without);
    if (!scenes[scene].spared) check_at_most(without, told / 10);
    return told;
}

static void test_building(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, built, "built"), 50);
}

static void test_moving(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) check_above(every_allocation(k, relaxed_and_moved, "moved"), 5);
}

static void test_reading(void **state)
{
    (void)state;
    if (!lack_works()) skip();
    for (int k = 0; k < SCENES; ++k) {
        kept = written(k);
        check_above(every_allocation(k, read_back, "read"), 2);
        checkpoint_free(&kept);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(test_building), cmocka_unit_test(test_moving),
                                       cmocka_unit_test(test_reading)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
