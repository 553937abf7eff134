#include "sim/solve/integrator.h"

#include <assert.h>
#include <cvode/cvode.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sundials/sundials_linearsolver.h>
#include <sundials/sundials_matrix.h>
#include <sundials/sundials_version.h>

#include "core/chain.h"
#include "core/error.h"
#include "core/machine.h"
#include "sim/equipment/winch.h"
#include "sim/solve/contact_newton.h"
#include "sim/solve/cvode_memory.h"
#include "sim/solve/esdirk.h"
#include "sim/solve/failure.h"
#include "sim/solve/scales.h"

/* Content of SUNDIALS' serial vector, so that its own operations keep working, with the norm and its owner. */
typedef struct VectorContent {
    struct _N_VectorContent_Serial serial; /* first */
    VectorNorm norm;
    const void *owner;
    VectorFamily *family;
} VectorContent;

static int length_of(N_Vector v) { return (int)NV_LENGTH_S(v); }

/* Carries out the waiting tasks of the vector's family. */
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

/* Carries the task out at once if there is no queue. */
static void task_end(N_Vector z, const VectorTask *task, const VectorTask *alone)
{
    if (task == alone) vector_task_run(task, length_of(z));
}

/* ------------------------------------------------------------------------------------------ deferred operations */

static void op_linear_sum(sunrealtype a, N_Vector x, sunrealtype b, N_Vector y, N_Vector z)
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

static void op_scale(sunrealtype a, N_Vector x, N_Vector z)
{
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_SCALE;
    task->a[0] = a;
    task->x[0] = NV_DATA_S(x);
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
}

static void op_const(sunrealtype a, N_Vector z)
{
    VectorTask alone, *const task = task_begin(z, &alone);
    task->kind = VECTOR_FILL;
    task->a[0] = a;
    task->z = NV_DATA_S(z);
    task_end(z, task, &alone);
}

static int op_combination(int terms, sunrealtype *a, N_Vector *x, N_Vector z)
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
static int op_scale_add_multi(int terms, sunrealtype *a, N_Vector x, N_Vector *y, N_Vector *z)
{
    for (int k = 0; k < terms; ++k) op_linear_sum(a[k], x, 1, y[k], z[k]);
    return 0;
}

/* ------------------------------------------------------------------------------------------ immediate operations */

static sunrealtype *op_data(N_Vector v)
{
    settle(v);
    return NV_DATA_S(v);
}

static sunrealtype op_norm(N_Vector x, N_Vector w)
{
    const VectorContent *const content = x->content;
    settle(x);
    return content->norm(content->owner, NV_DATA_S(x), NV_DATA_S(w));
}

/* Operations that CVODE uses before its first step only are SUNDIALS' own; no task is waiting then. */

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

static void op_add_const(N_Vector x, sunrealtype b, N_Vector z)
{
    settle(z);
    N_VAddConst_Serial(x, b, z);
}

static sunrealtype op_dot(N_Vector x, N_Vector y)
{
    settle(x);
    return N_VDotProd_Serial(x, y);
}

static sunrealtype op_largest(N_Vector x)
{
    settle(x);
    return N_VMaxNorm_Serial(x);
}

static sunrealtype op_least(N_Vector x)
{
    settle(x);
    return N_VMin_Serial(x);
}

/* ------------------------------------------------------------------------------------------ life */

/* Adds to the family's list; 0 if there is no memory. */
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

/* Operations that are not replaced would read numbers that are still to be computed: they are removed. */
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
    /* the serial vector provides its other operations; its content is replaced by ours, which begins with it */
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
                      int (*solve)(SUNLinearSolver, SUNMatrix, N_Vector, N_Vector, sunrealtype), SUNContext context)
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

/* ------------------------------------------------------------------------------------------ messages */

enum { MESSAGE_LENGTH = 256 };

/* CVODE's last message goes to `message`, and not to the standard error. messages_keep returns 0: no memory. */
#if SUNDIALS_VERSION_MAJOR < 7
static void message_keep(int code, const char *module, const char *function, char *text, void *message)
{
    (void)code, (void)module, (void)function;
    snprintf(message, MESSAGE_LENGTH, "%s", text);
}

