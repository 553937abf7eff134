#include "linsolve/small.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "linsolve/lapack.h"

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
