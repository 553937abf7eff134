/* What the figures of a run may be off by: of the steps in time, of the mesh, of friction that vanishes at rest. From
 * what a run sees of itself, without a second one. docs/model.md, "Error bars". */
#ifndef HAWSER_SIM_WATCH_ERROR_BARS_H
#define HAWSER_SIM_WATCH_ERROR_BARS_H

#include "hawser/hawser.h"
#include "sim/scene.h"
#include "sim/time_mean.h"
#include "sim/watch/balance.h"
#include "theory/mesh.h"

/* What all figures of a run share: parts of a force, and of its wavering, 1. */
typedef struct ErrorShares {
    double time;   /* of a mean: what the books of the window leave open or have lost (EB2) */
    double step;   /* of a peak: the tolerance of a step (EB4) */
    double waver;  /* what of a figure's wavering is the mesh's (EB1) */
    double passed; /* of a segment, while nothing has been wavering for a whole one */
    double still;  /* N: what a tension may waver by besides, then (EB9) */
    double placed; /* N: what the places of joints over rollers made of the peak (EB11) */
    double rough;  /* what of second differences is the error of a peak (EB12) */
    double slack,
        at_rest; /* of a peak's height above the mean and above the pull at rest, N, that what hung slack made (EB15) */
    double faded;  /* N: what steps have taken from a swing before the peak (EB23) */
    double blow;   /* N: what the peak owes to segments that a wave must run through, or a clamp holds (EB26), (EB31) */
    double missed; /* N: what rows do not see of a mean (EB33) */
    double drift;  /* of a mean, between the halves of its window, if that is refused (EB17) */
    double start;  /* N: with which a chain that did not come to rest begins inside a body (EB18) */
    double stands_out; /* of a peak: a spike or jolt that is refused (EB16) */
    double mesh;       /* what the places of the route and the head ask of segments (EB3), (EB6) */
    double friction;   /* not yet there at the speed of the pull (EB5) */
    /* by which friction falls once the cable slides, of what is left; m/s, the speed where it has; the share again, if
     * a peak is of a cable that breaks loose (EB10) */
    double falls, falls_until, breaks_loose;
} ErrorShares;

/* books: NULL where nothing has moved; pull: mean of the steady window, N. */
ErrorShares error_shares(const Scene *scene, const Mesh *mesh, const BalanceWindow *books, double pull);

/* What a load of 1 N on the r-th roller takes from those beside the cable once it does not creep across it any more, N
 * of the pull (EB13). */
double held_sideways(const Scene *scene, int r);
/* What a peak owes to the length that hung slack, which nobody knows better than the mesh does; travel: of the winch up
 * to then, m; rest: the pull at first, N (EB15). */
double slack_share(const Scene *scene, double travel, double rest);
/* Of the mean over the steady window; of the largest value of the run. */
hawser_error_bar error_of_mean(const TimeMean *figure, const ErrorShares *shares);
hawser_error_bar error_of_peak(const TimeMean *figure, const ErrorShares *shares);

#endif
