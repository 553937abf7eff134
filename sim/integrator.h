/* CVODE (BDF) on the chain: the only file, with its .c, that knows SUNDIALS. docs/model.md, "Integration". */
#ifndef HAWSER_SIM_INTEGRATOR_H
#define HAWSER_SIM_INTEGRATOR_H

#include "sim/dynamics.h"
#include "sim/newton.h"

typedef struct Integrator Integrator;

typedef struct IntegratorStats {
    long steps, rhs_evals, newton_iters, jac_evals, lin_setups, error_fails, newton_fails;
    double rhs, contacts, jacobian, factor, solve, total; /* s */
    double last_step;                                     /* s */
} IntegratorStats;

/* Starts at (t, y). Scene, workspace, Newton matrix and y [13 n] are borrowed; y always holds the latest state. */
hawser_status integrator_new(const Scene *scene, Workspace *ws, Newton *newton, double t, double *y, Integrator **out,
                             hawser_error *err);
Integrator *integrator_free(Integrator *in);
/* Takes one step, but not beyond `stop` (s). On failure y and *t hold the last good step and err says when, where
 * and what to try (HAWSER_ERR_RUN). */
hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err);
void integrator_stats(const Integrator *in, IntegratorStats *stats);

#endif
