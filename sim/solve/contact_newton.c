#include "sim/solve/contact_newton.h"

#include <math.h>

/* A matrix whose corrections leave more than SLOW of the error is made anew if it would need more than LEFT iterations:
 * a new one costs about four of them (N18). */
static const double SLOW = 0.2;
enum { LEFT = 3 };
/* The next correction must be at most this share of the last one, otherwise it diverges (N19). */
static const double FALLS = 0.75;
/* Share that CVODE keeps of the old estimate of the rate. */
static const double RATE_KEPT = 0.3;
enum { ITERATIONS_MOST = 20, HALVINGS_MOST = 6 };

/* One solution: its iterate, weights and tolerance. */
typedef struct Attempt {
    ContactNewton *c;
    N_Vector e, weight;     /* the correction to the predictor, which is the unknown */
    double tolerance, size; /* on the remaining error; norm of c->step */
    void *cvode;
} Attempt;

/* r at e. Where it is not finite, > 0. */
static int residual_at(const Attempt *a) { return a->c->residual(a->e, a->c->r, a->cvode); }

/* The correction by the present matrix at the last evaluation of r, and its norm. */
static int correction(const Attempt *a, N_Vector out, double *size)
{
    N_VScale(-1.0, a->c->r, out);
    const int bad = a->c->solve(out, a->cvode);
    *size = bad ? INFINITY : N_VWrmsNorm(out, a->weight);
    return bad;
}

/* Makes the matrix of the last evaluation of r. */
static int matrix_fresh(const Attempt *a)
{
    sunbooleantype current;
    a->c->rate = 1;
    a->c->fresh = 1;
    return a->c->setup(SUNTRUE, &current, a->cvode);
}

/* The correction that follows at e after the last one: its norm is INFINITY if there is none. < 0: stop. */
static int look_ahead(Attempt *a, double *next)
{
    *next = INFINITY;
    const int bad = residual_at(a);
    return bad ? bad : correction(a, a->c->next, next);
}

/* Accepts the last correction; the one after it becomes the next to make. */
static void go_on(Attempt *a, double next)
{
    ContactNewton *const c = a->c;
    N_Vector step = c->step;
    c->step = c->next;
    c->next = step;
    a->size = next;
}

/* The same with a new matrix, made at the last evaluation of r. */
static int go_on_fresh(Attempt *a)
{
    const int bad = matrix_fresh(a);
    return bad ? bad : correction(a, a->c->step, &a->size);
}

/* Returns to the start of the last correction, and continues from there with a new matrix. */
static int go_back(Attempt *a)
{
    N_VLinearSum(1.0, a->e, -1.0, a->c->step, a->e);
    const int bad = residual_at(a);
    return bad ? bad : go_on_fresh(a);
}

/* With a new matrix: tries half of the correction, a quarter..., until the residual falls as it should (N20). */
static int damp(Attempt *a)
{
    ContactNewton *const c = a->c;
    int bad = go_back(a);
    double made = 0, share = 0.5;
    for (int k = 0; !bad && k < HALVINGS_MOST && c->iterations < ITERATIONS_MOST; ++k, share /= 2) {
        double next;
        ++c->iterations;
        N_VLinearSum(1.0, a->e, share - made, c->step, a->e);
        made = share;
        if (look_ahead(a, &next) < 0) return SUN_ERR_EXT_FAIL;
        if (next <= (1 - share / 4) * a->size) return go_on_fresh(a);
    }
    return bad ? bad : SUN_NLS_CONV_RECVR;
}

/* After a correction was made: finds the next one by the rules (N18)-(N20). */
static int next_correction(Attempt *a)
{
    ContactNewton *const c = a->c;
    double next;
    int bad = look_ahead(a, &next);
    if (bad < 0) return bad;
    const double ratio = next / a->size;
    if (ratio <= FALLS) {
        c->rate = fmax(RATE_KEPT * c->rate, ratio);
        c->fresh = 0;
        const int slow =
            ratio > SLOW && next * fmin(1, c->rate) > a->tolerance && next * pow(ratio, LEFT) > a->tolerance;
        if (slow) return go_on_fresh(a);
        go_on(a, next);
        return 0;
    }
    if (!c->fresh) return go_back(a);
    if (next < INFINITY) {
        bad = matrix_fresh(a);
        if (!bad) bad = correction(a, c->next, &next);
        if (bad < 0) return bad;
        if (!bad && next <= a->size) {
            go_on(a, next);
            return 0;
        }
    }
    return damp(a);
}

