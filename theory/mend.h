/* What would make a pull safe, computed again with all limits: radii of the bends that are too tight, together, and
 * less friction where that is not enough. docs/model.md, "The planner's calculation", (PN12). */
#ifndef HAWSER_THEORY_MEND_H
#define HAWSER_THEORY_MEND_H

#include "theory/calculator.h"

enum { MEND_BENDS_MAX = 64, MEND_STILL_MAX = 160 };

/* A bend with another radius. */
typedef struct MendBend {
    int piece;          /* of the route */
    double now, radius; /* m; rounded up to three digits */
} MendBend;

typedef struct Mend {
    int way;
    int safe; /* with all of it every limit and condition holds, at the values that were taken */
    int n;
    MendBend bend[MEND_BENDS_MAX];
    double now, friction;       /* the largest coefficient, rounded down; friction NAN: it stays as it is */
    char still[MEND_STILL_MAX]; /* what is not kept all the same: limits and conditions, by name */
} Mend;

/* Of a way that is not safe; n of 0 and friction NAN where neither helps. Errors: MEMORY. */
hawser_status mend_find(const Setup *setup, const Calculator *base, int way, Mend *out, hawser_error *err);
/* Whether all limits and conditions of one way hold at the values that were taken (ranges of what is assumed are not
 * looked at); otherwise what is not kept, by name. */
int calculator_is_safe(const Setup *setup, const Calculator *c, int way, char still[MEND_STILL_MAX]);

#endif
