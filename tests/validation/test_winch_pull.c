/* Winches at work on a level row of rollers: a set tension against closed forms, a trip with its restart. */
#include "tests/support/rig.h"

#include <stdio.h>

static const RowChoice ROW = {.segments = 40, .pitch = 1, .mu = 0.2};

static Sim *started(SceneDef *def, double duration, int threads)
{
    hawser_error err = {0};
    hawser_relaxation relaxation;
    def->duration = duration;
    Sim *const s = sim_made(def, threads);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    return s;
}

static const hawser_sample *at_time(Sim *s, double t)
{
    hawser_error err = {0};
    if (sim_advance(s, t, 0, &err)) fail_msg("%s", err.message);
    return hawser_sim_sample(s);
}

static void tension_row(SceneDef *def, double force)
{
    row_scene(def, &ROW);
    def->winch = (WinchDef){.present = 1,
                            .axial_only = 1,
                            .mode = WINCH_TENSION,
                            .tension = {.kind = PROFILE_STEP, .t1 = 0.2, .v1 = force},
                            .band = 0.05,
                            .drum_mass = 700};
}

/* A force above the friction accelerates cable and drum: (F - mu m g)/(m + drum). */
TEST(test_acceleration)
{
    const double mass = row_weight(&ROW) / ROW_G, friction = ROW.mu * row_weight(&ROW), force = 1.2 * friction;
    const double exact = (force - friction) / (mass + 700);
    SceneDef def;
    tension_row(&def, force);
    Sim *s = started(&def, 6, 1);
    const double before = at_time(s, 1)->winch_speed, middle = at_time(s, 3)->winch_travel,
                 after = at_time(s, 4)->winch_speed, end = hawser_sim_sample(s)->winch_travel;
    const double found = (after - before) / 3;
    print_message("acceleration %.6f, exact %.6f m/s2 (%.3f %%)\n", found, exact, 100 * (found / exact - 1));
    check_share(found, exact, 2e-3);
    /* travel over the last second: its mean speed */
    check_share(end - middle, after - exact / 2, 2e-3);
    check_share(hawser_sim_sample(s)->winch_force, force, 1e-13);
    sim_free(s);
}

/* With a limit the speed settles where the falling force meets the friction: STEP = friction/force. */
TEST(test_speed_limit)
{
    const double friction = ROW.mu * row_weight(&ROW), force = 2 * friction; /* STEP = 1/2: the middle of the band */
    SceneDef def;
    tension_row(&def, force);
    def.winch.speed_limit = 0.1;
    Sim *s = started(&def, 8, 1);
    double mean = 0, pull = 0;
    for (int k = 1; k <= 40; ++k) {
        const hawser_sample *const look = at_time(s, 4 + 0.1 * k);
        mean += look->winch_speed / 40;
        pull += look->winch_force / 40;
    }
    print_message("speed %.6f m/s, exact %.6f; pull %.2f N, exact %.2f N\n", mean, 0.1 * 0.975, pull, friction);
    check_share(mean, 0.1 * 0.975, 1e-4);
    check_share(pull, friction, 2e-3);
    sim_free(s);
}

/* Less than the friction moves nothing but what the regularised law lets creep: v_s/3 at half the friction or so. */
TEST(test_too_little)
{
    const double friction = ROW.mu * row_weight(&ROW);
    SceneDef def;
    tension_row(&def, 0.5 * friction);
    Sim *s = started(&def, 3, 1);
    const double before = at_time(s, 2)->winch_travel, after = at_time(s, 3)->winch_travel;
    check_between(after - before, 0, 1e-3); /* v_s for a second */
    sim_free(s);
}

/* A row whose tail is held back by more than the winch may pull, between 3 and 5 s. mu_s is half as large again as
 * mu_d.
 */
static void trip_row(SceneDef *def, double limit)
{
    row_scene(def, &ROW);
    def->friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.2, .v_s = 1e-3, .v_d = 5e-3};
    for (int r = 0; r < def->n_rollers; ++r) def->rollers[r].friction = def->friction;
    assert_true(profile_table(&def->tail.tension, 5));
    const double points[5][2] = {{0, 0}, {3, 0}, {4, 4000}, {5, 4000}, {5.5, 0}};
    for (int i = 0; i < 5; ++i) {
        def->tail.tension.time[i] = points[i][0];
        def->tail.tension.value[i] = points[i][1];
    }
    def->winch.trip = (TripDef){.force = limit, .brake = 0.2, .pause = 3, .ramp = 1, .restarts = 1};
}

/* What a run with a trip showed. */
typedef struct TripRun {
    double first_peak, peak, restart_peak, last; /* N: of the start, of all, from the restart on, at the end */
    double speed;                                /* m/s, at the end */
    int n;
    struct {
        double t, pull_N;
        char what[80];
    } event[8];
} TripRun;

