/* The order of elimination along the chains, and the blocks that it fills. */
#include "linsolve/block.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/chain.h"
#include "linsolve/backend.h"
#include "linsolve/block_factor.h"

/* Neighbours of every row: near[start[i]] .. near[start[i+1]-1]. */
typedef struct Graph {
    int n;
    int *start, *near;
} Graph;

static int graph_make(Graph *g, int n, int count, const BlockPair *coupled)
{
    *g = (Graph){n, calloc((size_t)n + 2, sizeof(int)), malloc((2 * (size_t)count + 1) * sizeof(int))};
    if (!g->start || !g->near) return 0;
    int *const next = g->start + 1;
    for (int c = 0; c < count; ++c) {
        ++next[coupled[c].low + 1];
        ++next[coupled[c].high + 1];
    }
    for (int i = 0; i < n; ++i) next[i + 1] += next[i];
    for (int c = 0; c < count; ++c) {
        g->near[next[coupled[c].low]++] = coupled[c].high;
        g->near[next[coupled[c].high]++] = coupled[c].low;
    }
    return 1;
}

static void graph_free(Graph *g)
{
    free(g->start);
    free(g->near);
}

void block_pattern_free(BlockPattern *p)
{
    free(p->row);
    free(p->place);
    free(p->start);
    free(p->below);
    free(p->update);
    free(p->updates);
    memset(p, 0, sizeof *p);
}

static int pattern_room(BlockPattern *p, int n)
{
    if (p->row) return 1;
    const size_t rows = (size_t)n + 1;
    p->n = n;
    p->row = calloc(rows, sizeof(int));
    p->place = malloc(rows * sizeof(int));
    p->start = calloc(rows, sizeof(int));
    p->updates = calloc(rows, sizeof(int));
    if (p->row && p->place && p->start && p->updates) return 1;
    block_pattern_free(p); /* an incomplete pattern is not kept for the next attempt */
    return 0;
}

/* Makes room in list for `count`; 0 if there is no memory. */
static int list_room(int **list, int *allocated, int count)
{
    if (count <= *allocated) return 1;
    const int more = 2 * count + 64;
    int *const grown = realloc(*list, (size_t)more * sizeof *grown);
    if (!grown) return 0;
    *list = grown;
    *allocated = more;
    return 1;
}

static int int_compare(const void *a, const void *b) { return *(const int *)a - *(const int *)b; }

/* Blocks filled by elimination in the order p->row: column k has its couplings with later rows, and those of the
 * columns whose first block is in row k. */
static int fill(BlockPattern *p, const Graph *g)
{
    const int n = p->n;
    int *const mark = malloc(3 * (size_t)n * sizeof *mark + 1), *const child = mark + n, *const sibling = child + n;
    int count = 0, ok = mark != NULL;
    for (int k = 0; ok && k < n; ++k) mark[k] = child[k] = -1;
    for (int k = 0; ok && k < n; ++k) {
        p->start[k] = count;
        ok = list_room(&p->below, &p->allocated, count + n - k);
        mark[k] = k;
        const int row = p->row[k];
        for (int e = g->start[row]; ok && e < g->start[row + 1]; ++e) {
            const int i = p->place[g->near[e]];
            if (i > k && mark[i] != k) p->below[count++] = i, mark[i] = k;
        }
        for (int c = ok ? child[k] : -1; c >= 0; c = sibling[c]) {
            for (int e = p->start[c]; e < p->start[c + 1]; ++e) {
                const int i = p->below[e];
                if (mark[i] != k) p->below[count++] = i, mark[i] = k;
            }
        }
        p->start[k + 1] = count;
        const int own = count - p->start[k];
        if (own > 1) qsort(p->below + p->start[k], (size_t)own, sizeof(int), int_compare);
        if (!own) continue;
        const int parent = p->below[p->start[k]];
        sibling[k] = child[parent];
        child[parent] = k;
    }
    free(mark);
    return ok;
}

/* The number of the block at (i, j) of the rows in their order. */
static int block_of(const BlockPattern *p, int i, int j)
{
    if (i == j) return i;
    const int column = i > j ? j : i, row = i > j ? i : j;
    int low = p->start[column], high = p->start[column + 1];
    while (low + 1 < high) {
        const int middle = (low + high) / 2;
        if (p->below[middle] <= row) low = middle;
        if (p->below[middle] > row) high = middle;
    }
    return p->n + low + (i > j ? 0 : p->start[p->n]);
}

