/* What the pulling calculator is asked: a route, stretches of weight and friction, allowances, machines on the way,
 * pits in which the pull begins anew. docs/model.md, "The planner's calculation". */
#ifndef HAWSER_THEORY_PLAN_H
#define HAWSER_THEORY_PLAN_H

#include "def/duct.h"
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

/* One pull of a plan: the cable up to a place on the route and the rope ahead of it, one way, at speed or from rest.
 * docs/model.md, "The planner's calculation", (PN1)-(PN5). */

/* Where the pull begins and ends, m along the route. */
double plan_first(const PlanDef *def, int way);
double plan_last(const PlanDef *def, int way);
/* What every winch pulls beside cable and rope on the route (T25), N. */
double plan_allowance(const PlanDef *def, int way);
/* A part of the route that is pulled on its own: from the start or a pit to the next pit or the end. */
typedef struct PlanSection {
    double from, to; /* m along the route, in the pull's order */
    double start;    /* N, the tension at `from` */
    int begins;      /* the step that it begins at, a pit; -1: where the pull begins */
    int ends;        /* likewise; -1: where it ends */
} PlanSection;

/* How many sections there are: one more than pits between start and end. */
int plan_sections(const PlanDef *def, int way);
/* The i-th of them, in the pull's order. */
PlanSection plan_section(const PlanDef *def, int way, int i);
/* The one in which the head is at `head`, m along the route: at a pit the one that ends there. */
PlanSection plan_section_at(const PlanDef *def, int way, double head);
/* The same when it is held back least (the place at which it slackens or runs away first), and whether that is less. */
PlanDef plan_slack(const PlanDef *def);
int plan_slackens(const PlanDef *def);
/* What plan_pull is asked for. */
typedef struct PlanPullDef {
    int way, restart;
    double head;      /* m along the route: cable up to there, rope from there to the end of the section */
    int whole;        /* the whole route, sections and all, with the cable's head at its end; `head` does not count */
    int forces_only;  /* as a PullDef's */
    const Pull *like; /* likewise */
} PlanPullDef;

/* Solves it. Errors: as pull_solve. */
hawser_status plan_pull(const PlanDef *def, const PlanPullDef *what, Pull *out, hawser_error *err);
/* The winch's force for every place of the cable's head: rope ahead, cable behind, bends passed one after the other.
 * docs/model.md, "The planner's calculation", (PN5)-(PN7). */

/* The pull with the head at one place. */
typedef struct HeadForce {
    double head;    /* m along the route */
    double tension; /* N, of the cable there, at speed */
    double force;   /* N, of the winch at the section's end, the rope's allowance included */
    double restart; /* N, the same from rest */
} HeadForce;

typedef struct HeadSeries {
    int n;
    HeadForce *row; /* [n] in the pull's order: corners of route and equipment, and evenly between; NULL if n is 0 */
    HeadForce peak; /* the largest force at speed, wherever the head is then; between rows too */
    HeadForce restart_peak; /* likewise from rest */
} HeadSeries;

/* One place. Errors: as pull_solve. */
hawser_status plan_head(const PlanDef *def, int way, double head, HeadForce *out, hawser_error *err);
/* All of them; between corners no farther apart than `apart` m (INFINITY: corners only); of more than a thousand
 * corners only some have a row. plan_heads_free gives them back. Errors: as pull_solve, MEMORY; nothing is left
 * allocated then. */
hawser_status plan_heads(const PlanDef *def, int way, double apart, HeadSeries *out, hawser_error *err);
/* The peaks alone, in a time that is linear in the number of corners (but where friction goes by the length that has
 * passed a place): rows are none then. Give it back likewise. */
hawser_status plan_peaks(const PlanDef *def, int way, HeadSeries *out, hawser_error *err);
void plan_heads_free(HeadSeries *s);
/* The most that rope ahead is drawn with at a place, wherever the head is behind it (PN6a). */
typedef struct RopeSeries {
    int way, restart; /* of which pull */
    int n;
    double *s;       /* [n] m along the route, in the pull's order */
    double *tension; /* [n] N */
} RopeSeries;

/* from: m along the route, where the head begins; `apart` as plan_heads'; friction that goes by the length that has
 * passed a place is that of the section's end. Errors: as pull_solve, MEMORY; nothing is left allocated then.
 * plan_rope_free gives it back. */
hawser_status plan_rope(const PlanDef *def, int way, int restart, double from, double apart, RopeSeries *out,
                        hawser_error *err);
