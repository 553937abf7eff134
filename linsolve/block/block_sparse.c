/* The back end `block-sparse`: a chain, or several, with blocks anywhere off the three diagonals. The factors' pattern
 * is that of the blocks which are not zero now; without any it is the twisted block LU. docs/model.md, "Linear
 * solvers", (L15)-(L19). */
#include "linsolve/block/block_sparse.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "linsolve/backend.h"

typedef struct BlockSparseSolver {
    const SparseKernels *kernels;
    BlockSolver plain; /* of a matrix without blocks off the diagonals */
    int is_plain;      /* the present factors are those */
    BlockSparse s;
    int coupled;      /* pairs of rows that the pattern was made for; -1: none was made */
    int extras;       /* that there is room for */
    BlockPair *pair;  /* [2][n + extras] those, and room for the next */
    int value_blocks; /* that there is room for */
    long analyses;
    BlockReport report;
} BlockSparseSolver;

static void sparse_drop(void *self)
{
    BlockSparseSolver *const s = self;
    block_solver_release(&s->plain);
    block_pattern_free(&s->s.pattern);
    free(s->s.value);
    free(s->s.scale);
    free(s->s.z);
    free(s->pair);
    free(s);
}

static void *sparse_make(const LinMatrix *a, const LinOptions *options)
{
    static const SparseKernels *const kernels[] = ISA_TABLE(sparse6_kernels);
    const NewtonMatrix *const m = a->newton;
    const int n = m->chain.n;
    BlockSparseSolver *const s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->kernels = kernels[isa_best()];
    s->is_plain = 1;
    s->coupled = -1;
    s->extras = m->extras;
    s->s.growth_limit = growth_limit_of(options);
    Team *const team = options->threads > 1 ? options->team : NULL;
    const int ok = block_solver_init(&s->plain, n, m->chain.b, isa_best(), s->s.growth_limit, team);
    s->s.scale = aligned_array_new(n * SPARSE_WIDTH);
    s->s.z = aligned_array_new(n * SPARSE_WIDTH);
    s->pair = malloc(2 * ((size_t)n + (size_t)m->extras) * sizeof *s->pair);
    if (ok && s->s.scale && s->s.z && s->pair) return s;
    sparse_drop(s);
    return NULL;
}

static int block_is_zero(const double *block)
{
    for (int k = 0; k < SPARSE_CELL; ++k)
        if (block[k] != 0) return 0; /* a NaN is not zero */
    return 1;
}

static int extra_lives(const NewtonMatrix *m, int e)
{
    return m->live ? m->live[e] : !block_is_zero(m->extra[e].block);
}

/* The pairs of rows that are coupled now; each stands once, but extras that both ways live twice. Returns how many. */
static int pairs_now(const NewtonMatrix *m, BlockPair *pair, int *off)
{
    int count = 0;
    for (int i = 1; i < m->chain.n; ++i) {
        if (block_is_zero(m->chain.lower + SPARSE_CELL * i) && block_is_zero(m->chain.upper + SPARSE_CELL * (i - 1)))
            continue;
        pair[count++] = (BlockPair){i - 1, i};
    }
    const int chain = count;
    for (int e = 0; e < m->extras; ++e) {
        const int row = m->extra[e].row, col = m->extra[e].col;
        if (row == col || !extra_lives(m, e)) continue;
        pair[count++] = row < col ? (BlockPair){row, col} : (BlockPair){col, row};
    }
    *off = count - chain;
    return count;
}

