/* The derivatives of cable on cable against finite differences: turns of a helix that lie on each other, strands that
 * cross, at rest and moving, shaken; the pattern holds every coupling that there is. */
#include "tests/support/touch.h"

#include "tests/support/contact_fd.h"

/* Entry (row, col) of the analytic matrices. */
static double entry(const SelfScene *s, const BlockChain *chain, const double *extra, int row, int col)
{
    const int i = row / 6, j = col / 6, at = 6 * (col % 6) + row % 6;
    if (i == j) return chain->diag[36 * i + at];
    if (i == j + 1) return chain->lower[36 * i + at];
    if (i == j - 1) return chain->upper[36 * i + at];
    const int e = block_extras_find(&s->pairs.extras, i, j);
    return e < 0 ? 0 : extra[36 * e + at];
}

/* Largest difference over the largest entry, worst of the four kinds of entries. */
static double difference(const SelfScene *s, const BlockChain *chain, const double *extra, const double *dense)
{
    double most[4] = {0}, apart[4] = {0}, worst = 0;
    const int size = 6 * s->chain.n;
    for (int col = 0; col < size; ++col) {
        for (int row = 0; row < size; ++row) {
            const int kind = 2 * (row % 6 / 3) + col % 6 / 3;
            const double value = dense[(size_t)col * (size_t)size + (size_t)row];
            most[kind] = larger_of(most[kind], fabs(value));
            apart[kind] = larger_of(apart[kind], fabs(value - entry(s, chain, extra, row, col)));
        }
    }
    for (int kind = 0; kind < 4; ++kind) worst = larger_of(worst, most[kind] <= 0 ? 1 : apart[kind] / most[kind]);
    return worst;
}

static void compare(SelfScene *s, const char *what, int least)
{
    const int n = s->chain.n;
    const size_t entries = (size_t)(6 * n) * (size_t)(6 * n);
    BlockChain k, d;
    double *const dense[2] = {calloc(entries, sizeof(double)), calloc(entries, sizeof(double))};
    assert_true(block_chain_alloc(&k, n, 6) && block_chain_alloc(&d, n, 6) && dense[0] && dense[1]);
    self_fresh(s);
    self_load(s, 1);
    check_at_least(s->pairs.active[0] + s->pairs.active[1], least);
    block_extras_zero(&s->pairs.extras);
    self_blocks(&s->model, SELF_ALONE(&s->chain, &s->kin), 1, &s->pairs, &k, &d);
    assert_true(self_blocks_fd(&s->model, &s->chain, &s->kin, 1, &s->pairs, 1e-7, 1e-7, dense[0], dense[1]));
    const double stiffness = difference(s, &k, s->pairs.extras.k, dense[0]);
    const double damping = difference(s, &d, s->pairs.extras.d, dense[1]);
    print_message("%s: %d pieces, K %.1g, D %.1g\n", what, s->pairs.active[0] + s->pairs.active[1], stiffness, damping);
    check_below(stiffness, 2e-7);
    check_below(damping, 2e-7);
    block_chain_free(&k);
    block_chain_free(&d);
    free(dense[0]);
    free(dense[1]);
}

/* Two and a half turns beside each other. */
TEST(test_turns)
{
    uint64_t seed = 3;
    for (int shaken = 0; shaken < 3; ++shaken) {
        SelfScene s;
        self_new(&s, 32, 0.25);
        self_helix(&s, 0.5, 2 * SELF_RADIUS - 2e-3);
        self_shake(&s, shaken * 5e-4, 0.01 * shaken + 1e-4, &seed);
        compare(&s, "turns", 20);
        self_free(&s);
    }
}

/* Two strands across each other, at angles from nearly parallel to square; unlike radii on the upper one. */
TEST(test_crossing)
{
    uint64_t seed = 5;
    const double angle[] = {0.05, 0.3, 1, 1.5};
    for (int k = 0; k < 4; ++k) {
        SelfScene s;
        self_new(&s, 12, 0.3);
        for (int i = 8; i < 12; ++i) s.chain.radius[i] = 0.02 + 0.005 * (i - 8);
        const double c = cos(angle[k]), e = sin(angle[k]), high = SELF_RADIUS + 0.0213 - 4e-3;
        self_strand(&s, 0, 6, v3(-0.95, 0, 0), v3(1, 0, 0));
        self_strand(&s, 6, 6, v3(0.85 * c, 0.85 * e, high), v3(-c, -e, 0));
        self_shake(&s, 2e-3, 0.02, &seed);
        compare(&s, "crossing", 1);
        self_free(&s);
    }
}

/* The cable's end on its own back: the foot is held at the end of the line. */
TEST(test_end)
{
    uint64_t seed = 9;
    SelfScene s;
    self_new(&s, 12, 0.3);
    self_strand(&s, 0, 6, v3(-0.95, 0, 0), v3(1, 0, 0));
    self_strand(&s, 6, 6, v3(0.05, 0.02, 1.8 + 2 * SELF_RADIUS - 1e-2), v3(0, 0, -1));
    self_shake(&s, 5e-4, 0.02, &seed);
    compare(&s, "end", 1);
    self_free(&s);
}
