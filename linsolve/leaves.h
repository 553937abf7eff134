/* Elimination of the leaf bodies of a NewtonMatrix: each is condensed into the one or two chain blocks that it touches,
 * which keeps the chain block tridiagonal. docs/model.md, "Linear solvers", (L9)-(L10). */
#ifndef HAWSER_LINSOLVE_LEAVES_H
#define HAWSER_LINSOLVE_LEAVES_H

#include "linsolve/newton_matrix.h"

/* One leaf, eliminated. */
typedef struct LeafFactor {
    int size, at, touches;               /* as at the last factorisation */
    int first;                           /* its first unknown, counted from the first leaf's */
    double inverse[LEAF_MAX * LEAF_MAX]; /* E^-1 */
    double into[2][LEAF_MAX * LEAF_MAX]; /* [b*size]: copy of Leaf.into */
    double back[2][LEAF_MAX * LEAF_MAX]; /* [size*b]: E^-1 from */
} LeafFactor;

typedef struct Leaves {
    int b, leaves, unknowns;
    LeafFactor *factor; /* [leaves] */
} Leaves;

/* Sizes from the pattern of a; 0 if there is no memory. */
int leaves_init(Leaves *s, const NewtonMatrix *a);
void leaves_release(Leaves *s);
/* Inverts the leaves and takes them off `chain`, which holds the values of a->chain. 0, or LIN_UNSTABLE if a leaf is
 * singular to working precision or its elimination makes a chain block grow beyond growth_limit; *growth rises to the
 * largest growth seen. */
int leaves_condense(Leaves *s, const NewtonMatrix *a, BlockChain *chain, double growth_limit, double *growth);
/* Right-hand sides before and after the chain's solve; chain [n*b], leaf [unknowns]. Forward turns leaf into E^-1 leaf
 * and takes it off the chain; back takes the chain's solution off the leaves. */
void leaves_forward(const Leaves *s, double *chain, double *leaf);
void leaves_back(const Leaves *s, const double *chain, double *leaf);

#endif