static TripRun trip_run(double limit, int threads)
{
    TripRun out = {0};
    SceneDef def;
    hawser_error err = {0};
    trip_row(&def, limit);
    Sim *s = started(&def, 12, threads);
    while (hawser_sim_time(s) < 12) {
        if (sim_advance(s, 12, 1, &err)) fail_msg("%s", err.message);
        const hawser_sample *const look = hawser_sim_sample(s);
        const hawser_event *event;
        const int events = hawser_sim_events(s, &event);
        if (hawser_sim_time(s) < 3) out.first_peak = larger_of(out.first_peak, look->winch_force);
        if (events >= 3) out.restart_peak = larger_of(out.restart_peak, look->winch_force);
        out.peak = larger_of(out.peak, look->winch_force);
        out.last = look->winch_force;
        out.speed = look->axial_speed[0];
    }
    const hawser_event *event;
    out.n = hawser_sim_events(s, &event);
    assert_in_range(out.n, 0, 8);
    for (int i = 0; i < out.n; ++i) {
        out.event[i].t = event[i].t;
        out.event[i].pull_N = event[i].pull_N;
        snprintf(out.event[i].what, sizeof out.event[i].what, "%s", event[i].what);
    }
    sim_free(s);
    return out;
}

/* The trip, the stop, the restart; the force is kept near the limit and breaks the cable away again by mu_s. */
TEST(test_trip)
{
    const double weight = row_weight(&ROW), limit = 0.2 * weight + 2500;
    const TripRun r = trip_run(limit, 1);
    for (int i = 0; i < r.n; ++i)
        print_message("%.4f s: %s, %.1f N\n", r.event[i].t, r.event[i].what, r.event[i].pull_N);
    print_message(
        "friction %.0f N, break-away %.0f N, limit %.0f N, peaks %.0f (start), %.0f, %.0f (restart), end %.1f "
        "N\n",
        0.2 * weight, 0.3 * weight, limit, r.first_peak, r.peak, r.restart_peak, r.last);
    assert_int_equal(r.n, 4);
    /* the tail's 2.5 kN are reached at 3.625 s */
    check_between(r.event[0].t, 3.6, 3.7);
    check_between(r.event[0].pull_N, limit, limit + 4000 * 0.05); /* N/s, s: one step */
    check_close(r.event[1].t - r.event[0].t, 0.2, 1e-9);
    check_close(r.event[2].t - r.event[1].t, 3, 1e-9);
    check_close(r.event[3].t - r.event[2].t, 1, 1e-9);
    /* while it brakes the tail's tension goes on growing, and just before the end friction rises to mu_s */
    check_below(r.peak, limit + 4000 * (0.05 + 0.2) + 0.1 * weight);
    /* both starts break away: mu_s of the weight, and less than 1 % for the mass */
    check_between(r.first_peak, 0.285 * weight, 0.31 * weight + 0.15 * weight / ROW_G);
    check_between(r.restart_peak, 0.285 * weight, 0.31 * weight + 0.15 * weight / ROW_G);
    check_share(r.last, 0.2 * weight, 5e-4);
    check_share(r.speed, 0.1, 5e-5);
}

/* Two threads change no bit of a run with trips, nor does a limit that is never reached one of a run without. */
TEST(test_trip_threads)
{
    const double limit = 0.2 * row_weight(&ROW) + 2500;
    const TripRun one = trip_run(limit, 1), two = trip_run(limit, 2), high = trip_run(1e9, 1), none = trip_run(0, 1);
    assert_memory_equal(&one, &two, sizeof one);
    assert_memory_equal(&high, &none, sizeof high);
    assert_int_equal(none.n, 0);
    check_above(none.peak, limit + 1400);
}

/* A trip that ends the run: the end comes nearer, and the run is told from one that was finished. */
TEST(test_trip_ends_the_run)
{
    SceneDef def;
    trip_row(&def, 0.2 * row_weight(&ROW) + 2500);
    def.winch.trip.restarts = 0;
    def.winch.trip.ends_run = 1;
    Sim *s = started(&def, 12, 1);
    hawser_error err = {0};
    check_close(hawser_sim_end_time(s), 12, 1e-12);
    check_close(s->stage.scene.def.duration, 12, 1e-12);
    while (hawser_sim_time(s) < hawser_sim_end_time(s))
        assert_int_equal(sim_advance(s, hawser_sim_end_time(s), 1, &err), HAWSER_OK);
    assert_true(hawser_sim_end_time(s) < s->stage.scene.def.duration);
    check_between(hawser_sim_time(s), 3.8, 3.9);
    sim_free(s);
}

/* By a factor of what the theory expects; a theory that expects nothing is no measure. */
TEST(test_trip_factor)
{
    SceneDef def;
    hawser_error err = {0};
    trip_row(&def, 0);
    def.winch.trip.factor = 1 + 2500 / (0.2 * row_weight(&ROW));
    Sim *s = started(&def, 12, 1);
    at_time(s, 3.9);
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    check_between(event[0].t, 3.6, 3.7);
    sim_free(s);
    trip_row(&def, 0);
    def.winch.trip.factor = 1.5;
    def.friction = (FrictionLaw){.mu_s = 0, .mu_d = 0, .v_s = 1e-3, .v_d = 5e-3};
    assert_int_equal(sim_new(&def, 1, &s, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "drive.winch.trip.factor");
    scene_def_clear(&def);
}
