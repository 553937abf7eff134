/* The sweeps of the solve, for block_lanes.h only: several right-hand sides share the loads of a block, and the two
 * sides of the chain go in turn, so that one's sums run while the other's wait. */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_SUBSTITUTE_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_SUBSTITUTE_H

#include "linsolve/block/block_eliminate.h"

/* Row i of a right-hand side; the last row has nothing behind it to read. */
VEC_INLINE Vec row_load(const BlockFactor *f, const double *x, int i)
{
    if (i + 1 < f->n) return vec_load(x + i * B);
    double last[W] = {0};
    memcpy(last, x + i * B, B * sizeof(double));
    return vec_load(last);
}

/* A x, in two chains, which halves the wait for the sums. */
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

VEC_INLINE double *z_at(const BlockFactor *f, int i, int rhs) { return f->z + (rhs * f->n + i) * W; }

/* z_i = X (r - L z_before) (L5); z holds z_before and receives z_i. */
VEC_INLINE void row_forward(const BlockFactor *f, int i, int count, const double *x, Vec z[])
{
    const Block l = block_load(f->front + 2 * i * CELL), inverse = block_load(f->front + (2 * i + 1) * CELL);
    UNROLL for (int r = 0; r < count; ++r)
    {
        z[r] = times(&inverse, minus_times(row_load(f, x + r * f->n * B, i), &l, z[r]));
        vec_store(z_at(f, i, r), z[r]);
    }
}

/* r - L z_before of the middle row. */
VEC_INLINE void middle_forward(const BlockFactor *f, int count, const double *x, const Vec z[])
{
    const Block l = block_load(f->front + 2 * f->middle * CELL);
    for (int r = 0; r < count; ++r) {
        vec_store(z_at(f, f->middle, r), minus_times(row_load(f, x + r * f->n * B, f->middle), &l, z[r]));
    }
}

VEC_INLINE void forward(const BlockFactor *f, int sides, int count, const double *x)
{
    const int top = sides & SIDE_TOP ? f->middle : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - f->middle : 0;
    Vec down[BLOCK_RHS], up[BLOCK_RHS];
    UNROLL for (int r = 0; r < count; ++r) down[r] = up[r] = vec_zero();
    int k = 0;
    for (; k < top && k < bottom; ++k) {
        row_forward(f, k, count, x, down);
        row_forward(f, f->n - 1 - k, count, x, up);
    }
    for (int i = k; i < top; ++i) row_forward(f, i, count, x, down);
    for (int i = k; i < bottom; ++i) row_forward(f, f->n - 1 - i, count, x, up);
    if (sides & SIDE_TOP) middle_forward(f, count, x, down);
}

/* x_m = X (z_m - U z_below), computed by each side for itself. */
VEC_INLINE void middle_back(const BlockFactor *f, int count, Vec next[])
{
    const int m = f->middle;
    const Block u = block_load(f->back + m * CELL), inverse = block_load(f->front + (2 * m + 1) * CELL);
    UNROLL for (int r = 0; r < count; ++r)
    {
        const Vec below = m + 1 < f->n ? vec_load(z_at(f, m + 1, r)) : vec_zero();
        next[r] = times(&inverse, minus_times(vec_load(z_at(f, m, r)), &u, below));
    }
}

/* x_i = z_i - V x_next (L6); next holds x_next and receives x_i. */
VEC_INLINE void row_back(const BlockFactor *f, int i, int count, double *x, Vec next[])
{
    const Block v = block_load(f->back + i * CELL);
    UNROLL for (int r = 0; r < count; ++r)
    {
        next[r] = minus_times(vec_load(z_at(f, i, r)), &v, next[r]);
        vec_store_short(x + (r * f->n + i) * B, next[r]);
    }
}

VEC_INLINE void back(const BlockFactor *f, int sides, int count, double *x)
{
    const int m = f->middle, top = sides & SIDE_TOP ? m : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - m : 0;
    Vec up[BLOCK_RHS], down[BLOCK_RHS];
    middle_back(f, count, up);
    UNROLL for (int r = 0; r < count; ++r)
    {
        down[r] = up[r];
        if (sides & SIDE_TOP) vec_store_short(x + (r * f->n + m) * B, up[r]);
    }
    int k = 0;
    for (; k < top && k < bottom; ++k) {
        row_back(f, m - 1 - k, count, x, up);
        row_back(f, m + 1 + k, count, x, down);
    }
    for (int i = k; i < top; ++i) row_back(f, m - 1 - i, count, x, up);
    for (int i = k; i < bottom; ++i) row_back(f, m + 1 + i, count, x, down);
}

#endif
