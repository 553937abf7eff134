/* Least squares within bounds: Levenberg's and Marquardt's steps with differences for derivatives, and how well the
 * data tell the parameters. docs/model/96-measured-pulls.md, "Fit". */
#ifndef HAWSER_STUDY_MATHS_FIT_H
#define HAWSER_STUDY_MATHS_FIT_H

enum { FIT_MAX = 16 };

typedef struct FitPlan {
    int n, m;                        /* parameters, at most FIT_MAX; residuals, more than parameters */
    const double *from, *to, *start; /* [n] bounds, where it begins */
    int evaluations;                 /* at most */
    double difference, small;        /* shares of each range: the step of differences; where it ends */
} FitPlan;

/* Residuals r[m] at x[n], all finite, in the order along the data. Returns 1; 0: there are none at x; -1: enough. */
typedef int (*FitTry)(void *user, const double *x, double *r);

typedef struct FitResult {
    int n, m, evaluations;
    int done;              /* the least was found; else evaluations ran out, or x has no residuals around */
    double x[FIT_MAX];     /* the best that was met */
    int at_bound[FIT_MAX]; /* -1: at `from`, 1: at `to`: the data want to go beyond, and say nothing of its error */
    double
        half[FIT_MAX]; /* half of the 95 % interval; infinite: the data do not say it; NAN: at a bound, or not done */
    double correlation[FIT_MAX][FIT_MAX]; /* of the estimates; NAN likewise */
    double least_singular;                /* over the largest, columns by ranges (LS4) */
    double weakest[FIT_MAX];              /* its direction, in shares of the ranges: what the data tell least of */
    double rms;                           /* of the residuals */
    double lag;                           /* their correlation from one to the next */
    double effective;                     /* independent residuals (LS3) */
} FitResult;

/* Returns 0 without memory. */
int fit_run(const FitPlan *plan, FitTry try, void *user, FitResult *x);
/* The two-sided 95 % quantile of Student's distribution with v >= 1 degrees of freedom: whole ones to 1e-3 of it. */
double student_95(double v);

#endif
