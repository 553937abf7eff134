#include "linsolve/small.h"

#include <math.h>

static double largest(int count, const double *a)
{
    double most = 0;
    for (int k = 0; k < count; ++k) {
        if (!isfinite(a[k])) return NAN;
        most = fmax(most, fabs(a[k]));
    }
    return most;
}

/* Swaps rows i and j of all columns. */
static void rows_swap(int n, double *a, int i, int j)
{
    if (i == j) return;
    for (int c = 0; c < n; ++c) {
        const double t = a[c * n + i];
        a[c * n + i] = a[c * n + j];
        a[c * n + j] = t;
    }
}

/* Row from k on with the largest entry in column k. */
static int pivot_row(int n, const double *a, int k)
{
    int best = k;
    for (int i = k + 1; i < n; ++i) {
        if (fabs(a[k * n + i]) > fabs(a[k * n + best])) best = i;
    }
    return best;
}

int small_lu_factor(int n, double *a, int *pivot)
{
    const double scale = largest(n * n, a);
    if (!isfinite(scale)) return 1;
    for (int k = 0; k < n; ++k) {
        pivot[k] = pivot_row(n, a, k);
        rows_swap(n, a, k, pivot[k]);
        double *const column = a + k * n;
        if (!(fabs(column[k]) > 1e-14 * scale)) return 1;
        for (int i = k + 1; i < n; ++i) column[i] /= column[k];
        for (int c = k + 1; c < n; ++c) {
            const double t = a[c * n + k];
            for (int i = k + 1; i < n; ++i) a[c * n + i] -= t * column[i];
        }
    }
    return 0;
}

void small_lu_solve(int n, const double *lu, const int *pivot, double *x)
{
    for (int k = 0; k < n; ++k) { /* L, with the rows as they were swapped */
        const double t = x[pivot[k]];
        x[pivot[k]] = x[k];
        x[k] = t;
    }
    for (int k = 0; k < n; ++k) {
        for (int i = k + 1; i < n; ++i) x[i] -= x[k] * lu[k * n + i];
    }
    for (int k = n - 1; k >= 0; --k) { /* U */
        x[k] /= lu[k * n + k];
        for (int i = 0; i < k; ++i) x[i] -= x[k] * lu[k * n + i];
    }
}
