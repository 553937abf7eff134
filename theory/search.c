#include "theory/search.h"

#include <assert.h>
#include <math.h>

static const double CLOSE = 1e-10, STRIDE = 1.1;

static int holds(const SearchDef *def, double x) { return def->holds(def->what, x); }

/* Bisects between a value where the predicate holds and one where it does not, until they are CLOSE; the geometric mean
 * halves the ratio. */
static SearchBound bisect(const SearchDef *def, double good, double bad)
{
    while (fabs(bad - good) > CLOSE * fabs(good)) {
        const double middle = sqrt(good) * sqrt(bad);
        if (middle == good || middle == bad) break;
        if (holds(def, middle)) {
            good = middle;
        } else {
            bad = middle;
        }
    }
    return (SearchBound){SEARCH_FOUND, good, bad};
}

/* Searches outward from a value where the predicate holds, squaring the stride every time. */
static SearchBound search_outward(const SearchDef *def, int up)
{
    double good = def->now, stride = STRIDE;
    while (good != def->farthest) {
        const double next = up ? fmin(good * stride, def->farthest) : fmax(good / stride, def->farthest);
        if (!holds(def, next)) return bisect(def, good, next);
        good = next;
        stride *= stride;
    }
    return (SearchBound){SEARCH_EVERYWHERE, good, good};
}

SearchBound search_bound(const SearchDef *def)
{
    assert(def->now > 0 && def->farthest > 0 && def->farthest != def->now);
    const int up = def->farthest > def->now;
    if (holds(def, def->now)) return search_outward(def, up);
    const double nearest = def->now * (def->now / def->farthest);
    for (double bad = def->now, next; bad != nearest; bad = next) {
        next = up ? fmax(bad / STRIDE, nearest) : fmin(bad * STRIDE, nearest);
        if (holds(def, next)) return bisect(def, next, bad);
    }
    return (SearchBound){SEARCH_NOWHERE, NAN, def->now};
}

SearchTop search_top(double (*f)(void *what, double x), void *what, double low, double high, int steps)
{
    const double share = (sqrt(5) - 1) / 2;
    SearchTop in[2] = {{.at = high - share * (high - low)}, {.at = low + share * (high - low)}};
    for (int k = 0; k < 2; k++) in[k].value = f(what, in[k].at);
    for (int i = 0; i < steps; i++) {
        const int right = in[1].value > in[0].value;
        if (right) low = in[0].at;
        if (!right) high = in[1].at;
        in[!right] = in[right];
        in[right].at = right ? low + share * (high - low) : high - share * (high - low);
        in[right].value = f(what, in[right].at);
    }
    return in[in[1].value > in[0].value];
}
