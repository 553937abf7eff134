#include "sim/dynamics.h"

#include <stdlib.h>
#include <string.h>

#include "core/base/clock.h"
#include "core/base/lanes.h"
#include "core/base/team.h"
#include "sim/loads.h"

/* Segments from which light loops pay on two threads, and joints with the contacts of rollers. */
enum { LONG_CHAIN = 1000, MIDDLE_CHAIN = 500 };

/* The rollers in two halves by number, which is mostly their order along the route. */
static int parts_alloc(Workspace *ws, const Scene *scene)
{
    const int rollers = scene->contact.n_rollers, half = rollers / 2;
    int ok = 1;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        part->model = scene->contact;
        part->model.roller = scene->contact.roller + (p == 0 ? 0 : half);
        part->model.n_rollers = p == 0 ? half : rollers - half;
        part->first = p == 0 ? 0 : half;
        part->sticks = contact_sticks(&part->model);
        if (scene->equipment.n > 0) {
            part->model.roller = ws->equipment.roller + part->first;
            part->model.motion = ws->equipment.motion + part->first;
        }
        ok &= contact_pairs_alloc(&part->pairs, scene->chain.n) & loads_alloc(&ws->loads[p], scene->chain.n);
    }
    /* the element before segment `middle` is the second half's */
    const int elements = scene->surfaces.points.elements, middle = elements > 0 ? ws->middle : 0;
    surface_pairs_init(&ws->contact[0].surface, 0, middle);
    surface_pairs_init(&ws->contact[1].surface, middle, elements);
    if (!surface_sticks(&ws->surfaces)) return ok;
    for (int p = 0; p < PARTS; ++p) {
        ok &= surface_pairs_sticks(&ws->contact[p].surface, &ws->surfaces, scene->chain.n);
    }
    return ok;
}

int workspace_alloc(Workspace *ws, const Scene *scene, Team *team)
{
    const int n = scene->chain.n;
    memset(ws, 0, sizeof *ws);
    ws->team = team;
    ws->middle = n / 2 / LANES * LANES;
    ws->surfaces = scene->surfaces.model;
    int ok = equipment_work_alloc(&ws->equipment, &scene->equipment, scene->contact.n_rollers, scene->rollers);
    ok = ok && kinematics_alloc(&ws->kin, n) && kinematics_alloc_slips(&ws->kin, &scene->chain);
    ok = ok && joint_loads_alloc(&ws->joints, n) & parts_alloc(ws, scene);
    for (int c = 0; c < 6; ++c) {
        ws->law[c] = chain_array_new(n, 0);
        ok = ok && ws->law[c];
    }
    if (scene->self.present) ok &= self_pairs_alloc(&ws->self, n);
    ws->on_roller = calloc((size_t)scene->contact.n_rollers + 1, sizeof *ws->on_roller);
    ws->on_surface = calloc((size_t)scene->surfaces.model.n_surfaces + 1, sizeof *ws->on_surface);
    ws->in_conveyor = calloc((size_t)scene->n_conveyors + 1, sizeof *ws->in_conveyor);
    ok = ok && ws->on_roller && ws->on_surface && ws->in_conveyor;
    if (!ok) workspace_free(ws);
    return ok;
}

void workspace_free(Workspace *ws)
{
    kinematics_free(&ws->kin);
    joint_loads_free(&ws->joints);
    for (int c = 0; c < 6; ++c) ws->law[c] = chain_array_free(ws->law[c]);
    for (int p = 0; p < PARTS; ++p) {
        contact_pairs_free(&ws->contact[p].pairs);
        surface_pairs_free(&ws->contact[p].surface);
        loads_free(&ws->loads[p]);
    }
    self_pairs_free(&ws->self);
    equipment_work_free(&ws->equipment);
    free(ws->on_surface);
    ws->on_surface = NULL;
    free(ws->on_roller);
    free(ws->in_conveyor);
    ws->in_conveyor = NULL;
    ws->on_roller = NULL;
}

