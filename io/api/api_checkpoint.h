/* Checkpoints as files, for the calls that run a case. */
#ifndef HAWSER_IO_API_API_CHECKPOINT_H
#define HAWSER_IO_API_API_CHECKPOINT_H

#include "core/base/checkpoint.h"
#include "io/api/api_handles.h"

/* How far a run with results has come, beside its simulation; plain numbers. */
typedef struct RunKept {
    long rows, states;           /* beats so far */
    double last_row, last_state; /* s */
    ResultsPosition files;
} RunKept;

/* The state of now, with run's (NULL: there is none), as the bytes of a file; checkpoint_free follows either way.
 * Errors: MEMORY, RUN. */
hawser_status checkpoint_write(hawser_sim *s, RunKept *run, Checkpoint *c, hawser_error *err);
/* The other way; `path` is for messages. run: NULL if the file need not have it. Errors: as hawser_sim_load. */
hawser_status checkpoint_read(hawser_sim *s, const char *path, const void *bytes, size_t size, RunKept *run,
                              hawser_error *err);
/* That of a results folder. */
hawser_status checkpoint_read_dir(hawser_sim *s, const char *dir, RunKept *run, hawser_error *err);

#endif
