/* The chain in three dimensions, 13 numbers a segment (core/state.h), as the integrator sees it. */
#ifndef HAWSER_SIM_STEP_SPATIAL_H
#define HAWSER_SIM_STEP_SPATIAL_H

#include "sim/dynamics.h"
#include "sim/newton/newton.h"
#include "sim/step/motion.h"

typedef struct Spatial {
    Motion motion; /* first: a Motion is the Spatial that it begins */
    Workspace *ws;
    Newton *newton;
} Spatial;

/* Scene, workspace and Newton matrix are borrowed. Returns &s->motion. */
Motion *spatial_init(Spatial *s, const Scene *scene, Workspace *ws, Newton *newton);

#endif
