/* Models of the environment in a case: their place in each of its ways, equipment from their parts, and clearances
 * against closed forms, in theory and in a run. */
#include "tests/io/case_fixture.h"
#include "tests/support/scratch.h"
#include "theory/mend.h"

TEST_GROUP(scratch_make, scratch_remove)

static const char MODEL[] = HAWSER_SOURCE_DIR "/tests/data/model.stl";

/* A level cable of 60 mm along x, 20 m, and the models; more: further sections. */
static const char *text_of(const char *environment, const char *more)
{
    static char text[3000];
    snprintf(text, sizeof text,
             "cables: {c: {EA: 1 MN, GA: 1 MN, GJ: 1 kN m2, EI: 1 kN m2, d: 60 mm, mass: 5 kg/m}}\n"
             "route: {start: [1000 m, 2000 m, 30 m], pieces: [{straight: 20 m}]}\n"
             "drive: {winch: {speed: 0.1 m/s, ramp: none}, tail: {tension: 1 kN, ramp: none}}\n"
             "run: {duration: 1 s}\n"
             "limits: {clearance_environment: 100 mm}\n"
             "environment: %s\n%s",
             environment, more);
    return text;
}

/* The same as a file with a text model, NAME, beside it. */
static const char *model_of(const char *keys)
{
    static char one[1500];
    snprintf(one, sizeof one, "[{file: '%s', unit: 1 mm, up: z, %s}]", MODEL, keys);
    return one;
}

static void read_good(const char *keys, SceneDef *def) { expect_good(text_of(model_of(keys), ""), NULL, NULL, def); }

/* The model's wall is a box of 1 m, 0.2 m and 3 m with a corner at its origin; its roller one of 0.1 m, 0.4 m and 0.1 m
 * with its middle at (5.05, 0, -0.11). */
static Vec3 least_corner(const SceneDef *def)
{
    Vec3 low = v3(INFINITY, INFINITY, INFINITY);
    const Mesh *const m = &def->environment.mesh;
    for (int v = 0; v < m->n_vertices; ++v)
        low = v3(fmin(low.x, m->vertex[v][0]), fmin(low.y, m->vertex[v][1]), fmin(low.z, m->vertex[v][2]));
    return low;
}

TEST(places_agree)
{
    static const char *const ways[] = {
        "layers: [wall], at: [1004 m, 2001 m, 30 m], turn: 90 deg",
        "layers: [wall], along: 4 m, from: [-1 m, 0 m, 0 m], turn: 90 deg",
        "layers: [wall], points: [{model: [0 m, 0 m, 0 m], world: [1004 m, 2001 m, 30 m]}, "
        "{model: [2 m, 0 m, 0 m], world: [1004 m, 2003 m, 30 m]}]"};
    for (int k = 0; k < 3; ++k) {
        SceneDef def;
        read_good(ways[k], &def);
        assert_int_equal(def.environment.mesh.n_triangles, 12);
        check_close(mesh_area(&def.environment.mesh), 2 * (0.2 + 3 + 0.6), 1e-12);
        check_close(mesh_volume(&def.environment.mesh), 0.6, 1e-12);
        /* turned to the left: 0.2 m behind its corner */
        check_vec(v3_add(least_corner(&def), def.route_origin), v3(1003.8, 2001, 30), 1e-9);
        scene_def_clear(&def);
    }
    expect_bad(text_of(model_of("points: [{model: [0 m, 0 m, 0 m], world: [1004 m, 2001 m, 30 m]}, {model: [2 m, 0 m, "
                                "0 m], world: [1004 m, 2006 m, 30 m]}]"),
                       ""),
               NULL, NULL, "the points are 2 m apart in the model");
    expect_bad(text_of(model_of("at: [0 m, 0 m, 0 m], along: 3 m"), ""), NULL, NULL, "beside 'at': give one of them");
    expect_bad(text_of(model_of("along: 21 m"), ""), NULL, NULL, "must be on the route, at most 20 m");
    expect_bad(text_of(model_of("layers: [nothing]"), ""), NULL, NULL, "no triangles are taken from it");
    char file[600];
    snprintf(file, sizeof file, "[{file: '%s'}]", MODEL);
    expect_bad(text_of(file, ""), NULL, NULL, "an STL file does not say its unit of length: give 'unit'");
}

