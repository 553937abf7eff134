#include "io/case/schema.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/case/library.h"

enum { WANTED_MAX = 128, NAMES_MAX = 64, NUMBER_MAX = 32 };

const char *const case_ramps[] = {"none", "step", "step5", NULL};

/* Adds each section once; a section may have several places (a friction law, for example). */
int case_sections(const CaseSection *section, const CaseSection *all[], int n)
{
    for (int i = 0; i < n; i++) {
        if (all[i] == section) return n;
    }
    assert(n < CASE_SECTIONS_MAX);
    all[n++] = section;
    for (int k = 0; k < section->n; k++) {
        if (section->key[k].section) n = case_sections(section->key[k].section, all, n);
    }
    return n;
}

/* Searches linearly: sections have two dozen keys at most. */
const CaseKey *case_key_of(const CaseSection *section, const char *name)
{
    for (int k = 0; k < section->n; k++) {
        if (strcmp(section->key[k].name, name) == 0) return &section->key[k];
    }
    return NULL;
}

/* Writes a number as people do: 1e6, not 1000000 or 1e+06. */
static const char *number_text(double value, char *text)
{
    snprintf(text, NUMBER_MAX, fabs(value) < 1e5 ? "%.10g" : "%.10e", value);
    char *e = strchr(text, 'e');
    if (!e) return text;
    const long power = strtol(e + 1, NULL, 10);
    snprintf(text, NUMBER_MAX, "%.10ge%ld", value / pow(10, (double)power), power);
    return text;
}

/* Writes angles in degrees, as people do. */
const char *case_range_text(const CaseKey *key, char *text)
{
    char min[NUMBER_MAX], max[NUMBER_MAX];
    const int angle = key->dimension == DIM_ANGLE || key->dimension == DIM_SLOPE, plain = key->dimension == DIM_NONE;
    const double scale = angle ? 180 / 3.14159265358979323846 : 1;
    const char *unit = angle ? "deg" : plain ? "" : dimension_unit(key->dimension), *gap = plain ? "" : " ";
    number_text(key->min * scale, min);
    number_text(key->max * scale, max);
    snprintf(text, CASE_RANGE_MAX, "%s %s%s%s, at most %s%s%s", key->above ? "above" : "at least", min, gap, unit, max,
             gap, unit);
    return text;
}

const char *case_form_text(const CaseKey *key, char *text)
{
    if (key->form) return key->form;
    snprintf(text, CASE_FORM_MAX, "section `%s`", key->section->path);
    return text;
}

/* ": expected a length, such as 500 mm" */
static const char *number_wanted(const CaseKey *key, char *text)
{
    snprintf(text, WANTED_MAX, ": expected %s, such as %s", dimension_name(key->dimension),
             dimension_example(key->dimension));
    return text;
}

hawser_status case_idle_check(const CaseReader *r, const CaseNode *node, int n, const KeyIdle *rule)
{
    for (int i = 0; i < n; i++) {
        const CaseNode *const idle = case_node_key(node, rule[i].key);
        char given[96] = "";
        int all = idle != NULL;
        for (int k = 0; k < 3 && rule[i].beside[k]; k++) {
            const size_t used = strlen(given);
            all &= case_node_key(node, rule[i].beside[k]) != NULL;
            snprintf(given + used, sizeof given - used, "%s'%s'", k ? " and " : "", rule[i].beside[k]);
        }
        if (all && !idle->entry) /* the catalogue may give the same in other keys */
            return case_key_error(r->err, idle, NULL, "has no effect beside %s: leave it out, or change these", given);
    }
    return HAWSER_OK;
}

/* No NaN arrives here: units_read rejects it. */
hawser_status case_range_check(const CaseReader *r, const CaseNode *node, const CaseKey *key, double value)
{
    char range[CASE_RANGE_MAX];
    const int low = key->above ? value <= key->min : value < key->min;
    if (!low && value <= key->max) return HAWSER_OK;
    if (key->dimension == DIM_AREA && node->kind == NODE_TEXT && !node->text[strspn(node->text, "+0123456789.eE")])
        return case_value_error(r->err, node, " is out of range: must be %s; it has no unit: write '%g mm2'",
                                case_range_text(key, range), value);
    return case_value_error(r->err, node, " is out of range: must be %s", case_range_text(key, range));
}

