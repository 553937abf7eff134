/* Error in place of LAPACK's functions in a build without LAPACK. */
#include "core/error.h"
#include "linsolve/small.h"

hawser_status small_eigen(int n, int symmetric, double *s, double *t, double *mu, double *imaginary, double *z,
                          hawser_error *err)
{
    (void)n, (void)symmetric, (void)s, (void)t, (void)mu, (void)imaginary, (void)z;
    return error_set(err, HAWSER_ERR_RUN, "modes need LAPACK, which this build of hawser leaves out (HAWSER_LAPACK)");
}
