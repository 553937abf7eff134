/* What acts on the chain's own ends: the back tension on the tail, the drag of the rope behind the eye. docs/model.md,
 * "Loads" (F2), (F3). */
#ifndef HAWSER_SIM_EQUIPMENT_ENDS_H
#define HAWSER_SIM_EQUIPMENT_ENDS_H

#include "sim/scene.h"

/* The drag acts on the first segment of the rope, as long as that is simulated. */
void drag_place(Scene *scene);
/* The drag over the axial speed (m/s), signed against the motion, N, and its slope (F3). */
double drag_size(const Drag *drag, double speed, double *slope);

#endif
