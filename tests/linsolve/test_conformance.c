/* What every back end must do: solve well, say so when it cannot, and give the same bits for the same values. */
#include <float.h>
#include <lapacke.h>
#include <stdio.h>

#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

/* One way to solve a chain. */
typedef struct Way {
    const char *name;
    LinKind kind;
    LinOrdering ordering;
    int threads;
    int most_rows; /* longest chain that it is asked to solve here */
} Way;

static const Way ways[] = {{"auto", LIN_AUTO, ORDER_AUTO, 1, 20000},
                           {"block", LIN_BLOCK, ORDER_AUTO, 1, 20000},
                           {"block, two threads", LIN_BLOCK, ORDER_AUTO, 2, 20000},
                           {"bordered", LIN_BORDERED, ORDER_AUTO, 1, 20000},
                           {"block-sparse", LIN_BLOCK_SPARSE, ORDER_AUTO, 1, 20000},
                           {"klu", LIN_KLU, ORDER_AUTO, 1, 370},
                           {"klu amd", LIN_KLU, ORDER_AMD, 1, 20000},
                           {"klu colamd", LIN_KLU, ORDER_COLAMD, 1, 2000},
                           {"klu metis", LIN_KLU, ORDER_METIS, 1, 2000}};

enum { WAYS = sizeof ways / sizeof ways[0] };

/* A solver of one way for the pattern of one chain. */
typedef struct Subject {
    const Way *way;
    LinSolver *solver;
} Subject;

static Subject subject_new(const Way *way, const BlockChain *a)
{
    const LinOptions options = {.kind = way->kind, .ordering = way->ordering, .threads = way->threads};
    hawser_error err = {0};
    const Subject s = {way, linsolver_new(a, &options, &err)};
    if (!s.solver) fail_msg("%s: %s", way->name, err.message);
    return s;
}

static void subject_free(Subject *s) { linsolver_free(s->solver); }

static int subject_factor(Subject *s, const BlockChain *a) { return linsolver_factor(s->solver, a); }

/* A x = r solved into fresh memory, which the caller frees. */
static double *subject_solve(Subject *s, int size, const double *r)
{
    double *const x = malloc((size_t)size * sizeof *x);
    memcpy(x, r, (size_t)size * sizeof *x);
    assert_int_equal(linsolver_solve(s->solver, x), 0);
    return x;
}

/* LAPACK's dense solution, and the reciprocal of the condition number. */
static double *dense_solution(const BlockChain *a, const double *r, double *rcond)
{
    const NewtonMatrix m = {.chain = *a};
    const int n = a->n * a->b;
    double *const full = calloc((size_t)n * (size_t)n, sizeof(double)), *const x = malloc((size_t)n * sizeof(double));
    lapack_int *const pivot = malloc((size_t)n * sizeof *pivot);
    for (int k = 0; k < newton_pieces(&m); ++k) {
        const Piece p = newton_piece(&m, k);
        for (int c = 0; c < p.cols; ++c) {
            for (int i = 0; i < p.rows; ++i) full[(p.col + c) * n + p.row + i] = p.value[c * p.rows + i];
        }
    }
    memcpy(x, r, (size_t)n * sizeof(double));
    const double norm = LAPACKE_dlange(LAPACK_COL_MAJOR, '1', n, n, full, n);
    assert_int_equal(LAPACKE_dgesv(LAPACK_COL_MAJOR, n, 1, full, n, pivot, x, n), 0);
    LAPACKE_dgecon(LAPACK_COL_MAJOR, '1', n, full, n, norm, rcond);
    free(full);
    free(pivot);
    return x;
}

/* Every way solves a; the result is within `slack` rounding errors times the condition of the dense solution, and its
 * backward error within `backward`. */
