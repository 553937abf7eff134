#include "sim/newton/newton_data.h"

#include <stdlib.h>

#include "core/base/lanes.h"
#include "core/chain.h"

int newton_parts_new(Newton *nw, int extra)
{
    const int n = nw->n;
    int ok = chain_arrays_new(&nw->mass, 1, n, 1) & chain_arrays_new(nw->inertia, 9, n, 0) &
             chain_arrays_new(nw->w, 3, n, 0);
    ok &= chain_arrays_new(nw->q, 1, n, 1) & chain_arrays_new(nw->q + 1, 3, n, 0);
    ok &= block_chain_alloc(&nw->k, n, 6) & block_chain_alloc(&nw->d, n, 6) & block_chain_alloc(&nw->a, n, 6);
    nw->z = calloc((size_t)(6 * n) + LANES, sizeof(double));
    nw->x = calloc((size_t)(6 * n + extra) + LANES, sizeof(double));
    return ok && nw->z && nw->x;
}

void newton_parts_free(Newton *nw)
{
    block_chain_free(&nw->k);
    block_chain_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(&nw->mass, 1);
    chain_arrays_free(nw->inertia, 9);
    chain_arrays_free(nw->q, 4);
    chain_arrays_free(nw->w, 3);
    free(nw->z);
    free(nw->x);
}
