/* Counts the directions in which a symmetric block tridiagonal matrix is negative: for the stability of equilibria.
 * docs/theory.md, "Rods" (RD24), (RD16). */
#ifndef HAWSER_LINSOLVE_INERTIA_H
#define HAWSER_LINSOLVE_INERTIA_H

#include "core/block_chain.h"

/* Number of negative eigenvalues of the symmetric part (a + a^T)/2: by Sylvester's law of inertia that of negative
 * pivots in its factors L D L^T, which are computed without interchanges and not kept. b <= 6. Costs about a third of a
 * block LU and no memory. */
int block_chain_negative(const BlockChain *a);

#endif
