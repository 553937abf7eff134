/* A simulation as a whole: a short pull, the same one elsewhere, twice, side by side and on two threads. */
#include "sim/run/sim.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS, ROLLERS_MAX = 32 };

/* What a pull ends with. */
typedef struct Result {
    double t, winch_force, travel;
    double position[3 * N], quaternion[4 * N], velocity[3 * N], omega[3 * N];
    double tension[N + 1], roller_load[ROLLERS_MAX];
    int rollers;
    long steps;
} Result;

static Sim *pull_new(const FixtureChoice *choice, int threads)
{
    SceneDef def;
    fixture_pull(&def, choice);
    Sim *const s = sim_made(&def, threads);
    return s;
}

static void advance(Sim *s, double t)
{
    hawser_error err = {0};
    if (sim_advance(s, t, 0, &err)) fail_msg("%s", err.message);
}

static void result_take(Sim *s, Result *out)
{
    memset(out, 0, sizeof *out); /* padding too: results are compared bit by bit */
    const hawser_sample *const look = hawser_sim_sample(s);
    hawser_summary summary;
    hawser_sim_summary(s, &summary);
    out->t = look->t;
    out->winch_force = look->winch_force;
    out->travel = look->winch_travel;
    out->rollers = look->rollers;
    out->steps = summary.steps;
    memcpy(out->position, look->position, sizeof out->position);
    memcpy(out->quaternion, look->quaternion, sizeof out->quaternion);
    memcpy(out->velocity, look->velocity, sizeof out->velocity);
    memcpy(out->omega, look->omega, sizeof out->omega);
    memcpy(out->tension, look->tension, sizeof out->tension);
    memcpy(out->roller_load, look->roller_load, (size_t)look->rollers * sizeof(double));
}

/* Relaxes, pulls to `to` in two goes, takes the result. */
static void pull_run(const FixtureChoice *choice, int threads, double to, Result *out)
{
    Sim *s = pull_new(choice, threads);
    hawser_relaxation relaxation;
    assert_int_equal(sim_relax(s, &relaxation, NULL), HAWSER_OK);
    assert_true(relaxation.reached);
    advance(s, to / 3);
    advance(s, to);
    result_take(s, out);
    sim_free(s);
}

/* The pull runs, with both geometries; the cable moves at the winch's speed and is held back by tail and friction. */
TEST(test_pull)
{
    double force[2];
    for (int geometry = 0; geometry < 2; ++geometry) {
        Result r;
        pull_run(&(FixtureChoice){.geometry = geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH}, 1, 3, &r);
        print_message("pull %.1f N after %ld steps\n", r.winch_force, r.steps);
        force[geometry] = r.winch_force;
        check_close(r.t, 3, 1e-14);
        check_close(r.travel, 0.1 * 2.5, 1e-14); /* STEP's area is half of its second */
        /* more than tail and drag, less than these with all the weight as friction and hoisted by 0.5 m */
        check_between(r.winch_force, 800 + 240, 800 + 300 + 0.3 * 12 * 20 * 9.81 + 20 * 9.81);
        check_share(r.tension[N], r.winch_force, 0.02);
        for (int i = 0; i < N; ++i) {
            const double *const v = r.velocity + 3 * i;
            check_close(sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]), 0.1, 0.02);
        }
    }
    check_close(force[0], force[1], 0.01 * force[0]); /* the capsules' ripple */
}

/* Turned about the vertical and shifted, the pull is the same. */
TEST(test_elsewhere)
{
    Result here, there;
    pull_run(&(FixtureChoice){.accuracy = 1e-4}, 1, 3, &here);
    pull_run(&(FixtureChoice){.start = {3, -7, 2}, .heading = 2.2, .accuracy = 1e-4}, 1, 3, &there);
    double tension = fabs(here.winch_force - there.winch_force), load = 0;
    for (int j = 0; j <= N; ++j) tension = larger_of(tension, fabs(here.tension[j] - there.tension[j]));
    for (int k = 0; k < here.rollers; ++k) load = larger_of(load, fabs(here.roller_load[k] - there.roller_load[k]));
    print_message("tensions differ by %.2g N of %.0f, roller loads by %.2g N\n", tension, here.winch_force, load);
    check_below(tension, 1e-4 * here.winch_force);
    check_below(load, 1e-4 * here.winch_force);
}

/* The same run gives the same bits; so does a second thread. */
TEST(test_repeated)
{
    Result first, again, two;
    pull_run(&(FixtureChoice){0}, 1, 2, &first);
    pull_run(&(FixtureChoice){0}, 1, 2, &again);
    pull_run(&(FixtureChoice){0}, 2, 2, &two);
    assert_memory_equal(&first, &again, sizeof first);
    assert_memory_equal(&first, &two, sizeof first);
}

