/* Small dense matrices: LU for leaf bodies and borders, for which a library call costs more than the computation, and
 * LAPACK's threads more than that; eigenvalues by LAPACK, which is loaded for them. */
#ifndef HAWSER_LINSOLVE_SMALL_H
#define HAWSER_LINSOLVE_SMALL_H

#include "hawser/hawser.h"

/* a [n*n], column-major, becomes L (unit diagonal) and U of the rows in the order of pivot[n]: at step k rows k and
 * pivot[k] were swapped. Returns 0, or 1 if a pivot is rounding relative to the entries of a, or these are not
 * finite. */
int small_lu_factor(int n, double *a, int *pivot);
/* x [n] becomes the solution. */
void small_lu_solve(int n, const double *lu, const int *pivot, double *x);

/* S z = mu T z for matrices [n*n], column-major, which are overwritten. symmetric: both are symmetric and T is positive
 * definite; then `imaginary` is all zero. mu and imaginary [n] are in LAPACK's order; z [n*n] has the vectors, a
 * complex pair's as real and imaginary part in two columns. Errors: MEMORY, RUN (LAPACK is not there, or failed). */
hawser_status small_eigen(int n, int symmetric, double *s, double *t, double *mu, double *imaginary, double *z,
                          hawser_error *err);

#endif