/* Reports errors of the text before those of the value. */
hawser_status case_number_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double *value)
{
    char why[UNITS_WHY_MAX], wanted[WANTED_MAX];
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, "%s", number_wanted(key, wanted));
    if (!units_read(r->units, node->text, key->dimension, value, why)) {
        return case_value_error(r->err, node, " %s%s", why, number_wanted(key, wanted));
    }
    return case_range_check(r, node, key, *value);
}

/* Names the first wrong item by its own key, as in 'gravity.2'. */
hawser_status case_numbers_read(const CaseReader *r, const CaseNode *node, int n, const CaseKey *const key[],
                                double value[])
{
    if (node->kind != NODE_LIST) return case_value_error(r->err, node, ": expected a list of %d numbers", n);
    if (node->count != n) return case_value_error(r->err, node, " of %d: expected %d numbers", node->count, n);
    for (int k = 0; k < n; k++) {
        const hawser_status status = case_number_read(r, case_node_item(node, k), key[k], &value[k]);
        if (status) return status;
    }
    return HAWSER_OK;
}

/* Accepts digits only: '1e3' and '2.0' are rejected, for the value is a count. */
hawser_status case_integer_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, long *value)
{
    static const char wanted[] = ": expected a whole number, such as 2";
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, wanted);
    const char *digits = node->text + (*node->text == '-' || *node->text == '+');
    if (!*digits || digits[strspn(digits, "0123456789")]) {
        return case_value_error(r->err, node, " is not a whole number%s", wanted);
    }
    errno = 0;
    *value = strtol(node->text, NULL, 10);
    if (errno == ERANGE) return case_value_error(r->err, node, " is too large a number");
    return case_range_check(r, node, key, (double)*value);
}

/* Handles int and long: most counts are int, but the number of steps is long. */
static hawser_status integer_field(const CaseReader *r, const CaseNode *node, const CaseKey *key, void *at)
{
    long value = 0;
    const hawser_status status = case_integer_read(r, node, key, &value);
    if (status) return status;
    assert(key->size == sizeof(long) || key->size == sizeof(int));
    if (key->size == sizeof(long)) {
        memcpy(at, &value, sizeof value);
    } else {
        const int small = (int)value;
        memcpy(at, &small, sizeof small);
    }
    return HAWSER_OK;
}

int case_word_place(const CaseNode *node, const char *const *word)
{
    for (int k = 0; node->kind == NODE_TEXT && word[k]; k++) {
        if (strcmp(node->text, word[k]) == 0) return k;
    }
    return -1;
}

/* YAML's words for truth values, in pairs: the even places are false. */
static const char *const truth_words[] = {"false", "true", "no", "yes", "off", "on", NULL};

static hawser_status flag_field(const CaseReader *r, const CaseNode *node, int *value)
{
    const int place = case_word_place(node, truth_words);
    if (place < 0) return case_value_error(r->err, node, ": expected true or false");
    *value = place % 2;
    return HAWSER_OK;
}

/* Writes letters and digits alone, in lower case: "TB 889" becomes tb889. `out` has WANTED_MAX bytes. */
static const char *word_plain(const char *text, char *out)
{
    static const char *const same[][2] = {{"aluminum", "aluminium"}, {"al", "aluminium"}, {"alu", "aluminium"},
                                          {"cu", "copper"},          {"pb", "lead"},      {"cigretb889", "tb889"}};
    size_t n = 0;
    for (; *text && n + 1 < WANTED_MAX; text++) {
        if (isalnum((unsigned char)*text)) out[n++] = (char)tolower((unsigned char)*text);
    }
    out[n] = 0;
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        if (strcmp(out, same[i][0]) == 0) return same[i][1];
    }
    return out;
}

/* Reads a choice; its place in the list is the enumeration's value. Capitals, blanks and usual other names of a choice
 * do not matter; a choice that is a truth value accepts all words for it, since YAML writers exchange them: `planar:
 * false` is `planar: off`. */
