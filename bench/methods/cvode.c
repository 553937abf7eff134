/* CVODE on the unreduced system with what SUNDIALS brings, set up as its guide does it: order 5 or what
 * solver.max_order says, its own norm over all entries, Newton's iteration to a tenth of the tolerance, derivatives and
 * matrix renewed by its own rules. Only the tolerances are hawser's, entry by entry, and quaternions are projected. */
#include <cvode/cvode.h>
#include <cvode/cvode_bandpre.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunlinsol/sunlinsol_dense.h>
#include <sunlinsol/sunlinsol_klu.h>
#include <sunlinsol/sunlinsol_spgmr.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunmatrix/sunmatrix_dense.h>
#include <sunmatrix/sunmatrix_sparse.h>

#include "bench/methods/coloured.h"
#include "bench/methods/methods.h"
#include "bench/methods/own_linear.h"
#include "core/chain.h"

enum { GMRES_LONG = 60 };

/* Banded solvers want the unknowns segment by segment: CVODE's vector is then `size` = per n entries in that order, and
 * the motion's own is gathered from it. */
typedef struct Plain {
    Problem *p;
    int by_segment;
    int size;
    double *motion_y, *motion_f, *weight; /* [motion->size] */
    void *memory;
    SUNContext context;
    N_Vector y;
    SUNMatrix matrix;
    SUNLinearSolver solver;
    OwnLinear own;
    Coloured coloured;
    long rhs;
} Plain;

static void to_motion(const Plain *c, const double *x, double *y)
{
    const Problem *const p = c->p;
    for (int i = 0; i < p->n; ++i) {
        for (int k = 0; k < p->per; ++k) y[k * p->stride + i] = x[p->per * i + k];
    }
}

static void from_motion(const Plain *c, const double *y, double *x)
{
    const Problem *const p = c->p;
    for (int i = 0; i < p->n; ++i) {
        for (int k = 0; k < p->per; ++k) x[p->per * i + k] = y[k * p->stride + i];
    }
}

/* ------------------------------------------------------------------------------------------------ call-backs */

