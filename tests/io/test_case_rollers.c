/* Rollers along a route and by coordinates: where they stand, and that none begins inside the cable. */
#include "tests/io/case_fixture.h"

static const double RADIUS = 0.04365; /* of the cable in data_text("smallest"), m */

/* A roller is the sum of the radii from the route at its s, square to the tangent, with a level axis. */
static void stands_right(const Route *route, const RollerDef *roller)
{
    const RoutePoint at = route_at(route, roller->s);
    const Vec3 away = v3_sub(roller->centre, at.position);
    check_share(v3_norm(away), roller->radius + RADIUS, 1e-12);
    check_close(v3_dot(away, at.tangent), 0, 1e-12);
    check_close(roller->axis.z, 0, 1e-12);
    check_share(v3_norm(roller->axis), 1, 1e-12);
    check_close(v3_dot(roller->axis, at.tangent), 0, 1e-12);
    check_equal(away.z > 0, roller->hold_down != 0);
}

TEST(rows_by_count_and_spacing)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers.along", "{count: 11, radius: 80 mm, width: 0.3, rating: 10 kN}", &def);
    assert_int_equal(def.n_rollers, 11);
    for (int k = 0; k < 11; k++) check_share(def.rollers[k].s, 2 * k, 1e-12);
    assert_string_equal(def.rollers[10].name, "R11");
    check_share(def.rollers[3].centre.z, -0.08 - RADIUS, 1e-15);
    check_share(def.rollers[3].width, 0.3, 0);
    check_share(def.rollers[3].rating, 10e3, 0);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along", "{from: -4 m, to: 27.9 m, spacing: 2 m, name: P}", &def);
    assert_int_equal(def.n_rollers, 16);
    check_share(def.rollers[0].centre.x, -4, 0);
    check_share(def.rollers[15].centre.x, 26, 1e-15);
    assert_string_equal(def.rollers[15].name, "P16");
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along", "{from: 3 m, count: 1}", &def);
    assert_int_equal(def.n_rollers, 1);
    check_share(def.rollers[0].s, 3, 0);
    scene_def_clear(&def);
}

TEST(several_rows_and_a_list)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers",
                "{along: [{to: 4 m, spacing: 2 m}, {from: 10 m, count: 3, name: Q, friction: {mu: 0.3}}], "
                "list: [{centre: [0, 0, -1], axis: [0, -3, 0], friction: {mu_s: 0.5}}, "
                "{centre: [0, 0, 1], axis: [0, 1, 1], name: top, radius: 0.2}]}",
                &def);
    assert_int_equal(def.n_rollers, 8);
    assert_string_equal(def.rollers[2].name, "R3");
    assert_string_equal(def.rollers[3].name, "Q4");
    assert_string_equal(def.rollers[6].name, "L1");
    assert_string_equal(def.rollers[7].name, "top");
    check_share(def.rollers[2].friction.mu_d, 0.2, 0);
    check_share(def.rollers[3].friction.mu_s, 0.3, 0);
    check_share(def.rollers[3].friction.mu_d, 0.3, 0);
    check_share(def.rollers[6].friction.mu_s, 0.5, 0);
    check_share(def.rollers[6].friction.mu_d, 0.2, 0);
    check_share(def.rollers[6].axis.y, -1, 0);
    check_share(def.rollers[7].axis.z, sqrt(0.5), 1e-15);
    check_nan(def.rollers[7].s);
    scene_def_clear(&def);
}

static const char BENDS[] =
    "{heading: 40 deg, slope: -5 deg, pieces: [{straight: 3 m}, {bend: 15 deg, radius: 20 m, plane: up}, "
    "{straight: 2 m}, {bend: 30 deg, radius: 9 m, plane: left}, {bend: 30 deg, radius: 8 m, plane: 200 deg}, "
    "{bend: 12 deg, radius: 10 m, plane: down}]}";

/* In bends of all planes, up, to the side and askew. */
TEST(along_bends)
{
    SceneDef def;
    CaseTree *tree;
    hawser_error err;
    assert_int_equal(case_tree_parse(data_text("smallest"), NAME, &tree, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "route", BENDS, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "rollers.along", "{spacing: 0.7, hold_down: sag}", &err), HAWSER_OK);
    if (case_read(tree, &def, &err)) fail_msg("%s", err.message);
    Route route = route_of(&def);
    int held = 0;
    for (int k = 0; k < def.n_rollers; k++) {
        const RollerDef *roller = &def.rollers[k];
        stands_right(&route, roller);
        held += roller->hold_down;
        const double up = route_at(&route, roller->s).curvature.z;
        if (roller->hold_down) {
            check_above(up, 0);
            assert_string_equal(strchr(roller->name, ' '), " above");
        } else if (k + 1 < def.n_rollers && !def.rollers[k + 1].hold_down) {
            check_below(up, 1e-9);
        }
    }
    /* 5.236 m of sag bend, and the left bend of a rising line turns level only */
    assert_in_range(held, 7, 8);
    route_clear(&route);
    scene_def_clear(&def);
    case_tree_free(tree);
}

