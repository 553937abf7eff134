/* Making, joining and freeing the nodes of a CaseTree; for io/yaml_*.c only. */
#ifndef HAWSER_IO_YAML_NODE_H
#define HAWSER_IO_YAML_NODE_H

#include "io/yaml_tree.h"

/* A place that text came from: kept for as long as the tree, since nodes point at the name. */
typedef struct CaseOrigin {
    char *name;
    struct CaseOrigin *next;
} CaseOrigin;

/* A node without parent or children; NULL if there is no memory. */
CaseNode *node_new(NodeKind kind, const char *origin, int line);
/* Frees a node and all below it; NULL-safe; returns NULL. */
CaseNode *node_free(CaseNode *node);
/* Makes child the last of parent. */
void node_append(CaseNode *parent, CaseNode *child);
/* Puts `by` in old's place under old's key, and frees old. */
void node_replace(CaseNode *old, CaseNode *by);

/* Remembers a name in the tree and returns the tree's copy; NULL if there is no memory. */
const char *tree_origin(CaseTree *tree, const char *name);
/* Reads one YAML document as nodes of `tree`, without making it the root. `lines` 0: the text is a setting's
 * value, and line numbers mean nothing. Errors as case_tree_parse. */
hawser_status tree_read_text(CaseTree *tree, const char *text, size_t size, const char *origin, int lines,
                             CaseNode **out, hawser_error *err);

#endif
