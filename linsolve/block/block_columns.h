/* A B x B block in registers, for block_lanes.h only. */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_COLUMNS_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_COLUMNS_H

#include "linsolve/block/block_vec.h"

enum { W = BLOCK_W, CELL = BLOCK_B * BLOCK_B };

/* A B x B block, column by column. In memory columns lie side by side: a load brings along the beginning of what
 * follows, and nobody looks at those places. */
typedef struct Block {
    Vec c[B];
} Block;

VEC_INLINE Block block_load(const double *p)
{
    Block a;
    UNROLL for (int c = 0; c < B; ++c) a.c[c] = vec_load(p + c * B);
    return a;
}

/* Each column overwrites what the one before it stored too much. */
VEC_INLINE void block_store(double *p, const Block *a)
{
    UNROLL for (int c = 0; c + 1 < B; ++c) vec_store(p + c * B, a->c[c]);
    vec_store_short(p + (B - 1) * B, a->c[B - 1]);
}

#endif
