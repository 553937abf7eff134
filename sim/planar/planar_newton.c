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

/* Eliminates and couples rows, whose neighbours' z are needed too: elimination is a lane ahead of coupling, and the
 * rows at the middle wait for the other half. */
static void rows_reduce(void *arg, LinSide side, int from, int to)
{
    const Share *const s = arg;
    PlanarNewton *const nw = s->nw;
    const int n = nw->chain->n;
    if (side == LIN_TOP) {
        planar_sim_kernels()->eliminate(nw, s->b, from > 0 ? from + LANES : 0, to + LANES);
    } else if (side == LIN_BOTTOM) {
        planar_sim_kernels()->eliminate(nw, s->b, from - LANES, to < n ? to - LANES : to);
    } else { /* what no side was asked for, having no rows of its own */
        if (from == 0) planar_sim_kernels()->eliminate(nw, s->b, 0, nw->middle);
        if (to == n) planar_sim_kernels()->eliminate(nw, s->b, nw->middle, to);
    }
    planar_sim_kernels()->couple(nw, s->b, from, to);
}

static void rows_expand(void *arg, int from, int to)
{
    const Share *const s = arg;
    planar_sim_kernels()->expand(s->nw, s->b, from, to);
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
    return linsolver_stream(nw->solver, &(LinStream){&share, rows_reduce, rows_expand}, nw->x);
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
