/* What a case says of a chain away from equipment: the air or water around it, and the speeds it begins with. Parts of
 * SceneDef (def/scene_def.h). SI; components are the world's. */
#ifndef HAWSER_DEF_FLIGHT_DEF_H
#define HAWSER_DEF_FLIGHT_DEF_H

#include "core/base/vec3.h"

/* A fluid that fills all space and streams evenly. docs/model/82-medium.md (MD1)-(MD6). */
typedef struct MediumDef {
    double density;            /* kg/m3; 0: there is none */
    Vec3 velocity;             /* m/s: the current or the wind */
    double normal, tangential; /* drag coefficients across (by the diameter) and along (by the circumference), 1 */
    int buoyancy;              /* the fluid carries the weight of what the chain displaces */
} MediumDef;

/* Velocity at a place of the chain. */
typedef struct LaunchRow {
    double at;     /* m from the tail */
    double along;  /* m/s, along the chain toward the head */
    Vec3 velocity; /* m/s, added to that */
} LaunchRow;

/* How the chain moves at t = 0: the sum of all these. (MD7), (MD8) */
typedef struct LaunchDef {
    int present;
    double along;        /* m/s, of the whole chain along itself */
    Vec3 velocity, spin; /* m/s, rad/s: of the whole chain as a rigid body about `about` */
    int about_given;
    Vec3 about; /* m; if it is not given, the centre of mass */
    int n_rows;
    LaunchRow *row; /* [n_rows], owned; places rise, between two it is linear, outside as at the nearest */
} LaunchDef;

#endif
