/* KLU for any pattern: one symbolic analysis, refactorisation while the pivots remain good, otherwise a full
 * factorisation. docs/theory.md, "Linear solvers", (L12)-(L14). */
#include <float.h>
#include <klu.h>
#include <metis.h>
#include <stdlib.h>
#include <string.h>

#include "linsolve/backend.h"

/* In the order in which auto tries them; the first of equals wins. */
typedef enum Candidate { TRY_AMD, TRY_COLAMD, TRY_METIS, TRY_NATURAL, CANDIDATES } Candidate;

typedef struct KluSolver {
    klu_common common;
    klu_symbolic *symbolic;
    klu_numeric *numeric; /* NULL before the first factorisation and after a failed one */
    int decided;          /* 1: the ordering is chosen */
    Candidate candidate;
    double growth_limit;
    double rcond; /* ratio of U's diagonal in the last full factorisation */
    double *full; /* values of that factorisation, which determined the pivots; owned */
    int again;    /* 1: other values have been factored since, with these pivots */
    LinStats stats;
} KluSolver;

static const char *candidate_name(Candidate c)
{
    static const char *const name[] = {"amd", "colamd", "metis", "natural"};
    return name[c];
}

static void *klu_drop(KluSolver *s)
{
    if (!s) return NULL;
    klu_free_numeric(&s->numeric, &s->common);
    klu_free_symbolic(&s->symbolic, &s->common);
    free(s->full);
    free(s);
    return NULL;
}

/* Analysis with a given permutation. Block triangular form is off: it would permute columns away from the diagonal and
 * undo the ordering, and a Newton matrix is irreducible anyway. */
static klu_symbolic *analyse_given(KluSolver *s, const LinMatrix *a, Candidate c)
{
    const SparseMatrix *const m = a->sparse;
    int *const perm = malloc(((size_t)m->n + 1) * sizeof *perm);
    klu_symbolic *symbolic = NULL;
    int status = perm ? 0 : -1;
    if (perm && c == TRY_METIS) status = ordering_metis(a, perm);
    for (int k = 0; perm && c == TRY_NATURAL && k < m->n; ++k) perm[k] = k;
    if (status == 0) {
        s->common.btf = 0;
        symbolic = klu_analyze_given(m->n, m->p, m->i, perm, perm, &s->common);
    }
    free(perm);
    return symbolic;
}

/* Returns NULL when memory ran out or the pattern does not suit the ordering. */
static klu_symbolic *analyse(KluSolver *s, const LinMatrix *a, Candidate c)
{
    const SparseMatrix *const m = a->sparse;
    ++s->stats.analyses;
    if (c == TRY_METIS || c == TRY_NATURAL) return analyse_given(s, a, c);
    s->common.btf = 1;
    s->common.ordering = c == TRY_AMD ? 0 : 1;
    return klu_analyze(m->n, m->p, m->i, &s->common);
}

static void *klu_make(const LinMatrix *a, const LinOptions *options)
{
    KluSolver *const s = calloc(1, sizeof *s);
    if (!s) return NULL;
    klu_defaults(&s->common);
    s->growth_limit = growth_limit_of(options);
    s->decided = options->ordering != ORDER_AUTO;
    if (!s->decided) return s;
    s->candidate = options->ordering == ORDER_AMD      ? TRY_AMD
                   : options->ordering == ORDER_COLAMD ? TRY_COLAMD
                                                       : TRY_METIS;
    s->symbolic = analyse(s, a, s->candidate);
    return s->symbolic ? s : klu_drop(s);
}

static int values_are_finite(const SparseMatrix *m)
{
    enum { SUMS = 8 };
    double zero[SUMS] = {
        0}; /* become NaN with the first value that is not finite; several, so that none waits for another */
    const int count = m->p[m->n];
    for (int k = 0; k + SUMS <= count; k += SUMS) {
        for (int j = 0; j < SUMS; ++j) zero[j] += 0 * m->x[k + j];
    }
    for (int k = count - count % SUMS; k < count; ++k) zero[0] += 0 * m->x[k];
    for (int j = 1; j < SUMS; ++j) zero[0] += zero[j];
    return zero[0] == 0;
}

