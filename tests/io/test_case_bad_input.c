/* Every key of the tables, wrong in every way: missing, misspelt, of the wrong type or unit, not a number, not finite,
 * out of range, with garbage behind it. Each must be refused with file, line and key. */
#include "tests/io/case_fixture.h"

#include "core/checkpoint.h"
#include "io/case/case_parts.h"
#include "io/case/yaml.h"

enum { TEXT_MAX = 16384, VALUE_MAX = 64, KEYS_MAX = 1200 };

/* The keys that were met in some text, and how many mistakes were made. */
typedef struct Coverage {
    const CaseKey *met[KEYS_MAX];
    uint64_t path[KEYS_MAX]; /* of each: a hash of where it stands */
    int n, mistakes;
} Coverage;

/* One key of one text: what it is by the tables and where it stands. */
typedef struct Site {
    const char *text;
    const CaseNode *node;
    const CaseKey *key;
    char path[CASE_PATH_MAX];
} Site;

static int depth_of(const char *line) { return (int)strspn(line, " "); }

/* The text with the line of the key changed: `name` for its key (NULL: kept), `value` for its value (NULL: kept, "-":
 * the line goes). With a new value or none, the lines below it that belong to it go too. */
static void text_edit(const Site *site, const char *name, const char *value, char *out)
{
    int number = 1, skipping = -1;
    *out = 0;
    for (const char *line = site->text; *line; number++) {
        const size_t length = strcspn(line, "\n") + 1;
        const int depth = depth_of(line);
        if (depth <= skipping) skipping = -1;
        if (number == site->node->line) {
            const int goes = value && strcmp(value, "-") == 0;
            const char *key = name ? name : site->key->name;
            out += sprintf(out, "%*s", goes ? 0 : depth, "");
            if (value && !goes) out += sprintf(out, "%s: %s\n", key, value);
            if (!value)
                out +=
                    sprintf(out, "%s%.*s", key, (int)(length - (size_t)(strchr(line, ':') - line)), strchr(line, ':'));
            if (value) skipping = depth;
        } else if (skipping < 0) {
            memcpy(out, line, length);
            out += length;
            *out = 0;
        }
        line += length;
    }
}

/* The changed text is refused, with `part` in the message; `path`: the key that it must name. line 0: any line. */
static void refused(const char *text, int line, const char *path, const char *part)
{
    char place[80], key[CASE_PATH_MAX + 8];
    hawser_error err;
    SceneDef def;
    const hawser_status status = read_with(text, NULL, NULL, &def, &err);
    if (!status) {
        scene_def_clear(&def);
        fail_msg("accepted, a wrong %s:\n%s", path, text);
    }
    assert_int_equal(status, HAWSER_ERR_INPUT);
    snprintf(place, sizeof place, line ? NAME ":%d: " : NAME ":", line);
    snprintf(key, sizeof key, "key '%s", path);
    if (strncmp(err.message, place, strlen(place)) != 0) fail_msg("does not begin with %s: %s", place, err.message);
    if (!strstr(err.message, key)) fail_msg("does not say %s: %s", key, err.message);
    if (!strstr(err.message, part)) fail_msg("does not say %s: %s", part, err.message);
    assert_null(strchr(err.message, '\n'));
}

static void value_refused(const Site *site, const char *value, const char *part, Coverage *coverage)
{
    static char text[TEXT_MAX];
    text_edit(site, NULL, value, text);
    refused(text, site->node->line, site->path, part);
    coverage->mistakes++;
}

static void misspelt(const Site *site, Coverage *coverage)
{
    static char text[TEXT_MAX];
    char name[80], path[CASE_PATH_MAX + 8];
    snprintf(name, sizeof name, "%s%c", site->key->name, site->key->name[strlen(site->key->name) - 1]);
    snprintf(path, sizeof path, "%s%c'", site->path, site->path[strlen(site->path) - 1]);
    text_edit(site, name, NULL, text);
    refused(text, site->node->line, path, "unknown key");
    coverage->mistakes++;
}

/* Without the key: required ones are missed, others may be, or not. */
static void missing(const Site *site, Coverage *coverage)
{
    static char text[TEXT_MAX];
    hawser_error err;
    SceneDef def;
    text_edit(site, NULL, "-", text);
    if (site->key->required) {
        refused(text, 0, site->path, "missing");
    } else if (read_with(text, NULL, NULL, &def, &err)) {
        assert_int_equal(err.status, HAWSER_ERR_INPUT);
        check_has(err.message, "key '");
    } else {
        scene_def_clear(&def);
    }
    coverage->mistakes++;
}

