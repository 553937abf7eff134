/* Routes out of files: one line in five formats, pulls along it, the real files' own figures, what is wrong with a
 * case that names a file. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/vec3.h"
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

#define ROUTES HAWSER_SOURCE_DIR "/cases/routes/"

static hawser_routes *routes_of(const char *path, const hawser_route_options *options)
{
    hawser_routes *r = NULL;
    hawser_error err = {0};
    if (hawser_routes_read(path, options, &r, &err)) fail_msg("%s", err.message);
    return r;
}

static hawser_route_place place(hawser_routes *r, int i, double s)
{
    hawser_route_place p;
    hawser_error err;
    if (hawser_routes_at(r, i, s, &p, &err)) fail_msg("%s", err.message);
    return p;
}

static double apart(const double a[3], const double b[3]) { return v3_norm(v3_sub(v3_get(a), v3_get(b))); }

#ifdef __SANITIZE_ADDRESS__
enum { UNDER_SANITIZERS = 1 };
#else
enum { UNDER_SANITIZERS = 0 };
#endif

/* LandXML, IFC, a table, and a drawing in plan with a table of heights: within 5 mm along the whole length. */
TEST(formats_agree)
{
    static const char *const files[] = {ROUTES "tunnel.ifc", ROUTES "tunnel.csv", ROUTES "tunnel.dxf"};
    hawser_routes *const one = routes_of(ROUTES "tunnel.xml", NULL);
    double length, other;
    assert_int_equal(hawser_routes_length(one, 0, &length, NULL), HAWSER_OK);
    check_close(length, 132.028, 1e-3);
    for (int f = 0; f < 3; ++f) {
        hawser_route_options options = hawser_route_defaults();
        hawser_route_figures figures;
        double worst = 0;
        if (f == 2) {
            options.layer = "CENTRE";
            options.profile = ROUTES "tunnel-profile.csv";
        }
        hawser_routes *const r = routes_of(files[f], &options);
        assert_int_equal(hawser_routes_count(r), 1);
        assert_int_equal(hawser_routes_length(r, 0, &other, NULL), HAWSER_OK);
        check_close(other, length, 1e-3);
        for (double s = 0; s < length; s += 0.25)
            worst = larger_of(worst, apart(place(one, 0, s).position_m, place(r, 0, s).position_m));
        check_below(worst, f == 2 ? 1e-3 : 1e-4);
        assert_int_equal(hawser_routes_figures(r, 0, &figures, NULL), HAWSER_OK);
        check_close(figures.least_radius_m, 15, 1e-3);
        check_close(figures.length_m, length, 1e-3);
        assert_int_equal(figures.fitted, f == 2);
        hawser_routes_free(r);
    }
    hawser_routes_free(one);
}

/* Tangent and curvature are the position's derivatives, and the curvature that of the elements. */
TEST(places_hang_together)
{
    const double h = 1e-3;
    hawser_routes *const r = routes_of(ROUTES "tunnel.xml", NULL);
    for (double s = 1; s < 131; s += 1.7) {
        const hawser_route_place a = place(r, 0, s - h), p = place(r, 0, s), b = place(r, 0, s + h);
        for (int c = 0; c < 3; ++c) {
            check_close((b.position_m[c] - a.position_m[c]) / (2 * h), p.tangent[c], 2e-6);
            check_close((b.tangent[c] - a.tangent[c]) / (2 * h), p.curvature_per_m[c], 1e-4);
        }
    }
    check_close(v3_norm(v3_get(place(r, 0, 50).curvature_per_m)), 0.05, 1e-4);
    hawser_routes_free(r);
}

