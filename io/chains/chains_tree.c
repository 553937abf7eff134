#include "io/chains/chains.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* A child that may be changed: the tree is ours. */
static CaseNode *own_key(CaseNode *map, const char *key) { return (CaseNode *)(uintptr_t)case_node_key(map, key); }

/* A copy of `value` under a key of the map, in place of what is there; 0 if there is no memory. */
static int put(CaseNode *map, const char *key, const CaseNode *value)
{
    CaseNode *const copy = node_clone(value, NULL), *const old = own_key(map, key);
    if (!copy) return 0;
    if (old) {
        node_replace(old, copy);
        return 1;
    }
    copy->key = strdup(key);
    if (copy->key) node_append(map, copy);
    if (!copy->key) node_free(copy);
    return copy->parent != NULL;
}

/* The map of a key, an empty one if there is none; NULL if there is no memory. */
static CaseNode *map_of(CaseNode *map, const char *key, const CaseNode *like)
{
    CaseNode *const empty = node_new(NODE_MAP, like->origin, like->line);
    const int there = case_node_key(map, key) != NULL;
    if (empty && !there) put(map, key, empty);
    node_free(empty);
    return own_key(map, key);
}

/* A map without one of its keys. */
static int take_out(CaseNode *map, const char *key)
{
    CaseNode *const without = node_new(NODE_MAP, map->origin, map->line);
    int ok = without != NULL;
    for (const CaseNode *child = map->first; ok && child; child = child->next)
        if (strcmp(child->key, key) != 0) ok = put(without, child->key, child);
    if (ok) node_replace(map, without);
    if (!ok) node_free(without);
    return ok;
}

/* What the case's drive has that is not this chain's. */
static int drive_strip(CaseNode *root, const ChainRole *role)
{
    const struct {
        const char *key;
        int away;
    } parts[] = {{"winch", role->led || role->still},
                 {"rope_drag", role->led || role->still},
                 {"tail", role->rope || role->still},
                 {"script", role->led || role->still}};
    int ok = 1;
    for (size_t i = 0; ok && i < sizeof parts / sizeof *parts; ++i) {
        CaseNode *const drive = own_key(root, "drive");
        if (drive && drive->kind == NODE_MAP && parts[i].away && case_node_key(drive, parts[i].key))
            ok = take_out(drive, parts[i].key);
    }
    return ok;
}

CaseNode *chain_tree(const CaseNode *root, const CaseNode *node, const ChainRole *role)
{
    CaseNode *const own = node_clone(root, NULL);
    const CaseNode *const chain = case_node_key(node, "chain"), *const drive = case_node_key(node, "drive");
    const CaseNode *const head_at = case_node_key(node, "head_at");
    int ok = own && drive_strip(own, role);
    if (ok && chain) ok = put(own, "chain", chain);
    if (ok && drive) {
        CaseNode *const to = map_of(own, "drive", drive);
        ok = to != NULL;
        for (const CaseNode *child = drive->first; ok && child; child = child->next) ok = put(to, child->key, child);
    }
    if (ok && head_at) {
        CaseNode *const route = map_of(own, "route", head_at);
        ok = route && put(route, "head_at", head_at);
    }
    return ok ? own : node_free(own);
}
