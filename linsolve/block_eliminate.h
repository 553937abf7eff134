/* The elimination of block rows, for block_lanes.h and sparse6_lanes.c only. A row is processed in registers: its pivot
 * block and the coupling that follows. */
#ifndef HAWSER_LINSOLVE_BLOCK_ELIMINATE_H
#define HAWSER_LINSOLVE_BLOCK_ELIMINATE_H

#include <float.h>

#include "linsolve/backend.h"
#include "linsolve/block_factor.h"
#include "linsolve/block_vec.h"

enum { W = BLOCK_W, CELL = BLOCK_B * BLOCK_B };

/* A B x B block, column by column. Columns are adjacent in memory: a load includes the beginning of the following data,
 * which is never used. */
typedef struct Block {
    Vec c[B];
} Block;

VEC_INLINE Block block_load(const double *p)
{
    Block a;
    UNROLL for (int c = 0; c < B; ++c) a.c[c] = vec_load(p + c * B);
    return a;
}

/* Each column overwrites the surplus entries that the one before it stored. */
VEC_INLINE void block_store(double *p, const Block *a)
{
    UNROLL for (int c = 0; c + 1 < B; ++c) vec_store(p + c * B, a->c[c]);
    vec_store_short(p + (B - 1) * B, a->c[B - 1]);
}

/* Limits of the fast path (L7): the sum of the multipliers, and row sum over pivot. */
static const double multipliers_max = 30, smallness_max = 1e13;

/* s - a v, v a block of the factor in memory: its numbers are spread as they are loaded. */
VEC_INLINE Block block_minus(Block s, const Block *a, const double *v)
{
    UNROLL for (int k = 0; k < B; ++k)
    {
        UNROLL for (int c = 0; c < B; ++c) s.c[c] = vec_minus_number(s.c[c], a->c[k], v[c * B + k]);
    }
    return s;
}

/* t + row sums of |a|. */
VEC_INLINE Vec row_sums(Vec t, const Block *a)
{
    UNROLL for (int c = 0; c < B; ++c) t = vec_add(t, vec_abs(a->c[c]));
    return t;
}

/* Column k before its elimination, over its pivot; 1/pivot in the pivot's own place. */
VEC_INLINE Vec quotients(const Block *s, int k)
{
    const Vec own = vec_places(k, k + 1), others = vec_or(vec_places(0, k), vec_places(k + 1, B));
    const Vec one = vec_and(vec_set(1), own);
    return vec_div(vec_or(vec_and(s->c[k], others), one), vec_fill(vec_splat(s->c[k], k)));
}

/* a less the multipliers m times its place k. */
VEC_INLINE Vec column_eliminate(Vec a, Vec m, int k) { return vec_minus(a, m, vec_splat(a, k)); }

/* Gauss-Jordan on [s | u], pivots on the diagonal (L3): s becomes its inverse and u the inverse times u, except for the
 * division of the rows by their pivots; inverse gets 1 / pivot, multipliers the sum of |multipliers| below the
 * diagonal, place by place. The next pivot's column goes first in each step, so that its division overlaps with the
 * other columns. */
VEC_INLINE void eliminate(Block *s, Block *u, Vec *inverse, Vec *multipliers)
{
    Vec q = quotients(s, 0);
    *inverse = *multipliers = vec_zero();
    UNROLL for (int k = 0; k < B; ++k)
    {
        const Vec own = vec_places(k, k + 1), below = vec_places(k + 1, B);
        const Vec m = vec_and(q, vec_or(vec_places(0, k), below));
        *inverse = vec_or(*inverse, vec_and(q, own));
        if (k + 1 < B) {
            s->c[k + 1] = column_eliminate(s->c[k + 1], m, k);
            q = quotients(s, k + 1);
        }
        UNROLL for (int c = 0; c < B; ++c)
        {
            if (c != k && c != k + 1) s->c[c] = column_eliminate(s->c[c], m, k);
        }
        UNROLL for (int c = 0; c < B; ++c) u->c[c] = column_eliminate(u->c[c], m, k);
        s->c[k] = vec_sub(vec_and(vec_set(1), own), m);
        *multipliers = vec_add(*multipliers, vec_abs(vec_and(m, below)));
    }
}

/* One block row: X and V, or the pivoting path if the diagonal's pivots are too small. */
VEC_INLINE int row_factor(const BlockFactor *f, const BlockRow *row, BlockReport *report)
{
    const Block before = block_load(row->before);
    Block s = block_load(row->diag), u = block_load(row->after);
    const Vec scale = row_sums(row_sums(vec_zero(), &before), &s);
    block_store(row->front, &before);
    s = block_minus(s, &before, row->v_before); /* (L2) */
    const Vec sums = row_sums(vec_zero(), &s);
    Vec inverse, multipliers;
    eliminate(&s, &u, &inverse, &multipliers);
    UNROLL for (int c = 0; c < B; ++c)
    {
        s.c[c] = vec_mul(s.c[c], inverse);
        u.c[c] = vec_mul(u.c[c], inverse);
    }
    block_store(row->front + CELL, &s);
    block_store(row->back, &u);
    const double growth = vec_max(vec_div(sums, vec_add(scale, vec_set(DBL_MIN))));
    if (!(growth <= f->growth_limit)) return LIN_UNSTABLE;
    if (growth > report->growth) report->growth = growth;
    const double smallness = vec_sum(vec_mul(vec_abs(inverse), scale));
    if (vec_sum(multipliers) <= multipliers_max && smallness <= smallness_max) return 0;
    ++report->pivoted;
    return block_row_pivoted(f, row);
}

#endif