static int messages_keep(SUNContext context, void *cvode, char message[MESSAGE_LENGTH])
{
    (void)context;
    return CVodeSetErrHandlerFn(cvode, message_keep, message) == CV_SUCCESS;
}
#else
static void message_keep(int line, const char *function, const char *file, const char *text, SUNErrCode code,
                         void *message, SUNContext context)
{
    (void)line, (void)function, (void)file, (void)code, (void)context;
    snprintf(message, MESSAGE_LENGTH, "%s", text ? text : "");
}

/* SUNDIALS calls all handlers of a context, its own among them. */
static int messages_keep(SUNContext context, void *cvode, char message[MESSAGE_LENGTH])
{
    (void)cvode;
    return !SUNContext_ClearErrHandlers(context) && !SUNContext_PushErrHandler(context, message_keep, message);
}
#endif

enum { STALLED_MOST = 20 };

/* Change of gamma that requires a new matrix (CVODE's default: 0.3): with sliding contacts CVODE accepts a single
 * iteration long after a matrix has become poor, and steps that grow by a few per cent are rare. */
static const double GAMMA_CHANGE = 0.005;

struct Integrator {
    Motion *motion;
    double *y;
    double *weight;         /* [size] 1 / absolute tolerance */
    const double *weighted; /* CVODE's array that already has them; NULL: none */
    double way;             /* m, largest motion of the chain per step; INFINITY: unlimited */
    double speed, speed_at; /* m/s, of the chain before the last step; s, its time, < 0: none */
    double stop;            /* s, the stop time set in CVODE */
    double bound;           /* s, longest step, 0: unlimited (integrator_bound) */
    double gamma;           /* s, of the factored matrix */
    int stalled, lack;      /* steps in a row that were too small to change t; 1: no memory for the matrix */
    int still;              /* integrator_prepare: rates are zero and nothing is computed */
    Esdirk *esdirk;         /* NULL: CVODE integrates, and everything below exists */
    void *cvode;
    SUNContext context;
    VectorFamily family; /* every vector that CVODE has made */
    N_Vector state;
    N_Vector good; /* the state of the last good step */
    CustomLinear linear;
    ContactNewton newton;
    IntegratorStats stats;
    IntegratorStats before;         /* CVODE's counts from before its last restart */
    char complaint[MESSAGE_LENGTH]; /* CVODE's last message */
};

/* ---------------------------------------------------------------- CVODE's call-backs; `user` is the Integrator */

