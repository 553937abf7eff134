/* The equations of motion in time: by CVODE (BDF), or by one-step methods (sim/step/esdirk.h). This, with
 * sim/step/sundials.h, contact_newton.h and failure.h, is all that knows SUNDIALS. docs/model.md, "Integration" and
 * "One-step integration". */
#ifndef HAWSER_SIM_STEP_INTEGRATOR_H
#define HAWSER_SIM_STEP_INTEGRATOR_H

#include "sim/step/motion.h"

typedef struct Integrator Integrator;

/* Starts at (t, y). The motion and y [motion->size] are borrowed; y always holds the latest state. Errors: MEMORY, RUN
 * (a SUNDIALS that integrator_reshape could not live with). */
hawser_status integrator_new(Motion *motion, double t, double *y, Integrator **out, hawser_error *err);
Integrator *integrator_free(Integrator *in);
/* Takes one step, but not beyond `stop` (s). On failure y and *t hold the last good step and err says when, where
 * and what to try (HAWSER_ERR_RUN). */
hawser_status integrator_step(Integrator *in, double stop, double *t, hawser_error *err);
/* No step is longer than that from now on, s; 0: than the case lets it be. */
void integrator_bound(Integrator *in, double longest);

/* Goes on from the same time with the motion's new size: the history of the method is mapped like the state (RL17), so
 * that order and step stay, and Newton's matrix is made anew at once. Public calls of SUNDIALS suffice: all vectors
 * that CVODE works with are clones of ours, which change their length where they stand, and CVodeGetNonlinearSystemData
 * tells which of them is the history's state. Motion->size is the new one already. Errors: MEMORY (the integrator can
 * only be freed then), RUN. */
hawser_status integrator_reshape(Integrator *in, double t, const Reshape *reshape, hawser_error *err);
/* The same time and motion in other equations: starts anew at (t, y) and goes on counting. Errors: as integrator_new;
 * *in is as it was then. */
hawser_status integrator_renew(Integrator **in, Motion *motion, double t, double *y, hawser_error *err);
/* The rates of the state of the last accepted step, [size], as the method has them: times *h, s: the step's length with
 * BDF, 1 with others. They are those of the collocation or of the last stage, which the equations of motion meet to
 * within Newton's tolerance. Valid until the next step. */
const double *integrator_rates(Integrator *in, double *h);
/* Goes on counting where another one has stopped. Nothing has been stepped yet. */
void integrator_go_on(Integrator *in, const IntegratorStats *so_far);
void integrator_stats(const Integrator *in, IntegratorStats *stats);
/* The segment whose weighted local error is largest, of those simulated. Takes memory for a state. */
int integrator_worst(Integrator *in);

/* Gets one ready to be read from a checkpoint: a fresh one is set up by its first step, which is made from t with all
 * rates zero and moves y by rounding alone. Errors: RUN (a SUNDIALS whose state is not known). */
hawser_status integrator_prepare(Integrator *in, double t, hawser_error *err);
/* Whether its state can be saved; *why says why not. */
int integrator_known(const Integrator *in, const char **why);
/* Steps, orders and history; y, the workspace and the motion's own are not its. */
void integrator_checkpoint(Checkpoint *c, Integrator *in);

#endif
