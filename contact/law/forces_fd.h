/* Derivatives of any forces on the segments by finite differences: what the twins of the analytic derivatives share. */
#ifndef HAWSER_CONTACT_LAW_FORCES_FD_H
#define HAWSER_CONTACT_LAW_FORCES_FD_H

#include "core/base/vec3.h"
#include "core/block_chain.h"
#include "core/chain.h"

/* Adds the forces in question to loads, which are zero. */
typedef void (*ForcesOf)(void *arg, const Kinematics *kin, Loads *loads);

/* Adds central differences of forces and moments to k (by shifts and turns) and d (by velocities), 6x6 blocks, world.
 * Steps: `step` in m and rad for the configuration (rotations are applied on the left, world), `speed_step` in m/s and
 * rad/s. kin is changed meanwhile and restored; its quaternions are not used. Returns the largest entry found outside
 * the three block diagonals, which must be zero; -1 if there is no memory. */
double forces_fd(ForcesOf forces, void *arg, const Chain *chain, Kinematics *kin, double step, double speed_step,
                 BlockChain *k, BlockChain *d);

#endif
