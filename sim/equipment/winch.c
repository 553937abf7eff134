/* Phases of the winch: trips and commands. docs/theory.md, "Winch and conveyors" (WI8)-(WI12), "Control" (K2), (K3). */
#include "sim/equipment/winch.h"

#include <math.h>
#include <stdlib.h>

#include "core/body.h"
#include "core/bushing.h"
#include "core/error.h"
#include "core/lanes.h"
#include "sim/equipment/rooms.h"
#include "sim/joints.h"

/* ------------------------------------------------------------------------------------------------------- trips */

/* The trip is a state machine between accepted steps:
 *
 *    follows --force too large--> brakes --at rest--> stands --pause over--> restarts --at speed--> follows
 *
 * A restart can trip too. Every change keeps travel and speed continuous (WI8)-(WI12). */

static const double ON_TIME = 1e-9; /* s: the integrator stops at a phase's end up to rounding */

/* Begins another speed profile at time t; the travel is continuous. */
static void phase_begin(Winch *w, WinchDoing doing, double t, Profile speed, double clock)
{
    WinchPhase *const now = &w->phase;
    const double travel = winch_travel(w, t);
    now->doing = doing;
    now->speed = speed;
    now->since = t - clock;
    now->offset = travel - profile_integral(&speed, clock);
    now->over = INFINITY;
    now->until = INFINITY;
}

/* (WI9). Applies the brake: from the present speed to rest. A restart that trips keeps the speed to return to. */
static WinchEvent brake(Winch *w, double t)
{
    WinchPhase *const now = &w->phase;
    const Profile down = {.kind = PROFILE_STEP, .v0 = winch_speed(w, t), .t1 = w->trip.brake};
    if (now->doing == WINCH_FOLLOWS) now->resume = t - now->since;
    phase_begin(w, WINCH_BRAKES, t, down, 0);
    now->until = t + w->trip.brake;
    ++now->trips;
    return WINCH_TRIPPED;
}

/* At rest: for a pause, for good (WI10), or until a command. The brake's profile stays: it is 0 from here on. */
static WinchEvent stand(Winch *w)
{
    WinchPhase *const now = &w->phase;
    const double since = now->until;
    now->doing = WINCH_STANDS;
    if (now->told) {
        now->until = INFINITY;
        return WINCH_STOPPED;
    }
    now->until = now->trips <= w->trip.restarts ? since + w->trip.pause : INFINITY;
    if (isfinite(now->until)) return WINCH_STOPPED;
    if (!w->trip.ends_run) return WINCH_STAYS;
    now->ended = since;
    return WINCH_ENDS_THE_RUN;
}

/* (WI11). Restarts from the speed `start`, which is 0 after a trip, to the speed at which the brake was applied. */
static WinchEvent restart(Winch *w, double start, double ramp)
{
    WinchPhase *const now = &w->phase;
    const double before = isnan(now->asked) ? profile_value(&w->speed, now->resume) : now->asked;
    const Profile up = {.kind = PROFILE_STEP, .v0 = winch_speed(w, start), .v1 = before, .t1 = ramp};
    phase_begin(w, WINCH_RESTARTS, start, up, 0);
    now->until = start + ramp;
    return WINCH_STARTED;
}

/* (WI12). Resumes the case's profile where it was left, or the speed that was commanded. */
static WinchEvent follow(Winch *w)
{
    const double asked = w->phase.asked;
    if (isnan(asked)) {
        phase_begin(w, WINCH_FOLLOWS, w->phase.until, w->speed, w->phase.resume);
    } else {
        phase_begin(w, WINCH_OBEYS, w->phase.until, profile_level(asked), 0);
    }
    return WINCH_RUNNING;
}

/* Checks whether the force has been above the limit for the trip's delay (WI8). */
static int too_large(Winch *w, double t, double pull)
{
    WinchPhase *const now = &w->phase;
    if (!(pull > w->trip_force)) {
        now->over = INFINITY;
        return 0;
    }
    now->over = fmin(now->over, t);
    return t - now->over >= w->trip.hold - ON_TIME;
}

