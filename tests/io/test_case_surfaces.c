/* Ducts, trays and planes of a case: what they become, and every mistake that goes beyond one key. */
#include "tests/io/case_fixture.h"

/* A cable on a route with a bend, with these surfaces. */
#define CASE(surfaces) data_with("surfaces", "surfaces: {}", "surfaces: " surfaces)

TEST(ducts_are_read)
{
    SceneDef def;
    expect_good(CASE("{ducts: [{from: 2 m, to: 8 m, radius: 75 mm}, {name: b, from: 8 m, radius: 0.1, place: resting, "
                     "friction: {mu: 0.1}}]}"),
                NULL, NULL, &def);
    assert_int_equal(def.n_surfaces, 2);
    const SurfaceDef *const a = &def.surfaces[0], *const b = &def.surfaces[1];
    assert_string_equal(a->name, "D1");
    assert_string_equal(b->name, "b");
    assert_int_equal(a->shape.kind, SURFACE_DUCT);
    check_share(a->shape.radius, 0.075, 1e-12);
    check_share(a->shape.cable_radius, 0.04365, 1e-12);
    check_equal(a->shape.lift, 0);
    check_equal(a->friction.mu_d, 0.3);
    check_share(b->shape.lift, 0.1 - 0.04365, 1e-12);
    check_share(b->shape.to, 15 + 1.5 * M_PI, 1e-9);
    check_equal(b->friction.mu_d, 0.1);
    check_equal(def.line_impact.k, 1e8);
    check_equal(def.line_impact.c, 5e3);
    check_equal(def.line_impact.d, 2e-4);
    scene_def_clear(&def);
}

TEST(trays_are_read)
{
    SceneDef def;
    expect_good(CASE("{trays: [{to: 4 m}, {from: 4 m, to: 8 m, section: v}, {from: 8 m, section: u, radius: 90 mm}], "
                     "planes: [{point: [0, 0, -5 m], normal: [0, 0, 3]}], contact: {k: 2e6 N/m, e: 1}}"),
                NULL, NULL, &def);
    assert_int_equal(def.n_surfaces, 4);
    const SurfaceShape *const flat = &def.surfaces[0].shape, *const v = &def.surfaces[1].shape,
                              *const u = &def.surfaces[2].shape, *const plane = &def.surfaces[3].shape;
    check_equal(flat->kind, SURFACE_FLAT);
    check_equal(v->kind, SURFACE_V);
    check_equal(u->kind, SURFACE_U);
    check_share(flat->depth, 0.04365, 1e-12);
    check_equal(flat->height, 0);
    check_equal(flat->width, 0.4);
    check_share(v->angle, M_PI / 2, 1e-12);
    check_share(v->height, 4 * 0.04365, 1e-12);
    check_share(u->height, 0.09, 1e-12);
    assert_int_equal(plane->kind, SURFACE_PLANE);
    check_share(plane->normal.z, 1, 1e-15);
    check_share(v3_norm(plane->along), 1, 1e-15);
    check_close(v3_dot(plane->along, plane->normal), 0, 1e-15);
    check_equal(def.line_impact.k, 2e6);
    check_equal(def.line_impact.e, 1);
    check_equal(def.line_impact.c, 5e3);
    scene_def_clear(&def);
}

TEST(stretches_are_checked)
{
    expect_bad(CASE("{ducts: [{from: 2 m, to: 25 m, radius: 75 mm}]}"), NULL, NULL,
               "pull.yaml:8: key 'surfaces.ducts.0.to': 25 m is out of range: must be on the route, at most 19.712");
    expect_bad(CASE("{ducts: [{from: 9 m, to: 8 m, radius: 75 mm}]}"), NULL, NULL,
               "at least 'from' plus 'fade', 9.5 m");
    expect_bad(CASE("{ducts: [{to: 8 m, radius: 75 mm}, {from: 7 m, to: 9 m, radius: 75 mm}]}"), NULL, NULL,
               "key 'surfaces.ducts.1.from': 7 m to 9 m overlaps 'D1', which lies from 0 m to 8 m");
    expect_bad(CASE("{ducts: [{to: 8 m, radius: 75 mm}], trays: [{from: 6 m}]}"), NULL, NULL, "overlaps 'D1'");
    expect_bad(CASE("{ducts: [{to: 8 m, radius: 75 mm, friction: {mu: -0.1}}]}"), NULL, NULL, "out of range");
}

