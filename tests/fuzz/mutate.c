/* A mutator that knows what a case is: it changes values within and beyond what their keys allow and makes them equal
 * to others of their dimension, drops and repeats keys and items, adds keys that the schema knows, sections with what
 * they need, and exchanges parts of two cases; every fourth time it leaves the bytes to the fuzzer's own. What is no
 * case goes to the fuzzer's own too. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "io/case/case_parts.h"
#include "tests/fuzz/fuzz.h"

size_t LLVMFuzzerMutate(uint8_t *data, size_t size, size_t max_size);
size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned int seed);
size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t n_one, const uint8_t *two, size_t n_two, uint8_t *out,
                                 size_t max_size, unsigned int seed);

/* ------------------------------------------------------------------------------------------------------------ chance
 */

/* SplitMix64 (Steele, Lea, Flood 2014). */
static uint64_t draw(uint64_t *state)
{
    uint64_t z = *state += 0x9E3779B97F4A7C15u;
    z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9u;
    z = (z ^ z >> 27) * 0x94D049BB133111EBu;
    return z ^ z >> 31;
}

static int pick(uint64_t *state, int n) { return (int)(draw(state) % (uint64_t)n); }
static double part(uint64_t *state) { return (double)(draw(state) >> 11) * 0x1p-53; }

/* -------------------------------------------------------------------------------------------------------------- tree
 */

/* The section whose keys a node's children are, by the way down from the root; NULL: none is known. */
static const CaseSection *section_of(const CaseNode *node)
{
    if (!node->parent) return &case_top;
    const CaseNode *const above = node->parent;
    const CaseSection *const section = section_of(above);
    if (!section || above->kind == NODE_LIST) return section;
    for (int k = 0; k < section->n; ++k) {
        if (strcmp(section->key[k].name, node->key) == 0) return section->key[k].section;
    }
    return strcmp(section->path, "cables.NAME") == 0 ? section : NULL; /* the name of a cable */
}

/* The row of a node's own key; NULL: none. */
static const CaseKey *key_of(const CaseNode *node)
{
    const CaseSection *const section = node->parent && node->key ? section_of(node->parent) : NULL;
    for (int k = 0; section && k < section->n; ++k) {
        if (strcmp(section->key[k].name, node->key) == 0) return &section->key[k];
    }
    return NULL;
}

static int count_nodes(const CaseNode *node)
{
    int n = 1;
    for (const CaseNode *child = node->first; child; child = child->next) n += count_nodes(child);
    return n;
}

/* The node that is `*left` nodes on, in the order in which they were written. */
static CaseNode *nth_node(CaseNode *node, int *left)
{
    if ((*left)-- == 0) return node;
    for (CaseNode *child = node->first; child; child = child->next) {
        CaseNode *const found = nth_node(child, left);
        if (found) return found;
    }
    return NULL;
}

static CaseNode *any_node(CaseTree *tree, uint64_t *state)
{
    int left = pick(state, count_nodes(tree->root));
    return nth_node(tree->root, &left);
}

static char *text_copy(const char *text)
{
    char *const copy = strdup(text);
    FUZZ_MUST(copy);
    return copy;
}

static CaseNode *text_node(const char *key, const char *text)
{
    CaseNode *const node = node_new(NODE_TEXT, "mutation", 0);
    FUZZ_MUST(node);
    node->text = text_copy(text);
    if (key) node->key = text_copy(key);
    return node;
}

static CaseNode *copy_node(const CaseNode *from)
{
    CaseNode *const node = node_new(from->kind, "mutation", 0);
    FUZZ_MUST(node);
    if (from->text) node->text = text_copy(from->text);
    if (from->key) node->key = text_copy(from->key);
    for (const CaseNode *child = from->first; child; child = child->next) node_append(node, copy_node(child));
    return node;
}

static void drop_node(CaseNode *node)
{
    CaseNode *const parent = node->parent;
    CaseNode **link = &parent->first;
    CaseNode *before = NULL;
    for (; *link != node; link = &(*link)->next) before = *link;
    *link = node->next;
    if (parent->last == node) parent->last = before;
    parent->count--;
    node->parent = node->next = NULL;
    node_free(node);
    int index = 0;
    for (CaseNode *child = parent->first; child; child = child->next) child->index = index++;
}

/* ------------------------------------------------------------------------------------------------------------ values
 */

