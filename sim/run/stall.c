#include "sim/run/stall.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "core/vec3.h"

/* Shares of a window's steps from which on something is the cause of short steps; share of the longest allowed step. */
static const double FAILS_MANY = 0.1, STRIDES_MANY = 0.5, LONGEST_NEAR = 0.8;
static const double CRAWL = 1e-3;   /* of the longest window's mean step */
static const double FOR_EVER = 1e8; /* steps to the end */

StallFrom stall_from(const Integrator *in, double t)
{
    IntegratorStats now;
    integrator_stats(in, &now);
    return (StallFrom){now.steps, now.error_fails, now.newton_fails, now.strides, t};
}

static Vec3 place_of(const hawser_sample *sample, int segment)
{
    const double *const p = sample->position + 3 * segment;
    return (Vec3){p[0], p[1], p[2]};
}

/* The segment that moves fastest, m/s. */
static int fastest_segment(const hawser_sample *sample)
{
    double most = -1;
    int fastest = sample->first;
    for (int i = sample->first; i < sample->first + sample->active; ++i) {
        const double *const v = sample->velocity + 3 * i, speed = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
        if (speed > most) fastest = i;
        most = fmax(most, speed);
    }
    return fastest;
}

/* The contact that carries force and is nearest to a segment: a roller within a few segments, or a surface along which
 * the segment is. "" without one. */
static void contact_at(const Scene *scene, const hawser_sample *sample, const hawser_roller *roller,
                       const hawser_surface *surface, int segment, char where[HAWSER_WHERE_MAX])
{
    const int i = segment - scene->first;
    const double half = i >= 0 && i < scene->chain.n ? scene->chain.half[i] : scene->chain.half[0];
    const double s = scene->joint_s[segment] + sample->winch_travel;
    double nearest = 3 * half;
    *where = 0;
    for (int k = 0; k < sample->surfaces; ++k) {
        if (!(sample->surface_normal[k] > 0) || s < surface[k].from_m - half || s > surface[k].to_m + half) continue;
        snprintf(where, HAWSER_WHERE_MAX, "%.60s", surface[k].name);
    }
    for (int r = 0; r < sample->rollers; ++r) {
        if (!(sample->roller_load[r] > 0)) continue;
        const Vec3 from = v3_sub(place_of(sample, segment), scene->rollers[r].shape.centre);
        const double away = v3_norm(from) - scene->rollers[r].shape.radius;
        if (!(away < nearest)) continue;
        nearest = away;
        snprintf(where, HAWSER_WHERE_MAX, "%.60s", roller[r].name);
    }
}

static const char *cause_of(const hawser_hold *h, double longest)
{
    const double steps = fmax(1, (double)h->steps), newton = (double)h->newton_fails / steps,
                 error = (double)h->error_fails / steps;
    if (newton > FAILS_MANY && newton >= error) return "newton";
    if (error > FAILS_MANY) return "error test";
    if ((double)h->strides > STRIDES_MANY * steps) return "stride";
    return longest > 0 && h->step_s > LONGEST_NEAR * longest ? "longest step" : "accuracy";
}

/* Writes the cause as text. */
static void cause_say(const hawser_hold *h, double longest, char *says, size_t size)
{
    if (!strcmp(h->cause, "newton"))
        snprintf(says, size, "Newton's iteration did not converge in %ld of %ld", h->newton_fails, h->steps);
    else if (!strcmp(h->cause, "error test"))
        snprintf(says, size, "the error test was failed %ld times in %ld", h->error_fails, h->steps);
    else if (stall_by_speed(h))
        snprintf(says, size, "a point of the chain may not move farther in one (N14): %ld of %ld", h->strides,
                 h->steps);
    else if (!strcmp(h->cause, "longest step"))
        snprintf(says, size, "no step may be longer than %.3g s (solver.max_step, or output.interval)", longest);
    else
        snprintf(says, size, "longer ones would be less exact than solver.accuracy");
}

int stall_by_speed(const hawser_hold *hold) { return !strcmp(hold->cause, "stride"); }

void stall_cause(const StallFrom *from, const Integrator *in, double t, double longest, hawser_hold *out)
{
    const StallFrom now = stall_from(in, t);
    *out = (hawser_hold){.from_s = from->t,
                         .to_s = now.t,
                         .steps = now.steps - from->steps,
                         .error_fails = now.error_fails - from->error_fails,
                         .newton_fails = now.newton_fails - from->newton_fails,
                         .strides = now.strides - from->strides};
    out->step_s = (now.t - from->t) / fmax(1, (double)out->steps);
    snprintf(out->cause, sizeof out->cause, "%s", cause_of(out, longest));
    cause_say(out, longest, out->says, sizeof out->says);
}

void stall_place(const Scene *scene, int segment, const hawser_sample *sample, const hawser_roller *roller,
                 const hawser_surface *surface, hawser_hold *out)
{
    const char *const chain = scene->def.strand.name;
    char why[128];
    snprintf(why, sizeof why, "%.127s", out->says);
    out->segment = stall_by_speed(out) ? fastest_segment(sample) : scene->first + segment;
    contact_at(scene, sample, roller, surface, out->segment, out->where);
    snprintf(out->chain, sizeof out->chain, "%s", chain);
    snprintf(out->says, sizeof out->says, "steps of %.3g s at t = %.6g s: %s; %s at segment %d of %d%s%s%s%s%s%s",
             out->step_s, out->to_s, why, stall_by_speed(out) ? "fastest" : "worst", out->segment, scene->total,
             *chain ? " of chain '" : "", chain, *chain ? "'" : "", *out->where ? ", on '" : "", out->where,
             *out->where ? "'" : "");
}

void stall_begin(Stall *stall, const Integrator *in, double t)
{
    stall->from = stall_from(in, t);
    stall->left = STALL_STEPS;
}

int stall_step(Stall *stall, const Integrator *in, double t, double end)
{
    if (stall->left == 0) {
        stall_begin(stall, in, t);
        return 0;
    }
    if (--stall->left > 0) return 0;
    const StallFrom now = stall_from(in, t);
    const double step = (t - stall->from.t) / fmax(1, (double)(now.steps - stall->from.steps));
    stall->longest = fmax(stall->longest, step);
    const int crawls = step < CRAWL * stall->longest && end - t > FOR_EVER * step && isfinite(end);
    stall->crawls = crawls ? stall->crawls + 1 : 0;
    if (stall->slowest.steps == 0 || step < 0.5 * stall->slowest.step_s) return 1;
    stall_begin(stall, in, t);
    return 0;
}
