/* Newton's iteration where contacts open and close, in place of SUNDIALS' own. docs/model.md, "Integration"
 * (N17)-(N20).
 *
 * A matrix is made anew as soon as the old one would take longer, and where the iteration stands, instead of beginning
 * again; a correction that leads off is judged by the matrix of where it led to, since one without a contact knows
 * nothing of the depth in it; what leads off even so is damped. Only what is given up then counts as a failure, and
 * CVODE takes a smaller step. */
#ifndef HAWSER_SIM_SOLVE_CONTACT_NEWTON_H
#define HAWSER_SIM_SOLVE_CONTACT_NEWTON_H

#include <sundials/sundials_config.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_nonlinearsolver.h>

/* Names of SUNDIALS 7, for 6. */
#if SUNDIALS_VERSION_MAJOR < 7
#define SUN_COMM_NULL    NULL
#define SUN_SUCCESS      SUNLS_SUCCESS
#define SUN_ERR_MEM_FAIL SUNLS_MEM_FAIL
#define SUN_ERR_EXT_FAIL SUN_NLS_EXT_FAIL
#endif

typedef struct ContactNewton {
    SUNNonlinearSolver shell; /* what CVODE is given; it borrows this struct */
    /* What CVODE gives. The unknown e is the correction of its predictor. */
    SUNNonlinSolSysFn residual; /* r(e) (N17); > 0: not finite there, a smaller step may do */
    SUNNonlinSolLSetupFn setup; /* factors the matrix: of where r was evaluated last, or the old one for a new gamma */
    SUNNonlinSolLSolveFn solve; /* with the factors of now */
    /* of one solution */
    N_Vector r;          /* where it was evaluated last */
    N_Vector step, next; /* the correction that was made last, and the one after it */
    double rate;         /* of convergence with the matrix of now, as CVODE reckons it: R of (N17) */
    int fresh;           /* the matrix is that of where the last correction began */

    long iterations; /* corrections tried; CVODE adds them up */
    long failures;   /* 1: it was given up */
} ContactNewton;

/* For vectors like `like`. 0 if there is no memory; contact_newton_free may follow either way. */
int contact_newton_new(ContactNewton *newton, N_Vector like);
void contact_newton_free(ContactNewton *newton);

#endif
