/* A run that is moved by positions in steady motion wherever that may be, and by its equations of motion elsewhere:
 * when it changes from one to the other, how far apart positions are, and rows between them.
 * docs/model/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_RUN_H
#define HAWSER_SIM_RUN_QUASI_RUN_H

#include "hawser/hawser.h"
#include "sim/stage/quasi.h"

enum { QUASI_KEPT = 3 }; /* positions: two that rows lie between, and the one before */

/* The pull while the equations of motion move a winch of constant speed (QS1). */
typedef struct PullWindow {
    double from, last; /* s; when it began (< 0: it has not), and the last step's end */
    double speed;      /* m/s */
    double least, most, sum;
    double before; /* N, at `last` */
} PullWindow;

typedef struct QuasiRun {
    Quasi stage;
    /* by time, the last one last, which is where the run is or ahead of it */
    double t[QUASI_KEPT];     /* s */
    double *look[QUASI_KEPT]; /* [numbers] what rows show of them; owned, in one piece by memory */
    double *memory;
    int numbers;
    int known;        /* of these positions, how many there are */
    double *y;        /* [size] state of the last; owned */
    int probing;      /* the stage is at a position that rows know nothing of */
    int size, active; /* of y; contacts that carry force there */
    double step;      /* s, to the next */
    double checked;   /* s: when the equations of motion were asked last */
    double peak_at;   /* m, past a roller: where the front was when the one behind it was loaded most (QS9) */
    int peaks;        /* so far */
    int peak_side;    /* on which side of that the next look is: 1, -1; 0: nothing is known yet */
    PullWindow window;
    int told;          /* something that positions know nothing of: they are over */
    int waits, failed; /* windows to let pass before the next attempt; attempts that failed */
    hawser_quasi_static said;
} QuasiRun;

struct hawser_sim;

/* Errors: as quasi_new. quasi_run_free may follow. */
hawser_status quasi_run_new(struct hawser_sim *s, hawser_error *err);
void quasi_run_free(QuasiRun *q);

/* A step of the equations of motion has ended: positions may go on from here. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_begin(struct hawser_sim *s, hawser_error *err);
/* Moves on by positions, to the next one or to t (s) if that is before it; *arrived: it is one. They may end here: then
 * the equations of motion go on from a time that is not beyond t. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_move(struct hawser_sim *s, double t, int *arrived, hawser_error *err);
/* Equations of motion from now on. Nothing is done where they move already. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_end(struct hawser_sim *s, hawser_error *err);

/* Finds the position of time t, where the stage is then. Errors: as positions_advance. */
hawser_status quasi_find(struct hawser_sim *s, double t, hawser_relaxation *found, hawser_error *err);
/* Of what a position showed: the load of roller r, N. */
double quasi_roller_load(const struct hawser_sim *s, const double *numbers, int r);
/* When the front next is where a roller may be loaded most (QS9), s, not before `from`; at most `end`. */
double quasi_next_peak(const struct hawser_sim *s, double from, double end);
/* Peaks of rollers' loads between the last two positions, (QS9): found as positions of their own, which count for
 * nothing else. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_peaks(struct hawser_sim *s, hawser_error *err);

/* Between the last two positions, s; of the first of a stretch: the last step before it. */
double quasi_step(const QuasiRun *q);
/* Whether the state of now is one between two positions; what a look at it shows (QS6), once kinematics are looked at.
 */
int quasi_between(const struct hawser_sim *s);
void quasi_mix(struct hawser_sim *s);

/* Before and after the stage's own. Errors: MEMORY. */
void quasi_checkpoint_before(Checkpoint *c, struct hawser_sim *s);
hawser_status quasi_checkpoint(Checkpoint *c, struct hawser_sim *s, hawser_error *err);

#endif