/* The equipment's part of a state. */
static const double *equipment_of(const Scene *scene, const double *y) { return y + STATE_SIZE * scene->chain.n; }

/* Slips of joints that are there before and after: one number more if a segment has joined behind the tail, whose joint
 * has not bent yet. */
static void slips_carry(const Kinematics *old, const Kinematics *now, int joints, int joined)
{
    for (int k = 0; k < 2 * SLIDERS_MAX; ++k) {
        if (!old->slip[k]) continue;
        memcpy(now->slip[k] + joined + 1, old->slip[k] + 1, (size_t)(joints - joined - 1) * sizeof(double));
    }
}

/* The leans of friction that sticks, likewise: rollers keep their half, elements may have changed it. */
static void sticks_carry(Workspace *old, Workspace *now, int joined)
{
    for (int p = 0; p < PARTS; ++p) {
        if (now->contact[p].sticks) stick_carry(&old->contact[p].pairs.stick, &now->contact[p].pairs.stick, joined);
        for (int q = 0; q < PARTS && now->contact[p].surface.stick.n_beds > 0; ++q) {
            surface_carry(&old->contact[q].surface, &now->contact[p].surface, joined);
        }
    }
}

int workspace_renew(Workspace *ws, const Scene *scene, int joined)
{
    Workspace old = *ws;
    if (!workspace_alloc(ws, scene, old.team)) {
        *ws = old;
        return 0;
    }
    slips_carry(&old.kin, &ws->kin, scene->chain.n + 1, joined);
    sticks_carry(&old, ws, joined);
    ws->rhs_evals = old.rhs_evals;
    ws->refreshes = old.refreshes;
    ws->candidates_max = old.candidates_max;
    for (int p = 0; p < PARTS; ++p) ws->contact[p].seconds = old.contact[p].seconds;
    workspace_free(&old);
    return 1;
}

void dynamics_kinematics(const Scene *scene, Workspace *ws, double t, const double *y)
{
    body_kinematics(scene->chain.n, y, 0, scene->chain.n, &ws->kin);
    scene_ghosts(scene, t, &ws->kin);
    if (scene->equipment.n > 0) equipment_pose(&ws->equipment, equipment_of(scene, y));
}

/* Friction that sticks leans by what has been slid since the last accepted step (GR11). */
static void stick_time(Workspace *ws, double t)
{
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        if (part->sticks) stick_clock(&part->pairs.stick, t);
        if (part->surface.stick.n_beds > 0) surface_clock(&part->surface, t);
    }
}

/* One evaluation, as both threads see it. */
typedef struct Evaluation {
    const Scene *scene;
    Workspace *ws;
    double t, friction;
    const double *y;
    double *ydot;
    BlockChain *k, *d;
} Evaluation;

/* Contact forces of one half of the rollers, onto ws->loads; on_roller (NULL: not wanted) gets those on the rollers. */
static void part_forces(const Scene *scene, Workspace *ws, int part, double friction, Vec3 *on_roller)
{
    ContactPart *const p = &ws->contact[part];
    RollerLoad *const load = p->model.motion ? ws->equipment.load + p->first : NULL;
    contact_forces(&p->model, &scene->chain, &ws->kin, friction, &p->pairs, &ws->loads[part], on_roller, load);
}

/* Few segments, and their loads come in the order of the machines: no work for two. */
static void conveyors_loads(const Evaluation *e)
{
    const Scene *const s = e->scene;
    for (int i = 0; i < s->n_conveyors; ++i) {
        conveyor_loads(&s->conveyor[i], &e->ws->in_conveyor[i], &s->winch, &s->chain, &e->ws->kin, e->t, e->friction,
                       &e->ws->loads[0]);
    }
}

