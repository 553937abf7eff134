/* The data of Newton's matrix, shared by newton.c, its kernels and the unreduced system. */
#ifndef HAWSER_SIM_NEWTON_NEWTON_DATA_H
#define HAWSER_SIM_NEWTON_NEWTON_DATA_H

#include "core/state.h"
#include "linsolve/linsolve.h"

typedef struct Newton {
    int n;
    int middle;      /* segments before it are the first half of a split loop; a multiple of LANES */
    BlockChain k, d; /* derivative blocks at the linearisation point */
    BlockChain a;    /* M - gamma D - gamma^2 K S */
    /* at the linearisation point, chain arrays */
    double *mass;       /* kg */
    double *inertia[9]; /* row-major, world, kg m2 */
    double *q[4];       /* as in y (not normalised) */
    double *w[3];       /* rad/s */
    /* of one solution */
    double *z;                   /* [6n] gamma times position residual and eliminated rotation */
    double *x;                   /* [6n + extra] reduced right-hand side and solution */
    double gamma;                /* s, of a */
    LinSolver *solver;           /* of the matrix; NULL if the full system is solved */
    NewtonMatrix matrix;         /* a, and what the equipment adds */
    LinOptions options;          /* of the solver */
    struct NewtonLeaves *leaves; /* sim/newton/newton_leaves.h: rollers that move; NULL: none */
    struct NewtonFull *full;     /* klu-full: the unreduced system; NULL otherwise */
    struct NewtonExtra *extra;   /* sim/newton/newton_extra.h: blocks off the diagonals; NULL: none */
    Team *team;                  /* borrowed; NULL: one thread */
} Newton;

/* Blocks and arrays for nw->n segments, masses 1; 0 if there is no memory (what there is stays for the free, which may
 * be called on a zeroed struct). `extra` doubles are added to x for unknowns behind the chain's. */
int newton_parts_new(Newton *nw, int extra);
void newton_parts_free(Newton *nw);

#endif
