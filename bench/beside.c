/* What Newton's matrix of several chains that touch all along costs: the least CPU time of a factorisation and of a
 * solution, by back end, as rows of a table. Usage: bench_beside [REPETITIONS] */
#include <stdio.h>
#include <time.h>

#include "linsolve/linsolve.h"
#include "tests/linsolve/beside_fixture.h"

typedef struct Way {
    const char *name;
    LinKind kind;
    LinOrdering ordering;
    int most; /* segments of all chains, above which it is not asked: it takes minutes */
} Way;

static const Way ways[] = {{"block-sparse", LIN_BLOCK_SPARSE, ORDER_AUTO, 100000},
                           {"klu, amd", LIN_KLU, ORDER_AMD, 3000},
                           {"klu, metis", LIN_KLU, ORDER_METIS, 1200}};

enum { WAYS = sizeof ways / sizeof *ways };

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Factors and solves; prints the least times in microseconds. */
static int measure(const Way *way, int k, int n, const NewtonMatrix *m, int repetitions)
{
    const LinOptions options = {.kind = way->kind, .ordering = way->ordering, .threads = 1};
    LinSolver *const s = linsolver_new_newton(m, &options, NULL);
    double *const x = calloc((size_t)newton_size(m), sizeof *x), least[2] = {INFINITY, INFINITY};
    int bad = !s || !x || linsolver_factor_newton(s, m);
    for (int r = 0; !bad && r < repetitions; ++r) {
        const double begin = now();
        bad = linsolver_factor_newton(s, m);
        const double factored = now();
        for (int i = 0; i < newton_size(m); ++i) x[i] = i % 7;
        const double filled = now();
        bad |= linsolver_solve(s, x);
        least[1] = fmin(least[1], now() - filled);
        least[0] = fmin(least[0], factored - begin);
    }
    LinStats stats = {0};
    if (!bad) linsolver_stats(s, &stats);
    if (!bad)
        printf("| %d | %d | %s | %.0f | %.0f | %ld |\n", k, n, way->name, 1e6 * least[0], 1e6 * least[1],
               stats.nonzeros);
    linsolver_free(s);
    free(x);
    return bad;
}

int main(int argc, char **argv)
{
    static const int chains[] = {1, 2, 3, 5}, segments[] = {100, 370, 1000};
    const int repetitions = argc > 1 ? atoi(argv[1]) : 20;
    uint64_t seed = 1;
    int bad = 0;
    printf("| chains | segments each | back end | factor, us | solve, us | doubles |\n|---|---|---|---|---|---|\n");
    for (int c = 0; c < 4; ++c) {
        for (int l = 0; l < 3; ++l) {
            const int k = chains[c], n = segments[l];
            Beside b = beside_new(k, n, 0, n, &seed);
            const NewtonMatrix m = matrix_of(&b, 1);
            for (int w = 0; w < WAYS; ++w)
                if (k * n <= ways[w].most) bad |= measure(&ways[w], k, n, &m, repetitions);
            beside_free(&b);
        }
    }
    return bad;
}
