/* The sweeps of the solve, for block_lanes.h only: several right-hand sides share the loads of a block, and the two
 * sides of the chain alternate, so that the sums of one are computed while the other's are pending. */
#ifndef HAWSER_LINSOLVE_BLOCK_SUBSTITUTE_H
#define HAWSER_LINSOLVE_BLOCK_SUBSTITUTE_H

#include "linsolve/block_eliminate.h"

/* A x, in two independent sums, which halves the latency. */
VEC_INLINE Vec times(const Block *a, Vec x)
{
    Vec even = vec_scale(a->c[0], vec_splat(x, 0)), odd = vec_scale(a->c[1], vec_splat(x, 1));
    UNROLL for (int k = 2; k < B; k += 2) even = vec_plus(even, a->c[k], vec_splat(x, k));
    UNROLL for (int k = 3; k < B; k += 2) odd = vec_plus(odd, a->c[k], vec_splat(x, k));
    return vec_add(even, odd);
}

/* t - A x, likewise. */
VEC_INLINE Vec minus_times(Vec t, const Block *a, Vec x)
{
    Vec odd = vec_scale(a->c[1], vec_splat(x, 1));
    UNROLL for (int k = 0; k < B; k += 2) t = vec_minus(t, a->c[k], vec_splat(x, k));
    UNROLL for (int k = 3; k < B; k += 2) odd = vec_plus(odd, a->c[k], vec_splat(x, k));
    return vec_sub(t, odd);
}

/* Block k of a factor's array, of doubles or of floats. */
VEC_INLINE Block factor_block(const double *array, int k, int single)
{
    if (!single) return block_load(array + k * CELL);
    const float *const p = (const float *)array + k * CELL;
    Block a;
    UNROLL for (int c = 0; c < B; ++c) a.c[c] = vec_load_single(p + c * B);
    return a;
}

/* Row i of right-hand side r, of z, of the solution. */
VEC_INLINE double *row_at(const BlockFactor *f, double *x, int i, int r) { return x + (r * f->n + i) * B; }

/* A row is read together with its neighbour in the direction of the sweep: a load of what the row before has just
 * stored would have to wait. The last row of a sweep to the chain's end is read alone. */
typedef enum Beside { BESIDE_NEXT, BESIDE_LAST, BESIDE_NONE } Beside;

VEC_INLINE Vec row_load(const double *row, Beside beside)
{
    return beside == BESIDE_NEXT ? vec_load(row) : beside == BESIDE_LAST ? vec_load_ending(row) : vec_load_short(row);
}

/* z, or x, of row i; zero if there is no such row. */
VEC_INLINE void rows_begin(const BlockFactor *f, int i, int count, double *x, Vec out[])
{
    UNROLL for (int r = 0; r < count; ++r)
    {
        out[r] = i >= 0 && i < f->n ? vec_load_short(row_at(f, x, i, r)) : vec_zero();
    }
}

/* z_i = X (r - L z_before) (L5); z holds z_before and receives z_i. */
VEC_INLINE void row_forward(const BlockFactor *f, int i, Beside beside, int count, int single, double *x, Vec z[])
{
    const Block l = factor_block(f->front, 2 * i, single), inverse = factor_block(f->front, 2 * i + 1, single);
    UNROLL for (int r = 0; r < count; ++r)
    {
        z[r] = times(&inverse, minus_times(row_load(row_at(f, x, i, r), beside), &l, z[r]));
        vec_store_short(row_at(f, x, i, r), z[r]);
    }
}

VEC_INLINE void forward(const BlockFactor *f, BlockSpan s, int count, int single, double *x)
{
    Vec down[BLOCK_RHS], up[BLOCK_RHS];
    rows_begin(f, s.top_from - 1, count, x, down);
    rows_begin(f, s.bottom_to, count, x, up);
    int i = s.top_from, j = s.bottom_to - 1;
    for (; i < s.top_to && j >= s.bottom_from; ++i, --j) {
        row_forward(f, i, BESIDE_NEXT, count, single, x, down);
        row_forward(f, j, BESIDE_LAST, count, single, x, up);
    }
    for (; i < s.top_to; ++i) row_forward(f, i, BESIDE_NEXT, count, single, x, down);
    for (; j >= s.bottom_from; --j) row_forward(f, j, BESIDE_LAST, count, single, x, up);
}

/* x_m = X (r - L z_above - U z_below). */
VEC_INLINE void middle(const BlockFactor *f, int count, int single, double *x)
{
    const int m = f->middle;
    const Block l = factor_block(f->front, 2 * m, single), u = factor_block(f->back, m, single);
    const Block inverse = factor_block(f->front, 2 * m + 1, single);
    Vec above[BLOCK_RHS], below[BLOCK_RHS];
    rows_begin(f, m - 1, count, x, above);
    rows_begin(f, m + 1, count, x, below);
    UNROLL for (int r = 0; r < count; ++r)
    {
        const Vec t = minus_times(vec_load_short(row_at(f, x, m, r)), &l, above[r]);
        vec_store_short(row_at(f, x, m, r), times(&inverse, minus_times(t, &u, below[r])));
    }
}

/* x_i = z_i - V x_next (L6); next holds x_next and receives x_i. */
VEC_INLINE void row_back(const BlockFactor *f, int i, Beside beside, int count, int single, double *x, Vec next[])
{
    const Block v = factor_block(f->back, i, single);
    UNROLL for (int r = 0; r < count; ++r)
    {
        next[r] = minus_times(row_load(row_at(f, x, i, r), beside), &v, next[r]);
        vec_store_short(row_at(f, x, i, r), next[r]);
    }
}

VEC_INLINE void back(const BlockFactor *f, BlockSpan s, int count, int single, double *x)
{
    Vec up[BLOCK_RHS], down[BLOCK_RHS];
    rows_begin(f, s.top_to, count, x, up);
    rows_begin(f, s.bottom_from - 1, count, x, down);
    const int first = s.top_from > 1 ? s.top_from : 1, last = s.bottom_to < f->n - 1 ? s.bottom_to : f->n - 1;
    int i = s.top_to - 1, j = s.bottom_from;
    for (; i >= first && j < last; --i, ++j) {
        row_back(f, i, BESIDE_LAST, count, single, x, up);
        row_back(f, j, BESIDE_NEXT, count, single, x, down);
    }
    for (; i >= first; --i) row_back(f, i, BESIDE_LAST, count, single, x, up);
    for (; j < last; ++j) row_back(f, j, BESIDE_NEXT, count, single, x, down);
    if (i >= s.top_from) row_back(f, i, BESIDE_NONE, count, single, x, up);
    if (j < s.bottom_to) row_back(f, j, BESIDE_NONE, count, single, x, down);
}

#endif
