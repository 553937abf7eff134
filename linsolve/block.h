/* The LU of blocks with couplings anywhere: several chains in contact. Its data, and the kernels of every instruction
 * set. docs/theory.md, "Linear solvers", (L15)-(L19). */
#ifndef HAWSER_LINSOLVE_BLOCK_H
#define HAWSER_LINSOLVE_BLOCK_H

#include "linsolve/block_factor.h"

enum { SPARSE_B = 6, SPARSE_CELL = SPARSE_B * SPARSE_B, SPARSE_WIDTH = 8 };

/* The blocks of the factors. Rows are numbered in the order of their elimination; the pattern is symmetric. */
typedef struct BlockPattern {
    int n;
    int *row;     /* [n] the matrix's row that is eliminated k-th */
    int *place;   /* [n] place of each row of the matrix in that order */
    int *start;   /* [n+1] blocks of L's column k: start[k] .. start[k+1]-1; those of U's row k have the same numbers */
    int *below;   /* [start[n]] their rows, rising */
    int *update;  /* for each k and each pair of its blocks (p of L, q of U): the block to which their product is
                   * added */
    int *updates; /* [n+1] where those of k begin */
    int allocated, updates_allocated;
} BlockPattern;

/* Blocks in the order diagonal [n], L [start[n]], U [start[n]]; block e begins at value + SPARSE_CELL e. Factored, the
 * diagonal has the inverses X of the pivot blocks, L its values at its elimination, U the products V = X U. */
typedef struct BlockSparse {
    BlockPattern pattern;
    double *value;
    double *scale; /* [n][SPARSE_WIDTH] sums of a row's absolute values in the matrix (L8) */
    double *z;     /* [n][SPARSE_WIDTH] scratch of the solve */
    double growth_limit;
} BlockSparse;

typedef struct SparseKernels {
    /* Returns 0 or LIN_UNSTABLE. */
    int (*factor)(const BlockSparse *s, BlockReport *report);
    /* x [6 n] by the matrix's rows. */
    void (*solve)(const BlockSparse *s, double *x);
} SparseKernels;

extern const SparseKernels sparse6_kernels_generic, sparse6_kernels_avx2, sparse6_kernels_avx512;

/* Couplings of n rows with others, each once: low < high. Fills the pattern in the order with the least computation; 0
 * if there is no memory. */
int block_pattern_set(BlockPattern *p, int n, int count, const BlockPair *coupled);
void block_pattern_free(BlockPattern *p);

#endif
