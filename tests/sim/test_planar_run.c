/* Runs in the plane: the pull of the same scene solved in space, the same bits on two threads, what a free chain
 * conserves. */
#include "sim/run/sim.h"
#include "sim/solve/integrator.h"
#include "sim/solve/planar.h"
#include "tests/support/scene.h"

/* A recorded pull of the planar scene; its samples are kept apart. */
typedef struct Pulled {
    hawser_summary summary;
    double tension[FIXTURE_SEGMENTS + 1], place[3 * FIXTURE_SEGMENTS], load[32];
} Pulled;

static void pull_at_reach(Pulled *out, PlanarChoice planar, ContactGeometry geometry, int threads, double accuracy,
                          double reach)
{
    SceneDef def;
    hawser_error err = {0};
    hawser_relaxation relaxation;
    fixture_planar(&def, &(FixtureChoice){.geometry = geometry, .heading = 37 * M_PI / 180, .accuracy = accuracy});
    def.solver.planar = planar;
    def.contact_reach = reach;
    Sim *const s = sim_made(&def, threads);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    hawser_sim_record(s);
    for (int k = 1; k <= 60; ++k) {
        if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
        if (k % 2) sim_record_row(s);
        if (k % 2 == 0) hawser_sim_record(s);
    }
    const hawser_sample *const look = hawser_sim_sample(s);
    memset(out, 0, sizeof *out);
    memcpy(out->tension, look->tension, sizeof out->tension);
    memcpy(out->place, look->position, sizeof out->place);
    memcpy(out->load, look->roller_load, (size_t)look->rollers * sizeof(double));
    hawser_sim_summary(s, &out->summary);
    assert_int_equal(out->summary.planar, planar != PLANAR_OFF);
    sim_free(s);
}

/* With candidates that are renewed on the way. */
static void pull(Pulled *out, PlanarChoice planar, ContactGeometry geometry, int threads, double accuracy)
{
    pull_at_reach(out, planar, geometry, threads, accuracy, 0.1);
}

static double largest_difference(int count, const double *a, const double *b)
{
    double most = 0;
    for (int k = 0; k < count; ++k) most = larger_of(most, fabs(a[k] - b[k]));
    return most;
}

/* Both follow the same motion to the tolerance: pull, tensions, places and loads. */
TEST(test_agreement)
{
    for (int g = 0; g < 2; ++g) {
        Pulled flat, full;
        const ContactGeometry geometry = g ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH;
        pull(&flat, PLANAR_ON, geometry, 1, 1e-4);
        pull(&full, PLANAR_OFF, geometry, 1, 1e-4);
        const double force = full.summary.pull_mean_N, error = fabs(flat.summary.pull_mean_N / force - 1);
        const double tension = largest_difference(FIXTURE_SEGMENTS + 1, flat.tension, full.tension) / force;
        const double load = largest_difference(32, flat.load, full.load) / force;
        const double place = largest_difference(3 * FIXTURE_SEGMENTS, flat.place, full.place);
        print_message("pull %.3f N, off by %.1g; tensions %.1g, loads %.1g, places %.1g m; %ld and %ld steps\n", force,
                      error, tension, load, place, flat.summary.steps, full.summary.steps);
        check_above(flat.summary.contact_refreshes, 1);
        check_close((double)(flat.summary.steps - full.summary.steps), 0, 0.1 * (double)full.summary.steps);
        check_below(error, 2e-5);
        check_below(tension, 3e-4);
        check_below(load, 1e-3);
        check_below(place, 3e-5); /* 1.4e-5 by clang, half of it by gcc */
    }
}

TEST(test_threads)
{
    Pulled one, two;
    pull(&one, PLANAR_ON, GEOMETRY_SMOOTH, 1, 1e-3);
    pull(&two, PLANAR_ON, GEOMETRY_SMOOTH, 2, 1e-3);
    assert_memory_equal(one.tension, two.tension, sizeof one.tension);
    assert_memory_equal(one.place, two.place, sizeof one.place);
    assert_memory_equal(one.load, two.load, sizeof one.load);
    check_equal(one.summary.pull_mean_N, two.summary.pull_mean_N);
    check_equal(one.summary.steps, two.summary.steps);
}

