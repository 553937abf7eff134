/* What planar_lanes.c offers to planar.c, once for every instruction set. */
#ifndef HAWSER_CORE_PLANAR_PLANAR_KERNELS_H
#define HAWSER_CORE_PLANAR_PLANAR_KERNELS_H

#include "core/base/isa.h"
#include "core/planar/planar_data.h"

typedef struct PlanarKernels {
    void (*kinematics)(const PlanarChain *chain, const double *y, int from, int to, PlanarKinematics *kin);
    double (*joint_loads)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                          PlanarJointLoads *loads);
    void (*tension)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, double *tension);
    int (*rates)(const PlanarChain *chain, const PlanarKinematics *kin, const PlanarJointLoads *joints,
                 const PlanarLoads loads[2], int from, int to, double *ydot);
    void (*joint_blocks)(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, PlanarBlocks *k,
                         PlanarBlocks *d);
    void (*blocks_join)(PlanarBlocks *blocks, int from, int to);
} PlanarKernels;

extern const PlanarKernels planar_kernels_generic, planar_kernels_avx2, planar_kernels_avx512;

#endif
