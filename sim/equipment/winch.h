/* The winch: what it does to the chain's head. It moves a ghost at a speed profile, or pulls with a set tension; it
 * trips, stands and starts again. docs/model.md, "Winch and conveyors" (WI1)-(WI12).
 *
 * Between two events the winch is a function of time (and, with a set tension, of the head's motion) like everything
 * else in the right-hand side. Its `phase` changes between accepted steps only, in winch_accept(). */
#ifndef HAWSER_SIM_EQUIPMENT_WINCH_H
#define HAWSER_SIM_EQUIPMENT_WINCH_H

#include "core/state.h"
#include "sim/dynamics.h"

/* It follows the case, or the last command. */
typedef enum WinchDoing { WINCH_FOLLOWS, WINCH_BRAKES, WINCH_STANDS, WINCH_RESTARTS, WINCH_OBEYS } WinchDoing;

/* What the winch does now: speed(t) = value of `speed` at t - since, travel(t) = offset + its integral there (WI1). */
typedef struct WinchPhase {
    WinchDoing doing;
    Profile speed; /* m/s, over t - since */
    double since;  /* s */
    double offset; /* m */
    double until;  /* s, when the phase ends by itself; INFINITY: never */
    double resume; /* s, on the case's profile: where the speed was when the brake fell in */
    double over;   /* s, since when the force has been above the trip's; INFINITY: it is not */
    int trips;     /* so far */
    int held;      /* set tension: HELD_FIRST: the brake is on, as before t = 0; HELD_TOLD: it is on by a command */
    double ended;  /* s, when a last trip ended the run; INFINITY: it did not */
    /* by commands */
    int told;        /* it was stopped by one: it stands until it is told to go on */
    double asked;    /* m/s, set in place of the case's profile; NAN: none is */
    Profile tension; /* N, of WINCH_TENSION, over t */
    double before;   /* N, with which it pulled before a pause; NAN: it does not pause */
    Profile hold;    /* share of the brake of a set tension's winch, 0..1, over t (K3) */
    double held_at;  /* m of travel, where that brake holds */
} WinchPhase;

enum { HELD_FIRST = 1, HELD_TOLD = 2 };

/* A winch that takes the rope in: a segment that has passed it leaves the chain and becomes the ghost that holds the
 * next one, a whole rigid segment whose pose moves on along the pull as the rope does (RL16). */
typedef struct TakeIn {
    int present;
    Vec3 place; /* m, where the winch stands */
    /* of the segment that was taken last: how it moved besides following the winch */
    double since;     /* s */
    Vec3 drift, spin; /* m/s, rad/s; they die out over a fifth of a second */
} TakeIn;

/* The winch of a scene; all but `phase` and `trip_force` is fixed when the scene is built. */
typedef struct Winch {
    int present;
    WinchMode mode;
    Profile speed;  /* m/s, of WINCH_SPEED */
    Vec3 origin;    /* where the head's end is at t = 0, m */
    Vec3 direction; /* unit */
    Quat attitude;
    /* WINCH_TENSION */
    Profile tension;    /* N */
    double speed_limit; /* m/s; INFINITY: none */
    double band;        /* share of the limit over which the force falls off */
    double drum_mass;   /* kg, inertia of the drum at the rope: moves with the last segment, weighs nothing */
    double guide[2];    /* N/m, N s/m: holds the head's end on the pull's line, across it */
    double brake[2];    /* N/m, N s/m: holds it along the line while the brake is on */
    double slowing;     /* N s/m: what stops it while the brake comes on (K3) */
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

/* Sets what the definition says, at rest before t = 0; the place, the guide and the brake are left to the scene. */
void winch_init(Winch *w, const WinchDef *def);
/* Where the winch stands that takes the rope in, m along the route: as the definition says; otherwise the route's end,
 * or the head's place if that is farther. */
double winch_place(const Scene *scene);
/* A segment that moved on by itself with this drift (m/s) and spin (rad/s) becomes the ghost at time t. */
void winch_take_in(Winch *w, double t, Vec3 drift, Vec3 spin);
/* A set speed with grip `axial` holds the head's end along the pull and lets it slide across it: the two directions
 * into axis; returns how many there are, 0 of any other. */
int winch_free_axes(const Winch *w, const WinchDef *def, Vec3 axis[2]);
/* A winch with a speed profile: functions of time alone. */
double winch_speed(const Winch *w, double t);
double winch_travel(const Winch *w, double t);
/* Either kind: a winch of set tension goes where the head's end is, which kin tells. */
WinchMotion winch_motion(const Winch *w, const Chain *chain, const Kinematics *kin, double t);
/* The largest speed of the profile up to that time (s), or the limit; 0 if there is none, m/s. */
double winch_largest_speed(const Winch *w, double until);
/* Set tension: what it pulls with at time t when the head's end moves at `speed` along the pull (WI2); *slope (may be
 * NULL) gets d/d(speed). */
double winch_tension(const Winch *w, double t, double speed, double *slope);
/* Set tension: force on the last segment along the pull, N: the tension, or what the brake holds (WI5). */
double winch_pull(const Winch *w, const Chain *chain, const Kinematics *kin, double t);
/* The same from (t, y); brings the kinematics of the head's last segments up to date, no others. */
double winch_pull_at(const Scene *scene, Workspace *ws, double t, const double *y);
/* What happens to a winch. */
typedef enum WinchEvent {
    WINCH_NOTHING,
    WINCH_TRIPPED,     /* the force was too large: the brake falls in */
    WINCH_STOPPED,     /* it stands */
    WINCH_STARTED,     /* it starts again */
    WINCH_RUNNING,     /* it is back at the speed at which it tripped */
    WINCH_STAYS,       /* it has stopped for good */
    WINCH_ENDS_THE_RUN /* the same, and the run ends with it */
} WinchEvent;

/* A step to time t was accepted, with this pull on the head (N). Changes the phase if something happens (WI8)-(WI12);
 * call again until NOTHING. */
WinchEvent winch_accept(Winch *w, double t, double pull);

#endif