/* Returns 0: good; > 0: singular, by the ratio of U's diagonal (L13); < 0: no memory. Checks the present factors. */
static int grade(KluSolver *s)
{
    if (!s->numeric) return s->common.status < 0 && s->common.status != KLU_INVALID ? -1 : 1;
    if (s->common.status != KLU_OK) return 1;
    if (!klu_rcond(s->symbolic, s->numeric, &s->common)) return 1;
    return s->common.rcond > 4 * DBL_EPSILON ? 0 : 1;
}

/* Measures the growth of the present factors; it reads the whole matrix, which takes a third of a refactorisation's
 * time. */
static void measure_growth(KluSolver *s, const SparseMatrix *m)
{
    const int ok = klu_rgrowth(m->p, m->i, m->x, s->symbolic, s->numeric, &s->common);
    s->stats.growth = ok ? s->common.rgrowth : 0;
}

static int factor_full(KluSolver *s, const SparseMatrix *m)
{
    klu_free_numeric(&s->numeric, &s->common);
    s->numeric = klu_factor(m->p, m->i, m->x, s->symbolic, &s->common);
    const int status = grade(s);
    if (status) {
        klu_free_numeric(&s->numeric, &s->common);
        return status;
    }
    const size_t bytes = (size_t)m->p[m->n] * sizeof *s->full;
    if (!s->full) s->full = malloc(bytes);
    if (!s->full) return -1;
    memcpy(s->full, m->x, bytes);
    s->again = 0;
    measure_growth(s, m);
    s->rcond = s->common.rcond;
    s->stats.nonzeros = (long)s->numeric->lnz + s->numeric->unz - m->n;
    return 0;
}

/* Checks whether the old pivots are good for the new values. Rows are scaled to 1, so factors grow only over a small
 * pivot: while the smallest pivot stays near that of the full factorisation, the growth need not be measured (L14). */
static int refactor_is_good(KluSolver *s, const SparseMatrix *m)
{
    if (!klu_refactor(m->p, m->i, m->x, s->symbolic, s->numeric, &s->common) || grade(s)) return 0;
    if (s->common.rcond > 1e-2 * s->rcond) return 1;
    measure_growth(s, m);
    return s->stats.growth * s->growth_limit >= 1;
}

/* Measures the fill of every ordering on the first matrix and keeps the least (L12). */
static int decide(KluSolver *s, const LinMatrix *a)
{
    KluSolver best = {0};
    int status = 1;
    for (Candidate c = TRY_AMD; c < CANDIDATES; ++c) {
        s->symbolic = analyse(s, a, c);
        const int now = s->symbolic ? factor_full(s, a->sparse) : -1;
        if (now == 0 && (!best.symbolic || s->stats.nonzeros < best.stats.nonzeros)) {
            klu_free_numeric(&best.numeric, &s->common);
            klu_free_symbolic(&best.symbolic, &s->common);
            best = (KluSolver){
                .symbolic = s->symbolic, .numeric = s->numeric, .candidate = c, .rcond = s->rcond, .stats = s->stats};
        } else {
            klu_free_numeric(&s->numeric, &s->common);
            klu_free_symbolic(&s->symbolic, &s->common);
        }
        s->numeric = NULL;
        s->symbolic = NULL;
        status = now == 0 || status == 0 ? 0 : now;
    }
    s->symbolic = best.symbolic;
    s->numeric = best.numeric;
    s->candidate = best.candidate;
    s->rcond = best.rcond;
    s->stats.nonzeros = best.stats.nonzeros;
    s->stats.growth = best.stats.growth;
    s->decided = status == 0;
    return status;
}

static int klu_factorise(void *self, const LinMatrix *a)
{
    KluSolver *const s = self;
    const SparseMatrix *const m = a->sparse;
    if (!values_are_finite(m)) return 1;
    if (!s->decided) return decide(s, a);
    if (!s->numeric) return factor_full(s, m);
    ++s->stats.refactors;
    s->again = 1;
    if (refactor_is_good(s, m)) return 0;
    ++s->stats.fallbacks;
    return factor_full(s, m);
}

