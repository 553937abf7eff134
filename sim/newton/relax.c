#include "sim/newton/relax.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/equipment/rod.h"
#include "sim/newton/relax_space.h"

/* The largest change that one iteration may make. */
static const double MOVE_MAX = 0.05, TURN_MAX = 0.1;                   /* m, rad */
static const double DT_FIRST = 1e-2, DT_LARGEST = 1e8, DT_GROWTH = 10; /* s, s, 1 */
/* The careful variant (E4): the shortest step, and how much a residual may grow in one. */
static const double DT_SMALLEST = 1e-4, JUMP = 4;
/* Contacts made soft (E5): the first share of their stiffness, its growth from stage to stage; a stage ends at this
 * share of the loads, or after so many iterations. */
static const double SOFTEST = 1e-3, SOFT_GROWTH = 10, SOFT_AIM = 1e-2;
enum { SOFT_ITERATIONS = 60 };

/* --------------------------------------------------------------------------------------- any chain */

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
        if (r->ops->implicit_step(r->self, dt)) {
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
    const double before = out->residual_N,
                 scale = r->ops->implicit_step(r->self, *dt) ? 0 : r->ops->move_scale(r->self, *dt);
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
    return status ? status : iterate_carefully(r, out->tolerance_N, last - out->iterations, out, err);
}

/* Straight away; where that does not reach equilibrium, once more from the start and from soft contacts. */
static hawser_status attempts(Relaxing *r, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = iterate(r, out->tolerance_N, r->def->relax_iterations, out, err);
    if (status || out->reached || !r->touches) return status;
    memcpy(r->y, r->start, (size_t)r->size * sizeof(double));
    status = r->ops->refresh(r->self, 1, err);
    return status ? status : iterate_from_soft(r, out, err);
}

hawser_status relax_run(const Scene *scene, const StopCheck *stop, const RelaxOps *ops, void *self, int size, double *y,
                        hawser_relaxation *out, hawser_error *err)
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
        status = attempts(&r, out, err);
    } else {
        status = error_memory(err);
    }
    free(r.start);
    free(r.back);
    return status;
}

/* ------------------------------------------------------------------------------------- the chain in space */

double space_residual(void *self, int *where)
{
    Relaxation *const r = self;
    const Chain *const chain = &r->scene->chain;
    const int n = chain->n;
    double largest = 0;
    dynamics_rates(r->scene, r->ws, r->t, r->y, 0.0, r->rate);
    for (int i = 0; i < n; ++i) {
        const Vec3 a = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 spin = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const double force = chain->mass[i] * v3_norm(a);
        const double moment = v3_norm(body_inertia_times(chain, &r->ws->kin, i, spin)) / chain->half[i];
        const double both = force + moment;
        if (both > largest || isnan(both)) {
            largest = both;
            *where = i;
        }
    }
    const double mounts = equipment_residual(r->scene->equipment, r->scene->rollers, r->rate + STATE_SIZE * n);
    return mounts > largest || isnan(mounts) ? mounts : largest;
}

void space_blocks(Relaxation *r)
{
    dynamics_blocks(r->scene, r->ws, r->t, r->y, r->rate, 0.0, &r->newton->k, &r->newton->d);
    newton_point(r->newton, r->scene, &r->ws->kin, r->y);
    newton_point_equipment(r->newton, r->ws->equipment, r->y, 0.0);
}

int space_solve(Relaxation *r, double dt)
{
    const int n = r->scene->chain.n;
    const int status = newton_factor(r->newton);
    if (status) return status;
    memset(r->rate, 0, (size_t)(STATE_V * n) * sizeof(double));
    for (int k = STATE_V * n; k < r->size; ++k) r->rate[k] *= dt;
    /* the mounts' positions and quaternions have no residual either */
    const int mounts = STATE_SIZE * n + r->scene->equipment->spins;
    memset(r->rate + mounts, 0, (size_t)(STATE_V * r->scene->equipment->mounts) * sizeof(double));
    return newton_solve(r->newton, r->rate);
}

int space_step(void *self, double dt)
{
    Relaxation *const r = self;
    space_blocks(r);
    newton_form(r->newton, dt);
    return space_solve(r, dt);
}