static void check_against_dense(const BlockChain *a, double slack, double backward, uint64_t *seed)
{
    const NewtonMatrix m = {.chain = *a};
    const int size = a->n * a->b;
    double rcond, *const r = fixture_vector(size, seed), *const expected = dense_solution(a, r, &rcond);
    for (int w = 0; w < WAYS; ++w) {
        Subject s = subject_new(ways + w, a);
        assert_int_equal(subject_factor(&s, a), 0);
        double *const x = subject_solve(&s, size, r);
        double error = 0;
        for (int k = 0; k < size; ++k) error = larger_of(error, fabs(x[k] - expected[k]));
        error /= fixture_norm(size, expected);
        const double residual = fixture_backward_error(&m, x, r);
        if (!(error <= slack * DBL_EPSILON / rcond)) fail_msg("%s: error %g, rcond %g", ways[w].name, error, rcond);
        if (!(residual <= backward)) fail_msg("%s: backward error %g", ways[w].name, residual);
        free(x);
        subject_free(&s);
    }
    free(r);
    free(expected);
}

TEST(well_conditioned)
{
    static const int sizes[] = {1, 2, 3, 4, 7, 24};
    uint64_t seed = 1;
    for (int b = 3; b <= 6; b += 3) {
        for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
            BlockChain a;
            fixture_chain_random(&a, sizes[k], b, 2 * b, &seed);
            check_against_dense(&a, 10, 1e-14, &seed);
            block_chain_free(&a);
        }
    }
}

/* Nothing dominant: pivoting and, for the block LU, KLU's help are needed. */
TEST(random_blocks)
{
    uint64_t seed = 2;
    for (int n = 1; n <= 24; n += n < 4 ? 1 : 5) {
        BlockChain a;
        fixture_chain_random(&a, n, n % 2 ? 6 : 3, 0, &seed);
        check_against_dense(&a, 100, 1e-10, &seed);
        block_chain_free(&a);
    }
}

/* Two almost equal rows: condition number about 1e10. */
TEST(ill_conditioned)
{
    uint64_t seed = 3;
    for (int row = 0; row < 9; row += 4) {
        BlockChain a;
        fixture_chain_random(&a, 9, 6, 12, &seed);
        double *const blocks[3] = {a.lower, a.diag, a.upper};
        for (int d = 0; d < 3; ++d) {
            double *const block = blocks[d] + 36 * row;
            for (int c = 0; c < 6; ++c) block[6 * c + 3] = block[6 * c + 2] * (1 + 1e-10 * fixture_random(&seed));
        }
        check_against_dense(&a, 100, 1e-11, &seed);
        block_chain_free(&a);
    }
}

/* Rows and columns in units that differ by ten orders of magnitude. */
TEST(mixed_units)
{
    uint64_t seed = 4;
    BlockChain a;
    fixture_chain_random(&a, 12, 6, 12, &seed);
    double scale[12 * 6];
    for (int k = 0; k < 12 * 6; ++k) scale[k] = pow(10, 5 * fixture_random(&seed));
    double *const blocks[3] = {a.lower, a.diag, a.upper};
    for (int d = 0; d < 3; ++d) {
        for (int k = 0; k < 12 * 36; ++k) blocks[d][k] *= scale[6 * (k / 36) + k % 6];
    }
    check_against_dense(&a, 10, 1e-13, &seed);
    block_chain_free(&a);
}

/* The cable's Newton matrix at the lengths that matter, judged by the componentwise backward error. */
TEST(cable)
{
    static const int sizes[] = {1, 2, 3, 370, 20000};
    for (int b = 3; b <= 6; b += 3) {
        for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
            BlockChain a;
            uint64_t seed = 5;
            fixture_chain_cable(&a, sizes[k], b, 0.005, &seed);
            const NewtonMatrix m = {.chain = a};
            double *const r = fixture_vector(sizes[k] * b, &seed);
            for (int w = 0; w < WAYS; ++w) {
                if (sizes[k] > ways[w].most_rows) continue;
                Subject s = subject_new(ways + w, &a);
                assert_int_equal(subject_factor(&s, &a), 0);
                double *const x = subject_solve(&s, sizes[k] * b, r);
                const double residual = fixture_backward_error(&m, x, r);
                if (!(residual < 2e-15)) fail_msg("%s, n %d: backward error %g", ways[w].name, sizes[k], residual);
                free(x);
                subject_free(&s);
            }
            free(r);
            block_chain_free(&a);
        }
    }
}

