/* How a run follows small changes of its parameters: the equations of motion linearised along it, with the Newton
 * matrix of each of its steps. docs/model.md, "Changes of a run". */
#ifndef HAWSER_SIM_RUN_TANGENT_H
#define HAWSER_SIM_RUN_TANGENT_H

#include "sim/run/stage.h"

/* Of the run: the winch's pull, the tension at each station, the load of each roller, N; in this order. */
typedef struct TangentFigures {
    int n, stations, rollers; /* n = 1 + stations + rollers */
    double *value, *slope;    /* [n], [parameters * n]: means over the time since `from`, and their derivatives */
    double seconds;           /* of that time so far */
} TangentFigures;

typedef struct Tangent Tangent;

/* The case as it is, and with each of n parameters by half[k] less and more. figures since `from`, s. Errors: INPUT
 * (the scene does what this does not know, and what that is), MEMORY. *out is NULL then. */
hawser_status tangent_new(const SceneDef *base, int n, const SceneDef *less, const SceneDef *more, const double *half,
                          double from, Tangent **out, hawser_error *err);
Tangent *tangent_free(Tangent *g);
/* The run has begun or made a step: it is at (t, y) [motion->size]; y is that of a stage of the base. The first call
 * says where it begins: that state is held whatever the parameters are. Errors: RUN (a matrix that is singular),
 * MEMORY.
 */
hawser_status tangent_step(Tangent *g, double t, const double *y, hawser_error *err);
const TangentFigures *tangent_figures(const Tangent *g);

#endif
