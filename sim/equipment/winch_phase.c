/* What the winch does next: trips, and what it is told. docs/model.md, "Winch and conveyors" (WI8)-(WI12), "Control"
 * (K2), (K3). */
#include <math.h>

#include "core/base/error.h"
#include "sim/equipment/winch.h"

/* ------------------------------------------------------------------------------------------------------- trips */

/* The trip as a small machine between accepted steps:
 *
 *     follows --force too large--> brakes --at rest--> stands --pause over--> restarts --at speed--> follows
 *
 * A restart can trip too. Every change keeps travel and speed continuous (WI8)-(WI12). */

static const double ON_TIME = 1e-9; /* s: the integrator stops at a phase's end up to rounding */

/* Another profile from time t on, where the travel is what it was. */
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

/* (WI9). The brake falls in: from the speed of now to rest. A restart that trips keeps what it was to come back to. */
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

/* At rest, for a while or for good (WI10), or until it is told. The brake's profile stays: it is 0 from here on. */
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

/* (WI11). From the speed of `start`, which is none after a trip, to that at which the brake fell in. */
static WinchEvent restart(Winch *w, double start, double ramp)
{
    WinchPhase *const now = &w->phase;
    const double before = isnan(now->asked) ? profile_value(&w->speed, now->resume) : now->asked;
    const Profile up = {.kind = PROFILE_STEP, .v0 = winch_speed(w, start), .v1 = before, .t1 = ramp};
    phase_begin(w, WINCH_RESTARTS, start, up, 0);
    now->until = start + ramp;
    return WINCH_STARTED;
}

/* (WI12). The case's profile goes on where it was left, or the speed that was set. */
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

/* Whether the force has been above the limit for as long as it takes (WI8). */
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

Occurrence winch_occurrence(WinchEvent event)
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

/* Trips, and the ends of what it was told. */
int winch_watches(const Room *room)
{
    const Winch *const w = room->self;
    const int ends = isfinite(w->phase.until);
    return (w->trip_force > 0 || ends ? WATCH_PULL : 0) | (w->mode == WINCH_TENSION && ends ? WATCH_TRAVEL : 0);
}

/* A set tension's brake is on, or off (K3). */
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

Occurrence winch_happen(Room *room, const Occasion *now)
{
    Winch *const w = room->self;
    if (w->mode == WINCH_TENSION) return winch_occurrence(brake_done(w, now));
    return winch_occurrence(winch_accept(w, now->t, now->pull));
}

/* ----------------------------------------------------------------------------------------------------- commands */

/* (K2). It sets the speed, also of a winch that stands. */
static void obey(Winch *w, double t, double speed, double ramp)
{
    const Profile to = {.kind = PROFILE_STEP, .v0 = winch_speed(w, t), .t1 = ramp, .v1 = speed};
    phase_begin(w, WINCH_OBEYS, t, to, 0);
    w->phase.asked = speed;
    w->phase.told = 0;
}

/* (K2). Down to rest from whatever it does now; to come back to it. */
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
            now->before = c->value; /* for when it goes on */
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

int winch_command(Room *room, const Scene *scene, const Command *c, double t, hawser_error *err)
{
    (void)scene;
    Winch *const w = room->self;
    if (c->kind < HAWSER_WINCH_SPEED || c->kind > HAWSER_WINCH_RESTART) return 0;
    return w->mode == WINCH_SPEED ? speed_command(w, c, t, err) : tension_command(w, c, t, err);
}

void winch_controls(Room *room, ControlsVisit *visit)
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
