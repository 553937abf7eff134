#include "sim/equipment/forces.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "core/error.h"
#include "core/state.h"
#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"
#include "sim/scene.h"

static hawser_status forces_build(Room *room, Scene *scene, hawser_error *err)
{
    (void)scene;
    room->self = calloc(1, sizeof(Outside)); /* not present until a command or a law arrives */
    return room->self ? HAWSER_OK : error_memory(err);
}

Outside *outside_of(Scene *scene) { return room_of(scene, &FORCES_ROOM)->self; }

/* ------------------------------------------------------------------------------------------------- one segment */

/* Force, and moment about the segment's centre, world. */
typedef struct Wrench {
    Vec3 force, moment;
} Wrench;

static Quat attitude_of(const Kinematics *kin, int i)
{
    return (Quat){kin->q[0][i], kin->q[1][i], kin->q[2][i], kin->q[3][i]};
}

/* (K7): what turns with the segment is rotated; also returns the arm of the force. */
static Wrench force_now(const OutsideForce *f, const Kinematics *kin, int i, double t, Vec3 *arm)
{
    const Quat q = attitude_of(kin, i);
    const double share = profile_value(&f->share, t);
    const Vec3 force = v3_scale(share, f->force), moment = v3_scale(share, f->moment);
    *arm = quat_rotate(q, f->arm);
    return (Wrench){f->follows ? quat_rotate(q, force) : force, f->follows ? quat_rotate(q, moment) : moment};
}

static void force_add(const OutsideForce *f, const Kinematics *kin, int i, double t, Loads *loads)
{
    Vec3 arm;
    const Wrench w = force_now(f, kin, i, t, &arm);
    loads_add(loads, i, w.force, v3_add(w.moment, v3_cross(arm, w.force)));
}

/* (K8): the arm of a dead force turns; of a follower, force, moment and arm turn. */
static void force_blocks(const OutsideForce *f, const Kinematics *kin, int i, double t, double *k)
{
    Vec3 arm;
    const Wrench w = force_now(f, kin, i, t, &arm);
    for (int c = 0; c < 3; ++c) {
        const Vec3 e = v3_axis(c), turned = v3_cross(v3_cross(e, arm), w.force);
        if (!f->follows) {
            block6_add(k, 3 + c, V3_ZERO, turned);
            continue;
        }
        const Vec3 force = v3_cross(e, w.force);
        block6_add(k, 3 + c, force, v3_add(v3_cross(e, w.moment), v3_add(turned, v3_cross(arm, force))));
    }
}

/* ------------------------------------------------------------------------------------------------------ the law */

static hawser_segment_now segment_now(const Moment *m, int i)
{
    const Scene *const scene = m->scene;
    const Kinematics *const kin = &m->ws->kin;
    hawser_segment_now at = {
        .segment = scene->first + i, .t = m->t, .length_m = 2 * scene->chain.half[i], .mass_kg = scene->chain.mass[i]};
    for (int c = 0; c < 3; ++c) {
        at.position_m[c] = kin->p[c][i];
        at.velocity_m_per_s[c] = kin->v[c][i];
        at.omega_rad_per_s[c] = kin->w[c][i];
    }
    for (int c = 0; c < 4; ++c) at.quaternion[c] = kin->q[c][i];
    return at;
}

static int all_finite(const double *values, int n)
{
    int finite = 1;
    for (int k = 0; k < n && values; ++k) finite &= isfinite(values[k]) != 0;
    return finite;
}

/* Calls the law once; by_place, by_motion NULL: without derivatives. */
static void law_call(Outside *all, const hawser_segment_now *at, double wrench[6], double *by_place, double *by_motion)
{
    for (int c = 0; c < 6; ++c) wrench[c] = 0;
    ++all->calls;
    if (all->law.call(all->law.user, at, wrench, by_place, by_motion)) all->stopped = 1;
    --all->calls;
    if (all->bad || (all_finite(wrench, 6) && all_finite(by_place, 36) && all_finite(by_motion, 36))) return;
    all->bad = 1;
    all->segment = at->segment;
    all->t = at->t;
}

