/* The reduction of Newton's matrix to the velocities against the whole system, 13 unknowns a segment: the same pull to
 * within the tolerance of the steps.
 *
 * The window of means begins with the first step after steady_from, at which the pull is 2.5 N below the mean and
 * rises: a step of 1.5 ms more or less in a window of 0.5 s makes 2.5 N * 1.5 ms / 0.5 s = 8 mN of 386 N, 2e-5. No
 * accuracy makes that smaller than by the length of its steps, and the bar's part of time does not know of it. */
#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#include <math.h>
#include <string.h>

static hawser_summary pulled(const char *solver, hawser_sim **s)
{
    static const char *const set[][2] = {{"solver.accuracy", "1e-6"}, {"solver.planar", "off"}, {"output.states", "0"}};
    hawser_error err = {0};
    hawser_summary sum;
    hawser_case *const c = case_with(data_text("short-pull"), NULL);
    for (size_t k = 0; k < sizeof set / sizeof *set; k++)
        if (hawser_case_set(c, set[k][0], set[k][1], &err)) fail_msg("%s", err.message);
    if (hawser_case_set(c, "solver.linear_solver", solver, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, s, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(*s, NULL, NULL, NULL, &err)) fail_msg("%s: %s", solver, err.message);
    hawser_sim_summary(*s, &sum);
    hawser_case_free(c);
    return sum;
}

TEST(the_whole_system_pulls_the_same)
{
    hawser_sim *whole, *reduced;
    const hawser_summary a = pulled("klu-full", &whole), b = pulled("klu", &reduced);
    assert_string_equal(a.linear_solver, "klu-full");
    check_above(a.pull_mean_error.total + b.pull_mean_error.total, fabs(a.pull_mean_N - b.pull_mean_N));
    check_share(a.pull_mean_N, b.pull_mean_N, 2e-5);
    check_share(a.pull_peak_N, b.pull_peak_N, 1e-4);
    check_close((double)a.steps, (double)b.steps, 0.05 * (double)b.steps);
    hawser_sim_free(whole);
    hawser_sim_free(reduced);
}

/* Its matrix goes with a checkpoint: what is gone on with is the same, bit for bit. */
TEST(a_checkpoint_holds_the_whole_system)
{
    hawser_sim *first;
    hawser_error err = {0};
    double at[2];
    (void)pulled("klu-full", &first);
    hawser_sim_free(first);
    hawser_case *const c =
        case_with(data_text("short-pull"), (const char *const[]){"solver.linear_solver", "klu-full", NULL});
    hawser_sim *sim[2];
    void *bytes = NULL;
    size_t size = 0;
    for (int k = 0; k < 2; k++) assert_int_equal(hawser_sim_new(c, NULL, &sim[k], &err), HAWSER_OK);
    assert_int_equal(hawser_sim_relax(sim[0], NULL, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_advance(sim[0], 0.7, 0, &err), HAWSER_OK);
    if (hawser_sim_save_memory(sim[0], &bytes, &size, &err)) fail_msg("%s", err.message);
    if (hawser_sim_load_memory(sim[1], bytes, size, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < 2; k++) {
        assert_int_equal(hawser_sim_advance(sim[k], 1.1, 0, &err), HAWSER_OK);
        at[k] = hawser_sim_sample(sim[k])->winch_force;
        hawser_sim_free(sim[k]);
    }
    check_close(at[0], at[1], 0);
    check_above(at[0], 1);
    hawser_bytes_free(bytes);
    hawser_case_free(c);
}
