/* The linear solvers of the Newton matrix: one contract, several back ends. A solver is made for a pattern, then
 * factors and solves any number of times. docs/model.md, "Linear solvers"; the measured choice: docs/performance.md. */
#ifndef HAWSER_LINSOLVE_LINSOLVE_H
#define HAWSER_LINSOLVE_LINSOLVE_H

#include "core/base/team.h"
#include "core/block_chain.h"
#include "hawser/hawser.h"
#include "linsolve/newton_matrix.h"

/* LIN_KLU_FULL takes any sparse matrix (the unreduced system); LIN_BAND and LIN_DENSE serve tests and benchmarks. */
typedef enum LinKind {
    LIN_AUTO,
    LIN_BLOCK,
    LIN_BORDERED,
    LIN_KLU,
    LIN_KLU_FULL,
    LIN_BAND,
    LIN_DENSE,
    LIN_BLOCK_SPARSE /* of several chains; a case cannot ask for it */
} LinKind;
typedef enum LinOrdering { ORDER_AUTO, ORDER_AMD, ORDER_COLAMD, ORDER_METIS } LinOrdering;

typedef struct LinOptions {
    LinKind kind;
    LinOrdering ordering; /* KLU only; auto: the one with the least measured fill */
    int threads;          /* 1 or 2; results do not depend on it */
    double growth_limit;  /* pivot growth above which a factorisation is redone more carefully; 0: default */
    Team *team;           /* borrowed; NULL with threads = 2: the solver starts its own */
} LinOptions;

typedef struct LinStats {
    const char *name;     /* "klu", "block", ... */
    const char *ordering; /* "amd", "colamd", "metis", "natural" */
    char why[128];        /* why auto chose it */
    long analyses, factors, refactors, fallbacks, solves;
    long pivoted;  /* block rows of the last factorisation that needed pivoting off the diagonal */
    long nonzeros; /* of the factors */
    double growth; /* smallest reciprocal pivot growth when last measured, 1 is best */
} LinStats;

typedef struct LinSolver LinSolver;

/* Analyses the pattern of a (its values are not read). NULL with err set when there is no memory, or when the kind that
 * was asked for cannot hold the pattern. */
LinSolver *linsolver_new(const BlockChain *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_new_newton(const NewtonMatrix *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_new_sparse(const SparseMatrix *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_free(LinSolver *s);

/* Factors a, which has the pattern and the type that the solver was made for. 0: done; > 0: singular to working
 * precision or not finite (a smaller step may help); < 0: no memory. The same values give the same bits. */
int linsolver_factor(LinSolver *s, const BlockChain *a);
int linsolver_factor_newton(LinSolver *s, const NewtonMatrix *a);
int linsolver_factor_sparse(LinSolver *s, const SparseMatrix *a);

/* x (a value an unknown, in: right-hand side) becomes the solution. Same returns; needs a factorisation. */
int linsolver_solve(LinSolver *s, double *x);
/* The same for `count` right-hand sides, one after the other in x; each comes out as linsolver_solve would give it. */
int linsolver_solve_many(LinSolver *s, int count, double *x);

/* What the solver has learned, and the factors of a (or of the sparse matrix b; the other is NULL), which has the
 * values that were factored last: read, they are made again with the same bits. */
void linsolver_checkpoint(Checkpoint *c, LinSolver *s, const NewtonMatrix *a, const SparseMatrix *b);

void linsolver_stats(const LinSolver *s, LinStats *stats);
/* "auto", "block", ... */
const char *linsolver_kind_name(LinKind kind);

#endif
