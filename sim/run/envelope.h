/* What a run has made of the cable in all its time: least, mean and largest of tension, curvature and sidewall
 * pressure, by arc length (each joint wherever it was) and by place along the route (whatever cable was there). Taken
 * in with each row of output; the memory does not grow with the run. */
#ifndef HAWSER_SIM_RUN_ENVELOPE_H
#define HAWSER_SIM_RUN_ENVELOPE_H

#include "sim/run/sample.h"
#include "sim/run/stats.h"

/* [n] each; NAN: there was none. The mean is over time, each value standing for the time since the last one. */
typedef struct Extremes {
    double *least, *mean, *largest;
} Extremes;

typedef struct EnvelopeLine {
    int n;
    double *s;                             /* m: from the tail, unstretched; or along the route */
    double *time;                          /* s, over which the means are */
    Extremes tension, curvature, sidewall; /* N, 1/m, N/m */
} EnvelopeLine;

typedef struct Envelope {
    int present;
    double last;             /* s, of the last sample; < 0: none */
    double step;             /* m, between places */
    EnvelopeLine arc, place; /* [joints of the whole chain]; from the route's start to its end; none of a rod */
    double *at;              /* [joints] m along the route: scratch */
    double *memory;          /* owned */
} Envelope;

/* Places are this far apart, m, but never more than so many. */
#define ENVELOPE_STEP 0.25
enum { ENVELOPE_PLACES_MAX = 4000 };

/* Errors: MEMORY. */
hawser_status envelope_new(Envelope *e, const Scene *scene, hawser_error *err);
void envelope_free(Envelope *e);
/* Takes a sample with its fields in. By place counts the cable alone, up to its eye; wound cable and rope that was
 * taken in count nowhere. A sample that is not new changes nothing. */
void envelope_record(Envelope *e, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);

#endif
