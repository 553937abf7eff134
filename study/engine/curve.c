/* A run's winch force by the place of the cable's head, as a log of it would have it: docs/model/96-measured-pulls.md,
 * "Fit". */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "io/api/api_handles.h"
#include "study/engine/engine.h"

/* After each step. A second pass begins anew: its results are those of the run. */
static int step_add(void *user, hawser_sim *sim, double t)
{
    RunCurve *const c = user;
    const Stage *const st = &sim->stage;
    const hawser_sample *const now = hawser_sim_sample(sim);
    const double at = st->scene.def.head_at + now->winch_travel;
    if (t < c->time) c->n = 0;
    c->time = t;
    if (c->n > 0 && !(at > c->point[c->n - 1].at)) return 0; /* at rest */
    if (c->n == c->room) {
        CurvePoint *const more = realloc(c->point, (2 * (size_t)c->room + 256) * sizeof *more);
        if (!more) return 1;
        c->point = more;
        c->room = 2 * c->room + 256;
    }
    CurvePoint *const p = &c->point[c->n];
    *p = (CurvePoint){at, now->winch_force, 0};
    if (c->n > 0) p->area = p[-1].area + (at - p[-1].at) * (p->force + p[-1].force) / 2;
    c->n++;
    return 0;
}

void curve_begin(RunCurve *c, hawser_sim *sim)
{
    *c = (RunCurve){.time = -INFINITY};
    hawser_sim_on_step(sim, step_add, c);
}

void curve_free(RunCurve *c) { free(c->point); }

/* The integral of the force from the curve's beginning to `at`, which lies within. */
static double area_to(const RunCurve *c, double at)
{
    int low = 0, high = c->n - 1;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(c->point[middle].at <= at ? &low : &high) = middle;
    }
    const CurvePoint *const p = &c->point[low], *const q = &c->point[high];
    const double share = (at - p->at) / (q->at - p->at);
    return p->area + (at - p->at) * (p->force + share * (q->force - p->force) / 2);
}

/* Means over parts as wide as the log's (LO10). */
int curve_take(const RunCurve *c, const Measured *m, double *force, char *why, size_t size)
{
    const double from = c->n > 1 ? c->point[0].at : NAN, to = c->n > 1 ? c->point[c->n - 1].at : NAN;
    for (int k = 0; k < m->n; k++) {
        const double at = m->point[k].at;
        if (!(at >= from && at <= to)) {
            snprintf(why, size,
                     "the run has the cable's head from %.4g to %.4g m along the route, the log at %.4g m: give "
                     "calibrate 'from' and 'to', or run.duration more",
                     from, to, at);
            return 0;
        }
        const double a = fmax(from, at - m->width / 2), b = fmin(to, at + m->width / 2);
        force[k] = (area_to(c, b) - area_to(c, a)) / (b - a);
    }
    return 1;
}
