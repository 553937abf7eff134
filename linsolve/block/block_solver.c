#include "linsolve/block/block_factor.h"

#include <assert.h>
#include <stdlib.h>

#include "core/chain.h"
#include "linsolve/backend.h"

/* From how many blocks, and from how many entries in the diagonal ones, the second thread pays: measured,
 * bench/results/xeon-2core/linsolve.md. */
enum { TEAM_FACTOR_MIN = 600, TEAM_SOLVE_ENTRIES = 30000, ALIGNMENT = 64 };
/* Rows that are made, swept over and used while they are in the second cache. Shorter tiles cost more than they save:
 * forty arrays that begin anew have their first lines fetched one by one. */
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
    const LinStream *stream; /* NULL: x is whole */
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
