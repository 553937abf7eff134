/* A drum with the cable wound on it, touched by every turn: for short studies and to check the reel that only pays out.
 * The drum is a roller that spins, with a brake; the layers touch it and each other; the cable's end is held to it.
 * docs/model.md, "Cable on cable", "A wound drum" (CC22)-(CC26). */
#ifndef HAWSER_SIM_EQUIPMENT_DRUM_H
#define HAWSER_SIM_EQUIPMENT_DRUM_H

#include "core/base/vec3.h"

typedef struct Drum {
    int present;
    int roller;   /* of the scene's: the barrel; its two flanges follow */
    int joints;   /* joints 0 .. joints-1 are placed below, the others along the route */
    Vec3 *joint;  /* [joints], m */
    Vec3 tangent; /* where the cable leaves the drum at the start, m */
    double hold;  /* N s/m: of the cable's end on the drum */
    double turns; /* wound at the start */
} Drum;

#endif
