/* Kernels of the twisted block LU, written once over columns of a block; block6_lanes.c and block3_lanes.c set the
 * sizes (BLOCK_B, the padded length BLOCK_W, the vector length BLOCK_PART, the table's BLOCK_NAME) and include this.
 * Letters and numbers as in docs/model.md, "Linear solvers". */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_LANES_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_LANES_H

#include "linsolve/block/block_eliminate.h"
#include "linsolve/block/block_substitute.h"

/* The rows of one side, from the end of the chain to the middle. */
static int side_factor(const BlockFactor *f, const BlockChain *a, int top, BlockReport *report)
{
    const int count = top ? f->middle : f->n - 1 - f->middle, step = top ? 1 : -1;
    const double *const before = top ? a->lower : a->upper, *const after = top ? a->upper : a->lower;
    for (int k = 0, i = top ? 0 : f->n - 1; k < count; ++k, i += step) {
        const BlockRow row = {.diag = a->diag + i * B * B,
                              .before = k ? before + i * B * B : block_zero,
                              .after = after + i * B * B,
                              .v_before = k ? f->back + (i - step) * CELL : block_zero,
                              .front = f->front + 2 * i * CELL,
                              .back = f->back + i * CELL};
        if (row_factor(f, &row, report)) return LIN_UNSTABLE;
    }
    return 0;
}

static int kernel_factor(const BlockFactor *f, const BlockChain *a, int sides, BlockReport *report)
{
    if (sides & SIDE_TOP && side_factor(f, a, 1, report)) return LIN_UNSTABLE;
    return sides & SIDE_BOTTOM ? side_factor(f, a, 0, report) : 0;
}

/* S = D - L V of both neighbours: what comes from below is taken off first, the rest is a row like the others. */
static int kernel_factor_middle(const BlockFactor *f, const BlockChain *a, BlockReport *report)
{
    double diag[CELL + W] = {0};
    const int m = f->middle, first = m == 0, last = m + 1 == f->n;
    const Block below = block_load(last ? block_zero : a->upper + m * B * B);
    const Block s = block_minus(block_load(a->diag + m * B * B), &below, last ? block_zero : f->back + (m + 1) * CELL);
    UNROLL for (int c = 0; c < B; ++c) vec_store_short(diag + c * B, s.c[c]);
    const BlockRow row = {.diag = diag,
                          .before = first ? block_zero : a->lower + m * B * B,
                          .after = block_zero,
                          .v_before = first ? block_zero : f->back + (m - 1) * CELL,
                          .front = f->front + 2 * m * CELL,
                          .back = f->back + m * CELL};
    const int status = row_factor(f, &row, report);
    block_store(f->back + m * CELL, &below); /* the middle has no row after it */
    return status;
}

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
