/* The pulling calculator of a scene: the whole route filled with cable and pulled in either direction, and every
 * earlier place of the cable's head. docs/theory.md, "The planner's calculation" and "Limits". */
#ifndef HAWSER_THEORY_CALCULATOR_H
#define HAWSER_THEORY_CALCULATOR_H

#include "def/limits.h"
#include "theory/environment.h"
#include "theory/expected.h"
#include "theory/plan.h"

/* Position of the cables in one duct of the scene. */
typedef struct CalculatorDuct {
    const SurfaceDef *surface; /* the scene's */
    DuctLoad load;
} CalculatorDuct;

/* Conditions for theory to describe the case: something carries the cable; no friction is larger than assumed; the
 * medium does not matter; the drive is known. */
enum { KNOWN_SUPPORT, KNOWN_FRICTION, KNOWN_MEDIUM, KNOWN_DRIVE, CALCULATOR_KNOWN };

/* Rule of friction on a piece of the route: (T6), (LI1), or each on a part. */
typedef enum SupportRule { SUPPORT_RESULTANT, SUPPORT_SEPARATE, SUPPORT_MIXED } SupportRule;

/* A roller beside a bend without rollers, which bears the bend's load. */
typedef struct Bearer {
    int piece, roller;
} Bearer;

/* A rated carrier on a straight with a neighbour in a bend, so that it turns the cable as well: its place, m along the
 * route; the downward and lateral force per tension of a cable that is taut to its neighbours; the length of cable it
 * carries, m. */
typedef struct Beside {
    int roller;
    double s, down, aside, gap;
} Beside;

/* The place where the compression exceeds its allowed value most (the push of a machine behind it, or the intended
 * push); if it exceeds it nowhere, the place of the largest compression. */
typedef struct Pushed {
    double force, allowed; /* N */
    double at;             /* m along the route */
    int piece;             /* of the route at that place */
} Pushed;

/* Reason for run-away: the case as it is; the least friction of the script; pushes larger than the pull at the winch;
 * the cable's own weight, without any push; the late start of the back tension; a chain that pulls others runs ahead of
 * them. */
typedef enum Away { AWAY_AS_IT_IS, AWAY_LOOSENED, AWAY_OVERFED, AWAY_BY_ITSELF, AWAY_EARLY, AWAY_FROM_DRAWN } Away;

typedef struct Calculator {
    const Route *route; /* the scene's, or `own` */
    Route own;          /* a varied route */
    PlanDef def;        /* definition of the plan; borrows all arrays below */
    int cables;
    double mu_least, mu_largest; /* along the route, without a duct's correction and wear */
    Stretches stretches;         /* of all cables together */
    PullStep *push[PLAN_WAYS];   /* [the setup's pushers] along the pull */
    PullStep *step;              /* [def.n_steps] machines and pits of the section `theory` */
    double *spacing, *guides;    /* [pieces] m, largest gap between carriers, and between guides; 0: none */
    int n_bearers;
    Bearer *bearer; /* [n_bearers] */
    int n_beside;
    Beside *beside;    /* [n_beside] with the case's own radii */
    SupportRule *rule; /* [pieces] */
    int n_ducts;
    CalculatorDuct *duct;  /* [n_ducts] */
    SupportRoller *roller; /* [the map's rollers] those the rope may run on, on this route */
    Plan plan;
    HeadSeries heads[PLAN_WAYS]; /* winch force by place of the head */
    double
        beyond[PLAN_WAYS]; /* N, least excess of the winch force over the tension at the cable's front, without chains
                            * that are pulled; below 0: rope that hangs down ahead relieves the winch (LI11a) */
    int n_limits;          /* in each direction; 0: the case has none */
    hawser_limit limit[PLAN_WAYS][HAWSER_LIMITS_MAX];
    hawser_condition pulled[PLAN_WAYS]; /* the cable is in tension everywhere */
    hawser_condition limp[PLAN_WAYS];   /* bending stiffness breaks no limit; its effect (T32) */
    Pushed pushed[PLAN_WAYS];           /* largest compression */
    Away away[PLAN_WAYS];               /* and its reason */
    double early[PLAN_WAYS];            /* s, of AWAY_EARLY: time of the largest compression */
    Brake brake[PLAN_WAYS];             /* against run-away; its `brake` is 0 where none is needed */
    TripSetting trip[PLAN_WAYS];
    int best;                      /* direction that keeps the limits better; without limits the one with less force */
    LayerNear *near[PLAN_WAYS];    /* [layers] owned: clearances from the environment; NULL: none, or the base's */
    const struct Calculator *base; /* of a variation: what it varies, borrowed; NULL: it is none */
    hawser_condition known[CALCULATOR_KNOWN]; /* theory takes everything in the case into account */
} Calculator;

/* What is computed: of FORWARD, data of the other direction stay zero, and `best` and `plan.better` are meaningless; of
 * PEAKS, `heads` has no rows. */
enum { CALCULATE_ALL = 0, CALCULATE_FORWARD = 1, CALCULATE_PEAKS = 2 };

/* Builds and solves the calculator. expected: provides the tension of all cables where the pull begins, in either
 * direction. what: a sum of the above. The scene must outlive it. Errors: INPUT (as plan_build), MEMORY. The result
 * must be freed with calculator_free, also after an error. */
