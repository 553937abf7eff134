/* The pulling calculator for a scene: the whole route filled with cable and pulled either way. docs/model.md, "The
 * calculator" and "Limits". */
#ifndef HAWSER_SIM_EXPECTED_CALCULATOR_H
#define HAWSER_SIM_EXPECTED_CALCULATOR_H

#include "sim/expected/expected.h"
#include "sim/expected/stretches.h"
#include "theory/limits.h"
#include "theory/plan.h"

/* How the cables lie in one duct of the scene. */
typedef struct CalculatorDuct {
    const SurfaceDef *surface; /* the scene's */
    DuctLoad load;
} CalculatorDuct;

/* Which rule of friction holds on a piece of the route: (T6), (LI1), or each on a part. */
typedef enum SupportRule { SUPPORT_RESULTANT, SUPPORT_SEPARATE, SUPPORT_MIXED } SupportRule;

typedef struct Calculator {
    Plan plan;
    int cables;
    Stretches stretches; /* of all cables together */
    int n_pushers;
    Pusher *pusher;            /* [n_pushers] conveyors and whatever else pushes */
    PullStep *push[PLAN_WAYS]; /* [n_pushers] N along the pull */
    double *spacing, *guides;  /* [pieces] m, the largest gap between carriers there, and between guides; 0: none */
    SupportRule *rule;         /* [pieces] */
    int n_ducts;
    CalculatorDuct *duct; /* [n_ducts] */
    int n_limits;         /* of either way; 0: the case has none */
    hawser_limit limit[PLAN_WAYS][HAWSER_LIMITS_MAX];
    hawser_condition pulled[PLAN_WAYS]; /* whether the cable is in tension everywhere */
    hawser_condition supported;         /* whether anything is known of what carries it */
} Calculator;

/* start_tension: N, of one cable where the pull begins, whichever way. Errors: INPUT (cables that do not fit into a
 * duct, and as plan_build), MEMORY. Give it back with calculator_free, also after an error. The scene must stay. */
hawser_status calculator_build(const Scene *scene, double start_tension, Calculator *out, hawser_error *err);
void calculator_free(Calculator *c);

#endif
