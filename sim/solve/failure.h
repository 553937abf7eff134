/* What to say of a step that failed: when, how long it was, where it was worst, what to try. */
#ifndef HAWSER_SIM_SOLVE_FAILURE_H
#define HAWSER_SIM_SOLVE_FAILURE_H

#include "sim/solve/motion.h"

/* Where integration stands as a step fails. */
typedef struct StepFailure {
    const Motion *motion;
    const double *y; /* [motion->size] the latest state, from which the step did not come further; read as it is told,
                        so that it may still be put back after this was filled in */
    double t, step;  /* s; the length of the step that was to come */
    int segment;     /* whose error is largest, of those that are simulated (of all chains) */
    const char *method, *complaint; /* who integrates, and what it said */
} StepFailure;

/* A step that could not be made; flag: CVODE's, or the one that stands for the same with another method. What may help
 * follows from the flag: Newton's iteration that does not converge, an error that stays too large, a matrix without
 * factors, forces that are not finite, steps that do not change t any more. Where it was worst, and what is there, may
 * say more:
 * - the head of a limp cable does not keep its direction on an axial grip;
 * - a limp cable that lies on a roller over more than two segments has no nearest point there (C6).
 * Returns RUN. */
hawser_status failure_tell(const StepFailure *f, int flag, hawser_error *err);

/* solver.max_steps are used up. Returns RUN. */
hawser_status failure_steps_spent(const StepFailure *f, hawser_error *err);

/* Both say with error_moment when and at which segment of its whole chain it was. */

#endif
