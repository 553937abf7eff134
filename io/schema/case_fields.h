/* Reads one section of a case by its table: the part that every section has in common. */
#ifndef HAWSER_IO_SCHEMA_CASE_FIELDS_H
#define HAWSER_IO_SCHEMA_CASE_FIELDS_H

#include "core/route.h"
#include "io/schema/case_schema.h"
#include "io/yaml/yaml_node.h"
#include "sim/def/scene_def.h"

/* One case being read. */
typedef struct CaseReader {
    Units *units;
    SceneDef *def;
    Route route; /* built once its section is read, for what lies along it */
    const CaseNode *root;
    hawser_error *err;
} CaseReader;

/* Fills `record` from a map: unknown keys, missing ones, types, units and ranges are errors (INPUT). node
 * NULL: the section is not there; optional keys get their defaults, required ones zeros. */
hawser_status case_section_read(const CaseReader *r, const CaseNode *node, const CaseSection *section, void *record);

/* One number of the key's dimension and range, SI. Errors: INPUT. */
hawser_status case_number_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, double *value);
/* A list of n numbers, each of its key. Errors: INPUT. */
hawser_status case_numbers_read(const CaseReader *r, const CaseNode *node, int n, const CaseKey *const key[],
                                double value[]);
/* One whole number. Errors: INPUT. */
hawser_status case_integer_read(const CaseReader *r, const CaseNode *node, const CaseKey *key, long *value);
/* Whether a number that was read lies in the key's range. Errors: INPUT. */
hawser_status case_range_check(const CaseReader *r, const CaseNode *node, const CaseKey *key, double value);

/* The row of a key that the section is known to have. */
const CaseKey *case_key_of(const CaseSection *section, const char *name);

enum { CASE_RANGE_MAX = 96 };
/* "above 0 m, at most 1e6 m": what a number may be, in the dimension's SI unit, angles in degrees. `text` has
 * CASE_RANGE_MAX bytes. */
const char *case_range_text(const CaseKey *key, char *text);

#endif
