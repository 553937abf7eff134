/* Lengths of segments: what the geometry asks for, what too long ones cost, and that runs with them are not trusted;
 * places within a segment. */
#include "tests/io/case_fixture.h"

#include "theory/stiffness.h"

/* A run with segments as given ("auto": by the geometry). */
typedef struct Pulled {
    double pull, expected; /* N; what the lengths are expected to add, a share */
    int segments, found;   /* hawser_verdict */
    char verdict[HAWSER_VERDICT_MAX];
} Pulled;

static Pulled pulled(const char *text, const char *segment)
{
    Pulled out = {.expected = 0};
    hawser_summary sum;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    hawser_sim *const sim = run_of(text, (const char *const[]){"chain.0.segment", segment, NULL});
    hawser_sim_summary(sim, &sum);
    const int n = hawser_sim_limits(sim, limit);
    out.found = hawser_verdict(sum.n_conditions, sum.conditions, n, limit, out.verdict, sizeof out.verdict);
    out.pull = sum.pull_mean_N;
    out.segments = sum.segments;
    for (int i = 0; i < sum.n_conditions; i++) {
        if (!strcmp(sum.conditions[i].name, "mesh")) out.expected = sum.conditions[i].value;
    }
    hawser_sim_free(sim);
    return out;
}

/* The narrow duct of the trust tests at a usual tension. */
static const char *narrow_duct(void)
{
    static char text[2000];
    snprintf(text, sizeof text, "%s", data_with("trust-duct", "radius: 50 mm", "radius: 31 mm"));
    char *const tension = strstr(text, "500 N, ramp");
    assert_non_null(tension);
    memcpy(tension, "2 kN ", 5);
    return text;
}

/* Each scene jams with segments that used to be the default or were given without a word; by the geometry it comes
 * within 1 % of what fine ones give. What is expected of the long ones is right within a factor of two. */
TEST(long_segments_jam)
{
    const struct {
        const char *text, *coarse, *fine;
        double least; /* what the long ones add at least, a share */
    } scene[] = {{narrow_duct(), "500 mm", "100 mm", 0.15},
                 {data_text("mesh-hold-downs"), "1 m", "125 mm", 1.4},
                 {data_text("mesh-s-bends"), "500 mm", "62.5 mm", 0.5}};
    for (int k = 0; k < 3; ++k) {
        const Pulled coarse = pulled(scene[k].text, scene[k].coarse), fine = pulled(scene[k].text, scene[k].fine);
        const Pulled by_itself = pulled(scene[k].text, "auto");
        const double error = coarse.pull / fine.pull - 1;
        print_message("%s: %+.1f %%, expected %+.1f %%; auto, %d segments: %+.2f %%\n", scene[k].coarse, 100 * error,
                      100 * coarse.expected, by_itself.segments, 100 * (by_itself.pull / fine.pull - 1));
        check_at_least(error, scene[k].least);
        check_between(coarse.expected / error, 0.5, 2);
        assert_int_equal(coarse.found, -2);
        check_has(coarse.verdict, "NOT TRUSTED: segments are too long");
        check_at_least(fine.found, 0); /* trusted, whatever the limits of a narrow duct say */
        check_at_least(by_itself.found, 0);
        check_share(by_itself.pull, fine.pull, 0.01);
        check_below(by_itself.segments, fine.segments + 1);
    }
}

/* The mesh of a case as its file says it. */
static SegmentMesh mesh_of(const char *text, const char *key, const char *value, SceneDef *def)
{
    SegmentMesh mesh;
    expect_good(text, key, value, def);
    Route route = route_of(def);
    Supports map = {.def = def, .route = &route};
    if (!def->rod.present) assert_int_equal(supports_build(def, &route, &map, NULL), HAWSER_OK);
    assert_int_equal(mesh_find(&map, &mesh, NULL), HAWSER_OK);
    supports_free(&map);
    route_clear(&route);
    return mesh;
}

