/* The data of the planar chain's Newton matrix, shared by planar_newton.c and its kernels. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_NEWTON_DATA_H
#define HAWSER_SIM_PLANAR_PLANAR_NEWTON_DATA_H

#include "core/planar/planar.h"
#include "linsolve/linsolve.h"

typedef struct PlanarNewton {
    const PlanarChain *chain; /* borrowed */
    int middle;               /* segments before it are the first half; a multiple of LANES */
    PlanarBlocks k, d;        /* at the linearisation point */
    BlockChain a;             /* M - gamma D - gamma^2 K */
    double *z[3];             /* gamma times the positions' residuals; chain arrays */
    double *x;                /* [3 stride] reduced right-hand side and solution, row by row */
    double gamma;             /* s, of a */
    LinSolver *solver;
    Team *team; /* borrowed; NULL: one thread */
} PlanarNewton;

#endif