/* The pattern for m's blocks of now; < 0: no memory. */
static int pattern_follow(BlockSparseSolver *s, const NewtonMatrix *m, int *off)
{
    const int n = m->chain.n;
    BlockPair *const next = s->pair + n + s->extras;
    assert(m->extras <= s->extras);
    const int count = pairs_now(m, next, off);
    if (*off == 0) return 0;
    if (count == s->coupled && memcmp(next, s->pair, (size_t)count * sizeof *next) == 0) return 0;
    s->coupled = -1;
    ++s->analyses;
    if (!block_pattern_set(&s->s.pattern, n, count, next)) return -1;
    const int blocks = n + 2 * s->s.pattern.start[n];
    if (blocks > s->value_blocks) {
        free(s->s.value);
        s->value_blocks = 0;
        s->s.value = aligned_array_new(SPARSE_CELL * blocks + SPARSE_WIDTH);
        if (!s->s.value) return -1;
        s->value_blocks = blocks;
    }
    memcpy(s->pair, next, (size_t)count * sizeof *next);
    s->coupled = count;
    return 0;
}

/* Adds a block of the matrix to that of the factors, and its absolute values to its row's scale. */
static void block_take(BlockSparse *s, int row, int col, const double *block)
{
    double *const to = s->value + (size_t)block_pattern_find(&s->pattern, row, col) * SPARSE_CELL;
    double *const scale = s->scale + s->pattern.place[row] * SPARSE_WIDTH;
    for (int c = 0; c < SPARSE_B; ++c) {
        for (int r = 0; r < SPARSE_B; ++r) {
            to[c * SPARSE_B + r] += block[c * SPARSE_B + r];
            scale[r] += fabs(block[c * SPARSE_B + r]);
        }
    }
}

static void values_take(BlockSparse *s, const NewtonMatrix *m)
{
    const BlockPattern *const t = &s->pattern;
    memset(s->value, 0, (size_t)(t->n + 2 * t->start[t->n]) * SPARSE_CELL * sizeof *s->value);
    memset(s->scale, 0, (size_t)t->n * SPARSE_WIDTH * sizeof *s->scale);
    for (int i = 0; i < t->n; ++i) {
        block_take(s, i, i, m->chain.diag + SPARSE_CELL * i);
        const double *const lower = m->chain.lower + SPARSE_CELL * i;
        const double *const upper = m->chain.upper + SPARSE_CELL * (i - 1);
        if (i == 0 || (block_is_zero(lower) && block_is_zero(upper))) continue;
        block_take(s, i, i - 1, lower);
        block_take(s, i - 1, i, upper);
    }
    for (int e = 0; e < m->extras; ++e)
        if (extra_lives(m, e)) block_take(s, m->extra[e].row, m->extra[e].col, m->extra[e].block);
}

static int sparse_factor(void *self, const LinMatrix *a)
{
    BlockSparseSolver *const s = self;
    int off = 0;
    if (a->newton->extras > 0 && pattern_follow(s, a->newton, &off)) return -1;
    s->is_plain = off == 0;
    if (s->is_plain) return block_solver_factor(&s->plain, &a->newton->chain);
    values_take(&s->s, a->newton);
    s->report = (BlockReport){.growth = 1};
    return s->kernels->factor(&s->s, &s->report);
}

static int sparse_solve(void *self, int count, double *x)
{
    BlockSparseSolver *const s = self;
    if (s->is_plain) block_solver_solve(&s->plain, count, x);
    for (int r = 0; !s->is_plain && r < count; ++r)
        s->kernels->solve(&s->s, x + (size_t)r * SPARSE_B * (size_t)s->s.pattern.n);
    return 0;
}

static void sparse_stats(const void *self, LinStats *stats)
{
    const BlockSparseSolver *const s = self;
    const BlockReport *const report = s->is_plain ? &s->plain.report : &s->report;
    const BlockPattern *const t = &s->s.pattern;
    stats->pivoted = report->pivoted;
    stats->growth = 1 / report->growth;
    stats->analyses = s->analyses;
    stats->nonzeros = s->is_plain ? block_solver_nonzeros(&s->plain) : (long)SPARSE_CELL * (t->n + 2L * t->start[t->n]);
    if (!s->is_plain) stats->ordering = "along";
}

const LinBackend block_sparse_backend = {
    .make = sparse_make, .drop = sparse_drop, .factor = sparse_factor, .solve = sparse_solve, .stats = sparse_stats};
