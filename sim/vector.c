#include "sim/vector.h"

#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "sim/vector_kernels.h"

enum { TERMS_MAX = 16 }; /* more than CVODE ever combines: its order is at most 12, plus 2 */

/* What SUNDIALS' serial vector keeps, so that its own operations go on working, and the norm with whom to ask. */
typedef struct VectorContent {
    struct _N_VectorContent_Serial serial; /* first */
    VectorNorm norm;
    const void *owner;
    VectorFamily *family;
} VectorContent;

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
    const VectorContent *const content = x->content;
    return content->norm(content->owner, NV_DATA_S(x), NV_DATA_S(w));
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
    if (!(a < 0 || a > 0)) {
        memset(data, 0, (size_t)count * sizeof *data); /* which is what CVODE asks for */
        return;
    }
    for (int i = 0; i < count; ++i) data[i] = a;
}

/* Into the family's list; 0 if there is no memory. */
static int family_add(VectorFamily *family, N_Vector v)
{
    if (!family) return 1;
    if (family->n == family->room) {
        const int room = 2 * family->room + 16;
        N_Vector *const longer = realloc(family->member, (size_t)room * sizeof *longer);
        if (!longer) return 0;
        family->member = longer;
        family->room = room;
    }
    family->member[family->n++] = v;
    return 1;
}

static void family_remove(VectorFamily *family, N_Vector v)
{
    for (int k = 0; family && k < family->n; ++k) {
        if (family->member[k] != v) continue;
        family->member[k] = family->member[--family->n];
        break;
    }
}

static void op_destroy(N_Vector v)
{
    if (!v) return;
    VectorContent *const content = v->content;
    if (content) family_remove(content->family, v);
    if (content && content->serial.own_data) free(content->serial.data);
    free(content);
    N_VFreeEmpty(v);
}

/* The content and operations of a vector around `data`. */
static N_Vector vector_fill(N_Vector v, double *data, int own, const VectorContent *like)
{
    VectorContent *const content = malloc(sizeof *content);
    if (!v || !content || !data || !family_add(like->family, v)) {
        free(content);
        if (own) free(data);
        N_VFreeEmpty(v);
        return NULL;
    }
    *content = *like;
    content->serial.data = data;
    content->serial.own_data = own;
    v->content = content;
    return v;
}

static N_Vector op_clone(N_Vector like)
{
    const VectorContent *const content = like->content;
    N_Vector v = N_VNewEmpty(like->sunctx);
    if (v && N_VCopyOps(like, v)) {
        N_VFreeEmpty(v);
        return NULL;
    }
    return vector_fill(v, aligned_array_new((int)content->serial.length), 1, content);
}

static void use_kernels(N_Vector v)
{
    v->ops->nvclone = op_clone;
    v->ops->nvdestroy = op_destroy;
    v->ops->nvlinearsum = op_linear_sum;
    v->ops->nvscale = op_scale;
    v->ops->nvconst = op_const;
    v->ops->nvwrmsnorm = op_norm;
    v->ops->nvlinearcombination = op_combination;
    v->ops->nvscaleaddmulti = op_scale_add_multi;
}

N_Vector vector_wrap(int length, double *data, VectorNorm norm, const void *owner, VectorFamily *family,
                     SUNContext context)
{
    /* the serial vector lends its other operations; its content makes room for ours, which begins like it */
    N_Vector v = N_VNewEmpty_Serial(length, context);
    if (!v) return NULL;
    free(v->content);
    v->content = NULL;
    use_kernels(v);
    const VectorContent content = {.serial = {.length = length}, .norm = norm, .owner = owner, .family = family};
    return vector_fill(v, data, 0, &content);
}

void vector_family_clear(VectorFamily *family)
{
    free(family->member);
    *family = (VectorFamily){0};
}

int vector_family_resize(VectorFamily *family, int length, double *data, VectorMap map, const void *user)
{
    const int n = family->n;
    double **const fresh = calloc((size_t)n + 1, sizeof *fresh);
    int ok = fresh != NULL;
    for (int k = 0; ok && k < n; ++k) {
        fresh[k] = NV_OWN_DATA_S(family->member[k]) ? calloc((size_t)length + 1, sizeof(double)) : data;
        ok = fresh[k] != NULL;
    }
    for (int k = 0; fresh && k < n; ++k) {
        N_Vector v = family->member[k];
        if (ok) {
            if (NV_OWN_DATA_S(v)) {
                map(user, v, NV_DATA_S(v), fresh[k]);
                free(NV_DATA_S(v));
            }
            NV_DATA_S(v) = fresh[k];
            NV_LENGTH_S(v) = length;
        } else if (NV_OWN_DATA_S(v)) {
            free(fresh[k]);
        }
    }
    free(fresh);
    return ok;
}
