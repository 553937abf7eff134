/* A block tridiagonal matrix: one block row a segment, neighbours coupled. It holds stiffness, damping and the Newton
 * matrix. Blocks are b x b (6: force and moment; 3: planar), column-major, without padding. */
#ifndef HAWSER_CORE_BLOCK_CHAIN_H
#define HAWSER_CORE_BLOCK_CHAIN_H

#include "core/base/vec3.h"

typedef struct BlockChain {
    int n;         /* block rows */
    int b;         /* block size */
    double *lower; /* [n][b*b]: row i, column i-1; lower[0] is zero and unused */
    double *diag;  /* [n][b*b]: row i, column i */
    double *upper; /* [n][b*b]: row i, column i+1; the last is zero and unused */
} BlockChain;

/* Allocates zeroed blocks, 64-byte aligned and readable a vector beyond their end; returns 0 if there is no memory (and
 * leaves nothing allocated). */
int block_chain_alloc(BlockChain *a, int n, int b);
void block_chain_free(BlockChain *a);
void block_chain_zero(BlockChain *a);
/* The blocks of `from`, which has the same sizes. */
void block_chain_copy(BlockChain *to, const BlockChain *from);
/* Adds [force; moment] to a column of a 6x6 block. */
static inline void block6_add(double *block, int column, Vec3 force, Vec3 moment)
{
    const double value[6] = {force.x, force.y, force.z, moment.x, moment.y, moment.z};
    for (int row = 0; row < 6; ++row) block[6 * column + row] += value[row];
}
/* y = y + s A x for vectors of n*b. */
void block_chain_gemv(const BlockChain *a, double s, const double *x, double *y);

#endif
