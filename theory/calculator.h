/* The pulling calculator for a scene: the whole route filled with cable and pulled either way, and every place of the
 * cable's head before that. docs/model.md, "The planner's calculation" and "Limits". */
#ifndef HAWSER_THEORY_CALCULATOR_H
#define HAWSER_THEORY_CALCULATOR_H

#include "def/limits.h"
#include "theory/expected.h"
#include "theory/plan.h"

/* How the cables lie in one duct of the scene. */
typedef struct CalculatorDuct {
    const SurfaceDef *surface; /* the scene's */
    DuctLoad load;
} CalculatorDuct;

/* What theory must know of a case for its pull to be the case's: what carries the cable; that nothing of that has more
 * friction than is reckoned with; that no fluid does; what drives it. */
enum { KNOWN_SUPPORT, KNOWN_FRICTION, KNOWN_MEDIUM, KNOWN_DRIVE, CALCULATOR_KNOWN };

/* Which rule of friction holds on a piece of the route: (T6), (LI1), or each on a part. */
typedef enum SupportRule { SUPPORT_RESULTANT, SUPPORT_SEPARATE, SUPPORT_MIXED } SupportRule;

/* A roller that stands beside a bend in which none stands, and bears what that has. */
typedef struct Bearer {
    int piece, roller;
} Bearer;

/* A rated carrier on a straight of which a neighbour stands round a bend, and which turns the cable as well: m along
 * the route; of a cable that is taut from one to the next, newtons downward and aside for each of tension; the metres
 * that weigh on it. */
typedef struct Beside {
    int roller;
    double s, down, aside, gap;
} Beside;

/* Where the cable is pushed most beyond what it may be pushed with (by a machine behind that place, or as is meant);
 * where it nowhere is, where it is pushed most. */
typedef struct Pushed {
    double force, allowed; /* N */
    double at;             /* m along the route */
    int piece;             /* of it */
} Pushed;

/* What makes a cable run away: the case as it is; with the least friction of its script; what pushes gives more than
 * the pull needs, at the winch; it does so by its weight, however little it is pushed; before the back tension is there
 * that comes in late; of a chain that draws others, more than these hold it back by. */
typedef enum Away { AWAY_AS_IT_IS, AWAY_LOOSENED, AWAY_OVERFED, AWAY_BY_ITSELF, AWAY_EARLY, AWAY_FROM_DRAWN } Away;

typedef struct Calculator {
    const Route *route; /* the scene's, or `own` */
    Route own;          /* one with other bends */
    PlanDef def;        /* what was asked; borrows all that follows */
    int cables;
    double mu_least, mu_largest; /* of what lies along the route, without a duct's correction and wear */
    Stretches stretches;         /* of all cables together */
    PullStep *push[PLAN_WAYS];   /* [the setup's pushers] N along the pull */
    PullStep *step;              /* [def.n_steps] machines and pits of the section `theory` */
    double *spacing, *guides;    /* [pieces] m, the largest gap between carriers there, and between guides; 0: none */
    int n_bearers;
    Bearer *bearer; /* [n_bearers] */
    int n_beside;
    Beside *beside;    /* [n_beside] of the case's own radii */
    SupportRule *rule; /* [pieces] */
    int n_ducts;
    CalculatorDuct *duct;  /* [n_ducts] */
    SupportRoller *roller; /* [the map's rollers] those that the rope may run on, on this route */
    Plan plan;
    HeadSeries heads[PLAN_WAYS]; /* the winch's force by the place of the head */
    double beyond[PLAN_WAYS]; /* N, by what the winch pulls more than the cable's front at least, what is drawn apart;
                               * below 0: rope that hangs down ahead takes it off the winch (LI11a) */
    int n_limits;             /* of either way; 0: the case has none */
    hawser_limit limit[PLAN_WAYS][HAWSER_LIMITS_MAX];
    hawser_condition pulled[PLAN_WAYS]; /* whether the cable is in tension everywhere */
    hawser_condition limp[PLAN_WAYS];   /* whether its bending stiffness breaks no limit, and what it takes (T32) */
    Pushed pushed[PLAN_WAYS];           /* where it is not */
    Away away[PLAN_WAYS];               /* and why */
    double early[PLAN_WAYS];            /* s, of AWAY_EARLY: when it is pushed most */
    Brake brake[PLAN_WAYS];             /* against running away; its `brake` is 0 where none is needed */
    TripSetting trip[PLAN_WAYS];
    int best; /* the way that keeps the limits better; without limits the one that needs less force */
    hawser_condition known[CALCULATOR_KNOWN]; /* whether it is calculated with all that the case says */
} Calculator;

/* expected: has the tension of all cables where the pull begins, whichever way. forward_only: what belongs to the other
 * way stays zero, and `best` and `plan.better` say nothing. Errors: INPUT (as plan_build), MEMORY. Give it back with
 * calculator_free, also after an error. The scene must stay. */