WinchEvent winch_accept(Winch *w, double t, double pull)
{
    const int moving = w->phase.doing != WINCH_BRAKES && w->phase.doing != WINCH_STANDS;
    if (w->trip_force > 0 && moving && too_large(w, t, pull)) return brake(w, t);
    if (t < w->phase.until - ON_TIME) return WINCH_NOTHING;
    switch (w->phase.doing) {
    case WINCH_BRAKES:
        return stand(w);
    case WINCH_STANDS:
        return restart(w, w->phase.until, w->trip.ramp);
    case WINCH_RESTARTS:
        return follow(w);
    case WINCH_FOLLOWS:
    case WINCH_OBEYS:
        break;
    }
    return WINCH_NOTHING;
}

/* The event as it is recorded; what: NULL for WINCH_NOTHING. */
static Occurrence winch_occurrence(WinchEvent event)
{
    static const Occurrence occurrence[] = {
        [WINCH_NOTHING] = {HAWSER_EVENT_NOTE, NULL},
        [WINCH_TRIPPED] = {HAWSER_EVENT_WINCH_TRIPS, "the winch trips"},
        [WINCH_STOPPED] = {HAWSER_EVENT_WINCH_STOPPED, "the winch has stopped"},
        [WINCH_STARTED] = {HAWSER_EVENT_WINCH_STARTS, "the winch starts again"},
        [WINCH_RUNNING] = {HAWSER_EVENT_WINCH_RUNS, "the winch is back at speed"},
        [WINCH_STAYS] = {HAWSER_EVENT_WINCH_STAYS, "the winch has stopped for good"},
        [WINCH_ENDS_THE_RUN] = {HAWSER_EVENT_WINCH_ENDS_RUN, "the winch has stopped for good: the run ends"}};
    return occurrence[event];
}

/* Trips, and the ends of commands. */
static int winch_watches(const Room *room)
{
    const Winch *const w = room->self;
    const int ends = isfinite(w->phase.until);
    return (w->trip_force > 0 || ends ? WATCH_PULL : 0) | (w->mode == WINCH_TENSION && ends ? WATCH_TRAVEL : 0);
}

/* End of applying or releasing the brake of a set tension (K3). */
static WinchEvent brake_done(Winch *w, const Occasion *now)
{
    WinchPhase *const phase = &w->phase;
    if (now->t < phase->until - ON_TIME) return WINCH_NOTHING;
    phase->until = INFINITY;
    if (phase->doing == WINCH_BRAKES) {
        phase->doing = WINCH_STANDS;
        if (!(phase->hold.v1 > 0)) return WINCH_STOPPED; /* a pause */
        phase->held = HELD_TOLD;
        phase->held_at = now->travel;
        return WINCH_STOPPED;
    }
    phase->doing = WINCH_FOLLOWS;
    phase->held = 0;
    return WINCH_RUNNING;
}

static Occurrence winch_happen(Room *room, const Occasion *now)
{
    Winch *const w = room->self;
    if (w->mode == WINCH_TENSION) return winch_occurrence(brake_done(w, now));
    return winch_occurrence(winch_accept(w, now->t, now->pull));
}

/* ----------------------------------------------------------------------------------------------------- commands */

/* (K2). Commands the speed, also of a winch that stands. */
static void obey(Winch *w, double t, double speed, double ramp)
{
    const Profile to = {.kind = PROFILE_STEP, .v0 = winch_speed(w, t), .t1 = ramp, .v1 = speed};
    phase_begin(w, WINCH_OBEYS, t, to, 0);
    w->phase.asked = speed;
    w->phase.told = 0;
}

/* (K2). Ramps down to rest; the present motion can be resumed. */
static void stop(Winch *w, double t, double ramp)
{
    WinchPhase *const now = &w->phase;
    const Profile down = {.kind = PROFILE_STEP, .v0 = winch_speed(w, t), .t1 = ramp};
    now->told = 1;
    if (now->doing == WINCH_STANDS) now->until = INFINITY;
    if (now->doing == WINCH_STANDS || now->doing == WINCH_BRAKES) return;
    if (now->doing == WINCH_FOLLOWS) now->resume = t - now->since;
    phase_begin(w, WINCH_BRAKES, t, down, 0);
    now->until = t + ramp;
}

