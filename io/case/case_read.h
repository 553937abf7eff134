/* What a case file says, checked and turned into a SceneDef. docs/case-format.md describes every key; the
 * tables that this reader works from are in io/case/schema.c. */
#ifndef HAWSER_IO_CASE_CASE_READ_H
#define HAWSER_IO_CASE_CASE_READ_H

#include "def/scene_def.h"
#include "io/case/yaml.h"

/* Fills *def (its old content is not looked at) with what the tree says and the defaults of the rest, SI
 * units; the caller clears it with scene_def_clear. Everything that can be checked without building the scene
 * is checked. Errors: INPUT with "FILE:LINE: key 'a.b': what is wrong: what is allowed", MEMORY; *def is
 * cleared then. */
hawser_status case_read(const CaseTree *tree, SceneDef *def, hawser_error *err);

#endif