static int call_rates(sunrealtype t, N_Vector y, N_Vector ydot, void *user)
{
    Integrator *const in = user;
    const double start = clock_now();
    if (in->still) {
        N_VConst(0, ydot);
        return 0;
    }
    const int bad = in->motion->ops->rates(in->motion, t, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
    in->stats.rhs += clock_now() - start;
    return bad; /* > 0: a smaller step may succeed */
}

static int call_weights(N_Vector y, N_Vector weight, void *user)
{
    (void)y;
    Integrator *const in = user;
    double *const data = NV_DATA_S(weight); /* no task waits for it */
    if (data != in->weighted) memcpy(data, in->weight, (size_t)in->motion->size * sizeof(double));
    in->weighted = data;
    return 0;
}

/* CVODE's setup: new blocks on request, the matrix for this gamma always. */
static int call_system(sunrealtype t, N_Vector y, N_Vector fy, SUNMatrix a, sunbooleantype jok, sunbooleantype *jcur,
                       sunrealtype gamma, void *user, N_Vector t1, N_Vector t2, N_Vector t3)
{
    (void)a, (void)t1, (void)t2, (void)t3;
    Integrator *const in = user;
    const double start = clock_now();
    *jcur = !jok;
    if (in->still) return 0;
    if (!jok) {
        in->motion->ops->linearise(in->motion, t, N_VGetArrayPointer(y), N_VGetArrayPointer(fy));
        ++in->stats.jac_evals;
    }
    in->gamma = gamma;
    in->motion->ops->form(in->motion, gamma);
    in->stats.jacobian += clock_now() - start;
    return 0;
}

static int call_projection(sunrealtype t, N_Vector y, N_Vector correction, sunrealtype tolerance, N_Vector error,
                           void *user)
{
    (void)t, (void)tolerance;
    const Integrator *const in = user;
    in->motion->ops->project(in->motion, N_VGetArrayPointer(y), N_VGetArrayPointer(correction),
                             error ? N_VGetArrayPointer(error) : NULL);
    return 0;
}

static double call_norm(const void *owner, const double *x, const double *w)
{
    const Motion *const motion = owner;
    return motion->ops->norm(motion, x, w);
}

/* ----------------------------------------------------------- the Newton matrix in SUNDIALS' clothes (SUNDIALS custom)
 */

static int solver_setup(SUNLinearSolver s, SUNMatrix a)
{
    (void)a;
    Integrator *const in = s->content;
    const double start = clock_now();
    if (in->still) return 0;
    const int status = matrix_factor(in->motion, !in->newton.fresh);
    in->stats.factor += clock_now() - start;
    return custom_linear_told(status, &in->lack);
}

static int solver_solve(SUNLinearSolver s, SUNMatrix a, N_Vector x, N_Vector b, sunrealtype tolerance)
{
    (void)a, (void)tolerance;
    Integrator *const in = s->content;
    const double start = clock_now();
    if (x != b) vector_take(x, b); /* CVODE continues by copying x to b */
    if (in->still) return 0;
    const int status = in->motion->ops->solve(in->motion, N_VGetArrayPointer(x));
    in->stats.solve += clock_now() - start;
    return custom_linear_told(status, &in->lack);
}

static int solvers_attach(Integrator *in)
{
    if (!custom_linear_new(&in->linear, in, solver_setup, solver_solve, in->context)) return 0;
    if (!contact_newton_new(&in->newton, in->state)) return 0;
    return CVodeSetLinearSolver(in->cvode, in->linear.solver, in->linear.matrix) == CV_SUCCESS &&
           CVodeSetLinSysFn(in->cvode, call_system) == CV_SUCCESS &&
           CVodeSetNonlinearSolver(in->cvode, in->newton.shell) == CV_SUCCESS;
}

/* ------------------------------------------------------------------------------------------------- life */

/* s; 0: unlimited, as in CVODE. */
static double longest_step(const Integrator *in)
{
    const SceneDef *const def = &in->motion->scene->def;
    const double given = def->solver.max_step > 0 ? def->solver.max_step : def->output.interval;
    return in->bound > 0 ? fmin(in->bound, given) : given;
}

static int cvode_set(Integrator *in)
{
    const SolverDef *const def = &in->motion->scene->def.solver;
    void *const c = in->cvode;
    int bad = CVodeSetUserData(c, in);
    bad |= CVodeWFtolerances(c, call_weights);
    bad |= CVodeSetMaxOrd(c, def->max_order);
    bad |= CVodeSetMaxNumSteps(c, -1);
    bad |= CVodeSetNonlinConvCoef(c, scales_newton_share(in->motion->scene));
    bad |= CVodeSetDeltaGammaMaxLSetup(c, GAMMA_CHANGE);
    if (in->motion->ops->project) bad |= CVodeSetProjFn(c, call_projection);
    bad |= CVodeSetMaxStep(c, longest_step(in));
    if (def->first_step > 0) bad |= CVodeSetInitStep(c, def->first_step);
    return !bad && solvers_attach(in);
}

/* Stores the present state so that the integrator can return to it. */
static void state_keep(Integrator *in)
{
    N_VScale(1.0, in->state, in->good);
    vector_family_settle(&in->family); /* from here on the numbers are read */
}

/* The vector of CVODE's history (Nordsieck's array: the state and its scaled derivatives) that is the state: CVODE
 * predicts in place and returns its address. NULL if it does not. */
static N_Vector history_state(const Integrator *in)
{
    sunrealtype t, gamma, rl1;
    N_Vector predicted = NULL, now, rates, first;
    void *user;
    const int flag = CVodeGetNonlinearSystemData(in->cvode, &t, &predicted, &now, &rates, &gamma, &rl1, &first, &user);
    return flag == CV_SUCCESS ? predicted : NULL;
}

/* Checks that reshaping can rely on history_state: when CVODE starts, that vector is a copy of the state and not one of
 * ours. A version of SUNDIALS without this property must not be used: cmake/sundials_version.cmake. */
static hawser_status history_check(Integrator *in, hawser_error *err)
{
    N_Vector v = history_state(in);
    vector_family_settle(&in->family);
    if (v && v != in->state && !memcmp(NV_DATA_S(v), in->y, (size_t)in->motion->size * sizeof(double)))
        return HAWSER_OK;
    char version[32] = "of unknown version";
    SUNDIALSGetVersion(version, sizeof version);
    return error_set(err, HAWSER_ERR_RUN,
                     "SUNDIALS %s does not show the integrator's history as this program needs it: build hawser with a "
                     "supported version (cmake/sundials_version.cmake)",
                     version);
}

/* Largest number of vectors that CVODE creates at setup: Nordsieck's array up to order 5, weights, corrections and
 * scratch, those of its solvers. */
enum { VECTORS_MOST = 24 };

/* Bytes sufficient for SUNContext_Create. */
enum { CONTEXT_ROOM = 1 << 14 };

/* Returns 0 if there is no memory. If CVodeInit runs out of memory it destroys the vectors that it has created, and
 * CVodeFree would destroy them again: only its own structure is freed then. */
static int cvode_new(Integrator *in, double t)
{
    in->cvode = CVodeCreate(CV_BDF, in->context);
    if (!in->cvode) return 0;
    if (messages_keep(in->context, in->cvode, in->complaint) &&
        CVodeInit(in->cvode, call_rates, t, in->state) == CV_SUCCESS)
        return 1;
    free(in->cvode);
    in->cvode = NULL;
    return 0;
}

/* Returns 0 if there is no memory. SUNContext_Create does not check whether its logger has memory. */
static int integrator_start(Integrator *in, double t)
{
    const int length = in->motion->size;
    if (!memory_room(CONTEXT_ROOM) || SUNContext_Create(SUN_COMM_NULL, &in->context)) return 0;
    in->family.queue = (VectorQueue){.team = in->motion->team, .pitch = &in->motion->pitch};
    in->state = vector_wrap(length, in->y, call_norm, in->motion, &in->family, in->context);
    if (!in->state || !vector_family_stock(in->state, VECTORS_MOST)) return 0;
    if (!cvode_new(in, t)) return 0;
    in->good = vector_clone(in->state);
    if (!in->good) return 0;
    state_keep(in);
    const int set = cvode_set(in);
    vector_family_unstock(&in->family);
    return set;
}

/* Sets weights and creates the chosen method. */
static hawser_status method_start(Integrator *in, double t, hawser_error *err)
{
    const Scene *const scene = in->motion->scene;
    in->weight = malloc((size_t)in->motion->size * sizeof(double));
    if (!in->weight) return error_memory(err);
    in->motion->ops->weights(in->motion, in->weight);
    if (scene->def.solver.method != METHOD_ESDIRK)
        return integrator_start(in, t) ? history_check(in, err) : error_memory(err);
    in->esdirk = esdirk_new(in->motion, in->y, in->weight, scales_newton_share(scene), longest_step(in), &in->stats);
    return in->esdirk ? HAWSER_OK : error_memory(err);
}

/* NOLINTNEXTLINE(readability-non-const-parameter): every step writes it */
hawser_status integrator_new(Motion *motion, double t, double *y, Integrator **out, hawser_error *err)
{
    Integrator *in = calloc(1, sizeof *in);
    *out = in;
    if (!in) return error_memory(err);
    *in = (Integrator){.motion = motion, .y = y, .way = stride_most(motion->scene), .stop = -1, .speed_at = -1};
    const hawser_status status = method_start(in, t, err);
    if (status) *out = integrator_free(in);
    return status;
}

Integrator *integrator_free(Integrator *in)
{
    if (!in) return NULL;
    esdirk_free(in->esdirk);
    if (in->cvode) CVodeFree(&in->cvode);
    contact_newton_free(&in->newton);
    custom_linear_free(&in->linear);
    vector_family_unstock(&in->family);
    if (in->good) N_VDestroy(in->good);
    if (in->state) N_VDestroy(in->state);
    if (in->context) SUNContext_Free(&in->context);
    vector_family_clear(&in->family);
    free(in->weight);
    free(in);
    return NULL;
}

/* They are in CVODE's history: Nordsieck's array has h y' beside y. */
const double *integrator_rates(Integrator *in, double *h)
{
    sunrealtype t, gamma, rl1;
    N_Vector predicted, now, rates, first = NULL;
    void *user;
    if (in->esdirk) {
        *h = 1;
        return esdirk_rates(in->esdirk);
    }
    CVodeGetLastStep(in->cvode, h);
    CVodeGetNonlinearSystemData(in->cvode, &t, &predicted, &now, &rates, &gamma, &rl1, &first, &user);
    return N_VGetArrayPointer(first);
}

/* ------------------------------------------------------------------------------------------------ stepping */

static long steps_made(const Integrator *in)
{
    IntegratorStats stats;
    integrator_stats(in, &stats);
    return stats.steps;
}

/* s; 0 before the first one */
static double step_next(const Integrator *in)
{
    double step = 0;
    if (in->esdirk) return esdirk_next(in->esdirk);
    CVodeGetCurrentStep(in->cvode, &step);
    return step;
}

int integrator_worst(Integrator *in)
{
    if (in->esdirk) return in->motion->ops->worst(in->motion, esdirk_error(in->esdirk), in->weight);
    N_Vector error = vector_clone(in->state);
    int worst = 0;
    if (error && CVodeGetEstLocalErrors(in->cvode, error) == CV_SUCCESS) {
        worst = in->motion->ops->worst(in->motion, N_VGetArrayPointer(error), in->weight);
    }
    if (error) N_VDestroy(error);
    return worst;
}

static StepFailure failure_at(Integrator *in, double t)
{
    return (StepFailure){.motion = in->motion,
                         .y = in->y,
                         .t = t,
                         .step = step_next(in),
                         .segment = integrator_worst(in),
                         .method = in->esdirk ? "ESDIRK" : "CVODE",
                         .complaint = in->complaint};
}

static hawser_status step_failed(Integrator *in, int flag, double t, hawser_error *err)
{
    const StepFailure failure = failure_at(in, t);
    if (in->good) N_VScale(1.0, in->good, in->state);
    vector_family_settle(&in->family); /* which has no members if CVODE is not used */
    return in->lack || flag == CV_MEM_FAIL ? error_memory(err) : failure_tell(&failure, flag, err);
}

/* Checks whether solver.max_steps, if given, is used up. */
static int steps_spent(const Integrator *in)
{
    const long limit = in->motion->scene->def.solver.max_steps;
    return limit > 0 && steps_made(in) >= limit;
}

/* End of the step from t: `stop`, or less if the chain would move too far before it (N14), (N15). Before the first step
 * CVODE reports a length of 0; a chain at rest moves little in that step. */
static double stride_end(Integrator *in, double t, double stop)
{
    if (!(in->way < INFINITY)) return stop;
    double step = step_next(in);
    const double speed = in->motion->ops->speed(in->motion, in->y), since = t - in->speed_at;
    const double growth = in->speed_at >= 0 && since > 0 ? fmax(0, (speed - in->speed) / since)
                                                         : v3_norm(in->motion->scene->weight.gravity);
    const double longest = stride_longest(in->way, speed, growth);
    in->speed = speed;
    in->speed_at = t;
    if (!(step > 0) && speed > 0) step = INFINITY;
    if (!(step > longest) || !(t + longest > t) || !(t + longest < stop)) return stop;
    ++in->stats.strides;
    return t + longest;
}

/* `end`, or earlier if the step would be longer than allowed: CVODE itself keeps the limit up to rounding then. */
static double bounded_end(Integrator *in, double t, double end)
{
    static const double ROUNDING = 1e-6;
    const double step = step_next(in);
    return in->bound > 0 && step > (1 + ROUNDING) * in->bound ? fmin(end, t + in->bound) : end;
}

/* Makes one step of the method and returns as CVode does: 0 or more, or an error. */
static int method_step(Integrator *in, double stop, double end, double *reached)
{
    static const int flag[] = {
        [ESDIRK_DONE] = CV_SUCCESS,           [ESDIRK_NO_RATES] = CV_RHSFUNC_FAIL, [ESDIRK_NO_NEWTON] = CV_CONV_FAILURE,
        [ESDIRK_NO_FACTORS] = CV_LSETUP_FAIL, [ESDIRK_NO_MEMORY] = CV_MEM_FAIL,    [ESDIRK_INEXACT] = CV_ERR_FAILURE,
        [ESDIRK_STUCK] = CV_TOO_CLOSE};
    if (in->esdirk) return flag[esdirk_step(in->esdirk, end, reached)];
    if (end > in->stop || end < in->stop) {
        CVodeSetStopTime(in->cvode, end);
        in->stop = end;
    }
    const int done = CVode(in->cvode, stop, in->state, reached, CV_ONE_STEP);
    if (done >= 0) state_keep(in);
    return done;
}

hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err)
{
    if (steps_spent(in)) {
        const StepFailure failure = failure_at(in, *t);
        return failure_steps_spent(&failure, err);
    }
    const double end = bounded_end(in, *t, stride_end(in, *t, stop));
    const double start = clock_now();
    double reached = *t;
    const int flag = method_step(in, stop, end, &reached);
    if (flag < 0) return step_failed(in, flag, *t, err);
    in->stalled = reached > *t ? 0 : in->stalled + 1;
    if (in->stalled >= STALLED_MOST) return step_failed(in, CV_TOO_CLOSE, *t, err);
    *t = reached;
    const hawser_status status = in->motion->ops->accept(in->motion, reached, in->y, err);
    in->stats.total += clock_now() - start;
    return status;
}