static int speed_command(Winch *w, const Command *c, double t, hawser_error *err)
{
    const int stands = w->phase.doing == WINCH_STANDS || w->phase.doing == WINCH_BRAKES;
    if (c->kind == HAWSER_WINCH_TENSION) {
        error_set(err, HAWSER_ERR_INPUT, "the winch of this case has a set speed: no tension can be set");
        return -1;
    }
    if (isfinite(w->phase.ended) || (c->kind == HAWSER_WINCH_RESTART && !stands)) {
        error_set(err, HAWSER_ERR_INPUT,
                  isfinite(w->phase.ended) ? "the winch has stopped for good" : "the winch does not stand");
        return -1;
    }
    if (c->kind == HAWSER_WINCH_SPEED) obey(w, t, c->value, c->ramp);
    if (c->kind == HAWSER_WINCH_BRAKE || c->kind == HAWSER_WINCH_PAUSE) stop(w, t, c->ramp);
    if (c->kind == HAWSER_WINCH_RESTART) {
        w->phase.told = 0;
        restart(w, t, c->ramp);
    }
    return 1;
}

/* (K3) */
static int tension_command(Winch *w, const Command *c, double t, hawser_error *err)
{
    WinchPhase *const now = &w->phase;
    if (c->kind == HAWSER_WINCH_SPEED || (c->kind == HAWSER_WINCH_RESTART && !now->told)) {
        error_set(err, HAWSER_ERR_INPUT,
                  c->kind == HAWSER_WINCH_SPEED ? "the winch of this case has a set tension: no speed can be set"
                                                : "the winch does not stand");
        return -1;
    }
    if (c->kind == HAWSER_WINCH_TENSION) {
        if (!isnan(now->before)) {
            now->before = c->value; /* for a later restart */
        } else {
            now->tension = command_ramp(&now->tension, t, c->value, c->ramp);
        }
        return 1;
    }
    if (c->kind == HAWSER_WINCH_PAUSE && isnan(now->before)) {
        now->before = fmax(0, profile_value(&now->tension, t));
        now->tension = command_ramp(&now->tension, t, 0, c->ramp);
    }
    if (c->kind == HAWSER_WINCH_BRAKE) now->hold = command_ramp(&now->hold, t, 1, c->ramp);
    if (c->kind == HAWSER_WINCH_RESTART) {
        if (!isnan(now->before)) now->tension = command_ramp(&now->tension, t, now->before, c->ramp);
        if (now->hold.v1 > 0) now->hold = command_ramp(&now->hold, t, 0, c->ramp);
        now->before = NAN;
    }
    now->told = c->kind != HAWSER_WINCH_RESTART;
    now->doing = now->told ? WINCH_BRAKES : WINCH_RESTARTS;
    now->until = t + c->ramp;
    return 1;
}

static int winch_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    (void)scene;
    Winch *const w = room->self;
    if (c->kind < HAWSER_WINCH_SPEED || c->kind > HAWSER_WINCH_RESTART) return 0;
    return w->mode == WINCH_SPEED ? speed_command(w, c, t, err) : tension_command(w, c, t, err);
}

static void winch_controls(Room *room, ControlsVisit *visit)
{
    const Profile level = profile_level(0);
    Winch *const w = room->self;
    controls_bytes(visit, &w->phase, sizeof w->phase);
    if (visit->load && !(w->phase.trips >= 0 && w->phase.trips <= CHECKPOINT_COUNT_MAX)) visit->wrong = 1;
    controls_profile_mend(visit, &w->phase.speed, &w->speed);
    controls_profile_mend(visit, &w->phase.tension, &w->tension);
    controls_profile_mend(visit, &w->phase.hold, &level);
    if (visit->load && ((int)w->phase.doing < 0 || w->phase.doing > WINCH_OBEYS)) visit->wrong = 1;
    if (visit->wrong) w->phase.doing = WINCH_FOLLOWS;
}

/* ------------------------------------------------------------------------------------ a winch with a speed (WI1) */

double winch_speed(const Winch *w, double t) { return profile_value(&w->phase.speed, t - w->phase.since); }

double winch_travel(const Winch *w, double t)
{
    return w->phase.offset + profile_integral(&w->phase.speed, t - w->phase.since);
}

double winch_largest_speed(const Winch *w, double until)
{
    const WinchDef now = {
        .mode = w->mode, .speed = w->speed, .speed_limit = isfinite(w->speed_limit) ? w->speed_limit : 0};
    return winch_def_largest_speed(&now, until);
}

static const double FADE = 0.2; /* s, in which the motion of a segment that was taken in dies out */