/* Iterates from e = 0 to the solution. The test of convergence is CVODE's, without its rule that a doubled correction
 * is divergence. */
static int iterate(Attempt *a, int setup)
{
    ContactNewton *const c = a->c;
    c->iterations = c->failures = 0;
    c->fresh = 0;
    int bad = residual_at(a);
    if (bad) return bad;
    if (setup) {
        sunbooleantype current = SUNFALSE;
        bad = c->setup(SUNFALSE, &current, a->cvode);
        c->fresh = current;
        c->rate = 1;
    }
    if (!bad) bad = correction(a, c->step, &a->size);
    while (!bad && a->size < INFINITY) {
        N_VLinearSum(1.0, a->e, 1.0, c->step, a->e);
        ++c->iterations;
        if (a->size * fmin(1, c->rate) <= a->tolerance) return 0;
        if (c->iterations >= ITERATIONS_MOST) break;
        bad = next_correction(a);
    }
    if (bad < 0) return bad;
    c->failures = 1;
    return SUN_NLS_CONV_RECVR;
}

/* ------------------------------------------------------------------------------------ as a SUNDIALS solver */

static int solve_step(SUNNonlinearSolver shell, N_Vector predicted, N_Vector e, N_Vector weight, sunrealtype tolerance,
                      sunbooleantype setup, void *cvode)
{
    (void)predicted;
    ContactNewton *const c = shell->content;
    Attempt a = {.c = c, .e = e, .weight = weight, .tolerance = tolerance, .cvode = cvode};
    const int status = iterate(&a, setup);
    return status;
}

static ContactNewton *newton_of(SUNNonlinearSolver shell) { return shell->content; }

static SUNNonlinearSolver_Type solver_type(SUNNonlinearSolver shell)
{
    (void)shell;
    return SUNNONLINEARSOLVER_ROOTFIND;
}

static int set_residual(SUNNonlinearSolver shell, SUNNonlinSolSysFn residual)
{
    newton_of(shell)->residual = residual;
    return 0;
}

static int set_setup(SUNNonlinearSolver shell, SUNNonlinSolLSetupFn setup)
{
    newton_of(shell)->setup = setup;
    return 0;
}

static int set_solve(SUNNonlinearSolver shell, SUNNonlinSolLSolveFn solve)
{
    newton_of(shell)->solve = solve;
    return 0;
}

static int get_iterations(SUNNonlinearSolver shell, long *count)
{
    *count = newton_of(shell)->iterations;
    return 0;
}

static int get_failures(SUNNonlinearSolver shell, long *count)
{
    *count = newton_of(shell)->failures;
    return 0;
}

int contact_newton_new(ContactNewton *newton, N_Vector like)
{
    *newton = (ContactNewton){.shell = SUNNonlinSolNewEmpty(like->sunctx),
                              .r = N_VClone(like),
                              .step = N_VClone(like),
                              .next = N_VClone(like),
                              .rate = 1};
    if (!newton->shell || !newton->r || !newton->step || !newton->next) return 0;
    struct _generic_SUNNonlinearSolver_Ops *const ops = newton->shell->ops;
    ops->gettype = solver_type;
    ops->solve = solve_step;
    ops->setsysfn = set_residual;
    ops->setlsetupfn = set_setup;
    ops->setlsolvefn = set_solve;
    ops->getnumiters = get_iterations;
    ops->getnumconvfails = get_failures;
    newton->shell->content = newton;
    return 1;
}

void contact_newton_free(ContactNewton *newton)
{
    if (newton->r) N_VDestroy(newton->r);
    if (newton->step) N_VDestroy(newton->step);
    if (newton->next) N_VDestroy(newton->next);
    if (newton->shell) SUNNonlinSolFreeEmpty(newton->shell);
    *newton = (ContactNewton){0};
}
