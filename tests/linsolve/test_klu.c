/* KLU behind the contract: assembly into compressed columns, orderings, refactorisation and its way out. */

#include "linsolve/backend.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

/* A ring of 30 blocks with a bridge: the chain's ends and two inner blocks are coupled both ways. */
typedef struct Ring {
    NewtonMatrix m;
    ExtraBlock extra[5];
    double *block;
} Ring;

static void ring_init(Ring *ring, int n, int b, uint64_t *seed)
{
    *ring = (Ring){.block = fixture_vector(5 * b * b, seed)};
    const int at[5][2] = {{0, n - 1}, {n - 1, 0}, {n / 3, 2 * n / 3}, {2 * n / 3, n / 3}, {1, 1}};
    fixture_chain_random(&ring->m.chain, n, b, 5 * b, seed);
    for (int k = 0; k < 5; ++k) ring->extra[k] = (ExtraBlock){at[k][0], at[k][1], ring->block + k * b * b};
    ring->m.extras = 5;
    ring->m.extra = ring->extra;
}

static void ring_free(Ring *ring)
{
    block_chain_free(&ring->m.chain);
    free(ring->block);
}

/* y = y + s A x, piece by piece. */
static void gemv(const NewtonMatrix *a, double s, const double *x, double *y)
{
    for (int k = 0; k < newton_pieces(a); ++k) {
        const Piece p = newton_piece(a, k);
        assert_non_null(p.value);
        for (int c = 0; c < p.cols; ++c) {
            const double *const column = p.value + (size_t)c * (size_t)p.rows;
            for (int r = 0; r < p.rows; ++r) y[p.row + r] += s * x[p.col + c] * column[r];
        }
    }
}

/* Assembled columns are sorted, without repetition, and act like the matrix. */
TEST(assembly)
{
    uint64_t seed = 1;
    Ring ring;
    SparseAssembly s;
    ring_init(&ring, 30, 6, &seed);
    assert_true(sparse_assembly_new(&ring.m, &s));
    assert_int_equal(s.a.n, 180);
    assert_int_equal(s.a.p[180], (30 + 2 * 29 + 4) * 36); /* the fifth extra block lies on the chain's */
    for (int again = 0; again < 2; ++again) {
        sparse_assembly_refresh(&s, &ring.m);
        double *const x = fixture_vector(180, &seed), y[180] = {0}, z[180] = {0};
        gemv(&ring.m, 2, x, y);
        for (int c = 0; c < 180; ++c) {
            for (int k = s.a.p[c]; k < s.a.p[c + 1]; ++k) {
                if (k > s.a.p[c]) check_above(s.a.i[k], s.a.i[k - 1]);
                z[s.a.i[k]] += 2 * x[c] * s.a.x[k];
            }
        }
        for (int i = 0; i < 180; ++i) check_close(y[i], z[i], 1e-12);
        free(x);
    }
    sparse_assembly_free(&s);
    ring_free(&ring);
}

/* METIS' order is a permutation that keeps groups together; tiny and unconnected graphs are no trouble. */
TEST(metis_order)
{
    for (int n = 1; n <= 40; n += n < 4 ? 1 : 12) {
        uint64_t seed = 2;
        BlockChain a;
        fixture_chain_random(&a, n, 6, 0, &seed);
        const NewtonMatrix m = {.chain = a};
        SparseAssembly s;
        assert_true(sparse_assembly_new(&m, &s));
        int at[41], perm[240], seen[240] = {0};
        const int groups = newton_groups(&m, at);
        assert_int_equal(groups, n);
        const LinMatrix view = {.sparse = &s.a, .groups = groups, .group_at = at};
        assert_int_equal(ordering_metis(&view, perm), 0);
        for (int k = 0; k < 6 * n; ++k) {
            assert_false(seen[perm[k]]++);
            assert_int_equal(perm[k] % 6, k % 6);
        }
        sparse_assembly_free(&s);
        block_chain_free(&a);
    }
    int p[] = {0, 1, 2, 3, 4}, i[] = {0, 1, 2, 3}, perm[4];
    double x[] = {1, 1, 1, 1};
    const SparseMatrix diagonal = {4, p, i, x};
    assert_int_equal(ordering_metis(&(LinMatrix){.sparse = &diagonal, .groups = 4}, perm), 0);
    for (int k = 0; k < 4; ++k) assert_int_equal(perm[k], k);
}

/* The automatic ordering has the least fill of all, and keeps its choice. */
TEST(least_fill)
{
    uint64_t seed = 3;
    Ring ring;
    ring_init(&ring, 60, 6, &seed);
    long nonzeros[4];
    for (LinOrdering o = ORDER_AUTO; o <= ORDER_METIS; ++o) {
        static const char *const expected[] = {NULL, "amd", "colamd", "metis"};
        LinStats stats;
        LinSolver *const s = linsolver_new_newton(&ring.m, &(LinOptions){.kind = LIN_KLU, .ordering = o}, NULL);
        for (int k = 0; k < 3; ++k) assert_int_equal(linsolver_factor_newton(s, &ring.m), 0);
        linsolver_stats(s, &stats);
        nonzeros[o] = stats.nonzeros;
        if (expected[o]) assert_string_equal(stats.ordering, expected[o]);
        assert_int_equal(stats.factors, 3);
        assert_int_equal(stats.refactors, 2);
        assert_int_equal(stats.fallbacks, 0);
        assert_int_equal(stats.analyses, o == ORDER_AUTO ? 4 : 1);
        check_above(stats.growth, 0.1);
        check_at_most(stats.growth, 1);
        check_above(nonzeros[o], 0);
        check_at_most(nonzeros[ORDER_AUTO], nonzeros[o]);
        check_at_most(nonzeros[o],
                      3 * 60 * 2 * 36); /* a ring cut at one place: two off-diagonal blocks a row, and its fill */
        assert_string_equal(stats.why, "asked for");
        linsolver_free(s);
    }
    ring_free(&ring);
}

