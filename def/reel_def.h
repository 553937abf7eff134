/* The reel or the drum behind the route: parts of SceneDef (def/scene_def.h). */
#ifndef HAWSER_DEF_REEL_DEF_H
#define HAWSER_DEF_REEL_DEF_H

#include "core/profile.h"

/* Model of the reel. The case's reader converts a weight of cable into a tail tension. */
typedef enum ReelModel { REEL_NONE, REEL_PAYOUT } ReelModel;
typedef enum BrakeLaw { BRAKE_CONSTANT, BRAKE_PROPORTIONAL, BRAKE_SPEED } BrakeLaw;

/* A drum that the cable may leave during the run; its back tension is the tail's. */
typedef struct ReelDef {
    ReelModel model;
    double distance;              /* m from where the cable leaves the drum to the route's start */
    double barrel, flange, width; /* m: diameters of the bare drum and of its flanges, length between these */
    double inertia;               /* kg m2, of the empty drum */
    double bearing;               /* N m, friction torque */
    int end_fixed;                /* the cable's end is fastened to the drum */
    BrakeLaw brake;
    double torque;   /* N m; 0: no brake */
    double at_speed; /* m/s of the cable, with a full drum, at which a proportional brake gives its torque */
    Profile speed;   /* m/s, set speed of a speed-matched brake */
    double over;     /* m/s above it at which that brake has full torque */
    double v_s;      /* m/s of the cable below which the torque of brake and bearing decays */
} ReelDef;

/* A drum with the cable behind the route wound on it, with contact at every turn. */
typedef struct DrumDef {
    int present;
    double distance;              /* m from where the cable leaves the drum to the route's start */
    double barrel, flange, width; /* m: diameters of the bare drum and of its flanges, length between these */
    double lay;                   /* m from turn to turn; 0: 2.5 diameters of the cable */
    double inertia;               /* kg m2, of the empty drum */
    double torque;                /* N m: brake and bearing */
} DrumDef;

#endif
