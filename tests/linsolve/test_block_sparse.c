/* Chains beside each other with blocks between them: against LAPACK's dense solution, by the backward error, and what
 * the pattern of now costs. */

#include "linsolve/block.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/beside_fixture.h"
#include "tests/support/check.h"

static LinSolver *solver_of(const NewtonMatrix *m, LinKind kind)
{
    hawser_error err = {0};
    LinSolver *const s =
        linsolver_new_newton(m, &(LinOptions){.kind = kind, .ordering = ORDER_AMD, .threads = 1}, &err);
    if (!s) fail_msg("%s", err.message);
    return s;
}

/* Solves and returns the backward error; x may be looked at. */
static double solved(LinSolver *s, const NewtonMatrix *m, const double *r, double *x)
{
    assert_int_equal(linsolver_factor_newton(s, m), 0);
    memcpy(x, r, (size_t)newton_size(m) * sizeof *x);
    assert_int_equal(linsolver_solve(s, x), 0);
    return fixture_backward_error(m, x, r);
}

/* Two, three and five chains, touching all along or on a stretch: as well as KLU. */
TEST(chains_beside)
{
    static const int chains[] = {2, 3, 5};
    uint64_t seed = 11;
    for (int c = 0; c < 3; ++c) {
        for (int stretch = 0; stretch < 2; ++stretch) {
            const int k = chains[c], n = 30;
            Beside b = beside_new(k, n, stretch ? 10 : 0, stretch ? 14 : n, &seed);
            const NewtonMatrix m = matrix_of(&b, stretch);
            double *const r = fixture_vector(6 * k * n, &seed), *const x = malloc((size_t)(6 * k * n) * sizeof *x);
            double *const y = malloc((size_t)(6 * k * n) * sizeof *y);
            LinSolver *const s = solver_of(&m, LIN_BLOCK_SPARSE), *const klu = solver_of(&m, LIN_KLU);
            check_below(solved(s, &m, r, x), 1e-14);
            check_below(solved(klu, &m, r, y), 1e-14);
            const double size = fixture_norm(6 * k * n, y);
            for (int i = 0; i < 6 * k * n; ++i) check_close(x[i], y[i], 1e-9 * size);
            LinStats stats;
            linsolver_stats(s, &stats);
            assert_int_equal(stats.fallbacks, 0);
            assert_int_equal(stats.analyses, 1);
            /* a band of 2 k - 1 blocks to either side, where they touch; else the chains' own */
            const long rows = stretch ? 4 + 2 : n, band = 36L * k * n * 3 + 36L * 2 * k * rows * 2 * k;
            if (!(stats.nonzeros <= band)) fail_msg("%d chains: %ld of %ld", k, stats.nonzeros, band);
            linsolver_free(s);
            linsolver_free(klu);
            free(r);
            free(x);
            free(y);
            beside_free(&b);
        }
    }
}

/* Contacts come and go: the pattern follows, and the same matrix gives the same bits whatever was factored before.
 * Without any, it is the block LU's bits. */
TEST(pattern_follows)
{
    enum { K = 3, N = 12, SIZE = 6 * K * N };
    uint64_t seed = 12;
    Beside b = beside_new(K, N, 2, 9, &seed);
    const NewtonMatrix m = matrix_of(&b, 1);
    double *const r = fixture_vector(SIZE, &seed), x[SIZE], again[SIZE];
    LinSolver *const s = solver_of(&m, LIN_BLOCK_SPARSE);
    check_below(solved(s, &m, r, x), 1e-14);
    memset(b.value, 0, (size_t)b.count * BLOCK * sizeof(double));
    memset(b.live, 0, (size_t)b.count);
    check_below(solved(s, &m, r, again), 1e-14);
    LinSolver *const plain = linsolver_new(&b.chain, &(LinOptions){.kind = LIN_BLOCK, .threads = 1}, NULL);
    double alone[SIZE];
    const NewtonMatrix bare = {.chain = b.chain};
    check_below(solved(plain, &bare, r, alone), 1e-14);
    assert_memory_equal(again, alone, sizeof alone);
    beside_free(&b);
    seed = 12;
    b = beside_new(K, N, 2, 9, &seed);
    const NewtonMatrix same = matrix_of(&b, 0);
    check_below(solved(s, &same, r, again), 1e-14);
    assert_memory_equal(x, again, sizeof x);
    linsolver_free(plain);
    linsolver_free(s);
    free(r);
    beside_free(&b);
}

/* A pivot block that is zero on its diagonal is pivoted; what is singular or not finite is not solved, and does no harm
 * to the next. */
TEST(hard_blocks)
{
    enum { K = 2, N = 5, SIZE = 6 * K * N };
    uint64_t seed = 13;
    Beside b = beside_new(K, N, 0, N, &seed);
    const NewtonMatrix m = matrix_of(&b, 1);
    double *const r = fixture_vector(SIZE, &seed), x[SIZE], kept[BLOCK];
    LinSolver *const s = solver_of(&m, LIN_BLOCK_SPARSE);
    double *const diag = b.chain.diag + BLOCK * 2;
    memcpy(kept, diag, sizeof kept);
    memset(diag, 0, sizeof kept);
    for (int c = 0; c < 6; ++c) diag[6 * c + (c ^ 1)] = 1e9; /* all that is large is beside the diagonal */
    check_below(solved(s, &m, r, x), 1e-12);
    LinStats stats;
    linsolver_stats(s, &stats);
    check_above((double)(stats.pivoted + stats.fallbacks), 0);
    memcpy(diag, kept, sizeof kept);
    diag[3] = NAN;
    check_above(linsolver_factor_newton(s, &m), 0);
    memcpy(diag, kept, sizeof kept);
    check_below(solved(s, &m, r, x), 1e-14);
    linsolver_free(s);
    free(r);
    beside_free(&b);
}