static void law_loads(const Moment *m, Outside *all, int i, Loads *loads)
{
    double w[6];
    const hawser_segment_now at = segment_now(m, i);
    law_call(all, &at, w, NULL, NULL);
    loads_add(loads, i, v3(w[0], w[1], w[2]), v3(w[3], w[4], w[5]));
}

/* The state, moved by h in direction c (place, turning, velocity, omega, three each). */
static hawser_segment_now moved(const hawser_segment_now *from, int c, double h)
{
    hawser_segment_now at = *from;
    if (c < 3) at.position_m[c] += h;
    if (c >= 6 && c < 9) at.velocity_m_per_s[c - 6] += h;
    if (c >= 9) at.omega_rad_per_s[c - 9] += h;
    if (c < 3 || c >= 6) return at;
    const Quat q = {at.quaternion[0], at.quaternion[1], at.quaternion[2], at.quaternion[3]};
    const Quat turned = quat_mul(quat_exp(v3_scale(h, v3_axis(c - 3))), q);
    const double value[4] = {turned.w, turned.x, turned.y, turned.z};
    for (int k = 0; k < 4; ++k) at.quaternion[k] = value[k];
    return at;
}

/* (K10): central differences; the step makes the truncation error about equal to rounding. */
static void law_differences(Outside *all, const hawser_segment_now *at, double by_place[36], double by_motion[36])
{
    static const double step[4] = {1e-6, 1e-6, 1e-6, 1e-6}; /* m, rad, m/s, rad/s */
    for (int c = 0; c < 12; ++c) {
        const double h = step[c / 3];
        double ahead[6], behind[6];
        const hawser_segment_now plus = moved(at, c, h), minus = moved(at, c, -h);
        law_call(all, &plus, ahead, NULL, NULL);
        law_call(all, &minus, behind, NULL, NULL);
        double *const by = c < 6 ? by_place : by_motion;
        for (int r = 0; r < 6; ++r) by[6 * r + c % 6] = (ahead[r] - behind[r]) / (2 * h);
    }
}

/* Adds row-major rows to a block, which is column-major. */
static void block_add(const double rows[36], double *block)
{
    for (int r = 0; r < 6; ++r) {
        for (int c = 0; c < 6; ++c) block[6 * c + r] += rows[6 * r + c];
    }
}

static void law_blocks(const Moment *m, Outside *all, int i, double *k, double *d)
{
    double wrench[6] = {0}, by_place[36] = {0}, by_motion[36] = {0};
    const hawser_segment_now at = segment_now(m, i);
    if (!all->law.has_derivatives) {
        law_differences(all, &at, by_place, by_motion);
    } else {
        law_call(all, &at, wrench, by_place, by_motion);
    }
    block_add(by_place, k);
    block_add(by_motion, d);
}

/* The law's segments that are simulated: from .. *to-1 of the chain. */
static int law_from(const Outside *all, const Scene *scene, int *to)
{
    const int from = all->law.from - scene->first, end = all->law.to - scene->first, n = scene->chain.n;
    *to = all->law.call ? (end < n ? end : n) : 0;
    return from > 0 ? from : 0;
}

/* ------------------------------------------------------------------------------------------------------ a step */

/* Index in the chain of the segment on which a force acts; -1: it is not simulated now. */
static int place_of(const OutsideForce *f, const Scene *scene)
{
    const int i = f->segment - scene->first;
    return i < scene->chain.n ? i : -1;
}

static void forces_loads(const Room *room, const Moment *m, int part)
{
    Outside *const all = room->self;
    if (part != 0) return;
    for (int k = 0; k < all->n; ++k) {
        const int i = place_of(&all->force[k], m->scene);
        if (i >= 0) force_add(&all->force[k], &m->ws->kin, i, m->t, &m->ws->loads[0]);
    }
    int to;
    for (int i = law_from(all, m->scene, &to); i < to; ++i) law_loads(m, all, i, &m->ws->loads[0]);
}

