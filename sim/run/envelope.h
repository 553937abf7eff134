/* Least, mean and largest tension, curvature and sidewall pressure of the cable over the whole run, by arc length (each
 * joint wherever it was) and by place along the route (whatever cable was there). Updated with each row of output; the
 * memory does not grow with the run. */
#ifndef HAWSER_SIM_RUN_ENVELOPE_H
#define HAWSER_SIM_RUN_ENVELOPE_H

#include "sim/run/sample.h"
#include "sim/run/stats.h"

/* [n] each; NAN: no value. The mean is over time; each value counts for the time since the last one. */
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
    EnvelopeLine arc, place; /* [joints of the whole chain]; from the route's start to its end; not for a rod */
    double *at;              /* [joints] m along the route: scratch */
    double *memory;          /* owned */
} Envelope;

/* Distance of places, m, and their largest number, which has priority. */
#define ENVELOPE_STEP 0.25
enum { ENVELOPE_PLACES_MAX = 4000 };

/* Errors: MEMORY. */
hawser_status envelope_new(Envelope *e, const Scene *scene, hawser_error *err);
void envelope_free(Envelope *e);
/* Adds a sample with its fields. By place, only the cable counts, up to its eye; cable on the reel and rope that was
 * taken in are left out. A sample that is not new changes nothing. */
void envelope_record(Envelope *e, const Scene *scene, const Kinematics *kin, const hawser_sample *sample);

#endif