void winch_take_in(Winch *w, double t, Vec3 drift, Vec3 spin)
{
    w->take_in.since = t;
    w->take_in.drift = drift;
    w->take_in.spin = spin;
}

int winch_free_axes(const Winch *w, const WinchDef *def, Vec3 axis[2])
{
    if (w->mode != WINCH_SPEED || !def->axial_only || w->take_in.present) return 0;
    const Vec3 u = w->direction, a = v3(fabs(u.x), fabs(u.y), fabs(u.z));
    const Vec3 least = v3_axis(a.x <= a.y && a.x <= a.z ? 0 : a.y <= a.z ? 1 : 2);
    axis[0] = v3_unit(v3_cross(u, least));
    axis[1] = v3_cross(u, axis[0]);
    return 2;
}

/* The ghost at the chain's head (segment n). That of a set tension does not move: it only holds the head's attitude.
 * The own motion of a segment that was taken in fades out (RL16). */
static void winch_ghost(const Room *room, const Scene *scene, double t, Kinematics *kin)
{
    const Winch *const w = room->self;
    const int n = scene->chain.n, moves = w->mode == WINCH_SPEED;
    const double speed = moves ? winch_speed(w, t) : 0;
    Vec3 p = moves ? v3_axpy(w->origin, winch_travel(w, t), w->direction) : w->origin;
    Vec3 v = v3_scale(speed, w->direction), spin = V3_ZERO, axis = w->direction;
    Quat q = w->attitude;
    if (w->take_in.present) {
        const Profile left = {.kind = PROFILE_STEP, .v0 = 1, .t1 = FADE};
        const double x = fmax(t - w->take_in.since, 0);
        const double rate = profile_value(&left, x), gone = profile_integral(&left, x);
        q = quat_mul(quat_exp(v3_scale(gone, w->take_in.spin)), q);
        p = v3_axpy(p, gone, w->take_in.drift);
        v = v3_axpy(v, rate, w->take_in.drift);
        spin = v3_scale(rate, w->take_in.spin);
        axis = quat_rotate(q, v3(1, 0, 0));
    }
    const double attitude[4] = {q.w, q.x, q.y, q.z};
    v3_store(kin->p, n, p);
    v3_store(kin->v, n, v);
    v3_store(kin->w, n, spin);
    v3_store(kin->a, n, axis);
    for (int c = 0; c < 4; ++c) kin->q[c][n] = attitude[c];
    Vec3 free_axis[2];
    const int free_axes = winch_free_axes(w, &scene->def.winch, free_axis);
    if (free_axes > 0) slide_ghost(&scene->chain, kin, n, n - 1, free_axes, free_axis); /* (WI1a) */
}

/* Corners of its speed or force, and the ends of its phases. */
static double winch_next_stop(const Room *room, const Scene *scene, double t)
{
    (void)scene;
    const Winch *const w = room->self;
    const WinchPhase *const now = &w->phase;
    double next = now->until > t ? now->until : INFINITY;
    if (w->mode == WINCH_TENSION)
        return profile_corner_before(&now->tension, t, profile_corner_before(&now->hold, t, next));
    if (now->over + w->trip.hold > t) next = fmin(next, now->over + w->trip.hold);
    return fmin(next, now->since + profile_corner_before(&now->speed, t - now->since, INFINITY));
}

/* --------------------------------------------------------------------------------- a winch with a tension (WI2) */

double winch_tension(const Winch *w, double t, double speed, double *slope)
{
    double share = 1, fall = 0;
    if (isfinite(w->speed_limit)) {
        share = step_cubic(speed, (1 - w->band) * w->speed_limit, 1, w->speed_limit, 0, &fall);
    }
    const double full = fmax(0, profile_value(&w->phase.tension, t));
    if (slope) *slope = full * fall;
    return full * share;
}

/* The head's end: its arm from the last segment's centre, its place and velocity. */
typedef struct HeadEnd {
    Vec3 arm, spin, off, velocity; /* m; rad/s; m, from the winch's origin; m/s */
} HeadEnd;

