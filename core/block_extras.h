/* Blocks of K and D outside the chain's three diagonals: what couples segments that are not neighbours (cable on
 * cable). The pattern is symmetric and changes with the contact candidates, never inside a step. */
#ifndef HAWSER_CORE_BLOCK_EXTRAS_H
#define HAWSER_CORE_BLOCK_EXTRAS_H

#include "core/block_chain.h"

typedef struct BlockExtras {
    int n;         /* block rows of the chain */
    long version;  /* grows whenever the pattern changes */
    int count;     /* blocks: every pair stands twice, (i, j) and (j, i) */
    int allocated; /* blocks that the arrays below have room for */
    int *start;    /* [n+1] blocks of row i: start[i] .. start[i+1]-1, columns rising */
    int *row;      /* [count] */
    int *col;      /* [count] */
    double *k, *d; /* [count][36] 6x6 blocks, column-major, as in BlockChain */
} BlockExtras;

/* Two segments that may couple, low + 1 < high. */
typedef struct BlockPair {
    int low, high;
} BlockPair;

/* No blocks yet. 0 if there is no memory (nothing is left allocated). The free may be called on a zeroed struct. */
int block_extras_alloc(BlockExtras *x, int n);
void block_extras_free(BlockExtras *x);
/* The pattern becomes that of pair[count], in any order, repetitions allowed; pair is sorted. Blocks that were there
 * before keep their values, new ones are zero. 0 if there is no memory (then nothing has changed). */
int block_extras_set(BlockExtras *x, int count, BlockPair *pair);
void block_extras_zero(BlockExtras *x);
/* The number of block (row, col), -1 if it is not in the pattern. O(log blocks of the row). */
int block_extras_find(const BlockExtras *x, int row, int col);
/* y = y + s K z for vectors of 6n. */
void block_extras_gemv(const BlockExtras *x, double s, const double *z, double *y);

#endif
