/* The finite-difference twin of contact_blocks: kept to test it. */
#ifndef HAWSER_CONTACT_ROLLER_CONTACT_FD_H
#define HAWSER_CONTACT_ROLLER_CONTACT_FD_H

#include "contact/roller/contact.h"

/* Adds central differences of contact_forces to k and d, as contact_blocks adds derivatives. Steps: `step` in
 * m and rad for the configuration (rotations are applied on the left, world), `speed_step` in m/s and rad/s.
 * kin is changed meanwhile and restored; its quaternions are not used. Returns the largest entry found
 * outside the three block diagonals, which must be zero; -1 if there is no memory. */
double contact_blocks_fd(const ContactModel *model, const Chain *chain, Kinematics *kin, double friction_scale,
                         ContactPairs *pairs, double step, double speed_step, BlockChain *k, BlockChain *d);

#endif
