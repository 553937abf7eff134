/* The methods. Each walks its problem's state from `from` to `to`, or as far as it gets, and fills the walk; 0 only if
 * it could not even begin (memory). setting: the accuracy of one that controls its error, the step in s of one that
 * does not. variant: which of its kind. */
#ifndef HAWSER_BENCH_METHODS_METHODS_H
#define HAWSER_BENCH_METHODS_METHODS_H

#include "bench/methods/problem.h"

typedef struct Choice {
    int variant;
    double setting, limit; /* limit: s of processor time */
} Choice;

typedef int MethodRun(Problem *p, const Choice *choice, Walk *w);

/* hawser's integrator as the program uses it. */
MethodRun run_hawser;

/* Fixed steps, explicit. */
enum { EXPLICIT_RK4, EXPLICIT_SYMPLECTIC };
MethodRun run_explicit;

/* Fixed steps, implicit, with hawser's Newton matrix. */
enum { FIXED_EULER, FIXED_TRAPEZOID, FIXED_BDF2, FIXED_ALPHA };
MethodRun run_fixed;

/* ARKODE: variant is a table's number (arkode_butcher_erk.h, arkode_butcher_dirk.h), the latter with hawser's matrix.
 */
enum { DIRK_DEFAULT = 1000 }; /* added to a table's number: with ARKODE's own settings of Newton's iteration */
MethodRun run_erk, run_dirk;

/* CVODE as its user's guide would set it up on the unreduced system (orders up to solver.max_order, its own norm,
 * limits and Newton's tolerance) with a linear solver of SUNDIALS', or with hawser's matrix. */
enum {
    LINEAR_OWN,        /* hawser's, whatever solver.linear_solver says */
    LINEAR_DENSE,      /* difference quotients, LU */
    LINEAR_BAND,       /* the same in segment order, banded */
    LINEAR_KLU,        /* coloured difference quotients, KLU */
    LINEAR_GMRES,      /* matrix-free, five vectors as is the default */
    LINEAR_GMRES_LONG, /* the same with 60 vectors */
    LINEAR_GMRES_BAND, /* SUNDIALS' banded preconditioner, in segment order */
    LINEAR_GMRES_OWN   /* hawser's matrix as preconditioner */
};
MethodRun run_cvode;

#endif
