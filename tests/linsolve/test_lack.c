/* Every allocation of a linear solver fails once: it is said, nothing else is harmed, and the next try gives the same
 * bits as if nothing had been. */
#include <stdlib.h>

#include "tests/support/lack.h"

#include "linsolve/linsolve.h"
#include "linsolve/small.h"
#include "tests/linsolve/beside_fixture.h"
#include "tests/support/check.h"

enum { ROWS = 7, SIZE = 6 * ROWS, MOST = 4000 };

/* A solver is made, factors, is written and read into another one, while the k-th of all allocations fails. Returns
 * whether there were as many; x: what it solves. */
static int tried(const NewtonMatrix *m, const LinOptions *options, long k, double *x, int size)
{
    hawser_error err = {0};
    Checkpoint c = {0}, back = {0};
    LinSolver *to = NULL;
    int status = -1;
    lack_after(k);
    LinSolver *const s = linsolver_new_newton(m, options, &err);
    if (s) status = linsolver_factor_newton(s, m);
    if (s && !status) c = checkpoint_new(1 << 20);
    if (s && !status && !c.status) {
        linsolver_checkpoint(&c, s, m);
        to = linsolver_new_newton(m, options, &err);
    }
    if (to) {
        back = checkpoint_over(c.bytes, c.size, NULL);
        linsolver_checkpoint(&back, to, m);
    }
    const int met = lack_end();
    const int done = to && !c.status && !back.status;
    if (!met) assert_true(done);
    if (!s) assert_int_equal(err.status, HAWSER_ERR_MEMORY);
    if (s && status) check_below(status, 0); /* no matrix is blamed */
    if (c.status) assert_int_equal(c.status, HAWSER_ERR_MEMORY);
    if (back.status) assert_int_equal(back.status, HAWSER_ERR_MEMORY);
    if (s && status) assert_int_equal(linsolver_factor_newton(s, m), 0); /* there is memory again */
    if (s) {
        uint64_t seed = 3;
        double *const r = fixture_vector(size, &seed);
        memcpy(x, r, (size_t)size * sizeof *x);
        assert_int_equal(linsolver_solve(s, x), 0);
        if (done) {
            assert_int_equal(linsolver_solve(to, r), 0);
            assert_memory_equal(r, x, (size_t)size * sizeof *x);
        }
        free(r);
    }
    linsolver_free(to);
    linsolver_free(s);
    checkpoint_free(&c);
    return met;
}

static void every_allocation(const NewtonMatrix *m, LinKind kind, LinOrdering ordering, int size)
{
    const LinOptions options = {.kind = kind, .ordering = ordering, .threads = kind == LIN_BLOCK ? 2 : 1};
    double *const x = calloc((size_t)size, sizeof *x), *const whole = calloc((size_t)size, sizeof *whole);
    long k = 0;
    assert_false(tried(m, &options, MOST, whole, size));
    for (; tried(m, &options, k, x, size); ++k) {
        /* auto takes the least fill of those orderings for which there was memory */
        if (x[0] != 0 && !(kind == LIN_KLU && ordering == ORDER_AUTO)) {
            assert_memory_equal(x, whole, (size_t)size * sizeof *x);
        }
        memset(x, 0, (size_t)size * sizeof *x);
    }
    check_between(k, 3, MOST);
    free(x);
    free(whole);
}

TEST(chains)
{
    if (!lack_works()) skip();
    uint64_t seed = 1;
    BlockChain chain, hard;
    fixture_chain_cable(&chain, ROWS, 6, 0.005, &seed);
    fixture_chain_random(&hard, ROWS, 6, 0, &seed);
    memset(hard.diag, 0, 36 * sizeof(double)); /* KLU has to help */
    const NewtonMatrix m = {.chain = chain}, helped = {.chain = hard};
    static const LinKind kinds[] = {LIN_AUTO, LIN_BORDERED, LIN_BLOCK_SPARSE};
    for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) every_allocation(&m, kinds[k], ORDER_AUTO, SIZE);
    every_allocation(&m, LIN_KLU, ORDER_AMD, SIZE);
    every_allocation(&m, LIN_KLU, ORDER_COLAMD, SIZE);
    every_allocation(&m, LIN_KLU, ORDER_METIS, SIZE);
    every_allocation(&m, LIN_KLU, ORDER_AUTO, SIZE);
    every_allocation(&helped, LIN_BLOCK, ORDER_AUTO, SIZE);
    block_chain_free(&chain);
    block_chain_free(&hard);
}

/* With leaves and a border. */
TEST(surrounded)
{
    if (!lack_works()) skip();
    enum { WHOLE = SIZE + 2 + 1 };
    uint64_t seed = 2;
    BlockChain chain;
    fixture_chain_cable(&chain, ROWS, 6, 0.005, &seed);
    double *const v = fixture_vector(4 + 48, &seed), *const border = fixture_vector(2 * WHOLE, &seed), corner = 90;
    v[0] += 9;
    v[3] += 9;
    const Leaf leaf = {.size = 2, .at = 3, .touches = 2, .diag = v, .into = {v + 4, v + 16}, .from = {v + 28, v + 40}};
    const NewtonMatrix m = {.chain = chain,
                            .leaves = 1,
                            .leaf = &leaf,
                            .border = 1,
                            .right = border,
                            .bottom = border + WHOLE,
                            .corner = &corner};
    every_allocation(&m, LIN_AUTO, ORDER_AUTO, WHOLE);
    every_allocation(&m, LIN_KLU, ORDER_AMD, WHOLE);
    block_chain_free(&chain);
    free(v);
    free(border);
}

TEST(beside)
{
    if (!lack_works()) skip();
    uint64_t seed = 3;
    Beside b = beside_new(2, 4, 0, 4, &seed);
    const NewtonMatrix m = matrix_of(&b, 1);
    every_allocation(&m, LIN_BLOCK_SPARSE, ORDER_AUTO, 48);
    beside_free(&b);
}

TEST(eigenvalues)
{
    if (!lack_works()) skip();
    int met = 1, lacked = 0;
    for (long k = 0; met; ++k) {
        double a[9] = {2, 1, 0, 1, 3, 1, 0, 1, 4}, b[9] = {1, 0, 0, 0, 1, 0, 0, 0, 1}, mu[3], imaginary[3], z[9];
        hawser_error err = {0};
        lack_after(k);
        const hawser_status status = small_eigen(3, 1, a, b, mu, imaginary, z, &err);
        met = lack_end();
        /* the library itself is loaded each time: where there is no memory for that, it is not found */
        if (status && status != HAWSER_ERR_MEMORY) check_has(err.message, "was not found");
        lacked += status == HAWSER_ERR_MEMORY;
        if (!met) assert_int_equal(status, HAWSER_OK);
    }
    check_above(lacked, 1); /* its own, and LAPACK's */
}
