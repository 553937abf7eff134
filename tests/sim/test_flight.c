/* A medium's forces and their derivatives, how a launch sets a chain moving, what a section's gyration does. */
#include "core/body.h"
#include "sim/run/sim.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

/* A free helix in a current of water. */
static RodFixture helix(void)
{
    RodFixture f = {.n = 9, .length = 4.5, .steps = 1, .gravity = {0, 0, -9.81}};
    f.rod.shape = ROD_HELIX;
    f.rod.radius = 1;
    f.rod.pitch = -0.4;
    f.rod.stress_free = 1;
    return f;
}

static const MediumDef STREAM = {
    .density = 1000, .velocity = {0.4, -0.7, 0.2}, .normal = 1.2, .tangential = 0.05, .buoyancy = 1};

/* What the medium does to segment i. */
static void forces_on(Scene *scene, const double *y, int i, Workspace *ws, double out[6])
{
    const int n = scene->chain.n;
    body_kernels()->kinematics(n, y, 0, n, &ws->kin);
    for (int part = 0; part < PARTS; ++part) loads_zero(&ws->loads[part], n);
    room_loads(&MEDIUM_ROOM, scene, ws, 0, 1);
    for (int c = 0; c < 3; ++c) {
        out[c] = ws->loads[0].f[c][i] + ws->loads[1].f[c][i];
        out[3 + c] = ws->loads[0].m[c][i] + ws->loads[1].m[c][i];
    }
}

/* (MD4) to (MD6): every column of every segment's blocks. */
TEST(blocks_against_differences)
{
    static const double E = 1e-6;
    RodFixture f = helix();
    SceneDef def;
    Scene scene;
    Workspace ws;
    BlockChain block[2];
    rod_define(&def, &f);
    def.medium = STREAM;
    fixture_build(&def, &scene);
    const int n = scene.chain.n;
    assert_true(workspace_alloc(&ws, &scene, NULL));
    for (int b = 0; b < 2; ++b) assert_true(block_chain_alloc(&block[b], n, 6));
    double *const y = fixture_array(STATE_SIZE * n, sizeof *y), largest[2] = {0, 0};
    uint64_t seed = 5;
    scene_initial_state(&scene, y);
    state_shake(y, n, 0.1, 0.8, 1.5, 2, &seed);
    body_kernels()->kinematics(n, y, 0, n, &ws.kin);
    room_blocks(&MEDIUM_ROOM, &scene, &ws, 0, 1, &block[0], &block[1]);
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 12; ++c) {
            const int b = c / 6;
            double plus[6], minus[6];
            state_nudge(y, n, i, c, E);
            forces_on(&scene, y, i, &ws, plus);
            state_nudge(y, n, i, c, -2 * E);
            forces_on(&scene, y, i, &ws, minus);
            state_nudge(y, n, i, c, E);
            for (int r = 0; r < 6; ++r) {
                const double found = block[b].diag[36 * i + 6 * (c % 6) + r];
                check_close(found, (plus[r] - minus[r]) / (2 * E), 2e-6);
                largest[b] = larger_of(largest[b], fabs(found));
            }
        }
    }
    for (int b = 0; b < 2; ++b) check_above(largest[b], 5);
    free(y);
    for (int b = 0; b < 2; ++b) block_chain_free(&block[b]);
    workspace_free(&ws);
    scene_clear(&scene);
}

/* (MD1), (MD3): a straight segment that slides along itself, one that moves across, one that rests in the stream's own
 * frame. */
TEST(drag_is_that_of_its_law)
{
    RodFixture f = {.n = 4, .length = 2, .steps = 1, .gravity = {0, 0, -9.81}};
    SceneDef def;
    Scene scene;
    Workspace ws;
    rod_define(&def, &f);
    def.medium = STREAM;
    fixture_build(&def, &scene);
    assert_true(workspace_alloc(&ws, &scene, NULL));
    double y[STATE_SIZE * 4], force[6];
    const double d = 2 * scene.chain.radius[0], h = 2 * scene.chain.half[0], half_rho = STREAM.density / 2;
    const Vec3 through[3] = {{2, 0, 0}, {0, 3, 0}, {0, 0, 0}};
    const double drag[3] = {-half_rho * M_PI * d * STREAM.tangential * h * 4, -half_rho * d * STREAM.normal * h * 9, 0};
    scene_initial_state(&scene, y);
    for (int k = 0; k < 3; ++k) {
        const Vec3 v = v3_add(through[k], STREAM.velocity);
        y[STATE_V * 4] = v.x;
        y[(STATE_V + 1) * 4] = v.y;
        y[(STATE_V + 2) * 4] = v.z;
        forces_on(&scene, y, 0, &ws, force);
        check_close(force[k % 3], k == 2 ? STREAM.density * M_PI * d * d / 4 * h * 9.81 : drag[k], 1e-9);
        for (int c = 3; c < 6; ++c) check_close(force[c], 0, 1e-12);
    }
    workspace_free(&ws);
    scene_clear(&scene);
}

