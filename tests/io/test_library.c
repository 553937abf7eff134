/* The catalogue: every shipped entry with its source and range, and as part of a case; what is given beside a type;
 * files that a case includes, and what is wrong with them; estimated stiffness, and the list of what nobody gave. */
#include "tests/io/case_fixture.h"

#include <sys/stat.h>
#include <unistd.h>

#include "io/case/library.h"
#include "io/case/units.h"
#include "tests/support/scratch.h"

enum { TEXT_MAX = 4000 };

static const char HEAD[] =
    "chain: [{cable: c, length: 10 m}]\nroute: {pieces: [{straight: 20 m}]}\nrun: {duration: 1 s}\n";
static const char REEL_HEAD[] =
    "chain: [{cable: c, length: 10 m}]\nroute: {head_at: 4 m, pieces: [{straight: 20 m}]}\nrun: {duration: 1 s}\n";

/* ------------------------------------------------------------------------------------------------- the shipped entries
 */

/* An entry in the least case that it can be in. */
static void case_of_entry(const LibraryEntry *e, char *text)
{
    static const char *const forms[] = {
        [LIBRARY_CABLES] = "cables: {c: {type: %s}}\n",
        [LIBRARY_ROPES] = "cables: {c: {type: %s}}\n",
        [LIBRARY_ROLLERS] = "cables: {c: {d: 50 mm, mass: 4 kg/m}}\nrollers: {along: {type: %s, spacing: 2 m}}\n",
        [LIBRARY_DUCTS] = "cables: {c: {d: 20 mm, mass: 1 kg/m}}\nsurfaces: {ducts: [{type: %s}]}\n",
        [LIBRARY_FRICTION] = "cables: {c: {d: 20 mm, mass: 1 kg/m}}\nfriction: {type: %s}\n",
        [LIBRARY_REELS] = "cables: {c: {d: 20 mm, mass: 1 kg/m}}\nreel: {type: %s, distance: 3 m, inertia: 90 kg m2}\n",
    };
    size_t n = (size_t)sprintf(text, "%s", e->kind == LIBRARY_REELS ? REEL_HEAD : HEAD);
    char form[200];
    snprintf(form, sizeof form, "%s", forms[e->kind]);
    char *const hole = strstr(form, "%s");
    n += (size_t)sprintf(text + n, "%.*s%s%s", (int)(hole - form), form, e->name, hole + 2);
    assert_true(n < TEXT_MAX);
}

static void case_accepts(const LibraryEntry *e)
{
    char text[TEXT_MAX], *description = NULL;
    hawser_error err;
    case_of_entry(e, text);
    hawser_case *const c = case_with(text, NULL);
    if (hawser_case_describe(c, HAWSER_TABLE, &description, &err)) fail_msg("%s: %s", e->name, err.message);
    assert_non_null(strstr(description, e->name)); /* check says where the figures are from */
    hawser_text_free(description);
    hawser_case_free(c);
}

static double number(const Units *units, const char *text, const char *key)
{
    static const struct {
        const char *key;
        Dimension dimension;
    } known[] = {{"d", DIM_LENGTH},      {"mass", DIM_LINE_MASS}, {"strength", DIM_FORCE}, {"EA", DIM_FORCE},
                 {"radius", DIM_LENGTH}, {"width", DIM_LENGTH},   {"rating", DIM_FORCE},   {"mu", DIM_NONE},
                 {"barrel", DIM_LENGTH}, {"flange", DIM_LENGTH},  {"area", DIM_AREA}};
    char why[UNITS_WHY_MAX];
    double value = NAN;
    for (size_t k = 0; k < sizeof known / sizeof *known; k++) {
        if (strcmp(known[k].key, key) == 0 && !units_read(units, text, known[k].dimension, &value, why))
            fail_msg("%s %s", text, why);
    }
    if (isnan(value)) fail_msg("no dimension is known of '%s'", key);
    return value;
}

/* A share between 0 and 1, or two ends with the value between them. */
static void range_holds(const Units *units, const LibraryEntry *e, const CaseNode *range)
{
    const CaseNode *const value = case_node_key(e->node, range->key);
    if (!value) fail_msg("%s: a range of '%s', which it does not have", e->name, range->key);
    if (range->kind == NODE_TEXT) {
        char *end;
        const double percent = strtod(range->text, &end);
        assert_string_equal(end, " %");
        check_above(percent, 0);
        check_below(percent, 50);
        return;
    }
    const double at = number(units, value->text, range->key), from = number(units, range->first->text, range->key),
                 to = number(units, range->last->text, range->key);
    if (!(from <= at && at <= to && from < to)) fail_msg("%s: %s is not in its range", e->name, range->key);
}