static HeadEnd head_end(const Winch *w, const Chain *chain, const Kinematics *kin)
{
    const int i = chain->n - 1;
    HeadEnd e = {.arm = v3_scale(chain->half[i], v3(kin->a[0][i], kin->a[1][i], kin->a[2][i])),
                 .spin = v3(kin->w[0][i], kin->w[1][i], kin->w[2][i])};
    const Vec3 p = v3(kin->p[0][i], kin->p[1][i], kin->p[2][i]), v = v3(kin->v[0][i], kin->v[1][i], kin->v[2][i]);
    e.off = v3_sub(v3_add(p, e.arm), w->origin);
    e.velocity = v3_add(v, v3_cross(e.spin, e.arm));
    return e;
}

WinchMotion winch_motion(const Winch *w, const Chain *chain, const Kinematics *kin, double t)
{
    if (w->mode == WINCH_SPEED) return (WinchMotion){winch_travel(w, t), winch_speed(w, t)};
    const HeadEnd e = head_end(w, chain, kin);
    return (WinchMotion){v3_dot(e.off, w->direction), v3_dot(e.velocity, w->direction)};
}

/* Change of the force on the head's end with its place and its velocity: along the pull and across it, N/m, N s/m. */
typedef struct HeadLaw {
    double along, k_along, c_along, k_across, c_across; /* N; N/m, N s/m */
} HeadLaw;

/* Rest of the tension while the brake is being applied, and the brake (K3). */
static void brake_share(const Winch *w, double share, double x, double v, HeadLaw *law)
{
    const int holds = w->phase.held == HELD_TOLD;
    const double k = holds ? share * w->brake[0] : 0, c = share * (holds ? w->brake[1] : w->slowing);
    law->along = (1 - share) * law->along - k * (x - w->phase.held_at) - c * v;
    law->c_along = (1 - share) * law->c_along + c;
    law->k_along = k;
}

/* (WI2), or (WI5) while the brake is on; across the line (WI3). */
static HeadLaw head_law(const Winch *w, const HeadEnd *e, double t)
{
    const double x = v3_dot(e->off, w->direction), v = v3_dot(e->velocity, w->direction);
    HeadLaw law = {.k_across = w->guide[0], .c_across = w->guide[1]};
    if (w->phase.held == HELD_FIRST) {
        law.k_along = w->brake[0];
        law.c_along = w->brake[1];
        law.along = -law.k_along * x - law.c_along * v;
    } else {
        double slope;
        const double share = profile_value(&w->phase.hold, t);
        law.along = winch_tension(w, t, v, &slope);
        law.c_along = -slope;
        if (share > 0) brake_share(w, share, x, v, &law);
    }
    return law;
}

double winch_pull(const Winch *w, const Chain *chain, const Kinematics *kin, double t)
{
    const HeadEnd e = head_end(w, chain, kin);
    return head_law(w, &e, t).along;
}

/* Stiffness times a change of the end's place, or damping times one of its velocity. */
static Vec3 head_change(const Winch *w, double along, double across, Vec3 d)
{
    const double x = v3_dot(d, w->direction);
    return v3_axpy(v3_scale(-along * x, w->direction), -across, v3_axpy(d, -x, w->direction));
}

/* Total force on the head's end (WI4). */
static Vec3 head_force(const Winch *w, const HeadLaw *law, const HeadEnd *e)
{
    const Vec3 across = v3_add(head_change(w, 0, law->k_across, e->off), head_change(w, 0, law->c_across, e->velocity));
    return v3_axpy(across, law->along, w->direction);
}

static void winch_loads(const Room *room, const Moment *m, int part)
{
    const Winch *const w = room->self;
    if (w->mode != WINCH_TENSION || part != 0) return;
    const HeadEnd e = head_end(w, &m->scene->chain, &m->ws->kin);
    const HeadLaw law = head_law(w, &e, m->t);
    const Vec3 f = head_force(w, &law, &e);
    loads_add(&m->ws->loads[0], m->scene->chain.n - 1, f, v3_cross(e.arm, f));
}