/* Which pairs are looked at does not change a bit: few, renewed again and again, or all of them, once. */
TEST(test_reach)
{
    Pulled few, all;
    pull(&few, PLANAR_ON, GEOMETRY_SMOOTH, 1, 1e-3);
    pull_at_reach(&all, PLANAR_ON, GEOMETRY_SMOOTH, 1, 1e-3, 1e6);
    check_above(few.summary.contact_refreshes, 1);
    check_equal(all.summary.contact_refreshes, 1);
    assert_int_equal(all.summary.contact_candidates, (FIXTURE_SEGMENTS + 1) * all.summary.rollers);
    check_below(few.summary.contact_candidates, all.summary.contact_candidates / 4);
    assert_memory_equal(few.tension, all.tension, sizeof few.tension);
    assert_memory_equal(few.place, all.place, sizeof few.place);
    assert_memory_equal(few.load, all.load, sizeof few.load);
    check_equal(few.summary.steps, all.summary.steps);
}

/* What a row leaves out of the sample it does not leave out of the statistics. */
TEST(test_rows)
{
    hawser_summary summary[2];
    for (int whole = 0; whole < 2; ++whole) {
        SceneDef def;
        hawser_error err = {0};
        fixture_planar(&def, &(FixtureChoice){0});
        def.output.steady_from = 0.5;
        Sim *const s = sim_made(&def, 1);
        for (int k = 0; k <= 20; ++k) {
            if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
            (whole ? hawser_sim_record : sim_record_row)(s);
        }
        hawser_sim_summary(s, &summary[whole]);
        sim_free(s);
    }
    check_equal(summary[0].pull_mean_N, summary[1].pull_mean_N);
    check_equal(summary[0].pull_peak_N, summary[1].pull_peak_N);
    check_equal(summary[0].steps, summary[1].steps);
    check_equal(summary[0].error_max_pct, summary[1].error_max_pct);
}

/* A planar free chain with its own workspace and integrator. */
typedef struct Rig {
    Scene scene;
    Workspace ws;
    Planar planar;
    Team *team;
    double *y, t;
} Rig;

static Rig *rig_new(int n, double accuracy, int threads)
{
    Rig *const r = fixture_array(1, sizeof *r);
    SceneDef def;
    Plane plane;
    char why[PLANE_WHY_MAX];
    hawser_error err = {0};
    uint64_t seed = 5;
    fixture_free_chain(&def, n);
    def.solver.accuracy = accuracy;
    def.route_heading = 0.7;
    fixture_build(&def, &r->scene);
    r->team = threads > 1 ? team_new(threads) : NULL;
    assert_true(workspace_alloc(&r->ws, &r->scene, r->team));
    if (!plane_find(&r->scene, &plane, why)) fail_msg("%s", why);
    LinOptions options = r->scene.def.solver.linear;
    options.threads = threads;
    options.team = r->team;
    if (planar_new(&r->planar, &r->scene, &plane, &r->ws, &options, &err)) fail_msg("%s", err.message);
    double *const full = fixture_array(STATE_SIZE * n, sizeof *full);
    r->y = fixture_array(r->planar.motion.size, sizeof *r->y);
    scene_initial_state(&r->scene, full);
    r->planar.motion.ops->pack(&r->planar.motion, full, r->y);
    planar_shake(r->y, n, 0.01, 0.1, 0.3, 0.5, &seed);
    free(full);
    return r;
}

static void rig_free(Rig *r)
{
    planar_free(&r->planar);
    workspace_free(&r->ws);
    scene_clear(&r->scene);
    team_free(r->team);
    free(r->y);
    free(r);
}

/* Energy (J), momentum and angular momentum of the chain. */
static void balance_of(Rig *r, double out[4])
{
    const PlanarChain *const c = &r->planar.ps.chain;
    const int stride = c->stride;
    memset(out, 0, 4 * sizeof *out);
    for (int i = 0; i < c->n; ++i) {
        const double *const at = r->y + i, m = c->mass[i], vx = at[3 * stride], vz = at[4 * stride], w = at[5 * stride];
        out[0] += (m * (vx * vx + vz * vz) + c->inertia[i] * w * w) / 2;
        out[1] += m * vx;
        out[2] += m * vz;
        out[3] += m * (at[0] * vz - at[stride] * vx) + c->inertia[i] * w;
    }
    for (int j = 1; j < c->n; ++j) { /* the law (PL6), from the state alone */
        const double *const a = r->y + j - 1, *const b = r->y + j;
        const double angle_a = a[2 * stride], angle_b = b[2 * stride], mean = (angle_a + angle_b) / 2;
        const double x = b[0] - a[0] - c->half[j - 1] * cos(angle_a) - c->half[j] * cos(angle_b);
        const double z = b[stride] - a[stride] - c->half[j - 1] * sin(angle_a) - c->half[j] * sin(angle_b);
        const double d[3] = {cos(mean) * x + sin(mean) * z, cos(mean) * z - sin(mean) * x, angle_b - angle_a};
        for (int k = 0; k < 3; ++k) out[0] += c->stiffness[k][j] * d[k] * d[k] / 2;
    }
}

