/* A matrix and a direct linear solver of ours in SUNDIALS' clothes: the matrix is empty, since the owner forms and
 * keeps it; SUNDIALS only says when to factor and when to solve. */
#ifndef HAWSER_SIM_STEP_CUSTOM_LINEAR_H
#define HAWSER_SIM_STEP_CUSTOM_LINEAR_H

#include <sundials/sundials_linearsolver.h>

typedef struct CustomLinear {
    SUNMatrix matrix;
    SUNLinearSolver solver;
} CustomLinear;

/* setup factors, solve solves, as SUNLinearSolver_Ops have them; solver->content is `owner`. 0: no memory;
 * custom_linear_free may follow either way. */
int custom_linear_new(CustomLinear *linear, void *owner, int (*setup)(SUNLinearSolver, SUNMatrix),
                      int (*solve)(SUNLinearSolver, SUNMatrix, N_Vector, N_Vector, realtype), SUNContext context);
void custom_linear_free(CustomLinear *linear);

#endif