/* Longer segments are never expected to be better, and the length for an error has that error. */
TEST(errors_rise_with_length)
{
    static const char *const scenes[] = {"mesh-hold-downs", "mesh-s-bends", "trust-duct", "rod-end"};
    for (int k = 0; k < 4; ++k) {
        SceneDef def;
        SegmentMesh mesh = mesh_of(data_text(scenes[k]), NULL, NULL, &def);
        check_at_least(mesh.n, 1);
        for (int i = 0; i < mesh.n; ++i) {
            double last = 0;
            for (double h = 0.01; h < 2; h *= 1.1) {
                const double error = mesh_error(&mesh.place[i], h);
                check_at_least(error, last);
                last = error;
            }
            const double h = mesh_place_length(&mesh.place[i], 1e-3);
            if (h < MESH_USUAL) check_share(mesh_error(&mesh.place[i], h), 1e-3, 1e-6);
        }
        segment_mesh_free(&mesh);
        scene_def_clear(&def);
    }
}

/* Halving the segments quarters what smooth bends and wheels cost. */
TEST(smooth_places_are_of_second_order)
{
    const MeshPlace wheel = {.radius = 1, .room = NAN, .wrapped = 0.09};
    const MeshPlace bend = {.radius = 3, .room = NAN, .bending_length = 0.5};
    const MeshPlace rod = {.rod_length = 5, .radius = 2, .room = NAN};
    /* sag: of first order for a limp cable, of second (and more) where bending rounds the corner */
    check_share(mesh_sag_error(0.5, 2, 0) / mesh_sag_error(0.25, 2, 0), 2, 1e-12);
    check_at_least(mesh_sag_error(0.1, 2, 1) / mesh_sag_error(0.05, 2, 1), 4);
    check_share(mesh_error(&wheel, 0.2) / mesh_error(&wheel, 0.1), 4, 1e-12);
    check_share(mesh_error(&bend, 0.02) / mesh_error(&bend, 0.01), 4, 0.02);
    check_share(mesh_error(&rod, 0.2) / mesh_error(&rod, 0.1), 4, 1e-12);
}

/* A bend shorter than its rollers' spacing is a turn between two of them (ME11). */
TEST(a_short_bend_is_a_turn)
{
    MeshPlace p = {.radius = 2.3, .length = 0.4, .pitch = 0.4, .room = NAN, .bending_length = 3};
    const double row = mesh_error(&p, 0.2);
    p.pitch = 1.6;
    check_share(mesh_error(&p, 0.2), row / 16, 1e-12);
}

/* What pairs without room press a stiff chain with, and what room is worth (ME12). */
TEST(pairs_bend_stiff_cables)
{
    const double lambda = 1.5, a = 0.5, length = 6.6, radius = 13, mu = 0.3;
    MeshPlace p = {.radius = radius,
                   .length = length,
                   .pitch = a,
                   .room = NAN,
                   .bending_length = lambda,
                   .mu = mu,
                   .tension = 250,
                   .impact = {.k = 0, .e = 1.5}};
    for (double h = 0.1; h < 1; h *= 2) {
        const double x = fmin(h, a), corners = 0.17 * mu * (length / a - 1) * pow(lambda * x, 2) / (radius * pow(a, 3));
        p.room = NAN;
        const double one_side = mesh_error(&p, h);
        p.room = 0;
        check_share(mesh_error(&p, h) - one_side, corners, 1e-9);
        p.room = x * x / (8 * radius); /* as high as the corners stand */
        check_share(mesh_error(&p, h) - one_side, corners / 2, 1e-9);
    }
}

/* A straight segment askew between a pair's rollers (ME13): depths of reach angle^2/2, whose force to the power e is
 * 1/(2 e + 1) of the largest in the mean; room takes of it, and no more presses than turns the segment. */
