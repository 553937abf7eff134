/* The engine: samples on worker processes, each row appended whole to its worker's file, so that a study that is killed
 * goes on where it was and repeats nothing. docs/studies.md, "How it is computed". */
#ifndef HAWSER_STUDY_ENGINE_ENGINE_H
#define HAWSER_STUDY_ENGINE_ENGINE_H

#include "hawser/hawser.h"
#include "study/plan/study.h"
#include "theory/limits.h"

/* How a sample ended. */
typedef enum RowState { ROW_OPEN, ROW_DONE, ROW_REFUSED, ROW_FAILED, ROW_TIME, ROW_MEMORY, ROW_DIED } RowState;
/* What its answer says. */
typedef enum RowVerdict {
    VERDICT_NONE,
    VERDICT_SAFE,
    VERDICT_NOT_SAFE,
    VERDICT_NOT_JUDGED,
    VERDICT_NOT_TRUSTED
} RowVerdict;

/* The words for them, by the enumerations. */
extern const char *const row_states[], *const row_verdicts[];

enum { REASON_MAX = 200 };

/* One sample. On disk it is this struct, then its quantities, then a check sum: the same machine reads it again. */
typedef struct Row {
    int64_t sample;
    int32_t state, verdict; /* a RowState, RowVerdict of the last answer */
    int32_t answered;       /* BY_THEORY or BY_RUN: the last answer */
    int32_t theory_verdict; /* of theory, where it was asked */
    int32_t limited_by;     /* the LimitKind with the least margin; -1: none was judged */
    int32_t pad;
    double margin[LIMIT_KINDS]; /* of the last answer; NAN: not judged */
    double seconds;             /* of processor time */
    char reason[REASON_MAX];    /* why there is no answer, or "" */
} Row;

/* All rows of a study, by sample. */
typedef struct Rows {
    long n;
    int n_quantities;
    Row *row;      /* [n]; ROW_OPEN: not computed yet */
    double *value; /* [n * n_quantities]; NAN: not known */
} Rows;

/* ROW_OPEN everywhere. Errors: MEMORY. */
hawser_status rows_make(const Study *s, Rows *rows, hawser_error *err);
void rows_free(Rows *rows);

/* Computes sample i: fills row and value[n_quantities]. What goes wrong is in the row. */
void sample_evaluate(const Study *s, long i, Row *row, double *value);
/* Whether the quantities are in the answers to the middle of all parameters, as far as that shows without a run.
 * Errors: INPUT with file and line, MEMORY. */
hawser_status quantities_check(const Study *s, hawser_error *err);

/* ------------------------------------------------------------------------------------------------- workers' files */

/* Reads every whole row that workers have left in dir/workers into `rows`, if they are of this study; cuts off one that
 * is not. A folder without such is fine. Errors: INPUT (they are of another study), OUTPUT, MEMORY.
 */
hawser_status store_read(const Study *s, const char *dir, Rows *rows, hawser_error *err);
/* Makes dir/workers and says whose it is; `fresh`: what is there is removed. Errors: OUTPUT, MEMORY. */
hawser_status store_begin(const Study *s, const char *dir, int fresh, hawser_error *err);
/* Worker k's file to append to; < 0 with errno. */
int store_open(const char *dir, int k);
/* Appends a row in one write; 0 or errno. */
int store_append(int fd, const Row *row, const double *value, int n_quantities);
/* Cuts off a row that its worker did not finish writing; 0 or errno. */
int store_mend(int fd, int n_quantities);

/* --------------------------------------------------------------------------------------------------------- workers */

/* Computes what is open on `jobs` processes. Errors: OUTPUT, MEMORY, STOPPED; rows that were written are in `rows` in
 * any case. *efficiency: processor time of samples over wall time and workers; NAN if nothing was open. */
hawser_status engine_run(const Study *s, const char *dir, const hawser_study_options *options, Rows *rows,
                         double *efficiency, hawser_error *err);

#endif
