/* What surrounds a chain: leaf bodies, a border, couplings anywhere; and what auto makes of it. */
#include <float.h>

#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"
#include "tests/support/check.h"

enum { LEAVES = LEAF_MAX, EXTRAS = 3 };

/* A NewtonMatrix that owns its values. */
typedef struct Scene {
    NewtonMatrix m;
    Leaf leaf[LEAVES];
    ExtraBlock extra[EXTRAS];
    double *value[5 * LEAVES + EXTRAS + 3];
    int values;
} Scene;

static double *scene_values(Scene *s, int count, uint64_t *seed)
{
    return s->value[s->values++] = fixture_vector(count, seed);
}

/* Leaves of 1..LEAF_MAX unknowns with 1 on the diagonal, touching none, one or two blocks. */
static void add_leaves(Scene *s, int count, uint64_t *seed)
{
    const int b = s->m.chain.b;
    for (int l = 0; l < count; ++l) {
        Leaf *const leaf = s->leaf + l;
        *leaf = (Leaf){.size = l + 1, .touches = l % 3, .at = l % 2 ? s->m.chain.n - l % 3 : 0};
        double *const diag = scene_values(s, leaf->size * leaf->size, seed);
        for (int k = 0; k < leaf->size; ++k) diag[k * (leaf->size + 1)] += 8;
        leaf->diag = diag;
        for (int k = 0; k < leaf->touches; ++k) {
            leaf->into[k] = scene_values(s, b * leaf->size, seed);
            leaf->from[k] = scene_values(s, b * leaf->size, seed);
        }
    }
    s->m.leaves = count;
    s->m.leaf = s->leaf;
}

static void add_border(Scene *s, int w, uint64_t *seed)
{
    const int m = newton_inner(&s->m);
    double *const corner = scene_values(s, w * w, seed);
    for (int k = 0; k < w; ++k) corner[k * (w + 1)] += 40;
    s->m.right = scene_values(s, m * w, seed);
    s->m.bottom = scene_values(s, m * w, seed);
    s->m.corner = corner;
    s->m.border = w;
}

/* Blocks far from the diagonal, one of them twice. */
static void add_extras(Scene *s, int count, uint64_t *seed)
{
    const int b = s->m.chain.b, n = s->m.chain.n;
    for (int k = 0; k < count; ++k) {
        s->extra[k] = (ExtraBlock){.row = k ? n - 1 : 0, .col = k ? 0 : n - 1, .block = scene_values(s, b * b, seed)};
    }
    s->m.extras = count;
    s->m.extra = s->extra;
}

static void scene_init(Scene *s, int n, int b, int leaves, int border, int extras, uint64_t *seed)
{
    *s = (Scene){0};
    fixture_chain_random(&s->m.chain, n, b, 5 * b, seed);
    add_leaves(s, leaves, seed);
    if (border) add_border(s, border, seed);
    add_extras(s, extras, seed);
}

static void scene_free(Scene *s)
{
    for (int k = 0; k < s->values; ++k) free(s->value[k]);
    block_chain_free(&s->m.chain);
}

/* Solves m in one way and returns the backward error, or -1 if it is refused; stats may be NULL. */
static double solve_error(const NewtonMatrix *m, LinKind kind, LinOrdering ordering, LinStats *stats)
{
    enum { COUNT = 3 };
    uint64_t seed = 99;
    hawser_error err = {0};
    const int size = newton_size(m);
    double error = 0, *const r = fixture_vector(COUNT * size, &seed),
           *const x = malloc((size_t)(COUNT * size) * sizeof *x);
    memcpy(x, r, (size_t)(COUNT * size) * sizeof *x);
    LinSolver *s = linsolver_new_newton(m, &(LinOptions){.kind = kind, .ordering = ordering, .threads = 1}, &err);
    if (s) {
        assert_int_equal(linsolver_factor_newton(s, m), 0);
        assert_int_equal(linsolver_solve_many(s, COUNT, x), 0);
        for (int k = 0; k < COUNT; ++k) error = larger_of(error, fixture_backward_error(m, x + k * size, r + k * size));
        if (stats) linsolver_stats(s, stats);
    } else {
        assert_int_equal(err.status, HAWSER_ERR_INPUT);
        error = -1;
    }
    linsolver_free(s);
    free(r);
    free(x);
    return error;
}