/* (WI6), (WI7) */
static void winch_blocks(const Room *room, const Moment *m, BlockChain *k, BlockChain *d)
{
    const Winch *const w = room->self;
    const int n = m->scene->chain.n;
    Vec3 axis[2];
    slide_blocks(&m->scene->chain, &m->ws->kin, n, n - 1, winch_free_axes(w, &m->scene->def.winch, axis), axis, k, d);
    if (w->mode != WINCH_TENSION) return;
    const size_t last = 36 * (size_t)(n - 1);
    const HeadEnd e = head_end(w, &m->scene->chain, &m->ws->kin);
    const HeadLaw law = head_law(w, &e, m->t);
    const Vec3 f = head_force(w, &law, &e);
    for (int c = 0; c < 3; ++c) {
        const Vec3 unit = v3_axis(c);
        const Vec3 turned = v3_cross(unit, e.arm); /* change of the arm by dphi, of the end's velocity by dw */
        const Vec3 by_x = head_change(w, law.k_along, law.k_across, unit);
        const Vec3 by_v = head_change(w, law.c_along, law.c_across, unit);
        const Vec3 by_w = head_change(w, law.c_along, law.c_across, turned);
        const Vec3 by_phi = v3_add(head_change(w, law.k_along, law.k_across, turned),
                                   head_change(w, law.c_along, law.c_across, v3_cross(e.spin, turned)));
        block6_add(k->diag + last, c, by_x, v3_cross(e.arm, by_x));
        block6_add(k->diag + last, 3 + c, by_phi, v3_add(v3_cross(turned, f), v3_cross(e.arm, by_phi)));
        block6_add(d->diag + last, c, by_v, v3_cross(e.arm, by_v));
        block6_add(d->diag + last, 3 + c, by_w, v3_cross(e.arm, by_w));
    }
}

/* ---------------------------------------------------------------------------------------------------- the pull */

/* Pull of the winch on the head along its direction at time t, N, for the kinematics in the workspace; 0 without
 * one. */
static double winch_pull_now(const Scene *scene, Workspace *ws, double t)
{
    const Winch *const w = scene->winch;
    const int n = scene->chain.n;
    if (!w->present) return 0;
    if (w->mode == WINCH_TENSION) return winch_pull(w, &scene->chain, &ws->kin, t);
    bushing_kernels()->loads(&scene->chain, &ws->kin, n / LANES * LANES, n + 1,
                             &ws->joints); /* the last lane contains the head's joint */
    return v3_dot(v3_load(ws->joints.force, n), w->direction);
}

double winch_pull_at(const Scene *scene, Workspace *ws, double t, const double *y)
{
    const int n = scene->chain.n;
    body_kernels()->kinematics(n, y, (n - 1) / LANES * LANES, n, &ws->kin);
    scene_ghosts(scene, t, &ws->kin);
    return winch_pull_now(scene, ws, t);
}

/* Power at the ghost, whose joint holds the head, and of a set tension on the head's end (BA2). */
static void winch_work(const Room *room, const Moment *m, BalanceRates *out)
{
    const Winch *const w = room->self;
    balance_work(out, BY_WINCH, dynamics_ghost_push(m, m->scene->chain.n));
    if (w->mode != WINCH_TENSION) return;
    const HeadEnd e = head_end(w, &m->scene->chain, &m->ws->kin);
    const HeadLaw law = head_law(w, &e, m->t);
    const Vec3 f = head_force(w, &law, &e);
    balance_work(out, BY_WINCH, (Push){v3_dot(f, e.velocity), f});
}

static int winch_look(const Room *room, const Moment *m)
{
    (void)room;
    m->ws->head_pull = winch_pull_now(m->scene, m->ws, m->t);
    return 0;
}

/* ---------------------------------------------------------------------------------------------------- building */

/* s: over the brake's stiffness: least damping of the head while the brake is being applied (K3). */
static const double SLOWING = 0.01;

double winch_place(const Scene *scene)
{
    const double at = scene->def.winch.at;
    return isnan(at) ? fmax(scene->joint_s[scene->total], scene->route.length) : at;
}

void winch_init(Winch *w, const WinchDef *def)
{
    w->present = def->present;
    w->mode = def->mode;
    w->speed = def->speed;
    w->tension = def->tension;
    w->speed_limit = def->speed_limit > 0 ? def->speed_limit : INFINITY;
    w->band = def->band;
    w->drum_mass = def->mode == WINCH_TENSION ? def->drum_mass : 0;
    w->trip = def->trip;
    w->trip_force = def->mode == WINCH_SPEED ? def->trip.force : 0;
    w->phase = (WinchPhase){.doing = WINCH_FOLLOWS,
                            .speed = def->speed,
                            .until = INFINITY,
                            .over = INFINITY,
                            .held = def->mode == WINCH_TENSION ? HELD_FIRST : 0,
                            .ended = INFINITY,
                            .asked = NAN,
                            .tension = def->tension,
                            .before = NAN};
}

