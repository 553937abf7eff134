/* A YAML file as a small tree of texts, maps and lists that remembers where each of them was written. Nothing
 * is interpreted here: numbers, units and what a key means are the business of io/case/case_read.h. */
#ifndef HAWSER_IO_YAML_YAML_TREE_H
#define HAWSER_IO_YAML_YAML_TREE_H

#include "hawser/hawser.h"
#include "io/yaml/yaml_node.h"

typedef struct CaseTree {
    CaseNode *root;             /* a map */
    struct CaseOrigin *origins; /* the names of the places that nodes point at */
} CaseTree;

/* Reads a file. Errors: INPUT with file and line (not readable, not YAML, empty, not a map, several
 * documents, a key twice, too large, too deep); MEMORY. *out is NULL then. */
hawser_status case_tree_load(const char *path, CaseTree **out, hawser_error *err);
/* The same for text; `name` stands in for the file's name. */
hawser_status case_tree_parse(const char *text, const char *name, CaseTree **out, hawser_error *err);
/* Gives the dotted key ("chain.0.segment") a new value, which is YAML itself ("250 mm", "[0, 0, -9.8]"). Maps
 * on the way are made where they are missing; list items must exist. Errors: INPUT that names the setting;
 * MEMORY. The tree is unchanged then. */
hawser_status case_tree_set(CaseTree *tree, const char *key, const char *value, hawser_error *err);
CaseTree *case_tree_free(CaseTree *tree);

#endif
