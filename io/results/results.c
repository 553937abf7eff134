/* Order matters in a results folder. At the start every file is opened, so that problems show early; in between files
 * grow and are flushed together, states before the file that points to them; at the end the tables are written,
 * whatever happened, and the first error is reported. */
#include "io/results/results.h"

#include "core/error.h"
#include "core/file.h"
#include "core/machine.h"
#include "io/results/results_file.h"

#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Largest number of states between two flushes; their frames are added to results.xdmf together. */
enum { PENDING_MAX = 32 };
/* Wall time between two flushes, s. */
static const double flush_interval = 0.5;

/* Files that are opened at the start and filled at the end. */
enum { STATIONS, ROLLERS, TABLES };
static const struct {
    const char *file;
    const Columns *columns;
} tables[TABLES] = {{"stations.csv", &station_columns}, {"rollers.csv", &roller_columns}};

/* All files of a run, and those derived from it; the summary comes last. */
enum { RUN_FILES = 11, FOLDER_FILES = 15 };
static const char *const folder_files[FOLDER_FILES] = {
    "sensitivities.json", "certificate.json", "report.html",   "report.pdf",   "series.csv",
    "stations.csv",       "rollers.csv",      "inputs.csv",    "route.csv",    "modes.csv",
    "positions.csv",      "results.h5",       "states.hawser", "results.xdmf", "summary.json"};
static const char *const *const run_files = folder_files + FOLDER_FILES - RUN_FILES;

/* Folder within the results folder: the complete results of an earlier run, until those of this one are complete. */
#define EARLIER "earlier"
/* Mark within that, during the move: a move that was interrupted by a kill is to be continued. */
#define MOVING "moving"

struct Results {
    OutFile series, tables[TABLES];
    XdmfFile xdmf;
    H5File *h5; /* NULL: no states requested */
    OutDir dir;
    int taken; /* this file took the folder, not its caller */
    Series columns;
    int n_pending;               /* states that results.xdmf does not have yet */
    double pending[PENDING_MAX]; /* their times, s */
    long states;                 /* in results.h5 */
    double last_flush;
};

static hawser_status folder_spare(const char *dir, const FileMarks *files, hawser_error *err)
{
    static const char *const more[] = {CHECKPOINT_FILE, "results.h5.journal", MOVING};
    enum { MORE = sizeof more / sizeof *more };
    char path[OUT_PATH_MAX];
    hawser_status s = HAWSER_OK;
    for (int k = 0; k < FOLDER_FILES + MORE && !s; k++) {
        s = out_join(path, dir, k < FOLDER_FILES ? folder_files[k] : more[k - FOLDER_FILES], err);
        if (!s) s = file_marks_spare(files, path, err);
    }
    return s;
}

hawser_status results_spare(const char *dir, const FileMarks *files, hawser_error *err)
{
    char earlier[OUT_PATH_MAX];
    hawser_status s = folder_spare(dir, files, err);
    if (!s) s = out_join(earlier, dir, EARLIER, err);
    return s ? s : folder_spare(earlier, files, err);
}

/* Opens both files or none: one is useless without the other. */
static hawser_status open_states(Results *r, const ResultsDef *def, hawser_error *err)
{
    const hawser_status status = h5_open(&r->h5, &r->dir, def, err);
    return status ? status : xdmf_open(&r->xdmf, &r->dir, def, err);
}

/* Old files that this run does not write, or names late: a folder holds the results of one run. */
enum { OLD_ENDS = 6, OLD_BUT_XDMF = 11, OLD_ALL = 12 }; /* the first: files that only the end of a run writes */
static hawser_status remove_old(const Results *r, int count, hawser_error *err)
{
    static const char *const names[OLD_ALL] = {
        "positions.csv", "modes.csv", "certificate.json",   "sensitivities.json", "report.html",   "report.pdf",
        CHECKPOINT_FILE, "route.csv", "results.h5.journal", "results.h5",         "states.hawser", "results.xdmf"};
    OutSpot spot;
    hawser_status s = HAWSER_OK;
    for (int k = 0; k < count && !s; k++) {
        s = out_spot(&spot, &r->dir, names[k], err);
        if (!s && !file_remove_in(spot.at, names[k])) s = out_error(spot.path, errno, err);
    }
    return s;
}

