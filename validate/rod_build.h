/* Rods for the suite: chains without a route, weightless and straight along x unless said otherwise. */
#ifndef HAWSER_VALIDATE_ROD_BUILD_H
#define HAWSER_VALIDATE_ROD_BUILD_H

#include "validate/build.h"

/* A rod of n segments and `length` (m) of this cable, with room for 3 loads and 1 motion of the head; its ends are
 * free. Undamped, no gravity; statics in `steps` load steps from t = 0 to 1 s. Errors: MEMORY (nothing is left
 * allocated). */
hawser_status rod_start(SceneDef *def, CableDef cable, double length, int n, int steps, hawser_error *err);

/* Every component of an end. */
void rod_clamp(RodEndDef *end);
/* The place alone: free to turn all the way round. */
void rod_pin(RodEndDef *end);

/* A value in a direction: all the time, or growing from nothing at t = 0 in proportion to time to this size at 1 s. The
 * latter owns a table. Errors: MEMORY. */
RodProfile rod_steady(Vec3 direction, double size);
hawser_status rod_growing(Vec3 direction, double size, RodProfile *out, hawser_error *err);
/* Adds a dead force (N) or moment (N m) at `at` m from the tail. */
void rod_add_load(SceneDef *def, double at, int moment, RodProfile by);

#endif
