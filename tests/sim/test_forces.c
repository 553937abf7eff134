/* Forces from outside: their blocks and those of a law against differences, what takes a force's place, what is saved.
 */
#include "core/body.h"
#include "sim/equipment/forces.h"
#include "sim/run/commands.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

enum { SEGMENTS = 9 };

/* A free helix in disorder. */
static void scene_make(Scene *scene, Workspace *ws, double y[STATE_SIZE * SEGMENTS])
{
    RodFixture f = {.n = SEGMENTS, .length = 4.5, .steps = 1, .gravity = {0, 0, -9.81}};
    SceneDef def;
    uint64_t seed = 7;
    f.rod.shape = ROD_HELIX;
    f.rod.radius = 1;
    f.rod.pitch = -0.4;
    f.rod.stress_free = 1;
    rod_define(&def, &f);
    fixture_build(&def, scene);
    assert_true(workspace_alloc(ws, scene, NULL));
    scene_initial_state(scene, y);
    state_shake(y, SEGMENTS, 0.1, 0.8, 1.5, 2, &seed);
}

static void scene_end(Scene *scene, Workspace *ws)
{
    workspace_free(ws);
    scene_clear(scene);
}

static void forces_on(Scene *scene, const double *y, int i, Workspace *ws, double t, double out[6])
{
    body_kernels()->kinematics(SEGMENTS, y, 0, SEGMENTS, &ws->kin);
    for (int part = 0; part < PARTS; ++part) loads_zero(&ws->loads[part], SEGMENTS);
    room_loads(&FORCES_ROOM, scene, ws, t, 1);
    for (int c = 0; c < 3; ++c) {
        out[c] = ws->loads[0].f[c][i];
        out[3 + c] = ws->loads[0].m[c][i];
    }
}

/* Every column of every segment's blocks against central differences of the forces. */
static void blocks_check(Scene *scene, Workspace *ws, double *y, double tolerance)
{
    static const double E = 1e-6;
    BlockChain block[2];
    double largest = 0;
    for (int b = 0; b < 2; ++b) assert_true(block_chain_alloc(&block[b], SEGMENTS, 6));
    body_kernels()->kinematics(SEGMENTS, y, 0, SEGMENTS, &ws->kin);
    room_blocks(&FORCES_ROOM, scene, ws, 0.1, 1, &block[0], &block[1]);
    for (int i = 0; i < SEGMENTS; ++i) {
        for (int c = 0; c < 12; ++c) {
            double plus[6], minus[6];
            state_nudge(y, SEGMENTS, i, c, E);
            forces_on(scene, y, i, ws, 0.1, plus);
            state_nudge(y, SEGMENTS, i, c, -2 * E);
            forces_on(scene, y, i, ws, 0.1, minus);
            state_nudge(y, SEGMENTS, i, c, E);
            for (int r = 0; r < 6; ++r) {
                const double found = block[c / 6].diag[36 * i + 6 * (c % 6) + r];
                check_close(found, (plus[r] - minus[r]) / (2 * E), tolerance);
                largest = larger_of(largest, fabs(found));
            }
        }
    }
    check_above(largest, 5);
    for (int b = 0; b < 2; ++b) block_chain_free(&block[b]);
}

static void command(Scene *scene, int segment, int follows, double size, double t)
{
    hawser_error err = {0};
    const Command c = {.kind = COMMAND_FORCE,
                       .ramp = 0.2,
                       .segment = segment,
                       .follows = follows,
                       .force = {30 * size, -20 * size, 10 * size},
                       .moment = {4 * size, 5 * size, -6 * size},
                       .arm = {0.3, 0.1, -0.2}};
    assert_int_equal(FORCES_ROOM.command(room_of(scene, &FORCES_ROOM), scene, &c, t, &err), 1);
}

/* (K7), (K8): dead forces and those that follow, half-way up their ramps. */
TEST(forces_against_differences)
{
    Scene scene;
    Workspace ws;
    double y[STATE_SIZE * SEGMENTS];
    scene_make(&scene, &ws, y);
    for (int i = 0; i < SEGMENTS; ++i) command(&scene, i, i % 2, 1 + i, 0);
    blocks_check(&scene, &ws, y, 2e-6);
    scene_end(&scene, &ws);
}

/* A spring to a point and an air brake, twisted by the segment's attitude: every derivative is there. */
static int tie_law(void *user, const hawser_segment_now *at, double wrench[6], double by_place[36],
                   double by_motion[36])
{
    (void)user, (void)by_place, (void)by_motion;
    const Quat q = {at->quaternion[0], at->quaternion[1], at->quaternion[2], at->quaternion[3]};
    const Vec3 axis = quat_rotate(q, v3(1, 0, 0));
    const double a[3] = {axis.x, axis.y, axis.z};
    for (int c = 0; c < 3; ++c) {
        wrench[c] = -40 * (at->position_m[c] - c) * (2 + a[0]) - 3 * at->velocity_m_per_s[c];
        wrench[3 + c] = 7 * a[(c + 1) % 3] - 2 * at->omega_rad_per_s[c] * at->omega_rad_per_s[c];
    }
    return 0;
}

/* (K10): the differences that stand in for derivatives. */
TEST(law_against_differences)
{
    Scene scene;
    Workspace ws;
    double y[STATE_SIZE * SEGMENTS];
    hawser_error err = {0};
    const OutsideLaw law = {.call = tie_law, .from = 2, .to = 7};
    scene_make(&scene, &ws, y);
    assert_int_equal(outside_law_set(&scene, &law, &err), HAWSER_OK);
    blocks_check(&scene, &ws, y, 2e-6);
    scene_end(&scene, &ws);
}

/* (K9): what is given anew takes the place of what was there, continuously, and what has gone leaves the list. */
TEST(a_force_takes_the_place_of_another)
{
    Scene scene;
    Workspace ws;
    double y[STATE_SIZE * SEGMENTS], before[6], after[6];
    scene_make(&scene, &ws, y);
    command(&scene, 4, 0, 1, 0);
    forces_on(&scene, y, 4, &ws, 1, before);
    check_close(before[0], 30, 1e-12);
    command(&scene, 4, 0, 2, 1);
    forces_on(&scene, y, 4, &ws, 1, after);
    for (int c = 0; c < 6; ++c) check_close(after[c], before[c], 1e-12);
    forces_on(&scene, y, 4, &ws, 1.1, after);
    check_close(after[0], 45, 1e-12);
    forces_on(&scene, y, 4, &ws, 1.2, after);
    check_close(after[0], 60, 1e-12);
    assert_int_equal(outside_of(&scene)->n, 2);
    command(&scene, 4, 0, 0, 2);
    assert_int_equal(outside_of(&scene)->n, 1);
    forces_on(&scene, y, 4, &ws, 3, after);
    for (int c = 0; c < 6; ++c) check_close(after[c], 0, 0);
    scene_end(&scene, &ws);
}
