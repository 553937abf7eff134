/* What samples say of a quantity, and how well. docs/model/94-studies.md, "Estimates". */
#ifndef HAWSER_STUDY_MATHS_ESTIMATE_H
#define HAWSER_STUDY_MATHS_ESTIMATE_H

/* A share or probability and the interval in which it lies with 95 % confidence: of 100 studies that could be made 95
 * have the truth inside. */
typedef struct Share {
    double value, low, high;
} Share;

/* Wilson's interval (ES1) of `hits` among n independent samples; n of 0: NAN. */
Share share_of(long hits, long n);
/* The same in %. */
Share share_percent(Share s);

/* How values lie, in their own unit. */
typedef struct Spread {
    long n; /* values that are known */
    double mean;
    double sd;          /* of one value: the root of the sum of squares about the mean over n - 1 */
    double least, most; /* of all values */
    double mean_error;  /* half of the 95 % interval of the mean, of independent samples */
} Spread;

/* Of the finite ones of x[n]. NAN where there are too few: none, of sd and mean_error one. */
Spread spread_of(int n, const double *x);

/* The p-quantile (0 <= p <= 1) of x[n], which rises and holds finite numbers only: (ES2). n of 0: NAN. */
double quantile_of_sorted(int n, const double *x, double p);
/* Moves the finite ones to the front, rising; returns how many there are. */
int sort_finite(int n, double *x);

#endif
