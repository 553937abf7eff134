/* LU with row pivoting of small dense matrices: leaf bodies and borders, for which a library call costs more than the
 * work, and LAPACK's threads more than that. */
#ifndef HAWSER_LINSOLVE_SMALL_LU_H
#define HAWSER_LINSOLVE_SMALL_LU_H

/* a [n*n], column-major, becomes L (unit diagonal) and U of the rows in the order pivot[n] says: at step k rows k and
 * pivot[k] were swapped. 0, or 1 if a pivot is rounding against the entries of a, or these are not finite. */
int small_lu_factor(int n, double *a, int *pivot);
/* x [n] becomes the solution. */
void small_lu_solve(int n, const double *lu, const int *pivot, double *x);

#endif
