/* The block LU itself: instruction sets, threads, pivoting, and when it hands over to KLU. */

#include "linsolve/block_factor.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

/* Every instruction set that this machine has solves the same systems; two of them differ by rounding only. */
TEST(instruction_sets)
{
    uint64_t seed = 1;
    for (int b = 3; b <= 6; b += 3) {
        for (int n = 1; n < 12; ++n) {
            BlockChain a;
            fixture_chain_cable(&a, n, b, 0.005, &seed);
            const NewtonMatrix m = {.chain = a};
            double *const r = fixture_vector(5 * n * b, &seed), *const x = malloc((size_t)(5 * n * b) * sizeof(double));
            for (int isa = ISA_GENERIC; isa <= (int)isa_best(); ++isa) {
                BlockSolver s;
                assert_true(block_solver_init(&s, n, b, (Isa)isa, 1e6, NULL));
                assert_int_equal(block_solver_factor(&s, &a), 0);
                memcpy(x, r, (size_t)(5 * n * b) * sizeof(double));
                block_solver_solve(&s, 5, x);
                for (int k = 0; k < 5; ++k) {
                    check_below(fixture_backward_error(&m, x + k * n * b, r + k * n * b), 1e-15);
                }
                block_solver_release(&s);
            }
            free(r);
            free(x);
            block_chain_free(&a);
        }
    }
}

static void solve_into(const BlockChain *a, Team *team, int count, const double *r, double *x)
{
    BlockSolver s;
    assert_true(block_solver_init(&s, a->n, a->b, isa_best(), 1e6, team));
    assert_int_equal(block_solver_factor(&s, a), 0);
    memcpy(x, r, (size_t)(count * a->n * a->b) * sizeof(double));
    block_solver_solve(&s, count, x);
    block_solver_release(&s);
}

/* Two threads give the bits of one, on both sides of the lengths where the second thread comes in. */
TEST(threads)
{
    static const int sizes[] = {1, 2, 299, 300, 301, 599, 600, 2001, 3401};
    Team *team = team_new(2);
    uint64_t seed = 2;
    for (int b = 3; b <= 6; b += 3) {
        for (size_t k = 0; k < sizeof sizes / sizeof sizes[0]; ++k) {
            enum { COUNT = 6 };
            BlockChain a;
            fixture_chain_cable(&a, sizes[k], b, 0.005, &seed);
            const size_t values = (size_t)(COUNT * sizes[k] * b);
            double *const r = fixture_vector((int)values, &seed), *const one = malloc(values * sizeof *one),
                          *const two = malloc(values * sizeof *two);
            solve_into(&a, NULL, COUNT, r, one);
            for (int again = 0; again < 20; ++again) {
                solve_into(&a, team, COUNT, r, two);
                assert_memory_equal(one, two, values * sizeof *one);
            }
            free(r);
            free(one);
            free(two);
            block_chain_free(&a);
        }
    }
    team = team_free(team);
}

static LinSolver *block_new(const BlockChain *a, double growth_limit)
{
    LinSolver *const s =
        linsolver_new(a, &(LinOptions){.kind = LIN_BLOCK, .threads = 1, .growth_limit = growth_limit}, NULL);
    assert_non_null(s);
    return s;
}

/* Solves and checks the backward error; returns the statistics. */
static LinStats solve_well(LinSolver *s, const BlockChain *a, double most)
{
    uint64_t seed = 3;
    LinStats stats;
    const NewtonMatrix m = {.chain = *a};
    double *const r = fixture_vector(a->n * a->b, &seed), *const x = malloc((size_t)(a->n * a->b) * sizeof(double));
    memcpy(x, r, (size_t)(a->n * a->b) * sizeof(double));
    assert_int_equal(linsolver_factor(s, a), 0);
    assert_int_equal(linsolver_solve(s, x), 0);
    check_below(fixture_backward_error(&m, x, r), most);
    free(r);
    free(x);
    linsolver_stats(s, &stats);
    return stats;
}

