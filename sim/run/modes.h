/* Linear vibrations about an equilibrium: the lowest modes, by subspace iteration with Newton's own matrix.
 * docs/theory.md, "Rods" (RD10)-(RD14). */
#ifndef HAWSER_SIM_RUN_MODES_H
#define HAWSER_SIM_RUN_MODES_H

#include "sim/run/stage.h"

typedef struct Modes {
    int n, segments;  /* number of modes found; of segments of the chain */
    hawser_mode *out; /* [n], by rising frequency */
    double *shape;    /* [n][6 segments]: dx dy dz, rx ry rz of every segment, the largest displacement 1 m */
    int iterations;
} Modes;

/* Finds the lowest `wanted` modes (or all there are) about the stage's present state, which must be an equilibrium;
 * without friction and damping. radius: 0, or the radius of inertia of newton_swell, m: then only the sign of omega^2
 * is right. Errors: INPUT (rollers that move), MEMORY, RUN. modes_free may follow either way. */
hawser_status modes_find(Stage *stage, int wanted, double radius, Modes *modes, hawser_error *err);
void modes_free(Modes *modes);
/* Size of omega^2 (1/s2) below which rounding of the stiffest spring dominates (RD13). */
double modes_rounding(const Chain *chain, double radius);

#endif