static double some_number(const CaseKey *key, const char *old, uint64_t *state)
{
    const double was = old ? strtod(old, NULL) : 1;
    static const double factors[] = {0.5, 2, 10, 0.1, -1, 1.001, 1e3, 1e-3};
    const double low = key && key->max > key->min ? fmax(key->min, 1e-9) : 1e-9;
    const double high = key && key->max > low ? key->max : 1e6;
    switch (pick(state, 6)) {
    case 0:
        return key ? key->min : 0;
    case 1:
        return key ? key->max : 1e300;
    case 2:
        return low * pow(high / low, part(state));
    case 3:
        return (double)pick(state, 10);
    default:
        return was * factors[pick(state, 8)];
    }
}

/* A text for a key of that kind; a unit that was there stays. */
static void some_text(const CaseKey *key, const char *old, uint64_t *state, char *out, size_t size)
{
    static const char *const words[] = {"true", "false", "auto", "none", "step", "step5", "nan", "", "x", "both"};
    int choices = 0;
    while (key && key->choices && key->choices[choices]) ++choices;
    const char *unit = old ? old + strspn(old, "+-.0123456789eE") : "";
    if (choices > 0 && pick(state, 8)) {
        snprintf(out, size, "%s", key->choices[pick(state, choices)]);
    } else if (key && key->kind == KEY_FLAG) {
        snprintf(out, size, "%s", pick(state, 2) ? "true" : "false");
    } else if (key && key->kind == KEY_INTEGER) {
        snprintf(out, size, "%.0f", some_number(key, old, state));
    } else if (!pick(state, 12)) {
        snprintf(out, size, "%s", words[pick(state, 10)]);
    } else {
        snprintf(out, size, "%.9g%s", some_number(key, old, state), unit);
    }
}

/* --------------------------------------------------------------------------------------------------------- mutations
 */

static void change_value(CaseNode *node, uint64_t *state)
{
    char text[200];
    if (node->kind != NODE_TEXT) return;
    some_text(key_of(node), node->text, state, text, sizeof text);
    free(node->text);
    node->text = text_copy(text);
}

/* The number of another place with the same dimension: what is equal is a case of its own in many laws. */
static void tie_value(CaseTree *tree, CaseNode *node, uint64_t *state)
{
    const CaseKey *const key = node->kind == NODE_TEXT ? key_of(node) : NULL;
    for (int tries = 0; key && tries < 20; ++tries) {
        const CaseNode *const other = any_node(tree, state);
        const CaseKey *const theirs = other->kind == NODE_TEXT && other != node ? key_of(other) : NULL;
        if (!theirs || theirs->kind != key->kind || theirs->dimension != key->dimension) continue;
        free(node->text);
        node->text = text_copy(other->text);
        return;
    }
}

static CaseNode *new_list(int n, const CaseKey *key, uint64_t *state)
{
    CaseNode *const list = node_new(NODE_LIST, "mutation", 0);
    FUZZ_MUST(list);
    for (int k = 0; k < n; ++k) {
        char text[200];
        some_text(key, NULL, state, text, sizeof text);
        node_append(list, text_node(NULL, text));
    }
    return list;
}

static CaseNode *new_node(const CaseKey *key, int deep, uint64_t *state);

/* What a section must have, and now and then what it may have. */
static CaseNode *new_map(const CaseSection *section, int deep, uint64_t *state)
{
    CaseNode *const map = node_new(NODE_MAP, "mutation", 0);
    FUZZ_MUST(map);
    for (int k = 0; k < section->n; ++k) {
        if (section->key[k].required || (deep < 3 && !pick(state, 4)))
            node_append(map, new_node(&section->key[k], deep + 1, state));
    }
    return map;
}

static CaseNode *new_node(const CaseKey *key, int deep, uint64_t *state)
{
    char text[200];
    CaseNode *node;
    if (key->section && key->kind == KEY_LIST) {
        node = new_list(0, key, state);
        node_append(node, new_map(key->section, deep, state));
    } else if (key->section && deep < 4) {
        node = new_map(key->section, deep, state);
    } else if (key->kind == KEY_POINT) {
        node = new_list(3, key, state);
    } else {
        some_text(key, key->fallback, state, text, sizeof text);
        node = text_node(NULL, text);
    }
    node->key = text_copy(key->name);
    return node;
}

static void add_key(CaseNode *node, uint64_t *state)
{
    const CaseSection *const section = node->kind == NODE_MAP ? section_of(node) : NULL;
    if (!section) return;
    const CaseKey *const key = &section->key[pick(state, section->n)];
    if (!case_node_key(node, key->name)) node_append(node, new_node(key, 0, state));
}

