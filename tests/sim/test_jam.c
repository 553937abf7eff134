/* Jams: pulls before, during and after against closed forms, events at their times and places, balances, repetition.
 * Derivatives with jammed rollers are in test_newton_rollers.c. */
#include <stdio.h>

#include "tests/support/rig.h"

/* 16 m of cable on rollers 1 m apart, pulled at 0.1 m/s. */
static const RowChoice ROW = {.segments = 32, .pitch = 1, .mu = 0.1};
enum { MIDDLE = 8, MOST = 4 }; /* a roller 7.5 m along the row */

/* Room for `n` jams in a definition; the rollers get names. */
static JamDef *jams_of(SceneDef *def, int n)
{
    for (int r = 0; r < def->n_rollers; ++r) snprintf(def->rollers[r].name, NAME_MAX_LENGTH, "R%d", r);
    def->jams = fixture_array(n, sizeof *def->jams);
    def->n_jams = n;
    for (int i = 0; i < n; ++i) {
        def->jams[i] =
            (JamDef){.at = NAN, .head_at = NAN, .release = NAN, .release_head_at = NAN, .ramp = 0.2, .friction = NAN};
    }
    return def->jams;
}

static void row_with_jams(SceneDef *def, int n)
{
    row_scene(def, &ROW);
    jams_of(def, n);
    def->duration = 20;
}

/* What is kept of a run: means of the pull over windows of time, and its events. */
typedef struct Window {
    double from, to, mean;
} Window;

static Sim *run(SceneDef *def, int threads, int n, Window window[])
{
    hawser_error err = {0};
    int count[MOST] = {0};
    const double end = def->duration;
    Sim *const s = sim_at_rest(def, threads);
    for (int k = 1; k * 0.02 <= end + 1e-9; ++k) {
        if (sim_advance(s, k * 0.02, 0, &err)) fail_msg("%s", err.message);
        const double t = hawser_sim_time(s), pull = hawser_sim_sample(s)->winch_force;
        for (int w = 0; w < n; ++w) {
            if (t < window[w].from || t > window[w].to) continue;
            window[w].mean += (pull - window[w].mean) / ++count[w];
        }
    }
    return s;
}

/* mu W of each metre, and the jammed roller's share of it: 1 m of cable with its friction. Over a whole number of
 * rollers' pitches the stiff cable's ripple is out of the mean. */
TEST(test_row)
{
    SceneDef def;
    row_with_jams(&def, 1);
    snprintf(def.jams->what, NAME_MAX_LENGTH, "R%d", MIDDLE);
    def.jams->at = 14;
    def.jams->release = 26;
    def.duration = 40;
    def.solver.max_step = 5e-3; /* a step over the moment at which the grip turns round is the books' largest error */
    Window window[3] = {{3, 13, 0}, {15, 25, 0}, {27, 37, 0}};
    Sim *const s = run(&def, 1, 3, window);
    const double free = 0.1 * row_weight(&ROW), more = (0.4 - 0.1) * ROW_MASS * ROW_G;
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    assert_string_equal(event[0].what, "roller R8 jams");
    assert_string_equal(event[1].what, "roller R8 is free again");
    check_close(event[0].t, 14, 1e-9);
    check_close(event[1].t, 26, 1e-9);
    check_share(window[0].mean, free, 2e-4);
    check_share(window[1].mean, free + more, 2e-4);
    check_share(window[2].mean, free, 2e-4);
    check_share(event[1].pull_N, free + more, 5e-3);
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    assert_non_null(sum.balance);
    check_below(sum.balance->residual_share, 5e-5);
    check_below(sum.balance->impulse_residual_share, 5e-5);
    assert_int_equal(sum.planar, 0);
    assert_non_null(strstr(sum.planar_why, "jams"));
    sim_free(s);
}

/* The friction that a jam names; a roller without any friction that jams; the same whose friction would stick. */
TEST(test_friction)
{
    for (int smooth = 0; smooth < 3; ++smooth) {
        SceneDef def;
        row_with_jams(&def, 1);
        snprintf(def.jams->what, NAME_MAX_LENGTH, "R%d", MIDDLE);
        def.jams->at = 2;
        def.jams->friction = 0.7;
        def.duration = 13;
        if (smooth > 0) def.rollers[MIDDLE].friction.mu_s = def.rollers[MIDDLE].friction.mu_d = 0;
        if (smooth > 1) def.rollers[MIDDLE].friction.d_s = 1e-3;
        Window window[1] = {{3, 13, 0}};
        Sim *const s = run(&def, 1, 1, window);
        check_share(window[0].mean, 0.1 * row_weight(&ROW) + 0.6 * ROW_MASS * ROW_G, 2e-4);
        sim_free(s);
    }
}

