#include "sim/newton/newton_data.h"

#include <stdlib.h>

#include "core/base/lanes.h"
#include "core/chain.h"

enum { POINT_ARRAYS = 17 }; /* from Newton.mass to w */

int newton_parts_new(Newton *nw, int extra)
{
    const int n = nw->n;
    const int ok = chain_struct_new(&nw->mass, POINT_ARRAYS, n) & block_chain_alloc(&nw->k, n, 6) &
                   block_chain_alloc(&nw->d, n, 6) & block_chain_alloc(&nw->a, n, 6);
    nw->z = calloc((size_t)(6 * n) + LANES, sizeof(double));
    nw->x = calloc((size_t)(6 * n + extra) + LANES, sizeof(double));
    if (!ok || !nw->z || !nw->x) return 0;
    chain_array_fill(nw->mass, n, 1);
    chain_array_fill(nw->q[0], n, 1);
    return 1;
}

void newton_parts_free(Newton *nw)
{
    block_chain_free(&nw->k);
    block_chain_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(&nw->mass, POINT_ARRAYS);
    free(nw->z);
    free(nw->x);
}
