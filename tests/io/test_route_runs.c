/* Runs along curves against theory: a duct round a helix, rollers along a clothoid; a bend on a grade keeps it, slopes
 * of straights are rounded, and coordinates of any size come down to an origin. */
#include "tests/io/case_fixture.h"

#include "hawser/hawser.h"

static void pull_is_theorys(const char *name)
{
    hawser_summary s;
    hawser_sim *const sim = run_of(data_text(name), NULL);
    hawser_sim_summary(sim, &s);
    check_close(s.pull_mean_N / s.reference_total_N, 1, 0.005);
    hawser_sim_free(sim);
}

TEST(runs_round_a_helix) { pull_is_theorys("route-helix"); }

TEST(runs_along_a_clothoid) { pull_is_theorys("route-clothoid"); }

/* 90 deg on 6 deg: no height is lost, unless the bend is told to lie in a plane. */
TEST(bends_keep_their_grade)
{
    static const char *const pieces =
        "[{straight: 20 m, slope: -5 deg}, {bend: 90 deg, radius: 12 m, plane: left%s}, {straight: 30 m, name: out}]";
    char text[256];
    for (int plane = 0; plane < 2; ++plane) {
        SceneDef def;
        snprintf(text, sizeof text, pieces, plane ? ", grade: plane" : "");
        expect_good(data_text("full-route"), "route.pieces", text, &def);
        Route r = route_of(&def);
        const double grade = -5 * M_PI / 180;
        check_close(route_slope(&r, r.length), plane ? 0 : grade, 1e-12);
        if (!plane) check_close(route_at(&r, r.length).position.z, 2 + 50 * sin(grade) + 6 * M_PI * tan(grade), 1e-12);
        route_clear(&r);
        scene_def_clear(&def);
    }
}

/* A surveyor's coordinates: the route begins near zero, and the origin is what was taken off. */
TEST(coordinates_come_down)
{
    SceneDef def;
    expect_good(data_text("full-route-plan"), NULL, NULL, &def);
    check_close(def.route_origin.x, 453000, 0);
    check_close(def.route_origin.y, 6712000, 0);
    check_close(def.route_start.x, 0.25, 0);
    check_close(def.route_start.y, 345.5, 0);
    check_close(def.route_start.z, 50 + 10.0 / 35, 1e-13);
    scene_def_clear(&def);
    expect_bad(data_text("full-route"), "route.pieces.1.straight", "4 m", "too short for the changes of slope");
    expect_bad(data_text("full-route"), "route.pieces.0.radius", "4 m", "not allowed in a 'straight' piece");
    expect_bad(data_text("full-route-plan"), "route.profile.corners.2.parabola", "60 m",
               "is too short for the roundings");
    expect_bad(data_text("full-route-points"), "route.radius", "40 m", "too near for a radius");
}
