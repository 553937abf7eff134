/* What a run's peaks say of single rollers; see sim/watch/peaks.h. */
#ifndef HAWSER_SIM_WATCH_OVERLOAD_H
#define HAWSER_SIM_WATCH_OVERLOAD_H

/* The overload factor of eq. 12 at one roller. */
typedef struct Overload {
    const char *name;       /* the scene's */
    double s;               /* m along the route */
    double peak, reference; /* N; reference: at speed, by the reference theory */
    double alpha;           /* peak / reference; NAN where there is no measure */
} Overload;

#endif
