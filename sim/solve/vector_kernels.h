/* Loops over the state vector, once for every instruction set: CVODE's vector operations and the chain's norm. */
#ifndef HAWSER_SIM_SOLVE_VECTOR_KERNELS_H
#define HAWSER_SIM_SOLVE_VECTOR_KERNELS_H

#include "core/machine.h"

typedef struct VectorKernels {
    /* z = a x + b y; z may be x or y */
    void (*linear_sum)(int count, double a, const double *x, double b, const double *y, double *z);
    /* z = a x; z may be x */
    void (*scale)(int count, double a, const double *x, double *z);
    /* z = sum of a[k] x[k], k < terms; z may be x[0] */
    void (*combination)(int count, int terms, const double *a, double *const *x, double *z);
    /* Largest over the windows of 16 segments in from..to-1 (from: a window's first) of the sum of (x w)^2 over the
     * window's entries, divided by their number; x and w are 13 arrays of n (N11). A NaN in x or w gives a NaN. */
    double (*window_square)(int n, int from, int to, const double *x, const double *w);
    /* The same where each of the 13 arrays of w holds one number throughout: only its first entry is read. */
    double (*window_square_even)(int n, int from, int to, const double *x, const double *w);
    /* Largest over the n entries of sum of v[c]^2, c < dims, + half^2 times the sum of w[c]^2, c < turns: v[c] begins
     * at v + c pitch, w[c] likewise. NaNs are ignored. */
    double (*largest_square)(int n, int pitch, int dims, const double *v, int turns, const double *w,
                             const double *half);
    /* 1 if every entry is finite */
    int (*all_finite)(int count, const double *x);
    /* Correction of the quaternions of y (13 arrays of n) to unit length, zero elsewhere; removes from error (NULL:
     * none) its part along them (N9). Segments from..to-1, from a lane's first. */
    void (*project)(int n, int from, int to, const double *y, double *correction, double *error);
} VectorKernels;

ISA_KERNELS(VectorKernels, vector_kernels)

#endif
