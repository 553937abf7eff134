/* Small dense systems: residuals of random ones that need pivoting, and what cannot be solved. */
#include <math.h>

#include "linsolve/small.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

enum { MOST = 40 };

TEST(residuals)
{
    uint64_t seed = 2;
    for (int n = 1; n <= MOST; ++n) {
        double *const a = fixture_vector(n * n, &seed), *const b = fixture_vector(n, &seed);
        double lu[MOST * MOST], x[MOST], worst = 0;
        int pivot[MOST];
        if (n > 1) a[0] = 0; /* no step without an exchange */
        memcpy(lu, a, (size_t)(n * n) * sizeof *lu);
        memcpy(x, b, (size_t)n * sizeof *x);
        assert_int_equal(small_lu_factor(n, lu, pivot), 0);
        small_lu_solve(n, lu, pivot, x);
        for (int i = 0; i < n; ++i) {
            double rest = b[i], size = fabs(b[i]);
            for (int c = 0; c < n; ++c) {
                rest -= a[c * n + i] * x[c];
                size += fabs(a[c * n + i] * x[c]);
            }
            worst = larger_of(worst, fabs(rest) / size);
        }
        check_below(worst, 1e-13);
        free(a);
        free(b);
    }
}

TEST(refused)
{
    int pivot[3];
    double zero[1] = {0}, twice[9] = {1, 2, 3, 2, 4, 6, 1, 0, 1}, wrong[4] = {1, 0, NAN, 1};
    assert_int_equal(small_lu_factor(1, zero, pivot), 1);
    assert_int_equal(small_lu_factor(3, twice, pivot), 1);
    assert_int_equal(small_lu_factor(2, wrong, pivot), 1);
    assert_int_equal(small_lu_factor(0, zero, pivot), 0); /* no border */
}

/* A pivot is too small by what the whole matrix is like: 1e-14 of its largest entry, whatever the units are. */
TEST(singular_by_its_own_size)
{
    int pivot[2];
    for (int e = -200; e <= 200; e += 50) {
        const double unit = pow(10, e);
        double rounding[4] = {unit, 0, 0, 0.9e-14 * unit}, small[4] = {-unit, 0, 0, 1.1e-14 * unit};
        double under[4] = {0.9e-14 * unit, 0, unit, 1}, alike[4] = {3 * unit, unit, 6 * unit, 2 * unit};
        assert_int_equal(small_lu_factor(2, rounding, pivot), 1);
        assert_int_equal(small_lu_factor(2, small, pivot), 0);
        under[3] = 2 * unit; /* the second column alone shows how large the entries are */
        assert_int_equal(small_lu_factor(2, under, pivot), 1);
        assert_int_equal(small_lu_factor(2, alike, pivot), 1);
    }
}
