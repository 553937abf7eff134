/* The pulling calculator: one route, one or several cables, both pulling directions, at speed and at a
 * restart. Builds on pulling.h, closed_form.h and duct.h; docs/model.md, "Pulling theory", (T24)-(T26). */
#ifndef HAWSER_THEORY_PLAN_H
#define HAWSER_THEORY_PLAN_H

#include "theory/duct.h"
#include "theory/pulling.h"

enum { PLAN_FORWARD, PLAN_BACKWARD, PLAN_WAYS, PLAN_REASON_MAX = 200 };

/* What is pulled. Plain data; the paper's allowances are 15 m of cable on the reel and 5 m for the rope. */
typedef struct PlanDef {
    const Route *route;
    int n_stretches; /* >= 1: weight of all cables together (N/m) and friction, without a duct's correction */
    const PullStretch *stretch;
    const DuctDef *duct;   /* NULL: none; else its weight and sidewall factors apply on the whole route */
    double reel_length;    /* m of cable whose weight is the reel's back tension (eq. 3: 15) */
    double rope_length;    /* m of cable whose weight is the allowance for the rope (eq. 9: 5) */
    double back_tension;   /* N, added to the reel's: a brake */
    double rope_force;     /* N, added to the rope's allowance: a drag */
    double roller_spacing; /* m; 0: no roller loads asked for */
    const double *spacing; /* [pieces] m, in its place; NULL: roller_spacing everywhere */
    const double *guides;  /* [pieces] m, of the rollers beside the cable; NULL: as the others */
    int n_pushes;
    const PullStep *push;      /* conveyors and the like; force > 0: along the pull; < 0: brake */
    const PullStep *push_back; /* the same when pulled back, by the same order; NULL: as push */
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
    double start;                   /* N, reel and brake (T24) */
    double rope;                    /* N, the rope's allowance (T25) */
    double force;                   /* N: tension at the end plus rope */
    double restart_force;           /* N: the same with static friction */
    double restart_max, restart_at; /* N, m; of the cable then */
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
