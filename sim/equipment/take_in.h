/* The winch that takes the rope in: a segment that has passed it leaves the chain and becomes the ghost that holds the
 * next one, a whole rigid segment whose pose moves on along the pull as the rope does. docs/model.md, "Reel and
 * take-in" (RL16). */
#ifndef HAWSER_SIM_EQUIPMENT_TAKE_IN_H
#define HAWSER_SIM_EQUIPMENT_TAKE_IN_H

#include "core/base/vec3.h"
#include "core/chain.h"

typedef struct TakeIn {
    int present;
    Vec3 place; /* m, where the winch stands */
    /* of the segment that was taken last: how it moved besides following the winch */
    double since;     /* s */
    Vec3 drift, spin; /* m/s, rad/s; they die out over TAKE_IN_FADE */
} TakeIn;

/* The segment is taken at time t. */
void take_in_begin(TakeIn *w, double t, Vec3 drift, Vec3 spin);
/* Adds to the ghost's pose and motion (segment n), which follow the winch, what is left of drift and spin. */
void take_in_ghost(const TakeIn *w, double t, int n, Kinematics *kin);

#endif