TEST(all_shapes)
{
    uint64_t seed = 1;
    for (int b = 3; b <= 6; b += 3) {
        for (int n = 2; n <= 12; n += 5) {
            for (int leaves = 0; leaves <= LEAVES; leaves += LEAVES) {
                for (int border = 0; border <= 4; border += 2) {
                    for (int extras = 0; extras <= EXTRAS; extras += EXTRAS) {
                        if (n == 2 && extras) continue; /* they would lie on the chain's own blocks */
                        Scene s;
                        scene_init(&s, n, b, leaves, border, extras, &seed);
                        for (LinOrdering o = ORDER_AUTO; o <= ORDER_METIS; ++o) {
                            check_close(solve_error(&s.m, LIN_KLU, o, NULL), 0, 1e-14);
                        }
                        check_close(solve_error(&s.m, LIN_AUTO, ORDER_AUTO, NULL), 0, 1e-14);
                        const double error = solve_error(&s.m, LIN_BORDERED, ORDER_AUTO, NULL);
                        if (extras) check_equal(error, -1);
                        if (!extras) check_at_least(error, 0);
                        if (!extras) check_below(error, 1e-14);
                        scene_free(&s);
                    }
                }
            }
        }
    }
}

/* Extra blocks may lie on the chain's own and add up with them. */
TEST(overlapping_blocks)
{
    uint64_t seed = 2;
    Scene s;
    scene_init(&s, 2, 6, 0, 0, EXTRAS, &seed);
    check_close(solve_error(&s.m, LIN_KLU, ORDER_AMD, NULL), 0, 1e-14);
    scene_free(&s);
}

TEST(choice)
{
    static const struct {
        int leaves, border, extras;
        const char *name, *why;
    } cases[] = {{0, 0, 0, "block", "auto: a plain chain, block tridiagonal"},
                 {2, 0, 0, "bordered", "auto: a chain with 2 leaf bodies and a border of 0 unknowns"},
                 {0, 3, 0, "bordered", "auto: a chain with 0 leaf bodies and a border of 3 unknowns"},
                 {2, 3, 1, "klu", "auto: 1 couplings outside the chain's three diagonals"}};
    uint64_t seed = 3;
    for (size_t k = 0; k < sizeof cases / sizeof cases[0]; ++k) {
        Scene s;
        scene_init(&s, 7, 6, cases[k].leaves, cases[k].border, cases[k].extras, &seed);
        LinStats stats;
        check_close(solve_error(&s.m, LIN_AUTO, ORDER_AUTO, &stats), 0, 1e-14);
        assert_string_equal(stats.name, cases[k].name);
        assert_string_equal(stats.why, cases[k].why);
        assert_int_equal(stats.factors, 1);
        assert_int_equal(stats.solves, 3);
        const int plain = !cases[k].leaves && !cases[k].border && !cases[k].extras;
        check_equal(solve_error(&s.m, LIN_BLOCK, ORDER_AUTO, NULL) == -1, !plain);
        scene_free(&s);
    }
}

/* Leaves slide along the chain and let go of it between factorisations of one solver. */
TEST(leaves_move)
{
    const LinKind kind[] = {LIN_BORDERED, LIN_KLU};
    for (int k = 0; k < 2; ++k) {
        uint64_t seed = 7;
        Scene s;
        hawser_error err = {0};
        scene_init(&s, 9, 6, LEAVES, 2, 0, &seed);
        LinSolver *const solver = linsolver_new_newton(&s.m, &(LinOptions){.kind = kind[k], .threads = 1}, &err);
        assert_non_null(solver);
        const int size = newton_size(&s.m);
        double *const r = fixture_vector(size, &seed), *const x = malloc((size_t)size * sizeof *x);
        for (int step = 0; step < 6; ++step) {
            for (int l = 0; l < LEAVES; ++l) {
                s.leaf[l].at = (step + l) % 8;
                if (step == 3 && s.leaf[l].touches) --s.leaf[l].touches;
            }
            memcpy(x, r, (size_t)size * sizeof *x);
            assert_int_equal(linsolver_factor_newton(solver, &s.m), 0);
            assert_int_equal(linsolver_solve(solver, x), 0);
            check_below(fixture_backward_error(&s.m, x, r), 1e-14);
        }
        linsolver_free(solver);
        free(r);
        free(x);
        scene_free(&s);
    }
}

