/* What the relaxation before t = 0 and the load steps of statics share: the residual of a chain in space, and linearly
 * implicit Euler steps toward where it vanishes. */
#ifndef HAWSER_SIM_NEWTON_RELAX_SPACE_H
#define HAWSER_SIM_NEWTON_RELAX_SPACE_H

#include "sim/newton/newton.h"
#include "sim/newton/relax.h"

/* Moves y [13 n] to where all forces of time t balance, friction off, and leaves it at rest. `out` says how far it got;
 * not reaching equilibrium is not an error. Errors: MEMORY, STOPPED (ws->stop). */
hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err);

/* The same step by step. */
typedef struct Relaxation {
    const Scene *scene;
    Workspace *ws;
    Newton *newton;
    double t;
    double *y;
    double friction; /* scales every friction and drag force: 0 of a rest, 1 of steady motion */
    int size;        /* of y */
    double *rate;    /* [size] */
    double *start;   /* [3 n] positions before */
} Relaxation;

/* Puts y to rest and takes memory; 0 if there is none. space_end may follow either way. */
int space_begin(Relaxation *r);
void space_end(Relaxation *r);

/* Largest unbalanced force, N; moments count over half a segment. *where gets the segment. Leaves the accelerations in
 * `rate`. self: a Relaxation, here and below, for RelaxOps. */
double space_residual(void *self, int *where);
/* The same from the accelerations that are there. */
double space_unbalanced(const Relaxation *r, int *where);
/* One linearly implicit Euler step of length dt (s) from rest: (M - dt D - dt^2 K) u = dt F (E1), for the accelerations
 * in `rate`, in whose velocity part the velocities u land. Returns the solver's status. */
int space_step(void *self, double dt);
/* Its parts: K and D of y; then, once newton_form has made the matrix for dt, its factors and the velocities. */
void space_blocks(Relaxation *r);
int space_solve(Relaxation *r, double dt);
/* The right-hand side of that: what has rates but is to begin from rest. */
void space_from_rest(Relaxation *r, double dt);
/* What a move of dt times the velocities found is shortened by (E2). */
double space_move_scale(void *self, double dt);
/* Moves the state by dt times the velocities found. */
void space_move(void *self, double dt);
/* New contact candidates where things have moved too far, or always. Errors: MEMORY. */
hawser_status space_refresh(void *self, int always, hawser_error *err);
/* Gives the contacts `share` of their stiffness. */
void space_soften(void *self, double share);
/* The largest way of a centre from `from` [3 n], or from the origin (NULL), m. */
double space_farthest(const Relaxation *r, const double *from);

#endif