static hawser_status choice_field(const CaseReader *r, const CaseNode *node, const CaseKey *key, int *value)
{
    char all[WANTED_MAX] = "", given[WANTED_MAX], allowed[WANTED_MAX];
    const char *const plain = node->kind == NODE_TEXT ? word_plain(node->text, given) : "";
    *value = case_word_place(node, key->choices);
    for (int k = 0; *value < 0 && *plain && key->choices[k]; k++) {
        if (strcmp(plain, word_plain(key->choices[k], allowed)) == 0) *value = k;
    }
    const int truth = case_word_place(node, truth_words);
    for (int k = 0; *value < 0 && truth >= 0 && key->choices[k]; k++) {
        for (int same = truth % 2; same < (int)(sizeof truth_words / sizeof *truth_words) - 1; same += 2) {
            if (strcmp(key->choices[k], truth_words[same]) == 0) *value = k;
        }
    }
    if (*value >= 0) return HAWSER_OK;
    for (int k = 0; key->choices[k]; k++) {
        const size_t used = strlen(all);
        snprintf(all + used, sizeof all - used, "%s%s", k ? ", " : "", key->choices[k]);
    }
    return case_value_error(r->err, node, ": expected one of %s", all);
}

/* Rejects a text that is too long; it is never cut. */
static hawser_status text_field(const CaseReader *r, const CaseNode *node, const CaseKey *key, char *at)
{
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, ": expected a text");
    if (strlen(node->text) >= key->size) {
        return case_value_error(r->err, node, " is too long: at most %zu characters", key->size - 1);
    }
    if (key->required && !*node->text) return case_value_error(r->err, node, " is empty: expected a text");
    strcpy(at, node->text);
    return HAWSER_OK;
}

/* Reads three numbers of one dimension and range. */
static hawser_status point_field(const CaseReader *r, const CaseNode *node, const CaseKey *key, Vec3 *at)
{
    const CaseKey *const keys[3] = {key, key, key};
    double x[3] = {0};
    const hawser_status status = case_numbers_read(r, node, 3, keys, x);
    if (!status) *at = v3(x[0], x[1], x[2]);
    return status;
}

/* Checks only the kind of a value that other code reads. */
static hawser_status node_check(const CaseReader *r, const CaseNode *node, const CaseKey *key)
{
    char form[CASE_FORM_MAX];
    if (key->kind == KEY_MAP && node->kind != NODE_MAP) {
        return case_value_error(r->err, node, ": expected a map (%s)", case_form_text(key, form));
    }
    if (key->kind == KEY_LIST && node->kind != NODE_LIST) {
        return case_value_error(r->err, node, ": expected a list (%s)", case_form_text(key, form));
    }
    return HAWSER_OK;
}

/* Reads one value into its place in the record, by its kind. */
static hawser_status field_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, char *at)
{
    switch (key->kind) {
    case KEY_NUMBER:
        return case_number_read(r, node, key, (double *)(void *)at);
    case KEY_INTEGER:
        return integer_field(r, node, key, at);
    case KEY_FLAG:
        return flag_field(r, node, (int *)(void *)at);
    case KEY_CHOICE:
        return choice_field(r, node, key, (int *)(void *)at);
    case KEY_TEXT:
        return text_field(r, node, key, at);
    case KEY_POINT:
        return point_field(r, node, key, (Vec3 *)(void *)at);
    case KEY_SECTION:
        return case_section_read(r, node, key->section, at);
    case KEY_MAP:
    case KEY_LIST:
    case KEY_ANY:
        break;
    }
    return node_check(r, node, key);
}

/* Sets the meaning of an absent key: its fallback is read as if it had been written; the rest gets a neutral value. */
static hawser_status field_default(const CaseReader *r, const CaseKey *key, char *at)
{
    CaseNode written = {.kind = NODE_TEXT, .origin = "default", .text = (char *)(size_t)key->fallback};
    if (key->kind == KEY_SECTION) return case_section_read(r, NULL, key->section, at);
    if (key->fallback && key->kind != KEY_POINT) return field_read(r, &written, key, at);
    assert(key->otherwise || (key->kind != KEY_FLAG && key->kind != KEY_CHOICE)); /* for its reader */
    memset(at, 0, key->size);
    if (key->kind == KEY_NUMBER) *(double *)(void *)at = NAN;
    return HAWSER_OK;
}

/* Detects {mu: 0,3}: for YAML a key 'mu' with the value 0, and a key '3' without one. */
static int is_comma(const CaseNode *child, const CaseNode *before)
{
    if (!before || before->kind != NODE_TEXT || child->kind != NODE_TEXT || *child->text) return 0;
    const size_t end = strlen(before->text);
    return isdigit((unsigned char)*child->key) && end > 0 && isdigit((unsigned char)before->text[end - 1]);
}

