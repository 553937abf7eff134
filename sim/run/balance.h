/* The balances of energy and momentum of a run: the work and impulse since t = 0 against the change of what is stored.
 * docs/theory.md, "Balances". */
#ifndef HAWSER_SIM_RUN_BALANCE_H
#define HAWSER_SIM_RUN_BALANCE_H

#include "hawser/hawser.h"
#include "sim/solve/motion.h"

typedef struct Balance Balance;

/* Begins at the state (t, y): evaluates it. Errors: MEMORY. */
hawser_status balance_new(Motion *motion, double t, const double *y, Balance **out, hawser_error *err);
Balance *balance_free(Balance *b);
/* Adds an accepted step of h (s) to (t, y), of which the motion has evaluated the last iterate (BA9); rates: those of y
 * times h (integrator_rates). Allocates nothing. */
void balance_step(Balance *b, Motion *motion, double t, const double *y, const double *rates, double h);
/* Called before and after segments join or leave at (t, y), which may bring another motion; the change counts as
 * carried in or out by them (BA3). Errors: MEMORY. */
void balance_leave(Balance *b, Motion *motion, double t, const double *y);
hawser_status balance_enter(Balance *b, Motion *motion, double t, const double *y, hawser_error *err);
/* Adds a position in steady motion at (t, y) after the last one, balance_enter before the first (QS13); momentum is
 * carried. It evaluates y; the energy of segments that joined on the way, less that of those that left, is given
 * afterwards, J. Errors: MEMORY. */
hawser_status balance_position(Balance *b, Motion *motion, double t, const double *y, hawser_error *err);
void balance_carry(Balance *b, double energy);
/* Closes the balances from the beginning to (t, y), which is evaluated; *out remains the balance's. */
const hawser_balance *balance_close(Balance *b, Motion *motion, double t, const double *y);
/* The same as of balance_leave, while nothing is added. */
const hawser_balance *balance_left(Balance *b);
/* Saves or loads the balances of the motion; loading creates them if there are none (NULL). */
void balance_checkpoint(Checkpoint *c, Balance **books, const Motion *motion);
/* The same of the steady window alone, J, after balance_close. Zero before it opens. */
typedef struct BalanceWindow {
    double winch;     /* its work */
    double numerical; /* taken out of the motion by the method */
    double residual;  /* residual */
} BalanceWindow;

BalanceWindow balance_window(const Balance *b);

#endif
