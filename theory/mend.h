/* Theory of a definition, whole: for those who ask what becomes of a case that is changed. */
#ifndef HAWSER_THEORY_MEND_H
#define HAWSER_THEORY_MEND_H

#include "theory/calculator.h"

/* Its parts borrow from each other: it stays where it is made. */
typedef struct Solved {
    SceneDef def;
    Setup setup;
    Expected expected;
    Calculator c;
} Solved;

/* Solves a definition that is its own from now on. company: of the case that it comes from; stays. Errors: as
 * setup_make and calculator_build. Give it back with solved_free, also after an error. */
hawser_status solved_make(const SceneDef *own, const Company *company, int forward_only, Solved *out,
                          hawser_error *err);
void solved_free(Solved *s);
/* Values that a case does not give and that its limits depend on: friction, friction at rest, back tension, radii of
 * changes of slope. Each limit
 * is judged at the unfavourable end of the usual range of one of them at a time. docs/reference/limits.md, "What is
 * assumed". */

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
/* Sets `worst`, `assumed` and the bounds of limits that were judged, limit[way][n] of the first `ways` ways; what an
 * unknown friction touches is no longer judged. base: theory of the case, of which the limits are; NULL: they are a
 * run's, whose values change as theory's do. bounds: 0: the values taken stand for bounds, and where a limit is broken
 * anyway the others are not varied, for those who need the word alone. Errors: as calculator_build. */
hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err);
/* Computes all limits of a way, and whether they hold, with all that is assumed at its upper end. Errors: as above. */
hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err);
/* What would make a pull safe, computed again with all limits: ducts in which the cables jam or have no room, radii of
 * the bends that are too tight, all together, and less friction where that is not enough. docs/model.md, "The planner's
 * calculation", (PN12). */

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
