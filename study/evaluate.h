/* The engine: samples on worker processes, each row appended whole to its worker's file, so that a study that is killed
 * goes on where it was and repeats nothing. docs/guide/studies-and-measured-pulls.md. */
#ifndef HAWSER_STUDY_EVALUATE_H
#define HAWSER_STUDY_EVALUATE_H

#include <stdint.h>

#include "hawser/hawser.h"
#include "io/results/results_file.h"
#include "study/maths.h"
#include "study/plan.h"

/* How a sample ended. */
typedef enum RowState { ROW_OPEN, ROW_DONE, ROW_REFUSED, ROW_FAILED, ROW_TIME, ROW_MEMORY, ROW_DIED } RowState;

/* What its answer says. */
typedef enum RowVerdict {
    VERDICT_NONE,
    VERDICT_SAFE = HAWSER_SAFE + 1,
    VERDICT_NOT_SAFE = HAWSER_NOT_SAFE + 1,
    VERDICT_NOT_JUDGED = HAWSER_NOT_JUDGED + 1,
    VERDICT_NOT_TRUSTED = HAWSER_NOT_TRUSTED + 1,
    VERDICT_SAFE_ONLY_IF = HAWSER_SAFE_ONLY_IF + 1,
    VERDICTS
} RowVerdict;

/* The words for them, by the enumerations. */
extern const char *const row_states[];

const char *row_verdict(int verdict);
enum { REASON_MAX = 200 };

/* One sample. On disk it is this struct, then its quantities, then a check sum: the same machine reads it again. */
typedef struct Row {
    int64_t sample;
    int32_t state, verdict; /* a RowState, RowVerdict of the last answer */
    int32_t answered;       /* BY_THEORY or BY_RUN: the last answer */
    int32_t theory_verdict; /* of theory, where it was asked */
    int32_t limited_by;     /* the hawser_limit_kind with the least margin; -1: none was judged */
    int32_t pad;
    double margin[LIMIT_KINDS]; /* of the last answer; NAN: not judged */
    double seconds;             /* of processor time */
    double theory[LIMIT_KINDS]; /* margins of theory where a run has answered too and is trusted; else NAN */
    char reason[REASON_MAX];    /* why there is no answer, or "" */
} Row;

/* All rows of a study, by sample. */
typedef struct Rows {
    long n;
    int width;     /* values of a row: quantities, and of a study that searches the point */
    Row *row;      /* [n]; ROW_OPEN: not computed yet */
    double *value; /* [n * width]; NAN: not known */
} Rows;

/* ROW_OPEN everywhere. Errors: MEMORY. */
hawser_status rows_make(const Study *s, Rows *rows, hawser_error *err);
void rows_free(Rows *rows);
/* How many values a row has. */
int row_width(const Study *s);
/* The point x[n_parameters] of a row that is there. */
void row_point(const Study *s, const Rows *rows, long i, double *x);
/* A run's winch force by the place of the cable's head. */
typedef struct CurvePoint {
    double at, force, area; /* m along the route; N; N m: its integral from the first point on */
} CurvePoint;

typedef struct RunCurve {
    double time; /* s, of the last step */
    int n, room;
    CurvePoint *point; /* [n] by rising place */
} RunCurve;

/* Computes sample i at its point x[n_parameters]: fills row and value[row_width]. What goes wrong is in the row. */
void sample_evaluate(const Study *s, long i, const double *x, Row *row, double *value);
/* Whether the quantities are in the answers to the middle of all parameters, as far as that shows without a run.
 * Errors: INPUT with file and line, MEMORY. */
hawser_status quantities_check(const Study *s, hawser_error *err);
/* ------------------------------------------------------------------------------------------------- workers' files */

/* A number that two studies share if their rows are the same: by what they say, and by the contents of every file that
 * the base case or a variant names. also: a text that counts too, or NULL. Errors: MEMORY. */
hawser_status study_identity(const Study *s, const char *also, uint64_t *out, hawser_error *err);
/* dir/workers, which is no link; out_leave follows. Errors: OUTPUT, with errno. */
hawser_status workers_enter(OutDir *workers, const char *dir, hawser_error *err);
/* Reads every whole row that is in dir/workers into `rows`, if they are of this study; changes no file, so that others
 * may append meanwhile. A folder without such is fine. Errors: INPUT (they are of another study), OUTPUT, MEMORY.
 */
hawser_status store_read(const Study *s, const char *dir, Rows *rows, hawser_error *err);
/* Makes dir/workers and says whose it is; `fresh`: what is there is removed. Errors: OUTPUT, MEMORY. */
hawser_status store_begin(const Study *s, const char *dir, int fresh, hawser_error *err);
/* Whether nothing that a study writes into a folder is a file that it reads. Errors: INPUT that names it. */
hawser_status store_spare(const Study *s, const char *dir, hawser_error *err);
/* Which study's rows are in a folder: its file, path[OUT_PATH_MAX]. Errors: INPUT (there is none). */
hawser_status store_study(const char *dir, char path[], hawser_error *err);
/* A crew is the workers of one engine; its name begins those of its files. */
enum { CREW_MAX = 40, STORE_NAME_MAX = 40 };

