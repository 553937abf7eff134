/* ARKODE's Runge-Kutta methods: explicit ones, and diagonally implicit ones with hawser's Newton matrix, norm and share
 * of the tolerance for Newton's iteration. */
#include <arkode/arkode_arkstep.h>
#include <math.h>
#include <nvector/nvector_serial.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "bench/methods/methods.h"
#include "bench/methods/own_linear.h"
#include "core/chain.h"
#include "sim/solve/integrator.h"

/* As the integrator has them: what Newton's iteration leaves is a share of the tolerance, and the same at any. */
static const double NEWTON_SHARE = 1e-3, NEWTON_SHARE_MOST = 0.1, NEWTON_LEFT = 3e-7, GAMMA_CHANGE = 0.05;
enum { ITERATIONS_MOST = 10, PREDICT_VARIABLE_ORDER = 2 };

typedef struct Ark {
    Problem *p;
    double *weight, *fixed; /* [size] */
    void *memory;
    SUNContext context;
    N_Vector y;
    OwnLinear own;
    long rhs;
} Ark;

static int call_rates(sunrealtype t, N_Vector y, N_Vector ydot, void *user)
{
    Ark *const a = user;
    ++a->rhs;
    return a->p->motion->ops->rates(a->p->motion, t, N_VGetArrayPointer(y), N_VGetArrayPointer(ydot));
}

static int call_weights(N_Vector y, N_Vector weight, void *user)
{
    (void)y;
    const Ark *const a = user;
    memcpy(N_VGetArrayPointer(weight), a->weight, (size_t)a->p->motion->size * sizeof(double));
    return 0;
}

static int call_system(sunrealtype t, N_Vector y, N_Vector fy, SUNMatrix a, SUNMatrix mass, sunbooleantype jok,
                       sunbooleantype *jcur, sunrealtype gamma, void *user, N_Vector t1, N_Vector t2, N_Vector t3)
{
    (void)a, (void)mass, (void)t1, (void)t2, (void)t3;
    return own_linear_system(&((Ark *)user)->own, t, y, fy, jok, jcur, gamma);
}

/* Quaternions of unit length after every step. */
static int call_after(sunrealtype t, N_Vector y, void *user)
{
    (void)t;
    const Ark *const a = user;
    const Motion *const motion = a->p->motion;
    if (!motion->ops->project) return 0;
    double *const data = N_VGetArrayPointer(y);
    motion->ops->project(motion, data, a->fixed, NULL);
    for (int i = 0; i < motion->size; ++i) data[i] += a->fixed[i];
    return 0;
}

static double call_norm(const void *owner, const double *x, const double *w)
{
    const Motion *const motion = owner;
    return motion->ops->norm(motion, x, w);
}

static void call_complaint(int code, const char *module, const char *function, char *message, void *user)
{
    (void)code, (void)module, (void)function, (void)message, (void)user;
}

static int implicit_set(Ark *a, int variant)
{
    void *const m = a->memory;
    const int own = variant < DIRK_DEFAULT;
    int bad = ARKStepSetTableNum(m, (ARKODE_DIRKTableID)(own ? variant : variant - DIRK_DEFAULT), ARKODE_ERK_NONE);
    bad |= !own_linear_new(&a->own, a->p->motion, a->context);
    bad |= ARKStepSetLinearSolver(m, a->own.linear.solver, a->own.linear.matrix);
    bad |= ARKStepSetLinSysFn(m, call_system);
    if (!own) return bad;
    bad |= ARKStepSetPredictorMethod(m, PREDICT_VARIABLE_ORDER);
    const double accuracy = a->p->stage.scene.def.solver.accuracy;
    bad |= ARKStepSetNonlinConvCoef(m, fmax(NEWTON_SHARE, fmin(NEWTON_LEFT / accuracy, NEWTON_SHARE_MOST)));
    bad |= ARKStepSetMaxNonlinIters(m, ITERATIONS_MOST);
    bad |= ARKStepSetDeltaGammaMax(m, GAMMA_CHANGE);
    bad |= ARKStepSetDeduceImplicitRhs(m, 1);
    return bad;
}

static int ark_start(Ark *a, Problem *p, int table, int implicit)
{
    const int size = p->motion->size;
    *a = (Ark){.p = p, .weight = aligned_array_new(size), .fixed = aligned_array_new(size)};
    if (!a->weight || !a->fixed || SUNContext_Create(NULL, &a->context)) return 0;
    p->motion->ops->weights(p->motion, a->weight);
    a->y = vector_wrap(size, p->stage.y, call_norm, p->motion, NULL, a->context);
    if (!a->y) return 0;
    a->memory = ARKStepCreate(implicit ? NULL : call_rates, implicit ? call_rates : NULL, p->from, a->y, a->context);
    if (!a->memory) return 0;
    void *const m = a->memory;
    int bad = ARKStepSetUserData(m, a) | ARKStepWFtolerances(m, call_weights) | ARKStepSetMaxNumSteps(m, -1);
    bad |= ARKStepSetErrHandlerFn(m, call_complaint, a) | ARKStepSetPostprocessStepFn(m, call_after);
    bad |= ARKStepSetMaxStep(m, p->stage.scene.def.output.interval);
    bad |= implicit ? implicit_set(a, table) : ARKStepSetTableNum(m, ARKODE_DIRK_NONE, (ARKODE_ERKTableID)table);
    return !bad;
}

static void ark_count(Ark *a, Counts *c)
{
    ARKStepGetNumSteps(a->memory, &c->steps);
    ARKStepGetNumNonlinSolvIters(a->memory, &c->iterations);
    ARKStepGetNumLinSolvSetups(a->memory, &c->setups);
    ARKStepGetNumErrTestFails(a->memory, &c->error_fails);
    ARKStepGetNumNonlinSolvConvFails(a->memory, &c->newton_fails);
    c->rhs = a->rhs;
    c->jacobians = a->own.jacobians;
}

static void ark_free(Ark *a)
{
    if (a->memory) ARKStepFree(&a->memory);
    own_linear_free(&a->own);
    if (a->y) N_VDestroy(a->y);
    if (a->context) SUNContext_Free(&a->context);
    free(a->weight);
    free(a->fixed);
}

static int run(Problem *p, const Choice *choice, int implicit, Walk *w)
{
    Ark a;
    p->stage.scene.def.solver.accuracy = choice->setting;
    walk_begin(w, p, choice->limit);
    const int ok = ark_start(&a, p, choice->variant, implicit);
    double t = p->from, stop = t;
    while (ok && t < p->to) {
        if (t >= stop) ARKStepSetStopTime(a.memory, stop = problem_stop(p, t));
        const int flag = ARKStepEvolve(a.memory, stop, a.y, &t, ARK_ONE_STEP);
        if (flag < 0) snprintf(w->why, sizeof w->why, "ARKODE's flag %d at t = %.4g s", flag, t);
        if (flag < 0 || walk_step(w, t, p->stage.y)) break;
    }
    walk_end(w);
    if (ok) ark_count(&a, &w->counts);
    ark_free(&a);
    return ok;
}

int run_erk(Problem *p, const Choice *choice, Walk *w) { return run(p, choice, 0, w); }
int run_dirk(Problem *p, const Choice *choice, Walk *w) { return run(p, choice, 1, w); }