TEST(every_entry)
{
    static const int least[LIBRARY_KINDS] = {150, 20, 15, 80, 20, 8};
    int found[LIBRARY_KINDS] = {0};
    hawser_error err;
    Library *const library = library_new();
    Units *const units = units_new();
    if (library_ship(library, &err)) fail_msg("%s", err.message);
    for (int i = 0; i < library->n_entries; i++) {
        const LibraryEntry *const e = &library->entry[i];
        const CaseNode *const range = case_node_key(e->node, "range"), *const source = case_node_key(e->node, "source");
        found[e->kind]++;
        if (!range || range->count == 0 || !source || !case_node_key(e->node, "mark"))
            fail_msg("%s: no range, source or mark", e->name);
        if (strcmp(e->source, source->text) == 0) fail_msg("%s: its source is not among the file's sources", e->name);
        check_above((double)strlen(e->source), 20);
        for (const CaseNode *r = range->first; r; r = r->next) range_holds(units, e, r);
        case_accepts(e);
    }
    for (int k = 0; k < LIBRARY_KINDS; k++) check_above(found[k], least[k] - 1);
    units_free(units);
    library_free(library);
}

/* ------------------------------------------------------------------------------------------------- given beside a type
 */

/* The least case with these cables. */
static hawser_status cables_read(const char *cables, SceneDef *def, hawser_error *err)
{
    char text[TEXT_MAX];
    snprintf(text, sizeof text, "%scables: {c: %s}\n", HEAD, cables);
    return read_with(text, NULL, NULL, def, err);
}

static void cable_good(const char *cables, SceneDef *def)
{
    hawser_error err;
    if (cables_read(cables, def, &err)) fail_msg("%s", err.message);
}

