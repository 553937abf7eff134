#include "sim/planar/planar.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "core/base/lanes.h"
#include "core/base/team.h"
#include "sim/dynamics.h"
#include "sim/equipment/winch.h"
#include "sim/step/scales.h"

static Planar *planar_of(Motion *m) { return (Planar *)m; }
static const Planar *planar_in(const Motion *m) { return (const Planar *)m; }

static int segments(const Planar *p) { return p->ps.chain.n; }

/* The forces on the rollers, back in space. */
static void on_rollers_lift(Planar *p)
{
    for (int r = 0; r < p->motion.scene->contact.n_rollers; ++r)
        p->ws->on_roller[r] = plane_vector(&p->ps.plane, p->on_roller[r][0], p->on_roller[r][1]);
}

/* The forces of the rollers on the chain, which are all that its contacts do to it: back in space. */
static void on_chain_lift(Planar *p)
{
    for (int half = 0; half < PARTS; ++half) {
        double *const *const f = p->loads[half].f;
        for (int i = 0; i < segments(p); ++i)
            v3_store(p->ws->loads[half].f, i, plane_vector(&p->ps.plane, f[0][i], f[1][i]));
    }
}

static int roller_forces(Planar *p, int on_chain)
{
    int active = 0, first = 0;
    const int n = segments(p);
    for (int half = 0; half < PARTS; ++half) {
        for (int c = 0; c < 2 && on_chain; ++c) memset(p->loads[half].f[c], 0, (size_t)n * sizeof(double));
        ContactPairs *const pairs = &p->ws->contact[half].pairs;
        if (p->model[half].n_rollers == 0) continue;
        planar_contact_forces(&p->model[half], &p->ps.chain, &p->kin, 1, pairs, &p->loads[half], p->on_roller + first);
        active += pairs->active;
        first += p->model[half].n_rollers;
    }
    on_rollers_lift(p);
    if (on_chain) on_chain_lift(p);
    return active;
}

/* The winch's pull for the kinematics of now: the last lane of joints holds the head's. */
static double head_pull(Planar *p)
{
    const int n = segments(p);
    if (!p->motion.scene->winch->present) return 0;
    planar_kernels()->joint_loads(&p->ps.chain, &p->kin, n / LANES * LANES, n + 1, &p->joints);
    return p->joints.force[0][n] * p->ps.winch_direction[0] + p->joints.force[1][n] * p->ps.winch_direction[1];
}

/* The winch at the head's joint: its force along the ghost's velocity, which does not turn (BA2). */
static Push winch_push_now(Planar *p, double t, const double *y)
{
    const int n = segments(p);
    if (!p->motion.scene->winch->present) return (Push){0};
    planar_kernels()->kinematics(&p->ps.chain, y, (n - 1) / LANES * LANES, n, &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
    planar_kernels()->joint_loads(&p->ps.chain, &p->kin, n / LANES * LANES, n + 1, &p->joints);
    const double f[2] = {p->joints.force[0][n], p->joints.force[1][n]};
    return (Push){f[0] * p->kin.v[0][n] + f[1] * p->kin.v[1][n], plane_vector(&p->ps.plane, f[0], f[1])};
}

static void planar_work(Motion *m, double t, const double *y, BalanceRates *out)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    memset(out, 0, sizeof *out);
    balance_gather(p->ws, out);
    for (int half = 0; half < PARTS; ++half)
        balance_contact(out, LOST_ROLLERS, PUSH_ROLLERS, &p->ws->contact[half].pairs.tally);
    const Vec3 flat = out->push[PUSH_ROLLERS];
    out->push[PUSH_ROLLERS] = plane_vector(&p->ps.plane, flat.x, flat.y);
    planar_kernels()->kinematics(&p->ps.chain, y, 0, LANES < n ? LANES : n, &p->kin);
    const Push winch = winch_push_now(p, t, y), tail = planar_tail(&p->ps, &p->kin, t, p->ws->tail_at);
    const Push drag = planar_drag(&p->ps, &p->kin);
    out->work[BY_WINCH] = winch.power;
    out->push[BY_WINCH] = winch.force;
    out->work[BY_TAIL] = tail.power;
    out->push[BY_TAIL] = tail.force;
    out->loss[LOST_DRAG] = -drag.power;
    out->push[PUSH_DRAG] = drag.force;
}

