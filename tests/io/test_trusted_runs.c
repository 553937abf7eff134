/* Runs that were called safe and are not: what the conditions of trust and the refusals did not look at. */
#include "tests/io/case_fixture.h"

static const hawser_condition *of_run(hawser_sim *sim, hawser_summary *sum, const char *name)
{
    hawser_sim_summary(sim, sum);
    return condition_of(sum, name);
}

/* ------------------------------------------------------------------------------------------------------- a reel */

/* 2 m of cable are wound, whose end is fastened; the winch pulls `duration` times 0.5 m/s off it. */
#define FASTENED(how, duration)                                                                                        \
    {                                                                                                                  \
        "chain", "[{cable: power, length: 16 m, segment: 1 m}, {cable: rope, length: 20 m, segment: 1 m}]",            \
            "rollers.along", "{spacing: 2 m}", "drive.winch", "{speed: 0.5 m/s, ramp: none}", "reel.end", how,         \
            "run.duration", duration, NULL, NULL                                                                       \
    }

/* The first comes so far that the end holds. */
static const char *const fastened[][13] = {FASTENED("fixed", "8 s"), FASTENED("fixed", "3 s"), FASTENED("free", "8 s")};

/* A fastened end was let go by positions. */
TEST(positions_of_a_fastened_end)
{
    for (int k = 0; k < 3; k++) {
        hawser_error err = {0};
        hawser_sim *sim = NULL;
        hawser_case *const c = case_with(data_text("reel-payout"), fastened[k]);
        assert_int_equal(hawser_case_set(c, "run.analysis", "positions", &err), HAWSER_OK);
        const hawser_status status = hawser_sim_new(c, NULL, &sim, &err);
        hawser_case_free(c);
        assert_int_equal(status, k == 0 ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (k == 0) check_has(err.message, "the fastened end holds the cable from the front at 11 m on");
        hawser_sim_free(sim);
    }
}

/* So it was by positions that move a run: these leave such a pull to motion. */
TEST(motion_to_a_fastened_end)
{
    for (int k = 0; k < 3; k++) {
        hawser_error err = {0};
        hawser_sim *sim = NULL;
        hawser_summary sum;
        hawser_case *const c = case_with(data_text("reel-payout"), fastened[k]);
        assert_int_equal(hawser_case_set(c, "solver.motion", "auto", &err), HAWSER_OK);
        assert_int_equal(hawser_case_set(c, "solver.planar", "off", &err), HAWSER_OK);
        if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
        hawser_case_free(c);
        hawser_sim_summary(sim, &sum);
        assert_non_null(sum.quasi_static);
        if (k == 0) check_has(sum.quasi_static->why, "fastened to the reel");
        if (k != 0) assert_null(sum.quasi_static->why);
        hawser_sim_free(sim);
    }
}

/* --------------------------------------------------------------------------------------------- slow for friction */

/* A brake and bearings that are not there yet at the pull's speed make it too small, as friction does. */
TEST(what_else_fades)
{
    static const char spins[] = "{spacing: 1 m, spin: {inertia: 0.05 kg m2, bearing: {friction: 0.5, journal: 20 mm, "
                                "speed: 10 rad/s}}}";
    static const char *const reel[][5] = {{"reel.brake", "{torque: 500 N m}", "reel.v_s", "500 mm/s"},
                                          {"reel.brake", "{torque: 500 N m}", "reel.v_s", "50 mm/s"},
                                          {"reel.back_tension", "{tension: 500 N}", "reel.v_s", "500 mm/s"}};
    hawser_summary sum;
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {"rollers.along",
                                        "{spacing: 2 m}",
                                        "run",
                                        "{duration: 1 s, steady_from: 500 ms, keep_going: true}",
                                        reel[k][0],
                                        reel[k][1],
                                        reel[k][2],
                                        reel[k][3],
                                        NULL};
        hawser_sim *const sim = run_of(data_text("reel-payout"), settings);
        const hawser_condition *const c = of_run(sim, &sum, "friction_speed");
        assert_non_null(c);
        assert_int_equal(c->holds, k > 0);
        if (k == 0) check_has(c->remedy, "set reel.v_s below 0.01");
        hawser_sim_free(sim);
    }
    const char *const settings[] = {"rollers.along", spins, "run.keep_going", "true", NULL};
    hawser_sim *const sim = run_of(data_text("limits"), settings);
    const hawser_condition *const c = of_run(sim, &sum, "friction_speed");
    assert_false(c->holds);
    check_has(c->remedy, "set the rollers' spin.bearing.speed below");
    check_has(c->remedy, "rad/s");
    hawser_sim_free(sim);
}

