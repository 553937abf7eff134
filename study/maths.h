/* Distributions of parameters by their quantiles, alone and correlated. docs/theory/94-studies.md, "Distributions". */
#ifndef HAWSER_STUDY_MATHS_H
#define HAWSER_STUDY_MATHS_H

#include <stdint.h>

typedef enum DistributionKind {
    LAW_UNIFORM,    /* a to b */
    LAW_NORMAL,     /* mean a, standard deviation b */
    LAW_LOGNORMAL,  /* median a; two thirds lie between a/b and a b: ln x has the standard deviation ln b */
    LAW_TRIANGULAR, /* a to b, mode c */
    LAW_DISCRETE    /* one of n, by its weight */
} DistributionKind;

typedef struct Distribution {
    DistributionKind kind;
    double a, b, c;
    double low, high; /* NORMAL, LOGNORMAL: truncation; infinite: none */
    int n;
    const double *weight; /* [n] of DISCRETE, not negative; borrowed */
} Distribution;

/* The standard normal distribution, and its inverse for 0 < p < 1, both to 1e-15. */
double normal_share(double z);
double normal_quantile(double p);
/* Quantile of the share u, 0 < u < 1; for DISCRETE the number of the choice. (DI1)-(DI5). */
double distribution_quantile(const Distribution *d, double u);
/* Computes the lower triangle L of R = L L^T by rows, [n*n]; `r` is symmetric with ones on its diagonal. Returns -1, or
 * the row where R is not positive definite. */
int correlation_factor(int n, const double *r, double *l);
/* Applies a Gaussian copula (DI6): u[n], independent in (0, 1), get these correlations of their normal scores. z:
 * scratch [n]. */
void correlation_apply(int n, const double *l, double *u, double *z);
/* Statistics of a quantity from samples, with their accuracy. docs/theory/94-studies.md, "Estimates". */

/* A share or probability with its 95 % confidence interval. */
typedef struct Share {
    double value, low, high;
} Share;

/* Wilson's interval (ES1) of `hits` among n independent samples; n of 0: NAN. */
Share share_of(long hits, long n);
/* The same in %. */
Share share_percent(Share s);
/* Distribution of values, in their own unit. */
typedef struct Spread {
    long n; /* values that are known */
    double mean;
    double sd;          /* of one value: the root of the sum of squares about the mean over n - 1 */
    double least, most; /* of all values */
    double mean_error;  /* half of the 95 % interval of the mean, of independent samples */
} Spread;

/* Computes the spread of the finite ones of x[n]. NAN if there are too few: none; for sd and mean_error one. */
Spread spread_of(int n, const double *x);
/* The p-quantile (0 <= p <= 1) of x[n], which rises and holds finite numbers only: (ES2). n of 0: NAN. */
double quantile_of_sorted(int n, const double *x, double p);
/* Moves the finite ones to the front, rising; returns their number. */
int sort_finite(int n, double *x);
/* Points of the unit cube, each a function of a seed and its number alone: sample i has the same point in every
 * process. docs/theory/94-studies.md, "Points". */

/* Four words from six, Philox-4x32-10: J. Salmon, M. Moraes, R. Dror, D. Shaw, "Parallel random numbers: as easy as
 * 1, 2, 3", SC11 (2011). */
typedef struct RandomWords {
    uint32_t word[4];
} RandomWords;

RandomWords random_words(uint64_t key, const uint32_t counter[4]);
/* Uses of numbers: one seed gives different numbers for different uses. */
typedef enum RandomUse {
    RANDOM_POINT,    /* plain random points */
    RANDOM_ORDER,    /* the order of a Latin hypercube's layers */
    RANDOM_PLACE,    /* the place within a layer */
    RANDOM_SCRAMBLE, /* Sobol digits */
    RANDOM_TAIL,     /* the remainder below the last digit */
    RANDOM_BOOTSTRAP,
    RANDOM_MORRIS
} RandomUse;

/* Number in the open interval (0, 1) with 52 random bits, by its two indices. */
double random_uniform(uint64_t seed, RandomUse use, uint64_t i, uint32_t j);
/* Place of i in a random order of 0 ... n-1, without a table; 0 <= i < n, n < 2^62. */
uint64_t random_order(uint64_t seed, uint32_t which, uint64_t i, uint64_t n);
typedef enum PointKind { POINTS_RANDOM, POINTS_LATIN, POINTS_SOBOL } PointKind;

enum { SOBOL_DIMENSIONS = 64 };

/* Coordinate j of point i out of n, in (0, 1): random (PO1), Latin hypercube (PO2), Sobol with Owen's scrambling (PO3),
 * (PO4). n matters only for the hypercube. i < 2^32 for Sobol. */
double points_at(PointKind kind, uint64_t seed, uint64_t i, uint64_t n, int j);
/* Digits of Sobol's sequence in base 2, most significant first, without scrambling: point i, dimension j. */
uint32_t sobol_digits(uint32_t i, int j);
/* Importance of parameters: Morris' elementary effects and Sobol's indices, from designs of the unit cube whose point i
 * is a function of seed and i. docs/theory/94-studies.md, "Sensitivity". */

/* ------------------------------------------------------------------------------------------------------- Morris */

enum { MORRIS_LEVELS = 8 };

/* Computes a point of trajectories of d+1 points, one coordinate changed per step (SE1): point i of trajectory i/(d+1),
 * u[d]. */
