/* A case with several chains: each is the case with a chain, a drive and a place of its own.
 * docs/reference/case-keys.md, "chains.NAME", "lay". */
#ifndef HAWSER_IO_CASE_CHAINS_H
#define HAWSER_IO_CASE_CHAINS_H

#include "io/case/schema.h"

extern const CaseSection case_strand, case_lay;

/* Reads a case with one chain; as case_read. The common sections, the route and what stands along it, are read once for
 * each chain: each definition is complete, and refers to the others only by its StrandDef. */
typedef hawser_status CaseReadOne(const CaseTree *tree, SceneDef *def, hawser_error *err);

/* Reads the first chain's definition, with those of the others beside it: their places by `lay`, the joined heads,
 * theory's weight factors of common ducts. Parts that several chains do not support are an error. Errors: INPUT,
 * MEMORY; *def is cleared then. */
hawser_status chains_read(const CaseTree *tree, CaseReadOne *read, SceneDef *def, hawser_error *err);
/* ---- The tree of one chain's own case: the case's, with the chain's own values in their place (chains_tree.c). */

/* Parts of the case's drive that do not act on a chain. */
typedef struct ChainRole {
    int led;   /* its head is joined to a rope: no winch pulls it, no rope drags */
    int rope;  /* heads are joined to it: nothing holds its tail back */
    int still; /* it lies still: neither */
} ChainRole;

#endif
