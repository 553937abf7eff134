/* The validation suite: part of hawser/hawser.h, which includes it. docs/validation.md describes what each case proves.
 */
#ifndef HAWSER_VALIDATE_H
#define HAWSER_VALIDATE_H

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct hawser_validation {
    const char *filter; /* runs the cases whose names hold this text; NULL or empty: all */
    int fast;           /* not 0: only the quick cases */
} hawser_validation;

/* Runs the suite; choice NULL: all of it. *text is malloc'ed (hawser_text_free): case, quantity, expected, found,
 * error, tolerance, source; *outside gets the number of quantities outside their tolerance; a case that cannot be run
 * counts as one. Errors: INPUT (no case has such a name), MEMORY. */
hawser_status hawser_validate(const hawser_validation *choice, hawser_format format, char **text, int *outside,
                              hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
