/* Stability of equilibria, and the loads at which they lose it. docs/theory.md, "Rods" (RD16)-(RD19), (RD24). */
#ifndef HAWSER_SIM_RUN_STATICS_H
#define HAWSER_SIM_RUN_STATICS_H

#include "sim/run/stage.h"

/* Successive static equilibria while the loads change with time. docs/theory.md, "Rods" (RD8), (RD16)-(RD20), (RD23).
 */

/* Moves the stage to equilibrium under the loads of time `target` (s), by smaller load steps where needed. Where
 * equilibria lose stability stage->stability gets the load; the definition's analysis.stability decides what follows.
 * out adds up the effort. On failure the stage is left at the last equilibrium found. Errors: MEMORY, RUN (with the
 * place and a remedy). */
hawser_status statics_advance(Stage *stage, double target, hawser_relaxation *out, hawser_error *err);
/* Finds equilibrium at the stage's own time: by Newton's method, otherwise by the continuation in time of
 * sim/solve/relax.h. Not reaching it is not an error. Errors: MEMORY. */
hawser_status statics_settle(Stage *stage, double share, hawser_relaxation *out, hawser_error *err);

#endif
