/* Several cables pulled together, and the one cable that stands for them in a scene: a part of SceneDef
 * (def/scene_def.h). docs/model.md, "Bundles". */
#ifndef HAWSER_DEF_BUNDLE_DEF_H
#define HAWSER_DEF_BUNDLE_DEF_H

#include "def/cables/bundle.h"

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
