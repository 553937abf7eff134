/* What holds a run up: why its steps are short, and where. Looked at over windows of so many steps, so that it is the
 * same of every run of a case, whatever the clock says. */
#ifndef HAWSER_SIM_RUN_STALL_H
#define HAWSER_SIM_RUN_STALL_H

#include "hawser/hawser.h"
#include "sim/scene.h"
#include "sim/solve/integrator.h"

enum {
    STALL_STEPS = 500,
    STALL_CRAWLS = 20
}; /* so many windows go less far than ten usual steps: nothing comes of it */

/* Since when: the integrator's counts and the time then. */
typedef struct StallFrom {
    long steps, error_fails, newton_fails, strides;
    double t; /* s */
} StallFrom;

typedef struct Stall {
    int left;       /* steps of this window that are still to come; 0: none has begun */
    StallFrom from; /* where the window began */
    int crawls; /* windows in a row whose steps were less than a thousandth of the longest window's, and that leave a
                 * hundred million to the end */
    double longest;      /* s, mean step of the window with the longest steps */
    hawser_hold slowest; /* of the windows so far; steps 0: none */
} Stall;

StallFrom stall_from(const Integrator *in, double t);
/* What has held the steps up since then, until t (s), where `longest` (s) is the longest that is allowed: counts and
 * cause. */
void stall_cause(const StallFrom *from, const Integrator *in, double t, double longest, hawser_hold *out);
/* Where: at out->cause "stride" the fastest segment of the scene's chain, else the one given, of those that are
 * simulated; and all of it in words. sample: of now, with all segments; roller, surface: names, [sample->rollers],
 * [sample->surfaces]. */
void stall_place(const Scene *scene, int segment, const hawser_sample *sample, const hawser_roller *roller,
                 const hawser_surface *surface, hawser_hold *out);
/* Whether it is where something moves fastest, not where the error is largest. */
int stall_by_speed(const hawser_hold *hold);
/* After each step of a run to `end`, s. Whether a window has ended whose steps were at most half as long as those of
 * the slowest one, which is to be asked for then: what held it up from stall->from on; and stall_begin. */
int stall_step(Stall *stall, const Integrator *in, double t, double end);
/* The window that begins now. */
void stall_begin(Stall *stall, const Integrator *in, double t);

#endif
