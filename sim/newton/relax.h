/* Static equilibrium before t = 0 by pseudo-transient continuation. docs/model.md, "Relaxation" (E1)-(E3). */
#ifndef HAWSER_SIM_NEWTON_RELAX_H
#define HAWSER_SIM_NEWTON_RELAX_H

#include "sim/dynamics.h"

/* Whether a stop is wanted now (not while contacts are soft, if it must be firm). Errors: STOPPED. */
hawser_status relax_stopped(const StopCheck *stop, int soft, hawser_error *err);

/* The continuation itself (E3)-(E5), for any chain that can do these things; `self` is handed to them. */
typedef struct RelaxOps {
    /* Largest unbalanced force, N; moments count over half a segment. *where gets the segment. */
    double (*residual)(void *self, int *where);
    /* One linearly implicit Euler step of dt (s) from rest (E1), after residual; returns as linsolver_solve. */
    int (*implicit_step)(void *self, double dt);
    /* What a move of dt times the velocities found must be shortened by (E2), see relax_shorten. */
    double (*move_scale)(void *self, double dt);
    /* Moves by dt times the velocities found. */
    void (*move)(void *self, double dt);
    /* Renews the contact candidates if need be, or always. Errors: MEMORY. */
    hawser_status (*refresh)(void *self, int always, hawser_error *err);
    /* Gives the rollers' contacts `share` of their stiffness. */
    void (*soften)(void *self, double share);
} RelaxOps;

/* y [size] is the chain's state; out->tolerance_N is given. Errors: MEMORY; STOPPED where `stop` asks for it: y is on
 * its way then. */
hawser_status relax_run(const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self, int size, double *y,
                        hawser_relaxation *out, hawser_error *err);
/* The same with so many iterations straight away, at most, before it begins from soft contacts. */
hawser_status relax_run_within(int straight, const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self,
                               int size, double *y, hawser_relaxation *out, hawser_error *err);
/* Largest length among the n vectors of y - from, of which component c begins at c pitch; from NULL: of y. */
double relax_farthest(int n, int pitch, int dims, const double *y, const double *from);
/* What counts as balanced, N: the tolerance times the largest of the segments' weights and the loads of t, but never
 * less than what rounding of coordinates as large as `far` (m) does to the stiffest bushing. */
double relax_tolerance(const Scene *scene, double t, double far);
/* What rounding of coordinates as large as `far` (m), and of rotations, does to the stiffest bushing, N; moments count
 * over half a segment (E6). */
double relax_rounding(const Scene *scene, double far);
/* The most that a segment may move and turn by in one iteration, and that its ends may move by its turning (E2). */
typedef struct RelaxStride {
    double move, turn, sweep; /* m, rad, m */
} RelaxStride;
RelaxStride relax_stride(const Scene *scene);
/* `scale`, or less, so that a segment of this half length (m) that would move by `move` (m) and turn by `turn` (rad)
 * does not go too far. */
double relax_shorten(const RelaxStride *most, double scale, double move, double turn, double half);

#endif
