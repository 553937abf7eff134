/* Elimination of the leaf bodies of a NewtonMatrix: each is condensed into the one or two chain blocks that it touches,
 * which keeps the chain block tridiagonal. docs/theory.md, "Linear solvers", (L9)-(L10). */
#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "linsolve/backend.h"
#include "linsolve/block_factor.h"
#include "linsolve/newton_matrix.h"
#include "linsolve/small.h"

/* One leaf, eliminated. */
typedef struct LeafFactor {
    int size, at, touches;               /* as at the last factorisation */
    int first;                           /* its first unknown, counted from the first leaf's */
    double inverse[LEAF_MAX * LEAF_MAX]; /* E^-1 */
    double into[2][LEAF_MAX * LEAF_MAX]; /* [b*size]: copy of Leaf.into */
    double back[2][LEAF_MAX * LEAF_MAX]; /* [size*b]: E^-1 from */
} LeafFactor;

typedef struct Leaves {
    int b, leaves, unknowns;
    LeafFactor *factor; /* [leaves] */
} Leaves;

/* Computes sizes from the pattern of a; 0 if there is no memory. */
static int leaves_init(Leaves *s, const NewtonMatrix *a)
{
    *s = (Leaves){.b = a->chain.b, .leaves = a->leaves};
    s->factor = calloc((size_t)a->leaves + 1, sizeof *s->factor);
    if (!s->factor) return 0;
    for (int l = 0; l < a->leaves; ++l) {
        const Leaf *const leaf = a->leaf + l;
        assert(leaf->size >= 1 && leaf->size <= LEAF_MAX);
        s->factor[l] = (LeafFactor){.size = leaf->size, .first = s->unknowns};
        s->unknowns += leaf->size;
    }
    return 1;
}

static void leaves_release(Leaves *s)
{
    free(s->factor);
    *s = (Leaves){0};
}

/* c += s A B, column-major: A is rows x inner, B inner x cols. */
static void multiply_add(int rows, int inner, int cols, double s, const double *a, const double *b, double *c)
{
    for (int j = 0; j < cols; ++j) {
        for (int k = 0; k < inner; ++k) {
            const double t = s * b[j * inner + k];
            for (int i = 0; i < rows; ++i) c[j * rows + i] += t * a[k * rows + i];
        }
    }
}

static double largest(int count, const double *a)
{
    double most = 0;
    for (int k = 0; k < count; ++k) most = fmax(most, fabs(a[k]));
    return most;
}

/* E^-1, column by column; LIN_UNSTABLE if a pivot is rounding relative to the entries of E. */
static int leaf_invert(LeafFactor *f, const double *diag)
{
    int pivot[LEAF_MAX];
    double lu[LEAF_MAX * LEAF_MAX];
    const int d = f->size;
    memcpy(lu, diag, (size_t)(d * d) * sizeof(double));
    if (small_lu_factor(d, lu, pivot)) return LIN_UNSTABLE;
    memset(f->inverse, 0, sizeof f->inverse);
    for (int k = 0; k < d; ++k) {
        f->inverse[k * d + k] = 1;
        small_lu_solve(d, lu, pivot, f->inverse + k * d);
    }
    return 0;
}

static double *chain_block(const BlockChain *chain, int i, int j)
{
    double *const blocks = j < i ? chain->lower : j > i ? chain->upper : chain->diag;
    return blocks + (size_t)i * (size_t)(chain->b * chain->b);
}

static int leaf_condense(LeafFactor *f, const Leaf *leaf, BlockChain *chain, double growth_limit, double *growth)
{
    const int b = chain->b, d = f->size, bb = b * b;
    assert(leaf->size == d && leaf->touches >= 0 && leaf->touches <= 2);
    assert(leaf->touches == 0 || (leaf->at >= 0 && leaf->at + leaf->touches <= chain->n));
    f->at = leaf->at;
    f->touches = leaf->touches;
    if (leaf_invert(f, leaf->diag)) return LIN_UNSTABLE;
    for (int k = 0; k < f->touches; ++k) {
        memcpy(f->into[k], leaf->into[k], (size_t)(b * d) * sizeof(double));
        memset(f->back[k], 0, sizeof f->back[k]);
        multiply_add(d, d, b, 1, f->inverse, leaf->from[k], f->back[k]);
    }
    for (int k = 0; k < f->touches; ++k) {
        double *const diag = chain_block(chain, f->at + k, f->at + k);
        const double before = largest(bb, diag);
        for (int j = 0; j < f->touches; ++j) {
            multiply_add(b, d, b, -1, f->into[k], f->back[j], chain_block(chain, f->at + k, f->at + j));
        }
        const double ratio = largest(bb, diag) / before;
        if (!(ratio <= growth_limit)) return LIN_UNSTABLE;
        *growth = fmax(*growth, ratio);
    }
    return 0;
}

/* Inverts the leaves and subtracts them from `chain`, which has the values of a->chain. 0, or LIN_UNSTABLE if a leaf is
 * singular to working precision or its elimination makes a chain block grow beyond growth_limit; *growth rises to the
 * largest growth found. */
static int leaves_condense(Leaves *s, const NewtonMatrix *a, BlockChain *chain, double growth_limit, double *growth)
{
    for (int l = 0; l < s->leaves; ++l) {
        const int status = leaf_condense(s->factor + l, a->leaf + l, chain, growth_limit, growth);
        if (status) return status;
    }
    return 0;
}

/* Treats right-hand sides before and after the chain's solve; chain [n*b], leaf [unknowns]. Forward turns leaf into
 * E^-1 leaf and subtracts it from the chain; back subtracts the chain's solution from the leaves. */
static void leaves_forward(const Leaves *s, double *chain, double *leaf)
{
    for (int l = 0; l < s->leaves; ++l) {
        const LeafFactor *const f = s->factor + l;
        double solved[LEAF_MAX] = {0};
        multiply_add(f->size, f->size, 1, 1, f->inverse, leaf + f->first, solved);
        memcpy(leaf + f->first, solved, (size_t)f->size * sizeof(double));
        for (int k = 0; k < f->touches; ++k) {
            multiply_add(s->b, f->size, 1, -1, f->into[k], solved, chain + (f->at + k) * s->b);
        }
    }
}

static void leaves_back(const Leaves *s, const double *chain, double *leaf)
{
    for (int l = 0; l < s->leaves; ++l) {
        const LeafFactor *const f = s->factor + l;
        for (int k = 0; k < f->touches; ++k) {
            multiply_add(f->size, s->b, 1, -1, f->back[k], chain + (f->at + k) * s->b, leaf + f->first);
        }
    }
}

/* The block LU with leaf bodies condensed into the chain and a dense border around it: the back end `bordered`.
 * docs/theory.md, "Linear solvers", (L9)-(L11). */

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

/* P and the LU of S; LIN_UNSTABLE if S is singular to working precision: the whole matrix need not be. */
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
