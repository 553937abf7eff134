#include "sim/planar/planar.h"

#include <math.h>
#include <string.h>

#include "core/base/clock.h"
#include "core/base/team.h"

static int segments(const Planar *p) { return p->ps.chain.n; }

/* One evaluation, as both threads see it. */
typedef struct Evaluation {
    Planar *p;
    double t, friction;
    const double *y;
    double *ydot;
    int behind; /* segments that the lead-in has */
    int finite[PARTS];
} Evaluation;

static int share_from(const Planar *p, int rank) { return rank == 0 ? 0 : p->middle; }
static int share_to(const Planar *p, int rank, int end) { return rank == 0 ? p->middle : end; }

/* Kinematics of one half, with its weight, and nothing yet in the second set of loads. */
static void kinematics_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Planar *const p = e->p;
    const int from = share_from(p, rank), to = share_to(p, rank, segments(p));
    planar_kernels()->kinematics(&p->ps.chain, e->y, from, to, &p->kin);
    p->ws->lead_in[rank] = planar_weight(&p->ps, &p->kin, from, to, e->behind, &p->loads[0]);
    double *const second[3] = {p->loads[1].f[0], p->loads[1].f[1], p->loads[1].m};
    for (int c = 0; c < 3; ++c) memset(second[c] + from, 0, (size_t)(to - from) * sizeof(double));
}

/* Wrenches of half of the joints, contacts of half of the rollers; the first half brings the loads at the ends. */
static void loads_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Planar *const p = e->p;
    p->ws->joint_power[rank].damping = planar_kernels()->joint_loads(&p->ps.chain, &p->kin, share_from(p, rank),
                                                                     share_to(p, rank, segments(p) + 1), &p->joints);
    if (rank == 0) planar_ends(&p->ps, &p->kin, e->t, e->friction, p->ws->tail_at, &p->loads[0]);
    if (p->model[rank].n_rollers == 0) return;
    ContactPart *const part = &p->ws->contact[rank];
    const double start = clock_now();
    planar_contact_forces(&p->model[rank], &p->ps.chain, &p->kin, e->friction, &part->pairs, &p->loads[rank],
                          p->on_roller + part->first);
    part->seconds += clock_now() - start;
}

static void motion_job(void *arg, int rank)
{
    Evaluation *const e = arg;
    Planar *const p = e->p;
    e->finite[rank] = planar_kernels()->rates(&p->ps.chain, &p->kin, &p->joints, p->loads, share_from(p, rank),
                                              share_to(p, rank, segments(p)), e->ydot);
}

static void both(Planar *p, TeamJob job, Evaluation *e) { halves_run(p->ws->team, segments(p) >= HALVES_LONG, job, e); }

void planar_place(Planar *p, double t, const double *y)
{
    planar_kernels()->kinematics(&p->ps.chain, y, 0, segments(p), &p->kin);
    planar_scene_ghosts(&p->ps, t, &p->kin);
}

/* NOLINTNEXTLINE(readability-non-const-parameter): the jobs write it */
int planar_evaluate(Planar *p, double t, const double *y, double friction, double *ydot)
{
    Evaluation e = {
        .p = p, .t = t, .friction = friction, .y = y, .ydot = ydot, .behind = planar_weight_behind(&p->ps, y)};
    both(p, kinematics_job, &e);
    planar_scene_ghosts(&p->ps, t, &p->kin); /* after the kinematics, whose last lane reaches beyond the chain */
    for (int c = 0; c < 2 && friction <= 0; ++c) p->kin.v[c][segments(p)] = 0; /* the search for rest: (E1) */
    both(p, loads_job, &e);
    both(p, motion_job, &e);
    ++p->ws->rhs_evals;
    return !(e.finite[0] && e.finite[1]);
}

static void joint_blocks_job(void *arg, int rank)
{
    Planar *const p = ((Evaluation *)arg)->p;
    planar_kernels()->joint_blocks(&p->ps.chain, &p->kin, share_from(p, rank), share_to(p, rank, segments(p) + 1),
                                   &p->newton.k, &p->newton.d);
}

static void join_job(void *arg, int rank)
{
    Planar *const p = ((Evaluation *)arg)->p;
    const int from = share_from(p, rank), to = share_to(p, rank, segments(p));
    planar_kernels()->blocks_join(&p->newton.k, from, to);
    planar_kernels()->blocks_join(&p->newton.d, from, to);
}

