/* The finite-difference twin of self_blocks: kept to test it. */
#ifndef HAWSER_CONTACT_SELF_SELF_CONTACT_FD_H
#define HAWSER_CONTACT_SELF_SELF_CONTACT_FD_H

#include "contact/self/self_contact.h"

/* Central differences of self_forces as dense matrices k, d [6n x 6n], column-major, rows [force; moment] of every
 * segment, columns [dx; dphi] and [dv; dw]. Steps and the use of kin as in contact_fd.h. 0 if there is no memory. */
int self_blocks_fd(const SelfModel *model, const Chain *chain, Kinematics *kin, double friction_scale, SelfPairs *pairs,
                   double step, double speed_step, double *k, double *d);

#endif