hawser_status calculator_build(const Setup *setup, const Expected *expected, int what, Calculator *out,
                               hawser_error *err);
void calculator_free(Calculator *c);
/* Builds a condition of theory, which holds where value <= allowed. */
hawser_condition theory_condition(hawser_condition_kind kind, double value, double allowed);
/* Fills limits and `pulled` of a solved calculator. Errors: MEMORY. */
hawser_status calculator_judge(const Setup *setup, Calculator *c, hawser_error *err);
/* Checks whether a bend presses the cable away from a guide of a row, so that the guide bears nothing. */
int guide_stands_outside(const Route *route, const RollerDef *guide);
/* Fills `known` and `limp` of a solved calculator. Errors: as plan_build. */
hawser_status calculator_know(const Setup *setup, Calculator *c, hawser_error *err);
/* Checks whether the case gives friction for theory alone at s (m along the route), or along the whole route if s is
 * NAN. */
int friction_is_given(const Setup *setup, double s);
/* Checks three conditions of a forward pull and writes the first that fails into *out, which must hold on entry: sag of
 * unsupported spans (T29), uplift (T31), lateral support in bends (T30). Errors: as plan_build. */
hawser_status supported_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err);
/* Increase of the pull that the kept limits allow, N, and the limit that allows least; NULL: no limit depends on the
 * pull. */
double limits_left(const Calculator *c, int way, const hawser_limit **least);
/* Checks whether the estimated effect of bending stiffness (`value`, N of winch force) would break a limit that holds
 * without it (T32). */
hawser_condition stiffened_judge(const Setup *setup, const Calculator *c, int way);
/* Checks whether the route crosses itself within the cable's length, into a condition that holds on entry. Errors:
 * MEMORY. */
hawser_status crossing_judge(const Setup *setup, hawser_condition *out, hawser_error *err);
/* Checks whether limits of a forward pull hold while belts that run ahead of the winch build up their force at the
 * start (WI24), into a condition that holds on entry. Errors: MEMORY. */
hawser_status started_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err);
/* Computes the load of each rated roller, load[n_rollers] in N, from this chain, those that it pulls and all others
 * (SC18); 0 where theory knows none. */
void calculator_rollers(const Setup *setup, const Calculator *c, int way, double *load);
/* Largest winch force, N, over all places of the head, moving or from rest; for a rope with all chains that it pulls,
 * each at its own maximum (SC15). */
double calculator_peak(const Setup *setup, const Calculator *c, int way);
/* Checks whether the front's places count for slack: the case defines where the front begins and is drawn by a winch.
 */
int heads_slacken(const Setup *setup);
/* Fills `pulled`, `pushed`, `away` and `early`. Errors: as plan_build. */
hawser_status calculator_pulled(const Setup *setup, Calculator *c, hawser_error *err);
/* Checks whether a brake where the pull begins prevents this run-away. */
int away_is_braked(Away away);
/* Writes the reason for compression in this direction as text. */
void away_say(const Calculator *c, int way, int size, char *text);
/* Smallest friction factor of the script, for any target; at most 1. */
double friction_least_told(const Setup *setup);
/* Sets the plan's definition with that smallest friction. The caller frees the stretches, also after an error. Errors:
 * MEMORY. */
hawser_status calculator_loosen(const Setup *setup, const Calculator *c, PlanDef *out, PullStretch **own,
                                hawser_error *err);
/* Finds the brake that prevents compression. If the script lowers friction, the winch force is that with full friction.
 * Errors: as plan_brake. */
hawser_status calculator_brake(const Setup *setup, const Calculator *c, int way, Brake *out, hawser_error *err);
/* Fills brake, trip and best of a solved calculator; it is the last step of calculator_build. Errors: as pull_solve,
 * MEMORY. */
hawser_status calculator_follow(const Setup *setup, Calculator *c, hawser_error *err);

/* A changed pull of the same case. */
typedef struct Variation {
    int way;              /* the only direction that is computed */
    double friction;      /* factor on all friction */
    double radius;        /* factor on the radius of ... */
    int bend;             /* ... this piece, or of every bend: -1 */
    const double *radii;  /* [pieces] factors that replace it, one for all parts of a bend; NULL */
    double beyond;        /* m, extension of the pull beyond the route's end; below 0: it ends before */
    int n_steps;          /* number of additional ... */
    const PullStep *step; /* ... machines and pits [n_steps] */
    double enough;        /* N: a larger tension is an error, which saves time; 0: no bound */
} Variation;

/* Solves a variation: plan, limits and `pulled` of its direction. `base` must stay. Errors as calculator_build; the
 * result must be freed likewise. */
hawser_status calculator_vary(const Setup *setup, const Calculator *base, const Variation *by, Calculator *out,
                              hawser_error *err);
/* A tension, N, that breaks a limit for certain: searches need no values beyond it. It is known where the cable's
 * tension is judged both moving and from rest. skip[HAWSER_LIMITS_MAX]: limits that do not count; NULL: none. 0: none
 * is known. */
double calculator_enough(const Setup *setup, const Calculator *c, int way, const int *skip);
/* The limit that is broken most, or that is nearest to it; NULL if none is judged. */
const hawser_limit *calculator_worst(const Calculator *c, int way);
/* Checks whether all limits of a direction that can be judged hold and the cable is in tension everywhere. */
int calculator_holds(const Calculator *c, int way);

#endif
