#include "core/block_chain.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

enum { ALIGNMENT = 64 };

/* Zeroed, aligned array of `count` doubles (at least one vector register longer). */
static double *blocks_new(size_t count)
{
    const size_t bytes = (count * sizeof(double) / ALIGNMENT + 2) * ALIGNMENT;
    double *p = aligned_alloc(ALIGNMENT, bytes);
    if (p) memset(p, 0, bytes);
    return p;
}

int block_chain_alloc(BlockChain *a, int n, int b)
{
    const size_t count = (size_t)n * (size_t)(b * b);
    *a =
        (BlockChain){.n = n, .b = b, .lower = blocks_new(count), .diag = blocks_new(count), .upper = blocks_new(count)};
    if (a->lower && a->diag && a->upper) return 1;
    block_chain_free(a);
    return 0;
}

void block_chain_free(BlockChain *a)
{
    free(a->lower);
    free(a->diag);
    free(a->upper);
    *a = (BlockChain){0};
}

void block_chain_zero(BlockChain *a)
{
    const size_t bytes = (size_t)a->n * (size_t)(a->b * a->b) * sizeof(double);
    memset(a->lower, 0, bytes);
    memset(a->diag, 0, bytes);
    memset(a->upper, 0, bytes);
}

void block_chain_copy(BlockChain *to, const BlockChain *from)
{
    assert(to->n == from->n && to->b == from->b);
    const size_t bytes = (size_t)to->n * (size_t)(to->b * to->b) * sizeof(double);
    memcpy(to->lower, from->lower, bytes);
    memcpy(to->diag, from->diag, bytes);
    memcpy(to->upper, from->upper, bytes);
}

/* y += s block x, one block. */
static void block_gemv(int b, const double *block, double s, const double *x, double *y)
{
    for (int c = 0; c < b; ++c) {
        for (int r = 0; r < b; ++r) y[r] += s * x[c] * block[c * b + r];
    }
}

void block_chain_gemv(const BlockChain *a, double s, const double *x, double *y)
{
    const int b = a->b, bb = b * b;
    for (int i = 0; i < a->n; ++i) {
        block_gemv(b, a->diag + i * bb, s, x + i * b, y + i * b);
        if (i > 0) block_gemv(b, a->lower + i * bb, s, x + (i - 1) * b, y + i * b);
        if (i + 1 < a->n) block_gemv(b, a->upper + i * bb, s, x + (i + 1) * b, y + i * b);
    }
}
