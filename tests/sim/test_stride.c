/* How far a step may carry the chain (N14), and what has turned too far to be followed (B16). */
#include "sim/run/sample.h"
#include "sim/solve/scales.h"
#include "tests/support/rig.h"
#include "tests/support/tessellated.h"

static Rig *pull(void)
{
    SceneDef def;
    const FixtureChoice choice = {0};
    fixture_pull(&def, &choice);
    return rig_make(&def, NULL);
}

/* The thinnest roller and the thinnest cable, and what is left of the reach; nothing where there is nothing to pass. */
TEST(test_way)
{
    Rig *const r = pull();
    double thin = INFINITY;
    for (int i = 0; i < r->scene.def.n_cables; ++i) thin = smaller_of(thin, r->scene.def.cables[i].diameter / 2);
    check_close(stride_most(&r->scene), 0.1 + thin, 1e-15);
    r->scene.rollers[3].shape.half_width = 0.03; /* a disc may be passed along its axis */
    check_close(stride_most(&r->scene), 0.03 + thin, 1e-15);
    r->scene.def.contact_reach = 0.16;
    check_close(stride_most(&r->scene), 0.04, 1e-15);
    rig_free(r);
    SceneDef def;
    fixture_free_chain(&def, 12);
    Rig *const alone = rig_make(&def, NULL);
    check_infinite(stride_most(&alone->scene));
    rig_free(alone);
}

/* A wall with ends is passed within its depth and the cable's radius; half of space is not, but candidates must be
 * found in time. */
TEST(test_way_of_surfaces)
{
    for (int bounded = 0; bounded < 2; ++bounded) {
        SceneDef def;
        fixture_free_chain(&def, 12);
        def.n_surfaces = 1;
        def.surfaces = fixture_array(1, sizeof *def.surfaces);
        def.surfaces[0].shape = (SurfaceShape){.kind = SURFACE_PLANE,
                                               .normal = {0, 0, 1},
                                               .along = {1, 0, 0},
                                               .point = {0, 0, -3},
                                               .length = bounded ? 4 : 0,
                                               .fade = 0.1};
        def.surfaces[0].friction = def.friction;
        Rig *const r = rig_make(&def, NULL);
        const double radius = r->scene.def.cables[0].diameter / 2;
        check_close(stride_most(&r->scene), bounded ? (SURFACE_DEPTH_MAX + radius) / 2 : 0.25, 1e-15);
        rig_free(r);
    }
}

/* A sheet of a mesh has no other side within which the cable would still be in contact: half a cable's radius, and what
 * the lists of triangles leave. */
TEST(test_way_of_an_environment)
{
    SceneDef def;
    MeshBuild m = {0};
    fixture_free_chain(&def, 12);
    mesh_box(&m, "box", v3(-1, -1, -4), v3(1, 1, -3));
    mesh_build_end(&m);
    def.environment.mesh = m.mesh;
    def.environment.clear = fixture_array(1, sizeof *def.environment.clear);
    def.environment.friction = fixture_array(1, sizeof *def.environment.friction);
    def.environment.touched = true;
    assert_int_equal(environment_share(&def.environment, NULL), HAWSER_OK);
    Rig *const r = rig_make(&def, NULL);
    const double radius = r->scene.def.cables[0].diameter / 2, skin = fmax(0.01, radius);
    check_close(scene_way(&r->scene), radius / 2, 1e-15);
    check_close(r->scene.surfaces.model.skin, skin, 1e-15);
    check_close(stride_most(&r->scene), fmin(radius / 2, (1 - CONTACT_USABLE) * skin), 1e-15);
    rig_free(r);
}

/* (N15): the way at a constant speed, from rest, and both. */
TEST(test_longest)
{
    check_close(stride_longest(0.1, 2, 0), 0.05, 1e-15);
    check_close(stride_longest(0.1, 0, 9.81), sqrt(0.2 / 9.81), 1e-15);
    const double h = stride_longest(0.1, 2, 9.81);
    check_close(2 * h + 9.81 * h * h / 2, 0.1, 1e-15);
    check_infinite(stride_longest(0.1, 0, 0));
}

/* The largest of all segments, wherever it is, for counts that are no multiple of the lanes. */
TEST(test_speed)
{
    Rig *const r = pull();
    const Chain *const chain = &r->scene.chain;
    const int n = r->n;
    for (int i = 0; i < n; ++i) {
        double *const y = r->y;
        y[STATE_V * n + i] = 3, y[(STATE_V + 2) * n + i] = -4, y[(STATE_W + 1) * n + i] = 12 / chain->half[i];
        const double speed = stride_speed(chain, n, 3, y + STATE_V * n, 3, y + STATE_W * n);
        check_close(speed, 13, 1e-12);
        y[STATE_V * n + i] = y[(STATE_V + 2) * n + i] = y[(STATE_W + 1) * n + i] = 0;
    }
    rig_free(r);
}

TEST(test_turned)
{
    Rig *const r = pull();
    const int n = r->n;
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    assert_int_equal(turned(&r->scene, 0, &r->ws.kin), 0);
    /* segment 5 about its own axis: by 140 deg, by 160 deg */
    const Quat q = {r->y[3 * n + 5], r->y[4 * n + 5], r->y[5 * n + 5], r->y[6 * n + 5]};
    for (int degrees = 140; degrees <= 160; degrees += 20) {
        const double half = degrees * M_PI / 360;
        const Quat p = quat_mul(q, (Quat){cos(half), sin(half), 0, 0});
        r->y[3 * n + 5] = p.w, r->y[4 * n + 5] = p.x, r->y[5 * n + 5] = p.y, r->y[6 * n + 5] = p.z;
        dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
        assert_int_equal(turned(&r->scene, 0, &r->ws.kin), degrees > 150 ? TURNED_JOINT : 0);
    }
    assert_int_equal(turned(&r->scene, 1, &r->ws.kin), 0); /* a plane has no such limit */
    rig_free(r);
}