/* Ways to spoil a matrix so that no solver may accept it. */
enum { SPOIL_ZERO, SPOIL_ROW, SPOIL_COLUMN, SPOIL_TWINS, SPOIL_NAN, SPOIL_INFINITE, SPOILS };

static void spoil(BlockChain *a, int how)
{
    const int b = a->b, bb = b * b, row = a->n / 2;
    if (how == SPOIL_ZERO) block_chain_zero(a);
    if (how == SPOIL_NAN) a->diag[row * bb + 1] = NAN;
    if (how == SPOIL_INFINITE) a->diag[row * bb] = INFINITY;
    for (int c = 0; c < b; ++c) {
        double *const blocks[3] = {a->lower + row * bb + c * b, a->diag + row * bb + c * b,
                                   a->upper + row * bb + c * b};
        for (int d = 0; d < 3; ++d) {
            if (how == SPOIL_ROW) blocks[d][1] = 0;
            if (how == SPOIL_TWINS) blocks[d][1] = blocks[d][0];
        }
    }
    if (how == SPOIL_COLUMN) {
        memset(a->diag + row * bb + b, 0, (size_t)b * sizeof(double));
        if (row > 0) memset(a->upper + (row - 1) * bb + b, 0, (size_t)b * sizeof(double));
        if (row + 1 < a->n) memset(a->lower + (row + 1) * bb + b, 0, (size_t)b * sizeof(double));
    }
}

/* A matrix that cannot be solved gives a status, and does no harm to the next one. */
TEST(singular)
{
    uint64_t seed = 6;
    for (int n = 1; n <= 8; n += n < 3 ? 1 : 5) {
        for (int how = 0; how < SPOILS; ++how) {
            BlockChain good, bad;
            fixture_chain_cable(&good, n, 6, 0.005, &seed);
            block_chain_alloc(&bad, n, 6);
            block_chain_copy(&bad, &good);
            spoil(&bad, how);
            const NewtonMatrix m = {.chain = good};
            double *const r = fixture_vector(6 * n, &seed);
            for (int w = 0; w < WAYS; ++w) {
                Subject s = subject_new(ways + w, &good);
                for (int first = 0; first < 2; ++first) { /* spoilt at once, and after a good one */
                    if (subject_factor(&s, &bad) <= 0) fail_msg("%s accepts spoilt matrix %d", ways[w].name, how);
                    check_above(linsolver_solve(s.solver, (double[48]){0}), 0);
                    assert_int_equal(subject_factor(&s, &good), 0);
                }
                double *const x = subject_solve(&s, 6 * n, r);
                check_below(fixture_backward_error(&m, x, r), 1e-14);
                free(x);
                subject_free(&s);
            }
            free(r);
            block_chain_free(&good);
            block_chain_free(&bad);
        }
    }
}

/* Singular but for rounding: either a status, or finite numbers with a small residual. */
TEST(nearly_singular)
{
    uint64_t seed = 7;
    for (int trial = 0; trial < 12; ++trial) {
        BlockChain a;
        fixture_chain_random(&a, 5, 6, 12, &seed);
        const double noise = pow(10, -10 - 0.6 * trial);
        double *const block = a.diag + 2 * 36;
        for (int c = 0; c < 6; ++c) {
            a.lower[2 * 36 + 6 * c + 1] = a.lower[2 * 36 + 6 * c];
            a.upper[2 * 36 + 6 * c + 1] = a.upper[2 * 36 + 6 * c];
            block[6 * c + 1] = block[6 * c] + noise * fixture_random(&seed);
        }
        const NewtonMatrix m = {.chain = a};
        double *const r = fixture_vector(30, &seed);
        for (int w = 0; w < WAYS; ++w) {
            Subject s = subject_new(ways + w, &a);
            if (subject_factor(&s, &a) == 0) {
                double *const x = subject_solve(&s, 30, r);
                const double error = fixture_backward_error(&m, x, r);
                if (!(error < 1e-9)) fail_msg("%s, noise %g: backward error %g", ways[w].name, noise, error);
                free(x);
            }
            subject_free(&s);
        }
        free(r);
        block_chain_free(&a);
    }
}

