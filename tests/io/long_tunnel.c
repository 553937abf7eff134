/* The whole tunnel, end to end: the winch's force as a function of where the cable's front is, against the reference
 * theory. Minutes. */

#include <math.h>
#include <stdio.h>

#include "hawser/hawser.h"
#include "tests/io/example_fixture.h"
#include "tests/support/check.h"

static hawser_sim *tunnel_run(void)
{
    hawser_error err = {0};
    hawser_sim *const sim = example_sim("tunnel-879", NULL);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    return sim;
}

/* Within 5 % from the first stretch to the last, and the front has come to the tunnel's end. */
TEST(test_pull_along_the_tunnel)
{
    hawser_sim *const sim = tunnel_run();
    const hawser_position *row;
    const int n = hawser_sim_positions(sim, &row);
    double largest = 0, sum = 0;
    for (int i = 0; i < n; ++i) {
        const double error = fabs(row[i].pull_N / row[i].reference_N - 1);
        largest = larger_of(largest, error);
        sum += error;
    }
    hawser_summary s;
    hawser_sim_summary(sim, &s);
    print_message("%d stretches: error %.2f %% at most, %.2f %% in the mean; %.0f N at the end, %.1f s of wall time\n",
                  n, 100 * largest, 100 * sum / n, row[n - 1].pull_N, s.wall_time_s);
    assert_true(s.relaxation.reached);
    check_above(n, 100);
    check_below(row[0].head_m, 10);
    check_above(row[n - 1].head_m, 870);
    check_below(largest, 0.05);
    hawser_sim_free(sim);
}