/* Two simulations, taking turns step by step, do not notice each other. */
TEST(test_side_by_side)
{
    const FixtureChoice choice[2] = {{0}, {.geometry = GEOMETRY_CYLINDER, .frame = FRAME_ADAMS, .heading = 1}};
    Result alone[2], together[2];
    Sim *s[2];
    for (int k = 0; k < 2; ++k) {
        pull_run(&choice[k], 1, 1.5, &alone[k]);
        s[k] = pull_new(&choice[k], 1);
    }
    for (int k = 0; k < 2; ++k) assert_int_equal(sim_relax(s[k], NULL, NULL), HAWSER_OK);
    for (double to = 0.5; to < 2; to += 1) { /* 0.5, 1.5: as pull_run stops */
        while (hawser_sim_time(s[0]) < to || hawser_sim_time(s[1]) < to) {
            for (int k = 0; k < 2; ++k) assert_int_equal(sim_advance(s[k], to, 1, NULL), HAWSER_OK);
        }
    }
    for (int k = 0; k < 2; ++k) {
        result_take(s[k], &together[k]);
        sim_free(s[k]);
        assert_memory_equal(&alone[k], &together[k], sizeof alone[k]);
    }
}

/* One step is one step: forward, never beyond the time given, and every corner of the profiles is hit on the way. */
TEST(test_one_step)
{
    Sim *s = pull_new(&(FixtureChoice){0}, 1);
    const double corner[] = {0.5, 1, 1.5}; /* s: tail starts, winch is up, tail is up */
    int hit[3] = {0};
    long calls = 0;
    assert_int_equal(sim_relax(s, NULL, NULL), HAWSER_OK);
    while (hawser_sim_time(s) < 1.75) {
        const double before = hawser_sim_time(s);
        assert_int_equal(sim_advance(s, 1.75, 1, NULL), HAWSER_OK);
        check_above(hawser_sim_time(s), before);
        check_at_most(hawser_sim_time(s), 1.75);
        for (int k = 0; k < 3; ++k) hit[k] += fabs(hawser_sim_time(s) - corner[k]) < 1e-12;
        ++calls;
    }
    hawser_summary summary;
    hawser_sim_summary(s, &summary);
    assert_int_equal(summary.steps, calls);
    for (int k = 0; k < 3; ++k) assert_int_equal(hit[k], 1);
    /* what lies behind is no work */
    assert_int_equal(sim_advance(s, 1, 0, NULL), HAWSER_OK);
    check_close(hawser_sim_time(s), 1.75, 1e-15);
    sim_free(s);
}

/* Looking between steps changes no bit. */
TEST(test_sample_is_pure)
{
    Result seen, unseen;
    pull_run(&(FixtureChoice){0}, 1, 1.6, &unseen);
    Sim *s = pull_new(&(FixtureChoice){0}, 1);
    assert_int_equal(sim_relax(s, NULL, NULL), HAWSER_OK);
    const double stop[] = {1.6 / 3, 1.6};
    for (int k = 0; k < 2; ++k) {
        while (hawser_sim_time(s) < stop[k]) {
            assert_int_equal(sim_advance(s, stop[k], 1, NULL), HAWSER_OK);
            hawser_sim_record(s);
        }
    }
    result_take(s, &seen);
    assert_memory_equal(&seen, &unseen, sizeof seen);
    sim_free(s);
}

/* What is known before anything moves, and what the summary counts. */
TEST(test_summary)
{
    Sim *s = pull_new(&(FixtureChoice){0}, 1);
    hawser_summary summary;
    assert_int_equal(sim_relax(s, NULL, NULL), HAWSER_OK);
    hawser_sim_summary(s, &summary);
    assert_int_equal(summary.segments, N);
    assert_int_equal(summary.bushings, N); /* between segments, and to the winch */
    assert_int_equal(summary.rollers, 14); /* 12 below, 2 beside the bend */
    assert_true(summary.relaxation.reached);
    check_at_least(summary.contact_candidates, summary.rollers);
    assert_int_equal(summary.steps, 0);
    check_close(hawser_sim_end_time(s), 3, 1e-15);
    advance(s, 0.5);
    hawser_sim_record(s);
    hawser_sim_summary(s, &summary);
    check_above(summary.steps, 5);
    check_at_least(summary.rhs_evals, summary.steps);
    check_at_least(summary.newton_iters, summary.steps);
    check_at_least(summary.contact_active_max, 5);
    check_at_most(summary.contact_active_max, summary.contact_candidates);
    check_above(summary.pull_peak_N, 0);
    assert_non_null(summary.linear_solver);
    sim_free(s);
}

/* The weight of the whole chain rests on the rollers, up to what slope, lead-in and winch take. */
TEST(test_roller_table)
{
    Sim *s = pull_new(&(FixtureChoice){0}, 1);
    const hawser_roller *roller;
    double sum = 0;
    assert_int_equal(sim_relax(s, NULL, NULL), HAWSER_OK);
    hawser_sim_record(s);
    const int count = hawser_sim_rollers(s, &roller);
    for (int k = 0; k < count; ++k) {
        check_at_least(roller[k].initial_N, 0);
        check_at_least(roller[k].peak_N, roller[k].initial_N);
        sum += roller[k].initial_N;
    }
    /* 9 m of cable at 20 kg/m, without what tension adds in the bends */
    check_between(sum, 0.9 * 9 * 20 * 9.81, 1.5 * 9 * 20 * 9.81);
    sim_free(s);
}