void morris_point(uint64_t seed, uint64_t i, int d, double *u);
/* Effects of one parameter on one quantity, per unit of the cube. */
typedef struct MorrisEffect {
    long n;                     /* trajectories that count: values at both ends of the step are known */
    double mean, mean_size, sd; /* mu, mu*, sigma of (SE2); NAN if too few count */
    double mean_size_error;     /* half of the 95 % interval of mu*, NAN likewise */
} MorrisEffect;

/* Computes effect[d] from y[trajectories * (d+1)], in the order of the points; not finite: unknown. Returns 0 without
 * memory. */
int morris_effects(uint64_t seed, int d, int trajectories, const double *y, MorrisEffect *effect);
/* -------------------------------------------------------------------------------------------------------- Sobol */

/* Computes a point of blocks of d+2 points, (SE3): A, B, and A with each coordinate in turn from B. Point i of n*(d+2),
 * u[d]; A and B are one point of 2 d dimensions. d <= SOBOL_DIMENSIONS/2. */
void sobol_design_point(uint64_t seed, uint64_t i, int d, double *u);
/* A share of the variance with its 95 % interval. */
typedef struct SobolIndex {
    double first, first_low, first_high;
    double total, total_low, total_high;
} SobolIndex;

/* Computes index[d] from y[n*(d+2)] in the order of the points, by (SE4), (SE5), with intervals by bootstrap over
 * blocks; a block with an unknown value does not count. Returns the number of blocks that count, -1 without memory.
 * With fewer than two, or without variance, all are NAN. */
int sobol_indices(uint64_t seed, int d, int n, const double *y, SobolIndex *index);
/* Minimisation of a function of real and whole numbers within a box, under constraints, from values alone. One search
 * is a sequence of points, each a function of the earlier values: a repetition with the same values finds the same
 * points. docs/theory/94-studies.md, "Search". */

typedef enum SearchMethod {
    SEARCH_AUTO,   /* ALL if possible, else RANDOM with whole numbers, LINEAR without */
    SEARCH_LINEAR, /* COBYLA: linear models over a simplex; numbers only */
    SEARCH_RANDOM, /* ISRES, an evolution of many points; then the neighbours of the best one */
    SEARCH_ALL     /* every point of a box of whole numbers */
} SearchMethod;

/* The searched box. */
typedef struct SearchBox {
    int n;
    const double *from, *to;    /* [n] from < to, or equal: not varied */
    const double *start;        /* [n] where the first search begins */
    const unsigned char *whole; /* [n] whole numbers only, from and to included */
} SearchBox;

typedef struct SearchPlan {
    SearchMethod method; /* not AUTO */
    int constraints;
    int number, of;   /* this search, 0 <= number < of; each has its own start */
    long evaluations; /* at most */
    uint64_t seed;
    double tolerance; /* share of the box's sides: the search ends when points are closer together */
} SearchPlan;

/* Evaluates x[n]: the value, and by how much each constraint is broken, broken[constraints], not above 0 if it is kept.
 * *value NAN: there is none. Returns 0 to end the search. */
typedef int (*SearchTry)(void *user, const double *x, double *value, double *broken);

/* The method that AUTO selects; the number of points of a box of whole numbers, 0 if it has others or more than 1e9. */
SearchMethod search_method(const SearchBox *box, long evaluations);
double search_points(const SearchBox *box);
/* Calls `try` for each point once. Returns 0 without memory. */
int search_run(const SearchBox *box, const SearchPlan *plan, SearchTry try, void *user);
/* Checks whether the first of two results is better, (SR2). broken: the sums of (SR1). */
int search_better(double value, double broken, double than_value, double than_broken);
/* Sum of the excesses over constraints (SR1); infinite without a value. */
double search_broken(double value, const double *broken, int n);
/* Version, e.g. "NLopt 2.7.1": other versions may find other points. */
const char *search_version(char text[32]);
/* Least squares within bounds: Levenberg-Marquardt steps with difference quotients, and how well the data determine the
 * parameters. docs/theory/96-measured-pulls.md, "Fit". */

enum { FIT_MAX = 16 };

typedef struct FitPlan {
    int n, m;                        /* parameters, at most FIT_MAX; residuals, more than parameters */
    const double *from, *to, *start; /* [n] bounds, start */
    int evaluations;                 /* at most */
    double difference, small;        /* shares of each range: step of differences; step at which it ends */
} FitPlan;

/* Computes residuals r[m] at x[n], all finite, in the order of the data. Returns 1; 0: there are none at x; -1: end the
 * fit. */
typedef int (*FitTry)(void *user, const double *x, double *r);

typedef struct FitResult {
    int n, m, evaluations;
    int done;              /* the minimum was found; else evaluations ran out, or x has no residuals around it */
    double x[FIT_MAX];     /* the best point */
    int at_bound[FIT_MAX]; /* -1: at `from`, 1: at `to`: the minimum lies beyond, and its error is unknown */
    double half[FIT_MAX];  /* half of the 95 % interval; infinite: undetermined; NAN: at a bound, or not done */
    double correlation[FIT_MAX][FIT_MAX]; /* of the estimates; NAN likewise */
    double least_singular;                /* relative to the largest, columns scaled by ranges (LS4) */
    double weakest[FIT_MAX];              /* its direction, in shares of the ranges: what the data determine least */
    double rms;                           /* of the residuals */
    double lag;                           /* correlation of adjacent residuals */
    double effective;                     /* number of independent residuals (LS3) */
} FitResult;

/* Runs the fit; returns 0 without memory. */
int fit_run(const FitPlan *plan, FitTry try, void *user, FitResult *x);
/* The two-sided 95 % quantile of Student's distribution with v >= 1 degrees of freedom: for whole ones to a relative
 * 1e-3. */
double student_95(double v);

#endif
