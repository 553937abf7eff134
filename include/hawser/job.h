/* Many pulls as one job, calculated by theory: part of hawser/hawser.h, which includes it.
 * docs/guide/jobs-and-sheets.md describes the file. */
#ifndef HAWSER_JOB_H
#define HAWSER_JOB_H

#include "hawser/limits.h"
#include "hawser/shown.h"
#include "hawser/status.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef struct hawser_job hawser_job;

/* Returns what a job may hold as a JSON Schema, as hawser_case_schema does for a case. Errors: MEMORY. */
hawser_status hawser_job_schema(char **text, hawser_error *err);

/* Reads a job's file and all cases that it names, and calculates each pull in both directions. Errors: INPUT with file,
 * line and key, and the name of the pull; MEMORY. *out is NULL then. */
hawser_status hawser_job_load(const char *path, hawser_job **out, hawser_error *err);
void hawser_job_free(hawser_job *job);
/* Returns the tables of pulls, of reels and of joint bays; HAWSER_CSV: the pulls alone. *text is malloc'ed
 * (hawser_text_free). word (may be NULL): SAFE if every pull is SAFE in the chosen direction; otherwise the worst word.
 * Errors: MEMORY. */
hawser_status hawser_job_answer(const hawser_job *job, hawser_format format, char **text, hawser_word *word,
                                hawser_error *err);
/* Writes the same as one page (HTML), followed by the calculation of each pull on its own sheet. Errors: INPUT (`path`
 * leads to a file that the job is read from), OUTPUT, MEMORY. */
hawser_status hawser_job_page(const hawser_job *job, hawser_units units, const char *path, hawser_error *err);
/* Writes the crew's sheets of all pulls as one page, a side each (hawser_case_crew_sheet). Errors: as above. */
hawser_status hawser_job_crew_sheets(const hawser_job *job, hawser_units units, const char *path, hawser_error *err);
/* Writes the tables as a workbook (.xlsx, Office Open XML, ECMA-376), a sheet each, in SI units. Errors: as above. */
hawser_status hawser_job_workbook(const hawser_job *job, const char *path, hawser_error *err);

#ifdef __cplusplus
}
#endif

#endif