/* One-step methods damp oscillations so little that they need no bound (OS11). */
void integrator_bound(Integrator *in, double longest)
{
    if (in->esdirk) return;
    in->bound = longest;
    CVodeSetMaxStep(in->cvode, longest_step(in));
}

/* ---------------------------------------------------------------------------------------------- a new shape */

typedef struct ReshapeCall {
    const Reshape *reshape;
    N_Vector history_state;
} ReshapeCall;

/* (RL17) */
static void call_map(const void *user, N_Vector which, const double *from, double *to)
{
    const ReshapeCall *const call = user;
    call->reshape->map(call->reshape->user, which == call->history_state, from, to);
}

/* Renews the arrays beside CVODE's vectors; 0 if there is no memory. */
static int arrays_renew(Integrator *in, const Reshape *reshape)
{
    double *const weight = malloc((size_t)reshape->size * sizeof(double));
    if (!weight) return 0;
    free(in->weight);
    in->weight = weight;
    in->weighted = NULL;
    in->y = reshape->y;
    in->motion->ops->weights(in->motion, weight);
    return 1;
}

/* Makes Newton's matrix at (t, y) for the step for which CVODE assumes it was made: CVODE does not know that it is
 * new. */
static int matrix_renew(Integrator *in, double t)
{
    const double start = clock_now();
    double *const rates = malloc((size_t)in->motion->size * sizeof(double));
    if (!rates) return -1;
    int bad = in->motion->ops->rates(in->motion, t, in->y, rates);
    if (!bad) {
        in->motion->ops->linearise(in->motion, t, in->y, rates);
        in->motion->ops->form(in->motion, in->gamma);
        bad = in->motion->ops->factor(in->motion);
        ++in->stats.jac_evals;
    }
    free(rates);
    in->stats.jacobian += clock_now() - start;
    return bad;
}

