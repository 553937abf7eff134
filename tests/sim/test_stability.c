/* Equilibria that stop being stable: the loads at which they do, where the rods go then, and turns that are not lost.
 */
#include "sim/run/statics.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

/* EI = 100 N m2, 1 m, thin, hardly stretches: pinned at its tail, its head slides along the x axis. */
static RodFixture column(int n, double force, double push)
{
    RodFixture f = {.n = n, .length = 1, .steps = 10, .ea = 1e7, .ga = 1e7, .gj = 100, .ei_y = 100, .ei_z = 100};
    rod_hold(&f.rod.end[ROD_TAIL], 1);
    f.rod.end[ROD_HEAD].held[1] = f.rod.end[ROD_HEAD].held[2] = 1;
    f.rod.loads = fixture_array(2, sizeof *f.rod.loads);
    rod_load(&f.rod, 1, 0, 0, v3(-1, 0, 0), force);
    if (push > 0) rod_load(&f.rod, 0.5, 0, 0, v3(0, 0, 1), push);
    return f;
}

static void run(RodFixture f, StabilityChoice choice, Stage *stage)
{
    SceneDef def;
    rod_define(&def, &f);
    def.analysis.stability = choice;
    rod_stage(&def, stage);
    rod_solve(stage);
}

/* The error of the chain's Euler load against pi^2 EI/L^2. */
static double euler_error(int n)
{
    Stage stage;
    run(column(n, 2000, 0), STABILITY_REPORT, &stage);
    const Stability *const s = &stage.stability;
    assert_int_equal(s->n, 1);
    assert_int_equal(s->unstable, 2); /* a round section bends either way */
    assert_string_equal(s->critical[0].kind, "buckling");
    check_close(s->critical[0].at, 0.5, 0.51 / n);
    check_close(s->critical[0].direction[0], 0, 1e-6);
    check_close(v3_norm(rod_front(&stage, n / 2 - 1)), 0.5, 1e-3); /* it stays straight */
    const double error = 2000 * s->critical[0].t / (M_PI * M_PI * 100) - 1;
    stage_free(&stage);
    return error;
}

TEST(euler_loads_are_of_second_order)
{
    const double coarse = euler_error(10), middle = euler_error(20), fine = euler_error(40);
    check_close(fine, 0, 6e-4);
    check_close((coarse - middle) / (middle - fine), 4, 0.3);
}

/* At twice its load the column bends as the elastica says, 0.398 of its length, whatever makes it go to one side; with
 * nothing to say to which. At nine tenths it stays straight. */
TEST(columns_bend_into_the_elastica)
{
    const double push[4] = {0, 1e-9, 1e-3, 0.1};
    for (int k = 0; k < 4; ++k) {
        Stage stage;
        run(column(20, 2000, push[k]), STABILITY_FOLLOW, &stage);
        const Vec3 middle = rod_front(&stage, 9), head = rod_front(&stage, 19);
        check_close(hypot(middle.y, middle.z), 0.398, 0.002);
        if (push[k] > 1e-4) check_close(middle.z, 0.398, 0.002);
        check_close(hypot(head.y, head.z), 0, 1e-6); /* the head stays on its line */
        assert_int_equal(stage.stability.unstable, 0);
        assert_int_equal(stage.stability.n, push[k] < 1e-6);
        stage_free(&stage);
    }
    Stage stage;
    run(column(20, 900, 1e-3), STABILITY_FOLLOW, &stage);
    check_close(rod_front(&stage, 9).z, 0, 1e-5);
    assert_int_equal(stage.stability.unstable, 0);
    assert_int_equal(stage.stability.n, 0);
    stage_free(&stage);
}

/* Nothing holds a pinned rod about its axis; it is at rest all the same. */
TEST(stiff_columns_converge)
{
    Stage stage;
    run(column(40, 50, 0), STABILITY_FOLLOW, &stage);
    check_share(1 - rod_front(&stage, 39).x, 50 * (1 - 0.5 / 40) / 1e7, 1e-6);
    stage_free(&stage);
}

/* A follower makes a clamped column flutter at 20.05 EI/L^2 (Beck), which no pivot shows; nothing is followed then. */
TEST(followers_flutter)
{
    RodFixture f = {.n = 12, .length = 1, .steps = 4, .ea = 1e6, .ga = 1e6, .gj = 100, .ei_y = 100, .ei_z = 100};
    Stage stage;
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, 1, 0, 1, v3(-1, 0, 0), 2400);
    run(f, STABILITY_FOLLOW, &stage);
    assert_int_equal(stage.stability.n, 1);
    assert_string_equal(stage.stability.critical[0].kind, "flutter");
    check_share(2400 * stage.stability.critical[0].t, 2005, 0.04);
    check_above(stage.stability.unstable, 0);
    stage_free(&stage);
}