/* Station 20 m to 60 m, from end to start. */
TEST(parts_are_cut_and_turned)
{
    hawser_route_options options = hawser_route_defaults();
    hawser_route_figures f;
    hawser_routes *const whole = routes_of(ROUTES "tunnel.xml", NULL);
    options.from_m = 20;
    options.to_m = 60;
    options.reverse = 1;
    hawser_routes *const r = routes_of(ROUTES "tunnel.xml", &options);
    assert_int_equal(hawser_routes_figures(r, 0, &f, NULL), HAWSER_OK);
    check_close(f.horizontal_length_m, 40, 1e-9);
    assert_int_equal(f.pieces, 3);
    double length;
    assert_int_equal(hawser_routes_length(r, 0, &length, NULL), HAWSER_OK);
    check_close(length, f.length_m, 1e-6);
    /* the plan's 20 m lie 20 m sqrt(1 + 0.03^2) along the whole */
    const double begin = 20 * sqrt(1 + 9e-4);
    for (double s = 0; s <= length; s += 1)
        check_below(apart(place(r, 0, s).position_m, place(whole, 0, begin + length - s).position_m), 1e-5);
    hawser_error err;
    hawser_routes *none;
    options.to_m = 132.005; /* the line ends at 132 m: rounding */
    assert_int_equal(hawser_routes_read(ROUTES "tunnel.xml", &options, &none, &err), HAWSER_OK);
    hawser_routes_free(none);
    options.to_m = 150;
    assert_int_equal(hawser_routes_read(ROUTES "tunnel.xml", &options, &none, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "m: it cannot be used from 20 m to 150 m");
    options.from_m = 140;
    assert_int_equal(hawser_routes_read(ROUTES "tunnel.xml", &options, &none, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "reaches from station 0 m to");
    hawser_routes_free(whole);
    hawser_routes_free(r);
}

/* The example cases: a verdict, and a short run that ends near theory. */
TEST(examples_are_pulled)
{
    static const char *const names[] = {"landxml", "ifc", "dxf", "csv", "geojson", "gpx"};
    double first = 0;
    for (int i = 0; i < 6; ++i) {
        char name[40];
        snprintf(name, sizeof name, "routes/tunnel-%s", names[i]);
        Outcome o = example_run(name, NULL);
        check_close(o.summary.pull_mean_N / o.summary.reference_total_N, 1, 0.02);
        if (i == 0) first = o.summary.pull_mean_N;
        check_share(o.summary.pull_mean_N, first, i >= 4 ? 0.01 : 1e-3);
        hawser_sim_free(o.sim);
    }
}

/* Arcs with their places: the file's own without an uncertainty, those of a track's points with one. */
TEST(bends_are_listed)
{
    static const char *const files[] = {ROUTES "tunnel.xml", ROUTES "tunnel.gpx"};
    for (int f = 0; f < 2; ++f) {
        hawser_routes *const r = routes_of(files[f], NULL);
        hawser_route_bend *bend;
        hawser_error err;
        int n;
        assert_int_equal(hawser_routes_bends(r, 0, &n, &bend, &err), HAWSER_OK);
        assert_int_equal(n, 2);
        check_close(bend[0].station_m, 38, 0.1);
        check_close(bend[0].radius_m, 20, 0.01);
        check_close(bend[1].radius_m, 15, 0.01);
        check_close(bend[1].turn, -14 / 15.0, 1e-3);
        for (int i = 0; i < 2; ++i) {
            if (f == 0) assert_true(isnan(bend[i].radius_sd_m));
            if (f == 1) check_close(bend[i].radius_sd_m, 0.0015, 0.0014); /* points to the millimetre */
        }
        hawser_route_bends_free(bend);
        assert_int_equal(hawser_routes_bends(r, 1, &n, &bend, &err), HAWSER_ERR_INPUT);
        assert_int_equal(n, 0);
        assert_null(bend);
        hawser_routes_free(r);
    }
}

/* A route of more pieces than a case can have is refused, at once. */
TEST(cases_have_bounds)
{
    char path[] = "/tmp/hawser-pieces-XXXXXX", text[600];
    const int fd = mkstemp(path);
    assert_true(fd >= 0);
    FILE *const to = fdopen(fd, "w");
    fputs("length (m),angle (deg),radius (m),turn\n", to);
    for (int i = 0; i < 30000; ++i) fputs("2,,,\n,10,5,left\n", to);
    fclose(to);
    snprintf(text, sizeof text,
             "cables: {c: {d: 50 mm, mass: 4 kg/m, EA: 80 MN, GA: 10 MN, GJ: 2 kN m2, EI: 2 kN m2}}\n"
             "chain: [{cable: c, length: 30 m}]\ndrive: {winch: {speed: 0.1 m/s}}\nrun: {duration: 10 s}\n"
             "route: {file: %s}\n",
             path);
    char case_path[64];
    snprintf(case_path, sizeof case_path, "%s.yaml", path);
    FILE *const c = fopen(case_path, "w");
    fputs(text, c);
    fclose(c);
    hawser_case *loaded = NULL;
    hawser_error err;
    assert_int_equal(hawser_case_load(case_path, &loaded, &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(loaded, &err), HAWSER_ERR_INPUT);
    hawser_case_free(loaded);
    check_has(err.message, "has 60000 pieces, and a case's route at most 50000");
    unlink(path);
    unlink(case_path);
}

/* Twenty rows and fewer than fifteen lines of YAML give a verdict. */
TEST(a_table_is_enough)
{
    const char *const path = HAWSER_SOURCE_DIR "/cases/theory/route-table.yaml";
    int lines = 0, rows = -1;
    char line[400], *text = NULL;
    FILE *f = fopen(path, "r");
    while (fgets(line, sizeof line, f)) lines += *line != '#';
    fclose(f);
    f = fopen(HAWSER_SOURCE_DIR "/cases/theory/route-table.csv", "r");
    while (fgets(line, sizeof line, f)) rows++;
    fclose(f);
    assert_int_equal(rows, 20);
    check_below(lines, 15);
    hawser_case *c;
    hawser_error err;
    if (hawser_case_load(path, &c, &err)) fail_msg("%s", err.message);
    if (hawser_case_theory(c, HAWSER_TABLE, &text, &err)) fail_msg("%s", err.message);
    check_has(text, "SAFE: ");
    check_has(text, "yard"); /* a row's name is its piece's */
    check_has(text, "length of the route            644.9 m");
    hawser_text_free(text);
    hawser_case_free(c);
}

/* Millimetres although the drawing says metres, heights drawn on another layer, cut and turned around; the route
 * begins at the drawing's 19 m. */
TEST(a_drawing_in_a_case)
{
    SceneDef def;
    expect_good(data_text("full-route-file"), NULL, NULL, &def);
    Route r = route_of(&def);
    check_vec(route_at(&r, 0).position, v3(19, 0, 5.95), 1e-6);
    check_vec(route_at(&r, r.length).position, v3(1, 0, 5.05), 1e-6);
    check_close(r.length, 18 * sqrt(1 + 0.05 * 0.05), 1e-6);
    route_clear(&r);
    scene_def_clear(&def);
    /* without the profile it is level where the case says */
    expect_good(data_with("full-route-file",
                          "  profile:\n    file: route.dxf\n    name: HEIGHTS\n    layer: HEIGHTS\n    units: mm\n",
                          ""),
                NULL, NULL, &def);
    Route level = route_of(&def);
    check_vec(route_at(&level, 0).position, v3(19, 0, 2), 1e-6);
    route_clear(&level);
    scene_def_clear(&def);
    expect_bad(data_text("full-route-file"), "route.radius", "1 m", "has a profile: a 'radius'");
}

/* A northing of 6.7e6 m comes down to an origin, which coordinates of the case count from too. */
TEST(large_coordinates)
{
    CaseTree *tree;
    hawser_error err;
    SceneDef def;
    assert_int_equal(case_tree_load(ROUTES "tunnel-landxml.yaml", &tree, &err), HAWSER_OK);
    if (case_read(tree, &def, &err)) fail_msg("%s", err.message);
    check_vec(def.route_origin, v3(453000, 6712000, 0), 0);
    check_vec(def.route_start, v3(120.25, 310.5, 12), 1e-6);
    scene_def_clear(&def);
    case_tree_free(tree);
}

TEST(wrong_cases)
{
    const char *const text = data_text("full-route-file");
    static const char *const wrong[][3] = {
        {"route.file", "none.dxf", "none.dxf"},
        {"route.file", "full-route.yaml", "full-route.yaml:"},
        {"route.layer", "WALLS", "no line of the name 'centre' on layer 'WALLS'; there are 'CENTRE'"},
        {"route.units", "kg", "'kg' is no unit of length"},
        {"route.pieces", "[{straight: 5 m}]", "two kinds at once"},
        {"route.slope", "1 deg", "not with 'file'"},
        {"route.from", "25 m", "reaches from station 0 m to 20 m"},
        {"route.profile", "[{station: 0, height: 0}, {station: 9, height: 0}]", "a map that names another file"},
        {"route.profile.layer", "CENTRE", "no line of the name 'HEIGHTS' on layer 'CENTRE'"},
        {"route.profile.corners", "[{station: 0, height: 0}]", "they belong to a 'plan'"},
    };
    for (size_t k = 0; k < sizeof wrong / sizeof *wrong; ++k) expect_bad(text, wrong[k][0], wrong[k][1], wrong[k][2]);
    expect_bad(text, "route.profile.layer", "CENTRE", "'route.file'");
    hawser_error err;
    hawser_case *const c = case_with(text, NULL);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, NAME ":14: key 'route.file': value 'route.dxf': a case that is a text has no folder");
    hawser_case_free(c);
}

/* What of a file is not in the route is said where the case is looked at: a gap cuts the line off. */
TEST(what_is_not_in_the_route)
{
    char folder[] = "/tmp/hawser-route-XXXXXX", path[80], name[80];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/gap.dxf", folder);
    snprintf(name, sizeof name, "%s/case.yaml", folder);
    FILE *f = fopen(path, "w");
    fputs("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n", f);
    for (int k = 0; k < 2; ++k)
        fprintf(f, "0\nLINE\n8\nA\n10\n%g\n20\n0\n11\n%g\n21\n0\n", k ? 300.02 : 0, k ? 320.0 : 300.0);
    fputs("0\nENDSEC\n0\nEOF\n", f);
    fclose(f);
    f = fopen(name, "w");
    fputs("cables: {c: {d: 90 mm, mass: 20 kg/m}}\nroute: {file: gap.dxf}\nrollers: {along: [{spacing: 2 m}]}\n"
          "friction: {mu: 0.2}\nlimits: {pull: 30 kN}\n",
          f);
    fclose(f);
    hawser_case *c = NULL;
    hawser_error err;
    char *theory = NULL, *check = NULL, *shown = NULL;
    static const hawser_theory_options terminal = {.width = 80};
    assert_int_equal(hawser_case_load(name, &c, &err), HAWSER_OK);
    if (hawser_case_theory(c, HAWSER_JSON, &theory, &err)) fail_msg("%s", err.message);
    if (hawser_case_theory_shown(c, HAWSER_TABLE, &terminal, &shown, NULL, &err)) fail_msg("%s", err.message);
    if (hawser_case_describe(c, HAWSER_JSON, &check, &err)) fail_msg("%s", err.message);
    check_has(theory, "not in the route, of its file: gap of 0.02 m at 300.0");
    check_has(check, "\"not read\"");
    check_has(shown, "not read       gap of 0.02 m at 300.0"); /* above the verdict */
    hawser_text_free(shown);
    hawser_text_free(theory);
    hawser_text_free(check);
    hawser_case_free(c);
    unlink(path);
    unlink(name);
    rmdir(folder);
}

/* Corners of straights that are drawn one by one get the radius that the case asks for, at the height that it says; a
 * line that has heights wants none. */
TEST(corners_of_straights)
{
    char folder[] = "/tmp/hawser-route-XXXXXX", path[80], name[80];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/corner.dxf", folder);
    snprintf(name, sizeof name, "%s/case.yaml", folder);
    for (int high = 0; high < 2; ++high) {
        FILE *f = fopen(path, "w");
        fputs("0\nSECTION\n2\nHEADER\n9\n$INSUNITS\n70\n6\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n", f);
        fprintf(f, "0\nLINE\n8\nA\n10\n0\n20\n0\n30\n%d\n11\n10\n21\n0\n31\n%d\n", high, 2 * high);
        fprintf(f, "0\nLINE\n8\nA\n10\n10\n20\n0\n30\n%d\n11\n10\n21\n10\n31\n%d\n", 2 * high, 3 * high);
        fputs("0\nENDSEC\n0\nEOF\n", f);
        fclose(f);
        f = fopen(name, "w");
        fputs("cables: {c: {d: 90 mm, mass: 20 kg/m}}\nroute: {file: corner.dxf, radius: 2 m, height: 3 m}\n", f);
        fclose(f);
        CaseTree *tree;
        hawser_error err;
        SceneDef def;
        assert_int_equal(case_tree_load(name, &tree, &err), HAWSER_OK);
        const hawser_status status = case_read(tree, &def, &err);
        assert_int_equal(status, high ? HAWSER_ERR_INPUT : HAWSER_OK);
        if (high) check_has(err.message, "has heights of its own: a 'height' is for a line without");
        if (!high) {
            Route r = route_of(&def);
            check_close(r.length, 20 - 2 * 2 + 2 * M_PI / 2, 1e-9);
            check_vec(route_at(&r, 0).position, v3(0, 0, 3), 1e-9);
            check_vec(route_at(&r, r.length).position, v3(10, 10, 3), 1e-9);
            route_clear(&r);
        }
        if (!status) scene_def_clear(&def);
        case_tree_free(tree);
    }
    unlink(path);
    unlink(name);
    rmdir(folder);
}

/* Of a table's row the file's line is named, beside the case's. */
TEST(both_lines_are_named)
{
    char folder[] = "/tmp/hawser-route-XXXXXX", path[80], name[80];
    assert_non_null(mkdtemp(folder));
    snprintf(path, sizeof path, "%s/route.csv", folder);
    snprintf(name, sizeof name, "%s/case.yaml", folder);
    FILE *f = fopen(path, "w");
    fputs("length (m),angle (deg),radius (m),turn\n10,,,\n,30,,left\n", f);
    fclose(f);
    f = fopen(name, "w");
    fputs("cables: {c: {d: 50 mm, mass: 4 kg/m}}\nroute: {file: route.csv}\n", f);
    fclose(f);
    hawser_case *c = NULL;
    hawser_error err;
    assert_int_equal(hawser_case_load(name, &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "case.yaml:2: key 'route.file': ");
    check_has(err.message, "route.csv:3: a bend needs a radius");
    hawser_case_free(c);
    unlink(path);
    unlink(name);
    rmdir(folder);
}

/* A drawing of 100 000 lines that do not meet, on two layers: what is known of each line takes 1 kB, not errors and
 * fits that nobody asked for. Read by a child, whose largest memory is its own. */
TEST(many_lines_in_little_memory)
{
    enum { LINES = 100000 };
    char path[] = "/tmp/hawser-route-XXXXXX";
    FILE *const f = fdopen(mkstemp(path), "w");
    assert_non_null(f);
    fputs("0\nSECTION\n2\nENTITIES\n", f);
    for (int i = 0; i < LINES; ++i)
        fprintf(f, "0\nLINE\n8\n%c\n10\n%d\n20\n%d\n11\n%d.5\n21\n%d\n", "AB"[i % 2], i % 300 * 9, i / 300 * 9,
                i % 300 * 9, i / 300 * 9);
    fputs("0\nENDSEC\n0\nEOF\n", f);
    fclose(f);
    const pid_t child = fork();
    if (child == 0) {
        struct rusage at_first, now;
        hawser_routes *r = NULL;
        hawser_error err;
        char *text = NULL;
        getrusage(RUSAGE_SELF, &at_first);
        const hawser_status status = hawser_routes_read(path, NULL, &r, &err);
        const int all = !status && hawser_routes_count(r) == LINES;
        const int said = all && hawser_routes_describe(r, HAWSER_JSON, &text, &err) == HAWSER_OK;
        getrusage(RUSAGE_SELF, &now);
        const long most = UNDER_SANITIZERS ? 2000 * 1024L : 200 * 1024L; /* kB; they keep what is freed */
        _exit(!said ? 1 : now.ru_maxrss - at_first.ru_maxrss < most ? 0 : 2);
    }
    int how = -1;
    assert_int_equal(waitpid(child, &how, 0), child);
    unlink(path);
    assert_true(WIFEXITED(how));
    assert_int_equal(WEXITSTATUS(how), 0);
}

/* ------------------------------------------------------------------------------------------- the real files */

/* The path of a real file; the test is skipped without it. */
static const char *real_file(const char *name, char path[1024])
{
    const char *const given = getenv("HAWSER_ROUTES");
    snprintf(path, 1024, "%s/%s", given ? given : HAWSER_SOURCE_DIR "/../shared/routes", name);
    if (access(path, R_OK)) {
        print_message("no %s: skipped\n", path);
        skip();
    }
    return path;
}

static hawser_routes *shared(const char *name, const char *profile)
{
    char path[1024], heights[1024];
    hawser_route_options options = hawser_route_defaults();
    if (profile) options.profile = real_file(profile, heights);
    return routes_of(real_file(name, path), &options);
}

/* Lengths and ends within 1 mm of the files' own figures. */
TEST(shared_figures)
{
    static const double tramway[] = {108.360853736, 14.566530746, 47.349749727, 14.578784415,
                                     58.981749834,  39.724959032, 9.190333403};
    hawser_routes *r = shared("cabling-civil3d.landxml.xml", NULL);
    hawser_route_figures f;
    assert_int_equal(hawser_routes_count(r), 7);
    for (int i = 0; i < 7; ++i) {
        assert_int_equal(hawser_routes_figures(r, i, &f, NULL), HAWSER_OK);
        check_close(f.horizontal_length_m, tramway[i], 1e-3);
        assert_null(f.problem);
        check_below(f.deviation_max_m, 0.05);
    }
    assert_int_equal(hawser_routes_figures(r, 0, &f, NULL), HAWSER_OK);
    check_below(hypot(f.start_m[0] - 1892028.4500, f.start_m[1] - 3126573.3474), 1e-3);
    check_below(hypot(f.end_m[0] - 1891982.8940, f.end_m[1] - 3126671.4206), 1e-3);
    hawser_routes_free(r);
    r = shared("stn01.landxml.xml", NULL);
    assert_int_equal(hawser_routes_figures(r, 0, &f, NULL), HAWSER_OK);
    check_close(f.horizontal_length_m, 1029.3720712725, 1e-3);
    check_below(hypot(f.start_m[0] - 452270.18825, f.start_m[1] - 4539403.94736), 1e-3);
    check_below(hypot(f.end_m[0] - 453202.52411, f.end_m[1] - 4539831.92869), 1e-3);
    hawser_routes_free(r);
    r = shared("tunnel-alignment.ifc", NULL);
    assert_int_equal(hawser_routes_figures(r, 0, &f, NULL), HAWSER_OK);
    check_close(f.horizontal_length_m, 705.7206, 1e-3);
    assert_int_equal(f.pieces, 12);
    check_below(f.deviation_max_m, 1e-3);
    hawser_routes_free(r);
}

/* The railway's tables of plan and profile are its LandXML within 5 mm along the whole length. */
TEST(shared_tables_agree)
{
    hawser_routes *const a = shared("stn01.landxml.xml", NULL), *const b = shared("stn01-horizontal.csv",
                                                                                  "stn01-vertical.csv");
    double length, worst = 0;
    assert_int_equal(hawser_routes_length(a, 0, &length, NULL), HAWSER_OK);
    for (double s = 0; s <= length; s += 2)
        worst = larger_of(worst, apart(place(a, 0, s).position_m, place(b, 0, s).position_m));
    check_below(worst, 5e-3);
    hawser_routes_free(a);
    hawser_routes_free(b);
}

/* A pull along each kind of real alignment: the tramway's with a corner of its profile rounded, the road tunnel's and
 * railway's first 100 m, which its stations count from -153.1 m on, and the same as tables. Near theory; where a
 * profile changes its grade every few metres, a stiff cable presses its rollers by more than its weight, which theory
 * has not: 4 %. */
TEST(shared_files_are_pulled)
{
    static const struct {
        const char *file, *profile, *name, *to;
    } pulls[] = {{"cabling-civil3d.landxml.xml", NULL, "A1", "100 m"},
                 {"cabling-civil3d.landxml.xml", NULL, "A5", "58 m"},
                 {"tunnel-alignment.ifc", NULL, "Alignment", "200 m"},
                 {"stn01.landxml.xml", NULL, "Asse_BP", "-53.1 m"},
                 {"stn01-horizontal.csv", "stn01-vertical.csv", "stn01-horizontal", "100 m"}};
    double railway = 0;
    for (size_t i = 0; i < sizeof pulls / sizeof *pulls; ++i) {
        char path[1024], heights[1024];
        const char *settings[12] = {
            "route.file", real_file(pulls[i].file, path), "route.name", pulls[i].name, "route.to", pulls[i].to};
        if (pulls[i].profile) {
            settings[6] = "route.profile.file";
            settings[7] = real_file(pulls[i].profile, heights);
        }
        Outcome o = example_run("routes/tunnel-landxml", settings);
        check_close(o.summary.pull_mean_N / o.summary.reference_total_N, 1, i < 3 ? 0.06 : 0.02);
        if (i == 3) railway = o.summary.pull_mean_N;
        if (i == 4) check_share(o.summary.pull_mean_N, railway, 1e-3);
        hawser_sim_free(o.sim);
    }
}