/* Diagonal blocks that are permutations have zeros where the fast path wants its pivots. */
TEST(pivoting)
{
    uint64_t seed = 4;
    for (int b = 3; b <= 6; b += 3) {
        BlockChain a;
        fixture_chain_random(&a, 9, b, 0, &seed);
        for (int i = 0; i < 9; ++i) {
            fixture_fill(a.diag + i * b * b, b * b, 0.01, &seed);
            for (int c = 0; c < b; ++c) a.diag[i * b * b + c * b + (c + 1 + i % 2) % b] = 20 + c;
        }
        LinSolver *const s = block_new(&a, 0);
        const LinStats stats = solve_well(s, &a, 1e-15);
        assert_int_equal(stats.pivoted, 9);
        assert_int_equal(stats.fallbacks, 0);
        linsolver_free(s);
        block_chain_free(&a);
    }
}

/* Pivot blocks that are zero, in a matrix that is not singular: KLU takes over, and gives back. */
TEST(fallback_singular_block)
{
    uint64_t seed = 5;
    BlockChain a, good;
    fixture_chain_random(&a, 6, 6, 0, &seed);
    fixture_chain_random(&good, 6, 6, 12, &seed);
    memset(a.diag, 0, 36 * sizeof(double));
    LinSolver *const s = block_new(&a, 0);
    assert_int_equal(solve_well(s, &a, 1e-11).fallbacks, 1);
    assert_int_equal(solve_well(s, &good, 1e-14).fallbacks, 1);
    const LinStats stats = solve_well(s, &a, 1e-11);
    assert_int_equal(stats.fallbacks, 2);
    assert_string_equal(stats.name, "block");
    linsolver_free(s);
    block_chain_free(&a);
    block_chain_free(&good);
}

/* A pivot block of 1e-9 makes the next one grow to 1e9: too much by default, allowed on request. */
TEST(growth)
{
    uint64_t seed = 6;
    BlockChain a;
    fixture_chain_random(&a, 5, 6, 3, &seed);
    for (int k = 0; k < 36; ++k) a.diag[k] *= 1e-9;
    LinSolver *s = block_new(&a, 0);
    assert_int_equal(solve_well(s, &a, 1e-12).fallbacks, 1);
    s = linsolver_free(s);
    s = block_new(&a, 1e20);
    const LinStats stats = solve_well(s, &a, 1e-5);
    assert_int_equal(stats.fallbacks, 0);
    check_between(stats.growth, 1e-12, 1e-7);
    linsolver_free(s);
    block_chain_free(&a);
}

/* A cable needs neither pivoting nor KLU, and nothing grows. */
TEST(cable_is_easy)
{
    for (double gamma = 1e-6; gamma < 1; gamma *= 10) {
        uint64_t seed = 7;
        BlockChain a;
        fixture_chain_cable(&a, 100, 6, gamma, &seed);
        LinSolver *const s = block_new(&a, 0);
        const LinStats stats = solve_well(s, &a, 1e-15);
        assert_int_equal(stats.pivoted, 0);
        assert_int_equal(stats.fallbacks, 0);
        check_above(stats.growth, 0.5);
        linsolver_free(s);
        block_chain_free(&a);
    }
}

/* The blocks beyond both ends are not looked at. */
TEST(unused_blocks)
{
    uint64_t seed = 8;
    for (int n = 1; n < 5; ++n) {
        BlockChain a;
        fixture_chain_cable(&a, n, 6, 0.005, &seed);
        for (int k = 0; k < 36; ++k) a.lower[k] = a.upper[36 * (n - 1) + k] = NAN;
        LinSolver *const s = block_new(&a, 0);
        assert_int_equal(solve_well(s, &a, 1e-15).fallbacks, 0);
        linsolver_free(s);
        block_chain_free(&a);
    }
}

/* r - A x */
static void residual_of(const BlockChain *a, const double *x, const double *r, double *out)
{
    const NewtonMatrix m = {.chain = *a};
    memcpy(out, r, (size_t)(a->n * a->b) * sizeof *out);
    for (int k = 0; k < newton_pieces(&m); ++k) {
        const Piece p = newton_piece(&m, k);
        for (int c = 0; c < p.cols; ++c) {
            for (int i = 0; i < p.rows; ++i) out[p.row + i] -= p.value[c * p.rows + i] * x[p.col + c];
        }
    }
}

/* The largest |x - y| over the largest |y|. */
static double apart(int count, const double *x, const double *y)
{
    double most = 0;
    for (int k = 0; k < count; ++k) most = larger_of(most, fabs(x[k] - y[k]));
    return most / fixture_norm(count, y);
}

