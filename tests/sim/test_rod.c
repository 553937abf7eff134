/* Rods: their shapes, ground bodies, loads and masses, each against what it stands for. */
#include "def/rod_def.h"
#include "sim/equipment/rod.h"
#include "sim/run/sim.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

/* A helix with loads of every kind, turned and shifted by a state that is shaken. */
static RodFixture loaded_helix(void)
{
    RodFixture f = {.n = 9, .length = 4.5, .steps = 1, .gravity = {0, 0, -9.81}};
    f.rod.shape = ROD_HELIX;
    f.rod.radius = 1;
    f.rod.pitch = -0.4;
    f.rod.roll_rate = 0.3;
    f.rod.stress_free = 1;
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    f.rod.loads = fixture_array(4, sizeof *f.rod.loads);
    rod_load(&f.rod, 4.5, 0, 0, v3(1, 2, -1), 300);
    rod_load(&f.rod, 1.2, 0, 1, v3(0, 2, -1), 200);
    rod_load(&f.rod, 3.1, 1, 0, v3(1, 0, -1), 50);
    rod_load(&f.rod, 0, 1, 1, v3(1, -3, 1), 40);
    return f;
}

/* What the loads of t = 0.7 s do to segment i, force and moment. */
static void loads_on(Scene *scene, const double *y, int i, Workspace *ws, double out[6])
{
    const int n = scene->chain.n;
    const Loads *const loads = &ws->loads[0];
    body_kernels()->kinematics(n, y, 0, n, &ws->kin);
    loads_zero(&ws->loads[0], n);
    room_loads(&ROD_ROOM, scene, ws, 0.7, 1);
    for (int c = 0; c < 3; ++c) {
        out[c] = loads->f[c][i];
        out[3 + c] = loads->m[c][i];
    }
}

TEST(load_blocks_against_differences)
{
    RodFixture f = loaded_helix();
    SceneDef def;
    Scene scene;
    Workspace ws;
    BlockChain k, d;
    rod_define(&def, &f);
    fixture_build(&def, &scene);
    const int n = scene.chain.n;
    assert_true(workspace_alloc(&ws, &scene, NULL) && block_chain_alloc(&k, n, 6) && block_chain_alloc(&d, n, 6));
    double *const y = fixture_array(STATE_SIZE * n, sizeof *y);
    scene_initial_state(&scene, y);
    uint64_t seed = 5;
    state_shake(y, n, 0.1, 0.8, 0, 0, &seed);
    body_kernels()->kinematics(n, y, 0, n, &ws.kin);
    room_blocks(&ROD_ROOM, &scene, &ws, 0.7, 1, &k, &d);
    const double e = 1e-6;
    double largest = 0;
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 6; ++c) {
            double plus[6], minus[6];
            state_nudge(y, n, i, c, e);
            loads_on(&scene, y, i, &ws, plus);
            state_nudge(y, n, i, c, -2 * e);
            loads_on(&scene, y, i, &ws, minus);
            state_nudge(y, n, i, c, e);
            for (int r = 0; r < 6; ++r) {
                const double found = k.diag[36 * i + 6 * c + r];
                check_close(found, (plus[r] - minus[r]) / (2 * e), 1e-6);
                largest = larger_of(largest, fabs(found));
            }
        }
    }
    check_above(largest, 50);
    free(y);
    block_chain_free(&k);
    block_chain_free(&d);
    workspace_free(&ws);
    scene_clear(&scene);
}

/* A ground body's velocities are the rates of its pose, also for turns about several axes at once. */
TEST(ghosts_move_as_they_say)
{
    RodMotionDef motion[4];
    const Vec3 direction[4] = {{1, 0, 0}, {0, 0.6, 0.8}, {1, 0, 0}, {0, 0, 1}};
    for (int m = 0; m < 4; ++m) {
        motion[m] = (RodMotionDef){.turns = m > 1, .rates = m % 2, .by.direction = direction[m]};
        motion[m].by.size = (Profile){.kind = PROFILE_STEP5, .t0 = -0.2 * m, .t1 = 1 + 0.3 * m, .v1 = 1.5 + m};
    }
    const RodEndDef end = {.n_motions = 4, .motions = motion}, still = {.pivot = 0};
    Rod rod = {.present = 1, .end = {{&end, {1, 2, 3}, {0.6, 0, 0.8, 0}}, {&still, {0, 0, 0}, {1, 0, 0, 0}}}};
    const Room room = {.kind = &ROD_ROOM, .present = 1, .self = &rod};
    const Scene scene = {.chain.n = 2};
    Kinematics kin;
    assert_true(kinematics_alloc(&kin, 2));
    const double e = 1e-5;
    for (double t = 0.1; t < 1; t += 0.2) {
        Vec3 p[2];
        Quat q[2];
        for (int side = 0; side < 2; ++side) {
            ROD_ROOM.ghosts(&room, &scene, side ? t + e : t - e, &kin);
            p[side] = v3(kin.p[0][-1], kin.p[1][-1], kin.p[2][-1]);
            q[side] = (Quat){kin.q[0][-1], kin.q[1][-1], kin.q[2][-1], kin.q[3][-1]};
        }
        ROD_ROOM.ghosts(&room, &scene, t, &kin);
        const Quat turned = quat_mul(q[1], quat_conj(q[0]));
        const Vec3 v = v3_scale(0.5 / e, v3_sub(p[1], p[0])), w = v3_scale(1 / e, v3(turned.x, turned.y, turned.z));
        for (int c = 0; c < 3; ++c) {
            check_close(kin.v[c][-1], c == 0 ? v.x : c == 1 ? v.y : v.z, 1e-7);
            check_close(kin.w[c][-1], c == 0 ? w.x : c == 1 ? w.y : w.z, 1e-7);
        }
        check_close(kin.p[0][2], 0, 0);
    }
    kinematics_free(&kin);
}