TEST(parts_become_equipment)
{
    SceneDef def, hand;
    read_good("leave: [wall], along: 2 m, equipment: {roller*: {rollers: {radius: 50 mm, width: 300 mm}}}", &def);
    expect_good(text_of("[]", "rollers: {along: {at: [7.05 m], radius: 50 mm, width: 300 mm, name: roller 1}}"), NULL,
                NULL, &hand);
    assert_int_equal(def.environment.mesh.n_triangles, 0);
    assert_int_equal(def.n_rollers, 1);
    assert_string_equal(def.rollers[0].name, "roller 1");
    check_vec(def.rollers[0].centre, hand.rollers[0].centre, 1e-9);
    assert_string_equal(def.drawn[0].layer, "roller*");
    assert_int_equal(def.drawn[0].placed, 1);
    scene_def_clear(&def);
    scene_def_clear(&hand);
    expect_bad(text_of(model_of("at: [1000 m, 2005 m, 30 m], equipment: {roller*: {rollers: {radius: 50 mm}}}"), ""),
               NULL, NULL, "is 5 m from the route, nearest at 5.05 m along it");
}

/* Clearances of the layers in theory's forward pull; near: [n]. Clears the definition. Returns the tension at s (m), N.
 */
static double near_of(SceneDef *def, int n, LayerNear *near, double s)
{
    static const Company none;
    Solved solved;
    hawser_error err;
    if (solved_make(def, &none, 1, &solved, &err)) fail_msg("%s", err.message);
    assert_int_equal(solved.def.environment.mesh.n_layers, n);
    assert_non_null(solved.c.near[PLAN_FORWARD]);
    memcpy(near, solved.c.near[PLAN_FORWARD], (size_t)n * sizeof *near);
    const double tension = pull_at(&solved.c.plan.way[PLAN_FORWARD].pull, s).tension;
    solved_free(&solved);
    return tension;
}

/* Distances of a straight cable from a box: beside it, past its corner, overlapping it; what is not to be kept clear
 * of, and what is farther than theory looks. */
TEST(clearance_of_a_box)
{
    static const struct {
        const char *at;
        double clearance, s;
    } kind[] = {{"[1004 m, 2000.5 m, 29 m]", 0.5 - 0.03, NAN},     /* all of its length is as near */
                {"[1004 m, 2000.3 m, 30.4 m]", 0.5 - 0.03, NAN},   /* its lower edge: 0.3, 0.4 */
                {"[1004 m, 1999.9 m, 30.02 m]", 0.02 - 0.03, NAN}, /* above: it overlaps */
                {"[1020.4 m, 2000.3 m, 29 m]", 0.5 - 0.03, 20},    /* beyond the end */
                {"[1004 m, 2006 m, 30 m]", INFINITY, NAN}};
    for (size_t k = 0; k < sizeof kind / sizeof *kind; ++k) {
        SceneDef def;
        LayerNear near;
        char keys[200];
        snprintf(keys, sizeof keys, "layers: [wall], at: %s", kind[k].at);
        read_good(keys, &def);
        near_of(&def, 1, &near, 0);
        if (isinf(kind[k].clearance))
            check_infinite(near.distance);
        else
            check_close(near.distance, kind[k].clearance, 1e-9);
        if (!isnan(kind[k].s)) check_close(near.s, kind[k].s, 1e-9);
    }
}

/* In a bend of 6 m about (1000, 2006) an upright edge is 3 m and 4.2 m from the centre; chords are within 0.1 mm. */
TEST(clearance_in_a_bend)
{
    SceneDef def;
    LayerNear near;
    expect_good(text_of(model_of("layers: [wall], at: [1003 m, 2002 m, 29 m], turn: 180 deg"), ""), "route.pieces",
                "[{bend: 90 deg, radius: 6 m, plane: left}]", &def);
    near_of(&def, 1, &near, 0);
    check_close(near.distance, 6 - hypot(3, 4.2) - 0.03, 1e-4);
    check_close(near.s, 6 * atan2(3, 4.2), 5e-3);
}

/* Between rollers 2 m apart the cable hangs by w l^2/8/(T + 9.6 EI/l^2) (EN5); above a span it counts as taut, and a
 * tray holds it up. */
