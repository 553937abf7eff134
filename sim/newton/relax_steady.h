/* Steady motion of a chain along itself: the equilibrium of all forces, friction fully developed, inertia left out.
 * docs/model/44-positions.md (PS1)-(PS9).
 *
 * The line on which the chain lies stands still, and each segment moves to where the next one is. That is a field of
 * velocities over the chain's positions and attitudes, so that what remains is a system of equations in these: forces
 * and moments at the velocities of the field vanish. Newton's matrix is that of the motion in time, with what turning a
 * segment does to its velocity (steady_follow) and for a step so long that inertia counts for nothing.
 *
 * The caller lays the chain down, near to where it will lie, and sees to it that its joints' damping is zero: the field
 * strains joints at rates that are those of chords, not of the line (PS3). */
#ifndef HAWSER_SIM_NEWTON_RELAX_STEADY_H
#define HAWSER_SIM_NEWTON_RELAX_STEADY_H

#include "sim/newton/newton.h"
#include "sim/newton/presumption.h"

/* Writes into y [13 n], whose positions and attitudes stay, the velocities with which every segment comes to where the
 * next one is: `speed` (m/s) along its own axis, turning as the chain turns there (PS1), (PS2). */
void steady_field(const Chain *chain, double speed, double *y);
/* Adds to k what the forces change by because a segment that turns takes its velocity along: D dv/dphi (PS5). y: the
 * state with its field, at which k and d [6x6 blocks, as BlockChain has them] were taken. What the field's turning
 * changes by is left out: it is no more than the cable's radius over that of the bend, and costs iterations only. */
void steady_follow(const BlockChain *d, const double *y, BlockChain *k);

/* From where: what pressed in a position nearby (NULL: none is known), and whether the continuation begins from soft
 * contacts at once. */
typedef struct SteadyStart {
    const Pressed *last;
    int soft;
} SteadyStart;

/* Moves y to where all forces of time t balance in steady motion at `speed`, and leaves it with those velocities. The
 * chain's damping must be zero (PS3). Newton's method with presumed contacts first (PS11); where that fails, the
 * relaxation's continuation. `out` says how far it got; not reaching equilibrium is no error; then y is of no use.
 * Errors: MEMORY, STOPPED. */
hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed,
                           const SteadyStart *start, double *y, hawser_relaxation *out, hawser_error *err);

#endif
