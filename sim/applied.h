/* The loads that the scene applies by itself: weight with the lead-in, the tail's tension, the rope's drag; and their
 * derivatives. docs/model.md, "Loads" (F1)-(F4). */
#ifndef HAWSER_SIM_APPLIED_H
#define HAWSER_SIM_APPLIED_H

#include "sim/scene.h"

/* Writes (does not add) the applied loads of time t into loads. */
void applied_loads(const Scene *scene, const Kinematics *kin, double t, double friction, Loads *loads);
/* Adds their derivatives to the diagonal blocks of k and d. */
void applied_blocks(const Scene *scene, const Kinematics *kin, double t, double friction, BlockChain *k, BlockChain *d);

#endif
