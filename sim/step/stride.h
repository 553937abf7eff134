/* How far the chain may move in one step. Contacts are looked at where a step ends, so that a longer one could carry
 * the cable through a roller, or through itself, without either having been noticed. docs/model.md, "Integration"
 * (N14). */
#ifndef HAWSER_SIM_STEP_STRIDE_H
#define HAWSER_SIM_STEP_STRIDE_H

#include "sim/scene.h"

/* The way in m; INFINITY where there is nothing to pass through. */
double stride_most(const Scene *scene);

/* Largest speed of a point of the chain, or up to sqrt(2) of it, m/s: sqrt(|v|^2 + (half |w|)^2) of n segments. v is
 * `dims` arrays `pitch` apart, w `turns` arrays. */
double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w);

#endif
