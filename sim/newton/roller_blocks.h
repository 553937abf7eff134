/* From the contacts' derivatives by a roller's pose and motion to those by its unknowns. docs/model.md, "Rollers that
 * spin and rollers on mounts", (SP11), (SP12). */
#ifndef HAWSER_SIM_NEWTON_ROLLER_BLOCKS_H
#define HAWSER_SIM_NEWTON_ROLLER_BLOCKS_H

#include "sim/equipment/roller_motion.h"

/* One moving roller: of its `size` unknowns six (a mount's) or none have a position. Column-major. */
typedef struct RollerLeaf {
    int size, positions; /* 1, 6 or 7; 0 or 6 */
    int first;           /* its first unknown in the solver's order */
    int wide;            /* linearisations in a row at which it touched more than two neighbours */
    int border;          /* its first column of the border; -1: it is a leaf */
    double mass[ROLLER_UNKNOWNS];
    /* at the linearisation point */
    Vec3 turning; /* angular velocity of the mount, rad/s */
    int touched, room, *block;
    double k_own[6 * ROLLER_UNKNOWNS], d_own[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS]; /* [positions][size], [size][size] */
    double (*k_into)[36], (*d_into)[6 * ROLLER_UNKNOWNS];                        /* [room]: [positions][6], [size][6] */
    double (*k_from)[6 * ROLLER_UNKNOWNS], (*d_from)[6 * ROLLER_UNKNOWNS];       /* [room]: [6][size] */
    /* for gamma (SP13) */
    double diag[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS];
    double (*into)[6 * ROLLER_UNKNOWNS], (*from)[6 * ROLLER_UNKNOWNS]; /* [room] */
} RollerLeaf;

/* K and D of moving roller k: own, into and from, all of what it touches, into leaf; friction scales the bearing. */
void roller_blocks(const EquipmentWork *w, int k, const double *e, double friction, RollerLeaf *leaf);

#endif
