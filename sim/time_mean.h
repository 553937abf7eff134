/* Mean and mean square of a value over time, by the trapezoidal rule over a window, with its peak over the whole run.
 */
#ifndef HAWSER_SIM_TIME_MEAN_H
#define HAWSER_SIM_TIME_MEAN_H

#include <math.h>

typedef struct TimeMean {
    double last, sum, square, time, peak; /* value; value s; value^2 s; s; largest value */
    int started;
} TimeMean;

/* A sample of `value`, dt (s) after the last one; it counts for the mean if `steady`. */
static inline void mean_add(TimeMean *m, double value, double dt, int steady)
{
    if (steady && m->started) {
        const double middle = (value + m->last) / 2;
        m->sum += middle * dt;
        m->square += middle * middle * dt;
        m->time += dt;
    }
    if (!m->started || value > m->peak) m->peak = value;
    m->last = value;
    m->started = 1;
}

static inline double mean_of(const TimeMean *m) { return m->time > 0 ? m->sum / m->time : m->last; }

/* Root mean square deviation from the mean. */
static inline double mean_ripple(const TimeMean *m)
{
    const double mean = mean_of(m);
    return m->time > 0 ? sqrt(fmax(0, m->square / m->time - mean * mean)) : 0;
}

#endif
