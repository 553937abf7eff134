/* Writing into a case's tree: what a drawing says stands there afterwards as if somebody had typed it. A node that is
 * put where there was another takes its place. */
#ifndef HAWSER_IO_PLACE_TREE_H
#define HAWSER_IO_PLACE_TREE_H

#include "io/yaml/yaml_tree.h"

/* The map or list `key` of a map, made if it is not there; NULL: no memory. A map where a list is wanted becomes its
 * only item. */
CaseNode *tree_child(CaseNode *map, const char *key, NodeKind kind);
/* A text like the printed one under a map's key, said to be where `like` is. 0: no memory. */
int tree_put(CaseNode *map, const CaseNode *like, const char *key, const char *format, ...)
    __attribute__((format(printf, 4, 5)));
/* A length, m, such that reading it gives the same number. 0: no memory. */
int tree_put_length(CaseNode *map, const CaseNode *like, const char *key, double metres);

#endif
