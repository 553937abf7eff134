/* Rollers, fixed and moving: what the cable touches at single places. docs/model.md, "Contact", "Rollers that spin and
 * rollers on mounts". What moves them is in sim/equipment/moving_rollers.h and roller_motion.h. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "sim/dynamics.h"
#include "sim/equipment/roller_motion.h"
#include "sim/equipment/rooms.h"

/* A roller that may be held fast, or whose friction changes. */
typedef struct HeldRoller {
    int roller;
    const Seizure *by; /* NULL: what it is told */
    Seizure told;
    double mu;        /* with which the cable drags over it when it stands; NAN: as ever */
    double torque;    /* N m, of the jammed bearing besides what follows the load */
    Profile friction; /* its coefficients over the case's (K6) */
} HeldRoller;

typedef struct Rollers {
    int n;
    ContactRoller *roller; /* [n], as the case puts them */
    Equipment equipment;   /* those that move */
    int n_held;
    HeldRoller *held; /* [n_held], room for every roller: one for each that ever was */
} Rollers;

/* What a workspace has of its own: friction laws and bearings, by time where rollers may be held. */
typedef struct HeldWork {
    ContactRoller *roller; /* [n] of the scene, where none moves */
    Equipment equipment;   /* the scene's, but with items of its own */
} HeldWork;

/* ---------------------------------------------------------------------------------------------------- building */

/* Surfaces need it too: where the chain was at the last refresh is kept with the rollers' candidates. */
static hawser_status rollers_build(Room *room, Scene *scene, hawser_error *err)
{
    const SceneDef *const def = &scene->def;
    Rollers *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    scene->equipment = &all->equipment;
    scene->rollers = all->roller = calloc((size_t)def->n_rollers + 1, sizeof *all->roller);
    all->n = def->n_rollers;
    all->held = calloc((size_t)def->n_rollers + 1, sizeof *all->held);
    if (!all->roller || !all->held) return error_memory(err);
    for (int r = 0; r < def->n_rollers; ++r) {
        const RollerDef *const d = &def->rollers[r];
        all->roller[r] = (ContactRoller){.shape = roller_def_shape(d), .friction = d->friction};
    }
    scene->contact = (ContactModel){.geometry = def->geometry,
                                    .impact = def->impact,
                                    .n_rollers = def->n_rollers,
                                    .roller = all->roller,
                                    .reach = def->contact_reach};
    room->present = def->n_rollers > 0 || def->n_surfaces > 0;
    const hawser_status status = equipment_build(def, all->roller, &all->equipment, err);
    room->states = equipment_size(&all->equipment);
    return status;
}

static void rollers_clear(Room *room)
{
    Rollers *const all = room->self;
    if (!all) return;
    equipment_clear(&all->equipment);
    free(all->roller);
    free(all->held);
}

/* Of cable jackets on a steel shell that stands. */
static const double STANDING_MU = 0.4;

/* What is kept of a roller that is held; a new one is free and has its own friction. */
static HeldRoller *held_of(Rollers *all, int r)
{
    int h = 0;
    while (h < all->n_held && all->held[h].roller != r) ++h;
    if (h < all->n_held) return &all->held[h];
    all->held[all->n_held++] = (HeldRoller){.roller = r, .mu = NAN, .friction = profile_level(1)};
    return &all->held[h];
}

/* A roller that spins keeps its friction; one that does not has had its bearing in it, and drags. */
static void held_set(HeldRoller *held, const Scene *scene, const Seizure *by)
{
    const RollerDef *const def = &scene->def.rollers[held->roller];
    const double inertia = def->spin.inertia;
    held->mu = isnan(by->mu) && !(inertia > 0) ? STANDING_MU : by->mu;
    held->torque = inertia * scene->largest_speed / def->radius / by->ramp;
}

static int roller_called(const SceneDef *def, const char *name)
{
    for (int r = 0; r < def->n_rollers; ++r) {
        if (strcmp(def->rollers[r].name, name) == 0) return r;
    }
    return -1;
}

static const char *rollers_seize(Room *room, const Scene *scene, const char *name, const Seizure *by)
{
    const int r = roller_called(&scene->def, name);
    if (r < 0) return NULL;
    HeldRoller *const held = held_of(room->self, r);
    held->by = by;
    held_set(held, scene, by);
    return "roller";
}

static void rollers_start(const Room *room, double *own)
{
    const Rollers *const all = room->self;
    equipment_initial(&all->equipment, own);
}

/* ------------------------------------------------------------------------------------------ rollers that are held */

