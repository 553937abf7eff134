#include "sim/step/spatial.h"

#include <string.h>

#include "core/base/worst.h"
#include "core/bushing.h"
#include "sim/dynamics.h"
#include "sim/equipment/roller_motion.h"
#include "sim/equipment/winch.h"
#include "sim/newton/relax_space.h"
#include "sim/step/scales.h"
#include "sim/step/vector_kernels.h"

static Spatial *spatial_of(Motion *m) { return (Spatial *)m; }

/* Vectors of a long chain, shared by two threads as the segments are. */
typedef struct Halves {
    int n, size;
    const double *y;
    double *correction, *error;
    int finite[2];
} Halves;

static int half_from(const Halves *h, int rank) { return rank ? halves_middle(h->n) : 0; }
static int half_to(const Halves *h, int rank) { return rank ? h->n : halves_middle(h->n); }

static void finite_job(void *arg, int rank)
{
    Halves *const h = arg;
    const int from = half_from(h, rank), count = half_to(h, rank) - from, beside = STATE_SIZE * h->n;
    int finite = rank == 0 || vector_kernels()->all_finite(h->size - beside, h->y + beside);
    for (int c = 0; c < STATE_SIZE; ++c) finite &= vector_kernels()->all_finite(count, h->y + c * h->n + from);
    h->finite[rank] = finite;
}

static int is_finite(const Motion *m, const double *y)
{
    Halves h = {.n = m->scene->chain.n, .size = m->size, .y = y};
    if (h.n < HALVES_LONG || team_size(m->team) == 1) return vector_kernels()->all_finite(m->size, y);
    team_run(m->team, finite_job, &h);
    return h.finite[0] & h.finite[1];
}

static int spatial_rates(Motion *m, double t, const double *y, double *ydot)
{
    dynamics_rates(m->scene, spatial_of(m)->ws, t, y, 1.0, ydot);
    return !is_finite(m, ydot);
}

static void spatial_linearise(Motion *m, double t, const double *y, const double *ydot)
{
    Spatial *const s = spatial_of(m);
    dynamics_blocks(m->scene, s->ws, t, y, ydot, 1.0, &s->newton->k, &s->newton->d);
    newton_point(s->newton, m->scene, &s->ws->kin, y);
    newton_point_equipment(s->newton, s->ws->equipment, y, 1.0);
}

static void spatial_form(Motion *m, double gamma) { newton_form(spatial_of(m)->newton, gamma); }

static int spatial_factor(Motion *m)
{
    newton_rough(spatial_of(m)->newton, m->rough);
    return newton_factor(spatial_of(m)->newton);
}

static int spatial_solve(Motion *m, double *b) { return newton_solve(spatial_of(m)->newton, b); }

static void spatial_weights(const Motion *m, double *weight) { scales_weights(m->scene, weight); }

static double window_square(const void *owner, int from, int to, const double *x, const double *w)
{
    return vector_kernels()->window_square_even(((const Chain *)owner)->n, from, to, x, w);
}

static double spatial_norm(const Motion *m, const double *x, const double *w)
{
    const int n = m->scene->chain.n;
    const double chain = scales_chain_norm(m->team, n, window_square, &m->scene->chain, x, w);
    if (m->scene->equipment->n == 0) return chain;
    const double beside = scales_equipment_norm(m->scene->equipment, x + STATE_SIZE * n, w + STATE_SIZE * n);
    return larger_of(chain, beside);
}

static double spatial_speed(const Motion *m, const double *y)
{
    const Chain *const chain = &m->scene->chain;
    return stride_speed(chain, chain->n, 3, y + STATE_V * chain->n, 3, y + STATE_W * chain->n);
}

static void project_job(void *arg, int rank)
{
    const Halves *const h = arg;
    vector_kernels()->project(h->n, half_from(h, rank), half_to(h, rank), h->y, h->correction, h->error);
}

/* Keeps the quaternions of unit length (N9). */
static void spatial_project(const Motion *m, const double *y, double *correction, double *error)
{
    const int n = m->scene->chain.n, chain = STATE_SIZE * n;
    Halves h = {.n = n, .y = y, .correction = correction, .error = error};
    halves_run(m->team, n >= HALVES_LONG, project_job, &h);
    if (m->scene->equipment->n == 0) return;
    scales_equipment_project(m->scene->equipment, y + chain, correction + chain, error ? error + chain : NULL);
}

static hawser_status spatial_accept(Motion *m, double t, const double *y, hawser_error *err)
{
    Spatial *const s = spatial_of(m);
    dynamics_accept(m->scene, s->ws, t, y);
    const hawser_status status = newton_renew(s->newton, s->ws->equipment, err);
    return status ? status : dynamics_refresh(m->scene, s->ws, t, y, 0, err);
}

/* The segment that is nearest to a moving roller: where to look for what ails it. */
static int nearest_segment(const Workspace *ws, int n, int moving)
{
    const Vec3 at = ws->equipment->roller[ws->equipment->q->item[moving].roller].shape.centre;
    int nearest = 0;
    double least = INFINITY;
    for (int i = 0; i < n; ++i) {
        const double away = v3_norm(v3_sub(v3(ws->kin.p[0][i], ws->kin.p[1][i], ws->kin.p[2][i]), at));
        if (away < least) {
            least = away;
            nearest = i;
        }
    }
    return nearest;
}