/* Numbers beyond both ends of the range: bare, but for angles, of which a bare one is asked about. */
static void out_of_range(const Site *site, Coverage *coverage)
{
    char value[VALUE_MAX];
    const CaseKey *key = site->key;
    const int angle = key->kind == KEY_NUMBER && (key->dimension == DIM_ANGLE || key->dimension == DIM_SLOPE);
    const char *whole = key->kind == KEY_INTEGER ? "%.0f" : angle ? "%.17g rad" : "%.17g";
    const double size = fabs(key->max) + 1;
    snprintf(value, sizeof value, whole, key->min - size);
    value_refused(site, value, "out of range: must be ", coverage);
    snprintf(value, sizeof value, whole, key->max + size);
    value_refused(site, value, "out of range: must be ", coverage);
    snprintf(value, sizeof value, whole, key->min);
    if (key->above) value_refused(site, value, "out of range: must be above", coverage);
    if (key->min >= 0) value_refused(site, angle ? "-1 rad" : "-1", "out of range: must be ", coverage);
    if (angle) value_refused(site, "5", "is that degrees? write '5 deg' or '5 rad'", coverage);
}

static void wrong_number(const Site *site, Coverage *coverage)
{
    static const char *const texts[] = {
        "nan",   ".nan", "NaN",   "inf",         "-inf", ".inf",   "1e400", "115e9x", "115e9 x",
        "0x10",  "1,5",  "'1 2'", "abc",         "''",   "",       "~",     "true",   "5 kg rad5",
        "1.2.3", "--1",  "1e",    "1 m garbage", "[1]",  "{a: 1}", "[]",    "{}",     "5 m @ 2"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) value_refused(site, texts[k], ": expected", coverage);
    out_of_range(site, coverage);
}

static void wrong_integer(const Site *site, Coverage *coverage)
{
    static const char *const texts[] = {"nan", "inf", "2.5", "2x", "2 m", "0x2",   "1e0",
                                        "two", "''",  "",    "~",  "[1]", "{a: 1}"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) value_refused(site, texts[k], ": expected", coverage);
    value_refused(site, "99999999999999999999", "too large", coverage);
    out_of_range(site, coverage);
}

static void wrong_point(const Site *site, Coverage *coverage)
{
    static const char *const texts[] = {"7",          "[1, 2]", "[1, 2, 3, 4]",      "[1, 2, nan]", "[1, inf, 3]",
                                        "[1, 2, 3x]", "{a: 1}", "[1, 2, 5 kg rad5]", "''",          "[[1], 2, 3]"};
    for (size_t k = 0; k < sizeof texts / sizeof *texts; k++) value_refused(site, texts[k], "expected", coverage);
    value_refused(site, "[1, 1e30, 3]", "out of range", coverage);
}

/* Values with forms of their own. */
static void wrong_any(const Site *site, Coverage *coverage)
{
    static const struct {
        const char *key, *texts[10];
    } forms[] = {
        {"gravity", {"5 kg", "nan", "-1", "inf", "9.8x", "[0, 0]", "[0, 0, nan]", "{a: 1}", "", "1e9"}},
        {"origin",
         {"7", "aut", "[1, 2]", "[1, 2, nan]", "[1, 2, 3x]", "{a: 1}", "[1, 2, 5 kg]", "''", "[[1], 2, 3]", "nan"}},
        {"place", {"7", "aut", "[1]", "[1, 2, 3]", "[1, nan]", "[1, 5 kg]", "{a: 1}", "''", "[[1], 2]", "nan"}},
        {"plane", {"upp", "5 kg", "nan", "inf", "[1]", "{a: 1}", "", "30x", "1000 deg", "-7"}},
        {"along",
         {"7", "[7]", "[[1]]", "{a: 1}", "[{from: 1}, {}]", "''", "{spacing: 1, count: 2}", "{}", "[~]", "nan"}},
        {"law", {"stik", "true", "7", "[7]", "{a: 1}", "", "''", "Stick", "stick adams", "nan"}},
        {"accuracy", {"aut", "5 kg", "nan", "inf", "0", "-1", "[1]", "{a: 1}", "", "1"}},
        {"segment", {"aut", "5 kg", "nan", "inf", "0", "-1", "[1]", "{a: 1}", "", "500 mn"}},
        {"where", {"bend", "true", "7", "[7]", "[[1, 2, 3]]", "[[2, 1]]", "[[1, nan]]", "{a: 1}", "", "[[1, 5 kg]]"}},
        {"hold_down",
         {"sagg", "true", "7", "[7]", "[[1, 2, 3]]", "[[2, 1]]", "[[1, nan]]", "{a: 1}", "", "[[1, 5 kg]]"}},
        {"k", {"5 kg", "nan", "inf", "-1", "0", "1e8 N/m^9", "1e8 N/m", "[1]", "1e8x", ""}},
        {"include", {"7", "{a: 1}", "''", "", "[7]", "[{a: 1}]", "nan", "[[a]]", "[~]", "/dev/null"}},
        {"ignore", {"7", "{a: 1}", "''", "cots", "[costs]", "[[cost]]", "[~]", "[cost, checkd]", "nan", "[{a: 1}]"}},
        {"type", {"bogus", "5 kg", "nan", "[a]", "{a: 1}", "''", "", "7", "[7]", "Straight"}},
        {"positions",
         {"7", "[]", "[aut]", "[nan]", "{step: 0}", "{step: 5 kg}", "{a: 1}", "''", "[[1], 2]", "{from: nan}"}},
        {"profile", {"7", "[7]", "[]", "''", "nan", "{a: 1}", "{}", "{file: []}", "[{station: 1}]", "[~]"}},
        {"stations",
         {"7", "[7]", "{a: 1}", "{spacing: nan}", "{spacing: 0}", "[{name: A}]", "[{at: 1}]", "''", "nan",
          "{list: 7}"}},
    };
    for (size_t f = 0; f < sizeof forms / sizeof *forms; f++) {
        if (strcmp(forms[f].key, site->key->name) != 0) continue;
        for (int k = 0; k < 10; k++) value_refused(site, forms[f].texts[k], "", coverage);
        return;
    }
    fail_msg("no wrong forms of '%s' are known", site->key->name);
}

