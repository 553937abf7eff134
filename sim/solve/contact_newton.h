/* Newton's iteration for contacts that open and close, in place of SUNDIALS' own. docs/theory.md, "Integration"
 * (N17)-(N20).
 *
 * A matrix is made anew as soon as the old one would take longer, and at the present iterate, instead of restarting; a
 * correction that diverges is judged by the matrix at its end, since one without a contact has no information on its
 * depth; if it diverges even so it is damped. Only what is given up then counts as a failure, and CVODE takes a smaller
 * step. */
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
    SUNNonlinearSolver shell; /* handed to CVODE; it borrows this struct */
    /* Set by CVODE. The unknown e is the correction to its predictor. */
    SUNNonlinSolSysFn residual; /* r(e) (N17); > 0: not finite there, a smaller step may be */
    SUNNonlinSolLSetupFn setup; /* factors the matrix: of the last evaluation of r, or the old one for a new gamma */
    SUNNonlinSolLSolveFn solve; /* with the present factors */
    /* of one solution */
    N_Vector r;          /* at its last evaluation */
    N_Vector step, next; /* the last correction made, and the one after it */
    double rate;         /* of convergence with the present matrix, as CVODE estimates it: R of (N17) */
    int fresh;           /* 1: the matrix was made at the start of the last correction */

    long iterations; /* corrections tried; CVODE adds them up */
    long failures;   /* solutions given up */
} ContactNewton;

/* For vectors like `like`. 0 if there is no memory; contact_newton_free may follow either way. */
int contact_newton_new(ContactNewton *newton, N_Vector like);
void contact_newton_free(ContactNewton *newton);

#endif
