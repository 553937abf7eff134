#include "sim/newton/newton.h"

#include <string.h>

#include "core/base/error.h"
#include "core/base/lanes.h"
#include "linsolve/inertia.h"
#include "sim/newton/newton_extra.h"
#include "sim/newton/newton_leaves.h"

/* The solver that the options ask for, for the present pattern. */
static hawser_status solver_new(Newton *nw, hawser_error *err)
{
    hawser_error mine = {0};
    if (nw->options.kind == LIN_KLU_FULL) {
        newton_full_new(nw, &nw->options, &nw->full, &mine);
    } else {
        nw->solver = linsolver_new_newton(&nw->matrix, &nw->options, &mine);
    }
    if (nw->solver || nw->full) return HAWSER_OK;
    return error_set(err, mine.status ? mine.status : HAWSER_ERR_MEMORY, "%s", mine.message);
}

static hawser_status equipment_new(Newton *nw, const Scene *scene, hawser_error *err)
{
    if (nw->options.kind != LIN_KLU_FULL) return newton_leaves_new(nw, scene->equipment, err);
    return error_set(
        err, HAWSER_ERR_INPUT,
        "key 'solver.linear_solver': 'klu-full' cannot hold rollers that spin or stand on mounts: expected "
        "auto, bordered or klu");
}

hawser_status newton_new(Newton *nw, const Scene *scene, const LinOptions *options, hawser_error *err)
{
    memset(nw, 0, sizeof *nw);
    nw->n = scene->chain.n;
    nw->team = options->team;
    nw->middle = halves_middle(nw->n);
    if (!newton_parts_new(nw, scene->equipment->spins + 6 * scene->equipment->mounts)) {
        newton_free(nw);
        return error_memory(err);
    }
    for (int i = 0; i < nw->n; ++i) nw->mass[i] = scene->chain.mass[i];
    nw->matrix.chain = nw->a;
    nw->options = *options;
    hawser_status status = HAWSER_OK;
    if (scene->equipment->n > 0) status = equipment_new(nw, scene, err);
    if (!status) status = solver_new(nw, err);
    if (status) newton_free(nw);
    return status;
}

hawser_status newton_rows_new(Newton *nw, int rows, const LinOptions *options, hawser_error *err)
{
    memset(nw, 0, sizeof *nw);
    nw->n = rows;
    nw->team = options->team;
    nw->middle = halves_middle(rows);
    nw->options = *options;
    hawser_status status = newton_parts_new(nw, 0) ? HAWSER_OK : error_memory(err);
    nw->matrix.chain = nw->a;
    if (!status) status = solver_new(nw, err);
    if (status) newton_free(nw);
    return status;
}

/* The blocks of the rows from `row` on. */
static BlockChain rows_of(const BlockChain *whole, int row, int n)
{
    const size_t at = 36 * (size_t)row;
    return (BlockChain){n, 6, whole->lower + at, whole->diag + at, whole->upper + at};
}

void newton_part(const Newton *whole, int row, const Chain *chain, Newton *part)
{
    const int n = chain->n;
    *part = (Newton){.n = n,
                     .middle = halves_middle(n),
                     .k = rows_of(&whole->k, row, n),
                     .d = rows_of(&whole->d, row, n),
                     .a = rows_of(&whole->a, row, n),
                     .mass = whole->mass + row,
                     .z = whole->z + 6 * (size_t)row,
                     .x = whole->x + 6 * (size_t)row,
                     .team = whole->team};
    for (int c = 0; c < 9; ++c) part->inertia[c] = whole->inertia[c] + row;
    for (int c = 0; c < 4; ++c) part->q[c] = whole->q[c] + row;
    for (int c = 0; c < 3; ++c) part->w[c] = whole->w[c] + row;
    for (int i = 0; i < n; ++i) part->mass[i] = chain->mass[i];
}

