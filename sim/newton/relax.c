#include "sim/newton/relax.h"

#include <float.h>
#include <limits.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"

/* The largest change that one iteration may make. */
static const double MOVE_MAX = 0.05, TURN_MAX = 0.1;                   /* m, rad */
static const double DT_FIRST = 1e-2, DT_LARGEST = 1e8, DT_GROWTH = 10; /* s, s, 1 */
/* The careful variant (E4): the shortest step, and how much a residual may grow in one. */
static const double DT_SMALLEST = 1e-4, JUMP = 4;
/* Contacts made soft (E5): the first share of their stiffness, its growth from stage to stage; a stage ends at this
 * share of the loads, or after so many iterations. */
static const double SOFTEST = 1e-3, SOFT_GROWTH = 10, SOFT_AIM = 1e-2;
enum { SOFT_ITERATIONS = 60 };

/* What is relaxed. */
typedef struct Relaxing {
    const RelaxOps *ops;
    void *self;
    const StopCheck *stop;
    int soft; /* contacts are, for now */
    const SolverDef *def;
    int touches;          /* there are rollers or surfaces */
    int size;             /* of the state */
    double *y;            /* [size] */
    double *start, *back; /* [size] state before; before the last move */
} Relaxing;

RelaxStride relax_stride(const Scene *scene)
{
    const double half = scene_way(scene) / 2;
    return (RelaxStride){fmin(MOVE_MAX, half), TURN_MAX, half};
}

double relax_shorten(const RelaxStride *most, double scale, double move, double turn, double half)
{
    const double alone = fmin(most->move / (move + 1e-300), most->turn / (turn + 1e-300));
    return fmin(scale, fmin(alone, most->sweep / (half * turn + 1e-300)));
}

hawser_status relax_stopped(const StopCheck *stop, int soft, hawser_error *err)
{
    if ((soft && stop->firm) || !stop_wanted(stop)) return HAWSER_OK;
    return error_set(err, HAWSER_STOPPED, "stopped on the way to equilibrium");
}

double relax_farthest(int n, int pitch, int dims, const double *y, const double *from)
{
    double far = 0;
    for (int i = 0; i < n; ++i) {
        double square = 0;
        for (int k = i; k < dims * pitch; k += pitch) {
            const double away = y[k] - (from ? from[k] : 0);
            square += away * away;
        }
        far = fmax(far, sqrt(square));
    }
    return far;
}

double relax_rounding(const Scene *scene, double far)
{
    const Chain *const chain = &scene->chain;
    const int joints = chain->n + scene->rod->present; /* the head's end of a rod counts as its tail's does */
    double force = 0;
    for (int j = 0; j < joints; ++j) {
        const double half = chain->half[j < chain->n ? j : chain->n - 1];
        force = fmax(force, far * chain->stiffness[0][j]);
        for (int c = 3; c < 6; ++c) force = fmax(force, chain->stiffness[c][j] / half); /* quaternions are of size 1 */
    }
    return 16 * DBL_EPSILON * force;
}

double relax_tolerance(const Scene *scene, double t, double far)
{
    const Chain *const chain = &scene->chain;
    double load = fmax(fabs(profile_value(&scene->tail, t)), rod_load_size(scene->rod, chain, t));
    for (int i = 0; i < chain->n; ++i) load = fmax(load, chain->mass[i] * v3_norm(scene->weight.gravity));
    return fmax(scene->def.solver.relax_tolerance * load, relax_rounding(scene, far));
}

/* The continuation in time: the step grows as the residual falls, until it is Newton's method (E3). Goes on until the
 * residual is below `aim` or `limit` iterations are spent. */
static hawser_status iterate(Relaxing *r, double aim, int limit, hawser_relaxation *out, hawser_error *err)
{
    double dt = DT_FIRST;
    out->residual_N = r->ops->residual(r->self, &out->segment);
    for (int spent = 0; spent < limit && !(out->residual_N <= aim); ++spent) {
        const hawser_status stopped = relax_stopped(r->stop, r->soft, err);
        if (stopped) return stopped;
        ++out->iterations;
        const int bad = r->ops->implicit_step(r->self, dt);
        if (bad < 0) return error_memory(err);
        if (bad) {
            dt /= DT_GROWTH;
        } else {
            r->ops->move(r->self, r->ops->move_scale(r->self, dt) * dt);
        }
        const hawser_status status = r->ops->refresh(r->self, 0, err);
        if (status) return status;
        const double before = out->residual_N;
        out->residual_N = r->ops->residual(r->self, &out->segment);
        const double growth = before / out->residual_N;
        dt = fmin(DT_LARGEST, dt * fmin(DT_GROWTH, fmax(1 / DT_GROWTH, growth > 1 ? 2 * growth : growth)));
    }
    out->reached = out->residual_N <= out->tolerance_N;
    return HAWSER_OK;
}

