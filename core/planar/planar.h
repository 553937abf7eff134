/* A chain that moves in one plane: three degrees of freedom a segment (two coordinates, one angle), and all that
 * core/body.h and core/bushing.h do, in that plane. docs/model.md, "Planar chain". */
#ifndef HAWSER_CORE_PLANAR_PLANAR_H
#define HAWSER_CORE_PLANAR_PLANAR_H

#include "core/planar/planar_data.h"

/* All zero but the inverse masses, which are 1; 0 if there is no memory (then nothing is allocated). */
int planar_chain_alloc(PlanarChain *chain, int n);
void planar_chain_free(PlanarChain *chain);
int planar_kinematics_alloc(PlanarKinematics *kin, int n);
void planar_kinematics_free(PlanarKinematics *kin);
int planar_loads_alloc(PlanarLoads *loads, int n);
void planar_loads_free(PlanarLoads *loads);
int planar_joint_loads_alloc(PlanarJointLoads *loads, int n);
void planar_joint_loads_free(PlanarJointLoads *loads);
int planar_blocks_alloc(PlanarBlocks *blocks, int n);
void planar_blocks_free(PlanarBlocks *blocks);

/* n filled up to whole lanes. */
int planar_stride(int n);

/* Unpacks segments from..to-1 of y. from is a multiple of LANES; entries up to the next multiple of LANES after `to`
 * are overwritten: set the head's ghost afterwards. */
void planar_kinematics(const PlanarChain *chain, const double *y, int from, int to, PlanarKinematics *kin);
/* Wrenches of joints from..to-1, ghosts included (PL5)-(PL7); from is a multiple of LANES, and joints up to the next
 * one after `to` are overwritten. Returns what the joints' damping takes out of the motion, W (BA4). */
double planar_joint_loads(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                          PlanarJointLoads *loads);
/* Axial force of joints from..to-1, N; from and `to` as above. */
void planar_tension(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, double *tension);
/* Rates of y, segments from..to-1 (PL2), from the joints' loads and two sets of other loads. `to` is a multiple of
 * LANES or n; then what pads the arrays gets zeros. Returns 0 if a rate is not finite. */
int planar_rates(const PlanarChain *chain, const PlanarKinematics *kin, const PlanarJointLoads *joints,
                 const PlanarLoads loads[2], int from, int to, double *ydot);
/* Writes the derivatives of the wrenches of joints from..to-1 to k and d (PL8)-(PL10): lower, upper and front, and to
 * diag what they give to the segments after them. from is a multiple of LANES. Blocks of the ghosts are written too
 * where the arrays have room for them. */
void planar_joint_blocks(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, PlanarBlocks *k,
                         PlanarBlocks *d);
/* Once all joints are there: adds front to the diagonals of segments from..to-1; from is a multiple of LANES. */
void planar_blocks_join(PlanarBlocks *blocks, int from, int to);
/* Zeroes what couples the chain of n with its ghosts. */
void planar_blocks_trim(PlanarBlocks *blocks, int n);

#endif
