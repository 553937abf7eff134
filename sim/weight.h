/* The chain's weight, and what the lead-in behind the route takes of it. docs/model.md, "Loads" (F1). */
#ifndef HAWSER_SIM_WEIGHT_H
#define HAWSER_SIM_WEIGHT_H

#include "core/push.h"
#include "sim/scene.h"

/* Writes (does not add) the weight of segments from..to-1, with what the lead-in does to them, into loads. Returns what
 * the lead-in does to the motion. */
Push weight_loads(const Scene *scene, const Kinematics *kin, int from, int to, Loads *loads);
/* Adds the derivatives of that to the diagonal blocks of k and d. */
void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d);

#endif