void newton_free(Newton *nw)
{
    newton_parts_free(nw);
    nw->leaves = newton_leaves_free(nw->leaves);
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

void newton_swell(Newton *nw, double radius)
{
    for (int i = 0; i < nw->n; ++i) {
        for (int c = 0; c < 9; ++c) nw->inertia[c][i] = c % 4 == 0 ? nw->mass[i] * radius * radius : 0;
    }
}

/* A loop over segments and the half of it that one of two threads does. */
typedef struct Split {
    Newton *nw;
    double *b; /* only read on the way in */
} Split;

static int split_from(const Newton *nw, int rank) { return rank == 0 ? 0 : nw->middle; }
static int split_to(const Newton *nw, int rank) { return rank == 0 ? nw->middle : nw->n; }

static void form_job(void *arg, int rank)
{
    Newton *const nw = ((Split *)arg)->nw;
    newton_kernels()->form(nw, split_from(nw, rank), split_to(nw, rank));
}

/* Eliminates and couples rows, whose neighbours' z are needed too: elimination is a lane ahead of coupling, and the
 * rows at the middle wait for the other half. */
static void rows_reduce(void *arg, LinSide side, int from, int to)
{
    const Split *const s = arg;
    Newton *const nw = s->nw;
    if (side == LIN_TOP) {
        newton_kernels()->eliminate(nw, s->b, from > 0 ? from + LANES : 0, to + LANES);
    } else if (side == LIN_BOTTOM) {
        newton_kernels()->eliminate(nw, s->b, from - LANES, to < nw->n ? to - LANES : to);
    } else { /* what no side was asked for, having no rows of its own */
        if (from == 0) newton_kernels()->eliminate(nw, s->b, 0, nw->middle);
        if (to == nw->n) newton_kernels()->eliminate(nw, s->b, nw->middle, to);
    }
    newton_kernels()->couple(nw, from, to);
}

static void rows_expand(void *arg, int from, int to)
{
    const Split *const s = arg;
    newton_kernels()->expand(s->nw, s->b, from, to);
}

/* One side, by tiles: what elimination wrote for coupling is in the nearest cache. */
enum { TILE = 128 };

static void reduce_job(void *arg, int rank)
{
    const Newton *const nw = ((Split *)arg)->nw;
    const LinSeam seam = lin_seam(nw->n);
    for (int i = 0; rank == 0 && i < seam.from; i += TILE) {
        rows_reduce(arg, LIN_TOP, i, i + TILE < seam.from ? i + TILE : seam.from);
    }
    for (int to = nw->n, from; rank == 1 && to > seam.to; to = from) {
        from = (to - 1) / TILE * TILE;
        if (from < seam.to) from = seam.to;
        rows_reduce(arg, LIN_BOTTOM, from, to);
    }
}

static void expand_job(void *arg, int rank)
{
    const Split *const s = arg;
    rows_expand(arg, split_from(s->nw, rank), split_to(s->nw, rank));
}

static void both(TeamJob job, Split *split) { halves_run(split->nw->team, split->nw->n >= HALVES_LONG, job, split); }

void newton_form(Newton *nw, double gamma)
{
    Split split = {.nw = nw};
    nw->gamma = gamma;
    if (nw->full) {
        newton_full_form(nw->full, nw);
    } else {
        both(form_job, &split);
        if (nw->leaves) newton_leaves_form(nw);
    }
    if (nw->extra) newton_extra_form(nw);
}

int newton_negative(const Newton *nw)
{
    if (nw->full || nw->extra || nw->leaves || nw->matrix.extras || nw->matrix.border) return -1;
    return block_chain_negative(&nw->a);
}

int newton_factor(Newton *nw)
{
    if (nw->extra) return newton_extra_factor(nw);
    return nw->full ? newton_full_factor(nw->full) : linsolver_factor_newton(nw->solver, &nw->matrix);
}

void newton_stats(const Newton *nw, LinStats *stats)
{
    linsolver_stats(nw->full ? newton_full_solver(nw->full) : nw->solver, stats);
    if (nw->extra) newton_extra_stats(nw->extra, stats);
}

void newton_reduce(Newton *nw, const double *b)
{
    Split split = {.nw = nw, .b = (double *)(uintptr_t)b};
    const LinSeam seam = lin_seam(nw->n);
    both(reduce_job, &split);
    rows_reduce(&split, LIN_SEAM, seam.from, seam.to);
}

void newton_expand(Newton *nw, double *b)
{
    Split split = {.nw = nw, .b = b};
    both(expand_job, &split);
}

/* With what the equipment and other chains add between reduction and solution. */
static int solve_beside(Newton *nw, double *b)
{
    newton_reduce(nw, b);
    if (nw->extra) newton_extra_couple(nw);
    double *const equipment = b + STATE_SIZE * nw->n;
    if (nw->leaves) newton_leaves_reduce(nw, equipment);
    const int status = linsolver_solve(nw->solver, nw->x);
    if (!status) newton_expand(nw, b);
    if (!status && nw->leaves) newton_leaves_expand(nw, equipment);
    return status;
}

int newton_solve(Newton *nw, double *b)
{
    if (nw->full) return newton_full_solve(nw->full, nw, b);
    if (nw->extra || nw->leaves) return solve_beside(nw, b);
    Split split = {.nw = nw, .b = b};
    return linsolver_stream(nw->solver, &(LinStream){&split, rows_reduce, rows_expand}, nw->x);
}

void newton_rough(Newton *nw, int rough)
{
    if (!nw->full) linsolver_rough(nw->solver, rough);
}

void newton_point_equipment(Newton *nw, const EquipmentWork *w, const double *y, double friction)
{
    if (nw->leaves) newton_leaves_point(nw->leaves, w, y + STATE_SIZE * nw->n, friction);
}

hawser_status newton_renew(Newton *nw, EquipmentWork *w, hawser_error *err)
{
    const int changed = nw->leaves ? newton_leaves_widen(nw, w) : 0;
    if (changed < 0) return error_memory(err);
    if (changed == 0) return HAWSER_OK;
    if (nw->extra) return newton_extra_renew(nw) ? HAWSER_OK : error_memory(err);
    nw->solver = linsolver_free(nw->solver);
    return solver_new(nw, err);
}

/* The matrix of the blocks and of gamma again, but for the extra blocks, which are listed: their pattern may have
 * changed since it was formed. */
static void matrix_again(Newton *nw)
{
    Split split = {.nw = nw};
    if (nw->full) {
        newton_full_form(nw->full, nw);
        return;
    }
    both(form_job, &split);
    if (nw->leaves) newton_leaves_form(nw);
}

void newton_checkpoint(Checkpoint *c, Newton *nw, EquipmentWork *w)
{
    block_chain_checkpoint(c, "nw->k", &nw->k);
    block_chain_checkpoint(c, "nw->d", &nw->d);
    chain_arrays_checkpoint(c, "nw->inertia", nw->inertia, 9, nw->n);
    chain_arrays_checkpoint(c, "nw->q", nw->q, 4, nw->n);
    chain_arrays_checkpoint(c, "nw->w", nw->w, 3, nw->n);
    CHECKPOINT(c, nw->gamma);
    if (nw->leaves) newton_leaves_checkpoint(c, nw, w);
    if (c->reading && !c->status) matrix_again(nw);
    if (nw->extra) {
        newton_extra_checkpoint(c, nw);
    } else if (nw->full) {
        newton_full_checkpoint(c, nw->full);
    } else {
        linsolver_checkpoint(c, nw->solver, &nw->matrix, NULL);
    }
}