/* A flat arch clamped at both ends under a force at its crown snaps through to the other side. */
TEST(arches_snap_through)
{
    RodFixture f = {.n = 20, .length = 1, .steps = 10, .ea = 1e6, .ga = 1e6, .gj = 100, .ei_y = 10, .ei_z = 1e3};
    SceneDef def;
    Stage stage;
    for (int e = 0; e < 2; ++e) rod_hold(&f.rod.end[e], 0);
    f.rod.shape = ROD_ARC;
    f.rod.radius = 1.25;
    f.rod.plane = -M_PI / 2;
    f.rod.stress_free = 1;
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, 0.5, 0, 0, v3(0, 0, -1), 6000);
    rod_define(&def, &f);
    def.route_slope = 0.4;
    rod_stage(&def, &stage);
    rod_solve(&stage);
    check_above(stage.stability.n, 0);
    check_below(rod_front(&stage, 9).z, -0.02);
    assert_int_equal(stage.stability.unstable, 0);
    stage_free(&stage);
}

/* A clamped rod whose head is turned by `turns`, and the torque in its middle after `steps` load steps. */
static double torque_after(double turns, int steps, double damping, Stage *stage)
{
    RodFixture f = {.n = 25, .length = 1, .steps = steps, .gj = 1};
    SceneDef def;
    for (int e = 0; e < 2; ++e) rod_hold(&f.rod.end[e], 0);
    RodDef lent = {.loads = fixture_array(1, sizeof(RodLoadDef))};
    rod_load(&lent, 0, 0, 0, v3(1, 0, 0), 2 * M_PI * turns);
    f.rod.end[ROD_HEAD].n_motions = 1;
    f.rod.end[ROD_HEAD].motions = fixture_array(1, sizeof *f.rod.end[ROD_HEAD].motions);
    f.rod.end[ROD_HEAD].motions[0] = (RodMotionDef){.turns = 1, .by = lent.loads[0].by};
    free(lent.loads);
    rod_define(&def, &f);
    def.cables[0].damping = damping;
    rod_stage(&def, stage);
    rod_solve(stage);
    dynamics_look(&stage->scene, &stage->ws, 1, stage->y);
    bushing_kernels()->law(&stage->scene.chain, &stage->ws.kin, 0, 26, stage->ws.law);
    return stage->ws.law[3][12];
}

/* However many turns a load step makes, and whatever damps them. */
TEST(turns_are_counted)
{
    const double turns[4] = {10, 1, 300.0 / 360, -0.75};
    const int steps[4] = {10, 1, 1, 1};
    for (int k = 0; k < 4; ++k) {
        Stage stage;
        check_share(torque_after(turns[k], steps[k], k % 2 ? 2e-3 : 0, &stage), 2 * M_PI * turns[k], 1e-9);
        assert_int_equal(stage.stability.turned, 0);
        stage_free(&stage);
    }
}

/* Twelve turns over 25 segments turn a joint by more than 150 deg: said so. */
TEST(a_joint_takes_no_half_turn)
{
    Stage stage;
    torque_after(11.5, 5, 0, &stage);
    check_above(stage.stability.turned, 0);
    stage_free(&stage);
}

/* F (n 6) of a state: what the masses answer with. */
static void forces_of(Stage *stage, double *rate, double *out)
{
    const Chain *const c = &stage->scene.chain;
    dynamics_rates(&stage->scene, &stage->ws, 1, stage->y, 0, rate);
    for (int i = 0; i < c->n; ++i) {
        v3_put(out + 6 * i, v3_scale(c->mass[i], state_vec(rate, c->n, STATE_V, i)));
        v3_put(out + 6 * i + 3, body_inertia_times(c, &stage->ws.kin, i, state_vec(rate, c->n, STATE_W, i)));
    }
}

/* K of a rod whose head slides, in a state far from rest, against differences of the forces (RD22). */
TEST(blocks_of_a_slide)
{
    enum { N = 3 };
    RodFixture f = column(N, 100, 0);
    SceneDef def;
    Stage stage;
    rod_define(&def, &f);
    rod_stage(&def, &stage);
    double *const rate = fixture_array(STATE_SIZE * N, sizeof *rate), *const none = fixture_array(STATE_SIZE * N, 8);
    double plus[6 * N], minus[6 * N], largest = 0;
    uint64_t seed = 3;
    BlockChain *const k = &stage.newton.k;
    state_shake(stage.y, N, 1e-3, 0.6, 0, 0, &seed);
    const int i = N - 1;
    for (int c = 0; c < 6; ++c) {
        const double e = 1e-7;
        state_nudge(stage.y, N, i, c, e);
        forces_of(&stage, rate, plus);
        state_nudge(stage.y, N, i, c, -2 * e);
        forces_of(&stage, rate, minus);
        state_nudge(stage.y, N, i, c, e);
        dynamics_blocks(&stage.scene, &stage.ws, 1, stage.y, none, 0, k, &stage.newton.d);
        for (int r = 0; r < 6; ++r) {
            check_close(k->diag[36 * i + 6 * c + r], (plus[6 * i + r] - minus[6 * i + r]) / (2 * e), 200);
            largest = larger_of(largest, fabs(k->diag[36 * i + 6 * c + r]));
        }
    }
    check_above(largest, 3e7); /* N/m: of a segment of 1/3 m */
    free(rate);
    free(none);
    stage_free(&stage);
}