/* What a case gives wins, also where it says the same in other words. */
TEST(given_wins)
{
    SceneDef def;
    hawser_error err;
    cable_good("{type: steel-6x36-14}", &def);
    check_share(def.cables[0].ea, 9.02e6, 1e-12);
    check_share(def.cables[0].strength, 124e3, 1e-12);
    check_share(def.cables[0].mass, 0.802, 1e-12);
    scene_def_clear(&def);
    cable_good("{type: steel-6x36-14, EA: 8 MN, mass: 0.9 kg/m}", &def);
    check_share(def.cables[0].ea, 8e6, 1e-12);
    check_share(def.cables[0].mass, 0.9, 1e-12);
    check_share(def.cables[0].diameter, 0.014, 1e-12);
    scene_def_clear(&def);
    cable_good("{type: steel-6x36-14, E: 100 GPa, G: 40 GPa, A: 80 mm2}", &def);
    check_share(def.cables[0].ea, 8e6, 1e-12); /* E A, not the entry's 9.02 MN */
    assert_int_equal(def.cables[0].estimated, 0);
    scene_def_clear(&def);
    assert_int_equal(cables_read("{type: steel-6x36-14, E: 100 GPa}", &def, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "key 'cables.c.EA': missing: give it, or E and A");
}

/* Wherever a type may stand; a friction within. */
TEST(every_place)
{
    SceneDef def;
    expect_good(data_text("full-library"), NULL, NULL, &def);
    check_share(def.cables[0].diameter, 0.0437, 1e-12);
    check_share(def.cables[2].strength, 130e3, 1e-12);
    check_share(def.rollers[0].radius, 0.040, 1e-12);
    check_share(def.rollers[0].rating, 5e3, 1e-12);
    check_share(def.rollers[def.n_rollers - 1].radius, 0.150, 1e-12);
    check_share(def.surfaces[0].shape.radius, 0.048, 1e-12);
    check_share(def.friction.mu_d, 0.15, 1e-12);
    scene_def_clear(&def);
    expect_good(data_text("full-library"), "surfaces.ducts.0.friction", "{type: pe-jacket/pvc-duct/dry}", &def);
    check_share(def.surfaces[0].friction.mu_d, 0.34, 1e-12); /* a PE jacket's; it was 0.55, another jacket's */
    scene_def_clear(&def);
    expect_good(data_text("full-library"), "friction.mu", "0.3", &def);
    check_share(def.friction.mu_s, 0.3, 1e-12);
    scene_def_clear(&def);
}

TEST(unknown_types)
{
    expect_bad(
        data_text("full-library"), "cables.power.type", "xlpe-33kv-24-al",
        "key 'cables.power.type': value 'xlpe-33kv-24-al' is not in the catalogue: did you mean 'xlpe-33kv-240-al'");
    expect_bad(data_text("full-library"), "rollers.along.type", "steel-6x36-14", "(hawser library rollers)");
    expect_bad(data_text("full-library"), "friction.type", "pe-jacket/pvc-duct/dri",
               "did you mean 'pe-jacket/pvc-duct/dry'");
    /* what does not go together is found in the case */
    expect_bad(data_text("full-library"), "cables.power.d", "120 mm",
               "key 'surfaces.ducts.0.radius': 0.048 m is too small");
}

/* --------------------------------------------------------------------------------------------------------- includes */

/* Reads the folder's case.yaml with this include and this type. */
static hawser_status included(const char *include, const char *type, SceneDef *def, hawser_error *err)
{
    char text[TEXT_MAX];
    CaseTree *tree;
    snprintf(text, sizeof text, "%sinclude: %s\ncables: {c: {type: %s}}\n", HEAD, include, type);
    assert_int_equal(case_tree_load(scratch_write("case.yaml", text), &tree, err), HAWSER_OK);
    const hawser_status status = case_read(tree, def, err);
    case_tree_free(tree);
    return status;
}

static void include_refused(const char *include, const char *where, const char *part)
{
    SceneDef def;
    hawser_error err;
    assert_int_equal(included(include, "mine", &def, &err), HAWSER_ERR_INPUT);
    check_has(err.message, where);
    check_has(err.message, part);
    assert_null(strchr(err.message, '\n'));
}

/* A user's own entries come first, also before shipped ones of the same name; files in files, each once. */
TEST(includes_are_read)
{
    SceneDef def;
    hawser_error err;
    scratch_write("mine.yaml", "include: [deeper.yaml, both.yaml]\ncables:\n  mine: {d: 50 mm, mass: 4 kg/m}\n");
    scratch_write("deeper.yaml",
                  "include: both.yaml\nropes:\n  steel-6x36-14: {d: 15 mm, mass: 1 kg/m, strength: 99 kN}\n");
    scratch_write(
        "both.yaml",
        "sources: {sheet: a data sheet of our own}\ncables:\n  other: {d: 60 mm, mass: 5 kg/m, source: sheet}\n");
    assert_int_equal(included("mine.yaml", "mine", &def, &err), HAWSER_OK);
    check_share(def.cables[0].diameter, 0.05, 1e-12);
    scene_def_clear(&def);
    assert_int_equal(included("[mine.yaml, both.yaml]", "other", &def, &err), HAWSER_OK);
    check_has(def.assumptions[0].source, "other (typical): a data sheet of our own");
    scene_def_clear(&def);
    assert_int_equal(included("mine.yaml", "steel-6x36-14", &def, &err), HAWSER_OK);
    check_share(def.cables[0].strength, 99e3, 1e-12);
    scene_def_clear(&def);
    assert_int_equal(included("mine.yaml", "steel-6x36-16", &def, &err),
                     HAWSER_OK); /* the shipped ones are there too */
    scene_def_clear(&def);
}

TEST(includes_are_refused)
{
    char text[100], name[20];
    include_refused("nix.yaml", "case.yaml:4: key 'include': value 'nix.yaml'", "cannot be read: No such file");
    include_refused("[case.yaml]", "case.yaml:", "unknown key");
    include_refused("[.]", "case.yaml:4: key 'include.0'", "is not a file");
    include_refused("/dev/zero", "case.yaml:4: key 'include'", "is not a file");
    include_refused("{a: b}", "case.yaml:4: key 'include'", "expected a list of files");
    scratch_write("a.yaml", "include: [b.yaml]\n");
    scratch_write("b.yaml", "cables: {}\ninclude: [a.yaml]\n");
    include_refused("a.yaml", "b.yaml:2: key 'include.0': value 'a.yaml'", "a circle");
    for (int k = 0; k < 10; k++) {
        snprintf(name, sizeof name, "deep%d.yaml", k % 10);
        snprintf(text, sizeof text, "include: deep%d.yaml\n", (k + 1) % 100);
        scratch_write(name, text);
    }
    include_refused("deep0.yaml", "deep7.yaml:1: key 'include'", "too deep");
    scratch_write("bad.yaml", "cables:\n  mine:\n    d: 50 mm\n    mass: 5 kN\n");
    include_refused("bad.yaml", "bad.yaml:4: key 'cables.c.mass': value '5 kN'", "expected a mass per length");
    scratch_write("bad.yaml", "cables:\n  mine:\n    densty: 5\n");
    include_refused("bad.yaml", "bad.yaml:3: key 'cables.c.densty'", "unknown key: did you mean 'density'?");
    scratch_write("bad.yaml", "cabels: {}\n");
    include_refused("bad.yaml", "bad.yaml:1: key 'cabels'", "did you mean 'cables'?");
    scratch_write("bad.yaml", "cables: {x: 7}\n");
    include_refused("bad.yaml", "bad.yaml:1: key 'cables.x'", "expected a map of keys and values");
    scratch_write("bad.yaml", "cables: {x: {mark: sure}}\n");
    include_refused("bad.yaml", "key 'cables.x.mark'", "expected typical or estimated");
    scratch_write("bad.yaml", "cables: {x: {range: {d: {a: 1}}}}\n");
    include_refused("bad.yaml", "key 'cables.x.range.d'", "expected [from, to]");
    scratch_write("bad.yaml", "ropes: {x: {}}\n");
    scratch_write("same.yaml", "cables: {x: {}}\n");
    include_refused("[bad.yaml, same.yaml]", "same.yaml:1: key 'cables.x': this name is taken", "bad.yaml:1");
    scratch_write("bad.yaml", "cables: [\n");
    include_refused("bad.yaml", "bad.yaml:", "YAML");
    assert_int_equal(truncate(scratch_write("large.yaml", "#"), LIBRARY_FILE_BYTES + 1), 0);
    include_refused("large.yaml", "case.yaml:4: key 'include'", "too large");
}

/* A text has no folder: nothing is opened for it, until it is given one. */
TEST(texts_include_nothing)
{
    char text[TEXT_MAX];
    hawser_case *c = NULL;
    hawser_error err;
    snprintf(text, sizeof text, "%sinclude: own.yaml\ncables: {c: {type: mine}}\n", HEAD);
    scratch_write("own.yaml", "cables:\n  mine: {d: 50 mm, mass: 4 kg/m}\n");
    assert_int_equal(hawser_case_parse(text, NAME, &c, &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    check_has(err.message, NAME ":4: key 'include': value 'own.yaml': a case that is a text has no folder");
    assert_int_equal(hawser_case_folder(c, scratch_folder(), &err), HAWSER_OK);
    if (hawser_case_check(c, &err)) fail_msg("%s", err.message);
    assert_int_equal(hawser_case_set(c, "include", "/dev/null", &err), HAWSER_OK);
    assert_int_equal(hawser_case_check(c, &err), HAWSER_ERR_INPUT);
    hawser_case_free(c);
}

/* Another catalogue in place of the shipped one. */
TEST(environment_names_another)
{
    SceneDef def;
    hawser_error err;
    char *text = NULL;
    const char *const path = scratch_path("catalogue");
    assert_int_equal(mkdir(path, 0700), 0);
    scratch_write("catalogue/only.yaml", "cables:\n  only: {d: 50 mm, mass: 4 kg/m}\n");
    setenv("HAWSER_LIBRARY", path, 1);
    cable_good("{type: only}", &def);
    scene_def_clear(&def);
    assert_int_equal(cables_read("{type: steel-6x36-14}", &def, &err), HAWSER_ERR_INPUT);
    assert_int_equal(hawser_library(NULL, NULL, HAWSER_CSV, &text, &err), HAWSER_OK);
    check_has(text, "only");
    hawser_text_free(text);
    setenv("HAWSER_LIBRARY", "/nowhere", 1);
    assert_int_equal(cables_read("{type: only}", &def, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "HAWSER_LIBRARY, '/nowhere', is not a folder");
    unsetenv("HAWSER_LIBRARY");
}

/* ------------------------------------------------------------------------------------------------- what nobody gave */

static const hawser_assumption *assumption(const SceneDef *def, const char *key)
{
    for (int i = 0; i < def->n_assumptions; i++) {
        if (strcmp(def->assumptions[i].key, key) == 0) return &def->assumptions[i];
    }
    fail_msg("no assumption '%s'", key);
    return NULL;
}

/* Neither the calculation nor a run asks for a rigidity; the estimates are those of the formulas, and said. */
TEST(stiffness_is_estimated)
{
    SceneDef def;
    cable_good("{d: 87.3 mm, mass: 14 kg/m, conductor: {material: copper, area: 800 mm2}}", &def);
    check_share(def.cables[0].ea, 79.7557e6, 1e-5);
    check_share(def.cables[0].ei_y, 2417.96, 1e-5);
    check_share(def.cables[0].ei_z, 2417.96, 1e-5);
    check_share(def.cables[0].gj, 2417.96 / 1.35, 1e-5);
    check_share(def.cables[0].ga, 79.7557e6 / 2.7, 1e-5);
    assert_string_equal(assumption(&def, "cables.c.EI")->origin, "estimated");
    check_has(assumption(&def, "cables.c.EI")->source, "good within a factor of 2.6");
    check_has(assumption(&def, "cables.c.EI")->source, "it matters in bends and ducts, not for theory");
    assert_string_equal(assumption(&def, "cables.c.mass")->origin, "given");
    assert_string_equal(assumption(&def, "cables.c.mass")->value, "14 kg/m");
    scene_def_clear(&def);
    /* what is given stays as it was, and what goes with it follows */
    cable_good("{d: 87.3 mm, mass: 14 kg/m, EI: 1 kN m2, EA: 100 MN}", &def);
    check_share(def.cables[0].ei_y, 1e3, 0);
    check_share(def.cables[0].gj, 1e3 / 1.35, 1e-12);
    check_share(def.cables[0].ga, 100e6 / 2.7, 1e-12);
    scene_def_clear(&def);
    hawser_error err;
    assert_int_equal(cables_read("{d: 1e-90 m, mass: 1 kg/m}", &def, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "key 'cables.c.d': 1e-90 m is too thin for an estimate");
    /* a case that says all of it has nothing to list */
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    assert_int_equal(def.n_assumptions, 0);
    scene_def_clear(&def);
}

/* Given, catalogue and estimated side by side; rollers of one type stand once. */
TEST(assumptions_are_listed)
{
    SceneDef def;
    expect_good(data_text("full-library"), "surfaces.ducts",
                "[{type: pe-110-sdr17, to: 5 m}, {type: pe-110-sdr17, from: 10 m}]", &def);
    assert_string_equal(assumption(&def, "cables.power.d")->origin, "catalogue");
    check_has(assumption(&def, "cables.power.d")->source, "xlpe-33kv-240-al (estimated, +- 12 %)");
    assert_string_equal(assumption(&def, "cables.rope.strength")->origin, "given");
    assert_string_equal(assumption(&def, "cables.rope.EA")->origin, "catalogue");
    assert_string_equal(assumption(&def, "cables.rope.EI")->origin, "estimated");
    assert_string_equal(assumption(&def, "rollers.along.rating")->value, "5 kN");
    assert_string_equal(assumption(&def, "friction.mu")->value, "0.15");
    int ducts = 0;
    for (int i = 0; i < def.n_assumptions; i++) ducts += strncmp(def.assumptions[i].key, "surfaces.ducts", 14) == 0;
    assert_int_equal(ducts, 1);
    scene_def_clear(&def);
}

/* The limits that a chain's own cables answer; a section of its own wins. */
TEST(limits_from_cables)
{
    static const char text[] = "cables: {c: {type: xlpe-33kv-240-al}, r: {type: steel-6x36-14}}\n"
                               "chain: [{cable: c, length: 10 m}, {cable: r, length: 5 m}]\n"
                               "route: {pieces: [{straight: 20 m}]}\nrun: {duration: 1 s}\nlimits: {}\n";
    SceneDef def;
    expect_good(text, NULL, NULL, &def);
    assert_int_equal(def.limits.metal, METAL_ALUMINIUM);
    check_share(def.limits.area, 240e-6, 1e-12);
    check_share(def.limits.rope_strength, 124e3, 1e-12);
    scene_def_clear(&def);
    expect_good(text, "limits", "{conductor: {material: copper, area: 95 mm2}, rope_strength: 50 kN}", &def);
    assert_int_equal(def.limits.metal, METAL_COPPER);
    check_share(def.limits.area, 95e-6, 1e-12);
    check_share(def.limits.rope_strength, 50e3, 1e-12);
    scene_def_clear(&def);
}

/* What `hawser library` prints, and what it cannot. */
TEST(catalogue_is_listed)
{
    char *text = NULL;
    hawser_error err;
    assert_int_equal(hawser_library("ducts", "sdr17", HAWSER_TABLE, &text, &err), HAWSER_OK);
    check_has(text, "pe-160-sdr17");
    assert_null(strstr(text, "sdr11"));
    hawser_text_free(text);
    assert_int_equal(hawser_library("duct", NULL, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    assert_null(text);
    check_has(err.message, "'duct' is no kind of the catalogue");
    assert_int_equal(hawser_library("ropes", "hemp-1", HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "near are 'hmpe-1");
}

TEST_GROUP(scratch_make, scratch_remove)
