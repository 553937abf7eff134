/* results.h5: the sampled states, one row a state, readable while the run goes on. docs/results.md lists what
 * is in it. HDF5 stays silent: what goes wrong comes back as a status. */
#ifndef HAWSER_IO_RESULTS_RESULTS_H5_H
#define HAWSER_IO_RESULTS_RESULTS_H5_H

#include "io/results/results_def.h"

typedef struct H5File H5File;

/* Creates dir/results.h5 with everything that does not change. Errors: OUTPUT, MEMORY. */
hawser_status h5_open(H5File **out, const char *dir, const ResultsDef *def, hawser_error *err);
/* Adds one state. Errors: OUTPUT; the states before it stay readable. */
hawser_status h5_append(H5File *h, const hawser_sample *sample, hawser_error *err);
/* After this, readers see every state. Errors: OUTPUT. */
hawser_status h5_flush(H5File *h, hawser_error *err);
/* Closes *file and sets it to NULL (NULL is fine). Errors: OUTPUT. */
hawser_status h5_close(H5File **file, hawser_error *err);

#endif
