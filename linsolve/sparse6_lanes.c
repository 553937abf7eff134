/* The kernels of linsolve/block.h, in the widest vectors of each instruction set. */
#define BLOCK_B       6
#define BLOCK_W       8
#define PART6_generic 2
#define PART6_avx2    4
#define PART6_avx512  8
#define BLOCK_PART    ISA_NAME(PART6)
#include "linsolve/block.h"
#include "linsolve/block_substitute.h"

/* a b, b in memory. */
VEC_INLINE Block block_times(const Block *a, const double *b)
{
    Block t;
    UNROLL for (int c = 0; c < B; ++c) t.c[c] = vec_scale(a->c[0], vec_fill(b[c * B] - (Part){0}).p[0]);
    UNROLL for (int k = 1; k < B; ++k)
    {
        UNROLL for (int c = 0; c < B; ++c) t.c[c] = vec_plus(t.c[c], a->c[k], b[c * B + k] - (Part){0});
    }
    return t;
}

/* Inverts the pivot block of step k in place (L16): by its diagonal, or with pivoting if that is too small (L7). */
VEC_INLINE int pivot_invert(const BlockSparse *s, int k, BlockReport *report)
{
    double *const diag = s->value + k * CELL, kept[CELL + W], v[CELL], x[2 * CELL + W];
    Block a = block_load(diag), none;
    UNROLL for (int c = 0; c < B; ++c) none.c[c] = vec_zero();
    const Vec sums = row_sums(vec_zero(), &a), scale = vec_load(s->scale + k * W);
    memcpy(kept, diag, CELL * sizeof *diag);
    Vec inverse, multipliers;
    eliminate(&a, &none, &inverse, &multipliers);
    UNROLL for (int c = 0; c < B; ++c) a.c[c] = vec_mul(a.c[c], inverse);
    double own[CELL + W];
    block_store(own, &a);
    memcpy(diag, own, CELL * sizeof *diag);
    const double growth = vec_max(vec_div(sums, vec_add(scale, vec_set(DBL_MIN))));
    if (!(growth <= s->growth_limit)) return LIN_UNSTABLE;
    if (growth > report->growth) report->growth = growth;
    const double smallness = vec_sum(vec_mul(vec_abs(inverse), scale));
    if (vec_sum(multipliers) <= multipliers_max && smallness <= smallness_max) return 0;
    ++report->pivoted;
    const BlockRow row = {
        .diag = kept, .before = block_zero, .after = block_zero, .v_before = block_zero, .front = x, .back = v};
    if (block_row_pivoted(&(BlockFactor){.b = B}, &row)) return LIN_UNSTABLE;
    memcpy(diag, x + CELL, CELL * sizeof *diag);
    return 0;
}

static int kernel_factor(const BlockSparse *s, BlockReport *report)
{
    const BlockPattern *const t = &s->pattern;
    double *const lower = s->value + (size_t)t->n * CELL, *const upper = lower + (size_t)t->start[t->n] * CELL;
    for (int k = 0; k < t->n; ++k) {
        if (pivot_invert(s, k, report)) return LIN_UNSTABLE;
        const Block x = block_load(s->value + k * CELL);
        const int from = t->start[k], to = t->start[k + 1];
        double v[CELL + W];
        for (int q = from; q < to; ++q) { /* (L17) */
            const Block product = block_times(&x, upper + q * CELL);
            block_store(v, &product);
            memcpy(upper + q * CELL, v, CELL * sizeof *v);
        }
        const int *update = t->update + t->updates[k];
        for (int p = from; p < to; ++p) { /* (L18) */
            const Block l = block_load(lower + p * CELL);
            for (int q = from; q < to; ++q, ++update) {
                double *const at = s->value + (size_t)*update * CELL;
                const Block less = block_minus(block_load(at), &l, upper + q * CELL);
                UNROLL for (int c = 0; c + 1 < B; ++c) vec_store(at + c * B, less.c[c]);
                vec_store_short(at + (B - 1) * B, less.c[B - 1]);
            }
        }
    }
    return 0;
}

static void kernel_solve(const BlockSparse *s, double *x)
{
    const BlockPattern *const t = &s->pattern;
    const double *const lower = s->value + (size_t)t->n * CELL, *const upper = lower + (size_t)t->start[t->n] * CELL;
    for (int k = 0; k < t->n; ++k) {
        memcpy(s->z + k * W, x + t->row[k] * B, B * sizeof *x);
        memset(s->z + k * W + B, 0, (W - B) * sizeof *x);
    }
    for (int k = 0; k < t->n; ++k) {
        const Block inverse = block_load(s->value + k * CELL);
        const Vec z = times(&inverse, vec_load(s->z + k * W));
        vec_store(s->z + k * W, z);
        for (int p = t->start[k]; p < t->start[k + 1]; ++p) {
            double *const at = s->z + t->below[p] * W;
            const Block l = block_load(lower + p * CELL);
            vec_store(at, minus_times(vec_load(at), &l, z));
        }
    }
    for (int k = t->n - 1; k >= 0; --k) {
        Vec z = vec_load(s->z + k * W);
        for (int q = t->start[k]; q < t->start[k + 1]; ++q) {
            const Block v = block_load(upper + q * CELL);
            z = minus_times(z, &v, vec_load(s->z + t->below[q] * W));
        }
        vec_store(s->z + k * W, z);
        vec_store_short(x + t->row[k] * B, z);
    }
}

const SparseKernels ISA_NAME(sparse6_kernels) = {.factor = kernel_factor, .solve = kernel_solve};
