/* What two passes of one run say of each other: the second is a level finer in time and length (docs/model.md, "Error
 * bars", (EB19), (EB20)), so that the difference of a figure measures its error. */
#ifndef HAWSER_SIM_RUN_PASSES_H
#define HAWSER_SIM_RUN_PASSES_H

#include "hawser/hawser.h"
#include "sim/watch/stats.h"

/* What is said of a run's passes, with room for their figures. */
typedef struct PassesSaid {
    hawser_passes said;
    hawser_pass pass[2];
} PassesSaid;

/* The figures of the other pass, in the order of the tables. Zeroed: there is none. */
typedef struct OtherPass {
    int present;
    int finer;                            /* it is the second one */
    int unsound;                          /* it fails a condition itself: then it makes no bar narrower */
    double mean, peak;                    /* N, of the pull */
    double jolt;                          /* N, of its start; NAN: there is none (EB22) */
    double *station, *roller, *line_load; /* [2 n] mean and peak, N; [2 n]; [n] N/m; owned */
    int n_stations, n_rollers, n_surfaces;
} OtherPass;

/* The figures of a run that is over, for the other pass's sake; jolt: of its start, N, or NAN. Errors: MEMORY. */
hawser_status other_pass_take(OtherPass *out, const Stats *stats, const hawser_summary *figures, double jolt, int finer,
                              int unsound, hawser_error *err);
void other_pass_free(OtherPass *other);
/* Brings the error bars of summary and tables to what both passes say; jolt: of this one's start, N, or NAN. */
void other_pass_bars(const OtherPass *other, const Stats *stats, double jolt, hawser_summary *figures);
/* The largest share of the mean pull that lengths of segments can have added by it; INFINITY: there is no other pass.
 */
double other_pass_share(const OtherPass *other, const hawser_summary *figures);

#endif
