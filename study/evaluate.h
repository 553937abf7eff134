/* The engine: samples on worker processes, each row appended whole to its worker's file, so that a study that was
 * killed continues without repeating anything. docs/guide/studies-and-measured-pulls.md. */
#ifndef HAWSER_STUDY_EVALUATE_H
#define HAWSER_STUDY_EVALUATE_H

#include <stdint.h>

#include "hawser/hawser.h"
#include "io/results/results_file.h"
#include "study/maths.h"
#include "study/plan.h"

/* Result of a sample. */
typedef enum RowState { ROW_OPEN, ROW_DONE, ROW_REFUSED, ROW_FAILED, ROW_TIME, ROW_MEMORY, ROW_DIED } RowState;

/* Verdict of its answer. */
typedef enum RowVerdict {
    VERDICT_NONE,
    VERDICT_SAFE = HAWSER_SAFE + 1,
    VERDICT_NOT_SAFE = HAWSER_NOT_SAFE + 1,
    VERDICT_NOT_JUDGED = HAWSER_NOT_JUDGED + 1,
    VERDICT_NOT_TRUSTED = HAWSER_NOT_TRUSTED + 1,
    VERDICT_SAFE_ONLY_IF = HAWSER_SAFE_ONLY_IF + 1,
    VERDICTS
} RowVerdict;

/* Texts in the order of the enumerations. */
extern const char *const row_states[];

const char *row_verdict(int verdict);
enum { REASON_MAX = 200 };

/* One sample. The file contains this struct, then its quantities, then a checksum; it is read on the same kind of
 * machine. */
typedef struct Row {
    int64_t sample;
    int32_t state, verdict; /* a RowState, RowVerdict of the last answer */
    int32_t answered;       /* BY_THEORY or BY_RUN: the last answer */
    int32_t theory_verdict; /* of theory, if it was computed */
    int32_t limited_by;     /* the hawser_limit_kind with the least margin; -1: none was judged */
    int32_t pad;
    double margin[LIMIT_KINDS]; /* of the last answer; NAN: not judged */
    double seconds;             /* of processor time */
    double theory[LIMIT_KINDS]; /* margins of theory if a trusted run has answered too; else NAN */
    char reason[REASON_MAX];    /* reason for a missing answer, or "" */
} Row;

/* All rows of a study, by sample. */
typedef struct Rows {
    long n;
    int width;     /* values of a row: quantities, and for a study that searches the point */
    Row *row;      /* [n]; ROW_OPEN: not computed yet */
    double *value; /* [n * width]; NAN: unknown */
} Rows;

/* Initialises all rows as ROW_OPEN. Errors: MEMORY. */
hawser_status rows_make(const Study *s, Rows *rows, hawser_error *err);
void rows_free(Rows *rows);
/* Number of values of a row. */
int row_width(const Study *s);
/* Copies the point x[n_parameters] of a row that is there. */
void row_point(const Study *s, const Rows *rows, long i, double *x);
/* Winch force of a run by the place of the cable's head. */
typedef struct CurvePoint {
    double at, force, area; /* m along the route; N; N m: its integral from the first point on */
} CurvePoint;

typedef struct RunCurve {
    double time; /* s, of the last step */
    int n, room;
    CurvePoint *point; /* [n] by rising place */
} RunCurve;

/* Computes sample i at its point x[n_parameters]: fills row and value[row_width]. Failures are recorded in the row. */
void sample_evaluate(const Study *s, long i, const double *x, Row *row, double *value);
/* Checks that the quantities exist in the answers to the middle of all parameters, as far as possible without a run.
 * Errors: INPUT with file and line, MEMORY. */
hawser_status quantities_check(const Study *s, hawser_error *err);
/* ------------------------------------------------------------------------------------------------- workers' files */

/* Computes a number that two studies share if their rows are the same: from their contents, and the contents of every
 * file that the base case or a variant names. also: a further text that counts, or NULL. Errors: MEMORY. */
hawser_status study_identity(const Study *s, const char *also, uint64_t *out, hawser_error *err);
/* Opens dir/workers, which must not be a link; out_leave must follow. Errors: OUTPUT, with errno. */
hawser_status workers_enter(OutDir *workers, const char *dir, hawser_error *err);
/* Reads every whole row in dir/workers into `rows`, if they belong to this study; changes no file, so that others may
 * append meanwhile. A folder without rows is accepted. Errors: INPUT (rows of another study), OUTPUT, MEMORY. */
hawser_status store_read(const Study *s, const char *dir, Rows *rows, hawser_error *err);
/* Creates dir/workers and records its study; `fresh`: removes existing rows. Errors: OUTPUT, MEMORY. */
hawser_status store_begin(const Study *s, const char *dir, int fresh, hawser_error *err);
/* Checks that the study does not overwrite a file in the folder that it reads. Errors: INPUT that names it. */
hawser_status store_spare(const Study *s, const char *dir, hawser_error *err);
/* Finds the study whose rows are in a folder: its file, path[OUT_PATH_MAX]. Errors: INPUT (there is none). */
hawser_status store_study(const char *dir, char path[], hawser_error *err);
/* A crew is the workers of one engine; its name is the prefix of their files. */
enum { CREW_MAX = 40, STORE_NAME_MAX = 40 };