static int is_there(const OutDir *dir, const char *name)
{
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd >= 0) close(fd);
    return fd >= 0 || errno != ENOENT;
}

/* Checks whether the folder's summary is that of a finished run; a file that cannot be read now counts as one, so that
 * no good results are lost. */
static int is_finished(const OutDir *dir)
{
    enum { MOST = 1 << 28, MORE = 1 << 16, TIMES = 24 };
    static const char *const name = "summary.json";
    char *text;
    size_t size;
    const int fd = file_open_in(dir->at, name, O_RDONLY);
    if (fd >= 0) close(fd);
    if (fd < 0 && (errno == ENOENT || errno == ELOOP || errno == ENOTBLK)) return 0;
    if (file_whole_in(dir->at, name, name, MOST, &text, &size, NULL)) return 1;
    if (!text) return 0;
    const int room = memory_room(MORE + TIMES * size);
    json_t *summary = room ? json_loadb(text, size, 0, NULL) : NULL;
    if (room && !summary) summary = json_loadb(text, size, 0, NULL); /* there may have been no memory for a word */
    free(text);
    if (!room) return 1;
    const char *const outcome = json_string_value(json_object_get(summary, "outcome"));
    const int finished = outcome && !strcmp(outcome, "finished");
    json_decref(summary);
    return finished;
}

/* Removes a list of files from a folder within another one, the last of them first, and the folder if it is empty then.
 */
static void files_remove(const OutDir *dir, const char *from, int n, const char *const *files)
{
    OutDir inner;
    if (!out_within(&inner, dir, from)) return;
    while (n-- > 0) out_remove(&inner, files[n]);
    out_remove(&inner, MOVING);
    out_leave(&inner);
    folder_remove_in(dir->at, from);
}

/* Moves a list of files, where they exist, into another folder. The last one moves after the others, whatever happens
 * to the machine meanwhile. */
static hawser_status files_move(const OutDir *to, const OutDir *from, int n, const char *const *files,
                                hawser_error *err)
{
    OutSpot new;
    hawser_status s = HAWSER_OK;
    for (int k = 0; k < n && !s; k++) {
        if (k == n - 1) s = out_sync_in(to, ".", err);
        if (!s) s = out_spot(&new, to, files[k], err);
        if (!s && !file_name_in(from->at, files[k], to->at, files[k]) && errno != ENOENT)
            s = out_error(new.path, errno, err);
    }
    return s;
}

/* Makes an empty EARLIER with its mark, on the disk. */
static hawser_status earlier_begin(const OutDir *dir, OutDir *earlier, hawser_error *err)
{
    static const char *const marks[] = {MOVING};
    OutSpot spot;
    OutFile mark;
    files_remove(dir, EARLIER, FOLDER_FILES, folder_files);
    hawser_status s = out_spot(&spot, dir, EARLIER, err);
    if (!s && !folder_make_in(dir->at, EARLIER)) s = out_error(spot.path, errno, err);
    if (!s && !out_within(earlier, dir, EARLIER)) s = out_error(spot.path, errno, err);
    if (!s) out_sweep(earlier, 1, marks); /* a program that was killed while making the mark has left a part of it */
    if (!s) s = out_open_in(&mark, earlier, MOVING, err);
    if (!s) s = out_close(&mark, err);
    if (!s) s = out_sync_in(earlier, ".", err);
    return s ? s : out_sync_in(dir, ".", err);
}

/* Keeps complete results in EARLIER until new ones replace them; others are dropped. During the move they are in both
 * folders, the summary still in the old one: the next program that finds this continues. */
