/* The elastic bed over a patch; for contact/patch*.c only. */
#ifndef HAWSER_CONTACT_SELF_PATCH_BED_H
#define HAWSER_CONTACT_SELF_PATCH_BED_H

#include "contact/self/patch_data.h"

/* Where the piece is pressed, and the forces on its ends (CC2)-(CC6); 0 if it is pressed nowhere. */
int bed_integrate(Patch *patch, const PatchLaw *law);

/* What a change of the two separations (m) and of R (m) does to the bed's forces (N) and moments m0, m1 (m) (CC15). */
void bed_vary(const Patch *patch, const Vec3 w_by[2], double radius_by, Vec3 g_by[2], double *m0_by, double *m1_by);

#endif
