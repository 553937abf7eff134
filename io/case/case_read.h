/* Reads and checks a case file into a SceneDef. docs/reference/case-keys.md describes every key; the tables that this
 * reader works from are in io/case/schema.c. */
#ifndef HAWSER_IO_CASE_CASE_READ_H
#define HAWSER_IO_CASE_CASE_READ_H

#include "def/scene_def.h"
#include "io/case/yaml.h"

/* Fills *def (its old content is ignored) with the values of the tree and the defaults of the rest, in SI units; the
 * caller clears it with scene_def_clear. Checks everything that can be checked without building the scene. Errors:
 * INPUT with "FILE:LINE: key 'a.b': what is wrong: what is allowed", MEMORY; *def is cleared then. */
hawser_status case_read(const CaseTree *tree, SceneDef *def, hawser_error *err);

#endif