/* Path of worker k's file, path[OUT_PATH_MAX]. Errors: OUTPUT (too long). */
hawser_status store_path(char path[], const char *dir, const char *crew, int k, hawser_error *err);
/* It, open to append to; < 0 with errno. */
int store_open(const char *dir, const char *crew, int k);
/* Appends a row in one write; 0 or errno. */
int store_append(int fd, const Row *row, const double *value, int width);
/* Cuts off a row that its worker did not finish writing, before another is appended; 0 or errno. */
int store_mend(int fd, int width);
/* Whether the last row of a file that is mended is this sample's; *number: 0, or errno of a file that cannot be read.
 */
int store_ends_with(int fd, int width, long sample, int *number);
/* Worker k's rows, with those that came since the folder was read. Errors: OUTPUT. */
hawser_status store_take(const char *dir, const char *crew, int k, Rows *rows, hawser_error *err);
/* A name for the study in this folder that no other has; dir as realpath has it. Errors: MEMORY. */
hawser_status store_name(const Study *s, const char *dir, char name[STORE_NAME_MAX], hawser_error *err);
/* --------------------------------------------------------------------------------------------------------- searches */

/* What a search makes of a row that is there: the value that is to be least, and by how much each constraint is broken,
 * as a share of its bound, broken[aim_constraints], not above 0 where it is kept. NAN: the row has no value. */
int aim_constraints(const Study *s);
double aim_value(const Study *s, const Row *row, const double *value, const double *x, double *broken);
/* The search that computes a sample of its own with this, and gets it back: fills row and value. Returns 0: enough. */
typedef int (*SampleAsk)(void *user, long i, const double *x, Row *row, double *value);

/* Search c, from its beginning. Samples that `known` has are not asked for again. Returns 0 without memory; what stands
 * in `known` may turn out to be another search's: *other. */
int search_samples(const Study *s, long c, const Rows *known, SampleAsk ask, void *user, int *other);
/* The fit of a calibration likewise; ask NULL: as far as `known` goes. With both fidelities the first half of the
 * samples is theory's fit, and the second that of runs, which begins where theory's has ended. */
int fit_samples(const Study *s, const Rows *known, SampleAsk ask, void *user, int *other, FitResult *result);
/* --------------------------------------------------------------------------------------------------------- workers */

/* (ES3): of each limit the band about 0 within which theory is not relied on, by the pilots that are there; beyond 1e3
 * nothing is. */
void pilots_bands(const Study *s, const Rows *rows, double band[LIMIT_KINDS]);
/* What is computed: samples one by one, or of a study that searches whole searches. */
typedef struct Units {
    long n, *unit;             /* [n], owned; rising; NULL: unit k is k */
    hawser_study_state before; /* what is there of the others */
} Units;

/* What is open by `rows`, with `pilots` of these samples alone. Errors: MEMORY. */
hawser_status units_open(const Study *s, int pilots, const Rows *rows, Units *open, hawser_error *err);
/* Where the units of one engine come from, where several share them; of each look at its workers one call. */
typedef enum Fed { FED_NOT_YET, FED_MORE, FED_NO_MORE, FED_STOP } Fed;

typedef struct Feed {
    /* `empty`: the workers have taken all that there was. MORE: units from .. to-1 of the list are theirs. `state` is
     * this engine's, and may be made that of all. */
    Fed (*more)(void *user, int empty, hawser_study_state *state, long *from, long *to);
    void *user;
} Feed;

/* Computes units on options->jobs processes, whose files are the crew's; feed NULL: all of them. `rows` are those of
 * earlier starts, for searches, or NULL. Errors: OUTPUT, MEMORY, STOPPED; rows that were written are in the files in
 * any case. *efficiency: time with samples over wall time and workers; NAN if there were none. */
hawser_status engine_run(const Study *s, const char *dir, const char *crew, const hawser_study_options *options,
                         const Units *units, const Feed *feed, Rows *rows, double *efficiency, hawser_error *err);
/* -------------------------------------------------------------------------------------------------------- clusters */

/* Computes units as a Slurm array, and again what is open after it: waits until nothing is. Rows of earlier starts in
 * `rows`, which follows what comes in. Errors: INPUT (no Slurm), OUTPUT, MEMORY, STOPPED. */
hawser_status slurm_run(const Study *s, const char *dir, const hawser_study_options *options,
                        const hawser_study_cluster *cluster, int pilots, Rows *rows, hawser_error *err);
/* Errors: INPUT if an array of the study in this folder is at work. */
hawser_status slurm_idle(const Study *s, const char *dir, hawser_error *err);
/* One task of the array that slurm_run has submitted. Errors: INPUT, OUTPUT, MEMORY, STOPPED. */
hawser_status slurm_task(Study *s, const char *dir, int task, const hawser_study_options *options, hawser_error *err);
/* Computes what is open on all ranks; each calls it. `rows`: on rank 0 those of earlier starts, and what is new; on the
 * others those of rows_make, untouched. Errors: of whichever rank had one, with its text where it was. */
hawser_status ranks_run(Study *s, const char *dir, const hawser_study_options *options, const hawser_ranks *ranks,
                        int pilots, Rows *rows, double *efficiency, hawser_error *err);
/* Rank 0's status, if it is another than OK, on the others too. */
hawser_status ranks_agree(const hawser_ranks *ranks, hawser_status status, hawser_error *err);
/* A hash of what a study reads and writes: FNV-1a, 64 bits. */
typedef uint64_t Hash;

static const Hash HASH_BEGIN = 14695981039346656037u;

/* h with these bytes behind it. */
static inline Hash hash_bytes(Hash h, const void *from, size_t size)
{
    for (const unsigned char *p = from, *end = p + size; p < end; p++) h = (h ^ *p) * 1099511628211u;
    return h;
}

#endif
