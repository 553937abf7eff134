/* The LU of blocks with couplings anywhere: several chains that touch. Its data, and the kernels that every instruction
 * set offers. docs/model.md, "Linear solvers", (L15)-(L19). */
#ifndef HAWSER_LINSOLVE_BLOCK_H
#define HAWSER_LINSOLVE_BLOCK_H

#include "linsolve/block_factor.h"

enum { SPARSE_B = 6, SPARSE_CELL = SPARSE_B * SPARSE_B, SPARSE_WIDTH = 8 };

/* Which blocks the factors have. Rows are numbered in the order of their elimination; the pattern is symmetric. */
typedef struct BlockPattern {
    int n;
    int *row;     /* [n] the matrix's row that is eliminated k-th */
    int *place;   /* [n] and when a row of the matrix is */
    int *start;   /* [n+1] blocks of L's column k: start[k] .. start[k+1]-1; those of U's row k have the same numbers */
    int *below;   /* [start[n]] their rows, rising */
    int *update;  /* for each k, for each pair of its blocks (p of L, q of U): the block that takes their product */
    int *updates; /* [n+1] where those of k begin */
    int allocated, updates_allocated;
} BlockPattern;

/* Blocks in the order diagonal [n], L [start[n]], U [start[n]]; block e begins at value + SPARSE_CELL e. Factored, the
 * diagonal holds the pivot blocks' inverses X, L what it was at its elimination, U the products V = X U. */
typedef struct BlockSparse {
    BlockPattern pattern;
    double *value;
    double *scale; /* [n][SPARSE_WIDTH] sums of a row's absolute values in the matrix (L8) */
    double *z;     /* [n][SPARSE_WIDTH] scratch of the solve */
    double growth_limit;
} BlockSparse;

typedef struct SparseKernels {
    /* 0 or LIN_UNSTABLE. */
    int (*factor)(const BlockSparse *s, BlockReport *report);
    /* x [6 n] by the matrix's rows. */
    void (*solve)(const BlockSparse *s, double *x);
} SparseKernels;

extern const SparseKernels sparse6_kernels_generic, sparse6_kernels_avx2, sparse6_kernels_avx512;

/* Couplings of n rows with others, each once: low < high. Fills the pattern by the order in which the least is to be
 * computed; 0 if there is no memory. */
int block_pattern_set(BlockPattern *p, int n, int count, const BlockPair *coupled);
void block_pattern_free(BlockPattern *p);

#endif
