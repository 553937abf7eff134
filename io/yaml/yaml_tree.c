#include "io/yaml/yaml_tree.h"

#include <ctype.h>
#include <limits.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"

enum { KEY_MAX = 200, STEPS_MAX = 16 };

/* A place that text came from: kept for as long as a tree whose nodes point at the name. Copies of a tree share the
 * list that was there when they were made, each with its own first element. */
typedef struct CaseOrigin {
    char *name;
    struct CaseOrigin *next;
    atomic_int users; /* trees and elements that point here */
} CaseOrigin;

/* Remembers a name in the tree and returns the tree's copy; NULL if there is no memory. */
static const char *tree_origin(CaseTree *tree, const char *name)
{
    for (const CaseOrigin *o = tree->origins; o; o = o->next) {
        if (strcmp(o->name, name) == 0) return o->name;
    }
    CaseOrigin *origin = calloc(1, sizeof *origin);
    if (!origin) return NULL;
    origin->name = strdup(name);
    if (!origin->name) {
        free(origin);
        return NULL;
    }
    origin->next = tree->origins; /* the tree's reference passes on */
    atomic_init(&origin->users, 1);
    tree->origins = origin;
    return origin->name;
}

CaseTree *case_tree_free(CaseTree *tree)
{
    if (!tree) return NULL;
    node_free(tree->root);
    for (CaseOrigin *origin = tree->origins; origin && atomic_fetch_sub(&origin->users, 1) == 1;) {
        CaseOrigin *next = origin->next;
        free(origin->name);
        free(origin);
        origin = next;
    }
    free(tree->path);
    free(tree->folder);
    free(tree);
    return NULL;
}

/* The folder of a path, malloc'ed; NULL if there is no memory. */
static char *folder_of(const char *path)
{
    const char *const slash = strrchr(path, '/');
    if (!slash) return strdup(".");
    return strndup(path, slash == path ? 1 : (size_t)(slash - path));
}

/* A tree from `size` bytes of text, which editors may begin with a byte order mark. */
static hawser_status tree_new(const char *text, size_t size, const char *name, CaseTree **out, hawser_error *err)
{
    static const char mark[] = "\xef\xbb\xbf";
    const size_t skip = strncmp(text, mark, 3) == 0 ? 3 : 0;
    CaseTree *tree = calloc(1, sizeof *tree);
    const char *origin = tree ? tree_origin(tree, name) : NULL;
    *out = NULL;
    if (!origin) {
        case_tree_free(tree);
        return error_memory(err);
    }
    hawser_status status = yaml_read(text + skip, size - skip, origin, 1, &tree->root, err);
    if (!status && tree->root && tree->root->kind != NODE_MAP)
        status = case_text_error(err, origin, tree->root->line, "a case is a map: lines of 'key: value'", NULL);
    *out = status ? case_tree_free(tree) : tree;
    return status;
}

/* The text's length is up to its NUL. */
hawser_status case_tree_parse(const char *text, const char *name, CaseTree **out, hawser_error *err)
{
    return tree_new(text, strlen(text), name, out, err);
}

hawser_status case_tree_load(const char *path, CaseTree **out, hawser_error *err)
{
    *out = NULL;
    char *text;
    size_t size;
    hawser_status status = case_file_read(path, &text, &size, err);
    if (status) return status;
    status = tree_new(text, size, path, out, err);
    free(text);
    if (!status) (*out)->folder = folder_of(path);
    if (!status) (*out)->path = strdup(path);
    if (!status && (!(*out)->folder || !(*out)->path)) {
        *out = case_tree_free(*out);
        status = error_memory(err);
    }
    return status;
}

CaseTree *case_tree_copy(const CaseTree *tree)
{
    CaseTree *const copy = calloc(1, sizeof *copy);
    if (!copy) return NULL;
    copy->root = node_clone(tree->root, NULL);
    copy->folder = tree->folder ? strdup(tree->folder) : NULL;
    copy->path = tree->path ? strdup(tree->path) : NULL;
    copy->origins = tree->origins;
    if (copy->origins) atomic_fetch_add(&copy->origins->users, 1);
    return copy->root && (copy->folder || !tree->folder) && (copy->path || !tree->path) ? copy : case_tree_free(copy);
}

/* A key on its way into a tree: where it comes from, and its parts. */
typedef struct Setting {
    const CaseTree *tree;
    const char *origin; /* "--set KEY"; where a value is only read, the key */
    char key[KEY_MAX];  /* with NULs for dots */
    const char *step[STEPS_MAX];
    int n;
    hawser_error *err;
} Setting;

