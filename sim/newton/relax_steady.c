#include "sim/newton/relax_steady.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/worst.h"
#include "core/state.h"
#include "sim/equipment/roller_motion.h"
#include "sim/newton/relax.h"
#include "sim/newton/relax_space.h"

/* The step that stands for infinity: inertia is then 1e-10 of a spring of 1 N/m and 1 kg. */
static const double DT_STEADY = 1e5; /* s */
/* Newton's method goes on while none but so many iterations in a row have left no less than the best one; and the
 * continuation has so many before contacts are made soft: nearly all that arrive at all have arrived by then. */
enum { NEWTON_ITERATIONS = 25, WAITS = 3, STRAIGHT = 16 };
/* In the first iteration, which moves farthest, contacts let go of no more than the rest of this share (PS12). */
static const double KEPT = 0.1, FALLS = 0.8;

/* The relaxation's parts come first: what they are handed is this. */
typedef struct Steady {
    Relaxation r;
    double speed; /* m/s */
} Steady;

void steady_field(const Chain *chain, double speed, double *y)
{
    const int n = chain->n;
    for (int i = 0; i < n; ++i) {
        const int before = i > 0 ? i - 1 : i, after = i + 1 < n ? i + 1 : i;
        const Vec3 ahead = v3(1, 0, 0), axis = quat_rotate(state_attitude(y, n, i), ahead);
        const Vec3 turned =
            v3_sub(quat_rotate(state_attitude(y, n, after), ahead), quat_rotate(state_attitude(y, n, before), ahead));
        double way = 0; /* from the centre of `before` to that of `after` */
        for (int k = before; k < after; ++k) way += chain->half[k] + chain->half[k + 1];
        const Vec3 v = v3_scale(speed, axis), w = v3_scale(speed / way, v3_cross(axis, turned));
        const double field[6] = {v.x, v.y, v.z, w.x, w.y, w.z};
        for (int c = 0; c < 6; ++c) y[(STATE_V + c) * n + i] = field[c];
    }
}

/* block of d, of the segment that moves with v, into the same block of k. */
static void follow_block(const double *d, Vec3 v, double *k)
{
    for (int c = 0; c < 3; ++c) {
        const Vec3 by = v3_cross(v3_axis(c), v);
        const double part[3] = {by.x, by.y, by.z};
        for (int b = 0; b < 3; ++b) {
            for (int r = 0; r < 6; ++r) k[6 * (3 + c) + r] += d[6 * b + r] * part[b];
        }
    }
}

void steady_follow(const BlockChain *d, const double *y, BlockChain *k)
{
    const int n = d->n;
    for (int i = 0; i < n; ++i) {
        follow_block(d->diag + 36 * i, state_vector(y, n, STATE_V, i), k->diag + 36 * i);
        if (i > 0) follow_block(d->lower + 36 * i, state_vector(y, n, STATE_V, i - 1), k->lower + 36 * i);
        if (i + 1 < n) follow_block(d->upper + 36 * i, state_vector(y, n, STATE_V, i + 1), k->upper + 36 * i);
    }
}

/* Torques left on rollers that spin, as forces at their surfaces, count like forces on segments (PS7). */
static double spins_residual(const Relaxation *r)
{
    const Equipment *const q = r->scene->equipment;
    const double *const rate = r->rate + STATE_SIZE * r->scene->chain.n;
    double largest = 0;
    for (int k = 0; k < q->n; ++k) {
        const MovingRoller *const item = &q->item[k];
        if (item->spin < 0) continue;
        const double radius = r->scene->contact.roller[item->roller].shape.radius;
        largest = larger_of(largest, item->inertia * fabs(rate[item->spin]) / radius);
    }
    return largest;
}

static double steady_residual(void *self, int *where)
{
    Steady *const s = self;
    steady_field(&s->r.scene->chain, s->speed, s->r.y);
    return larger_of(space_residual(&s->r, where), spins_residual(&s->r));
}

/* (PS6). Newton's matrix without what turns the segments: on the way of a step that stands for infinity they would go
 * round thousands of times (N4). */
static int steady_step(void *self, double dt)
{
    Steady *const s = self;
    Newton *const newton = s->r.newton;
    space_blocks(&s->r);
    for (int c = 0; c < 3; ++c) memset(newton->w[c], 0, (size_t)newton->n * sizeof(double));
    steady_follow(&newton->d, s->r.y, &newton->k);
    newton_form(newton, dt);
    return space_solve(&s->r, dt);
}

