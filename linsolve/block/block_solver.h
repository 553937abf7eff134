/* The twisted block LU of a plain chain, used by the back ends `block` and `bordered`. */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_SOLVER_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_SOLVER_H

#include "core/base/team.h"
#include "linsolve/block/block_factor.h"

typedef struct BlockSolver {
    BlockFactor f;
    const BlockKernels *kernels;
    Team *team; /* borrowed; used for long chains only, with the same result */
    BlockReport report;
} BlockSolver;

/* Scratch and factors for n blocks of b (3 or 6). `isa` picks the kernels: isa_best(), or a lesser one in tests.
 * Returns 0 if there is no memory (and nothing stays allocated). */
int block_solver_init(BlockSolver *s, int n, int b, Isa isa, double growth_limit, Team *team);
void block_solver_release(BlockSolver *s);
/* 0, or LIN_UNSTABLE. */
int block_solver_factor(BlockSolver *s, const BlockChain *a);
/* x: count right-hand sides of n*b values, one after the other. */
void block_solver_solve(BlockSolver *s, int count, double *x);
/* Doubles in the factors. */
long block_solver_nonzeros(const BlockSolver *s);

#endif