/* Reports the first key of the map that the section does not have. */
static hawser_status keys_check(const CaseReader *r, const CaseNode *map, const CaseSection *section)
{
    const char *name[NAMES_MAX];
    char all[HAWSER_MESSAGE_MAX / 4] = "";
    assert(section->n <= NAMES_MAX);
    for (int k = 0; k < section->n; k++) {
        const size_t used = strlen(all);
        name[k] = section->key[k].name;
        snprintf(all + used, sizeof all - used, "%s%s", k ? ", " : "", name[k]);
    }
    const CaseNode *before = NULL;
    for (const CaseNode *child = map->first; child; before = child, child = child->next) {
        if (case_key_of(section, child->key)) continue;
        if (is_comma(child, before)) {
            return case_key_error(r->err, before, NULL,
                                  "value '%.20s,%.20s' has a comma: decimals follow a point, '%.20s.%.20s'",
                                  before->text, child->key, before->text, child->key);
        }
        const char *nearest = case_nearest(child->key, name, section->n);
        if (nearest) return case_key_error(r->err, child, NULL, "unknown key: did you mean '%s'?", nearest);
        return case_key_error(r->err, child, NULL, "unknown key: allowed are %s", all);
    }
    return HAWSER_OK;
}

/* Reports a missing key with what to write. */
static hawser_status missing(const CaseReader *r, const CaseNode *map, const CaseKey *key)
{
    if (key->kind == KEY_NUMBER) {
        return case_key_error(r->err, map, key->name, "missing: give %s, such as %s", dimension_name(key->dimension),
                              dimension_example(key->dimension));
    }
    char form[CASE_FORM_MAX];
    const int node = key->form || key->section;
    return case_key_error(r->err, map, key->name, "missing: give %s", node ? case_form_text(key, form) : "it");
}

/* Visits every key of the section, present or not, so that the record is always complete. */
hawser_status case_section_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *record)
{
    if (node && node->kind != NODE_MAP) {
        return case_value_error(r->err, node, ": expected a map with keys such as '%s'", section->key[0].name);
    }
    hawser_status status = node ? keys_check(r, node, section) : HAWSER_OK;
    for (int k = 0; !status && k < section->n; k++) {
        const CaseKey *key = &section->key[k];
        const CaseNode *value = case_node_key(node, key->name);
        char *at = (char *)record + key->offset;
        if (value) {
            status = field_read(r, value, key, at);
        } else if (key->required && node) {
            status = missing(r, node, key);
        } else {
            status = field_default(r, key, at);
        }
    }
    return status;
}

hawser_status case_list_read(const CaseReader *r, const CaseNode *list, size_t size, CaseItemRead read, void *array,
                             int *n)
{
    if (!list) return HAWSER_OK;
    char *const items = calloc((size_t)list->count + 1, size);
    if (!items) return error_memory(r->err);
    memcpy(array, &items, sizeof items);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *node = list->first; !status && node; node = node->next) {
        ++*n;
        status = read(r, node, items + (size_t)node->index * size);
    }
    return status;
}

hawser_status case_file_path(const CaseReader *r, const CaseNode *section, const char *file, char **path)
{
    const CaseNode *const node = case_node_key(section, "file");
    const int absolute = *file == '/';
    *path = NULL;
    if (!node) return case_key_error(r->err, section, "file", "missing: it names the file");
    if (!*file) return case_value_error(r->err, node, ": expected the name of a file");
    if (!absolute && !r->folder)
        return case_value_error(r->err, node, ": a case that is a text has no folder to look in: load it from a file");
    const size_t size = (r->folder ? strlen(r->folder) : 0) + strlen(file) + 2;
    *path = malloc(size);
    if (!*path) return error_memory(r->err);
    snprintf(*path, size, "%s%s%s", absolute ? "" : r->folder, absolute ? "" : "/", file);
    return HAWSER_OK;
}

/* Inputs of a case: every key that has a value, and its source. Four sources, in this order: written values,
 * in the tree's order (with those that a `type` brought from the catalogue); estimates; the defaults of missing keys in
 * the tables. A default that several items of a list share is listed once, with N for the item. */

enum { VALUE_MAX = 240, LISTED_MAX = 400 };

/* The list as it grows. */
typedef struct Gathering {
    const CaseReader *r;
    int room;
    int listed[LISTED_MAX], n_listed; /* where in the list the defaults with N in their key begin */
} Gathering;

