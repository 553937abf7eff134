/* The finite-difference twins of contact_blocks, surface_blocks and self_blocks, kept to test these. Everything that
 * the analytic derivatives could have forgotten is in the forces by construction. */
#ifndef HAWSER_TESTS_SUPPORT_CONTACT_FD_H
#define HAWSER_TESTS_SUPPORT_CONTACT_FD_H

#include "contact/roller.h"
#include "contact/self.h"
#include "contact/surface.h"

/* Steps: `step` in m and rad for the configuration (rotations are applied on the left, world), `speed_step` in m/s and
 * rad/s. kin is changed meanwhile and restored; its quaternions are not used.
 *
 * The first two add central differences of the forces to k and d, as contact_blocks and surface_blocks add derivatives;
 * they return the largest entry found outside the three block diagonals, which must be zero, or -1 if there is no
 * memory. */
double contact_blocks_fd(const ContactModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         ContactPairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d);
double surface_blocks_fd(const SurfaceModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         SurfacePairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d);
/* The differences as dense matrices k, d [6n x 6n], column-major, rows [force; moment] of every segment, columns
 * [dx; dphi] and [dv; dw], so that what couples segments that the pattern does not hold would show. 0 if there is no
 * memory. */
int self_blocks_fd(const SelfModel *model, const Chain *chain, Kinematics *kin, double friction_scale, SelfPairs *pairs,
                   double step, double speed_step, double *k, double *d);

#endif
