/* What a back end offers to linsolve.c. */
#ifndef HAWSER_LINSOLVE_BACKEND_H
#define HAWSER_LINSOLVE_BACKEND_H

#include "linsolve/linsolve.h"

/* Returned by a factorisation that linsolve.c is to repeat with KLU. */
enum { LIN_UNSTABLE = 1000 };

/* A matrix as given or assembled: back ends of the block family read `newton`, the others `sparse`. */
typedef struct LinMatrix {
    const NewtonMatrix *newton; /* NULL: only the assembled one (tests) */
    const SparseMatrix *sparse; /* NULL: not assembled */
    int groups;                 /* of unknowns that belong together, for orderings */
    const int *group_at;        /* [groups+1]; NULL: every unknown is alone */
} LinMatrix;

typedef struct LinBackend {
    int sparse; /* wants LinMatrix.sparse */
    /* NULL when there is no memory. */
    void *(*make)(const LinMatrix *a, const LinOptions *options);
    void (*drop)(void *self);
    /* As linsolver_factor, or LIN_UNSTABLE. */
    int (*factor)(void *self, const LinMatrix *a);
    int (*solve)(void *self, int count, double *x); /* after a factorisation that succeeded */
    /* As linsolver_stream; NULL: the whole right-hand side is made first. */
    int (*stream)(void *self, const LinStream *stream, double *x);
    /* As linsolver_rough, just before the factorisation; NULL: there is nothing to be rounded. */
    void (*rough)(void *self, int rough);
    /* What goes on from factorisation to factorisation; read, it makes the factors of a again, if there are any. NULL:
     * factors depend on the matrix alone. */
    void (*checkpoint)(Checkpoint *c, void *self, const LinMatrix *a, int ready);
    /* Fills what the back end knows: ordering, refactors, fallbacks, pivoted, nonzeros, growth. */
    void (*stats)(const void *self, LinStats *stats);
} LinBackend;

extern const LinBackend klu_backend, block_backend, bordered_backend, block_sparse_backend;

/* LinOptions.growth_limit, or the default: losing more than six digits to growth is worth a better factorisation. */
static inline double growth_limit_of(const LinOptions *options)
{
    return options->growth_limit > 0 ? options->growth_limit : 1e6;
}

/* An ordering that KLU does not bring along: METIS' nested dissection of the groups of a->sparse (one vertex a group,
 * weighed by its size), spelt out for the unknowns: perm[k] is the unknown in place k. 0: done; < 0: no memory; > 0:
 * METIS refused. */
int ordering_metis(const LinMatrix *a, int *perm);

#endif