static MethodLoss planar_method_loss(const Motion *m, const double *y, const double *rates, double scale, double *past)
{
    return planar_sim_kernels()->method_loss(&planar_in(m)->ps.chain, y, rates, scale, past);
}

static void planar_stock(Motion *m, double t, const double *y, BalanceStock *out)
{
    Planar *const p = planar_of(m);
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    balance_stock(m->scene, p->ws, NULL, out);
}

static double motion_winch_pull(Motion *m, double t, const double *y)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    planar_kernels()->kinematics(&p->ps.chain, y, (n - 1) / LANES * LANES, n, &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
    return head_pull(p);
}

/* Everything that a sample reads from the workspace, and no more. */
static int planar_look(Motion *m, double t, const double *y, int on_chain)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    planar_kernels()->tension(&p->ps.chain, &p->kin, 0, n + 1, p->ws->law[0]);
    p->ws->head_pull = head_pull(p);
    return roller_forces(p, on_chain);
}

static void planar_glance(Motion *m)
{
    Planar *const p = planar_of(m);
    planar_kernels()->tension(&p->ps.chain, &p->kin, 0, segments(p) + 1, p->ws->law[0]);
    on_rollers_lift(p);
}

/* -------------------------------------------------------------------------------------- as the integrator sees it */

static int motion_rates(Motion *m, double t, const double *y, double *ydot)
{
    return planar_evaluate(planar_of(m), t, y, 1, ydot);
}

static void motion_linearise(Motion *m, double t, const double *y, const double *ydot)
{
    (void)ydot; /* inertia about one axis does not turn */
    planar_blocks(planar_of(m), t, y, 1);
}

static void motion_form(Motion *m, double gamma) { planar_newton_form(&planar_of(m)->newton, gamma); }
static int motion_factor(Motion *m)
{
    PlanarNewton *const nw = &planar_of(m)->newton;
    linsolver_rough(nw->solver, m->rough);
    return linsolver_factor(nw->solver, &nw->a);
}

static int motion_solve(Motion *m, double *b) { return planar_newton_solve(&planar_of(m)->newton, b); }

/* The same tolerances as in space: an angle's for half of it in the quaternion (PL18). */
static void motion_weights(const Motion *m, double *weight)
{
    const Tolerances tol = scales_tolerances(m->scene);
    const double atol[PLANAR_SIZE] = {tol.position, tol.position, tol.rotation, tol.velocity, tol.velocity, tol.omega};
    const int stride = planar_in(m)->ps.chain.stride;
    for (int c = 0; c < PLANAR_SIZE; ++c) {
        for (int i = 0; i < stride; ++i) weight[c * stride + i] = 1 / atol[c];
    }
}

static double window_square(const void *owner, int from, int to, const double *x, const double *w)
{
    return planar_sim_kernels()->window_square(owner, from, to, x, w);
}

static double motion_norm(const Motion *m, const double *x, const double *w)
{
    const PlanarChain *const chain = &planar_in(m)->ps.chain;
    return scales_chain_norm(m->team, chain->n, window_square, chain, x, w);
}

static double motion_speed(const Motion *m, const double *y)
{
    const int stride = planar_in(m)->ps.chain.stride;
    return stride_speed(&m->scene->chain, stride, 2, y + 3 * stride, 1, y + 5 * stride);
}

static hawser_status motion_renew(Motion *m, double t, const double *y, hawser_error *err)
{
    const hawser_status status = planar_refresh(planar_of(m), t, y, 1, err);
    if (!status) planar_narrow(planar_of(m), t, y);
    return status;
}

static int motion_worst(const Motion *m, const double *error, const double *weight)
{
    const PlanarChain *const chain = &planar_in(m)->ps.chain;
    return scales_worst_segment(chain->n, chain->stride, PLANAR_SIZE, error, weight);
}

static Vec3 motion_place(const Motion *m, const double *y, int segment)
{
    const Planar *const p = planar_in(m);
    return v3_add(p->ps.plane.origin, plane_vector(&p->ps.plane, y[segment], y[p->ps.chain.stride + segment]));
}

