/* The units in which figures are shown. Everything is kept in SI; here alone it is turned into what people read. */
#ifndef HAWSER_IO_RESULTS_SHOWN_H
#define HAWSER_IO_RESULTS_SHOWN_H

#include "hawser/hawser.h"

/* A value times `factor` is so many `unit`. */
typedef struct Scale {
    double factor;
    const char *unit; /* lives for ever, or is the unit that was asked about */
} Scale;

/* How values of a unit are shown of which the largest is `size` (in that unit; NAN: the plain unit). A unit that is not
 * in the table ("s", "deg") stays as it is. */
Scale scale_of(const char *unit, double size, hawser_units units);

/* The unit with which a key ends, as in "forward_end_N" and "max_sidewall_N_per_m"; "" if it has none. */
const char *unit_of_key(const char *key);
/* The length of a key without its unit. */
size_t key_length(const char *key);

/* A number in so many significant digits, never with a power of ten where it can be read without. `text` has
 * HAWSER_SHOWN_MAX bytes. */
const char *say_digits(double value, int digits, char *text);

/* The pairs of units one by one, for tests: NULL behind the last. *factor: how many of `*shown` one `*si` is. */
const char *shown_pair(int i, const char **shown, double *factor);

#endif
