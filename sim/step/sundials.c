#include "sim/step/sundials.h"

#include <assert.h>
#include <nvector/nvector_serial.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"

/* What SUNDIALS' serial vector keeps, so that its own operations go on working, and the norm with whom to ask. */
typedef struct VectorContent {
    struct _N_VectorContent_Serial serial; /* first */
    VectorNorm norm;
    const void *owner;
    VectorFamily *family;
} VectorContent;

static int length_of(N_Vector v) { return (int)NV_LENGTH_S(v); }

/* Does what waits for the vector's family. */
static void settle(N_Vector v)
{
    const VectorContent *const content = v->content;
    if (content->family) vector_queue_flush(&content->family->queue, length_of(v));
}

/* The task to fill in: in the family's queue, or `alone` where there is none. */
static VectorTask *task_begin(N_Vector z, VectorTask *alone)
{
    const VectorContent *const content = z->content;
    return content->family ? vector_queue_next(&content->family->queue, length_of(z)) : alone;
}

/* Done at once if it has no queue to wait in. */
static void task_end(N_Vector z, const VectorTask *task, const VectorTask *alone)
{
    if (task == alone) vector_task_run(task, length_of(z));
}

/* ------------------------------------------------------------------------------------------ what can wait */

static void op_linear_sum(realtype a, N_Vector x, realtype b, N_Vector y, N_Vector z)
{
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_SUM;
    task->a[0] = a;
    task->a[1] = b;
    task->x[0] = NV_DATA_S(x);
    task->x[1] = NV_DATA_S(y);
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
}

static void op_scale(realtype a, N_Vector x, N_Vector z)
{
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_SCALE;
    task->a[0] = a;
    task->x[0] = NV_DATA_S(x);
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
}

static void op_const(realtype a, N_Vector z)
{
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_FILL;
    task->a[0] = a;
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
}

static int op_combination(int terms, realtype *a, N_Vector *x, N_Vector z)
{
    if (terms < 1 || terms > VECTOR_TERMS_MAX) return -1;
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_COMBINATION;
    task->terms = terms;
    for (int k = 0; k < terms; ++k) {
        task->a[k] = a[k];
        task->x[k] = NV_DATA_S(x[k]);
    }
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
    return 0;
}

/* z[k] = a[k] x + y[k] */
static int op_scale_add_multi(int terms, realtype *a, N_Vector x, N_Vector *y, N_Vector *z)
{
    for (int k = 0; k < terms; ++k) op_linear_sum(a[k], x, 1, y[k], z[k]);
    return 0;
}

/* ------------------------------------------------------------------------------------------ what cannot */

static realtype *op_data(N_Vector v)
{
    settle(v);
    return NV_DATA_S(v);
}

static realtype op_norm(N_Vector x, N_Vector w)
{
    const VectorContent *const content = x->content;
    settle(x);
    return content->norm(content->owner, NV_DATA_S(x), NV_DATA_S(w));
}

/* What CVODE asks for before its first step is SUNDIALS' own, of numbers that are there. */

static void op_product(N_Vector x, N_Vector y, N_Vector z)
{
    settle(z);
    N_VProd_Serial(x, y, z);
}

static void op_quotient(N_Vector x, N_Vector y, N_Vector z)
{
    settle(z);
    N_VDiv_Serial(x, y, z);
}

static void op_absolute(N_Vector x, N_Vector z)
{
    settle(z);
    N_VAbs_Serial(x, z);
}

static void op_inverse(N_Vector x, N_Vector z)
{
    settle(z);
    N_VInv_Serial(x, z);
}

static void op_add_const(N_Vector x, realtype b, N_Vector z)
{
    settle(z);
    N_VAddConst_Serial(x, b, z);
}

static realtype op_dot(N_Vector x, N_Vector y)
{
    settle(x);
    return N_VDotProd_Serial(x, y);
}

static realtype op_largest(N_Vector x)
{
    settle(x);
    return N_VMaxNorm_Serial(x);
}

static realtype op_least(N_Vector x)
{
    settle(x);
    return N_VMin_Serial(x);
}

/* ------------------------------------------------------------------------------------------ life */

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
    if (content) {
        settle(v);
        family_remove(content->family, v);
    }
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