/* Values of the wrong kind: a map, list or text in place of another. */
static void wrong_kind(const Site *site, const char *const texts[4], Coverage *coverage)
{
    for (int k = 0; k < 4 && texts[k]; k++) value_refused(site, texts[k], "expected", coverage);
}

static void wrong_value(const Site *site, Coverage *coverage)
{
    static const char *const no_map[4] = {"7", "[7]", "''", "nan"}, *const no_list[4] = {"7", "{a: 1}", "''", "nan"},
                             *const no_text[4] = {"[a]", "{a: 1}", "[]", "{}"},
                             *const no_word[4] = {"bogus", "''", "[a]", "7"};
    switch (site->key->kind) {
    case KEY_NUMBER:
        wrong_number(site, coverage);
        break;
    case KEY_INTEGER:
        wrong_integer(site, coverage);
        break;
    case KEY_POINT:
        wrong_point(site, coverage);
        break;
    case KEY_ANY:
        wrong_any(site, coverage);
        break;
    case KEY_FLAG:
    case KEY_CHOICE:
        wrong_kind(site, no_word, coverage);
        break;
    case KEY_TEXT:
        wrong_kind(site, no_text, coverage);
        break;
    case KEY_SECTION:
    case KEY_MAP:
        wrong_kind(site, no_map, coverage);
        break;
    case KEY_LIST:
        wrong_kind(site, no_list, coverage);
        break;
    }
}

/* The section that a map belongs to, by its path with numbers as N; NULL for maps of names. */
static const CaseSection *section_of(const CaseNode *map)
{
    char path[CASE_PATH_MAX], general[CASE_PATH_MAX] = "";
    size_t n = 0;
    case_path(map, NULL, path);
    if (strncmp(path, "cables.", 7) == 0) n = (size_t)sprintf(general, "cables.NAME");
    for (char *part = n ? strchr(path + 7, '.') : path; part && *part; part = strchr(part + 1, '.')) {
        const char *word = part + (*part == '.');
        const size_t length = strcspn(word, ".");
        const int number = strspn(word, "0123456789") == length && length > 0;
        n += (size_t)snprintf(general + n, sizeof general - n, "%s%.*s", n ? "." : "", number ? 1 : (int)length,
                              number ? "N" : word);
    }
    /* sections that stand in several places are documented in one */
    static const char *const shared[][2] = {{"friction", "friction"},
                                            {"groove", "rollers.along.groove"},
                                            {"spin.bearing", "rollers.along.spin.bearing"},
                                            {"spin.motor", "rollers.along.spin.motor"},
                                            {"spin", "rollers.along.spin"},
                                            {"mount", "rollers.along.mount"},
                                            {"rule", "rollers.along.rule"}};
    const char *known = general;
    for (size_t k = 0; k < sizeof shared / sizeof *shared && known == general; k++) {
        if (strstr(general, shared[k][0])) known = shared[k][1];
    }
    if (strcmp(general, "rollers.along.N") == 0) known = "rollers.along";
    if (strcmp(general, "output.stations.N") == 0) known = "output.stations.list.N";
    /* what a layer repeats of other sections is read, and its mistakes are named, where the marks put it */
    if (strncmp(path, "drawing.layers.", 15) == 0) known = strchr(path + 15, '.') ? "elsewhere" : "drawing.layers.NAME";
    /* likewise what a chain among several has in place of the case's */
    if (strncmp(path, "chains.", 7) == 0) known = strchr(path + 7, '.') ? "elsewhere" : "chains.NAME";
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int sections = case_sections(&case_top, all, 0);
    for (int k = 0; k < sections; k++) {
        if (strcmp(all[k]->path, known) == 0) return all[k];
    }
    return NULL;
}