/* Allocates this many more bytes. */
static hawser_status room_make(Gathering *g, size_t more)
{
    SceneDef *const def = g->r->def;
    const size_t wanted = (size_t)def->inputs_size + more;
    if (wanted <= (size_t)g->room) return HAWSER_OK;
    if (wanted > (size_t)1 << 30) return error_memory(g->r->err);
    const size_t room = 2 * wanted + 4096;
    char *const text = realloc(def->inputs, room);
    if (!text) return error_memory(g->r->err);
    def->inputs = text;
    g->room = (int)room;
    return HAWSER_OK;
}

/* Adds one input: its texts behind the others, each with a NUL (INPUT_TEXTS of them). */
static hawser_status input_add(Gathering *g, const char *const text[INPUT_TEXTS])
{
    SceneDef *const def = g->r->def;
    size_t size = 0;
    for (int k = 0; k < INPUT_TEXTS; ++k) size += strlen(text[k]) + 1;
    const hawser_status status = room_make(g, size);
    if (status) return status;
    for (int k = 0; k < INPUT_TEXTS; ++k) {
        const size_t n = strlen(text[k]) + 1;
        memcpy(def->inputs + def->inputs_size, text[k], n);
        def->inputs_size += (int)n;
    }
    def->n_inputs++;
    return HAWSER_OK;
}

/* Returns the end of the number that the text begins with, in any locale of the program; 0 if there is none. */
static size_t number_length(const char *text)
{
    size_t n = strspn(text, "+-");
    const size_t digits = strspn(text + n, "0123456789.");
    if (digits == 0) return 0;
    n += digits;
    if (text[n] != 'e' && text[n] != 'E') return n;
    const size_t sign = n + 1 + (text[n + 1] == '-' || text[n + 1] == '+');
    return sign + strspn(text + sign, "0123456789") > sign ? sign + strspn(text + sign, "0123456789") : n;
}

/* Splits a number and its unit, "152.5 m"; any other text is all value. Returns the unit, which lies in the text's
 * memory or is empty. */
static const char *unit_cut(char *text)
{
    const size_t n = number_length(text);
    char *const unit = text + n + strspn(text + n, " ");
    if (n == 0 || !*unit || isdigit((unsigned char)*unit) || (unit == text + n && !isalpha((unsigned char)*unit)))
        return "";
    text[n] = 0;
    return unit;
}

static hawser_status value_add(Gathering *g, const char *key, const char *text, const char *origin, const char *where,
                               const char *source)
{
    char value[VALUE_MAX];
    snprintf(value, sizeof value, "%s", text);
    const char *const unit = unit_cut(value);
    return input_add(g, (const char *const[INPUT_TEXTS]){key, value, unit, origin, where, source});
}

/* Writes a list as in a case, "[0, 0, [5, 6]]", cut where it is too long. Returns 0 if it holds a map. */
static int list_text(const CaseNode *list, size_t room, char *text)
{
    size_t n = (size_t)snprintf(text, room, "[");
    for (const CaseNode *item = list->first; item; item = item->next) {
        char inner[VALUE_MAX] = "";
        if (item->kind == NODE_MAP || (item->kind == NODE_LIST && !list_text(item, sizeof inner, inner))) return 0;
        if (n + 8 > room) continue;
        n += (size_t)snprintf(text + n, room - n, "%s%s", item == list->first ? "" : ", ",
                              item->kind == NODE_TEXT ? item->text : inner);
    }
    if (n + 8 > room) n = (size_t)snprintf(text + room - 8, 8, " ...") + room - 8;
    snprintf(text + n, room - n, "]");
    return 1;
}

/* Adds one value that is written in the case, or that its type brought. */
static hawser_status leaf_add(Gathering *g, const CaseNode *node, const char *text)
{
    char path[CASE_PATH_MAX], place[CASE_PLACE_MAX], source[HAWSER_ASSUMPTION_SOURCE_MAX] = "";
    const LibraryEntry *const entry = node->entry;
    if (entry) snprintf(source, sizeof source, "%.63s (%.20s): %.140s", entry->name, entry->mark, entry->source);
    return value_add(g, case_path(node, NULL, path), text, entry ? "catalogue" : "given",
                     case_place(node->origin, node->line, place), source);
}

