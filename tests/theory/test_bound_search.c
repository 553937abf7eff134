/* The search for the last value at which something holds: bounds known beforehand, from both sides. */
#include "theory/search.h"

#include "tests/support/check.h"

static int below(void *what, double x) { return x <= *(double *)what; }
static int above(void *what, double x) { return x >= *(double *)what; }

/* (PN9). */
static void the_search(void **state)
{
    (void)state;
    for (double bound = 0.02; bound < 100; bound *= 2.3) {
        const SearchDef most = {below, &bound, 1, 1e3}, least = {above, &bound, 1, 1e-3};
        const SearchBound a = search_bound(&most), b = search_bound(&least);
        assert_int_equal(a.end, SEARCH_FOUND);
        assert_int_equal(b.end, SEARCH_FOUND);
        check_share(a.value, bound, 1e-9);
        check_share(b.value, bound, 1e-9);
        assert_true(a.value <= bound && a.fails > bound && b.value >= bound && b.fails < bound);
    }
    double far = 1e4, never = 1e-9;
    const SearchDef all = {below, &far, 1, 1e3}, none = {below, &never, 1, 1e3};
    assert_int_equal(search_bound(&all).end, SEARCH_EVERYWHERE);
    assert_int_equal(search_bound(&none).end, SEARCH_NOWHERE);
}

/* Nothing is asked beyond the farthest value, and the first step is a tenth. */
typedef struct Asked {
    double bound, low, high;
} Asked;

static int asked_below(void *what, double x)
{
    Asked *const a = what;
    a->low = fmin(a->low, x);
    a->high = fmax(a->high, x);
    return x <= a->bound;
}

static void no_further_than_told(void **state)
{
    (void)state;
    for (double bound = 0.5; bound < 2e4; bound *= 1.7) {
        Asked a = {bound, INFINITY, 0};
        const SearchDef def = {asked_below, &a, 1, 1e3};
        const SearchBound found = search_bound(&def);
        assert_int_equal(found.end, bound < 1e3 ? SEARCH_FOUND : SEARCH_EVERYWHERE);
        check_at_most(a.high, 1e3);
        check_at_least(a.low, 1e-3);
        if (found.end == SEARCH_EVERYWHERE) check_equal(found.value, 1e3);
        if (bound < 1) check_at_least(a.low, bound / 1.1);
        if (found.end == SEARCH_FOUND) check_share(found.fails, found.value, 1.001e-10);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(the_search), cmocka_unit_test(no_further_than_told)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