void planar_blocks(Planar *p, double t, const double *y, double friction)
{
    const PlanarChain *const chain = &p->ps.chain;
    PlanarBlocks *const k = &p->newton.k, *const d = &p->newton.d;
    const int n = chain->n;
    Evaluation e = {.p = p};
    planar_place(p, t, y);
    both(p, joint_blocks_job, &e);
    both(p, join_job, &e);
    planar_blocks_trim(k, n);
    planar_blocks_trim(d, n);
    planar_applied_blocks(&p->ps, &p->kin, t, friction, p->ws->tail_at, k, d);
    for (int half = 0; half < PARTS; ++half) {
        if (p->model[half].n_rollers == 0) continue;
        planar_contact_blocks(&p->model[half], chain, &p->kin, friction, &p->ws->contact[half].pairs, k, d);
    }
}

/* --------------------------------------------------------------------------------------- what steps renew, and looks
 */

/* Shares of the reach: within what candidates are near; what a step may move so that they suffice for the next. */
static const double NEAR = 1. / 4, NEAR_STEP = 1. / 128;

static double moved_since(const Planar *p, const PlanarStand *then)
{
    return planar_contact_kernels()->moved(&p->ps.chain, &p->kin, then->p, then->a);
}

static void stand(const Planar *p, PlanarStand *now)
{
    const size_t bytes = (size_t)segments(p) * sizeof(double);
    for (int c = 0; c < 2; ++c) {
        memcpy(now->p[c], p->kin.p[c], bytes);
        memcpy(now->a[c], p->kin.a[c], bytes);
    }
}

/* Chooses what is near the kinematics of now, of candidates since whose search points have moved by `spent`, m. */
static void near_choose(Planar *p, double spent, int wide)
{
    const double reach = p->motion.scene->contact.reach, left = CONTACT_USABLE * reach - spent;
    for (int half = 0; half < PARTS; ++half) {
        ContactPairs *const pairs = &p->ws->contact[half].pairs;
        if (wide) {
            contact_widen(pairs);
        } else {
            planar_contact_narrow(&p->model[half], &p->ps.chain, &p->kin, NEAR * reach, pairs);
        }
    }
    stand(p, &p->near);
    p->near_usable = wide ? left : fmin(left, CONTACT_USABLE * NEAR * reach);
    p->near_moved = 0;
    p->wide = wide;
}

void planar_widen(Planar *p)
{
    if (p->motion.scene->contact.n_rollers > 0) near_choose(p, moved_since(p, &p->at), 1);
}

void planar_narrow(Planar *p, double t, const double *y)
{
    if (p->motion.scene->contact.n_rollers == 0) return;
    planar_place(p, t, y);
    near_choose(p, moved_since(p, &p->at), 0);
}

/* (PL19), with the last evaluation for y as below. */
hawser_status planar_accept(Motion *m, double t, const double *y, hawser_error *err)
{
    Planar *const p = (Planar *)m;
    const Scene *const scene = m->scene;
    const double reach = scene->contact.reach;
    p->ws->tail_at = planar_tail_place(&p->ps, y, t, p->ws->tail_at, 0);
    if (scene->contact.n_rollers == 0) return HAWSER_OK;
    const double moved = moved_since(p, &p->near), step = fabs(moved - p->near_moved);
    const int fast = !(step <= NEAR_STEP * reach);
    p->near_moved = moved;
    if (moved <= p->near_usable && (p->wide || !fast)) return HAWSER_OK;
    const double spent = moved_since(p, &p->at);
    if (spent <= CONTACT_USABLE * reach) {
        near_choose(p, spent, fast);
        return HAWSER_OK;
    }
    const hawser_status status = planar_refresh(p, t, y, 1, err);
    if (!status) near_choose(p, 0, fast);
    return status;
}

hawser_status planar_refresh(Planar *p, double t, const double *y, int always, hawser_error *err)
{
    const Scene *const scene = p->motion.scene;
    if (always) p->ws->tail_at = planar_tail_place(&p->ps, y, t, p->ws->tail_at, 1);
    if (scene->contact.n_rollers == 0) return HAWSER_OK;
    /* (C20), with the last evaluation for y, which is nearer to it than the reach's reserve */
    const double moved = always ? 0 : moved_since(p, &p->at);
    if (!always && moved <= CONTACT_USABLE * scene->contact.reach) return HAWSER_OK;
    planar_place(p, t, y);
    planar_sim_kernels()->lift(&p->ps.plane, &p->ps.chain, &p->kin, &p->ws->kin);
    stand(p, &p->at);
    return dynamics_find_candidates(scene, p->ws, err);
}
