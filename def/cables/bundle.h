/* Several cables pulled together as one: what the set is like as a whole, and what twisting does to it. docs/model.md,
 * "Bundles". */
#ifndef HAWSER_THEORY_BUNDLE_H
#define HAWSER_THEORY_BUNDLE_H

#include "def/cables/duct.h"

/* Where a duct's weight factor multiplies the friction: sources differ for bends. */
typedef enum WeightCorrection { CORRECT_EVERYWHERE, CORRECT_STRAIGHTS, CORRECT_NONE } WeightCorrection;

enum { BUNDLE_KINDS_MAX = 8, BUNDLE_CABLES_MAX = 24 };

/* The cables of a set by kind; those of a kind are alike. */
typedef struct BundleSet {
    int kinds;
    int count[BUNDLE_KINDS_MAX];       /* >= 1 */
    double diameter[BUNDLE_KINDS_MAX]; /* m, outside */
    int layout;                        /* a DuctLayout, of the thickest */
    int twisted;
    double lay;           /* m of the set in which a twisted cable goes round once */
    double weight_factor; /* in place of the layout's; 0: none */
    double oval;          /* of the ducts' bends, for jamming; 0: as usual */
} BundleSet;

/* The set as a whole. */
typedef struct BundleShape {
    int cables, thickest;  /* all of them; those of the largest diameter, which must be 1..4 */
    double diameter;       /* m, the largest */
    double thinner_square; /* m2, sum of the squares of the others' diameters */
    double jam_diameter;   /* m, mean of the three thickest; 0: there are no three */
    double touch;          /* m, diameter with which the bundle touches what it lies on (BU6) */
    double pitch_radius;   /* m, from the bundle's middle to its cables' (BU3) */
    double share;          /* of a force across the bundle, on the worst cable where there is no duct (BU9) */
} BundleShape;

/* Share of the thickest's diameter from which on cables lie, and are pulled, as equal ones (BU6); twisted ones must be
 * equal. */
double bundle_alike(int twisted);
/* Errors: INPUT: more cables than a duct's formulas know. */
hawser_status bundle_shape(const BundleSet *set, BundleShape *out, hawser_error *err);
/* The set in a duct of this inside diameter (m), for duct_load. */
DuctDef bundle_in_duct(const BundleSet *set, const BundleShape *shape, double duct_diameter);

/* What a cable gives to a bundle, by its own value, where it is a helix of the pitch radius and lay; 1 if it is not
 * twisted. (BU4), (BU5) */
typedef struct LayFactors {
    double mass, axial;      /* of its mass and of EA and GA */
    double bending, torsion; /* of EI and GJ, which helices mix */
} LayFactors;
/* EI and GJ: the cable's own, N m2, above 0. */
LayFactors bundle_lay(const BundleSet *set, const BundleShape *shape, double EI, double GJ);

const char *weight_correction_name(WeightCorrection correction);

#endif
