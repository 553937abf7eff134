/* The linear solvers against each other on a cable's Newton matrix: medians in one run, printed as Markdown tables.
 * Usage: bench_linsolve [repetitions of the short cases, default 1000] */
#include <klu.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/peak.h"
#include "linsolve/block_solver.h"
#include "linsolve/linsolve.h"
#include "tests/linsolve/matrix_fixture.h"

static const double gamma_step = 0.005; /* s, of the Newton matrix */

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

static int compare(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Times of one solver, s: medians, and lower quartiles, which a second thread needs to show anything on a busy machine.
 */
typedef struct Timing {
    double factor, solve;
    double factor_quartile, solve_quartile;
} Timing;

/* What is timed: factor, then solve x in place. */
typedef struct Subject {
    void (*factor)(void *self);
    void (*solve)(void *self, double *x);
    void *self;
    int size; /* unknowns */
} Subject;

/* Sorts v. */
static double median(double *v, int count)
{
    qsort(v, (size_t)count, sizeof *v, compare);
    return v[count / 2];
}

static Timing measure(Subject s, int repetitions)
{
    uint64_t seed = 1;
    double *const factor = malloc((size_t)repetitions * sizeof(double)), *const r = fixture_vector(s.size, &seed);
    double *const solve = malloc((size_t)repetitions * sizeof(double)), *const x = fixture_vector(s.size, &seed);
    s.factor(s.self);
    for (int k = 0; k < repetitions; ++k) {
        const double t0 = now();
        s.factor(s.self);
        factor[k] = now() - t0;
        memcpy(x, r, (size_t)s.size * sizeof *x);
        const double t1 = now();
        s.solve(s.self, x);
        solve[k] = now() - t1;
    }
    Timing t = {.factor = median(factor, repetitions), .solve = median(solve, repetitions)};
    t.factor_quartile = factor[repetitions / 4];
    t.solve_quartile = solve[repetitions / 4];
    free(factor);
    free(solve);
    free(r);
    free(x);
    return t;
}

/* Through the contract. */
typedef struct Contract {
    LinSolver *solver;
    const BlockChain *a;
} Contract;

static void contract_factor(void *self)
{
    const Contract *const c = self;
    if (linsolver_factor(c->solver, c->a)) abort();
}

static void contract_solve(void *self, double *x)
{
    const Contract *const c = self;
    if (linsolver_solve(c->solver, x)) abort();
}

static Timing measure_kind(const BlockChain *a, LinKind kind, int threads, int repetitions)
{
    const LinOptions options = {.kind = kind, .ordering = ORDER_AMD, .threads = threads};
    Contract c = {linsolver_new(a, &options, NULL), a};
    const Timing t = measure((Subject){contract_factor, contract_solve, &c, a->n * a->b}, repetitions);
    linsolver_free(c.solver);
    return t;
}

/* KLU itself, without the contract's assembly and checks: klu_refactor and klu_solve. */
typedef struct RawKlu {
    const SparseMatrix *a;
    klu_common common;
    klu_symbolic *symbolic;
    klu_numeric *numeric;
} RawKlu;

static void raw_factor(void *self)
{
    RawKlu *const k = self;
    if (!k->numeric) k->numeric = klu_factor(k->a->p, k->a->i, k->a->x, k->symbolic, &k->common);
    if (!klu_refactor(k->a->p, k->a->i, k->a->x, k->symbolic, k->numeric, &k->common)) abort();
}

static void raw_solve(void *self, double *x)
{
    RawKlu *const k = self;
    if (!klu_solve(k->symbolic, k->numeric, k->a->n, 1, x, &k->common)) abort();
}

/* ordering as in klu_common: 0 AMD, 1 COLAMD (what SUNDIALS' own KLU interface takes by default). */
static Timing measure_raw_klu(const SparseMatrix *a, int ordering, int repetitions)
{
    RawKlu k = {.a = a};
    klu_defaults(&k.common);
    k.common.ordering = ordering;
    k.symbolic = klu_analyze(a->n, a->p, a->i, &k.common);
    const Timing t = measure((Subject){raw_factor, raw_solve, &k, a->n}, repetitions);
    klu_free_numeric(&k.numeric, &k.common);
    klu_free_symbolic(&k.symbolic, &k.common);
    return t;
}

static Timing measure_raw_klu_of(const BlockChain *a, int repetitions)
{
    const NewtonMatrix m = {.chain = *a};
    SparseAssembly s;
    if (!sparse_assembly_new(&m, &s)) abort();
    sparse_assembly_refresh(&s, &m);
    const Timing t = measure_raw_klu(&s.a, 0, repetitions);
    sparse_assembly_free(&s);
    return t;
}

/* The unreduced system I - gamma J of n segments with 13 unknowns (position, quaternion, velocity, angular velocity):
 * rates of position and quaternion depend on the own body, accelerations on both neighbours too. Diagonally dominant
 * numbers in the true pattern: KLU's time does not depend on them. */
static void full_system(int n, SparseMatrix *a)
{
    enum { DOF = 13, POSITION = 3, RATES = 7 };
    uint64_t seed = 2;
    const int most = n * DOF * 3 * DOF;
    *a = (SparseMatrix){.n = DOF * n,
                        .p = calloc((size_t)(DOF * n + 1), sizeof(int)),
                        .i = malloc((size_t)most * sizeof(int)),
                        .x = malloc((size_t)most * sizeof(double))};
    for (int c = 0, at = 0; c < DOF * n; ++c) {
        const int body = c / DOF, dc = c % DOF;
        for (int r = DOF * (body ? body - 1 : 0); r < DOF * (body + 2) && r < DOF * n; ++r) {
            const int dr = r % DOF, own = r / DOF == body;
            const int position = own && dr < POSITION && (dr == dc || dc == dr + RATES);
            const int quaternion = own && dr >= POSITION && dr < RATES && ((dc >= POSITION && dc < RATES) || dc > 9);
            if (!position && !quaternion && dr < RATES) continue;
            a->i[at] = r;
            a->x[at++] = fixture_random(&seed) + (r == c ? 60 : 0);
        }
        a->p[c + 1] = at;
    }
}

static Timing measure_full(int n, int ordering, int repetitions)
{
    SparseMatrix a;
    full_system(n, &a);
    const Timing t = measure_raw_klu(&a, ordering, repetitions);
    free(a.p);
    free(a.i);
    free(a.x);
    return t;
}

static void row(const char *name, int b, int n, Timing t, Timing reference)
{
    printf("| %s | %d | %d | %.2f | %.2f | %.1f | %.1f | %.3f | %.3f |\n", name, b, n, 1e6 * t.factor, 1e6 * t.solve,
           1e9 * t.factor / n, 1e9 * t.solve / n, t.factor / reference.factor, t.solve / reference.solve);
}

static void table_head(const char *last)
{
    printf("\n| solver | b | N | factor us | solve us | factor ns/N | solve ns/N | factor / %s | solve / %s |\n", last,
           last);
    printf("|---|---|---|---|---|---|---|---|---|\n");
}

static void back_ends(int repetitions)
{
    printf("\nBack ends, one thread. `klu_refactor` is KLU alone; `klu` adds assembly and the growth check.\n");
    table_head("klu_refactor");
    for (int b = 6; b >= 3; b -= 3) {
        BlockChain a;
        uint64_t seed = 3;
        fixture_chain_cable(&a, 370, b, gamma_step, &seed);
        const Timing raw = measure_raw_klu_of(&a, repetitions);
        row("klu_refactor", b, 370, raw, raw);
        row("klu", b, 370, measure_kind(&a, LIN_KLU, 1, repetitions), raw);
        row("block", b, 370, measure_kind(&a, LIN_BLOCK, 1, repetitions), raw);
        row("bordered", b, 370, measure_kind(&a, LIN_BORDERED, 1, repetitions), raw);
        row("band", b, 370, measure_kind(&a, LIN_BAND, 1, repetitions / 10 + 1), raw);
        if (b == 6) row("klu-full, AMD", 13, 370, measure_full(370, 0, repetitions / 10 + 1), raw);
        if (b == 6) row("klu-full, COLAMD", 13, 370, measure_full(370, 1, repetitions / 10 + 1), raw);
        block_chain_free(&a);
    }
}

static void lengths(int repetitions)
{
    printf("\n`block` over the chain's length, against N = 370; factors take 864 N bytes (b = 6).\n");
    table_head("(N / 370) t(370)");
    static const int sizes[] = {370, 1000, 2000, 5000, 20000};
    for (int b = 6; b >= 3; b -= 3) {
        Timing first = {0};
        for (int k = 0; k < 5; ++k) {
            BlockChain a;
            uint64_t seed = 3;
            fixture_chain_cable(&a, sizes[k], b, gamma_step, &seed);
            const Timing t = measure_kind(&a, LIN_BLOCK, 1, repetitions * 370 / sizes[k] + 11);
            if (!k) first = t;
            const double ratio = sizes[k] / 370.;
            row("block", b, sizes[k], t, (Timing){.factor = ratio * first.factor, .solve = ratio * first.solve});
            block_chain_free(&a);
        }
    }
}

/* The lower quartile as if it were the median. */
static Timing quartiles(Timing t) { return (Timing){.factor = t.factor_quartile, .solve = t.solve_quartile}; }

static void two_threads(int repetitions)
{
    printf("\nTwo threads against one, lower quartiles.\n");
    table_head("one thread");
    static const int sizes[] = {100, 200, 370, 600, 1000, 2000, 5000};
    for (int k = 0; k < 7; ++k) {
        BlockChain a;
        uint64_t seed = 3;
        fixture_chain_cable(&a, sizes[k], 6, gamma_step, &seed);
        const Timing one = measure_kind(&a, LIN_BLOCK, 1, repetitions),
                     two = measure_kind(&a, LIN_BLOCK, 2, repetitions);
        row("block, two threads", 6, sizes[k], quartiles(two), quartiles(one));
        block_chain_free(&a);
    }
}

static double peak_rate(Isa isa)
{
    static void (*const peak[])(long, double *) = ISA_TABLE(peak);
    enum { ROUNDS = 1000, SAMPLES = 201 };
    static _Alignas(64) double work[PEAK_DOUBLES];
    double t[SAMPLES];
    for (int k = 0; k < SAMPLES; ++k) {
        const double start = now();
        peak[isa](ROUNDS, work);
        t[k] = now() - start;
    }
    return ROUNDS * 432 / median(t, SAMPLES);
}

/* The block LU with kernels of one's own choice. */
typedef struct Direct {
    BlockSolver block;
    BlockChain a;
} Direct;

static void direct_factor(void *self)
{
    Direct *const d = self;
    if (block_solver_factor(&d->block, &d->a)) abort();
}

static void direct_solve(void *self, double *x)
{
    Direct *const d = self;
    block_solver_solve(&d->block, 1, x);
}

/* Per block row: the inverse of S, V and L V, three products' worth, 3 x 432 operations. */
static void rates(int repetitions)
{
    printf("\nInstruction sets, N = 370, b = 6: the factor's rate (1296 operations a row) against C -= A B on 6 x 6 "
           "blocks in first-level cache.\n\n");
    printf("| set | factor us | solve us | factor GF/s | peak GF/s | share |\n|---|---|---|---|---|---|\n");
    for (int isa = ISA_GENERIC; isa <= (int)isa_best(); ++isa) {
        Direct d;
        uint64_t seed = 3;
        fixture_chain_cable(&d.a, 370, 6, gamma_step, &seed);
        if (!block_solver_init(&d.block, 370, 6, (Isa)isa, 1e6, NULL)) abort();
        const Timing t = measure((Subject){direct_factor, direct_solve, &d, 370 * 6}, repetitions);
        const double rate = 370 * 1296 / t.factor, peak = peak_rate((Isa)isa);
        printf("| %s | %.2f | %.2f | %.1f | %.1f | %.2f |\n", isa_name((Isa)isa), 1e6 * t.factor, 1e6 * t.solve,
               1e-9 * rate, 1e-9 * peak, rate / peak);
        block_solver_release(&d.block);
        block_chain_free(&d.a);
    }
}

int main(int argc, char **argv)
{
    const int repetitions = argc > 1 ? atoi(argv[1]) : 1000;
    if (repetitions < 1) return 2;
    setbuf(stdout, NULL);
    back_ends(repetitions);
    lengths(repetitions);
    two_threads(repetitions);
    rates(repetitions);
    return 0;
}
