/* Bounds that still hold: the planner's inverse questions, each answered by the same calculator.
 * docs/theory.md, "The planner's calculation", (PN9), (PN11). */
#ifndef HAWSER_THEORY_INVERSE_H
#define HAWSER_THEORY_INVERSE_H

#include "theory/calculator.h"
#include "theory/mend.h"
#include "theory/search.h"

typedef enum InverseKind { INVERSE_FRICTION, INVERSE_RADIUS, INVERSE_BEND, INVERSE_LENGTH, INVERSE_KINDS } InverseKind;

enum { INVERSE_STAYS_MAX = 64 };

/* One answer. Broken limits that do not depend on the searched value (a duct too full, whatever the friction) do not
 * count, but are named. Friction stands for the largest on the route, the radius for the smallest. */
typedef struct InverseAnswer {
    InverseKind kind;
    int way;
    double now;                    /* 1, m, m, m: the case's value */
    SearchEnd end;                 /* NOWHERE: no value helps; EVERYWHERE: no bound within a factor of a thousand */
    double value;                  /* at which all limits just hold; NAN unless FOUND */
    char binds[24];                /* limit that breaks just beyond, or at any value; "pulled": the cable slackens */
    char where[80];                /* its place */
    char what[64];                 /* the bend in question */
    double from;                   /* of friction that must not be less either: least value; NAN: no lower bound */
    char stays[INVERSE_STAYS_MAX]; /* limits that stay broken, by name */
} InverseAnswer;

enum { INVERSE_MACHINES_MAX = 64 };

/* The least number of machines of a given push, or of pits, and their places. */
typedef struct InverseMachines {
    int way, n;                                                   /* -1: no number of them keeps the limits */
    double at[INVERSE_MACHINES_MAX], takes[INVERSE_MACHINES_MAX]; /* m along the route; N, at speed */
    char stays[INVERSE_STAYS_MAX];
    char binds[24], where[80]; /* with one fewer; if n is -1, with any number */
} InverseMachines;

typedef struct Inverse {
    int n;
    InverseAnswer answer[PLAN_WAYS * INVERSE_KINDS];
    Mend mend[PLAN_WAYS]; /* of each direction that is not safe */
    int asked;            /* machines were requested */
    InverseMachines machines[PLAN_WAYS];
} Inverse;

/* Answers all questions; nothing is answered if no limit can be judged. Errors: MEMORY. */
hawser_status inverse_find(const Setup *setup, const Calculator *base, Inverse *out, hawser_error *err);
/* Finds the smallest number of machines that take off up to `force` (N) each, or of pits where the pull begins anew
 * with that tension, with which all limits hold, also at the ends of the assumed ranges (PN11), (PN13). Errors: MEMORY.
 */
hawser_status inverse_place(const Setup *setup, const Calculator *base, int way, int pits, double force,
                            InverseMachines *out, hawser_error *err);

#endif
