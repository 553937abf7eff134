/* A drum with the cable wound on it: the lay keeps turns and layers apart, the hold of the end has the derivatives that
 * differences give and keeps angular momentum, Newton's matrix holds drum and layers together, and a cable that is
 * pulled off has the brake's torque over the radius as its tension. */
#include "sim/equipment/reel.h"
#include "sim/equipment/rollers.h"
#include "tests/support/rig.h"

/* Turns and layers that are not neighbours along the cable do not press on each other, whatever the layers. */
TEST(test_lay)
{
    for (int turns = 2; turns <= 7; ++turns) {
        const int n = turns < 6 ? 24 + 28 * turns : 270;
        SceneDef def;
        Scene scene;
        Workspace ws;
        wound_case(&def, n, turns, 0);
        fixture_build(&def, &scene);
        double *const y = fixture_array(scene_state_size(&scene), sizeof *y);
        assert_true(workspace_alloc(&ws, &scene, NULL));
        scene_initial_state(&scene, y);
        assert_int_equal(dynamics_refresh(&scene, &ws, 0, y, 1, NULL), HAWSER_OK);
        const SelfDetail deepest = self_deepest(&scene.self, SELF_ALONE(&scene.chain, &ws.kin), &ws.self);
        print_message("%d turns a layer, %.2f in all: deepest %.3g mm\n", turns, scene.drum->turns,
                      1e3 * deepest.depth);
        check_above(scene.drum->turns, 1.5 * turns);
        /* where the cable leaves, it leaves square and the turn before it does not; a start may be so deep (sim.c) */
        check_below(deepest.depth, WOUND_DIAMETER / 8);
        for (int i = 0; i + 1 < n; ++i) { /* the joints are closed */
            const Vec3 a = state_vec(y, n, STATE_P, i), b = state_vec(y, n, STATE_P, i + 1);
            const Vec3 ra = quat_rotate(state_quat(y, n, i), v3(WOUND_SEGMENT / 2, 0, 0));
            const Vec3 rb = quat_rotate(state_quat(y, n, i + 1), v3(WOUND_SEGMENT / 2, 0, 0));
            check_vec(v3_sub(b, rb), v3_add(a, ra), 1e-9);
        }
        workspace_free(&ws);
        scene_clear(&scene);
        free(y);
    }
}

static hawser_status build_with(double DrumDef_flange, double width, double distance, char *message)
{
    SceneDef def;
    Scene scene;
    hawser_error err = {0};
    wound_case(&def, 80, 2, 0);
    if (DrumDef_flange > 0) def.drum.flange = DrumDef_flange;
    if (width > 0) def.drum.width = width;
    if (distance > 0) def.drum.distance = distance;
    const hawser_status status = scene_build(&def, &scene, &err);
    scene_def_clear(&def);
    if (!status) scene_clear(&scene);
    strcpy(message, err.message);
    return status;
}

TEST(test_refused)
{
    char message[512];
    assert_int_equal(build_with(0, 0, 0, message), HAWSER_OK);
    assert_int_equal(build_with(0.62, 0, 0, message), HAWSER_ERR_INPUT);
    check_has(message, "more cable than fits");
    assert_int_equal(build_with(0, 3 * WOUND_DIAMETER, 0, message), HAWSER_ERR_INPUT);
    check_has(message, "reel.width");
    assert_int_equal(build_with(0, 0, 0.5, message), HAWSER_ERR_INPUT);
    check_has(message, "reel.distance");
    assert_int_equal(build_with(0, 0, 11, message), HAWSER_ERR_INPUT);
    check_has(message, "no cable is left");
}