TEST(clearance_of_a_hanging_cable)
{
    static const char rollers[] = "friction: {mu: 0}\n"
                                  "rollers: {along: {from: 0 m, to: 20 m, spacing: 2 m, radius: 50 mm, width: 300 mm}}",
                      tray[] = "friction: {mu: 0}\n"
                               "surfaces: {trays: [{section: flat, width: 80 mm, height: 60 mm, friction: {mu: 0}}]}";
    const double hangs = 5 * 9.81 * 4 / 8 / (1000 + 9.6 * 1000 / 4);
    for (int k = 0; k < 3; ++k) {
        SceneDef def;
        LayerNear near; /* the box is 3 m high, 0.1 m from the axis of the cable of 60 mm */
        const char *const at = k == 1 ? "[1004.5 m, 1999.9 m, 30.1 m]" : "[1004.5 m, 1999.9 m, 26.9 m]";
        char keys[200];
        snprintf(keys, sizeof keys, "layers: [wall], at: %s", at);
        expect_good(text_of(model_of(keys), k == 2 ? tray : rollers), NULL, NULL, &def);
        near_of(&def, 1, &near, 0);
        check_close(near.distance, 0.07 - (k == 0 ? hangs : 0), 1e-6);
        if (k == 0) check_close(near.s, 5, 1e-6);
    }
}

/* The example: the pipe is a collision at 40 m, its lower line 10 mm above the cable's axis, of which the radius
 * is 43.65 mm; the plate at the tray's end is at 52 m, 16.35 mm below a cable that does not hang. The rollers are the
 * model's. */
TEST(example_tunnel)
{
    CaseTree *tree;
    SceneDef def;
    hawser_error err;
    if (case_tree_load(HAWSER_SOURCE_DIR "/cases/environment/tunnel.yaml", &tree, &err) || case_read(tree, &def, &err))
        fail_msg("%s", err.message);
    enum { LAYERS = 100 };
    LayerNear near[LAYERS];
    char name[LAYERS][NAME_MAX_LENGTH];
    int rollers = 0, found = 0;
    const int layers = def.environment.mesh.n_layers;
    for (int i = 0; i < def.n_rollers; ++i) {
        if (strncmp(def.rollers[i].name, "roller ", 7)) continue;
        check_close(def.rollers[i].s, 1 + 2 * (strtod(def.rollers[i].name + 7, NULL) - 1), 1e-3);
        ++rollers;
    }
    assert_int_equal(rollers, 30);
    check_at_most(layers, LAYERS);
    for (int k = 0; k < layers; ++k) snprintf(name[k], sizeof name[k], "%s", def.environment.mesh.layer_name[k]);
    const double tension = near_of(&def, layers, near, 52);
    const double hangs = 46.67 * 9.81 * 4 / 8 / (tension + 9.6 * 2000 / 4); /* between rollers at 51 and 53 m (EN5) */
    for (int k = 0; k < layers; ++k) {
        const int pipe = !strcmp(name[k], "pipe");
        if (!pipe && strcmp(name[k], "tray end")) continue;
        check_close(near[k].distance, pipe ? -0.03365 : 0.01635 - hangs, 2e-5);
        check_close(near[k].s, pipe ? 40 : 52, 1e-2);
        ++found;
    }
    assert_int_equal(found, 2);
    case_tree_free(tree);
}

/* The limit with its place, in theory and in a run of a cable that stays on the route. */
TEST(limit_is_judged)
{
    static const struct {
        const char *keys;
        int ok;
        double value;
    } kind[] = {{"layers: [wall], at: [1004 m, 2000.1 m, 29 m]", 0, 0.07},
                {"layers: [wall], at: [1004 m, 2000.14 m, 29 m]", 1, 0.11},
                {"layers: [wall], at: [1004 m, 2000.1 m, 29 m], clearance: no", -1, NAN}};
    for (int k = 0; k < 3; ++k) {
        const char *const text =
            text_of(model_of(kind[k].keys),
                    "surfaces: {trays: [{section: flat, width: 80 mm, height: 60 mm, friction: {mu: 0.2}}]}");
        hawser_sim *const sim = run_of(text, NULL);
        hawser_limit limit[HAWSER_LIMITS_MAX];
        const int n = hawser_sim_limits(sim, limit);
        const hawser_limit *found = NULL;
        for (int i = 0; i < n; ++i)
            if (limit[i].kind == HAWSER_LIMIT_CLEARANCE_ENVIRONMENT) found = &limit[i];
        assert_int_equal(found != NULL, kind[k].ok >= 0);
        if (found) {
            assert_int_equal(found->ok, kind[k].ok);
            check_close(found->value, kind[k].value, 2e-3);
            check_has(found->where, "'wall', ");
        }
        hawser_sim_free(sim);
    }
}
