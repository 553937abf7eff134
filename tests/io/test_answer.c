/* What a report begins with: what would make each broken limit hold, put back into the formula that it comes from, and
 * the answer of a run and of the calculation. */
#include <jansson.h>

#include "def/limits.h"
#include "tests/io/case_fixture.h"

#include "io/api/api_handles.h"

static const char three[] =
    "cables: {c: {d: 25.4 mm, mass: 1.5 kg/m, E: 10 GPa, G: 3 GPa, A: 30 mm2}}\n"
    "chain: [{cable: c, length: 30 m}]\n"
    "route: {pieces: [{name: in, straight: 10 m}, {name: turn, bend: 90 deg, radius: 2 m, plane: left},"
    " {straight: 20 m}]}\n"
    "surfaces: {ducts: [{name: d, radius: 31.75 mm, friction: {mu: 0.25}}]}\n"
    "theory: {cables: 3}\n"
    "limits: {pull: 10 kN, rope_strength: 50 kN}\n"
    "drive: {tail: {tension: 3 kN}}\n"
    "run: {duration: 10 s}\n";

static int answer_setup(void **state)
{
    static SceneDef def; /* the scene borrows its definition */
    static Scene scene;
    hawser_error err;
    assert_int_equal(read_with(three, NULL, NULL, &def, &err), HAWSER_OK);
    assert_int_equal(scene_build(&def, &scene, &err), HAWSER_OK);
    *state = &scene;
    return 0;
}

static int answer_teardown(void **state)
{
    scene_clear(*state);
    return 0;
}

static const char *remedy(const Scene *scene, const char *name, const char *unit, double value, double limit,
                          const char *where, hawser_units units)
{
    static char text[256];
    hawser_limit l = {
        .kind = limits_kind(name), .name = name, .unit = unit, .value = value, .limit = limit, .judged = 1};
    snprintf(l.where, sizeof l.where, "%s", where);
    Remedy r;
    *text = 0;
    if (remedy_find(&scene->setup, &l, &r)) remedy_say(&r, units, text);
    return text;
}

TEST(words)
{
    const Scene *const scene = *state;
    static const struct {
        const char *name, *unit;
        double value, limit;
        const char *said;
    } row[] = {
        {"pull", "N", 15200, 10000, "5.2 kN less pull: conveyors, a pit, or a lubricant"},
        {"winch", "N", 15200, 10000, "5.2 kN less"},
        {"rope", "N", 15000, 10000, "a rope that breaks at 75 kN (limits.rope_strength)"},
        {"bend_radius", "m", 1.5, 2, "a radius of at least 2 m there"},
        {"run_away", "N", 11730, 0,
         "a brake of 3.91 kN more where the pull begins (drive.tail.tension, of each cable)"},
        {"speed", "m/s", 0.3, 0.25, "at most 0.25 m/s"},
        {"roller_steady", "N", 5000, 2500, "rollers there at 0.5 of their spacing, or rated 2 times as high"},
        {"alpha", "1", 2, 1.5, "a softer start"},
        {"a limit to come", "1", 2, 1, ""},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; k++) {
        const char *const said = remedy(scene, row[k].name, row[k].unit, row[k].value, row[k].limit, "x", HAWSER_SI);
        check_has(said, row[k].said);
        if (!*row[k].said) assert_string_equal(said, "");
    }
    check_has(remedy(scene, "pull", "N", 4448.2216 * 2, 4448.2216, "", HAWSER_US), "1000 lbf less pull");
}

/* The duct that is named keeps all limits of a duct, from there on, and one that is 1 % narrower does not. Once each
 * limit had a remedy of its own, of which two broke another: 64.7 mm and 69.6 mm, in which three cables jam. */
