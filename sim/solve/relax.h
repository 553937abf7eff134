/* Static equilibrium before t = 0 by pseudo-transient continuation. docs/theory.md, "Relaxation" (E1)-(E3). */
#ifndef HAWSER_SIM_SOLVE_RELAX_H
#define HAWSER_SIM_SOLVE_RELAX_H

#include "sim/dynamics.h"
#include "sim/solve/newton.h"

/* The continuation itself (E3)-(E5), for any chain with these operations; `self` is passed to them. */
typedef struct RelaxOps {
    /* Largest unbalanced force, N; moments are divided by half a segment's length. *where gets the segment. */
    double (*residual)(void *self, int *where);
    /* One linearly implicit Euler step of dt (s) from rest (E1), after residual; returns as linsolver_solve. */
    int (*implicit_step)(void *self, double dt);
    /* Factor by which a move of dt times the velocities found must be shortened (E2), see relax_shorten. */
    double (*move_scale)(void *self, double dt);
    /* Moves by dt times the velocities found. */
    void (*move)(void *self, double dt);
    /* Renews the contact candidates if necessary, or always. Errors: MEMORY. */
    hawser_status (*refresh)(void *self, int always, hawser_error *err);
    /* Sets the stiffness of the rollers' contacts to `share` of the scene's. */
    void (*soften)(void *self, double share);
} RelaxOps;

/* y [size] is the chain's state; out->tolerance_N is given. Errors: MEMORY; STOPPED if `stop` requests it: y is an
 * intermediate state then. */
hawser_status relax_run(const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self, int size, double *y,
                        hawser_relaxation *out, hawser_error *err);
/* Largest length among the n vectors of y - from; component c begins at c pitch; from NULL: of y. */
double relax_farthest(int n, int pitch, int dims, const double *y, const double *from);
/* Largest residual that counts as balanced, N: the tolerance times the larger of the segments' weights and the loads of
 * t, but not less than the effect of rounding of coordinates as large as `far` (m) on the stiffest bushing. */
double relax_tolerance(const Scene *scene, double t, double far);
/* Largest motion and rotation of a segment in one iteration, and largest motion of its ends by rotation (E2). */
typedef struct RelaxStride {
    double move, turn, sweep; /* m, rad, m */
} RelaxStride;

RelaxStride relax_stride(const Scene *scene);
/* `scale`, or less, so that a segment of this half length (m) that would move by `move` (m) and turn by `turn` (rad)
 * does not go too far. */
double relax_shorten(const RelaxStride *most, double scale, double move, double turn, double half);
/* Shared by the relaxation before t = 0 and the load steps of statics: the residual of a chain in space, and linearly
 * implicit Euler steps toward its zero. */

/* Moves y [13 n] to equilibrium of all forces of time t, friction off, and leaves it at rest. `out` has the result; not
 * reaching equilibrium is not an error. Errors: MEMORY, STOPPED (ws->stop). */
hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err);
/* The same step by step. */
typedef struct Relaxation {
    const Scene *scene;
    Workspace *ws;
    Newton *newton;
    double t;
    double *y;
    double friction; /* scales every friction and drag force: 0 for equilibrium at rest, 1 for steady motion */
    int size;        /* of y */
    double *rate;    /* [size] */
    double *start;   /* [3 n] positions before */
} Relaxation;

/* Sets y to rest and allocates memory; 0 if there is none. space_end may follow either way. */
int space_begin(Relaxation *r);
/* The same from the accelerations already computed. */
double space_unbalanced(const Relaxation *r, int *where);
int space_solve(Relaxation *r, double dt);
/* Sets the right-hand side of the step: parts with rates start from rest. */
void space_from_rest(Relaxation *r, double dt);
/* Factor by which a move of dt times the velocities found is shortened (E2). */
double space_move_scale(void *self, double dt);
/* Moves the state by dt times the velocities found. */
void space_move(void *self, double dt);
/* Finds new contact candidates where something has moved too far, or always. Errors: MEMORY. */
hawser_status space_refresh(void *self, int always, hawser_error *err);
/* Largest distance of a centre from `from` [3 n], or from the origin (NULL), m. */
double space_farthest(const Relaxation *r, const double *from);
/* Presumed forces of all contacts of a scene while Newton's method seeks an equilibrium, and their forces in one.
 * docs/theory/44-positions.md (PS11)-(PS13). */

