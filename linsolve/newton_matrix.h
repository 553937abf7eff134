/* The Newton matrix as the solvers see it: a block chain with the scene's further parts around it. A plain chain leaves
 * the rest zero, at no cost. The unknowns are numbered chain (n b), leaves in their order, border. */
#ifndef HAWSER_LINSOLVE_NEWTON_MATRIX_H
#define HAWSER_LINSOLVE_NEWTON_MATRIX_H

#include "core/block_chain.h"

/* A b x b block outside the three diagonals (cable on cable); blocks at the same place add up. */
typedef struct ExtraBlock {
    int row, col;        /* block row and column of the chain */
    const double *block; /* [b*b], column-major */
} ExtraBlock;

enum { LEAF_MAX = 7 };

/* A small body that touches at most two neighbouring blocks of the chain: a spinning roller, a roller's mount. Its
 * place (at, touches) may change from one factorisation to the next; its size may not. */
typedef struct Leaf {
    int size;              /* unknowns, 1..LEAF_MAX */
    int at;                /* the first chain block it touches */
    int touches;           /* 0, 1 (at) or 2 (at and at + 1) */
    const double *diag;    /* [size*size]: rows and columns of the leaf; all blocks are column-major */
    const double *into[2]; /* [b*size]: rows of chain block at + k, columns of the leaf */
    const double *from[2]; /* [size*b]: rows of the leaf, columns of chain block at + k */
} Leaf;

typedef struct NewtonMatrix {
    BlockChain chain; /* borrowed; from block_chain_alloc: the kernels read a few doubles past the last block */
    int extras;
    const ExtraBlock *extra;   /* [extras] */
    const unsigned char *live; /* [extras] 0: a block of zeros; NULL: not known */
    int leaves;
    const Leaf *leaf;     /* [leaves] */
    int border;           /* w unknowns that may couple with any other: a reel drum, shared bodies */
    const double *right;  /* [m*w], m = newton_inner(): rows of chain and leaves, columns of the border */
    const double *bottom; /* [w*m]: rows of the border, columns of chain and leaves */
    const double *corner; /* [w*w] */
} NewtonMatrix;

/* Unknowns of chain and leaves; of everything. */
int newton_inner(const NewtonMatrix *a);
int newton_size(const NewtonMatrix *a);

/* The matrix as a list of dense pieces, in a fixed order; values may be NULL where a caller asks for the pattern
 * only. */
typedef struct Piece {
    int row, col, rows, cols; /* place in the whole matrix */
    const double *value;      /* [rows*cols], column-major */
} Piece;

int newton_pieces(const NewtonMatrix *a);
Piece newton_piece(const NewtonMatrix *a, int k);

/* Groups of consecutive unknowns that belong together: chain blocks, leaves, border. Fills at[groups + 1] with their
 * first unknowns (NULL: only counts) and returns their number. */
int newton_groups(const NewtonMatrix *a, int *at);

/* ------------------------------------------------------------------------------------------ compressed columns */

/* A general sparse matrix in compressed columns. */
typedef struct SparseMatrix {
    int n;
    int *p;    /* [n+1]: column c holds entries p[c]..p[c+1]-1 */
    int *i;    /* [p[n]]: rows, ascending in a column */
    double *x; /* [p[n]]: values */
} SparseMatrix;

/* A NewtonMatrix in compressed columns: the pattern is built once, the values are updated in place. */
typedef struct SparseAssembly {
    SparseMatrix a;
    int pieces;
    int *offset; /* [columns of all pieces]: where in a.x a piece's column begins */
} SparseAssembly;

/* Builds pattern and offsets; 0 if there is no memory (and nothing stays allocated). */
int sparse_assembly_new(const NewtonMatrix *m, SparseAssembly *out);
void sparse_assembly_free(SparseAssembly *s);
/* Updates s->a.x from the values of m, which has the pattern for which s was built. */
void sparse_assembly_refresh(SparseAssembly *s, const NewtonMatrix *m);

#endif
