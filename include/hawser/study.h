/* Studies: many samples of a case, on all processors; part of hawser/hawser.h, which includes it.
 * docs/guide/studies-and-measured-pulls.md describes the file, the ways to vary, and the results. */
#ifndef HAWSER_STUDY_H
#define HAWSER_STUDY_H

#include "hawser/shown.h"
#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct hawser_study hawser_study;

/* Progress of a study; valid only during the call of the progress function. */
typedef struct hawser_study_state {
    long samples, done; /* rows in all; finished rows, including those of an earlier start */
    long failed;        /* rows of these without an answer */
    long not_safe;
    int jobs;
    double wall_s, left_s; /* s since the start; s until the end, NAN: not known yet */
} hawser_study_state;
/* Returns 0 to go on, anything else to stop. Called a few times a second. */
typedef int (*hawser_study_progress)(void *user, const hawser_study_state *state);

typedef struct hawser_study_options {
    int jobs;                       /* worker processes; 0: as many as there are processors */
    int fresh;                      /* results of an earlier start in the folder are dropped instead of continued */
    hawser_study_progress progress; /* may be NULL */
    void *user;
} hawser_study_options;

/* Returns what a study may hold as a JSON Schema, as hawser_case_schema does for a case. Errors: MEMORY. */
hawser_status hawser_study_schema(char **text, hawser_error *err);
/* Reads a study file and its base case. Errors: INPUT with file, line and key; MEMORY. *out is NULL then. */
hawser_status hawser_study_load(const char *path, hawser_study **out, hawser_error *err);
void hawser_study_free(hawser_study *s);
/* Computes the samples that the folder does not have yet, in processes that are forked from this one (which must have
 * no other threads), and writes samples.csv, study.h5 and summary.json. A sample without an answer is a row with its
 * reason. options may be NULL. Errors: INPUT (the folder has another study), OUTPUT, MEMORY, STOPPED; the tables hold
 * the finished samples then. */
hawser_status hawser_study_run(hawser_study *s, const char *dir, const hawser_study_options *options,
                               hawser_error *err);
/* Returns the answer, as far as the last run went: tables for readers, or with HAWSER_JSON the content of summary.json.
 * *text is malloc'ed: hawser_text_free. Errors: INPUT (it has not run; HAWSER_CSV: a study's table is samples.csv),
 * MEMORY. */
hawser_status hawser_study_answer(const hawser_study *s, hawser_format format, char **text, hawser_error *err);

/* ---------------------------------------------------------------------------------------------------- measured pulls
 */

typedef struct hawser_compare_options {
    int by_start;         /* compared by time since the pull began; 0: by the winch's travel */
    double shift;         /* s or m, added to the log's time or travel */
    double band;          /* share of the log's force that counts as agreement; 0: a tenth */
    int raw;              /* spikes and drop-outs are kept */
    const char *page;     /* an HTML file with figures; NULL: none */
    hawser_format format; /* format of the text */
} hawser_compare_options;
/* Compares the winch's force from a logger (CSV, docs/guide/studies-and-measured-pulls.md) with the run and the theory
 * in a results folder: figures of agreement. *text is malloc'ed: hawser_text_free. options may be NULL. Errors: INPUT
 * (files, no stretch in common), OUTPUT, MEMORY. */
hawser_status hawser_compare(const char *results, const char *log, const hawser_compare_options *options, char **text,
                             hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
