/* Mean and mean square of a value over time, by the trapezoidal rule over a window, and its peak over the whole run;
 * also the figures that its error bounds need: the variation while a segment of the mesh passes, and the sharpness of
 * the peak (docs/theory.md, "Error bars"). */
#ifndef HAWSER_SIM_TIME_MEAN_H
#define HAWSER_SIM_TIME_MEAN_H

#include <math.h>

/* Sums over a stretch of time of the value less `from`; `moment` sums that times the time since the beginning. */
typedef struct TimeBlock {
    double from, sum, square, moment, time; /* value; value s; value^2 s; value s^2; s */
} TimeBlock;

typedef struct TimeMean {
    double last, sum, square, time, peak; /* value; value s; value^2 s; s; largest value */
    int started;                          /* number of samples, at most 2 */
    /* whether the last sample was the peak; the value before it; second difference of the value at the peak */
    int at_peak;
    double before, sharpness;
    double rough, rough_at_peak; /* value^2: mean square of second differences up to the last sample, and up to the peak
                                  * (EB12) */
    TimeBlock block;             /* since mean_block */
    double wavered, blocks;      /* value^2 s, s: squared deviations from the blocks' own means, and durations, summed
                                  * over the blocks that have ended */
    double most;                 /* largest mean of a block that has ended; 0 if none has */
} TimeMean;

static const double ROUGH_FORGETS = 1.0 / 8; /* per sample: samples farther back than its inverse count little */

/* Adds a sample of `value`, dt (s) after the last one; it counts for the mean if `steady`. */
static inline void mean_add(TimeMean *m, double value, double dt, int steady)
{
    if (steady && m->started) {
        const double middle = (value + m->last) / 2, off = middle - m->block.from;
        m->sum += middle * dt;
        m->square += middle * middle * dt;
        m->time += dt;
        m->block.sum += off * dt;
        m->block.square += off * off * dt;
        m->block.moment += off * (m->block.time + dt / 2) * dt;
        m->block.time += dt;
    }
    const double second = m->before - 2 * m->last + value;
    if (m->started > 1) m->rough += ROUGH_FORGETS * (second * second - m->rough);
    if (m->at_peak) {
        m->sharpness = fabs(second);
        m->rough_at_peak = m->rough;
    }
    m->at_peak = !m->started || value > m->peak;
    if (m->at_peak) m->peak = value;
    m->before = m->started ? m->last : value;
    m->last = value;
    m->started = m->started ? 2 : 1; /* 2: there is a sample before the last one */
}

/* Adds a value between two samples that counts for the peak alone, with its sharpness. */
static inline void mean_raise(TimeMean *m, double value, double sharpness)
{
    if (!m->started || !(value > m->peak)) return;
    m->peak = value;
    m->sharpness = sharpness;
    m->rough_at_peak = m->rough;
    m->at_peak = 0;
}

static const double HELD_SHARP = 16; /* in second differences: an eighth of it is twice the difference of two steps */

/* Adds the value that two successive steps both reached, which counts for the peak alone (EB14): the lower of both. The
 * top of a parabola exceeds the higher one by no more than their difference. */
static inline void mean_held(TimeMean *m, double before, double now)
{
    mean_raise(m, fmin(now, before), HELD_SHARP * fabs(now - before));
}

/* Ends a block and begins the next one. */
static inline void mean_block(TimeMean *m)
{
    const TimeBlock *const b = &m->block;
    if (b->time > 0) {
        const double mean = b->from + b->sum / b->time;
        m->most = m->blocks > 0 ? fmax(m->most, mean) : mean;
        m->wavered += fmax(0, b->square - b->sum * b->sum / b->time);
        m->blocks += b->time;
    }
    m->block = (TimeBlock){.from = m->last};
}

/* Mean over the steady window; NAN before it. */
static inline double mean_of(const TimeMean *m) { return m->time > 0 ? m->sum / m->time : NAN; }

/* Largest value that lasts while a segment passes: the largest mean of a block; the overall mean if no block has ended
 * or none is above it; NAN before the steady window. */
static inline double mean_lasting(const TimeMean *m) { return m->blocks > 0 ? fmax(m->most, mean_of(m)) : mean_of(m); }

/* Root mean square deviation from the mean. */
static inline double mean_ripple(const TimeMean *m)
{
    const double mean = mean_of(m);
    return m->time > 0 ? sqrt(fmax(0, m->square / m->time - mean * mean)) : 0;
}

/* The same within blocks, without the changes from block to block. The ripple if no block has ended. */
static inline double mean_waver(const TimeMean *m)
{
    return m->blocks > 0 ? sqrt(m->wavered / m->blocks) : mean_ripple(m);
}

/* Waver that an unfinished block will show, of which a share `passed` is complete: the straight line is extended to the
 * whole block, and the deviation about it stays the same (EB9). */
static inline double mean_waver_ahead(const TimeMean *m, double passed)
{
    const TimeBlock *const b = &m->block;
    if (!(b->time > 0)) return 0;
    const double mean = b->sum / b->time, rise = 12 * (b->moment / b->time - b->sum / 2) / b->time;
    const double line = rise * rise / 12, about = fmax(0, b->square / b->time - mean * mean - line);
    return sqrt(about + line / (passed * passed));
}

#endif
