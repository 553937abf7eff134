#include "sim/dynamics.h"

#include <stdlib.h>
#include <string.h>

#include "core/bushing.h"
#include "core/lanes.h"
#include "core/machine.h"
#include "core/team.h"

/* Share of the whole weight that a segment feels at p (F1): 0 behind the start, 1 ahead. */
static double weight_share(const Weight *w, Vec3 p, double *slope)
{
    const double x = v3_dot(v3_sub(p, w->origin), w->direction);
    return step_cubic(x, -w->blend / 2, 0, w->blend / 2, 1, slope);
}

/* Acceleration with which the lead-in holds a segment that is off its line, m/s2. */
static Vec3 lead_in_hold(const Weight *w, const Kinematics *kin, int i)
{
    const Vec3 off = v3_reject(v3_sub(v3_load(kin->p, i), w->origin), w->direction);
    return v3_axpy(v3_scale(-w->hold, off), -w->hold_damping, v3_reject(v3_load(kin->v, i), w->direction));
}

/* m from the lead-in's line. A tail farther away is elsewhere on purpose; the lead-in would pull it with a thousand
 * times its weight. */
static const double ELSEWHERE = 1;

int weight_first_past(int n, int dims, const double *const p[], const double *origin, const double *direction, int held,
                      double past)
{
    for (int i = 0; i < n; ++i) {
        double along = 0, square = 0;
        for (int c = 0; c < dims; ++c) {
            const double off = p[c][i] - origin[c];
            along += off * direction[c];
            square += off * off;
        }
        if (!(along < past) || (i == 0 && held && square - along * along > ELSEWHERE * ELSEWHERE)) return i;
    }
    return n;
}

int weight_behind(const Scene *scene, const double *const p[3], double past)
{
    const Weight *const w = &scene->weight;
    const double origin[3] = {w->origin.x, w->origin.y, w->origin.z};
    const double direction[3] = {w->direction.x, w->direction.y, w->direction.z};
    return w->lead_in ? weight_first_past(scene->chain.n, 3, p, origin, direction, w->hold > 0, past) : 0;
}

/* Writes (does not add) the weight of segments from..to-1 into loads, with the lead-in's force on those among the first
 * `behind`. Returns the power and force of the lead-in. */
static Push weight_loads(const Scene *scene, const Kinematics *kin, int from, int to, int behind, Loads *loads)
{
    const Weight *const w = &scene->weight;
    const double g[3] = {w->gravity.x, w->gravity.y, w->gravity.z};
    for (int c = 0; c < 3; ++c) {
        for (int i = from; i < to; ++i) {
            loads->f[c][i] = scene->chain.mass[i] * g[c];
            loads->m[c][i] = 0;
        }
    }
    if (w->weightless > 0 && to == scene->chain.n) { /* the drum's mass moves with the last segment but its weight does
                                                      * not hang there */
        v3_gather(loads->f, to - 1, v3_scale(-w->weightless, w->gravity));
    }
    Push by = {0};
    for (int i = from; i < to && i < behind; ++i) {
        const double share = weight_share(w, v3_load(kin->p, i), NULL);
        const Vec3 pull = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        const Vec3 force = v3_scale((1 - share) * scene->chain.mass[i], pull);
        v3_gather(loads->f, i, force);
        by.power += v3_dot(force, v3_load(kin->v, i));
        by.force = v3_add(by.force, force);
    }
    return by;
}

