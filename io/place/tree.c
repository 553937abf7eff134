#include "io/place/place.h"

#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* The child of a map that may be changed. */
static CaseNode *find(CaseNode *map, const char *key)
{
    CaseNode *child = map->first;
    while (child && strcmp(child->key, key) != 0) child = child->next;
    return child;
}

/* Under the key, in place of what is there. The child is freed if there is no memory. */
static int put(CaseNode *map, const char *key, CaseNode *child)
{
    CaseNode *const old = child && map ? find(map, key) : NULL;
    if (!child || !map) return node_free(child), 0;
    if (old) return node_replace(old, child), 1;
    child->key = strdup(key);
    if (!child->key) return node_free(child), 0;
    node_append(map, child);
    return 1;
}

CaseNode *tree_child(CaseNode *map, const char *key, NodeKind kind)
{
    CaseNode *const old = map ? find(map, key) : NULL;
    if (!map || (old && old->kind == kind)) return old;
    CaseNode *const child = node_new(kind, old ? old->origin : map->origin, old ? old->line : map->line);
    CaseNode *const item = old && old->kind == NODE_MAP && kind == NODE_LIST ? node_clone(old, old->entry) : NULL;
    if (child && item) node_append(child, item);
    return put(map, key, child) ? child : NULL;
}

int tree_put(CaseNode *map, const CaseNode *like, const char *key, const char *format, ...)
{
    char text[CASE_PATH_MAX];
    va_list list;
    va_start(list, format);
    vsnprintf(text, sizeof text, format, list);
    va_end(list);
    CaseNode *const node = node_new(NODE_TEXT, like->origin, like->line);
    if (!node) return 0;
    node->text = strdup(text);
    if (!node->text) return node_free(node), 0;
    return put(map, key, node);
}

int tree_put_length(CaseNode *map, const CaseNode *like, const char *key, double metres)
{
    return tree_put(map, like, key, "%.17g m", metres);
}