/* Of what the cable can turn a roller with: the jammed bearing's limit (JA5). */
static const double HOLD = 20;

/* (JA4) */
static FrictionLaw held_friction(const HeldRoller *held, FrictionLaw law, double share, double factor)
{
    law = friction_scaled(law, factor);
    if (isnan(held->mu)) return law;
    law.mu_s = fmax(law.mu_s + share * (held->mu - law.mu_s), FRICTION_HARDLY_ANY);
    law.mu_d = fmax(law.mu_d + share * (held->mu - law.mu_d), FRICTION_HARDLY_ANY);
    return law;
}

/* (JA5) */
static Bearing held_bearing(const HeldRoller *held, Bearing bearing, double most, double share)
{
    bearing.journal = bearing.friction * bearing.journal + share * HOLD * most;
    bearing.friction = 1;
    bearing.torque += share * held->torque;
    return bearing;
}

/* Friction laws and bearings of time t, into the workspace. */
static void rollers_hold(const Room *room, Workspace *ws, double t)
{
    const Rollers *const all = room->self;
    HeldWork *const own = ws->room[room->number];
    const int moving = all->equipment.n > 0;
    for (int h = 0; h < all->n_held; ++h) {
        const HeldRoller *const held = &all->held[h];
        const ContactRoller *const usual = &all->roller[held->roller];
        const Seizure *const by = held->by ? held->by : &held->told;
        const double share = profile_value(&by->share, t), factor = profile_value(&held->friction, t);
        ContactRoller *const now = (moving ? ws->equipment->roller : own->roller) + held->roller;
        now->friction = held_friction(held, usual->friction, share, factor);
        const int k = moving ? ws->equipment->item_of[held->roller] : -1;
        if (k < 0) continue;
        own->equipment.item[k].bearing =
            held_bearing(held, all->equipment.item[k].bearing, now->friction.mu_s * usual->shape.radius, share);
    }
}

static HeldWork *held_work_new(const Rollers *all, int n)
{
    HeldWork *const own = calloc(1, sizeof *own);
    const int moving = all->equipment.n;
    if (!own) return NULL;
    own->roller = calloc((size_t)n + 1, sizeof *own->roller);
    own->equipment = all->equipment;
    own->equipment.item = calloc((size_t)moving + 1, sizeof *own->equipment.item);
    if (own->roller) memcpy(own->roller, all->roller, (size_t)n * sizeof *own->roller);
    if (own->equipment.item && moving > 0)
        memcpy(own->equipment.item, all->equipment.item, (size_t)moving * sizeof *own->equipment.item);
    return own;
}

/* In two halves by number, which is mostly their order along the route. */
static int rollers_work_alloc(const Room *room, const Scene *scene, Workspace *ws)
{
    const Rollers *const all = room->self;
    const int n = scene->contact.n_rollers, half = n / 2;
    EquipmentWork *const moving = ws->equipment = calloc(1, sizeof *moving);
    ws->on_roller = calloc((size_t)n + 1, sizeof *ws->on_roller);
    HeldWork *const own = held_work_new(all, n);
    ws->room[room->number] = own;
    int ok = moving && ws->on_roller && own && own->roller && own->equipment.item;
    ok = ok && equipment_work_alloc(moving, &own->equipment, n, all->roller);
    if (ok) rollers_hold(room, ws, 0);
    for (int p = 0; ok && p < PARTS; ++p) {
        ContactPart *const part = &ws->contact[p];
        part->model = scene->contact;
        part->model.roller = own->roller + (p == 0 ? 0 : half);
        part->model.n_rollers = p == 0 ? half : n - half;
        part->first = p == 0 ? 0 : half;
        part->sticks = contact_sticks(&part->model);
        if (all->equipment.n > 0) {
            part->model.roller = moving->roller + part->first;
            part->model.motion = moving->motion + part->first;
        }
        ok = contact_pairs_alloc(&part->pairs, scene->chain.n);
    }
    return ok;
}

static void rollers_work_free(const Room *room, Workspace *ws)
{
    HeldWork *const own = ws->room[room->number];
    for (int p = 0; p < PARTS; ++p) contact_pairs_free(&ws->contact[p].pairs);
    if (ws->equipment) equipment_work_free(ws->equipment);
    free(ws->equipment);
    free(ws->on_roller);
    if (!own) return;
    free(own->roller);
    free(own->equipment.item);
}