static void forces_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    Outside *const all = room->self;
    for (int f = 0; f < all->n; ++f) {
        const int i = place_of(&all->force[f], m->scene);
        if (i >= 0) force_blocks(&all->force[f], &m->ws->kin, i, m->t, k->diag + 36 * (size_t)i);
    }
    int to;
    for (int i = law_from(all, m->scene, &to); i < to; ++i)
        law_blocks(m, all, i, k->diag + 36 * (size_t)i, d->diag + 36 * (size_t)i);
}

static double forces_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Outside *const all = room->self;
    double next = INFINITY;
    for (int k = 0; k < all->n; ++k) next = profile_corner_before(&all->force[k].share, t, next);
    return next;
}

/* Power and force of one segment's wrench (BA2). */
static Push push_of(const Kinematics *kin, int i, Vec3 force, Vec3 moment)
{
    return (Push){v3_dot(force, v3_load(kin->v, i)) + v3_dot(moment, v3_load(kin->w, i)), force};
}

static void forces_work(const Room *room, const Moment *m, BalanceRates *out)
{
    Outside *const all = room->self;
    const Kinematics *const kin = &m->ws->kin;
    for (int k = 0; k < all->n; ++k) {
        const int i = place_of(&all->force[k], m->scene);
        if (i < 0) continue;
        Vec3 arm;
        const Wrench w = force_now(&all->force[k], kin, i, m->t, &arm);
        balance_work(out, BY_OUTSIDE, push_of(kin, i, w.force, v3_add(w.moment, v3_cross(arm, w.force))));
    }
    int to;
    for (int i = law_from(all, m->scene, &to); i < to; ++i) {
        double w[6];
        const hawser_segment_now at = segment_now(m, i);
        law_call(all, &at, w, NULL, NULL);
        balance_work(out, BY_OUTSIDE, push_of(kin, i, v3(w[0], w[1], w[2]), v3(w[3], w[4], w[5])));
    }
}

/* ---------------------------------------------------------------------------------------------------- commands */

/* Removes the forces that have faded out from the list. */
static void gone_drop(Outside *all, double t)
{
    int left = 0;
    for (int k = 0; k < all->n; ++k) {
        const Profile *const share = &all->force[k].share;
        if (share->v1 > 0 || t < share->t1) all->force[left++] = all->force[k];
    }
    all->n = left;
}

/* (K9): the old forces of the segment fade out while the new one fades in. */
static int forces_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    Outside *const all = room->self;
    if (c->kind != COMMAND_FORCE) return 0;
    room->present = 1;
    gone_drop(all, t);
    if (c->segment < 0 || c->segment >= scene->total || all->n == OUTSIDE_MAX) {
        error_set(err, HAWSER_ERR_INPUT, "segment %d: %s", c->segment,
                  all->n == OUTSIDE_MAX ? "too many forces at a time" : "the chain has no such segment");
        return -1;
    }
    for (int k = 0; k < all->n; ++k) {
        OutsideForce *const f = &all->force[k];
        if (f->segment == c->segment) f->share = command_ramp(&f->share, t, 0, c->ramp);
    }
    const Profile none = profile_level(0);
    if (v3_norm(c->force) + v3_norm(c->moment) > 0)
        all->force[all->n++] = (OutsideForce){.segment = c->segment,
                                              .follows = c->follows,
                                              .force = c->force,
                                              .moment = c->moment,
                                              .arm = c->arm,
                                              .share = command_ramp(&none, t, 1, c->ramp)};
    return 1;
}

hawser_status outside_law_set(Scene *scene, const OutsideLaw *law, hawser_error *err)
{
    if (law->call && (law->from < 0 || law->to > scene->total || law->from >= law->to))
        return error_set(err, HAWSER_ERR_INPUT, "segments %d to %d: the chain has 0 to %d", law->from, law->to,
                         scene->total);
    Room *const room = room_of(scene, &FORCES_ROOM);
    ((Outside *)room->self)->law = *law;
    room->present = 1;
    return HAWSER_OK;
}

