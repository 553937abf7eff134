/* Input of the pulling calculator: a route, stretches of weight and friction, allowances, machines on the way, pits
 * where the pull begins anew. docs/theory.md, "The planner's calculation". */
#ifndef HAWSER_THEORY_PLAN_H
#define HAWSER_THEORY_PLAN_H

#include "def/duct.h"
#include "def/output_def.h"
#include "theory/pulling.h"

enum { PLAN_FORWARD, PLAN_BACKWARD, PLAN_WAYS };

/* Definition of a pull. Plain data; the paper's allowances are 15 m of cable on the reel and 5 m for the rope. */
typedef struct PlanDef {
    const Route *route;
    PullLaw law;
    int n_stretches; /* >= 1: weight of all cables together (N/m) and friction, without a duct's correction */
    const PullStretch *stretch;
    double reel_length;      /* m of cable whose weight is the reel's back tension (eq. 3: 15) */
    double rope_length;      /* m of cable whose weight is the allowance for the rope (eq. 9: 5) */
    double back_tension;     /* N, added to the reel's, e.g. a brake */
    double back_fall;        /* N, by which that is less at times; used to check for slack and run-away */
    double behind;           /* m of cable behind the route's start, on its line, as the pull forward begins, */
    double behind_least;     /* m, the part left when the head is at the end */
    int behind_slides;       /* it lies on the route's first stretch; 0: on a track without friction */
    double lightest;         /* N/m, of the lightest piece of a cable whose stretches have the heaviest; 0: all alike */
    int slack;               /* use the smallest values of all these */
    double feed;             /* N, push where the pull begins */
    double rope_force;       /* N, added to the rope's allowance: a drag */
    double drawn[PLAN_WAYS]; /* N, in each direction: of the cables behind, if a rope is pulled (SC15) */
    double rope_weight;      /* N/m, of the rope ahead of the cable */
    double beyond;           /* m: extension of the pull beyond the route's end; below 0: it ends before */
    double roller_spacing;   /* m; 0: no roller loads are computed */
    const double *spacing;   /* [pieces] m, replaces it; NULL: roller_spacing everywhere */
    const double *guides;    /* [pieces] m, of the guide rollers; INFINITY: one guide for the whole bend; NULL: as
                              * the others */
    int n_pushes;
    const PullStep *push;      /* conveyors and the like; force > 0: along the pull; < 0: brake */
    const PullStep *push_back; /* the same for the backward pull, in the same order; NULL: as push */
    const PushLaw *pushes; /* pushes as functions of the arriving tension, which replace the forces; NULL: constant */
    int n_steps;
    const PullStep *step; /* machines (STEP_TAKE) and pits (STEP_ANEW), the same in both directions */
    int n_wear;           /* by rising `from`; 0: constant friction */
    const PlanWear *wear;
    WearKind wear_by;
    double enough;       /* N: a larger cable tension ends the pull with an error, as in PullDef; 0: none */
    int skip[PLAN_WAYS]; /* this direction is not computed */
} PlanDef;

/* One pull of a plan: the cable up to a place on the route and the rope ahead of it, in one direction, moving or from
 * rest. docs/theory.md, "The planner's calculation", (PN1)-(PN5). */

/* Start and end of the pull, m along the route. */
double plan_first(const PlanDef *def, int way);
double plan_last(const PlanDef *def, int way);
/* Winch force beside cable and rope on the route (T25), N. */
double plan_allowance(const PlanDef *def, int way);
/* A part of the route with its own pull: from the start or a pit to the next pit or the end. */
typedef struct PlanSection {
    double from, to; /* m along the route, in the pull's order */
    double start;    /* N, the tension at `from` */
    int begins;      /* index of the pit at its start; -1: the pull's start */
    int ends;        /* likewise at its end; -1: the pull's end */
} PlanSection;

/* Number of sections: one more than pits between start and end. */
int plan_sections(const PlanDef *def, int way);
/* The i-th section in the pull's order. */
PlanSection plan_section(const PlanDef *def, int way, int i);
/* The section with the head at `head`, m along the route: at a pit the one that ends there. */
PlanSection plan_section_at(const PlanDef *def, int way, double head);
/* The same definition with the least back tension (for slack and run-away), and whether that is less. */
PlanDef plan_slack(const PlanDef *def);
int plan_slackens(const PlanDef *def);
/* Input of plan_pull. */
typedef struct PlanPullDef {
    int way, restart;
    double head;      /* m along the route: cable up to there, rope from there to the end of the section */
    int whole;        /* the whole route with all sections, the cable's head at its end; `head` is ignored */
    int forces_only;  /* as in PullDef */
    const Pull *like; /* likewise */
} PlanPullDef;

