/* The twisted block LU of a block chain: its data and the kernels that every instruction set offers.
 * docs/model.md, "Linear solvers", (L1)-(L8). */
#ifndef HAWSER_LINSOLVE_BLOCK_BLOCK_FACTOR_H
#define HAWSER_LINSOLVE_BLOCK_BLOCK_FACTOR_H

#include "core/base/isa.h"
#include "core/base/team.h"
#include "core/block_chain.h"

/* The two halves of the chain: rows 0..middle-1 are eliminated downwards, n-1..middle+1 upwards. */
enum { SIDE_TOP = 1, SIDE_BOTTOM = 2, SIDE_BOTH = 3 };

/* Right-hand sides that the kernels take at once. */
enum { BLOCK_RHS = 4 };

/* Blocks are stored like the chain's, b*b doubles; vectors of the solve are padded to `width`, 8 for b = 6, 4 for 3. */
typedef struct BlockFactor {
    int n, b, width, middle;
    double *front; /* [n][2][b*b]: coupling with the neighbour eliminated before (L2), inverse X of the pivot (L3) */
    double *back;  /* [n][b*b]: V = X times the coupling with the neighbour eliminated after (L4) */
    double *z;     /* [BLOCK_RHS][n][width]: scratch of the solve (L6) */
    double growth_limit;
} BlockFactor;

/* What a factorisation noticed. */
typedef struct BlockReport {
    double growth; /* largest growth of a row (L8) */
    int pivoted;   /* block rows that needed pivoting off the diagonal */
} BlockReport;

typedef struct BlockKernels {
    /* Factors the rows of `sides`, from the chain's ends to the middle; 0 or LIN_UNSTABLE. */
    int (*factor)(const BlockFactor *f, const BlockChain *a, int sides, BlockReport *report);
    /* Factors the middle row, when both sides are done. */
    int (*factor_middle)(const BlockFactor *f, const BlockChain *a, BlockReport *report);
    /* z of the rows of `sides` from x: count right-hand sides (1..BLOCK_RHS), each n*b values, one after the other.
     * The top also begins the middle row. */
    void (*forward)(const BlockFactor *f, int sides, int count, const double *x);
    /* x of the rows of `sides` from z, both forward sweeps being done; the top also writes the middle row. */
    void (*back)(const BlockFactor *f, int sides, int count, double *x);
} BlockKernels;

extern const BlockKernels block6_kernels_generic, block6_kernels_avx2, block6_kernels_avx512;
extern const BlockKernels block3_kernels_generic, block3_kernels_avx2, block3_kernels_avx512;

/* One block row as the kernels and the pivoting see it. */
typedef struct BlockRow {
    const double *diag;
    const double *before, *after; /* couplings with the neighbours eliminated before and after */
    const double *v_before;       /* V of the neighbour eliminated before */
    double *front, *back;         /* of this row */
} BlockRow;

/* No neighbour: a coupling, or a V, of zeros; as long as a vector load may reach. */
extern const double block_zero[];

/* The row with full partial pivoting, for when the diagonal's pivots are too small: slower, the same result in exact
 * arithmetic. 0, or LIN_UNSTABLE if the pivot block is singular to working precision. */
int block_row_pivoted(const BlockFactor *f, const BlockRow *row);

/* The twisted block LU of a plain chain, used by the back ends `block` and `bordered`. */
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
