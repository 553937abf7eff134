#include "sim/watch/steady.h"

#include <math.h>

/* s, in which a jolt at t = 0 runs through the chain and back twice, sqrt(m/k) a segment; up to the first row behind t
 * = 0 at least. */
static double first_moments(const Scene *scene)
{
    const Chain *const chain = &scene->chain;
    double once = 0;
    for (int i = 0; i < chain->n; ++i) {
        const double k = chain->stiffness[0][i];
        if (k > 0) once += sqrt(chain->mass[i] / k);
    }
    return fmax(4 * once, 1.5 * scene->def.output.interval);
}

/* Which of the rows is the largest shows when the one behind it is there. */
static void row_record(Steadiness *s, double pull, double t, double dt)
{
    if (!(t > 0)) s->row[0] = s->row[1] = s->peak = -INFINITY;
    if (s->row[1] > s->peak) {
        s->peak = s->row[1];
        s->beside = fmax(s->row[0], pull);
        s->peak_at = t - dt;
    }
    s->row[0] = s->row[1];
    s->row[1] = pull;
    s->last = t;
}

double steadiness_spike(const Steadiness *s, double *at)
{
    const int ends = s->row[1] > s->peak; /* the run ends at its largest pull: nothing is behind it */
    const double peak = ends ? s->row[1] : s->peak, beside = ends ? s->row[0] : s->beside;
    *at = ends ? s->last : s->peak_at;
    return peak > 0 && isfinite(beside) ? (peak - beside) / peak : 0;
}

void steadiness_record(Steadiness *s, const Scene *scene, const hawser_sample *sample, double dt)
{
    const double from = scene->def.output.steady_from, middle = (from + scene->def.duration) / 2;
    row_record(s, sample->winch_force, sample->t, dt);
    if (!(s->first > 0)) s->first = first_moments(scene);
    if (!(sample->t > 0)) s->speed = sample->winch_speed;
    double *const largest = sample->t <= s->first ? &s->jolt : &s->later;
    if (sample->winch_force > *largest) {
        *largest = sample->winch_force;
        if (largest == &s->jolt) s->jolt_at = sample->t;
    }
    if (!(sample->t - dt >= from - 1e-9)) return;
    HalfWindow *const half = &s->half[sample->t - dt / 2 > middle];
    half->pull += sample->winch_force * dt;
    half->time += dt;
    if (isnan(sample->reference)) return;
    half->theory += sample->reference * dt;
    half->theory_time += dt;
}

double steadiness_drift(const Steadiness *s)
{
    const HalfWindow *const a = &s->half[0], *const b = &s->half[1];
    if (!(a->time > 0 && b->time > 0)) return 0;
    const double change = b->pull / b->time - a->pull / a->time;
    const int known = a->theory_time > 0 && b->theory_time > 0;
    const double expected = known ? b->theory / b->theory_time - a->theory / a->theory_time : 0;
    const double mean = fabs(a->pull + b->pull) / (a->time + b->time);
    return fmin(fabs(change), fabs(change - expected)) / fmax(fmax(mean, 0.1 * fmax(s->jolt, s->later)), 1e-6);
}
