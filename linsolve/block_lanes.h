/* Kernels of the twisted block LU, written once in vectors of one block column; block6_lanes.c and block3_lanes.c set the
 * sizes and include this. A row's elimination works in registers on its pivot block and the coupling that follows;
 * everything fixed in size is unrolled by the compiler. Letters as in docs/model.md, "Linear solvers". */
#include <float.h>
#include <stdint.h>
#include <string.h>

#include "linsolve/backend.h"
#include "linsolve/block_factor.h"

enum { B = BLOCK_B, W = BLOCK_W, CELL = BLOCK_B * BLOCK_W };

typedef double Vec __attribute__((vector_size(BLOCK_W * sizeof(double))));
typedef int64_t Mask __attribute__((vector_size(BLOCK_W * sizeof(double))));

#define VEC_INLINE static inline __attribute__((always_inline))

/* Limits of the fast path (L7): the sum of the multipliers, and row sum over pivot. */
static const double multipliers_max = 30, smallness_max = 1e13;

VEC_INLINE Vec vec_load(const double *p)
{
    Vec v;
    memcpy(&v, p, sizeof v);
    return v;
}

VEC_INLINE void vec_store(double *p, Vec v) { memcpy(p, &v, sizeof v); }

/* A column of the chain: b values, then the next column's first, which are masked out. */
VEC_INLINE Vec column_load(const double *p)
{
    static const Mask keep = BLOCK_KEEP;
    return (Vec)((Mask)vec_load(p) & keep);
}

VEC_INLINE Vec vec_abs(Vec v) { return (Vec)((Mask)v & INT64_MAX); }

/* All places get v's place k (a constant once the loops are unrolled). */
VEC_INLINE Vec splat(Vec v, int k)
{
    switch (k) {
    case 0: return BLOCK_SPLAT(v, 0);
    case 1: return BLOCK_SPLAT(v, 1);
    case 2: return BLOCK_SPLAT(v, 2);
#if BLOCK_B > 3
    case 3: return BLOCK_SPLAT(v, 3);
    case 4: return BLOCK_SPLAT(v, 4);
    case 5: return BLOCK_SPLAT(v, 5);
#endif
    default: __builtin_unreachable();
    }
}

/* All bits set in places from <= place < to. */
VEC_INLINE Mask places(int from, int to)
{
    Mask m = {0};
    for (int k = 0; k < W; ++k) m[k] = k >= from && k < to ? -1 : 0;
    return m;
}

VEC_INLINE double vec_sum(Vec v)
{
    double s = v[0] + v[1];
    for (int k = 2; k < B; ++k) s += v[k];
    return s;
}

/* What one row's elimination gathers for its checks, place by place. */
typedef struct Checks {
    Vec multipliers; /* sum of |multipliers| below the diagonal */
    Vec inverses;    /* |1 / pivot| in the pivot's place */
} Checks;

/* Step k of Gauss-Jordan on [s | u] with the pivot on the diagonal (L3): s becomes its inverse column by column. */
VEC_INLINE void eliminate(Vec s[B], Vec u[B], int k, Checks *checks)
{
    const Mask own = places(k, k + 1), below = places(k + 1, B);
    const Vec r = 1 / splat(s[k], k);
    const Vec m = s[k] * r;
    const Vec minus = (Vec)(((Mask)m & ~own) | ((Mask)-r & own));
    checks->multipliers += (Vec)((Mask)m & (below & INT64_MAX));
    checks->inverses = (Vec)((Mask)checks->inverses | ((Mask)r & (own & INT64_MAX)));
    for (int c = 0; c < B; ++c) {
        const Vec p = splat(s[c], k), q = splat(u[c], k);
        if (c != k) s[c] = (Vec)((Mask)s[c] & ~own) - minus * p;
        u[c] = (Vec)((Mask)u[c] & ~own) - minus * q;
    }
    s[k] = -minus;
}

/* S = diag - before V (L2), copying `before` on the way; scale gets the row sums of |diag| + |before|. */
VEC_INLINE void schur(const BlockRow *row, Vec s[B], Vec *scale)
{
    Vec l[B];
    *scale = (Vec){0};
    for (int c = 0; c < B; ++c) {
        l[c] = column_load(row->before + c * B);
        s[c] = column_load(row->diag + c * B);
        vec_store(row->front + c * W, l[c]);
        *scale += vec_abs(l[c]) + vec_abs(s[c]);
    }
    for (int c = 0; c < B; ++c) {
        for (int k = 0; k < B; ++k) s[c] -= l[k] * row->v_before[c * W + k];
    }
}

