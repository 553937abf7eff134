/* The catalogue, and what a case did not say itself: part of hawser/hawser.h, which includes it.
 * docs/guide/equipment.md. */
#ifndef HAWSER_LIBRARY_H
#define HAWSER_LIBRARY_H

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_ASSUMPTION_KEY_MAX = 96, HAWSER_ASSUMPTION_VALUE_MAX = 40, HAWSER_ASSUMPTION_SOURCE_MAX = 240 };

/* A value of a cable, rope, roller, duct or friction of which not all was given in the case. */
typedef struct hawser_assumption {
    char key[HAWSER_ASSUMPTION_KEY_MAX];       /* dotted, as hawser_case_set has it: "cables.power.EI" */
    char value[HAWSER_ASSUMPTION_VALUE_MAX];   /* with its unit, as it was written */
    const char *origin;                        /* "given", "catalogue", "estimated" or "not read"; lives for ever */
    char source[HAWSER_ASSUMPTION_SOURCE_MAX]; /* the entry and where its figures are from; how it was estimated, what
                                                * it may be off by, and where that matters; what of a file is not in
                                                * the route, and how often in value. Of a given value empty */
} hawser_assumption;

/* Given, from the catalogue, estimated: the values of every part of the case that has one of the latter two. A value
 * that several rollers or ducts of one type have stands once. *out stays the simulation's. Returns how many. */
int hawser_sim_assumptions(const hawser_sim *s, const hawser_assumption **out);

/* The shipped catalogue with figures, ranges, marks and sources: of one kind ("cables", "ropes", "rollers", "ducts",
 * "friction", "reels"; NULL or empty: all), and of it the entries whose names hold `pattern` (NULL or empty: all). It
 * is looked for in the folder that the environment variable HAWSER_LIBRARY names, else in share/hawser/library beside
 * the program or the library. *text is malloc'ed (hawser_text_free). Errors: INPUT (no such kind, no such entry, no
 * catalogue), MEMORY. */
hawser_status hawser_library(const char *kind, const char *pattern, hawser_format format, char **text,
                             hawser_error *err);

/* Adds an entry to a catalogue of one's own, which is made if it is not there: of one kind, with a name and `n` values
 * as "KEY=VALUE", keys of a case or `source`, `note`, `mark`, `range`, values as in a case ("91.5 mm", "{material:
 * copper, area: 800 mm2}"). All else in the file stays as it is; its kind must not stand in brackets. Errors: INPUT (no
 * such kind, key or value, a name that is taken, a file that is no catalogue), OUTPUT, MEMORY; the file is as before
 * then. */
hawser_status hawser_library_add(const char *file, const char *kind, const char *name, int n, const char *const *values,
                                 hawser_error *err);

/* Where the files are looked for that the case's `include` names; what hawser_case_load has set for a file. A case from
 * hawser_case_parse has no folder, and may include nothing, until it is given one. Errors: MEMORY. */
hawser_status hawser_case_folder(hawser_case *c, const char *folder, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