hawser_status integrator_reshape(Integrator *in, double t, const Reshape *reshape, hawser_error *err)
{
    const double start = clock_now();
    assert(in->motion->size == reshape->size);
    if (in->esdirk) {
        const int made = arrays_renew(in, reshape) && esdirk_reshape(in->esdirk, reshape, in->weight);
        return made ? HAWSER_OK : error_memory(err);
    }
    const ReshapeCall call = {reshape, history_state(in)};
    if (!vector_family_resize(&in->family, reshape->size, reshape->y, call_map, &call) || !arrays_renew(in, reshape))
        return error_memory(err);
    state_keep(in);
    /* without its history the method has to restart; so it must before its first step, when it has none */
    long steps = 0;
    CVodeGetNumSteps(in->cvode, &steps);
    double last = 0;
    CVodeGetLastStep(in->cvode, &last);
    int bad = 0;
    if (reshape->forget || steps == 0) {
        IntegratorStats so_far;
        integrator_stats(in, &so_far);
        in->before = so_far;
        bad = CVodeReInit(in->cvode, t, in->state) != CV_SUCCESS;
        if (last > 0) bad |= CVodeSetInitStep(in->cvode, last / 10) != CV_SUCCESS;
        in->stop = -1;
    } else {
        bad = matrix_renew(in, t);
    }
    in->stats.total += clock_now() - start;
    if (bad < 0) return error_memory(err);
    return bad ? error_set(err, HAWSER_ERR_RUN, "no equations of motion at t = %.6g s, where the chain has changed", t)
               : HAWSER_OK;
}

