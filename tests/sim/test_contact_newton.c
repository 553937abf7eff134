/* Newton's iteration for contacts on equations of one unknown, (N17)-(N20): a contact that closes, a force that
 * saturates, an old matrix, an equation without a solution. The test stands in CVODE's place. */
#include "sim/solve/contact_newton.h"

#include <nvector/nvector_serial.h>

#include "tests/support/check.h"

/* r(e) and its slope. */
typedef struct Equation {
    double (*r)(double e);
    double (*slope)(double e);
    double matrix;        /* the slope that is factored */
    double at;            /* e of the last residual */
    int residuals, fresh; /* evaluated; matrices made inside the iteration */
} Equation;

static int residual(N_Vector e, N_Vector r, void *user)
{
    Equation *const q = user;
    q->at = NV_Ith_S(e, 0);
    NV_Ith_S(r, 0) = q->r(q->at);
    ++q->residuals;
    return !isfinite(NV_Ith_S(r, 0));
}

static int setup(sunbooleantype bad, sunbooleantype *current, void *user)
{
    Equation *const q = user;
    q->matrix = q->slope(q->at);
    q->fresh += bad;
    *current = SUNTRUE;
    return 0;
}

static int solve(N_Vector b, void *user)
{
    NV_Ith_S(b, 0) /= ((const Equation *)user)->matrix;
    return 0;
}

/* Where the iteration from e = 0 ends; *status is what it returns. `matrix`: it begins with this old one, 0: with its
 * own. */
static double solution(Equation *q, double matrix, double tolerance, int *status)
{
    SUNContext context;
    assert_int_equal(SUNContext_Create(SUN_COMM_NULL, &context), 0);
    N_Vector e = N_VNew_Serial(1, context), weight = N_VNew_Serial(1, context);
    ContactNewton newton;
    long failures = 0;
    assert_true(contact_newton_new(&newton, e));
    SUNNonlinearSolver shell = newton.shell;
    assert_int_equal(SUNNonlinSolSetSysFn(shell, residual), 0);
    assert_int_equal(SUNNonlinSolSetLSetupFn(shell, setup), 0);
    assert_int_equal(SUNNonlinSolSetLSolveFn(shell, solve), 0);
    N_VConst(0, e);
    N_VConst(1, weight);
    q->matrix = matrix;
    *status = SUNNonlinSolSolve(shell, e, e, weight, tolerance, matrix > 0 ? SUNFALSE : SUNTRUE, q);
    assert_int_equal(SUNNonlinSolGetNumConvFails(shell, &failures), 0);
    assert_int_equal(failures, *status != 0);
    const double found = NV_Ith_S(e, 0);
    contact_newton_free(&newton);
    N_VDestroy(e);
    N_VDestroy(weight);
    SUNContext_Free(&context);
    return found;
}

/* A mass that falls on a contact of Hertz' law, e = 0 is where it is off by 60 times its depth: m (e + 1) = k
 * depth^1.5, depth = -e - 0.1. */
static double hertz(double e)
{
    const double depth = -e - 0.1;
    return e + 1 - (depth > 0 ? 1e4 * pow(depth, 1.5) : 0);
}

static double hertz_slope(double e)
{
    const double depth = -e - 0.1;
    return 1 + (depth > 0 ? 1.5e4 * sqrt(depth) : 0);
}

/* The root by bisection. */
static double root_of(double (*r)(double), double low, double high)
{
    while (high - low > 1e-15) {
        const double middle = (low + high) / 2;
        if (r(low) * r(middle) <= 0) {
            high = middle;
        } else {
            low = middle;
        }
    }
    return low;
}

/* Its first step goes right through the contact; from there each leaves a third until the depth is met, then less. */
TEST(test_contact_closes)
{
    Equation q = {.r = hertz, .slope = hertz_slope};
    int status;
    check_close(solution(&q, 0, 1e-9, &status), root_of(hertz, -1, 0), 1e-9);
    assert_int_equal(status, 0);
    check_at_most(q.residuals, 16);
}

/* Friction that reverses: from where it is full Newton's step goes far beyond the other side. */
static double saturates(double e) { return atan(20 * (e - 1)) + 0.001 * e; }
static double saturates_slope(double e) { return 20 / (1 + 400 * (e - 1) * (e - 1)) + 0.001; }

TEST(test_damped)
{
    Equation q = {.r = saturates, .slope = saturates_slope};
    int status;
    /* undamped, e = 0 is thrown beyond e = 20, and from there farther */
    check_above(-saturates(0) / saturates_slope(0), 20);
    check_close(solution(&q, 0, 1e-9, &status), root_of(saturates, 0, 2), 1e-9);
    assert_int_equal(status, 0);
}

/* With a matrix that is off by s a linear equation's corrections shrink by 1 - 1/s: kept where that is quick, made anew
 * where it is not (N18). */
static double line(double e) { return e - 1; }
static double line_slope(double e)
{
    (void)e;
    return 1;
}

TEST(test_old_matrix)
{
    Equation quick = {.r = line, .slope = line_slope}, slow = quick, wrong = quick;
    int status;
    check_close(solution(&quick, 1.1, 1e-6, &status), 1, 1e-6); /* leaves 1/11 */
    assert_int_equal(status, 0);
    check_equal(quick.fresh, 0);
    check_close(solution(&slow, 2, 1e-6, &status), 1, 1e-6); /* a half */
    assert_int_equal(status, 0);
    check_equal(slow.fresh, 1);
    check_equal(slow.residuals, 3);
    check_close(solution(&wrong, 0.4, 1e-6, &status), 1, 1e-6); /* each is 1.5 times the one before */
    assert_int_equal(status, 0);
    check_equal(wrong.fresh, 1);
    /* what is nearly there is not worth a new one */
    Equation near = {.r = line, .slope = line_slope};
    check_close(solution(&near, 2, 0.05, &status), 1, 0.1);
    assert_int_equal(status, 0);
    check_equal(near.fresh, 0);
}

static double rootless(double e) { return e * e + 1; }
static double rootless_slope(double e) { return 2 * e + 0.01; }
static double nowhere(double e) { return e > 0.5 ? NAN : e - 1; }

TEST(test_given_up)
{
    Equation q = {.r = rootless, .slope = rootless_slope}, n = {.r = nowhere, .slope = line_slope};
    int status;
    solution(&q, 0, 1e-9, &status);
    assert_int_equal(status, SUN_NLS_CONV_RECVR);
    check_at_most(q.residuals, 80);
    solution(&n, 0, 1e-9, &status);
    assert_true(status > 0); /* a smaller step may do */
}
