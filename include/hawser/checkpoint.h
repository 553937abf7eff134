/* A simulation's whole state, kept and gone on from; part of hawser/hawser.h, which includes it. What follows is, bit
 * for bit, what would have followed without it. docs/formats.md. */
#ifndef HAWSER_CHECKPOINT_H
#define HAWSER_CHECKPOINT_H

#include <stddef.h>

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the state of now to a file: beside its name first, and to the disk, so that what has the name is whole at any
 * time. Between two calls of hawser_sim_advance, at any time. Errors: OUTPUT, MEMORY; RUN with a SUNDIALS whose
 * integrator cannot be saved. */
hawser_status hawser_sim_save(hawser_sim *s, const char *path, hawser_error *err);
/* The state of such a file takes the place of that of now, in a simulation of the same case (built by the same program,
 * with the same settings; the number of threads does not matter). Errors: INPUT (no checkpoint, a damaged one, of
 * another case or another version: nothing has changed then), MEMORY, RUN (the simulation can only be freed then). */
hawser_status hawser_sim_load(hawser_sim *s, const char *path, hawser_error *err);

/* The same with memory; *bytes [*size] is malloc'ed: free it with hawser_bytes_free. Errors: as above. */
hawser_status hawser_sim_save_memory(hawser_sim *s, void **bytes, size_t *size, hawser_error *err);
hawser_status hawser_sim_load_memory(hawser_sim *s, const void *bytes, size_t size, hawser_error *err);
void hawser_bytes_free(void *bytes);

/* The case of the run whose checkpoint is in the results folder `dir`, with all its settings; files that it includes
 * are read where they were. Errors: INPUT (no checkpoint there, a damaged one), MEMORY. */
hawser_status hawser_case_resume(const char *dir, hawser_case **out, hawser_error *err);
/* Goes on with that run, in a simulation built of that case, as hawser_sim_run would have gone on. Errors: as
 * hawser_sim_run; INPUT as hawser_sim_load. */
hawser_status hawser_sim_resume(hawser_sim *s, const char *dir, hawser_progress progress, void *user,
                                hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