TEST(askew_segments_are_pressed)
{
    const double mu = 0.2, reach = 0.1, k = 1e7, e = 1.5, h = 0.2, radius = 5, tension = 300;
    MeshPlace p = {.radius = radius,
                   .pitch = 0.5,
                   .room = NAN,
                   .bending_length = 0.5,
                   .mu = mu,
                   .tension = tension,
                   .impact = {.k = k, .e = e}};
    const double none = mesh_error(&p, h), depth = reach * pow(h / (2 * radius), 2) / 2;
    p.pairs = 3;
    p.reach = reach;
    const double askew = mesh_error(&p, h) - none;
    check_share(askew, 2 * mu * 3 * k * pow(depth, e) / (2 * e + 1) / tension, 0.01);
    p.play = 0.5 * depth;
    check_at_most(mesh_error(&p, h) - none, 0.5 * askew);
    p.play = depth;
    check_equal(mesh_error(&p, h), none);
    p.play = 0;
    p.impact.k = 1e30;
    check_share(mesh_error(&p, h) - none, 2 * mu * 3 * 0.75 * (h + 2 * 0.25 / h) / reach, 1e-9);
}

/* What presses on a segment between the rollers of a pair is the radius of a roller and that of the cable, and the play
 * what those of the bend leave: 80 mm and 25 mm here, whose difference was taken for their sum. */
TEST(pairs_reach_by_both_radii)
{
    SceneDef def;
    SegmentMesh mesh = mesh_of(data_text("trust-askew"), NULL, NULL, &def);
    assert_int_equal(mesh.n, 1);
    check_close(mesh.place[0].reach, 0.08 + 0.025, 1e-12);
    check_close(mesh.place[0].play, 0, 1e-4);
    assert_int_equal(mesh.place[0].pairs, 4);
    segment_mesh_free(&mesh);
    scene_def_clear(&def);
}

/* 554 N for 537 N was trusted; no such thing is foretold of a smooth line, and there is none. */
TEST(askew_between_rollers)
{
    const char *const smooth[] = {"contact.geometry", "smooth", "solver.passes", "1", NULL}, *const once[] = {
                                                                                                 "solver.passes", "1",
                                                                                                 NULL};
    hawser_sim *const capsules = run_of(data_text("trust-askew"), once), *const line =
                                                                             run_of(data_text("trust-askew"), smooth);
    hawser_summary a, b;
    hawser_sim_summary(capsules, &a);
    hawser_sim_summary(line, &b);
    check_at_most(a.pull_mean_N - 537, a.pull_mean_error.total);
    check_at_least(a.pull_mean_N - 537, 0.02 * 537);
    check_at_most(fabs(b.pull_mean_N - 537), 0.01 * 537);
    for (int i = 0; i < a.n_conditions; i++)
        if (!strcmp(a.conditions[i].name, "mesh")) assert_false(a.conditions[i].holds);
    for (int i = 0; i < b.n_conditions; i++)
        if (!strcmp(b.conditions[i].name, "mesh")) assert_true(b.conditions[i].holds);
    hawser_sim_free(capsules);
    hawser_sim_free(line);
}

/* The spacing round a bend that has no row of its own: rollers every 2 m, none or one in it, or a wheel. */
TEST(neighbours_say_the_spacing)
{
    const char *const route = "route: {head_at: 20 m, pieces: [{straight: 24 m}]}";
    static const struct {
        const char *bend, *radius;
        double pitch;
    } kind[] = {{"10.5 m", "60 mm", 2}, {"9.8 m", "60 mm", 2}, {"9.8 m", "1.3 m", 0}};
    for (int k = 0; k < 3; ++k) {
        char text[200];
        SceneDef def;
        snprintf(text, sizeof text,
                 "route: {head_at: 20 m, pieces: [{straight: %s}, {bend: 10 deg, radius: 2.3 m, plane: up}, {straight: "
                 "13 m}]}",
                 kind[k].bend);
        SegmentMesh mesh = mesh_of(data_with("trust", route, text), "rollers.along.radius", kind[k].radius, &def);
        assert_int_equal(mesh.n, 1);
        check_close(mesh.place[0].pitch, kind[k].pitch, 1e-9);
        assert_int_equal(mesh.place[0].wrapped > 0, kind[k].pitch <= 0);
        segment_mesh_free(&mesh);
        scene_def_clear(&def);
    }
}

