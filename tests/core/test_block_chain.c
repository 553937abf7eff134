/* The block tridiagonal matrix. */
#include <math.h>

#include "core/block_chain.h"
#include "tests/support/check.h"

/* Block (i, j) has entries 100 i + 10 j + row + column / 8, so that none equals another's. */
static double entry(int i, int j, int r, int c) { return 100 * i + 10 * j + r + 0.125 * c; }

static void fill(BlockChain *a)
{
    const int b = a->b;
    double *const blocks[3] = {a->lower, a->diag, a->upper};
    for (int i = 0; i < a->n; ++i) {
        for (int d = 0; d < 3; ++d) {
            if (i + d < 1 || i + d > a->n) continue;
            for (int k = 0; k < b * b; ++k) blocks[d][i * b * b + k] = entry(i, i + d - 1, k % b, k / b);
        }
    }
}

TEST(allocation)
{
    BlockChain a;
    assert_true(block_chain_alloc(&a, 5, 6));
    double *const blocks[3] = {a.lower, a.diag, a.upper};
    for (int d = 0; d < 3; ++d) {
        assert_int_equal((uintptr_t)blocks[d] % 64, 0);
        for (int k = 0; k < 5 * 36 + 8; ++k) check_equal(blocks[d][k], 0); /* and a vector beyond */
    }
    block_chain_free(&a);
    assert_null(a.diag);
    block_chain_free(&a);
}

TEST(copy_and_zero)
{
    BlockChain a, c;
    block_chain_alloc(&a, 4, 3);
    block_chain_alloc(&c, 4, 3);
    fill(&a);
    block_chain_copy(&c, &a);
    assert_memory_equal(a.lower, c.lower, 36 * sizeof(double));
    assert_memory_equal(a.diag, c.diag, 36 * sizeof(double));
    assert_memory_equal(a.upper, c.upper, 36 * sizeof(double));
    block_chain_zero(&a);
    for (int k = 0; k < 36; ++k) {
        check_equal(a.lower[k], 0);
        check_equal(a.diag[k], 0);
        check_equal(a.upper[k], 0);
    }
    check_equal(c.diag[0], entry(0, 0, 0, 0));
    check_equal(c.lower[9], entry(1, 0, 0, 0));
    block_chain_free(&a);
    block_chain_free(&c);
}