/* What a move of dt times the velocities found is shortened by (E2). */
static double move_scale(void *self, double dt)
{
    const Relaxation *const r = self;
    const int n = r->scene->chain.n;
    const RelaxStride most = relax_stride(r->scene);
    double scale = 1;
    for (int i = 0; i < n; ++i) {
        const Vec3 u = v3(r->rate[7 * n + i], r->rate[8 * n + i], r->rate[9 * n + i]);
        const Vec3 w = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        scale = relax_shorten(&most, scale, dt * v3_norm(u), dt * v3_norm(w), r->scene->chain.half[i]);
    }
    const double *const beside = r->rate + STATE_SIZE * n;
    return fmin(scale, equipment_move_share(r->scene->equipment, beside, dt, most.move, most.turn));
}

void space_move(void *self, double dt)
{
    Relaxation *const r = self;
    const int n = r->scene->chain.n;
    equipment_move(r->scene->equipment, r->y + STATE_SIZE * n, r->rate + STATE_SIZE * n, dt);
    for (int i = 0; i < n; ++i) {
        double *const y = r->y + i;
        for (int c = 0; c < 3; ++c) y[c * n] += dt * r->rate[(STATE_V + c) * n + i];
        const Vec3 turn = v3(r->rate[10 * n + i], r->rate[11 * n + i], r->rate[12 * n + i]);
        const Quat q =
            quat_unit(quat_mul(quat_exp(v3_scale(dt, turn)), (Quat){y[3 * n], y[4 * n], y[5 * n], y[6 * n]}));
        y[3 * n] = q.w;
        y[4 * n] = q.x;
        y[5 * n] = q.y;
        y[6 * n] = q.z;
    }
}

double space_farthest(const Relaxation *r, const double *from)
{
    const int n = r->scene->chain.n;
    return relax_farthest(n, n, 3, r->y, from);
}

hawser_status space_refresh(void *self, int always, hawser_error *err)
{
    Relaxation *const r = self;
    if (!always) dynamics_kinematics(r->scene, r->ws, r->t, r->y);
    const hawser_status status = always ? HAWSER_OK : newton_renew(r->newton, r->ws->equipment, err);
    return status ? status : dynamics_refresh(r->scene, r->ws, r->t, r->y, always, err);
}

static void soften(void *self, double share)
{
    Relaxation *const r = self;
    dynamics_soften(r->scene, r->ws, share);
}

/* Mounts are held until the chain has come to rest on them, and are let go then: what they give way by changes little,
 * but light bodies on springs under a chain that falls make for many more iterations (SP15). */
static hawser_status stages(Relaxation *r, const RelaxOps *ops, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (r->scene->equipment->mounts > 0) {
        r->ws->equipment->held = 1;
        status = relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
        r->ws->equipment->held = 0;
    }
    return status ? status : relax_run(r->scene, &r->ws->stop, ops, r, r->size, r->y, out, err);
}

int space_begin(Relaxation *r)
{
    const size_t n = (size_t)r->scene->chain.n;
    r->size = scene_state_size(r->scene);
    r->rate = malloc((size_t)r->size * sizeof(double));
    r->start = malloc(3 * n * sizeof(double));
    if (!r->rate || !r->start) return 0;
    memcpy(r->start, r->y, 3 * n * sizeof(double));
    memset(r->y + STATE_V * n, 0, (STATE_SIZE - STATE_V) * n * sizeof(double));
    equipment_halt(r->scene->equipment, r->y + STATE_SIZE * n);
    return 1;
}

void space_end(Relaxation *r)
{
    free(r->rate);
    free(r->start);
}

hawser_status relax_to_equilibrium(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y,
                                   hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {space_residual, space_step, move_scale, space_move, space_refresh, soften};
    Relaxation r = {.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y};
    *out = (hawser_relaxation){0};
    hawser_status status = space_begin(&r) ? HAWSER_OK : error_memory(err);
    if (!status) {
        out->tolerance_N = relax_tolerance(scene, t, space_farthest(&r, NULL));
        status = stages(&r, &ops, out, err);
        out->moved_m = space_farthest(&r, r.start);
    }
    space_end(&r);
    return status;
}
