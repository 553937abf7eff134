/* No step allocates, and an allocation that fails while a simulation is built is reported as what it is. Nothing is
 * counted under sanitizers: there the test only runs the pull. */
#include <stdlib.h>

#include "sim/run/sim.h"
#include "sim/solve/planar.h"
#include "tests/support/lack.h"
#include "tests/support/scene.h"

/* Allocations in the steps of a pull from rest through its ramp, with samples and records. */
static long pull_allocations_with(LinKind kind, int threads, int planar, int moving)
{
    SceneDef def;
    hawser_error err = {0};
    (planar ? fixture_planar : fixture_pull)(&def, &(FixtureChoice){0});
    if (moving) fixture_moving_rollers(&def, 1, 1);
    def.solver.linear.kind = kind;
    def.contact_reach = 0.05; /* so that candidates are renewed while we count */
    Sim *const s = sim_at_rest(&def, threads);
    if (sim_advance(s, 0.1, 0, &err)) fail_msg("%s", err.message); /* makes the integrator */
    const long before = lack_calls();
    hawser_status status = HAWSER_OK;
    while (!status && hawser_sim_time(s) < 2) {
        status = sim_advance(s, 2, 1, &err);
        hawser_sim_record(s);
    }
    const long allocations = lack_calls() - before;
    hawser_summary summary;
    hawser_sim_summary(s, &summary);
    if (status) fail_msg("%s", err.message);
    assert_int_equal(summary.planar, planar);
    check_above(summary.steps, 100);
    check_above(summary.jac_evals, 5);
    check_above(summary.contact_refreshes, 5);
    sim_free(s);
    return allocations;
}

static long pull_allocations(LinKind kind, int threads, int planar)
{
    return pull_allocations_with(kind, threads, planar, 0);
}

/* Rollers that spin, stand on mounts, and both, as leaves that move along the chain. */
TEST(test_moving_rollers)
{
    assert_int_equal(pull_allocations_with(LIN_AUTO, 1, 0, 1), 0);
    assert_int_equal(pull_allocations_with(LIN_AUTO, 2, 0, 1), 0);
}

TEST(test_block) { assert_int_equal(pull_allocations(LIN_BLOCK, 1, 0), 0); }

TEST(test_block_two_threads) { assert_int_equal(pull_allocations(LIN_BLOCK, 2, 0), 0); }

TEST(test_planar)
{
    assert_int_equal(pull_allocations(LIN_BLOCK, 1, 1), 0);
    assert_int_equal(pull_allocations(LIN_BLOCK, 2, 1), 0);
}

TEST(test_klu) { assert_int_equal(pull_allocations(LIN_KLU, 1, 0), 0); }

/* The counters do count. */
TEST(test_counting)
{
    const long before = lack_calls();
    void *volatile block = malloc(10);
    free(block);
    assert_int_equal(lack_calls() - before, lack_works());
}

/* No cable on cable here: its candidates are sorted by qsort, which does without the memory that it asks for.
 *
 * Builds a simulation again and again, each time with the next allocation failing, until none does; how many failed. */
static long failures(void (*define)(SceneDef *))
{
    for (long k = 0;; ++k) {
        SceneDef def;
        Sim *s = NULL;
        hawser_error err = {0};
        define(&def);
        lack_after(k);
        const hawser_status status = sim_new(&def, 1, &s, &err);
        const int reached = lack_end();
        scene_def_clear(&def);
        if (!reached) {
            assert_int_equal(status, HAWSER_OK);
            sim_free(s);
            return k;
        }
        if (status != HAWSER_ERR_MEMORY) fail_msg("allocation %ld fails: status %d, '%s'", k, status, err.message);
        check_has(err.message, "out of memory");
        assert_null(s);
    }
}

static void define_space(SceneDef *def) { fixture_pull(def, &(FixtureChoice){0}); }
static void define_plane(SceneDef *def) { fixture_planar(def, &(FixtureChoice){0}); }
static void define_reel(SceneDef *def) { reel_pull(def, &(ReelChoice){.payout = 1, .take_in = 1, .tension = 800}); }
static void define_moving(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    fixture_moving_rollers(def, 1, 1);
}

TEST(test_failures)
{
    if (!lack_works()) skip();
    void (*const define[])(SceneDef *) = {define_space, define_plane, define_reel, define_moving};
    for (size_t k = 0; k < sizeof define / sizeof *define; ++k) {
        const long failed = failures(define[k]);
        print_message("scene %zu: %ld allocations, each failed once\n", k, failed);
        check_above(failed, 100);
    }
}

/* CVODE and its vectors are made when the first step is taken. Each allocation of that fails once, CVODE's own too, and
 * nothing is used that is not there. */
TEST(test_history)
{
    if (!lack_works()) skip();
    hawser_status status = HAWSER_ERR_MEMORY;
    long k = 0;
    for (; status; ++k) {
        SceneDef def;
        hawser_error err = {0};
        define_space(&def);
        Sim *const s = sim_made(&def, 1);
        lack_after(k);
        status = sim_advance(s, 0.01, 1, &err);
        const int reached = lack_end();
        assert_int_equal(status, reached ? HAWSER_ERR_MEMORY : HAWSER_OK);
        if (reached) check_has(err.message, "out of memory");
        sim_free(s);
    }
    print_message("%ld allocations, each failed once\n", k - 1);
    check_above(k, 80);
}
