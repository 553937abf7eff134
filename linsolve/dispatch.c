#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "linsolve/backend.h"
#include "linsolve/linsolve.h"
#include "linsolve/newton_matrix.h"

struct LinSolver {
    const LinBackend *backend;
    void *self;
    LinOptions options; /* with the kind that auto resolved to */
    int size;
    int chain_n, chain_b;    /* of the NewtonMatrix, to detect misuse */
    int groups, *group_at;   /* as in LinMatrix */
    SparseAssembly assembly; /* if the back end needs compressed columns */
    int *leaf_at;            /* in that case [2 leaves]: at and touches of every leaf when the pattern was analysed */
    Team *team;              /* own team, if the caller provided none */
    LinSolver *backup;       /* KLU, created when the back end first fails for a matrix */
    int use_backup;          /* 1: the present factors belong to the backup */
    int rough, was_rough;    /* 1: the next factors, the present ones may be rounded: linsolver_rough */
    int ready;               /* 1: the last factorisation succeeded */
    LinStats stats;
};

static const struct {
    const char *name;
    const LinBackend *backend;
} kinds[] = {[LIN_AUTO] = {"auto", NULL},
             [LIN_BLOCK] = {"block", &block_backend},
             [LIN_BORDERED] = {"bordered", &bordered_backend},
             [LIN_KLU] = {"klu", &klu_backend},
             [LIN_BLOCK_SPARSE] = {"block-sparse", &block_sparse_backend}};

enum { KINDS = sizeof kinds / sizeof kinds[0] };

const char *linsolver_kind_name(LinKind kind) { return kinds[kind].name; }

/* Kind that auto selects for a chain and its surroundings, with the reason in `why` (128 characters). */
static LinKind kind_choose(const NewtonMatrix *a, char *why, size_t size)
{
    if (a->extras > 0) {
        snprintf(why, size, "auto: %d couplings outside the chain's three diagonals", a->extras);
        return LIN_KLU;
    }
    if (a->leaves > 0 || a->border > 0) {
        snprintf(why, size, "auto: a chain with %d leaf bodies and a border of %d unknowns", a->leaves, a->border);
        return LIN_BORDERED;
    }
    snprintf(why, size, "auto: a plain chain, block tridiagonal");
    return LIN_BLOCK;
}

/* Resolves auto and refuses matrices that a kind cannot hold; 0 with err set if so. */
static int kind_settle(LinSolver *s, const NewtonMatrix *m, hawser_error *err)
{
    const LinKind asked = s->options.kind;
    if (asked == LIN_BLOCK_SPARSE) {
        snprintf(s->stats.why, sizeof s->stats.why, "auto: several chains, %d couplings between them at most",
                 m->extras);
    } else if (asked != LIN_AUTO) {
        snprintf(s->stats.why, sizeof s->stats.why, "asked for");
    } else {
        s->options.kind = kind_choose(m, s->stats.why, sizeof s->stats.why);
    }
    const LinKind kind = s->options.kind;
    const int bare = !m->leaves && !m->border;
    const int fits = kind == LIN_BLOCK          ? bare && !m->extras
                     : kind == LIN_BORDERED     ? !m->extras
                     : kind == LIN_BLOCK_SPARSE ? bare && (m->chain.b == 6 || !m->extras)
                                                : 1;
    if (fits) return 1;
    error_set(err, HAWSER_ERR_INPUT, "the linear solver '%s' cannot hold this system; 'auto' or 'klu' can",
              kinds[kind].name);
    return 0;
}

/* Checks whether leaves have moved since the pattern was analysed, and stores their present places; 0 if there is no
 * memory. */
static int places_changed(const LinSolver *s, const NewtonMatrix *a)
{
    int changed = 0;
    for (int l = 0; l < a->leaves; ++l) {
        const Leaf *const leaf = a->leaf + l;
        changed |= s->leaf_at[2 * l + 1] != leaf->touches || (leaf->touches && s->leaf_at[2 * l] != leaf->at);
    }
    return changed;
}

static int places_keep(LinSolver *s, const NewtonMatrix *a)
{
    if (!s->leaf_at) s->leaf_at = malloc((2 * (size_t)a->leaves + 1) * sizeof *s->leaf_at);
    for (int l = 0; s->leaf_at && l < a->leaves; ++l) {
        s->leaf_at[2 * l] = a->leaf[l].at;
        s->leaf_at[2 * l + 1] = a->leaf[l].touches;
    }
    return s->leaf_at != NULL;
}