/* One matrix of a cable, a solution whose factors were rounded and KLU's. */
typedef struct Rounding {
    int size;
    BlockChain a;
    LinSolver *rough;
    double *r, *x, *exact, *left;
} Rounding;

static void rounding_new(Rounding *t, int n, int b, double gamma)
{
    uint64_t seed = 9;
    const LinOptions options = {.kind = LIN_BLOCK, .threads = 1};
    fixture_chain_cable(&t->a, n, b, gamma, &seed);
    t->size = n * b;
    t->r = fixture_vector(t->size, &seed);
    for (int k = 0; k < t->size; ++k) t->r[k] = 1 + 0.1 * t->r[k];
    t->x = malloc((size_t)t->size * sizeof(double));
    t->exact = malloc((size_t)t->size * sizeof(double));
    t->left = malloc((size_t)t->size * sizeof(double));
    LinSolver *klu = linsolver_new(&t->a, &(LinOptions){.kind = LIN_KLU, .ordering = ORDER_AMD}, NULL);
    t->rough = linsolver_new(&t->a, &options, NULL);
    assert_true(t->rough && klu && t->x && t->exact && t->left);
    memcpy(t->exact, t->r, (size_t)t->size * sizeof(double));
    memcpy(t->x, t->r, (size_t)t->size * sizeof(double));
    assert_int_equal(linsolver_factor(klu, &t->a), 0);
    assert_int_equal(linsolver_solve(klu, t->exact), 0);
    linsolver_rough(t->rough, 1);
    assert_int_equal(linsolver_factor(t->rough, &t->a), 0);
    assert_int_equal(linsolver_solve(t->rough, t->x), 0);
    linsolver_free(klu);
}

static void rounding_free(Rounding *t)
{
    linsolver_free(t->rough);
    free(t->r);
    free(t->x);
    free(t->exact);
    free(t->left);
    block_chain_free(&t->a);
}

/* x + the solution of what x leaves: a Newton iteration of a linear system. */
static void refine(Rounding *t)
{
    residual_of(&t->a, t->x, t->r, t->left);
    assert_int_equal(linsolver_solve(t->rough, t->left), 0);
    for (int k = 0; k < t->size; ++k) t->x[k] += t->left[k];
}

static double backward_error(const Rounding *t)
{
    return fixture_backward_error(&(NewtonMatrix){.chain = t->a}, t->x, t->r);
}

/* Factors of a long chain, rounded: the solution is that of a matrix whose entries are off by single precision's
 * rounding (L20); a correction leaves 1e-3 of that and of the error at most, and after two of them it is as good as
 * KLU's. */
TEST(rounded)
{
    static const double gamma[] = {1e-4, 3e-3, 0.05, 1}, unit = 6e-8; /* s; half of FLT_EPSILON */
    for (int b = 3; b <= 6; b += 3) {
        for (int k = 0; k < 4; ++k) {
            Rounding t;
            rounding_new(&t, LIN_ROUND_ENTRIES / (b * b), b, gamma[k]);
            const double error = apart(t.size, t.x, t.exact), backward = backward_error(&t);
            check_between(backward, 0.1 * unit, 3 * unit);
            check_below(error, 100 * unit);
            refine(&t);
            check_below(apart(t.size, t.x, t.exact), 2e-3 * error);
            check_below(backward_error(&t), 1e-3 * backward);
            refine(&t);
            check_below(backward_error(&t), 1e-14);
            rounding_free(&t);
        }
    }
}

/* Where it is not asked for, not wanted, or the chain is short, nothing is rounded. */
TEST(not_rounded)
{
    static const struct {
        int rough, precise, shorter;
    } ways[] = {{0, 0, 0}, {1, 1, 0}, {1, 0, 1}};
    for (int k = 0; k < 3; ++k) {
        uint64_t seed = 10;
        BlockChain a;
        fixture_chain_cable(&a, LIN_ROUND_ENTRIES / 36 - ways[k].shorter, 6, 0.01, &seed);
        LinSolver *const s =
            linsolver_new(&a, &(LinOptions){.kind = LIN_BLOCK, .threads = 1, .precise = ways[k].precise}, NULL);
        assert_int_equal(linsolver_factor(s, &a), 0);
        linsolver_rough(s, ways[k].rough);
        solve_well(s, &a, 1e-15);
        linsolver_rough(s, 1);
        assert_int_equal(linsolver_factor(s, &a), 0);
        solve_well(s, &a, 1e-15); /* what is asked for holds for one factorisation */
        linsolver_free(s);
        block_chain_free(&a);
    }
}

