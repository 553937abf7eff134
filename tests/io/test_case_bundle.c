/* Several cables in one duct, from a case to a run: the cable that stands for them, what is refused, and the run
 * against the theory, which sees the same. */
#include "tests/io/case_fixture.h"

#include <jansson.h>

/* The bundle's cable; the definition is the caller's to clear. */
static const CableDef *bundled(const char *key, const char *value, SceneDef *def)
{
    expect_good(data_text("bundle"), key, value, def);
    return &def->cables[def->pieces[0].cable];
}

TEST(three_as_one)
{
    SceneDef def;
    const CableDef *c = bundled(NULL, NULL, &def);
    assert_string_equal(c->name, "3 x phase");
    check_share(c->mass, 6, 1e-15);
    check_share(c->ea, 15e6, 1e-15);
    check_share(c->ga, 6e6, 1e-15);
    check_share(c->gj, 12, 1e-15);
    check_share(c->ei_y, 6, 1e-15);
    check_share(c->ei_z, 6, 1e-15);
    for (int k = 0; k < 6; k++) check_share(c->damping * c->damping_factor[k], 5e-3, 1e-14);
    check_share(c->gyration, sqrt(0.0075 * 0.0075 + 0.03 * 0.03 / 6), 1e-14);
    check_share(c->diameter, 0.03, 1e-14);
    check_share(def.tail.tension.v1, 900, 1e-15); /* each of three holds back */
    /* the room: D/d = 2.2 */
    const double r = 0.018, x = 0.03 / 0.036, room = r * sqrt(1 - x * x) - 0.03 / (2 * sqrt(3));
    const SurfaceDef *const duct = &def.surfaces[0];
    check_share(duct->shape.radius - c->diameter / 2, room, 1e-12);
    check_share(duct->shape.lift, room, 1e-12);
    check_share(duct->bore, 0.033, 1e-15);
    check_share(bundle_friction(&def, duct, 1), 1 / sqrt(1 - x * x), 1e-14);
    check_share(bundle_share(&def, duct), 0.5 / sqrt(1 - x * x), 1e-14);
    check_share(bundle_share(&def, NULL), 1.0 / 3, 1e-15);
    check_share(bundle_friction(&def, NULL, 1), 1, 0);
    scene_def_clear(&def);
}

/* Phases and earth: sums by kind, damping by stiffness. */
TEST(unlike_as_one)
{
    SceneDef def;
    hawser_error err;
    const char *const members = "{members: [{cable: phase, count: 3}, {cable: earth}]}";
    char wide[4000];
    snprintf(wide, sizeof wide, "%s", data_with("bundle", "radius: 33 mm", "radius: 38 mm"));
    if (read_with(wide, "bundle", members, &def, &err)) fail_msg("%s", err.message);
    const CableDef *const c = &def.cables[def.pieces[0].cable];
    assert_string_equal(c->name, "3 x phase + 1 x earth");
    check_share(c->mass, 6.4, 1e-15);
    check_share(c->ea, 16e6, 1e-15);
    check_share(c->ei_y, 6.2, 1e-15);
    check_share(c->damping * c->damping_factor[0], (15 * 5e-3 + 1 * 2e-3) / 16, 1e-14);
    check_share(def.tail.tension.v1, 4 * 300, 1e-15);
    DuctLoad load;
    assert_int_equal(bundle_in(&def, &def.surfaces[0], &load, &err), HAWSER_OK);
    assert_int_equal(load.layout, DUCT_CRADLE);
    check_share(load.weight_factor, 1 + 4 / 3.0 * pow(30.0 / 46, 2), 1e-12); /* above 1.4 */
    check_share(load.fill, (3 * 900 + 144) / (76.0 * 76), 1e-12);
    assert_int_equal(def.bundle.shape.thickest, 3);
    scene_def_clear(&def);
}

