/* The linear solvers of the Newton matrix: one contract, several back ends. A solver is made for a pattern, then
 * factors and solves any number of times. docs/model.md, "Newton matrix"; the measured choice: docs/performance.md. */
#ifndef HAWSER_LINSOLVE_LINSOLVE_H
#define HAWSER_LINSOLVE_LINSOLVE_H

#include "core/block_chain.h"
#include "hawser/hawser.h"

typedef enum LinKind { LIN_AUTO, LIN_BLOCK, LIN_BORDERED, LIN_KLU, LIN_KLU_FULL, LIN_BAND, LIN_DENSE } LinKind;
typedef enum LinOrdering { ORDER_AUTO, ORDER_AMD, ORDER_COLAMD, ORDER_METIS } LinOrdering;

typedef struct LinOptions {
    LinKind kind;
    LinOrdering ordering; /* KLU only */
    int threads;          /* 1 or 2; results do not depend on it */
    double growth_limit;  /* pivot growth above which a refactorisation is redone in full; 0: default */
} LinOptions;

typedef struct LinStats {
    const char *name;     /* "klu", "block", ... */
    const char *ordering; /* "amd", "colamd", "metis", "natural" */
    char why[128];        /* why auto chose it */
    long analyses, factors, refactors, fallbacks, solves;
    long nonzeros; /* of the factors */
    double growth; /* of the last factorisation: smallest reciprocal pivot growth, 1 is best */
} LinStats;

typedef struct LinSolver LinSolver;

/* Analyses the pattern of a (its values are not read). NULL with err set when there is no memory. */
LinSolver *linsolver_new(const BlockChain *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_free(LinSolver *s);
/* Factors a. 0: done; > 0: singular to working precision (a smaller step may help); < 0: no memory. */
int linsolver_factor(LinSolver *s, const BlockChain *a);
/* x (n*b, in: right-hand side) becomes the solution. Same returns; needs a factorisation. */
int linsolver_solve(LinSolver *s, double *x);
void linsolver_stats(const LinSolver *s, LinStats *stats);
/* "auto", "block", ... -> kind; returns 0 if unknown. */
int linsolver_kind_parse(const char *text, LinKind *kind);
const char *linsolver_kind_name(LinKind kind);

#endif
