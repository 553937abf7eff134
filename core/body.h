/* The segments as rigid bodies: state to kinematics, loads to accelerations, and the derivatives of inertia.
 * docs/theory.md, "Segments". */
#ifndef HAWSER_CORE_BODY_H
#define HAWSER_CORE_BODY_H

#include "core/block_chain.h"
#include "core/bushing.h"
#include "core/chain.h"
#include "core/machine.h"
#include "core/state.h"
#include "core/vec3.h"

/* Adds to the rotation parts of k and d the contributions of the rotating inertia and of the gyroscopic moment to
 * d(moment - I w')/d(phi) and /d(w) (S4), for segments from..to-1; ydot holds w'. */
void body_blocks(const Chain *chain, const Kinematics *kin, const double *ydot, int from, int to, BlockChain *k,
                 BlockChain *d);

/* The inertia of segment i about its centre times a, world, kg m2 * a. */
Vec3 body_inertia_times(const Chain *chain, const Kinematics *kin, int i, Vec3 a);

/* ------------------------------------------------------------------------------------------------------ kernels */

/* Loss of a step in time: the work of all forces along the path of the bodies, less their gain of kinetic energy; and
 * their kinetic energy at the end, J. docs/theory.md, "Balances" (BA11). */
typedef struct MethodLoss {
    double lost, moving;
} MethodLoss;
enum { BODY_PAST = 19 }; /* numbers kept of a step per segment: p q v w (body axes), force, moment (body axes) */

/* The loops over segments (body_lanes.c), once for every instruction set: body_kernels()->rates(...). `from` is a
 * multiple of LANES. */
typedef struct BodyKernels {
    /* Energy that a step took out of segments from..to-1 (BA11), and their kinetic energy at its end; see MethodLoss.
     * rates: of y, times 1 / scale. past [BODY_PAST * stride], stride: n rounded up to whole lanes: data of the step
     * before, of this one on return. */
    MethodLoss (*method_loss)(const Chain *chain, const double *y, const double *rates, double scale, int from, int to,
                              double *past);
    /* Unpacks segments from..to-1 of y (core/state.h) into kin: quaternions are normalised, axes derived. Entries up to
     * the next multiple of LANES after `to` are overwritten: set the head ghost afterwards. */
    void (*kinematics)(int n, const double *y, int from, int to, Kinematics *kin);
    /* Rates of y for segments from..to-1 (S1)-(S3): v, half w q, (sum of forces)/m, and Euler's equation, from the
     * joints' loads and the two sets of other loads on the segments. y is needed for its quaternions as they are (not
     * normalised). */
    void (*rates)(const Chain *chain, const Kinematics *kin, const JointLoads *joints, const Loads loads[2],
                  const double *y, int from, int to, double *ydot);
} BodyKernels;

ISA_KERNELS(BodyKernels, body_kernels)

#endif
