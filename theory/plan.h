/* The pulling calculator: one route, one or several cables, both pulling directions, at speed and at a restart; with
 * machines on the way, pits in which the pull begins anew, a push where it begins, and friction that changes with the
 * length pulled. Builds on pulling.h, closed_form.h and duct.h; docs/model.md, "The planner's calculation". */
#ifndef HAWSER_THEORY_PLAN_H
#define HAWSER_THEORY_PLAN_H

#include "theory/plan_def.h"

enum { PLAN_REASON_MAX = 200 };

/* One piece of the route, pulled one way. */
typedef struct PlanPiece {
    double t_in, t_out;           /* N, where the pull enters and leaves; a push exactly at an end counts to the
                                   * piece that the pull enters there */
    double max_tension;           /* N */
    double sidewall;              /* N/m, the worst loaded cable's T/R; 0 on straights */
    double turn;                  /* m, length of the bend that it is, or is a part of; straights: INFINITY */
    double roller_load;           /* N, largest force per length on one support times the spacing, no more than (T18);
                                   * of all parts of a bend the largest. That of what carries, and of what stands aside
                                   * (0: the same supports do both): */
    double carried, guided;       /* N */
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
    double restart_sidewall, restart_sidewall_at; /* N/m, m; from rest */
    int restart_sidewall_piece;
    PlanPiece *piece; /* [n], by the route's order */
} PlanWay;

typedef struct Plan {
    int n; /* pieces */
    PlanWay way[PLAN_WAYS];
    int better; /* the way that needs the smaller force */
} Plan;

/* Errors: INPUT as pull_solve gives them, pushes that are no numbers or off the route; MEMORY. Nothing is left
 * allocated then. The plan borrows nothing. */
hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err);
void plan_clear(Plan *plan);

#endif
