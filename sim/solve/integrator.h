/* Parts made here for SUNDIALS: vectors, whose costly operations are the project's kernels and whose norm is their
 * owner's, and the shell of a linear solver. */
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

/* All vectors that exist and were cloned, directly or not, from one: they can change their length together, and their
 * waiting operations share one queue. */
typedef struct VectorFamily {
    int n, room;
    N_Vector *member; /* [n] */
    int n_spare;
    N_Vector *spare; /* [n_spare] of the members: created in advance, see vector_family_stock */
    VectorQueue queue;
} VectorFamily;

/* Wraps a vector around data [length], borrowed as are the owner and the family (NULL: none); its clones have their own
 * data, the same norm and the same family. NULL if there is no memory. N_VDestroy frees it. The numbers of a vector
 * with a family are read and written through N_VGetArrayPointer, which carries out waiting tasks, or after
 * vector_family_settle. */
N_Vector vector_wrap(int length, double *data, VectorNorm norm, const void *owner, VectorFamily *family,
                     SUNContext context);
/* Clones as N_VClone does, or returns NULL if there is no memory: N_VClone of SUNDIALS 6 writes into the clone without
 * checking that it exists. */
N_Vector vector_clone(N_Vector like);
/* Creates n clones of `like`, which has a family, in advance: as long as there are any, N_VClone returns one of them
 * and cannot fail. Returns 0 if there is no memory. vector_family_unstock destroys the rest and returns their
 * number. */
int vector_family_stock(N_Vector like, int n);
int vector_family_unstock(VectorFamily *family);
/* Moves b's numbers to x, a clone of the same vector; b must not be read before it is written again. Nothing is copied
 * unless one of them wraps borrowed data. */
void vector_take(N_Vector x, N_Vector b);
/* Carries out the waiting tasks of the family's vectors. */
void vector_family_settle(VectorFamily *family);
/* Called after the family's vectors, including those in stock, are destroyed. */
void vector_family_clear(VectorFamily *family);
/* Writes a vector's entries of the new length from those of the old one. */
typedef void (*VectorMap)(const void *user, N_Vector which, const double *from, double *to);

/* Gives every vector of the family the length `length`, through the map. The one that wraps borrowed data gets `data`
 * [length], already filled. Returns 0 if there is no memory; then the vectors can only be destroyed. */
int vector_family_resize(VectorFamily *family, int length, double *data, VectorMap map, const void *user);
/* A matrix and a direct linear solver around it. The matrix is empty, since the owner forms and keeps it; SUNDIALS only
 * determines when to factor and when to solve. */
typedef struct CustomLinear {
    SUNMatrix matrix;
    SUNLinearSolver solver;
} CustomLinear;

/* setup factors, solve solves, as in SUNLinearSolver_Ops; solver->content is `owner`. 0: no memory; custom_linear_free
 * may follow either way. */
int custom_linear_new(CustomLinear *linear, void *owner, int (*setup)(SUNLinearSolver, SUNMatrix),
                      int (*solve)(SUNLinearSolver, SUNMatrix, N_Vector, N_Vector, sunrealtype), SUNContext context);
/* Converts the results of linsolver_factor and linsolver_solve for SUNDIALS, which takes unknown numbers for success.
 * *lack: there was no memory. */
static inline int custom_linear_told(int status, int *lack)
{
    *lack = status < 0;
    return status == 0 ? SUN_SUCCESS : status < 0 ? SUN_ERR_MEM_FAIL : SUNLS_PACKAGE_FAIL_REC;
}

void custom_linear_free(CustomLinear *linear);
/* Integrates the equations of motion in time: by CVODE (BDF), or by one-step methods (sim/solve/esdirk.h). Only this,
 * with sim/solve/integrator.h, contact_newton.h and failure.h, uses SUNDIALS. docs/theory.md, "Integration" and
 * "One-step integration". */

typedef struct Integrator Integrator;

/* Starts at (t, y). The motion and y [motion->size] are borrowed; y always holds the latest state. Errors: MEMORY, RUN
 * (a SUNDIALS for which integrator_reshape does not work). */
hawser_status integrator_new(Motion *motion, double t, double *y, Integrator **out, hawser_error *err);
Integrator *integrator_free(Integrator *in);
/* Makes one step, not beyond `stop` (s). On failure y and *t hold the last good step and err has time, place and
 * remedies (HAWSER_ERR_RUN). */
hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err);
/* Limits the steps to `longest` from now on, s; 0: to the case's limit. */
void integrator_bound(Integrator *in, double longest);
/* Continues from the same time with the motion's new size: the history of the method is mapped like the state (RL17),
 * so that order and step stay, and Newton's matrix is made anew at once. Public calls of SUNDIALS suffice: all vectors
 * that CVODE uses are clones of ours, which change their length in place, and CVodeGetNonlinearSystemData returns the
 * one that is the history's state. motion->size is the new one already. Errors: MEMORY (the integrator can only be
 * freed then), RUN. */
hawser_status integrator_reshape(Integrator *in, double t, const Reshape *reshape, hawser_error *err);
/* Restarts at (t, y) with other equations for the same motion, keeping the counts. Errors: as integrator_new; *in is
 * unchanged then. */
hawser_status integrator_renew(Integrator **in, Motion *motion, double t, double *y, hawser_error *err);
/* Rates of the state of the last accepted step, [size], by the method: times *h, s: the step's length with BDF, 1 with
 * others. They are those of the collocation or of the last stage, which satisfy the equations of motion within Newton's
 * tolerance. Valid until the next step. */
const double *integrator_rates(Integrator *in, double *h);
/* Continues the counts of another integrator; called before the first step. */
void integrator_go_on(Integrator *in, const IntegratorStats *so_far);
void integrator_stats(const Integrator *in, IntegratorStats *stats);
/* Segment with the largest weighted local error, among those simulated. Allocates memory for a state. */
int integrator_worst(Integrator *in);
/* Prepares a new one to be read from a checkpoint: it is set up by a first step from t, with all rates zero, which
 * moves y by rounding only. Errors: RUN (a SUNDIALS whose state is not known). */
hawser_status integrator_prepare(Integrator *in, double t, hawser_error *err);
/* Checks whether its state can be saved; *why is the reason if not. */
int integrator_known(const Integrator *in, const char **why);
/* Saves or loads steps, orders and history, not y, the workspace or the motion's own data. */
void integrator_checkpoint(Checkpoint *c, Integrator *in);

#endif
