/* Values that a case does not give and that its limits depend on: friction, friction at rest, back tension, radii of
 * changes of slope. Each limit
 * is judged at the unfavourable end of the usual range of one of them at a time. docs/limits.md, "What is assumed". */
#ifndef HAWSER_THEORY_ASSUMED_H
#define HAWSER_THEORY_ASSUMED_H

#include "theory/calculator.h"

typedef enum AssumedKind {
    ASSUMED_RADIUS,   /* of changes of slope: it has no range, and a limit that it breaks asks for a wider one */
    ASSUMED_FRICTION, /* typical of what is named: it has a range */
    ASSUMED_UNKNOWN,  /* friction of which nothing is known: what it touches is not judged */
    ASSUMED_REST,     /* friction at rest where one coefficient is given */
    ASSUMED_BACK,     /* back tension */
    ASSUMED_KINDS
} AssumedKind;

enum { ASSUMED_KEY_MAX = 48 };

typedef struct Assumed {
    AssumedKind kind;
    const char *name, *unit;
    double value, low, high;   /* taken; its usual range. NAN: no range is known */
    int more;                  /* other keys that give it elsewhere */
    char key[ASSUMED_KEY_MAX]; /* of the case, to give it */
    char source[96];
} Assumed;

/* Lists what the definition leaves open and theory uses, of several frictions the largest. Returns how many there
 * are. */
int assumed_list(const Setup *setup, Assumed out[ASSUMED_KINDS]);

/* Whether a piece of the route rounds a change of slope between pieces of the case, with the radius that all of these
 * have between them. */
int route_rounds_slope(const Route *route, int piece);

/* The case's key of a surface: "surfaces.ducts.2.radius" of its key "radius". */
void surface_key(const SceneDef *def, int i, const char *of, char key[ASSUMED_KEY_MAX]);

/* A friction that theory reckons with, and the section of the case that gives it. */
typedef struct FrictionUsed {
    double moving, rest; /* 1 */
    int rest_assumed;
    char key[ASSUMED_KEY_MAX]; /* "friction", "surfaces.ducts.0.friction", "theory.stretches.1" */
} FrictionUsed;
/* Lists them, one of each section, at most `most`. Returns how many there are. */
int frictions_used(const Setup *setup, int most, FrictionUsed out[]);

/* Gives what is assumed that way another value. */
void assumed_set(SceneDef *def, const Assumed *a, double x);

/* Sets `worst`, `assumed` and the bounds of limits that were judged, limit[way][n] of the first `ways` ways; what an
 * unknown friction touches is no longer judged. base: theory of the case, of which the limits are; NULL: they are a
 * run's, whose values change as theory's do. bounds: 0: the values taken stand for bounds, and where a limit is broken
 * anyway the others are not varied, for those who need the word alone. Errors: as calculator_build. */
hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err);

/* The same of the limits limit[n] of one way of a case that is changed (`by`); friction that changes is known then. */
hawser_status assumed_judge_varied(const Setup *setup, const Variation *by, int bounds, int n, hawser_limit *limit,
                                   hawser_error *err);

/* Computes all limits of a way, and whether they hold, with all that is assumed at its upper end. Errors: as above. */
hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err);

#endif