TEST(ducts)
{
    const Scene *const scene = *state;
    static const hawser_limit_kind kinds[] = {HAWSER_LIMIT_CLEARANCE, HAWSER_LIMIT_FILL, HAWSER_LIMIT_JAM_RATIO};
    DuctDef def = {.duct_diameter = 63.5e-3, .cable_diameter = 25.4e-3, .cables = 3};
    DuctLoad then;
    double least;
    for (int k = 0; k < 3; k++) {
        const char *const said = remedy(scene, limits_name(kinds[k]), "1", 1, 2, "d", HAWSER_SI);
        assert_int_equal(sscanf(said, "an inside diameter of at least %lf mm in 'd' would keep its limits", &least), 1);
        check_has(said, "now 63.5 mm, twice surfaces.ducts.0.radius");
        check_between(1.05 * least / 25.4, 3.2, 3.21); /* the end of the band in which they jam binds */
    }
    for (int k = 0; k < 20; k++) {
        def.duct_diameter = 1e-3 * least * (1 + 0.05 * k);
        assert_int_equal(duct_load(&def, &then, NULL), HAWSER_OK);
        check_at_least(then.clearance, 6.35e-3);
        check_at_most(then.fill, 0.4);
        check_at_least(then.jam_ratio, 3.2);
    }
    def.duct_diameter = 0.99e-3 * least;
    assert_int_equal(duct_load(&def, &then, NULL), HAWSER_OK);
    check_between(then.jam_ratio, 2.6, 3.2);
    assert_string_equal(remedy(scene, "fill", "1", 0.5, 0.4, "no such duct", HAWSER_SI), "");
}

/* Whatever is broken, with values or without: whole sentences, of which no brace or bracket is left. */
TEST(sentences)
{
    const Scene *const scene = *state;
    int said = 0;
    for (int kind = 0; kind < HAWSER_LIMITS_MAX; ++kind) {
        for (int k = 0; k < 6; ++k) {
            static const char *const where[] = {"", "d", "12.0 m (turn)", "25.0 m (straight)", "theory.feed", "P1"};
            hawser_limit l = {.kind = (hawser_limit_kind)kind, .name = "x", .unit = "N", .value = 5e3, .limit = 3e3};
            Remedy r;
            char text[REMEDY_MAX] = "";
            snprintf(l.where, sizeof l.where, "%s", where[k]);
            if (!remedy_find(&scene->setup, &l, &r)) continue;
            remedy_say(&r, HAWSER_SI, text);
            assert_int_equal(strcspn(text, "{}[]|"), strlen(text));
            assert_null(strstr(text, "nan"));
            assert_true(*text);
            ++said;
        }
    }
    check_at_least(said, 6 * 14);
}

/* A bend is found by the metres of its place, also at its very end where the next straight begins; elsewhere there is
 * only less tension. What the bend's own length adds to the tension is in the radius. */
TEST(bends)
{
    const Scene *const scene = *state;
    const double end = 10 + 2 * 3.14159265358979323846 / 2;
    char where[40];
    snprintf(where, sizeof where, "%.1f m (straight)", end);
    double radius;
    const char *said = remedy(scene, "sidewall", "N/m", 4000, 3000, where, HAWSER_SI);
    assert_int_equal(
        sscanf(said, "a radius of %lf m in 'turn' would keep this limit (route.pieces.1.radius, now 2 m)", &radius), 1);
    check_between(radius, 2 * 4000 / 3000.0, 2.8);
    check_has(said, "25 % less tension there");
    said = remedy(scene, "sidewall", "N/m", 4000, 3000, "25.0 m (straight)", HAWSER_SI);
    assert_ptr_equal(strstr(said, "25 % less tension there"), said);
    check_has(remedy(scene, "sidewall", "N/m", 4000, 3000, where, HAWSER_US), " ft in 'turn'");
}

/* What is assumed, and what would do, in the summary: codes with values and units. */
static void check_coded(const hawser_sim *sim)
{
    char *text = NULL;
    const char *code, *key, *unit, *name, *rest;
    double least, now, low, high;
    assert_int_equal(hawser_sim_summary_json(sim, &text, NULL), HAWSER_OK);
    json_t *const o = json_loads(text, 0, NULL);
    hawser_text_free(text);
    assert_int_equal(json_unpack(o, "{s:[{s:s,s:s,s:s,s:F,s:F}]}", "remedies", "remedy", &code, "key", &key, "unit",
                                 &unit, "least", &least, "now", &now),
                     0);
    assert_string_equal(code, "do_radius"); /* by theory with all limits; it was "radius", of its own limit alone */
    assert_string_equal(key, "route.pieces.1.radius");
    assert_string_equal(unit, "m");
    check_at_least(least, now);
    assert_int_equal(
        json_unpack(o, "{s:[{s:s,s:s,s:F,s:F}]}", "assumed", "name", &name, "key", &rest, "low", &low, "high", &high),
        0);
    assert_string_equal(name, "friction at rest");
    assert_string_equal(rest, "friction.mu_s");
    check_equal(low, 0.2);
    check_between(high, 0.3 - 1e-12, 0.3 + 1e-12);
    json_decref(o);
}

