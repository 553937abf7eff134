/* The public interface of studies. */
#include "hawser/hawser.h"

#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

#include "core/error.h"
#include "core/machine.h"
#include "io/case/case_parts.h"
#include "io/results/results_file.h"
#include "study/evaluate.h"
#include "study/findings.h"

struct hawser_study {
    Study *study;
    Rows rows; /* of the last run; n of 0: there is none */
    Findings findings;
    double efficiency;
};

hawser_status hawser_study_schema(char **text, hawser_error *err)
{
    return text ? case_schema(&study_top, "study", NULL, text, err) : error_argument(err, "text");
}

/* Loads a study; checks here, before any computation, that the base case gives all quantities. */
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

/* Writes summary.json atomically. */
static hawser_status summary_write(const hawser_study *s, const OutDir *dir, hawser_error *err)
{
    char *text = NULL;
    hawser_status status = findings_text(s->study, &s->findings, HAWSER_JSON, &text, err);
    if (!status) status = out_whole_in(dir, "summary.json", text, err);
    hawser_text_free(text);
    return status;
}

/* Writes the tables of the available rows. */
static hawser_status tables_write(hawser_study *s, const OutDir *dir, hawser_error *err)
{
    static const char *const names[] = {"samples.csv", "study.h5", "study.html", "summary.json"};
    out_sweep(dir, sizeof names / sizeof *names, names);
    hawser_status status = findings_make(s->study, &s->rows, &s->findings, err);
    if (!status) status = table_csv(s->study, &s->rows, dir, err);
    if (!status) status = table_h5(s->study, &s->rows, dir, err);
    if (!status) status = summary_write(s, dir, err);
    return status ? status : study_page_write(s->study, &s->rows, &s->findings, dir, "study.html", err);
}

/* Locks the folder. Workers of a study that was killed end a moment after it, and hold its folder until then. */
static hawser_status folder_lock(const char *dir, OutDir *folder, hawser_error *err)
{
    static const double PATIENCE = 2; /* s */
    const struct timespec pause = {.tv_nsec = 20000000};
    const double start = clock_now();
    hawser_status status = out_take(folder, NULL, dir, 1, err);
    while (status && clock_now() - start < PATIENCE) {
        nanosleep(&pause, NULL);
        status = out_take(folder, NULL, dir, 1, err);
    }
    return status;
}

/* Computes open units wherever they run, and again those of workers that died before they reported; reads the rows
 * afterwards. Pilots come first: they determine which others are run. */
static hawser_status part_run(hawser_study *s, const char *dir, const hawser_study_options *o,
                              const hawser_study_cluster *on, int pilots, hawser_error *err)
{
    hawser_error late;
    if (on->ranks) return ranks_run(s->study, dir, o, on->ranks, pilots, &s->rows, &s->efficiency, err);
    if (on->slurm) return slurm_run(s->study, dir, o, on, pilots, &s->rows, err);
    hawser_status status = HAWSER_OK;
    for (long left = LONG_MAX; !status;) {
        Units open;
        status = units_open(s->study, pilots, &s->rows, &open, err);
        const int more = open.n > 0 && open.n < left;
        left = open.n;
        if (!status && more)
            status = engine_run(s->study, dir, "worker", o, &open, NULL, &s->rows, &s->efficiency, err);
        free(open.unit);
        const hawser_status read = store_read(s->study, dir, &s->rows, &late);
        if (read && !status) status = error_set(err, read, "%s", late.message);
        if (!more) break;
    }
    return status;
}

static hawser_status parts_run(hawser_study *s, const char *dir, const hawser_study_options *o,
                               const hawser_study_cluster *on, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (s->study->pilot) status = part_run(s, dir, o, on, 1, err);
    if (s->study->pilot && !status) pilots_bands(s->study, &s->rows, s->study->close);
    return status ? status : part_run(s, dir, o, on, 0, err);
}

/* Locks the folder and reads its contents. */
static hawser_status folder_begin(hawser_study *s, const char *dir, int fresh, int slurm, OutDir *folder,
                                  hawser_error *err)
{
    hawser_status status = store_spare(s->study, dir, err);
    if (!status) status = out_make_dir(dir, err);
    if (!status) status = folder_lock(dir, folder, err);
    if (!status) status = rows_make(s->study, &s->rows, err);
    if (!status && fresh && slurm) status = slurm_idle(s->study, dir, err);
    if (!status && !fresh) status = store_read(s->study, dir, &s->rows, err);
    return status ? status : store_begin(s->study, dir, fresh, err);
}