/* The number of the block at (row, col) of the matrix, which is in the pattern. */
static int block_pattern_find(const BlockPattern *p, int row, int col)
{
    return block_of(p, p->place[row], p->place[col]);
}

/* Sets the targets of the products of each column's blocks. */
static int updates_set(BlockPattern *p)
{
    int count = 0;
    for (int k = 0; k < p->n; ++k) {
        const int own = p->start[k + 1] - p->start[k];
        p->updates[k] = count;
        if (!list_room(&p->update, &p->updates_allocated, count + own * own)) return 0;
        for (int a = p->start[k]; a < p->start[k + 1]; ++a) {
            for (int b = p->start[k]; b < p->start[k + 1]; ++b)
                p->update[count++] = block_of(p, p->below[a], p->below[b]);
        }
    }
    p->updates[p->n] = count;
    return 1;
}

static int degree(const Graph *g, int i) { return g->start[i + 1] - g->start[i]; }

/* Appends the rows that row number k of the order couples with and that are not placed yet to the order, those with
 * fewer neighbours first; returns its new length. */
static int neighbours_take(BlockPattern *p, const Graph *g, int k, int count)
{
    const int from = count, row = p->row[k];
    for (int e = g->start[row]; e < g->start[row + 1]; ++e) {
        const int j = g->near[e];
        if (p->place[j] >= 0) continue;
        p->place[j] = 0;
        int at = count++;
        for (; at > from && degree(g, p->row[at - 1]) > degree(g, j); --at) p->row[at] = p->row[at - 1];
        p->row[at] = j;
    }
    return count;
}

/* Cuthill and McKee's order, reversed (L15): rows by their distance from one end of the coupled rows, so that chains
 * beside each other are ordered in parallel, and the band is as wide as the number of chains. */
static void along(BlockPattern *p, const Graph *g)
{
    enum { PASSES = 3 }; /* from any row to an end, to the other end, and back through all */
    int count = 0;
    for (int i = 0; i < p->n; ++i) p->place[i] = -1;
    for (int i = 0; i < p->n; ++i) {
        if (p->place[i] >= 0) continue;
        const int first = count;
        int root = i;
        for (int pass = 0; pass < PASSES; ++pass) {
            for (int k = first; k < count; ++k) p->place[p->row[k]] = -1;
            count = first + 1;
            p->row[first] = root;
            p->place[root] = 0;
            for (int k = first; k < count; ++k) count = neighbours_take(p, g, k, count);
            root = p->row[count - 1];
        }
    }
    for (int k = 0; k < p->n / 2; ++k) {
        const int row = p->row[k];
        p->row[k] = p->row[p->n - 1 - k];
        p->row[p->n - 1 - k] = row;
    }
    for (int k = 0; k < p->n; ++k) p->place[p->row[k]] = k;
}

int block_pattern_set(BlockPattern *p, int n, int count, const BlockPair *coupled)
{
    Graph g;
    int ok = graph_make(&g, n, count, coupled) && pattern_room(p, n);
    if (ok) along(p, &g);
    ok = ok && fill(p, &g) && updates_set(p);
    graph_free(&g);
    return ok;
}

/* The rare path of the block LU: a row whose diagonal pivots are too small gets full partial pivoting, in plain C. */

enum { B_MAX = 6, W_MAX = 8 };

const double block_zero[B_MAX * B_MAX + W_MAX];

/* [S | after | I], column-major; Gauss-Jordan turns it into [I | V | X]. */
typedef struct Augmented {
    int b;
    double a[3 * B_MAX][B_MAX];
    double scale[B_MAX]; /* row sums of |S|: pivots are compared after scaling by them */
} Augmented;

static void augment(const BlockFactor *f, const BlockRow *row, Augmented *g)
{
    const int b = f->b;
    memset(g, 0, sizeof *g);
    g->b = b;
    for (int c = 0; c < b; ++c) {
        memcpy(g->a[c], row->diag + c * b, (size_t)b * sizeof(double));
        memcpy(g->a[b + c], row->after + c * b, (size_t)b * sizeof(double));
        g->a[2 * b + c][c] = 1;
        for (int k = 0; k < b; ++k) {
            for (int r = 0; r < b; ++r) g->a[c][r] -= row->before[k * b + r] * row->v_before[c * b + k];
        }
        for (int r = 0; r < b; ++r) g->scale[r] += fabs(g->a[c][r]);
    }
}

