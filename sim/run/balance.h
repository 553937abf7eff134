/* The balances of energy and momentum of a run: what was done to the motion since t = 0 against what is there.
 * docs/model.md, "Balances". */
#ifndef HAWSER_SIM_RUN_BALANCE_H
#define HAWSER_SIM_RUN_BALANCE_H

#include "hawser/hawser.h"
#include "sim/solve/motion.h"

typedef struct Balance Balance;

/* Begins at the state (t, y): evaluates it. Errors: MEMORY. */
hawser_status balance_new(Motion *motion, double t, const double *y, Balance **out, hawser_error *err);
Balance *balance_free(Balance *b);
/* A step of h (s) to (t, y) was accepted, of which the motion has evaluated the last iterate (BA9); rates: those of y
 * times h (integrator_rates). Allocates nothing. */
void balance_step(Balance *b, Motion *motion, double t, const double *y, const double *rates, double h);
/* Segments join or leave at (t, y): around the change, which may bring another motion; what it changes is carried in
 * or out by them (BA3). Errors: MEMORY. */
void balance_leave(Balance *b, Motion *motion, double t, const double *y);
hawser_status balance_enter(Balance *b, Motion *motion, double t, const double *y, hawser_error *err);
/* A position in steady motion at (t, y) behind the last one, balance_enter before the first (QS13); momentum is
 * carried. It evaluates y: what energy has joined on the way, less what has left, is told behind it, J. Errors: MEMORY.
 */
hawser_status balance_position(Balance *b, Motion *motion, double t, const double *y, hawser_error *err);
void balance_carry(Balance *b, double energy);
/* The balances from the beginning to (t, y), which is evaluated; *out stays the balance's. */
const hawser_balance *balance_close(Balance *b, Motion *motion, double t, const double *y);
/* The same as the books were left (balance_leave), while nothing is booked. */
const hawser_balance *balance_left(Balance *b);
/* The books of the motion; read, they are made if there are none (NULL). */
void balance_checkpoint(Checkpoint *c, Balance **books, const Motion *motion);
/* The same of the steady window alone, once balance_close has been asked, J. Zero before it opens. */
typedef struct BalanceWindow {
    double winch;     /* its work */
    double numerical; /* what the method has taken out of the motion */
    double residual;  /* what is still open */
} BalanceWindow;

BalanceWindow balance_window(const Balance *b);

#endif
