/* Interface of a back end to linsolve/dispatch.c. */
#ifndef HAWSER_LINSOLVE_BACKEND_H
#define HAWSER_LINSOLVE_BACKEND_H

#include "linsolve/linsolve.h"

/* Returned by a factorisation that has to be repeated with KLU. */
enum { LIN_UNSTABLE = 1000 };

/* A matrix as given or assembled: back ends of the block family read `newton`, the others `sparse`. */
typedef struct LinMatrix {
    const NewtonMatrix *newton; /* NULL: only the assembled one (tests) */
    const SparseMatrix *sparse; /* NULL: not assembled */
    int groups;                 /* of unknowns that belong together, for orderings */
    const int *group_at;        /* [groups+1]; NULL: every unknown is alone */
} LinMatrix;

typedef struct LinBackend {
    int sparse; /* 1: needs LinMatrix.sparse */
    /* Returns NULL when there is no memory. */
    void *(*make)(const LinMatrix *a, const LinOptions *options);
    void (*drop)(void *self);
    /* Like linsolver_factor; may also return LIN_UNSTABLE. */
    int (*factor)(void *self, const LinMatrix *a);
    int (*solve)(void *self, int count, double *x); /* after a factorisation that succeeded */
    /* Like linsolver_stream; NULL: the whole right-hand side is computed first. */
    int (*stream)(void *self, const LinStream *stream, double *x);
    /* Like linsolver_rough, called just before the factorisation; NULL: nothing can be rounded. */
    void (*rough)(void *self, int rough);
    /* Saves or loads what passes from factorisation to factorisation; loading restores the factors of a, if there are
     * any. NULL: factors depend on the matrix alone. */
    void (*checkpoint)(Checkpoint *c, void *self, const LinMatrix *a, int ready);
    /* Fills in the back end's statistics: ordering, refactors, fallbacks, pivoted, nonzeros, growth. */
    void (*stats)(const void *self, LinStats *stats);
} LinBackend;

extern const LinBackend klu_backend, block_backend, bordered_backend, block_sparse_backend;

/* LinOptions.growth_limit, or the default: a loss of more than six digits by growth justifies a better
 * factorisation. */
static inline double growth_limit_of(const LinOptions *options)
{
    return options->growth_limit > 0 ? options->growth_limit : 1e6;
}

/* An ordering that KLU does not include: METIS' nested dissection of the groups of a->sparse (one vertex per group,
 * weighted by its size), expanded to the unknowns: perm[k] is the unknown in place k. 0: done; < 0: no memory; > 0:
 * METIS failed. */
int ordering_metis(const LinMatrix *a, int *perm);

#endif
