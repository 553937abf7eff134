/* The cases that come with the program say what they are meant to say. */
#include "tests/io/case_fixture.h"

#include <glob.h>

#include "io/case/case_parts.h"
#include "theory/closed_form.h"

static const double DEG = 3.14159265358979323846 / 180;

static void load(const char *name, SceneDef *def)
{
    CaseTree *tree;
    hawser_error err;
    if (case_tree_load(name, &tree, &err)) fail_msg("%s", err.message);
    const hawser_status status = case_read(tree, def, &err);
    case_tree_free(tree);
    if (status) fail_msg("%s", err.message);
}

TEST(every_file_is_good)
{
    glob_t files;
    assert_int_equal(glob(HAWSER_SOURCE_DIR "/cases/*.yaml", 0, NULL, &files), 0);
    for (size_t k = 0; k < files.gl_pathc; k++) {
        SceneDef def;
        load(files.gl_pathv[k], &def);
        assert_true(*def.title);
        scene_def_clear(&def);
    }
    check_at_least(files.gl_pathc, 2);
    globfree(&files);
}

TEST(huangjiahu_cable)
{
    SceneDef def;
    load(HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml", &def);
    assert_int_equal(def.pieces[0].segments, 305);
    assert_int_equal(def.pieces[1].segments, 65);
    assert_int_equal(def.pieces[1].swivel, 1);
    assert_int_equal(case_eye(&def), 305);
    check_share(def.cables[0].mass, 46.6710427, 1e-14);
    check_share(profile_value(&def.winch.speed, 13), 0.1, 1e-15);
    check_below(profile_value(&def.winch.speed, 12.9), 0.1);
    check_share(profile_value(&def.tail.tension, def.duration), 15 * 9.8 * def.cables[0].mass, 1e-7);
    check_share(def.drag.force, 5 * 9.8 * def.cables[0].mass, 1e-7);
    check_share(paper_total(def.n_paper, def.paper, def.cables[0].mass, def.friction.mu_d, 9.8), 12903.21, 1e-7);
    assert_int_equal(def.lead_in.present, 1);
    assert_int_equal(def.lead_in.carries_weight, 1);
    scene_def_clear(&def);
}

/* The route of arcs has the length of the paper's path, and its height where the crest arc at D begins. */
TEST(huangjiahu_route)
{
    SceneDef def;
    load(HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml", &def);
    Route route = route_of(&def);
    const double half_crest = 60 * 5 * DEG, D = 4 + half_crest + 21.28577, crest = D - half_crest;
    const double z = -4 * sin(5 * DEG) - 60 * (1 - cos(5 * DEG)) + (21.28577 - half_crest) * sin(10 * DEG);
    check_close(route.length, 58.5, 1e-5);
    check_close(route_at(&route, crest).position.z, z, 5e-7);
    check_share(route_slope(&route, crest - 1e-6), 10 * DEG, 1e-6);
    check_close(route_slope(&route, D + half_crest + 1e-6), 0, 1e-6);
    const double E = D + 19.71424;
    check_close(route_slope(&route, E), -2.5 * DEG, 1e-6);
    check_share(route_slope(&route, 58.5), -5 * DEG, 1e-6);
    check_share(def.head_at, 58.5, 0);
    route_clear(&route);
    scene_def_clear(&def);
}

TEST(huangjiahu_rollers_and_stations)
{
    SceneDef def;
    load(HAWSER_SOURCE_DIR "/cases/huangjiahu.yaml", &def);
    assert_int_equal(def.n_rollers, 32);
    check_share(def.rollers[0].s, 0, 0);
    check_share(def.rollers[31].s, 58.5, 1e-12);
    for (int k = 0; k < 32; k++) check_share(def.rollers[k].rating, 160e3, 0);
    const char *const names[] = {"A", "B", "C", "D", "E", "F"};
    int found = 0;
    for (int k = 0; k < def.n_stations; k++) {
        if (k > 0) check_above(def.stations[k].s, def.stations[k - 1].s);
        if (found < 6 && strcmp(def.stations[k].name, names[found]) == 0) found++;
    }
    assert_int_equal(found, 6);
    assert_int_equal(def.n_stations, 30 + 4); /* every 2 m, A and B among them */
    scene_def_clear(&def);
}

TEST(straight_row)
{
    SceneDef def;
    load(HAWSER_SOURCE_DIR "/cases/straight.yaml", &def);
    const int n = case_segments(&def);
    assert_int_equal(n, 370);
    const double segment_mass = def.cables[0].mass * def.pieces[0].length / n;
    check_share(segment_mass, 11, 1e-15);
    check_share(def.friction.mu_d * segment_mass * 9.81 * n, 7985.34, 1e-9);
    check_share(def.gravity.z, -9.81, 0);
    check_share(def.rollers[1].s - def.rollers[0].s, 2, 1e-12);
    check_share(def.rollers[0].radius, 0.1, 0);
    /* The row begins behind the tail and ends ahead of where the head arrives. */
    const double tail = def.head_at - def.pieces[0].length, travel = profile_integral(&def.winch.speed, def.duration);
    check_below(def.rollers[0].s, tail - 2);
    check_above(def.rollers[def.n_rollers - 1].s, def.head_at + travel + 2);
    int under = 0;
    for (int k = 0; k < def.n_rollers; k++) under += def.rollers[k].s >= tail && def.rollers[k].s <= def.head_at;
    assert_in_range(under, 92, 93);
    scene_def_clear(&def);
}

/* The example at the head of docs/case-format.md works. */
TEST(the_documented_example)
{
    char text[8192];
    SceneDef def;
    FILE *f = fopen(HAWSER_SOURCE_DIR "/docs/case-format.md", "r");
    assert_non_null(f);
    text[fread(text, 1, sizeof text - 1, f)] = 0;
    fclose(f);
    char *start = strstr(text, "```yaml\n") + 8, *end = strstr(start, "```");
    assert_non_null(end);
    *end = 0;
    expect_good(start, NULL, NULL, &def);
    scene_def_clear(&def);
}