/* The contacts of one half of the rollers; the first half brings the loads at the ends and of conveyors too. */
static void part_loads(const Evaluation *e, int part)
{
    Workspace *const ws = e->ws;
    ContactPart *const mine = &ws->contact[part];
    if (part == 0) {
        applied_ends(e->scene, &ws->kin, e->t, e->friction, &ws->loads[0]);
        conveyors_loads(e);
    }
    const SelfModel *const self = &e->scene->self;
    const SurfaceModel *const surfaces = &ws->surfaces;
    const Chain *const chain = &e->scene->chain;
    if (mine->model.n_rollers == 0 && !self->present && surfaces->n_patches == 0) return;
    const double start = clock_now();
    if (mine->model.n_rollers > 0) part_forces(e->scene, ws, part, e->friction, NULL);
    if (self->present) self_forces(self, chain, &ws->kin, e->friction, part, &ws->self, &ws->loads[part]);
    if (surfaces->n_patches > 0) {
        surface_forces(surfaces, chain, &ws->kin, e->friction, &mine->surface, &ws->loads[part], NULL);
    }
    mine->seconds += clock_now() - start;
}

/* The corridor of one step in three strides; each half needs what both halves did in the stride before. */
/* Kinematics of one half, with its weight, and nothing yet in the second set of loads. */
static void kinematics_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Workspace *const ws = e->ws;
    const int n = e->scene->chain.n, from = rank == 0 ? 0 : ws->middle, to = rank == 0 ? ws->middle : n;
    body_kinematics(n, e->y, from, to, &ws->kin);
    ws->lead_in[rank] = applied_weight(e->scene, &ws->kin, from, to, &ws->loads[0]);
    for (int c = 0; c < 3; ++c) {
        memset(ws->loads[1].f[c] + from, 0, (size_t)(to - from) * sizeof(double));
        memset(ws->loads[1].m[c] + from, 0, (size_t)(to - from) * sizeof(double));
    }
}

static void loads_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    const Chain *const chain = &e->scene->chain;
    const int middle = e->ws->middle;
    e->ws->joint_power[rank] =
        bushing_loads(chain, &e->ws->kin, rank == 0 ? 0 : middle, rank == 0 ? middle : chain->n + 1, &e->ws->joints);
    part_loads(e, rank);
}

static void motion_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    const Workspace *const ws = e->ws;
    const int n = e->scene->chain.n;
    body_rates(&e->scene->chain, &ws->kin, &ws->joints, ws->loads, e->y, rank == 0 ? 0 : ws->middle,
               rank == 0 ? ws->middle : n, e->ydot);
}

/* Whether joints and contacts gain more from a second thread than it takes to wake it and to send it the state. What
 * lies on surfaces or on itself has so much to compute that they do in any case. */
static int loads_heavy(const Scene *scene)
{
    return scene->chain.n >= MIDDLE_CHAIN || scene->surfaces.model.n_surfaces > 0 || scene->self.present;
}

/* Both shares of a job, on two threads where that is worth it, or in a row. */
static void both(Workspace *ws, TeamJob job, int worth, Evaluation *e)
{
    if (worth && team_size(ws->team) == PARTS) {
        team_run(ws->team, job, e);
    } else {
        job(e, 0);
        job(e, 1);
    }
}

void dynamics_rates(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot)
{
    Evaluation e = {.scene = scene, .ws = ws, .t = t, .friction = friction, .y = y};
    e.ydot = ydot;
    stick_time(ws, t);
    const int is_long = scene->chain.n >= LONG_CHAIN; /* jobs of a few nanoseconds a segment */
    both(ws, kinematics_job, is_long, &e);
    scene_ghosts(scene, t, &ws->kin); /* after the kinematics, whose last lane reaches beyond the chain */
    if (scene->equipment.n > 0) equipment_pose(&ws->equipment, equipment_of(scene, y));
    both(ws, loads_job, loads_heavy(scene), &e);
    if (scene->drum.present) {
        ws->drum_hold = drum_hold(&scene->drum, &ws->kin, &ws->equipment, friction, &ws->loads[0]);
    }
    both(ws, motion_job, is_long, &e);
    if (scene->equipment.n > 0) {
        equipment_rates(&ws->equipment, equipment_of(scene, y), friction, ydot + STATE_SIZE * scene->chain.n);
    }
    ++ws->rhs_evals;
}

