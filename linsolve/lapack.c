/* LAPACK, loaded when a solver needs it: runs of plain chains never do, and with OpenBLAS loading it starts a pool of
 * threads, which spin on the second core. */
#include <dlfcn.h>
#include <lapacke.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "linsolve/small.h"

/* Functions of LAPACKE by their own names and types; all zero: not loaded. */
typedef struct Lapack {
    void *library;
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
    int ok = function_find(lapack->library, "LAPACKE_dsygv", &lapack->dsygv);
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

/* DSYGV returns the vectors in s. */
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
