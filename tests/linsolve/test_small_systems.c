/* Systems whose factors are known in closed form: how much they fill, who gives up on them, what is said of them. */
#include <metis.h>
#include <stdio.h>

#include "linsolve/backend.h"
#include "linsolve/block.h"
#include "linsolve/block_factor.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/beside_fixture.h"
#include "tests/support/check.h"

static LinSolver *solver_of(const NewtonMatrix *m, LinKind kind)
{
    hawser_error err = {0};
    const LinOptions options = {.kind = kind, .ordering = ORDER_AMD, .threads = 1};
    LinSolver *const s = linsolver_new_newton(m, &options, &err);
    if (!s) fail_msg("%s", err.message);
    return s;
}

/* Factors and solves m, which it has to do to rounding; what the solver says then. */
static LinStats solved(LinSolver *s, const NewtonMatrix *m)
{
    enum { MOST = 600 };
    uint64_t seed = 31;
    const int size = newton_size(m);
    double x[MOST], *const r = fixture_vector(size, &seed);
    assert_in_range(size, 1, MOST);
    memcpy(x, r, (size_t)size * sizeof *r);
    assert_int_equal(linsolver_factor_newton(s, m), 0);
    assert_int_equal(linsolver_solve(s, x), 0);
    check_below(fixture_backward_error(m, x, r), 1e-13);
    free(r);
    LinStats stats;
    linsolver_stats(s, &stats);
    return stats;
}

/* A single leaf, which touches one block or two, wherever it is; a sparse solver takes its old pivots again while it
 * stays, and analyses anew where it goes. */
TEST(first_leaf)
{
    enum { N = 5, B = 3 };
    uint64_t seed = 3;
    BlockChain a;
    double diag[4] = {8, 0.3, -0.2, 7}, into[2][2 * B], from[2][2 * B];
    fixture_chain_random(&a, N, B, 5 * B, &seed);
    fixture_fill(into[0], 4 * B, 1, &seed);
    fixture_fill(from[0], 4 * B, 1, &seed);
    for (int touches = 1; touches <= 2; ++touches) {
        Leaf leaf = {.size = 2, .touches = touches, .diag = diag};
        for (int k = 0; k < touches; ++k) {
            leaf.into[k] = into[k];
            leaf.from[k] = from[k];
        }
        const NewtonMatrix m = {.chain = a, .leaves = 1, .leaf = &leaf};
        LinSolver *const bordered = solver_of(&m, LIN_BORDERED), *const klu = solver_of(&m, LIN_KLU);
        for (leaf.at = 0; leaf.at + touches <= N; ++leaf.at) {
            assert_int_equal(solved(bordered, &m).fallbacks, 0);
            const long before = solved(klu, &m).refactors;
            assert_int_equal(solved(klu, &m).refactors, before + 1);
            assert_int_equal(solved(klu, &m).refactors, before + 2);
        }
        linsolver_free(bordered);
        linsolver_free(klu);
    }
    block_chain_free(&a);
}

/* A row whose own block is zero has no pivot in it, though the whole can be solved: said at once, and what is done
 * instead solves it. */
TEST(row_without_pivot)
{
    enum { N = 3 };
    uint64_t seed = 4;
    for (int b = 3; b <= 6; b += 3) {
        for (int row = 0; row < b; ++row) {
            BlockChain a;
            fixture_chain_random(&a, N, b, 3 * b, &seed);
            for (int c = 0; c < b; ++c) a.diag[c * b + row] = 0;
            const NewtonMatrix m = {.chain = a};
            LinSolver *const s = solver_of(&m, LIN_BLOCK);
            assert_int_equal(solved(s, &m).fallbacks, 1);
            linsolver_free(s);
            block_chain_free(&a);
        }
    }
}

/* A block with a row of zeros is singular, and said to be, whichever row it is; the same with any other is not. */
TEST(row_of_zeros)
{
    enum { B = 6 };
    uint64_t seed = 8;
    for (int row = 0; row <= B; ++row) {
        double diag[B * B], after[B * B], front[3 * B * B], back[B * B];
        fixture_fill(diag, B * B, 1, &seed);
        fixture_fill(after, B * B, 1, &seed);
        for (int c = 0; c < B && row < B; ++c) diag[c * B + row] = 0;
        const BlockRow it = {diag, block_zero, after, block_zero, front, back};
        assert_int_equal(block_row_pivoted(&(BlockFactor){.b = B}, &it), row < B ? LIN_UNSTABLE : 0);
        if (row < B) continue;
        for (int k = 0; k < B * B; ++k) { /* diag V = after */
            double sum = 0;
            for (int j = 0; j < B; ++j) sum += diag[j * B + k % B] * back[k / B * B + j];
            check_close(sum, after[k], 1e-11);
        }
    }
}

