/* What a picture of a scene is made of: every kind of roller, obstacle and surface is there with its sizes, its
 * triangles close it, and each allocation fails once; what touches and how the cable is bent, looked at closely. */
#include "tests/support/lack.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "sim/run/sim.h"
#include "tests/support/kinds.h"

enum { MOST = 500, ROLLERS = 7, SURFACES = 8 };

static RollerDef shaped(const SceneDef *def, int k)
{
    RollerDef r = fixture_roller(def, v3(2 * k, 0, -3), v3(0, 0, -1), v3(0, 1, 0));
    snprintf(r.name, sizeof r.name, "shape %d", k);
    r.rating = k == 0 ? 5e3 : 0;
    if (k == 1) r.hold_down = 1;
    if (k == 2) r.profile = SHAPE_V_GROOVE;
    if (k == 2) r.groove = groove_v(0.6, 0.05);
    if (k == 3) r.profile = SHAPE_U_GROOVE;
    if (k == 3) r.groove = groove_u(0.08, 0.05);
    if (k == 4) r.profile = SHAPE_BOX;
    if (k == 4) r.box = (BoxSection){{0, 0, 1}, {0.1, 0.15}, 0.02};
    if (k == 4) r.radius = 0.1;
    if (k >= 5) r.profile = SHAPE_BELL;
    if (k >= 5) r.bell.ring = 0.4;
    if (k == 6) r.axis = v3(0, 0, 1);
    return r;
}

static SurfaceShape plane(Vec3 point, Vec3 normal, double length, double width)
{
    return (SurfaceShape){
        .kind = SURFACE_PLANE, .point = point, .normal = normal, .along = {1, 0, 0}, .length = length, .width = width};
}

static SurfaceShape along(SurfaceKind kind, int k)
{
    return (SurfaceShape){.kind = kind,
                          .from = 0.5 + 2 * k,
                          .to = 1.5 + 2 * k,
                          .fade = 0.1,
                          .cable_radius = 0.04,
                          .radius = 0.15,
                          .lift = 0.1,
                          .depth = 0.2,
                          .width = 0.4,
                          .height = 0.3,
                          .angle = 1.2};
}

/* Everything that there is, out of the cable's way. */
static void define_all(SceneDef *def)
{
    define_conveyor(def);
    def->n_jams = 0;
    def->n_rollers = 0;
    for (int k = 0; k < ROLLERS; ++k) def->rollers[def->n_rollers++] = shaped(def, k);
    def->surfaces = fixture_array(SURFACES, sizeof *def->surfaces);
    const SurfaceShape shape[SURFACES] = {plane(v3(0, 0, -5), v3(0, 0, 1), 0, 0),
                                          plane(v3(0, 0, 9), v3(0, 0, -1), 20, 3),
                                          plane(v3(0, 8, 0), v3(0, -1, 0), 20, 0),
                                          along(SURFACE_DUCT, 0),
                                          along(SURFACE_FLAT, 1),
                                          along(SURFACE_V, 2),
                                          along(SURFACE_U, 3),
                                          along(SURFACE_FLAT, 4)};
    for (int k = 0; k < SURFACES; ++k) {
        SurfaceDef *const s = &def->surfaces[def->n_surfaces++];
        *s = (SurfaceDef){.shape = shape[k], .friction = def->friction};
        snprintf(s->name, sizeof s->name, "surface %d", k);
    }
    def->surfaces[7].shape.height = 0; /* no sides */
    def->solver.relax = 0;
}

static void scene_of(void (*define)(SceneDef *), Scene *scene)
{
    SceneDef def;
    define(&def);
    fixture_build(&def, scene);
}

