/* Static equilibrium before t = 0 by pseudo-transient continuation. docs/model.md, "Relaxation" (E1)-(E3). */
#ifndef HAWSER_SIM_RELAX_H
#define HAWSER_SIM_RELAX_H

#include "sim/dynamics.h"
#include "sim/newton.h"

/* Moves y [13 n] to where all forces of time t balance, friction off, and leaves it at rest. `out` says how far it got;
 * not reaching equilibrium is not an error. Errors: MEMORY. */
hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err);

#endif