hawser_status integrator_renew(Integrator **in, Motion *motion, double t, double *y, hawser_error *err)
{
    Integrator *fresh;
    const hawser_status status = integrator_new(motion, t, y, &fresh, err);
    if (status) return status;
    integrator_stats(*in, &fresh->before);
    integrator_go_on(fresh, &fresh->before);
    integrator_free(*in);
    *in = fresh;
    return HAWSER_OK;
}

void integrator_go_on(Integrator *in, const IntegratorStats *so_far) { in->before = in->stats = *so_far; }

void integrator_stats(const Integrator *in, IntegratorStats *stats)
{
    const IntegratorStats *const before = &in->before;
    *stats = in->stats;
    if (in->esdirk) return; /* it keeps its own counts */
    cvode_counts(in->cvode, stats);
    CVodeGetLastStep(in->cvode, &stats->last_step);
    stats->steps += before->steps;
    stats->rhs_evals += before->rhs_evals;
    stats->newton_iters += before->newton_iters;
    stats->lin_setups += before->lin_setups;
    stats->error_fails += before->error_fails;
    stats->newton_fails += before->newton_fails;
}

/* ------------------------------------------------------------------------------------------------- checkpoints */

int integrator_known(const Integrator *in, const char **why)
{
    return in->esdirk || cvode_memory_known(in->cvode, why);
}

