/* The loads that the scene applies by itself: weight with the lead-in, the tail's tension, the rope's drag; and their
 * derivatives; and the winch's where it pulls with a set tension. docs/model.md, "Loads" (F1)-(F4). */
#ifndef HAWSER_SIM_LOADS_H
#define HAWSER_SIM_LOADS_H

#include "core/push.h"
#include "sim/scene.h"

/* Writes (does not add) the weight of segments from..to-1, with what the lead-in does to them, into loads. Returns what
 * the lead-in does to the motion. */
Push applied_weight(const Scene *scene, const Kinematics *kin, int from, int to, Loads *loads);
/* What the tail's tension of time t, and the rope's drag, do to the motion. */
Push applied_tail(const Scene *scene, const Kinematics *kin, double t);
Push applied_drag(const Scene *scene, const Kinematics *kin);
/* Adds the tail's tension of time t, the rope's drag times friction, and a winch's set tension. */
void applied_ends(const Scene *scene, const Kinematics *kin, double t, double friction, Loads *loads);
/* Adds their derivatives to the diagonal blocks of k and d. */
void applied_blocks(const Scene *scene, const Kinematics *kin, double t, double friction, BlockChain *k, BlockChain *d);

#endif