/* Solves the pull. Errors: as pull_solve. */
hawser_status plan_pull(const PlanDef *def, const PlanPullDef *what, Pull *out, hawser_error *err);
/* Winch force for every place of the cable's head: rope ahead, cable behind, bends passed one by one.
 * docs/theory.md, "The planner's calculation", (PN5)-(PN7). */

/* The pull with the head at one place. */
typedef struct HeadForce {
    double head;    /* m along the route */
    double tension; /* N, of the cable there, moving */
    double force;   /* N, of the winch at the section's end, the rope's allowance included */
    double restart; /* N, the same from rest */
} HeadForce;

typedef struct HeadSeries {
    int n;
    HeadForce
        *row; /* [n] in the pull's order: corners of route and equipment, and evenly between them; NULL if n is 0 */
    HeadForce peak;         /* the largest force in motion over all places of the head, also between rows */
    HeadForce restart_peak; /* likewise from rest */
} HeadSeries;

/* Computes one place. Errors: as pull_solve. */
hawser_status plan_head(const PlanDef *def, int way, double head, HeadForce *out, hawser_error *err);
/* Computes all places, between corners no farther apart than `apart` m (INFINITY: corners only); above a thousand
 * corners only some have a row. The result must be freed with plan_heads_free. Errors: as pull_solve, MEMORY; nothing
 * is left allocated then. */
hawser_status plan_heads(const PlanDef *def, int way, double apart, HeadSeries *out, hawser_error *err);
/* Finds the peaks alone, without rows, in time linear in the number of corners (unless friction depends on the length
 * that has passed a place). like[2]: pulls of the whole route, moving and from rest, whose identical spans are reused;
 * NULL: none. The result must be freed likewise. */
hawser_status plan_peaks(const PlanDef *def, int way, const Pull *const like[2], HeadSeries *out, hawser_error *err);
void plan_heads_free(HeadSeries *s);
/* Largest tension of the rope at each place, over all places of the head behind it (PN6a). */
typedef struct RopeSeries {
    int way, restart; /* the direction, and whether from rest */
    int n;
    double *s;       /* [n] m along the route, in the pull's order */
    double *tension; /* [n] N */
} RopeSeries;

/* Computes the series. from: m along the route, where the head begins; `apart` as in plan_heads; friction that depends
 * on the length that has passed a place is that of the section's end. plan_rope_free frees the result. Errors: as
 * pull_solve, MEMORY; nothing is left allocated then. */
hawser_status plan_rope(const PlanDef *def, int way, int restart, double from, double apart, RopeSeries *out,
                        hawser_error *err);
void plan_rope_free(RopeSeries *rope);
/* The same with the head at `head`: writes tension [n] at the places from there to `until` or the section's end, all m
 * along the route, and leaves the others unchanged. */
void plan_rope_ahead(const PlanDef *def, const RopeSeries *rope, double head, double until, double *tension);
/* Tension along the route: of the cable with its pull, or of the rope ahead of it. */
typedef struct Drawn {
    const Pull *pull;
    const RopeSeries *rope; /* NULL: the cable */
} Drawn;

/* Tension at s (m along the route), N; 0 for rope behind the head's first place. */
double drawn_at(const Drawn *drawn, double s);
/* Finds the largest pull of the rope ahead at the cable's head by its own weight, N, which relieves the winch (LI11a),
 * over all places of the head; 0: none. Errors: as pull_solve, MEMORY. */
hawser_status plan_relief(const PlanDef *def, int way, double *relief, hawser_error *err);
/* The smallest brake at the pull's start that prevents compression, and the pull with it (PN8). */
typedef struct Brake {
    double brake;       /* N, additional; 0: none is needed */
    double where;       /* m along the route: place of the largest compression without it */
    int piece;          /* of the route, there */
    double force;       /* N, of the winch with the brake and the head at the end */
    double peak;        /* N, the largest over all places of the head if the brake acts from the start */
    double max_tension; /* N, of the cable with the brake */
} Brake;

/* Finds the brake. Errors: as pull_solve, MEMORY. */
hawser_status plan_brake(const PlanDef *def, int way, Brake *out, hawser_error *err);
/* The pulling calculator: one route, one or several cables, both directions, moving and from rest; with machines on the
 * way, pits where the pull begins anew, a push at the start, and friction that changes with the length pulled. Builds
 * on pulling.h, closed_form.h and duct.h; docs/theory.md, "The planner's calculation". */

