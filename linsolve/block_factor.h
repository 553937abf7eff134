/* The twisted block LU of a block chain: its data and the kernels of every instruction set. docs/theory.md, "Linear
 * solvers", (L1)-(L8). */
#ifndef HAWSER_LINSOLVE_BLOCK_FACTOR_H
#define HAWSER_LINSOLVE_BLOCK_FACTOR_H

#include "core/block_chain.h"
#include "core/machine.h"
#include "core/team.h"
#include "linsolve/linsolve.h"

/* The two halves of the chain: rows 0..middle-1 are eliminated downwards, n-1..middle+1 upwards. */
enum { SIDE_TOP = 1, SIDE_BOTTOM = 2, SIDE_BOTH = 3 };

/* Number of right-hand sides that the kernels process at once. */
enum { BLOCK_RHS = 4 };

/* Blocks are stored like the chain's, b*b numbers. */
typedef struct BlockFactor {
    int n, b, middle;
    int single;    /* front and back are arrays of float (L20), in half of the same memory */
    double *front; /* [n][2][b*b]: coupling with the neighbour eliminated before (L2), inverse X of the pivot (L3) */
    double *back;  /* [n][b*b]: V = X times the coupling with the neighbour eliminated after (L4) */
    double *edge;  /* [2][BLOCK_CELL] where single: V of the rows above and below the middle, not rounded */
    double growth_limit;
} BlockFactor;

enum { BLOCK_CELL = 48 }; /* a block and the reach of a vector store beyond it */

/* Rows from..to-1 of each side, for a sweep: the top's rows rise in a forward sweep and fall in a backward one, the
 * bottom's the other way. */
typedef struct BlockSpan {
    int top_from, top_to, bottom_from, bottom_to;
} BlockSpan;

/* Statistics of a factorisation. */
typedef struct BlockReport {
    double growth; /* largest growth of a row (L8) */
    int pivoted;   /* number of block rows that needed pivoting off the diagonal */
} BlockReport;

typedef struct BlockKernels {
    /* Factors the rows of `sides`, from the chain's ends to the middle; 0 or LIN_UNSTABLE. */
    int (*factor)(const BlockFactor *f, const BlockChain *a, int sides, BlockReport *report);
    /* Factors the middle row, after both sides. */
    int (*factor_middle)(const BlockFactor *f, const BlockChain *a, BlockReport *report);
    /* Computes z of the rows of the span in place of the right-hand sides (L5): count of them (1..BLOCK_RHS), each n*b
     * values, one after the other. Rows farther from the middle are done. */
    void (*forward)(const BlockFactor *f, BlockSpan span, int count, double *x);
    /* Computes x of the middle row, after both forward sweeps. */
    void (*middle)(const BlockFactor *f, int count, double *x);
    /* Computes x of the rows of the span in place of z (L6). Rows nearer to the middle are done. */
    void (*back)(const BlockFactor *f, BlockSpan span, int count, double *x);
} BlockKernels;

extern const BlockKernels block6_kernels_generic, block6_kernels_avx2, block6_kernels_avx512;
extern const BlockKernels block3_kernels_generic, block3_kernels_avx2, block3_kernels_avx512;

/* One block row for the kernels and the pivoting. */
typedef struct BlockRow {
    const double *diag;
    const double *before, *after; /* couplings with the neighbours eliminated before and after */
    const double *v_before;       /* V of the neighbour eliminated before */
    double *front, *back;         /* of this row */
} BlockRow;

/* Zeros for a missing neighbour's coupling or V, as long as the reach of a vector load. */
extern const double block_zero[];

/* Factors a row with full partial pivoting, if the diagonal's pivots are too small: slower, with the same result in
 * exact arithmetic. 0, or LIN_UNSTABLE if the pivot block is singular to working precision. */
int block_row_pivoted(const BlockFactor *f, const BlockRow *row);

/* The twisted block LU of a plain chain, used by the back ends `block` and `bordered`. */
typedef struct BlockSolver {
    BlockFactor f;
    const BlockKernels *kernels;
    Team *team; /* borrowed; used for long chains only, with the same result */
    BlockReport report;
} BlockSolver;

/* Allocates scratch and factors for n blocks of b (3 or 6). `isa` selects the kernels: isa_best(), or a lesser one in
 * tests. Returns 0 if there is no memory (and nothing stays allocated). */
int block_solver_init(BlockSolver *s, int n, int b, Isa isa, double growth_limit, Team *team);
void block_solver_release(BlockSolver *s);
/* Returns 0, or LIN_UNSTABLE. */
int block_solver_factor(BlockSolver *s, const BlockChain *a);
/* Sets whether the next factors are rounded to single precision (L20); there are no factors until then. */
void block_solver_round(BlockSolver *s, int single);
/* x: count right-hand sides of n*b values, one after the other. */
void block_solver_solve(BlockSolver *s, int count, double *x);
/* The same for one right-hand side whose rows come and go by the stream. */
void block_solver_stream(BlockSolver *s, const LinStream *stream, double *x);
/* Numbers in the factors. */
long block_solver_nonzeros(const BlockSolver *s);

#endif
