/* What holds a run up: why its steps are short and where, in the summary, in the message of a failure, and as the run
 * goes on. */
#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/support/check.h"
#include "tests/support/data.h"

#include <string.h>

typedef struct Set {
    const char *key, *value;
} Set;

static hawser_sim *sim_with(const char *name, int n, const Set *set)
{
    hawser_sim *s = NULL;
    hawser_error err = {0};
    hawser_case *const c = case_with(data_text(name), NULL);
    for (int k = 0; k < n; k++)
        if (hawser_case_set(c, set[k].key, set[k].value, &err)) fail_msg("%s", err.message);
    if (hawser_sim_new(c, NULL, &s, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    return s;
}

static hawser_hold slowest_of(const char *name, int n, const Set *set)
{
    hawser_sim *const s = sim_with(name, n, set);
    hawser_error err = {0};
    hawser_summary sum;
    if (hawser_sim_run(s, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(s, &sum);
    assert_non_null(sum.slowest);
    const hawser_hold hold = *sum.slowest;
    print_message("%s\n", hold.says);
    assert_int_equal(hold.steps, 500);
    check_close(hold.step_s, (hold.to_s - hold.from_s) / 500, 1e-12);
    assert_true(hold.segment >= 0 && hold.segment < sum.segments);
    check_has(hold.says, " at segment ");
    hawser_sim_free(s);
    return hold;
}

TEST(the_longest_step_that_is_allowed)
{
    const Set set[] = {{"solver.max_step", "1 ms"}};
    const hawser_hold hold = slowest_of("short-pull", 1, set);
    assert_string_equal(hold.cause, "longest step");
    check_above(1.001e-3, hold.step_s);
    assert_int_equal(hold.strides, 0);
    check_has(hold.says, "solver.max_step");
}

/* An accuracy that nobody asks for: the error test alone keeps steps short; on rollers that carry something. */
TEST(accuracy)
{
    const Set set[] = {{"solver.accuracy", "1e-8"}};
    const hawser_hold hold = slowest_of("short-pull", 1, set);
    assert_true(!strcmp(hold.cause, "accuracy") || !strcmp(hold.cause, "error test"));
    assert_true(hold.where[0] == 'R' || !hold.where[0]);
}

TEST(few_steps_are_no_window)
{
    hawser_error err = {0};
    hawser_summary sum;
    hawser_sim *const s = sim_with("short-pull", 0, NULL);
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_OK);
    hawser_sim_summary(s, &sum);
    check_above(500, (double)sum.steps);
    assert_null(sum.slowest);
    hawser_sim_free(s);
}

TEST(a_failure_says_what_held_up_before_it)
{
    hawser_error err = {0};
    const Set set[] = {{"solver.max_step", "1 ms"}, {"solver.max_steps", "700"}};
    hawser_sim *const s = sim_with("short-pull", 2, set);
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_ERR_RUN);
    check_has(err.message, "solver.max_steps = 700 is used up");
    check_has(err.message, "; before it steps of 0.001 s");
    check_has(err.message, "no step may be longer than 0.001 s");
    hawser_sim_free(s);
}

/* Of several chains a segment is one of a chain's, which is named; whichever is asked. */
TEST(of_several_chains)
{
    const Set short_steps[] = {{"solver.max_step", "1 ms"}};
    const hawser_hold hold = slowest_of("chains", 1, short_steps);
    assert_string_equal(hold.cause, "longest step");
    assert_true(!strcmp(hold.chain, "one") || !strcmp(hold.chain, "two") || !strcmp(hold.chain, "three"));
    check_has(hold.says, " of 16 of chain '");
    /* the second is much faster than the others */
    const Set jerk[] = {{"solver.max_step", "1 ms"},
                        {"solver.max_steps", "700"},
                        {"chains.two.drive", "{winch: {speed: 2 m/s, to: 1 s}}"}};
    hawser_error err = {0};
    hawser_sim *const s = sim_with("chains", 3, jerk);
    assert_int_equal(hawser_sim_run(s, NULL, NULL, NULL, &err), HAWSER_ERR_RUN);
    print_message("%s\n", err.message);
    check_has(err.message, "the hardest part is segment ");
    check_has(err.message, " of 16 of chain 'two'");
    check_has(err.message, "; before it steps of 0.001 s");
    assert_in_range(err.segment, 0, 15);
    hawser_sim_free(s);
}
