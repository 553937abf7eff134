/* The nodes of a case's tree: texts, maps and lists that know where they were written. */
#ifndef HAWSER_IO_YAML_YAML_NODE_H
#define HAWSER_IO_YAML_YAML_NODE_H

typedef enum NodeKind { NODE_TEXT, NODE_MAP, NODE_LIST } NodeKind;

/* One value. Children of a map have keys, those of a list have numbers. */
typedef struct CaseNode {
    NodeKind kind;
    const char *origin; /* the file's name, or "--set KEY"; belongs to the tree */
    int line;           /* where its key, or else itself, begins, from 1; 0: not from a file */
    char *key;          /* in a map, else NULL */
    int index;          /* place among its siblings, from 0 */
    char *text;         /* of a NODE_TEXT, else NULL */
    int count;          /* children */
    struct CaseNode *parent, *first, *last, *next;
} CaseNode;

/* The child of a map by key, of a list by number; NULL if there is none, or if `node` is NULL or of another kind. */
const CaseNode *case_node_key(const CaseNode *node, const char *key);
const CaseNode *case_node_item(const CaseNode *node, int index);

/* A node without parent or children; NULL if there is no memory. */
CaseNode *node_new(NodeKind kind, const char *origin, int line);
/* Frees a node and all below it; NULL-safe; returns NULL. */
CaseNode *node_free(CaseNode *node);
/* Makes child the last of parent. */
void node_append(CaseNode *parent, CaseNode *child);
/* Puts `by` in old's place under old's key, and frees old. */
void node_replace(CaseNode *old, CaseNode *by);

#endif
