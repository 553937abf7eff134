/* Saves a simulation's whole state and resumes from it; part of hawser/hawser.h, which includes it. The resumed run is
 * bit for bit equal to the uninterrupted one. docs/guide/simulate.md. */
#ifndef HAWSER_CHECKPOINT_H
#define HAWSER_CHECKPOINT_H

#include <stddef.h>

#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

/* Writes the present state to a file. It is written beside the file, flushed to the disk and then renamed, so that the
 * file is complete at any time. May be called between any two calls of hawser_sim_advance. Errors: OUTPUT, MEMORY; RUN
 * with a SUNDIALS whose integrator cannot be saved. */
hawser_status hawser_sim_save(hawser_sim *s, const char *path, hawser_error *err);
/* Replaces the present state by that of such a file, in a simulation of the same case (built by the same program, with
 * the same settings; the number of threads does not matter). Errors: INPUT (no checkpoint, a damaged one, one of
 * another case or version: nothing has changed then), MEMORY, RUN (the simulation can only be freed then). */
hawser_status hawser_sim_load(hawser_sim *s, const char *path, hawser_error *err);

/* Do the same with memory; *bytes [*size] is malloc'ed: free it with hawser_bytes_free. Errors: as above. */
hawser_status hawser_sim_save_memory(hawser_sim *s, void **bytes, size_t *size, hawser_error *err);
hawser_status hawser_sim_load_memory(hawser_sim *s, const void *bytes, size_t size, hawser_error *err);
void hawser_bytes_free(void *bytes);

/* Loads the case of the run whose checkpoint is in the results folder `dir`, with all its settings; files that it
 * includes are read from where they were. Errors: INPUT (no checkpoint there, a damaged one), MEMORY. */
hawser_status hawser_case_resume(const char *dir, hawser_case **out, hawser_error *err);
/* Continues that run, in a simulation built from that case, as hawser_sim_run would have continued. Errors: as
 * hawser_sim_run; INPUT as hawser_sim_load. */
hawser_status hawser_sim_resume(hawser_sim *s, const char *dir, hawser_progress progress, void *user,
                                hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