static void mutate_tree(CaseTree *tree, uint64_t *state)
{
    CaseNode *const node = any_node(tree, state);
    switch (pick(state, 8)) {
    case 0:
        if (node->parent) drop_node(node);
        break;
    case 1:
        if (node->parent && node->parent->kind == NODE_LIST) node_append(node->parent, copy_node(node));
        break;
    case 2:
    case 3:
        add_key(node, state);
        break;
    case 4:
        tie_value(tree, node, state);
        break;
    default:
        change_value(node, state);
    }
}

/* ------------------------------------------------------------------------------------------------------------- bytes
 */

typedef struct Text {
    char *at;
    size_t n, size;
} Text;

static void put(Text *t, const char *format, ...) __attribute__((format(printf, 2, 3)));
static void put(Text *t, const char *format, ...)
{
    if (t->n >= t->size) return;
    va_list args;
    va_start(args, format);
    t->n += (size_t)vsnprintf(t->at + t->n, t->size - t->n, format, args);
    va_end(args);
}

static void put_quoted(Text *t, const char *text)
{
    put(t, "\"");
    for (const char *c = text; *c; ++c) {
        const unsigned char byte = (unsigned char)*c;
        if (byte == '"' || byte == '\\')
            put(t, "\\%c", byte);
        else if (byte < ' ')
            put(t, "\\x%02X", (unsigned)byte);
        else
            put(t, "%c", byte);
    }
    put(t, "\"");
}

/* As flow style, which any YAML reader takes. */
static void put_node(Text *t, const CaseNode *node)
{
    if (node->kind == NODE_TEXT) {
        put_quoted(t, node->text);
        return;
    }
    put(t, node->kind == NODE_MAP ? "{" : "[");
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (child->key) {
            put_quoted(t, child->key);
            put(t, ": ");
        }
        put_node(t, child);
        if (child->next) put(t, node->parent ? ", " : ",\n ");
    }
    put(t, node->kind == NODE_MAP ? "}" : "]");
}

/* The tree as bytes; 0: it does not fit. */
static size_t write_tree(const CaseTree *tree, uint8_t *data, size_t max_size)
{
    Text text = {malloc(max_size + 1), 0, max_size + 1};
    FUZZ_MUST(text.at);
    put_node(&text, tree->root);
    const size_t size = text.n <= max_size ? text.n : 0;
    memcpy(data, text.at, size);
    free(text.at);
    return size;
}

static CaseTree *read_tree(const uint8_t *data, size_t size)
{
    char *const text = fuzz_text(data, size);
    CaseTree *tree = NULL;
    hawser_error err;
    (void)case_tree_parse(text, "fuzz.yaml", &tree, &err);
    free(text);
    return tree;
}

size_t LLVMFuzzerCustomMutator(uint8_t *data, size_t size, size_t max_size, unsigned int seed)
{
    uint64_t state = seed;
    CaseTree *tree = pick(&state, 4) ? read_tree(data, size) : NULL;
    if (!tree) return LLVMFuzzerMutate(data, size, max_size);
    for (int k = 1 + pick(&state, 4); k > 0; --k) mutate_tree(tree, &state);
    const size_t written = write_tree(tree, data, max_size);
    case_tree_free(tree);
    return written > 0 ? written : LLVMFuzzerMutate(data, size, max_size);
}

/* The first node below this one that has the key. */
static const CaseNode *find_key(const CaseNode *node, const char *key)
{
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (child->key && strcmp(child->key, key) == 0) return child;
        const CaseNode *const found = find_key(child, key);
        if (found) return found;
    }
    return NULL;
}

size_t LLVMFuzzerCustomCrossOver(const uint8_t *one, size_t n_one, const uint8_t *two, size_t n_two, uint8_t *out,
                                 size_t max_size, unsigned int seed)
{
    uint64_t state = seed;
    size_t size = 0;
    CaseTree *const a = read_tree(one, n_one), *const b = read_tree(two, n_two);
    for (int tries = 0; a && b && tries < 20 && size == 0; ++tries) {
        CaseNode *const old = any_node(a, &state);
        const CaseNode *const by = old->key ? find_key(b->root, old->key) : NULL;
        if (!by || !old->parent) continue;
        CaseNode *const copy = copy_node(by);
        free(copy->key); /* it gets the old one's */
        copy->key = NULL;
        node_replace(old, copy);
        size = write_tree(a, out, max_size);
    }
    case_tree_free(a);
    case_tree_free(b);
    return size;
}
