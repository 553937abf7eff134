/* The least value of a function of numbers and whole numbers within a box, under constraints, from values alone. One
 * search is a chain of points, each a function of the values before: whoever repeats it with the same values meets the
 * same points. docs/model/94-studies.md, "Search". */
#ifndef HAWSER_STUDY_MATHS_SEARCH_H
#define HAWSER_STUDY_MATHS_SEARCH_H

#include <stdint.h>

typedef enum SearchMethod {
    SEARCH_AUTO,   /* ALL where that goes, else RANDOM with whole numbers, LINEAR without */
    SEARCH_LINEAR, /* COBYLA: linear models over a simplex; numbers only */
    SEARCH_RANDOM, /* ISRES, an evolution of many points; then the neighbours of the best one */
    SEARCH_ALL     /* every point of a box of whole numbers */
} SearchMethod;

/* What is searched. */
typedef struct SearchBox {
    int n;
    const double *from, *to;    /* [n] from < to, or equal: not varied */
    const double *start;        /* [n] where the first search begins */
    const unsigned char *whole; /* [n] whole numbers only; from and to are such */
} SearchBox;

typedef struct SearchPlan {
    SearchMethod method; /* not AUTO */
    int constraints;
    int number, of;   /* this search, 0 <= number < of; others begin elsewhere */
    long evaluations; /* at most */
    uint64_t seed;
    double tolerance; /* of the box's sides: it ends where points come closer together */
} SearchPlan;

/* The value at x[n], and by how much each constraint is broken there, broken[constraints], not above 0 where it is
 * kept. *value NAN: there is none, x cannot be taken. Returns 0: enough. */
typedef int (*SearchTry)(void *user, const double *x, double *value, double *broken);

/* What AUTO stands for; the points of a box of whole numbers, 0 if it has others or more than 1e9. */
SearchMethod search_method(const SearchBox *box, long evaluations);
double search_points(const SearchBox *box);
/* Calls `try` for one point after the other, none twice. Returns 0 without memory. */
int search_run(const SearchBox *box, const SearchPlan *plan, SearchTry try, void *user);
/* Of two outcomes: whether the first is better, (SR2). broken: the sums of (SR1). */
int search_better(double value, double broken, double than_value, double than_broken);
/* The sum of what is broken (SR1); infinite where there is no value. */
double search_broken(double value, const double *broken, int n);
/* "NLopt 2.7.1": other versions may meet other points. */
const char *search_version(char text[32]);

#endif