/* Contact forces in an equilibrium, by equipment. */
typedef struct Pressed {
    double *face;  /* [2 rollers] N, by roller and face */
    double *patch; /* [patches] N/m, mean over the points in contact */
} Pressed;

/* Finds them for the kinematics and candidates in the workspace; arrays as above. */
void pressed_find(const Scene *scene, Workspace *ws, const Pressed *out);
typedef struct Presumption {
    double *face, *next; /* [2 rollers] N */
    SurfacePresumed surface[PARTS];
} Presumption;

/* Equilibria under changing loads: Newton's method, and the descent from an unstable equilibrium. docs/theory.md,
 * "Rods" (RD8), (RD20). */

/* Accuracy and parameters of the search. */
typedef struct StaticAim {
    double share;       /* largest unbalanced force as a share of the largest force, but not below rounding */
    double floor;       /* N, limit by rounding: set by the functions below, from the initial y */
    double dt;          /* s, the step that acts as infinity */
    double radius;      /* m, radius of inertia in the descent (newton_swell) */
    double turn, shift; /* rad, m: Newton's first step in full, set by relax_static */
} StaticAim;

/* Newton's method alone, for loads that have changed a little since y was an equilibrium (RD8). Adds to out->iterations
 * and sets the rest; y is invalid if equilibrium is not reached. Errors: MEMORY. */
hawser_status relax_static(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                           hawser_relaxation *out, hawser_error *err);
/* From any state to a stable equilibrium, in steps along which the potential falls (RD20): not the nearest equilibrium
 * but the one that lies below. For a matrix that newton_negative supports. As relax_static. */
hawser_status relax_downhill(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                             hawser_relaxation *out, hawser_error *err);
/* Steady motion of a chain along itself: the equilibrium of all forces, friction fully developed, inertia left out.
 * docs/theory/44-positions.md (PS1)-(PS9).
 *
 * The line of the chain does not move, and each segment moves to the place of the next one. That defines a field of
 * velocities over the chain's positions and attitudes, and leaves a system of equations in these: forces and moments at
 * the velocities of the field vanish. Newton's matrix is that of the motion in time, with the effect of a segment's
 * rotation on its velocity (steady_follow) and for a step so long that inertia is negligible.
 *
 * The caller lays the chain near its equilibrium and sets its joints' damping to zero: the field strains joints at
 * rates that are those of chords, not of the line (PS3). */

/* Writes into y [13 n], whose positions and attitudes stay, the velocities with which every segment reaches the place
 * of the next one: `speed` (m/s) along its own axis, rotating with the curvature of the chain (PS1), (PS2). */
void steady_field(const Chain *chain, double speed, double *y);
/* Adds to k the change of the forces because a segment that rotates takes its velocity along: D dv/dphi (PS5). y: the
 * state with its field, at which k and d [6x6 blocks, as BlockChain has them] were computed. The change of the field's
 * rotation is neglected: it is no more than the cable's radius over that of the bend, and costs iterations only. */
void steady_follow(const BlockChain *d, const double *y, BlockChain *k);
/* Start: contact forces of a position nearby (NULL: none is known), and whether the continuation starts from soft
 * contacts at once. */
typedef struct SteadyStart {
    const Pressed *last;
    int soft;
} SteadyStart;

/* Moves y to equilibrium of all forces of time t in steady motion at `speed`, and leaves it with those velocities. The
 * chain's damping must be zero (PS3). Newton's method with presumed contacts first (PS11); if that fails, the
 * relaxation's continuation. `out` has the result; not reaching equilibrium is not an error, but y is invalid then.
 * Errors: MEMORY, STOPPED. */
hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed,
                           const SteadyStart *start, double *y, hawser_relaxation *out, hawser_error *err);

#endif