/* Twisted ones come from one reel, and keep to the circle round them. */
TEST(twisted_as_one)
{
    SceneDef def;
    hawser_error err;
    char wide[4000];
    snprintf(wide, sizeof wide, "%s", data_with("bundle", "radius: 33 mm", "radius: 45 mm"));
    if (read_with(wide, "bundle", "{cables: 3, twisted: true, lay: 600 mm}", &def, &err)) fail_msg("%s", err.message);
    const CableDef *const c = &def.cables[def.pieces[0].cable];
    const double longer = hypot(1, 2 * M_PI * 0.03 / sqrt(3) / 0.6);
    check_share(c->mass, 6 * longer, 1e-14);
    check_share(c->ea, 15e6 / pow(longer, 3), 1e-14);
    check_share(def.tail.tension.v1, 300, 1e-15);
    check_share(def.surfaces[0].shape.radius, 0.045, 1e-14);
    check_share(bundle_share(&def, NULL), 1, 0);
    scene_def_clear(&def);
    if (read_with(wide, "bundle", "{cables: 3, twisted: true}", &def, &err)) fail_msg("%s", err.message);
    check_share(def.bundle.set.lay, 0.9, 1e-15);
    scene_def_clear(&def);
}

/* Tables of bending and ratios of damping go with one kind. */
TEST(tables_as_one)
{
    SceneDef def;
    const CableDef *c =
        bundled("cables.phase",
                "{EA: 5 MN, GA: 2 MN, GJ: 4 N m2, d: 30 mm, mass: 2 kg/m, damping_ratio: {axial: 0.03}, "
                "preload: {axial: 10 N}, bending: {table: [[0.1 m-1, 2 N m], [1, 5]]}}",
                &def);
    assert_int_equal(c->bending.rows, 2);
    check_share(c->bending.curvature[1], 1, 0);
    check_share(c->bending.moment[1], 15, 1e-15);
    check_share(c->ei_y, 60, 1e-14);
    check_share(c->damping_ratio[0], 0.03, 0);
    check_share(c->preload[0], 30, 1e-15);
    scene_def_clear(&def);
}

/* The older keys of section theory mean the same. */
TEST(older_keys)
{
    SceneDef old, now;
    hawser_error err;
    char text[4000];
    snprintf(text, sizeof text, "%s",
             data_with("bundle", "bundle: {cables: 3}", "theory: {cables: 3, layout: triangle}"));
    if (read_with(text, NULL, NULL, &old, &err)) fail_msg("%s", err.message);
    const CableDef *const a = bundled("bundle.layout", "triangle", &now), *const b = &old.cables[old.pieces[0].cable];
    assert_memory_equal(a, b, sizeof *a);
    assert_memory_equal(&old.bundle, &now.bundle, sizeof old.bundle);
    check_share(old.surfaces[0].shape.radius, now.surfaces[0].shape.radius, 0);
    scene_def_clear(&old);
    scene_def_clear(&now);
}