/* The row at or below k with the largest scaled entry in column k. */
static int pivot_row(const Augmented *g, int k)
{
    int best = k;
    for (int r = k + 1; r < g->b; ++r) {
        if (fabs(g->a[k][r]) * g->scale[best] > fabs(g->a[k][best]) * g->scale[r]) best = r;
    }
    return best;
}

static void rows_swap(Augmented *g, int r, int s)
{
    const double scale = g->scale[r];
    g->scale[r] = g->scale[s];
    g->scale[s] = scale;
    for (int c = 0; c < 3 * g->b; ++c) {
        const double entry = g->a[c][r];
        g->a[c][r] = g->a[c][s];
        g->a[c][s] = entry;
    }
}

static void column_eliminate(Augmented *g, int k)
{
    const double inverse = 1 / g->a[k][k];
    double m[B_MAX];
    for (int r = 0; r < g->b; ++r) m[r] = r == k ? 0 : g->a[k][r] * inverse;
    for (int c = k; c < 3 * g->b; ++c) {
        const double p = g->a[c][k];
        for (int r = 0; r < g->b; ++r) g->a[c][r] -= m[r] * p;
        g->a[c][k] = p * inverse;
    }
}

int block_row_pivoted(const BlockFactor *f, const BlockRow *row)
{
    static const double singular = 1e-14; /* pivot over row sum: the rest is rounding */
    const int b = f->b;
    Augmented g;
    augment(f, row, &g);
    for (int k = 0; k < b; ++k) {
        const int p = pivot_row(&g, k);
        if (!(fabs(g.a[k][p]) > singular * g.scale[p])) return LIN_UNSTABLE;
        if (p != k) rows_swap(&g, p, k);
        column_eliminate(&g, k);
    }
    for (int c = 0; c < b; ++c) {
        memcpy(row->back + c * b, g.a[b + c], (size_t)b * sizeof(double));
        memcpy(row->front + (b + c) * b, g.a[2 * b + c], (size_t)b * sizeof(double));
    }
    return 0;
}

/* The back end `block-sparse`: a chain, or several, with blocks anywhere off the three diagonals. The factors' pattern
 * follows from the blocks that are not zero at present; without any it is the twisted block LU. docs/theory.md, "Linear
 * solvers", (L15)-(L19). */

typedef struct BlockSparseSolver {
    const SparseKernels *kernels;
    BlockSolver plain; /* for a matrix without blocks off the diagonals */
    int is_plain;      /* 1: the present factors are in `plain` */
    BlockSparse s;
    int coupled;      /* number of pairs of rows for which the pattern was made; -1: none */
    int extras;       /* number allocated */
    BlockPair *pair;  /* [2][n + extras] the pairs, and room for the next ones */
    int value_blocks; /* number allocated */
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
        if (block[k] != 0) return 0; /* a NaN counts as not zero */
    return 1;
}

static int extra_lives(const NewtonMatrix *m, int e)
{
    return m->live ? m->live[e] : !block_is_zero(m->extra[e].block);
}

/* Finds the pairs of rows that are coupled at present, each once; the matrix has extra blocks in both directions.
 * Returns their number. */
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

/* Makes the pattern for m's present blocks; < 0: no memory. */
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

/* Numbers of blocks, and of entries in the diagonal ones, from which the second thread pays: measured,
 * bench/results/xeon-2core/linsolve.md. */
enum { TEAM_FACTOR_MIN = 600, TEAM_SOLVE_ENTRIES = 30000, ALIGNMENT = 64 };

/* Rows that are filled, swept over and used while they are in the second cache. Shorter tiles cost more than they save:
 * at every start of a tile, the first lines of forty arrays have to be fetched separately. */
enum { TILE = 4096 };

static const BlockKernels *kernels_for(int b, Isa isa)
{
    static const BlockKernels *const six[] = ISA_TABLE(block6_kernels);
    static const BlockKernels *const three[] = ISA_TABLE(block3_kernels);
    return b == 6 ? six[isa] : three[isa];
}

