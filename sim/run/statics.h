/* Whether equilibria are stable, and the loads at which they stop being so. docs/model.md, "Rods" (RD16)-(RD19),
 * (RD24). */
#ifndef HAWSER_SIM_RUN_STATICS_H
#define HAWSER_SIM_RUN_STATICS_H

#include "sim/run/stage.h"

/* Static equilibria one after the other while the loads change with time. docs/model.md, "Rods" (RD8), (RD16)-(RD20),
 * (RD23). */

/* Moves the stage on to equilibrium under the loads of time `target` (s), by as many smaller load steps as it takes.
 * Where equilibria stop being stable stage->stability gets the load; the definition's analysis.stability says what
 * then. out adds up what it took. On failure the stage is left at the last equilibrium that was found. Errors: MEMORY,
 * RUN (says where and what to try). */
hawser_status statics_advance(Stage *stage, double target, hawser_relaxation *out, hawser_error *err);
/* Equilibrium at the stage's own time: by Newton's method, otherwise by the continuation in time of sim/solve/relax.h.
 * Not reaching it is not an error. Errors: MEMORY. */
hawser_status statics_settle(Stage *stage, double share, hawser_relaxation *out, hawser_error *err);

#endif
