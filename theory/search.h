/* Search for the farthest value at which a predicate holds, by bracketing and bisection, as used by the inverse
 * answers; and for the maximum of a function with one peak. docs/theory.md, "The planner's calculation", (PN9). The
 * first takes some forty evaluations for an answer within ten times of its start, up to a hundred if there is none. */
#ifndef HAWSER_THEORY_SEARCH_H
#define HAWSER_THEORY_SEARCH_H

#include <math.h>
#include <stddef.h>

/* Number of items before s, or up to s if `at` is set, in a row that rises by a double: `first` is that of the first
 * item, `size` the bytes between items. */
static inline int items_before(int n, const double *first, size_t size, double s, int at)
{
    int low = 0;
    for (int high = n; low < high;) {
        const int middle = low + (high - low) / 2;
        const double its = *(const double *)(const void *)((const char *)first + (size_t)middle * size);
        if (at ? its <= s : its < s)
            low = middle + 1;
        else
            high = middle;
    }
    return low;
}

/* Checks whether a exceeds b by more than rounding, so that of equals the first counts. */
static inline int exceeds(double a, double b) { return a - b > 1e-9 * fmax(fabs(a), fabs(b)); }

/* Compares items that rise by the double with which they begin, for qsort. */
static inline int compare_first(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Checks whether the predicate holds at x. It does not hold where it cannot be computed. For errors that end the search
 * the caller stores the error in `what` and returns 0 from then on. */
typedef int (*SearchHolds)(void *what, double x);

typedef struct SearchDef {
    SearchHolds holds;
    void *what;
    double now;      /* > 0, start of the search */
    double farthest; /* > 0, bound of the search, which lies beyond `now` on the searched side */
} SearchDef;

typedef enum SearchEnd { SEARCH_FOUND, SEARCH_NOWHERE, SEARCH_EVERYWHERE } SearchEnd;

typedef struct SearchBound {
    SearchEnd end;
    double value; /* FOUND: the predicate holds here ... */
    double fails; /* ... and fails here, 1e-10 of the value farther; NOWHERE: `now` */
} SearchBound;

/* If the predicate holds at `now`, finds the end of that range toward `farthest`. If not, finds the nearest end of a
 * range on the other side, down to `now`^2/`farthest` in steps of a tenth; narrower ranges are missed. */
SearchBound search_bound(const SearchDef *def);

typedef struct SearchTop {
    double at, value;
} SearchTop;

/* Finds the maximum of a function with one peak between low and high, by `steps` of the golden section, each with one
 * evaluation, after two: the peak is then within 0.62^steps of the range. The result is an evaluated point. */
SearchTop search_top(double (*f)(void *what, double x), void *what, double low, double high, int steps);

#endif