/* The parts stay where they are, with the dots turned into ends. */
static hawser_status key_cut(Setting *s, const char *key)
{
    snprintf(s->key, sizeof s->key, "%s", key);
    for (char *p = s->key; p; s->n++) {
        if (s->n == STEPS_MAX) return case_text_error(s->err, s->origin, 0, "the key has too many parts", NULL);
        s->step[s->n] = p;
        p = strchr(p, '.');
        if (p) *p++ = 0;
        if (!*s->step[s->n]) return case_text_error(s->err, s->origin, 0, "a part of the key is empty", NULL);
    }
    return HAWSER_OK;
}

/* The items of a list that have this `name`: how many there are, and the last of them. */
static int items_named(const CaseNode *list, const char *name, CaseNode **out)
{
    int n = 0;
    for (CaseNode *item = list->first; item; item = item->next) {
        const CaseNode *const own = case_node_key(item, "name");
        if (!own || own->kind != NODE_TEXT || strcmp(own->text, name) != 0) continue;
        *out = item;
        n++;
    }
    return n;
}

/* A name that is the number of another item: either could be meant. */
static hawser_status item_ambiguous(const Setting *s, const CaseNode *list, long index, const CaseNode *named)
{
    int place = 0;
    for (const CaseNode *item = list->first; item && item != named; item = item->next) place++;
    const CaseNode *const own = case_node_key(case_node_item(list, (int)index), "name");
    char shown[CASE_SHOWN_MAX];
    return error_set(s->err, HAWSER_ERR_INPUT,
                     "%s: %ld is the number of the item %s and the name of the item with the number %d: give that one "
                     "a name that is no number",
                     s->origin, index, own && own->kind == NODE_TEXT ? case_shown(own->text, shown) : "without a name",
                     place);
}

/* The item of a list that `step` numbers or names. */
static hawser_status item_find(const Setting *s, const CaseNode *list, const char *step, CaseNode **out)
{
    char *end, shown[CASE_SHOWN_MAX];
    const long index = isdigit((unsigned char)*step) ? strtol(step, &end, 10) : LONG_MAX;
    const int whole = index != LONG_MAX && !*end;
    CaseNode *by_name = NULL;
    const int named = items_named(list, step, &by_name);
    *out = by_name;
    if (whole && index < list->count) {
        *out = (CaseNode *)(size_t)case_node_item(list, (int)index);
        if (named == 0 || (named == 1 && by_name == *out)) return HAWSER_OK;
        return item_ambiguous(s, list, index, by_name);
    }
    if (named == 1) return HAWSER_OK;
    if (named > 1) {
        return error_set(s->err, HAWSER_ERR_INPUT, "%s: %d items have the name %s: give the number, from 0", s->origin,
                         named, case_shown(step, shown));
    }
    return error_set(s->err, HAWSER_ERR_INPUT, "%s: no item %s: the list has %d, numbered from 0", s->origin,
                     case_shown(step, shown), list->count);
}

/* Goes down the key as far as the tree has it: *node is the last that exists, *depth how many steps lead
 * there. */
static hawser_status path_follow(const Setting *s, CaseNode **node, int *depth)
{
    *node = s->tree->root;
    for (*depth = 0; *depth < s->n; ++*depth) {
        const char *step = s->step[*depth];
        CaseNode *next = NULL;
        if ((*node)->kind == NODE_TEXT)
            return case_text_error(s->err, s->origin, 0, "a value, not a map, comes before ", step);
        if ((*node)->kind == NODE_LIST) {
            const hawser_status status = item_find(s, *node, step, &next);
            if (status) return status;
        } else {
            next = (CaseNode *)(size_t)case_node_key(*node, step);
        }
        if (!next) break;
        *node = next;
    }
    return HAWSER_OK;
}

/* `value` inside maps for the steps from `depth` on; frees it without memory. */
static CaseNode *branch_new(const Setting *s, int depth, CaseNode *value)
{
    for (int k = s->n - 1; value && k >= depth; k--) {
        value->key = strdup(s->step[k]);
        if (k == depth && value->key) return value;
        CaseNode *map = value->key ? node_new(NODE_MAP, s->origin, 0) : NULL;
        if (map) {
            node_append(map, value);
        } else {
            node_free(value);
        }
        value = map;
    }
    return value;
}

/* Replaces what is there, or adds what is missing on the way. The value is placed or freed. */
static hawser_status value_place(const Setting *s, CaseNode *value)
{
    CaseNode *node;
    int depth;
    const hawser_status status = path_follow(s, &node, &depth);
    if (status) {
        node_free(value);
        return status;
    }
    if (depth == s->n) {
        node_replace(node, value);
        return HAWSER_OK;
    }
    value = branch_new(s, depth, value);
    if (!value) return error_memory(s->err);
    node_append(node, value);
    return HAWSER_OK;
}

static hawser_status key_long(const char *before, const char *key, hawser_error *err)
{
    char shown[CASE_SHOWN_MAX];
    return error_set(err, HAWSER_ERR_INPUT, "%s%s: the key is too long", before, case_shown(key, shown));
}