hawser_status calculator_build(const Setup *setup, const Expected *expected, int forward_only, Calculator *out,
                               hawser_error *err);
void calculator_free(Calculator *c);
/* A condition of theory, which holds where value <= allowed. */
hawser_condition theory_condition(hawser_condition_kind kind, double value, double allowed);
/* Fills limits and `pulled` of one that is solved. Errors: MEMORY. */
hawser_status calculator_judge(const Setup *setup, Calculator *c, hawser_error *err);
/* Whether a bend presses the cable away from a guide of a row: it bears nothing. */
int guide_stands_outside(const Route *route, const RollerDef *guide);
/* Fills `known` and `limp` of one that is solved: calculator_known.c. Errors: as plan_build. */
hawser_status calculator_know(const Setup *setup, Calculator *c, hawser_error *err);
/* Whether the case gives friction for theory alone at s (m along the route), or along all of it if that is NAN. */
int friction_is_given(const Setup *setup, double s);
/* Whether the cable sags too far where nothing carries it (T29), its tension lifts it off its route, pulled forward
 * (T31), or something holds it to the side where it turns (T30), into a condition that holds: supported.c. Errors: as
 * plan_build. */
hawser_status supported_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err);
/* N, of what more pull the limits that hold allow, and the limit that allows least; NULL: none says anything of it. */
double limits_left(const Calculator *c, int way, const hawser_limit **least);
/* Whether what bending stiffness takes, about (its `value`, N of the winch's force), would break a limit that holds
 * without (T32): stiffened.c. */
hawser_condition stiffened_judge(const Setup *setup, const Calculator *c, int way);
/* Whether the route crosses itself within the cable's length, into a condition that holds: cannot.c. Errors: MEMORY.
 */
hawser_status crossing_judge(const Setup *setup, hawser_condition *out, hawser_error *err);
/* Whether limits hold, pulled forward, while belts that run ahead of the winch come to their force at the start (WI24),
 * into a condition that holds: started.c. Errors: MEMORY. */
hawser_status started_judge(const Setup *setup, const Calculator *c, hawser_condition *out, hawser_error *err);
/* load [n_rollers]: N, what theory has each rated roller bear of this chain with what those bring that it draws, and
 * what all others do (SC18); 0 where it knows of none. */
void calculator_rollers(const Setup *setup, const Calculator *c, int way, double *load);
/* N, of the winch, wherever the head is, at speed or from rest; of a rope with all that it draws, whatever each pulls
 * at most (SC15). */
double calculator_peak(const Setup *setup, const Calculator *c, int way);
/* Fills `pulled`, `pushed`, `away` and `early`. Errors: as plan_build. */
hawser_status calculator_pulled(const Setup *setup, Calculator *c, hawser_error *err);
/* Whether a brake where the pull begins is what is missing. */
int away_is_braked(Away away);
/* Of a way of which it is not: why the cable is pushed, in words. */
void away_say(const Calculator *c, int way, int size, char *text);
/* The least factor that the script gives friction, of anything; at most 1. */
double friction_least_told(const Setup *setup);
/* The calculator's question with that friction; the stretches are malloc'ed, the caller's, also after an error. Errors:
 * MEMORY. */
hawser_status calculator_loosen(const Setup *setup, const Calculator *c, PlanDef *out, PullStretch **own,
                                hawser_error *err);
/* The brake that holds a cable which is pushed; of one that the script lets go, with the winch's force with all of the
 * friction. Errors: as plan_brake. */
hawser_status calculator_brake(const Setup *setup, const Calculator *c, int way, Brake *out, hawser_error *err);
/* Fills brake, trip and best of one that is solved; calculator_build's last step. Errors: as pull_solve, MEMORY. */
hawser_status calculator_follow(const Setup *setup, Calculator *c, hawser_error *err);

/* The same pull with something else about it. */
typedef struct Variation {
    int way;              /* the only one that is asked for */
    double friction;      /* factor on all friction */
    double radius;        /* factor on the radius of ... */
    int bend;             /* ... this piece, or of every bend: -1 */
    const double *radii;  /* [pieces] factors in place of that, one for all parts of a bend; NULL */
    double beyond;        /* m, how far the pull goes beyond the route's end; below 0: stops short of it */
    int n_steps;          /* so many more ... */
    const PullStep *step; /* ... machines and pits [n_steps] */
    double enough;        /* N: no tension beyond it is of interest, it is an error; 0: none */
} Variation;

/* Solved as far as plan, limits and `pulled` of that way go. Errors as calculator_build; give it back likewise. `base`
 * must stay. */
hawser_status calculator_vary(const Setup *setup, const Calculator *base, const Variation *by, Calculator *out,
                              hawser_error *err);
/* The limit that is broken most, or that is nearest to it; NULL if none is judged. */
const hawser_limit *calculator_worst(const Calculator *c, int way);
/* Whether all limits of a way hold that can be judged, and the cable is pulled everywhere. */
int calculator_holds(const Calculator *c, int way);

#endif
