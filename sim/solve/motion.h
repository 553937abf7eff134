/* The equations of motion as the integrator sees them: a state vector, its rates, and the Newton matrix of the rates.
 * The integrator knows nothing else of the scene, so that the same chain can be moved in several ways:
 * sim/solve/scales.h is the chain in three dimensions, sim/solve/planar.h the one in a plane. */
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
    /* ydot from (t, y). 0: done; > 0: not finite, a smaller step may do. */
    int (*rates)(Motion *m, double t, const double *y, double *ydot);
    /* Takes (t, y) with its rates as the point at which Newton's matrix is taken. */
    void (*linearise)(Motion *m, double t, const double *y, const double *ydot);
    /* Forms 1 - gamma J at that point, in whatever reduced shape it is solved; gamma in s. */
    void (*form)(Motion *m, double gamma);
    /* Factors it; b becomes the solution of (1 - gamma J) x = b. Both return as linsolver_factor and linsolver_solve.
     */
    int (*factor)(Motion *m);
    int (*solve)(Motion *m, double *b);
    /* weight = 1 / absolute tolerance of every entry. */
    void (*weights)(const Motion *m, double *weight);
    /* The norm of x weighted by w, which are those weights, in which errors are judged (N11): one number a component
     * of the chain, of which the first segment's are read. */
    double (*norm)(const Motion *m, const double *x, const double *w);
    /* Largest speed of a point of the chain, m/s: stride_speed. */
    double (*speed)(const Motion *m, const double *y);
    /* Correction of y to what its constraints ask for (unit quaternions) and projection of its error (NULL: none).
     * NULL where y has no such constraint. */
    void (*project)(const Motion *m, const double *y, double *correction, double *error);
    /* A step to (t, y) was accepted: what is renewed between steps (contact candidates). Errors: MEMORY. */
    hawser_status (*accept)(Motion *m, double t, const double *y, hawser_error *err);
    /* The same for a state that no evaluation has been near: renews in any case. Errors: MEMORY. */
    hawser_status (*renew)(Motion *m, double t, const double *y, hawser_error *err);
    /* The segment whose weighted error is largest, and where it is, m. */
    int (*worst)(const Motion *m, const double *error, const double *weight);
    Vec3 (*place)(const Motion *m, const double *y, int segment);
    /* Whose such a segment is, where several chains are counted through: its scene; *segment becomes its number there.
     */
    const Scene *(*whose)(const Motion *m, int *segment);
    /* Puts what a sample of (t, y) reads into the workspace: kinematics, tensions (law[0]), the winch's pull, forces on
     * the rollers and, where asked for, those of all contacts on the chain. Returns how many contacts carry force. */
    int (*look)(Motion *m, double t, const double *y, int on_chain);
    /* Puts tensions (law[0]) and forces on the rollers of the last evaluation of the rates into the workspace: those of
     * an iterate close to the last step's end, for next to nothing. */
    void (*glance)(Motion *m);
    /* The winch's pull at (t, y), N: winch_pull_at. */
    double (*winch_pull)(Motion *m, double t, const double *y);
    /* What works on the motion at (t, y), a state whose rates were evaluated last or close by (sim/dynamics.h). */
    void (*work)(Motion *m, double t, const double *y, BalanceRates *out);
    /* What the step that ends in y took out of the motion (BA11), and what moves there. rates: those of y, times
     * 1 / scale. past [motion_past(m)]: of the step before; this one's afterwards. */
    MethodLoss (*method_loss)(const Motion *m, const double *y, const double *rates, double scale, double *past);
    /* What is stored at (t, y), whose rates were the last evaluated. */
    void (*stock)(Motion *m, double t, const double *y, BalanceStock *out);
    /* Moves y to equilibrium under the loads of t; see relax_to_equilibrium. */
    hawser_status (*relax)(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err);
    /* y from the state in space (core/state.h), and back. */
    void (*pack)(Motion *m, const double *full, double *y);
    void (*unpack)(const Motion *m, const double *y, double *full);
    /* What is being solved with, and how it went. */
    void (*lin_stats)(const Motion *m, LinStats *stats);
    /* What is kept between steps beside y and the workspace: Newton's matrix, above all. */
    void (*checkpoint)(Checkpoint *c, Motion *m);
} MotionOps;

struct Motion {
    const MotionOps *ops;
    const Scene *scene; /* borrowed */
    int size;           /* of y */
    Team *team;         /* borrowed; NULL: one thread */
    int pitch;          /* y begins with arrays of so many entries, one a segment; 0: with nothing so simple */
    int rough;          /* the next factors may be rounded: see linsolver_rough */
};

/* MotionOps.factor for Newton's iteration, which looks at the residual that its corrections leave: factors may be
 * rounded (L21), but for the fresh matrix that it asks for where corrections fall too slowly. */
static inline int matrix_factor(Motion *m, int rough)
{
    m->rough = rough;
    const int status = m->ops->factor(m);
    m->rough = 0;
    return status;
}

/* MotionOps.whose of a motion that is one chain's. */
static inline const Scene *motion_whose(const Motion *m, int *segment)
{
    (void)segment;
    return m->scene;
}

/* Room for what method_loss keeps: no more than two numbers for each of y, lanes filled up. */
static inline int motion_past(const Motion *m) { return 2 * m->size + BODY_PAST * LANES; }

/* What integrating it took so far. */
typedef struct IntegratorStats {
    long steps, rhs_evals, newton_iters, jac_evals, lin_setups, error_fails, newton_fails;
    long strides;                               /* steps that (N14) has cut */
    double rhs, jacobian, factor, solve, total; /* s */
    double last_step;                           /* s */
} IntegratorStats;

/* A change of the state vector between two steps: entries come and go, and the motion that remains goes on smoothly. */
typedef struct Reshape {
    int size;  /* of the new state */
    double *y; /* [size] the new state, borrowed from now on in place of the old one */
    /* Writes a vector of the new size from one of the old: the state itself, or one that is linear in changes of it (a
     * derivative, a difference). */
    void (*map)(const void *user, int is_state, const double *from, double *to);
    const void *user;
    int forget; /* the history is of no use: start the method anew */
} Reshape;

#endif
