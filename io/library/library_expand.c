/* `type` in a case: the keys of the entry that it names, wherever the case does not say itself. */
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/library/library.h"

enum { NEAR_MAX = 300 };
enum {
    LINES = 1u << LIBRARY_CABLES | 1u << LIBRARY_ROPES,
    ROLLERS = 1u << LIBRARY_ROLLERS,
    DUCTS = 1u << LIBRARY_DUCTS,
    FRICTION = 1u << LIBRARY_FRICTION,
    REELS = 1u << LIBRARY_REELS
};

/* What a key that the case gives takes the place of, beside itself: it says the same in other words. NULL behind the
 * last. */
static const struct {
    unsigned kinds;
    const char *given, *displaced[4];
} displacements[] = {
    {LINES, "E", {"EA", "EI", "EI_y", "EI_z"}},
    {LINES, "G", {"GA", "GJ"}},
    {LINES, "A", {"EA", "GA"}},
    {LINES, "density", {"mass"}},
    {LINES, "EI", {"EI_y", "EI_z"}},
    {LINES, "bending", {"EI", "EI_y", "EI_z"}},
    {FRICTION, "mu", {"mu_s", "mu_d"}},
};
enum { DISPLACEMENTS = sizeof displacements / sizeof *displacements };

/* Whether a node is the child `key` of the root's, or of the root's child `above`. */
static int is_under(const CaseNode *node, const char *above, const char *key)
{
    if (!node || !node->key || strcmp(node->key, key) != 0) return 0;
    if (!above) return node->parent && !node->parent->parent;
    return is_under(node->parent, NULL, above);
}

/* Of which kinds a map's `type` is; 0: it may have none. */
static unsigned kinds_of(const CaseNode *map)
{
    const CaseNode *const p = map->parent;
    if (map->kind != NODE_MAP || !p) return 0;
    if (map->key && (strcmp(map->key, "friction") == 0 || strcmp(map->key, "cable_friction") == 0)) return FRICTION;
    if (is_under(map, NULL, "reel")) return REELS;
    if (is_under(p, NULL, "cables")) return LINES;
    if (map->key && strcmp(map->key, "rollers") == 0 && is_under(p->parent, "drawing", "layers")) return ROLLERS;
    if (is_under(map, "rollers", "along") || is_under(p, "rollers", "along") || is_under(p, "rollers", "list"))
        return ROLLERS;
    return is_under(p, "surfaces", "ducts") ? DUCTS : 0;
}

static const CaseNode *type_of(const CaseNode *map) { return kinds_of(map) ? case_node_key(map, "type") : NULL; }

static int has_type(const CaseNode *node)
{
    if (type_of(node)) return 1;
    for (const CaseNode *child = node->first; child; child = child->next) {
        if (has_type(child)) return 1;
    }
    return 0;
}

/* Whether the case says what this key of an entry would say. */
static int is_given(const CaseNode *map, unsigned kinds, const char *key)
{
    if (case_node_key(map, key)) return 1;
    for (int i = 0; i < DISPLACEMENTS; i++) {
        if (!(displacements[i].kinds & kinds) || !case_node_key(map, displacements[i].given)) continue;
        for (int k = 0; k < 4 && displacements[i].displaced[k]; k++) {
            if (strcmp(key, displacements[i].displaced[k]) == 0) return 1;
        }
    }
    return 0;
}

static hawser_status type_unknown(const Library *library, const CaseNode *type, unsigned kinds, hawser_error *err)
{
    char near[NEAR_MAX];
    int kind = 0;
    while (!(kinds >> kind & 1)) kind++;
    library_near(library, kinds, type->text, sizeof near, near);
    if (!*near)
        return case_value_error(err, type, " is not in the catalogue, which has none of %s", library_kinds[kind]);
    return case_value_error(err, type, " is not in the catalogue: did you mean %s? (hawser library %s)", near,
                            library_kinds[kind]);
}

/* What is given is looked at before anything is added: an entry does not displace its own keys. */
static hawser_status type_merge(const Library *library, CaseNode *map, const CaseNode *type, hawser_error *err)
{
    const unsigned kinds = kinds_of(map);
    if (type->kind != NODE_TEXT || !*type->text)
        return case_value_error(err, type, ": expected a name of the catalogue");
    const LibraryEntry *const entry = library_find(library, kinds, type->text);
    if (!entry) return type_unknown(library, type, kinds, err);
    CaseNode *const added = node_new(NODE_MAP, entry->node->origin, entry->node->line);
    int bad = !added;
    for (const CaseNode *child = entry->node->first; child && !bad; child = child->next) {
        if (library_about(child->key) || is_given(map, kinds, child->key)) continue;
        CaseNode *const copy = node_clone(child, entry);
        if (copy) copy->key = strdup(child->key);
        bad = !copy || !copy->key;
        if (bad) node_free(copy);
        if (!bad) node_append(added, copy);
    }
    for (CaseNode *child = bad ? NULL : added->first, *next; child; child = next) {
        next = child->next;
        child->parent = child->next = NULL;
        node_append(map, child);
    }
    if (!bad) added->first = added->last = NULL;
    node_free(added);
    return bad ? error_memory(err) : HAWSER_OK;
}

/* From the outside in: a friction that an entry of a roller brings may have a type of its own. */
static hawser_status types_merge(const Library *library, CaseNode *node, hawser_error *err)
{
    const CaseNode *const type = type_of(node);
    hawser_status status = type ? type_merge(library, node, type, err) : HAWSER_OK;
    for (CaseNode *child = node->first; child && !status; child = child->next)
        status = types_merge(library, child, err);
    return status;
}

/* Includes are read even where nothing refers to them, for their mistakes; the shipped files only for a type. */
hawser_status library_expand(const CaseTree *tree, CaseNode **root, Library **library, hawser_error *err)
{
    const int typed = has_type(tree->root);
    *root = NULL;
    *library = NULL;
    if (!typed && !case_node_key(tree->root, "include")) return HAWSER_OK;
    Library *const own = library_new();
    if (!own) return error_memory(err);
    hawser_status status = library_include(own, tree, err);
    if (!status && typed) status = library_ship(own, err);
    if (!status && typed && !(*root = node_clone(tree->root, NULL))) status = error_memory(err);
    if (!status && typed) status = types_merge(own, *root, err);
    if (status) {
        *root = node_free(*root);
        library_free(own);
    } else {
        *library = own; /* also of a case without a type: its files are the case's */
    }
    return status;
}