hawser_status integrator_prepare(Integrator *in, double t, hawser_error *err)
{
    const char *why;
    double reached;
    long steps = 0;
    if (in->esdirk) return HAWSER_OK;
    CVodeGetNumSteps(in->cvode, &steps);
    if (steps > 0) return HAWSER_OK;
    in->still = 1;
    int flag = CVodeSetInitStep(in->cvode, 1);
    if (flag == CV_SUCCESS) flag = CVode(in->cvode, t + 1, in->state, &reached, CV_ONE_STEP);
    in->still = 0;
    vector_family_settle(&in->family);
    if (flag < 0) return error_set(err, HAWSER_ERR_RUN, "the integrator cannot be set up: %s", in->complaint);
    return integrator_known(in, &why) ? HAWSER_OK : error_set(err, HAWSER_ERR_RUN, "%s", why);
}

void integrator_checkpoint(Checkpoint *c, Integrator *in)
{
    N_Vector history[CVODE_HISTORY_MAX];
    const size_t bytes = (size_t)in->motion->size * sizeof(double);
    vector_family_settle(&in->family);
    CHECKPOINT(c, in->way);
    CHECKPOINT(c, in->speed);
    CHECKPOINT(c, in->speed_at);
    CHECKPOINT(c, in->stop);
    CHECKPOINT(c, in->bound);
    CHECKPOINT(c, in->gamma);
    CHECKPOINT(c, in->newton.rate);
    CHECKPOINT(c, in->stalled);
    CHECKPOINT(c, in->stats);
    CHECKPOINT(c, in->before);
    checkpoint_counts(c, 1, &in->stalled);
    counts_check(c, &in->stats);
    counts_check(c, &in->before);
    if (in->esdirk) {
        esdirk_checkpoint(c, in->esdirk);
        return;
    }
    cvode_memory_checkpoint(c, in->cvode);
    if (c->status) return;
    const int n = cvode_memory_history(in->cvode, history);
    for (int k = 0; k < n; ++k) checkpoint_put(c, "history", NV_DATA_S(history[k]), bytes);
    if (!c->reading || c->status) return;
    CVodeSetMaxStep(in->cvode, longest_step(in));
    state_keep(in);
    in->weighted = NULL;
}
