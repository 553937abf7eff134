/* A run that moves by positions in steady motion where possible, and by its equations of motion elsewhere: the changes
 * between both, the distance of positions, and the rows between them. docs/theory/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_H
#define HAWSER_SIM_RUN_QUASI_H

#include "sim/run/parts.h"

/* Errors: as quasi_new. quasi_run_free may follow. */
hawser_status quasi_run_new(Sim *s, hawser_error *err);
void quasi_run_free(QuasiRun *q);
/* Checks, after a step of the equations of motion, whether positions can take over, and begins them. Errors: MEMORY,
 * RUN, STOPPED. */
hawser_status quasi_begin(Sim *s, hawser_error *err);
/* Moves on by positions, to the next one or to t (s) if that comes first; *arrived: it is a position. Positions may end
 * here: then the equations of motion continue from a time that is not beyond t. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_move(Sim *s, double t, int *arrived, hawser_error *err);
/* Returns to the equations of motion. Does nothing if they are active already. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_end(Sim *s, hawser_error *err);
/* Amount by which roller r's largest load, `peak` (N), may be too small because of peaks between positions, N (QS10),
 * (QS11). */
double quasi_peak_error(const QuasiRun *q, int r, double peak);
/* Called before and after the stage's own. Errors: MEMORY. */
void quasi_checkpoint_before(Checkpoint *c, Sim *s);
hawser_status quasi_checkpoint(Checkpoint *c, Sim *s, hawser_error *err);

#endif