/* A roller that is listed by coordinates counts where the cable reaches it. One that stands 5 m off the cable was taken
 * for one in every short bend: 1 m instead of 2 m. */
TEST(far_rollers_divide_no_spacing)
{
    static const struct {
        const char *list;
        double pitch;
    } kind[] = {{"[{centre: [10.8, 5, 0], axis: [0, 1, 0]}]", 2},
                {"[{centre: [10.75, 0, -0.14], axis: [0, 1, 0]}]", 1}};
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        SegmentMesh mesh = mesh_of(data_with("trust", "route: {head_at: 20 m, pieces: [{straight: 24 m}]}",
                                             "route: {head_at: 20 m, pieces: [{straight: 10.5 m}, {bend: 10 deg, "
                                             "radius: 2.3 m, plane: up}, {straight: 13 m}]}"),
                                   "rollers.list", kind[k].list, &def);
        assert_int_equal(mesh.n, 1);
        check_close(mesh.place[0].pitch, kind[k].pitch, 1e-9);
        segment_mesh_free(&mesh);
        scene_def_clear(&def);
    }
}

/* Shares of a place's tension are shares of the pull in the ratio of the two, at most themselves (EB6). */
TEST(shares_of_a_larger_pull_are_less)
{
    SceneDef def;
    int worst;
    SegmentMesh mesh = mesh_of(data_text("trust-duct"), NULL, NULL, &def);
    const double there = mesh.place[0].tension, full = mesh_given(&mesh, &def, 0, &worst);
    assert_int_equal(mesh.n, 1);
    check_above(full, 0);
    check_share(mesh_given(&mesh, &def, there / 2, &worst), full, 1e-12);
    check_share(mesh_given(&mesh, &def, 4 * there, &worst), full / 4, 1e-12);
    segment_mesh_free(&mesh);
    scene_def_clear(&def);
}

/* A long cable through one tight bend has no more segments than it may, and is not trusted for it. */
TEST(there_is_an_end_to_it)
{
    SceneDef def;
    int worst;
    SegmentMesh mesh = mesh_of(narrow_duct(), "chain", "[{cable: c, length: 20 km}]", &def);
    assert_int_equal(def.pieces[0].segments, MESH_SEGMENTS_MAX);
    check_above(mesh_given(&mesh, &def, 0, &worst), MESH_ALLOWED);
    segment_mesh_free(&mesh);
    scene_def_clear(&def);
}

TEST(check_says_who_asks)
{
    char *text = NULL;
    hawser_case *const c = case_with(narrow_duct(), NULL);
    assert_int_equal(hawser_case_describe(c, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    check_has(text, "bend at 2 m, R 3 m, room 1 mm");
    check_has(text, "too long: the run will not be trusted; chain.0.segment: auto takes");
    hawser_text_free(text);
    hawser_case_free(c);
}

/* A dead axial load and a torque: u(s) = F s/EA and theta(s) = G s/GJ at any place and with any segments; the last half
 * segment had no strain, 5 % of ten segments'. */
TEST(strain_within_a_segment)
{
    static const char *const lengths[] = {"2.5 m", "500 mm", "170 mm"};
    for (int k = 0; k < 3; ++k) {
        hawser_summary sum;
        hawser_sim *const sim =
            run_of(data_text("rod-end"), (const char *const[]){"chain.0.segment", lengths[k], NULL});
        hawser_sim_summary(sim, &sum);
        assert_int_equal(sum.n_probes, 3);
        for (int i = 0; i < 3; ++i) {
            const hawser_probe *const p = &sum.probes[i];
            check_share(p->displacement[0], 1e-3 * p->at, 1e-6);
            check_share(p->rotation[0], 0.1 * p->at, 1e-6);
        }
        hawser_sim_free(sim);
    }
}
