/* Static equilibrium before t = 0 by pseudo-transient continuation. docs/model.md, "Relaxation" (E1)-(E3). */
#ifndef HAWSER_SIM_SOLVE_RELAX_H
#define HAWSER_SIM_SOLVE_RELAX_H

#include "sim/dynamics.h"
#include "sim/solve/newton.h"

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
/* Largest length among the n vectors of y - from, of which component c begins at c pitch; from NULL: of y. */
double relax_farthest(int n, int pitch, int dims, const double *y, const double *from);
/* What counts as balanced, N: the tolerance times the largest of the segments' weights and the loads of t, but never
 * less than what rounding of coordinates as large as `far` (m) does to the stiffest bushing. */
double relax_tolerance(const Scene *scene, double t, double far);
/* The most that a segment may move and turn by in one iteration, and that its ends may move by its turning (E2). */
typedef struct RelaxStride {
    double move, turn, sweep; /* m, rad, m */
} RelaxStride;

RelaxStride relax_stride(const Scene *scene);
/* `scale`, or less, so that a segment of this half length (m) that would move by `move` (m) and turn by `turn` (rad)
 * does not go too far. */
double relax_shorten(const RelaxStride *most, double scale, double move, double turn, double half);
/* What the relaxation before t = 0 and the load steps of statics share: the residual of a chain in space, and linearly
 * implicit Euler steps toward where it vanishes. */

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
/* The same from the accelerations that are there. */
double space_unbalanced(const Relaxation *r, int *where);
int space_solve(Relaxation *r, double dt);
/* The right-hand side of that: what has rates but is to begin from rest. */
void space_from_rest(Relaxation *r, double dt);
/* What a move of dt times the velocities found is shortened by (E2). */
double space_move_scale(void *self, double dt);
/* Moves the state by dt times the velocities found. */
void space_move(void *self, double dt);
/* New contact candidates where things have moved too far, or always. Errors: MEMORY. */
hawser_status space_refresh(void *self, int always, hawser_error *err);
/* The largest way of a centre from `from` [3 n], or from the origin (NULL), m. */
double space_farthest(const Relaxation *r, const double *from);
/* What all contacts of a scene are presumed to press with while Newton's method looks for an equilibrium, and what they
 * press with in one. docs/model/44-positions.md (PS11)-(PS13). */

/* What pressed in an equilibrium, by the equipment. */
typedef struct Pressed {
    double *face;  /* [2 rollers] N, by roller and face */
    double *patch; /* [patches] N/m, the mean of those points that press */
} Pressed;

/* Of the kinematics and candidates in the workspace; arrays as above. */
void pressed_find(const Scene *scene, Workspace *ws, const Pressed *out);
typedef struct Presumption {
    double *face, *next; /* [2 rollers] N */
    SurfacePresumed surface[PARTS];
} Presumption;

/* Equilibria under loads that change: Newton's method, and the way down from an equilibrium that is not stable.
 * docs/model.md, "Rods" (RD8), (RD20). */

/* What is looked for, and how. */
typedef struct StaticAim {
    double share;       /* the largest unbalanced force as a share of the largest force, though not below rounding */
    double floor;       /* N, what rounding allows: set by the functions below, from where y is at first */
    double dt;          /* s, the step that stands for infinity */
    double radius;      /* m, of inertia on the way down (newton_swell) */
    double turn, shift; /* rad, m: Newton's first step in full, set by relax_static */
} StaticAim;

/* Newton's method alone, for loads that have grown a little since y was an equilibrium (RD8). Adds to out->iterations
 * and sets the rest; y is of no use if it is not reached. Errors: MEMORY. */
hawser_status relax_static(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                           hawser_relaxation *out, hawser_error *err);
/* From anywhere to an equilibrium that is stable, in steps along which the potential falls (RD20): not the nearest
 * equilibrium but the one that lies below. For a matrix that newton_negative can judge. As relax_static. */
hawser_status relax_downhill(const Scene *scene, Workspace *ws, Newton *newton, double t, StaticAim *aim, double *y,
                             hawser_relaxation *out, hawser_error *err);
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