void weight_blocks(const Scene *scene, const Kinematics *kin, BlockChain *k, BlockChain *d)
{
    const Weight *const w = &scene->weight;
    const double *const p[3] = {kin->p[0], kin->p[1], kin->p[2]};
    const int behind = weight_behind(scene, p, w->blend / 2);
    for (int i = 0; i < behind; ++i) {
        double slope;
        const double share = weight_share(w, v3_load(kin->p, i), &slope), m = scene->chain.mass[i];
        const Vec3 pull = v3_add(v3_sub(w->behind, w->gravity), lead_in_hold(w, kin, i));
        for (int c = 0; c < 3; ++c) {
            const Vec3 across = v3_reject(v3_axis(c), w->direction);
            const Vec3 entering = v3_scale(-slope * v3_dot(v3_axis(c), w->direction) * m, pull);
            block6_add(k->diag + 36 * i, c, v3_axpy(entering, -(1 - share) * m * w->hold, across), V3_ZERO);
            block6_add(d->diag + 36 * i, c, v3_scale(-(1 - share) * m * w->hold_damping, across), V3_ZERO);
        }
    }
}

/* Least number of segments for which two threads pay for joints with roller contacts; HALVES_LONG holds for lighter
 * loops. */
enum { MIDDLE_CHAIN = 500 };

/* Loops over the equipment kinds that are present in a scene and have OP, as `room`. */
#define EACH_ROOM(room, scene, op)                                                                                     \
    for (const Room *room = (scene)->room; room < (scene)->room + (scene)->n_rooms; ++room)                            \
        if (room->present && room->kind->op)

/* ------------------------------------------------------------------------------------------------- the workspace */

int workspace_alloc(Workspace *ws, const Scene *scene, Team *team)
{
    const int n = scene->chain.n;
    memset(ws, 0, sizeof *ws);
    ws->scene = scene;
    ws->team = team;
    ws->middle = halves_middle(n);
    int ok = kinematics_alloc(&ws->kin, n) && kinematics_alloc_slips(&ws->kin, &scene->chain);
    ok = ok && chain_struct_alloc(&ws->joints, n);
    for (int p = 0; p < PARTS; ++p) ok = ok && chain_struct_alloc(&ws->loads[p], n);
    ok &= chain_arrays_new(ws->law, 6, n, 0);
    EACH_ROOM(room, scene, work_alloc) ok = ok && room->kind->work_alloc(room, scene, ws);
    if (!ok) workspace_free(ws);
    return ok;
}

void workspace_free(Workspace *ws)
{
    if (!ws->scene) return;
    kinematics_free(&ws->kin);
    chain_struct_free(&ws->joints);
    for (int p = 0; p < PARTS; ++p) chain_struct_free(&ws->loads[p]);
    chain_arrays_free(ws->law, 6);
    EACH_ROOM(room, ws->scene, work_free) room->kind->work_free(room, ws);
    for (int r = 0; r < ROOMS_MAX; ++r) free(ws->room[r]);
    memset(ws, 0, sizeof *ws);
}

int stop_wanted(const StopCheck *check) { return check->ask && check->ask(check->user); }

/* Copies the slips of the joints that exist before and after. If a segment has joined behind the tail there is one
 * joint more, which has not bent yet. */
