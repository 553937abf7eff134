/* Several cables pulled together as one: what the set is like as a whole, and what twisting does to it. docs/model.md,
 * "Bundles". */
#ifndef HAWSER_DEF_BUNDLE_DEF_H
#define HAWSER_DEF_BUNDLE_DEF_H

#include "def/duct.h"

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
/* Several cables pulled together, and the one cable that stands for them in a scene: a part of SceneDef
 * (def/scene_def.h). docs/model.md, "Bundles". */

struct SceneDef;

struct SurfaceDef;

/* What is pulled. One cable, unless shape.cables is above 1. */
typedef struct BundleDef {
    BundleSet set;                /* its diameters by bundle_make */
    int member[BUNDLE_KINDS_MAX]; /* [set.kinds] the cable of each kind, in SceneDef.cables */
    WeightCorrection correction;
    /* by bundle_make */
    BundleShape shape;
} BundleDef;

/* Whether there are several cables. */
int bundle_present(const BundleDef *bundle);
/* Adds the equivalent cable to the definition's (BU1)-(BU5), and gives it to all pieces of the chain before the eye.
 * The set's kinds, counts, layout and lay must be there. Errors: INPUT (cables that no single one can stand for),
 * MEMORY. */
hawser_status bundle_make(struct SceneDef *def, hawser_error *err);
/* Outer diameter of the cable, m; of several the thickest's. */
double bundle_diameter(const struct SceneDef *def);
/* How the cables lie in a duct; also one alone, or several chains. Errors: as duct_load. */
hawser_status bundle_in(const struct SceneDef *def, const struct SurfaceDef *duct, DuctLoad *out, hawser_error *err);
/* For how many cables what the winch pulls with counts (LI9): those of the scene, or that it draws as their rope. */
int bundle_pulled(const struct SceneDef *def);
/* How many lie in a duct. */
int bundle_cables_in(const struct SceneDef *def, const struct SurfaceDef *duct);
/* By how much friction on a surface (NULL: on rollers) is larger for the cables' layout, on a straight or in a bend
 * (BU7). */
double bundle_friction(const struct SceneDef *def, const struct SurfaceDef *surface, int in_bend);
/* The same to theory, which knows nothing of what chains beside each other press with (SC15): a run finds that. */
double bundle_theory_friction(const struct SceneDef *def, const struct SurfaceDef *surface, int in_bend);
/* The share of T/R, or of the force per length, on the worst loaded cable there (BU9). */
double bundle_share(const struct SceneDef *def, const struct SurfaceDef *surface);
/* How many times the tension of one cable's tail holds the bundle back: each has a reel of its own, unless they are
 * twisted. */
int bundle_tails(const BundleDef *bundle);
/* What is said of a bundle: every term of the cable that stands for it, and how it lies in each duct. */
typedef struct BundleTerms {
    hawser_bundle said;       /* cables 0: there is no bundle */
    hawser_bundle_duct *duct; /* [said.n_ducts] owned */
} BundleTerms;

/* Borrows the definition's names. Errors: MEMORY. Give it back with bundle_terms_free, also after an error. */
hawser_status bundle_terms_make(const struct SceneDef *def, BundleTerms *out, hawser_error *err);
void bundle_terms_free(BundleTerms *terms);
/* The risk of jamming in words never says less than the limit: at a ratio that the case's code forbids it is
 * significant.
 */
JamRisk bundle_jam_risk(const struct SceneDef *def, const DuctLoad *load);

#endif
