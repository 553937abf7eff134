/* The public interface of studies. */
#include "hawser/hawser.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "io/results/results_file.h"
#include "study/engine/engine.h"
#include "study/results/results.h"

struct hawser_study {
    Study *study;
    Rows rows; /* of the last run; n of 0: there was none */
    Findings findings;
    double efficiency;
};

/* What the base case cannot answer is found here, before anything is computed. */
hawser_status hawser_study_load(const char *path, hawser_study **out, hawser_error *err)
{
    hawser_error local;
    hawser_error *const e = err ? err : &local;
    if (!path || !out) return error_argument(err, path ? "out" : "path");
    hawser_study *const s = calloc(1, sizeof *s);
    *out = NULL;
    if (!s) return error_memory(e);
    hawser_status status = study_read(path, &s->study, e);
    if (!status) status = quantities_check(s->study, e);
    if (!status) *out = s;
    if (status) hawser_study_free(s);
    return status;
}

static void drop_rows(hawser_study *s)
{
    rows_free(&s->rows);
    findings_free(&s->findings);
}

void hawser_study_free(hawser_study *s)
{
    if (!s) return;
    drop_rows(s);
    study_free(s->study);
    free(s);
}

/* summary.json, whole. */
static hawser_status summary_write(const hawser_study *s, const char *dir, hawser_error *err)
{
    OutFile out;
    char *text;
    hawser_status status = findings_text(s->study, &s->findings, HAWSER_JSON, &text, err);
    if (status) return status;
    status = out_open(&out, dir, "summary.json", err);
    if (!status) {
        status = out_print(&out, err, "%s", text);
        const hawser_status closed = out_close(&out, status ? NULL : err);
        if (!status) status = closed;
    }
    hawser_text_free(text);
    return status;
}

/* The tables of what is there. */
static hawser_status tables_write(hawser_study *s, const char *dir, hawser_error *err)
{
    hawser_status status = findings_make(s->study, &s->rows, &s->findings, err);
    if (!status) status = table_csv(s->study, &s->rows, dir, err);
    if (!status) status = table_h5(s->study, &s->rows, dir, err);
    if (!status) status = summary_write(s, dir, err);
    return status ? status : study_page_write(s->study, &s->rows, &s->findings, dir, err);
}

/* The workers of a study that was killed end a moment after it, and hold its folder until then. */
static hawser_status folder_lock(const char *dir, int *lock, hawser_error *err)
{
    static const double PATIENCE = 2; /* s */
    const struct timespec pause = {.tv_nsec = 20000000};
    const double start = clock_now();
    hawser_status status = out_lock_dir(dir, lock, err);
    while (status && clock_now() - start < PATIENCE) {
        nanosleep(&pause, NULL);
        status = out_lock_dir(dir, lock, err);
    }
    return status;
}

/* In a folder that is ours for as long as this lasts. A study that is stopped gets its tables too; the first error
 * counts. */
hawser_status hawser_study_run(hawser_study *s, const char *dir, const hawser_study_options *options, hawser_error *err)
{
    const hawser_study_options usual = {0}, *const o = options ? options : &usual;
    hawser_error local, late;
    hawser_error *const e = err ? err : &local;
    int lock = -1;
    if (!s || !dir) return error_argument(err, s ? "dir" : "s");
    drop_rows(s);
    hawser_status status = out_make_dir(dir, e);
    if (!status) status = folder_lock(dir, &lock, e);
    if (!status) status = rows_make(s->study, &s->rows, e);
    if (!status && !o->fresh) status = store_read(s->study, dir, &s->rows, e);
    if (!status) status = store_begin(s->study, dir, o->fresh, e);
    if (!status) {
        /* pilots first: they say which of the others are run */
        if (s->study->pilot) status = engine_run(s->study, dir, o, 1, &s->rows, &s->efficiency, e);
        if (s->study->pilot) pilots_bands(s->study, &s->rows, s->study->close);
        if (!status) status = engine_run(s->study, dir, o, 0, &s->rows, &s->efficiency, e);
        const hawser_status written = tables_write(s, dir, &late);
        if (written && (!status || status == HAWSER_STOPPED)) status = error_set(e, written, "%s", late.message);
    }
    if (lock >= 0) close(lock);
    return status;
}

hawser_status hawser_study_answer(const hawser_study *s, hawser_units units, char **text, hawser_error *err)
{
    char *found, *whole;
    if (!s || !text) return error_argument(err, s ? "text" : "s");
    *text = NULL;
    if (s->rows.n == 0) return error_set(err, HAWSER_ERR_INPUT, "the study has not run");
    const hawser_format format = units == HAWSER_US ? HAWSER_TABLE_US : HAWSER_TABLE;
    const hawser_status status = findings_text(s->study, &s->findings, format, &found, err);
    if (status || isnan(s->efficiency)) {
        *text = status ? NULL : found;
        return status;
    }
    const size_t size = strlen(found) + 80;
    whole = malloc(size);
    if (whole) snprintf(whole, size, "%s\nWorkers were busy for %.0f %% of the time\n", found, 100 * s->efficiency);
    free(found);
    *text = whole;
    return whole ? HAWSER_OK : error_memory(err);
}
