/* The chain's weight, and what the lead-in behind the route takes of it. docs/model.md, "Loads" (F1). */
#ifndef HAWSER_SIM_WEIGHT_H
#define HAWSER_SIM_WEIGHT_H

#include "core/push.h"
#include "sim/scene.h"

/* How many segments from the tail on have not passed the route's start by `past` m; 0 without a lead-in. p[c] are their
 * centres' coordinates. What has passed it stays so where the route turns back, behind the start. */
int weight_behind(const Scene *scene, const double *const p[3], double past);
/* The same for n of them, with `dims` coordinates; none where the lead-in holds what it has, and the tail is elsewhere.
 */
int weight_first_past(int n, int dims, const double *const p[], const double *origin, const double *direction, int held,
                      double past);
/* Writes (does not add) the weight of segments from..to-1 into loads, with what the lead-in does to those of them that
 * are among the first `behind`. Returns what it does to the motion. */
Push weight_loads(const Scene *scene, const Kinematics *kin, int from, int to, int behind, Loads *loads);
/* Adds the derivatives of that to the diagonal blocks of k and d. */
void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d);

#endif
