/* Response of a run to small changes of its parameters: the equations of motion linearised along it, with the Newton
 * matrix of each of its steps. docs/theory.md, "Changes of a run". */
#ifndef HAWSER_SIM_RUN_TANGENT_H
#define HAWSER_SIM_RUN_TANGENT_H

#include "sim/run/stage.h"

/* Figures of the run: the winch's pull, the tension at each station, the load of each roller, N; in this order. */
typedef struct TangentFigures {
    int n, stations, rollers; /* n = 1 + stations + rollers */
    double *value, *slope;    /* [n], [parameters * n]: means over the time since `from`, and their derivatives */
    double seconds;           /* duration so far */
    int *at_station;          /* [stations] segment that passes it */
} TangentFigures;

void tangent_figures_look(const TangentFigures *f, Stage *st, double t, const double *y, double *figure);
/* ----------------------------------------------------------------------------------------------------- along a run */

typedef struct Tangent Tangent;

/* The case itself, and with each of n parameters smaller and larger by half[k]. figures since `from`, s. Errors: INPUT
 * (names what the scene has that this does not cover), MEMORY. *out is NULL then. */
hawser_status tangent_new(const SceneDef *base, int n, const SceneDef *less, const SceneDef *more, const double *half,
                          double from, Tangent **out, hawser_error *err);
Tangent *tangent_free(Tangent *g);
/* Called when the run has begun or made a step: it is at (t, y) [motion->size]; y is that of a stage of the base. The
 * first call gives the initial state, which depends on the parameters too (SN13). Errors: RUN (a singular matrix),
 * MEMORY. */
hawser_status tangent_step(Tangent *g, double t, const double *y, hawser_error *err);
const TangentFigures *tangent_figures(const Tangent *g);
/* dy/dp of parameter k now [motion->size]. */
const double *tangent_slope(const Tangent *g, int k);
/* ------------------------------------------------------------------------------------------------- at one position */

/* Derivatives of a steady position's figures by any number of parameters: one solution with the transposed matrix per
 * figure, none per parameter (SN14)-(SN17). */
typedef struct Position Position;

/* The position y [scene_state_size] (core/state.h) of the base at time t. Errors: INPUT (names what the scene has that
 * this does not cover), RUN (a singular matrix), MEMORY; *out is NULL then. */
hawser_status position_new(const SceneDef *base, double t, const double *y, Position **out, hawser_error *err);
Position *position_free(Position *p);
/* The figures there; slope is NULL. */
const TangentFigures *position_figures(const Position *p);
/* slope [figures] by a parameter that is smaller and larger by `half` in the two cases. Errors: INPUT (it changes the
 * number of segments), RUN, MEMORY. */
hawser_status position_by(Position *p, const SceneDef *less, const SceneDef *more, double half, double *slope,
                          hawser_error *err);

#endif