/* Bushings and inertia of one half, without the lane of joints at the middle, which touches segments of both. */
static void blocks_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Workspace *const ws = e->ws;
    const Chain *const chain = &e->scene->chain;
    const int n = chain->n;
    if (rank == 0) {
        bushing_blocks(chain, &ws->kin, 0, ws->middle, e->k, e->d);
    } else if (ws->middle + LANES < n + 1) {
        bushing_blocks(chain, &ws->kin, ws->middle + LANES, n + 1, e->k, e->d);
    }
}

/* Surfaces under one half, without the element at the middle, which hangs on segments of both. */
static void surface_blocks_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Workspace *const ws = e->ws;
    const int from = rank == 0 ? 0 : ws->middle + 1, to = rank == 0 ? ws->middle : e->scene->chain.n + 1;
    surface_blocks(&ws->surfaces, &e->scene->chain, &ws->kin, e->friction, &ws->contact[rank].surface, from, to, e->k,
                   e->d);
}

static void blocks_of_surfaces(Evaluation *e)
{
    Workspace *const ws = e->ws;
    both(ws, surface_blocks_job, 1, e);
    surface_blocks(&ws->surfaces, &e->scene->chain, &ws->kin, e->friction, &ws->contact[1].surface, ws->middle,
                   ws->middle + 1, e->k, e->d);
}

/* Adds up in the order that does not depend on the number of threads: two terms of a sum commute. */
static void blocks_of_chain(Evaluation *e)
{
    Workspace *const ws = e->ws;
    const Chain *const chain = &e->scene->chain;
    const int after = ws->middle + LANES < chain->n + 1 ? ws->middle + LANES : chain->n + 1;
    both(ws, blocks_job, 1, e);
    bushing_blocks(chain, &ws->kin, ws->middle, after, e->k, e->d);
    body_blocks(chain, &ws->kin, e->ydot, 0, chain->n, e->k, e->d);
}

/* What a part's contacts couple its rollers by. */
typedef struct Taker {
    EquipmentWork *work;
    int first;
} Taker;
static void coupling_take(void *user, const RollerCoupling *coupling)
{
    const Taker *const to = user;
    equipment_blocks_take(to->work, to->first, coupling);
}

/* The contacts' derivatives of one half; where rollers move, their loads and couplings too. */
static void part_blocks(const Scene *scene, Workspace *ws, int part, double friction, BlockChain *k, BlockChain *d)
{
    ContactPart *const p = &ws->contact[part];
    Taker taker = {&ws->equipment, p->first};
    if (p->model.motion) part_forces(scene, ws, part, friction, NULL);
    contact_blocks(&p->model, &scene->chain, &ws->kin, friction, &p->pairs, k, d,
                   p->model.motion ? coupling_take : NULL, &taker);
}

void dynamics_blocks(const Scene *scene, Workspace *ws, double t, const double *y, const double *ydot, double friction,
                     BlockChain *k, BlockChain *d)
{
    const Chain *const chain = &scene->chain;
    Evaluation e = {.scene = scene, .ws = ws, .friction = friction, .ydot = (double *)ydot, .k = k, .d = d};
    dynamics_kinematics(scene, ws, t, y);
    stick_time(ws, t);
    block_chain_zero(k);
    block_chain_zero(d);
    blocks_of_chain(&e);
    applied_blocks(scene, &ws->kin, t, friction, k, d);
    for (int i = 0; i < scene->n_conveyors; ++i) {
        conveyor_blocks(&scene->conveyor[i], &ws->in_conveyor[i], &scene->winch, chain, &ws->kin, t, friction, k, d);
    }
    if (scene->equipment.n > 0) equipment_blocks_begin(&ws->equipment);
    for (int p = 0; p < PARTS; ++p) {
        if (ws->contact[p].model.n_rollers > 0) part_blocks(scene, ws, p, friction, k, d);
    }
    if (ws->surfaces.n_patches > 0) blocks_of_surfaces(&e);
    if (scene->drum.present) drum_hold_blocks(&scene->drum, &ws->kin, &ws->equipment, friction, k, d);
    if (scene->equipment.n > 0) equipment_bushing_blocks(&ws->equipment);
    if (!scene->self.present) return;
    block_extras_zero(&ws->self.extras);
    self_blocks(&scene->self, chain, &ws->kin, friction, &ws->self, k, d);
}