void outside_attend(Scene *scene, int law)
{
    Room *const room = room_of(scene, &FORCES_ROOM);
    const Outside *const all = room->self;
    room->present = all->n > 0 || (law && all->law.call);
}

/* The law belongs to the caller, who sets it again after loading. */
static void forces_controls(Room *room, ControlsVisit *visit)
{
    Outside *const all = room->self;
    const Profile none = profile_level(0);
    controls_count(visit, &all->n, OUTSIDE_MAX);
    controls_bytes(visit, all->force, (size_t)all->n * sizeof *all->force);
    for (int i = 0; i < all->n; ++i) controls_profile_mend(visit, &all->force[i].share, &none);
    if (visit->load) room->present = all->n > 0 || all->law.call;
}

const RoomKind FORCES_ROOM = {.name = "forces from outside",
                              .build = forces_build,
                              .loads = forces_loads,
                              .blocks = forces_blocks,
                              .next_stop = forces_next_stop,
                              .work = forces_work,
                              .command = forces_command,
                              .controls = forces_controls,
                              .in_space = "forces act on segments from outside"};

/* Jams: a roller or a conveyor stops during the run, at a time or when the cable's front reaches a place, and may be
 * released again. docs/theory.md, "Jams" (JA1)-(JA6).
 *
 * A jam acts through the equipment that jams: it is given a Seizure when the scene is built and reads its share at
 * every evaluation. Between two events the share is a function of time alone; it changes after accepted steps only, in
 * jams_happen(). The effect of a jam on a roller or a belt is in their own files. */

typedef enum JamDoing { JAM_WAITS, JAM_HOLDS, JAM_IS_OVER } JamDoing;

typedef struct Jam {
    const JamDef *def; /* the scene's */
    JamDoing doing;
    Seizure seizure;
    char says[2][NAME_MAX_LENGTH + 32]; /* texts of its beginning and its end */
} Jam;

typedef struct Jams {
    int n;
    Jam *item; /* [n], in the case's order */
} Jams;

static hawser_status jams_build(Room *room, Scene *scene, hawser_error *err)
{
    Jams *const all = room->self = calloc(1, sizeof *all);
    if (!all) return error_memory(err);
    all->n = room->present = scene->def.n_jams;
    all->item = calloc((size_t)all->n + 1, sizeof *all->item);
    if (!all->item) return error_memory(err);
    for (int i = 0; i < all->n; ++i) {
        const JamDef *const def = &scene->def.jams[i];
        all->item[i] = (Jam){.def = def, .seizure = {.ramp = def->ramp, .mu = def->friction}};
    }
    return HAWSER_OK;
}

static void jams_clear(Room *room)
{
    Jams *const all = room->self;
    if (all) free(all->item);
}

/* Called when all equipment is built: gives each jam's seizure to the equipment of that name. */
static hawser_status jams_finish(Room *room, Scene *scene, hawser_error *err)
{
    const Jams *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        Jam *const jam = &all->item[i];
        const char *kind = NULL;
        for (int r = 0; !kind && r < scene->n_rooms; ++r) {
            Room *const other = &scene->room[r];
            if (other->present && other->kind->seize)
                kind = other->kind->seize(other, scene, jam->def->what, &jam->seizure);
        }
        if (!kind) {
            return error_set(err, HAWSER_ERR_INPUT, "key 'jams.%d.what': nothing that can jam is called '%s'", i,
                             jam->def->what);
        }
        snprintf(jam->says[0], sizeof jam->says[0], "%s %s jams", kind, jam->def->what);
        snprintf(jam->says[1], sizeof jam->says[1], "%s %s is free again", kind, jam->def->what);
    }
    return HAWSER_OK;
}

