/* The reduced Newton matrix against the whole system: newton_solve must solve (1 - gamma J) x = b with J x taken by
 * differences of the rates, whatever the quaternions' lengths and however fast the segments spin. */
#include "tests/support/rig.h"

enum { N = FIXTURE_SEGMENTS, SIZE = STATE_SIZE * N };

static const double T = 0.7; /* s: the winch is speeding up, the tail tension rising */

/* The soft scene in disorder: segments spin at up to `spin` (rad/s), quaternions are 1 +- 0.01 long. */
static Rig *rig_new(const FixtureChoice *choice, LinKind kind, double spin, uint64_t seed)
{
    SceneDef def;
    fixture_pull(&def, choice);
    Rig *const r = rig_make(&def, &(LinOptions){.kind = kind, .threads = 1});
    r->seed = seed;
    state_shake(r->y, N, 3e-3, 0.02, 0.05, spin, &r->seed);
    for (int i = 0; i < N; ++i) {
        const double length = 1 + 0.01 * fixture_random(&r->seed);
        for (int c = 0; c < 4; ++c) r->y[(STATE_Q + c) * N + i] *= length;
    }
    r->t = T;
    rig_refresh(r);
    rig_linearise(r);
    return r;
}

/* From tiny to large gamma, without new blocks in between. */
static double gammas_error(Rig *r)
{
    double worst = 0;
    for (int k = -6; k <= 0; ++k) {
        const double gamma = pow(10, k);
        newton_form(&r->newton, gamma);
        assert_int_equal(newton_factor(&r->newton), 0);
        worst = larger_of(worst, rig_solve_error(r, gamma, 6e-6));
    }
    return worst;
}

TEST(test_solve)
{
    double worst = 0;
    for (int choice = 0; choice < 4; ++choice) {
        const FixtureChoice c = {.geometry = choice % 2 ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH,
                                 .frame = choice / 2 ? FRAME_ADAMS : FRAME_SYMMETRIC,
                                 .soft = 1,
                                 .heading = 1.1};
        Rig *const r = rig_new(&c, LIN_AUTO, 5, 100 + (uint64_t)choice);
        worst = larger_of(worst, gammas_error(r));
        rig_free(r);
    }
    print_message("worst relative residual %.2g\n", worst);
    check_below(worst, 1e-6);
}

/* Fast spin: gamma w of order 10, where the elimination of the quaternions is far from the identity. */
TEST(test_spin)
{
    Rig *const r = rig_new(&(FixtureChoice){.soft = 1}, LIN_AUTO, 40, 9);
    newton_form(&r->newton, 0.3);
    assert_int_equal(newton_factor(&r->newton), 0);
    const double error = rig_solve_error(r, 0.3, 6e-6);
    print_message("relative residual %.2g\n", error);
    check_below(error, 1e-6);
    rig_free(r);
}

/* The same blocks at the same gamma give the same bits, whatever was formed before. */
TEST(test_form_again)
{
    Rig *const r = rig_new(&(FixtureChoice){.soft = 1}, LIN_AUTO, 5, 4);
    double b[SIZE], first[SIZE], again[SIZE];
    for (int k = 0; k < SIZE; ++k) b[k] = fixture_random(&r->seed);
    double *const x[2] = {first, again};
    for (int k = 0; k < 2; ++k) {
        newton_form(&r->newton, 1e-3);
        assert_int_equal(newton_factor(&r->newton), 0);
        memcpy(x[k], b, sizeof b);
        assert_int_equal(newton_solve(&r->newton, x[k]), 0);
        newton_form(&r->newton, 0.1);
        assert_int_equal(newton_factor(&r->newton), 0);
    }
    assert_memory_equal(first, again, sizeof first);
    rig_free(r);
}

