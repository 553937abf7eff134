/* A results folder, written while the run goes on: series.csv, results.h5 and results.xdmf grow;
 * stations.csv, rollers.csv and summary.json are filled at the end (until then summary.json says "running").
 * Memory stays constant. docs/reference/results.md describes every file. */
#ifndef HAWSER_IO_RESULTS_RESULTS_H
#define HAWSER_IO_RESULTS_RESULTS_H

#include "io/results/results_def.h"
#include "io/results/results_file.h"

typedef struct Results Results;

/* What is known at the end; borrowed. */
typedef struct ResultsTables {
    int n_stations;
    const hawser_station *station; /* [n_stations] */
    int n_rollers;
    const hawser_roller *roller; /* [n_rollers] */
    int n_modes, segments;
    const hawser_mode *mode;  /* [n_modes], of `segments` segments; none: no modes.csv */
    const Envelope *envelope; /* NULL: none */
    int n_places;
    const hawser_place *place;   /* [n_places]; none: no positions.csv */
    const double *place_station; /* [n_places][n_stations] N */
} ResultsTables;

/* Opens all files of a folder, so that what cannot be written shows before anything is computed: of `home`, which its
 * caller has taken (out_take) and keeps; or of the folder `name` within it, or of that path where home is NULL, which
 * is made and taken. `summary`: summary.json until the end. Errors: OUTPUT, MEMORY. */
hawser_status results_open(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                           const char *summary, hawser_error *err);
/* How far the files that grow had come when a checkpoint was made. */
typedef struct ResultsPosition {
    long series, xdmf; /* bytes */
    long states;
} ResultsPosition;
/* Brings everything to the disk and says how far that is: a run that is resumed goes on from there. Errors: OUTPUT. */
hawser_status results_position(Results *r, ResultsPosition *position, hawser_error *err);
/* Opens the folder of such a run: what its files have beyond that is taken away. Arguments and errors as results_open.
 */
hawser_status results_resume(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                             const ResultsPosition *position, const char *summary, hawser_error *err);
/* CHECKPOINT_FILE of the folder, whole and on the disk, in place of the one before; or none any more. Errors: OUTPUT,
 * MEMORY. */
#define CHECKPOINT_FILE "checkpoint.hawser"
hawser_status results_checkpoint(const OutDir *dir, const void *bytes, size_t size, hawser_error *err);
void results_no_checkpoint(const OutDir *dir);
/* A row of series.csv. Errors: OUTPUT. */
hawser_status results_row(Results *r, const hawser_sample *sample, hawser_error *err);
/* A state of results.h5; nothing if no states are wanted. Errors: OUTPUT. */
hawser_status results_state(Results *r, const hawser_sample *sample, hawser_error *err);
/* Brings the files up to date for their readers if the last time was a while ago (half a second). Errors:
 * OUTPUT. */
hawser_status results_tick(Results *r, hawser_error *err);
/* Writes the tables and closes everything; what can still be written is, and the first error is returned.
 * Only the summary may follow. Errors: OUTPUT. */
hawser_status results_finish(Results *r, const ResultsTables *tables, hawser_error *err);
/* summary.json for good: whole, or what stood there before; all files are on the disk then. whole: the run ended as it
 * should, and results of a run before, which wait in the folder "earlier", are not needed any more. Errors: OUTPUT,
 * MEMORY. */
hawser_status results_summary(Results *r, const char *summary, int whole, hawser_error *err);
const OutDir *results_dir(const Results *r);
Results *results_free(Results *r);

/* Whether nothing that a run writes, moves or takes away in a folder is one of these files. Errors: INPUT that names
 * it. */
hawser_status results_spare(const char *dir, const FileMarks *files, hawser_error *err);

/* Of folders whose runs are over. The tables once more, without the summary, which is to follow, and what had been made
 * of them; the results of `from`, a folder within the folder `to`, of the same case, in the place of those of `to`
 * (what has been moved already is there); `from` with all that a run leaves away. Errors: OUTPUT, MEMORY. */
hawser_status results_again(const OutDir *dir, const ResultsTables *tables, hawser_error *err);
hawser_status results_replace(const OutDir *to, const char *from, hawser_error *err);
void results_remove(const OutDir *dir, const char *from);

#endif
