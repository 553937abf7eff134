/* The winch, which moves the chain's head: it moves a ghost by a speed profile, or pulls with a set tension; it trips,
 * stands and starts again. docs/theory.md, "Winch and conveyors" (WI1)-(WI12).
 *
 * Between two events the winch is a function of time (and, with a set tension, of the head's motion) like everything
 * else in the right-hand side. Its `phase` changes between accepted steps only, in winch_accept(). */
#ifndef HAWSER_SIM_EQUIPMENT_WINCH_H
#define HAWSER_SIM_EQUIPMENT_WINCH_H

#include "core/state.h"
#include "sim/dynamics.h"

/* FOLLOWS: by the case; OBEYS: by the last command. */
typedef enum WinchDoing { WINCH_FOLLOWS, WINCH_BRAKES, WINCH_STANDS, WINCH_RESTARTS, WINCH_OBEYS } WinchDoing;

/* Present motion of the winch: speed(t) = value of `speed` at t - since, travel(t) = offset + its integral there
 * (WI1). */
typedef struct WinchPhase {
    WinchDoing doing;
    Profile speed; /* m/s, over t - since */
    double since;  /* s */
    double offset; /* m */
    double until;  /* s, end of the phase; INFINITY: none */
    double resume; /* s, on the case's profile: time at which the brake was applied */
    double over;   /* s, time since which the force has been above the trip's; INFINITY: it is not */
    int trips;     /* so far */
    int held;      /* set tension: HELD_FIRST: the brake is on, as before t = 0; HELD_TOLD: a command has applied it */
    double ended;  /* s, time at which a last trip ended the run; INFINITY: it did not */
    /* by commands */
    int told;        /* a command has stopped it: it stands until the next command */
    double asked;    /* m/s, speed by command instead of the case's profile; NAN: none */
    Profile tension; /* N, of WINCH_TENSION, over t */
    double before;   /* N, its pull before a pause; NAN: no pause */
    Profile hold;    /* share of the brake of a set tension's winch, 0..1, over t (K3) */
    double held_at;  /* m of travel at which that brake holds */
} WinchPhase;

enum { HELD_FIRST = 1, HELD_TOLD = 2 };

/* A winch that takes the rope in: a segment that has passed it leaves the chain and becomes the ghost that holds the
 * next one: a whole rigid segment whose pose moves along the pull with the rope (RL16). */
typedef struct TakeIn {
    int present;
    Vec3 place; /* m, of the winch */
    /* motion, relative to the winch's, of the segment that was taken in last */
    double since;     /* s */
    Vec3 drift, spin; /* m/s, rad/s; they die out over a fifth of a second */
} TakeIn;

/* The winch of a scene; all but `phase` and `trip_force` is fixed when the scene is built. */
typedef struct Winch {
    int present;
    WinchMode mode;
    Profile speed;  /* m/s, of WINCH_SPEED */
    Vec3 origin;    /* place of the head's end at t = 0, m */
    Vec3 direction; /* unit */
    Quat attitude;
    /* WINCH_TENSION */
    Profile tension;    /* N */
    double speed_limit; /* m/s; INFINITY: no limit */
    double band;        /* share of the limit over which the force drops */
    double drum_mass;   /* kg, inertia of the drum at the rope: moves with the last segment, has no weight */
    double guide[2];    /* N/m, N s/m: holds the head's end on the pull's line, across it */
    double brake[2];    /* N/m, N s/m: holds it along the line while the brake is on */
    double slowing;     /* N s/m: least damping while the brake is being applied (K3) */
    /* trips */
    TripDef trip;
    double trip_force; /* N; 0: never trips */
    WinchPhase phase;
    TakeIn take_in;
} Winch;

/* Travel along the pull (m) and its rate (m/s). */
typedef struct WinchMotion {
    double travel, speed;
} WinchMotion;

/* Initialises by the definition, at rest before t = 0; the place, the guide and the brake are left to the scene. */
void winch_init(Winch *w, const WinchDef *def);
/* Place of a winch that takes the rope in, m along the route: by the definition, otherwise the route's end, or the
 * head's place if that is farther. */
double winch_place(const Scene *scene);
/* Makes a segment with this own drift (m/s) and spin (rad/s) the ghost at time t. */
void winch_take_in(Winch *w, double t, Vec3 drift, Vec3 spin);
/* Directions across the pull in which the head's end may slide, for a set speed with grip `axial`: the two into axis;
 * returns their number, 0 for any other winch. */
int winch_free_axes(const Winch *w, const WinchDef *def, Vec3 axis[2]);
/* A winch with a speed profile: functions of time alone. */
double winch_speed(const Winch *w, double t);
double winch_travel(const Winch *w, double t);
/* Motion of either kind of winch; with a set tension it is that of the head's end in kin. */
WinchMotion winch_motion(const Winch *w, const Chain *chain, const Kinematics *kin, double t);
/* Largest speed of the profile up to that time (s), or the limit; 0 if there is none, m/s. */
double winch_largest_speed(const Winch *w, double until);
/* Set tension: pull at time t when the head's end moves at `speed` along the pull (WI2); *slope (may be NULL) gets
 * d/d(speed). */
double winch_tension(const Winch *w, double t, double speed, double *slope);
/* Set tension: force on the last segment along the pull, N: the tension, or the brake's force (WI5). */
double winch_pull(const Winch *w, const Chain *chain, const Kinematics *kin, double t);
/* The same from (t, y); updates the kinematics of the head's last segments only. */
double winch_pull_at(const Scene *scene, Workspace *ws, double t, const double *y);
/* Events of a winch. */
typedef enum WinchEvent {
    WINCH_NOTHING,
    WINCH_TRIPPED,     /* the force was too large: the brake is applied */
    WINCH_STOPPED,     /* it has come to rest */
    WINCH_STARTED,     /* it starts again */
    WINCH_RUNNING,     /* it has reached the speed at which it tripped */
    WINCH_STAYS,       /* it has stopped for good */
    WINCH_ENDS_THE_RUN /* the same, and the run ends with it */
} WinchEvent;

/* Updates the phase after an accepted step to time t with this pull on the head (N), if there is an event (WI8)-(WI12);
 * call again until NOTHING. */
WinchEvent winch_accept(Winch *w, double t, double pull);

#endif
