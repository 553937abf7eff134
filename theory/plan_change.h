/* How a pull follows small changes of what is not well known: of the whole route full of cable at speed, exactly, by
 * the variational equation, in both directions of reckoning. docs/model.md, "Changes of a pull". */
#ifndef HAWSER_THEORY_PLAN_CHANGE_H
#define HAWSER_THEORY_PLAN_CHANGE_H

#include "theory/plan.h"

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
