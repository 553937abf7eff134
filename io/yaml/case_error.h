/* Messages about a case: where, which key, what value, what is allowed. */
#ifndef HAWSER_IO_YAML_CASE_ERROR_H
#define HAWSER_IO_YAML_CASE_ERROR_H

#include "hawser/hawser.h"
#include "io/yaml/yaml_node.h"

enum { CASE_PLACE_MAX = 300, CASE_SHOWN_MAX = 80, CASE_PATH_MAX = 256 };

/* "FILE:LINE", or the origin alone for line 0. Writes and returns `place`, which has CASE_PLACE_MAX bytes. */
const char *case_place(const char *origin, int line, char *place);
/* The user's text in quotes, on one line and cut short. `shown` has CASE_SHOWN_MAX bytes. */
const char *case_shown(const char *text, char *shown);
/* The dotted key of a node, or of its child `key` (NULL: itself). `path` has CASE_PATH_MAX bytes. */
const char *case_path(const CaseNode *node, const char *key, char *path);

/* "PLACE: key 'PATH': value 'TEXT'WHAT", or "the value is a mapWHAT": WHAT brings its own blank or colon.
 * Returns HAWSER_ERR_INPUT. */
hawser_status case_value_error(hawser_error *err, const CaseNode *node, const char *what, ...)
    __attribute__((format(printf, 3, 4)));
/* "PLACE: key 'PATH': WHAT" about the node, or about its child `key` that may be absent. */
hawser_status case_key_error(hawser_error *err, const CaseNode *node, const char *key, const char *what, ...)
    __attribute__((format(printf, 4, 5)));

/* The name of names[n] that `word` was probably meant to be; NULL if none is near. */
const char *case_nearest(const char *word, const char *const *name, int n);

#endif
