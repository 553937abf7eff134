/* A block tridiagonal matrix: one block row per segment, neighbours coupled. It holds stiffness, damping and the Newton
 * matrix. Blocks are b x b (6: force and moment; 3: planar), column-major, without padding. */
#ifndef HAWSER_CORE_BLOCK_CHAIN_H
#define HAWSER_CORE_BLOCK_CHAIN_H

#include "core/checkpoint.h"
#include "core/vec3.h"

typedef struct BlockChain {
    int n;         /* block rows */
    int b;         /* block size */
    double *lower; /* [n][b*b]: row i, column i-1; lower[0] is zero and unused */
    double *diag;  /* [n][b*b]: row i, column i */
    double *upper; /* [n][b*b]: row i, column i+1; the last is zero and unused */
} BlockChain;

/* Allocates zeroed blocks, 64-byte aligned and readable a vector beyond their end; returns 0 if there is no memory (and
 * leaves nothing allocated). */
int block_chain_alloc(BlockChain *a, int n, int b);
void block_chain_free(BlockChain *a);
void block_chain_zero(BlockChain *a);
/* Adds v to rows row..row+2 of a column of a 6x6 block. */
static inline void block_column_add(double *block, int column, int row, Vec3 v)
{
    double *const at = block + 6 * column + row;
    v3_put(at, v3_add(v3_get(at), v));
}

/* Adds [force; moment] to a whole column. */
static inline void block6_add(double *block, int column, Vec3 force, Vec3 moment)
{
    block_column_add(block, column, 0, force);
    block_column_add(block, column, 3, moment);
}

/* Copies the blocks of `from`, which has the same sizes. */
void block_chain_copy(BlockChain *to, const BlockChain *from);
/* Saves or loads all blocks. */
void block_chain_checkpoint(Checkpoint *c, const char *name, BlockChain *a);
/* Blocks of K and D outside the three diagonals: couplings of segments that are not neighbours (cable on cable). The
 * pattern is symmetric and changes with the contact candidates, never inside a step. */
typedef struct BlockExtras {
    int n;               /* block rows of the chain */
    long version;        /* grows whenever the pattern changes */
    int count;           /* number of blocks: every pair is there twice, (i, j) and (j, i) */
    int allocated;       /* number of blocks allocated in the arrays below */
    int *start;          /* [n+1] blocks of row i: start[i] .. start[i+1]-1, columns rising */
    int *row;            /* [count] */
    int *col;            /* [count] */
    double *k, *d;       /* [count][36] 6x6 blocks, column-major, as in BlockChain */
    unsigned char *live; /* [count] 0: nothing has been added to the block since it was zeroed */
} BlockExtras;

/* Two segments that may couple, low + 1 < high. */
typedef struct BlockPair {
    int low, high;
} BlockPair;

/* Creates an empty set. 0 if there is no memory (nothing is left allocated). The free may be called on a zeroed
 * struct. */
int block_extras_alloc(BlockExtras *x, int n);
void block_extras_free(BlockExtras *x);
/* Sets the pattern to that of pair[count], in any order, repetitions allowed; pair gets sorted. Blocks that existed
 * before keep their values, new ones are zero. 0 if there is no memory (then nothing has changed). */
int block_extras_set(BlockExtras *x, int count, BlockPair *pair);
void block_extras_zero(BlockExtras *x);
/* Saves or loads pattern and values. */
void block_extras_checkpoint(Checkpoint *c, BlockExtras *x);
/* Number of block (row, col), -1 if it is not in the pattern. O(log blocks of the row). */
int block_extras_find(const BlockExtras *x, int row, int col);
/* The same for a block that is in the pattern, to be added to: marks it as live. */
int block_extras_touch(BlockExtras *x, int row, int col);
/* y = y + s K z for vectors of 6n, with the live blocks. */
void block_extras_gemv(const BlockExtras *x, double s, const double *z, double *y);

#endif
