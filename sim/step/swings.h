/* What steps in time make of a pull that swings, and how long they may be then; and how fast it rises. A method of
 * second order takes of a fall what third differences of the pull say, whatever it swings by and wherever on a ramp.
 * docs/model.md, "Error bars". */
#ifndef HAWSER_SIM_STEP_SWINGS_H
#define HAWSER_SIM_STEP_SWINGS_H

#include "sim/scene.h"

enum { SWINGS_STEPS = 4 }; /* whose third difference is taken */

typedef struct Swings {
    double t[SWINGS_STEPS], pull[SWINGS_STEPS]; /* s, N: of the last steps, the latest last */
    int steps;                                  /* that were seen */
    int downward;                               /* steps in a row in which the pull has fallen */
    double top, bottom;                         /* N: where it began to fall, and to rise, last */
    double risen_at;                            /* s: when it began to rise */
    double largest;                             /* N, of all steps */
    /* N: the most that the method takes of a fall so far (EB23) */
    double fades;
    /* N/s: the last rise where it was steepest (EB26) */
    double steepest;
    /* N/s^3: the third derivative, as it fades from its tops; s: the longest step, 0: none is asked for (EB25) */
    double third;
    double bound;
} Swings;

/* Takes in the pull at the end of a step, N at t. A scene without a longest step (no rows, none given) has no bound. */
void swings_step(Swings *swings, const Scene *scene, double t, double pull);
/* N: by how much the last rise went up. */
double swings_rise(const Swings *swings);

#endif
