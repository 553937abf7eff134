/* What a linear solver leaves for a run that goes on: read into a solver that has seen nothing, it solves with the same
 * bits and goes on with the same bits and counts; what cannot be is refused. */
#include <stdint.h>

#include "linsolve/linsolve.h"
#include "tests/linsolve/beside_fixture.h"
#include "tests/support/check.h"

enum { ROWS = 9, SIZE = 6 * ROWS };

static LinSolver *solver_for(const NewtonMatrix *a, LinKind kind, LinOrdering ordering)
{
    hawser_error err = {0};
    const LinOptions options = {.kind = kind, .ordering = ordering, .threads = 1};
    LinSolver *const s = linsolver_new_newton(a, &options, &err);
    if (!s) fail_msg("%s", err.message);
    return s;
}

static int factored(LinSolver *s, const NewtonMatrix *a) { return linsolver_factor_newton(s, a); }

static Checkpoint written(LinSolver *s, const NewtonMatrix *a)
{
    Checkpoint c = checkpoint_new(0);
    linsolver_checkpoint(&c, s, a);
    c = checkpoint_new(c.size);
    linsolver_checkpoint(&c, s, a);
    assert_int_equal(c.status, HAWSER_OK);
    return c;
}

static void same_solution(LinSolver *one, LinSolver *two, int size)
{
    uint64_t seed = 5;
    double *const x = fixture_vector(2 * size, &seed), *const y = malloc((size_t)(2 * size) * sizeof *y);
    memcpy(y, x, (size_t)(2 * size) * sizeof *y);
    assert_int_equal(linsolver_solve_many(one, 2, x), 0);
    assert_int_equal(linsolver_solve_many(two, 2, y), 0);
    assert_memory_equal(x, y, (size_t)(2 * size) * sizeof *y);
    free(x);
    free(y);
}

static void same_stats(const LinSolver *one, const LinSolver *two)
{
    LinStats a, b;
    linsolver_stats(one, &a);
    linsolver_stats(two, &b);
    assert_string_equal(a.name, b.name);
    assert_string_equal(a.ordering, b.ordering);
    assert_string_equal(a.why, b.why);
    assert_int_equal(a.factors, b.factors);
    assert_int_equal(a.refactors, b.refactors);
    assert_int_equal(a.fallbacks, b.fallbacks);
    assert_int_equal(a.solves, b.solves);
    assert_int_equal(a.pivoted, b.pivoted);
    assert_int_equal(a.nonzeros, b.nonzeros);
    check_equal(a.growth, b.growth);
}

/* A solver for the pattern of a[0] factors the first `count` of a; read into another one for that pattern, both solve
 * and go on with a[last] alike. */
static void goes_on(const NewtonMatrix *const *a, int count, int last, int size, LinKind kind, LinOrdering ordering)
{
    LinSolver *const s = solver_for(a[0], kind, ordering), *const to = solver_for(a[0], kind, ordering);
    for (int k = 0; k < count; ++k) assert_int_equal(factored(s, a[k]), 0);
    const NewtonMatrix *const now = a[count > 0 ? count - 1 : 0];
    Checkpoint c = written(s, now), back = checkpoint_over(c.bytes, c.size, NULL);
    linsolver_checkpoint(&back, to, now);
    checkpoint_end(&back);
    if (back.status) fail_msg("%s: %s", linsolver_kind_name(kind), back.fault);
    checkpoint_free(&c);
    same_stats(s, to);
    if (count > 0) {
        same_solution(s, to, size);
    } else {
        check_above(linsolver_solve(to, (double[SIZE]){0}), 0); /* nothing is factored there either */
    }
    assert_int_equal(factored(s, a[last]), 0);
    assert_int_equal(factored(to, a[last]), 0);
    same_solution(s, to, size);
    same_stats(s, to);
    linsolver_free(s);
    linsolver_free(to);
}

/* The cable at three step sizes; KLU keeps the pivots of the first. */
TEST(chains)
{
    static const double gamma[] = {0.02, 0.005, 0.001};
    BlockChain chain[3];
    NewtonMatrix m[3];
    const NewtonMatrix *a[3];
    for (int k = 0; k < 3; ++k) {
        uint64_t seed = 1;
        fixture_chain_cable(&chain[k], ROWS, 6, gamma[k], &seed);
        m[k] = (NewtonMatrix){.chain = chain[k]};
        a[k] = &m[k];
    }
    for (int count = 0; count < 3; ++count) {
        static const LinKind kinds[] = {LIN_AUTO, LIN_BLOCK, LIN_BORDERED, LIN_BLOCK_SPARSE};
        for (size_t k = 0; k < sizeof kinds / sizeof *kinds; ++k) goes_on(a, count, 2, SIZE, kinds[k], ORDER_AUTO);
        for (LinOrdering o = ORDER_AUTO; o <= ORDER_METIS; ++o) goes_on(a, count, 2, SIZE, LIN_KLU, o);
    }
    for (int k = 0; k < 3; ++k) block_chain_free(&chain[k]);
}

