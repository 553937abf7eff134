/* Newton's matrix of the planar chain: (1 - gamma J) delta = b over the six rates of a segment, with the positions and
 * angles eliminated: 3x3 blocks. docs/model.md, "Planar chain" (PL15). */
#ifndef HAWSER_SIM_PLANAR_PLANAR_NEWTON_H
#define HAWSER_SIM_PLANAR_PLANAR_NEWTON_H

#include "linsolve/linsolve.h"
#include "sim/planar/planar_scene.h"

/* The planar chain's Newton matrix (PL15). */
struct PlanarNewton {
    const PlanarChain *chain; /* borrowed */
    int middle;               /* segments before it are the first half; a multiple of LANES */
    PlanarBlocks k, d;        /* at the linearisation point */
    BlockChain a;             /* M - gamma D - gamma^2 K */
    double *z[3];             /* gamma times the positions' residuals; chain arrays */
    double *x;                /* [3 stride] reduced right-hand side and solution, row by row */
    double gamma;             /* s, of a */
    LinSolver *solver;
    Team *team; /* borrowed; NULL: one thread */
};

hawser_status planar_newton_new(PlanarNewton *nw, const PlanarChain *chain, const LinOptions *options,
                                hawser_error *err);
void planar_newton_free(PlanarNewton *nw);
/* Forms a for gamma (s) from k and d. */
void planar_newton_form(PlanarNewton *nw, double gamma);
/* b [6 stride] becomes the solution of (1 - gamma J) x = b, once solver has factored a; returns as linsolver_solve. */
int planar_newton_solve(PlanarNewton *nw, double *b);

/* The linearisation point and its factors. */
void planar_newton_checkpoint(Checkpoint *c, PlanarNewton *nw);

#endif
