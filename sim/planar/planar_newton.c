#include "sim/planar/planar_newton.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/lanes.h"
#include "core/base/team.h"

static int parts_new(PlanarNewton *nw)
{
    const int n = nw->chain->n;
    const int ok = chain_struct_alloc(&nw->k, n) & chain_struct_alloc(&nw->d, n) & block_chain_alloc(&nw->a, n, 3) &
                   chain_arrays_new(nw->z, 3, n, 0);
    nw->x = calloc((size_t)(3 * nw->chain->stride) + LANES, sizeof *nw->x);
    return ok && nw->x;
}

hawser_status planar_newton_new(PlanarNewton *nw, const PlanarChain *chain, const LinOptions *options,
                                hawser_error *err)
{
    *nw = (PlanarNewton){.chain = chain, .middle = halves_middle(chain->n), .team = options->team};
    hawser_error mine = {0};
    if (parts_new(nw)) nw->solver = linsolver_new(&nw->a, options, &mine);
    if (nw->solver) return HAWSER_OK;
    planar_newton_free(nw);
    if (!mine.status) return error_memory(err);
    return error_set(err, mine.status, "%s", mine.message);
}

void planar_newton_free(PlanarNewton *nw)
{
    chain_struct_free(&nw->k);
    chain_struct_free(&nw->d);
    block_chain_free(&nw->a);
    chain_arrays_free(nw->z, 3);
    free(nw->x);
    nw->solver = linsolver_free(nw->solver);
    memset(nw, 0, sizeof *nw);
}

/* A loop over segments, of which one of two threads does half. */
typedef struct Share {
    PlanarNewton *nw;
    double *b;
} Share;

static int share_from(const PlanarNewton *nw, int rank) { return rank == 0 ? 0 : nw->middle; }
static int share_to(const PlanarNewton *nw, int rank) { return rank == 0 ? nw->middle : nw->chain->n; }

static void form_job(void *arg, int rank)
{
    PlanarNewton *const nw = ((Share *)arg)->nw;
    planar_sim_kernels()->form(nw, share_from(nw, rank), share_to(nw, rank));
}

/* Rows that are eliminated, then coupled, while what the first wrote for the second is in the nearest cache; whole
 * lanes. */
enum { TILE = 256 };

/* Eliminates in one half and couples its rows, but for the lane beside the middle, which needs the other half's z too.
 * A lane needs its neighbours' z: coupling follows one lane behind. */
static void reduce_job(void *arg, int rank)
{
    const Share *const s = arg;
    PlanarNewton *const nw = s->nw;
    const int from = share_from(nw, rank), to = share_to(nw, rank);
    int coupled = rank == 0 ? from : from + LANES;
    for (int i = from; i < to; i += TILE) {
        const int end = i + TILE < to ? i + TILE : to, last = end == to && rank == 1 ? to : end - LANES;
        planar_sim_kernels()->eliminate(nw, s->b, i, end);
        if (last > coupled) planar_sim_kernels()->couple(nw, s->b, coupled, last);
        if (last > coupled) coupled = last;
    }
}

static void expand_job(void *arg, int rank)
{
    const Share *const s = arg;
    planar_sim_kernels()->expand(s->nw, s->b, share_from(s->nw, rank), share_to(s->nw, rank));
}

static void both(TeamJob job, Share *share)
{
    const PlanarNewton *const nw = share->nw;
    halves_run(nw->team, nw->chain->n >= HALVES_LONG, job, share);
}

void planar_newton_form(PlanarNewton *nw, double gamma)
{
    Share share = {.nw = nw};
    nw->gamma = gamma;
    both(form_job, &share);
}

int planar_newton_solve(PlanarNewton *nw, double *b)
{
    Share share = {.nw = nw, .b = b};
    const int n = nw->chain->n, before = nw->middle > 0 ? nw->middle - LANES : 0;
    both(reduce_job, &share);
    planar_sim_kernels()->couple(nw, b, before, nw->middle + LANES < n ? nw->middle + LANES : n);
    const int status = linsolver_solve(nw->solver, nw->x);
    if (!status) both(expand_job, &share);
    return status;
}

void planar_newton_checkpoint(Checkpoint *c, PlanarNewton *nw)
{
    const int n = nw->chain->n;
    chain_struct_checkpoint(c, "nw->k", &nw->k, n);
    chain_struct_checkpoint(c, "nw->d", &nw->d, n);
    CHECKPOINT(c, nw->gamma);
    if (c->reading && !c->status) planar_newton_form(nw, nw->gamma);
    const NewtonMatrix m = {.chain = nw->a};
    linsolver_checkpoint(c, nw->solver, &m, NULL);
}