/* Leaves that have moved since the solver was made, by one place each time. */
TEST(leaves)
{
    enum { LEAVES = 3, PLACES = 3, WHOLE = SIZE + LEAVES * 2 };
    uint64_t seed = 2;
    Leaf leaf[PLACES][LEAVES];
    NewtonMatrix m[PLACES];
    const NewtonMatrix *a[PLACES];
    BlockChain chain;
    double *value[LEAVES];
    fixture_chain_cable(&chain, ROWS, 6, 0.005, &seed);
    for (int l = 0; l < LEAVES; ++l) value[l] = fixture_vector(4 + 4 * 12, &seed);
    for (int l = 0; l < LEAVES; ++l) value[l][0] += 9, value[l][3] += 9;
    for (int p = 0; p < PLACES; ++p) {
        for (int l = 0; l < LEAVES; ++l) {
            double *const v = value[l];
            leaf[p][l] = (Leaf){.size = 2, .at = 2 * l + p, .touches = l == 1 ? p : 2, .diag = v};
            for (int k = 0; k < 2; ++k) {
                leaf[p][l].into[k] = v + 4 + 24 * k;
                leaf[p][l].from[k] = v + 16 + 24 * k;
            }
        }
        m[p] = (NewtonMatrix){.chain = chain, .leaves = LEAVES, .leaf = leaf[p]};
        a[p] = &m[p];
    }
    for (int count = 1; count <= PLACES; ++count) {
        goes_on(a, count, PLACES - 1, WHOLE, LIN_AUTO, ORDER_AUTO);
        goes_on(a, count, 0, WHOLE, LIN_KLU, ORDER_AMD);
    }
    for (int l = 0; l < LEAVES; ++l) free(value[l]);
    block_chain_free(&chain);
}

/* Chains that touch: the pattern of now is found again. */
TEST(chains_beside)
{
    enum { N = 6 };
    uint64_t seed = 3;
    Beside b[2] = {beside_new(2, N, 0, N, &seed), beside_new(2, N, 0, N, &seed)};
    memset(b[0].live + b[0].count / 2, 0, (size_t)(b[0].count - b[0].count / 2));
    for (int e = b[0].count / 2; e < b[0].count; ++e) memset(b[0].value + BLOCK * e, 0, BLOCK * sizeof(double));
    const NewtonMatrix m[] = {matrix_of(&b[0], 1), matrix_of(&b[1], 1)};
    const NewtonMatrix *const a[] = {&m[0], &m[1]};
    goes_on(a, 1, 1, 12 * N, LIN_BLOCK_SPARSE, ORDER_AUTO);
    goes_on(a, 2, 0, 12 * N, LIN_BLOCK_SPARSE, ORDER_AUTO);
    beside_free(&b[0]);
    beside_free(&b[1]);
}

/* What the block LU gave up on: KLU, which solves instead of it, is there again. */
TEST(helped)
{
    uint64_t seed = 5;
    BlockChain hard, good;
    fixture_chain_random(&hard, ROWS, 6, 0, &seed);
    fixture_chain_random(&good, ROWS, 6, 12, &seed);
    memset(hard.diag, 0, 36 * sizeof(double));
    const NewtonMatrix m[] = {{.chain = hard}, {.chain = good}};
    const NewtonMatrix *const a[] = {&m[0], &m[1]};
    LinStats stats, klu;
    LinSolver *const s = solver_for(a[0], LIN_BLOCK, ORDER_AUTO), *const k = solver_for(a[0], LIN_KLU, ORDER_AMD);
    assert_int_equal(factored(s, a[0]), 0);
    assert_int_equal(factored(k, a[0]), 0);
    linsolver_stats(s, &stats);
    linsolver_stats(k, &klu);
    assert_int_equal(stats.fallbacks, 1);
    assert_int_equal(stats.nonzeros, klu.nonzeros); /* of the factors that are used */
    check_equal(stats.growth, klu.growth);
    linsolver_free(s);
    linsolver_free(k);
    goes_on(a, 1, 1, SIZE, LIN_BLOCK, ORDER_AUTO);
    goes_on(a, 2, 0, SIZE, LIN_BLOCK, ORDER_AUTO); /* helped once, and then not */
    block_chain_free(&hard);
    block_chain_free(&good);
}

