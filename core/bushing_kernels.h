/* What bushing_lanes.c offers to bushing.c, once for every instruction set. */
#ifndef HAWSER_CORE_BUSHING_KERNELS_H
#define HAWSER_CORE_BUSHING_KERNELS_H

#include "core/base/isa.h"
#include "core/base/lanes.h"
#include "core/chain.h"

/* Derivatives of LANES joints' force, moment on A and moment on B (9 rows) with respect to relative displacement,
 * rotation of A and rotation of B (9 columns), or to the rates of these; world. */
typedef struct JointMatrix {
    double entry[9][9][LANES]; /* [column][row][joint] */
} JointMatrix;

typedef struct BushingKernels {
    JointPower (*loads)(const Chain *chain, const Kinematics *kin, int from, int to, JointLoads *loads);
    void (*law)(const Chain *chain, const Kinematics *kin, int from, int to, double *const law[6]);
    void (*columns)(const Chain *chain, const Kinematics *kin, int joint, JointMatrix *k, JointMatrix *d);
    JointEnergy (*energy)(const Chain *chain, const Kinematics *kin, int from, int to);
    void (*slip)(const Chain *chain, Kinematics *kin, int from, int to);
} BushingKernels;

extern const BushingKernels bushing_kernels_generic, bushing_kernels_avx2, bushing_kernels_avx512;

#endif
