/* hawser's Newton matrix as a linear solver of SUNDIALS', for CVODE and ARKODE alike (both ask for 1 - gamma J). */
#ifndef HAWSER_BENCH_METHODS_OWN_LINEAR_H
#define HAWSER_BENCH_METHODS_OWN_LINEAR_H

#include "sim/solve/integrator.h"
#include "sim/solve/motion.h"

typedef struct OwnLinear {
    Motion *motion;
    CustomLinear linear;
    long jacobians;
} OwnLinear;

int own_linear_new(OwnLinear *own, Motion *motion, SUNContext context);
void own_linear_free(OwnLinear *own);
/* New derivatives at (t, y) unless jok; the matrix for gamma. */
int own_linear_system(OwnLinear *own, double t, N_Vector y, N_Vector rates, int jok, sunbooleantype *jcur,
                      double gamma);

#endif
