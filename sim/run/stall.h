/* Causes of short steps in a run, and their place. Windows have a fixed number of steps, so that the result is the same
 * in every run of a case, independent of the clock. */
#ifndef HAWSER_SIM_RUN_STALL_H
#define HAWSER_SIM_RUN_STALL_H

#include "hawser/hawser.h"
#include "sim/scene.h"
#include "sim/solve/integrator.h"

enum {
    STALL_STEPS = 500,
    STALL_CRAWLS = 20
}; /* number of windows that advance less than ten usual steps: the run makes no progress */

/* Beginning of a window: the integrator's counts and the time. */
typedef struct StallFrom {
    long steps, error_fails, newton_fails, strides;
    double t; /* s */
} StallFrom;

typedef struct Stall {
    int left;       /* steps still to come in this window; 0: none has begun */
    StallFrom from; /* where the window began */
    int crawls; /* windows in a row whose steps were less than a thousandth of the longest window's, and with which a
                 * hundred million steps remain to the end */
    double longest;      /* s, mean step of the window with the longest steps */
    hawser_hold slowest; /* among the windows so far; steps 0: none */
} Stall;

StallFrom stall_from(const Integrator *in, double t);
/* Finds the cause of short steps since `from`, until t (s), where `longest` (s) is the longest allowed step: counts and
 * cause. */
void stall_cause(const StallFrom *from, const Integrator *in, double t, double longest, hawser_hold *out);
/* Finds the place: for out->cause "stride" the fastest segment of the scene's chain, else the given one, among those
 * that are simulated; writes the text. sample: of the present, with all segments; roller, surface: names,
 * [sample->rollers], [sample->surfaces]. */
void stall_place(const Scene *scene, int segment, const hawser_sample *sample, const hawser_roller *roller,
                 const hawser_surface *surface, hawser_hold *out);
/* Checks whether the place is where something moves fastest, not where the error is largest. */
int stall_by_speed(const hawser_hold *hold);
/* Called after each step of a run to `end`, s. Checks whether a window has ended whose steps were at most half as long
 * as those of the slowest one; if so the cause since stall->from is to be found, and stall_begin called. */
int stall_step(Stall *stall, const Integrator *in, double t, double end);
/* Begins a window now. */
void stall_begin(Stall *stall, const Integrator *in, double t);

#endif
