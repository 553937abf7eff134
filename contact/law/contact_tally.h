/* What contacts of one kind do to the motion; docs/model.md, "Balances". */
#ifndef HAWSER_CONTACT_LAW_CONTACT_TALLY_H
#define HAWSER_CONTACT_LAW_CONTACT_TALLY_H

/* Sums over the contacts of one call. */
typedef struct ContactTally {
    double friction, damping; /* W, what they take out of the motion (BA5) */
    double edges;             /* W, what surfaces' fades do to the motion (BA10) */
    double energy;            /* J, in the springs (BA6) */
    double force[3];          /* N, on the cable */
} ContactTally;

#endif