static void spoil_all(const char *text, const CaseNode *node, Coverage *coverage);

/* All mistakes with one key, then with those below it. */
static void spoil(const char *text, const CaseNode *node, const CaseKey *key, Coverage *coverage)
{
    Site site = {.text = text, .node = node, .key = key};
    case_path(node, NULL, site.path);
    check_below(coverage->n, KEYS_MAX);
    const uint64_t path = checkpoint_hash(site.path, strlen(site.path));
    int again = 0; /* the same place in a text before this one */
    for (int i = 0; i < coverage->n; i++) again |= coverage->met[i] == key && coverage->path[i] == path;
    coverage->path[coverage->n] = path;
    coverage->met[coverage->n++] = key;
    missing(&site, coverage);
    if (!again) misspelt(&site, coverage), wrong_value(&site, coverage);
    spoil_all(text, node, coverage);
}

static void spoil_all(const char *text, const CaseNode *node, Coverage *coverage)
{
    const CaseSection *section = node->kind == NODE_MAP ? section_of(node) : NULL;
    for (const CaseNode *child = node->first; child; child = child->next) {
        const CaseKey *key = section ? case_key_of(section, child->key) : NULL;
        if (section && !key) fail_msg("'%s' is not in section '%s'", child->key, section->path);
        if (key) spoil(text, child, key, coverage);
        if (!key) spoil_all(text, child, coverage);
    }
}

TEST(every_key_wrong_in_every_way)
{
    static const char *const names[] = {
        "full-ramps",      "full-tables",       "full-tension",     "full-tension-table", "full-reel",
        "full-reel-table", "full-reel-weight",  "full-rod",         "full-rod-polyline",  "full-bundle",
        "full-chains",     "full-library",      "full-route",       "full-route-points",  "full-route-plan",
        "full-drawing",    "full-drawing-file", "full-environment", "full-route-file",    "full-route-sheet"};
    Coverage coverage = {.n = 0};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        const char *const text = data_text(names[k]);
        CaseTree *tree;
        hawser_error err;
        SceneDef def;
        expect_good(text, NULL, NULL, &def);
        scene_def_clear(&def);
        assert_int_equal(case_tree_parse(text, NAME, &tree, &err), HAWSER_OK);
        spoil_all(text, tree->root, &coverage);
        case_tree_free(tree);
    }
    const CaseSection *all[CASE_SECTIONS_MAX];
    const int sections = case_sections(&case_top, all, 0);
    for (const CaseSection **s = all; s < all + sections; s++) {
        for (int k = 0; k < (*s)->n; k++) {
            int met = 0;
            for (int i = 0; i < coverage.n; i++) met = met || coverage.met[i] == &(*s)->key[k];
            if (!met) fail_msg("no text has the key '%s' of section '%s'", (*s)->key[k].name, (*s)->path);
        }
    }
    print_message("%d keys, %d mistakes\n", coverage.n, coverage.mistakes);
}

/* The same mistakes by --set are named as settings. */
TEST(settings_are_named)
{
    expect_bad(data_text("full-ramps"), "chain.0.length", "5 kg",
               "--set chain.0.length: key 'chain.0.length': value '5 kg' has the unit");
    expect_bad(data_text("full-ramps"), "chain.0.lenght", "5 m",
               "--set chain.0.lenght: key 'chain.0.lenght': unknown key: did you mean 'length'?");
    expect_bad(data_text("full-ramps"), "drive.wnich.speed", "1",
               "--set drive.wnich.speed: key 'drive.wnich': unknown key: did you mean 'winch'?");
    expect_bad(data_text("full-ramps"), "solver.threads", "9",
               "--set solver.threads: key 'solver.threads': value '9' is out of range");
    expect_bad(data_text("full-ramps"), "gravity", "[0, 0, nan]",
               "--set gravity: key 'gravity.2': value 'nan' is not a number");
}