/* Places the winch at the head's end, pulling along the route's end direction; the frame of its ghost continues that of
 * the last segment. Errors: MEMORY. */
static hawser_status winch_stand(Winch *w, const Scene *scene, hawser_error *err)
{
    const int n = scene->chain.n;
    const double end = fmax(scene->joint_s[n], scene->route.length);
    w->origin = scene_line_at(scene, scene->joint_s[n]);
    w->direction = route_at(&scene->route, end).tangent;
    if (scene->def.winch.take_in) {
        const RoutePoint at = route_at(&scene->route, winch_place(scene));
        w->take_in = (TakeIn){.present = 1, .place = at.position};
        w->direction = at.tangent;
    }
    double *const y = malloc((size_t)(STATE_SIZE * n) * sizeof *y);
    if (!y) return error_memory(err);
    scene_initial_chain(scene, y);
    const double *const last = y + n - 1;
    const Quat q = {last[3 * n], last[4 * n], last[5 * n], last[6 * n]};
    w->attitude = quat_carry(q, quat_rotate(q, v3(1, 0, 0)), w->direction);
    free(y);
    return HAWSER_OK;
}

static hawser_status winch_build(Room *room, Scene *scene, hawser_error *err)
{
    Winch *const w = room->self = scene->winch = calloc(1, sizeof *w);
    if (!w) return error_memory(err);
    winch_init(w, &scene->def.winch);
    room->present = w->present;
    scene->weight.weightless = w->drum_mass;
    const double speed = winch_largest_speed(w, scene->def.duration);
    if (w->present && speed > 0) scene->largest_speed = speed;
    return winch_stand(w, scene, err);
}

/* The head's joint is the half-spring of the last segment alone. With a set tension its end slides along the pull,
 * guided and braked by that spring; a clamp holds its attitude too, and the drum moves with the last segment
 * (WI3)-(WI5). */
static void winch_join(Room *room, Scene *scene)
{
    Winch *const w = room->self;
    const int n = scene->chain.n, clamp = !scene->def.winch.axial_only;
    Bushing b = joints_clamp(scene, n - 1);
    if (w->mode != WINCH_TENSION) {
        Vec3 axis[2];
        const int slides = winch_free_axes(w, &scene->def.winch, axis) > 0;
        if (slides) joint_even(&b);
        joint_set(&scene->chain, n, &b, 0, clamp ? COMPONENTS : slides ? TORSION : SHEAR_Y);
        return;
    }
    if (clamp) joint_set(&scene->chain, n, &b, TORSION, COMPONENTS);
    w->guide[0] = clamp ? b.stiffness[SHEAR_Y] : 0;
    w->guide[1] = clamp ? b.damping[SHEAR_Y] : 0;
    w->brake[0] = b.stiffness[AXIAL];
    w->brake[1] = b.damping[AXIAL];
    w->slowing = fmax(w->brake[1], SLOWING * w->brake[0]);
    scene->chain.mass[n - 1] += w->drum_mass;
}

static const char *winch_not_planar(const Room *room, const Scene *scene)
{
    (void)scene;
    const Winch *const w = room->self;
    if (w->take_in.present) return "segments join and leave the chain";
    return w->mode == WINCH_SPEED ? NULL : "the winch pulls with a set tension";
}

/* Commands and the winch's own phases are among its controls. */
static void winch_checkpoint(Checkpoint *c, const Room *room, const Scene *scene, Workspace *ws)
{
    (void)scene, (void)ws;
    Winch *const w = room->self;
    CHECKPOINT(c, w->origin);
    CHECKPOINT(c, w->attitude);
    CHECKPOINT(c, w->take_in);
}

const RoomKind WINCH_ROOM = {.name = "winch",
                             .build = winch_build,
                             .join = winch_join,
                             .ghosts = winch_ghost,
                             .loads = winch_loads,
                             .blocks = winch_blocks,
                             .watches = winch_watches,
                             .happen = winch_happen,
                             .next_stop = winch_next_stop,
                             .checkpoint = winch_checkpoint,
                             .command = winch_command,
                             .controls = winch_controls,
                             .work = winch_work,
                             .look = winch_look,
                             .not_planar = winch_not_planar};
