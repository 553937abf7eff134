/* A case with several chains: each is the case with a chain, a drive and a place of its own. docs/case-format.md,
 * "chains.NAME", "lay". */
#ifndef HAWSER_IO_CHAINS_CHAINS_H
#define HAWSER_IO_CHAINS_CHAINS_H

#include "io/schema/case_schema.h"

extern const CaseSection case_strand, case_lay;

/* Reads a case with one chain; as case_read. */
typedef hawser_status CaseReadOne(const CaseTree *tree, SceneDef *def, hawser_error *err);

/* The first chain's definition, with those of the others beside it. Errors: INPUT, MEMORY; *def is cleared then. */
hawser_status chains_read(const CaseTree *tree, CaseReadOne *read, SceneDef *def, hawser_error *err);

#endif