/* When the front comes to a place, and to the next: within what a step moves it. */
TEST(test_front)
{
    SceneDef def;
    row_with_jams(&def, 1);
    snprintf(def.jams->what, NAME_MAX_LENGTH, "R%d", MIDDLE);
    def.jams->head_at = 16.5;
    def.jams->release_head_at = 17;
    def.solver.max_step = 0.02;
    def.duration = 12;
    Sim *const s = run(&def, 1, 0, NULL);
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    /* the winch's travel, STEP over the first second: 0.1 (t - 0.5); the cable stretches by micrometres */
    check_between(event[0].t, 5.5 - 1e-3, 5.5 + 0.021);
    check_between(event[1].t, 10.5 - 1e-3, 10.5 + 0.021);
    sim_free(s);
}

/* A release that is due before the jam is complete waits for that. */
TEST(test_waits_for_the_ramp)
{
    SceneDef def;
    row_with_jams(&def, 1);
    snprintf(def.jams->what, NAME_MAX_LENGTH, "R%d", MIDDLE);
    def.jams->at = 3;
    def.jams->release_head_at = 16.1;
    def.jams->ramp = 0.7;
    def.duration = 5;
    Sim *const s = run(&def, 1, 0, NULL);
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    check_close(event[1].t, 3.7, 1e-9);
    sim_free(s);
}

/* A belt that pushed with all its grip stands and brakes with all of it: the winch pays twice the grip more. */
TEST(test_belt)
{
    SceneDef def;
    row_with_jams(&def, 1);
    const double grip = 200;
    def.conveyors = fixture_array(1, sizeof *def.conveyors);
    def.n_conveyors = 1;
    *def.conveyors = (ConveyorDef){.name = "C1",
                                   .from = 10.2,
                                   .to = 11.8,
                                   .edge = 0.2,
                                   .sync = 1,
                                   .factor = 1.1,
                                   .clamp = grip,
                                   .mu = 0.5,
                                   .v_s = 1e-4,
                                   .v_d = 2e-4,
                                   .ratio = 1};
    snprintf(def.jams->what, NAME_MAX_LENGTH, "C1");
    def.jams->at = 14;
    def.jams->release = 26;
    def.duration = 40;
    def.solver.max_step = 5e-3; /* a step over the moment at which the grip turns round is the books' largest error */
    Window window[3] = {{3, 13, 0}, {15, 25, 0}, {28, 38, 0}};
    Sim *const s = run(&def, 1, 3, window);
    const double row = 0.1 * row_weight(&ROW), sign[3] = {-1, 1, -1};
    for (int w = 0; w < 3; ++w) check_share(window[w].mean, row + sign[w] * grip, 1e-4);
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    assert_string_equal(event[0].what, "conveyor C1 jams");
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    check_below(sum.balance->residual_share, 5e-6);
    check_below(sum.balance->impulse_residual_share, 5e-6);
    sim_free(s);
}

/* Rollers that spin without resistance cost nothing; one that jams costs mu W of its metre. It stands within the ramp,
 * and turns again once it is free. */
