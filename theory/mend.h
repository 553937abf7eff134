/* What would make a pull safe, computed again with all limits: ducts in which the cables jam or have no room, radii of
 * the bends that are too tight, all together, and less friction where that is not enough. docs/model.md, "The planner's
 * calculation", (PN12). */
#ifndef HAWSER_THEORY_MEND_H
#define HAWSER_THEORY_MEND_H

#include "theory/assumed.h"
#include "theory/solved.h"

/* A case as it is, and with each of what is assumed at its upper end: what holds for them all is sure. */
typedef struct Ends {
    int n;
    Solved at[1 + ASSUMED_KINDS];
    int of_friction[1 + ASSUMED_KINDS]; /* friction itself is assumed there: where it is changed it is known */
} Ends;

/* Solves them; one that cannot be computed is left out. def: the setup's, or that with other ducts. Errors: as
 * solved_make. Give it back with ends_free. */
hawser_status ends_make(const Setup *setup, const SceneDef *def, Ends **out, hawser_error *err);
void ends_free(Ends *ends);

enum { MEND_BENDS_MAX = 64, MEND_DUCTS_MAX = 8, MEND_STILL_MAX = 160 };

/* A bend with another radius. */
typedef struct MendBend {
    int piece;          /* of the route */
    double now, radius; /* m, as the case gives it; rounded up to three digits */
} MendBend;

/* Inside diameters, m, with which a duct's limits hold: from one on, or, where no wide one does, those next above its
 * own, or else next below. */
typedef struct MendDuct {
    int surface; /* of the definition */
    double now, least, most;
    double taken; /* of a mended pull: with which it was computed */
} MendDuct;

typedef struct Mend {
    int way;
    int safe;        /* with all of it every limit and condition holds, at the values that were taken */
    char word[96];   /* and with what is assumed at its ends: "SAFE", "SAFE ONLY IF ..."; backward without bounds */
    int conditional; /* the second */
    unsigned beside; /* 1 << kind: limits that are broken in a run and that theory does not know */
    int unjudged;    /* or neither: of the friction, or of what is allowed, nothing is known */
    int n, n_ducts;
    MendBend bend[MEND_BENDS_MAX];
    MendDuct duct[MEND_DUCTS_MAX]; /* computed with the end that is nearer */
    double now, friction;          /* the largest coefficient, rounded down; friction NAN: it stays as it is */
    char still[MEND_STILL_MAX];    /* what is not kept all the same: limits and conditions, by name */
} Mend;

/* Of a way that is not safe; n of 0 and friction NAN where neither helps. run[n_run]: a run's limits, which stand for
 * theory's then: what each has more than theory's may go with the pull or stay, whichever is worse; NULL: there are
 * none. ends: of the case; NULL: it makes its own. Errors: MEMORY. */
hawser_status mend_find(const Setup *setup, const Calculator *base, const Ends *ends, int way, int n_run,
                        const hawser_limit *run, Mend *out, hawser_error *err);
/* The radius of a bend as the case gives it, m: in plan, where it keeps its grade on a slope. */
double mend_radius_given(const SceneDef *def, const Route *route, int piece);
/* Of a duct whose limits do not hold. 0: no diameter from the cable's up to eight times as wide does. */
int mend_duct(const SceneDef *def, int surface, MendDuct *out);

#endif