/* KLU and the block solver agree on the scene's matrix. */
TEST(test_solvers_agree)
{
    const LinKind kind[2] = {LIN_BLOCK, LIN_KLU};
    double x[2][SIZE], size = 0, apart = 0;
    for (int k = 0; k < 2; ++k) {
        Rig *const r = rig_new(&(FixtureChoice){0}, kind[k], 1, 6);
        newton_form(&r->newton, 5e-3);
        assert_int_equal(newton_factor(&r->newton), 0);
        for (int c = 0; c < SIZE; ++c) x[k][c] = fixture_random(&r->seed);
        assert_int_equal(newton_solve(&r->newton, x[k]), 0);
        rig_free(r);
    }
    for (int c = 0; c < SIZE; ++c) {
        size = larger_of(size, fabs(x[0][c]));
        apart = larger_of(apart, fabs(x[0][c] - x[1][c]));
    }
    print_message("solvers differ by %.2g of the largest entry\n", apart / size);
    check_below(apart, 1e-11 * size);
}

/* Values that are not finite are reported, not solved. */
TEST(test_not_finite)
{
    Rig *const r = rig_new(&(FixtureChoice){.soft = 1}, LIN_AUTO, 1, 8);
    r->newton.k.diag[36 * 7 + 3] = NAN;
    newton_form(&r->newton, 0.01);
    check_above(newton_factor(&r->newton), 0);
    rig_free(r);
}

/* A matrix of n rows with random blocks, well conditioned. */
static void rows_new(Newton *nw, int n, Team *team, uint64_t *seed)
{
    hawser_error err = {0};
    const LinOptions options = {.kind = LIN_BLOCK, .threads = team ? 2 : 1, .team = team};
    if (newton_rows_new(nw, n, &options, &err)) fail_msg("%s", err.message);
    newton_swell(nw, 1);
    for (int k = 0; k < 36 * n; ++k) {
        nw->k.diag[k] = fixture_random(seed);
        nw->d.diag[k] = fixture_random(seed);
        if (k >= 36) nw->k.lower[k] = fixture_random(seed);
        if (k < 36 * (n - 1)) nw->k.upper[k] = fixture_random(seed);
    }
    for (int i = 0; i < n; ++i) {
        for (int c = 0; c < 4; ++c) nw->q[c][i] = 1 + 0.3 * fixture_random(seed);
        for (int c = 0; c < 3; ++c) nw->w[c][i] = fixture_random(seed);
    }
    newton_form(nw, 0.1);
    assert_int_equal(newton_factor(nw), 0);
}

/* Rows that are reduced and expanded as the solver comes to them have the bits of rows that are reduced, solved and
 * expanded one loop after the other, whatever the length leaves of the sides, with one thread and two. */
TEST(test_rows)
{
    enum { MOST = 9001 };
    Team *team = team_new(2);
    for (int n = 1; n <= MOST; n = n < 50 ? n + 1 : 3 * n - 4) {
        for (int threads = 1; threads <= 2; ++threads) {
            uint64_t seed = 5;
            Newton nw;
            rows_new(&nw, n, threads == 2 ? team : NULL, &seed);
            double *const b = malloc((size_t)(STATE_SIZE * n) * sizeof *b), *const x = malloc((size_t)(STATE_SIZE * n) *
                                                                                              sizeof *x);
            for (int k = 0; k < STATE_SIZE * n; ++k) b[k] = x[k] = fixture_random(&seed);
            newton_kernels()->eliminate(&nw, x, 0, n);
            newton_kernels()->couple(&nw, 0, n);
            assert_int_equal(linsolver_solve(nw.solver, nw.x), 0);
            newton_kernels()->expand(&nw, x, 0, n);
            memset(nw.x, 0, (size_t)(6 * n) * sizeof *nw.x);
            memset(nw.z, 0, (size_t)(6 * n) * sizeof *nw.z);
            assert_int_equal(newton_solve(&nw, b), 0);
            assert_memory_equal(b, x, (size_t)(STATE_SIZE * n) * sizeof *b);
            free(b);
            free(x);
            newton_free(&nw);
        }
    }
    team_free(team);
}
