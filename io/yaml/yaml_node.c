#include "io/yaml/yaml_tree.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

CaseNode *node_new(NodeKind kind, const char *origin, int line)
{
    CaseNode *node = calloc(1, sizeof *node);
    if (!node) return NULL;
    node->kind = kind;
    node->origin = origin;
    node->line = line;
    return node;
}

/* Recursion is as deep as the tree, which yaml_read and case_tree_set limit. */
CaseNode *node_free(CaseNode *node)
{
    if (!node) return NULL;
    for (CaseNode *child = node->first; child;) {
        CaseNode *next = child->next;
        node_free(child);
        child = next;
    }
    free(node->key);
    free(node->text);
    free(node);
    return NULL;
}

/* One node's own part of a copy. */
static CaseNode *node_copy(const CaseNode *node, const struct LibraryEntry *entry)
{
    CaseNode *const copy = node_new(node->kind, node->origin, node->line);
    if (!copy) return NULL;
    copy->entry = entry ? entry : node->entry;
    copy->text = node->text ? strdup(node->text) : NULL;
    return node->text && !copy->text ? node_free(copy) : copy;
}

/* Recursion is as deep as the tree. */
CaseNode *node_clone(const CaseNode *node, const struct LibraryEntry *entry)
{
    CaseNode *copy = node_copy(node, entry);
    for (const CaseNode *child = node->first; child && copy; child = child->next) {
        CaseNode *const below = node_clone(child, entry);
        char *const key = child->key ? strdup(child->key) : NULL;
        if (!below || (child->key && !key)) {
            free(key);
            node_free(below);
            return node_free(copy);
        }
        below->key = key;
        node_append(copy, below);
    }
    return copy;
}

/* In constant time, by the pointer to the last child. */
void node_append(CaseNode *parent, CaseNode *child)
{
    assert(parent->kind != NODE_TEXT && !child->parent && !child->next);
    child->parent = parent;
    child->index = parent->count++;
    if (parent->last) {
        parent->last->next = child;
    } else {
        parent->first = child;
    }
    parent->last = child;
}

/* Key and number pass to the new node, so that the old one's place in the tree is unchanged. */
void node_replace(CaseNode *old, CaseNode *by)
{
    CaseNode *parent = old->parent;
    CaseNode **link = &parent->first;
    while (*link != old) link = &(*link)->next;
    *link = by;
    if (parent->last == old) parent->last = by;
    by->parent = parent;
    by->next = old->next;
    by->index = old->index;
    by->key = old->key;
    old->key = NULL;
    node_free(old);
}

/* Maps have 500 keys at most. */
const CaseNode *case_node_key(const CaseNode *node, const char *key)
{
    if (!node || node->kind != NODE_MAP) return NULL;
    const CaseNode *child = node->first;
    while (child && strcmp(child->key, key) != 0) child = child->next;
    return child;
}

void case_node_path(const CaseNode *node, char *path, size_t size)
{
    *path = 0;
    if (!node || !node->parent) return;
    case_node_path(node->parent, path, size);
    const size_t n = strlen(path);
    if (node->key)
        snprintf(path + n, size - n, "%s%s", n ? "." : "", node->key);
    else
        snprintf(path + n, size - n, "%s%d", n ? "." : "", node->index);
}

/* From the first on; readers that need all items walk along `next` instead. */
const CaseNode *case_node_item(const CaseNode *node, int index)
{
    if (!node || node->kind != NODE_LIST) return NULL;
    const CaseNode *child = node->first;
    while (child && child->index != index) child = child->next;
    return child;
}
