/* The block LU with leaf bodies condensed into the chain and a dense border around it: the back end `bordered`.
 * docs/model.md, "Linear solvers", (L9)-(L11). */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "linsolve/backend.h"
#include "linsolve/block/block_factor.h"
#include "linsolve/leaves.h"
#include "linsolve/small.h"

/* Letters of (L11): inner matrix A (chain and leaves), border columns B, rows C, corner E; P = A^-1 B, S = E - C P. */
typedef struct BorderedSolver {
    BlockSolver block;
    Leaves leaves;
    BlockChain condensed; /* the chain less the leaves; empty without leaves */
    int nb, w;            /* unknowns of the chain, of the border */
    double *p_chain;      /* [w][nb]: P's rows of the chain */
    double *p_leaf;       /* [w][leaves.unknowns]: P's rows of the leaves */
    double *bottom;       /* [(nb + leaves.unknowns)*w]: C, as in NewtonMatrix */
    double *s;            /* [w*w]: LU of S */
    int *pivot;           /* [w] */
    double growth, growth_limit;
} BorderedSolver;

static void bordered_drop(void *self)
{
    BorderedSolver *const s = self;
    block_solver_release(&s->block);
    leaves_release(&s->leaves);
    block_chain_free(&s->condensed);
    free(s->p_chain);
    free(s->p_leaf);
    free(s->bottom);
    free(s->s);
    free(s->pivot);
    free(s);
}

static int bordered_alloc(BorderedSolver *s, const NewtonMatrix *a, const LinOptions *options)
{
    const BlockChain *const c = &a->chain;
    Team *const team = options->threads > 1 ? options->team : NULL;
    const size_t w = (size_t)s->w, m = (size_t)newton_inner(a);
    if (!block_solver_init(&s->block, c->n, c->b, isa_best(), s->growth_limit, team)) return 0;
    if (!leaves_init(&s->leaves, a)) return 0;
    if (a->leaves && !block_chain_alloc(&s->condensed, c->n, c->b)) return 0;
    s->p_chain = malloc((w * (size_t)s->nb + 1) * sizeof(double));
    s->p_leaf = malloc((w * (size_t)s->leaves.unknowns + 1) * sizeof(double));
    s->bottom = malloc((w * m + 1) * sizeof(double));
    s->s = malloc((w * w + 1) * sizeof(double));
    s->pivot = malloc((w + 1) * sizeof *s->pivot);
    return s->p_chain && s->p_leaf && s->bottom && s->s && s->pivot;
}

static void *bordered_make(const LinMatrix *a, const LinOptions *options)
{
    BorderedSolver *const s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->nb = a->newton->chain.n * a->newton->chain.b;
    s->w = a->newton->border;
    s->growth = 1;
    s->growth_limit = growth_limit_of(options);
    if (bordered_alloc(s, a->newton, options)) return s;
    bordered_drop(s);
    return NULL;
}

/* A^-1 of count right-hand sides: chain [count][nb], leaf [count][unknowns]. */
static void inner_solve(BorderedSolver *s, int count, double *chain, double *leaf)
{
    const int nb = s->nb, nl = s->leaves.unknowns;
    for (int r = 0; r < count; ++r) leaves_forward(&s->leaves, chain + r * nb, leaf + r * nl);
    block_solver_solve(&s->block, count, chain);
    for (int r = 0; r < count; ++r) leaves_back(&s->leaves, chain + r * nb, leaf + r * nl);
}

/* y -= C x for x = (chain, leaf). */
static void bottom_subtract(const BorderedSolver *s, const double *chain, const double *leaf, double *y)
{
    const double *column = s->bottom;
    for (int k = 0; k < s->nb + s->leaves.unknowns; ++k, column += s->w) {
        const double t = k < s->nb ? chain[k] : leaf[k - s->nb];
        for (int i = 0; i < s->w; ++i) y[i] -= t * column[i];
    }
}

static int inner_factor(BorderedSolver *s, const NewtonMatrix *a)
{
    const BlockChain *chain = &a->chain;
    s->growth = 1;
    if (a->leaves) {
        block_chain_copy(&s->condensed, chain);
        const int status = leaves_condense(&s->leaves, a, &s->condensed, s->growth_limit, &s->growth);
        if (status) return status;
        chain = &s->condensed;
    }
    const int status = block_solver_factor(&s->block, chain);
    s->growth = fmax(s->growth, s->block.report.growth);
    return status;
}

/* P and the LU of S; LIN_UNSTABLE if S is singular to working precision: the whole need not be. */
static int border_factor(BorderedSolver *s, const NewtonMatrix *a)
{
    const int w = s->w, nb = s->nb, nl = s->leaves.unknowns;
    memcpy(s->bottom, a->bottom, (size_t)w * (size_t)(nb + nl) * sizeof(double));
    memcpy(s->s, a->corner, (size_t)w * (size_t)w * sizeof(double));
    for (int c = 0; c < w; ++c) {
        const double *const right = a->right + (size_t)c * (size_t)(nb + nl);
        memcpy(s->p_chain + c * nb, right, (size_t)nb * sizeof(double));
        memcpy(s->p_leaf + c * nl, right + nb, (size_t)nl * sizeof(double));
    }
    inner_solve(s, w, s->p_chain, s->p_leaf);
    for (int c = 0; c < w; ++c) bottom_subtract(s, s->p_chain + c * nb, s->p_leaf + c * nl, s->s + c * w);
    return small_lu_factor(w, s->s, s->pivot) ? LIN_UNSTABLE : 0;
}

static int bordered_factor(void *self, const LinMatrix *a)
{
    BorderedSolver *const s = self;
    int status = inner_factor(s, a->newton);
    if (!status && s->w) status = border_factor(s, a->newton);
    return status;
}

/* x = (r1, r2) -> y = A^-1 r1, z = S^-1 (r2 - C y), (y - P z, z) (L11). */
static void solve_one(BorderedSolver *s, double *x)
{
    const int nb = s->nb, nl = s->leaves.unknowns, w = s->w;
    double *const leaf = x + nb, *const z = leaf + nl;
    inner_solve(s, 1, x, leaf);
    if (!w) return;
    bottom_subtract(s, x, leaf, z);
    small_lu_solve(w, s->s, s->pivot, z);
    for (int c = 0; c < w; ++c) {
        for (int k = 0; k < nb; ++k) x[k] -= z[c] * s->p_chain[c * nb + k];
        for (int k = 0; k < nl; ++k) leaf[k] -= z[c] * s->p_leaf[c * nl + k];
    }
}

static int bordered_solve(void *self, int count, double *x)
{
    BorderedSolver *const s = self;
    for (int r = 0; r < count; ++r) solve_one(s, x + (size_t)r * (size_t)(s->nb + s->leaves.unknowns + s->w));
    return 0;
}

static void bordered_stats(const void *self, LinStats *stats)
{
    const BorderedSolver *const s = self;
    const long inner = s->nb + s->leaves.unknowns;
    stats->pivoted = s->block.report.pivoted;
    stats->nonzeros = block_solver_nonzeros(&s->block) + (2 * inner + s->w) * s->w;
    stats->growth = 1 / s->growth;
}

const LinBackend bordered_backend = {.make = bordered_make,
                                     .drop = bordered_drop,
                                     .factor = bordered_factor,
                                     .solve = bordered_solve,
                                     .stats = bordered_stats};
