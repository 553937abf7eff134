/* What solvers say of themselves, by closed forms: growth wherever it is, entries of the factors, how often what was
 * done; and chains whose ends touch. */
#include "linsolve/backend.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/beside_fixture.h"
#include "tests/support/check.h"

static LinSolver *solver_new(const NewtonMatrix *m, LinKind kind, double growth_limit)
{
    hawser_error err = {0};
    const LinOptions options = {.kind = kind, .ordering = ORDER_AMD, .threads = 1, .growth_limit = growth_limit};
    LinSolver *const s = linsolver_new_newton(m, &options, &err);
    if (!s) fail_msg("%s", err.message);
    return s;
}

static LinStats factored(LinSolver *s, const NewtonMatrix *m)
{
    LinStats stats;
    assert_int_equal(linsolver_factor_newton(s, m), 0);
    linsolver_stats(s, &stats);
    return stats;
}

/* (L8): two block rows of ones on the diagonal, place r of the second coupled by `by` with place 0 of the first, which
 * is coupled back by 10: S = 1 - 10 by in one place, over sums of 1 + |by|. The largest over all places counts,
 * whichever that is; and the smallest reciprocal is what is said. */
TEST(growth_in_every_place)
{
    for (int b = 3; b <= 6; b += 3) {
        for (int r = 0; r < b; ++r) {
            for (int from_below = 0; from_below < 2; ++from_below) {
                BlockChain a;
                assert_true(block_chain_alloc(&a, 2, b));
                for (int i = 0; i < 2; ++i) {
                    for (int k = 0; k < b; ++k) a.diag[i * b * b + k * (b + 1)] = 1;
                }
                /* both rows: one of them is eliminated first */
                a.lower[b * b + r] = a.upper[r] = 2;
                a.upper[b * r] += 10;
                a.lower[b * b + b * r] += 10;
                const NewtonMatrix m = {.chain = a};
                LinSolver *const s = solver_new(&m, LIN_BLOCK, 0);
                const LinStats stats = factored(s, &m);
                /* column 0 of the coupling before has 2 in row r, column r has 10 in row 0; r = 0: 12 in one place */
                double worst = 1;
                for (int row = 0; row < b; ++row) {
                    double sum = 0, scale = 1;
                    for (int c = 0; c < b; ++c) {
                        const double before = (row == r && c == 0 ? 2 : 0) + (row == 0 && c == r ? 10 : 0);
                        double product = 0;
                        for (int k = 0; k < b; ++k) {
                            product += ((row == r && k == 0 ? 2 : 0) + (row == 0 && k == r ? 10 : 0)) *
                                       ((k == r && c == 0 ? 2 : 0) + (k == 0 && c == r ? 10 : 0));
                        }
                        sum += fabs((row == c) - product);
                        scale += before;
                    }
                    worst = larger_of(worst, sum / scale);
                }
                check_share(1 / stats.growth, worst, 1e-14);
                linsolver_free(s);
                block_chain_free(&a);
            }
        }
    }
}

/* One place alone grows: row r of the second block by 2 times 10 in column `c` of the first. */
TEST(growth_in_one_place)
{
    for (int b = 3; b <= 6; b += 3) {
        for (int r = 0; r < b; ++r) {
            const int c = (r + 1) % b;
            BlockChain a;
            assert_true(block_chain_alloc(&a, 2, b));
            for (int i = 0; i < 2; ++i) {
                for (int k = 0; k < b; ++k) a.diag[i * b * b + k * (b + 1)] = 1;
            }
            a.lower[b * b + c * b + r] = a.upper[c * b + r] = 2;  /* row r, column c */
            a.upper[r * b + c] = a.lower[b * b + r * b + c] = 10; /* row c, column r */
            const NewtonMatrix m = {.chain = a};
            LinSolver *const s = solver_new(&m, LIN_BLOCK, 0);
            /* S = 1 - 20 in row r over 1 + 2, and in row c over 1 + 10 */
            check_share(1 / factored(s, &m).growth, 19.0 / 3, 1e-14);
            linsolver_free(s);
            block_chain_free(&a);
        }
    }
}