static hawser_status spatial_renew(Motion *m, double t, const double *y, hawser_error *err)
{
    return dynamics_refresh(m->scene, spatial_of(m)->ws, t, y, 1, err);
}

static int spatial_worst(const Motion *m, const double *error, const double *weight)
{
    const int n = m->scene->chain.n, worst = scales_worst_segment(n, n, STATE_SIZE, error, weight);
    double sum = 0, beside;
    for (int c = 0; c < STATE_SIZE; ++c) sum += pow(error[c * n + worst] * weight[c * n + worst], 2);
    const int roller = equipment_worst(m->scene->equipment, error + STATE_SIZE * n, weight + STATE_SIZE * n, &beside);
    return roller < 0 || !(beside > sum) ? worst : nearest_segment(spatial_of((Motion *)m)->ws, n, roller);
}

static Vec3 spatial_place(const Motion *m, const double *y, int segment)
{
    const int n = m->scene->chain.n;
    return v3(y[segment], y[n + segment], y[2 * n + segment]);
}

static int spatial_look(Motion *m, double t, const double *y, int on_chain)
{
    (void)on_chain; /* the evaluation leaves them there */
    return dynamics_look(m->scene, spatial_of(m)->ws, t, y);
}

static void spatial_glance(Motion *m)
{
    Workspace *const ws = spatial_of(m)->ws;
    bushing_kernels()->law(&m->scene->chain, &ws->kin, 0, m->scene->chain.n + 1, ws->law);
}

static double spatial_winch_pull(Motion *m, double t, const double *y)
{
    return winch_pull_at(m->scene, spatial_of(m)->ws, t, y);
}

static void spatial_work(Motion *m, double t, const double *y, BalanceRates *out)
{
    balance_spatial(m->scene, spatial_of(m)->ws, t, y, out);
}

static MethodLoss spatial_method_loss(const Motion *m, const double *y, const double *rates, double scale, double *past)
{
    const int n = m->scene->chain.n, stride = (n + LANES - 1) / LANES * LANES, own = STATE_SIZE * n;
    MethodLoss loss = body_kernels()->method_loss(&m->scene->chain, y, rates, scale, 0, n, past);
    if (m->scene->equipment->n == 0) return loss;
    const MethodLoss beside =
        equipment_method_loss(m->scene->equipment, y + own, rates + own, scale, past + BODY_PAST * stride);
    loss.lost += beside.lost;
    loss.moving += beside.moving;
    return loss;
}

static void spatial_stock(Motion *m, double t, const double *y, BalanceStock *out)
{
    (void)t;
    balance_stock(m->scene, spatial_of(m)->ws, y + STATE_SIZE * m->scene->chain.n, out);
}

static hawser_status spatial_relax(Motion *m, double t, double *y, hawser_relaxation *out, hawser_error *err)
{
    Spatial *const s = spatial_of(m);
    return relax_to_equilibrium(m->scene, s->ws, s->newton, t, y, out, err);
}

static void spatial_pack(Motion *m, const double *full, double *y) { memcpy(y, full, (size_t)m->size * sizeof *y); }

static void spatial_unpack(const Motion *m, const double *y, double *full)
{
    memcpy(full, y, (size_t)m->size * sizeof *y);
}

static void spatial_lin_stats(const Motion *m, LinStats *stats) { newton_stats(((const Spatial *)m)->newton, stats); }

static void spatial_checkpoint(Checkpoint *c, Motion *m)
{
    newton_checkpoint(c, spatial_of(m)->newton, spatial_of(m)->ws->equipment);
}

Motion *spatial_init(Spatial *s, const Scene *scene, Workspace *ws, Newton *newton)
{
    static const MotionOps ops = {.rates = spatial_rates,
                                  .linearise = spatial_linearise,
                                  .form = spatial_form,
                                  .factor = spatial_factor,
                                  .solve = spatial_solve,
                                  .weights = spatial_weights,
                                  .norm = spatial_norm,
                                  .speed = spatial_speed,
                                  .project = spatial_project,
                                  .accept = spatial_accept,
                                  .renew = spatial_renew,
                                  .worst = spatial_worst,
                                  .whose = motion_whose,
                                  .place = spatial_place,
                                  .look = spatial_look,
                                  .glance = spatial_glance,
                                  .winch_pull = spatial_winch_pull,
                                  .work = spatial_work,
                                  .method_loss = spatial_method_loss,
                                  .stock = spatial_stock,
                                  .relax = spatial_relax,
                                  .pack = spatial_pack,
                                  .unpack = spatial_unpack,
                                  .lin_stats = spatial_lin_stats,
                                  .checkpoint = spatial_checkpoint};
    *s = (Spatial){.motion = {&ops, scene, scene_state_size(scene), ws->team, .pitch = scene->chain.n},
                   .ws = ws,
                   .newton = newton};
    return &s->motion;
}