/* New values may make the old pivots worthless: the refactorisation notices and chooses new ones. */
TEST(fallback_growth)
{
    uint64_t seed = 4;
    BlockChain a, turned;
    fixture_chain_random(&a, 6, 6, 12, &seed);
    fixture_chain_random(&turned, 6, 6, 12, &seed);
    for (int i = 0; i < 6; ++i) { /* rows 0 and 1 change places: the old pivots are 1e-12 */
        double *const block = turned.diag + 36 * i;
        for (int c = 0; c < 6; ++c) {
            const double row = block[6 * c];
            block[6 * c] = block[6 * c + 1];
            block[6 * c + 1] = row;
        }
        block[0] = block[7] = 1e-12;
    }
    const NewtonMatrix m = {.chain = turned};
    double *const r = fixture_vector(36, &seed), x[36];
    LinStats stats;
    LinSolver *const s = linsolver_new(&a, &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD}, NULL);
    assert_int_equal(linsolver_factor(s, &a), 0);
    assert_int_equal(linsolver_factor(s, &turned), 0);
    linsolver_stats(s, &stats);
    assert_int_equal(stats.fallbacks, 1);
    memcpy(x, r, sizeof x);
    assert_int_equal(linsolver_solve(s, x), 0);
    check_below(fixture_backward_error(&m, x, r), 1e-13);
    assert_int_equal(linsolver_factor(s, &turned), 0);
    linsolver_stats(s, &stats);
    assert_int_equal(stats.fallbacks, 1); /* the new pivots serve from now on */
    linsolver_free(s);
    free(r);
    block_chain_free(&a);
    block_chain_free(&turned);
}

/* The first matrix of auto's trials is singular: the choice waits for a better one. */
TEST(undecided)
{
    uint64_t seed = 5;
    BlockChain a, zero;
    fixture_chain_random(&a, 6, 6, 12, &seed);
    block_chain_alloc(&zero, 6, 6);
    LinStats stats;
    LinSolver *const s = linsolver_new(&zero, &(LinOptions){.kind = LIN_KLU}, NULL);
    check_above(linsolver_factor(s, &zero), 0);
    linsolver_stats(s, &stats);
    assert_string_equal(stats.ordering, "undecided");
    assert_int_equal(linsolver_factor(s, &a), 0);
    linsolver_stats(s, &stats);
    assert_string_not_equal(stats.ordering, "undecided");
    linsolver_free(s);
    block_chain_free(&a);
    block_chain_free(&zero);
}

/* A value that is not finite, wherever it stands, is seen before anything is factored: nothing is counted, and the old
 * factors go on solving. Sizes leave 0 to 7 values after the last eight. */
TEST(not_finite_anywhere)
{
    static const double wrong[] = {NAN, INFINITY, -INFINITY};
    for (int n = 2; n <= 5; ++n) {
        uint64_t seed = 6;
        BlockChain a;
        SparseAssembly s;
        LinStats stats;
        fixture_chain_random(&a, n, 3, 12, &seed);
        const NewtonMatrix m = {.chain = a};
        assert_true(sparse_assembly_new(&m, &s));
        sparse_assembly_refresh(&s, &m);
        const int count = s.a.p[s.a.n];
        double *const r = fixture_vector(3 * n, &seed), x[15], before[15];
        void *const solver = klu_backend.make(&(LinMatrix){.sparse = &s.a, .groups = s.a.n},
                                              &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD});
        assert_non_null(solver);
        assert_int_equal(klu_backend.factor(solver, &(LinMatrix){.sparse = &s.a}), 0);
        memcpy(before, r, (size_t)(3 * n) * sizeof *r);
        assert_int_equal(klu_backend.solve(solver, 1, before), 0);
        for (int k = 0; k < count; ++k) {
            const double good = s.a.x[k];
            s.a.x[k] = wrong[k % 3];
            check_above(klu_backend.factor(solver, &(LinMatrix){.sparse = &s.a}), 0);
            s.a.x[k] = good;
        }
        klu_backend.stats(solver, &stats);
        assert_int_equal(stats.refactors, 0);
        assert_int_equal(stats.fallbacks, 0);
        assert_int_equal(klu_backend.factor(solver, &(LinMatrix){.sparse = &s.a}), 0);
        memcpy(x, r, (size_t)(3 * n) * sizeof *r);
        assert_int_equal(klu_backend.solve(solver, 1, x), 0);
        for (int i = 0; i < 3 * n; ++i) check_close(x[i], before[i], 1e-14);
        klu_backend.stats(solver, &stats);
        assert_int_equal(stats.refactors, 1); /* with the pivots of the first */
        klu_backend.drop(solver);
        free(r);
        sparse_assembly_free(&s);
        block_chain_free(&a);
    }
}