/* Rows that come and go. */
typedef struct Rows {
    int n, b;
    const double *r;
    double *x, *out;
    int *filled, *taken;
} Rows;

static void rows_fill(void *user, LinSide side, int from, int to)
{
    const Rows *const t = user;
    const LinSeam seam = lin_seam(t->n);
    if (side == LIN_TOP) assert_true(to <= seam.from && (from == 0 || t->filled[from - 1]));
    if (side == LIN_BOTTOM) assert_true(from >= seam.to && (to == t->n || t->filled[to]));
    if (side == LIN_SEAM) assert_true(from == seam.from && to == seam.to);
    for (int i = from; i < to; ++i) ++t->filled[i];
    memcpy(t->x + from * t->b, t->r + from * t->b, (size_t)((to - from) * t->b) * sizeof(double));
}

static void rows_take(void *user, int from, int to)
{
    const Rows *const t = user;
    for (int i = from; i < to; ++i) ++t->taken[i];
    memcpy(t->out + from * t->b, t->x + from * t->b, (size_t)((to - from) * t->b) * sizeof(double));
}

static void stream_once(int n, int b, LinKind kind, int rough, Team *team)
{
    uint64_t seed = 11;
    BlockChain a;
    hawser_error err = {0};
    fixture_chain_cable(&a, n, b, 0.005, &seed);
    const size_t bytes = (size_t)(n * b) * sizeof(double);
    double *const r = fixture_vector(n * b, &seed), *const whole = malloc(bytes);
    Rows rows = {.n = n, .b = b, .r = r, .x = malloc(bytes), .out = malloc(bytes)};
    rows.filled = calloc((size_t)n, sizeof(int));
    rows.taken = calloc((size_t)n, sizeof(int));
    LinSolver *s = linsolver_new(&a, &(LinOptions){.kind = kind, .threads = 1}, &err);
    if (!s) fail_msg("%s", err.message);
    linsolver_rough(s, rough);
    assert_int_equal(linsolver_factor(s, &a), 0);
    memcpy(whole, r, bytes);
    assert_int_equal(linsolver_solve(s, whole), 0);
    s = linsolver_free(s);
    s = linsolver_new(&a, &(LinOptions){.kind = kind, .threads = team ? 2 : 1, .team = team}, &err);
    linsolver_rough(s, rough);
    assert_int_equal(linsolver_factor(s, &a), 0);
    assert_int_equal(linsolver_stream(s, &(LinStream){&rows, rows_fill, rows_take}, rows.x), 0);
    assert_memory_equal(rows.out, whole, bytes);
    for (int i = 0; i < n; ++i) assert_true(rows.filled[i] == 1 && rows.taken[i] == 1);
    linsolver_free(s);
    free(r);
    free(whole);
    free(rows.x);
    free(rows.out);
    free(rows.filled);
    free(rows.taken);
    block_chain_free(&a);
}

/* Rows that come and go give the bits of a whole right-hand side, each of them once and in order, around lanes, tiles
 * and the lengths where the second thread comes in, rounded or not, and with a back end that needs all of them first.
 */
TEST(streams)
{
    static const int sizes[] = {999, 1000, 1001, 4096, 8191, 8193, 12100};
    Team *team = team_new(2);
    for (int b = 3; b <= 6; b += 3) {
        for (int n = 1; n < 50; ++n) stream_once(n, b, LIN_BLOCK, 0, NULL);
        for (int k = 0; k < 7; ++k) {
            for (int rough = 0; rough < 2; ++rough) {
                stream_once(sizes[k], b, LIN_BLOCK, rough, NULL);
                stream_once(sizes[k], b, LIN_BLOCK, rough, team);
            }
        }
        stream_once(77, b, LIN_KLU, 1, NULL);
    }
    team = team_free(team);
}
