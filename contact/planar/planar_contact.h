/* Contact of a chain that moves in a plane with fixed rollers whose axes are normal to it: circles. The same line,
 * ownership of contacts and laws as in contact.h, so that the forces are those in space. docs/model.md, "Planar chain".
 *
 * The candidates are those that contact_refresh found in space. */
#ifndef HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_H
#define HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_H

#include "contact/roller/contact.h"
#include "core/planar/planar.h"

typedef struct PlanarRoller {
    double centre[2]; /* m, in the plane */
    double radius;    /* m */
    FrictionLaw friction;
} PlanarRoller;

/* What never changes during a run. */
typedef struct PlanarContactModel {
    ContactGeometry geometry;
    ImpactLaw impact;
    int n_rollers;
    const PlanarRoller *roller; /* [n_rollers], borrowed */
} PlanarContactModel;

/* Adds forces (N) and moments (N m) on the segments to loads; pairs holds the candidates. friction_scale multiplies
 * every friction coefficient. on_roller[n_rollers] (NULL: not wanted) is overwritten by the size of the force on each
 * roller, N. */
void planar_contact_forces(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarLoads *loads, double (*on_roller)[2]);

/* Keeps of the candidates those that are within `reach` (m) of their roller, as `near`, which is what the forces look
 * at: (C19) with the spheres (C18). Of a roller's ranges the part between its first and its last near element. Capsules
 * are all kept. */
void planar_contact_narrow(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double reach, ContactPairs *pairs);

/* Adds the derivatives of [force; moment] by [dx; dphi] to k and by [dv; dw] to d (PL13). */
void planar_contact_blocks(const PlanarContactModel *model, const PlanarChain *chain, const PlanarKinematics *kin,
                           double friction_scale, ContactPairs *pairs, PlanarBlocks *k, PlanarBlocks *d);

/* The largest |dx| + half |da| of a segment between (p, a) and (at_p, at_a), m: no point of the line has moved farther
 * (C20). NaN counts as infinite. */
double planar_contact_moved(const PlanarChain *chain, const PlanarKinematics *kin, double *const at_p[2],
                            double *const at_a[2]);

#endif
