#include "linsolve/block/block_factor.h"

#include <assert.h>
#include <stdlib.h>

#include "core/chain.h"
#include "linsolve/backend.h"

/* From how many blocks, and from how many entries in the diagonal ones, the second thread pays: measured,
 * bench/results/xeon-2core/linsolve.md. */
enum { TEAM_FACTOR_MIN = 600, TEAM_SOLVE_ENTRIES = 30000, ALIGNMENT = 64 };

static const BlockKernels *kernels_for(int b, Isa isa)
{
    static const BlockKernels *const six[] = ISA_TABLE(block6_kernels);
    static const BlockKernels *const three[] = ISA_TABLE(block3_kernels);
    return b == 6 ? six[isa] : three[isa];
}

int block_solver_init(BlockSolver *s, int n, int b, Isa isa, double growth_limit, Team *team)
{
    assert(n > 0 && (b == 3 || b == 6));
    const int width = b == 6 ? 8 : 4;
    const int cell = b * b;
    *s = (BlockSolver){.kernels = kernels_for(b, isa), .team = team, .report = {.growth = 1}};
    s->f = (BlockFactor){.n = n, .b = b, .width = width, .middle = n / 2, .growth_limit = growth_limit};
    s->f.front = aligned_array_new(2 * cell * n);
    s->f.back = aligned_array_new(cell * n);
    s->f.z = aligned_array_new(n * BLOCK_RHS * width);
    if (s->f.front && s->f.back && s->f.z) return 1;
    block_solver_release(s);
    return 0;
}

void block_solver_release(BlockSolver *s)
{
    free(s->f.front);
    free(s->f.back);
    free(s->f.z);
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

typedef struct SolveJob {
    BlockSolver *s;
    int count;
    double *x;
} SolveJob;

static void forward_side(void *arg, int rank)
{
    const SolveJob *const job = arg;
    job->s->kernels->forward(&job->s->f, rank ? SIDE_BOTTOM : SIDE_TOP, job->count, job->x);
}

static void back_side(void *arg, int rank)
{
    const SolveJob *const job = arg;
    job->s->kernels->back(&job->s->f, rank ? SIDE_BOTTOM : SIDE_TOP, job->count, job->x);
}

void block_solver_solve(BlockSolver *s, int count, double *x)
{
    const BlockFactor *const f = &s->f;
    for (int done = 0; done < count; done += BLOCK_RHS) {
        double *const at = x + (size_t)done * (size_t)(f->n * f->b);
        SolveJob job = {s, count - done < BLOCK_RHS ? count - done : BLOCK_RHS, at};
        if (f->n * f->b * f->b >= TEAM_SOLVE_ENTRIES && team_ready(s->team)) {
            team_run(s->team, forward_side, &job);
            team_run(s->team, back_side, &job);
        } else {
            s->kernels->forward(f, SIDE_BOTH, job.count, at);
            s->kernels->back(f, SIDE_BOTH, job.count, at);
        }
    }
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

static void block_stats(const void *self, LinStats *stats)
{
    const BlockSolver *const s = self;
    stats->pivoted = s->report.pivoted;
    stats->nonzeros = block_solver_nonzeros(s);
    stats->growth = 1 / s->report.growth;
}

const LinBackend block_backend = {
    .make = block_make, .drop = block_drop, .factor = block_factorise, .solve = block_solve, .stats = block_stats};
