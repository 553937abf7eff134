/* CVODE on the chain: what a free chain must conserve, free flight, unit quaternions, and failures that are told. */
#include "tests/support/rig.h"

enum { N = 12, SIZE = STATE_SIZE * N };

/* From a state that the test has changed. */
static hawser_status run_from(Rig *r, double to, hawser_error *err)
{
    rig_refresh(r);
    return rig_run(r, to, err);
}

static Rig *free_chain(double accuracy, int max_order)
{
    SceneDef def;
    fixture_free_chain(&def, N);
    def.solver.accuracy = accuracy;
    def.solver.max_order = max_order;
    def.solver.method = METHOD_BDF;
    return rig_make(&def, NULL);
}

/* What undamped motion without loads conserves. */
typedef struct Balance {
    double energy; /* J, kinetic and of the bushings */
    Vec3 p, l;     /* kg m/s, kg m2/s about the origin */
} Balance;

static Balance balance_of(Rig *r)
{
    const Chain *const c = &r->scene.chain;
    Balance b = {0};
    dynamics_kinematics(&r->scene, &r->ws, r->t, r->y);
    for (int i = 0; i < N; ++i) {
        const Vec3 v = state_vec(r->y, N, STATE_V, i), w = state_vec(r->y, N, STATE_W, i);
        const Vec3 spin = body_inertia_times(c, &r->ws.kin, i, w), push = v3_scale(c->mass[i], v);
        b.energy += (v3_dot(v, push) + v3_dot(w, spin)) / 2;
        b.p = v3_add(b.p, push);
        b.l = v3_add(b.l, v3_add(spin, v3_cross(state_vec(r->y, N, STATE_P, i), push)));
    }
    bushing_kernels()->law(c, &r->ws.kin, 0, N + 1, r->ws.law);
    for (int j = 1; j < N; ++j) {
        for (int k = 0; k < 6; ++k) b.energy += r->ws.law[k][j] * r->ws.law[k][j] / (2 * c->stiffness[k][j]);
    }
    return b;
}

/* Drifts over 1 s of a bent chain with random velocities: energy relative; momenta over the size of their sums. */
static void drifts(double accuracy, int max_order, double drift[3])
{
    Rig *r = free_chain(accuracy, max_order);
    uint64_t seed = 21;
    hawser_error err = {0};
    state_shake(r->y, N, 0.01, 0.1, 0.3, 0.5, &seed);
    const Balance before = balance_of(r);
    if (run_from(r, 1, &err)) fail_msg("%s", err.message);
    const Balance after = balance_of(r);
    double mass = 0;
    for (int i = 0; i < N; ++i) mass += r->scene.chain.mass[i];
    const double speed = sqrt(2 * before.energy / mass);
    drift[0] = fabs(after.energy / before.energy - 1);
    drift[1] = v3_norm(v3_sub(after.p, before.p)) / (mass * speed);
    drift[2] = v3_norm(v3_sub(after.l, before.l)) / (mass * speed * 0.5 * N);
    rig_free(r);
}

/* Three decades of accuracy: the drifts are of the tolerance's size and fall with it: energy to less than limit times
 * accuracy, all of them over the three decades by `ratio` (what is rounding already stays). */
static void check_drifts(int max_order, double limit, double ratio)
{
    double drift[4][3];
    for (int k = 0; k < 4; ++k) {
        const double accuracy = pow(10, -3 - k);
        drifts(accuracy, max_order, drift[k]);
        print_message("order %d, accuracy %.0e: energy %.2g, momentum %.2g, angular momentum %.2g\n", max_order,
                      accuracy, drift[k][0], drift[k][1], drift[k][2]);
        check_below(drift[k][0], limit * accuracy);
        check_below(drift[k][1], 1e-14);
        check_below(drift[k][2], 0.1 * accuracy);
    }
    check_below(drift[3][0] * ratio, drift[0][0]);
    check_below(drift[3][2] * ratio, drift[0][2]);
}

TEST(test_drift_order_2) { check_drifts(2, 60, 100); }

/* Higher orders take longer steps near the edge of their stability. */
TEST(test_drift_order_5) { check_drifts(5, 600, 50); }

/* A straight chain that flies evenly and turns about its own axis moves as one body. */
TEST(test_free_flight)
{
    Rig *r = free_chain(1e-4, 2);
    double start[SIZE];
    const Vec3 v = v3(3, -2, 1), w = v3(0.8, 0, 0);
    hawser_error err = {0};
    for (int i = 0; i < N; ++i) {
        state_set_vec(r->y, N, STATE_V, i, v);
        state_set_vec(r->y, N, STATE_W, i, w);
    }
    memcpy(start, r->y, sizeof start);
    if (run_from(r, 1, &err)) fail_msg("%s", err.message);
    double off = 0, turned = 0, speed = 0;
    for (int i = 0; i < N; ++i) {
        const Vec3 p = v3_add(state_vec(start, N, STATE_P, i), v3_scale(r->t, v));
        const Quat q = quat_mul(quat_exp(v3_scale(r->t, w)), state_quat(start, N, i));
        const Quat error = quat_mul(state_quat(r->y, N, i), quat_conj(q));
        off = larger_of(off, v3_norm(v3_sub(state_vec(r->y, N, STATE_P, i), p)));
        turned = larger_of(turned, 2 * v3_norm(v3(error.x, error.y, error.z)));
        speed = larger_of(speed, v3_norm(v3_sub(state_vec(r->y, N, STATE_V, i), v)));
        speed = larger_of(speed, v3_norm(v3_sub(state_vec(r->y, N, STATE_W, i), w)));
    }
    print_message("off by %.2g m, turned too far by %.2g rad, speeds wrong by %.2g\n", off, turned, speed);
    check_close(r->t, 1, 1e-15);
    check_below(off, 1e-12);
    check_below(speed, 1e-12);
    check_below(turned, 30 * 1e-4 * 0.1); /* accuracy times the scale of rotations */
    rig_free(r);
}

