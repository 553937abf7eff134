/* General sparse matrices in compressed columns, and the assembly of a NewtonMatrix into one. */
#ifndef HAWSER_LINSOLVE_SPARSE_H
#define HAWSER_LINSOLVE_SPARSE_H

#include "linsolve/newton_matrix.h"

typedef struct SparseMatrix {
    int n;
    int *p;    /* [n+1]: column c holds entries p[c]..p[c+1]-1 */
    int *i;    /* [p[n]]: rows, ascending in a column */
    double *x; /* [p[n]]: values */
} SparseMatrix;

/* A NewtonMatrix in compressed columns: the pattern is built once, the values are refreshed in place. */
typedef struct SparseAssembly {
    SparseMatrix a;
    int pieces;
    int *offset; /* [columns of all pieces]: where in a.x a piece's column begins */
} SparseAssembly;

/* Builds pattern and offsets; 0 if there is no memory (and nothing stays allocated). */
int sparse_assembly_new(const NewtonMatrix *m, SparseAssembly *out);
void sparse_assembly_free(SparseAssembly *s);
/* s->a.x from the values of m, which has the pattern that s was built for. */
void sparse_assembly_refresh(SparseAssembly *s, const NewtonMatrix *m);

#endif