static int klu_solve_many(void *self, int count, double *x)
{
    KluSolver *const s = self;
    const int ok = klu_solve(s->symbolic, s->numeric, s->symbolic->n, count, x, &s->common);
    return ok ? 0 : s->common.status == KLU_OUT_OF_MEMORY ? -1 : 1;
}

static void klu_stats(const void *self, LinStats *stats)
{
    const KluSolver *const s = self;
    stats->ordering = s->decided ? candidate_name(s->candidate) : "undecided";
    stats->analyses = s->stats.analyses;
    stats->refactors = s->stats.refactors;
    stats->fallbacks = s->stats.fallbacks;
    stats->nonzeros = s->stats.nonzeros;
    stats->growth = s->stats.growth;
}

/* Restores the pivots of the last full factorisation, and with these the present factors. */
static void factors_again(Checkpoint *c, KluSolver *s, const LinMatrix *a, int ready)
{
    const SparseMatrix now = *a->sparse;
    klu_free_numeric(&s->numeric, &s->common);
    klu_free_symbolic(&s->symbolic, &s->common);
    s->symbolic = analyse(s, a, s->candidate);
    if (s->symbolic) s->numeric = klu_factor(now.p, now.i, s->full, s->symbolic, &s->common);
    if (!s->numeric) {
        checkpoint_check(c, !s->symbolic || s->common.status == KLU_OUT_OF_MEMORY, "its matrix has no pivots");
        checkpoint_lack(c);
        return;
    }
    if (ready && s->again)
        checkpoint_check(c, klu_refactor(now.p, now.i, now.x, s->symbolic, s->numeric, &s->common),
                         "its matrix cannot be factored");
}

static void klu_checkpoint(Checkpoint *c, void *self, const LinMatrix *a, int ready)
{
    KluSolver *const s = self;
    int factored = s->numeric != NULL;
    const size_t bytes = (size_t)a->sparse->p[a->sparse->n] * sizeof *s->full;
    CHECKPOINT(c, factored);
    CHECKPOINT(c, s->again);
    CHECKPOINT(c, s->decided);
    CHECKPOINT(c, s->candidate);
    if (c->reading && factored && !s->full) s->full = malloc(bytes);
    if (factored && !s->full) checkpoint_lack(c);
    if (factored) checkpoint_put(c, "s->full", s->full, bytes);
    if (!checkpoint_check(c, (int)s->candidate >= 0 && s->candidate < CANDIDATES, "no such ordering")) return;
    if (!checkpoint_check(c, s->decided || !factored, "it has factors without an ordering")) return;
    if (!checkpoint_check(c, factored || !ready, "its Newton matrix has no factors")) return;
    if (c->reading && factored) factors_again(c, s, a, ready);
    CHECKPOINT(c, s->rcond);
    lin_stats_checkpoint(c, &s->stats);
}

static void klu_drop_self(void *self) { klu_drop(self); }

const LinBackend klu_backend = {.sparse = 1,
                                .make = klu_make,
                                .drop = klu_drop_self,
                                .factor = klu_factorise,
                                .solve = klu_solve_many,
                                .checkpoint = klu_checkpoint,
                                .stats = klu_stats};

/* The graph of the groups: METIS requires it symmetric, without loops. */
typedef struct Graph {
    idx_t groups;
    idx_t *start, *neighbour, *weight; /* [groups+2], [edges], [groups] */
    int *group_of;                     /* [n] */
    int *seen;                         /* [groups]: last vertex that met this one */
} Graph;

/* First unknown of group g. */
static int group_first(const LinMatrix *a, int g) { return a->group_at ? a->group_at[g] : g; }

static void graph_free(Graph *g)
{
    free(g->start);
    free(g->neighbour);
    free(g->weight);
    free(g->group_of);
    free(g->seen);
}