TEST(test_kinds)
{
    static const char *const rollers[ROLLERS] = {"roller", "hold-down",  "roller",    "roller",
                                                 "box",    "bell-mouth", "bell-mouth"};
    static const char *const surfaces[SURFACES] = {"floor", "ceiling", "wall", "duct", "tray", "tray", "tray", "tray"};
    Scene scene;
    Geometry g;
    hawser_error err = {0};
    scene_of(define_all, &scene);
    if (geometry_make(&scene, &g, &err)) fail_msg("%s", err.message);
    assert_int_equal(g.n_rollers, ROLLERS);
    for (int k = 0; k < ROLLERS; ++k) {
        assert_string_equal(g.roller_kind[k], rollers[k]);
        check_equal(g.roller_groove[k], k == 2 || k == 3 ? 0.05 : 0);
        if (k == 0) check_equal(g.roller_rating[k], 5e3);
        if (k > 0) check_nan(g.roller_rating[k]);
    }
    assert_int_equal(g.n_obstacles, 3);
    assert_int_equal(g.obstacle_roller[0], 4);
    check_vec(v3_get(g.obstacle_size), v3(0.6, 0.2, 0.3), 1e-15);
    check_equal(g.obstacle_edge[0], 0.02);
    check_nan(g.obstacle_ring[0]);
    for (int k = 1; k < 3; ++k) { /* a ring of 0.4 m with a section of 0.1 m */
        check_vec(v3_get(g.obstacle_size + 3 * k), v3(0.6, 1, 1), 1e-15);
        check_equal(g.obstacle_ring[k], 0.4);
        check_close(v3_dot(v3_get(g.obstacle_side + 3 * k), k == 1 ? v3(0, 1, 0) : v3(0, 0, 1)), 0, 1e-15);
    }
    assert_int_equal(g.n_surfaces, SURFACES);
    for (int k = 0; k < SURFACES; ++k) {
        const GeometrySurface *const s = &g.surface[k];
        assert_string_equal(s->kind, surfaces[k]);
        assert_int_equal(s->endless, k == 0 || k == 2);
        check_at_least(s->n, 2);
    }
    check_close(g.surface[1].width, 3, 1e-15);
    check_close(g.surface[3].diameter, 0.3, 1e-15);
    check_close(g.surface[4].width, 0.4, 1e-15);
    check_close(g.surface[4].height, 0.3, 1e-15);
    check_close(g.surface[6].diameter, 0.3, 1e-15);
    assert_int_equal(g.n_conveyors, 1);
    assert_string_equal(g.conveyor_name[0], "belts");
    assert_true(g.winch.present && !g.reel.present);
    assert_int_equal(g.n_segments, FIXTURE_SEGMENTS);
    double length = 0;
    for (int i = 0; i < g.n_segments; ++i) length += g.length[i];
    check_close(length, 16, 1e-12);
    geometry_free(&g);
    scene_clear(&scene);
}

/* Points that there are, triangles of parts that the scene has; a roller's volume is that of its size. */
TEST(test_triangles)
{
    Scene scene;
    Geometry g;
    hawser_error err = {0};
    scene_of(define_all, &scene);
    if (geometry_make(&scene, &g, &err)) fail_msg("%s", err.message);
    const Skin *const m = &g.skin;
    int of[4] = {0}, item[ROLLERS] = {0};
    for (int k = 0; k < 3 * m->n_points; ++k) check_finite(m->points[k]);
    for (int t = 0; t < m->n_triangles; ++t) {
        check_between(m->part[t], -1, 4);
        ++of[m->part[t]];
        if (m->part[t] == SKIN_ROLLER) ++item[m->item[t]];
        for (int c = 0; c < 3; ++c) check_between(m->triangle[3 * t + c], -1, m->n_points);
    }
    for (int part = SKIN_ROLLER; part <= SKIN_CONVEYOR; ++part) check_above(of[part], 10);
    for (int r = 0; r < ROLLERS; ++r) check_above(item[r], 11);
    /* the volume of roller 0, a cylinder of 0.1 m and 0.6 m, by the tetrahedra over its triangles */
    double volume = 0;
    for (int t = 0; t < m->n_triangles; ++t) {
        if (m->part[t] != SKIN_ROLLER || m->item[t] != 0) continue;
        Vec3 p[3];
        for (int c = 0; c < 3; ++c)
            p[c] = v3_sub(v3_get(m->points + 3 * m->triangle[3 * t + c]), v3_get(g.roller_position));
        volume += v3_dot(p[0], v3_cross(p[1], p[2])) / 6;
    }
    check_share(volume, M_PI * 0.1 * 0.1 * 0.6, 0.05); /* of a prism in it */
    geometry_free(&g);
    scene_clear(&scene);
}