/* One block row: X and V, or the pivoting path if the diagonal's pivots are too small. */
static __attribute__((noinline)) int row_factor(const BlockFactor *f, const BlockRow *row, BlockReport *report)
{
    Vec s[B], u[B], scale, sum = {0};
    Checks checks = {{0}, {0}};
    schur(row, s, &scale);
    for (int c = 0; c < B; ++c) {
        u[c] = column_load(row->after + c * B);
        sum += vec_abs(s[c]);
    }
    for (int k = 0; k < B; ++k) eliminate(s, u, k, &checks);
    for (int c = 0; c < B; ++c) {
        vec_store(row->front + CELL + c * W, s[c]);
        vec_store(row->back + c * W, u[c]);
    }
    const double growth = vec_sum(sum / (scale + DBL_MIN));
    if (!(growth <= f->growth_limit)) return LIN_UNSTABLE;
    if (growth > report->growth) report->growth = growth;
    if (vec_sum(checks.multipliers) <= multipliers_max && vec_sum(checks.inverses * scale) <= smallness_max) return 0;
    ++report->pivoted;
    return block_row_pivoted(f, row);
}

static int kernel_factor(const BlockFactor *f, const BlockChain *a, int sides, BlockReport *report)
{
    const int top = sides & SIDE_TOP ? f->middle : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - f->middle : 0;
    for (int k = 0; k < top || k < bottom; ++k) {
        if (k < top) {
            const BlockRow row = block_row(f, a, k, SIDE_TOP);
            if (row_factor(f, &row, report)) return LIN_UNSTABLE;
        }
        if (k < bottom) {
            const BlockRow row = block_row(f, a, f->n - 1 - k, SIDE_BOTTOM);
            if (row_factor(f, &row, report)) return LIN_UNSTABLE;
        }
    }
    return 0;
}

/* S = D - L V of both neighbours: what comes from below is taken off first, the rest is a row like the others. */
static int kernel_factor_middle(const BlockFactor *f, const BlockChain *a, BlockReport *report)
{
    _Alignas(64) double diag[B * B + W] = {0};
    const int m = f->middle;
    BlockRow row = block_row(f, a, m, SIDE_TOP);
    const BlockRow under = block_row(f, a, m, SIDE_BOTTOM);
    for (int c = 0; c < B; ++c) {
        Vec s = column_load(row.diag + c * B);
        for (int k = 0; k < B; ++k) s -= column_load(under.before + k * B) * under.v_before[c * W + k];
        memcpy(diag + c * B, &s, B * sizeof(double));
    }
    row.diag = diag;
    const int status = row_factor(f, &row, report);
    for (int c = 0; c < B; ++c) vec_store(f->back + m * CELL + c * W, column_load(under.before + c * B));
    return status;
}

/* Row i of a right-hand side; the last row has nothing behind it to read. */
VEC_INLINE Vec row_load(const BlockFactor *f, const double *x, int i)
{
    Vec r = {0};
    if (i + 1 == f->n) {
        memcpy(&r, x + i * B, B * sizeof(double));
        return r;
    }
    return vec_load(x + i * B);
}

VEC_INLINE void cell_load(const double *cell, Vec column[B])
{
    for (int c = 0; c < B; ++c) column[c] = vec_load(cell + c * W);
}

/* t - A x in two chains, which halves the wait for the sums. */
VEC_INLINE Vec minus_times(Vec t, const Vec a[B], Vec x)
{
    Vec odd = a[1] * splat(x, 1);
    for (int k = 0; k < B; k += 2) t -= a[k] * splat(x, k);
    for (int k = 3; k < B; k += 2) odd += a[k] * splat(x, k);
    return t - odd;
}

/* A x, likewise. */
VEC_INLINE Vec times(const Vec a[B], Vec x)
{
    Vec even = a[0] * splat(x, 0), odd = a[1] * splat(x, 1);
    for (int k = 2; k < B; k += 2) even += a[k] * splat(x, k);
    for (int k = 3; k < B; k += 2) odd += a[k] * splat(x, k);
    return even + odd;
}

