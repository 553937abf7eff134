#include "core/planar.h"

#include "core/lanes.h"

int planar_stride(int n) { return (n + LANES - 1) / LANES * LANES; }

/* ---------------------------------------------------------------------------------------------------- memory */

enum { PLANAR_ARRAYS = 15 }; /* from PlanarChain.half to preload */

int planar_chain_alloc(PlanarChain *chain, int n)
{
    *chain = (PlanarChain){.n = n, .stride = planar_stride(n), .share = 0.5};
    return chain_struct_new(&chain->half, PLANAR_ARRAYS, n);
}

void planar_chain_free(PlanarChain *chain) { chain_arrays_free(&chain->half, PLANAR_ARRAYS); }

int planar_kinematics_alloc(PlanarKinematics *kin, int n)
{
    if (!chain_struct_alloc(kin, n)) return 0;
    chain_array_fill(kin->h[0], n, 1);
    chain_array_fill(kin->a[0], n, 1);
    return 1;
}

void planar_blocks_trim(PlanarBlocks *blocks, int n)
{
    for (int e = 0; e < 9; ++e) {
        blocks->lower[e][0] = blocks->lower[e][n] = 0;
        blocks->upper[e][-1] = blocks->upper[e][n - 1] = 0;
    }
}
