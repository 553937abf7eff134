/* The pull by the place of the cable's front: theory along the way against sums done by hand, means against known
 * signals, and a short run from a reel against both. */
#include "sim/run/positions.h"

#include "sim/run/sim.h"
#include "tests/support/scene.h"
#include "theory/expected.h"

static void scene_for(const ReelChoice *choice, Scene *scene)
{
    SceneDef def;
    reel_pull(&def, choice);
    fixture_build(&def, scene);
}

/* A level row: friction of the cable that has passed the start and of the rope that has not passed the winch, and what
 * the drum holds back with. */
TEST(test_theory)
{
    const double mu = 0.2, cable = 12 * 9.81, rope = 1.5 * 9.81; /* N/m */
    Scene scene;
    ByPosition b;
    hawser_error err = {0};
    scene_for(&(ReelChoice){.payout = 1, .take_in = 1, .torque = 300, .bearing = 50, .tension = 800}, &scene);
    assert_int_equal(by_position_new(&b, &scene.setup, &err), HAWSER_OK);
    /* STEP to 0.2 m/s within 3 s, then until 10 s */
    check_close(b.from, 6, 1e-12);
    check_close(b.to - 6, 1.7, 1e-12);
    for (double s = 6; s < 7.7; s += 0.31) {
        /* 10 m are wound with the front at 6 m: one layer of 0.64 m radius */
        const double expected = 800 + 350 / 0.64 + mu * (cable * s + rope * (16 - s));
        check_share(by_position_reference(&b, s, 800), expected, 1e-13);
        /* the tension at the drum goes straight through on a level row */
        check_close(by_position_reference(&b, s, 500) - expected + 300, 0, 1e-10);
    }
    check_nan(by_position_reference(&b, 5.9, 800));
    check_nan(by_position_reference(&b, 7.8, 800));
    by_position_free(&b);
    scene_clear(&scene);
}

/* The end of the cable leaves the drum with the front at 7 m: what holds it back is all there until then, and gone. */
TEST(test_leaves_the_drum)
{
    const double mu = 0.2, cable = 12 * 9.81, rope = 1.5 * 9.81; /* N/m */
    Scene scene;
    ByPosition b;
    hawser_error err = {0};
    scene_for(&(ReelChoice){.payout = 1, .take_in = 1, .cable = 11, .torque = 300, .bearing = 50, .tension = 800},
              &scene);
    assert_int_equal(by_position_new(&b, &scene.setup, &err), HAWSER_OK);
    check_close(b.leaves, 7, 1e-12);
    for (double s = 6.9; s < 7.15; s += 0.02) {
        const double held = s < 7 ? 800 + 350 / 0.64 : 0;
        check_share(by_position_reference(&b, s, 800), held + mu * (cable * s + rope * (16 - s)), 1e-13);
    }
    by_position_free(&b);
    scene_clear(&scene);
}

/* Means over time by bins; what is not steady does not count. */
TEST(test_means)
{
    Scene scene;
    ByPosition b;
    hawser_error err = {0};
    scene_for(&(ReelChoice){.payout = 1, .take_in = 1, .rope = 20, .speed = 1, .cable = 30}, &scene);
    assert_int_equal(by_position_new(&b, &scene.setup, &err), HAWSER_OK);
    assert_int_equal(b.n_bins, 5); /* 8.5 m of travel in parts of at least 2 m, but the last one may be less */
    for (int k = 0; k <= 850; ++k) {
        const double s = 6 + k * 0.01;
        by_position_record(&b, k * 0.01, s, k < 100 ? 1e6 : 1000 + 100 * s, 2000, k >= 100);
    }
    const int n = by_position_table(&b);
    assert_int_equal(n, 5);
    for (int i = 0; i < n; ++i) {
        check_close(b.out[i].pull_N - 1000, 100 * b.out[i].head_m, 1e-10);
        check_close(b.out[i].reference_N, 2000, 1e-9);
        check_close(b.out[i].error_pct, b.out[i].pull_N / 20 - 100, 1e-9);
        if (i > 0) check_above(b.out[i].head_m, b.out[i - 1].head_m + 1);
    }
    by_position_free(&b);
    scene_clear(&scene);
}

/* A front that stands, or that lies beyond the route, has no table. */
TEST(test_none)
{
    SceneDef def;
    Scene scene;
    ByPosition b;
    hawser_error err = {0};
    fixture_pull(&def, &(FixtureChoice){0});
    def.winch.present = 0;
    fixture_build(&def, &scene);
    assert_int_equal(by_position_new(&b, &scene.setup, &err), HAWSER_OK);
    assert_int_equal(b.n_grid, 0);
    assert_int_equal(by_position_table(&b), 0);
    check_nan(by_position_reference(&b, 3, 0));
    by_position_free(&b);
    scene_clear(&scene);
}

/* The simulated pull follows the theory as the front moves. */
TEST(test_run)
{
    SceneDef def;
    Sim *s = NULL;
    hawser_error err = {0};
    const hawser_position *row;
    reel_pull(&def,
              &(ReelChoice){.payout = 1, .take_in = 1, .torque = 300, .bearing = 50, .tension = 800, .speed = 0.5});
    assert_int_equal(sim_new(&def, 1, &s, &err), HAWSER_OK);
    scene_def_clear(&def);
    assert_int_equal(sim_relax(s, NULL, &err), HAWSER_OK);
    while (hawser_sim_time(s) < 10) {
        if (sim_advance(s, hawser_sim_time(s) + 0.05, 0, &err)) fail_msg("%s", err.message);
        hawser_sim_record(s);
    }
    const int n = hawser_sim_positions(s, &row);
    check_at_least(n, 2);
    for (int i = 0; i < n; ++i) {
        print_message("front at %.3f m: %.2f N, theory %.2f N, %.2f %%\n", row[i].head_m, row[i].pull_N,
                      row[i].reference_N, row[i].error_pct);
        if (i > 0) check_close(row[i].error_pct, 0, 1); /* the first still swings */
    }
    /* the front is where the winch's travel has brought it, but for the stretch */
    const hawser_sample *const look = hawser_sim_sample(s);
    check_close(look->head_at - 6, look->winch_travel, 0.01);
    sim_free(s);
}