static void slips_carry(const Kinematics *old, const Kinematics *now, int joints, int joined)
{
    for (int k = 0; k < 2 * SLIDERS_MAX; ++k) {
        if (!old->slip[k]) continue;
        memcpy(now->slip[k] + joined + 1, old->slip[k] + 1, (size_t)(joints - joined - 1) * sizeof(double));
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
    EACH_ROOM(room, scene, carry) room->kind->carry(room, &old, ws, joined);
    ws->rhs_evals = old.rhs_evals;
    ws->refreshes = old.refreshes;
    ws->candidates_max = old.candidates_max;
    ws->stop = old.stop;
    workspace_free(&old);
    return 1;
}

void workspace_checkpoint(Checkpoint *c, Workspace *ws)
{
    const int n = ws->scene->chain.n;
    for (int k = 0; k < 2 * SLIDERS_MAX; ++k)
        if (ws->kin.slip[k]) chain_arrays_checkpoint(c, "kin.slip", &ws->kin.slip[k], 1, n);
    CHECKPOINT(c, ws->rhs_evals);
    CHECKPOINT(c, ws->refreshes);
    CHECKPOINT(c, ws->candidates_max);
    checkpoint_longs(c, 2, (const long[]){ws->rhs_evals, ws->refreshes});
    EACH_ROOM(room, ws->scene, checkpoint) room->kind->checkpoint(c, room, ws->scene, ws);
}

/* --------------------------------------------------------------------------------------------------- kinematics */

static void rooms_pose(const Moment *m, const double *y)
{
    const double *own = y + STATE_SIZE * m->scene->chain.n;
    scene_ghosts(m->scene, m->t, &m->ws->kin);
    for (const Room *room = m->scene->room; room < m->scene->room + m->scene->n_rooms; own += room++->states) {
        if (room->present && room->kind->pose) room->kind->pose(room, m, own);
    }
}

void dynamics_kinematics(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const Moment m = {.scene = scene, .ws = ws, .t = t};
    body_kernels()->kinematics(scene->chain.n, y, 0, scene->chain.n, &ws->kin);
    rooms_pose(&m, y);
}

/* --------------------------------------------------------------------------------------------------------- rates */

/* While equilibrium is sought, the ghosts that lead the ends stand still: the damping of their joints would count as a
 * load (E1). */
static void ghosts_stand(const Chain *chain, Kinematics *kin)
{
    for (int i = -1; i <= chain->n; i += chain->n + 1) {
        v3_store(kin->v, i, V3_ZERO);
        v3_store(kin->w, i, V3_ZERO);
    }
}

/* One evaluation, shared by both threads: the corridor of one step in three stages; each half needs the results of both
 * halves of the stage before. */
typedef struct Evaluation {
    Moment m;
    const double *y;
    double *ydot;
    BlockChain *k, *d;
    int behind; /* segments behind the route's start */
} Evaluation;

static int share_from(const Workspace *ws, int rank) { return rank == 0 ? 0 : ws->middle; }

static int share_to(const Workspace *ws, int rank, int end) { return rank == 0 ? ws->middle : end; }

static int behind_of(const Scene *scene, const double *y)
{
    const double *const p[3] = {y, y + scene->chain.n, y + 2 * scene->chain.n};
    return weight_behind(scene, p, scene->weight.blend / 2);
}

/* Kinematics and weight of one half; clears the second set of loads. */
static void kinematics_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    const Scene *const scene = e->m.scene;
    Workspace *const ws = e->m.ws;
    const int n = scene->chain.n, from = share_from(ws, rank), to = share_to(ws, rank, n);
    body_kernels()->kinematics(n, e->y, from, to, &ws->kin);
    ws->lead_in[rank] = weight_loads(scene, &ws->kin, from, to, e->behind, &ws->loads[0]);
    for (int c = 0; c < 3; ++c) {
        memset(ws->loads[1].f[c] + from, 0, (size_t)(to - from) * sizeof(double));
        memset(ws->loads[1].m[c] + from, 0, (size_t)(to - from) * sizeof(double));
    }
}

/* Joints and equipment loads of one half; the time of contacts is measured from the first contact on. */
static void loads_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    const Moment *const m = &e->m;
    Workspace *const ws = m->ws;
    const Chain *const chain = &m->scene->chain;
    double start = -1;
    ws->joint_power[rank] =
        bushing_kernels()->loads(chain, &ws->kin, share_from(ws, rank), share_to(ws, rank, chain->n + 1), &ws->joints);
    EACH_ROOM(room, m->scene, loads)
    {
        if (room->kind->touches && start < 0) start = clock_now();
        room->kind->loads(room, m, rank);
    }
    if (start >= 0) ws->contact[rank].seconds += clock_now() - start;
}

static void motion_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    const Workspace *const ws = e->m.ws;
    const Chain *const chain = &e->m.scene->chain;
    body_kernels()->rates(chain, &ws->kin, &ws->joints, ws->loads, e->y, share_from(ws, rank),
                          share_to(ws, rank, chain->n), e->ydot);
}

