/* Error messages of failed steps: time, length, place of the largest error, remedies. */
#ifndef HAWSER_SIM_SOLVE_FAILURE_H
#define HAWSER_SIM_SOLVE_FAILURE_H

#include "sim/solve/motion.h"

/* State of the integration as a step fails. */
typedef struct StepFailure {
    const Motion *motion;
    const double *y; /* [motion->size] the latest state, beyond which the step did not get; read when the message is
                      * made, so that it may still be restored after this was filled in */
    double t, step;  /* s; length of the failed step */
    int segment;     /* with the largest error, among those simulated (of all chains) */
    const char *method, *complaint; /* name of the method, and its message */
} StepFailure;

/* Reports a step that could not be made; flag: CVODE's, or its equivalent of another method. The remedy follows from
 * the flag: Newton's iteration that does not converge, an error that stays too large, a matrix without factors, forces
 * that are not finite, steps that do not change t any more. The place of the largest error may add:
 *    - the head of a limp cable does not keep its direction on an axial grip;
 *    - a limp cable in contact with a roller over more than two segments has no nearest point there (C6).
 *
 * Returns RUN. */
hawser_status failure_tell(const StepFailure *f, int flag, hawser_error *err);

/* Reports that solver.max_steps are used up. Returns RUN. */
hawser_status failure_steps_spent(const StepFailure *f, hawser_error *err);

/* Both give the time and the segment of its whole chain by error_moment. */

#endif
