/* Change of a stage from the equations of motion to positions in steady motion and back. The choice between them is
 * made in sim/run/quasi.h. docs/theory/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_DATA_H
#define HAWSER_SIM_RUN_QUASI_DATA_H

#include "hawser/hawser.h"
#include "sim/equipment/winch.h"
#include "sim/run/positions.h"

typedef struct Quasi {
    const char *why;        /* reason why this scene cannot be moved by positions; NULL: it can */
    int on;                 /* 1: positions are active */
    double *damping;        /* [6][joints of the whole chain] as built, owned; NULL: not needed */
    IntegratorStats so_far; /* of the integrator up to its last end */
} Quasi;

/* Decides how the scene may move: resolves `auto`, and takes a scene with `quasi-static` to space. Errors: INPUT (not
 * possible, with the reason), MEMORY. quasi_free may follow. */
hawser_status quasi_new(Quasi *q, Positions *p, const Stage *stage, hawser_error *err);
void quasi_free(Quasi *q);
/* Time until which the winch keeps the speed that it has at t, s; at most `end`. t itself: it has no constant speed, or
 * loses it now. */
double quasi_steady_until(const Scene *scene, double t, double end);
/* The stage before an attempt, to restore it. */
typedef struct Moving {
    int first, n, reel;
    double t, *y; /* owned */
    Vec3 origin;  /* of the winch */
    Quat attitude;
    TakeIn take_in;
} Moving;

/* Ends the integrator, keeping its counts; removes the damping of springs (PS3); the last shape is where the first
 * position begins. Errors: MEMORY, RUN; moving_free follows either way. */
hawser_status quasi_enter(Quasi *q, Positions *p, Stage *stage, Moving *from, hawser_error *err);
/* Continues with the equations of motion from the present state, which is in motion. Errors: MEMORY. */
hawser_status quasi_leave(Quasi *q, Stage *stage, hawser_error *err);
/* The same from the state before the attempt. Errors: MEMORY, RUN. */
hawser_status quasi_undo(Quasi *q, Stage *stage, const Moving *to, hawser_error *err);
/* Errors: MEMORY; RUN. moving_free follows either way. */
hawser_status moving_keep(Moving *m, const Stage *st, hawser_error *err);
hawser_status moving_restore(Stage *stage, const Moving *to, hawser_error *err);
void moving_free(Moving *from);
/* Sets springs with their damping, or without. */
void quasi_damping(const Quasi *q, Stage *stage, int present);
/* Data of a run that is moved by positions in steady motion: docs/theory/45-quasi-static.md. sim/run/quasi.h moves
 * it. */

enum { QUASI_KEPT = 3 }; /* positions: the two that enclose the rows, and the one before */

/* Pull over a window while the equations of motion move a winch of constant speed (QS1). */
typedef struct PullWindow {
    double from, last; /* s; beginning (< 0: none yet), and end of the last step */
    double speed;      /* m/s */
    double least, most, sum;
    double before; /* N, at `last` */
} PullWindow;

/* Place of the largest load of rollers (QS9). */
typedef struct QuasiPeak {
    double at;    /* m, before (< 0) the next roller or past it: the front's place at the last roller's peak */
    double usual; /* m: the same, where it was equal for two rollers in a row */
    double trend; /* m: its change since the roller before */
    double load;  /* N, at that time */
    double lag;   /* m, distance of the front behind the winch's travel: stretch */
    double done;  /* m: the next roller's place at that time */
    double open;  /* share by which that peak may exceed the highest look (QS11) */
    int rollers;  /* number since a peak was enclosed */
    int side;     /* on which the next look may be higher: 1, -1 */
} QuasiPeak;

/* Largest load found while a front passed, N, and its relative uncertainty. */
typedef struct QuasiTop {
    double load, open;
    double landing; /* m: place where the front comes to the next roller; NAN: another roller is at the same place */
} QuasiTop;

typedef struct QuasiRun {
    Quasi stage;
    /* by time; the last one is where the run is or ahead of it */
    double t[QUASI_KEPT];     /* s */
    double *look[QUASI_KEPT]; /* [numbers] their figures for rows; owned, in one piece by memory */
    double *memory;
    int numbers;
    int known;                  /* number of these positions that exist */
    double *y;                  /* [size] state of the last; owned */
    int probing;                /* 1: the stage is at a position that does not count for rows */
    int size, active;           /* size of y; number of contacts that carry force there */
    int booked_first, booked_n; /* segments of the last position in the balance of energy */
    double booked_drum;         /* kg, drum mass of the first of them */
    double step;                /* s, to the next position */
    int hangs;                  /* number of segments that pass the winch between two whose offset is computed */
    double checked;             /* s: last check by the equations of motion */
    QuasiPeak peak;
    QuasiTop *top; /* [rollers] owned */
    PullWindow window;
    int told;          /* 1: a command came that positions do not cover: they end */
    int waits, failed; /* windows to wait before the next attempt; failed attempts */
    hawser_quasi_static said;
} QuasiRun;

/* ---- rows between two positions, as numbers (sim/run/quasi.c) */
struct hawser_sim;

/* Their number; those of the last look. */
int quasi_numbers(const struct hawser_sim *s);
void quasi_take(struct hawser_sim *s, double *numbers);
/* Load of roller r in a position's numbers, N. */
double quasi_roller_load(const struct hawser_sim *s, const double *numbers, int r);
/* Time between the last two positions, s; at the first of a stretch, the last step before it. */
double quasi_step(const QuasiRun *q);
/* Checks whether the present state is between two positions; interpolates the figures of a look at it (QS6), after the
 * kinematics are computed. */
int quasi_between(const struct hawser_sim *s);
void quasi_mix(struct hawser_sim *s);

#endif
