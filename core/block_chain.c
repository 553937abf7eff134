#include "core/block_chain.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"

int block_chain_alloc(BlockChain *a, int n, int b)
{
    const int count = n * b * b;
    *a = (BlockChain){.n = n,
                      .b = b,
                      .lower = aligned_array_new(count),
                      .diag = aligned_array_new(count),
                      .upper = aligned_array_new(count)};
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

void block_chain_checkpoint(Checkpoint *c, const char *name, BlockChain *a)
{
    const size_t bytes = (size_t)a->n * (size_t)(a->b * a->b) * sizeof(double);
    checkpoint_put(c, name, a->lower, bytes);
    checkpoint_put(c, name, a->diag, bytes);
    checkpoint_put(c, name, a->upper, bytes);
}