/* Builds the path of worker k's file, path[OUT_PATH_MAX]. Errors: OUTPUT (too long). */
hawser_status store_path(char path[], const char *dir, const char *crew, int k, hawser_error *err);
/* Opens it for appending; returns < 0 with errno on failure. */
int store_open(const char *dir, const char *crew, int k);
/* Appends a row in one write; returns 0 or errno. */
int store_append(int fd, const Row *row, const double *value, int width);
/* Cuts off a row that its worker did not finish writing, before another is appended; returns 0 or errno. */
int store_mend(int fd, int width);
/* Checks whether the last row of a mended file is this sample's; *number: 0, or errno of a file that cannot be read. */
int store_ends_with(int fd, int width, long sample, int *number);
/* Takes worker k's rows, including those written since the folder was read. Errors: OUTPUT. */
hawser_status store_take(const char *dir, const char *crew, int k, Rows *rows, hawser_error *err);
/* Builds a unique name for the study in this folder; dir as realpath returns it. Errors: MEMORY. */
hawser_status store_name(const Study *s, const char *dir, char name[STORE_NAME_MAX], hawser_error *err);
/* --------------------------------------------------------------------------------------------------------- searches */

/* Objective of a row that is there, and by how much each constraint is broken, as a share of its bound,
 * broken[aim_constraints], not above 0 if it is kept. NAN: the row has no value. */
int aim_constraints(const Study *s);
double aim_value(const Study *s, const Row *row, const double *value, const double *x, double *broken);
/* Computes a sample for a search: fills row and value. Returns 0 to end the search. */
typedef int (*SampleAsk)(void *user, long i, const double *x, Row *row, double *value);

/* Runs search c from its beginning. Samples in `known` are reused. *other: `known` turned out to belong to another
 * search. Returns 0 without memory. */
int search_samples(const Study *s, long c, const Rows *known, SampleAsk ask, void *user, int *other);
/* Runs the fit of a calibration likewise; ask NULL: as far as `known` goes. With both fidelities the first half of the
 * samples is theory's fit, and the second that of runs, which begins where theory's ended. */
int fit_samples(const Study *s, const Rows *known, SampleAsk ask, void *user, int *other, FitResult *result);
/* --------------------------------------------------------------------------------------------------------- workers */

/* (ES3): computes for each limit the band about 0 within which theory is not relied on, from the available pilots;
 * beyond 1e3 theory is never relied on. */
void pilots_bands(const Study *s, const Rows *rows, double band[LIMIT_KINDS]);
/* Units of computation: samples, or whole searches for a study that searches. */
typedef struct Units {
    long n, *unit;             /* [n], owned; rising; NULL: unit k is k */
    hawser_study_state before; /* results that already exist for the others */
} Units;

/* Finds the open units by `rows`, with `pilots` only those of the pilots. Errors: MEMORY. */
hawser_status units_open(const Study *s, int pilots, const Rows *rows, Units *open, hawser_error *err);
/* Source of the units of one engine, if several engines share them; called once per check of its workers. */
typedef enum Fed { FED_NOT_YET, FED_MORE, FED_NO_MORE, FED_STOP } Fed;

typedef struct Feed {
    /* `empty`: the workers have taken all units. MORE: units from .. to-1 of the list are added. `state` is this
     * engine's, and may be extended to that of all. */
    Fed (*more)(void *user, int empty, hawser_study_state *state, long *from, long *to);
    void *user;
} Feed;

/* Computes units on options->jobs processes, which write the crew's files; feed NULL: all of them. `rows` are those of
 * earlier starts, for searches, or NULL. *efficiency: time in samples over wall time and workers; NAN if there were
 * none. Errors: OUTPUT, MEMORY, STOPPED; rows that were written are in the files in any case. */
hawser_status engine_run(const Study *s, const char *dir, const char *crew, const hawser_study_options *options,
                         const Units *units, const Feed *feed, Rows *rows, double *efficiency, hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- clusters */

/* Computes units as a Slurm array, and repeats for units still open after it until none is. `rows` has the rows of
 * earlier starts, and is updated. Errors: INPUT (no Slurm), OUTPUT, MEMORY, STOPPED. */
hawser_status slurm_run(const Study *s, const char *dir, const hawser_study_options *options,
                        const hawser_study_cluster *cluster, int pilots, Rows *rows, hawser_error *err);
/* Checks that no array of the study in this folder is running. Errors: INPUT if one is. */
hawser_status slurm_idle(const Study *s, const char *dir, hawser_error *err);
/* Computes one task of the array that slurm_run has submitted. Errors: INPUT, OUTPUT, MEMORY, STOPPED. */
hawser_status slurm_task(Study *s, const char *dir, int task, const hawser_study_options *options, hawser_error *err);
/* Computes open units on all ranks; each of them calls it. `rows`: on rank 0 those of earlier starts, to which new ones
 * are added; on the others those of rows_make, unchanged. Errors: of any rank, with its text on that rank. */
hawser_status ranks_run(Study *s, const char *dir, const hawser_study_options *options, const hawser_ranks *ranks,
                        int pilots, Rows *rows, double *efficiency, hawser_error *err);
/* Distributes rank 0's status, if it is not OK, to the others. */
hawser_status ranks_agree(const hawser_ranks *ranks, hawser_status status, hawser_error *err);
/* A hash of a study's input and output: FNV-1a, 64 bits. */
typedef uint64_t Hash;

static const Hash HASH_BEGIN = 14695981039346656037u;

/* Returns h extended by these bytes. */
static inline Hash hash_bytes(Hash h, const void *from, size_t size)
{
    for (const unsigned char *p = from, *end = p + size; p < end; p++) h = (h ^ *p) * 1099511628211u;
    return h;
}

#endif