VEC_INLINE double *z_at(const BlockFactor *f, int i, int rhs) { return f->z + (i * BLOCK_RHS + rhs) * W; }

/* z_i = X (r - L z_before) (L5); z holds z_before and receives z_i. */
VEC_INLINE void row_forward(const BlockFactor *f, int i, int count, const double *x, Vec z[])
{
    Vec l[B], inverse[B];
    cell_load(f->front + 2 * i * CELL, l);
    cell_load(f->front + (2 * i + 1) * CELL, inverse);
    for (int r = 0; r < count; ++r) {
        z[r] = times(inverse, minus_times(row_load(f, x + r * f->n * B, i), l, z[r]));
        vec_store(z_at(f, i, r), z[r]);
    }
}

/* r - L z_before of the middle row. */
VEC_INLINE void middle_forward(const BlockFactor *f, int count, const double *x, const Vec z[])
{
    Vec l[B];
    cell_load(f->front + 2 * f->middle * CELL, l);
    for (int r = 0; r < count; ++r) {
        vec_store(z_at(f, f->middle, r), minus_times(row_load(f, x + r * f->n * B, f->middle), l, z[r]));
    }
}

VEC_INLINE void forward(const BlockFactor *f, int sides, int count, const double *x)
{
    const int top = sides & SIDE_TOP ? f->middle : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - f->middle : 0;
    Vec down[BLOCK_RHS] = {{0}}, up[BLOCK_RHS] = {{0}};
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
    Vec u[B], inverse[B];
    cell_load(f->back + m * CELL, u);
    cell_load(f->front + (2 * m + 1) * CELL, inverse);
    for (int r = 0; r < count; ++r) {
        const Vec below = m + 1 < f->n ? vec_load(z_at(f, m + 1, r)) : (Vec){0};
        next[r] = times(inverse, minus_times(vec_load(z_at(f, m, r)), u, below));
    }
}

/* x_i = z_i - V x_next (L6); next holds x_next and receives x_i. */
VEC_INLINE void row_back(const BlockFactor *f, int i, int count, double *x, Vec next[])
{
    Vec v[B];
    cell_load(f->back + i * CELL, v);
    for (int r = 0; r < count; ++r) {
        next[r] = minus_times(vec_load(z_at(f, i, r)), v, next[r]);
        memcpy(x + (r * f->n + i) * B, &next[r], B * sizeof(double));
    }
}

VEC_INLINE void back(const BlockFactor *f, int sides, int count, double *x)
{
    const int m = f->middle;
    const int top = sides & SIDE_TOP ? m : 0, bottom = sides & SIDE_BOTTOM ? f->n - 1 - m : 0;
    Vec up[BLOCK_RHS], down[BLOCK_RHS];
    middle_back(f, count, up);
    for (int r = 0; r < count; ++r) {
        down[r] = up[r];
        if (sides & SIDE_TOP) memcpy(x + (r * f->n + m) * B, &up[r], B * sizeof(double));
    }
    int k = 0;
    for (; k < top && k < bottom; ++k) {
        row_back(f, m - 1 - k, count, x, up);
        row_back(f, m + 1 + k, count, x, down);
    }
    for (int i = k; i < top; ++i) row_back(f, m - 1 - i, count, x, up);
    for (int i = k; i < bottom; ++i) row_back(f, m + 1 + i, count, x, down);
}

/* One right-hand side, or BLOCK_RHS at once, or what is left one by one through shifted scratch. */
static void kernel_forward(const BlockFactor *f, int sides, int count, const double *x)
{
    if (count == BLOCK_RHS) {
        forward(f, sides, BLOCK_RHS, x);
        return;
    }
    BlockFactor one = *f;
    for (int r = 0; r < count; ++r, one.z += W) forward(&one, sides, 1, x + r * f->n * B);
}

static void kernel_back(const BlockFactor *f, int sides, int count, double *x)
{
    if (count == BLOCK_RHS) {
        back(f, sides, BLOCK_RHS, x);
        return;
    }
    BlockFactor one = *f;
    for (int r = 0; r < count; ++r, one.z += W) back(&one, sides, 1, x + r * f->n * B);
}

const BlockKernels ISA_NAME(BLOCK_NAME) = {
    .factor = kernel_factor, .factor_middle = kernel_factor_middle, .forward = kernel_forward, .back = kernel_back};
