/* What the error test measures in forces: errors of velocities that a step would make, as what they are in tensions and
 * in loads. docs/model.md, "Integration" (N21)-(N23). */
#ifndef HAWSER_SIM_STEP_FORCE_ERROR_H
#define HAWSER_SIM_STEP_FORCE_ERROR_H

#include "sim/scene.h"

/* What errors of the chain's velocities are in momentum, N s. */
typedef struct Surge {
    double
        chain; /* along the cable, between whichever two joints most of it is: what a tension would have to make up */
    double segment; /* of one segment, in any direction, turning included: what a load would */
} Surge;

/* Of errors of n segments: of velocities v (m/s), `dims` arrays `pitch` apart, and angular ones w (rad/s), `turns` such
 * arrays. axis [dims]: the segments' unit axes. */
Surge surge_of(const Chain *chain, int dims, double *const *axis, int pitch, const double *v, int turns,
               const double *w);

/* What errors of forces are compared with. */
typedef struct ForceScale {
    double tension, load; /* N, that the accuracy allows (N21), (N22) */
    double quick;         /* s: what is over sooner is motion within a segment and its joint (N23) */
    Surge noise;          /* what the iteration may leave, and is not judged (N24) */
} ForceScale;

/* now, most: the chain's largest tension, now and so far, N; left: what Newton's iteration may leave in a velocity,
 * m/s. Nothing is allowed, and nothing is judged, in a chain of a single segment. */
ForceScale force_scale(const Scene *scene, double now, double most, double left);

/* The errors as multiples of what is allowed, with what the method makes of a rate's error: gamma, s (N21). */
double force_error(const Surge *surge, const ForceScale *scale, double gamma);

#endif