/* (L14): KLU's old pivots serve while nothing grows, however small the pivots become; where they do, new ones are
 * taken from what the limit says on. Rows are scaled to their largest entry. */
TEST(klu_pivots)
{
    int p[] = {0, 2, 4}, i[] = {0, 1, 0, 1};
    double x[4];
    SparseMatrix a = {.n = 2, .p = p, .i = i, .x = x};
    static const double first[4] = {1, 0.5, 0.5, 1}, small[4] = {1, 1 - 1e-5, 1 - 1e-5, 1}, grown[4] = {1e-5, 1, 1, 0};
    for (int strict = 0; strict < 2; ++strict) {
        LinStats stats;
        memcpy(x, first, sizeof x);
        void *const s =
            klu_backend.make(&(LinMatrix){.sparse = &a, .groups = a.n},
                             &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD, .growth_limit = strict ? 1e4 : 1e6});
        assert_int_equal(klu_backend.factor(s, &(LinMatrix){.sparse = &a}), 0);
        klu_backend.stats(s, &stats);
        check_close(stats.growth, 1, 1e-12);
        memcpy(x, small, sizeof x); /* pivots 1 and 2e-5 */
        assert_int_equal(klu_backend.factor(s, &(LinMatrix){.sparse = &a}), 0);
        klu_backend.stats(s, &stats);
        assert_int_equal(stats.fallbacks, 0);
        memcpy(x, grown, sizeof x); /* pivots 1e-5 and -1e5 */
        assert_int_equal(klu_backend.factor(s, &(LinMatrix){.sparse = &a}), 0);
        klu_backend.stats(s, &stats);
        assert_int_equal(stats.refactors, 2);
        assert_int_equal(stats.fallbacks, strict);
        check_share(stats.growth, strict ? 1 : 1e-5, 1e-9); /* measured anew */
        double y[2] = {1 + 1e-5, 1};
        assert_int_equal(klu_backend.solve(s, 1, y), 0);
        check_close(y[0], 1, 1e-9);
        check_close(y[1], 1, 1e-9);
        klu_backend.drop(s);
    }
}

/* Chains beside each other: several right-hand sides as one by one, blocks and growth counted, the pattern analysed
 * again only when what lives has changed. */
TEST(beside)
{
    enum { K = 2, N = 7, SIZE = 6 * K * N, COUNT = 3 };
    uint64_t seed = 21;
    Beside b = beside_new(K, N, 0, N, &seed);
    const NewtonMatrix m = matrix_of(&b, 1);
    LinSolver *const s = solver_new(&m, LIN_BLOCK_SPARSE, 0), *const plain = solver_new(
                                                                  &(NewtonMatrix){.chain = b.chain}, LIN_BLOCK, 0);
    for (int again = 0; again < 3; ++again) assert_int_equal(factored(s, &m).analyses, 1);
    const LinStats stats = factored(s, &m);
    assert_string_equal(stats.ordering, "along");
    check_above(stats.growth, 0.1);
    check_at_most(stats.growth, 1);
    /* the chains' own blocks and those between them are all in the factors, which are at most full */
    check_at_least(stats.nonzeros, 36L * (K * N + 2 * K * (N - 1) + 2 * (3 * N - 2)));
    check_at_most(stats.nonzeros, 36L * K * N * K * N);
    assert_int_equal(stats.nonzeros % 36, 0);
    double *const r = fixture_vector(COUNT * SIZE, &seed), all[COUNT * SIZE];
    memcpy(all, r, sizeof all);
    assert_int_equal(linsolver_solve_many(s, COUNT, all), 0);
    for (int k = 0; k < COUNT; ++k) {
        check_below(fixture_backward_error(&m, all + k * SIZE, r + k * SIZE), 1e-14);
        assert_int_equal(linsolver_solve(s, r + k * SIZE), 0);
        assert_memory_equal(r + k * SIZE, all + k * SIZE, SIZE * sizeof *r);
    }
    unsigned char none[6 * K * K * N];
    memcpy(none, b.live, (size_t)b.count);
    memset(b.live, 0, (size_t)b.count);
    assert_int_equal(factored(s, &m).analyses, 1); /* without any there is none to analyse */
    assert_int_equal(factored(s, &m).nonzeros, factored(plain, &(NewtonMatrix){.chain = b.chain}).nonzeros);
    memcpy(b.live, none, (size_t)b.count);
    assert_int_equal(factored(s, &m).analyses, 1); /* as before */
    b.live[0] = 0;
    b.live[1] = 0;
    assert_int_equal(factored(s, &m).analyses, 2);
    linsolver_free(s);
    linsolver_free(plain);
    free(r);
    beside_free(&b);
}