static hawser_status written_add(Gathering *g, const CaseNode *node)
{
    char list[VALUE_MAX];
    if (node->kind == NODE_TEXT) return leaf_add(g, node, node->text);
    if (node->kind == NODE_LIST && list_text(node, sizeof list, list)) return leaf_add(g, node, list);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = node->first; child && !status; child = child->next) status = written_add(g, child);
    return status;
}

static hawser_status estimates_add(Gathering *g)
{
    const SceneDef *const def = g->r->def;
    hawser_status status = HAWSER_OK;
    for (int i = 0; i < def->n_assumptions && !status; ++i) {
        const hawser_assumption *const a = &def->assumptions[i];
        if (strcmp(a->origin, "estimated") == 0) status = value_add(g, a->key, a->value, a->origin, "", a->source);
    }
    return status;
}

/* Checks whether the default of a list item is listed already, from another item without the key. */
static int is_listed(const Gathering *g, const char *key)
{
    for (int i = 0; i < g->n_listed; ++i) {
        if (strcmp(g->r->def->inputs + g->listed[i], key) == 0) return 1;
    }
    return 0;
}

static int is_estimated(const Gathering *g, const char *key)
{
    const SceneDef *const def = g->r->def;
    for (int i = 0; i < def->n_assumptions; ++i) {
        const hawser_assumption *const a = &def->assumptions[i];
        if (strcmp(a->origin, "estimated") == 0 && strcmp(a->key, key) == 0) return 1;
    }
    return 0;
}

/* Adds the meaning of a missing key, in the words of the table; a key without a default ("none: or `points`") has no
 * value. `many`: the key is that of an item of a list. */
static hawser_status default_add(Gathering *g, const CaseKey *key, const char *path, int many)
{
    char words[VALUE_MAX];
    const char *const text = key->fallback ? key->fallback : key->otherwise;
    if (!text || strncmp(text, "none", 4) == 0) return HAWSER_OK;
    if ((many && is_listed(g, path)) || is_estimated(g, path)) return HAWSER_OK;
    if (many && g->n_listed < LISTED_MAX) g->listed[g->n_listed++] = g->r->def->inputs_size;
    size_t n = 0;
    for (const char *c = text; *c && n + 1 < sizeof words; ++c) {
        if (*c != '`') words[n++] = *c;
    }
    words[n] = 0;
    return value_add(g, path, words, "default", "", "");
}

static hawser_status defaults_add(Gathering *g, const CaseNode *map, const CaseSection *section, const char *path,
                                  int many);

/* Adds the keys missing inside a key's value: of a map its keys, of a map of names or a list those of each item. */
static hawser_status inner_add(Gathering *g, const CaseNode *value, const CaseSection *section, const char *path,
                               int many)
{
    char inner[CASE_PATH_MAX];
    const char *const last = strrchr(section->path, '.');
    const int named = last && strcmp(last, ".NAME") == 0, list = value->kind == NODE_LIST;
    if (value->kind == NODE_TEXT) return HAWSER_OK;
    if (!named && !list) return defaults_add(g, value, section, path, many);
    hawser_status status = HAWSER_OK;
    for (const CaseNode *item = value->first; item && !status; item = item->next) {
        if (item->kind != NODE_MAP) continue;
        const int n = snprintf(inner, sizeof inner, "%s.%s", path, list ? "N" : item->key);
        if (n < (int)sizeof inner) status = defaults_add(g, item, section, inner, many || list);
    }
    return status;
}

/* Adds the missing keys of one section. map NULL: the section itself is missing, and its defaults apply. */
static hawser_status defaults_add(Gathering *g, const CaseNode *map, const CaseSection *section, const char *path,
                                  int many)
{
    char inner[CASE_PATH_MAX];
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < section->n && !status; ++k) {
        const CaseKey *const key = &section->key[k];
        const CaseNode *const value = case_node_key(map, key->name);
        const int whole = key->section && key->otherwise && strcmp(key->otherwise, "its defaults") == 0;
        if (snprintf(inner, sizeof inner, "%s%s%s", path, *path ? "." : "", key->name) >= (int)sizeof inner) continue;
        if (value && key->section) status = inner_add(g, value, key->section, inner, many);
        if (!value && whole) status = defaults_add(g, NULL, key->section, inner, many);
        if (!value && !whole && !key->required) status = default_add(g, key, inner, many);
    }
    return status;
}