N_Vector vector_clone(N_Vector like)
{
    const VectorContent *const content = like->content;
    N_Vector v = N_VNewEmpty(like->sunctx);
    if (v && N_VCopyOps(like, v)) {
        N_VFreeEmpty(v);
        return NULL;
    }
    return vector_fill(v, aligned_array_new((int)content->serial.length), 1, content);
}

static N_Vector op_clone(N_Vector like)
{
    VectorFamily *const family = ((const VectorContent *)like->content)->family;
    return family && family->n_spare > 0 ? family->spare[--family->n_spare] : vector_clone(like);
}

/* Operations that are not listed would read numbers that wait to be computed: there are none. */
static void use_ours(N_Vector v)
{
    const struct _generic_N_Vector_Ops none = {0}, theirs = *v->ops;
    *v->ops = none;
    v->ops->nvgetvectorid = theirs.nvgetvectorid;
    v->ops->nvgetlength = theirs.nvgetlength;
    v->ops->nvspace = theirs.nvspace;
    v->ops->nvclone = op_clone;
    v->ops->nvdestroy = op_destroy;
    v->ops->nvgetarraypointer = op_data;
    v->ops->nvlinearsum = op_linear_sum;
    v->ops->nvscale = op_scale;
    v->ops->nvconst = op_const;
    v->ops->nvlinearcombination = op_combination;
    v->ops->nvscaleaddmulti = op_scale_add_multi;
    v->ops->nvwrmsnorm = op_norm;
    v->ops->nvprod = op_product;
    v->ops->nvdiv = op_quotient;
    v->ops->nvabs = op_absolute;
    v->ops->nvinv = op_inverse;
    v->ops->nvaddconst = op_add_const;
    v->ops->nvdotprod = op_dot;
    v->ops->nvmaxnorm = op_largest;
    v->ops->nvmin = op_least;
}

N_Vector vector_wrap(int length, double *data, VectorNorm norm, const void *owner, VectorFamily *family,
                     SUNContext context)
{
    /* the serial vector lends its other operations; its content makes room for ours, which begins like it */
    N_Vector v = N_VNewEmpty_Serial(length, context);
    if (!v) return NULL;
    free(v->content);
    v->content = NULL;
    use_ours(v);
    const VectorContent content = {.serial = {.length = length}, .norm = norm, .owner = owner, .family = family};
    return vector_fill(v, data, 0, &content);
}

void vector_take(N_Vector x, N_Vector b)
{
    VectorContent *const to = x->content, *const from = b->content;
    if (!to->family || !to->serial.own_data || !from->serial.own_data) {
        N_VScale(1.0, b, x);
        return;
    }
    double *const given = from->serial.data;
    vector_queue_unfill(&to->family->queue, to->serial.data);
    from->serial.data = to->serial.data;
    to->serial.data = given;
}

int vector_family_stock(N_Vector like, int n)
{
    VectorFamily *const family = ((const VectorContent *)like->content)->family;
    assert(family && !family->spare);
    family->spare = calloc((size_t)n, sizeof *family->spare);
    while (family->spare && family->n_spare < n) {
        N_Vector v = vector_clone(like);
        if (!v) break;
        family->spare[family->n_spare++] = v;
    }
    return family->n_spare == n;
}

int vector_family_unstock(VectorFamily *family)
{
    const int left = family->n_spare;
    while (family->n_spare > 0) op_destroy(family->spare[--family->n_spare]);
    free(family->spare);
    family->spare = NULL;
    return left;
}

void vector_family_settle(VectorFamily *family)
{
    if (family->n > 0) settle(family->member[0]);
}

void vector_family_clear(VectorFamily *family)
{
    free(family->member);
    *family = (VectorFamily){0};
}

int vector_family_resize(VectorFamily *family, int length, double *data, VectorMap map, const void *user)
{
    vector_family_settle(family);
    for (int k = 0; k < family->n; ++k) {
        N_Vector v = family->member[k];
        double *fresh = data;
        if (NV_OWN_DATA_S(v)) {
            fresh = aligned_array_new(length);
            if (!fresh) return 0;
            map(user, v, NV_DATA_S(v), fresh);
            free(NV_DATA_S(v));
        }
        NV_DATA_S(v) = fresh;
        NV_LENGTH_S(v) = length;
    }
    return 1;
}

/* ------------------------------------------------------------------------------------------ a linear solver */

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
