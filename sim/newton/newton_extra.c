#include "sim/newton/newton_extra.h"

#include <stdlib.h>
#include <string.h>

enum { BLOCK = 36 };

hawser_status newton_extra_attach(Newton *nw, const BlockExtras *from, const LinOptions *options, hawser_error *err)
{
    const LinKind kind = options->kind;
    if (kind != LIN_AUTO && kind != LIN_BLOCK_SPARSE && kind != LIN_KLU && kind != LIN_DENSE) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "solver.linear_solver '%s' cannot hold contact.cable_on_cable: take 'auto' or 'klu'",
                         linsolver_kind_name(kind));
    }
    NewtonExtra *const extra = calloc(1, sizeof *extra);
    if (!extra) return error_memory(err);
    extra->from = from;
    extra->options = *options;
    extra->version = -1;
    nw->extra = extra;
    return HAWSER_OK;
}

NewtonExtra *newton_extra_free(NewtonExtra *extra)
{
    if (!extra) return NULL;
    free(extra->a);
    free(extra->filled);
    free(extra->block);
    free(extra);
    return NULL;
}

/* Room and places for the pattern that there is now; 0 if there is no memory. */
static int pattern_follow(NewtonExtra *extra)
{
    const BlockExtras *const from = extra->from;
    free(extra->a);
    double *const a = extra->a = calloc((size_t)from->count * BLOCK + 8, sizeof *a);
    unsigned char *const filled = realloc(extra->filled, (size_t)from->count + 1);
    if (filled) extra->filled = filled;
    ExtraBlock *const block = realloc(extra->block, ((size_t)from->count + 1) * sizeof *block);
    if (block) extra->block = block;
    if (!a || !block || !filled) return 0;
    memset(filled, 0, (size_t)from->count + 1);
    for (int e = 0; e < from->count; ++e) {
        block[e] = (ExtraBlock){.row = from->row[e], .col = from->col[e], .block = a + BLOCK * e};
    }
    extra->count = from->count;
    extra->version = from->version;
    extra->stale = 1;
    return 1;
}

void newton_extra_form(Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    const BlockExtras *const from = extra->from;
    if (from->version != extra->version || from->count != extra->count) extra->failed = !pattern_follow(extra);
    if (extra->failed) return;
    for (int e = 0; e < from->count; ++e) {
        if (!from->live[e] && extra->filled[e]) memset(extra->a + BLOCK * e, 0, BLOCK * sizeof(double));
        extra->filled[e] = from->live[e];
        if (!from->live[e]) continue;
        double s[9];
        newton_turn(nw->gamma, v3_load(nw->w, from->col[e]), s);
        newton_kernels()->block(6, 6, 6, from->k + BLOCK * e, from->d + BLOCK * e, s, nw->gamma, extra->a + BLOCK * e);
    }
}

/* The ordering that the first solver chose by measuring serves the next patterns too: they are much alike. */
static void ordering_keep(NewtonExtra *extra, const LinStats *stats)
{
    if (extra->options.ordering != ORDER_AUTO || !stats->ordering || strcmp(stats->name, "klu") != 0) return;
    if (strcmp(stats->ordering, "amd") == 0) extra->options.ordering = ORDER_AMD;
    if (strcmp(stats->ordering, "colamd") == 0) extra->options.ordering = ORDER_COLAMD;
    if (strcmp(stats->ordering, "metis") == 0) extra->options.ordering = ORDER_METIS;
}

static void counts_add(LinStats *sum, const LinStats *more)
{
    sum->analyses += more->analyses;
    sum->factors += more->factors;
    sum->refactors += more->refactors;
    sum->fallbacks += more->fallbacks;
    sum->solves += more->solves;
}

/* A solver for the pattern of m in place of the one before. */
static int solver_renew(Newton *nw, const NewtonMatrix *m)
{
    NewtonExtra *const extra = nw->extra;
    LinStats before;
    linsolver_stats(nw->solver, &before);
    ordering_keep(extra, &before);
    LinSolver *const next = linsolver_new_newton(m, &extra->options, NULL);
    if (!next) return 0;
    counts_add(&extra->retired, &before);
    linsolver_free(nw->solver);
    nw->solver = next;
    extra->stale = 0;
    return 1;
}

/* The chain with what the equipment and the extra blocks add. */
static NewtonMatrix matrix_of(const Newton *nw)
{
    NewtonMatrix m = nw->matrix;
    m.extras = nw->extra->count;
    m.extra = nw->extra->block;
    m.live = nw->extra->filled;
    return m;
}

int newton_extra_renew(Newton *nw)
{
    const NewtonMatrix m = matrix_of(nw);
    return nw->extra->failed ? 0 : solver_renew(nw, &m);
}

int newton_extra_factor(Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    if (extra->failed) return -1;
    const NewtonMatrix m = matrix_of(nw);
    if (extra->stale && !solver_renew(nw, &m)) return -1;
    return linsolver_factor_newton(nw->solver, &m);
}

void newton_extra_couple(Newton *nw) { block_extras_gemv(nw->extra->from, 1, nw->z, nw->x); }

void newton_extra_stats(const NewtonExtra *extra, LinStats *stats) { counts_add(stats, &extra->retired); }

/* Room for the places and blocks that were saved; 0 if there is no memory. */
static int pattern_room(NewtonExtra *extra, int count)
{
    free(extra->a);
    free(extra->filled);
    free(extra->block);
    extra->a = calloc((size_t)count * BLOCK + 8, sizeof *extra->a);
    extra->filled = calloc((size_t)count + 1, sizeof *extra->filled);
    extra->block = calloc((size_t)count + 1, sizeof *extra->block);
    for (int e = 0; extra->a && extra->block && e < count; ++e) extra->block[e].block = extra->a + BLOCK * e;
    extra->count = count;
    return extra->a && extra->filled && extra->block;
}

void newton_extra_checkpoint(Checkpoint *c, Newton *nw)
{
    NewtonExtra *const extra = nw->extra;
    int count = extra->count;
    CHECKPOINT(c, extra->version);
    CHECKPOINT(c, extra->stale);
    CHECKPOINT(c, extra->options.ordering);
    lin_stats_checkpoint(c, &extra->retired);
    CHECKPOINT(c, count);
    const char *const fault = "a number of blocks is impossible";
    checkpoint_check(c, count == 0 || extra->version >= 0, fault);
    if (!checkpoint_number(c, count, BLOCK * sizeof *extra->a, fault)) return;
    if (c->reading && !pattern_room(extra, count)) checkpoint_lack(c);
    for (int e = 0; !c->status && e < count; ++e) {
        CHECKPOINT(c, extra->block[e].row);
        CHECKPOINT(c, extra->block[e].col);
        checkpoint_check(c,
                         extra->block[e].row >= 0 && extra->block[e].row < nw->n && extra->block[e].col >= 0 &&
                             extra->block[e].col < nw->n,
                         "a block is outside of the matrix");
    }
    if (count > 0) checkpoint_put(c, "extra->a", extra->a, (size_t)count * BLOCK * sizeof *extra->a);
    if (count > 0) checkpoint_put(c, "extra->filled", extra->filled, (size_t)count);
    if (c->status) return;
    const NewtonMatrix m = matrix_of(nw);
    if (c->reading && !extra->stale && extra->version >= 0) {
        LinSolver *const next = linsolver_new_newton(&m, &extra->options, NULL);
        if (!next) checkpoint_lack(c);
        if (next) linsolver_free(nw->solver);
        if (next) nw->solver = next;
    }
    if (!extra->stale) linsolver_checkpoint(c, nw->solver, &m, NULL);
}
