#include "sim/step/swings.h"

#include <math.h>

/* Of the largest pull: what a fall may lose to the steps, a tenth of what a peak that is trusted may be off by, at the
 * default accuracy or a coarser one; and what swings by less than that bounds no step. */
static const double LOST = 0.01, USUAL = 1e-3;
/* Of the third derivative's last top, a step later: between its tops lie four steps or more where (EB25) holds. */
static const double FADES = 0.8;
/* Steps become shorter than they must be, and longer when they may be by more than that: each change costs a matrix. */
static const double SHORTER = 0.9, LONGER = 1.4, MAY = 1.5;
/* Of the longest step without swings, at least: faster ones are the error test's alone. */
static const double LEAST = 1.0 / 16;

/* What a method of second order takes of a swing that falls in n steps, half of its period: pi^4/4n^3 of it (EB23). */
static void fall_record(Swings *s, double before, double pull)
{
    static const double HALF = M_PI * M_PI * M_PI * M_PI / 4;
    if (s->downward++ == 0) s->top = before;
    const double n = s->downward;
    s->fades = fmax(s->fades, fmin(1, HALF / (n * n * n)) * (s->top - pull));
}

/* h: the last step, s, that ended at t. */
static void rise_record(Swings *s, double before, double pull, double h, double t)
{
    if (s->downward > 0 || s->steps == 1) {
        s->bottom = before;
        s->risen_at = t - h;
        s->steepest = 0;
    }
    s->downward = 0;
    if (h > 0) s->steepest = fmax(s->steepest, (pull - before) / h);
}

/* Third derivative of the last four pulls, N/s^3; 0 where they waver by no more than what bounds no step. */
static double third_derivative(const Swings *s)
{
    double d[SWINGS_STEPS], least = INFINITY, most = -INFINITY;
    for (int i = 0; i < SWINGS_STEPS; ++i) {
        d[i] = s->pull[i];
        least = fmin(least, d[i]);
        most = fmax(most, d[i]);
    }
    if (!(most - least > LOST * s->largest)) return 0;
    for (int k = 1; k < SWINGS_STEPS; ++k)
        for (int i = SWINGS_STEPS - 1; i >= k; --i) d[i] = (d[i] - d[i - 1]) / (s->t[i] - s->t[i - k]);
    return 6 * fabs(d[SWINGS_STEPS - 1]);
}

/* (EB25), h: the last step, s. */
static void bound_set(Swings *s, const SolverDef *solver, double longest, double h)
{
    s->third = fmax(third_derivative(s), FADES * s->third);
    const double lost = LOST * fmin(1, solver->accuracy / USUAL) * s->largest;
    const double may = fmax(cbrt(lost / (M_PI / 2) / s->third), LEAST * longest); /* INFINITY: nothing swings */
    const double bound = s->bound > 0 ? s->bound : INFINITY;
    if (may < fmin(bound, h)) {
        s->bound = fmax(SHORTER * may, LEAST * longest);
    } else if (may > MAY * bound) {
        s->bound = LONGER * bound < longest ? LONGER * bound : 0;
    }
}

void swings_step(Swings *s, const Scene *scene, double t, double pull)
{
    const SolverDef *const solver = &scene->def.solver;
    const double longest = solver->max_step > 0 ? solver->max_step : scene->def.output.interval;
    const double before = s->pull[SWINGS_STEPS - 1], h = t - s->t[SWINGS_STEPS - 1];
    for (int i = 1; i < SWINGS_STEPS; ++i) {
        s->t[i - 1] = s->t[i];
        s->pull[i - 1] = s->pull[i];
    }
    s->t[SWINGS_STEPS - 1] = t;
    s->pull[SWINGS_STEPS - 1] = pull;
    s->largest = fmax(s->largest, fabs(pull));
    if (pull < before) {
        fall_record(s, before, pull);
    } else {
        rise_record(s, before, pull, h, t);
    }
    if (s->steps <= SWINGS_STEPS) ++s->steps; /* more are not counted: a run may have any number */
    if (s->steps > SWINGS_STEPS && longest > 0 && h > 0) bound_set(s, solver, longest, h);
}

double swings_rise(const Swings *s) { return (s->downward > 0 ? s->top : s->pull[SWINGS_STEPS - 1]) - s->bottom; }
