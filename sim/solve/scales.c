#include "sim/solve/scales.h"

#include <math.h>
#include <string.h>

#include "core/bushing.h"
#include "core/team.h"
#include "core/vec3.h"
#include "sim/dynamics.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/winch.h"
#include "sim/solve/relax.h"
#include "sim/solve/vector_kernels.h"

static const double LENGTH = 0.01, TURN = 0.1; /* m, rad: physical scales of the errors */

/* Tolerances are accuracy times these (N10); a case may give its own instead. */
static double chosen(double given, double otherwise) { return given > 0 ? given : otherwise; }

Tolerances scales_tolerances(const Scene *scene)
{
    const SolverDef *const s = &scene->def.solver;
    const double speed = scene->largest_speed;
    return (Tolerances){.position = chosen(s->atol_position, s->accuracy * LENGTH),
                        .rotation = chosen(s->atol_rotation, s->accuracy * TURN),
                        .velocity = chosen(s->atol_velocity, s->accuracy * speed),
                        .omega = chosen(s->atol_omega, s->accuracy * speed * TURN / LENGTH)};
}

void scales_weights(const Scene *scene, double *weight)
{
    const Tolerances tol = scales_tolerances(scene);
    const int n = scene->chain.n;
    for (int c = 0; c < STATE_SIZE; ++c) {
        const double atol = c < STATE_Q   ? tol.position
                            : c < STATE_V ? tol.rotation / 2
                            : c < STATE_W ? tol.velocity
                                          : tol.omega;
        for (int i = 0; i < n; ++i) weight[c * n + i] = 1 / atol;
    }
    const EquipmentTolerances equipment = {tol.position, tol.rotation, tol.velocity, tol.omega};
    equipment_weights(scene->equipment, scene->rollers, &equipment, weight + STATE_SIZE * n);
}

double scales_norm(int n, const double *x, const double *weight)
{
    return sqrt(vector_kernels()->window_square(n, 0, n, x, weight));
}

/* The windows of half of a chain. */
typedef struct NormHalf {
    int n, middle;
    WindowSquare *square;
    const void *owner;
    const double *x, *weight;
    double largest[2];
} NormHalf;

static void norm_half(void *arg, int rank)
{
    NormHalf *const h = arg;
    h->largest[rank] = h->square(h->owner, rank ? h->middle : 0, rank ? h->n : h->middle, h->x, h->weight);
}

double scales_chain_norm(Team *team, int n, WindowSquare *square, const void *owner, const double *x,
                         const double *weight)
{
    NormHalf h = {n, n / 2 / SCALES_WINDOW * SCALES_WINDOW, square, owner, x, weight, {0}};
    if (n < HALVES_LONG) return sqrt(square(owner, 0, n, x, weight));
    halves_run(team, 1, norm_half, &h);
    return sqrt(larger_of(h.largest[0], h.largest[1]));
}

/* Norm and projection (VectorKernels.project) of the part of the state that belongs to rollers that move (SP14). */
static double scales_equipment_norm(const Equipment *q, const double *x, const double *weight)
{
    double largest = q->mounts > 0 ? scales_norm(q->mounts, x + q->spins, weight + q->spins) : 0;
    for (int from = 0; from < q->spins; from += SCALES_WINDOW) {
        const int to = from + SCALES_WINDOW < q->spins ? from + SCALES_WINDOW : q->spins;
        double sum = 0;
        for (int i = from; i < to; ++i) sum += x[i] * weight[i] * x[i] * weight[i];
        largest = larger_of(largest, sqrt(sum / (to - from)));
    }
    return largest;
}

static void scales_equipment_project(const Equipment *q, const double *e, double *correction, double *error)
{
    memset(correction, 0, (size_t)q->spins * sizeof *correction);
    vector_kernels()->project(q->mounts, 0, q->mounts, e + q->spins, correction + q->spins,
                              error ? error + q->spins : NULL);
}

int scales_worst_segment(int n, int pitch, int components, const double *x, const double *weight)
{
    int worst = 0;
    double largest = -1;
    for (int i = 0; i < n; ++i) {
        double sum = 0;
        for (int k = i; k < components * pitch; k += pitch) sum += x[k] * weight[k] * x[k] * weight[k];
        if (isnan(sum)) return i;
        if (sum > largest) {
            largest = sum;
            worst = i;
        }
    }
    return worst;
}

/* The residual of Newton's iteration is noise in the tensions, because the axial stiffness multiplies it;
 * docs/theory.md, "Integration", has the figures. It is a share, of at least NEWTON_SHARE, of the error test's
 * tolerance; it grows as the tolerance falls, so that NEWTON_LEFT of the scales of (N10) remain at any accuracy, up to
 * CVODE's default. */
static const double NEWTON_SHARE = 1e-3, NEWTON_SHARE_MOST = 0.1, NEWTON_LEFT = 3e-7;

/* The same in a conveyor's force, times the accuracy, as a share of its grip (N16). */
static const double GRIP_LEFT = 0.01;

double scales_newton_share(const Scene *scene)
{
    const double share = fmax(NEWTON_SHARE, fmin(NEWTON_LEFT / scene->def.solver.accuracy, NEWTON_SHARE_MOST));
    return fmin(share, GRIP_LEFT * scene->grip_speed / (1.5 * scene->largest_speed));
}

double stride_most(const Scene *scene)
{
    const int touches = scene->contact.n_rollers > 0 || scene->surfaces.model.n_patches > 0 || scene->self.present;
    const double reach = scene->surfaces.facets ? scene->surfaces.model.skin : scene->def.contact_reach;
    const double unseen = (1 - CONTACT_USABLE) * fmin(reach, scene->def.contact_reach); /* candidates may be late */
    return touches ? fmin(scene_way(scene), unseen) : INFINITY;
}

double stride_speed(const Chain *chain, int pitch, int dims, const double *v, int turns, const double *w)
{
    return sqrt(vector_kernels()->largest_square(chain->n, pitch, dims, v, turns, w, chain->half));
}

double stride_longest(double way, double speed, double growth)
{
    const double both = speed + sqrt(speed * speed + 2 * growth * way);
    return both > 0 ? 2 * way / both : INFINITY;
}

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

/* Segment nearest to a moving roller, as the place to search for the cause of its error. */
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

/* Shares of the largest pull: loss of a fall to the steps, a tenth of the allowed error of a peak, at the default
 * accuracy or a coarser one; and size below which an oscillation does not bound the step. */
static const double LOST = 0.01, USUAL = 1e-3;

/* Factor per step on the last maximum of the third derivative: there are four steps or more between its maxima where
 * (EB25) holds. */
static const double FADES = 0.8;

/* Steps are made shorter than necessary, and longer only when the bound exceeds them by more than this: each change
 * costs a matrix. */
static const double SHORTER = 0.9, LONGER = 1.4, MAY = 1.5;

/* Lower bound, over the longest step without oscillations: faster ones are left to the error test. */
static const double LEAST = 1.0 / 16;

/* Loss of a method of second order in an oscillation that falls in n steps, half of its period: pi^4/4n^3 of it
 * (EB23). */
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

/* Third derivative of the last four pulls, N/s^3; 0 where they vary by no more than bounds no step. */
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
    const double may = fmax(cbrt(lost / (M_PI / 2) / s->third), LEAST * longest); /* INFINITY: no oscillation */
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