int block_solver_init(BlockSolver *s, int n, int b, Isa isa, double growth_limit, Team *team)
{
    assert(n > 0 && (b == 3 || b == 6));
    const int cell = b * b;
    *s = (BlockSolver){.kernels = kernels_for(b, isa), .team = team, .report = {.growth = 1}};
    s->f = (BlockFactor){.n = n, .b = b, .middle = n / 2, .growth_limit = growth_limit};
    s->f.front = aligned_array_new(2 * cell * n);
    s->f.back = aligned_array_new(cell * n);
    s->f.edge = aligned_array_new(2 * BLOCK_CELL);
    if (s->f.front && s->f.back && s->f.edge) return 1;
    block_solver_release(s);
    return 0;
}

void block_solver_release(BlockSolver *s)
{
    free(s->f.front);
    free(s->f.back);
    free(s->f.edge);
    *s = (BlockSolver){0};
}

/* A job for two threads: rank 0 takes the top, rank 1 the bottom. */
typedef struct FactorJob {
    const BlockSolver *s;
    const BlockChain *a;
    struct {
        _Alignas(ALIGNMENT) BlockReport report;
        int status;
    } side[2];
} FactorJob;

static void factor_side(void *arg, int rank)
{
    FactorJob *const job = arg;
    job->side[rank].status =
        job->s->kernels->factor(&job->s->f, job->a, rank ? SIDE_BOTTOM : SIDE_TOP, &job->side[rank].report);
}

static int factor_apart(BlockSolver *s, const BlockChain *a)
{
    FactorJob job = {.s = s, .a = a};
    team_run(s->team, factor_side, &job);
    for (int rank = 0; rank < 2; ++rank) {
        const BlockReport *const part = &job.side[rank].report;
        s->report.pivoted += part->pivoted;
        if (part->growth > s->report.growth) s->report.growth = part->growth;
    }
    return job.side[0].status ? job.side[0].status : job.side[1].status;
}

int block_solver_factor(BlockSolver *s, const BlockChain *a)
{
    const BlockFactor *const f = &s->f;
    s->report = (BlockReport){.growth = 1};
    const int apart = f->n >= TEAM_FACTOR_MIN && team_ready(s->team);
    int status = apart ? factor_apart(s, a) : s->kernels->factor(f, a, SIDE_BOTH, &s->report);
    if (!status) status = s->kernels->factor_middle(f, a, &s->report);
    return status;
}

void block_solver_round(BlockSolver *s, int single) { s->f.single = single; }

/* A solution: the sides' rows outside the seam, tile by tile, then the seam, then back. */
typedef struct SolveJob {
    BlockSolver *s;
    const LinStream *stream; /* NULL: x is complete */
    int count, tile;
    LinSeam seam;
    double *x;
} SolveJob;

static void rows_fill(const SolveJob *job, LinSide side, int from, int to)
{
    if (job->stream && from < to) job->stream->fill(job->stream->user, side, from, to);
}

static void rows_take(const SolveJob *job, int from, int to)
{
    if (job->stream && from < to) job->stream->take(job->stream->user, from, to);
}

/* Tile k of the sides, counted from the chain's ends. */
static BlockSpan tile_span(const SolveJob *job, int sides, int k)
{
    const int n = job->s->f.n, whole = (n + LANES - 1) / LANES * LANES, from = k * job->tile, to = from + job->tile;
    BlockSpan span = {0};
    if (sides & SIDE_TOP) {
        span.top_from = from < job->seam.from ? from : job->seam.from;
        span.top_to = to < job->seam.from ? to : job->seam.from;
    }
    if (sides & SIDE_BOTTOM) {
        const int high = k ? whole - from : n, low = whole - to;
        span.bottom_to = high > job->seam.to ? high : job->seam.to;
        span.bottom_from = low > job->seam.to ? low : job->seam.to;
    }
    return span;
}

static int tiles(const SolveJob *job)
{
    const int above = job->seam.from, below = job->s->f.n - job->seam.to + LANES;
    return (above > below ? above : below) / job->tile + 1;
}

static void sweep_forward(const SolveJob *job, int sides)
{
    const BlockFactor *const f = &job->s->f;
    for (int k = 0; k < tiles(job); ++k) {
        const BlockSpan span = tile_span(job, sides, k);
        rows_fill(job, LIN_TOP, span.top_from, span.top_to);
        rows_fill(job, LIN_BOTTOM, span.bottom_from, span.bottom_to);
        job->s->kernels->forward(f, span, job->count, job->x);
    }
}

