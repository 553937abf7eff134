/* Newton's matrix of the planar chain: (1 - gamma J) delta = b over the six rates of a segment, with the positions and
 * angles eliminated: 3x3 blocks. docs/model.md, "Planar chain" (PL15). */
#ifndef HAWSER_SIM_PLANAR_PLANAR_NEWTON_H
#define HAWSER_SIM_PLANAR_PLANAR_NEWTON_H

#include "sim/planar/planar_kernels.h"

hawser_status planar_newton_new(PlanarNewton *nw, const PlanarChain *chain, const LinOptions *options,
                                hawser_error *err);
void planar_newton_free(PlanarNewton *nw);
/* Forms a for gamma (s) from k and d. */
void planar_newton_form(PlanarNewton *nw, double gamma);
/* As linsolver_factor; b [6 stride] becomes the solution of (1 - gamma J) x = b. */
int planar_newton_factor(PlanarNewton *nw);
int planar_newton_solve(PlanarNewton *nw, double *b);

#endif
