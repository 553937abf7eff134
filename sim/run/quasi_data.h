/* A stage that is moved by positions in steady motion in place of the equations of motion, and back: what changes hands
 * then. Who chooses between them is sim/run/quasi.h. docs/model/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_DATA_H
#define HAWSER_SIM_RUN_QUASI_DATA_H

#include "hawser/hawser.h"
#include "sim/equipment/winch.h"
#include "sim/run/positions.h"

typedef struct Quasi {
    const char *why;        /* why positions cannot move this scene; NULL: they can */
    int on;                 /* they do now */
    double *damping;        /* [6][joints of the whole chain] as built, owned; NULL: not asked for */
    IntegratorStats so_far; /* of the integrator, while there is none */
} Quasi;

/* What the scene's motion may be: resolves `auto`, and what `quasi-static` asks for, which it takes to space. Errors:
 * INPUT (it cannot be, and says why), MEMORY. quasi_free may follow. */
hawser_status quasi_new(Quasi *q, Positions *p, const Stage *stage, hawser_error *err);
void quasi_free(Quasi *q);
/* Until when the winch keeps the speed that it has at t, s; at most `end`. t itself: it has none, or loses it now. */
double quasi_steady_until(const Scene *scene, double t, double end);
/* What an attempt can be taken back to: the stage as it was. */
typedef struct Moving {
    int first, n, reel;
    double t, *y; /* owned */
    Vec3 origin;  /* of the winch */
    Quat attitude;
    TakeIn take_in;
} Moving;

/* The integrator ends, its counts stay; springs lose their damping (PS3), and the last shape is where the first
 * position begins. Errors: MEMORY, RUN; moving_free follows either way. */
hawser_status quasi_enter(Quasi *q, Positions *p, Stage *stage, Moving *from, hawser_error *err);
/* Equations of motion again, from the state of now, which is one in motion. Errors: MEMORY. */
hawser_status quasi_leave(Quasi *q, Stage *stage, hawser_error *err);
/* The same from where they were left. Errors: MEMORY, RUN. */
hawser_status quasi_undo(Quasi *q, Stage *stage, const Moving *to, hawser_error *err);
/* Errors: MEMORY; RUN. moving_free follows either way. */
hawser_status moving_keep(Moving *m, const Stage *st, hawser_error *err);
hawser_status moving_restore(Stage *stage, const Moving *to, hawser_error *err);
void moving_free(Moving *from);
/* Springs with their damping, or without. */
void quasi_damping(const Quasi *q, Stage *stage, int present);
/* What a run keeps that positions in steady motion move: docs/model/45-quasi-static.md. Who moves it is in
 * sim/run/quasi.h. */

enum { QUASI_KEPT = 3 }; /* positions: two that rows lie between, and the one before */

/* The pull while the equations of motion move a winch of constant speed (QS1). */
typedef struct PullWindow {
    double from, last; /* s; when it began (< 0: it has not), and the last step's end */
    double speed;      /* m/s */
    double least, most, sum;
    double before; /* N, at `last` */
} PullWindow;

/* Where rollers are loaded most (QS9). */
typedef struct QuasiPeak {
    double at;    /* m, before (< 0) the next roller or past it: where the front was when the last one was */
    double usual; /* m: the same, where one roller was as the one before */
    double trend; /* m: what that has changed by since the one before */
    double load;  /* N, then */
    double lag;   /* m, by which the front is behind what the winch has hauled: stretch */
    double done;  /* m: the next roller's place then */
    double open;  /* share by which that one's peak may stand above the highest look (QS11) */
    int rollers;  /* since it was enclosed */
    int side;     /* on which the next one may be higher: 1, -1 */
} QuasiPeak;

/* The largest load that was found while a front passed, N, and the share by which it may have been more. */
typedef struct QuasiTop {
    double load, open;
    double landing; /* m: where the front comes to the next roller; NAN: another one stands at the same place */
} QuasiTop;

typedef struct QuasiRun {
    Quasi stage;
    /* by time, the last one last, which is where the run is or ahead of it */
    double t[QUASI_KEPT];     /* s */
    double *look[QUASI_KEPT]; /* [numbers] what rows show of them; owned, in one piece by memory */
    double *memory;
    int numbers;
    int known;                  /* of these positions, how many there are */
    double *y;                  /* [size] state of the last; owned */
    int probing;                /* the stage is at a position that rows know nothing of */
    int size, active;           /* of y; contacts that carry force there */
    int booked_first, booked_n; /* segments of the last position in the books of energy */
    double booked_drum;         /* kg, that the first of them has from the reel */
    double step;                /* s, to the next */
    int hangs;                  /* segments that pass the winch from one that is asked for its hanging to the next */
    double checked;             /* s: when the equations of motion were asked last */
    QuasiPeak peak;
    QuasiTop *top; /* [rollers] owned */
    PullWindow window;
    int told;          /* something that positions know nothing of: they are over */
    int waits, failed; /* windows to let pass before the next attempt; attempts that failed */
    hawser_quasi_static said;
} QuasiRun;

/* ---- rows between two positions, as numbers (sim/run/quasi.c) */
struct hawser_sim;

/* How many there are; those of the last look. */
int quasi_numbers(const struct hawser_sim *s);
void quasi_take(struct hawser_sim *s, double *numbers);
/* Of what a position showed: the load of roller r, N. */
double quasi_roller_load(const struct hawser_sim *s, const double *numbers, int r);
/* Between the last two positions, s; of the first of a stretch: the last step before it. */
double quasi_step(const QuasiRun *q);
/* Whether the state of now is one between two positions; what a look at it shows (QS6), once kinematics are looked at.
 */
int quasi_between(const struct hawser_sim *s);
void quasi_mix(struct hawser_sim *s);

#endif