/* The largest force or moment that any joint of the rod carries at t = 0, N or N m, and the largest gap. */
static double strain_at_start(RodFixture f, double *gap)
{
    SceneDef def;
    Stage stage;
    rod_define(&def, &f);
    rod_stage(&def, &stage);
    dynamics_look(&stage.scene, &stage.ws, 0, stage.y);
    double largest = 0;
    for (int j = 0; j <= f.n; ++j) {
        for (int c = 0; c < 6; ++c) largest = larger_of(largest, fabs(stage.ws.law[c][j]));
    }
    *gap = 0;
    for (int i = 0; i + 1 < f.n; ++i) {
        const Vec3 axis = quat_rotate(state_quat(stage.y, f.n, i + 1), v3(1, 0, 0));
        const Vec3 back = v3_axpy(state_vec(stage.y, f.n, STATE_P, i + 1), -stage.scene.chain.half[i + 1], axis);
        *gap = larger_of(*gap, v3_norm(v3_sub(back, rod_front(&stage, i))));
    }
    stage_free(&stage);
    return largest;
}

/* Every shape rests in itself, twisted or not; one that is bent into it from straight does not. */
TEST(shapes_are_free_of_stress)
{
    for (int shape = ROD_STRAIGHT; shape <= ROD_POLYLINE; ++shape) {
        for (int free_of_stress = 0; free_of_stress < 2; ++free_of_stress) {
            RodFixture f = {.n = 16, .length = 8, .steps = 1};
            for (int e = 0; e < 2; ++e) rod_hold(&f.rod.end[e], 0);
            f.rod.shape = (RodShape)shape;
            f.rod.radius = 2;
            f.rod.pitch = 1;
            f.rod.plane = 0.4;
            f.rod.roll_rate = 0.2;
            f.rod.stress_free = free_of_stress;
            if (shape == ROD_POLYLINE) {
                f.rod.n_points = 3;
                f.rod.points = fixture_array(3, sizeof *f.rod.points);
                f.rod.points[1] = v3(0, 3, 4);
                f.rod.points[2] = v3(3, 3, 4);
            }
            double gap;
            const double strain = strain_at_start(f, &gap);
            check_close(gap, 0, 1e-14);
            if (free_of_stress) check_close(strain, 0, 1e-8);
            if (!free_of_stress) check_above(strain, 100);
        }
    }
}

/* Chords of an arc: corners on the circle, the roll where it was asked for, ground bodies along the tangents. */
TEST(arcs_lie_on_their_circle)
{
    RodFixture f = {.n = 10, .length = 5, .steps = 1};
    SceneDef def;
    Scene scene;
    f.rod.shape = ROD_ARC;
    f.rod.radius = 2;
    f.rod.plane = M_PI / 2; /* the centre is above */
    f.rod.roll = 0.3;
    rod_define(&def, &f);
    def.route_start = v3(1, 1, 1);
    fixture_build(&def, &scene);
    Stage stage = {.y = scene.rod->start};
    stage.scene.chain = scene.chain;
    const Vec3 centre = v3(1, 1, 3);
    for (int i = 0; i < 10; ++i) check_close(v3_norm(v3_sub(rod_front(&stage, i), centre)), 2, 1e-12);
    check_close(v3_dot(quat_rotate(rod_attitude(scene.rod, 10, -1), v3(0, 1, 0)), v3(0, 0, 1)), sin(0.3), 1e-12);
    const Vec3 out = v3_sub(rod_front(&stage, 9), centre);
    check_close(v3_dot(out, quat_rotate(rod_attitude(scene.rod, 10, 10), v3(1, 0, 0))), 0, 1e-12);
    scene_clear(&scene);
}

