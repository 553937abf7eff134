/* cases/bending-hysteresis.yaml, run: what the loops of bending add to the pull, against their area. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hawser/hawser.h"
#include "tests/support/check.h"

/* The summary of the case without friction, with one more setting (NULL: none). */
static hawser_summary run(const char *key, const char *value)
{
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_summary summary;
    assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/bending-hysteresis.yaml", &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "friction.mu", "0", &err), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "solver.passes", "1", &err), HAWSER_OK); /* a second one is not asked about */
    if (key) assert_int_equal(hawser_case_set(c, key, value, &err), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(sim, &summary);
    hawser_sim_free(sim);
    hawser_case_free(c);
    assert_true(summary.relaxation.reached);
    return summary;
}

/* Energy per metre, N, of a slider that gives way at curvature l with rigidity k: bent to c, to -c, straight. */
static double taken(double k, double l, double c) { return k * l * (3 * (c - l) + fmax(0, c - 2 * l)); }

/* Weight and back tension are the theory's; what is more is the loops' area: at least that of the route's own
 * curvature, and not much more, since the cable bends more at the rollers than between them. */
TEST(test_loss_in_bends)
{
    const hawser_summary s = run(NULL, NULL);
    const double loss = s.pull_mean_N - s.reference_total_N, c = 1. / 3;
    const double k[] = {12000 - 3000, 3000 - 377. / 0.471};
    const double expected = taken(k[0], 0.03, c) + taken(k[1], 0.1, c);
    print_message("%.1f N lost, %.1f N by the route's curvature\n", loss, expected);
    check_between(loss, expected, 1.25 * expected);
}

/* Shorter segments: the same pull. */
TEST(test_convergence)
{
    const hawser_summary coarse = run(NULL, NULL), fine = run("chain.0.segment", "88 mm");
    check_share(fine.pull_mean_N, coarse.pull_mean_N, 0.005);
}
