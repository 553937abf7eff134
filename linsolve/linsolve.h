/* The linear solvers of the Newton matrix: one contract, several back ends. A solver is made for a pattern, then
 * factors and solves any number of times. docs/theory.md, "Linear solvers"; the measured choice: docs/performance.md.
 */
#ifndef HAWSER_LINSOLVE_LINSOLVE_H
#define HAWSER_LINSOLVE_LINSOLVE_H

#include "core/block_chain.h"
#include "core/team.h"
#include "hawser/hawser.h"
#include "linsolve/newton_matrix.h"

typedef enum LinKind {
    LIN_AUTO,
    LIN_BLOCK,
    LIN_BORDERED,
    LIN_KLU,
    LIN_BLOCK_SPARSE /* for several chains; cannot be chosen in a case */
} LinKind;
typedef enum LinOrdering { ORDER_AUTO, ORDER_AMD, ORDER_COLAMD, ORDER_METIS } LinOrdering;

typedef struct LinOptions {
    LinKind kind;
    LinOrdering ordering; /* KLU only; auto: the one with the least measured fill */
    int threads;          /* 1 or 2; results do not depend on it */
    int precise;          /* 1: factors are never rounded: see linsolver_rough */
    double growth_limit;  /* pivot growth above which a factorisation is redone more carefully; 0: default */
    Team *team;           /* borrowed; NULL with threads = 2: the solver starts its own */
} LinOptions;

typedef struct LinStats {
    const char *name;     /* "klu", "block", ... */
    const char *ordering; /* "amd", "colamd", "metis", "natural" */
    char why[128];        /* reason for auto's choice */
    long analyses, factors, refactors, fallbacks, solves;
    long pivoted;  /* number of block rows of the last factorisation that needed pivoting off the diagonal */
    long nonzeros; /* in the factors */
    double growth; /* smallest reciprocal pivot growth when last measured, 1 is best */
} LinStats;

typedef struct LinSolver LinSolver;

/* Analyses the pattern of a (its values are not read). Returns NULL with err set when there is no memory, or when the
 * requested kind cannot hold the pattern. */
LinSolver *linsolver_new(const BlockChain *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_new_newton(const NewtonMatrix *a, const LinOptions *options, hawser_error *err);
LinSolver *linsolver_free(LinSolver *s);

/* Factors a, which has the pattern and the type that the solver was made for. 0: done; > 0: singular to working
 * precision or not finite (a smaller step may help); < 0: no memory. The same values give the same bits. */
int linsolver_factor(LinSolver *s, const BlockChain *a);
int linsolver_factor_newton(LinSolver *s, const NewtonMatrix *a);

/* x (one value per unknown, in: right-hand side) becomes the solution. Same returns; needs a factorisation. */
int linsolver_solve(LinSolver *s, double *x);
/* The same for `count` right-hand sides, one after the other in x; each result equals that of linsolver_solve. */
int linsolver_solve_many(LinSolver *s, int count, double *x);

/* Computes a right-hand side, and uses a solution, row by row while the solver goes over its factors, so that neither
 * is read from main memory twice. Rows are block rows of a chain. */
typedef enum LinSide { LIN_TOP, LIN_BOTTOM, LIN_SEAM } LinSide;
typedef struct LinStream {
    void *user;
    /* Writes rows from..to-1 of the right-hand side to x: the top's from 0 to the seam, the bottom's from the end to
     * the seam, each side by one thread, whole lanes except at the chain's end; when both are done, the seam's. */
    void (*fill)(void *user, LinSide side, int from, int to);
    /* Receives rows from..to-1 of the solution in x: in any order, every row once, from one of two threads. */
    void (*take)(void *user, int from, int to);
} LinStream;
/* The rows between the sides: the lane before and the lane of halves_middle. */
typedef struct LinSeam {
    int from, to;
} LinSeam;
static inline LinSeam lin_seam(int n)
{
    const int middle = halves_middle(n);
    return (LinSeam){middle > 0 ? middle - LANES : 0, middle + LANES < n ? middle + LANES : n};
}
/* Like linsolver_solve, with the same bits. */
int linsolver_stream(LinSolver *s, const LinStream *stream, double *x);

/* Number of entries of the diagonal blocks (n b b) from which factors are rounded where allowed: those of 3000 segments
 * in space, or of 12 000 in the plane, exceed a core's second cache. docs/performance.md, "Scale". */
enum { LIN_ROUND_ENTRIES = 108000 };
/* Declares that the solutions of the next factorisation only are corrections of an iteration that checks its residual:
 * factors of long chains may then be rounded to single precision (L20). */
void linsolver_rough(LinSolver *s, int rough);

/* Saves or loads the solver's choices, and the factors of a, which has the values that were factored last: loading
 * computes them again with the same bits. */
void linsolver_checkpoint(Checkpoint *c, LinSolver *s, const NewtonMatrix *a);
/* Its counts and what follows them. */
void lin_stats_checkpoint(Checkpoint *c, LinStats *stats);

void linsolver_stats(const LinSolver *s, LinStats *stats);
/* "auto", "block", ... */
const char *linsolver_kind_name(LinKind kind);

#endif
