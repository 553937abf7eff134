#include "sim/vector.h"

#include <math.h>
#include <nvector/nvector_serial.h>

#include "core/state.h"
#include "sim/vector_kernels.h"

enum { TERMS_MAX = 16 }; /* more than CVODE ever combines: its order is at most 12, plus 2 */

static const VectorKernels *kernels(void)
{
    static const VectorKernels *const table[] = ISA_TABLE(vector_kernels);
    return table[isa_best()];
}

static int length_of(N_Vector v) { return (int)NV_LENGTH_S(v); }

static void op_linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z)
{
    kernels()->linear_sum(length_of(x), a, NV_DATA_S(x), b, NV_DATA_S(y), NV_DATA_S(z));
}

static void op_scale(realtype a, N_Vector x, N_Vector z)
{
    kernels()->scale(length_of(x), a, NV_DATA_S(x), NV_DATA_S(z));
}

static realtype op_norm(N_Vector x, N_Vector w)
{
    return sqrt(kernels()->window_square(length_of(x) / STATE_SIZE, NV_DATA_S(x), NV_DATA_S(w)));
}

static int op_combination(int terms, realtype *a, N_Vector *x, N_Vector z)
{
    double *data[TERMS_MAX];
    if (terms < 1 || terms > TERMS_MAX) return -1;
    for (int k = 0; k < terms; ++k) data[k] = NV_DATA_S(x[k]);
    kernels()->combination(length_of(z), terms, a, data, NV_DATA_S(z));
    return 0;
}

/* z[k] = a[k] x + y[k] */
static int op_scale_add_multi(int terms, realtype *a, N_Vector x, N_Vector *y, N_Vector *z)
{
    for (int k = 0; k < terms; ++k) op_linear_sum(a[k], x, 1, y[k], z[k]);
    return 0;
}

static void op_const(realtype a, N_Vector z)
{
    double *const data = NV_DATA_S(z);
    const int count = length_of(z);
    for (int i = 0; i < count; ++i) data[i] = a;
}

void vector_project(N_Vector y, N_Vector correction, N_Vector error)
{
    kernels()->project(length_of(y) / STATE_SIZE, NV_DATA_S(y), NV_DATA_S(correction), error ? NV_DATA_S(error) : NULL);
}

void vector_use_kernels(N_Vector v)
{
    v->ops->nvlinearsum = op_linear_sum;
    v->ops->nvscale = op_scale;
    v->ops->nvconst = op_const;
    v->ops->nvwrmsnorm = op_norm;
    v->ops->nvlinearcombination = op_combination;
    v->ops->nvscaleaddmulti = op_scale_add_multi;
}
