/* What the passes of one run say of each other: each is a level finer in time and length than the one before
 * (docs/model.md, "Error bars", (EB19), (EB20), (EB27) to (EB30)), so that the difference of a figure measures its
 * error.
 */
#ifndef HAWSER_SIM_RUN_PASSES_H
#define HAWSER_SIM_RUN_PASSES_H

#include "hawser/hawser.h"
#include "sim/run/stats.h"

enum { PASSES_MAX = 3 };

/* What is said of a run's passes, with room for their figures. */
typedef struct PassesSaid {
    hawser_passes said;
    hawser_pass pass[PASSES_MAX];
    double peak_alone[PASSES_MAX]; /* N: of each one's own bar of the pull's peak the part of time and mesh */
} PassesSaid;

/* The figures of a pass that is over, and what they may be off by: mean and peak of the pull (N; of their bars the part
 * of time and mesh), mean and peak at stations (N), steady and largest load of rollers (N), line load of surfaces
 * (N/m), in the order of the tables. Zeroed: there is none. */
typedef struct PassFigures {
    int n;
    double *value, *bar; /* [n], owned in one piece by value */
    double jolt;         /* N, of its start; NAN: there is none (EB22) */
} PassFigures;

/* jolt: of the pass's start, N, or NAN. Errors: MEMORY. */
hawser_status pass_figures_take(PassFigures *out, const Stats *stats, const hawser_summary *figures, double jolt,
                                hawser_error *err);
void pass_figures_free(PassFigures *f);

/* What the pass whose results are shown knows of the others. It is the first of them or the last. Zeroed: there is no
 * other one. */
typedef struct OtherPasses {
    int n;                             /* how many */
    int finer;                         /* they are the finer ones */
    int unsound;                       /* the last fails a condition itself: then it makes no bar narrower */
    PassFigures other[PASSES_MAX - 1]; /* the finest of them first; one is enough if they are finer */
    double peak_alone[PASSES_MAX];     /* N: the same as of PassesSaid, the finest first */
} OtherPasses;

void other_passes_free(OtherPasses *others);
/* Brings the error bars of summary and tables to what all passes say; jolt: of this one's start, N, or NAN. */
void other_passes_bars(const OtherPasses *others, const Stats *stats, double jolt, hawser_summary *figures);
/* The largest share of the mean pull that lengths of segments can have added by them; INFINITY: there is no other pass.
 */
double other_passes_share(const OtherPasses *others, const hawser_summary *figures);
/* By how much the pull's mean, or its peak, differs from that of the finest of them, N; 0: there is none. */
double other_passes_apart(const OtherPasses *others, int peak, const hawser_summary *figures);

#endif
