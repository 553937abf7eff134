/* The search for the last value at which something holds: bounds known beforehand, from both sides. */
#include "theory/search.h"

#include "tests/support/check.h"

static int below(void *what, double x) { return x <= *(double *)what; }
static int above(void *what, double x) { return x >= *(double *)what; }

/* (PN9). */
TEST(the_search)
{
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

TEST(no_further_than_told)
{
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

/* One top, within 0.62^steps of the range and no worse than any look; at an end where the function only rises. */
typedef struct Looked {
    double top, most;
    int looks;
} Looked;

static double hill(void *what, double x)
{
    Looked *const l = what;
    const double value = -fabs(x - l->top) - (x > l->top ? x - l->top : 0);
    l->most = fmax(l->most, value);
    l->looks++;
    return value;
}

TEST(the_top)
{
    for (double at = 2; at <= 5; at += 0.23) {
        for (int steps = 0; steps < 40; steps += 13) {
            Looked l = {at, -INFINITY, 0};
            const SearchTop top = search_top(hill, &l, 2, 5, steps);
            assert_int_equal(l.looks, 2 + steps);
            check_close(top.at, at, 3 * pow((sqrt(5) - 1) / 2, steps));
            check_equal(top.value, hill(&l, top.at));
            check_equal(top.value, l.most);
        }
    }
}
