#include "sim/run/statics.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"
#include "sim/newton/relax.h"

/* A load step may become this many times smaller than was asked for. */
static const double SMALLEST = 1.0 / 1024;

/* Newton's method at time t; y is put back if it does not get there. */
static hawser_status attempt(Stage *st, double t, double share, double *kept, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)st->motion->size * sizeof(double);
    memcpy(kept, st->y, bytes);
    hawser_status status = relax_static(&st->scene, &st->ws, &st->newton, t, share, st->y, out, err);
    if (status || out->reached) return status;
    memcpy(st->y, kept, bytes);
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

/* What keeps its place only for as long as a step takes: the slow way, then Newton's method from where it ends. */
static hawser_status slow_way(Stage *st, double t, double share, double *kept, hawser_relaxation *out,
                              hawser_error *err)
{
    const int spent = out->iterations;
    const hawser_status status = st->motion->ops->relax(st->motion, t, st->y, out, err);
    out->iterations += spent;
    return status ? status : attempt(st, t, share, kept, out, err);
}

/* Back to where it was: a rod without equilibrium stays where the case has put it. */
static hawser_status put_back(Stage *st, const double *start, hawser_relaxation *out, hawser_error *err)
{
    memcpy(st->y, start, (size_t)st->motion->size * sizeof *start);
    out->moved_m = 0;
    return st->motion->ops->renew(st->motion, st->t, st->y, err);
}

hawser_status statics_settle(Stage *st, double share, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)st->motion->size * sizeof(double);
    double *const kept = malloc(bytes), *const start = malloc(bytes);
    hawser_status status = kept && start ? HAWSER_OK : error_memory(err);
    if (!status) {
        memcpy(start, st->y, bytes);
        status = attempt(st, st->t, share, kept, out, err);
        if (!status && !out->reached && !rod_is_loose(&st->scene)) status = slow_way(st, st->t, share, kept, out, err);
        if (!status && !out->reached) status = put_back(st, start, out, err);
    }
    free(kept);
    free(start);
    return status;
}

static hawser_status stuck(const Stage *st, double t, const hawser_relaxation *r, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_RUN,
                     "no equilibrium was found under the loads of t = %.6g s: after t = %.6g s, %.3g N stay unbalanced "
                     "at segment %d (aim: %.3g N); is the rod held, or does it buckle there? More run.load_steps or "
                     "'analysis: dynamics' may help",
                     t, st->t, r->residual_N, r->segment, r->tolerance_N);
}

/* Steps are halved where Newton's method does not converge, and grow again behind. */
static hawser_status steps(Stage *st, double target, double *kept, hawser_relaxation *out, hawser_error *err)
{
    const double share = st->scene.def.analysis.tolerance, whole = target - st->t;
    double step = whole;
    hawser_status status = HAWSER_OK;
    while (!status && st->t < target) {
        const double next = step >= target - st->t ? target : st->t + step;
        status = attempt(st, next, share, kept, out, err);
        if (!status && !out->reached && step <= SMALLEST * whole) {
            if (!rod_is_loose(&st->scene)) status = slow_way(st, next, share, kept, out, err);
            if (!status && !out->reached) status = stuck(st, next, out, err);
        }
        if (status) return status;
        if (out->reached) {
            st->t = next;
            step *= 2;
            status = st->motion->ops->accept(st->motion, st->t, st->y, err);
        } else {
            step /= 2;
        }
    }
    return status;
}

hawser_status statics_advance(Stage *st, double target, hawser_relaxation *out, hawser_error *err)
{
    double *const kept = malloc((size_t)st->motion->size * sizeof *kept);
    if (!kept) return error_memory(err);
    const hawser_status status = steps(st, target, kept, out, err);
    free(kept);
    return status;
}
