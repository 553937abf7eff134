/* A results folder, written while the run goes on: series.csv, results.h5 and results.xdmf grow; stations.csv,
 * rollers.csv and summary.json are filled at the end (until then summary.json has "running"). Memory stays constant.
 * docs/reference/results.md describes every file. */
#ifndef HAWSER_IO_RESULTS_RESULTS_H
#define HAWSER_IO_RESULTS_RESULTS_H

#include "io/results/results_def.h"
#include "io/results/results_file.h"

typedef struct Results Results;

/* Results at the end; borrowed. */
typedef struct ResultsTables {
    int n_stations;
    const hawser_station *station; /* [n_stations] */
    int n_rollers;
    const hawser_roller *roller; /* [n_rollers] */
    int n_modes, segments;
    const hawser_mode *mode;  /* [n_modes], for `segments` segments; none: no modes.csv */
    const Envelope *envelope; /* NULL: none */
    int n_places;
    const hawser_place *place;   /* [n_places]; none: no positions.csv */
    const double *place_station; /* [n_places][n_stations] N */
} ResultsTables;

/* Opens all files of a folder, so that a problem shows before anything is computed: of `home`, which its caller has
 * taken (out_take) and keeps; or of the folder `name` within it, or of that path where home is NULL, which is made and
 * taken. `summary`: summary.json until the end. Errors: OUTPUT, MEMORY. */
hawser_status results_open(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                           const char *summary, hawser_error *err);
/* Length of the growing files when a checkpoint was made. */
typedef struct ResultsPosition {
    long series, xdmf; /* bytes */
    long states;
} ResultsPosition;
/* Brings everything to the disk and returns its length, from which a resumed run continues. Errors: OUTPUT. */
hawser_status results_position(Results *r, ResultsPosition *position, hawser_error *err);
/* Opens the folder of such a run, and cuts its files to that length. Arguments and errors as results_open. */
hawser_status results_resume(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                             const ResultsPosition *position, const char *summary, hawser_error *err);
/* Writes CHECKPOINT_FILE of the folder, complete and on the disk, in place of the one before; or removes it. Errors:
 * OUTPUT, MEMORY. */
#define CHECKPOINT_FILE "checkpoint.hawser"
hawser_status results_checkpoint(const OutDir *dir, const void *bytes, size_t size, hawser_error *err);
void results_no_checkpoint(const OutDir *dir);
/* Writes a row of series.csv. Errors: OUTPUT. */
hawser_status results_row(Results *r, const hawser_sample *sample, hawser_error *err);
/* Writes a state of results.h5, if states are requested. Errors: OUTPUT. */
hawser_status results_state(Results *r, const hawser_sample *sample, hawser_error *err);
/* Updates the files for their readers if the last update was half a second ago or more. Errors: OUTPUT. */
hawser_status results_tick(Results *r, hawser_error *err);
/* Writes the tables and closes everything; tries every file, and returns the first error. Only the summary may follow.
 * Errors: OUTPUT. */
hawser_status results_finish(Results *r, const ResultsTables *tables, hawser_error *err);
/* Writes the final summary.json, complete, or leaves the one before; all files are on the disk then. whole: the run has
 * finished, and the results of an earlier run in the folder "earlier" are removed. Errors: OUTPUT, MEMORY. */
hawser_status results_summary(Results *r, const char *summary, int whole, hawser_error *err);
const OutDir *results_dir(const Results *r);
Results *results_free(Results *r);

/* Checks that a run in a folder would write, move or remove none of these files. Errors: INPUT that names it. */
hawser_status results_spare(const char *dir, const FileMarks *files, hawser_error *err);

/* For folders of finished runs. results_again writes the tables again, without the summary, which follows, and removes
 * files derived from them; results_replace puts the results of `from`, a folder within the folder `to`, of the same
 * case, in place of those of `to` (files that were moved already are accepted); results_remove removes `from` with all
 * files of a run. Errors: OUTPUT, MEMORY. */
hawser_status results_again(const OutDir *dir, const ResultsTables *tables, hawser_error *err);
hawser_status results_replace(const OutDir *to, const char *from, hawser_error *err);
void results_remove(const OutDir *dir, const char *from);

#endif