/* ------------------------------------------------------------------------------------------------- what is damaged */

/* The start of piece k: a head of two words, then the bytes in whole words. */
static unsigned char *piece(const Checkpoint *c, int k)
{
    size_t at = 0;
    for (;; --k) {
        uint64_t size;
        memcpy(&size, c->bytes + at + 8, sizeof size);
        if (k == 0) return c->bytes + at + 16;
        at += 16 + (size + 7) / 8 * 8;
    }
}

/* Pieces of a solver with KLU. */
enum { READY, BACKUP_USED, WAS_ROUGH, STATS, FACTORED, AGAIN, DECIDED, CANDIDATE, VALUES };

/* What is said of a checkpoint read into a new solver for a, with piece k an int of this value; NULL: all is well. */
static const char *fault_of(const NewtonMatrix *a, LinKind kind, int factorings, int k, int value,
                            const NewtonMatrix *with)
{
    static char fault[sizeof((Checkpoint *)NULL)->fault];
    LinSolver *const s = solver_for(a, kind, ORDER_AMD), *const to = solver_for(a, kind, ORDER_AMD);
    for (int i = 0; i < factorings; ++i) assert_int_equal(factored(s, a), 0);
    Checkpoint c = written(s, a);
    memcpy(piece(&c, k), &value, sizeof value);
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    linsolver_checkpoint(&back, to, with);
    memcpy(fault, back.fault, sizeof fault);
    checkpoint_free(&c);
    linsolver_free(s);
    linsolver_free(to);
    return back.status ? fault : NULL;
}

TEST(impossible)
{
    uint64_t seed = 6;
    BlockChain chain, zero;
    fixture_chain_random(&chain, ROWS, 6, 12, &seed);
    assert_true(block_chain_alloc(&zero, ROWS, 6));
    const NewtonMatrix m = {.chain = chain}, none = {.chain = zero};
    const NewtonMatrix *const a = &m, *const nothing = &none;
    for (int value = 0; value < 4; ++value) assert_null(fault_of(a, LIN_KLU, 1, CANDIDATE, value, a));
    check_has(fault_of(a, LIN_KLU, 1, CANDIDATE, 4, a), "no such ordering");
    check_has(fault_of(a, LIN_KLU, 1, CANDIDATE, -1, a), "no such ordering");
    check_has(fault_of(a, LIN_KLU, 1, DECIDED, 0, a), "it has factors without an ordering");
    check_has(fault_of(a, LIN_KLU, 1, FACTORED, 0, a), "its Newton matrix has no factors");
    check_has(fault_of(a, LIN_KLU, 0, READY, 1, a), "its Newton matrix has no factors");
    assert_null(fault_of(a, LIN_KLU, 1, READY, 0, a));       /* the last one failed, those before it have left pivots */
    assert_null(fault_of(a, LIN_KLU, 1, AGAIN, 0, nothing)); /* the pivots' own values */
    check_has(fault_of(a, LIN_KLU, 2, AGAIN, 1, nothing), "its matrix cannot be factored");
    check_has(fault_of(a, LIN_KLU, 1, BACKUP_USED, 1, a), "nothing solves its Newton matrix");
    check_has(fault_of(a, LIN_BLOCK, 1, BACKUP_USED, 1, a), "nothing solves its Newton matrix");
    assert_null(fault_of(a, LIN_BLOCK, 1, READY, 1, a));
    assert_null(fault_of(a, LIN_BLOCK, 1, READY, 0, nothing));
    check_has(fault_of(a, LIN_BLOCK, 1, READY, 1, nothing), "its Newton matrix cannot be factored");

    LinSolver *const s = solver_for(a, LIN_KLU, ORDER_AMD), *const to = solver_for(a, LIN_KLU, ORDER_AMD);
    assert_int_equal(factored(s, a), 0);
    Checkpoint c = written(s, a);
    memset(piece(&c, VALUES), 0, (size_t)36 * sizeof(double));
    Checkpoint back = checkpoint_over(c.bytes, c.size, NULL);
    linsolver_checkpoint(&back, to, a);
    check_has(back.fault, "its matrix has no pivots");
    assert_int_equal(back.status, HAWSER_ERR_INPUT); /* no lack of memory */
    checkpoint_free(&c);
    linsolver_free(s);
    linsolver_free(to);
    block_chain_free(&chain);
    block_chain_free(&zero);
}
