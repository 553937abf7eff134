/* The pull over a slope, a crest and a bend does not hang on segment length or accuracy. */
#include "tests/support/rig.h"

/* Mean pull over half a metre of travel, N; segments of 0.5 m over `split`. */
static double pull_mean(int split, double accuracy)
{
    SceneDef def;
    hawser_summary out;
    fixture_pull(&def, &(FixtureChoice){0});
    for (int p = 0; p < def.n_pieces; ++p) def.pieces[p].segments *= split;
    def.solver.accuracy = accuracy;
    def.output.steady_from = 2;
    pull_record(&def, 7, &out);
    print_message("segments of %.3f m, accuracy %.0e: pull %.2f N after %ld steps\n", 0.5 / split, accuracy,
                  out.pull_mean_N, out.steps);
    return out.pull_mean_N;
}

TEST(test_refinement)
{
    const double pull = pull_mean(1, 1e-3), fine = pull_mean(2, 1e-3), exact = pull_mean(1, 1e-4);
    check_share(fine, pull, 2e-3);
    check_share(exact, pull, 5e-5);
}
