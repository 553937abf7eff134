/* The equations of motion as the integrator sees them: a state vector, its rates, and the Newton matrix of the rates.
 * The integrator uses nothing else of the scene, so that a chain can be moved in several ways: sim/solve/scales.h is
 * the chain in three dimensions, sim/solve/planar.h the one in a plane. */
#ifndef HAWSER_SIM_SOLVE_MOTION_H
#define HAWSER_SIM_SOLVE_MOTION_H

#include "core/body.h"
#include "core/lanes.h"
#include "core/team.h"
#include "core/vec3.h"
#include "sim/room.h"
#include "sim/scene.h"

typedef struct Motion Motion;

/* y, ydot, b, error and weight have `size` entries; t in s. */
typedef struct MotionOps {
    /* Computes ydot from (t, y). 0: done; > 0: not finite, a smaller step may succeed. */
    int (*rates)(Motion *m, double t, const double *y, double *ydot);
    /* Sets (t, y) with its rates as the point of linearisation. */
    void (*linearise)(Motion *m, double t, const double *y, const double *ydot);
    /* Forms 1 - gamma J at that point, in the reduced form in which it is solved; gamma in s. */
    void (*form)(Motion *m, double gamma);
    /* Factors it; b becomes the solution of (1 - gamma J) x = b. Both return as linsolver_factor and
     * linsolver_solve. */
    int (*factor)(Motion *m);
    int (*solve)(Motion *m, double *b);
    /* Writes weight = 1 / absolute tolerance of every entry. */
    void (*weights)(const Motion *m, double *weight);
    /* Norm of x weighted by w, those weights, for judging errors (N11): they are one number per component of the chain;
     * only the first segment's are read. */
    double (*norm)(const Motion *m, const double *x, const double *w);
    /* Largest speed of a point of the chain, m/s: stride_speed. */
    double (*speed)(const Motion *m, const double *y);
    /* Correction of y to satisfy its constraints (unit quaternions) and projection of its error (NULL: none). NULL
     * where y has no constraint. */
    void (*project)(const Motion *m, const double *y, double *correction, double *error);
    /* Called after an accepted step to (t, y): renews the contact candidates where necessary. Errors: MEMORY. */
    hawser_status (*accept)(Motion *m, double t, const double *y, hawser_error *err);
    /* The same for a state far from any evaluation: always renews. Errors: MEMORY. */
    hawser_status (*renew)(Motion *m, double t, const double *y, hawser_error *err);
    /* Segment with the largest weighted error, and its place, m. */
    int (*worst)(const Motion *m, const double *error, const double *weight);
    Vec3 (*place)(const Motion *m, const double *y, int segment);
    /* Scene of such a segment, where segments of several chains are numbered through; *segment becomes its number
     * there. */
    const Scene *(*whose)(const Motion *m, int *segment);
    /* Puts what a sample of (t, y) reads into the workspace: kinematics, tensions (law[0]), the winch's pull, forces on
     * the rollers and, with on_chain, those of all contacts on the chain. Returns the number of contacts that carry
     * force. */
    int (*look)(Motion *m, double t, const double *y, int on_chain);
    /* Puts tensions (law[0]) and forces on the rollers of the last evaluation of the rates into the workspace, at
     * almost no cost: those of an iterate close to the last step's end. */
    void (*glance)(Motion *m);
    /* The winch's pull at (t, y), N: winch_pull_at. */
    double (*winch_pull)(Motion *m, double t, const double *y);
    /* Work on the motion at (t, y), a state at or near the last evaluation of the rates (sim/dynamics.h). */
    void (*work)(Motion *m, double t, const double *y, BalanceRates *out);
    /* Energy that the step that ends in y took out of the motion (BA11), and the kinetic energy. rates: those of y,
     * times 1 / scale. past [motion_past(m)]: of the step before, of this one on return. */
    MethodLoss (*method_loss)(const Motion *m, const double *y, const double *rates, double scale, double *past);
    /* Stored energy and momentum at (t, y), where the rates were evaluated last. */
    void (*stock)(Motion *m, double t, const double *y, BalanceStock *out);
    /* Moves y to equilibrium under the loads of t; see relax_to_equilibrium. */
    hawser_status (*relax)(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err);
    /* Converts the state in space (core/state.h) to y, and back. */
    void (*pack)(Motion *m, const double *full, double *y);
    void (*unpack)(const Motion *m, const double *y, double *full);
    /* Statistics of the linear solver. */
    void (*lin_stats)(const Motion *m, LinStats *stats);
    /* Saves or loads what is kept between steps beside y and the workspace, mainly Newton's matrix. */
    void (*checkpoint)(Checkpoint *c, Motion *m);
} MotionOps;

struct Motion {
    const MotionOps *ops;
    const Scene *scene; /* borrowed */
    int size;           /* of y */
    Team *team;         /* borrowed; NULL: one thread */
    int pitch;          /* y begins with arrays of this many entries, one per segment; 0: it does not */
    int rough;          /* 1: the next factors may be rounded: see linsolver_rough */
};

/* MotionOps.factor for Newton's iteration, which checks the residual that its corrections leave: factors may be rounded
 * (L21), except for the new matrix that it requires where corrections fall too slowly. */
static inline int matrix_factor(Motion *m, int rough)
{
    m->rough = rough;
    const int status = m->ops->factor(m);
    m->rough = 0;
    return status;
}

/* MotionOps.whose of a motion of one chain. */
static inline const Scene *motion_whose(const Motion *m, int *segment)
{
    (void)segment;
    return m->scene;
}

/* Size of method_loss's memory: at most two numbers for each of y, with padded lanes. */
static inline int motion_past(const Motion *m) { return 2 * m->size + BODY_PAST * LANES; }

/* Effort of the integration so far. */
typedef struct IntegratorStats {
    long steps, rhs_evals, newton_iters, jac_evals, lin_setups, error_fails, newton_fails;
    long strides;                               /* steps that (N14) has shortened */
    double rhs, jacobian, factor, solve, total; /* s */
    double last_step;                           /* s */
} IntegratorStats;

/* A change of the state vector between two steps: entries are added or removed, and the remaining motion continues
 * smoothly. */
typedef struct Reshape {
    int size;  /* of the new state */
    double *y; /* [size] the new state, borrowed from now on in place of the old one */
    /* Writes a vector of the new size from one of the old: the state itself, or one that is linear in changes of it (a
     * derivative, a difference). */
    void (*map)(const void *user, int is_state, const double *from, double *to);
    const void *user;
    int forget; /* 1: the history cannot be used: restart the method */
} Reshape;

#endif
