/* The pulling calculator: one route, one or several cables, both pulling directions, at speed and at a restart; with
 * machines on the way, pits in which the pull begins anew, a push where it begins, and friction that changes with the
 * length pulled. Builds on pulling.h, closed_form.h and duct.h; docs/model.md, "The planner's calculation". */
#ifndef HAWSER_THEORY_PLAN_H
#define HAWSER_THEORY_PLAN_H

#include "theory/cables/duct.h"
#include "theory/pulling.h"

enum { PLAN_FORWARD, PLAN_BACKWARD, PLAN_WAYS, PLAN_REASON_MAX = 200 };

/* What makes friction change with the length pulled: the way that a place of the cable has come (its lubricant is used
 * up), or the length of cable that has passed a place of the route (the duct's is). */
typedef enum WearKind { WEAR_CABLE, WEAR_PLACE } WearKind;
typedef struct PlanWear {
    double from;   /* m of that length, from which on ... */
    double factor; /* ... friction is so many times the stretch's */
} PlanWear;

/* What is pulled. Plain data; the paper's allowances are 15 m of cable on the reel and 5 m for the rope. */
typedef struct PlanDef {
    const Route *route;
    PullLaw law;
    int n_stretches; /* >= 1: weight of all cables together (N/m) and friction, without a duct's correction */
    const PullStretch *stretch;
    const DuctDef *duct;   /* NULL: none; else its weight and sidewall factors apply on the whole route */
    double reel_length;    /* m of cable whose weight is the reel's back tension (eq. 3: 15) */
    double rope_length;    /* m of cable whose weight is the allowance for the rope (eq. 9: 5) */
    double back_tension;   /* N, added to the reel's: a brake */
    double feed;           /* N, by which the cable is pushed where the pull begins */
    double rope_force;     /* N, added to the rope's allowance: a drag */
    double rope_weight;    /* N/m, of the rope ahead of the cable */
    double beyond;         /* m: the pull goes so far beyond the route's end; below 0: it stops short of it */
    double roller_spacing; /* m; 0: no roller loads asked for */
    const double *spacing; /* [pieces] m, in its place; NULL: roller_spacing everywhere */
    const double *guides;  /* [pieces] m, of the rollers beside the cable; NULL: as the others */
    int n_pushes;
    const PullStep *push;      /* conveyors and the like, by what they add; force > 0: along the pull; < 0: brake */
    const PullStep *push_back; /* the same when pulled back, by the same order; NULL: as push */
    int n_steps;
    const PullStep *step; /* machines (STEP_TAKE) and pits (STEP_ANEW), the same either way */
    int n_wear;           /* by rising `from`; 0: friction stays */
    const PlanWear *wear;
    WearKind wear_by;
    int skip[PLAN_WAYS]; /* this way is not asked for */
} PlanDef;

/* One piece of the route, pulled one way. */
typedef struct PlanPiece {
    double t_in, t_out;           /* N, where the pull enters and leaves; a push exactly at an end counts to the
                                   * piece that the pull enters there */
    double max_tension;           /* N */
    double sidewall;              /* N/m, the worst loaded cable's T/R; 0 on straights */
    double roller_load;           /* N, largest force per length on one support times the spacing (T18) */
    double closed;                /* N, t_out by the closed form; NAN if it is refused */
    char reason[PLAN_REASON_MAX]; /* why it is refused, else empty */
} PlanPiece;

typedef struct PlanWay {
    Pull pull;                      /* at speed: tensions and sidewall pressures of the worst loaded cable, and where */
    double start;                   /* N, reel and brake less the push (T24) */
    double rope;                    /* N, the rope's allowance (T25) */
    double force;                   /* N: tension at the end plus rope, of the last section */
    double restart_force;           /* N: the same with static friction */
    double restart_max, restart_at; /* N, m; of the cable then */
    int restart_piece;              /* of the route, where that is */
    PlanPiece *piece;               /* [n], by the route's order */
} PlanWay;

typedef struct Plan {
    int n; /* pieces */
    PlanWay way[PLAN_WAYS];
    DuctLoad duct; /* weight and sidewall factor 1 without a duct */
    int better;    /* the way that needs the smaller force */
} Plan;

/* Errors: INPUT as pull_solve and duct_load give them, negative lengths, spacings, pushes
 * that are no numbers or off the route; MEMORY. Nothing is left allocated then. The plan borrows
 * nothing. */
hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err);
void plan_clear(Plan *plan);

#endif
