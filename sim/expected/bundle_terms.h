/* What is said of a bundle: every term of the cable that stands for it, and how it lies in each duct. */
#ifndef HAWSER_SIM_EXPECTED_BUNDLE_TERMS_H
#define HAWSER_SIM_EXPECTED_BUNDLE_TERMS_H

#include "sim/scene.h"

typedef struct BundleTerms {
    hawser_bundle said;       /* cables 0: there is no bundle */
    hawser_bundle_duct *duct; /* [said.n_ducts] owned */
} BundleTerms;

/* Borrows the scene's names. Errors: MEMORY. Give it back with bundle_terms_free, also after an error. */
hawser_status bundle_terms_make(const Scene *scene, BundleTerms *out, hawser_error *err);
void bundle_terms_free(BundleTerms *terms);

#endif