TEST(refused)
{
    static const struct {
        const char *key, *value, *part;
    } cases[] = {
        {"bundle", "{cables: 5}", "'bundle.cables': value '5' is out of range"},
        {"bundle", "{cables: 2, layout: cradle}", "'bundle.layout': a cradle is of 3 cables, but 'cables' is 2"},
        {"bundle", "{cables: 3, twisted: true, layout: cradle}", "do not lie in a cradle"},
        {"bundle", "{cables: 3, lay: 1 m}", "'bundle.lay': only with 'twisted: true'"},
        {"bundle", "{cables: 3, members: [{cable: phase}]}", "'bundle.members': given beside 'cables'"},
        {"bundle", "{members: [{cable: fase}]}", "'fase' is not one of those"},
        {"bundle", "{members: [{cable: earth, count: 2}]}", "'phase', the chain's cable, is not among them"},
        {"bundle", "{members: [{cable: phase}, {cable: phase}]}", "'phase' twice"},
        {"bundle", "{members: []}", "0 kinds of cables"},
        {"bundle", "{members: [{cable: phase, count: 5}]}",
         "'bundle.members': 5 cables, 5 of them as thick as the thickest within a tenth"},
        {"bundle", "{cables: 3, weight_factor: 0.5}", "'bundle.weight_factor': value '0.5' is out of range"},
        {"bundle.cables", "4", "'surfaces.ducts.0.radius': duct 'duct': 4 cables of 0.03 m do not fit"},
        {"theory", "{cables: 3}", "'theory.cables': given beside section 'bundle'"},
        {"chain", "[{cable: earth, length: 2 m}, {cable: phase, length: 6 m}, {cable: earth, length: 1 m}]",
         "'chain': a bundle is of one kind all along"},
        {"conveyors", "[{from: 1 m, to: 1.5 m, clamp: 1 kN}]", "'conveyors': the belts of a conveyor grip loose"},
        {"medium", "{density: 1025 kg/m3, buoyancy: false}", "'medium': the drag and lift"},
        {"rollers", "{along: [{from: 6 m, to: 7 m, spacing: 1 m, profile: v}]}", "has a groove, in which"},
        {"surfaces", "{trays: [{section: v, angle: 120 deg, depth: 100 mm}]}", "is a trough, in which"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++)
        expect_bad(data_text("bundle"), cases[k].key, cases[k].value, cases[k].part);
    expect_bad(data_with("bundle", "drive: {winch: {speed: 0.1 m/s, to: 1 s}, tail: {tension: 300 N, ramp: none}}",
                         "drive: {winch: {speed: 0.1 m/s, to: 1 s}}\nreel: {model: payout, distance: 1 m, barrel: 1 m, "
                         "flange: 2 m, width: 1 m, inertia: 10 kg m2}"),
               NULL, NULL, "loose cables come from a reel each");
    expect_bad(data_with("bundle", "GJ: 3 N m2", "GJ: 3 N m2, damping_ratio: {axial: 0.1}"), "bundle",
               "{members: [{cable: phase, count: 3}, {cable: earth}]}", "cable 'earth' has damping ratios");
}

/* A run with settings, to its end. */
typedef struct Ran {
    hawser_sim *sim;
    hawser_summary sum;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    int n, found;
    char verdict[HAWSER_VERDICT_MAX];
} Ran;

static Ran run(const char *text, const char *const *settings)
{
    Ran r = {.sim = NULL};
    hawser_error err;
    hawser_case *const c = case_with(text, NULL);
    for (int i = 0; settings && settings[i]; i += 2)
        assert_int_equal(hawser_case_set(c, settings[i], settings[i + 1], NULL), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &r.sim, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    assert_int_equal(hawser_sim_run(r.sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    hawser_sim_summary(r.sim, &r.sum);
    r.n = hawser_sim_limits(r.sim, r.limit);
    r.found = hawser_verdict(r.sum.n_conditions, r.sum.conditions, r.n, r.limit, r.verdict, sizeof r.verdict);
    return r;
}

/* In a tight duct run and theory agree within 1 %, by each way to correct the weight; and theory is what the formulas
 * say. The run was that of one cable: a quarter of the pull. */
TEST(runs_as_theory_says)
{
    const double w = 6 * 9.81, x = 0.03 / 0.036, factor = 1 / sqrt(1 - x * x), turn = M_PI / 4, R = 4;
    static const char *const where[] = {"everywhere", "straights", "none"};
    for (int k = 0; k < 3; k++) {
        const char *const settings[] = {"bundle.weight_correction", where[k], NULL};
        const double mu = 0.3 * (k < 2 ? factor : 1), in_bend = 0.3 * (k < 1 ? factor : 1);
        const double T1 = 900 + mu * w * 2;
        const double T2 = T1 * cosh(in_bend * turn) + sinh(in_bend * turn) * hypot(T1, w * R);
        const Ran r = run(data_text("bundle"), settings);
        const double to = 7 - 2 - R * turn; /* of the last straight, where the front was at t = 0 */
        check_share(r.sum.reference_total_N, T2 + mu * w * fmin(to, 3), 1e-6);
        check_share(r.sum.pull_mean_N, r.sum.reference_total_N, 0.01);
        check_above(r.found, -1); /* trusted: it is the bundle that runs */
        hawser_sim_free(r.sim);
    }
    const char *const straight[] = {"route.pieces", "[{straight: 8 m}]", NULL};
    const Ran r = run(data_text("bundle"), straight);
    check_share(r.sum.pull_mean_N, 900 + 0.3 * factor * w * 7, 0.004);
    hawser_sim_free(r.sim);
}

/* Limits count all cables for the pull, and the worst of them for the sidewall pressure; theory and run alike. */
TEST(limits_of_all)
{
    const Ran r = run(data_text("bundle"), NULL);
    char *text = NULL;
    hawser_case *const c = case_with(data_text("bundle"), NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, NULL), HAWSER_OK);
    json_t *const o = json_loads(text, 0, NULL);
    assert_non_null(o);
    for (int i = 0; i < r.n; i++) {
        const hawser_limit *const l = &r.limit[i];
        json_t *rows = json_object_get(o, "limits"), *row;
        size_t k;
        json_array_foreach(rows, k, row)
        {
            if (strcmp(json_string_value(json_object_get(row, "name")), l->name)) continue;
            if (strcmp(json_string_value(json_object_get(row, "direction")), "forward")) continue;
            const double by_theory = json_number_value(json_object_get(row, "value"));
            const int geometry = !strcmp(l->name, "clearance") || !strcmp(l->name, "fill");
            if (l->judged) check_share(json_number_value(json_object_get(row, "limit")), l->limit, 1e-9);
            if (geometry) check_share(by_theory, l->value, 1e-9);
            if (!strcmp(l->name, "pull")) check_share(l->limit, 60e3, 1e-12);
            if (!strcmp(l->name, "bend_radius")) check_share(l->limit, 20 * 0.03, 1e-12);
        }
    }
    assert_memory_equal(json_string_value(json_object_get(o, "verdict_forward")), "NOT SAFE", 8);
    check_has(r.verdict, "NOT SAFE: 2 of");
    check_has(r.verdict, "clearance");
    check_has(r.verdict, "fill");
    json_decref(o);
    hawser_text_free(text);
    hawser_case_free(c);
    hawser_sim_free(r.sim);
}

/* Everything that the one cable is made of is said. */
TEST(terms_are_said)
{
    const char *const settings[] = {
        "bundle.weight_correction", "straights", "run.duration", "0.1 s", "run.steady_from", "0 s", NULL};
    const Ran r = run(data_text("bundle"), settings);
    const hawser_bundle *const b = r.sum.bundle;
    assert_non_null(b);
    assert_int_equal(b->cables, 3);
    assert_int_equal(b->n_ducts, 1);
    assert_string_equal(b->weight_correction, "straights");
    check_share(b->ducts[0].friction_straight, 0.3 * b->ducts[0].weight_factor, 1e-14);
    check_share(b->ducts[0].friction_bend, 0.3, 1e-14);
    char *text = NULL;
    assert_int_equal(hawser_sim_summary_json(r.sim, &text, NULL), HAWSER_OK);
    json_t *const o = json_loads(text, 0, NULL), *const said = json_object_get(o, "bundle");
    check_share(json_number_value(json_object_get(said, "EA_N")), 15e6, 1e-9);
    check_share(json_number_value(json_object_get(said, "mass_kg_per_m")), 6, 1e-9);
    json_t *const duct = json_array_get(json_object_get(said, "ducts"), 0);
    assert_string_equal(json_string_value(json_object_get(duct, "layout")), "triangle");
    assert_true(json_is_null(json_object_get(said, "lay_m")));
    json_decref(o);
    hawser_text_free(text);
    hawser_sim_free(r.sim);
    hawser_case *const c = case_with(data_text("bundle"), NULL);
    assert_int_equal(hawser_case_describe(c, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    check_has(text, "3 x phase");
    check_has(text, "cables pulled together");
    check_has(text, "worst share");
    hawser_text_free(text);
    hawser_case_free(c);
}

/* A published pull, 13 418 N (TES-P-104.05, paragraph 4.5), has the factor on straights alone; everywhere and nowhere
 * it is another. */
TEST(factor_on_straights)
{
    static const char *const where[] = {"straights", "everywhere", "none"};
    double force[3];
    for (int k = 0; k < 3; k++) {
        char *text = NULL;
        hawser_case *const c =
            case_with(data_text("bundle-tes"), (const char *const[]){"bundle.weight_correction", where[k], NULL});
        assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, NULL), HAWSER_OK);
        json_t *const o = json_loads(text, 0, NULL), *const way = json_array_get(json_object_get(o, "directions"), 0);
        force[k] = json_number_value(json_object_get(way, "force_N"));
        json_decref(o);
        hawser_text_free(text);
        hawser_case_free(c);
    }
    check_share(force[0], 13418, 0.005);
    check_above(force[1], 1.05 * 13418);
    check_above(0.95 * 13418, force[2]);
}