/* newton_solve against differences of the rates: drum, layers, hold and chain in one matrix. */
TEST(test_newton)
{
    SceneDef def;
    Scene scene;
    Workspace ws;
    Newton nw;
    hawser_error err = {0};
    const LinOptions options = {.kind = LIN_AUTO, .threads = 1};
    wound_case(&def, 80, 2, 0.1);
    def.drum.lay = 0.99 * WOUND_DIAMETER; /* turns press on each other */
    fixture_soften(&def);
    def.cables[0].ea = def.cables[0].ga = 5e4;
    fixture_build(&def, &scene);
    /* the hold is far stiffer than all else: as it is, differences would see nothing else */
    scene.drum->hold = 1e3;
    assert_true(workspace_alloc(&ws, &scene, NULL));
    if (newton_new(&nw, &scene, &options, &err)) fail_msg("%s", err.message);
    if (newton_extra_attach(&nw, &ws.self.extras, &options, &err)) fail_msg("%s", err.message);
    const int size = scene_state_size(&scene), n = scene.chain.n;
    double *const y = fixture_array(6 * size, sizeof(double)), *const rate = y + size, *const b = y + 2 * size,
                  *const x = y + 3 * size, *const up = y + 4 * size, *const down = y + 5 * size;
    uint64_t seed = 12;
    const double gamma = 1e-2;
    scene_initial_state(&scene, y);
    state_shake(y, n, 2e-3, 4e-3, 0.05, 0.2, &seed);
    y[STATE_SIZE * n] = 0.3; /* rad/s, of the drum */
    assert_int_equal(dynamics_refresh(&scene, &ws, 0.5, y, 1, NULL), HAWSER_OK);
    for (int round = 0; round < 6; ++round) { /* a leaf that touches much becomes border after some rounds */
        dynamics_rates(&scene, &ws, 0.5, y, 1, rate);
        dynamics_blocks(&scene, &ws, 0.5, y, rate, 1, &nw.k, &nw.d);
        newton_point(&nw, &scene, &ws.kin, y);
        newton_point_equipment(&nw, ws.equipment, y, 1);
        if (newton_renew(&nw, ws.equipment, &err)) fail_msg("%s", err.message);
        newton_form(&nw, gamma);
        assert_int_equal(newton_factor(&nw), 0);
    }
    check_above(ws.self.active[0] + ws.self.active[1], 5);
    for (int k = 0; k < size; ++k) x[k] = b[k] = fixture_random(&seed);
    assert_int_equal(newton_solve(&nw, x), 0);
    double largest = 0, error[3] = {0}, term[3] = {0};
    for (int k = 0; k < size; ++k) largest = larger_of(largest, fabs(x[k]));
    const double e = 1e-6 / largest;
    double *const moved = fixture_array(size, sizeof(double));
    /* along x, and along x in disorder for the size of what cancels in it */
    for (int mixed = 0; mixed < 2; ++mixed) {
        for (int sign = -1; sign <= 1; sign += 2) {
            for (int k = 0; k < size; ++k) moved[k] = y[k] + sign * e * x[k] * (mixed && k % 3 ? -1 : 1);
            dynamics_rates(&scene, &ws, 0.5, moved, 1, sign > 0 ? up : down);
        }
        for (int k = 0; k < size; ++k) {
            const int kind = k >= STATE_SIZE * n ? 2 : k >= STATE_V * n ? 1 : 0;
            const double jx = (up[k] - down[k]) / (2 * e);
            if (!mixed) error[kind] = larger_of(error[kind], fabs(x[k] - gamma * jx - b[k]));
            term[kind] = larger_of(term[kind], fabs(x[k]) + fabs(gamma * jx) + fabs(b[k]));
        }
    }
    print_message("residuals %.1g %.1g %.1g\n", error[0] / term[0], error[1] / term[1], error[2] / term[2]);
    for (int kind = 0; kind < 3; ++kind) check_below(error[kind], 1e-6 * term[kind]);
    newton_free(&nw);
    workspace_free(&ws);
    scene_clear(&scene);
    free(moved);
    free(y);
}

/* Pulled off at a steady speed, one layer: the pull is the drum's. */
TEST(test_payout)
{
    const double found = payout_pull(50, 5, 1.2, 2.2), expected = wound_pull_at(0.25 + WOUND_DIAMETER / 2);
    print_message("mean pull %.2f N, expected %.2f N\n", found, expected);
    check_share(found, expected, 0.01);
}
