/* What the pulling calculator is asked: a route, stretches of weight and friction, allowances, machines on the way,
 * pits in which the pull begins anew. docs/model.md, "The planner's calculation". */
#ifndef HAWSER_THEORY_PLAN_DEF_H
#define HAWSER_THEORY_PLAN_DEF_H

#include "def/cables/duct.h"
#include "def/output_def.h"
#include "theory/pulling.h"

enum { PLAN_FORWARD, PLAN_BACKWARD, PLAN_WAYS };

/* What is pulled. Plain data; the paper's allowances are 15 m of cable on the reel and 5 m for the rope. */
typedef struct PlanDef {
    const Route *route;
    PullLaw law;
    int n_stretches; /* >= 1: weight of all cables together (N/m) and friction, without a duct's correction */
    const PullStretch *stretch;
    double reel_length;      /* m of cable whose weight is the reel's back tension (eq. 3: 15) */
    double rope_length;      /* m of cable whose weight is the allowance for the rope (eq. 9: 5) */
    double back_tension;     /* N, added to the reel's: a brake */
    double back_fall;        /* N, by which that is less at times: what slackens or runs away does so then */
    double behind;           /* m of cable behind the route's start, on its line, as the pull forward begins, */
    double behind_least;     /* m, and what is left of it when the head is at the end */
    int behind_slides;       /* it lies on what the route begins with; 0: on a track without friction */
    double lightest;         /* N/m, of the lightest piece of a cable whose stretches have the heaviest; 0: all alike */
    int slack;               /* what is asked is when all this holds back least */
    double feed;             /* N, by which the cable is pushed where the pull begins */
    double rope_force;       /* N, added to the rope's allowance: a drag */
    double drawn[PLAN_WAYS]; /* N, the same of each way: of the cables behind, if it is a rope that is pulled (SC15) */
    double rope_weight;      /* N/m, of the rope ahead of the cable */
    double beyond;           /* m: the pull goes so far beyond the route's end; below 0: it stops short of it */
    double roller_spacing;   /* m; 0: no roller loads asked for */
    const double *spacing;   /* [pieces] m, in its place; NULL: roller_spacing everywhere */
    const double *guides;    /* [pieces] m, of the rollers beside the cable; INFINITY: one has the whole bend; NULL: as
                              * the others */
    int n_pushes;
    const PullStep *push;      /* conveyors and the like, by what they add; force > 0: along the pull; < 0: brake */
    const PullStep *push_back; /* the same when pulled back, by the same order; NULL: as push */
    const PushLaw *pushes;     /* what push, by the tension that arrives, in place of their forces; NULL: these */
    int n_steps;
    const PullStep *step; /* machines (STEP_TAKE) and pits (STEP_ANEW), the same either way */
    int n_wear;           /* by rising `from`; 0: friction stays */
    const PlanWear *wear;
    WearKind wear_by;
    double enough;       /* N: a cable's tension beyond it ends the pull as an error, as a PullDef's; 0: none */
    int skip[PLAN_WAYS]; /* this way is not asked for */
} PlanDef;

#endif
