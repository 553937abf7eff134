/* Eigenvalues of small dense pairs of matrices, by LAPACK, which is loaded for it. */
#ifndef HAWSER_LINSOLVE_SMALL_EIGEN_H
#define HAWSER_LINSOLVE_SMALL_EIGEN_H

#include "hawser/hawser.h"

/* S z = mu T z for matrices [n*n], column-major, which are overwritten. symmetric: both are symmetric and T is positive
 * definite; then `imaginary` is all zero. mu and imaginary [n] are in LAPACK's order; z [n*n] has the vectors, a
 * complex pair's as real and imaginary part in two columns. Errors: MEMORY, RUN (LAPACK is not there, or failed). */
hawser_status small_eigen(int n, int symmetric, double *s, double *t, double *mu, double *imaginary, double *z,
                          hawser_error *err);

#endif
