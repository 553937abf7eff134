/* The unreduced Newton matrix, 13 unknowns a segment, for klu-full: a check of the reduction and the benchmark's other
 * side. Unknowns of a segment in the order position, quaternion, velocity, angular velocity; the velocity rows are
 * multiplied by the mass matrix as in (N5). docs/model.md, "Newton matrix" (N12). */
#ifndef HAWSER_SIM_NEWTON_NEWTON_FULL_H
#define HAWSER_SIM_NEWTON_NEWTON_FULL_H

#include "sim/newton/newton_data.h"

typedef struct NewtonFull NewtonFull;

/* Pattern and solver for the chain of nw. Errors: MEMORY. */
hawser_status newton_full_new(const Newton *nw, const LinOptions *options, NewtonFull **out, hawser_error *err);
NewtonFull *newton_full_free(NewtonFull *f);
/* Fills the values from nw's blocks for nw->gamma. */
void newton_full_form(NewtonFull *f, const Newton *nw);
/* As newton_factor, newton_solve. */
int newton_full_factor(NewtonFull *f);
int newton_full_solve(NewtonFull *f, const Newton *nw, double *b);
const LinSolver *newton_full_solver(const NewtonFull *f);

#endif
