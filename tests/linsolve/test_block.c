/* The block LU itself: instruction sets, threads, pivoting, and when it hands over to KLU. */

#include "linsolve/block/block_factor.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

/* Every instruction set that this machine has solves the same systems; two of them differ by rounding only. */
static void instruction_sets(void **state)
{
    (void)state;
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
static void threads(void **state)
{
    (void)state;
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
static void pivoting(void **state)
{
    (void)state;
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
static void fallback_singular_block(void **state)
{
    (void)state;
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
static void growth(void **state)
{
    (void)state;
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
static void cable_is_easy(void **state)
{
    (void)state;
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
static void unused_blocks(void **state)
{
    (void)state;
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

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(instruction_sets), cmocka_unit_test(threads),       cmocka_unit_test(pivoting),
        cmocka_unit_test(growth),           cmocka_unit_test(cable_is_easy), cmocka_unit_test(fallback_singular_block),
        cmocka_unit_test(unused_blocks),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
