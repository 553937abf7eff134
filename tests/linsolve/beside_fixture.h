/* Chains beside each other, with blocks between them, for the tests and the benchmark of the linear solvers. */
#ifndef HAWSER_TESTS_LINSOLVE_BESIDE_FIXTURE_H
#define HAWSER_TESTS_LINSOLVE_BESIDE_FIXTURE_H

#include "tests/linsolve/matrix_fixture.h"

enum { BLOCK = 36 }; /* doubles of a block */

/* Several chains of n rows in one matrix, and blocks between row i of one and rows i-1..i+1 of the others. */
typedef struct Beside {
    BlockChain chain;
    int count;
    ExtraBlock *extra;
    double *value;
    unsigned char *live;
} Beside;

/* Contacts of the rows from..to-1 between each two of k chains, as stiff as a tenth of the joints; unsymmetric by
 * friction. */
static inline Beside beside_new(int k, int n, int from, int to, uint64_t *seed)
{
    Beside b = {.value = calloc((size_t)(6 * k * k * n) * BLOCK, sizeof(double)),
                .extra = calloc((size_t)(6 * k * k * n), sizeof(ExtraBlock)),
                .live = calloc((size_t)(6 * k * k * n), 1)};
    fixture_chain_cable(&b.chain, k * n, 6, 0.005, seed);
    for (int c = 1; c < k; ++c) {
        memset(b.chain.lower + BLOCK * c * n, 0, BLOCK * sizeof(double));
        memset(b.chain.upper + BLOCK * (c * n - 1), 0, BLOCK * sizeof(double));
    }
    for (int p = 0; p < k; ++p) {
        for (int q = p + 1; q < k; ++q) {
            for (int i = from; i < to; ++i) {
                for (int j = i > 0 ? i - 1 : 0; j <= i + 1 && j < n; ++j) {
                    const double stiff = 0.005 * 0.005 * 2e7 * (1 + fixture_random(seed));
                    for (int way = 0; way < 2; ++way) {
                        double *const block = b.value + BLOCK * b.count;
                        const int row = (way ? q : p) * n + (way ? j : i), col = (way ? p : q) * n + (way ? i : j);
                        for (int e = 0; e < 3; ++e) {
                            block[7 * e] = -stiff;
                            b.chain.diag[BLOCK * row + 7 * e] += stiff;
                        }
                        block[1] = 0.3 * stiff;
                        block[20] = 0.1 * stiff;
                        b.live[b.count] = 1;
                        b.extra[b.count++] = (ExtraBlock){row, col, block};
                    }
                }
            }
        }
    }
    return b;
}

static inline void beside_free(Beside *b)
{
    block_chain_free(&b->chain);
    free(b->extra);
    free(b->value);
    free(b->live);
}

static inline NewtonMatrix matrix_of(const Beside *b, int known)
{
    return (NewtonMatrix){.chain = b->chain, .extras = b->count, .extra = b->extra, .live = known ? b->live : NULL};
}

#endif