/* Everything that depends on the pattern; 0 if there is no memory. */
static int solver_analyse(LinSolver *s, LinMatrix *a)
{
    s->backend = kinds[s->options.kind].backend;
    s->stats.name = kinds[s->options.kind].name;
    s->stats.ordering = "natural";
    if (s->options.threads > 1 && !s->options.team && !s->backend->sparse) {
        s->team = team_new(s->options.threads);
        if (!s->team) return 0;
        s->options.team = s->team;
    }
    if (s->backend->sparse) {
        if (!sparse_assembly_new(a->newton, &s->assembly)) return 0;
        s->groups = newton_groups(a->newton, NULL);
        s->group_at = malloc(((size_t)s->groups + 1) * sizeof *s->group_at);
        if (!s->group_at) return 0;
        newton_groups(a->newton, s->group_at);
        a->sparse = &s->assembly.a;
        a->groups = s->groups;
        a->group_at = s->group_at;
        if (!places_keep(s, a->newton)) return 0;
    }
    s->self = s->backend->make(a, &s->options);
    return s->self != NULL;
}

/* Restarts a sparse back end with the pattern of the leaves' present places; 0 if there is no memory. */
static int solver_analyse_again(LinSolver *s, const NewtonMatrix *a)
{
    LinMatrix m = {.newton = a};
    s->backend->drop(s->self);
    s->self = NULL;
    sparse_assembly_free(&s->assembly);
    free(s->group_at);
    s->group_at = NULL;
    return solver_analyse(s, &m);
}

LinSolver *linsolver_new_newton(const NewtonMatrix *a, const LinOptions *options, hawser_error *err)
{
    LinMatrix m = {.newton = a};
    LinSolver *const s = calloc(1, sizeof *s);
    if (!s) {
        error_memory(err);
        return NULL;
    }
    s->options = *options;
    s->size = newton_size(a);
    s->chain_n = a->chain.n;
    s->chain_b = a->chain.b;
    if (!kind_settle(s, a, err)) return linsolver_free(s);
    if (solver_analyse(s, &m)) return s;
    error_memory(err);
    return linsolver_free(s);
}

LinSolver *linsolver_new(const BlockChain *a, const LinOptions *options, hawser_error *err)
{
    const NewtonMatrix m = {.chain = *a};
    return linsolver_new_newton(&m, options, err);
}

LinSolver *linsolver_free(LinSolver *s)
{
    if (!s) return NULL;
    if (s->self) s->backend->drop(s->self);
    s->backup = linsolver_free(s->backup);
    s->team = team_free(s->team);
    sparse_assembly_free(&s->assembly);
    free(s->group_at);
    free(s->leaf_at);
    free(s);
    return NULL;
}

/* Factors a matrix with KLU after the back end has failed. The analysis is made once, when it is first needed. */
static int backup_factor(LinSolver *s, const NewtonMatrix *a)
{
    ++s->stats.fallbacks;
    if (!s->backup) {
        s->backup = linsolver_new_newton(a, &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD, .threads = 1}, NULL);
        if (!s->backup) return -1;
    }
    s->use_backup = 1;
    return linsolver_factor_newton(s->backup, a);
}

int linsolver_factor(LinSolver *s, const BlockChain *a)
{
    const NewtonMatrix m = {.chain = *a};
    return linsolver_factor_newton(s, &m);
}

int linsolver_factor_newton(LinSolver *s, const NewtonMatrix *a)
{
    assert(a->chain.n == s->chain_n && a->chain.b == s->chain_b && newton_size(a) == s->size);
    LinMatrix m = {.newton = a, .groups = s->groups, .group_at = s->group_at};
    if (s->backend->sparse) {
        if (!s->self || places_changed(s, a)) {
            s->ready = 0;
            if (!solver_analyse_again(s, a)) return -1;
            m.groups = s->groups;
            m.group_at = s->group_at;
        }
        sparse_assembly_refresh(&s->assembly, a);
        m.sparse = &s->assembly.a;
    }
    ++s->stats.factors;
    s->use_backup = 0;
    s->was_rough = s->rough;
    s->rough = 0;
    if (s->backend->rough) s->backend->rough(s->self, s->was_rough);
    int status = s->backend->factor(s->self, &m);
    if (status == LIN_UNSTABLE) status = backup_factor(s, a);
    s->ready = status == 0;
    return status;
}

int linsolver_solve(LinSolver *s, double *x) { return linsolver_solve_many(s, 1, x); }

int linsolver_solve_many(LinSolver *s, int count, double *x)
{
    if (!s->ready) return 1;
    s->stats.solves += count;
    if (s->use_backup) return linsolver_solve_many(s->backup, count, x);
    return s->backend->solve(s->self, count, x);
}