void plan_rope_free(RopeSeries *rope);
/* The same with the head at `head` and no farther: writes tension [n] at the places from there to `until`, or to the
 * section's end, all m along the route; the others are left as they are. */
void plan_rope_ahead(const PlanDef *def, const RopeSeries *rope, double head, double until, double *tension);
/* What is drawn over the route: the cable with its pull, or rope ahead of it. */
typedef struct Drawn {
    const Pull *pull;
    const RopeSeries *rope; /* NULL: the cable */
} Drawn;

/* N at s (m along the route); rope that has no tension there, since the head begins behind it: 0. */
double drawn_at(const Drawn *drawn, double s);
/* N, by which the rope ahead pulls at the cable's head by its own weight, so that the winch has less than the head: the
 * most of all places of the head (LI11a). 0: nowhere. Errors: as pull_solve, MEMORY. */
hawser_status plan_relief(const PlanDef *def, int way, double *relief, hawser_error *err);
/* The smallest brake where the pull begins with which the cable is nowhere pushed, and the pull with it (PN8). */
typedef struct Brake {
    double brake;       /* N, on top of what holds back already; 0: none is needed */
    double where;       /* m along the route: there it would be pushed most without */
    int piece;          /* of the route, there */
    double force;       /* N, of the winch with the brake, the head at the end */
    double peak;        /* N, the largest of all places of the head, if the brake is on from the start */
    double max_tension; /* N, of the cable then */
} Brake;

/* Errors: as pull_solve, MEMORY. */
hawser_status plan_brake(const PlanDef *def, int way, Brake *out, hawser_error *err);
/* The pulling calculator: one route, one or several cables, both pulling directions, at speed and at a restart; with
 * machines on the way, pits in which the pull begins anew, a push where it begins, and friction that changes with the
 * length pulled. Builds on pulling.h, closed_form.h and duct.h; docs/model.md, "The planner's calculation". */

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
/* How a pull follows small changes of what is not well known: of the whole route full of cable at speed, exactly, by
 * the variational equation, in both directions of reckoning. docs/model.md, "Changes of a pull". */

/* --------------------------------------------------------------------------------------------------------- a span */

/* How the sum of support forces, N/m, changes with the tension (1/m) and with the weight (1). Where it is zero, toward
 * what makes it grow. (SN2), (SN3). */
typedef struct SpanSlopes {
    double by_tension, by_weight;
} SpanSlopes;

SpanSlopes span_slopes(const SpanLaw *p, double s, double tension);
/* What small changes at a span's start and in it make of the tension at its end (SN4): by the tension at the start (1),
 * by the friction coefficient (N), by the weight (m). */
typedef struct SpanGain {
    double tension, friction, weight;
} SpanGain;

/* From s0, with that tension, to s1, as span_integrate; local errors below 1e-11. */
SpanGain span_gain(const SpanLaw *p, double s0, double tension, double s1);
/* --------------------------------------------------------------------------------------------------------- a pull */

/* What changes. Friction and weight are those of all stretches of cable by the same amount; behind these come the
 * friction of each stretch, then each push, by their order in the PlanDef. */
typedef enum ChangeOf { CHANGE_START, CHANGE_FRICTION, CHANGE_WEIGHT, CHANGE_OTHERS } ChangeOf;

/* Derivatives of one pull by n causes: N/N, N, N/(N/m) = m, then N and N/N. */
typedef struct PlanChange {
    int n;
    const Pull *pull;       /* borrowed, solved */
    double *start, *inside; /* [spans * n] of the tension where each span begins; of the span's mu (N: what a unit of
                             * the cause adds to it) ... */
    double *weight;         /* [n] ... and of the cable's weight */
    double *reach;          /* [spans] of the winch's force by the tension where each span begins: the adjoint (SN8) */
    double *force;          /* [n] of the winch's force */
    int one_sided; /* somewhere a machine takes just what arrives, or nothing does: with less it takes less, or none */
} PlanChange;

/* Of plan->way[way], which was built from def. Errors: MEMORY; plan_change_free follows in any case. */
hawser_status plan_change(const PlanDef *def, const Plan *plan, int way, PlanChange *out, hawser_error *err);
void plan_change_free(PlanChange *c);
/* At s (m along the route; before a step there): of the tension by each cause, tension[n]; of the force per length on
 * what carries the cable, support[n], N/m each; and *reach: what the winch's force grows by a newton more there. */
void plan_change_at(const PlanChange *c, double s, double *tension, double *support, double *reach);

#endif
