/* Straight rows of rollers: friction on the level, hoisting on a slope, and the ripple of the two contact geometries.
 */
#include "tests/support/rig.h"

static const char *const NAME[] = {"smooth", "cylinder"};

/* Pulls the row for 22 s, 2 m of them steady. */
static hawser_summary row_pulled(const RowChoice *row)
{
    SceneDef def;
    hawser_summary out;
    row_scene(&def, row);
    pull_record(&def, 22, &out);
    const double exact = row->mu * row_weight(row);
    print_message("%s, %d segments: pull %.2f N, exact %.2f N (%.3f %%), ripple %.2f N, %ld steps\n",
                  NAME[row->geometry], row->segments, out.pull_mean_N, exact, 100 * (out.pull_mean_N / exact - 1),
                  out.pull_ripple_N, out.steps);
    check_share(out.pull_mean_N, exact, 1e-3);
    check_share(out.reference_total_N, exact, 1e-12);
    check_share(out.steady_speed_m_per_s, 0.1, 5e-3);
    return out;
}

/* The mean pull is mu m g N, with both geometries. */
TEST(test_level_row)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        const RowChoice row = {.segments = 60, .pitch = 2, .mu = 0.2, .geometry = (ContactGeometry)geometry};
        row_pulled(&row);
    }
}

/* In a long row the smooth line ripples at least ten times less than the capsules, whose joints pass all rollers at
 * once. (In a short one, or with rollers so far apart that the ends droop, what is left are the ends as they meet
 * rollers.) */
TEST(test_ripple)
{
    double ripple[2];
    for (int geometry = 0; geometry < 2; ++geometry) {
        const RowChoice row = {.segments = 370, .pitch = 1, .mu = 0.2, .geometry = (ContactGeometry)geometry};
        ripple[geometry] = row_pulled(&row).pull_ripple_N;
    }
    check_above(ripple[GEOMETRY_CYLINDER], 10 * ripple[GEOMETRY_SMOOTH]);
}

/* At rest on smooth rollers the winch carries the weight's part along the slope, W L sin(slope). */
TEST(test_slope_at_rest)
{
    const double slope[] = {0.05, 0.2, 0.6};
    for (int k = 0; k < 3; ++k) {
        const RowChoice row = {.segments = 40, .pitch = 1, .slope = slope[k]};
        const double exact = row_weight(&row) * sin(slope[k]);
        SceneDef def;
        hawser_error err = {0};
        hawser_relaxation relaxation;
        row_scene(&def, &row);
        Sim *const s = sim_made(&def, 1);
        assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
        const double force = hawser_sim_sample(s)->winch_force;
        print_message("slope %.2f: winch %.3f N, exact %.3f N (%.4f %%)\n", slope[k], force, exact,
                      100 * (force / exact - 1));
        assert_true(relaxation.reached);
        check_share(force, exact, 1e-6);
        sim_free(s);
    }
}

/* Pulled up the slope, friction adds mu W L cos(slope). */
TEST(test_slope_up)
{
    const RowChoice row = {.segments = 40, .pitch = 1, .slope = 0.2, .mu = 0.15};
    const double exact = row_weight(&row) * (sin(row.slope) + row.mu * cos(row.slope));
    SceneDef def;
    hawser_summary out;
    row_scene(&def, &row);
    pull_record(&def, 12, &out);
    print_message("pull %.2f N, exact %.2f N (%.3f %%), ripple %.2f N\n", out.pull_mean_N, exact,
                  100 * (out.pull_mean_N / exact - 1), out.pull_ripple_N);
    check_share(out.pull_mean_N, exact, 1e-4);
}

/* While the winch speeds up by STEP, v (3 x^2 - 2 x^3) over 1 s, the pull is largest half-way: all the friction, and
 * the mass times 1.5 v / s. Looked at where the steps end: between steps the stiff springs feel how far the method's
 * polynomial is from the winch's motion; and held by two steps, as peaks are (EB14): a single one that is cut short has
 * its error in speed as a force. */
TEST(test_ramp_peak)
{
    const RowChoice row = {.segments = 60, .pitch = 2, .mu = 0.2};
    const double exact = row_weight(&row) * (row.mu + 1.5 * 0.1 / ROW_G);
    SceneDef def;
    hawser_error err = {0};
    double peak = 0, before = 0;
    row_scene(&def, &row);
    def.duration = 1.5;
    def.solver.accuracy = 1e-4;
    Sim *const s = sim_at_rest(&def, 1);
    while (hawser_sim_time(s) < 1.5) {
        if (sim_advance(s, 1.5, 1, &err)) fail_msg("%s", err.message);
        const double now = hawser_sim_sample(s)->winch_force;
        peak = larger_of(peak, fmin(before, now));
        before = now;
    }
    print_message("peak %.2f N, exact %.2f N\n", peak, exact);
    check_share(peak, exact, 0.01);
    sim_free(s);
}