static hawser_status earlier_keep(const Results *r, hawser_error *err)
{
    OutDir earlier;
    const int there = out_within(&earlier, &r->dir, EARLIER), finished = is_finished(&r->dir);
    const int begun = there && is_there(&earlier, MOVING) && !is_there(&earlier, "summary.json");
    hawser_status s = HAWSER_OK;
    if (finished && !begun) {
        out_leave(&earlier);
        s = earlier_begin(&r->dir, &earlier, err);
    }
    if (!s && finished) s = files_move(&earlier, &r->dir, FOLDER_FILES, folder_files, err);
    if (!s && finished) s = out_sync_in(&earlier, ".", err);
    if (!s && earlier.at >= 0) out_remove(&earlier, MOVING);
    out_leave(&earlier);
    return s;
}

/* Rejects a folder in which no run has begun, but which has a file with the name of one that a run writes or removes:
 * it is the user's. */
static hawser_status nobodys_check(const OutDir *dir, hawser_error *err)
{
    static const char *const more[] = {CHECKPOINT_FILE};
    enum { ALL = FOLDER_FILES + sizeof more / sizeof *more };
    OutSpot spot;
    for (int k = 0; k < ALL; k++) {
        const char *const name = k < FOLDER_FILES ? folder_files[k] : more[k - FOLDER_FILES];
        const int fd = file_open_in(dir->at, name, O_RDONLY); /* not a link, which is replaced, or a folder */
        if (fd < 0) continue;
        close(fd);
        const hawser_status status = out_spot(&spot, dir, name, err);
        return status ? status
                      : error_set(err, HAWSER_ERR_OUTPUT,
                                  "'%.700s' is there, and no summary.json of a run: it would be written over, or "
                                  "taken away; give another folder",
                                  spot.path);
    }
    return HAWSER_OK;
}

/* Checks that the folder, and the one of earlier results, belong to a run or have none of its files. */
static hawser_status ours_check(const OutDir *dir, hawser_error *err)
{
    OutDir earlier;
    const int there = out_within(&earlier, dir, EARLIER), kept = there && is_there(&earlier, "summary.json");
    hawser_status s = kept || is_there(dir, "summary.json") ? HAWSER_OK : nobodys_check(dir, err);
    if (!s && there && !kept && !is_there(&earlier, MOVING)) s = nobodys_check(&earlier, err);
    out_leave(&earlier);
    return s;
}

/* Writes the constant files: the case as it was read, and the route with its theory, where there is one. */
static hawser_status write_known(const Results *r, const ResultsDef *def, hawser_error *err)
{
    OutFile out;
    hawser_status status = out_open_in(&out, &r->dir, "inputs.csv", err);
    if (status) return status;
    status = inputs_write(&out, def->n_inputs, def->inputs, err);
    hawser_status closed = out_close(&out, status ? NULL : err);
    if (!status) status = closed;
    if (status || def->n_route == 0) return status;
    status = out_open_in(&out, &r->dir, "route.csv", err);
    if (status) return status;
    status = csv_head(&out, &route_columns, err);
    if (!status) status = csv_rows(&out, &route_columns, def->n_route, def->route, err);
    closed = out_close(&out, status ? NULL : err);
    return status ? status : closed;
}

/* Opens the files that the end fills. */
static hawser_status open_tables(Results *r, hawser_error *err)
{
    hawser_status s = HAWSER_OK;
    for (int k = 0; k < TABLES && !s; k++) {
        s = out_open_in(&r->tables[k], &r->dir, tables[k].file, err);
        if (!s) s = csv_head(&r->tables[k], tables[k].columns, err);
    }
    return s;
}

/* Opens everything before anything is written: two runs at once would mix their rows. The summary comes first: a folder
 * whose run is killed has "running" and not the summary of an earlier run. */
