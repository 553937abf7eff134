/* CVODE (BDF) on the equations of motion: with its .c and vector.[ch] all that knows SUNDIALS. docs/model.md,
 * "Integration". */
#ifndef HAWSER_SIM_INTEGRATOR_H
#define HAWSER_SIM_INTEGRATOR_H

#include "sim/motion.h"

typedef struct Integrator Integrator;

typedef struct IntegratorStats {
    long steps, rhs_evals, newton_iters, jac_evals, lin_setups, error_fails, newton_fails;
    double rhs, jacobian, factor, solve, total; /* s */
    double last_step;                           /* s */
} IntegratorStats;

/* Starts at (t, y). The motion and y [motion->size] are borrowed; y always holds the latest state. */
hawser_status integrator_new(Motion *motion, double t, double *y, Integrator **out, hawser_error *err);
Integrator *integrator_free(Integrator *in);
/* Takes one step, but not beyond `stop` (s). On failure y and *t hold the last good step and err says when, where
 * and what to try (HAWSER_ERR_RUN). */
hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err);
void integrator_stats(const Integrator *in, IntegratorStats *stats);

#endif