/* A reel, a drum, a rod: what is there besides. */
TEST(test_others)
{
    Scene scene;
    Geometry g;
    hawser_error err = {0};
    scene_of(define_drum, &scene);
    assert_int_equal(geometry_make(&scene, &g, &err), HAWSER_OK);
    assert_true(g.reel.present);
    check_close(g.reel.barrel, 0.25, 1e-15);
    check_close(g.reel.flange, 0.6, 1e-15);
    geometry_free(&g);
    scene_clear(&scene);
    scene_of(define_reel, &scene);
    assert_int_equal(geometry_make(&scene, &g, &err), HAWSER_OK);
    assert_true(g.reel.present);
    check_close(g.reel.barrel, 0.6, 1e-15);
    check_close(fabs(g.reel.axis[1]), 1, 1e-15);
    geometry_free(&g);
    scene_clear(&scene);
    scene_of(define_static, &scene);
    assert_int_equal(geometry_make(&scene, &g, &err), HAWSER_OK);
    assert_int_equal(g.n_route, 0);
    assert_false(g.winch.present);
    assert_int_equal(g.n_segments, 12);
    geometry_free(&g);
    scene_clear(&scene);
}

/* ------------------------------------------------------------------------------------------------ without memory */

typedef hawser_status Attempt(Sim *s, hawser_error *err);

static hawser_status geometry(Sim *s, hawser_error *err)
{
    Geometry g;
    const hawser_status status = geometry_make(&s->stage.scene, &g, err);
    assert_int_equal(g.n_owned > 0, !status);
    geometry_free(&g);
    return status;
}

static hawser_status around(Sim *s, hawser_error *err)
{
    Around *const a = around_new(&s->stage.scene, err);
    const hawser_status status = a ? HAWSER_OK : err->status;
    if (a) assert_int_equal(a->from.n_rollers, s->stage.scene.def.n_rollers);
    around_free(a);
    return status;
}

static hawser_status envelope(Sim *s, hawser_error *err)
{
    Envelope e;
    const hawser_status status = envelope_new(&e, &s->stage.scene, err);
    assert_int_equal(e.present, !status);
    envelope_free(&e);
    return status;
}

static hawser_status contacts(Sim *s, hawser_error *err)
{
    Closeup c = {0};
    const hawser_status status = closeup_contacts(&c, &s->stage.scene, &s->stage.ws, s->stage.t, err);
    if (!status) check_above(c.n_contacts, 0);
    closeup_free(&c);
    return status;
}

static hawser_status cable(Sim *s, hawser_error *err)
{
    Closeup c = {0};
    const hawser_status status = closeup_cable(&c, &s->stage.scene, &s->stage.ws, hawser_sim_sample(s), err);
    if (!status) check_finite(c.joint[3].tension_N);
    closeup_free(&c);
    return status;
}

static void every_allocation(void (*define)(SceneDef *), Attempt *attempt, int least)
{
    SceneDef def;
    Sim *s = NULL;
    hawser_error err = {0};
    define(&def);
    if (sim_new(&def, 1, &s, &err) || sim_relax(s, NULL, &err)) fail_msg("%s", err.message);
    scene_def_clear(&def);
    hawser_sim_sample(s);
    const long live = lack_live();
    int k = 0;
    for (int met = 1; met; ++k) {
        check_below(k, MOST);
        err = (hawser_error){0};
        lack_after(k);
        const hawser_status status = attempt(s, &err);
        met = lack_end();
        if (met) assert_int_equal(status, HAWSER_ERR_MEMORY);
        if (met) check_has(err.message, "out of memory");
        if (!met) assert_int_equal(status, HAWSER_OK);
        assert_int_equal(lack_live(), live);
    }
    check_above(k, least);
    sim_free(s);
}

TEST(test_lack)
{
    if (!lack_works()) skip();
    every_allocation(define_all, geometry, 40);
    every_allocation(define_drum, geometry, 20);
    every_allocation(define_all, around, 40);
    every_allocation(define_sticky, envelope, 1);
    every_allocation(define_sticky, contacts, 1);
    every_allocation(define_plane, contacts, 1);
    every_allocation(define_drum, contacts, 2);
    every_allocation(define_sticky, cable, 1);
}