/* The leans of friction that sticks: rollers keep their half. */
static void rollers_carry(const Room *room, Workspace *from, Workspace *to, int joined)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        if (to->contact[p].sticks) stick_carry(&from->contact[p].pairs.stick, &to->contact[p].pairs.stick, joined);
        to->contact[p].seconds = from->contact[p].seconds;
    }
}

/* ------------------------------------------------------------------------------------------------------ in a step */

static void rollers_pose(const Room *room, const Moment *m, const double *own)
{
    if (room->states > 0) equipment_pose(m->ws->equipment, own);
    rollers_hold(room, m->ws, m->t);
}

/* Friction that sticks leans by what has been slid since the last accepted step (GR11). */
static void rollers_begin(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->sticks) stick_clock(&part->pairs.stick, m->t);
    }
}

/* Contact forces of one half of the rollers; on_roller (NULL: not wanted) gets those on them. */
static void part_forces(const Moment *m, int part, double friction, Vec3 *on_roller)
{
    Workspace *const ws = m->ws;
    ContactPart *const p = &ws->contact[part];
    RollerLoad *const load = p->model.motion ? ws->equipment->load + p->first : NULL;
    if (p->model.n_rollers == 0) return;
    contact_forces(&p->model, &m->scene->chain, &ws->kin, friction, &p->pairs, &ws->loads[part], on_roller, load);
}

static void rollers_loads(const Room *room, const Moment *m, int part)
{
    (void)room;
    part_forces(m, part, m->friction, m->ws->on_roller + m->ws->contact[part].first);
}

static void rollers_rates(const Room *room, const Moment *m, const double *own, double *rate)
{
    if (room->states > 0) equipment_rates(m->ws->equipment, own, m->friction, rate);
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

/* Where rollers move, their loads and couplings too. */
static void rollers_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    Workspace *const ws = m->ws;
    const Chain *const chain = &m->scene->chain;
    if (room->states > 0) equipment_blocks_begin(ws->equipment);
    for (int half = 0; half < PARTS; ++half) {
        ContactPart *const p = &ws->contact[half];
        if (p->model.n_rollers == 0) continue;
        Taker taker = {ws->equipment, p->first};
        if (p->model.motion) part_forces(m, half, m->friction, NULL);
        contact_blocks(&p->model, chain, &ws->kin, m->friction, &p->pairs, k, d, p->model.motion ? coupling_take : NULL,
                       &taker);
    }
    if (room->states > 0) equipment_bushing_blocks(ws->equipment);
}

/* -------------------------------------------------------------------------------------------------- between steps */

/* Both parts were refreshed at the same positions; what rollers have moved is spent of the share of the reach (C20). */
static int rollers_stale(const Room *room, const Moment *m)
{
    const ContactPart *const part = &m->ws->contact[PARTS - 1];
    const Rollers *const all = room->self;
    ContactModel model = part->model;
    if (all->equipment.mounts > 0) model.reach -= equipment_moved(m->ws->equipment) / CONTACT_USABLE;
    return contact_moved_too_far(&model, &m->scene->chain, &m->ws->kin, &part->pairs);
}

static hawser_status rollers_refresh(const Room *room, const Moment *m, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int p = 0; p < PARTS && !status; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        status = contact_refresh(&part->model, &m->scene->chain, &m->ws->kin, &part->pairs, err);
    }
    if (room->states > 0) equipment_stand(m->ws->equipment);
    return status;
}

static int rollers_candidates(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].pairs.candidates + ws->contact[1].pairs.candidates;
}

static int rollers_remember(const Room *room, const Workspace *ws)
{
    (void)room;
    return ws->contact[0].sticks | ws->contact[1].sticks;
}

static void rollers_accept(const Room *room, const Moment *m)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->sticks) contact_accept(&part->model, &m->scene->chain, &m->ws->kin, m->t, &part->pairs);
    }
}

static void rollers_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)scene;
    const Rollers *const all = room->self;
    for (int p = 0; p < PARTS; ++p) {
        contact_pairs_checkpoint(c, &ws->contact[p].model, &ws->contact[p].pairs);
        CHECKPOINT(c, ws->contact[p].seconds);
    }
    if (all->equipment.n > 0)
        checkpoint_put(c, "equipment->stood", ws->equipment->stood,
                       2 * (size_t)all->equipment.n * sizeof *ws->equipment->stood);
}

/* The ends of what it was told. */
static double rollers_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Rollers *const all = room->self;
    double next = INFINITY;
    for (int h = 0; h < all->n_held; ++h) {
        next = profile_corner_before(&all->held[h].told.share, t, next);
        next = profile_corner_before(&all->held[h].friction, t, next);
    }
    return next;
}

