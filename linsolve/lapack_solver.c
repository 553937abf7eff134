/* LAPACK's banded and dense LU behind the contract: the yardsticks of tests and benchmarks. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "linsolve/backend.h"
#include "linsolve/lapack.h"

/* Column-major factors. Band storage after LAPACK: entry (i, j) at lu[2*below + above... row below + above + i - j]. */
typedef struct LapackSolver {
    Lapack lapack;
    int n, banded;
    int below, above; /* diagonals under and over the main one */
    int rows;         /* leading dimension of lu */
    double *lu;       /* [rows*n] */
    lapack_int *pivot;
    double growth;
} LapackSolver;

static double *entry(const LapackSolver *s, int i, int j)
{
    const int row = s->banded ? s->below + s->above + i - j : i;
    return s->lu + (size_t)j * (size_t)s->rows + row;
}

static void lapack_drop(void *self)
{
    LapackSolver *const s = self;
    if (!s) return;
    free(s->lu);
    free(s->pivot);
    lapack_unload(&s->lapack);
    free(s);
}

static void bandwidths(const SparseMatrix *m, int *below, int *above)
{
    *below = *above = 0;
    for (int c = 0; c < m->n; ++c) {
        for (int k = m->p[c]; k < m->p[c + 1]; ++k) {
            const int d = m->i[k] - c;
            if (d > *below) *below = d;
            if (-d > *above) *above = -d;
        }
    }
}

static void *lapack_make(const LinMatrix *a, const LinOptions *options)
{
    const SparseMatrix *const m = a->sparse;
    const int banded = options->kind == LIN_BAND;
    LapackSolver *const s = calloc(1, sizeof *s);
    if (!s) return NULL;
    s->n = m->n;
    s->banded = banded;
    bandwidths(m, &s->below, &s->above);
    s->rows = banded ? 2 * s->below + s->above + 1 : m->n;
    s->lu = malloc((size_t)s->rows * (size_t)m->n * sizeof *s->lu);
    s->pivot = malloc((size_t)m->n * sizeof *s->pivot);
    if (s->lu && s->pivot && memory_room(LAPACK_ROOM) && lapack_load(&s->lapack)) return s;
    lapack_drop(s);
    return NULL;
}

/* Spreads m into the storage; returns its 1-norm (NaN or infinite if a value is) and its largest entry. */
static double load(LapackSolver *s, const SparseMatrix *m, double *largest)
{
    double norm = 0;
    *largest = 0;
    memset(s->lu, 0, (size_t)s->rows * (size_t)s->n * sizeof *s->lu);
    for (int c = 0; c < m->n; ++c) {
        double sum = 0;
        for (int k = m->p[c]; k < m->p[c + 1]; ++k) {
            *entry(s, m->i[k], c) = m->x[k];
            sum += fabs(m->x[k]);
            *largest = fmax(*largest, fabs(m->x[k]));
        }
        norm = sum <= norm ? norm : sum;
        if (!isfinite(sum)) return NAN;
    }
    return norm;
}

/* Largest entry of U. */
static double upper_max(const LapackSolver *s)
{
    double largest = 0;
    const int reach = s->banded ? s->below + s->above : s->n;
    for (int c = 0; c < s->n; ++c) {
        for (int r = c > reach ? c - reach : 0; r <= c; ++r) largest = fmax(largest, fabs(*entry(s, r, c)));
    }
    return largest;
}

static int lapack_factor(void *self, const LinMatrix *a)
{
    LapackSolver *const s = self;
    double largest, rcond = 0;
    const double norm = load(s, a->sparse, &largest);
    if (isnan(norm)) return 1;
    const int info = s->banded
                         ? s->lapack.dgbtrf(LAPACK_COL_MAJOR, s->n, s->n, s->below, s->above, s->lu, s->rows, s->pivot)
                         : s->lapack.dgetrf_work(LAPACK_COL_MAJOR, s->n, s->n, s->lu, s->rows, s->pivot);
    if (info) return info;
    s->growth = largest / upper_max(s);
    const int told = s->banded ? s->lapack.dgbcon(LAPACK_COL_MAJOR, '1', s->n, s->below, s->above, s->lu, s->rows,
                                                  s->pivot, norm, &rcond)
                               : s->lapack.dgecon(LAPACK_COL_MAJOR, '1', s->n, s->lu, s->rows, norm, &rcond);
    if (told == LAPACK_WORK_MEMORY_ERROR) return -1;
    return rcond > DBL_EPSILON / 64 ? 0 : 1; /* rows in mixed units cost digits that are no sign of singularity */
}

static int lapack_solve(void *self, int count, double *x)
{
    LapackSolver *const s = self;
    return s->banded ? s->lapack.dgbtrs(LAPACK_COL_MAJOR, 'N', s->n, s->below, s->above, count, s->lu, s->rows,
                                        s->pivot, x, s->n)
                     : s->lapack.dgetrs_work(LAPACK_COL_MAJOR, 'N', s->n, count, s->lu, s->rows, s->pivot, x, s->n);
}

static void lapack_stats(const void *self, LinStats *stats)
{
    const LapackSolver *const s = self;
    stats->nonzeros = (long)s->rows * s->n;
    stats->growth = s->growth;
}

const LinBackend lapack_backend = {.sparse = 1,
                                   .make = lapack_make,
                                   .drop = lapack_drop,
                                   .factor = lapack_factor,
                                   .solve = lapack_solve,
                                   .stats = lapack_stats};