TEST(sizes_are_checked)
{
    expect_bad(
        CASE("{ducts: [{radius: 40 mm}]}"), NULL, NULL,
        "key 'surfaces.ducts.0.radius': 0.04 m is too small: must be above the largest cable's radius, 0.04365 m");
    expect_bad(CASE("{ducts: [{radius: 3.5 m}]}"), NULL, NULL, "must be below the radius of the bend at 10 m, 3 m");
    expect_bad(CASE("{trays: [{width: 80 mm, height: 0.1}]}"), NULL, NULL,
               "key 'surfaces.trays.0.width': 0.08 m is too small: its sides must be farther apart than");
    expect_bad(CASE("{trays: [{width: 7 m}]}"), NULL, NULL, "must be below the radius of the bend");
    expect_bad(CASE("{trays: [{section: u}]}"), NULL, NULL, "key 'surfaces.trays.0.radius': missing");
    expect_bad(CASE("{trays: [{section: u, radius: 4 cm}]}"), NULL, NULL, "is too small");
    expect_bad(CASE("{trays: [{section: v, width: 1 m}]}"), NULL, NULL,
               "not allowed for a tray with this cross-section");
    expect_bad(CASE("{trays: [{angle: 90 deg}]}"), NULL, NULL, "not allowed for a tray with this cross-section");
    expect_bad(CASE("{trays: [{depth: 40 mm}]}"), NULL, NULL, "key 'surfaces.trays.0.depth': 0.04 m is too small");
    expect_bad(CASE("{contact: {e: 1.2}}"), NULL, NULL, "key 'surfaces.contact.k': missing");
}

TEST(planes_are_checked)
{
    expect_bad(CASE("{planes: [{point: [0, 0, -30 mm], normal: [0, 0, 1]}]}"), NULL, NULL,
               "plane 'P1' is inside the cable");
    expect_bad(CASE("{planes: [{point: [0, 0, -1], normal: [0, 0, 0]}]}"), NULL, NULL, "a direction that is not zero");
    expect_bad(CASE("{planes: [{point: [0, 0, -1], normal: [0, 0, 1], along: [0, 0, 2]}]}"), NULL, NULL,
               "key 'surfaces.planes.0.along': the value is a list: expected a direction that is not the normal's");
    SceneDef def;
    /* half of space is behind a plane without ends: the cable cannot be there */
    expect_bad(CASE("{planes: [{point: [0, 0, 2 m], normal: [0, 0, 1]}]}"), NULL, NULL,
               "plane 'P1' is inside the cable: 4.712 m along the route it is -2 m from the line");
    /* a plane that ends before the cable may be as high as it likes, and so may one with ends that the cable is behind
     */
    expect_good(CASE("{planes: [{point: [-30 m, 0, 0], normal: [0, 0, 1], length: 1 m, width: 1 m}]}"), NULL, NULL,
                &def);
    scene_def_clear(&def);
    expect_good(CASE("{planes: [{point: [0, 0, 2 m], normal: [0, 0, 1], width: 1 km}]}"), NULL, NULL, &def);
    scene_def_clear(&def);
}

/* Level sections need a route that is not upright. */
TEST(upright_routes_are_refused)
{
    SceneDef def;
    expect_good(data_text("surfaces-upright"), NULL, NULL, &def);
    scene_def_clear(&def);
    expect_bad(data_text("surfaces-upright"), "surfaces.ducts.0.place", "resting", "steeper than 80 deg at 14.2 m");
}
