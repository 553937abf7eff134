/* What acts on the chain's own ends: the back tension on the tail, the drag of the rope behind the eye. docs/model.md,
 * "Loads" (F2), (F3). */
#ifndef HAWSER_SIM_EQUIPMENT_ENDS_H
#define HAWSER_SIM_EQUIPMENT_ENDS_H

#include "sim/scene.h"

/* What the tail's tension does at the tail's end (F2). */
typedef struct TailPull {
    Vec3 force;  /* N */
    Vec3 along;  /* unit: the route's tangent there */
    Vec3 turned; /* N/m: by what the force changes as the end moves along that */
} TailPull;

/* The tail's end at `end` (m), near the place `near` (m) of the route. */
TailPull tail_pull(const Scene *scene, double t, Vec3 end, double near);
/* Where it is along the route, m, if it was near the place `near`; `anew`: it may have been laid elsewhere, and if it
 * has, nothing is known but how far the winch has hauled. */
double tail_place(const Scene *scene, double t, Vec3 end, double near, int anew);

/* The drag acts on the first segment of the rope, as long as that is simulated. */
void drag_place(Scene *scene);
/* The drag over the axial speed (m/s), signed against the motion, N, and its slope (F3). */
double drag_size(const Drag *drag, double speed, double *slope);

#endif
