/* Comparison of the passes of one run: each is a level finer in time and length than the one before (docs/theory.md,
 * "Error bars", (EB19), (EB20), (EB27) to (EB30)), so that the difference of a figure measures its error. */
#ifndef HAWSER_SIM_RUN_PASSES_H
#define HAWSER_SIM_RUN_PASSES_H

#include "hawser/hawser.h"
#include "sim/run/stats.h"

enum { PASSES_MAX = 3 };

/* Text on a run's passes, and storage for their figures. */
typedef struct PassesSaid {
    hawser_passes said;
    hawser_pass pass[PASSES_MAX];
    double peak_alone[PASSES_MAX]; /* N: for each pass, the part of time and mesh in its own bound of the peak pull */
} PassesSaid;

/* Figures of a finished pass with their error bounds: mean and peak of the pull (N; of their bounds the part of time
 * and mesh), mean and peak at stations (N), steady and largest load of rollers (N), line load of surfaces (N/m), in the
 * order of the tables. Zeroed: none. */
typedef struct PassFigures {
    int n;
    double *value, *bar; /* [n], owned in one piece by value */
    double jolt;         /* N, jolt at the start; NAN: none (EB22) */
} PassFigures;

/* jolt: at the pass's start, N, or NAN. Errors: MEMORY. */
hawser_status pass_figures_take(PassFigures *out, const Stats *stats, const hawser_summary *figures, double jolt,
                                hawser_error *err);
void pass_figures_free(PassFigures *f);

/* The other passes, as known to the pass whose results are shown, which is the first or the last. Zeroed: there is no
 * other one. */
typedef struct OtherPasses {
    int n;                             /* number of others */
    int finer;                         /* 1: the others are finer */
    int unsound;                       /* 1: the last one fails a condition itself and therefore narrows no bound */
    PassFigures other[PASSES_MAX - 1]; /* the finest first; one is enough if they are finer */
    double peak_alone[PASSES_MAX];     /* N: as in PassesSaid, the finest first */
} OtherPasses;

void other_passes_free(OtherPasses *others);
/* Updates the error bounds of summary and tables by all passes; jolt: at this one's start, N, or NAN. */
void other_passes_bars(const OtherPasses *others, const Stats *stats, double jolt, hawser_summary *figures);
/* Largest share of the mean pull that the segment lengths can have added by the comparison; INFINITY: there is no other
 * pass. */
double other_passes_share(const OtherPasses *others, const hawser_summary *figures);
/* Difference of the pull's mean, or its peak, from that of the finest pass, N; 0: there is none. */
double other_passes_apart(const OtherPasses *others, int peak, const hawser_summary *figures);

#endif