static hawser_status open_all(Results *r, const ResultsDef *def, const char *summary, hawser_error *err)
{
    static const char *const more[] = {CHECKPOINT_FILE, "results.h5.journal"};
    hawser_status s = ours_check(&r->dir, err);
    if (s) return s;
    s = earlier_keep(r, err);
    out_sweep(&r->dir, RUN_FILES, run_files);
    out_sweep(&r->dir, sizeof more / sizeof *more, more);
    if (!s) s = out_whole_in(&r->dir, "summary.json", summary, err);
    if (!s) s = remove_old(r, def->states > 0 ? OLD_BUT_XDMF : OLD_ALL, err);
    if (!s) s = write_known(r, def, err);
    if (!s) s = out_open_in(&r->series, &r->dir, "series.csv", err);
    if (!s) s = series_make(&r->columns, def, err);
    if (!s) s = series_head(&r->series, &r->columns, err);
    if (!s) s = open_tables(r, err);
    if (!s && def->states > 0) s = open_states(r, def, err);
    return s;
}

/* Checks that all files to be continued exist and are as at the checkpoint; nothing is changed before. */
static hawser_status resume_check(const Results *r, const ResultsDef *def, const ResultsPosition *at, hawser_error *err)
{
    hawser_status s = summary_is_of(&r->dir, def->run, err);
    if (!s) s = out_can_resume(&r->dir, "series.csv", at->series, "\n", err);
    if (!s && def->states > 0) s = h5_can_resume(&r->dir, def, at->states, err);
    if (!s && def->states > 0) s = xdmf_can_resume(&r->dir, at->xdmf, err);
    return s;
}

/* Continues the files that grow; the others are complete. */
static hawser_status resume_all(Results *r, const ResultsDef *def, const ResultsPosition *at, const char *summary,
                                hawser_error *err)
{
    hawser_status s = resume_check(r, def, at, err);
    if (!s) out_sweep(&r->dir, RUN_FILES, run_files);
    if (!s) s = out_resume(&r->series, &r->dir, "series.csv", at->series, err);
    if (!s) s = series_make(&r->columns, def, err);
    if (!s && def->states > 0) s = h5_resume(&r->h5, &r->dir, def, at->states, err);
    if (!s && def->states > 0) s = xdmf_resume(&r->xdmf, &r->dir, def, at->xdmf, err);
    if (!s) s = out_whole_in(&r->dir, "summary.json", summary, err);
    if (!s) s = remove_old(r, OLD_ENDS, err);
    if (!s) s = open_tables(r, err);
    r->states = at->states;
    return s;
}

/* Takes the folder `name` of `home`, or `home` itself. */
static hawser_status folder_take(Results *r, const OutDir *home, const char *name, int make, hawser_error *err)
{
    if (!name) {
        r->dir = *home;
        return HAWSER_OK;
    }
    r->taken = 1;
    return out_take(&r->dir, home, name, make, err);
}

/* Leaves nothing open after a failure; files that were made until then stay, empty. at: NULL for a new run. */
static hawser_status results_begin(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                                   const ResultsPosition *at, const char *summary, hawser_error *err)
{
    *out = NULL;
    Results *r = calloc(1, sizeof *r);
    if (!r) return error_memory(err);
    hawser_status status = folder_take(r, home, name, !at, err);
    if (!status) status = at ? resume_all(r, def, at, summary, err) : open_all(r, def, summary, err);
    if (status) {
        results_free(r);
        return status;
    }
    *out = r;
    return HAWSER_OK;
}

hawser_status results_open(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                           const char *summary, hawser_error *err)
{
    return results_begin(out, home, name, def, NULL, summary, err);
}

hawser_status results_resume(Results **out, const OutDir *home, const char *name, const ResultsDef *def,
                             const ResultsPosition *position, const char *summary, hawser_error *err)
{
    return results_begin(out, home, name, def, position, summary, err);
}

const OutDir *results_dir(const Results *r) { return &r->dir; }

hawser_status results_row(Results *r, const hawser_sample *s, hawser_error *err)
{
    return series_row(&r->series, &r->columns, s, err);
}

/* Flushes the states first, then the file that points to them. */
static hawser_status flush_states(Results *r, int must, hawser_error *err)
{
    if (!r->n_pending && !(must && r->h5)) return HAWSER_OK;
    hawser_status status = h5_flush(r->h5, must, err);
    if (!status) status = xdmf_append(&r->xdmf, r->n_pending, r->states - r->n_pending, r->pending, err);
    r->n_pending = 0;
    return status;
}