hawser_status case_tree_find(const CaseTree *tree, const char *key, const CaseNode **node, hawser_error *err)
{
    Setting s = {.tree = tree, .origin = key, .err = err};
    CaseNode *found = tree->root;
    int depth = 0;
    if (strlen(key) >= KEY_MAX) return key_long("", key, err);
    hawser_status status = *key ? key_cut(&s, key) : HAWSER_OK;
    if (!status) status = path_follow(&s, &found, &depth);
    if (!status && depth < s.n) status = error_set(err, HAWSER_ERR_INPUT, "%s: the case does not give this key", key);
    *node = status ? NULL : found;
    return status;
}

/* The value is read before the tree is touched, so that a mistake leaves the tree as it was. */
hawser_status case_tree_set(CaseTree *tree, const char *key, const char *value, hawser_error *err)
{
    char origin[KEY_MAX + 16];
    if (strlen(key) >= KEY_MAX) return key_long("--set ", key, err);
    snprintf(origin, sizeof origin, "--set %s", key);
    Setting s = {.tree = tree, .origin = tree_origin(tree, origin), .err = err};
    if (!s.origin) return error_memory(err);
    hawser_status status = key_cut(&s, key);
    CaseNode *node = NULL;
    /* An empty value is an empty text, which the reader will refuse where a value is wanted. */
    if (!status) status = yaml_read(*value ? value : "''", strlen(*value ? value : "''"), s.origin, 0, &node, err);
    if (!status) status = value_place(&s, node);
    return status;
}

/* Adds a text to a map, unless it is NULL; *fine turns 0 without memory. */
static void text_add(CaseNode *map, const char *key, const char *text, int *fine)
{
    CaseNode *const node = text ? node_new(NODE_TEXT, "", 0) : NULL;
    if (!text) return;
    if (node) {
        node->key = strdup(key);
        node->text = strdup(text);
        node_append(map, node);
    }
    *fine &= node && node->key && node->text;
}

/* Absolute where that is there: the text may be read elsewhere. */
static void path_add(CaseNode *map, const char *key, const char *path, int *fine)
{
    char *const whole = path ? realpath(path, NULL) : NULL;
    text_add(map, key, whole ? whole : path, fine);
    free(whole);
}

hawser_status case_tree_pack(const CaseTree *tree, const char *name, char **text, hawser_error *err)
{
    CaseNode *const map = node_new(NODE_MAP, "", 0), *const root = node_clone(tree->root, NULL);
    int fine = map && root;
    if (fine) {
        text_add(map, "name", name, &fine);
        path_add(map, "folder", tree->folder, &fine);
        path_add(map, "path", tree->path, &fine);
        root->key = strdup("case");
        node_append(map, root);
        fine &= root->key != NULL;
    } else {
        node_free(root);
    }
    *text = NULL;
    const hawser_status status = fine ? case_node_text(map, text, err) : error_memory(err);
    node_free(map);
    return status;
}

/* Has all nodes be without lines and come from one place (NULL: from where they did). */
static void nodes_place(CaseNode *node, const char *origin)
{
    if (origin) node->origin = origin;
    node->line = 0;
    for (CaseNode *child = node->first; child; child = child->next) nodes_place(child, origin);
}

void case_tree_unline(CaseTree *tree) { nodes_place(tree->root, NULL); }

/* A copy of a text of the map, NULL where there is none; *fine turns 0 without memory. */
static char *text_take(const CaseNode *map, const char *key, int *fine)
{
    const CaseNode *const node = case_node_key(map, key);
    char *const text = node && node->text ? strdup(node->text) : NULL;
    *fine &= text || !node || !node->text;
    return text;
}

hawser_status case_tree_unpack(const char *text, CaseTree **out, char **name, hawser_error *err)
{
    static const char packed[] = "packed case";
    CaseNode *map = NULL;
    *out = NULL;
    *name = NULL;
    hawser_status status = yaml_read(text, strlen(text), packed, 0, &map, err);
    if (status) return status;
    const CaseNode *const root = case_node_key(map, "case"), *const called = case_node_key(map, "name");
    if (!root || root->kind != NODE_MAP || !called || !called->text) {
        node_free(map);
        return case_text_error(err, packed, 0, "no case, or one without a name", NULL);
    }
    int fine = 1;
    CaseTree *const tree = calloc(1, sizeof *tree);
    const char *const origin = tree ? tree_origin(tree, called->text) : NULL;
    if (origin) {
        tree->root = node_clone(root, NULL);
        tree->folder = text_take(map, "folder", &fine);
        tree->path = text_take(map, "path", &fine);
        *name = text_take(map, "name", &fine);
    }
    node_free(map);
    if (!origin || !tree->root || !fine) {
        case_tree_free(tree);
        free(*name);
        *name = NULL;
        return error_memory(err);
    }
    nodes_place(tree->root, origin);
    *out = tree;
    return HAWSER_OK;
}
