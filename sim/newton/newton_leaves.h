/* The moving rollers' share of Newton's matrix: leaves and border around the chain. docs/model.md, "Rollers that spin
 * and rollers on mounts", (SP11)-(SP13). Called by newton.c alone, but for newton_leaves_point. */
#ifndef HAWSER_SIM_NEWTON_NEWTON_LEAVES_H
#define HAWSER_SIM_NEWTON_NEWTON_LEAVES_H

#include "core/base/lanes.h"
#include "sim/equipment/roller_motion.h"
#include "sim/newton/newton_data.h"

/* ------------------------------------------------------------------------------------------------- one roller */

/* What a roller and a segment that it touches do to each other; [columns][rows]. */
typedef struct LeafTouch {
    int block;                                                       /* the segment */
    double k_into[36], d_into[6 * ROLLER_UNKNOWNS];                  /* [positions][6], [size][6] */
    double k_from[6 * ROLLER_UNKNOWNS], d_from[6 * ROLLER_UNKNOWNS]; /* [6][size] */
    double into[6 * ROLLER_UNKNOWNS], from[6 * ROLLER_UNKNOWNS];     /* of both, for gamma (SP13) */
} LeafTouch;

/* One moving roller: of its `size` unknowns six (a mount's) or none have a position. Column-major. */
typedef struct RollerLeaf {
    int size, positions; /* 1, 6 or 7; 0 or 6 */
    int first;           /* its first unknown in the solver's order */
    int wide;            /* linearisations in a row at which it touched more than two neighbours */
    int border;          /* its first column of the border; -1: it is a leaf */
    double mass[ROLLER_UNKNOWNS];
    /* at the linearisation point */
    Vec3 turning; /* angular velocity of the mount, rad/s */
    double k_own[6 * ROLLER_UNKNOWNS + LANES], d_own[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS + LANES]; /* [positions][size],
                                                                                                  * [size][size] */
    int touched, room;
    LeafTouch *touch; /* [room] */
    /* for gamma (SP13) */
    double diag[ROLLER_UNKNOWNS * ROLLER_UNKNOWNS];
} RollerLeaf;

/* K and D of moving roller k: own, into and from, all of what it touches, into leaf; friction scales the bearing. */
void roller_blocks(const EquipmentWork *w, int k, const double *e, double friction, RollerLeaf *leaf);

/* ------------------------------------------------------------------------------------------------- all of them */

enum { BORDER_MOST = 64 }; /* unknowns of rollers that may be in the border: its columns are dense */

typedef struct NewtonLeaves {
    const Equipment *q; /* borrowed */
    RollerLeaf *item;   /* [q->n] */
    Newton mounts;      /* the mounts as segments, for the elimination of their positions; without a solver */
    NewtonMatrix *matrix;
    Leaf *leaf; /* [q->n], of the matrix */
    double *right, *bottom, *corner;
} NewtonLeaves;

/* Around nw->a, into nw->matrix. Errors: MEMORY. */
hawser_status newton_leaves_new(Newton *nw, const Equipment *q, hawser_error *err);
NewtonLeaves *newton_leaves_free(NewtonLeaves *l);
/* Takes over the linearisation point from what dynamics_blocks left in the workspace; friction as there. */
void newton_leaves_point(NewtonLeaves *l, const EquipmentWork *w, const double *e, double friction);
/* After the chain's: leaves and border for nw->gamma. */
void newton_leaves_form(Newton *nw);
/* After the chain's elimination: the equipment's rows of nw->x, and what its positions do to the chain's; b: the
 * equipment's part of the right-hand side. */
void newton_leaves_reduce(Newton *nw, const double *b);
/* Before or after the chain's: b from nw->x. */
void newton_leaves_expand(Newton *nw, double *b);
/* Moves rollers that keep touching too much into the border; 1 if the pattern is another one now, for which the caller
 * makes a new solver, 0 if not, -1 without memory. */
int newton_leaves_widen(Newton *nw, EquipmentWork *w);

/* What is known of the rollers at the linearisation point, and which of them are in the border. */
void newton_leaves_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w);

#endif
