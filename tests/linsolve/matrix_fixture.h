/* Block chains to solve, for the tests and the benchmark of the linear solvers. */
#ifndef HAWSER_TESTS_LINSOLVE_MATRIX_FIXTURE_H
#define HAWSER_TESTS_LINSOLVE_MATRIX_FIXTURE_H

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec3.h"
#include "linsolve/newton_matrix.h"

/* Uniform in [-1, 1], from a 64-bit linear congruential generator (Knuth's MMIX constants). */
static inline double fixture_random(uint64_t *seed)
{
    *seed = *seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(int64_t)*seed / 9223372036854775808.0;
}

static inline void fixture_fill(double *a, int count, double size, uint64_t *seed)
{
    for (int k = 0; k < count; ++k) a[k] = size * fixture_random(seed);
}

static inline double *fixture_vector(int count, uint64_t *seed)
{
    double *const v = malloc((size_t)count * sizeof *v + 1);
    fixture_fill(v, count, 1, seed);
    return v;
}

/* Dense random blocks with `shift` on the diagonal: 2 b and more is diagonally dominant. */
static inline void fixture_chain_random(BlockChain *a, int n, int b, double shift, uint64_t *seed)
{
    const int bb = b * b;
    block_chain_alloc(a, n, b);
    for (int i = 0; i < n; ++i) {
        fixture_fill(a->diag + i * bb, bb, 1, seed);
        if (i > 0) fixture_fill(a->lower + i * bb, bb, 1, seed);
        if (i + 1 < n) fixture_fill(a->upper + i * bb, bb, 1, seed);
        for (int k = 0; k < b; ++k) a->diag[i * bb + k * (b + 1)] += shift;
    }
}

/* One bushing between bodies i - 1 and i: wrench = k (relative displacement, relative rotation) at arms +h/2, -h/2,
 * for the axial, two bending planes and torsion of a cable; b = 3 keeps one bending plane. */
static inline void fixture_bushing(const BlockChain *a, int i, double *block, double side_r, double side_c,
                                   double scale)
{
    static const double axial = 1.8e8, shear = 6e7, bend = 6.5e5, twist = 5e5, half = 0.25;
    const int b = a->b;
    (void)i;
    if (b == 3) { /* x, z, rotation */
        block[0] += scale * side_r * side_c * axial;
        block[4] += scale * side_r * side_c * shear;
        block[7] -= scale * side_r * half * shear;
        block[5] -= scale * side_c * half * shear;
        block[8] += scale * (half * half * shear + side_r * side_c * bend);
        return;
    }
    block[0] += scale * side_r * side_c * axial;
    block[7] += scale * side_r * side_c * shear;
    block[14] += scale * side_r * side_c * shear;
    block[21] += scale * side_r * side_c * twist;
    for (int plane = 0; plane < 2; ++plane) {
        const int f = 1 + plane, m = 5 - plane;
        const double sign = plane ? 1 : -1;
        block[f * 6 + m] += scale * sign * side_c * half * shear;
        block[m * 6 + f] += scale * sign * side_r * half * shear;
        block[m * 7] += scale * (half * half * shear + side_r * side_c * bend);
    }
}

/* M - gamma D - gamma^2 K of a cable like the paper's (0.5 m, 23 kg a segment; the solid bar's stiffness), damping
 * proportional to stiffness, contacts under every fourth segment, and a little friction that makes it unsymmetric. */
static inline void fixture_chain_cable(BlockChain *a, int n, int b, double gamma, uint64_t *seed)
{
    static const double mass[6] = {23, 23, 23, 0.003, 0.5, 0.5};
    const int bb = b * b;
    const double scale = gamma * gamma + 1e-4 * gamma;
    block_chain_alloc(a, n, b);
    for (int i = 0; i < n; ++i) {
        double *const diag = a->diag + i * bb;
        for (int k = 0; k < b; ++k) diag[k * (b + 1)] += b == 6 ? mass[k] : k < 2 ? 23 : 0.5;
        if (i > 0) {
            fixture_bushing(a, i, diag, 1, 1, scale);
            fixture_bushing(a, i, a->diag + (i - 1) * bb, -1, -1, scale);
            fixture_bushing(a, i, a->lower + i * bb, 1, -1, scale);
            fixture_bushing(a, i, a->upper + (i - 1) * bb, -1, 1, scale);
        }
        if (i % 4 == 0) {
            const double normal = gamma * gamma * 4e6 * (1 + 0.2 * fixture_random(seed));
            diag[(b == 6 ? 2 : 1) * (b + 1)] += normal;
            diag[(b == 6 ? 2 : 1) * b] += 0.2 * normal;
        }
    }
}

/* Largest |a|. */
static inline double fixture_norm(int count, const double *a)
{
    double most = 0;
    for (int k = 0; k < count; ++k) most = larger_of(most, fabs(a[k]));
    return most;
}

/* The largest over the rows of |A x - r|_i / (|A| |x| + |r|)_i, the componentwise backward error. */
static inline double fixture_backward_error(const NewtonMatrix *a, const double *x, const double *r)
{
    const int n = newton_size(a);
    double *const residual = calloc((size_t)n, sizeof(double)), *const size = calloc((size_t)n, sizeof(double));
    double worst = 0;
    for (int k = 0; k < newton_pieces(a); ++k) {
        const Piece p = newton_piece(a, k);
        for (int c = 0; c < p.cols; ++c) {
            for (int i = 0; i < p.rows; ++i) {
                const double term = p.value[(size_t)c * (size_t)p.rows + (size_t)i] * x[p.col + c];
                residual[p.row + i] += term;
                size[p.row + i] += fabs(term);
            }
        }
    }
    for (int i = 0; i < n; ++i) {
        const double error = fabs(residual[i] - r[i]), scale = size[i] + fabs(r[i]);
        worst = larger_of(worst, scale > 0 ? error / scale : error);
    }
    free(residual);
    free(size);
    return worst;
}

#endif
