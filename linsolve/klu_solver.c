/* KLU for any pattern: one symbolic analysis, refactorisation while the pivots stay good, a full factorisation when they
 * do not. docs/model.md, "Linear solvers", (L12)-(L14). */
#include <float.h>
#include <klu.h>
#include <stdlib.h>

#include "linsolve/backend.h"
#include "linsolve/ordering.h"

/* In the order in which auto tries them; the first of equals wins. */
typedef enum Candidate { TRY_AMD, TRY_COLAMD, TRY_METIS, TRY_NATURAL, CANDIDATES } Candidate;

typedef struct KluSolver {
    klu_common common;
    klu_symbolic *symbolic;
    klu_numeric *numeric; /* NULL before the first factorisation and after a failed one */
    int decided;          /* the ordering is chosen */
    Candidate candidate;
    double growth_limit;
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
    double zero = 0; /* becomes NaN with the first value that is not finite */
    for (int k = 0; k < m->p[m->n]; ++k) zero += 0 * m->x[k];
    return zero == 0;
}

/* 0: good; > 0: singular, by the ratio of U's diagonal (L13); < 0: no memory. Grades the present factors. */
static int grade(KluSolver *s, const SparseMatrix *m)
{
    if (!s->numeric) return s->common.status < 0 && s->common.status != KLU_INVALID ? -1 : 1;
    if (s->common.status != KLU_OK) return 1;
    if (!klu_rcond(s->symbolic, s->numeric, &s->common) || !(s->common.rcond > 4 * DBL_EPSILON)) return 1;
    if (!klu_rgrowth(m->p, m->i, m->x, s->symbolic, s->numeric, &s->common)) return 1;
    s->stats.growth = s->common.rgrowth;
    return s->common.rgrowth > 0 ? 0 : 1;
}

static int factor_full(KluSolver *s, const SparseMatrix *m)
{
    klu_free_numeric(&s->numeric, &s->common);
    s->numeric = klu_factor(m->p, m->i, m->x, s->symbolic, &s->common);
    const int status = grade(s, m);
    if (status) klu_free_numeric(&s->numeric, &s->common);
    if (!status) s->stats.nonzeros = (long)s->numeric->lnz + s->numeric->unz - m->n;
    return status;
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
            best = (KluSolver){.symbolic = s->symbolic, .numeric = s->numeric, .candidate = c, .stats = s->stats};
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
    const int ok = klu_refactor(m->p, m->i, m->x, s->symbolic, s->numeric, &s->common);
    if (ok && grade(s, m) == 0 && s->stats.growth * s->growth_limit >= 1) return 0;
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

static void klu_drop_self(void *self) { klu_drop(self); }

const LinBackend klu_backend = {.sparse = 1,
                                .make = klu_make,
                                .drop = klu_drop_self,
                                .factor = klu_factorise,
                                .solve = klu_solve_many,
                                .stats = klu_stats};