/* KLU's factors of a full matrix have as many entries as it, those of a diagonal one its own. */
TEST(klu_entries)
{
    enum { N = 5 };
    for (int full = 0; full < 2; ++full) {
        int p[N + 1] = {0}, i[N * N];
        double x[N * N];
        for (int c = 0; c < N; ++c) {
            p[c + 1] = p[c];
            for (int r = 0; r < N; ++r) {
                if (!full && r != c) continue;
                i[p[c + 1]] = r;
                x[p[c + 1]++] = r == c ? 7 : 1.0 / (1 + r + c);
            }
        }
        const SparseMatrix a = {.n = N, .p = p, .i = i, .x = x};
        const LinOptions options = {.kind = LIN_KLU, .ordering = ORDER_AMD};
        void *const s = klu_backend.make(&(LinMatrix){.sparse = &a, .groups = a.n}, &options);
        LinStats stats;
        assert_int_equal(klu_backend.factor(s, &(LinMatrix){.sparse = &a}), 0);
        klu_backend.stats(s, &stats);
        assert_int_equal(stats.nonzeros, full ? N * N : N);
        klu_backend.drop(s);
    }
}

/* One unknown that couples with all others, which couple with it alone: taken last, nothing is filled, whichever of
 * them it is. */
TEST(hub_goes_last)
{
    enum { N = 12 };
    for (int hub = 0; hub < N; ++hub) {
        int p[N + 1] = {0}, i[3 * N];
        double x[3 * N];
        for (int c = 0; c < N; ++c) {
            p[c + 1] = p[c];
            for (int r = 0; r < N; ++r) {
                if (r != c && r != hub && c != hub) continue;
                i[p[c + 1]] = r;
                x[p[c + 1]++] = r == c ? 20 : 1;
            }
        }
        const SparseMatrix a = {.n = N, .p = p, .i = i, .x = x};
        const LinOptions options = {.kind = LIN_KLU, .ordering = ORDER_METIS};
        void *const s = klu_backend.make(&(LinMatrix){.sparse = &a, .groups = a.n}, &options);
        LinStats stats;
        assert_int_equal(klu_backend.factor(s, &(LinMatrix){.sparse = &a}), 0);
        klu_backend.stats(s, &stats);
        assert_string_equal(stats.ordering, "metis");
        assert_int_equal(stats.nonzeros, 3 * N - 2);
        klu_backend.drop(s);
    }
}

/* The order is METIS's own for the graph of what couples with what, whether the pattern has both ways of a coupling or
 * one: unknowns on a square, each with its four neighbours. */
TEST(order_of_a_square)
{
    enum { SIDE = 7, N = SIDE * SIDE };
    idx_t start[N + 1] = {0}, near[4 * N], weight[N], order[N], place[N], groups = N, options[METIS_NOPTIONS];
    for (int v = 0; v < N; ++v) {
        start[v + 1] = start[v];
        weight[v] = 1;
        if (v >= SIDE) near[start[v + 1]++] = v - SIDE;
        if (v % SIDE > 0) near[start[v + 1]++] = v - 1;
        if (v % SIDE < SIDE - 1) near[start[v + 1]++] = v + 1;
        if (v < N - SIDE) near[start[v + 1]++] = v + SIDE;
    }
    METIS_SetDefaultOptions(options);
    options[METIS_OPTION_NUMBERING] = 0;
    options[METIS_OPTION_SEED] = 1;
    assert_int_equal(METIS_NodeND(&groups, start, near, weight, options, order, place), METIS_OK);
    for (int ways = 0; ways < 3; ++ways) { /* all; rows below the diagonal; above it */
        int p[N + 1] = {0}, i[5 * N], perm[N];
        for (int v = 0; v < N; ++v) {
            p[v + 1] = p[v];
            for (idx_t e = start[v]; e < start[v + 1]; ++e) {
                if (ways == 0 || (near[e] > v) == (ways == 1)) i[p[v + 1]++] = (int)near[e];
            }
        }
        const SparseMatrix a = {.n = N, .p = p, .i = i};
        assert_int_equal(ordering_metis(&(LinMatrix){.sparse = &a, .groups = N}, perm), 0);
        for (int v = 0; v < N; ++v) assert_int_equal(perm[v], order[v]);
    }
}

