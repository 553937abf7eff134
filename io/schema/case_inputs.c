/* The inputs of a case: every key that has a value, and where that comes from. Four sources, in this order: what is
 * written, in the tree's order (with what a `type` brought from the catalogue); what was estimated; what the tables of
 * keys say of those that are missing. A default that several items of a list share stands once, with N for the item. */
#include <ctype.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/library/library.h"
#include "io/schema/case_schema.h"

enum { VALUE_MAX = 240, LISTED_MAX = 400 };

/* The list as it grows. */
typedef struct Gathering {
    const CaseReader *r;
    int room;
    int listed[LISTED_MAX], n_listed; /* where in the list the defaults begin whose key has an N */
} Gathering;

/* Room for so many bytes more. */
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

/* One input: its texts behind those of the others, each with a NUL (INPUT_TEXTS of them). */
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

/* Where a number ends that the text begins with, whatever the program's locale is; the text itself if there is none. */
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

/* A number with a unit behind it, "152.5 m", is cut in two; any other text is all value. Returns the unit, which lies
 * in the text's room or is empty. */
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

/* A list as it would be written, "[0, 0, [5, 6]]", of which the end is left out where it is long. Returns 0 if it holds
 * a map. */
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

/* One value that is written in the case, or that its type brought. */
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

/* Whether a default of an item of a list stands already: another item has been without the key too. */
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

/* What a missing key means, in the words of the table; one that has no default ("none: or `points`") has no value.
 * `many`: the key is that of an item of a list. */
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

/* What a key's value leaves out: a map its keys, a map of names or a list those of each item. */
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

/* The missing keys of one section. map NULL: the section is missing itself, and its defaults count. */
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
