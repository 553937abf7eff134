#include "sim/step/custom_linear.h"

static SUNMatrix_ID matrix_id(SUNMatrix a)
{
    (void)a;
    return SUNMATRIX_CUSTOM;
}

static SUNLinearSolver_Type solver_type(SUNLinearSolver s)
{
    (void)s;
    return SUNLINEARSOLVER_DIRECT;
}

static SUNLinearSolver_ID solver_id(SUNLinearSolver s)
{
    (void)s;
    return SUNLINEARSOLVER_CUSTOM;
}

int custom_linear_new(CustomLinear *linear, void *owner, int (*setup)(SUNLinearSolver, SUNMatrix),
                      int (*solve)(SUNLinearSolver, SUNMatrix, N_Vector, N_Vector, realtype), SUNContext context)
{
    *linear = (CustomLinear){SUNMatNewEmpty(context), SUNLinSolNewEmpty(context)};
    if (!linear->matrix || !linear->solver) return 0;
    linear->matrix->ops->getid = matrix_id;
    linear->solver->ops->gettype = solver_type;
    linear->solver->ops->getid = solver_id;
    linear->solver->ops->setup = setup;
    linear->solver->ops->solve = solve;
    linear->solver->content = owner;
    return 1;
}

void custom_linear_free(CustomLinear *linear)
{
    if (linear->solver) SUNLinSolFreeEmpty(linear->solver);
    if (linear->matrix) SUNMatFreeEmpty(linear->matrix);
    *linear = (CustomLinear){0};
}
