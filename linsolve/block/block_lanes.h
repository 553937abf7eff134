/* Kernels of the twisted block LU, written once over columns of a block; block6_lanes.c and block3_lanes.c set the
 * sizes (BLOCK_B, the padded length BLOCK_W, the vector length BLOCK_PART, the table's BLOCK_NAME) and include this.
 * Letters and numbers as in docs/model.md, "Linear solvers". */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_LANES_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_LANES_H

#include "linsolve/block/block_eliminate.h"
#include "linsolve/block/block_substitute.h"

/* BLOCK_RHS right-hand sides at once, or any number one by one, each in its own part of the scratch. */
static void kernel_forward(const BlockFactor *f, int sides, int count, const double *x)
{
    if (count == BLOCK_RHS) {
        forward(f, sides, BLOCK_RHS, x);
        return;
    }
    BlockFactor one = *f;
    for (int r = 0; r < count; ++r, one.z += f->n * W) forward(&one, sides, 1, x + r * f->n * B);
}

static void kernel_back(const BlockFactor *f, int sides, int count, double *x)
{
    if (count == BLOCK_RHS) {
        back(f, sides, BLOCK_RHS, x);
        return;
    }
    BlockFactor one = *f;
    for (int r = 0; r < count; ++r, one.z += f->n * W) back(&one, sides, 1, x + r * f->n * B);
}

const BlockKernels ISA_NAME(BLOCK_NAME) = {
    .factor = kernel_factor, .factor_middle = kernel_factor_middle, .forward = kernel_forward, .back = kernel_back};

#endif