/* Points along a helix: equal steps of arc length, pitch and hand. */
TEST(helices_climb_by_their_pitch)
{
    const RodDef def = {.shape = ROD_HELIX, .radius = 2, .pitch = 1.5};
    const RodLine line = rod_line(&def, v3(0, 0, 0), 0, M_PI / 2);
    const double turn = hypot(2 * M_PI * 2, 1.5), e = 1e-5;
    const Vec3 after = rod_line_at(&line, turn).position;
    check_close(v3_norm(v3_sub(after, v3(0, 0, 1.5))), 0, 1e-12);
    for (double s = 0; s < turn; s += 1.3) {
        const Vec3 step = v3_sub(rod_line_at(&line, s + e).position, rod_line_at(&line, s - e).position);
        check_close(v3_norm(v3_sub(v3_scale(0.5 / e, step), rod_line_at(&line, s).tangent)), 0, 1e-8);
    }
    /* right-handed: seen from above it climbs against the clock */
    const Vec3 axis = v3_scale(0.5, v3_add(rod_line_at(&line, 0).position, rod_line_at(&line, turn / 2).position));
    const Vec3 arm = v3_sub(rod_line_at(&line, 0).position, axis);
    check_above(v3_cross(arm, rod_line_at(&line, 0).tangent).z, 0);
}

/* Total and first moment of point masses are kept between centres. */
TEST(masses_keep_their_place)
{
    for (double at = 0.3; at < 2.7; at += 0.17) {
        RodFixture f = {.n = 5, .length = 3, .steps = 1};
        SceneDef def;
        Scene scene;
        f.rod.n_masses = 1;
        f.rod.masses = fixture_array(1, sizeof *f.rod.masses);
        f.rod.masses[0] = (RodMassDef){at, 7};
        rod_define(&def, &f);
        fixture_build(&def, &scene);
        double mass = 0, moment = 0;
        for (int i = 0; i < 5; ++i) {
            mass += scene.chain.mass[i];
            moment += scene.chain.mass[i] * (0.3 + 0.6 * i);
        }
        check_close(mass, 10, 1e-12);
        check_close(moment, 3 * 1.5 + 7 * at, 1e-12);
        scene_clear(&scene);
    }
}

/* The place of the tip of the loaded helix whose whole scene is turned by a heading. */
static Vec3 helix_tip(double heading)
{
    RodFixture f = loaded_helix();
    SceneDef def;
    Stage stage;
    const Quat turn = quat_exp(v3(0, 0, heading));
    for (int l = 0; l < f.rod.n_loads; ++l) {
        f.rod.loads[l].by.direction = quat_rotate(turn, f.rod.loads[l].by.direction);
    }
    f.steps = 10;
    rod_define(&def, &f);
    def.route_heading = heading;
    rod_stage(&def, &stage);
    rod_solve(&stage);
    const Vec3 tip = rod_front(&stage, 8);
    stage_free(&stage);
    return quat_rotate(quat_conj(turn), tip);
}

TEST(scenes_may_be_turned) { check_close(v3_norm(v3_sub(helix_tip(0), helix_tip(1.1))), 0, 1e-8); }

/* One run of the loaded helix in time, from rest. */
static void run_helix(int threads, double *position)
{
    RodFixture f = loaded_helix();
    SceneDef def;
    Sim *sim;
    hawser_error err = {0};
    rod_define(&def, &f);
    def.analysis.kind = ANALYSIS_DYNAMICS;
    assert_int_equal(sim_new(&def, threads, &sim, &err), HAWSER_OK);
    assert_int_equal(sim_relax(sim, NULL, &err), HAWSER_OK);
    if (sim_advance(sim, 0.3, 0, &err)) fail_msg("%s", err.message);
    memcpy(position, hawser_sim_sample(sim)->position, 27 * sizeof(double));
    scene_def_clear(&def);
    sim_free(sim);
}

TEST(two_threads_give_the_same_bits)
{
    double one[27], two[27];
    run_helix(1, one);
    run_helix(2, two);
    assert_memory_equal(one, two, sizeof one);
    check_above(fabs(one[26]), 0.01);
}

/* A rod that its tail's support takes along comes to rest one shift farther and turned, as stiff as it was. */
TEST(a_led_rod_follows)
{
    RodFixture f = {.n = 6, .length = 1.2, .steps = 1};
    SceneDef def;
    Sim *sim;
    hawser_error err = {0};
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    RodEndDef *const tail = &f.rod.end[ROD_TAIL];
    tail->n_motions = 2;
    tail->motions = fixture_array(2, sizeof *tail->motions);
    const Profile ramp = {.kind = PROFILE_STEP, .t1 = 0.5, .v1 = 1.2};
    tail->motions[0] = (RodMotionDef){.by = {.direction = {0, 1, 0}, .size = ramp}};
    tail->motions[1] = (RodMotionDef){.turns = 1, .by = {.direction = {0, 0, 1}, .size = ramp}};
    rod_define(&def, &f);
    def.analysis.kind = ANALYSIS_DYNAMICS;
    def.cables[0].damping = 0.02;
    assert_int_equal(sim_new(&def, 0, &sim, &err), HAWSER_OK);
    if (sim_advance(sim, 3, 0, &err)) fail_msg("%s", err.message);
    const double *const last = hawser_sim_sample(sim)->position + 15;
    check_close(last[0], 1.1 * cos(1.2), 1e-12);
    check_close(last[1], 1.2 + 1.1 * sin(1.2), 1e-12);
    scene_def_clear(&def);
    sim_free(sim);
}
