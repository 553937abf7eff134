#include "io/schema/case_schema.h"

#include <assert.h>
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

enum { WANTED_MAX = 128, NAMES_MAX = 64, NUMBER_MAX = 32 };

const char *const case_ramps[] = {"none", "step", "step5", NULL};

/* Sections stand in several places (a friction law, say), but once in the list. */
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

/* Sections have two dozen keys at most: a search from the first on is quick enough. */
const CaseKey *case_key_of(const CaseSection *section, const char *name)
{
    for (int k = 0; k < section->n; k++) {
        if (strcmp(section->key[k].name, name) == 0) return &section->key[k];
    }
    return NULL;
}

/* A number as people write it: 1e6, not 1000000 or 1e+06. */
static const char *number_text(double value, char *text)
{
    snprintf(text, NUMBER_MAX, fabs(value) < 1e5 ? "%.10g" : "%.10e", value);
    char *e = strchr(text, 'e');
    if (!e) return text;
    const long power = strtol(e + 1, NULL, 10);
    snprintf(text, NUMBER_MAX, "%.10ge%ld", value / pow(10, (double)power), power);
    return text;
}

/* Angles are given in degrees, which is how people write them. */
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
        if (all && !idle->entry) /* what a catalogue has may be said otherwise */
            return case_key_error(r->err, idle, NULL, "says nothing beside %s: leave it out, or change these", given);
    }
    return HAWSER_OK;
}

/* A NaN never comes here: units_read refuses it. */
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

/* What is wrong with the text comes before what is wrong with the value. */
hawser_status case_number_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double *value)
{
    char why[UNITS_WHY_MAX], wanted[WANTED_MAX];
    if (node->kind != NODE_TEXT) return case_value_error(r->err, node, "%s", number_wanted(key, wanted));
    if (!units_read(r->units, node->text, key->dimension, value, why)) {
        return case_value_error(r->err, node, " %s%s", why, number_wanted(key, wanted));
    }
    return case_range_check(r, node, key, *value);
}

/* The first item that is wrong is named by its own key, as in 'gravity.2'. */
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

/* Digits only: '1e3' and '2.0' are refused, for what stands there is a count. */
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

/* Counts are int, but the number of steps is long. */
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

/* YAML's words for truth, in pairs: the even places are false. */
static const char *const truth_words[] = {"false", "true", "no", "yes", "off", "on", NULL};

static hawser_status flag_field(const CaseReader *r, const CaseNode *node, int *value)
{
    const int place = case_word_place(node, truth_words);
    if (place < 0) return case_value_error(r->err, node, ": expected true or false");
    *value = place % 2;
    return HAWSER_OK;
}

/* Letters and digits alone, in lower case: "TB 889" is tb889. `out` has WANTED_MAX bytes. */
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

/* The choices are in the order of the enumeration, so that the place is the value. Capitals, blanks and usual other
 * names of a choice do not matter; a choice that is a word for truth has all words for the same truth, as YAML writes
 * one for another: `planar: false` is `planar: off`. */
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

/* A text that does not fit is refused, never cut. */
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

/* Three numbers of one dimension and range. */
static hawser_status point_field(const CaseReader *r, const CaseNode *node, const CaseKey *key, Vec3 *at)
{
    const CaseKey *const keys[3] = {key, key, key};
    double x[3] = {0};
    const hawser_status status = case_numbers_read(r, node, 3, keys, x);
    if (!status) *at = v3(x[0], x[1], x[2]);
    return status;
}

/* A value that code of its own will read: only its kind is looked at here. */
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

/* One value into its place in the record, by its kind. */
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

/* What an absent key means: its fallback is read as if it had been written; the rest has a neutral value. */
static hawser_status field_default(const CaseReader *r, const CaseKey *key, char *at)
{
    CaseNode written = {.kind = NODE_TEXT, .origin = "default", .text = (char *)(size_t)key->fallback};
    if (key->kind == KEY_SECTION) return case_section_read(r, NULL, key->section, at);
    if (key->fallback && key->kind != KEY_POINT) return field_read(r, &written, key, at);
    assert(key->otherwise || (key->kind != KEY_FLAG && key->kind != KEY_CHOICE)); /* its reader looks for the key */
    memset(at, 0, key->size);
    if (key->kind == KEY_NUMBER) *(double *)(void *)at = NAN;
    return HAWSER_OK;
}

/* {mu: 0,3}: to YAML a key 'mu' of the value 0, and a key '3' without one. */
static int is_comma(const CaseNode *child, const CaseNode *before)
{
    if (!before || before->kind != NODE_TEXT || child->kind != NODE_TEXT || *child->text) return 0;
    const size_t end = strlen(before->text);
    return isdigit((unsigned char)*child->key) && end > 0 && isdigit((unsigned char)before->text[end - 1]);
}

/* Points at the first key of the map that the section does not know. */
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

/* The message says what to write, not only that it is missing. */
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

/* Every key of the section is visited, there or not, so that the record is always complete. */
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
