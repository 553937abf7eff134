/* Which scenes lie in a plane, which do not and why; and what a case's `solver.planar` makes of it. */
#include "sim/run/sim.h"
#include "sim/solve/planar.h"
#include "tests/support/scene.h"

enum { N = FIXTURE_SEGMENTS };

/* plane_find's verdict on a definition, which is taken apart. */
static int verdict(SceneDef *def, Plane *plane, char why[PLANE_WHY_MAX])
{
    Scene scene;
    fixture_build(def, &scene);
    const int flat = plane_find(&scene, plane, why);
    scene_clear(&scene);
    return flat;
}

static void expect_refusal(SceneDef *def, const char *reason)
{
    Plane plane;
    char why[PLANE_WHY_MAX] = "";
    assert_false(verdict(def, &plane, why));
    check_has(why, reason);
}

static void expect_plane(SceneDef *def, Vec3 normal)
{
    Plane plane;
    char why[PLANE_WHY_MAX] = "";
    if (!verdict(def, &plane, why)) fail_msg("refused: %s", why);
    check_below(v3_norm(v3_cross(plane.normal, normal)), 1e-12);
    check_vec(v3_cross(plane.e1, plane.e2), plane.normal, 1e-15);
}

static SceneDef planar_scene(double heading)
{
    SceneDef def;
    fixture_planar(&def, &(FixtureChoice){.heading = heading, .start = {1, 2, 3}});
    return def;
}

/* Vertical planes of any heading; at heading zero the axes are x and z. */
TEST(test_vertical)
{
    for (double heading = -3; heading < 3.2; heading += 0.31) {
        SceneDef def = planar_scene(heading);
        expect_plane(&def, v3(-sin(heading), cos(heading), 0));
    }
    SceneDef def = planar_scene(0);
    Plane plane;
    char why[PLANE_WHY_MAX];
    assert_true(verdict(&def, &plane, why));
    check_vec(plane.e1, v3(1, 0, 0), 1e-15);
    check_vec(plane.e2, v3(0, 0, 1), 1e-15);
}

/* A weightless chain on a bend in an inclined plane: no principal axis is along the normal, so that only a cable that
 * bends alike about both is flat there. */
TEST(test_inclined)
{
    for (int k = 0; k < 3; ++k) {
        SceneDef def;
        fixture_free_chain(&def, 12);
        def.route[0] = (RoutePieceDef){.kind = ROUTE_BEND, .radius = 20, .angle = 0.5, .plane = k == 2 ? 0 : 0.7};
        if (k == 0) def.cables[0].ei_z = def.cables[0].ei_y;
        const double tilt = k == 2 ? 0 : 0.7;
        if (k == 1) {
            expect_refusal(&def, "bends differently");
        } else {
            expect_plane(&def, v3(0, -sin(tilt), cos(tilt)));
        }
    }
}

