/* Steady motion of a chain along itself: the equilibrium of all forces, friction fully developed, inertia left out.
 * docs/model/44-positions.md (PO1)-(PO9). */
#ifndef HAWSER_SIM_NEWTON_RELAX_STEADY_H
#define HAWSER_SIM_NEWTON_RELAX_STEADY_H

#include "sim/newton/newton.h"

/* Writes into y [13 n], whose positions and attitudes stay, the velocities with which every segment comes to where the
 * next one is: `speed` (m/s) along its own axis, turning as the chain turns there (PO1), (PO2). */
void steady_field(const Chain *chain, double speed, double *y);
/* Adds to k what the forces change by because a segment that turns takes its velocity along: D dv/dphi (PO5). */
void steady_follow(const BlockChain *d, const double *y, BlockChain *k);

/* Moves y to where all forces of time t balance in steady motion at `speed`, and leaves it with those velocities. The
 * chain's damping must be zero (PO3). Newton's method first, from a state close to it; where that fails, or if y is
 * `far` from it, the relaxation's continuation. `out` says how far it got; not reaching equilibrium is no error; then y
 * is of no use. Errors: MEMORY, STOPPED. */
hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed, int far,
                           double *y, hawser_relaxation *out, hawser_error *err);

#endif
