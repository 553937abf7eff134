/* Values that a case does not give and that its limits depend on: friction, friction at rest, back tension. Each limit
 * is judged at the unfavourable end of the usual range of one of them at a time. docs/limits.md, "What is assumed". */
#ifndef HAWSER_THEORY_ASSUMED_H
#define HAWSER_THEORY_ASSUMED_H

#include "theory/calculator.h"

typedef enum AssumedKind {
    ASSUMED_FRICTION, /* typical of what is named: it has a range */
    ASSUMED_UNKNOWN,  /* friction of which nothing is known: what it touches is not judged */
    ASSUMED_REST,     /* friction at rest where one coefficient is given */
    ASSUMED_BACK,     /* back tension */
    ASSUMED_KINDS
} AssumedKind;

typedef struct Assumed {
    AssumedKind kind;
    const char *name, *unit, *key; /* key: of the case, to give it */
    double value, low, high;       /* taken; its usual range. NAN: no range is known */
    char source[96];
} Assumed;

/* Lists what the definition leaves open, of several frictions the largest. Returns how many there are. */
int assumed_list(const SceneDef *def, Assumed out[ASSUMED_KINDS]);

/* Sets `worst`, `assumed` and the bounds of limits that were judged, limit[way][n] of the first `ways` ways; what an
 * unknown friction touches is no longer judged. base: theory of the case, of which the limits are; NULL: they are a
 * run's, whose values change as theory's do. bounds: 0: the values taken stand for bounds, and where a limit is broken
 * anyway the others are not varied, for those who need the word alone. Errors: as calculator_build. */
hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err);

/* Computes all limits of a way, and whether they hold, with all that is assumed at its upper end. Errors: as above. */
hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err);

#endif