/* The distance between neighbours' ends, and its rate. */
static void joint_rates(const Scene *scene, const double *y, int j, Vec3 rate[2])
{
    const int n = scene->chain.n;
    for (int side = 0; side < 2; ++side) {
        const int i = j - 1 + side;
        const double half = (side ? -1 : 1) * scene->chain.half[i];
        const Vec3 arm = v3_scale(half, quat_rotate(state_quat(y, n, i), v3(1, 0, 0)));
        rate[side] = v3_add(state_vec(y, n, STATE_V, i), v3_cross(state_vec(y, n, STATE_W, i), arm));
    }
}

/* (MD7), (MD8): joints stay closed, a rigid body is one, a ring that runs along itself turns about its centre. */
TEST(launches_keep_joints_closed)
{
    RodFixture f = {.n = 12, .length = 6, .steps = 1};
    f.rod.shape = ROD_ARC;
    f.rod.radius = 2;
    f.rod.plane = M_PI / 2;
    SceneDef def;
    Scene scene;
    rod_define(&def, &f);
    def.launch = (LaunchDef){.present = 1,
                             .along = 0.5,
                             .velocity = {1, 2, 3},
                             .spin = {0.3, -0.2, 0.5},
                             .n_rows = 2,
                             .row = fixture_array(2, sizeof *def.launch.row)};
    def.launch.row[0] = (LaunchRow){.at = 1};
    def.launch.row[1] = (LaunchRow){.at = 4, .along = 0.5};
    fixture_build(&def, &scene);
    const int n = scene.chain.n;
    double *const y = fixture_array(STATE_SIZE * n, sizeof *y);
    scene_initial_state(&scene, y);
    Vec3 rate[2];
    for (int j = 1; j < n; ++j) {
        joint_rates(&scene, y, j, rate);
        check_close(v3_norm(v3_sub(rate[1], rate[0])), 0, 0.5 * 0.5 / 3 + 0.01); /* a segment's stretch by the table */
    }
    LaunchDef *const launch = &scene.def.launch;
    launch->n_rows = 0;
    scene_launch(&scene, y);
    for (int j = 2; j < n - 1; ++j) {
        joint_rates(&scene, y, j, rate);
        check_close(v3_norm(v3_sub(rate[1], rate[0])), 0, 1e-12);
    }
    launch->velocity = launch->spin = V3_ZERO;
    scene_launch(&scene, y);
    for (int i = 1; i < n - 1; ++i) check_close(v3_norm(state_vec(y, n, STATE_W, i)), 0.5 / 2, 1e-12);
    free(y);
    scene_clear(&scene);
}

/* A launch outlives the relaxation, and comes once. */
TEST(relaxation_does_not_take_it)
{
    RodFixture f = {.n = 6, .length = 3, .steps = 1, .gravity = {0, 0, -9.81}};
    SceneDef def;
    Sim *sim;
    hawser_error err = {0};
    hawser_relaxation relaxation = {0};
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    rod_hold(&f.rod.end[ROD_HEAD], 0);
    rod_define(&def, &f);
    def.analysis.kind = ANALYSIS_DYNAMICS;
    def.launch = (LaunchDef){.present = 1, .velocity = {0, 0.25, 0}};
    assert_int_equal(sim_new(&def, 1, &sim, &err), HAWSER_OK);
    assert_int_equal(sim_relax(sim, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    for (int i = 0; i < 6; ++i) check_close(state_vec(sim->stage.y, 6, STATE_V, i).y, 0.25, 1e-15);
    if (sim_advance(sim, 0.01, 0, &err)) fail_msg("%s", err.message);
    scene_def_clear(&def);
    sim_free(sim);
}

/* A shaft that is held at one end twists to and fro in 4 L sqrt(2 m k^2/GJ) (S5). */
TEST(gyration_slows_torsion)
{
    for (double gyration = 0; gyration < 0.05; gyration += 0.04) {
        RodFixture f = {.n = 40, .length = 4, .steps = 1};
        SceneDef def;
        Stage stage;
        Modes modes;
        hawser_error err = {0};
        rod_hold(&f.rod.end[ROD_TAIL], 0);
        for (int c = 0; c < 6; ++c) f.rod.end[ROD_HEAD].held[c] = c != 3;
        rod_define(&def, &f);
        def.cables[0].gj = 0.01; /* softer than anything else */
        def.cables[0].gyration = gyration;
        const double k = gyration > 0 ? gyration : def.cables[0].diameter / 4, mass = def.cables[0].mass;
        rod_stage(&def, &stage);
        assert_int_equal(modes_find(&stage, 1, 0, &modes, &err), HAWSER_OK);
        check_close(modes.out[0].frequency_Hz * 16 * sqrt(2 * mass * k * k / 0.01), 1, 1e-3);
        modes_free(&modes);
        stage_free(&stage);
    }
}
