/* What SUNDIALS works with, made here: vectors, whose operations that a run spends its time in are the project's
 * kernels and whose norm is their owner's, and the shell of a linear solver. */
#ifndef HAWSER_SIM_SOLVE_INTEGRATOR_H
#define HAWSER_SIM_SOLVE_INTEGRATOR_H

#include <sundials/sundials_context.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nvector.h>

#include "sim/solve/contact_newton.h"
#include "sim/solve/motion.h"
#include "sim/solve/vector_queue.h"

/* The norm of x weighted by w, for the owner of the vector. */
typedef double (*VectorNorm)(const void *owner, const double *x, const double *w);

/* All vectors that live and were cloned, directly or not, from one: they can change their length together, and what is
 * to be done with them waits in one queue. */
typedef struct VectorFamily {
    int n, room;
    N_Vector *member; /* [n] */
    int n_spare;
    N_Vector *spare; /* [n_spare] of the members: made before somebody asks for them, see vector_family_stock */
    VectorQueue queue;
} VectorFamily;

/* A vector around data [length], borrowed as are the owner and the family (NULL: none); its clones have data of their
 * own, the same norm and the same family. NULL if there is no memory. N_VDestroy frees it. Numbers of a vector with a
 * family are read and written through N_VGetArrayPointer, which does what waits, or after vector_family_settle. */
N_Vector vector_wrap(int length, double *data, VectorNorm norm, const void *owner, VectorFamily *family,
                     SUNContext context);
/* A clone, as N_VClone makes them, or NULL if there is no memory: N_VClone of SUNDIALS 6 writes into the clone without
 * looking whether there is one. */
N_Vector vector_clone(N_Vector like);
/* Makes n clones of `like`, which has a family, for those who clone with N_VClone: as long as there are any, it gets
 * one of them and cannot fail. Returns 0 if there is no memory. vector_family_unstock destroys those that are left and
 * returns how many these were. */
int vector_family_stock(N_Vector like, int n);
int vector_family_unstock(VectorFamily *family);
/* Moves b's numbers to x, a clone of the same vector: x has them, and what b holds is not to be read before it is
 * written. Nothing is copied unless one of them wraps borrowed data. */
void vector_take(N_Vector x, N_Vector b);
/* Does what waits to be done with the family's vectors. */
void vector_family_settle(VectorFamily *family);
/* After the family's vectors are destroyed, and those in stock too. */
void vector_family_clear(VectorFamily *family);
/* Writes a vector's entries of the new length from those of the old one. */
typedef void (*VectorMap)(const void *user, N_Vector which, const double *from, double *to);

/* Gives every vector of the family the length `length`, through the map. The one that wraps borrowed data gets `data`
 * [length], already filled. Returns 0 if there is no memory; then the vectors can only be destroyed. */
int vector_family_resize(VectorFamily *family, int length, double *data, VectorMap map, const void *user);
/* A matrix and a direct linear solver around it. The matrix is empty, since the owner forms and keeps it; SUNDIALS only
 * says when to factor and when to solve. */
typedef struct CustomLinear {
    SUNMatrix matrix;
    SUNLinearSolver solver;
} CustomLinear;

/* setup factors, solve solves, as SUNLinearSolver_Ops have them; solver->content is `owner`. 0: no memory;
 * custom_linear_free may follow either way. */
int custom_linear_new(CustomLinear *linear, void *owner, int (*setup)(SUNLinearSolver, SUNMatrix),
                      int (*solve)(SUNLinearSolver, SUNMatrix, N_Vector, N_Vector, sunrealtype), SUNContext context);
/* How SUNDIALS is told what linsolver_factor and linsolver_solve return: it takes numbers that it does not know for a
 * success. *lack: there was no memory. */
static inline int custom_linear_told(int status, int *lack)
{
    *lack = status < 0;
    return status == 0 ? SUN_SUCCESS : status < 0 ? SUN_ERR_MEM_FAIL : SUNLS_PACKAGE_FAIL_REC;
}

void custom_linear_free(CustomLinear *linear);
/* The equations of motion in time: by CVODE (BDF), or by one-step methods (sim/solve/esdirk.h). This, with
 * sim/solve/integrator.h, contact_newton.h and failure.h, is all that knows SUNDIALS. docs/model.md, "Integration" and
 * "One-step integration". */

typedef struct Integrator Integrator;

/* Starts at (t, y). The motion and y [motion->size] are borrowed; y always holds the latest state. Errors: MEMORY, RUN
 * (a SUNDIALS that integrator_reshape could not live with). */
hawser_status integrator_new(Motion *motion, double t, double *y, Integrator **out, hawser_error *err);
Integrator *integrator_free(Integrator *in);
/* Takes one step, but not beyond `stop` (s). On failure y and *t hold the last good step and err says when, where
 * and what to try (HAWSER_ERR_RUN). */
hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err);
/* No step is longer than that from now on, s; 0: than the case lets it be. */
void integrator_bound(Integrator *in, double longest);
/* Goes on from the same time with the motion's new size: the history of the method is mapped like the state (RL17), so
 * that order and step stay, and Newton's matrix is made anew at once. Public calls of SUNDIALS suffice: all vectors
 * that CVODE works with are clones of ours, which change their length where they stand, and CVodeGetNonlinearSystemData
 * tells which of them is the history's state. Motion->size is the new one already. Errors: MEMORY (the integrator can
 * only be freed then), RUN. */
hawser_status integrator_reshape(Integrator *in, double t, const Reshape *reshape, hawser_error *err);
/* The same time and motion in other equations: starts anew at (t, y) and goes on counting. Errors: as integrator_new;
 * *in is as it was then. */
hawser_status integrator_renew(Integrator **in, Motion *motion, double t, double *y, hawser_error *err);
/* The rates of the state of the last accepted step, [size], as the method has them: times *h, s: the step's length with
 * BDF, 1 with others. They are those of the collocation or of the last stage, which the equations of motion meet to
 * within Newton's tolerance. Valid until the next step. */
const double *integrator_rates(Integrator *in, double *h);
/* Goes on counting where another one has stopped. Nothing has been stepped yet. */
void integrator_go_on(Integrator *in, const IntegratorStats *so_far);
void integrator_stats(const Integrator *in, IntegratorStats *stats);
/* The segment whose weighted local error is largest, of those simulated. Takes memory for a state. */
int integrator_worst(Integrator *in);
/* Gets one ready to be read from a checkpoint: a fresh one is set up by its first step, which is made from t with all
 * rates zero and moves y by rounding alone. Errors: RUN (a SUNDIALS whose state is not known). */
hawser_status integrator_prepare(Integrator *in, double t, hawser_error *err);
/* Whether its state can be saved; *why says why not. */
int integrator_known(const Integrator *in, const char **why);
/* Steps, orders and history; y, the workspace and the motion's own are not its. */
void integrator_checkpoint(Checkpoint *c, Integrator *in);

#endif
