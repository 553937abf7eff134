/* A run that is moved by positions in steady motion wherever that may be, and by its equations of motion elsewhere:
 * when it changes from one to the other, how far apart positions are, and rows between them.
 * docs/model/45-quasi-static.md. */
#ifndef HAWSER_SIM_RUN_QUASI_RUN_H
#define HAWSER_SIM_RUN_QUASI_RUN_H

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

/* The books of energy at the first position of a stretch, where the state is put there, and at each of the others, once
 * the stage has come to it (QS13). Errors: MEMORY. */
hawser_status quasi_books_begin(Sim *s, hawser_error *err);
hawser_status quasi_books_position(Sim *s, hawser_error *err);

/* Finds the position of time t, where the stage is then. Errors: as positions_advance. */
hawser_status quasi_find(Sim *s, double t, hawser_relaxation *found, hawser_error *err);
/* Where peaks may be. Errors: MEMORY. */
hawser_status quasi_peaks_new(QuasiRun *q, const SceneDef *def, hawser_error *err);
/* A position is looked at: where its front is. */
void quasi_peaks_seen(QuasiRun *q, const Scene *scene, const hawser_sample *look);
/* Peaks of rollers' loads between the last two positions, (QS9): found as positions of their own, which count for
 * nothing else. Errors: MEMORY, RUN, STOPPED. */
hawser_status quasi_peaks(Sim *s, hawser_error *err);

/* By how much roller r's largest load, `peak` (N), may be too small for what lies between positions, N (QS10), (QS11).
 */
double quasi_peak_error(const QuasiRun *q, int r, double peak);

/* Before and after the stage's own. Errors: MEMORY. */
void quasi_checkpoint_before(Checkpoint *c, Sim *s);
hawser_status quasi_checkpoint(Checkpoint *c, Sim *s, hawser_error *err);

#endif
