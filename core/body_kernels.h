/* What body_lanes.c offers to body.c, once for every instruction set. */
#ifndef HAWSER_CORE_BODY_KERNELS_H
#define HAWSER_CORE_BODY_KERNELS_H

#include "core/base/isa.h"
#include "core/chain.h"

typedef struct BodyKernels {
    void (*kinematics)(int n, const double *y, int from, int to, Kinematics *kin);
    void (*rates)(const Chain *chain, const Kinematics *kin, const JointLoads *joints, const Loads loads[2],
                  const double *y, int from, int to, double *ydot);
} BodyKernels;

extern const BodyKernels body_kernels_generic, body_kernels_avx2, body_kernels_avx512;

#endif