/* Chains that touch in few places, rings among them: what elimination fills is in the pattern, whatever the first row
 * couples with. */
TEST(rings)
{
    enum { MOST = 9, EXTRAS = 6 };
    uint64_t seed = 22;
    for (int n = 4; n <= MOST; ++n) {
        for (int trial = 0; trial < 40; ++trial) {
            BlockChain a;
            ExtraBlock extra[EXTRAS];
            double value[EXTRAS][36];
            fixture_chain_random(&a, n, 6, 30, &seed);
            for (int e = 0; e < EXTRAS; e += 2) {
                int i = (int)((fixture_random(&seed) + 1) / 2 * n) % n,
                    j = (int)((fixture_random(&seed) + 1) / 2 * n) % n;
                if (e == 0) i = 0, j = n - 1;
                if (abs(i - j) < 2) i = 0, j = n - 1;
                for (int k = 0; k < 2; ++k) {
                    fixture_fill(value[e + k], 36, 1, &seed);
                    extra[e + k] = (ExtraBlock){.row = k ? j : i, .col = k ? i : j, .block = value[e + k]};
                }
            }
            if (trial % 4 == 3) { /* row 0 by itself */
                memset(a.lower + 36, 0, 36 * sizeof(double));
                memset(a.upper, 0, 36 * sizeof(double));
                for (int e = 0; e < EXTRAS; ++e) {
                    if (extra[e].row == 0) extra[e].row = extra[e].col == n - 1 ? 1 : n - 1;
                    if (extra[e].col == 0) extra[e].col = extra[e].row == n - 1 ? 1 : n - 1;
                }
            }
            const NewtonMatrix m = {.chain = a, .extras = trial % 4 ? EXTRAS : 2, .extra = extra};
            double *const r = fixture_vector(6 * n, &seed), x[6 * MOST];
            memcpy(x, r, (size_t)(6 * n) * sizeof *r);
            LinSolver *const s = solver_new(&m, LIN_BLOCK_SPARSE, 0);
            const LinStats stats = factored(s, &m);
            assert_int_equal(stats.fallbacks, 0);
            assert_int_equal(linsolver_solve(s, x), 0);
            check_below(fixture_backward_error(&m, x, r), 1e-14);
            /* a ring alone: each row but the last two fills one block to either side */
            if (trial % 4 == 0) assert_int_equal(stats.nonzeros, 36L * (n + 2 * (2 * n - 3)));
            linsolver_free(s);
            free(r);
            block_chain_free(&a);
        }
    }
}

/* Two threads count what one does. */
TEST(counts_of_two_threads)
{
    enum { N = 700 };
    uint64_t seed = 4;
    BlockChain a;
    fixture_chain_random(&a, N, 6, 0, &seed);
    for (int i = 0; i < N; ++i) {
        fixture_fill(a.diag + i * 36, 36, 0.01, &seed);
        for (int c = 0; c < 6; ++c) a.diag[i * 36 + c * 6 + (c + i % 2) % 6] = 20 + c; /* every other is pivoted */
    }
    LinStats one, two;
    for (int threads = 1; threads <= 2; ++threads) {
        LinSolver *const s = linsolver_new(&a, &(LinOptions){.kind = LIN_BLOCK, .threads = threads}, NULL);
        assert_int_equal(linsolver_factor(s, &a), 0);
        linsolver_stats(s, threads == 1 ? &one : &two);
        linsolver_free(s);
    }
    assert_int_equal(one.pivoted, N / 2);
    assert_int_equal(two.pivoted, N / 2);
    check_equal(one.growth, two.growth);
    block_chain_free(&a);
}