/* The first lines of a page: verdict, pull, worst place, remedy, in the units that are asked for, within a page. */
TEST(answers)
{
    hawser_case *c = NULL;
    char *text = NULL;
    assert_int_equal(hawser_case_parse(three, NAME, &c, NULL), HAWSER_OK);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    check_has(text, "\nNOT SAFE: ");
    check_has(text, "\n  pull           ");
    check_has(text, "\n  worst          ");
    check_has(text, "\n  remedy         an inside diameter of at least ");
    check_has(text, "\n  pulled back    ");
    const char *const answer = strstr(text, "NOT SAFE"), *const table = strstr(text, "weight of the cable");
    assert_non_null(answer);
    check_has(text, "\n\n  assumed        friction at rest 0."); /* above the verdict */
    assert_true(strstr(text, "assumed") < answer);
    assert_true(table > answer);
    hawser_text_free(text);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE_US, &text, NULL), HAWSER_OK);
    check_has(text, " lbf at the winch");
    check_has(text, " in in 'd' (now 2.5 in, twice surfaces.ducts.0.radius)");
    hawser_text_free(text);
    hawser_case_free(c);

    hawser_sim *sim = NULL;
    char said[HAWSER_ANSWER_MAX], little[40];
    assert_int_equal(hawser_case_parse(data_text("limits"), NAME, &c, NULL), HAWSER_OK);
    assert_int_equal(hawser_case_set(c, "limits.sidewall", "100 N/m", NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_new(c, NULL, &sim, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    hawser_sim_answer(sim, HAWSER_SI, said, sizeof said);
    check_has(said, "  assumed        friction at rest 0.2, usually 0.2 to 0.3 (friction.mu_s)\nNOT SAFE: 1 of");
    check_has(said, "\n  pull           mean ");
    check_has(said, "\n  reached        the cable's front reached ");
    check_has(said, "\n  worst          sidewall ");
    check_has(said, "allowed 100 N/m");
    check_has(said, "\n  remedy         a radius of ");
    check_has(said, "\n  trust          the figures are to be trusted");
    hawser_sim_answer(sim, HAWSER_US, said, sizeof said);
    check_has(said, "allowed 6.852 lbf/ft");
    check_coded(sim);
    hawser_sim_answer(sim, HAWSER_SI, little, sizeof little); /* cut, never beyond */
    assert_int_equal(strlen(little), sizeof little - 1);
    hawser_sim_free(sim);
    hawser_case_free(c);
}

/* What `hawser theory` prints of a case on a terminal of 80 columns, and, from the line where one is too long on, each
 * sentence in one line: the words do not depend on where they were cut. */
static char *told_of(const char *text, int *lines)
{
    static const hawser_theory_options terminal = {.width = 80};
    hawser_error err = {0};
    char *said = NULL;
    hawser_case *const c = case_with(text, NULL);
    if (hawser_case_theory_shown(c, HAWSER_TABLE, &terminal, &said, NULL, &err)) fail_msg("%s", err.message);
    hawser_case_free(c);
    *lines = 0;
    char *to = said;
    for (const char *at = said; *at; ++at) {
        *lines += *at == '\n';
        const int blank = *at == '\n' || *at == ' ';
        if (!blank || to == said || to[-1] != ' ') *to++ = blank ? ' ' : *at;
    }
    *to = 0;
    return said;
}

#define ONE  "cables: {c: {d: 50 mm, mass: 4 kg/m}}\n"
#define TAIL "drive: {tail: {tension: 0 N}}\n"
#define BENT(radius)                                                                                                   \
    "route: {pieces: [{straight: 300 m}, {name: b1, bend: 90 deg, radius: " radius ", plane: left}, {straight: 5 "     \
    "m}]}\n"

/* What a planner once read wrong in the answer. */
TEST(what_is_read)
{
    static const struct {
        const char *text, *has, *not ;
    } row[] = {
        /* "pulled from the other end: SAFE" stood above "NOT JUDGED: pull" of that direction */
        {ONE BENT("2 m") "surfaces: {ducts: [{radius: 50 mm}]}\nfriction: {mu: 0.3, mu_s: 0.3}\n" TAIL
                         "limits: {sidewall: 0.8 kN/m}\n",
         "would do; computed again: NOT JUDGED: pull", "pulled from the other end"},
        {ONE BENT("2 m") "surfaces: {ducts: [{radius: 50 mm}]}\nfriction: {mu: 0.3, mu_s: 0.3}\n" TAIL
                         "limits: {sidewall: 1.9 kN/m, pull: 20 kN}\n",
         "pulled from the other end: SAFE ", "NOT JUDGED"},
        /* a duct of exactly 1.5 diameters was NOT SAFE: fill by 2.22e-14 % */
        {"cables: {c: {d: 80 mm, mass: 12 kg/m}}\nroute: {pieces: [{straight: 50 m}]}\nsurfaces: {ducts: [{radius: "
         "60 "
         "mm}]}\nfriction: {mu: 0.3, mu_s: 0.3}\n" TAIL "limits: {code: tb889, pull: 20 kN, sidewall: 3 kN/m}\n",
         "SAFE: all ", "NOT SAFE"},
        /* "36.1 % left" stood under NOT SAFE: restart by 37.4 % */
        {ONE "route: {pieces: [{straight: 300 m}]}\nsurfaces: {ducts: [{radius: 50 mm}]}\nfriction: {mu: 0.2, mu_s: "
             "0.45}\n" TAIL "limits: {pull: 4 kN, sidewall: 3 kN/m}\n",
         "; from rest allowed 4 kN: 32.4 % over", "left worst"},
        /* "no duct makes this safe": three cables in a triangle have no place in a duct of eight times the width */
        {"cables: {c: {d: 80 mm, mass: 7 kg/m}}\nbundle: {cables: 3, layout: triangle}\nroute: {pieces: [{straight: "
         "100 "
         "m}]}\nsurfaces: {ducts: [{name: D1, radius: 107 mm}]}\nfriction: {mu: 0.15, mu_s: 0.2}\n" TAIL
         "limits: {code: aeic, pull: 20 kN, sidewall: 5 kN/m}\n",
         "an inside diameter of at least 0.244 m and at most 0.503 m in 'D1'", "no duct"},
        /* a bound on friction moved the friction at rest that was given: 0.212 for 0.25 */
        {ONE "route: {pieces: [{straight: 500 m}]}\nsurfaces: {ducts: [{radius: 50 mm, friction: {type: "
             "pe-jacket/pe-duct/lubricated, mu_s: 0.25}}]}\n" TAIL "limits: {pull: 5 kN, sidewall: 3 kN/m}\n",
         "SAFE: all ", "SAFE ONLY IF"},
        /* mu_d and mu_s beside a type were refused: its mu said nothing */
        {ONE "route: {pieces: [{straight: 100 m}]}\nsurfaces: {ducts: [{radius: 50 mm, friction: {type: "
             "pe-jacket/pe-duct/lubricated, mu_d: 0.1, mu_s: 0.2}}]}\n" TAIL "limits: {pull: 5 kN, sidewall: 3 kN/m}\n",
         "SAFE: all ", "assumed"},
        /* on a slope the radius of the line in space, 2.09 m, stood for that of the plan, which the case gives */
        {ONE "route: {slope: 12 deg, pieces: [{straight: 100 m}, {name: b, bend: 60 deg, radius: 2 m, plane: left}, "
             "{straight: 9 m}]}\nsurfaces: {ducts: [{radius: 50 mm}]}\nfriction: {mu: 0.3, mu_s: 0.3}\n" TAIL
             "limits: {pull: 20 kN, sidewall: 0.5 kN/m}\n",
         "(route.pieces.1.radius, now 2 m)", "now 2.09"},
        /* what a row of rollers gives was named friction.mu_s */
        {ONE "route: {pieces: [{straight: 40 m}]}\nrollers: {along: [{spacing: 2 m, to: 20 m, friction: {mu: 0.2}}, "
             "{spacing: 2 m, from: 20 m, friction: {mu: 0.25}}]}\n" TAIL "limits: {pull: 5 kN, sidewall: 3 kN/m}\n",
         "friction at rest 0.25, usually 0.25 to 0.375 (rollers.along.1.friction.mu_s", "(friction.mu_s)"},
    };
    for (size_t k = 0; k < sizeof row / sizeof *row; ++k) {
        int lines;
        char *const said = told_of(row[k].text, &lines);
        check_has(said, row[k].has);
        if (strstr(said, row[k].not )) fail_msg("row %zu: '%s' is in: %s", k, row[k].not, said);
        hawser_text_free(said);
    }
}

/* The title, a blank line and 24 more, whatever is broken: 37 once. */
TEST(no_more_than_a_page)
{
    static const char text[] =
        "cables: {c: {d: 100 mm, mass: 20 kg/m}}\nbundle: {cables: 3}\n"
        "route: {pieces: [{straight: 300 m}, {name: one, bend: 60 deg, radius: 1 m, plane: left}, {straight: 100 m}, "
        "{name: two, bend: 45 deg, radius: 1 m, plane: right}, {straight: 100 m}, {name: three, bend: 90 deg, radius: "
        "1 m, "
        "plane: left}, {straight: 50 m}]}\nsurfaces: {ducts: [{name: a long name of a duct, radius: 150 mm, to: 300 "
        "m}, "
        "{name: another name of a duct, radius: 145 mm, from: 300 m}]}\nfriction: {mu: 0.4}\n"
        "limits: {code: aeic, pull: 20 kN, sidewall: 1 kN/m, winch_capacity: 10 kN, rope_strength: 50 kN, "
        "attachment_rating: 5 kN}\ntheory: {machine_push: 5 kN}\n";
    int lines;
    char *const said = told_of(text, &lines);
    check_has(said, "NOT SAFE: 8 of 11 limits broken pull ");
    check_at_most(lines, 26);
    hawser_text_free(said);
}

/* The remedies of cases/duct-bends.yaml with those keys, run; that many, of all limits together, set. Returns the
 * largest T/R, N/m. */
static double run_ducts(const char *const set[], char key[3][64], double value[3])
{
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_summary sum;
    char *text = NULL;
    hawser_limit limit[HAWSER_LIMITS_MAX];
    double sidewall = NAN;
    assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/duct-bends.yaml", &c, NULL), HAWSER_OK);
    for (; *set; set += 2) assert_int_equal(hawser_case_set(c, set[0], set[1], NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_new(c, NULL, &sim, NULL), HAWSER_OK);
    assert_int_equal(hawser_sim_run(sim, NULL, NULL, NULL, NULL), HAWSER_OK);
    hawser_sim_summary(sim, &sum);
    const int n = hawser_sim_limits(sim, limit);
    for (int i = 0; i < n; ++i)
        if (limit[i].kind == HAWSER_LIMIT_SIDEWALL) sidewall = limit[i].value;
    assert_int_equal(hawser_sim_summary_json(sim, &text, NULL), HAWSER_OK);
    json_t *const o = json_loads(text, 0, NULL), *const remedies = json_object_get(o, "remedies");
    assert_int_equal(json_array_size(remedies), key ? 3 : 0);
    for (size_t i = 0; key && i < 3; ++i) {
        json_t *const r = json_array_get(remedies, i);
        assert_string_equal(json_string_value(json_object_get(r, "limit")), "all");
        snprintf(key[i], sizeof key[i], "%s", json_string_value(json_object_get(r, "key")));
        value[i] = json_number_value(json_object_get(r, "least"));
    }
    json_decref(o);
    hawser_text_free(text);
    hawser_sim_free(sim);
    hawser_case_free(c);
    return sidewall;
}

/* What a run proposes keeps all limits of the run with it: each of two bends is too tight and the duct too narrow. Of
 * its own limit alone the worse bend asked for 10.1 m, with which both are too tight all the same. */
TEST(a_runs_remedies)
{
    static const char limits[] = "{sidewall: 0.4 kN/m, pull: 20 kN}";
    char key[3][64], text[3][32];
    double value[3];
    const double before = run_ducts((const char *const[]){"limits", limits, "output.stations", "[]", NULL}, key, value);
    check_above(before, 750);
    assert_string_equal(key[0], "surfaces.ducts.0.radius");
    value[0] /= 2; /* of an inside diameter */
    for (int i = 0; i < 3; ++i) snprintf(text[i], sizeof text[i], "%.10g m", value[i]);
    const double after = run_ducts((const char *const[]){"limits", limits, "output.stations", "[]", "route.head_at",
                                                         "44.2 m", "chain.0.length", "43 m", key[0], text[0], key[1],
                                                         text[1], key[2], text[2], NULL},
                                   NULL, NULL);
    check_between(after, 250, 400);
}

/* A key of the case that a remedy names is one that makes that bend wider: bends between slopes are not listed. */
TEST(a_listed_bend)
{
    static const char sloped[] =
        "cables: {c: {d: 80 mm, mass: 20 kg/m}}\n"
        "route: {transition_radius: 20 m, pieces: [{straight: 50 m}, {straight: 40 m, slope: 10 deg},"
        " {straight: 30 m, slope: 0 deg}, {name: tight, bend: 90 deg, radius: 3 m, plane: left}, {straight: 30 m}]}\n"
        "friction: {mu: 0.2}\nsurfaces: {ducts: [{radius: 80 mm}]}\nlimits: {pull: 60 kN, sidewall: 3 kN/m}\n";
    SceneDef def;
    hawser_error err;
    Scene scene;
    assert_int_equal(read_with(sloped, NULL, NULL, &def, &err), HAWSER_OK);
    assert_int_equal(scene_build(&def, &scene, &err), HAWSER_OK);
    check_has(remedy(&scene, "sidewall", "N/m", 3500, 3000, "124.4 m (tight)", HAWSER_SI),
              "in 'tight' would keep this limit (route.pieces.3.radius, now 3 m)");
    const char *const said = remedy(&scene, "sidewall", "N/m", 3500, 3000, "50.0 m (change of slope)", HAWSER_SI);
    check_has(said, "in 'change of slope' would keep this limit (route.transition_radius, now 20 m)");
    scene_clear(&scene);
    scene_def_clear(&def);
}

/* The winch holds the rope's own way up as well: 151.6 kN stood beside 45.1 % left of 200 kN, which are the cable's. */
TEST(the_margin_is_the_cables)
{
    static const char shaft[] =
        "cables: {p: {d: 100 mm, mass: 20 kg/m}}\nchain: [{cable: p, length: 485.708 m}]\n"
        "route: {pieces: [{straight: 22 m}, {bend: 90 deg, radius: 5 m, plane: down}, {straight: 400 m},"
        " {bend: 90 deg, radius: 5 m, plane: up}, {straight: 60 m}]}\n"
        "surfaces: {ducts: [{radius: 75 mm}]}\nfriction: {mu: 0.2}\n"
        "drive: {tail: {tension: 80 kN}}\nlimits: {pull: 200 kN, sidewall: 50 kN/m, bend_radius: 1 m}\n";
    char *text = NULL;
    hawser_case *const c = case_with(shaft, NULL);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &text, NULL), HAWSER_OK);
    check_has(text, "in the cable 109.8 kN");
    hawser_text_free(text);
    hawser_case_free(c);
}

/* A run's limits with a change of slope that nobody gave a radius: one that theory has broken there asks for a radius;
 * one that theory does not know, or that no radius moves, stays broken. */
TEST(what_a_radius_mends)
{
    static const char slope[] = "cables: {power: {d: 80 mm, mass: 9 kg/m}}\n"
                                "route: {pieces: [{straight: 400 m}, {straight: 100 m, slope: -4 deg}]}\n"
                                "surfaces: {ducts: [{radius: 70 mm}]}\nfriction: {mu_s: 0.3, mu_d: 0.3}\n"
                                "theory: {reel: 1 mm}\nlimits: {pull: 20 kN, sidewall: 3 kN/m}\n";
    for (int k = 0; k < 3; k++) {
        static const hawser_limit_kind kinds[] = {HAWSER_LIMIT_SIDEWALL, HAWSER_LIMIT_ROLLER_PEAK, HAWSER_LIMIT_FILL};
        hawser_limit limit = {.kind = kinds[k],
                              .name = limits_name(kinds[k]),
                              .value = 6800,
                              .limit = 3000,
                              .margin = -1,
                              .judged = 1,
                              .slope_radius_least = NAN};
        hawser_limit *const all = &limit;
        SceneDef def;
        Setup setup;
        expect_good(slope, NULL, NULL, &def);
        assert_int_equal(setup_make(&def, &setup, NULL), HAWSER_OK);
        assert_int_equal(assumed_judge(&setup, NULL, 1, 1, 1, &all, NULL), HAWSER_OK);
        assert_int_equal(limit.ok, k == 0);
        if (k == 0) check_between(limit.slope_radius_least, 3.5, 3.8); /* 1.6 m times 6800/3000 */
        if (k > 0) check_equal(limit.value, 6800);
        setup_free(&setup);
        scene_def_clear(&def);
    }
}

TEST_GROUP(answer_setup, answer_teardown)