enum { PLAN_REASON_MAX = 200 };

/* One piece of the route, pulled in one direction. */
typedef struct PlanPiece {
    double t_in, t_out;           /* N, at the entry and exit of the pull; a push exactly at an end belongs to the
                                   * piece that the pull enters there */
    double max_tension;           /* N */
    double sidewall;              /* N/m, the worst loaded cable's T/R; 0 on straights */
    double turn;                  /* m, length of the bend that the piece is or belongs to; straights: INFINITY */
    double roller_load;           /* N, largest force per length on one support times the spacing, at most (T18); in a
                                   * bend the largest of all parts. Separately for carriers and guides (0: the same
                                   * supports do both): */
    double carried, guided;       /* N */
    double closed;                /* N, t_out by the closed form; NAN if it is refused */
    char reason[PLAN_REASON_MAX]; /* why it is refused, else empty */
} PlanPiece;

typedef struct PlanWay {
    Pull pull;            /* moving: tensions and sidewall pressures of the worst loaded cable, and where */
    double start;         /* N, reel and brake less the push (T24) */
    double rope;          /* N, the rope's allowance (T25) */
    double force;         /* N: tension at the end plus rope, of the last section */
    Pull rest;            /* the same from rest */
    double restart_force; /* N: `force` from rest */
    PlanPiece *piece;     /* [n], by the route's order */
} PlanWay;

typedef struct Plan {
    int n; /* pieces */
    PlanWay way[PLAN_WAYS];
    int better; /* the direction with the smaller force */
} Plan;

/* Solves both directions. The plan borrows nothing. Errors: INPUT as pull_solve, pushes that are not finite or off the
 * route; MEMORY. Nothing is left allocated then. */
hawser_status plan_build(const PlanDef *def, Plan *out, hawser_error *err);
void plan_clear(Plan *plan);
/* Sensitivity of a pull to small changes of uncertain values: the whole route full of cable, moving, exactly by the
 * variational equation, forward and adjoint. docs/theory.md, "Changes of a pull". */

/* --------------------------------------------------------------------------------------------------------- a span */

/* Derivatives of the sum of support forces (N/m) by the tension (1/m) and by the weight (1); where the sum is zero, in
 * the direction in which it grows. (SN2), (SN3). */
typedef struct SpanSlopes {
    double by_tension, by_weight;
} SpanSlopes;

SpanSlopes span_slopes(const SpanLaw *p, double s, double tension);
/* Derivatives of the tension at a span's end (SN4): by the tension at its start (1), the friction coefficient (N), the
 * weight (m). */
typedef struct SpanGain {
    double tension, friction, weight;
} SpanGain;

/* Integrates from s0, with that tension, to s1, as span_integrate; local errors below 1e-11. */
SpanGain span_gain(const SpanLaw *p, double s0, double tension, double s1);
/* --------------------------------------------------------------------------------------------------------- a pull */

/* Causes of change. Friction and weight change by the same amount for all stretches of cable; then follow the friction
 * of each stretch and each push, in the PlanDef's order. */
typedef enum ChangeOf { CHANGE_START, CHANGE_FRICTION, CHANGE_WEIGHT, CHANGE_OTHERS } ChangeOf;

/* Derivatives of one pull by n causes: N/N, N, N/(N/m) = m, then N and N/N. */
typedef struct PlanChange {
    int n;
    const Pull *pull;       /* borrowed, solved */
    double *start, *inside; /* [spans * n] derivative of the tension where each span begins; of the span's mu (N per
                             * unit of the cause) ... */
    double *weight;         /* [n] ... and of the cable's weight */
    double *reach;          /* [spans] of the winch's force by the tension where each span begins: the adjoint (SN8) */
    double *force;          /* [n] of the winch's force */
    int one_sided; /* at some place a machine takes exactly what arrives, or nothing arrives: its effect differs for
                      less */
} PlanChange;

/* Computes the derivatives of plan->way[way], which was built from def. plan_change_free must follow in any case.
 * Errors: MEMORY. */
hawser_status plan_change(const PlanDef *def, const Plan *plan, int way, PlanChange *out, hawser_error *err);
void plan_change_free(PlanChange *c);
/* Derivatives at s (m along the route; before a step there): tension[n] of the tension by each cause; support[n] of the
 * force per length on the carriers, N/m each; *reach: increase of the winch force per newton added there. */
void plan_change_at(const PlanChange *c, double s, double *tension, double *support, double *reach);

#endif