/* Several chains say why they are solved as they are. */
TEST(says_why)
{
    enum { K = 3, N = 4 };
    uint64_t seed = 5;
    Beside b = beside_new(K, N, 0, N, &seed);
    const NewtonMatrix m = matrix_of(&b, 1);
    LinSolver *const s = solver_of(&m, LIN_BLOCK_SPARSE);
    char expected[128];
    /* between each two chains, both ways, rows i and i-1..i+1 */
    snprintf(expected, sizeof expected, "auto: several chains, %d couplings between them at most", 6 * (3 * N - 2));
    assert_string_equal(solved(s, &m).why, expected);
    linsolver_free(s);
    beside_free(&b);
}

/* Whatever lived before, the factors of what lives now have the entries and the bits of a solver that saw nothing
 * else: chains that come apart again, in any order. */
TEST(as_if_it_were_new)
{
    enum { K = 4, N = 6, SIZE = 6 * K * N, TRIALS = 60 };
    uint64_t seed = 6;
    Beside b = beside_new(K, N, 0, N, &seed);
    double *const all = malloc((size_t)b.count * BLOCK * sizeof *all);
    memcpy(all, b.value, (size_t)b.count * BLOCK * sizeof *all);
    const NewtonMatrix m = matrix_of(&b, 1);
    LinSolver *const s = solver_of(&m, LIN_BLOCK_SPARSE);
    for (int trial = 0; trial < TRIALS; ++trial) {
        const double share = fixture_random(&seed);
        for (int e = 0; e < b.count; e += 2) {
            const int lives = fixture_random(&seed) < share - 0.5;
            for (int way = e; way < e + 2; ++way) {
                b.live[way] = (unsigned char)lives;
                for (int k = 0; k < BLOCK; ++k) b.value[BLOCK * way + k] = lives ? all[BLOCK * way + k] : 0;
            }
        }
        LinSolver *const fresh = solver_of(&m, LIN_BLOCK_SPARSE);
        assert_int_equal(solved(s, &m).nonzeros, solved(fresh, &m).nonzeros);
        double x[SIZE], y[SIZE];
        for (int k = 0; k < SIZE; ++k) x[k] = y[k] = fixture_random(&seed);
        assert_int_equal(linsolver_solve(s, x), 0);
        assert_int_equal(linsolver_solve(fresh, y), 0);
        assert_memory_equal(x, y, sizeof x);
        linsolver_free(fresh);
    }
    linsolver_free(s);
    free(all);
    beside_free(&b);
}

/* The order of rows depends on what is coupled, not on what was before: rows in any number of parts, each of which the
 * order keeps together. */
TEST(order_forgets)
{
    enum { N = 12, TRIALS = 200 };
    uint64_t seed = 9;
    BlockPattern kept = {0};
    for (int trial = 0; trial < TRIALS; ++trial) {
        BlockPair pair[N * N];
        int count = 0, part[N];
        for (int i = 0; i < N; ++i) part[i] = i;
        for (int i = 0; i < N; ++i) {
            for (int j = i + 1; j < N; ++j) {
                if (fixture_random(&seed) > -0.9) continue;
                pair[count++] = (BlockPair){i, j};
                for (int k = 0, from = part[j], to = part[i]; k < N; ++k) part[k] = part[k] == from ? to : part[k];
            }
        }
        BlockPattern fresh = {0};
        assert_true(block_pattern_set(&kept, N, count, pair) && block_pattern_set(&fresh, N, count, pair));
        assert_memory_equal(kept.row, fresh.row, N * sizeof *kept.row);
        assert_memory_equal(kept.place, fresh.place, N * sizeof *kept.place);
        int changes = 0, parts = 0;
        for (int k = 0; k < N; ++k) {
            assert_int_equal(kept.place[kept.row[k]], k);
            changes += k > 0 && part[kept.row[k]] != part[kept.row[k - 1]];
            int first = 1;
            for (int i = 0; i < k; ++i) first &= part[i] != part[k];
            parts += first;
        }
        assert_int_equal(changes, parts - 1);
        block_pattern_free(&fresh);
    }
    block_pattern_free(&kept);
}