static void sweep_back(const SolveJob *job, int sides)
{
    const BlockFactor *const f = &job->s->f;
    for (int k = tiles(job) - 1; k >= 0; --k) {
        const BlockSpan span = tile_span(job, sides, k);
        job->s->kernels->back(f, span, job->count, job->x);
        rows_take(job, span.top_from, span.top_to);
        rows_take(job, span.bottom_from, span.bottom_to);
    }
}

static void forward_side(void *arg, int rank) { sweep_forward(arg, rank ? SIDE_BOTTOM : SIDE_TOP); }

static void back_side(void *arg, int rank) { sweep_back(arg, rank ? SIDE_BOTTOM : SIDE_TOP); }

static void solve_job(SolveJob *job)
{
    const BlockSolver *const s = job->s;
    const BlockFactor *const f = &s->f;
    const LinSeam seam = job->seam;
    const BlockSpan inner = {seam.from, f->middle, f->middle + 1, seam.to};
    const int large = f->n * f->b * f->b >= TEAM_SOLVE_ENTRIES || (job->stream && f->n >= HALVES_LONG);
    const int apart = large && team_ready(s->team);
    if (apart) {
        team_run(s->team, forward_side, job);
    } else {
        sweep_forward(job, SIDE_BOTH);
    }
    rows_fill(job, LIN_SEAM, seam.from, seam.to);
    s->kernels->forward(f, inner, job->count, job->x);
    s->kernels->middle(f, job->count, job->x);
    s->kernels->back(f, inner, job->count, job->x);
    rows_take(job, seam.from, seam.to);
    if (apart) {
        team_run(s->team, back_side, job);
    } else {
        sweep_back(job, SIDE_BOTH);
    }
}

void block_solver_solve(BlockSolver *s, int count, double *x)
{
    const BlockFactor *const f = &s->f;
    for (int done = 0; done < count; done += BLOCK_RHS) {
        SolveJob job = {.s = s,
                        .count = count - done < BLOCK_RHS ? count - done : BLOCK_RHS,
                        .tile = f->n + LANES,
                        .seam = lin_seam(f->n),
                        .x = x + (size_t)done * (size_t)(f->n * f->b)};
        solve_job(&job);
    }
}

void block_solver_stream(BlockSolver *s, const LinStream *stream, double *x)
{
    SolveJob job = {.s = s, .stream = stream, .count = 1, .tile = TILE, .seam = lin_seam(s->f.n), .x = x};
    solve_job(&job);
}

long block_solver_nonzeros(const BlockSolver *s) { return 3L * s->f.n * s->f.b * s->f.b; }

/* The back end `block`. */

static void *block_make(const LinMatrix *a, const LinOptions *options)
{
    BlockSolver *const s = malloc(sizeof *s);
    if (!s) return NULL;
    const BlockChain *const chain = &a->newton->chain;
    Team *const team = options->threads > 1 ? options->team : NULL;
    if (block_solver_init(s, chain->n, chain->b, isa_best(), growth_limit_of(options), team)) return s;
    free(s);
    return NULL;
}

static void block_drop(void *self)
{
    block_solver_release(self);
    free(self);
}

static int block_factorise(void *self, const LinMatrix *a) { return block_solver_factor(self, &a->newton->chain); }

static int block_solve(void *self, int count, double *x)
{
    block_solver_solve(self, count, x);
    return 0;
}

static int block_stream(void *self, const LinStream *stream, double *x)
{
    block_solver_stream(self, stream, x);
    return 0;
}

static void block_rough(void *self, int rough)
{
    BlockSolver *const s = self;
    block_solver_round(s, rough && s->f.n * s->f.b * s->f.b >= LIN_ROUND_ENTRIES);
}

static void block_stats(const void *self, LinStats *stats)
{
    const BlockSolver *const s = self;
    stats->pivoted = s->report.pivoted;
    stats->nonzeros = block_solver_nonzeros(s);
    stats->growth = 1 / s->report.growth;
}

const LinBackend block_backend = {.make = block_make,
                                  .drop = block_drop,
                                  .factor = block_factorise,
                                  .solve = block_solve,
                                  .stream = block_stream,
                                  .rough = block_rough,
                                  .stats = block_stats};
