/* The trip as a small machine between accepted steps:
 *
 *     follows --force too large--> brakes --at rest--> stands --pause over--> restarts --at speed--> follows
 *
 * A restart can trip too. Every change keeps travel and speed continuous (WI8)-(WI12). */
#include <math.h>

#include "sim/equipment/winch.h"

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

/* At rest, for a while or for good (WI10). The brake's profile stays: it is 0 from here on. */
static WinchEvent stand(Winch *w)
{
    WinchPhase *const now = &w->phase;
    const double since = now->until;
    now->doing = WINCH_STANDS;
    now->until = now->trips <= w->trip.restarts ? since + w->trip.pause : INFINITY;
    if (isfinite(now->until)) return WINCH_STOPPED;
    if (!w->trip.ends_run) return WINCH_STAYS;
    now->ended = since;
    return WINCH_ENDS_THE_RUN;
}

/* (WI11). From rest to the speed at which the brake fell in. */
static WinchEvent restart(Winch *w)
{
    WinchPhase *const now = &w->phase;
    const double start = now->until;
    const Profile up = {.kind = PROFILE_STEP, .v1 = profile_value(&w->speed, now->resume), .t1 = w->trip.ramp};
    phase_begin(w, WINCH_RESTARTS, start, up, 0);
    now->until = start + w->trip.ramp;
    return WINCH_STARTED;
}

/* (WI12). The case's profile goes on where it was left. */
static WinchEvent follow(Winch *w)
{
    phase_begin(w, WINCH_FOLLOWS, w->phase.until, w->speed, w->phase.resume);
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
    const int moving = w->phase.doing == WINCH_FOLLOWS || w->phase.doing == WINCH_RESTARTS;
    if (!(w->trip_force > 0)) return WINCH_NOTHING;
    if (moving && too_large(w, t, pull)) return brake(w, t);
    if (t < w->phase.until - ON_TIME) return WINCH_NOTHING;
    switch (w->phase.doing) {
    case WINCH_BRAKES:
        return stand(w);
    case WINCH_STANDS:
        return restart(w);
    case WINCH_RESTARTS:
        return follow(w);
    case WINCH_FOLLOWS:
        break;
    }
    return WINCH_NOTHING;
}

const char *winch_event_name(WinchEvent event)
{
    static const char *const name[] = {"",
                                       "the winch trips",
                                       "the winch has stopped",
                                       "the winch starts again",
                                       "the winch is back at speed",
                                       "the winch has stopped for good",
                                       "the winch has stopped for good: the run ends"};
    return name[event];
}