int seizure_command(Seizure *told, const Seizure *by, const Command *c, double t, hawser_error *err)
{
    const int holds = by == told && told->share.v1 > 0;
    if (by && by != told) {
        error_set(err, HAWSER_ERR_INPUT, "'%s' jams by the case's section 'jams', which commands leave alone", c->what);
        return -1;
    }
    if (holds == (c->kind == HAWSER_JAM)) {
        error_set(err, HAWSER_ERR_INPUT, "'%s' is %s", c->what, holds ? "jammed already" : "not jammed");
        return -1;
    }
    told->share = command_ramp(&told->share, t, c->kind == HAWSER_JAM, c->ramp);
    told->ramp = c->ramp;
    return 1;
}

/* -------------------------------------------------------------------------------------------------- between steps */

static const double ON_TIME = 1e-9; /* s: the integrator stops at an event's time up to rounding */

/* Checks a time (s) or a place of the cable's front (m) for being reached; NAN: not given (JA1). */
static int due(double at, double front, const Occasion *now) { return now->t >= at - ON_TIME || now->front >= front; }

/* Starts a ramp of the share from `from` to `to` by STEP (JA2). */
static void share_begin(Jam *jam, JamDoing doing, double t, double from, double to)
{
    jam->doing = doing;
    jam->seizure.share = (Profile){.kind = PROFILE_STEP, .t0 = t, .v0 = from, .t1 = t + jam->seizure.ramp, .v1 = to};
}

/* A jam is released only after it is complete. */
static Occurrence jam_happen(Jam *jam, const Occasion *now)
{
    const JamDef *const def = jam->def;
    if (jam->doing == JAM_WAITS && due(def->at, def->head_at, now)) {
        share_begin(jam, JAM_HOLDS, now->t, 0, 1);
        return (Occurrence){HAWSER_EVENT_JAM, jam->says[0]};
    }
    const int complete = jam->doing == JAM_HOLDS && now->t >= jam->seizure.share.t1 - ON_TIME;
    if (!complete || !due(def->release, def->release_head_at, now)) return (Occurrence){0};
    share_begin(jam, JAM_IS_OVER, now->t, 1, 0);
    return (Occurrence){HAWSER_EVENT_FREE, jam->says[1]};
}

static Occurrence jams_happen(Room *room, const Occasion *now)
{
    const Jams *const all = room->self;
    Occurrence found = {0};
    for (int i = 0; !found.what && i < all->n; ++i) found = jam_happen(&all->item[i], now);
    return found;
}

static void jams_controls(Room *room, ControlsVisit *visit)
{
    const Jams *const all = room->self;
    for (int i = 0; i < all->n; ++i) {
        int doing = (int)all->item[i].doing;
        controls_count(visit, &doing, JAM_IS_OVER);
        all->item[i].doing = (JamDoing)doing;
        controls_seizure(visit, &all->item[i].seizure);
    }
}

/* The pull is reported with every event; the front is needed while a jam waits for it. */
static int jams_watch(const Room *room)
{
    const Jams *const all = room->self;
    int watched = 0;
    for (int i = 0; i < all->n; ++i) {
        const Jam *const jam = &all->item[i];
        const double front = jam->doing == JAM_WAITS ? jam->def->head_at : jam->def->release_head_at;
        if (jam->doing == JAM_IS_OVER) continue;
        watched |= WATCH_PULL | (isnan(front) ? 0 : WATCH_FRONT);
    }
    return watched;
}

/* Events at a given time are met exactly; so are the ends of the ramps. */
static double jams_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Jams *const all = room->self;
    double next = INFINITY;
    for (int i = 0; i < all->n; ++i) {
        const Jam *const jam = &all->item[i];
        if (jam->def->at > t) next = fmin(next, jam->def->at);
        if (jam->def->release > t) next = fmin(next, jam->def->release);
        next = profile_corner_before(&jam->seizure.share, t, next);
    }
    return next;
}

const RoomKind JAM_ROOM = {.name = "jams",
                           .build = jams_build,
                           .finish = jams_finish,
                           .clear = jams_clear,
                           .watches = jams_watch,
                           .happen = jams_happen,
                           .next_stop = jams_next_stop,
                           .controls = jams_controls,
                           .in_space = "something jams during the run, which theory does not cover"};