/* Drifts of energy and momenta of an undamped chain over 1 s, relative to what moves. */
static void drifts(double accuracy, double drift[3])
{
    enum { SEGMENTS = 12 };
    Rig *const r = rig_new(SEGMENTS, accuracy, 1);
    Integrator *in = NULL;
    hawser_error err = {0};
    double before[4], after[4], mass = 0;
    balance_of(r, before);
    if (integrator_new(&r->planar.motion, 0, r->y, &in, &err)) fail_msg("%s", err.message);
    while (r->t < 1) {
        if (integrator_step(in, 1, &r->t, &err)) fail_msg("%s", err.message);
    }
    balance_of(r, after);
    for (int i = 0; i < SEGMENTS; ++i) mass += r->scene.chain.mass[i];
    const double push = sqrt(2 * before[0] * mass);
    drift[0] = fabs(after[0] / before[0] - 1);
    drift[1] = hypot(after[1] - before[1], after[2] - before[2]) / push;
    drift[2] = fabs(after[3] - before[3]) / (push * 0.5 * SEGMENTS);
    integrator_free(in);
    rig_free(r);
}

TEST(test_conservation)
{
    double first = 0;
    for (int k = 3; k <= 6; ++k) {
        double drift[3];
        drifts(pow(10, -k), drift);
        print_message("accuracy 1e-%d: energy %.2g, momentum %.2g, angular momentum %.2g\n", k, drift[0], drift[1],
                      drift[2]);
        check_below(drift[0], 60 * pow(10, -k));
        check_below(drift[1], 1e-14);
        check_below(drift[2], 0.1 * pow(10, -k));
        if (k == 3) first = drift[0];
        if (k == 6) check_below(drift[0] * 100, first);
    }
}

/* Long enough for every loop to be split: rates and a Newton solution have the same bits on two threads. */
TEST(test_long_chain_threads)
{
    enum { LONG = 1037 };
    double *result[2], *rate[2];
    for (int k = 0; k < 2; ++k) {
        Rig *const r = rig_new(LONG, 1e-3, k + 1);
        Motion *const m = &r->planar.motion;
        const size_t bytes = (size_t)m->size * sizeof(double);
        rate[k] = fixture_array(m->size, sizeof(double));
        result[k] = fixture_array(m->size, sizeof(double));
        assert_int_equal(m->ops->rates(m, 0, r->y, rate[k]), 0);
        m->ops->linearise(m, 0, r->y, rate[k]);
        m->ops->form(m, 3e-3);
        assert_int_equal(m->ops->factor(m), 0);
        memcpy(result[k], rate[k], bytes);
        assert_int_equal(m->ops->solve(m, result[k]), 0);
        if (k == 1) {
            assert_memory_equal(rate[0], rate[1], bytes);
            assert_memory_equal(result[0], result[1], bytes);
        }
        rig_free(r);
    }
    for (int k = 0; k < 2; ++k) {
        free(rate[k]);
        free(result[k]);
    }
}

/* Rows that are reduced and expanded as the solver comes to them have the bits of rows that are reduced, solved and
 * expanded one loop after the other, whatever the length leaves of the sides. */
TEST(test_rows_come_and_go)
{
    static const int lengths[] = {2, 7, 8, 9, 15, 16, 17, 24, 31, 32, 33, 1037};
    for (size_t k = 0; k < sizeof lengths / sizeof lengths[0]; ++k) {
        Rig *const r = rig_new(lengths[k], 1e-3, 1);
        Motion *const m = &r->planar.motion;
        PlanarNewton *const nw = &r->planar.newton;
        const PlanarSimKernels *const kernels = planar_sim_kernels();
        const size_t bytes = (size_t)m->size * sizeof(double);
        double *const b = fixture_array(m->size, sizeof(double)), *const x = fixture_array(m->size, sizeof(double));
        assert_int_equal(m->ops->rates(m, 0, r->y, b), 0);
        m->ops->linearise(m, 0, r->y, b);
        m->ops->form(m, 3e-3);
        assert_int_equal(m->ops->factor(m), 0);
        memcpy(x, b, bytes);
        kernels->eliminate(nw, x, 0, lengths[k]);
        kernels->couple(nw, x, 0, lengths[k]);
        assert_int_equal(linsolver_solve(nw->solver, nw->x), 0);
        kernels->expand(nw, x, 0, lengths[k]);
        for (int c = 0; c < 3; ++c) memset(nw->z[c], 0, (size_t)lengths[k] * sizeof(double));
        assert_int_equal(m->ops->solve(m, b), 0);
        assert_memory_equal(b, x, bytes);
        free(b);
        free(x);
        rig_free(r);
    }
}
