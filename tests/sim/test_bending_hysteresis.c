/* Cables with a table of bending in whole scenes: the area of a cantilever's loop in a dynamic run, what a free chain
 * may lose and must keep, the start from a relaxed bend, threads. The law at one joint: tests/core/test_sliders.c. */
#include "sim/equipment/winch.h"
#include "sim/run/sim.h"
#include "sim/solve/relax.h"
#include "tests/support/rig.h"

static void rig_step(Rig *r, double stop)
{
    hawser_error err = {0};
    if (!r->integrator && integrator_new(rig_motion(r), r->t, r->y, &r->integrator, &err)) fail_msg("%s", err.message);
    if (integrator_step(r->integrator, stop, &r->t, &err)) fail_msg("%s", err.message);
}

/* Wrenches of now into ws.joints. */
static void rig_evaluate(Rig *r) { dynamics_rates(&r->scene, &r->ws, r->t, r->y, 1, r->rate); }

/* ------------------------------------------------------------------------------------------- the cantilever */

/* 4 m, 20 kg/m; 12 kN m2 to 1/500 m, then 4 and at last 1.2 kN m2: bent to about 1/100 m it turns by hundredths of a
 * radian, so that moments are statically determinate. */
enum { CANTILEVER = 8 };
static const double QUARTER = 20, THROW = 0.05; /* s, m */

static CableDef tabled_cable(void)
{
    CableDef c = fixture_cable(1, 20, 0.08);
    c.ei_y = c.ei_z = 12e3;
    c.damping = 1e-3;
    c.bending = (BendingTable){.rows = 3, .curvature = {0.002, 0.004, 0.006}, .moment = {24, 32, 34.4}};
    return c;
}

/* The winch clamps the head of a straight cable and moves it across to and fro, THROW to either side in triangles of
 * speed; the tail is held across at its place. Weightless. */
static Rig *cantilever_new(void)
{
    enum { CORNERS = 11 };
    static const double at[CORNERS] = {0, 0.5, 1, 2, 3, 4, 5, 6, 7, 8, 9},
                        up[CORNERS] = {0, 1, 0, -1, 0, 1, 0, -1, 0, 1};
    SceneDef def;
    fixture_free_chain(&def, CANTILEVER);
    def.cables[0] = tabled_cable();
    def.winch = (WinchDef){.present = 1};
    Profile *const speed = &def.winch.speed;
    assert_true(profile_table(speed, CORNERS));
    for (int k = 0; k < CORNERS; ++k) {
        speed->time[k] = at[k] * QUARTER;
        speed->value[k] = up[k] * 2 * THROW / QUARTER;
    }
    def.solver.accuracy = 1e-4;
    def.solver.max_step = 0.1;
    Rig *const r = rig_make(&def, NULL);
    r->scene.winch->direction = v3(0, 0, 1);
    for (int c = 1; c < 3; ++c) {
        r->scene.chain.stiffness[c][0] = 1e6;
        r->scene.chain.damping[c][0] = 1e3;
    }
    return r;
}

/* Energy that sliders take in a cycle at the joints when the force at the tail swings between -force and force: the
 * moment grows along the cable from the tail, the rotation by the first loading, then (HY8b). */
static double loops_expected(const Rig *r, double force)
{
    const Chain *const c = &r->scene.chain;
    double sum = 0;
    for (int j = 1; j <= c->n; ++j) {
        const double moment = force * 0.5 * j;
        double top = 0, reached = 0; /* rotation, and the moment there */
        double slope = c->stiffness[4][j];
        for (int s = 0; s < c->sliders.count; ++s) slope += c->sliders.stiffness[s][j];
        for (int s = 0; s < c->sliders.count; ++s) {
            const double next = reached + slope * (c->sliders.limit[s][j] - top);
            if (next >= moment) break;
            reached = next;
            top = c->sliders.limit[s][j];
            slope -= c->sliders.stiffness[s][j];
        }
        top += (moment - reached) / slope;
        for (int s = 0; s < c->sliders.count; ++s) {
            const double limit = c->sliders.limit[s][j];
            sum += 4 * c->sliders.stiffness[s][j] * limit * fmax(0, top - limit);
        }
    }
    return sum;
}

/* Integrates to `to` and returns the winch's work, J; *force gets the largest force across at the tail, N. */
static double work_until(Rig *r, double to, double *force)
{
    double work = 0, power = 0, t = r->t;
    const int n = r->scene.chain.n;
    *force = 0;
    while (r->t < to) {
        double corner = to;
        profile_next_corner(&r->scene.winch->speed, r->t + 1e-9, &corner);
        rig_step(r, fmin(corner, to));
        rig_evaluate(r);
        const double now = r->ws.joints.force[2][n] * profile_value(&r->scene.winch->speed, r->t);
        work += (now + power) / 2 * (r->t - t);
        power = now;
        t = r->t;
        *force = larger_of(*force, fabs(r->ws.joints.force[2][0]));
    }
    return work;
}

