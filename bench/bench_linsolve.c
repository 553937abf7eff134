/* The linear solvers against each other on a cable's Newton matrix: one round, in which every configuration has its
 * turn. Prints CSV, a row a configuration with the medians of its repetitions; bench/linsolve.py runs rounds and makes
 * tables. Usage: bench_linsolve [repetitions of the short cases, default 150] */
#include <klu.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench/peak.h"
#include "linsolve/block_factor.h"
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

/* Times of one solver, s: medians of the repetitions. */
typedef struct Timing {
    double factor, solve;
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
    const Timing t = {.factor = median(factor, repetitions), .solve = median(solve, repetitions)};
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

/* One row: group is the table that it belongs to; peak is the dense rate to compare with, flop/s, or 0. */
static void row(const char *group, const char *solver, int b, int n, int threads, Isa isa, Timing t, double peak)
{
    printf("%s,%s,%d,%d,%d,%s,%.4f,%.4f,%.3f\n", group, solver, b, n, threads, isa_name(isa), 1e6 * t.factor,
           1e6 * t.solve, 1e-9 * peak);
}

/* Every back end on one chain. `klu_refactor` is KLU alone; `klu` adds assembly and the growth check. */
static void back_ends(int repetitions)
{
    static const struct {
        const char *name;
        LinKind kind;
    } kinds[] = {{"klu", LIN_KLU}, {"block", LIN_BLOCK}, {"bordered", LIN_BORDERED}};
    const Isa isa = isa_best();
    for (int b = 6; b >= 3; b -= 3) {
        BlockChain a;
        uint64_t seed = 3;
        fixture_chain_cable(&a, 370, b, gamma_step, &seed);
        row("kinds", "klu_refactor", b, 370, 1, isa, measure_raw_klu_of(&a, repetitions), 0);
        for (int k = 0; k < 3; ++k) {
            const Timing t = measure_kind(&a, kinds[k].kind, 1, repetitions);
            row("kinds", kinds[k].name, b, 370, 1, isa, t, 0);
        }
        block_chain_free(&a);
    }
    const int few = repetitions / 10 + 1;
    row("kinds", "klu-full amd", 13, 370, 1, isa, measure_full(370, 0, few), 0);
    row("kinds", "klu-full colamd", 13, 370, 1, isa, measure_full(370, 1, few), 0);
}

/* `block` over the chain's length, on one thread and on two. */
static void lengths(int repetitions)
{
    static const int sizes[] = {100, 200, 370, 600, 1000, 2000, 5000, 20000};
    for (int k = 0; k < (int)(sizeof sizes / sizeof *sizes); ++k) {
        const int n = sizes[k], count = n > 370 ? repetitions * 370 / n + 11 : repetitions;
        for (int b = 6; b >= 3; b -= 3) {
            BlockChain a;
            uint64_t seed = 3;
            fixture_chain_cable(&a, n, b, gamma_step, &seed);
            for (int threads = 1; threads <= 2; ++threads) {
                const Timing t = measure_kind(&a, LIN_BLOCK, threads, count);
                row("lengths", "block", b, n, threads, isa_best(), t, 0);
            }
            block_chain_free(&a);
        }
    }
}

static double peak_rate(Isa isa)
{
    static void (*const peak[])(long, double *) = ISA_TABLE(peak);
    enum { ROUNDS = 1000, SAMPLES = 51 };
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

/* `block` with the kernels of each instruction set, beside the rate of dense products with the same one. */
static void rates(int repetitions)
{
    for (int isa = ISA_GENERIC; isa <= (int)isa_best(); ++isa) {
        Direct d;
        uint64_t seed = 3;
        fixture_chain_cable(&d.a, 370, 6, gamma_step, &seed);
        if (!block_solver_init(&d.block, 370, 6, (Isa)isa, 1e6, NULL)) abort();
        const Timing t = measure((Subject){direct_factor, direct_solve, &d, 370 * 6}, repetitions);
        row("rates", "block", 6, 370, 1, (Isa)isa, t, peak_rate((Isa)isa));
        block_solver_release(&d.block);
        block_chain_free(&d.a);
    }
}

int main(int argc, char **argv)
{
    const int repetitions = argc > 1 ? atoi(argv[1]) : 150;
    if (repetitions < 1) return 2;
    printf("group,solver,b,n,threads,isa,factor_us,solve_us,peak_gf\n");
    back_ends(repetitions);
    lengths(repetitions);
    rates(repetitions);
    return 0;
}