/* Checks whether joints and contacts gain more from a second thread than it costs to wake it and pass it the state. */
static int loads_heavy(const Scene *scene)
{
    EACH_ROOM(room, scene, heavy) return 1;
    return scene->chain.n >= MIDDLE_CHAIN;
}

/* Checks whether the chain is so long that jobs of a few nanoseconds per segment pay on two threads. */
static int is_long(const Scene *scene) { return scene->chain.n >= HALVES_LONG; }

void dynamics_pose(const Scene *scene, Workspace *ws, double t, const double *y, double friction)
{
    Evaluation e = {.m = {scene, ws, t, friction}, .y = y, .behind = behind_of(scene, y)};
    EACH_ROOM(room, scene, begin) room->kind->begin(room, &e.m);
    halves_run(ws->team, is_long(scene), kinematics_job, &e);
    rooms_pose(&e.m, y); /* after the kinematics, whose last lane reaches beyond the chain */
    if (friction <= 0) ghosts_stand(&scene->chain, &ws->kin);
}

void dynamics_loads(const Scene *scene, Workspace *ws, double t, double friction)
{
    Evaluation e = {.m = {scene, ws, t, friction}};
    halves_run(ws->team, loads_heavy(scene), loads_job, &e);
    EACH_ROOM(room, scene, after_loads) room->kind->after_loads(room, &e.m);
}

void dynamics_motion(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot)
{
    Evaluation e = {.m = {scene, ws, t, friction}, .y = y, .ydot = ydot};
    halves_run(ws->team, is_long(scene), motion_job, &e);
    int own = STATE_SIZE * scene->chain.n;
    for (const Room *room = scene->room; room < scene->room + scene->n_rooms; own += room++->states) {
        if (room->present && room->kind->rates) room->kind->rates(room, &e.m, y + own, ydot + own);
    }
    ++ws->rhs_evals;
}

void dynamics_rates(const Scene *scene, Workspace *ws, double t, const double *y, double friction, double *ydot)
{
    dynamics_pose(scene, ws, t, y, friction);
    dynamics_loads(scene, ws, t, friction);
    dynamics_motion(scene, ws, t, y, friction, ydot);
}

/* --------------------------------------------------------------------------------------------------------- blocks */

/* Bushings of one half, without the lane of joints at the middle, which involves segments of both halves. */
static void blocks_job(void *arg, int rank)
{
    const Evaluation *const e = arg;
    Workspace *const ws = e->m.ws;
    const Chain *const chain = &e->m.scene->chain;
    const int n = chain->n;
    if (rank == 0) {
        bushing_blocks(chain, &ws->kin, 0, ws->middle, e->k, e->d);
    } else if (ws->middle + LANES < n + 1) {
        bushing_blocks(chain, &ws->kin, ws->middle + LANES, n + 1, e->k, e->d);
    }
}

void dynamics_blocks(const Scene *scene, Workspace *ws, double t, const double *y, const double *ydot, double friction,
                     BlockChain *k, BlockChain *d)
{
    const Chain *const chain = &scene->chain;
    Evaluation e = {.m = {scene, ws, t, friction}, .k = k, .d = d};
    dynamics_kinematics(scene, ws, t, y);
    EACH_ROOM(room, scene, begin) room->kind->begin(room, &e.m);
    block_chain_zero(k);
    block_chain_zero(d);
    /* the order of addition does not depend on the number of threads: a sum of two terms commutes */
    const int after = ws->middle + LANES < chain->n + 1 ? ws->middle + LANES : chain->n + 1;
    halves_run(ws->team, 1, blocks_job, &e);
    bushing_blocks(chain, &ws->kin, ws->middle, after, k, d);
    body_blocks(chain, &ws->kin, ydot, 0, chain->n, k, d);
    weight_blocks(scene, &ws->kin, k, d);
    EACH_ROOM(room, scene, blocks) room->kind->blocks(room, &e.m, k, d);
    EACH_ROOM(room, scene, extra_blocks) room->kind->extra_blocks(room, &e.m, k, d);
}