static int graph_alloc(Graph *g, const LinMatrix *a)
{
    const size_t groups = (size_t)a->groups, entries = (size_t)a->sparse->p[a->sparse->n];
    *g = (Graph){.groups = a->groups,
                 .start = calloc(groups + 2, sizeof(idx_t)),
                 .neighbour = malloc((2 * entries + 1) * sizeof(idx_t)),
                 .weight = malloc((groups + 1) * sizeof(idx_t)),
                 .group_of = malloc(((size_t)a->sparse->n + 1) * sizeof(int)),
                 .seen = malloc((groups + 1) * sizeof(int))};
    return g->start && g->neighbour && g->weight && g->group_of && g->seen;
}

/* Visits every coupled pair of groups once from its column's side; counts (neighbour == NULL) or appends it in both
 * directions. */
static void graph_visit(Graph *g, const LinMatrix *a, idx_t *next, idx_t *neighbour)
{
    const SparseMatrix *const s = a->sparse;
    for (int v = 0; v < a->groups; ++v) g->seen[v] = -1;
    for (int v = 0; v < a->groups; ++v) {
        for (int k = s->p[group_first(a, v)]; k < s->p[group_first(a, v + 1)]; ++k) {
            const int u = g->group_of[s->i[k]];
            if (u == v || g->seen[u] == v) continue;
            g->seen[u] = v;
            if (neighbour) neighbour[next[v]] = u, neighbour[next[u]] = v;
            ++next[v];
            ++next[u];
        }
    }
}

/* A pair coupled in both directions was appended twice: keeps the first of each. */
static void graph_compact(Graph *g)
{
    idx_t to = 0, from = 0;
    for (idx_t v = 0; v < g->groups; ++v) g->seen[v] = -1;
    for (idx_t v = 0; v < g->groups; ++v) {
        const idx_t end = g->start[v + 1];
        for (; from < end; ++from) {
            const idx_t u = g->neighbour[from];
            if (g->seen[u] == v) continue;
            g->seen[u] = (int)v;
            g->neighbour[to++] = u;
        }
        g->start[v + 1] = to;
    }
}

static void graph_fill(Graph *g, const LinMatrix *a)
{
    for (int v = 0; v < a->groups; ++v) {
        g->weight[v] = group_first(a, v + 1) - group_first(a, v);
        for (int i = group_first(a, v); i < group_first(a, v + 1); ++i) g->group_of[i] = v;
    }
    graph_visit(g, a, g->start + 2, NULL);
    for (int v = 0; v < a->groups; ++v) g->start[v + 2] += g->start[v + 1];
    graph_visit(g, a, g->start + 1, g->neighbour);
    graph_compact(g);
}

/* Expands the order of the groups to perm over unknowns. */
static void spell_out(const LinMatrix *a, const idx_t *order, int *perm)
{
    int at = 0;
    for (int k = 0; k < a->groups; ++k) {
        const int g = order ? (int)order[k] : k;
        for (int i = group_first(a, g); i < group_first(a, g + 1); ++i) perm[at++] = i;
    }
}

/* Runs METIS; tiny graphs and graphs without edges stay as they are (METIS 5.1 does not accept them). */
static int dissect(Graph *g, const LinMatrix *a, int *perm)
{
    if (g->groups < 3 || g->start[g->groups] == 0) {
        spell_out(a, NULL, perm);
        return 0;
    }
    idx_t *const order = malloc(2 * (size_t)g->groups * sizeof *order);
    if (!order) return -1;
    idx_t options[METIS_NOPTIONS];
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;
    options[METIS_OPTION_SEED] = 1;
    const int status = METIS_NodeND(&g->groups, g->start, g->neighbour, g->weight, options, order, order + g->groups);
    if (status == METIS_OK) spell_out(a, order, perm);
    free(order);
    return status == METIS_OK ? 0 : status == METIS_ERROR_MEMORY ? -1 : 1;
}

int ordering_metis(const LinMatrix *a, int *perm)
{
    Graph g;
    int status = -1;
    if (graph_alloc(&g, a)) {
        graph_fill(&g, a);
        status = dissect(&g, a, perm);
    }
    graph_free(&g);
    return status;
}