/* Other values in between leave no trace: the same matrix gives the same bits. */
TEST(repeatable)
{
    uint64_t seed = 8;
    BlockChain a, other;
    fixture_chain_cable(&a, 40, 6, 0.005, &seed);
    fixture_chain_cable(&other, 40, 6, 0.02, &seed);
    double *const r = fixture_vector(240, &seed);
    for (int w = 0; w < WAYS; ++w) {
        Subject s = subject_new(ways + w, &a);
        subject_factor(&s, &a); /* the first factorisation may choose pivots; those after it keep them */
        assert_int_equal(subject_factor(&s, &a), 0);
        double *const first = subject_solve(&s, 240, r);
        assert_int_equal(subject_factor(&s, &other), 0);
        assert_int_equal(subject_factor(&s, &a), 0);
        double *const again = subject_solve(&s, 240, r);
        assert_memory_equal(first, again, 240 * sizeof *first);
        free(first);
        free(again);
        subject_free(&s);
    }
    free(r);
    block_chain_free(&a);
    block_chain_free(&other);
}

/* Many right-hand sides at once come out as one by one. */
TEST(many_right_hand_sides)
{
    enum { COUNT = 9, SIZE = 11 * 6 };
    uint64_t seed = 9;
    BlockChain a;
    fixture_chain_cable(&a, 11, 6, 0.005, &seed);
    double *const r = fixture_vector(COUNT * SIZE, &seed);
    for (int w = 0; w < WAYS; ++w) {
        Subject s = subject_new(ways + w, &a);
        assert_int_equal(subject_factor(&s, &a), 0);
        double all[COUNT * SIZE];
        memcpy(all, r, sizeof all);
        assert_int_equal(linsolver_solve_many(s.solver, COUNT, all), 0);
        for (int k = 0; k < COUNT; ++k) {
            double *const x = subject_solve(&s, SIZE, r + k * SIZE);
            for (int i = 0; i < SIZE; ++i) check_close(x[i], all[k * SIZE + i], 1e-13 * fabs(x[i]));
            free(x);
        }
        subject_free(&s);
    }
    free(r);
    block_chain_free(&a);
}

/* Segments join and leave as the pull goes on: solvers of several lengths live side by side. */
TEST(changing_patterns)
{
    enum { LENGTHS = 4 };
    uint64_t seed = 10;
    for (int w = 0; w < WAYS; ++w) {
        Subject s[LENGTHS];
        BlockChain a[LENGTHS];
        for (int k = 0; k < LENGTHS; ++k) {
            fixture_chain_cable(a + k, 3 + 7 * k, k % 2 ? 3 : 6, 0.005, &seed);
            s[k] = subject_new(ways + w, a + k);
        }
        for (int k = LENGTHS - 1; k >= 0; --k) assert_int_equal(subject_factor(s + k, a + k), 0);
        for (int k = 0; k < LENGTHS; ++k) {
            const int size = a[k].n * a[k].b;
            const NewtonMatrix m = {.chain = a[k]};
            double *const r = fixture_vector(size, &seed), *const x = subject_solve(s + k, size, r);
            check_below(fixture_backward_error(&m, x, r), 1e-14);
            free(r);
            free(x);
            subject_free(s + k);
            block_chain_free(a + k);
        }
    }
}

TEST(names)
{
    for (LinKind kind = LIN_AUTO; kind <= LIN_BLOCK_SPARSE; ++kind) {
        for (LinKind other = LIN_AUTO; other < kind; ++other) {
            assert_string_not_equal(linsolver_kind_name(kind), linsolver_kind_name(other));
        }
    }
}
