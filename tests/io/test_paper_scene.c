/* The paper's case in code and in its file are the same scene: the same pull after the start, the same theory. */

#include <math.h>

#include "hawser/hawser.h"
#include "tests/io/example_fixture.h"
#include "tests/support/check.h"
#include "validate/validate.h"

TEST(test_same)
{
    static const double TIME = 4; /* s */
    hawser_error err = {0};
    Sim *by_code;
    SceneDef def;
    hawser_summary a, b;
    hawser_sim *const by_file = example_sim("huangjiahu", NULL);
    assert_int_equal(hawser_sim_relax(by_file, NULL, &err), HAWSER_OK);
    assert_int_equal(paper_scene(&(PaperChoice){0}, &def, &err), HAWSER_OK);
    assert_int_equal(pull_start(&def, &by_code, &err), HAWSER_OK);
    assert_int_equal(hawser_sim_advance(by_file, TIME, 0, &err), HAWSER_OK);
    assert_int_equal(sim_advance(by_code, TIME, 0, &err), HAWSER_OK);
    hawser_sim_summary(by_file, &a);
    hawser_sim_summary(by_code, &b);
    assert_int_equal(a.segments, b.segments);
    assert_int_equal(a.rollers, b.rollers);
    check_share(b.paper_total_N, a.paper_total_N, 1e-9);
    check_share(b.reference_total_N, a.reference_total_N, 1e-9);
    const double pull = hawser_sim_sample(by_file)->winch_force, same = hawser_sim_sample(by_code)->winch_force;
    print_message("%.9f N and %.9f N after %ld and %ld steps\n", pull, same, a.steps, b.steps);
    check_share(same, pull, 1e-7);
    hawser_sim_free(by_file);
    sim_free(by_code);
}