static void motion_unpack(const Motion *m, const double *y, double *full)
{
    plane_lift(&planar_in(m)->ps.plane, m->scene->chain.n, y, full);
}

static void motion_pack(Motion *m, const double *full, double *y)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    plane_press(&p->ps.plane, n, full, y);
    planar_scene_unwind(&p->ps, y[PLANAR_ANGLE * p->ps.chain.stride + n - 1]);
}

static void motion_checkpoint(Checkpoint *c, Motion *m)
{
    Planar *const p = planar_of(m);
    const int n = segments(p);
    CHECKPOINT(c, p->ps.winch_angle);
    chain_struct_checkpoint(c, "p->at", &p->at, n);
    chain_struct_checkpoint(c, "p->near", &p->near, n);
    CHECKPOINT_FROM(c, p, Planar, near_usable);
    planar_newton_checkpoint(c, &p->newton);
}

static void motion_lin_stats(const Motion *m, LinStats *stats) { linsolver_stats(planar_in(m)->newton.solver, stats); }

/* ------------------------------------------------------------------------------------------------------- life */

static int parts_new(Planar *p)
{
    const int n = segments(p);
    int ok = planar_kinematics_alloc(&p->kin, n) & chain_struct_alloc(&p->joints, n);
    ok &= chain_struct_alloc(&p->at, n) & chain_struct_alloc(&p->near, n);
    for (int half = 0, first = 0; half < PARTS; first += p->model[half++].n_rollers) {
        const ContactModel *const model = &p->ws->contact[half].model;
        ok &= chain_struct_alloc(&p->loads[half], n);
        p->model[half] = (PlanarContactModel){.geometry = model->geometry,
                                              .impact = model->impact,
                                              .n_rollers = model->n_rollers,
                                              .roller = p->ps.roller + first};
    }
    p->on_roller = calloc((size_t)p->motion.scene->contact.n_rollers + 1, sizeof *p->on_roller);
    return ok && p->on_roller;
}

hawser_status planar_new(Planar *p, const Scene *scene, const Plane *plane, Workspace *ws, const LinOptions *options,
                         hawser_error *err)
{
    static const MotionOps ops = {.rates = motion_rates,
                                  .linearise = motion_linearise,
                                  .form = motion_form,
                                  .factor = motion_factor,
                                  .solve = motion_solve,
                                  .weights = motion_weights,
                                  .norm = motion_norm,
                                  .speed = motion_speed,
                                  .accept = planar_accept,
                                  .renew = motion_renew,
                                  .worst = motion_worst,
                                  .whose = motion_whose,
                                  .place = motion_place,
                                  .look = planar_look,
                                  .glance = planar_glance,
                                  .winch_pull = motion_winch_pull,
                                  .work = planar_work,
                                  .method_loss = planar_method_loss,
                                  .stock = planar_stock,
                                  .relax = planar_relax,
                                  .pack = motion_pack,
                                  .unpack = motion_unpack,
                                  .lin_stats = motion_lin_stats,
                                  .checkpoint = motion_checkpoint};
    const int n = scene->chain.n;
    *p = (Planar){.motion = {&ops, scene, PLANAR_SIZE * planar_stride(n), ws->team, .pitch = planar_stride(n)},
                  .ws = ws,
                  .middle = halves_middle(n)};
    hawser_status status = HAWSER_OK;
    if (!planar_scene_new(&p->ps, scene, plane) || !parts_new(p)) status = error_memory(err);
    if (!status) status = planar_newton_new(&p->newton, &p->ps.chain, options, err);
    if (status) planar_free(p);
    return status;
}

void planar_free(Planar *p)
{
    if (!p->motion.ops) return;
    planar_newton_free(&p->newton);
    chain_struct_free(&p->kin);
    chain_struct_free(&p->joints);
    chain_struct_free(&p->at);
    chain_struct_free(&p->near);
    for (int half = 0; half < PARTS; ++half) chain_struct_free(&p->loads[half]);
    free(p->on_roller);
    planar_scene_free(&p->ps);
    memset(p, 0, sizeof *p);
}