/* After every single step. */
TEST(test_unit_quaternions)
{
    Rig *r = free_chain(1e-3, 2);
    uint64_t seed = 5;
    double worst = 0;
    hawser_error err = {0};
    state_shake(r->y, N, 0.01, 0.2, 0.5, 3, &seed);
    assert_int_equal(integrator_new(rig_motion(r), 0, r->y, &r->integrator, &err), HAWSER_OK);
    int steps = 0;
    for (; r->t < 1; ++steps) {
        assert_int_equal(integrator_step(r->integrator, 1, &r->t, &err), HAWSER_OK);
        for (int i = 0; i < N; ++i) {
            const Quat q = state_quat(r->y, N, i);
            worst = larger_of(worst, fabs(sqrt(q.w * q.w + q.x * q.x + q.y * q.y + q.z * q.z) - 1));
        }
    }
    print_message("%d steps, lengths off by at most %.2g\n", steps, worst);
    check_above(steps, 20);
    check_below(worst, 1e-12);
    IntegratorStats stats;
    integrator_stats(r->integrator, &stats);
    assert_int_equal(stats.steps, steps);
    check_at_least(stats.rhs_evals, stats.steps);
    check_at_least(stats.jac_evals, 1);
    check_at_least(stats.lin_setups, stats.jac_evals);
    rig_free(r);
}

/* A tail tension that becomes infinite after 0.5 s: told with time, place and advice; the last good state is kept. */
TEST(test_failure_is_told)
{
    double time[] = {0, 0.5, 0.6}, tension[] = {0, 0, INFINITY};
    SceneDef def;
    fixture_free_chain(&def, N);
    def.solver.method = METHOD_BDF; /* which does not look at 0.5 s itself, where nothing times infinity is asked for */
    Rig *r = rig_make(&def, NULL);
    r->scene.tail = (Profile){.kind = PROFILE_TABLE, .n = 3, .time = time, .value = tension};
    for (int i = 0; i < N; ++i) state_set_vec(r->y, N, STATE_V, i, v3(1, 0, 0));
    hawser_error err = {0};
    double good[SIZE];
    assert_int_equal(run_from(r, 0.5, &err), HAWSER_OK);
    memcpy(good, r->y, sizeof good);
    assert_int_equal(run_from(r, 1, &err), HAWSER_ERR_RUN);
    print_message("%s\n", err.message);
    assert_int_equal(err.status, HAWSER_ERR_RUN);
    check_has(err.message, "t = 0.5 s");
    check_has(err.message, "at segment ");
    check_has(err.message, "infinite");
    check_close(r->t, 0.5, 1e-15);
    assert_memory_equal(good, r->y, sizeof good);
    rig_free(r);
}

/* A chain that falls on a roller so stiff that the steps shrink to nothing. */
static Rig *falling_chain(long max_steps)
{
    SceneDef def;
    fixture_free_chain(&def, N);
    def.gravity = v3(0, 0, -10);
    def.impact = (ImpactLaw){.k = 1e308, .e = 1, .c = 1e308, .d = 1e-9};
    def.n_rollers = 1;
    def.rollers = fixture_array(1, sizeof *def.rollers);
    def.rollers[0] = (RollerDef){.centre = v3(4.1, 0, -0.35),
                                 .axis = v3(0, 1, 0),
                                 .radius = 0.1,
                                 .width = 1,
                                 .s = NAN,
                                 .friction = def.friction};
    def.solver.max_steps = max_steps;
    return rig_make(&def, NULL);
}

/* The run ends between two times (s) with a message and a finite state. */
static void check_fall(long max_steps, double after, double before, const char *says)
{
    Rig *r = falling_chain(max_steps);
    hawser_error err = {0};
    const hawser_status status = run_from(r, 1, &err);
    print_message("%s\n", err.message);
    assert_int_equal(status, HAWSER_ERR_RUN);
    check_has(err.message, says);
    check_has(err.message, "segment ");
    check_between(r->t, after, before);
    for (int k = 0; k < SIZE; ++k) check_finite(r->y[k]);
    rig_free(r);
}

TEST(test_stall_is_told)
{
    check_fall(0, 0.12, 0.16, "try a softer contact.k"); /* 0.1 m of fall: sqrt(2 0.1 / 10) = 0.141 s */
}

TEST(test_max_steps) { check_fall(20, 0, 0.16, "solver.max_steps = 20"); }

/* Newton's iterations a step while a bent chain is let go. */
static double iterations(double accuracy)
{
    Rig *r = free_chain(accuracy, 2);
    uint64_t seed = 21;
    hawser_error err = {0};
    IntegratorStats stats;
    state_shake(r->y, N, 0.01, 0.1, 0.3, 0.5, &seed);
    if (run_from(r, 0.2, &err)) fail_msg("%s", err.message);
    integrator_stats(r->integrator, &stats);
    check_at_least(stats.factor, 0); /* times add up */
    check_at_least(stats.solve, 0);
    rig_free(r);
    print_message("accuracy %.0e: %.2f iterations a step\n", accuracy,
                  (double)stats.newton_iters / (double)stats.steps);
    return (double)stats.newton_iters / (double)stats.steps;
}

/* What Newton's iteration leaves does not shrink with the tolerance (N13): with a thousandth of it throughout the three
 * would take 1.44, 1.25 and 1.25 where they take 1.23, 1.10 and 1.07. */
TEST(test_newton_share)
{
    check_below(iterations(1e-4), 1.33);
    check_below(iterations(1e-5), 1.17);
    check_below(iterations(1e-6), 1.15);
}