/* Cycles that are all alike, each with the closed form's area within 1 % (measured: 0.2 %, which is the inertia). */
TEST(test_hysteretic_bending_loop_area)
{
    Rig *r = cantilever_new();
    double force[3], work[3];
    for (int cycle = 0; cycle < 3; ++cycle) work[cycle] = work_until(r, (1 + 4 * cycle) * QUARTER, &force[cycle]);
    check_share(work[1], loops_expected(r, force[1]), 0.01);
    check_share(work[2], loops_expected(r, force[2]), 0.01);
    check_share(work[2], work[1], 2e-4);
    check_share(force[2], force[1], 1e-3); /* no drift */
    rig_free(r);
}

/* ---------------------------------------------------------------------------------------------- a free chain */

/* Energy and momenta of a chain that nothing touches. */
typedef struct Balance {
    double energy; /* J, kinetic and of all springs */
    Vec3 p, l;     /* kg m/s, kg m2/s about the origin */
} Balance;

/* The rotation vector of joint j (B2). */
static Vec3 joint_rotation(const Rig *r, int j)
{
    const Quat q = quat_mul(quat_conj(kinematics_quat(&r->ws.kin, j - 1)), kinematics_quat(&r->ws.kin, j));
    const Vec3 v = v3_scale(q.w < 0 ? -1 : 1, v3(q.x, q.y, q.z));
    const double size = v3_norm(v);
    return size > 0 ? v3_scale(2 * atan2(size, fabs(q.w)) / size, v) : v;
}

static double joint_energy(const Rig *r, int j)
{
    const Chain *const c = &r->scene.chain;
    const Vec3 theta = joint_rotation(r, j);
    double sum = (c->stiffness[4][j] * theta.y * theta.y + c->stiffness[5][j] * theta.z * theta.z) / 2;
    for (int k = 0; k < 4; ++k) sum += r->ws.law[k][j] * r->ws.law[k][j] / (2 * c->stiffness[k][j]);
    for (int s = 0; s < c->sliders.count; ++s) {
        const double y = theta.y - r->ws.kin.slip[2 * s][j], z = theta.z - r->ws.kin.slip[2 * s + 1][j];
        sum += c->sliders.stiffness[s][j] * (y * y + z * z) / 2;
    }
    return sum;
}

static Balance balance_of(Rig *r)
{
    const Chain *const c = &r->scene.chain;
    const int n = c->n;
    Balance b = {0};
    dynamics_kinematics(&r->scene, &r->ws, r->t, r->y);
    bushing_kernels()->law(c, &r->ws.kin, 0, n + 1, r->ws.law);
    for (int i = 0; i < n; ++i) {
        const Vec3 v = state_vec(r->y, n, STATE_V, i), w = state_vec(r->y, n, STATE_W, i);
        const Vec3 spin = body_inertia_times(c, &r->ws.kin, i, w), push = v3_scale(c->mass[i], v);
        b.energy += (v3_dot(v, push) + v3_dot(w, spin)) / 2;
        b.p = v3_add(b.p, push);
        b.l = v3_add(b.l, v3_add(spin, v3_cross(state_vec(r->y, n, STATE_P, i), push)));
        if (i > 0) b.energy += joint_energy(r, i);
    }
    return b;
}

/* Shaken in three dimensions, undamped but for the sliders: from step to step the energy falls or stays, the momenta
 * stay. */
TEST(test_free_chain)
{
    SceneDef def;
    hawser_error err = {0};
    uint64_t seed = 21;
    fixture_free_chain(&def, 12);
    def.cables[0].ei_y = def.cables[0].ei_z = 40;
    def.cables[0].bending = (BendingTable){.rows = 3, .curvature = {0.05, 0.1, 0.2}, .moment = {2, 3, 3.5}};
    def.solver.accuracy = 1e-6;
    Rig *r = rig_make(&def, NULL);
    state_shake(r->y, 12, 0.005, 0.05, 0.3, 0.5, &seed);
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0, r->y, 1, &err), HAWSER_OK);
    dynamics_accept(&r->scene, &r->ws, 0, r->y);
    const Balance first = balance_of(r);
    Balance before = first;
    while (r->t < 1) {
        rig_step(r, 1);
        const Balance now = balance_of(r);
        check_below(now.energy - before.energy, 1e-6 * first.energy);
        before = now;
    }
    check_below(before.energy, 0.8 * first.energy);
    check_vec(before.p, first.p, 1e-12 * v3_norm(first.p));
    check_vec(before.l, first.l, 1e-5 * v3_norm(first.l));
    rig_free(r);
}

