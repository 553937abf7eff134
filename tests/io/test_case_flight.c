/* Medium and launch in case files: what they become, what no table of keys can see, and what they do to a run. */
#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

TEST(both_are_read)
{
    SceneDef def, copy;
    expect_good(data_text("full-rod-polyline"), NULL, NULL, &def);
    assert_int_equal(scene_def_copy(&def, &copy, NULL), HAWSER_OK);
    scene_def_clear(&def);
    const MediumDef *const medium = &copy.medium;
    const LaunchDef *const launch = &copy.launch;
    check_close(medium->density, 1025, 1e-12);
    check_close(medium->velocity.z, -0.1, 1e-15);
    check_close(medium->normal, 1.1, 1e-15);
    check_close(medium->tangential, 0.02, 1e-15);
    assert_int_equal(medium->buoyancy, 1);
    assert_true(launch->present && launch->about_given);
    check_close(launch->along, 0.1, 1e-15);
    check_close(launch->spin.z, 5 * 2 * M_PI / 60, 1e-12);
    check_close(launch->about.x, 1, 1e-15);
    assert_int_equal(launch->n_rows, 2);
    check_close(launch->row[0].along, 1, 1e-15);
    check_close(launch->row[1].at, 1, 1e-15);
    check_close(launch->row[1].velocity.z, 0.02, 1e-15);
    scene_def_clear(&copy);
    expect_good(data_text("smallest"), NULL, NULL, &def);
    assert_true(!def.launch.present && def.medium.density == 0);
    scene_def_clear(&def);
}

TEST(wrong_ones)
{
    static const struct {
        const char *file, *key, *value, *part;
    } cases[] = {
        {"full-rod-polyline", "launch.table", "[[1 m, 1 m/s], [1 m, 2 m/s]]",
         "'launch.table.1.0': value '1 m' is out of range: must be above the place before it, 1 m"},
        {"full-rod-polyline", "launch.table", "[[1 m, 1 m/s, 0]]",
         "'launch.table.0': the value is a list of 3: expected 4 numbers"},
        {"full-rod-polyline", "launch.table", "[[-1 m, 1 m/s]]", "'launch.table.0.0': value '-1 m' is out of range"},
        {"full-rod-polyline", "run.analysis", "static", "'launch': only with 'analysis: dynamics'"},
        {"full-reel", "launch", "{along: 1 m/s}", "'launch': not allowed beside a drum"},
        {"full-reel", "medium", "{density: 1000}", "'medium.buoyancy': not beside 'reel'"},
        {"smallest", "medium", "{normal: 1}", "'medium.density': missing"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        expect_bad(data_text(cases[k].file), cases[k].key, cases[k].value, cases[k].part);
}

/* The largest winch force, N, with this launch. */
static double peak_of(const char *along)
{
    hawser_summary summary;
    hawser_sim *const sim = run_of(data_text("running-pull"), (const char *const[]){"launch.along", along, NULL});
    hawser_sim_summary(sim, &summary);
    check_share(summary.pull_mean_N, 0.2 * 200 * 9.81, 0.02);
    hawser_sim_free(sim);
    return summary.pull_peak_N;
}

/* A winch that has its speed from the first moment strikes a cable at rest with v sqrt(EA m), 15.8 kN here; one that
 * runs with it only feels friction set in. */
TEST(a_running_pull_begins_without_a_shock)
{
    check_above(peak_of("0 m/s"), 0.5 * sqrt(50e6 * 20));
    check_below(peak_of("500 mm/s"), 2 * 0.2 * 200 * 9.81);
}

/* A winch that has its speed from the first moment does not work on the search for rest, in the plane or in space. */
TEST(rest_knows_no_speed)
{
    static const char *const plane[] = {"on", "off"};
    for (int k = 0; k < 2; ++k) {
        hawser_error err = {0};
        hawser_relaxation relaxation;
        hawser_sim *const sim = sim_of(data_text("short-pull"), (const char *const[]){"drive.winch.ramp", "none",
                                                                                      "solver.planar", plane[k], NULL});
        if (hawser_sim_relax(sim, &relaxation, &err)) fail_msg("%s", err.message);
        assert_true(relaxation.reached);
        check_close(hawser_sim_sample(sim)->position[3 * 19], 11.75, 1e-6); /* the head: 12 m less half a segment */
        hawser_sim_free(sim);
    }
}

/* The example begins in its closed form's equilibrium and ends there. */
TEST(example)
{
    const char *const still[] = {"launch", "{along: 0 m/s}", "run.duration", "10 ms", NULL};
    const double w = (9 - 1025 * M_PI * 0.06 * 0.06 / 4) * 9.81, across = 1025 * 0.06 * 1.2 / 2 * 0.8 * 0.8;
    const double x = w / (2 * across), cosine = sqrt(1 + x * x) - x;
    for (int k = 0; k < 2; ++k) {
        Outcome out = example_run("towed-in-water", k ? NULL : still);
        const hawser_probe *const probe = hawser_sim_sample(out.sim)->probe;
        const double *const end = probe[0].position, *const boat = probe[1].position;
        check_close((end[0] - boat[0]) / 30, cosine, k ? 5e-3 : 1e-4);
        check_close((boat[2] - end[2]) / 30, sqrt(1 - cosine * cosine), k ? 5e-3 : 1e-4);
        hawser_sim_free(out.sim);
    }
}
