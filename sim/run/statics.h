/* Static equilibria one after the other while the loads change with time, and linear vibrations about the last: the
 * lowest modes, by subspace iteration with Newton's own matrix. docs/model.md, "Rods" (RD8), (RD10)-(RD14),
 * (RD16)-(RD20), (RD23). */
#ifndef HAWSER_SIM_RUN_STATICS_H
#define HAWSER_SIM_RUN_STATICS_H

#include "sim/run/stage.h"

/* Moves the stage on to equilibrium under the loads of time `target` (s), by as many smaller load steps as it takes.
 * Where equilibria stop being stable stage->stability gets the load; the definition's analysis.stability says what
 * then. out adds up what it took. On failure the stage is left at the last equilibrium that was found. Errors: MEMORY,
 * RUN (says where and what to try). */
hawser_status statics_advance(Stage *stage, double target, hawser_relaxation *out, hawser_error *err);
/* Equilibrium at the stage's own time: by Newton's method, otherwise by the continuation in time of sim/newton/relax.h.
 * Not reaching it is not an error. Errors: MEMORY. */
hawser_status statics_settle(Stage *stage, double share, hawser_relaxation *out, hawser_error *err);

typedef struct Modes {
    int n, segments;  /* of modes found; of the chain */
    hawser_mode *out; /* [n], by rising frequency */
    double *shape;    /* [n][6 segments]: dx dy dz, rx ry rz of every segment, the largest displacement 1 m */
    int iterations;
} Modes;

/* The lowest `wanted` modes (or all there are) about the stage's state of now, which must be an equilibrium; friction
 * and damping left out. radius: 0, or that of inertia of newton_swell, m: then omega^2 has the right sign and no more.
 * Errors: INPUT (rollers that move), MEMORY, RUN. modes_free may follow either way. */
hawser_status modes_find(Stage *stage, int wanted, double radius, Modes *modes, hawser_error *err);
void modes_free(Modes *modes);
/* omega^2 (1/s2) that rounding of the stiffest spring may make or hide (RD13). */
double modes_rounding(const Chain *chain, double radius);

#endif