/* --------------------------------------------------------------------------------------------------- no winch */

/* What belts alone draw has a speed, too: the limit of speed and friction's were not asked where there is no winch. */
TEST(drawn_by_belts)
{
    static const struct {
        const char *belt, *v_s, *script;
        int fades, fast;
        double speed;
    } row[] = {
        {"0.5 m/s", "1 mm/s", "[]", 0, 1, 0.5},
        {"50 mm/s", "100 mm/s", "[]", 1, 0, 0.05},
        {"50 mm/s", "10 mm/s", "[]", 0, 0, 0.05},
        {"50 mm/s", "1 mm/s", "[{at: 1 s, do: conveyor_speed, of: K, speed: 0.5 m/s, ramp: 200 ms}]", 0, 1, 0.5}};
    for (int k = 0; k < 4; k++) {
        char belts[200], text[2000];
        hawser_summary sum;
        snprintf(belts, sizeof belts,
                 "[{name: K, from: 9.2 m, to: 10.8 m, clamp: 10 kN, belt: {speed: %s, to: 300 ms}}]", row[k].belt);
        snprintf(text, sizeof text,
                 "cables: {c: {EA: 50 MN, GA: 20 MN, GJ: 8 kN m2, EI: 2 kN m2, d: 80 mm, mass: 20 kg/m}}\n"
                 "chain: [{cable: c, length: 10 m, segment: 500 mm}]\n"
                 "route: {head_at: 11 m, pieces: [{straight: 14 m}]}\nlead_in: {}\n"
                 "rollers: {along: [{spacing: 1 m}]}\nfriction: {mu: 0.2, v_s: %s}\nconveyors: %s\n"
                 "drive: {tail: {tension: 200 N, to: 500 ms}, script: %s}\n"
                 "run: {duration: 2 s, steady_from: 1500 ms}\nlimits: {pull: 20 kN}\n",
                 row[k].v_s, belts, row[k].script);
        hawser_sim *const sim = run_of(text, NULL);
        const hawser_limit speed = run_limit(sim, "speed");
        assert_true(speed.judged);
        const hawser_condition *const c = of_run(sim, &sum, "friction_speed");
        check_share(speed.value, row[k].speed, 0.03);
        assert_int_equal(speed.ok, !row[k].fast);
        assert_non_null(c);
        assert_int_equal(c->holds, !row[k].fades);
        hawser_sim_free(sim);
    }
}

/* A belt with a speed of its own that is the winch's pushes with what lengths decide, as one that follows it does;
 * where it is faster it slips, and pushes with all it has. */
