/* No step allocates, and an allocation that fails while a simulation is built is reported as what it is: the C
 * library's allocation functions are replaced by ones that count, and fail when they are told to. Nothing to see under
 * the address sanitizer, which replaces them itself; there the counters stay at zero and the test only runs the pull.
 */
#define _GNU_SOURCE /* RTLD_NEXT */
#include <dlfcn.h>
#include <sundials/sundials_context.h>

#include "sim/planar/plane.h"
#include "sim/run/sim.h"
#include "tests/support/scene.h"

#if !defined(__SANITIZE_ADDRESS__)
static volatile int counting;
static volatile long allocations;
static volatile long failing = -1; /* the number, among those counted, of the allocation that fails; -1: none */

static int refused(void) { return counting && allocations++ == failing; }

void *__libc_malloc(size_t size);
void *__libc_calloc(size_t count, size_t size);
void *__libc_realloc(void *old, size_t size);
void *__libc_memalign(size_t alignment, size_t size);

void *malloc(size_t size) { return refused() ? NULL : __libc_malloc(size); }
void *calloc(size_t count, size_t size) { return refused() ? NULL : __libc_calloc(count, size); }
void *realloc(void *old, size_t size) { return refused() ? NULL : __libc_realloc(old, size); }
void *aligned_alloc(size_t alignment, size_t size) { return refused() ? NULL : __libc_memalign(alignment, size); }
#else
static int counting;
static long allocations;
#endif

/* Allocations in the steps of a pull from rest through its ramp, with samples and records. */
static long pull_allocations_with(LinKind kind, int threads, int planar, int moving)
{
    SceneDef def;
    Sim *s = NULL;
    hawser_error err = {0};
    (planar ? fixture_planar : fixture_pull)(&def, &(FixtureChoice){0});
    if (moving) fixture_moving_rollers(&def, 1, 1);
    def.solver.linear.kind = kind;
    def.contact_reach = 0.05; /* so that candidates are renewed while we count */
    if (sim_new(&def, threads, &s, &err)) fail_msg("%s", err.message);
    scene_def_clear(&def);
    assert_int_equal(sim_relax(s, NULL, &err), HAWSER_OK);
    if (sim_advance(s, 0.1, 0, &err)) fail_msg("%s", err.message); /* makes the integrator */
    allocations = 0;
    counting = 1;
    hawser_status status = HAWSER_OK;
    while (!status && hawser_sim_time(s) < 2) {
        status = sim_advance(s, 2, 1, &err);
        hawser_sim_record(s);
    }
    counting = 0;
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
static void test_moving_rollers(void **state)
{
    (void)state;
    assert_int_equal(pull_allocations_with(LIN_AUTO, 1, 0, 1), 0);
    assert_int_equal(pull_allocations_with(LIN_AUTO, 2, 0, 1), 0);
}

static void test_block(void **state)
{
    (void)state;
    assert_int_equal(pull_allocations(LIN_BLOCK, 1, 0), 0);
}

static void test_block_two_threads(void **state)
{
    (void)state;
    assert_int_equal(pull_allocations(LIN_BLOCK, 2, 0), 0);
}

static void test_planar(void **state)
{
    (void)state;
    assert_int_equal(pull_allocations(LIN_BLOCK, 1, 1), 0);
    assert_int_equal(pull_allocations(LIN_BLOCK, 2, 1), 0);
}

static void test_klu(void **state)
{
    (void)state;
    assert_int_equal(pull_allocations(LIN_KLU, 1, 0), 0);
}

/* The counters do count. */
static void test_counting(void **state)
{
    (void)state;
#if !defined(__SANITIZE_ADDRESS__)
    allocations = 0;
    counting = 1;
    void *volatile block = malloc(10);
    counting = 0;
    free(block);
    assert_int_equal(allocations, 1);
#endif
}

#if !defined(__SANITIZE_ADDRESS__)
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
        allocations = 0;
        failing = k;
        counting = 1;
        const hawser_status status = sim_new(&def, 1, &s, &err);
        counting = 0;
        failing = -1;
        scene_def_clear(&def);
        if (allocations <= k) { /* it was not reached */
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
#endif

static void test_failures(void **state)
{
    (void)state;
#if !defined(__SANITIZE_ADDRESS__)
    void (*const define[])(SceneDef *) = {define_space, define_plane, define_reel, define_moving};
    for (size_t k = 0; k < sizeof define / sizeof *define; ++k) {
        const long failed = failures(define[k]);
        print_message("scene %zu: %ld allocations, each failed once\n", k, failed);
        check_above(failed, 100);
    }
#endif
}

#if !defined(__SANITIZE_ADDRESS__)
/* It does not look whether its logger has got memory: what it asks for is not counted. */
int SUNContext_Create(void *communicator, SUNContext *context)
{
    const int counted = counting;
    int (*const create)(void *, SUNContext *) = (int (*)(void *, SUNContext *))dlsym(RTLD_NEXT, "SUNContext_Create");
    counting = 0;
    const int status = create(communicator, context);
    counting = counted;
    return status;
}
#endif

/* CVODE and its vectors are made when the first step is taken. Each allocation of that fails once, CVODE's own too, and
 * nothing is used that is not there. */
static void test_history(void **state)
{
    (void)state;
#if !defined(__SANITIZE_ADDRESS__)
    hawser_status status = HAWSER_ERR_MEMORY;
    long k = 0;
    for (; status; ++k) {
        SceneDef def;
        Sim *s = NULL;
        hawser_error err = {0};
        define_space(&def);
        if (sim_new(&def, 1, &s, &err)) fail_msg("%s", err.message);
        scene_def_clear(&def);
        allocations = 0;
        failing = k;
        counting = 1;
        status = sim_advance(s, 0.01, 1, &err);
        counting = 0;
        failing = -1;
        const int reached = allocations > k;
        assert_int_equal(status, reached ? HAWSER_ERR_MEMORY : HAWSER_OK);
        if (reached) check_has(err.message, "out of memory");
        sim_free(s);
    }
    print_message("%ld allocations, each failed once\n", k - 1);
    check_above(k, 80);
#endif
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_counting), cmocka_unit_test(test_block),   cmocka_unit_test(test_block_two_threads),
        cmocka_unit_test(test_planar),   cmocka_unit_test(test_klu),     cmocka_unit_test(test_moving_rollers),
        cmocka_unit_test(test_failures), cmocka_unit_test(test_history),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
