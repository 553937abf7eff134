#include "sim/newton/relax_steady.h"

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
enum { NEWTON_ITERATIONS = 25 };
/* Newton's method goes on while two iterations leave less than that of the residual, and the continuation has so many
 * iterations before contacts are made soft: nearly all that arrive at all have arrived by then. */
static const double CONTRACTS = 1.0 / 3;
enum { STRAIGHT = 16 };

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

static hawser_status newton_iterate(Steady *s, hawser_relaxation *out, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    double before[2] = {INFINITY, INFINITY}; /* N: residuals one and two iterations ago */
    for (int it = 0; !status && it <= NEWTON_ITERATIONS; ++it) {
        out->residual_N = steady_residual(s, &out->segment);
        out->reached = out->residual_N <= out->tolerance_N;
        if (out->reached || !isfinite(out->residual_N) || it == NEWTON_ITERATIONS) break;
        if (it > 2 && !(out->residual_N < CONTRACTS * before[1])) break;
        before[1] = before[0];
        before[0] = out->residual_N;
        status = relax_stopped(&s->r.ws->stop, 0, err);
        if (status || steady_step(s, DT_STEADY)) break;
        steady_move(s, space_move_scale(&s->r, DT_STEADY) * DT_STEADY);
        ++out->iterations;
        status = space_refresh(&s->r, 0, err);
    }
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

hawser_status relax_steady(const Scene *scene, Workspace *ws, Newton *newton, double t, double speed, SteadyStart far,
                           double *y, hawser_relaxation *out, hawser_error *err)
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
        if (far == STEADY_NEAR) status = newton_iterate(&s, out, err);
        if (!status && !out->reached) {
            memcpy(y, begun, bytes);
            status = slow_way(&s, far == STEADY_SOFT ? 0 : STRAIGHT, out, err);
        }
        out->moved_m = space_farthest(&s.r, s.r.start);
    }
    space_end(&s.r);
    free(begun);
    return status;
}
