/* Whether equilibria are stable, and the loads at which they stop being so. docs/model.md, "Rods" (RD16)-(RD19),
 * (RD24). */
#ifndef HAWSER_SIM_STAGE_STABILITY_H
#define HAWSER_SIM_STAGE_STABILITY_H

#include "sim/stage/stage.h"

/* The radius of inertia of segments with which signs are counted, m: a tenth of the rod (RD16). */
double stability_radius(const Chain *chain);
/* With it, -omega^2 (1/s2) of the slowest growth that is told from rounding (RD16). */
double stability_least(const Chain *chain);

/* How many independent motions grow from the stage's state as an equilibrium under the loads of its time, into
 * *unstable (-1: it cannot be said); *swings: none of them without swinging. Errors: MEMORY. */
hawser_status stability_count(Stage *stage, int *unstable, int *swings, hawser_error *err);

/* The motion that grows first, beside its load: into shape [6 n] as a mode's, its largest turn 1 rad or its largest
 * shift the rod's length, whichever is less. Of `count` motions that become possible together (a round section bends
 * either way) that which has the sense of the way from `from` [n positions] to the stage's state. count 0: they swing,
 * and that which grows fastest is wanted. Errors: MEMORY, RUN. */
hawser_status stability_shape(Stage *stage, int count, const double *from, double *shape, hawser_error *err);
/* How much of the change of the loads from the stage's time to t pushes along that motion, 0 to 1 (RD18). Errors:
 * MEMORY. */
hawser_status stability_push(Stage *stage, double t, const double *shape, double *share, hawser_error *err);
/* Moves the stage's state along it by `size`. */
void stability_nudge(Stage *stage, double size, const double *shape);

/* Adds a critical load; takes `shape`, which may be NULL. Errors: MEMORY (shape is freed). */
hawser_status stability_add(Stage *stage, hawser_critical found, double *shape, hawser_error *err);
/* Takes back the last one that was added. */
void stability_take_back(Stage *stage);

#endif
