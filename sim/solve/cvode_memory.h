/* State that CVODE keeps from step to step: order, step sizes, coefficients, counters, and which of its vectors are its
 * history. It offers no call for that, and its structures are not public: the relevant bytes are listed here by offset
 * and length, for the versions with this layout. Wherever the list is used, the layout is checked against everything
 * that CVODE reports about itself. docs/formats.md, "The checkpoint". */
#ifndef HAWSER_SIM_SOLVE_CVODE_MEMORY_H
#define HAWSER_SIM_SOLVE_CVODE_MEMORY_H

#include <sundials/sundials_nvector.h>

#include "core/checkpoint.h"
#include "sim/solve/motion.h"

enum { CVODE_HISTORY_MAX = 13 };

/* Checks whether the list is valid for this CVODE; *why (may be NULL) names what differs. */
int cvode_memory_known(void *cvode, const char **why);
/* CVODE's counts since it was last restarted: steps, evaluations, iterations, set-ups and failures only. */
void cvode_counts(void *cvode, IntegratorStats *stats);
/* Checks whether loaded counts are valid to continue with. */
void counts_check(Checkpoint *c, const IntegratorStats *counts);
/* Saves or loads everything but vectors. CVODE must have made a step: its first one sets it up. */
void cvode_memory_checkpoint(Checkpoint *c, void *cvode);
/* Writes those vectors of the history that the next step reads; returns their number. */
int cvode_memory_history(void *cvode, N_Vector history[CVODE_HISTORY_MAX]);

#endif
