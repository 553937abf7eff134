/* What every method is given: a relaxed scene of hawser's in motion at a time `from`, its rates, and the winch's force
 * that it should find up to a time `to`, against which it is measured as it goes. */
#ifndef HAWSER_BENCH_METHODS_PROBLEM_H
#define HAWSER_BENCH_METHODS_PROBLEM_H

#include "sim/run/stage.h"

/* The winch's force, converged: straight lines through times as close as the integrator's tightest steps. */
typedef struct Reference {
    int rows;
    double *t, *pull; /* [rows] s, N */
    double largest;   /* N: what errors are a share of */
} Reference;

typedef struct Problem {
    SceneDef def;
    Stage stage;
    Motion *motion; /* the stage's */
    int n;          /* segments */
    int per;        /* unknowns a segment: 13, in the plane 6 */
    int stride;     /* component c of segment i is y[c stride + i] */
    double from, to;
    Reference reference;
} Problem;

/* What a run did. Iterations: Newton's; `inner` are GMRES's; `rhs` are all evaluations of the rates, differences too.
 */
typedef struct Counts {
    long steps, rhs, iterations, inner, setups, jacobians, error_fails, newton_fails;
} Counts;

/* A run on its way. */
typedef struct Walk {
    Problem *problem;
    double limit; /* s of processor time, after which it ends where it is */
    double begun; /* s */
    double t;     /* s, reached */
    double last_error, square, worst;
    double cpu; /* s */
    Counts counts;
    char why[200]; /* it did not arrive */
} Walk;

/* Builds the scene `segments` > 0: straight_scene of that length, or the case file with its settings KEY=VALUE, and
 * relaxes it. Prints what is wrong and returns 0 on failure. */
int problem_new(Problem *p, const char *path, int segments, const char *const *settings, int n_settings);
void problem_free(Problem *p);
/* Makes state and reference: integrates from rest to `from`, then on to `to`, at this accuracy, and writes both. */
int problem_converge(Problem *p, double accuracy, double from, double to, const char *file);
/* Reads them, of this problem or of the same scene in the plane; the state is the stage's then. */
int problem_load(Problem *p, const char *file);

/* Where the next corner of the drive is, or `to`. */
double problem_stop(const Problem *p, double t);
double cpu_now(void);

/* Starts and ends what is timed. */
void walk_begin(Walk *w, Problem *p, double limit);
void walk_end(Walk *w);
/* After a step to (t, y): renews candidates if it is time, and compares the force. Returns 1 if the run must end: the
 * force is not finite or the time is up (then `why` says so). */
int walk_step(Walk *w, double t, const double *y);
/* RMS over the time that was covered, and largest error, as shares of the reference's largest force. */
double walk_rms(const Walk *w);
double walk_worst(const Walk *w);

#endif
