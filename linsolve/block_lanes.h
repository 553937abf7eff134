/* Kernels of the twisted block LU, written once over columns of a block; block6_lanes.c and block3_lanes.c set the
 * sizes (BLOCK_B, the padded length BLOCK_W, the vector length BLOCK_PART, the table's BLOCK_NAME) and include this.
 * Letters and numbers as in docs/theory.md, "Linear solvers". */
#ifndef HAWSER_LINSOLVE_BLOCK_LANES_H
#define HAWSER_LINSOLVE_BLOCK_LANES_H

#include "linsolve/block_eliminate.h"
#include "linsolve/block_substitute.h"

/* A block that was worked on in double, rounded into an array of floats. */
VEC_INLINE void block_round(double *array, int k, const double *block)
{
    float *const to = (float *)array + k * CELL;
    for (int e = 0; e < CELL; ++e) to[e] = (float)block[e];
}

static void row_round(const BlockFactor *f, int i, const double *front, const double *back)
{
    block_round(f->front, 2 * i, front);
    block_round(f->front, 2 * i + 1, front + CELL);
    block_round(f->back, i, back);
}

/* The rows of one side, from the end of the chain to the middle. Rows that are to be rounded are computed in a
 * buffer. */
VEC_INLINE int side_factor(const BlockFactor *f, const BlockChain *a, int top, int single, BlockReport *report)
{
    const int count = top ? f->middle : f->n - 1 - f->middle, step = top ? 1 : -1;
    const double *const before = top ? a->lower : a->upper, *const after = top ? a->upper : a->lower;
    double v[2][BLOCK_CELL], front[2 * BLOCK_CELL];
    for (int k = 0, i = top ? 0 : f->n - 1; k < count; ++k, i += step) {
        const double *const v_before = single ? v[1 - k % 2] : f->back + (i - step) * CELL;
        const BlockRow row = {.diag = a->diag + i * B * B,
                              .before = k ? before + i * B * B : block_zero,
                              .after = after + i * B * B,
                              .v_before = k ? v_before : block_zero,
                              .front = single ? front : f->front + 2 * i * CELL,
                              .back = single ? v[k % 2] : f->back + i * CELL};
        if (row_factor(f, &row, report)) return LIN_UNSTABLE;
        if (single) row_round(f, i, row.front, row.back);
    }
    if (single && count) memcpy(f->edge + (top ? 0 : BLOCK_CELL), v[(count - 1) % 2], CELL * sizeof(double));
    return 0;
}

static int kernel_factor(const BlockFactor *f, const BlockChain *a, int sides, BlockReport *report)
{
    int status = 0;
    for (int top = 1; top >= 0 && !status; --top) {
        if (!(sides & (top ? SIDE_TOP : SIDE_BOTTOM))) continue;
        status = f->single ? side_factor(f, a, top, 1, report) : side_factor(f, a, top, 0, report);
    }
    return status;
}

/* S = D - L V of both neighbours: that of the row below is subtracted first, the rest is a row like the others. */
static int kernel_factor_middle(const BlockFactor *f, const BlockChain *a, BlockReport *report)
{
    double diag[CELL + W] = {0}, front[2 * BLOCK_CELL], back[BLOCK_CELL];
    const int m = f->middle, first = m == 0, last = m + 1 == f->n;
    const double *const v_above = f->single ? f->edge : f->back + (m - 1) * CELL;
    const double *const v_below = f->single ? f->edge + BLOCK_CELL : f->back + (m + 1) * CELL;
    const Block below = block_load(last ? block_zero : a->upper + m * B * B);
    const Block s = block_minus(block_load(a->diag + m * B * B), &below, last ? block_zero : v_below);
    UNROLL for (int c = 0; c < B; ++c) vec_store_short(diag + c * B, s.c[c]);
    const BlockRow row = {.diag = diag,
                          .before = first ? block_zero : a->lower + m * B * B,
                          .after = block_zero,
                          .v_before = first ? block_zero : v_above,
                          .front = f->single ? front : f->front + 2 * m * CELL,
                          .back = f->single ? back : f->back + m * CELL};
    const int status = row_factor(f, &row, report);
    block_store(row.back, &below); /* the middle has no row after it */
    if (f->single) row_round(f, m, row.front, row.back);
    return status;
}

/* BLOCK_RHS right-hand sides at once, or any number one by one. */
static void kernel_forward(const BlockFactor *f, BlockSpan span, int count, double *x)
{
    if (count == BLOCK_RHS && !f->single) {
        forward(f, span, BLOCK_RHS, 0, x);
        return;
    }
    for (int r = 0; r < count; ++r) {
        double *const at = x + r * f->n * B;
        f->single ? forward(f, span, 1, 1, at) : forward(f, span, 1, 0, at);
    }
}

static void kernel_middle(const BlockFactor *f, int count, double *x)
{
    for (int r = 0; r < count; ++r) middle(f, 1, f->single, x + r * f->n * B);
}

static void kernel_back(const BlockFactor *f, BlockSpan span, int count, double *x)
{
    if (count == BLOCK_RHS && !f->single) {
        back(f, span, BLOCK_RHS, 0, x);
        return;
    }
    for (int r = 0; r < count; ++r) {
        double *const at = x + r * f->n * B;
        f->single ? back(f, span, 1, 1, at) : back(f, span, 1, 0, at);
    }
}

const BlockKernels ISA_NAME(BLOCK_NAME) = {.factor = kernel_factor,
                                           .factor_middle = kernel_factor_middle,
                                           .forward = kernel_forward,
                                           .middle = kernel_middle,
                                           .back = kernel_back};

#endif
