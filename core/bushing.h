/* The six-component bushings between neighbouring segments: their wrenches and the derivatives of these.
 * docs/theory.md, "Bushing". */
#ifndef HAWSER_CORE_BUSHING_H
#define HAWSER_CORE_BUSHING_H

#include "core/block_chain.h"
#include "core/chain.h"
#include "core/lanes.h"
#include "core/machine.h"

/* Accepts a step: the sliders of joints from..to-1 follow the rotations of kin, where these exceed their limits (HY8),
 * into kin->slip. Wrenches at the same kinematics do not change (HY9); their derivatives do. */
void bushing_slip(const Chain *chain, Kinematics *kin, int from, int to);

/* Adds the derivatives of the bushings' forces and moments to k (with respect to position and rotation, 6x6 blocks
 * [force; moment] by [dx; dphi], world) and d (with respect to velocity and angular velocity) (B10)-(B14). Joints
 * from..to-1; only a block row's own two joints add to it. Ghosts have no rows: their parts are dropped. */
void bushing_blocks(const Chain *chain, const Kinematics *kin, int from, int to, BlockChain *k, BlockChain *d);

/* ------------------------------------------------------------------------------------------------------ kernels */

/* Derivatives of LANES joints' force, moment on A and moment on B (9 rows) with respect to relative displacement,
 * rotation of A and rotation of B (9 columns), or to the rates of these; world. */
typedef struct JointMatrix {
    double entry[9][9][LANES]; /* [column][row][joint] */
} JointMatrix;

/* The loops over joints (bushing_lanes.c), once for every instruction set: bushing_kernels()->loads(...). Kinematics
 * have their ghosts; `from` is a multiple of LANES. */
typedef struct BushingKernels {
    /* Wrenches of joints from..to-1; joints up to the next multiple of LANES after `to` may be written too. Returns the
     * power that these joints take out of the motion. */
    JointPower (*loads)(const Chain *chain, const Kinematics *kin, int from, int to, JointLoads *loads);
    /* The law's own components of every joint (B8): law[0..2] force, law[3..5] moment, in the bushing's frame, N and
     * N m; law[0] is the axial force, positive in tension. */
    void (*law)(const Chain *chain, const Kinematics *kin, int from, int to, double *const law[6]);
    /* Derivatives of the wrenches of LANES joints from `joint` on. */
    void (*columns)(const Chain *chain, const Kinematics *kin, int joint, JointMatrix *k, JointMatrix *d);
    /* Energy stored in joints from..to-1. */
    JointEnergy (*energy)(const Chain *chain, const Kinematics *kin, int from, int to);
    /* bushing_slip */
    void (*slip)(const Chain *chain, Kinematics *kin, int from, int to);
} BushingKernels;

ISA_KERNELS(BushingKernels, bushing_kernels)

#endif