/* -------------------------------------------------------------------------------------------------- a pull */

/* The fixture's pull, whose bend of 10 m takes the cable beyond its first corner. */
static void tabled_pull(SceneDef *def)
{
    fixture_pull(def, &(FixtureChoice){0});
    def->cables[0].ei_y = def->cables[0].ei_z = 1e4;
    def->cables[0].bending = (BendingTable){.rows = 3, .curvature = {0.03, 0.06, 0.2}, .moment = {300, 400, 540}};
}

/* The relaxation bends for the first time: it is reached, nothing has slipped, and when the first steps begin the
 * sliders take over without a jump. */
TEST(test_relaxed_start)
{
    SceneDef def;
    hawser_error err = {0};
    hawser_relaxation relaxation;
    tabled_pull(&def);
    Rig *r = rig_make(&def, NULL);
    const int n = r->scene.chain.n;
    assert_int_equal(dynamics_refresh(&r->scene, &r->ws, 0, r->y, 1, &err), HAWSER_OK);
    assert_int_equal(relax_to_equilibrium(&r->scene, &r->ws, &r->newton, 0, r->y, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    double slipped = 0, jump = 0, largest = 0;
    double *const before = fixture_array(STATE_SIZE * n, sizeof *before);
    for (int j = 0; j <= n; ++j) slipped = larger_of(slipped, fabs(r->ws.kin.slip[1][j]));
    check_at_most(slipped, 0);
    rig_evaluate(r);
    memcpy(before, r->rate, (size_t)(STATE_SIZE * n) * sizeof *before);
    dynamics_accept(&r->scene, &r->ws, 0, r->y);
    rig_evaluate(r);
    for (int k = 0; k < STATE_SIZE * n; ++k) {
        jump = larger_of(jump, fabs(r->rate[k] - before[k]));
        largest = larger_of(largest, r->scene.chain.sliders.stiffness[0][1] / r->scene.chain.inertia[2][0]);
    }
    for (int j = 0; j <= n; ++j) slipped = larger_of(slipped, fabs(r->ws.kin.slip[1][j]));
    check_above(slipped, 1e-3);
    check_below(jump, 1e-14 * largest);
    free(before);
    rig_free(r);
}

/* Where two segments of unlike cables meet, and at the clamp: stiffness at first loading is the springs' in series. */
TEST(test_stiffness_of_joints)
{
    SceneDef def;
    tabled_pull(&def);
    Rig *r = rig_make(&def, NULL);
    const Chain *const c = &r->scene.chain;
    assert_int_equal(c->sliders.count, 2);
    const int eye = FIXTURE_CABLE, n = c->n;
    const double rope = 500 * sqrt(1.2) / 0.25, cable = 1e4 / 0.25; /* half-springs, N m/rad */
    const int joint[] = {3, eye, n - 1, n};
    const double elastic[] = {cable / 20, cable / 10 * rope / (cable / 10 + rope), rope / 2, rope};
    const double first[] = {cable / 2, cable * rope / (cable + rope), rope / 2, rope};
    for (int k = 0; k < 4; ++k) {
        const int j = joint[k];
        double sum = c->stiffness[4][j];
        if (k > 1) sum = sqrt(c->stiffness[4][j] * c->stiffness[5][j]); /* the rope alone keeps its own two */
        check_share(sum, elastic[k], 1e-12);
        for (int s = 0; s < 2; ++s) sum += c->sliders.stiffness[s][j];
        check_share(sum, first[k], 1e-12);
    }
    rig_free(r);
}

/* The same bits with one thread and with two. */
TEST(test_threads)
{
    Sim *sim[2];
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        hawser_error err = {0};
        tabled_pull(&def);
        sim[k] = sim_made(&def, 1 + k);
        if (sim_relax(sim[k], NULL, &err) || sim_advance(sim[k], 1, 0, &err)) fail_msg("%s", err.message);
    }
    const hawser_sample *const a = hawser_sim_sample(sim[0]), *const b = hawser_sim_sample(sim[1]);
    check_above(a->winch_force, 0);
    assert_memory_equal(a->position, b->position, 3 * FIXTURE_SEGMENTS * sizeof(double));
    assert_memory_equal(a->tension, b->tension, FIXTURE_SEGMENTS * sizeof(double));
    sim_free(sim[0]);
    sim_free(sim[1]);
}
