#include "bench/methods/own_linear.h"

#include <nvector/nvector_serial.h>
#include <string.h>

static int solver_setup(SUNLinearSolver s, SUNMatrix a)
{
    (void)a;
    Motion *const motion = ((OwnLinear *)s->content)->motion;
    return motion->ops->factor(motion);
}

static int solver_solve(SUNLinearSolver s, SUNMatrix a, N_Vector x, N_Vector b, sunrealtype tolerance)
{
    (void)a, (void)tolerance;
    Motion *const motion = ((OwnLinear *)s->content)->motion;
    if (x != b) N_VScale(1, b, x);
    return motion->ops->solve(motion, N_VGetArrayPointer(x));
}

int own_linear_new(OwnLinear *own, Motion *motion, SUNContext context)
{
    *own = (OwnLinear){.motion = motion};
    return custom_linear_new(&own->linear, own, solver_setup, solver_solve, context);
}

void own_linear_free(OwnLinear *own) { custom_linear_free(&own->linear); }

int own_linear_system(OwnLinear *own, double t, N_Vector y, N_Vector rates, int jok, sunbooleantype *jcur, double gamma)
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
