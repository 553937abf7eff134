/* The statistics of a run on signals whose means, ripple and peaks are known. */
#include "sim/run/sample.h"
#include "sim/run/stats.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS, STATIONS = 3 };

static const double STEADY_FROM = 4, END = 10; /* s */

typedef struct Rig {
    Scene scene;
    Workspace ws;
    SampleBuffers look;
    Stats stats;
    double y[STATE_SIZE * N];
} Rig;

/* The chain on its route, with stations at 2 m and 6.3 m and one where no cable is. */
static Rig *rig_new(void)
{
    Rig *const r = fixture_array(1, sizeof *r);
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    def.output.steady_from = STEADY_FROM;
    def.n_stations = STATIONS;
    def.stations = fixture_array(STATIONS, sizeof *def.stations);
    const double place[STATIONS] = {2, 6.3, 14};
    for (int k = 0; k < STATIONS; ++k) def.stations[k].s = place[k];
    fixture_build(&def, &r->scene);
    assert_true(workspace_alloc(&r->ws, &r->scene, NULL) && sample_alloc(&r->look, &r->scene));
    assert_int_equal(stats_new(&r->stats, &r->scene, NULL), HAWSER_OK);
    scene_initial_state(&r->scene, r->y);
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0, r->y, 1, NULL), HAWSER_OK);
    sample_take(&r->look, &r->scene, &r->ws, 0, dynamics_look(&r->scene, &r->ws, 0, r->y), SAMPLE_ALL);
    return r;
}

static void rig_free(Rig *r)
{
    stats_free(&r->stats);
    sample_free(&r->look);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    free(r);
}

/* Records the sample of time t with the given signals; loads and tensions in proportion to the force. */
static void record(Rig *r, double t, double force, double speed)
{
    hawser_sample *const s = &r->look.sample;
    s->t = t;
    s->winch_force = force;
    s->winch_travel = 0;
    for (int i = 0; i < N; ++i) r->look.axial_speed[i] = speed;
    for (int k = 0; k < s->rollers; ++k) r->look.roller_load[k] = (k + 1) * force;
    for (int j = 0; j <= N; ++j) r->look.tension[j] = force * r->scene.joint_s[j];
    stats_record(&r->stats, &r->scene, &r->ws.kin, s);
}

/* A force that rises evenly, 5 + 2 t, sampled at uneven times: mean 19 and ripple 12 / sqrt(12) from 4 s to 10 s. */
TEST(test_means)
{
    Rig *const r = rig_new();
    hawser_summary out;
    double t = 0;
    for (int k = 0; t < END; ++k) {
        record(r, t, 5 + 2 * t, 0.1);
        t = fmin(t + (k % 2 ? 0.005 : 0.015), END);
        if (fabs(t - STEADY_FROM) < 0.01) t = STEADY_FROM;
    }
    record(r, END, 5 + 2 * END, 0.1);
    record(r, END, 1e6, 9); /* no time has passed: it does not count */
    stats_summary(&r->stats, &out);
    check_close(out.pull_mean_N, 19, 1e-10);
    check_close(out.pull_ripple_N, sqrt(12), 1e-4);
    check_close(out.pull_peak_N, 25, 1e-12);
    check_below(fabs(out.steady_from_s - STEADY_FROM) + fabs(out.steady_to_s - END), 1e-12);
    check_close(out.steady_speed_m_per_s, 0.1, 1e-12);
    for (int k = 0; k < r->stats.n_rollers; ++k) {
        const hawser_roller *const roller = &r->stats.roller_out[k];
        check_close(roller->steady_N, (k + 1) * 19, 1e-9);
        check_close(roller->peak_N, (k + 1) * 25, 1e-9);
        check_close(roller->initial_N, (k + 1) * 5, 1e-9);
    }
    rig_free(r);
}

/* The tension at a station is read off where the joints lie on the route; where there is no cable there is none. */
TEST(test_stations)
{
    Rig *const r = rig_new();
    for (int k = 0; k <= 20; ++k) record(r, 0.5 * k, 10, 0.1);
    const hawser_station *const at = r->stats.station_out;
    for (int k = 0; k < 2; ++k) {
        check_close(at[k].mean_N, 10 * at[k].s, 1e-12);
        check_close(at[k].peak_N, 10 * at[k].s, 1e-12);
    }
    check_nan(at[2].mean_N);
    check_nan(at[2].peak_N);
    rig_free(r);
}

/* The time from which on the speed stays within 2 % of the winch's. */
TEST(test_settling)
{
    Rig *const r = rig_new();
    hawser_summary out;
    for (int k = 0; k <= 1000; ++k) {
        const double t = 0.01 * k, swing = 0.1 * exp(-t); /* passes 2 % of 0.1 m/s at ln 50 = 3.912 s */
        record(r, t, 1, 0.1 + swing);
    }
    stats_summary(&r->stats, &out);
    check_close(out.settle_time_s, log(50), 0.011);
    rig_free(r);
}

/* A speed that is still off as the run ends has not settled at its end; a window that was not reached ends nowhere. */
TEST(test_stopped)
{
    Rig *const r = rig_new();
    hawser_summary out;
    for (int k = 0; k <= 20; ++k) record(r, 0.1 * k, 1, 0.15);
    stats_summary(&r->stats, &out);
    check_nan(out.settle_time_s);
    check_close(out.steady_from_s, STEADY_FROM, 0);
    check_nan(out.steady_to_s);
    check_nan(out.pull_mean_N);
    rig_free(r);
}

/* Errors of the stations against both theories, largest and mean; a station without cable does not count. */
TEST(test_errors)
{
    Rig *const r = rig_new();
    hawser_summary out;
    for (int k = 0; k <= 20; ++k) record(r, 0.5 * k, 10, 0.1);
    hawser_station *const at = r->stats.station_out;
    const double reference[STATIONS] = {20 / 1.01, 63 / 0.95, NAN}, paper[STATIONS] = {20, 63 / 1.1, NAN};
    for (int k = 0; k < STATIONS; ++k) {
        at[k].reference_N = reference[k];
        at[k].paper_N = paper[k];
    }
    stats_summary(&r->stats, &out);
    check_close(out.error_max_pct, 5, 1e-12);
    check_close(out.error_mean_pct, 3, 1e-12);
    check_close(out.error_max_paper_pct, 10, 1e-12);
    check_close(out.error_mean_paper_pct, 5, 1e-12);
    rig_free(r);
}

/* Before the steady window there are no means; what a run's last value was is none. */
TEST(test_before_the_window)
{
    Rig *const r = rig_new();
    hawser_summary out;
    record(r, 0, 3, 0.1);
    record(r, 1, 7, 0.1);
    record(r, 2, 4, 0.1);
    stats_summary(&r->stats, &out);
    check_nan(out.pull_mean_N);
    check_close(out.pull_ripple_N, 0, 1e-15);
    check_close(out.pull_peak_N, 7, 1e-15);
    rig_free(r);
}