/* The rows of both sides and the seam's, one after the other. */
static void stream_all(const LinStream *stream, int n)
{
    const LinSeam seam = lin_seam(n);
    if (seam.from > 0) stream->fill(stream->user, LIN_TOP, 0, seam.from);
    if (seam.to < n) stream->fill(stream->user, LIN_BOTTOM, seam.to, n);
    stream->fill(stream->user, LIN_SEAM, seam.from, seam.to);
}

int linsolver_stream(LinSolver *s, const LinStream *stream, double *x)
{
    if (!s->ready) return 1;
    if (!s->use_backup && s->backend->stream) {
        ++s->stats.solves;
        return s->backend->stream(s->self, stream, x);
    }
    stream_all(stream, s->chain_n);
    const int status = linsolver_solve(s, x);
    if (!status) stream->take(stream->user, 0, s->chain_n);
    return status;
}

void linsolver_rough(LinSolver *s, int rough) { s->rough = rough && !s->options.precise; }

void linsolver_stats(const LinSolver *s, LinStats *stats)
{
    *stats = s->stats;
    s->backend->stats(s->self, stats);
    if (!s->use_backup) return;
    LinStats backup;
    linsolver_stats(s->backup, &backup);
    stats->pivoted = backup.pivoted;
    stats->growth = backup.growth;
    stats->nonzeros = backup.nonzeros;
}

/* Makes the pattern of the leaves' places at the last factorisation that of their places in m. */
static int pattern_renew(LinSolver *s, const NewtonMatrix *m)
{
    if (!s->backend->sparse) return 1;
    if (places_changed(s, m) && !solver_analyse_again(s, m)) return 0;
    sparse_assembly_refresh(&s->assembly, m);
    return 1;
}

/* A back end without a memory factors the same matrix again. */
static void factors_renew(Checkpoint *c, LinSolver *s, const LinMatrix *m)
{
    if (c->status || !c->reading || s->backend->checkpoint || !s->ready || s->use_backup) return;
    const int status = s->backend->factor(s->self, m);
    if (status < 0) checkpoint_lack(c);
    checkpoint_check(c, status == 0, "its Newton matrix cannot be factored");
}

void lin_stats_checkpoint(Checkpoint *c, LinStats *stats)
{
    CHECKPOINT_FROM(c, stats, LinStats, analyses);
    checkpoint_longs(c, 7,
                     (const long[]){stats->analyses, stats->factors, stats->refactors, stats->fallbacks, stats->solves,
                                    stats->pivoted, stats->nonzeros});
}

/* Saves or loads the solver for matrices for which the back end failed, if it was ever needed. */
static void backup_checkpoint(Checkpoint *c, LinSolver *s, const NewtonMatrix *a)
{
    int there = s->backup != NULL;
    CHECKPOINT(c, there);
    if (c->status || !there) return;
    if (!s->backup)
        s->backup = linsolver_new_newton(a, &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD, .threads = 1}, NULL);
    if (s->backup) linsolver_checkpoint(c, s->backup, a);
    if (!s->backup) checkpoint_lack(c);
}

void linsolver_checkpoint(Checkpoint *c, LinSolver *s, const NewtonMatrix *a)
{
    CHECKPOINT(c, s->ready);
    CHECKPOINT(c, s->use_backup);
    CHECKPOINT(c, s->was_rough);
    lin_stats_checkpoint(c, &s->stats);
    if (c->reading && !c->status && !pattern_renew(s, a)) checkpoint_lack(c);
    if (c->status) return;
    if (c->reading && s->backend->rough) s->backend->rough(s->self, s->was_rough);
    const LinMatrix m = {.newton = a, .sparse = &s->assembly.a, .groups = s->groups, .group_at = s->group_at};
    if (s->backend->checkpoint) s->backend->checkpoint(c, s->self, &m, s->ready && !s->use_backup);
    factors_renew(c, s, &m);
    backup_checkpoint(c, s, a);
    if (!c->status)
        checkpoint_check(c, !s->use_backup || (s->backup && s->backup->ready), "nothing solves its Newton matrix");
}

/* A run of consecutive rows in one column: one column of one piece. */
typedef struct Run {
    int row, rows;
    int slot; /* of SparseAssembly.offset */
} Run;

/* All runs, sorted into columns: column c holds run[start[c]]..run[start[c+1]-1]. */
typedef struct RunTable {
    int *start; /* [n+2] */
    Run *run;
} RunTable;

