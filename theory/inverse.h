/* What would still hold: the planner's questions the other way round, each answered by the same calculator.
 * docs/model.md, "The planner's calculation", (PN9), (PN11). */
#ifndef HAWSER_THEORY_INVERSE_H
#define HAWSER_THEORY_INVERSE_H

#include "theory/calculator.h"
#include "theory/mend.h"
#include "theory/search.h"

typedef enum InverseKind { INVERSE_FRICTION, INVERSE_RADIUS, INVERSE_BEND, INVERSE_LENGTH, INVERSE_KINDS } InverseKind;

enum { INVERSE_STAYS_MAX = 64 };

/* One answer. Limits that are broken and that the question does not touch (a duct too full, whatever the friction) do
 * not count, and are named. Of friction the largest on the route stands for all, of radii the smallest. */
typedef struct InverseAnswer {
    InverseKind kind;
    int way;
    double now;     /* 1, m, m, m: as the case has it */
    SearchEnd end;  /* NOWHERE: it would not help; EVERYWHERE: nothing binds within a thousand times */
    double value;   /* at which all limits just hold; NAN unless FOUND */
    char binds[24]; /* the limit that is broken just beyond, or whatever the value is; "pulled": the cable slackens */
    char where[80]; /* its place then */
    char what[64];  /* the bend that is meant */
    double from;    /* of friction, where less would not hold either: at least so much; NAN: no matter how little */
    char stays[INVERSE_STAYS_MAX]; /* limits that stay broken, by name */
} InverseAnswer;

enum { INVERSE_MACHINES_MAX = 64 };

/* The least number of machines of a given push, or of pits, and where they stand. */
typedef struct InverseMachines {
    int way, n;                                                   /* -1: no number of them keeps the limits */
    double at[INVERSE_MACHINES_MAX], takes[INVERSE_MACHINES_MAX]; /* m along the route; N, at speed */
    char stays[INVERSE_STAYS_MAX];
    char binds[24], where[80]; /* with one fewer; with n of -1, whatever their number is */
} InverseMachines;

typedef struct Inverse {
    int n;
    InverseAnswer answer[PLAN_WAYS * INVERSE_KINDS];
    Mend mend[PLAN_WAYS]; /* of each way that is not safe */
    int asked;            /* for machines */
    InverseMachines machines[PLAN_WAYS];
} Inverse;

/* Nothing is answered where no limit can be judged. Errors: MEMORY. */
hawser_status inverse_find(const Setup *setup, const Calculator *base, Inverse *out, hawser_error *err);
/* The fewest machines that take off up to `force` (N) each, or pits that the pull begins anew in with that tension,
 * with which all limits hold, with what is assumed at its ends too (PN11), (PN13). Errors: MEMORY. */
hawser_status inverse_place(const Setup *setup, const Calculator *base, int way, int pits, double force,
                            InverseMachines *out, hawser_error *err);

#endif
