/* The tree of one chain's own case: the case's, with what the chain says in its place. */
#ifndef HAWSER_IO_CHAINS_CHAINS_TREE_H
#define HAWSER_IO_CHAINS_CHAINS_TREE_H

#include "io/yaml/yaml_tree.h"

/* What the case's drive does not do to a chain. */
typedef struct ChainRole {
    int led;   /* its head is joined to a rope: no winch pulls it, no rope drags */
    int rope;  /* heads are joined to it: nothing holds its tail back */
    int still; /* it lies still: neither */
} ChainRole;

/* NULL if there is no memory; node: the chain's map. */
CaseNode *chain_tree(const CaseNode *root, const CaseNode *node, const ChainRole *role);

#endif