/* Makes every row and state visible to readers; must: even if one of them is reading. */
static hawser_status flush_all(Results *r, int must, hawser_error *err)
{
    const hawser_status status = out_flush(&r->series, err);
    r->last_flush = clock_now();
    return status ? status : flush_states(r, must, err);
}

/* Keeps frames for results.xdmf until they are flushed; their number is fixed. */
hawser_status results_state(Results *r, const hawser_sample *sample, hawser_error *err)
{
    if (!r->h5) return HAWSER_OK;
    const hawser_status status = h5_append(r->h5, sample, err);
    if (status) return status;
    r->states++;
    r->pending[r->n_pending++] = sample->t;
    return r->n_pending == PENDING_MAX ? flush_all(r, 0, err) : HAWSER_OK;
}

/* Flushes by wall time: otherwise a fast run would spend its time flushing, and a slow one would hide its states for
 * minutes. */
hawser_status results_tick(Results *r, hawser_error *err)
{
    return clock_now() - r->last_flush < flush_interval ? HAWSER_OK : flush_all(r, 0, err);
}

hawser_status results_position(Results *r, ResultsPosition *position, hawser_error *err)
{
    hawser_status s = flush_all(r, 1, err);
    if (!s) s = out_sync_in(&r->dir, "series.csv", err);
    if (!s && r->xdmf.out.f) s = out_sync_in(&r->dir, "results.xdmf", err);
    if (!s && r->h5) s = out_sync_in(&r->dir, STATES_FILE, err);
    *position = (ResultsPosition){ftell(r->series.f), r->h5 ? r->xdmf.end : 0, r->states};
    return s;
}

hawser_status results_checkpoint(const OutDir *dir, const void *bytes, size_t size, hawser_error *err)
{
    return out_bytes_in(dir, CHECKPOINT_FILE, bytes, size, err);
}

void results_no_checkpoint(const OutDir *dir) { out_remove(dir, CHECKPOINT_FILE); }

/* Keeps the first error of a sequence that continues; err is given only to calls before it. */
static void keep_first(hawser_status *first, hawser_status status)
{
    if (!*first) *first = status;
}

/* Writes only if there are modes. */
static hawser_status write_modes(Results *r, const ResultsTables *t, hawser_error *err)
{
    OutFile out;
    if (t->n_modes == 0) return HAWSER_OK;
    hawser_status status = out_open_in(&out, &r->dir, "modes.csv", err);
    if (status) return status;
    status = modes_write(&out, t->n_modes, t->segments, t->mode, err);
    const hawser_status closed = out_close(&out, status ? NULL : err);
    return status ? status : closed;
}

/* Stores in the states the identity of their series, which is complete now. */
static hawser_status states_tie(Results *r, hawser_error *err)
{
    FileSum series;
    const hawser_status status = out_own(file_sum(&r->dir, "series.csv", &series, err), err);
    return status ? status : h5_series(r->h5, series.sum, err);
}

/* Writes only if there are positions. */
static hawser_status write_places(Results *r, const ResultsTables *t, hawser_error *err)
{
    OutFile out;
    if (t->n_places == 0) return HAWSER_OK;
    hawser_status status = out_open_in(&out, &r->dir, "positions.csv", err);
    if (status) return status;
    status = places_write(&out, t->n_places, t->place, t->n_stations, t->station, t->place_station, err);
    const hawser_status closed = out_close(&out, status ? NULL : err);
    return status ? status : closed;
}