TEST(a_belt_as_fast_as_the_winch)
{
    static const struct {
        const char *belt;
        int shares;
    } row[] = {{"{speed: 0.1 m/s, to: 1 s}", 1},
               {"{speed: 0.1 m/s, to: 1.02 s}", 1},
               {"{speed: 0.11 m/s, to: 1 s}", 0},
               {"{speed: 0.09 m/s, to: 1 s}", 0}};
    for (int k = 0; k < 4; k++) {
        char belts[200];
        snprintf(belts, sizeof belts, "[{name: K, from: 4.2 m, to: 5.8 m, clamp: 1 kN, belt: %s}]", row[k].belt);
        const char *const settings[] = {"route",     "{head_at: 15 m, pieces: [{straight: 24 m}]}",
                                        "rollers",   "{along: [{spacing: 1 m}]}",
                                        "conveyors", belts,
                                        NULL};
        hawser_summary sum;
        hawser_sim *const sim = run_of(data_text("limits"), settings);
        const hawser_condition *const c = of_run(sim, &sum, "shared");
        assert_int_equal(c && !c->holds, row[k].shares);
        hawser_sim_free(sim);
        hawser_error err = {0};
        hawser_sim *placed = NULL;
        hawser_case *const p = case_with(data_text("limits"), settings);
        assert_int_equal(hawser_case_set(p, "run.analysis", "positions", &err), HAWSER_OK);
        const hawser_status status = hawser_sim_new(p, NULL, &placed, &err);
        hawser_case_free(p);
        assert_int_equal(status, row[k].shares ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (row[k].shares) check_has(err.message, "depends on lengths");
        hawser_sim_free(placed);
    }
}

/* ---------------------------------------------------------------------------------------------------- rollers */

/* What of rollers.csv is asked for at a place. */
static const hawser_roller *roller_at(hawser_sim *sim, double s)
{
    const hawser_roller *roller;
    const int n = hawser_sim_rollers(sim, &roller);
    for (int r = 0; r < n; r++)
        if (fabs(roller[r].s - s) < 1e-6) return &roller[r];
    fail_msg("no roller at %g m", s);
    return NULL;
}

/* A heavy length comes to a roller when the steady window is half over: it bears that from then on, however light what
 * lay on it before was. Judged was the window's mean. */
TEST(a_load_that_comes_late)
{
    static const char text[] =
        "cables:\n"
        "  heavy: {d: 60 mm, mass: 20 kg/m, EA: 60 MN, GA: 25 MN, GJ: 10 kN m2, EI: 1 kN m2, damping: 2 ms}\n"
        "  light: {d: 60 mm, mass: 10 kg/m, EA: 60 MN, GA: 25 MN, GJ: 10 kN m2, EI: 1 kN m2, damping: 2 ms}\n"
        "chain: [{cable: heavy, length: 16 m, segment: 250 mm}, {cable: light, length: 6 m, segment: 250 mm, rope: "
        "false}]\n"
        "route: {head_at: 14 m, pieces: [{straight: 22 m}]}\nlead_in: {}\n"
        "rollers: {along: [{spacing: 1 m, to: 10.5 m}, {spacing: 1 m, from: 11 m, to: 12.5 m, rating: 300 N},\n"
        "  {spacing: 1 m, from: 13 m}]}\n"
        "friction: {mu: 0.1}\ndrive: {winch: {speed: 1 m/s, to: 1 s}, tail: {tension: 1 kN}}\n"
        "run: {duration: 6.5 s, steady_from: 1500 ms}\nlimits: {pull: 30 kN}\n";
    hawser_sim *const sim = run_of(text, NULL);
    const hawser_limit steady = run_limit(sim, "roller_steady");
    assert_true(steady.judged);
    check_share(steady.value, 20 * 9.81 * hypot(1, 0.1), 0.05); /* where it begins it bends, and bears 4 % more */
    check_below(roller_at(sim, 11)->steady_N, 0.9 * steady.value);
    assert_false(steady.ok);
    hawser_sim_free(sim);
}

/* An eye goes over rollers on segments that are too short for its radius to fall over one of them (C6): the taper is
 * as long as a roller needs it. The load grew with the mesh, to 160 kN in a longer scene. */
TEST(an_eye_on_short_segments)
{
    static const char text[] =
        "cables:\n"
        "  power: {d: 80 mm, mass: 14 kg/m, EA: 60 MN, GA: 25 MN, GJ: 10 kN m2, EI: 2 kN m2, damping: 2 ms}\n"
        "  rope: {d: 14 mm, EA: 15.7 MN, GA: 6.05 MN, GJ: 263 N m2, EI: 342 N m2, mass: 0.676 kg/m, damping: 20 ms}\n"
        "chain: [{cable: power, length: 6 m, segment: 250 mm}, {cable: rope, length: 4 m, segment: 250 mm, swivel: "
        "true}]\n"
        "route: {head_at: 4.3 m, pieces: [{straight: 9 m}]}\nlead_in: {}\n"
        "rollers: {along: [{spacing: 1 m, radius: 60 mm, width: 400 mm}]}\nfriction: {mu: 0.2}\n"
        "drive: {winch: {speed: 0.2 m/s, ramp: step, to: 500 ms}, tail: {tension: 3 kN}}\n"
        "run: {duration: 9 s, steady_from: 2 s}\n";
    static const char *const segment[] = {"250 mm", "80 mm", "62.5 mm", "80 mm"};
    static const char far[] = "[{name: D, centre: [4, 0, -30], axis: [0, 1, 0], radius: 5 m, width: 1 m}]";
    double peak[4];
    for (int k = 0; k < 4; k++) { /* the last beside a drum that it never comes to */
        const char *const settings[] = {
            "chain.0.segment", segment[k], "chain.1.segment", segment[k], k == 3 ? "rollers.list" : NULL, far, NULL};
        hawser_sim *const sim = run_of(text, settings);
        peak[k] = roller_at(sim, 5)->peak_N;
        hawser_sim_free(sim);
        if (k > 0) check_share(peak[k], peak[0], 0.15);
    }
    check_share(peak[3], peak[1], 1e-6);
}
