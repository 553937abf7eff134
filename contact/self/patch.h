/* The contact of a piece of one cable's line with another stretch of line: the integral of an elastic bed over the
 * piece, damping, friction, and the derivatives of all that. docs/model.md, "Cable on cable"; letters as there. */
#ifndef HAWSER_CONTACT_SELF_PATCH_H
#define HAWSER_CONTACT_SELF_PATCH_H

#include "contact/self/patch_data.h"

/* The piece of element e between u_0 and u_1 (length m at rest) over the feet at v of the elements foot. Returns 0 if
 * nothing is pressed: then only the geometry is filled in. */
int patch_at(const Chain *chain, const Kinematics *kin, const PatchLaw *law, double friction_scale, int e,
             const double u[2], double length, const int foot[2], const double v[2], Patch *patch);

/* What the patch does to slot s (CC12). */
PatchWrench patch_wrench(const Patch *patch, int s);

/* Derivatives of all slots' wrenches by coordinate c of slot s: 0..2 shifts, 3..5 turns, 6..8 velocities, 9..11
 * angular velocities, world (CC13)-(CC17). */
void patch_column(const Patch *patch, const PatchLaw *law, int s, int c, PatchWrench out[PATCH_SLOTS]);

/* The largest depth on the piece, m; negative: the least distance between the surfaces. */
double patch_depth(const Patch *patch);

#endif