/* Runs the study in a locked folder. A stopped study gets its tables too; the first error counts. With several ranks
 * the first holds the folder and writes the tables. */
hawser_status hawser_study_run_on(hawser_study *s, const char *dir, const hawser_study_options *options,
                                  const hawser_study_cluster *cluster, hawser_error *err)
{
    const hawser_study_options usual = {0}, *const o = options ? options : &usual;
    const hawser_study_cluster here = {0}, *const on = cluster ? cluster : &here;
    hawser_error local, late;
    hawser_error *const e = err ? err : &local;
    const int first = !on->ranks || on->ranks->rank == 0;
    OutDir folder = {.at = -1};
    if (!s || !dir) return error_argument(err, s ? "dir" : "s");
    drop_rows(s);
    s->efficiency = NAN;
    hawser_status status =
        first ? folder_begin(s, dir, o->fresh, on->slurm != NULL, &folder, e) : rows_make(s->study, &s->rows, e);
    if (on->ranks) status = ranks_agree(on->ranks, status, e);
    const int begun = !status;
    if (begun) status = parts_run(s, dir, o, on, e);
    if (begun && first) {
        hawser_status written = out_stays(&folder, &late);
        if (!written) written = tables_write(s, &folder, &late);
        if (written && (!status || status == HAWSER_STOPPED)) status = error_set(e, written, "%s", late.message);
    }
    out_leave(&folder);
    return status;
}

hawser_status hawser_study_run(hawser_study *s, const char *dir, const hawser_study_options *options, hawser_error *err)
{
    return hawser_study_run_on(s, dir, options, NULL, err);
}

hawser_status hawser_study_task(hawser_study *s, const char *dir, int task, const hawser_study_options *options,
                                hawser_error *err)
{
    const hawser_study_options usual = {0};
    hawser_error local;
    if (!s || !dir) return error_argument(err, s ? "dir" : "s");
    return slurm_task(s->study, dir, task, options ? options : &usual, err ? err : &local);
}

/* Splits a file's path into folder and name; dir[OUT_PATH_MAX]. */
static const char *path_split(const char *path, char *dir)
{
    const char *const slash = strrchr(path, '/');
    const size_t n = slash == path ? 1 : slash ? (size_t)(slash - path) : 1;
    snprintf(dir, OUT_PATH_MAX, "%.*s", (int)(n < OUT_PATH_MAX ? n : 0), slash ? path : ".");
    return slash ? slash + 1 : path;
}

/* Writes the report again. The bands of pilots are recomputed, since the answer contains them. */
hawser_status hawser_study_report(const char *dir, const char *page, hawser_error *err)
{
    char path[OUT_PATH_MAX], folder[OUT_PATH_MAX];
    hawser_error local;
    hawser_error *const e = err ? err : &local;
    hawser_study *s = NULL;
    OutDir to = {.at = -1};
    if (!dir || !page) return error_argument(err, dir ? "page" : "dir");
    const char *const name = path_split(page, folder);
    hawser_status status = store_study(dir, path, e);
    if (!status) status = hawser_study_load(path, &s, e);
    if (!status) status = file_marks_spare(&s->study->files, page, e);
    if (!status) status = rows_make(s->study, &s->rows, e);
    if (!status) status = store_read(s->study, dir, &s->rows, e);
    if (!status && s->study->pilot) pilots_bands(s->study, &s->rows, s->study->close);
    if (!status) status = findings_make(s->study, &s->rows, &s->findings, e);
    if (!status) status = out_enter(&to, folder, e);
    if (!status) status = study_page_write(s->study, &s->rows, &s->findings, &to, name, e);
    out_leave(&to);
    hawser_study_free(s);
    return status;
}

hawser_status hawser_study_answer(const hawser_study *s, hawser_format format, char **text, hawser_error *err)
{
    char *found, *whole;
    if (!s || !text) return error_argument(err, s ? "text" : "s");
    *text = NULL;
    if (s->rows.n == 0) return error_set(err, HAWSER_ERR_INPUT, "the study has not run");
    if (format == HAWSER_CSV)
        return error_set(err, HAWSER_ERR_INPUT,
                         "the table of a study is samples.csv in its folder; of its answer there are tables and JSON");
    const hawser_status status = findings_text(s->study, &s->findings, format, &found, err);
    if (status || format == HAWSER_JSON || isnan(s->efficiency)) {
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
