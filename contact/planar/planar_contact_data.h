/* The data of contact in a plane, shared by planar_contact.c and its kernels. */
#ifndef HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_DATA_H
#define HAWSER_CONTACT_PLANAR_PLANAR_CONTACT_DATA_H

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

#endif
