/* Negative directions of block tridiagonal matrices against their eigenvalues by LAPACK. */
#include "linsolve/inertia.h"
#include "linsolve/small.h"
#include "tests/support/check.h"

enum { ROWS = 5, MOST = 6 * ROWS };

static double random_next(unsigned *seed)
{
    *seed = 1664525u * *seed + 1013904223u;
    return (double)(*seed >> 8) / (1 << 23) - 1;
}

/* A matrix whose diagonal is lifted by `shift`, of which the symmetric part is what the blocks add up to. */
static void fill(BlockChain *a, double shift, unsigned *seed)
{
    const int b = a->b;
    for (int i = 0; i < a->n; ++i) {
        for (int k = 0; k < b * b; ++k) {
            a->diag[b * b * i + k] = random_next(seed) + (k % (b + 1) == 0 ? shift : 0);
            if (i > 0) a->lower[b * b * i + k] = random_next(seed);
            if (i < a->n - 1) a->upper[b * b * i + k] = random_next(seed);
        }
    }
}

/* Entry (r, c) of the whole matrix. */
static double entry(const BlockChain *a, int r, int c)
{
    const int b = a->b, i = r / b, j = c / b, at = b * b * i + r % b + b * (c % b);
    if (i == j) return a->diag[at];
    if (j == i - 1) return a->lower[at];
    return j == i + 1 ? a->upper[at] : 0;
}

static int eigenvalues_below_zero(const BlockChain *a)
{
    const int size = a->n * a->b;
    static double s[MOST * MOST], t[MOST * MOST], z[MOST * MOST], mu[MOST], imaginary[MOST];
    hawser_error err = {0};
    for (int r = 0; r < size; ++r) {
        for (int c = 0; c < size; ++c) {
            s[r + size * c] = (entry(a, r, c) + entry(a, c, r)) / 2;
            t[r + size * c] = r == c;
        }
    }
    if (small_eigen(size, 1, s, t, mu, imaginary, z, &err)) fail_msg("%s", err.message);
    int below = 0;
    for (int k = 0; k < size; ++k) below += mu[k] < 0;
    return below;
}

TEST(signs_are_those_of_the_eigenvalues)
{
    unsigned seed = 7;
    int seen = 0;
    for (int b = 3; b <= 6; b += 3) {
        BlockChain a;
        assert_true(block_chain_alloc(&a, ROWS, b));
        for (int k = 0; k < 40; ++k) {
            fill(&a, 0.2 * (k - 20), &seed);
            const int below = eigenvalues_below_zero(&a);
            assert_int_equal(block_chain_negative(&a), below);
            seen |= below == 0 ? 1 : below == ROWS * b ? 2 : 4;
        }
        block_chain_free(&a);
    }
    assert_int_equal(seen & 4, 4); /* neither all nor none */
}

/* What has no stiffness at all is not negative, nor does it make others so. */
TEST(free_directions_do_not_count)
{
    BlockChain a;
    assert_true(block_chain_alloc(&a, 3, 6));
    assert_int_equal(block_chain_negative(&a), 0);
    for (int i = 0; i < 3; ++i) a.diag[36 * i + 7] = -1;
    assert_int_equal(block_chain_negative(&a), 3);
    block_chain_free(&a);
}