static int call_rates(sunrealtype t, N_Vector y, N_Vector ydot, void *user)
{
    Plain *const c = user;
    Motion *const motion = c->p->motion;
    ++c->rhs;
    if (!c->by_segment) return motion->ops->rates(motion, t, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    to_motion(c, N_VGetArrayPointer(y), c->motion_y);
    const int bad = motion->ops->rates(motion, t, c->motion_y, c->motion_f);
    from_motion(c, c->motion_f, N_VGetArrayPointer(ydot));
    return bad;
}

static int call_weights(N_Vector y, N_Vector weight, void *user)
{
    (void)y;
    const Plain *const c = user;
    double *const w = N_VGetArrayPointer(weight);
    if (c->by_segment) {
        from_motion(c, c->weight, w);
    } else {
        memcpy(w, c->weight, (size_t)c->size * sizeof *w);
    }
    return 0;
}

static int call_projection(sunrealtype t, N_Vector y, N_Vector correction, sunrealtype tolerance, N_Vector error,
                           void *user)
{
    (void)t, (void)tolerance;
    const Plain *const c = user;
    const Motion *const motion = c->p->motion;
    if (!c->by_segment) {
        motion->ops->project(motion, N_VGetArrayPointer(y), N_VGetArrayPointer(correction),
                             error ? N_VGetArrayPointer(error) : NULL);
        return 0;
    }
    to_motion(c, N_VGetArrayPointer(y), c->motion_y);
    motion->ops->project(motion, c->motion_y, c->motion_f, NULL); /* the error keeps its part along the quaternions */
    from_motion(c, c->motion_f, N_VGetArrayPointer(correction));
    return 0;
}

static int call_system(sunrealtype t, N_Vector y, N_Vector fy, SUNMatrix a, sunbooleantype jok, sunbooleantype *jcur,
                       sunrealtype gamma, void *user, N_Vector t1, N_Vector t2, N_Vector t3)
{
    (void)a, (void)t1, (void)t2, (void)t3;
    return own_linear_system(&((Plain *)user)->own, t, y, fy, jok, jcur, gamma);
}

static int call_jacobian(sunrealtype t, N_Vector y, N_Vector fy, SUNMatrix a, void *user, N_Vector t1, N_Vector t2,
                         N_Vector t3)
{
    (void)t1, (void)t2, (void)t3;
    return coloured_jacobian(&((Plain *)user)->coloured, t, N_VGetArrayPointer(y), N_VGetArrayPointer(fy), a);
}

static int call_precondition(sunrealtype t, N_Vector y, N_Vector fy, sunbooleantype jok, sunbooleantype *jcur,
                             sunrealtype gamma, void *user)
{
    Plain *const c = user;
    own_linear_system(&c->own, t, y, fy, jok, jcur, gamma);
    return c->p->motion->ops->factor(c->p->motion);
}

static int call_preconditioned(sunrealtype t, N_Vector y, N_Vector fy, N_Vector r, N_Vector z, sunrealtype gamma,
                               sunrealtype delta, int side, void *user)
{
    (void)t, (void)y, (void)fy, (void)gamma, (void)delta, (void)side;
    Motion *const motion = ((Plain *)user)->p->motion;
    N_VScale(1, r, z);
    return motion->ops->solve(motion, N_VGetArrayPointer(z));
}

static void call_complaint(int code, const char *module, const char *function, char *message, void *user)
{
    (void)code, (void)module, (void)function, (void)message, (void)user;
}

/* --------------------------------------------------------------------------------------------- linear solvers */

static int attach_matrix(Plain *c) { return CVodeSetLinearSolver(c->memory, c->solver, c->matrix) != CV_SUCCESS; }

static int attach_own(Plain *c)
{
    if (!own_linear_new(&c->own, c->p->motion, c->context)) return 1;
    return CVodeSetLinearSolver(c->memory, c->own.linear.solver, c->own.linear.matrix) ||
           CVodeSetLinSysFn(c->memory, call_system);
}

static int attach_dense(Plain *c)
{
    c->matrix = SUNDenseMatrix(c->size, c->size, c->context);
    c->solver = c->matrix ? SUNLinSol_Dense(c->y, c->matrix, c->context) : NULL;
    return !c->solver || attach_matrix(c);
}

/* Rates depend on the own segment and the neighbours, so that two whole segments less one fit beside the diagonal. */
static int half_band(const Plain *c) { return 2 * c->p->per - 1; }

static int attach_band(Plain *c)
{
    c->matrix = SUNBandMatrix(c->size, half_band(c), half_band(c), c->context);
    c->solver = c->matrix ? SUNLinSol_Band(c->y, c->matrix, c->context) : NULL;
    return !c->solver || attach_matrix(c);
}

static int attach_klu(Plain *c)
{
    if (!coloured_new(&c->coloured, c->p)) return 1;
    c->matrix = SUNSparseMatrix(c->size, c->size, coloured_entries(&c->coloured), CSC_MAT, c->context);
    c->solver = c->matrix ? SUNLinSol_KLU(c->y, c->matrix, c->context) : NULL;
    return !c->solver || attach_matrix(c) || CVodeSetJacFn(c->memory, call_jacobian);
}

static int attach_gmres(Plain *c, int variant)
{
    const int preconditioned = variant == LINEAR_GMRES_BAND || variant == LINEAR_GMRES_OWN;
    c->solver = SUNLinSol_SPGMR(c->y, preconditioned ? SUN_PREC_LEFT : SUN_PREC_NONE,
                                variant == LINEAR_GMRES_LONG ? GMRES_LONG : 0, c->context);
    if (!c->solver || attach_matrix(c)) return 1;
    if (variant == LINEAR_GMRES_BAND) return CVBandPrecInit(c->memory, c->size, half_band(c), half_band(c));
    if (variant != LINEAR_GMRES_OWN) return 0;
    return !own_linear_new(&c->own, c->p->motion, c->context) ||
           CVodeSetPreconditioner(c->memory, call_precondition, call_preconditioned);
}

static int attach(Plain *c, int variant)
{
    switch (variant) {
    case LINEAR_OWN:
        return attach_own(c);
    case LINEAR_DENSE:
        return attach_dense(c);
    case LINEAR_BAND:
        return attach_band(c);
    case LINEAR_KLU:
        return attach_klu(c);
    default:
        return attach_gmres(c, variant);
    }
}

/* ------------------------------------------------------------------------------------------------------- a run */

static int vector_start(Plain *c)
{
    Problem *const p = c->p;
    c->y = c->by_segment ? N_VNew_Serial(c->size, c->context) : N_VMake_Serial(c->size, p->stage.y, c->context);
    if (!c->y) return 0;
    if (c->by_segment) from_motion(c, p->stage.y, N_VGetArrayPointer(c->y));
    p->motion->ops->weights(p->motion, c->weight);
    return 1;
}

static int plain_start(Plain *c, Problem *p, int variant)
{
    Motion *const motion = p->motion;
    const int by_segment = variant == LINEAR_DENSE || variant == LINEAR_BAND || variant == LINEAR_GMRES_BAND;
    *c = (Plain){.p = p, .by_segment = by_segment, .size = by_segment ? p->per * p->n : motion->size};
    c->motion_y = aligned_array_new(motion->size);
    c->motion_f = aligned_array_new(motion->size);
    c->weight = aligned_array_new(motion->size);
    if (!c->motion_y || !c->motion_f || !c->weight || SUNContext_Create(NULL, &c->context)) return 0;
    if (!vector_start(c)) return 0;
    c->memory = CVodeCreate(CV_BDF, c->context);
    if (!c->memory || CVodeInit(c->memory, call_rates, p->from, c->y)) return 0;
    int bad = CVodeSetUserData(c->memory, c) | CVodeWFtolerances(c->memory, call_weights);
    bad |= CVodeSetMaxOrd(c->memory, p->stage.scene.def.solver.max_order) | CVodeSetMaxNumSteps(c->memory, -1);
    bad |= CVodeSetMaxStep(c->memory, p->stage.scene.def.output.interval);
    bad |= CVodeSetErrHandlerFn(c->memory, call_complaint, c);
    if (motion->ops->project) bad |= CVodeSetProjFn(c->memory, call_projection);
    return !bad && !attach(c, variant);
}

static void plain_count(const Plain *c, int variant, Counts *counts)
{
    CVodeGetNumSteps(c->memory, &counts->steps);
    CVodeGetNumNonlinSolvIters(c->memory, &counts->iterations);
    CVodeGetNumLinSolvSetups(c->memory, &counts->setups);
    CVodeGetNumErrTestFails(c->memory, &counts->error_fails);
    CVodeGetNumNonlinSolvConvFails(c->memory, &counts->newton_fails);
    CVodeGetNumJacEvals(c->memory, &counts->jacobians);
    CVodeGetNumLinIters(c->memory, &counts->inner);
    if (variant == LINEAR_OWN || variant == LINEAR_GMRES_OWN) counts->jacobians = c->own.jacobians;
    counts->rhs = c->rhs + c->coloured.rhs;
}

static void plain_free(Plain *c)
{
    if (c->memory) CVodeFree(&c->memory);
    if (c->solver) SUNLinSolFree(c->solver);
    if (c->matrix) SUNMatDestroy(c->matrix);
    own_linear_free(&c->own);
    coloured_free(&c->coloured);
    if (c->y) N_VDestroy(c->y);
    if (c->context) SUNContext_Free(&c->context);
    free(c->motion_y);
    free(c->motion_f);
    free(c->weight);
}

/* The step's state in the motion's order. */
static const double *state_of(const Plain *c)
{
    if (!c->by_segment) return N_VGetArrayPointer(c->y);
    to_motion(c, N_VGetArrayPointer(c->y), c->motion_y);
    return c->motion_y;
}

int run_cvode(Problem *p, const Choice *choice, Walk *w)
{
    Plain c;
    p->stage.scene.def.solver.accuracy = choice->setting;
    walk_begin(w, p, choice->limit);
    const int ok = plain_start(&c, p, choice->variant);
    double t = p->from, stop = t;
    while (ok && t < p->to) {
        if (t >= stop) CVodeSetStopTime(c.memory, stop = problem_stop(p, t));
        const int flag = CVode(c.memory, stop, c.y, &t, CV_ONE_STEP);
        if (flag < 0) snprintf(w->why, sizeof w->why, "CVODE's flag %d at t = %.4g s", flag, t);
        if (flag < 0 || walk_step(w, t, state_of(&c))) break;
    }
    walk_end(w);
    if (ok) plain_count(&c, choice->variant, &w->counts);
    plain_free(&c);
    return ok;
}