TEST(test_refusals)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    expect_refusal(&def, "route");

    def = planar_scene(0.3);
    def.gravity = v3(0.1, 0, -9.8);
    expect_refusal(&def, "gravity");

    def = planar_scene(0.3);
    def.rollers[3].axis = v3_unit(v3_add(def.rollers[3].axis, v3(0, 0, 1e-6)));
    expect_refusal(&def, "roller");

    def = planar_scene(0.3);
    def.rollers[3].centre = v3_axpy(def.rollers[3].centre, 0.51 * def.rollers[3].width, def.rollers[3].axis);
    expect_refusal(&def, "roller");

    def = planar_scene(0.3);
    def.cable_on_cable = 1;
    expect_refusal(&def, "touch itself");

    def = planar_scene(0.3);
    def.rollers[2].spin = (SpinDef){.inertia = 0.1, .friction = 0.1, .journal = 0.01, .speed = 0.1};
    expect_refusal(&def, "spin");

    def = planar_scene(0.3);
    def.rollers[2].profile = SHAPE_V_GROOVE;
    def.rollers[2].groove = groove_v(0.8, 0.04);
    expect_refusal(&def, "roller");

    def = planar_scene(0.3);
    def.winch.mode = WINCH_TENSION;
    def.winch.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = 1e3};
    expect_refusal(&def, "set tension");

    def = planar_scene(0.3);
    def.conveyors = fixture_array(1, sizeof *def.conveyors);
    def.n_conveyors = 1;
    def.conveyors[0] = (ConveyorDef){.from = 1, .to = 2, .edge = 0.2, .sync = 1, .factor = 1, .v_s = 1e-4, .v_d = 2e-4};
    expect_refusal(&def, "conveyors");

    def = planar_scene(0.3);
    def.cables[0].bending = (BendingTable){.rows = 2, .curvature = {0.1, 1}, .moment = {1e3, 2e3}};
    expect_refusal(&def, "hysteresis");

    const int sideways[] = {1, 3, 5}; /* shear y, torsion, bending about z: not in a vertical plane */
    for (int k = 0; k < 3; ++k) {
        def = planar_scene(0.3);
        def.cables[0].preload[sideways[k]] = 0.5;
        expect_refusal(&def, "preload");
    }
    def = planar_scene(0.3);
    for (int c = 0; c < 6; c += 2) def.cables[0].preload[c] = 0.5;
    expect_plane(&def, v3(-sin(0.3), cos(0.3), 0));
}

/* The summary says what was done; a scene that must be planar and is not is an error that says why. */
TEST(test_choice)
{
    for (int choice = PLANAR_AUTO; choice <= PLANAR_OFF; ++choice) {
        for (int flat = 0; flat < 2; ++flat) {
            SceneDef def = planar_scene(0.3);
            if (!flat) def.gravity = v3(0.1, 0, -9.8);
            def.solver.planar = (PlanarChoice)choice;
            Sim *s = NULL;
            hawser_error err = {0};
            hawser_summary summary;
            const hawser_status status = sim_new(&def, 1, &s, &err);
            scene_def_clear(&def);
            if (choice == PLANAR_ON && !flat) {
                assert_int_equal(status, HAWSER_ERR_INPUT);
                check_has(err.message, "solver.planar: on: gravity");
                continue;
            }
            assert_int_equal(status, HAWSER_OK);
            hawser_sim_summary(s, &summary);
            assert_int_equal(summary.planar, flat && choice != PLANAR_OFF);
            if (choice == PLANAR_OFF) assert_string_equal(summary.planar_why, "solver.planar is off");
            if (choice == PLANAR_AUTO) check_has(summary.planar_why, flat ? "in one plane" : "gravity");
            sim_free(s);
        }
    }
}

/* Pressing a state into the plane loses what is off it, and says how much; angles go on past half a turn. */
TEST(test_press)
{
    SceneDef def = planar_scene(0.3);
    Plane plane;
    char why[PLANE_WHY_MAX];
    Scene scene;
    fixture_build(&def, &scene);
    assert_true(plane_find(&scene, &plane, why));
    const int stride = planar_stride(N);
    double y[STATE_SIZE * N], flat[PLANAR_SIZE * 32], again[PLANAR_SIZE * 32];
    check_at_most(stride, 32);
    scene_initial_state(&scene, y);
    check_below(plane_press(&plane, N, y, flat), 1e-14);
    for (int i = 0; i < N; ++i) flat[PLANAR_ANGLE * stride + i] = -0.4 * i; /* two turns over the chain */
    plane_lift(&plane, N, flat, y);
    check_below(plane_press(&plane, N, y, again), 1e-14);
    for (int k = 0; k < PLANAR_SIZE * stride; ++k) check_close(again[k], flat[k], 1e-13);
    state_set_vec(y, N, STATE_P, 4, v3_axpy(state_vec(y, N, STATE_P, 4), 1e-3, plane.normal));
    check_close(plane_press(&plane, N, y, again), 1e-3, 1e-14);
    scene_clear(&scene);
}
