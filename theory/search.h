/* The farthest value at which something holds, by bracketing and bisection: what the inverse answers are found with;
 * and the largest of a function with one top. docs/model.md, "The planner's calculation", (PN9). Of the first some
 * forty looks for an answer within ten times of where it begins, up to a hundred for one that is not there. */
#ifndef HAWSER_THEORY_SEARCH_H
#define HAWSER_THEORY_SEARCH_H

#include <stddef.h>

/* How many of n items before s, or at it too (`at`), of items that rise by a double each: `first` of them, `size` bytes
 * apart. */
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

/* For qsort: items that rise by the double with which they begin. */
static inline int compare_first(const void *a, const void *b)
{
    const double x = *(const double *)a, y = *(const double *)b;
    return (x > y) - (x < y);
}

/* Whether it holds at x. What cannot be computed there does not hold; errors that end the search the caller keeps in
 * `what`, and answers 0 from then on. */
typedef int (*SearchHolds)(void *what, double x);

typedef struct SearchDef {
    SearchHolds holds;
    void *what;
    double now;      /* > 0, where the search begins */
    double farthest; /* > 0, beyond `now` on the side that is searched: it goes no further */
} SearchDef;

typedef enum SearchEnd { SEARCH_FOUND, SEARCH_NOWHERE, SEARCH_EVERYWHERE } SearchEnd;

typedef struct SearchBound {
    SearchEnd end;
    double value; /* FOUND: it holds here ... */
    double fails; /* ... and no more here, 1e-10 of the value further on; NOWHERE: `now` */
} SearchBound;

/* Where it holds at `now`, the end of the values from there toward `farthest` at which it does. Where it does not, the
 * nearest such end on the other side, looked for down to `now`^2/`farthest` in steps of a tenth: a narrower range of
 * values is missed. */
SearchBound search_bound(const SearchDef *def);

typedef struct SearchTop {
    double at, value;
} SearchTop;

/* The largest of a function that rises to one top between low and high and falls behind it, by `steps` of the golden
 * section, each of one look, after two: the top is then within 0.62^steps of the range. What is returned was looked
 * at. */
SearchTop search_top(double (*f)(void *what, double x), void *what, double low, double high, int steps);

#endif
