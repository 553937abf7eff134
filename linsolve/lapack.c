/* LAPACK's eigenvalues of small matrices. The library is loaded when modes are computed: no other run needs it, and
 * loading it starts a pool of threads where OpenBLAS stands behind it, which spin on the second core. */
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

/* What it takes to load the library, about, bytes. */
enum { LAPACK_ROOM = 1 << 20 };

static void lapack_unload(Lapack *lapack);

/* The function `name` into the pointer at `to`; 0 if the library has none. */
static int function_find(void *library, const char *name, void *to)
{
    void *const found = dlsym(library, name);
    memcpy(to, &found, sizeof found);
    return found != NULL;
}

/* Loads the library, for which there is memory; 0 if it is not there. */
static int lapack_load(Lapack *lapack)
{
    /* it stays once it is there: to let go of it and to load it again takes a thousand times as long as what is asked
     */
    *lapack = (Lapack){.library = dlopen("liblapacke.so.3", RTLD_NOW | RTLD_LOCAL | RTLD_NODELETE)};
    if (!lapack->library) return 0;
    int ok = function_find(lapack->library, "LAPACKE_dsygv", &lapack->dsygv);
    ok &= function_find(lapack->library, "LAPACKE_dggev", &lapack->dggev);
    if (!ok) lapack_unload(lapack);
    return ok;
}

/* Lets go of it; may be called on a zeroed struct. */
static void lapack_unload(Lapack *lapack)
{
    if (lapack->library) dlclose(lapack->library);
    *lapack = (Lapack){0};
}

/* DSYGV: vectors come in s. */
static lapack_int symmetric_pair(const Lapack *lapack, int n, double *s, double *t, double *mu, double *imaginary,
                                 double *z)
{
    const lapack_int info = lapack->dsygv(LAPACK_COL_MAJOR, 1, 'V', 'U', n, s, n, t, n, mu);
    memcpy(z, s, (size_t)n * (size_t)n * sizeof *z);
    memset(imaginary, 0, (size_t)n * sizeof *imaginary);
    return info;
}

/* DGGEV: eigenvalues are (mu + i imaginary)/beta; an infinite one stays infinite. */
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
    if (!memory_room(LAPACK_ROOM)) return error_memory(err); /* Fortran's library ends the program without */
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
