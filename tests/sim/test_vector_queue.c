/* Operations on vectors that wait do what they would have done at once, to the last bit, with one thread and two. */
#include "sim/solve/integrator.h"
#include "tests/support/check.h"

#include <math.h>
#include <nvector/nvector_serial.h>
#include <string.h>

enum { LENGTH = 30011, VECTORS = 5 };

/* The largest of |x w|. */
static double largest(const void *owner, const double *x, const double *w)
{
    double most = 0;
    for (int i = 0; i < *(const int *)owner; ++i) most = larger_of(most, fabs(x[i] * w[i]));
    return most;
}

typedef struct Vectors {
    SUNContext context;
    VectorFamily family;
    int length;
    double data[LENGTH];
    N_Vector v[VECTORS];
} Vectors;

static void vectors_new(Vectors *s, int length, int waits, Team *team, const int *pitch)
{
    memset(s, 0, sizeof *s);
    s->length = length;
    s->family.queue.team = team;
    s->family.queue.pitch = pitch;
    assert_int_equal(SUNContext_Create(SUN_COMM_NULL, &s->context), 0);
    for (int k = 0; k < VECTORS; ++k) {
        s->v[k] = k ? N_VClone(s->v[0])
                    : vector_wrap(length, s->data, largest, &s->length, waits ? &s->family : NULL, s->context);
        assert_non_null(s->v[k]);
        double *const data = N_VGetArrayPointer(s->v[k]);
        for (int i = 0; i < length; ++i) data[i] = sin(1 + i + 1000. * k);
    }
}

static void vectors_free(Vectors *s)
{
    for (int k = VECTORS; k-- > 0;) N_VDestroy(s->v[k]);
    vector_family_clear(&s->family);
    SUNContext_Free(&s->context);
}

/* More operations than the queue has room for, with results that are read again and overwritten, and looks between. */
static double work(Vectors *s)
{
    N_Vector *const v = s->v;
    sunrealtype a[3] = {0.3, -1.1, 0.7};
    N_Vector three[3] = {v[2], v[0], v[3]}, out[2] = {v[1], v[4]}, in[2] = {v[4], v[1]};
    double norms = 0;
    for (int round = 0; round < 3; ++round) {
        N_VLinearSum(1, v[0], 0.1, v[1], v[0]);
        N_VLinearSum(-0.3, v[1], 1, v[0], v[1]);
        N_VScale(-1, v[1], v[2]);
        N_VScale(0.9, v[2], v[2]);
        N_VConst(0, v[3]);
        N_VLinearSum(1, v[3], 1.7, v[2], v[3]);
        N_VLinearCombination(3, a, three, v[2]);
        N_VScaleAddMulti(2, a, v[0], in, out);
        if (round == 1) norms += N_VWrmsNorm(v[2], v[1]);
        N_VConst(0.25, v[4]);
        for (int k = 0; k < 5; ++k) N_VLinearSum(1, v[4], 0.01 * k, v[0], v[4]);
    }
    N_VAbs(v[4], v[1]); /* one of SUNDIALS' own */
    norms += N_VMaxNorm(v[1]) + N_VMin(v[4]);
    return norms;
}

/* Lengths below, at and above pieces and lanes. */
TEST(test_bits)
{
    static Vectors at_once, waiting;
    /* with two threads, also shared by arrays of so many entries and what is behind them */
    const int lengths[] = {1, 7, 512, 519, 4810, LENGTH, LENGTH, LENGTH, LENGTH};
    const int pitch[] = {0, 0, 0, 0, 370, 0, 2308, 1501, LENGTH + 1};
    Team *const two = team_new(2);
    assert_non_null(two);
    for (int k = 0; k < 9; ++k) {
        for (int threads = 1; threads <= 2; ++threads) {
            vectors_new(&at_once, lengths[k], 0, NULL, NULL);
            vectors_new(&waiting, lengths[k], 1, threads == 2 ? two : NULL, &pitch[k]);
            const double expected = work(&at_once), found = work(&waiting);
            assert_memory_equal(&expected, &found, sizeof found);
            for (int i = 0; i < VECTORS; ++i) {
                assert_memory_equal(N_VGetArrayPointer(at_once.v[i]), N_VGetArrayPointer(waiting.v[i]),
                                    (size_t)lengths[k] * sizeof(double));
            }
            vectors_free(&at_once);
            vectors_free(&waiting);
        }
    }
    team_free(two);
}

/* Nothing is done before somebody looks; then everything is, also what the look itself does not need. */
TEST(test_waits)
{
    static Vectors s;
    vectors_new(&s, 100, 1, NULL, NULL);
    N_VConst(3, s.v[0]);
    N_VScale(2, s.v[0], s.v[1]);
    check_above(fabs(s.data[5] - 3), 1);
    assert_int_equal(s.family.queue.tasks, 2);
    check_close(N_VGetArrayPointer(s.v[2])[0], sin(2001), 1e-15);
    assert_int_equal(s.family.queue.tasks, 0);
    check_close(s.data[5], 3, 1e-15);
    check_close(NV_DATA_S(s.v[1])[5], 6, 1e-15);
    N_VScale(5, s.v[1], s.v[0]);
    vector_family_settle(&s.family);
    check_close(s.data[99], 30, 1e-15);
    N_VScale(2, s.v[1], s.v[2]); /* of a vector that goes away before it is done */
    N_VDestroy(s.v[1]);
    check_close(NV_DATA_S(s.v[2])[7], 12, 1e-15);
    s.v[1] = N_VClone(s.v[0]);
    vectors_free(&s);
}

/* The numbers move, with what waits to be done to them; those that are lost are not computed. */
TEST(test_take)
{
    static Vectors s;
    vectors_new(&s, 100, 1, NULL, NULL);
    const double first = N_VGetArrayPointer(s.v[2])[0];
    N_VScale(2, s.v[2], s.v[2]);
    N_VConst(7, s.v[1]);
    vector_take(s.v[1], s.v[2]);
    assert_int_equal(s.family.queue.tasks, 1);
    N_VScale(1, s.v[1], s.v[2]);
    N_VConst(0, s.v[1]);
    check_close(N_VGetArrayPointer(s.v[2])[0], 2 * first, 1e-15);
    check_close(N_VGetArrayPointer(s.v[1])[0], 0, 1e-15);
    N_VConst(3, s.v[0]); /* borrowed data stay where they are */
    vector_take(s.v[1], s.v[0]);
    assert_ptr_equal(N_VGetArrayPointer(s.v[0]), s.data);
    check_close(N_VGetArrayPointer(s.v[1])[9], 3, 1e-15);
    vectors_free(&s);
}

/* N_VClone gets what is in stock, and what is left of that goes. */
TEST(test_stock)
{
    static Vectors s;
    vectors_new(&s, 100, 1, NULL, NULL);
    assert_int_equal(vector_family_stock(s.v[0], 3), 1);
    N_Vector last = s.family.spare[2], taken = N_VClone(s.v[1]), own = vector_clone(s.v[1]);
    assert_ptr_equal(taken, last);
    assert_int_equal(s.family.n_spare, 2);
    N_VScale(2, s.v[1], taken);
    check_close(N_VGetArrayPointer(taken)[7], 2 * sin(1008), 1e-15);
    assert_int_equal(s.family.n, VECTORS + 4);
    assert_int_equal(vector_family_unstock(&s.family), 2);
    assert_int_equal(s.family.n, VECTORS + 2);
    N_VDestroy(own);
    N_VDestroy(taken);
    vectors_free(&s);
}
