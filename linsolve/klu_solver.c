/* KLU for any pattern: one symbolic analysis, refactorisation while the pivots stay good, a full factorisation when
 * they do not. docs/model.md, "Linear solvers", (L12)-(L14). */
#include <float.h>
#include <klu.h>
#include <stdlib.h>
#include <string.h>

#include "linsolve/backend.h"

/* In the order in which auto tries them; the first of equals wins. */
typedef enum Candidate { TRY_AMD, TRY_COLAMD, TRY_METIS, TRY_NATURAL, CANDIDATES } Candidate;

typedef struct KluSolver {
    klu_common common;
    klu_symbolic *symbolic;
    klu_numeric *numeric; /* NULL before the first factorisation and after a failed one */
    int decided;          /* the ordering is chosen */
    Candidate candidate;
    double growth_limit;
    double rcond; /* ratio of U's diagonal in the last full factorisation */
    double *full; /* the values that were factored then, which have chosen the pivots; owned */
    int again;    /* other values have been factored since, with these pivots */
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

/* Analysis with a permutation of our own. Block triangular form is off: it would permute columns away from the diagonal
 * and undo the ordering, and a Newton matrix is irreducible anyway. */
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

/* NULL when memory ran out or the pattern is unfit for the ordering. */
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
        0}; /* become NaN with the first value that is not finite; several do not wait for each other */
    const int count = m->p[m->n];
    for (int k = 0; k + SUMS <= count; k += SUMS) {
        for (int j = 0; j < SUMS; ++j) zero[j] += 0 * m->x[k + j];
    }
    for (int k = count - count % SUMS; k < count; ++k) zero[0] += 0 * m->x[k];
    for (int j = 1; j < SUMS; ++j) zero[0] += zero[j];
    return zero[0] == 0;
}

/* 0: good; > 0: singular, by the ratio of U's diagonal (L13); < 0: no memory. Looks at the present factors. */
static int grade(KluSolver *s)
{
    if (!s->numeric) return s->common.status < 0 && s->common.status != KLU_INVALID ? -1 : 1;
    if (s->common.status != KLU_OK) return 1;
    if (!klu_rcond(s->symbolic, s->numeric, &s->common)) return 1;
    return s->common.rcond > 4 * DBL_EPSILON ? 0 : 1;
}

/* The growth of the present factors, measured; it reads the whole matrix, a third of a refactorisation's time. */
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

/* Whether the old pivots serve the new values. Rows are scaled to 1, so factors grow only over a small pivot: while the
 * smallest pivot stays near what the full factorisation found, there is nothing to measure (L14). */
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

/* The pivots of the last full factorisation, and with these the factors of now. */
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
