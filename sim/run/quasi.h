/* A run that is moved by positions in steady motion wherever that may be, and by its equations of motion elsewhere:
 * when it changes from one to the other, how far apart positions are, and rows between them.
 * docs/model/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_H
#define HAWSER_SIM_RUN_QUASI_H

#include "sim/run/parts.h"

/* Errors: as quasi_new. quasi_run_free may follow. */
hawser_status quasi_run_new(Sim *s, hawser_error *err);
void quasi_run_free(QuasiRun *q);
/* A step of the equations of motion has ended: positions may go on from here. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_begin(Sim *s, hawser_error *err);
/* Moves on by positions, to the next one or to t (s) if that is before it; *arrived: it is one. They may end here: then
 * the equations of motion go on from a time that is not beyond t. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_move(Sim *s, double t, int *arrived, hawser_error *err);
/* Equations of motion from now on. Nothing is done where they move already. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_end(Sim *s, hawser_error *err);
/* By how much roller r's largest load, `peak` (N), may be too small for what lies between positions, N (QS10), (QS11).
 */
double quasi_peak_error(const QuasiRun *q, int r, double peak);
/* Before and after the stage's own. Errors: MEMORY. */
void quasi_checkpoint_before(Checkpoint *c, Sim *s);
hawser_status quasi_checkpoint(Checkpoint *c, Sim *s, hawser_error *err);

#endif