/* One careful step of *dt: taken if nothing would move too far and the residual does not jump up, else taken back; *dt
 * becomes what to try next (E4). */
static hawser_status careful_step(Relaxing *r, double *dt, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)r->size * sizeof(double);
    const int bad = r->ops->implicit_step(r->self, *dt);
    if (bad < 0) return error_memory(err);
    const double before = out->residual_N, scale = bad ? 0 : r->ops->move_scale(r->self, *dt);
    if (scale < 0.3 && *dt > DT_SMALLEST) {
        *dt = fmax(DT_SMALLEST, *dt * fmax(0.03, sqrt(scale))); /* what has no stiffness moves as dt^2 */
        r->ops->residual(r->self, &out->segment);               /* the step has overwritten the rates */
        return HAWSER_OK;
    }
    memcpy(r->back, r->y, bytes);
    if (scale > 0) r->ops->move(r->self, scale * *dt);
    const hawser_status status = r->ops->refresh(r->self, 0, err);
    out->residual_N = r->ops->residual(r->self, &out->segment);
    if (out->residual_N < JUMP * before || *dt <= DT_SMALLEST) {
        *dt = fmin(DT_LARGEST, *dt * (out->residual_N < before / 2 ? DT_GROWTH : 2));
    } else {
        memcpy(r->y, r->back, bytes);
        *dt = fmax(DT_SMALLEST, *dt / 4);
        out->residual_N = r->ops->residual(r->self, &out->segment);
    }
    return status;
}

static hawser_status iterate_carefully(Relaxing *r, double aim, int limit, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double dt = DT_FIRST;
    out->residual_N = r->ops->residual(r->self, &out->segment);
    for (int spent = 0; !status && spent < limit && !(out->residual_N <= aim); ++spent) {
        ++out->iterations;
        status = relax_stopped(r->stop, r->soft, err);
        if (!status) status = careful_step(r, &dt, out, err);
    }
    out->reached = out->residual_N <= out->tolerance_N;
    return status;
}

/* An attempt that ends within so many tolerances goes on for so many times as long: long chains between guides creep.
 */
static const double NEAR = 100;
enum { FURTHER = 4 };

/* The continuation in the contacts' stiffness (E5): a light rope that falls onto stiff rollers overshoots by more than
 * Newton's method mends, so it lands on soft ones, which are then made stiffer and stiffer. */
static hawser_status iterate_from_soft(Relaxing *r, hawser_relaxation *out, hawser_error *err)
{
    const double load = out->tolerance_N / r->def->relax_tolerance;
    const int last = out->iterations + r->def->relax_iterations;
    hawser_status status = HAWSER_OK;
    r->soft = 1;
    for (double share = SOFTEST; !status && share < 0.5; share *= SOFT_GROWTH) {
        const int left = last - out->iterations;
        r->ops->soften(r->self, share);
        status = iterate_carefully(r, SOFT_AIM * load, left < SOFT_ITERATIONS ? left : SOFT_ITERATIONS, out, err);
    }
    r->ops->soften(r->self, 1);
    r->soft = 0;
    if (!status) status = iterate_carefully(r, out->tolerance_N, last - out->iterations, out, err);
    if (status || out->reached || out->residual_N > NEAR * out->tolerance_N) return status;
    return iterate_carefully(r, out->tolerance_N, FURTHER * r->def->relax_iterations, out, err);
}

/* Straight away; where that does not reach equilibrium, once more from the start and from soft contacts. */
static hawser_status attempts(Relaxing *r, int straight, hawser_relaxation *out, hawser_error *err)
{
    const int most = r->def->relax_iterations;
    hawser_status status = iterate(r, out->tolerance_N, straight < most ? straight : most, out, err);
    if (status || out->reached || !r->touches) return status;
    memcpy(r->y, r->start, (size_t)r->size * sizeof(double));
    status = r->ops->refresh(r->self, 1, err);
    return status ? status : iterate_from_soft(r, out, err);
}

hawser_status relax_run(const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self, int size, double *y,
                        hawser_relaxation *out, hawser_error *err)
{
    return relax_run_within(INT_MAX, scene, stop, ops, self, size, y, out, err);
}

hawser_status relax_run_within(int straight, const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self,
                               int size, double *y, hawser_relaxation *out, hawser_error *err)
{
    const size_t bytes = (size_t)size * sizeof(double);
    Relaxing r = {.ops = ops,
                  .self = self,
                  .stop = stop,
                  .def = &scene->def.solver,
                  .touches = scene->contact.n_rollers > 0 || scene->surfaces.model.n_patches > 0,
                  .size = size,
                  .y = y,
                  .start = malloc(bytes),
                  .back = malloc(bytes)};
    hawser_status status;
    if (r.start && r.back) {
        memcpy(r.start, y, bytes);
        status = attempts(&r, straight, out, err);
    } else {
        status = error_memory(err);
    }
    free(r.start);
    free(r.back);
    return status;
}