static int run_table_alloc(RunTable *t, int n, int runs)
{
    t->start = calloc((size_t)n + 2, sizeof *t->start);
    t->run = malloc(((size_t)runs + 1) * sizeof *t->run);
    return t->start && t->run;
}

static void run_table_free(RunTable *t)
{
    free(t->start);
    free(t->run);
}

/* Insertion sort by row; the pieces are nearly in order. */
static void runs_sort(Run *first, const Run *end)
{
    for (Run *r = first; r < end; ++r) {
        const Run run = *r;
        Run *to = r;
        for (; to > first && to[-1].row > run.row; --to) *to = to[-1];
        *to = run;
    }
}

/* Sorts the columns of all pieces into t: counts, appends, then orders each column. */
static void run_table_fill(RunTable *t, const NewtonMatrix *m)
{
    const int n = newton_size(m), pieces = newton_pieces(m);
    int *const next = t->start + 1; /* grows from the beginning of column c to its end */
    for (int k = 0; k < pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c) ++t->start[p.col + c + 2];
    }
    for (int c = 0; c < n; ++c) t->start[c + 2] += t->start[c + 1];
    for (int k = 0, slot = 0; k < pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c, ++slot) t->run[next[p.col + c]++] = (Run){p.row, p.rows, slot};
    }
    for (int c = 0; c < n; ++c) runs_sort(t->run + t->start[c], t->run + t->start[c + 1]);
}

/* Entries of column c, runs at the same rows counted once. */
static int column_length(const RunTable *t, int c)
{
    int length = 0;
    for (int k = t->start[c]; k < t->start[c + 1]; ++k) {
        if (k > t->start[c] && t->run[k].row == t->run[k - 1].row) continue;
        length += t->run[k].rows;
    }
    return length;
}

/* Writes the rows of column c and the offset of each of its runs. */
static void column_fill(const RunTable *t, int c, SparseAssembly *s)
{
    int at = s->a.p[c], begin = at;
    for (int k = t->start[c]; k < t->start[c + 1]; ++k) {
        const Run run = t->run[k];
        const int again = k > t->start[c] && run.row == t->run[k - 1].row;
        assert(!again || run.rows == t->run[k - 1].rows);
        if (!again) {
            begin = at;
            for (int r = 0; r < run.rows; ++r) s->a.i[at++] = run.row + r;
        }
        s->offset[run.slot] = begin;
    }
}

static int assembly_fill(const RunTable *t, SparseAssembly *s)
{
    for (int c = 0; c < s->a.n; ++c) s->a.p[c + 1] = s->a.p[c] + column_length(t, c);
    const size_t entries = (size_t)s->a.p[s->a.n] + 1;
    s->a.i = malloc(entries * sizeof *s->a.i);
    s->a.x = calloc(entries, sizeof *s->a.x);
    if (!s->a.i || !s->a.x) return 0;
    for (int c = 0; c < s->a.n; ++c) column_fill(t, c, s);
    return 1;
}

int sparse_assembly_new(const NewtonMatrix *m, SparseAssembly *out)
{
    int runs = 0;
    RunTable t = {0};
    *out = (SparseAssembly){.a.n = newton_size(m), .pieces = newton_pieces(m)};
    for (int k = 0; k < out->pieces; ++k) runs += newton_piece(m, k).cols;
    out->offset = malloc(((size_t)runs + 1) * sizeof *out->offset);
    out->a.p = calloc((size_t)out->a.n + 1, sizeof *out->a.p);
    int ok = out->offset && out->a.p && run_table_alloc(&t, out->a.n, runs);
    if (ok) {
        run_table_fill(&t, m);
        ok = assembly_fill(&t, out);
    }
    run_table_free(&t);
    if (!ok) sparse_assembly_free(out);
    return ok;
}

void sparse_assembly_free(SparseAssembly *s)
{
    free(s->a.p);
    free(s->a.i);
    free(s->a.x);
    free(s->offset);
    *s = (SparseAssembly){0};
}

void sparse_assembly_refresh(SparseAssembly *s, const NewtonMatrix *m)
{
    assert(newton_size(m) == s->a.n && newton_pieces(m) == s->pieces);
    memset(s->a.x, 0, (size_t)s->a.p[s->a.n] * sizeof *s->a.x);
    const int *offset = s->offset;
    for (int k = 0; k < s->pieces; ++k) {
        const Piece p = newton_piece(m, k);
        for (int c = 0; c < p.cols; ++c) {
            double *const to = s->a.x + *offset++;
            const double *const from = p.value + (size_t)c * (size_t)p.rows;
            for (int r = 0; r < p.rows; ++r) to[r] += from[r];
        }
    }
}
