/* Loads on the chain's ends: the back tension on the tail, the drag of the rope behind the eye. docs/theory.md, "Loads"
 * (F2), (F3). */
#ifndef HAWSER_SIM_EQUIPMENT_ENDS_H
#define HAWSER_SIM_EQUIPMENT_ENDS_H

#include "sim/scene.h"

/* Back tension at the tail's end (F2). */
typedef struct TailPull {
    Vec3 force;  /* N */
    Vec3 along;  /* unit: the route's tangent there */
    Vec3 turned; /* N/m: change of the force as the end moves along the tangent */
} TailPull;

/* Back tension at the tail's end at `end` (m), near the place `near` (m) of the route. */
TailPull tail_pull(const Scene *scene, double t, Vec3 end, double near);
/* Place of the tail's end along the route, m, if it was near `near`; `anew`: it may have been laid elsewhere, and
 * the place is then also sought from the one by the winch's travel. */
double tail_place(const Scene *scene, double t, Vec3 end, double near, int anew);

/* Places the drag on the first segment of the rope, as long as that is simulated. */
void drag_place(Scene *scene);
/* Drag over the axial speed (m/s), signed against the motion, N, and its slope (F3). */
double drag_size(const Drag *drag, double speed, double *slope);

#endif