/* Tries every file: a full disk may still have space for small tables. */
hawser_status results_finish(Results *r, const ResultsTables *t, hawser_error *err)
{
    const int n[TABLES] = {t->n_stations, t->n_rollers};
    const void *const rows[TABLES] = {t->station, t->roller};
    hawser_status s = flush_all(r, 0, err);
    if (r->h5 && t->envelope) keep_first(&s, h5_envelope(r->h5, t->envelope, s ? NULL : err));
    keep_first(&s, out_close(&r->series, s ? NULL : err));
    if (!s && r->h5) keep_first(&s, states_tie(r, err));
    const int states = r->h5 != NULL;
    keep_first(&s, h5_close(&r->h5, s ? NULL : err));
    if (!s && states) s = file_seal(&r->dir, STATES_FILE, err);
    keep_first(&s, xdmf_close(&r->xdmf, s ? NULL : err));
    for (int k = 0; k < TABLES; k++) {
        keep_first(&s, csv_rows(&r->tables[k], tables[k].columns, n[k], rows[k], s ? NULL : err));
        keep_first(&s, out_close(&r->tables[k], s ? NULL : err));
    }
    keep_first(&s, write_modes(r, t, s ? NULL : err));
    keep_first(&s, write_places(r, t, s ? NULL : err));
    return s;
}

/* Puts the other files on the disk before the summary with the outcome. */
hawser_status results_summary(Results *r, const char *summary, int whole, hawser_error *err)
{
    hawser_status s = HAWSER_OK;
    for (int k = 0; k < RUN_FILES - 1 && !s; k++)
        if (is_there(&r->dir, run_files[k])) s = out_sync_in(&r->dir, run_files[k], err);
    if (!s) s = out_whole_in(&r->dir, "summary.json", summary, err);
    if (!s && whole) files_remove(&r->dir, EARLIER, FOLDER_FILES, folder_files);
    return s;
}

/* Removes the summary, pages and certificates while files change, since they state that the files belong together. */
static void summary_withdraw(const OutDir *dir)
{
    static const char *const names[] = {"summary.json", "certificate.json", "sensitivities.json", "report.html",
                                        "report.pdf"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) out_remove(dir, names[k]);
}

hawser_status results_again(const OutDir *dir, const ResultsTables *t, hawser_error *err)
{
    const int n[TABLES] = {t->n_stations, t->n_rollers};
    const void *const rows[TABLES] = {t->station, t->roller};
    hawser_status s = HAWSER_OK;
    summary_withdraw(dir);
    for (int k = 0; k < TABLES && !s; k++) {
        OutFile out;
        s = out_open_in(&out, dir, tables[k].file, err);
        if (s) break;
        s = csv_head(&out, tables[k].columns, err);
        if (!s) s = csv_rows(&out, tables[k].columns, n[k], rows[k], err);
        keep_first(&s, out_close(&out, s ? NULL : err));
        if (!s) s = out_sync_in(dir, tables[k].file, err);
    }
    return s;
}

/* Moves the summary last: its files are there then. Keeps the case of `to`, which is the same, with the lines of the
 * file that it was read from. */
hawser_status results_replace(const OutDir *to, const char *from, hawser_error *err)
{
    OutDir inner;
    summary_withdraw(to);
    if (!out_within(&inner, to, from)) return errno == ENOENT ? HAWSER_OK : out_error(from, errno, err);
    out_remove(&inner, "inputs.csv");
    const hawser_status s = files_move(to, &inner, RUN_FILES, run_files, err);
    out_leave(&inner);
    return s;
}

/* Also removes what a kill has left. */
void results_remove(const OutDir *dir, const char *from)
{
    static const char *const kept[] = {CHECKPOINT_FILE, "results.h5.journal"};
    enum { KEPT = sizeof kept / sizeof *kept };
    OutDir inner;
    if (!out_within(&inner, dir, from)) return;
    out_sweep(&inner, RUN_FILES, run_files);
    out_sweep(&inner, KEPT, kept);
    for (size_t k = 0; k < KEPT; k++) out_remove(&inner, kept[k]);
    out_leave(&inner);
    files_remove(dir, from, RUN_FILES, run_files);
}

/* Frees memory alone after results_finish; without it, closes everything as it is. */
Results *results_free(Results *r)
{
    if (!r) return NULL;
    h5_close(&r->h5, NULL);
    xdmf_close(&r->xdmf, NULL);
    out_close(&r->series, NULL);
    for (int k = 0; k < TABLES; k++) out_close(&r->tables[k], NULL);
    if (r->taken) out_leave(&r->dir);
    free(r->columns.column);
    free(r);
    return NULL;
}