hawser_status case_inputs_read(CaseReader *r, const CaseSection *top)
{
    Gathering g = {.r = r};
    hawser_status status = room_make(&g, 1);
    if (!status) status = written_add(&g, r->root);
    if (!status) status = estimates_add(&g);
    return status ? status : defaults_add(&g, r->root, top, "", 0);
}

/* Values that a case does not give itself: those of a `type`, and estimated rigidities. They are collected
 * from the tree after all else has been read, for readers of the results. */

static const char GIVEN[] = "given", CATALOGUE[] = "catalogue", ESTIMATED[] = "estimated", NOT_READ[] = "not read";

/* The growing list, and the entries' values that are in it already. */
typedef struct AssumptionList {
    const CaseReader *r;
    int room;
} AssumptionList;

/* Adds one; NULL without memory. */
static hawser_assumption *assumption_add(AssumptionList *g, const char *key, const char *value, const char *origin)
{
    SceneDef *const def = g->r->def;
    if (def->n_assumptions == g->room) {
        const int room = g->room ? 2 * g->room : 32;
        hawser_assumption *const all = realloc(def->assumptions, (size_t)room * sizeof *all);
        if (!all) return NULL;
        def->assumptions = all;
        g->room = room;
    }
    hawser_assumption *const a = &def->assumptions[def->n_assumptions++];
    *a = (hawser_assumption){.origin = origin};
    snprintf(a->key, sizeof a->key, "%.*s", (int)sizeof a->key - 1, key);
    snprintf(a->value, sizeof a->value, "%.*s", (int)sizeof a->value - 1, value);
    return a;
}

/* Checks whether the list has the same key of the same entry already, from another roller or duct. */
static int is_repeated(const AssumptionList *g, const char *leaf, const char *source)
{
    const SceneDef *const def = g->r->def;
    for (int i = 0; i < def->n_assumptions; i++) {
        const hawser_assumption *const a = &def->assumptions[i];
        const char *const dot = strrchr(a->key, '.');
        if (a->origin == CATALOGUE && dot && strcmp(dot + 1, leaf) == 0 && strcmp(a->source, source) == 0) return 1;
    }
    return 0;
}

/* Writes the range of an entry's value, as in the file: " (70 mm to 75 mm)", " (+- 5 %)"; empty if there is none. */
static const char *range_text(const LibraryEntry *entry, const char *key, size_t room, char *text)
{
    const CaseNode *const range = case_node_key(case_node_key(entry->node, "range"), key);
    *text = 0;
    if (range && range->kind == NODE_TEXT) snprintf(text, room, ", +- %.40s", range->text);
    if (range && range->kind == NODE_LIST)
        snprintf(text, room, ", from %.30s to %.30s", range->first->text, range->last->text);
    return text;
}

/* Adds one value of a part of the case, or those of a map below it. */
static hawser_status assumption_value_add(AssumptionList *g, const CaseNode *node, int once)
{
    char path[CASE_PATH_MAX], source[HAWSER_ASSUMPTION_SOURCE_MAX] = "", range[100];
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = node->kind == NODE_MAP ? node->first : NULL; child && !status; child = child->next) {
        status = assumption_value_add(g, child, once);
    }
    if (node->kind != NODE_TEXT) return status;
    const LibraryEntry *const entry = node->entry;
    if (entry) {
        const int named = snprintf(source, sizeof source, "%.63s (%.20s%.99s): ", entry->name, entry->mark,
                                   range_text(entry, node->key, sizeof range, range));
        snprintf(source + named, sizeof source - (size_t)named, "%s", entry->source);
        if (once && is_repeated(g, node->key, source)) return HAWSER_OK;
    }
    hawser_assumption *const a = assumption_add(g, case_path(node, NULL, path), node->text, entry ? CATALOGUE : GIVEN);
    if (!a) return error_memory(g->r->err);
    memcpy(a->source, source, sizeof a->source);
    return HAWSER_OK;
}

/* Adds all values of a part with a type or an estimate, including the given ones. */
static hawser_status part_add(AssumptionList *g, const CaseNode *part, int once)
{
    hawser_status status = HAWSER_OK;
    for (const CaseNode *child = part->first; child && !status; child = child->next) {
        if (once && !child->entry) continue; /* for rollers, ducts and frictions only values of the type */
        if (strcmp(child->key, "type") != 0) status = assumption_value_add(g, child, once);
    }
    return status;
}

