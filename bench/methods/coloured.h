/* The sparse Jacobian of the unreduced rates by difference quotients, as its user has to make it for SUNDIALS' KLU:
 * columns that share no row are moved together. Three neighbouring segments' columns differ, so there are three colours
 * a component, and as many evaluations. */
#ifndef HAWSER_BENCH_METHODS_COLOURED_H
#define HAWSER_BENCH_METHODS_COLOURED_H

#include <sundials/sundials_matrix.h>

#include "bench/methods/problem.h"

typedef struct Coloured {
    const Problem *p;
    sunindextype *column, *row; /* [size + 1], [entries]: CSC */
    double *y, *f;              /* [size]: a moved state, its rates */
    long rhs;
} Coloured;

int coloured_new(Coloured *c, const Problem *p);
void coloured_free(Coloured *c);
sunindextype coloured_entries(const Coloured *c);
/* Fills a (SUNMATRIX_SPARSE, CSC) at (t, y) with rates fy. Returns as MotionOps.rates. */
int coloured_jacobian(Coloured *c, double t, const double *y, const double *fy, SUNMatrix a);

#endif