TEST(test_spinning)
{
    SceneDef def;
    row_with_jams(&def, 1);
    for (int r = 0; r < def.n_rollers; ++r)
        def.rollers[r].spin = (SpinDef){.inertia = 0.05, .friction = 0.01, .journal = 0.01, .speed = 0.02};
    snprintf(def.jams->what, NAME_MAX_LENGTH, "R%d", MIDDLE);
    def.jams->at = 14;
    def.jams->release = 26;
    def.duration = 40;
    def.solver.max_step = 5e-3; /* a step over the moment at which the grip turns round is the books' largest error */
    Window window[3] = {{3, 13, 0}, {15, 25, 0}, {27, 37, 0}};
    hawser_error err = {0};
    int count[3] = {0};
    const double radius = def.rollers[MIDDLE].radius, metre = ROW_MASS * ROW_G;
    const double bearing = 0.01 * 0.01 / radius * row_weight(&ROW);
    double fastest = 0;
    Sim *const s = sim_at_rest(&def, 1);
    for (int k = 1; k <= 2000; ++k) {
        if (sim_advance(s, k * 0.02, 0, &err)) fail_msg("%s", err.message);
        const hawser_sample *const look = hawser_sim_sample(s);
        const double spin = fabs(look->roller_spin[MIDDLE]);
        for (int w = 0; w < 3; ++w) {
            if (look->t < window[w].from || look->t > window[w].to) continue;
            window[w].mean += (look->winch_force - window[w].mean) / ++count[w];
        }
        if (look->t > 14.25 && look->t < 26) fastest = larger_of(fastest, spin);
        if (k == 600 || k == 1900) check_share(spin, 0.1 / radius, 5e-3);
    }
    check_below(fastest * radius, 1e-3 * 0.1);
    check_close(window[0].mean, bearing, 5e-4 * metre);
    check_share(window[1].mean, bearing + 0.1 * metre, 0.02);
    check_close(window[2].mean, bearing, 5e-4 * metre);
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    check_below(sum.balance->residual_share, 1e-3);
    sim_free(s);
}

/* Segments join behind the tail and leave at the winch while a roller stands: the workspace is made anew, the jam goes
 * on. The jam's share of the pull is mu W of what the roller bears, as its load says. */
TEST(test_joins)
{
    double pull[2] = {0}, load = 0;
    for (int jammed = 0; jammed < 2; ++jammed) {
        SceneDef def;
        hawser_error err = {0};
        hawser_summary sum;
        reel_pull(&def, &(ReelChoice){.payout = 1, .take_in = 1});
        JamDef *const jam = jams_of(&def, jammed);
        assert_in_range(def.n_rollers, 4, 100);
        if (jammed) {
            snprintf(jam->what, NAME_MAX_LENGTH, "R3");
            jam->at = 6;
            jam->friction = 0.6;
        }
        def.duration = 20;
        def.output.steady_from = 3;
        Sim *const s = sim_at_rest(&def, 1);
        int count = 0;
        for (int k = 1; k <= 900; ++k) {
            if (sim_advance(s, 0.02 * k, 0, &err)) fail_msg("%s", err.message);
            const hawser_sample *const look = hawser_sim_sample(s);
            if (look->t < 8) continue;
            ++count;
            pull[jammed] += (look->winch_force - pull[jammed]) / count;
            if (jammed) load += (look->roller_load[3] - load) / count;
        }
        hawser_sim_summary(s, &sum);
        check_below(sum.balance->residual_share, 1e-3);
        sim_free(s);
    }
    /* the load is the contact's whole force, friction with it: N sqrt(1 + mu2) */
    check_share(pull[1] - pull[0], (0.6 - 0.2) * load / sqrt(1 + 0.6 * 0.6), 0.02);
}

/* One thread and two, and a second run: the same bits, before, in and after a jam. */
TEST(test_repeats)
{
    double force[3][4];
    for (int k = 0; k < 3; ++k) {
        SceneDef def;
        hawser_error err = {0};
        fixture_pull(&def, &(FixtureChoice){0});
        fixture_moving_rollers(&def, 1, 1);
        JamDef *const jam = jams_of(&def, 3);
        for (int i = 0; i < 3; ++i) {
            snprintf(jam[i].what, NAME_MAX_LENGTH, "R%d", i + 1);
            jam[i].at = 0.2 + 0.1 * i;
            jam[i].release = 0.7;
        }
        def.duration = 1.5;
        Sim *const s = sim_at_rest(&def, k == 2 ? 2 : 1);
        for (int i = 0; i < 4; ++i) {
            if (sim_advance(s, 0.15 + 0.4 * i, 0, &err)) fail_msg("%s", err.message);
            force[k][i] = hawser_sim_sample(s)->winch_force;
        }
        sim_free(s);
    }
    assert_memory_equal(force[0], force[1], sizeof force[0]);
    assert_memory_equal(force[0], force[2], sizeof force[0]);
}

/* A name that nothing has. */
TEST(test_refused)
{
    SceneDef def;
    Scene scene;
    hawser_error err = {0};
    row_with_jams(&def, 1);
    snprintf(def.jams->what, NAME_MAX_LENGTH, "R99");
    def.jams->at = 1;
    assert_int_equal(scene_build(&def, &scene, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "nothing that can jam is called 'R99'");
    scene_def_clear(&def);
}
