/* Searches of functions whose least value is known: curved and constrained, of whole numbers, of both, with places
 * where there is no value; that none asks twice, and that the same values lead along the same points. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "study/maths.h"
#include "tests/support/check.h"

enum { SIDES_MAX = 4, POINTS_MAX = 4000 };

/* A function, its constraints, and what a search has asked of it. */
typedef struct Probe {
    int n, constraints;
    double (*value)(const double *x, double *broken);
    long asked, most; /* most: enough then; 0: never */
    double x[POINTS_MAX][SIDES_MAX], best[SIDES_MAX], least, broken;
} Probe;

static int ask(void *user, const double *x, double *value, double *broken)
{
    Probe *const p = user;
    if (p->most && p->asked == p->most) return 0;
    for (long k = 0; k < p->asked && p->n; k++) {
        if (memcmp(p->x[k], x, (size_t)p->n * sizeof *x) == 0) fail_msg("point %ld is asked for again", k);
    }
    memcpy(p->x[p->asked++], x, (size_t)p->n * sizeof *x);
    *value = p->value(x, broken);
    const double sum = search_broken(*value, broken, p->constraints);
    if (p->asked > 1 && !search_better(*value, sum, p->least, p->broken)) return 1;
    memcpy(p->best, x, (size_t)p->n * sizeof *x);
    p->least = *value;
    p->broken = sum;
    return 1;
}

/* The best of several searches. */
static Probe seek(const SearchBox *box, SearchMethod method, int constraints, int searches, long evaluations,
                  double (*value)(const double *, double *))
{
    Probe best = {.least = NAN, .broken = INFINITY};
    Probe *const p = malloc(sizeof *p);
    for (int k = 0; k < searches; k++) {
        const SearchPlan plan = {.method = method,
                                 .constraints = constraints,
                                 .number = k,
                                 .of = searches,
                                 .evaluations = evaluations,
                                 .seed = 5,
                                 .tolerance = 1e-6};
        *p = (Probe){.n = box->n, .constraints = constraints, .value = value};
        assert_true(search_run(box, &plan, ask, p));
        check_at_most((double)p->asked, (double)evaluations);
        if (k == 0 || search_better(p->least, p->broken, best.least, best.broken)) best = *p;
    }
    free(p);
    return best;
}

/* Rosenbrock's valley, cut by the unit disk. On the rim x = cos t: the least value is where its derivative by t is 0,
 * found here by halving. */
static double valley_in_disk(const double *x, double *broken)
{
    const double a = 1 - x[0], b = x[1] - x[0] * x[0];
    broken[0] = x[0] * x[0] + x[1] * x[1] - 1;
    return a * a + 100 * b * b;
}
static double slope_on_rim(double t)
{
    const double x = cos(t), y = sin(t), b = y - x * x;
    return (-2 * (1 - x) - 400 * x * b) * -y + 200 * b * x;
}
TEST(curved_and_constrained)
{
    const double from[] = {-1.5, -1.5}, to[] = {1.5, 1.5}, start[] = {-1, 0.5};
    const SearchBox box = {2, from, to, start, (const unsigned char[]){0, 0}};
    double low = 0.5, high = 0.8;
    while (high - low > 1e-14) {
        const double middle = (low + high) / 2;
        *(slope_on_rim(low) * slope_on_rim(middle) <= 0 ? &high : &low) = middle;
    }
    assert_int_equal(search_method(&box, 1000), SEARCH_LINEAR);
    const Probe p = seek(&box, SEARCH_LINEAR, 1, 4, 1500, valley_in_disk);
    check_close(p.best[0], cos(low), 2e-3);
    check_close(p.best[1], sin(low), 2e-3);
    check_at_most(p.broken, 1e-12);
}

/* Whole numbers with a ripple: of two neighbours one is often worse, as with rollers in bends. */
static double ripple(const double *x, double *broken)
{
    const double a = x[0] - 13, b = x[1] - 4, c = x[2] - 27;
    broken[0] = 40 - (x[0] + x[1] + x[2]);
    return a * a + 3 * b * b + 2 * c * c + a * b + 6 * sin(2.1 * x[0]) + 5 * cos(1.7 * x[1] + x[2]);
}
TEST(whole_numbers)
{
    const double from[] = {0, 0, 0}, to[] = {40, 20, 40}, start[] = {20, 10, 20};
    const SearchBox box = {3, from, to, start, (const unsigned char[]){1, 1, 1}};
    double least = INFINITY, broken;
    for (double x[3] = {0}; x[0] <= 40; x[0]++) {
        for (x[1] = 0; x[1] <= 20; x[1]++) {
            for (x[2] = 0; x[2] <= 40; x[2]++) {
                const double value = ripple(x, &broken);
                if (broken <= 0) least = fmin(least, value);
            }
        }
    }
    assert_int_equal(search_method(&box, 1000), SEARCH_RANDOM);
    assert_int_equal(search_method(&box, 41 * 21 * 41), SEARCH_ALL);
    const Probe p = seek(&box, SEARCH_RANDOM, 1, 4, 400, ripple);
    check_equal(p.least, least);
}

/* All points, shared out among the searches. */
TEST(all_points)
{
    const double from[] = {10, 0, 20}, to[] = {16, 9, 30}, start[] = {10, 0, 20};
    const SearchBox box = {3, from, to, start, (const unsigned char[]){1, 1, 1}};
    Probe *const p = calloc(1, sizeof *p);
    *p = (Probe){.n = 3, .constraints = 1, .value = ripple};
    for (int k = 0; k < 3; k++) {
        const SearchPlan plan = {SEARCH_ALL, 1, k, 3, 300, 1, 1e-3};
        assert_true(search_run(&box, &plan, ask, p));
    }
    check_equal(search_points(&box), 7 * 10 * 11);
    assert_int_equal(p->asked, 7 * 10 * 11);
    free(p);
}

/* A number and a whole number: the best x for each k is 0.3 + k/10, where (k - 6)^2 is left; beyond x = 0.95 there is
 * no value. */
static double both(const double *x, double *broken)
{
    const double a = x[0] - 0.3 - x[1] / 10;
    (void)broken;
    return x[0] > 0.95 ? NAN : 50 * a * a + (x[1] - 6) * (x[1] - 6) + 1;
}
TEST(numbers_of_both_kinds)
{
    const double from[] = {0, 0}, to[] = {2, 12}, start[] = {1.5, 11};
    const SearchBox box = {2, from, to, start, (const unsigned char[]){0, 1}};
    const Probe p = seek(&box, SEARCH_RANDOM, 0, 2, 300, both);
    check_equal(p.best[1], 6);
    check_close(p.best[0], 0.9, 1e-3);
    check_close(p.least, 1, 1e-4);
}

/* The same search again meets the same points; one that may ask for fewer has met the first of them. */
TEST(repeats)
{
    const double from[] = {0, 0, 0}, to[] = {40, 20, 40}, start[] = {20, 10, 20};
    const SearchBox box = {3, from, to, start, (const unsigned char[]){1, 1, 1}};
    const SearchPlan plan = {SEARCH_RANDOM, 1, 2, 4, 200, 9, 1e-3};
    Probe *const a = calloc(2, sizeof *a), *const b = a + 1;
    *a = *b = (Probe){.n = 3, .constraints = 1, .value = ripple};
    b->most = 61;
    assert_true(search_run(&box, &plan, ask, a));
    assert_true(search_run(&box, &plan, ask, b));
    assert_int_equal(b->asked, 61);
    for (long k = 0; k < b->asked; k++) assert_memory_equal(a->x[k], b->x[k], sizeof(double[3]));
    free(a);
}