int dynamics_roller_forces(const Scene *scene, Workspace *ws)
{
    int active = 0;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        if (part->model.n_rollers == 0) continue;
        loads_zero(&ws->loads[p], scene->chain.n);
        part_forces(scene, ws, p, 1.0, ws->on_roller + part->first);
        active += part->pairs.active;
    }
    for (int p = 0; p < PARTS; ++p) active += ws->self.active[p]; /* of the last evaluation */
    return active;
}

double dynamics_winch_pull(const Scene *scene, Workspace *ws, double t)
{
    const Winch *const w = &scene->winch;
    const int n = scene->chain.n;
    if (!w->present) return 0;
    if (w->mode == WINCH_TENSION) return winch_pull(w, &scene->chain, &ws->kin, t);
    bushing_loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1, &ws->joints); /* the last lane holds the head's */
    const Vec3 pull = v3(ws->joints.force[0][n], ws->joints.force[1][n], ws->joints.force[2][n]);
    return v3_dot(pull, w->direction);
}

void dynamics_tail_pull(const Scene *scene, Workspace *ws)
{
    bushing_loads(&scene->chain, &ws->kin, 0, 2, &ws->joints);
}

double dynamics_winch_pull_at(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const int n = scene->chain.n;
    body_kinematics(n, y, (n - 1) / LANES * LANES, n, &ws->kin);
    scene_ghosts(scene, t, &ws->kin);
    return dynamics_winch_pull(scene, ws, t);
}

void dynamics_soften(const Scene *scene, Workspace *ws, double share)
{
    for (int p = 0; p < PARTS; ++p) ws->contact[p].model.impact.k = share * scene->contact.impact.k;
    ws->surfaces.impact.k = share * scene->surfaces.model.impact.k;
}

int dynamics_surface_forces(const Scene *scene, Workspace *ws)
{
    const SurfaceModel *const model = &ws->surfaces;
    int active = 0;
    for (int i = 0; i < model->n_surfaces; ++i) ws->on_surface[i] = surface_tally_new();
    for (int p = 0; p < PARTS && model->n_patches > 0; ++p) {
        SurfacePairs *const pairs = &ws->contact[p].surface;
        loads_zero(&ws->loads[p], scene->chain.n);
        surface_forces(model, &scene->chain, &ws->kin, 1.0, pairs, &ws->loads[p], ws->on_surface);
        active += pairs->active;
    }
    return active;
}

int dynamics_look(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const Chain *const chain = &scene->chain;
    const int n = chain->n;
    dynamics_kinematics(scene, ws, t, y);
    bushing_law(chain, &ws->kin, 0, n + 1, ws->law);
    ws->winch_pull = dynamics_winch_pull(scene, ws, t);
    const int active = dynamics_roller_forces(scene, ws);
    return scene->surfaces.model.n_surfaces > 0 ? active + dynamics_surface_forces(scene, ws) : active;
}

ConveyorNow dynamics_conveyor(const Scene *scene, const Workspace *ws, int i, double t)
{
    return conveyor_loads(&scene->conveyor[i], &ws->in_conveyor[i], &scene->winch, &scene->chain, &ws->kin, t, 1.0,
                          NULL);
}

