#include "bench/methods/own_linear.h"

#include <nvector/nvector_serial.h>
#include <string.h>

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

static int solver_setup(SUNLinearSolver s, SUNMatrix a)
{
    (void)a;
    Motion *const motion = ((OwnLinear *)s->content)->motion;
    return motion->ops->factor(motion);
}

static int solver_solve(SUNLinearSolver s, SUNMatrix a, N_Vector x, N_Vector b, realtype tolerance)
{
    (void)a, (void)tolerance;
    Motion *const motion = ((OwnLinear *)s->content)->motion;
    if (x != b) N_VScale(1, b, x);
    return motion->ops->solve(motion, N_VGetArrayPointer(x));
}

int own_linear_new(OwnLinear *own, Motion *motion, SUNContext context)
{
    *own = (OwnLinear){.motion = motion, .matrix = SUNMatNewEmpty(context), .solver = SUNLinSolNewEmpty(context)};
    if (!own->matrix || !own->solver) return 0;
    own->matrix->ops->getid = matrix_id;
    own->solver->ops->gettype = solver_type;
    own->solver->ops->getid = solver_id;
    own->solver->ops->setup = solver_setup;
    own->solver->ops->solve = solver_solve;
    own->solver->content = own;
    return 1;
}

void own_linear_free(OwnLinear *own)
{
    if (own->solver) SUNLinSolFreeEmpty(own->solver);
    if (own->matrix) SUNMatFreeEmpty(own->matrix);
    memset(own, 0, sizeof *own);
}

int own_linear_system(OwnLinear *own, double t, N_Vector y, N_Vector rates, int jok, booleantype *jcur, double gamma)
{
    Motion *const motion = own->motion;
    if (!jok) {
        motion->ops->linearise(motion, t, N_VGetArrayPointer(y), N_VGetArrayPointer(rates));
        ++own->jacobians;
    }
    *jcur = !jok;
    motion->ops->form(motion, gamma);
    return 0;
}