TEST(held_down_where_asked)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers.along", "{spacing: 2 m, hold_down: [[3.9 m, 8 m], [15 m, 16.5 m]]}",
                &def);
    int held = 0;
    for (int k = 0; k < def.n_rollers; k++) held += def.rollers[k].hold_down;
    assert_int_equal(held, 4); /* at 4, 6, 8 and 16 m */
    assert_int_equal(def.n_rollers, 15);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along", "{spacing: 2 m, hold_down: none}", &def);
    assert_int_equal(def.n_rollers, 11);
    scene_def_clear(&def);
}

/* A roller of 100 mm at height z under, beside or across the line at x = 18 m: the cable lies from 15 to 20 m. */
static void overlap_at(const char *centre, const char *axis, int inside)
{
    char list[200];
    SceneDef def;
    snprintf(list, sizeof list, "[{centre: %s, axis: %s, name: it}]", centre, axis);
    if (inside) {
        expect_bad(data_text("smallest"), "rollers.list", list,
                   "key 'rollers.list.0': roller 'it' is inside the cable");
    } else {
        expect_good(data_text("smallest"), "rollers.list", list, &def);
        scene_def_clear(&def);
    }
}

TEST(rollers_inside_the_cable)
{
    overlap_at("[18, 0, -143.65 mm]", "[0, 1, 0]", 0);
    overlap_at("[18, 0, -142.7 mm]", "[0, 1, 0]", 0); /* less than 1 mm */
    overlap_at("[18, 0, -142.6 mm]", "[0, 1, 0]", 1); /* more */
    overlap_at("[18, 0, 142.6 mm]", "[0, 1, 0]", 1);  /* from above */
    overlap_at("[18, 0, 0]", "[0, 1, 0]", 1);         /* right through */
    overlap_at("[18, 0, -0.05]", "[1, 0, 0]", 1);     /* along the line */
    overlap_at("[18, 0.2, -0.05]", "[1, 0, 0]", 0);
    overlap_at("[18, 0.24, 0]", "[0, 1, 0]", 1); /* its end face */
    overlap_at("[18, 0.25, 0]", "[0, 1, 0]", 0);
    overlap_at("[20.1, 0, 0]", "[0, 1, 0]", 1); /* reaches back to the head */
    overlap_at("[20.2, 0, 0]", "[0, 1, 0]", 0); /* ahead of it */
    overlap_at("[14.8, 0, 0]", "[0, 1, 0]", 0); /* behind the tail */
    overlap_at("[14.9, 0, 0]", "[0, 1, 0]", 1);
}

/* The rope ahead of the eye is thinner: what would be inside the cable is free of the rope. */
TEST(the_rope_is_thinner)
{
    SceneDef def;
    expect_good(data_text("rope-thinner"), "rollers.list",
                "[{centre: [12, 0, -0.11], axis: [0, 1, 0]}, {centre: [4, 0, 0], axis: [0, 1, 0]}, {centre: [16, 0, "
                "0], axis: [0, 1, 0]}]",
                &def);
    scene_def_clear(&def);
    expect_bad(data_text("rope-thinner"), "rollers.list", "[{centre: [12, 0, -0.1], axis: [0, 1, 0]}]",
               "at least the cable's radius, 0.005 m");
    expect_bad(data_text("rope-thinner"), "rollers.list", "[{centre: [9, 0, -0.11], axis: [0, 1, 0]}]",
               "at least the cable's radius, 0.04 m");
    expect_bad(data_text("rope-thinner"), "rollers.list", "[{centre: [6, 0, -0.11], axis: [0, 1, 0]}]",
               "at least the cable's radius, 0.04 m");
}

/* A row whose rollers reach into the next turn of the route is found too, by the row's line. */
TEST(rows_inside_the_cable)
{
    expect_bad(data_text("row-inside"), NULL, NULL, NAME ":10: key 'rollers.along': roller 'R");
}