/* Adds an estimated rigidity with its accuracy. */
static hawser_status estimate_add(AssumptionList *g, const CaseNode *cable, const char *key, double value,
                                  const char *unit, const char *worth, ...)
{
    char path[CASE_PATH_MAX], text[HAWSER_ASSUMPTION_VALUE_MAX];
    snprintf(text, sizeof text, "%.3g %s", value, unit);
    hawser_assumption *const a = assumption_add(g, case_path(cable, key, path), text, ESTIMATED);
    if (!a) return error_memory(g->r->err);
    va_list args;
    va_start(args, worth);
    vsnprintf(a->source, sizeof a->source, worth, args);
    va_end(args);
    return HAWSER_OK;
}

static hawser_status assumption_estimates_add(AssumptionList *g, const CaseNode *node, const CableDef *cable)
{
    const StiffnessEstimate e = cable_def_estimate(cable);
    const unsigned which = cable->estimated;
    const char *const from =
        cable->conductor_area > 0 ? "diameter and conductor" : "diameter and mass, the metal taken for copper";
    hawser_status status = HAWSER_OK;
    if (which & CABLE_ESTIMATED_EA) {
        status = estimate_add(g, node, "EA", cable->ea, "N",
                              "(CS2) from %s; good within a factor of %.2g, which hardly changes the pull", from,
                              e.ea_factor);
    }
    if (!status && which & CABLE_ESTIMATED_EI) {
        status =
            estimate_add(g, node, "EI", cable->ei_y, "N m2",
                         "(CS5) from %s; good within a factor of %.2g, from strands that slip to strands that hold: it "
                         "matters in bends and ducts, not for theory",
                         from, e.ei_factor);
    }
    if (!status && which & CABLE_ESTIMATED_GJ) {
        status =
            estimate_add(g, node, "GJ", cable->gj, "N m2", "(CS6) from EI; matters only where the cable is twisted");
    }
    if (!status && which & CABLE_ESTIMATED_GA) {
        status = estimate_add(g, node, "GA", cable->ga, "N", "(CS7) from EA; changes nothing in a long cable");
    }
    return status;
}

/* Adds rollers, ducts and frictions, wherever they are. */
static hawser_status types_add(AssumptionList *g, const CaseNode *node)
{
    hawser_status status = node->kind == NODE_MAP && case_node_key(node, "type") ? part_add(g, node, 1) : HAWSER_OK;
    for (const CaseNode *child = node->first; child && !status; child = child->next) {
        const int cables = !node->parent && strcmp(child->key, "cables") == 0;
        if (!cables && child->kind != NODE_TEXT) status = types_add(g, child);
    }
    return status;
}

static hawser_status file_add(const CaseReader *r, const CaseNode *node, const char *value, const char *origin,
                              const char *source)
{
    char path[CASE_PATH_MAX];
    AssumptionList g = {.r = r, .room = r->def->n_assumptions};
    hawser_assumption *const a = assumption_add(&g, case_path(node, "file", path), value, origin);
    if (!a) return error_memory(r->err);
    snprintf(a->source, sizeof a->source, "%s", source);
    return HAWSER_OK;
}

hawser_status case_unread_add(const CaseReader *r, const CaseNode *node, const char *what, long times)
{
    char count[HAWSER_ASSUMPTION_VALUE_MAX];
    snprintf(count, sizeof count, "%ld times", times);
    return file_add(r, node, times == 1 ? "once" : count, NOT_READ, what);
}

hawser_status case_found_add(const CaseReader *r, const CaseNode *node, const char *value, int estimated,
                             const char *source)
{
    return file_add(r, node, value, estimated ? ESTIMATED : GIVEN, source);
}

hawser_status case_assumptions_read(CaseReader *r, const CaseNode *node)
{
    AssumptionList g = {.r = r, .room = r->def->n_assumptions};
    hawser_status status = HAWSER_OK;
    for (const CaseNode *cable = node->first; cable && !status; cable = cable->next) {
        const CableDef *const def = &r->def->cables[cable->index];
        if (!case_node_key(cable, "type") && !def->estimated) continue;
        status = part_add(&g, cable, 0);
        if (!status) status = assumption_estimates_add(&g, cable, def);
    }
    return status ? status : types_add(&g, r->root);
}
