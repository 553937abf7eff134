/* An ordinary tunnel: rollers of 210, 400 and 600 mm, one to three caterpillars. Seven of nine like these stalled or
 * were not trusted; narrow rollers are found before time begins now, the others are pulled and trusted. */
#include "tests/io/case_fixture.h"

TEST(nine_tunnels)
{
    static const char *const width[] = {"210 mm", "400 mm", "600 mm"};
    static const char *const belt[] = {
        "{name: first, from: 20 m, to: 22 m, clamp: 10 kN, limit: 3 kN, factor: 1.02}",
        "{name: second, from: 100 m, to: 102 m, clamp: 10 kN, limit: 3 kN, factor: 1.02}",
        "{name: third, from: 220 m, to: 222 m, clamp: 10 kN, limit: 3 kN, factor: 1.02}"};
    static const double mean[] = {7697, 4152, 4125}; /* N, the same on both widths: what is wider bears no more */
    char belts[400] = "[";
    for (int n = 0; n < 3; ++n) {
        snprintf(belts + strlen(belts) - (n > 0), sizeof belts - strlen(belts), "%s%s]", n > 0 ? ", " : "", belt[n]);
        for (int w = 0; w < 3; ++w) {
            const char *const settings[] = {
                "rollers.along.0.width", width[w], "rollers.along.1.width", width[w], "conveyors", belts, NULL};
            hawser_sim *const sim = sim_of(data_text("tunnel-caterpillars"), settings);
            hawser_error err = {0};
            hawser_summary sum;
            const hawser_status status = hawser_sim_run(sim, NULL, NULL, NULL, &err);
            hawser_sim_summary(sim, &sum);
            print_message("%s, %d: %.0f N +- %.0f N, %ld steps %s\n", width[w], n + 1, sum.pull_mean_N,
                          sum.pull_mean_error.total, sum.steps, err.message);
            if (w == 0) {
                assert_int_equal(status, HAWSER_ERR_RUN);
                assert_int_equal(sum.steps, 0);
                check_has(err.message, "mm beside the middle of roller 'R1");
            } else {
                assert_int_equal(status, HAWSER_OK);
                for (int i = 0; i < sum.n_conditions; ++i) assert_true(sum.conditions[i].holds);
                check_share(sum.pull_mean_N, mean[n], 0.01);
            }
            hawser_sim_free(sim);
        }
    }
}
