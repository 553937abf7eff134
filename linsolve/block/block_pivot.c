/* The rare path of the block LU: a row whose diagonal pivots are too small gets full partial pivoting, in plain C. */
#include <math.h>
#include <string.h>

#include "linsolve/backend.h"
#include "linsolve/block/block_factor.h"

enum { B_MAX = 6, W_MAX = 8 };

const double block_zero[B_MAX * B_MAX + W_MAX];

/* [S | after | I], column-major; Gauss-Jordan turns it into [I | V | X]. */
typedef struct Augmented {
    int b;
    double a[3 * B_MAX][B_MAX];
    double scale[B_MAX]; /* row sums of |S|: pivots are compared after scaling by them */
} Augmented;

static void augment(const BlockFactor *f, const BlockRow *row, Augmented *g)
{
    const int b = f->b;
    memset(g, 0, sizeof *g);
    g->b = b;
    for (int c = 0; c < b; ++c) {
        memcpy(g->a[c], row->diag + c * b, (size_t)b * sizeof(double));
        memcpy(g->a[b + c], row->after + c * b, (size_t)b * sizeof(double));
        g->a[2 * b + c][c] = 1;
        for (int k = 0; k < b; ++k) {
            for (int r = 0; r < b; ++r) g->a[c][r] -= row->before[k * b + r] * row->v_before[c * b + k];
        }
        for (int r = 0; r < b; ++r) g->scale[r] += fabs(g->a[c][r]);
    }
}

/* The row at or below k with the largest scaled entry in column k. */
static int pivot_row(const Augmented *g, int k)
{
    int best = k;
    for (int r = k + 1; r < g->b; ++r) {
        if (fabs(g->a[k][r]) * g->scale[best] > fabs(g->a[k][best]) * g->scale[r]) best = r;
    }
    return best;
}

static void rows_swap(Augmented *g, int r, int s)
{
    const double scale = g->scale[r];
    g->scale[r] = g->scale[s];
    g->scale[s] = scale;
    for (int c = 0; c < 3 * g->b; ++c) {
        const double entry = g->a[c][r];
        g->a[c][r] = g->a[c][s];
        g->a[c][s] = entry;
    }
}

static void column_eliminate(Augmented *g, int k)
{
    const double inverse = 1 / g->a[k][k];
    double m[B_MAX];
    for (int r = 0; r < g->b; ++r) m[r] = r == k ? 0 : g->a[k][r] * inverse;
    for (int c = k; c < 3 * g->b; ++c) {
        const double p = g->a[c][k];
        for (int r = 0; r < g->b; ++r) g->a[c][r] -= m[r] * p;
        g->a[c][k] = p * inverse;
    }
}

int block_row_pivoted(const BlockFactor *f, const BlockRow *row)
{
    static const double singular = 1e-14; /* pivot over row sum: the rest is rounding */
    const int b = f->b;
    Augmented g;
    augment(f, row, &g);
    for (int k = 0; k < b; ++k) {
        const int p = pivot_row(&g, k);
        if (!(fabs(g.a[k][p]) > singular * g.scale[p])) return LIN_UNSTABLE;
        if (p != k) rows_swap(&g, p, k);
        column_eliminate(&g, k);
    }
    for (int c = 0; c < b; ++c) {
        memcpy(row->back + c * b, g.a[b + c], (size_t)b * sizeof(double));
        memcpy(row->front + (b + c) * b, g.a[2 * b + c], (size_t)b * sizeof(double));
    }
    return 0;
}