/* Rollers that spin have no position: a move of dt changes their speeds by what was found, whole or in part. */
static void steady_move(void *self, double dt)
{
    Steady *const s = self;
    const int first = STATE_SIZE * s->r.scene->chain.n;
    space_move(&s->r, dt);
    for (int k = 0; k < s->r.scene->equipment->spins; ++k) {
        s->r.y[first + k] += dt / s->r.newton->gamma * s->r.rate[first + k];
    }
}

/* One step with the contacts about what is presumed, whose rates are there, and what it leads to presume. */
static hawser_status presumed_step(Steady *s, Presumption *p, double keep, int *stuck, hawser_error *err)
{
    Workspace *const ws = s->r.ws;
    hawser_status status = relax_stopped(&ws->stop, 0, err);
    const int bad = status ? 0 : steady_step(s, DT_STEADY);
    if (bad < 0) return error_memory(err);
    *stuck = bad > 0;
    if (status || *stuck) return status;
    steady_move(s, space_move_scale(&s->r, DT_STEADY) * DT_STEADY);
    presumption_use(p, ws, 0);
    status = space_refresh(&s->r, 0, err);
    return status ? status : presumption_go_on(p, s->r.scene, ws, keep, err);
}

/* (PS11)-(PS13). What is presumed agrees with the contacts' law in the end: it counts when that balances. */
static hawser_status newton_iterate(Steady *s, Presumption *p, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double least = INFINITY, last = 0; /* N: the best residual, the last one */
    for (int it = 0, best = 0, stuck = 0; !status && !stuck; ++it) {
        presumption_use(p, s->r.ws, 1);
        out->residual_N = steady_residual(s, &out->segment);
        if (out->residual_N <= out->tolerance_N) {
            presumption_use(p, s->r.ws, 0);
            out->residual_N = steady_residual(s, &out->segment);
            out->reached = out->residual_N <= out->tolerance_N;
            if (out->reached) break;
            presumption_use(p, s->r.ws, 1);
            steady_residual(s, &(int){0}); /* the rates that the step is for */
        }
        if (out->residual_N < FALLS * least) best = it;
        least = fmin(least, out->residual_N);
        if (it - best >= WAITS || it == NEWTON_ITERATIONS || !isfinite(out->residual_N)) break;
        status = presumed_step(s, p, out->residual_N > last ? KEPT : 0, &stuck, err);
        last = out->residual_N;
        out->iterations += !stuck;
    }
    presumption_use(p, s->r.ws, 0);
    return status;
}

static hawser_status newton_presumed(Steady *s, const Pressed *last, hawser_relaxation *out, hawser_error *err)
{
    Presumption p;
    dynamics_kinematics(s->r.scene, s->r.ws, s->r.t, s->r.y);
    hawser_status status = presumption_begin(&p, s->r.scene, s->r.ws, last, err);
    if (!status) status = newton_iterate(s, &p, out, err);
    presumption_free(&p);
    return status;
}

/* From the start again, step by step in time and from soft contacts (E3)-(E5). */
static hawser_status slow_way(Steady *s, int straight, hawser_relaxation *out, hawser_error *err)
{
    static const RelaxOps ops = {steady_residual, steady_step,   space_move_scale,
                                 steady_move,     space_refresh, space_soften};
    const hawser_status status = space_refresh(&s->r, 1, err);
    return status ? status
                  : relax_run_within(straight, s->r.scene, &s->r.ws->stop, &ops, s, s->r.size, s->r.y, out, err);
}

hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed,
                           const SteadyStart *start, double *y, hawser_relaxation *out, hawser_error *err)
{
    Steady s = {.r = {.scene = scene, .ws = ws, .newton = newton, .t = t, .y = y, .friction = 1}, .speed = speed};
    const size_t bytes = (size_t)scene_state_size(scene) * sizeof(double);
    double *const begun = malloc(bytes);
    const int spins = scene->equipment->spins, first = STATE_SIZE * scene->chain.n;
    hawser_status status = begun ? HAWSER_OK : error_memory(err);
    *out = (hawser_relaxation){0};
    if (!status) memcpy(begun, y, bytes);
    if (!status && !space_begin(&s.r)) status = error_memory(err);
    if (!status) {
        memcpy(y + first, begun + first, (size_t)spins * sizeof(double)); /* rollers go on spinning */
        memcpy(begun, y, bytes);
        out->tolerance_N = relax_tolerance(scene, t, space_farthest(&s.r, NULL));
        status = newton_presumed(&s, start->last, out, err);
        if (!status && !out->reached) {
            memcpy(y, begun, bytes);
            status = slow_way(&s, start->soft ? 0 : STRAIGHT, out, err);
        }
        out->moved_m = space_farthest(&s.r, s.r.start);
    }
    space_end(&s.r);
    free(begun);
    return status;
}
