/* Kernels of the twisted block LU, written once over columns of a block (block_vec.h); block6_lanes.c and
 * block3_lanes.c set the sizes and include this. A row's elimination works in registers on its pivot block and the
 * coupling that follows. Letters and numbers as in docs/model.md, "Linear solvers". */
#include <float.h>

#include "linsolve/backend.h"
#include "linsolve/block_factor.h"
#include "linsolve/block_vec.h"

enum { W = BLOCK_W, CELL = BLOCK_B * BLOCK_B };

/* Limits of the fast path (L7): the sum of the multipliers, and row sum over pivot. */
static const double multipliers_max = 30, smallness_max = 1e13;

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

/* s - a v, v a block in memory: its numbers spread as they are loaded. */
VEC_INLINE Block block_minus(Block s, const Block *a, const double *v)
{
    UNROLL for (int k = 0; k < B; ++k)
    {
        UNROLL for (int c = 0; c < B; ++c) s.c[c] = vec_minus_number(s.c[c], a->c[k], v[c * B + k]);
    }
    return s;
}

/* a v, likewise. */
VEC_INLINE Block block_times(const Block *a, const double *v)
{
    Block s;
    UNROLL for (int c = 0; c < B; ++c) s.c[c] = vec_times_number(a->c[0], v[c * B]);
    UNROLL for (int k = 1; k < B; ++k)
    {
        UNROLL for (int c = 0; c < B; ++c) s.c[c] = vec_plus_number(s.c[c], a->c[k], v[c * B + k]);
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

/* Gauss-Jordan on [s | u], pivots on the diagonal (L3): s becomes its inverse and u the inverse times u, but for the
 * rows' division by their pivots; inverse gets 1 / pivot, multipliers the sum of |multipliers| below the diagonal,
 * place by place. The next pivot's column goes first in each step, so that its division overlaps with the other
 * columns. */
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

/* One block row: X, V and E, or the pivoting path if the diagonal's pivots are too small. */
VEC_INLINE int row_factor(const BlockFactor *f, const BlockRow *row, BlockReport *report)
{
    const Block before = block_load(row->before);
    Block s = block_load(row->diag), u = block_load(row->after);
    const Vec scale = row_sums(row_sums(vec_zero(), &before), &s);
    s = block_minus(s, &before, row->v_before); /* (L2) */
    const Vec sums = row_sums(vec_zero(), &s);
    Vec inverse, multipliers;
    eliminate(&s, &u, &inverse, &multipliers);
    UNROLL for (int c = 0; c < B; ++c)
    {
        s.c[c] = vec_mul(s.c[c], inverse);
        u.c[c] = vec_mul(u.c[c], inverse);
    }
    const Block e = block_times(&s, row->before);
    block_store(row->back, &u);
    block_store(row->front, &s);
    block_store(row->front + CELL, &e);
    const double growth = vec_max(vec_div(sums, vec_add(scale, vec_set(DBL_MIN))));
    if (!(growth <= f->growth_limit)) return LIN_UNSTABLE;
    if (growth > report->growth) report->growth = growth;
    const double smallness = vec_sum(vec_mul(vec_abs(inverse), scale));
    if (vec_sum(multipliers) <= multipliers_max && smallness <= smallness_max) return 0;
    ++report->pivoted;
    return block_row_pivoted(f, row);
}

/* The rows of one side, from the end of the chain to the middle. */
static int side_factor(const BlockFactor *f, const BlockChain *a, int top, BlockReport *report)
{
    const int count = top ? f->middle : f->n - 1 - f->middle, step = top ? 1 : -1;
    const double *const before = top ? a->lower : a->upper, *const after = top ? a->upper : a->lower;
    for (int k = 0, i = top ? 0 : f->n - 1; k < count; ++k, i += step) {
        const BlockRow row = {.diag = a->diag + i * CELL,
                              .before = k ? before + i * CELL : block_zero,
                              .after = after + i * CELL,
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

/* S = D - L V of both neighbours: what comes from below is taken off first, the rest is a row like the others, the last
 * of the top side. */
static int kernel_factor_middle(const BlockFactor *f, const BlockChain *a, BlockReport *report)
{
    double diag[CELL + W] = {0};
    const int m = f->middle, first = m == 0, last = m + 1 == f->n;
    const double *const upper = last ? block_zero : a->upper + m * CELL;
    const Block below = block_load(upper);
    const Block s = block_minus(block_load(a->diag + m * CELL), &below, last ? block_zero : f->back + (m + 1) * CELL);
    block_store(diag, &s);
    const BlockRow row = {.diag = diag,
                          .before = first ? block_zero : a->lower + m * CELL,
                          .after = upper,
                          .v_before = first ? block_zero : f->back + (m - 1) * CELL,
                          .front = f->front + 2 * m * CELL,
                          .back = f->back + m * CELL};
    return row_factor(f, &row, report);
}

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

/* z_i = X r - E z_before (L5); z holds z_before and receives z_i. */
VEC_INLINE void row_forward(const BlockFactor *f, int i, int count, const double *x, Vec z[])
{
    const Block inverse = block_load(f->front + 2 * i * CELL), e = block_load(f->front + (2 * i + 1) * CELL);
    UNROLL for (int r = 0; r < count; ++r)
    {
        z[r] = minus_times(times(&inverse, row_load(f, x + r * f->n * B, i)), &e, z[r]);
        vec_store(z_at(f, i, r), z[r]);
    }
}

/* The top side takes the middle row along. */
VEC_INLINE void forward(const BlockFactor *f, int sides, int count, const double *x)
{
    const int top = sides & SIDE_TOP ? f->middle + 1 : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - f->middle : 0;
    Vec down[BLOCK_RHS], up[BLOCK_RHS];
    UNROLL for (int r = 0; r < count; ++r) down[r] = up[r] = vec_zero();
    int k = 0;
    for (; k < top && k < bottom; ++k) {
        row_forward(f, k, count, x, down);
        row_forward(f, f->n - 1 - k, count, x, up);
    }
    for (int i = k; i < top; ++i) row_forward(f, i, count, x, down);
    for (int i = k; i < bottom; ++i) row_forward(f, f->n - 1 - i, count, x, up);
}

/* x_i = z_i - V x_next (L6); next holds x_next and receives x_i, which goes to x unless that is NULL. */
VEC_INLINE void row_back(const BlockFactor *f, int i, int count, double *x, Vec next[])
{
    const Block v = block_load(f->back + i * CELL);
    UNROLL for (int r = 0; r < count; ++r)
    {
        next[r] = minus_times(vec_load(z_at(f, i, r)), &v, next[r]);
        if (x) vec_store_short(x + (r * f->n + i) * B, next[r]);
    }
}

/* Each side computes the middle row for itself, from z below it; the top writes it. */
VEC_INLINE void back(const BlockFactor *f, int sides, int count, double *x)
{
    const int m = f->middle, top = sides & SIDE_TOP ? m : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - m : 0;
    Vec up[BLOCK_RHS], down[BLOCK_RHS];
    UNROLL for (int r = 0; r < count; ++r) up[r] = m + 1 < f->n ? vec_load(z_at(f, m + 1, r)) : vec_zero();
    row_back(f, m, count, sides & SIDE_TOP ? x : NULL, up);
    UNROLL for (int r = 0; r < count; ++r) down[r] = up[r];
    int k = 0;
    for (; k < top && k < bottom; ++k) {
        row_back(f, m - 1 - k, count, x, up);
        row_back(f, m + 1 + k, count, x, down);
    }
    for (int i = k; i < top; ++i) row_back(f, m - 1 - i, count, x, up);
    for (int i = k; i < bottom; ++i) row_back(f, m + 1 + i, count, x, down);
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
