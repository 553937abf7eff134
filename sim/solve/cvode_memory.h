/* What CVODE remembers from step to step: order, step sizes, coefficients, counters, and which of its vectors are its
 * history. It offers no call for that, and its structures are not public: which bytes of them matter is listed here by
 * place and length, for the versions in which they lie so. Whether they do is asked, wherever that list is used, of
 * everything that CVODE says of itself. docs/formats.md, "The integrator". */
#ifndef HAWSER_SIM_SOLVE_CVODE_MEMORY_H
#define HAWSER_SIM_SOLVE_CVODE_MEMORY_H

#include <sundials/sundials_nvector.h>

#include "core/checkpoint.h"
#include "sim/solve/motion.h"

enum { CVODE_HISTORY_MAX = 13 };

/* Whether the list holds for this CVODE; *why (may be NULL) says what does not. */
int cvode_memory_known(void *cvode, const char **why);
/* What CVODE has counted since it was started anew: steps, evaluations, iterations, set-ups and failures alone. */
void cvode_counts(void *cvode, IntegratorStats *stats);
/* Whether counts that have been read can be counted on with. */
void counts_check(Checkpoint *c, const IntegratorStats *counts);
/* All but vectors. CVODE must have made a step: its first one sets it up. */
void cvode_memory_checkpoint(Checkpoint *c, void *cvode);
/* Those vectors of the history that the next step reads; returns how many. */
int cvode_memory_history(void *cvode, N_Vector history[CVODE_HISTORY_MAX]);

#endif
