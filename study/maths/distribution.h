/* Distributions of parameters by their quantiles, alone and correlated. docs/model/94-studies.md, "Distributions". */
#ifndef HAWSER_STUDY_MATHS_DISTRIBUTION_H
#define HAWSER_STUDY_MATHS_DISTRIBUTION_H

typedef enum DistributionKind {
    LAW_UNIFORM,    /* a to b */
    LAW_NORMAL,     /* mean a, standard deviation b */
    LAW_LOGNORMAL,  /* median a; two thirds lie between a/b and a b: ln x has the standard deviation ln b */
    LAW_TRIANGULAR, /* a to b, most often c */
    LAW_DISCRETE    /* one of n, by its weight */
} DistributionKind;

typedef struct Distribution {
    DistributionKind kind;
    double a, b, c;
    double low, high; /* NORMAL, LOGNORMAL: cut off outside; infinite: not */
    int n;
    const double *weight; /* [n] of DISCRETE, not negative; borrowed */
} Distribution;

/* The standard normal distribution, and its inverse for 0 < p < 1: to 1e-15 of either. */
double normal_share(double z);
double normal_quantile(double p);

/* The value below which the share u lies, 0 < u < 1; of DISCRETE the number of the choice. (DI1)-(DI5). */
double distribution_quantile(const Distribution *d, double u);

/* The lower triangle L of R = L L^T by rows, [n*n]; `r` is symmetric with ones on its diagonal. Returns -1, or the row
 * at which R turns out not to be positive definite. */
int correlation_factor(int n, const double *r, double *l);
/* Gaussian copula (DI6): u[n] of independent numbers in (0, 1) become such with these correlations of their normal
 * scores. z: scratch [n]. */
void correlation_apply(int n, const double *l, double *u, double *z);

#endif
