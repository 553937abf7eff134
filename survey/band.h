/* Linear equations with a band matrix, in doubles, with row exchanges. A matrix of n rows with entries at most `half`
 * columns from the diagonal is stored by rows of 3 half + 1: entry (i, j) at [i][j - i + half]; the last third is for
 * fill-in by the exchanges. */
#ifndef HAWSER_SURVEY_BAND_H
#define HAWSER_SURVEY_BAND_H

#include <math.h>
#include <stddef.h>

static inline double *band_at(double *a, int half, int i, int j)
{
    return &a[(size_t)i * (size_t)(3 * half + 1) + (size_t)(j - i + half)];
}

/* Exchanges row i and row k >= i from column i on. */
static inline void band_swap(double *a, int half, int i, int k, int last)
{
    for (int j = i; j <= last; ++j) {
        double *const x = band_at(a, half, i, j), *const y = band_at(a, half, k, j), kept = *x;
        *x = *y;
        *y = kept;
    }
}

/* Solves a x = b; b becomes x, a is overwritten. Returns 0 if it is singular. */
static inline int band_solve(int n, int half, double *a, double *b)
{
    for (int i = 0; i < n; ++i) {
        const int below = i + half < n ? i + half : n - 1, last = i + 2 * half < n ? i + 2 * half : n - 1;
        int pivot = i;
        for (int k = i + 1; k <= below; ++k) {
            if (fabs(*band_at(a, half, k, i)) > fabs(*band_at(a, half, pivot, i))) pivot = k;
        }
        if (!(fabs(*band_at(a, half, pivot, i)) > 0)) return 0;
        if (pivot != i) {
            const double kept = b[i];
            band_swap(a, half, i, pivot, last);
            b[i] = b[pivot];
            b[pivot] = kept;
        }
        for (int k = i + 1; k <= below; ++k) {
            const double factor = *band_at(a, half, k, i) / *band_at(a, half, i, i);
            if (factor == 0) continue;
            for (int j = i; j <= last; ++j) *band_at(a, half, k, j) -= factor * *band_at(a, half, i, j);
            b[k] -= factor * b[i];
        }
    }
    for (int i = n - 1; i >= 0; --i) {
        const int last = i + 2 * half < n ? i + 2 * half : n - 1;
        for (int j = i + 1; j <= last; ++j) b[i] -= *band_at(a, half, i, j) * b[j];
        b[i] /= *band_at(a, half, i, i);
    }
    return 1;
}

#endif