double dynamics_contact_seconds(const Workspace *ws)
{
    const double first = ws->contact[0].seconds, second = ws->contact[1].seconds;
    return team_size(ws->team) == PARTS ? fmax(first, second) : first + second;
}

int dynamics_candidates(const Workspace *ws)
{
    int count = ws->self.candidates;
    for (int p = 0; p < PARTS; ++p) count += ws->contact[p].pairs.candidates + ws->contact[p].surface.candidates;
    return count;
}

/* Whether a part's candidates no longer cover what can touch. */
static int stale(const Scene *scene, const Workspace *ws)
{
    const ContactPart *const part = &ws->contact[PARTS - 1]; /* both were refreshed at the same positions */
    if (scene->self.present && self_moved_too_far(&scene->self, &scene->chain, &ws->kin, &ws->self)) return 1;
    if (scene->contact.n_rollers == 0 && ws->surfaces.n_patches == 0) return 0;
    ContactModel model = part->model;
    /* what rollers have moved is spent of the share of the reach (C20) */
    if (scene->equipment.mounts > 0) model.reach -= equipment_moved(&ws->equipment) / CONTACT_USABLE;
    return contact_moved_too_far(&model, &scene->chain, &ws->kin, &part->pairs);
}

/* Finds again what is in the conveyors that have moved on. */
static void conveyors_refresh(const Scene *scene, Workspace *ws, const double *y, int always)
{
    for (int i = 0; i < scene->n_conveyors; ++i) {
        ConveyorRange *const range = &ws->in_conveyor[i];
        if (!always && !conveyor_stale(range, &scene->chain, y)) continue;
        conveyor_find(&scene->conveyor[i], &scene->chain, y, scene->contact.reach, range);
    }
}

hawser_status dynamics_refresh(const Scene *scene, Workspace *ws, double t, const double *y, int always,
                               hawser_error *err)
{
    conveyors_refresh(scene, ws, y, always);
    const SurfaceModel *const surfaces = &ws->surfaces;
    if (scene->contact.n_rollers == 0 && !scene->self.present && surfaces->n_patches == 0) return HAWSER_OK;
    /* the last evaluation is nearer to y than the reach's reserve: it will do for the question */
    if (!always && !stale(scene, ws)) return HAWSER_OK;
    dynamics_kinematics(scene, ws, t, y);
    return dynamics_find_candidates(scene, ws, err);
}

hawser_status dynamics_find_candidates(const Scene *scene, Workspace *ws, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int p = 0; p < PARTS && !status; ++p) {
        ContactPart *const part = &ws->contact[p];
        status = contact_refresh(&part->model, &scene->chain, &ws->kin, &part->pairs, err);
        if (!status) status = surface_refresh(&ws->surfaces, &scene->chain, &ws->kin, &part->surface, err);
    }
    if (!status && scene->self.present) status = self_refresh(&scene->self, &scene->chain, &ws->kin, &ws->self, err);
    if (scene->equipment.n > 0) equipment_stand(&ws->equipment);
    ++ws->refreshes;
    if (dynamics_candidates(ws) > ws->candidates_max) ws->candidates_max = dynamics_candidates(ws);
    return status;
}

/* Whether something remembers what was at the last accepted step. */
static int remembers(const Scene *scene, const Workspace *ws)
{
    int any = scene->chain.sliders.count > 0;
    for (int p = 0; p < PARTS; ++p) any |= ws->contact[p].sticks || ws->contact[p].surface.stick.n_beds > 0;
    return any;
}

void dynamics_accept(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const Chain *const chain = &scene->chain;
    if (!remembers(scene, ws)) return;
    dynamics_kinematics(scene, ws, t, y);
    if (chain->sliders.count > 0) bushing_slip(chain, &ws->kin, 0, chain->n + 1);
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        if (part->sticks) contact_accept(&part->model, chain, &ws->kin, t, &part->pairs);
        if (part->surface.stick.n_beds == 0) continue;
        surface_accept(&ws->surfaces, chain, &ws->kin, t, &part->surface);
    }
}
