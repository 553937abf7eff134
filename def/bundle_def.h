/* Several cables pulled together as one: properties of the whole set, and the effect of twisting. docs/theory.md,
 * "Bundles". */
#ifndef HAWSER_DEF_BUNDLE_DEF_H
#define HAWSER_DEF_BUNDLE_DEF_H

#include "def/duct.h"

/* Pieces on which a duct's weight factor multiplies the friction: sources differ for bends. */
typedef enum WeightCorrection { CORRECT_EVERYWHERE, CORRECT_STRAIGHTS, CORRECT_NONE } WeightCorrection;

enum { BUNDLE_KINDS_MAX = 8, BUNDLE_CABLES_MAX = 24 };

/* The cables of a set by kind; those of a kind are alike. */
typedef struct BundleSet {
    int kinds;
    int count[BUNDLE_KINDS_MAX];       /* >= 1 */
    double diameter[BUNDLE_KINDS_MAX]; /* m, outside */
    int layout;                        /* a DuctLayout, of the thickest */
    int twisted;
    double lay;           /* m of the set per turn of a twisted cable */
    double weight_factor; /* replaces the layout's; 0: none */
    double oval;          /* of the ducts' bends, for jamming; 0: as usual */
} BundleSet;

/* The set as a whole. */
typedef struct BundleShape {
    int cables, thickest;  /* all of them; those of the largest diameter, which must be 1..4 */
    double diameter;       /* m, the largest */
    double thinner_square; /* m2, sum of the squares of the others' diameters */
    double jam_diameter;   /* m, mean of the three thickest; 0: there are no three */
    double touch;          /* m, diameter of the bundle at the contact with its support (BU6) */
    double pitch_radius;   /* m, from the bundle's middle to its cables' (BU3) */
    double share;          /* share of a force across the bundle on the worst cable outside ducts (BU9) */
} BundleShape;

/* Least share of the thickest diameter for cables that lie, and are pulled, as equal ones (BU6); twisted ones must be
 * equal. */
double bundle_alike(int twisted);
/* Computes the shape of a set. Errors: INPUT: more cables than the formulas for ducts allow. */
hawser_status bundle_shape(const BundleSet *set, BundleShape *out, hawser_error *err);
/* The set in a duct of this inside diameter (m), for duct_load. */
DuctDef bundle_in_duct(const BundleSet *set, const BundleShape *shape, double duct_diameter);
/* Factors on a cable's own values in a bundle, where it is a helix of the pitch radius and lay; 1 if it is not twisted.
 * (BU4), (BU5) */
typedef struct LayFactors {
    double mass, axial;      /* on its mass; on EA and GA */
    double bending, torsion; /* on EI and GJ, which a helix couples */
} LayFactors;

/* Computes the factors. EI and GJ: the cable's own, N m2, above 0. */
LayFactors bundle_lay(const BundleSet *set, const BundleShape *shape, double EI, double GJ);
const char *weight_correction_name(WeightCorrection correction);
/* Several cables pulled together, and the equivalent cable in a scene: a part of SceneDef (def/scene_def.h).
 * docs/theory.md, "Bundles". */

struct SceneDef;

struct SurfaceDef;

/* The pulled cables: one, unless shape.cables is above 1. */
typedef struct BundleDef {
    BundleSet set;                /* its diameters are set by bundle_make */
    int member[BUNDLE_KINDS_MAX]; /* [set.kinds] the cable of each kind, in SceneDef.cables */
    WeightCorrection correction;
    /* set by bundle_make */
    BundleShape shape;
} BundleDef;

/* Checks for several cables. */
int bundle_present(const BundleDef *bundle);
/* Adds the equivalent cable to the definition (BU1)-(BU5), and assigns it to all pieces of the chain before the eye.
 * The set's kinds, counts, layout and lay must be there. Errors: INPUT (sets without an equivalent cable), MEMORY. */
hawser_status bundle_make(struct SceneDef *def, hawser_error *err);
/* Outer diameter of the cable, m; of several cables that of the thickest. */
double bundle_diameter(const struct SceneDef *def);
/* Computes the load of the cables in a duct; also for a single cable or several chains. Errors: as duct_load. */
hawser_status bundle_in(const struct SceneDef *def, const struct SurfaceDef *duct, DuctLoad *out, hawser_error *err);
/* Number of cables that share the winch's pull (LI9): those of the scene, or those pulled by this rope. */
int bundle_pulled(const struct SceneDef *def);
/* Number of cables in a duct. */
int bundle_cables_in(const struct SceneDef *def, const struct SurfaceDef *duct);
/* Factor by which the cables' layout increases friction on a surface (NULL: on rollers), on a straight or in a bend
 * (BU7). */
double bundle_friction(const struct SceneDef *def, const struct SurfaceDef *surface, int in_bend);
/* The same for theory, with the weight factor of parallel chains (SC15), whose mutual pressure only a run computes. */
double bundle_theory_friction(const struct SceneDef *def, const struct SurfaceDef *surface, int in_bend);
/* Share of T/R, or of the force per length, on the worst loaded cable there (BU9). */
double bundle_share(const struct SceneDef *def, const struct SurfaceDef *surface);
/* Factor from one cable's back tension to the bundle's: each cable has its own reel, unless they are twisted. */
int bundle_tails(const BundleDef *bundle);
/* Description of a bundle: every term of the equivalent cable, and its load in each duct. */
typedef struct BundleTerms {
    hawser_bundle said;       /* cables 0: there is no bundle */
    hawser_bundle_duct *duct; /* [said.n_ducts] owned */
} BundleTerms;

/* Builds the description; borrows the definition's names. The result must be freed with bundle_terms_free, also after
 * an error. Errors: MEMORY. */
hawser_status bundle_terms_make(const struct SceneDef *def, BundleTerms *out, hawser_error *err);
void bundle_terms_free(BundleTerms *terms);
/* Risk of jamming as a class, never lower than the limit implies: at a ratio that the case's code forbids it is
 * significant. */
JamRisk bundle_jam_risk(const struct SceneDef *def, const DuctLoad *load);

#endif
