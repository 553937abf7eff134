/* The part of a chain that is simulated: arrays copied out of the whole chain's, and vectors mapped as segments come
 * and go. */
#include "sim/run/stage.h"
#include "sim/solve/integrator.h"

#include "tests/support/chain.h"
#include "tests/support/check.h"

enum { WHOLE = 9, SLIDERS = 2 };

/* A chain whose every entry is a number of its own. */
static void numbered_chain(Chain *c)
{
    assert_true(chain_alloc(c, WHOLE) && chain_alloc_sliders(c, SLIDERS));
    for (int i = 0; i <= WHOLE; ++i) {
        c->half[i] = i < WHOLE ? 0.1 + i : 0;
        c->mass[i] = 100 + i;
        c->radius[i] = 0.01 * i;
        for (int k = 0; k < 3; ++k) c->inertia[k][i] = 1000 * k + i;
        for (int k = 0; k < 6; ++k) {
            c->stiffness[k][i] = 10 * k + i + 1;
            c->damping[k][i] = 20 * k + i + 1;
            c->preload[k][i] = 30 * k + i + 1;
        }
        for (int k = 0; k < SLIDERS; ++k) {
            c->sliders.stiffness[k][i] = 40 * k + i + 1;
            c->sliders.limit[k][i] = 50 * k + i + 1;
        }
    }
}

/* Segments first .. first + n - 1 with their joints; the tail's joint is free, the head's and what lies beyond are
 * those of the whole chain. */
TEST(test_chain)
{
    Chain whole, window;
    numbered_chain(&whole);
    for (int first = 0; first < WHOLE; first += 3) {
        for (int n = 1; first + n <= WHOLE; n += 2) {
            assert_true(window_chain(&whole, first, n, &window));
            assert_int_equal(window.n, n);
            assert_int_equal(window.sliders.count, SLIDERS);
            for (int i = 0; i <= n; ++i) {
                const int free = i == 0 && first > 0;
                check_close(window.half[i], whole.half[first + i], 1e-15);
                check_close(window.mass[i], whole.mass[first + i], 1e-15);
                for (int k = 0; k < 6; ++k) {
                    check_close(window.stiffness[k][i], free ? 0 : whole.stiffness[k][first + i], 1e-15);
                    check_close(window.damping[k][i], free ? 0 : whole.damping[k][first + i], 1e-15);
                    check_close(window.preload[k][i], free ? 0 : whole.preload[k][first + i], 1e-15);
                }
                for (int k = 0; k < SLIDERS; ++k) {
                    const double spring = free ? 0 : whole.sliders.stiffness[k][first + i];
                    check_close(window.sliders.stiffness[k][i], spring, 1e-15);
                    check_close(window.sliders.limit[k][i], whole.sliders.limit[k][first + i], 1e-15);
                }
            }
            window_end(&whole, &window);
            check_close(window.half[n], 0, 1e-15);
            check_close(window.stiffness[0][n], whole.stiffness[0][WHOLE], 1e-15);
            chain_free(&window);
        }
    }
    chain_free(&whole);
}

/* 13 arrays of n and a tail of other numbers: what stays is copied, the new row is a copy of the tail's, scaled, and
 * shifted in the state only. */
TEST(test_map)
{
    enum { N = 5, EXTRA = 4 };
    double from[STATE_SIZE * N + EXTRA], to[STATE_SIZE * (N + 1) + EXTRA];
    for (int k = 0; k < STATE_SIZE * N + EXTRA; ++k) from[k] = 1 + k;
    for (int c = 0; c < 8; ++c) {
        const int joined = c & 1, left = c >> 1 & 1, is_state = c >> 2;
        WindowMove m = window_move(N, joined, left);
        assert_int_equal(m.to, N + joined - left);
        for (int k = 0; k < STATE_SIZE; ++k) {
            m.scale[k] = 1 + 0.1 * k;
            m.offset[k] = 7 * k;
        }
        window_map(&m, EXTRA, is_state, from, to);
        for (int k = 0; k < STATE_SIZE; ++k) {
            for (int i = 0; i < m.to - joined; ++i) check_close(to[k * m.to + joined + i], from[k * N + i], 1e-15);
            const double row = m.scale[k] * from[k * N] + (is_state ? m.offset[k] : 0);
            if (joined) check_close(to[k * m.to], row, 1e-12);
        }
        for (int k = 0; k < EXTRA; ++k) check_close(to[STATE_SIZE * m.to + k], from[STATE_SIZE * N + k], 1e-15);
    }
}

static double no_norm(const void *owner, const double *x, const double *w)
{
    (void)owner;
    return x[0] + w[0];
}

/* Twice the first entry, whatever the length. */
static void double_first(const void *user, N_Vector which, const double *from, double *to)
{
    (void)which;
    for (int k = 0; k < *(const int *)user; ++k) to[k] = 2 * from[0];
}

/* All clones of a vector, and their clones, change their length; those that are gone are forgotten. */
TEST(test_family)
{
    SUNContext context;
    VectorFamily family = {0};
    double data[3] = {1, 2, 3}, longer[5] = {9, 8, 7, 6, 5};
    const int length = 5;
    assert_int_equal(SUNContext_Create(SUN_COMM_NULL, &context), 0);
    N_Vector v = vector_wrap(3, data, no_norm, NULL, &family, context), a = N_VClone(v), b = N_VClone(a);
    assert_true(v && a && b);
    assert_int_equal(family.n, 3);
    N_VConst(4, a);
    N_VConst(5, b);
    N_VDestroy(b);
    assert_int_equal(family.n, 2);
    assert_true(vector_family_resize(&family, length, longer, double_first, &length));
    assert_int_equal(N_VGetLength(a), 5);
    assert_int_equal(N_VGetLength(v), 5);
    assert_ptr_equal(N_VGetArrayPointer(v), longer);
    for (int k = 0; k < 5; ++k) check_close(N_VGetArrayPointer(a)[k], 8, 1e-15);
    N_VLinearSum(1, a, 1, v, a); /* the kernels know of it */
    check_close(N_VGetArrayPointer(a)[4], 13, 1e-15);
    N_VDestroy(a);
    N_VDestroy(v);
    assert_int_equal(family.n, 0);
    vector_family_clear(&family);
    SUNContext_Free(&context);
}
