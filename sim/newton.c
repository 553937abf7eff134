#include "sim/newton.h"

#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "core/lanes.h"
#include "sim/newton_extra.h"
#include "sim/newton_full.h"
#include "sim/newton_kernels.h"

static const NewtonKernels *kernels(void)
{
    static const NewtonKernels *const table[] = ISA_TABLE(newton_kernels);
    return table[isa_best()];
}

static int parts_new(Newton *nw)
{
    const int n = nw->n;
    int ok = chain_arrays_new(&nw->mass, 1, n, 1) & chain_arrays_new(nw->inertia, 9, n, 0) &
             chain_arrays_new(nw->w, 3, n, 0);
    ok &= chain_arrays_new(nw->q, 1, n, 1) & chain_arrays_new(nw->q + 1, 3, n, 0);
    ok &= block_chain_alloc(&nw->k, n, 6) & block_chain_alloc(&nw->d, n, 6) & block_chain_alloc(&nw->a, n, 6);
    nw->z = calloc((size_t)(6 * n) + LANES, sizeof(double));
    nw->x = calloc((size_t)(6 * n) + LANES, sizeof(double));
    return ok && nw->z && nw->x;
}

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err)
{
    memset(nw, 0, sizeof *nw);
    nw->n = scene->chain.n;
    nw->team = options->team;
    nw->middle = nw->n / 2 / LANES * LANES;
    if (!parts_new(nw)) {
        newton_free(nw);
        return error_memory(err);
    }
    for (int i = 0; i < nw->n; ++i) nw->mass[i] = scene->chain.mass[i];
    hawser_error mine = {0};
    if (options->kind == LIN_KLU_FULL) {
        newton_full_new(nw, options, &nw->full, &mine);
    } else {
        nw->solver = linsolver_new(&nw->a, options, &mine);
    }
    if (nw->solver || nw->full) return HAWSER_OK;
    newton_free(nw);
    return error_set(err, mine.status ? mine.status : HAWSER_ERR_MEMORY, "%s", mine.message);
}

void newton_free(Newton *nw)
{
    block_chain_free(&nw->k);
    block_chain_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(&nw->mass, 1);
    chain_arrays_free(nw->inertia, 9);
    chain_arrays_free(nw->q, 4);
    chain_arrays_free(nw->w, 3);
    free(nw->z);
    free(nw->x);
    nw->solver = linsolver_free(nw->solver);
    nw->full = newton_full_free(nw->full);
    nw->extra = newton_extra_free(nw->extra);
    memset(nw, 0, sizeof *nw);
}

void newton_point(Newton *nw, const Scene *scene, const Kinematics *kin, const double *y)
{
    const int n = nw->n;
    const Vec3 unit[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (int c = 0; c < 4; ++c) memcpy(nw->q[c], y + (STATE_Q + c) * n, (size_t)n * sizeof(double));
    for (int c = 0; c < 3; ++c) memcpy(nw->w[c], y + (STATE_W + c) * n, (size_t)n * sizeof(double));
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 3; ++c) {
            const Vec3 column = body_inertia_times(&scene->chain, kin, i, unit[c]);
            nw->inertia[c][i] = column.x;
            nw->inertia[3 + c][i] = column.y;
            nw->inertia[6 + c][i] = column.z;
        }
    }
}

/* A loop over segments and the half of it that one of two threads does. */
typedef struct Split {
    Newton *nw;
    double *b;
} Split;

static int split_from(const Newton *nw, int rank) { return rank == 0 ? 0 : nw->middle; }
static int split_to(const Newton *nw, int rank) { return rank == 0 ? nw->middle : nw->n; }

static void form_job(void *arg, int rank)
{
    Newton *const nw = ((Split *)arg)->nw;
    kernels()->form(nw, split_from(nw, rank), split_to(nw, rank));
}

/* Eliminates in one half and couples its rows, but for the one at the middle, which needs the other half's z too. */
static void reduce_job(void *arg, int rank)
{
    const Split *const s = arg;
    Newton *const nw = s->nw;
    const int from = split_from(nw, rank), to = split_to(nw, rank);
    kernels()->eliminate(nw, s->b, from, to);
    kernels()->couple(nw, rank == 0 ? from : from + 1, rank == 0 ? to - 1 : to);
}

static void expand_job(void *arg, int rank)
{
    const Split *const s = arg;
    kernels()->expand(s->nw, s->b, split_from(s->nw, rank), split_to(s->nw, rank));
}

enum { LONG_CHAIN = 1000 }; /* segments from which these loops pay on two threads */

/* Both halves, on two threads or in a row. */
static void both(TeamJob job, Split *split)
{
    if (team_size(split->nw->team) == 2 && split->nw->n >= LONG_CHAIN) {
        team_run(split->nw->team, job, split);
    } else {
        job(split, 0);
        job(split, 1);
    }
}

void newton_form(Newton *nw, double gamma)
{
    Split split = {.nw = nw};
    nw->gamma = gamma;
    if (nw->full) {
        newton_full_form(nw->full, nw);
    } else {
        both(form_job, &split);
    }
    if (nw->extra) newton_extra_form(nw);
}

int newton_factor(Newton *nw)
{
    if (nw->extra) return newton_extra_factor(nw);
    return nw->full ? newton_full_factor(nw->full) : linsolver_factor(nw->solver, &nw->a);
}

void newton_stats(const Newton *nw, LinStats *stats)
{
    linsolver_stats(nw->full ? newton_full_solver(nw->full) : nw->solver, stats);
    if (nw->extra) newton_extra_stats(nw->extra, stats);
}

int newton_solve(Newton *nw, double *b)
{
    if (nw->full) return newton_full_solve(nw->full, nw, b);
    Split split = {.nw = nw, .b = b};
    both(reduce_job, &split);
    kernels()->couple(nw, nw->middle > 0 ? nw->middle - 1 : 0, nw->middle < nw->n ? nw->middle + 1 : nw->n);
    if (nw->extra) newton_extra_couple(nw);
    const int status = linsolver_solve(nw->solver, nw->x);
    if (!status) both(expand_job, &split);
    return status;
}