/* A body without inertia of its own, held by the chain only: its block cannot be inverted, the whole can. */
TEST(fallback_leaf)
{
    uint64_t seed = 4;
    Scene s;
    scene_init(&s, 7, 6, 3, 2, 0, &seed);
    memset(s.value[0], 0, sizeof(double)); /* touches nothing: gives it a partner to hold on to */
    s.leaf[0].touches = 1;
    s.leaf[0].into[0] = scene_values(&s, 6, &seed);
    s.leaf[0].from[0] = scene_values(&s, 6, &seed);
    LinStats stats;
    const double error = solve_error(&s.m, LIN_BORDERED, ORDER_AUTO, &stats);
    check_at_least(error, 0);
    check_below(error, 1e-13);
    assert_int_equal(stats.fallbacks, 1);
    scene_free(&s);
}

/* A chain that only the border holds (free in every direction without it): A is singular, the whole is not. */
TEST(fallback_inner)
{
    uint64_t seed = 5;
    Scene s;
    scene_init(&s, 1, 3, 0, 3, 0, &seed);
    block_chain_zero(&s.m.chain);
    LinStats stats;
    const double error = solve_error(&s.m, LIN_BORDERED, ORDER_AUTO, &stats);
    check_at_least(error, 0);
    check_below(error, 1e-13);
    assert_int_equal(stats.fallbacks, 1);
    scene_free(&s);
}

/* A border whose rows repeat each other: singular, said so, and forgotten with the next matrix. */
TEST(singular_border)
{
    uint64_t seed = 6;
    Scene s;
    scene_init(&s, 6, 6, 2, 2, 0, &seed);
    const int m = newton_inner(&s.m);
    double *const bottom = malloc((size_t)(2 * m) * sizeof(double)), corner[4];
    for (int k = 0; k < 2 * m; ++k) bottom[k] = s.m.bottom[k - k % 2];
    for (int k = 0; k < 4; ++k) corner[k] = s.m.corner[k - k % 2];
    NewtonMatrix bad = s.m;
    bad.bottom = bottom;
    bad.corner = corner;
    LinSolver *const solver = linsolver_new_newton(&s.m, &(LinOptions){.kind = LIN_AUTO, .threads = 2}, NULL);
    assert_non_null(solver);
    check_above(linsolver_factor_newton(solver, &bad), 0);
    assert_int_equal(linsolver_factor_newton(solver, &s.m), 0);
    linsolver_free(solver);
    free(bottom);
    scene_free(&s);
}

/* What it says of itself: the chain's own factors and the border's three dense parts, C, P and S; a growth no smaller
 * than the chain's, and the chain's where there is nothing else to factor. */
TEST(statistics)
{
    for (int leaves = 0; leaves <= LEAVES; leaves += LEAVES) {
        for (int w = 1; w <= 4; w += 3) {
            uint64_t seed = 8;
            Scene s;
            LinStats plain, all;
            scene_init(&s, 11, 6, leaves, w, 0, &seed);
            for (int i = 0; i < 11; ++i) s.m.chain.diag[36 * i] = 1e-3; /* pivots below what is under them: growth */
            const NewtonMatrix chain = {.chain = s.m.chain};
            check_below(solve_error(&chain, LIN_BLOCK, ORDER_AUTO, &plain), 1e-12);
            check_below(solve_error(&s.m, LIN_BORDERED, ORDER_AUTO, &all), 1e-12);
            const long inner = newton_inner(&s.m);
            assert_int_equal(inner, 66 + leaves * (leaves + 1) / 2);
            assert_int_equal(all.nonzeros - plain.nonzeros, inner * w + inner * w + w * w);
            check_between(plain.growth, 0, 0.999);
            if (!leaves) check_equal(all.growth, plain.growth);
            if (leaves) check_between(all.growth, 0, 0.999);
            scene_free(&s);
        }
    }
}
