/* The catalogue, and the values that a case does not give itself: part of hawser/hawser.h, which includes it.
 * docs/guide/equipment.md. */
#ifndef HAWSER_LIBRARY_H
#define HAWSER_LIBRARY_H

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

enum { HAWSER_ASSUMPTION_KEY_MAX = 96, HAWSER_ASSUMPTION_VALUE_MAX = 40, HAWSER_ASSUMPTION_SOURCE_MAX = 240 };

/* A value of a cable, rope, roller, duct or friction that the case does not give completely. */
typedef struct hawser_assumption {
    char key[HAWSER_ASSUMPTION_KEY_MAX];       /* dotted, as for hawser_case_set: "cables.power.EI" */
    char value[HAWSER_ASSUMPTION_VALUE_MAX];   /* with its unit, as it was written */
    const char *origin;                        /* "given", "catalogue", "estimated" or "not read"; lives for ever */
    char source[HAWSER_ASSUMPTION_SOURCE_MAX]; /* the entry and the source of its figures; for an estimate its method,
                                                * its possible error and where that matters; for a file what is not in
                                                * the route (how often: in value). Empty for a given value */
} hawser_assumption;

/* Returns how many values there are (given, from the catalogue, estimated) of all parts of the case with at least one
 * of the latter two. A value that several rollers or ducts of one type share is listed once. *out stays the
 * simulation's. */
int hawser_sim_assumptions(const hawser_sim *s, const hawser_assumption **out);

/* Returns the shipped catalogue with figures, ranges, marks and sources: of one kind ("cables", "ropes", "rollers",
 * "ducts", "friction", "reels"; NULL or empty: all), and only entries whose names hold `pattern` (NULL or empty: all).
 * It is read from the folder that the environment variable HAWSER_LIBRARY names, else from share/hawser/library beside
 * the program or the library. *text is malloc'ed (hawser_text_free). Errors: INPUT (no such kind, no such entry, no
 * catalogue), MEMORY. */
hawser_status hawser_library(const char *kind, const char *pattern, hawser_format format, char **text,
                             hawser_error *err);

/* Adds an entry to the caller's own catalogue, which is made if it does not exist: of one kind, with a name and `n`
 * values as "KEY=VALUE", keys of a case or `source`, `note`, `mark`, `range`, values as in a case ("91.5 mm",
 * "{material: copper, area: 800 mm2}"). All else in the file stays as it is; the kind must not stand in brackets there.
 * Errors: INPUT (no such kind, key or value, a name that is taken, a file that is no catalogue), OUTPUT, MEMORY; the
 * file is unchanged then. */
hawser_status hawser_library_add(const char *file, const char *kind, const char *name, int n, const char *const *values,
                                 hawser_error *err);

/* Sets the folder of the files that the case's `include` names; hawser_case_load sets it to the folder of the case
 * file. A case from hawser_case_parse has no folder, and may include nothing, until it gets one. Errors: MEMORY. */
hawser_status hawser_case_folder(hawser_case *c, const char *folder, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
