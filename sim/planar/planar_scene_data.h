/* The data of a planar scene, shared by planar_scene.c and its kernels. */
#ifndef HAWSER_SIM_PLANAR_PLANAR_SCENE_DATA_H
#define HAWSER_SIM_PLANAR_PLANAR_SCENE_DATA_H

#include "contact/planar/planar_contact.h"
#include "core/push.h"
#include "sim/planar/plane.h"

/* Gravity along the chain (F1), as Weight. */
typedef struct PlanarWeight {
    double gravity[2]; /* m/s2 */
    int lead_in;
    double lost[2];      /* what of gravity is missing behind the start, m/s2 */
    double origin[2];    /* m */
    double direction[2]; /* unit */
    double blend, hold, hold_damping;
} PlanarWeight;

typedef struct PlanarScene {
    const Scene *scene; /* borrowed */
    Plane plane;
    PlanarChain chain;
    PlanarWeight weight;
    double winch_origin[2], winch_direction[2], winch_angle; /* m, unit, rad */
    PlanarRoller *roller;                                    /* [rollers] */
} PlanarScene;

#endif
