/* LAPACK, loaded when a solver needs it: runs of plain chains never do, and with OpenBLAS loading it starts a pool of
 * threads, which spin on the second core. */
#include <dlfcn.h>
#include <float.h>
#include <lapacke.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "linsolve/backend.h"
#include "linsolve/small.h"

/* Functions of LAPACKE by their own names and types; all zero: not loaded. */
typedef struct Lapack {
    void *library;
    __typeof__(LAPACKE_dgetrf_work) *dgetrf_work;
    __typeof__(LAPACKE_dgetrs_work) *dgetrs_work;
    __typeof__(LAPACKE_dgetri_work) *dgetri_work;
    __typeof__(LAPACKE_dgecon) *dgecon;
    __typeof__(LAPACKE_dgbtrf) *dgbtrf;
    __typeof__(LAPACKE_dgbtrs) *dgbtrs;
    __typeof__(LAPACKE_dgbcon) *dgbcon;
    __typeof__(LAPACKE_dsygv) *dsygv;
    __typeof__(LAPACKE_dggev) *dggev;
} Lapack;

/* Memory needed to load the library, roughly, bytes. */
enum { LAPACK_ROOM = 1 << 20 };

static void lapack_unload(Lapack *lapack);

/* Stores the address of the function `name` at `to`; 0 if the library does not have it. */
static int function_find(void *library, const char *name, void *to)
{
    void *const found = dlsym(library, name);
    memcpy(to, &found, sizeof found);
    return found != NULL;
}

/* Loads the library if there is memory; 0 if it is not installed. */
static int lapack_load(Lapack *lapack)
{
    /* it stays loaded: unloading and loading it again takes a thousand times as long as the computation */
    *lapack = (Lapack){.library = dlopen("liblapacke.so.3", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)};
    if (!lapack->library) return 0;
    int ok = function_find(lapack->library, "LAPACKE_dgetrf_work", &lapack->dgetrf_work);
    ok &= function_find(lapack->library, "LAPACKE_dgetrs_work", &lapack->dgetrs_work);
    ok &= function_find(lapack->library, "LAPACKE_dgetri_work", &lapack->dgetri_work);
    ok &= function_find(lapack->library, "LAPACKE_dgecon", &lapack->dgecon);
    ok &= function_find(lapack->library, "LAPACKE_dgbtrf", &lapack->dgbtrf);
    ok &= function_find(lapack->library, "LAPACKE_dgbtrs", &lapack->dgbtrs);
    ok &= function_find(lapack->library, "LAPACKE_dgbcon", &lapack->dgbcon);
    ok &= function_find(lapack->library, "LAPACKE_dsygv", &lapack->dsygv);
    ok &= function_find(lapack->library, "LAPACKE_dggev", &lapack->dggev);
    if (!ok) lapack_unload(lapack);
    return ok;
}

/* Releases it; may be called on a zeroed struct. */
static void lapack_unload(Lapack *lapack)
{
    if (lapack->library) dlclose(lapack->library);
    *lapack = (Lapack){0};
}

/* LAPACK's banded and dense LU behind the same interface: references of tests and benchmarks. */

/* Column-major factors. Band storage as in LAPACK: entry (i, j) at lu[2*below + above... row below + above + i - j]. */
typedef struct LapackSolver {
    Lapack lapack;
    int n, banded;
    int below, above; /* diagonals below and above the main one */
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
    return rcond > DBL_EPSILON / 64 ? 0 : 1; /* rows in mixed units cost digits, which does not mean that the matrix is
                                              * singular */
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

/* DSYGV: the vectors are returned in s. */
static lapack_int symmetric_pair(const Lapack *lapack, int n, double *s, double *t, double *mu, double *imaginary,
                                 double *z)
{
    const lapack_int info = lapack->dsygv(LAPACK_COL_MAJOR, 1, 'V', 'U', n, s, n, t, n, mu);
    memcpy(z, s, (size_t)n * (size_t)n * sizeof *z);
    memset(imaginary, 0, (size_t)n * sizeof *imaginary);
    return info;
}

/* DGGEV: eigenvalues are (mu + i imaginary)/beta; an infinite one remains infinite. */
static lapack_int general_pair(const Lapack *lapack, int n, double *s, double *t, double *mu, double *imaginary,
                               double *z, double *beta)
{
    double none;
    const lapack_int info =
        lapack->dggev(LAPACK_COL_MAJOR, 'N', 'V', n, s, n, t, n, mu, imaginary, beta, &none, 1, z, n);
    for (int k = 0; k < n; ++k) {
        mu[k] /= beta[k];
        imaginary[k] /= beta[k];
    }
    return info;
}

hawser_status small_eigen(int n, int symmetric, double *s, double *t, double *mu, double *imaginary, double *z,
                          hawser_error *err)
{
    Lapack lapack;
    if (!memory_room(LAPACK_ROOM))
        return error_memory(err); /* Fortran's library ends the program if it has no
                                   * memory */
    if (!lapack_load(&lapack)) {
        return error_set(err, HAWSER_ERR_RUN, "modes need LAPACK (liblapacke.so.3), which was not found");
    }
    double *const beta = malloc((size_t)n * sizeof *beta);
    lapack_int info = -1;
    if (beta) {
        info = symmetric ? symmetric_pair(&lapack, n, s, t, mu, imaginary, z)
                         : general_pair(&lapack, n, s, t, mu, imaginary, z, beta);
    }
    lapack_unload(&lapack);
    if (!beta) return error_memory(err);
    free(beta);
    if (info == 0) return HAWSER_OK;
    if (info == LAPACK_WORK_MEMORY_ERROR) return error_memory(err);
    return error_set(err, HAWSER_ERR_RUN, "LAPACK found no eigenvalues of the modes' %d by %d matrices (info %d)", n, n,
                     (int)info);
}
