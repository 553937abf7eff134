#include "linsolve/inertia.h"

#include <float.h>
#include <math.h>
#include <stddef.h>

enum { B_MAX = 6 };

/* Factors S of one block row: its lower triangle becomes L (unit diagonal) and d: S = L diag(d) L^T. Returns the number
 * of negative d. A pivot that is only rounding counts as positive: a direction without stiffness is not unstable. */
static inline int pivots(int b, double s[B_MAX][B_MAX], double *d)
{
    int negative = 0;
    for (int c = 0; c < b; ++c) {
        const double before = fabs(s[c][c]);
        d[c] = s[c][c];
        for (int k = 0; k < c; ++k) d[c] -= s[c][k] * s[c][k] * d[k];
        if (!(fabs(d[c]) > DBL_EPSILON * DBL_EPSILON * before)) d[c] = DBL_EPSILON * before + DBL_MIN;
        negative += d[c] < 0;
        for (int r = c + 1; r < b; ++r) {
            for (int k = 0; k < c; ++k) s[r][c] -= s[r][k] * d[k] * s[c][k];
            s[r][c] /= d[c];
        }
    }
    return negative;
}

/* next -= C S^-1 C^T, C the coupling of the next row to this one [row][column] (RD16). */
static inline void pass_on(int b, double s[B_MAX][B_MAX], const double *d, double c[B_MAX][B_MAX],
                           double next[B_MAX][B_MAX])
{
    for (int r = 0; r < b; ++r) { /* rows of C become those of C L^-T */
        for (int k = 0; k < b; ++k) {
            for (int l = 0; l < k; ++l) c[r][k] -= c[r][l] * s[k][l];
        }
    }
    double over[B_MAX][B_MAX]; /* C L^-T d^-1 */
    for (int k = 0; k < b; ++k) {
        const double one = 1 / d[k];
        for (int r = 0; r < b; ++r) over[r][k] = one * c[r][k];
    }
    for (int r = 0; r < b; ++r) {
        for (int q = 0; q <= r; ++q) {
            for (int k = 0; k < b; ++k) next[r][q] -= over[r][k] * c[q][k];
        }
    }
}

/* b is a->b: a constant at each call. */
static inline int negative_of(const BlockChain *a, int b)
{
    const size_t block = (size_t)(b * b);
    double s[2][B_MAX][B_MAX] = {{{0}}}, c[B_MAX][B_MAX], d[B_MAX];
    int negative = 0;
    for (int i = 0; i < a->n; ++i) {
        double(*const now)[B_MAX] = s[i % 2], (*const next)[B_MAX] = s[(i + 1) % 2];
        const double *const diag = a->diag + block * (size_t)i;
        for (int r = 0; r < b; ++r) {
            for (int q = 0; q <= r; ++q) {
                now[r][q] = (diag[r + b * q] + diag[q + b * r]) / 2 + (i > 0 ? now[r][q] : 0);
                next[r][q] = 0;
            }
        }
        negative += pivots(b, now, d);
        if (i + 1 == a->n) break;
        const double *const lower = a->lower + block * (size_t)(i + 1), *const upper = a->upper + block * (size_t)i;
        for (int r = 0; r < b; ++r) {
            for (int q = 0; q < b; ++q) c[r][q] = (lower[r + b * q] + upper[q + b * r]) / 2;
        }
        pass_on(b, now, d, c, next);
    }
    return negative;
}

int block_chain_negative(const BlockChain *a) { return a->b == B_MAX ? negative_of(a, B_MAX) : negative_of(a, a->b); }