/* ----------------------------------------------------------------------------------------------------- to look at */

/* The joint's force acts on the body before it, its opposite on the body after it. */
Push dynamics_ghost_push(const Moment *m, int joint)
{
    const Kinematics *const kin = &m->ws->kin;
    const JointLoads *const joints = &m->ws->joints;
    const int ghost = joint == 0 ? -1 : m->scene->chain.n;
    const Vec3 force = v3_scale(joint == 0 ? -1 : 1, v3_load(joints->force, joint));
    const Vec3 moment = v3_load(joint == 0 ? joints->torque_a : joints->torque_b, joint);
    return (Push){v3_dot(force, v3_load(kin->v, ghost)) - v3_dot(moment, v3_load(kin->w, ghost)), force};
}

void dynamics_tail_pull(const Scene *scene, Workspace *ws)
{
    bushing_kernels()->loads(&scene->chain, &ws->kin, 0, 2, &ws->joints);
}

void dynamics_soften(const Scene *scene, Workspace *ws, double share)
{
    for (int p = 0; p < PARTS; ++p) ws->contact[p].model.impact.k = share * scene->contact.impact.k;
    ws->surfaces.impact.k = share * scene->surfaces.model.impact.k;
}

int dynamics_look(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const Moment m = {scene, ws, t, 1};
    int active = 0;
    dynamics_kinematics(scene, ws, t, y);
    bushing_kernels()->law(&scene->chain, &ws->kin, 0, scene->chain.n + 1, ws->law);
    for (int p = 0; p < PARTS; ++p) loads_zero(&ws->loads[p], scene->chain.n);
    EACH_ROOM(room, scene, look) active += room->kind->look(room, &m);
    return active;
}

double dynamics_contact_seconds(const Workspace *ws)
{
    const double first = ws->contact[0].seconds, second = ws->contact[1].seconds;
    return team_size(ws->team) == PARTS ? fmax(first, second) : first + second;
}

/* -------------------------------------------------------------------------------------------------- between steps */

int dynamics_candidates(const Workspace *ws)
{
    int count = 0;
    EACH_ROOM(room, ws->scene, candidates) count += room->kind->candidates(room, ws);
    return count;
}

hawser_status dynamics_refresh(const Scene *scene, Workspace *ws, double t, const double *y, int always,
                               hawser_error *err)
{
    const Moment m = {scene, ws, t, 1};
    EACH_ROOM(room, scene, follow) room->kind->follow(room, &m, y, always);
    /* the last evaluation is closer to y than the reserve of the reach: it is good enough for this check */
    int due = 0;
    EACH_ROOM(room, scene, stale) due = due || always || room->kind->stale(room, &m);
    if (!due) return HAWSER_OK;
    dynamics_kinematics(scene, ws, t, y);
    return dynamics_find_candidates(scene, ws, err);
}

hawser_status dynamics_find_candidates(const Scene *scene, Workspace *ws, hawser_error *err)
{
    const Moment m = {.scene = scene, .ws = ws, .friction = 1};
    hawser_status status = HAWSER_OK;
    EACH_ROOM(room, scene, refresh) status = status ? status : room->kind->refresh(room, &m, err);
    ++ws->refreshes;
    const int count = dynamics_candidates(ws);
    if (count > ws->candidates_max) ws->candidates_max = count;
    return status;
}

void dynamics_accept(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const Moment m = {scene, ws, t, 1};
    const Chain *const chain = &scene->chain;
    int any = chain->sliders.count > 0;
    EACH_ROOM(room, scene, remembers) any |= room->kind->remembers(room, ws);
    if (!any) return;
    dynamics_kinematics(scene, ws, t, y);
    if (chain->sliders.count > 0) bushing_slip(chain, &ws->kin, 0, chain->n + 1);
    EACH_ROOM(room, scene, accept) room->kind->accept(room, &m);
}
