/* Complete theory of a definition, for callers that change a case. */
#ifndef HAWSER_THEORY_MEND_H
#define HAWSER_THEORY_MEND_H

#include "theory/calculator.h"

/* Its parts borrow from each other: it must not be moved in memory. */
typedef struct Solved {
    SceneDef def;
    Setup setup;
    Expected expected;
    Calculator c;
} Solved;

/* Solves a definition and takes ownership of it. company: of the original case, must outlive the result. Errors: as
 * setup_make and calculator_build. The result must be freed with solved_free, also after an error. */
hawser_status solved_make(const SceneDef *own, const Company *company, int forward_only, Solved *out,
                          hawser_error *err);
void solved_free(Solved *s);
/* Values that a case does not give and that its limits depend on: friction, static friction, back tension, radii of
 * changes of slope. Each limit is judged at the unfavourable end of the usual range of one of them at a time.
 * docs/guide/read-the-verdict.md, "SAFE ONLY IF". */

typedef enum AssumedKind {
    ASSUMED_RADIUS,   /* of changes of slope: it has no range; a limit that it breaks requires a wider one */
    ASSUMED_FRICTION, /* typical of the named materials: it has a range */
    ASSUMED_UNKNOWN,  /* unknown friction: limits that depend on it are not judged */
    ASSUMED_REST,     /* static friction where the case gives one coefficient */
    ASSUMED_BACK,     /* back tension */
    ASSUMED_KINDS
} AssumedKind;

enum { ASSUMED_KEY_MAX = 48 };

typedef struct Assumed {
    AssumedKind kind;
    const char *name, *unit;
    double value, low, high;   /* the value taken; its usual range. NAN: unknown */
    int more;                  /* number of other keys with the same assumption */
    char key[ASSUMED_KEY_MAX]; /* key of the case that gives it */
    char source[96];
} Assumed;

/* Lists the values that the definition leaves open and theory uses, of several frictions the largest. Returns their
 * number. */
int assumed_list(const Setup *setup, Assumed out[ASSUMED_KINDS]);
/* The case's key of a surface: "surfaces.ducts.2.radius" of its key "radius". */
void surface_key(const SceneDef *def, int i, const char *of, char key[ASSUMED_KEY_MAX]);
/* A friction that theory uses, and the section of the case that gives it. */
typedef struct FrictionUsed {
    double moving, rest;       /* 1 */
    int rest_assumed, apart;   /* as in FrictionKnown */
    char key[ASSUMED_KEY_MAX]; /* "friction", "surfaces.ducts.0.friction", "theory.stretches.1" */
} FrictionUsed;

/* Lists the frictions, one of each section, at most `most`. Returns their number. */
int frictions_used(const Setup *setup, int most, FrictionUsed out[]);
/* Sets `worst`, `assumed` and the bounds of judged limits, limit[way][n] of the first `ways` directions; limits that
 * depend on an unknown friction become unjudged. base: the case's theory, whose limits these are; NULL: they are a
 * run's, and change as theory's do. bounds: 0 for the verdict alone: the values taken stand for the bounds, and after a
 * broken limit nothing more is varied. Errors: as calculator_build. */
hawser_status assumed_judge(const Setup *setup, const Calculator *base, int ways, int bounds, int n,
                            hawser_limit *const limit[], hawser_error *err);
/* Computes all limits of a direction, and whether they hold, with all assumed values at their upper ends. Errors: as
 * above. */
hawser_status assumed_together(const Setup *setup, const Calculator *base, int way, hawser_limit out[HAWSER_LIMITS_MAX],
                               hawser_error *err);
/* Changes that make a pull safe, recomputed with all limits: wider ducts where the cables jam or do not fit, wider
 * bends, all together, and less friction where that is not enough. docs/theory.md, "The planner's calculation", (PN12).
 */

/* A case as it is, and with each assumed value at its upper end: a result that holds for all of them does not depend on
 * the assumptions. */
typedef struct Ends {
    int n;
    Solved at[1 + ASSUMED_KINDS];
    int of_friction[1 + ASSUMED_KINDS]; /* friction itself is at its end: no longer assumed once it is changed */
} Ends;

/* Solves the ends, and leaves out those that cannot be computed. def: the setup's, or that with other ducts. Errors: as
 * solved_make. The result must be freed with ends_free. */
hawser_status ends_make(const Setup *setup, const SceneDef *def, Ends **out, hawser_error *err);
void ends_free(Ends *ends);
enum { MEND_BENDS_MAX = 64, MEND_DUCTS_MAX = 8, MEND_STILL_MAX = 160 };

/* A bend with another radius. */
typedef struct MendBend {
    int piece;          /* of the route */
    double now, radius; /* m, as the case gives it; rounded up to three digits */
} MendBend;

/* Inside diameters, m, with which a duct's limits hold: all from `least` on, or, if wide ones fail, the next range
 * above the duct's own, else below it. */
typedef struct MendDuct {
    int surface; /* of the definition */
    double now, least, most;
    double taken; /* of a mended pull: the diameter used */
} MendDuct;

typedef struct Mend {
    int way;
    int safe;        /* every limit and condition holds with these changes, at the values taken */
    char word[96];   /* verdict with the assumed ranges: "SAFE", "SAFE ONLY IF ..."; backward without bounds */
    int conditional; /* the verdict is conditional */
    unsigned beside; /* 1 << kind: limits that are broken in a run and unknown to theory */
    int unjudged;    /* or NOT JUDGED: friction or allowed values are unknown */
    int n, n_ducts;
    MendBend bend[MEND_BENDS_MAX];
    MendDuct duct[MEND_DUCTS_MAX]; /* computed with the nearer end */
    double now, friction;          /* largest coefficient, rounded down; friction NAN: unchanged */
    char still[MEND_STILL_MAX];    /* names of limits and conditions that still do not hold */
} Mend;

/* Finds changes for a direction that is not safe; n of 0 and friction NAN if neither helps. run[n_run]: a run's limits
 * in place of theory's; their excess over theory's counts as proportional to the pull or constant, whichever is worse;
 * NULL: none. ends: of the case; NULL: computed here. Errors: MEMORY. */
hawser_status mend_find(const Setup *setup, const Calculator *base, const Ends *ends, int way, int n_run,
                        const hawser_limit *run, Mend *out, hawser_error *err);
/* Radius of a bend as the case gives it, m: in plan if the bend keeps its grade on a slope. */
double mend_radius_given(const SceneDef *def, const Route *route, int piece);
/* Finds diameters for a duct whose limits do not hold. Returns 0 if there is none between the cable's and eight times
 * that. */
int mend_duct(const SceneDef *def, int surface, MendDuct *out);

#endif