/* (K6), (JA2). A law without friction stays without. */
static int rollers_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    Rollers *const all = room->self;
    const SceneDef *const def = &scene->def;
    const int r = *c->what ? roller_called(def, c->what) : -1;
    if (c->kind == HAWSER_FRICTION && !*c->what) {
        for (int i = 0; i < def->n_rollers; ++i) {
            HeldRoller *const held = held_of(all, i);
            held->friction = command_ramp(&held->friction, t, c->value, c->ramp);
        }
        return def->n_rollers > 0;
    }
    if (r < 0 || (c->kind != HAWSER_FRICTION && c->kind != HAWSER_JAM && c->kind != HAWSER_RELEASE)) return 0;
    HeldRoller *const held = held_of(all, r);
    if (c->kind == HAWSER_FRICTION) {
        held->friction = command_ramp(&held->friction, t, c->value, c->ramp);
        return 1;
    }
    const int taken = seizure_command(&held->told, held->by ? held->by : &held->told, c, t, err);
    const Seizure now = {.ramp = c->ramp, .mu = NAN};
    if (taken > 0 && c->kind == HAWSER_JAM) held_set(held, scene, &now);
    return taken;
}

/* What holds it by the case stays where it was built. */
static void rollers_controls(Room *room, ControlsVisit *visit)
{
    Rollers *const all = room->self;
    const Profile level = profile_level(1);
    controls_count(visit, &all->n_held, all->n);
    for (int h = 0; h < all->n_held; ++h) {
        HeldRoller *const held = &all->held[h];
        const Seizure *const by = held->by;
        controls_bytes(visit, held, sizeof *held);
        controls_profile_mend(visit, &held->told.share, &level);
        controls_profile_mend(visit, &held->friction, &level);
        if (visit->load && (held->roller < 0 || held->roller >= all->n)) visit->wrong = 1;
        if (visit->wrong) held->roller = 0;
        held->by = by;
    }
}

/* ----------------------------------------------------------------------------------------------------- to look at */

static void rollers_work(const Room *room, const Moment *m, BalanceRates *out)
{
    (void)room;
    for (int p = 0; p < PARTS; ++p) balance_contact(out, LOST_ROLLERS, PUSH_ROLLERS, &m->ws->contact[p].pairs.tally);
    out->loss[LOST_BEARINGS] += m->ws->equipment->lost_bearings;
    out->loss[LOST_MOUNTS] += m->ws->equipment->lost_mounts;
}

static void rollers_stock(const Room *room, const Moment *m, const double *own, BalanceStock *out)
{
    for (int p = 0; p < PARTS; ++p) out->energy[IN_ROLLERS] += m->ws->contact[p].pairs.tally.energy;
    if (room->states > 0) out->energy[IN_EQUIPMENT] = equipment_energy(m->ws->equipment, own);
}

static int rollers_look(const Room *room, const Moment *m)
{
    (void)room;
    int active = 0;
    for (int p = 0; p < PARTS; ++p) {
        ContactPart *const part = &m->ws->contact[p];
        if (part->model.n_rollers == 0) continue;
        part_forces(m, p, 1.0, m->ws->on_roller + part->first);
        active += part->pairs.active;
    }
    return active;
}

/* Whether they cross the plane square, its own geometry asks (sim/planar/plane.c). */
static const char *rollers_not_planar(const Room *room, const Scene *scene)
{
    if (contact_sticks(&scene->contact)) return "friction sticks";
    return room->states > 0 ? "rollers spin or stand on mounts" : NULL;
}

const RoomKind ROLLERS_ROOM = {.name = "rollers",
                               .build = rollers_build,
                               .seize = rollers_seize,
                               .clear = rollers_clear,
                               .start = rollers_start,
                               .work_alloc = rollers_work_alloc,
                               .work_free = rollers_work_free,
                               .carry = rollers_carry,
                               .pose = rollers_pose,
                               .begin = rollers_begin,
                               .loads = rollers_loads,
                               .rates = rollers_rates,
                               .blocks = rollers_blocks,
                               .touches = 1,
                               .stale = rollers_stale,
                               .refresh = rollers_refresh,
                               .candidates = rollers_candidates,
                               .remembers = rollers_remember,
                               .accept = rollers_accept,
                               .checkpoint = rollers_checkpoint,
                               .next_stop = rollers_next_stop,
                               .command = rollers_command,
                               .controls = rollers_controls,
                               .work = rollers_work,
                               .stock = rollers_stock,
                               .look = rollers_look,
                               .not_planar = rollers_not_planar};
