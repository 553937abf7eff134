/* Workers' files: rows of one size, each with a check sum, appended and never changed. A row that is cut
 * off or damaged counts as not there. */
#define _GNU_SOURCE /* scandirat */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/base/error.h"
#include "core/base/file.h"
#include "io/results/results_file.h"
#include "study/engine/engine.h"

enum { IDENTITY_MAX = 128, RECORD_MAX = 1 << 16, OWNER_MOST = 1 << 16 };

/* The line by which a folder knows whose it is. */
static hawser_status identity_say(const Study *s, char text[IDENTITY_MAX], hawser_error *err)
{
    uint64_t h = 0;
    const hawser_status status = study_identity(s, NULL, &h, err);
    snprintf(text, IDENTITY_MAX, "hawser study %016llx\n", (unsigned long long)h);
    return status;
}

/* ----------------------------------------------------------------------------------------------------------- paths */

static const char ENDING[] = ".rows";

enum { ROWS_NAME_MAX = CREW_MAX + 20 };

static void rows_name(char name[ROWS_NAME_MAX], const char *crew, int k)
{
    snprintf(name, ROWS_NAME_MAX, "%.*s-%d%s", CREW_MAX, crew, k, ENDING);
}

hawser_status store_path(char path[], const char *dir, const char *crew, int k, hawser_error *err)
{
    char name[ROWS_NAME_MAX], folder[OUT_PATH_MAX];
    rows_name(name, crew, k);
    const hawser_status status = out_join(folder, dir, "workers", err);
    return status ? status : out_join(path, folder, name, err);
}

hawser_status workers_enter(OutDir *workers, const char *dir, hawser_error *err)
{
    OutDir outer;
    workers->at = -1;
    hawser_status status = out_enter(&outer, dir, err);
    if (!status && !out_within(workers, &outer, "workers")) status = out_error(workers->path, errno, err);
    const int number = errno;
    out_leave(&outer);
    errno = number;
    return status;
}

static int is_rows(const struct dirent *entry)
{
    const size_t n = strlen(entry->d_name), end = sizeof ENDING - 1;
    return n > end && strcmp(entry->d_name + n - end, ENDING) == 0;
}

/* A file of rows that cannot be "read" or "written". */
static hawser_status rows_error(const char *what, const char *path, int number, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot %s '%.700s': %s", what, path, file_reason(number));
}

/* Calls `with` on every file of rows in dir/workers, in the order of their names, until one returns another number than
 * 0, which is why the file cannot be done `what` with. Errors: OUTPUT, MEMORY. */
typedef int (*RowsFile)(void *user, const OutDir *workers, const char *name);
static hawser_status files_each(const char *dir, const char *what, RowsFile with, void *user, hawser_error *err)
{
    char path[OUT_PATH_MAX];
    OutDir workers;
    struct dirent **list = NULL;
    if (workers_enter(&workers, dir, NULL)) return errno == ENOENT ? HAWSER_OK : rows_error("read", dir, errno, err);
    const int n = scandirat(workers.at, ".", &list, is_rows, alphasort);
    hawser_status status = n >= 0            ? HAWSER_OK
                           : errno == ENOMEM ? error_memory(err)
                                             : rows_error("read", workers.path, errno, err);
    for (int k = 0; k < n; k++) {
        const int number = status ? 0 : with(user, &workers, list[k]->d_name);
        if (number && !out_join(path, workers.path, list[k]->d_name, err)) status = rows_error(what, path, number, err);
        free(list[k]);
    }
    free(list);
    out_leave(&workers);
    return status;
}

/* ------------------------------------------------------------------------------------------------------------ rows */

int row_width(const Study *s) { return s->n_quantities + (study_searches(s) ? s->n_parameters : 0) + s->measured.n; }

void row_point(const Study *s, const Rows *rows, long i, double *x)
{
    const size_t q = (size_t)s->n_quantities, d = (size_t)s->n_parameters;
    if (study_searches(s)) {
        memcpy(x, rows->value + (size_t)i * (size_t)rows->width + q, d * sizeof *x);
    } else {
        study_point(s, i, x);
    }
}

hawser_status rows_make(const Study *s, Rows *rows, hawser_error *err)
{
    const size_t n = (size_t)s->samples, q = (size_t)row_width(s);
    *rows = (Rows){s->samples, (int)q, calloc(n, sizeof *rows->row), malloc((n * q + 1) * sizeof(double))};
    if (rows->row && rows->value) return HAWSER_OK;
    rows_free(rows);
    return error_memory(err);
}

void rows_free(Rows *rows)
{
    free(rows->row);
    free(rows->value);
    *rows = (Rows){0};
}

static size_t record_size(int width) { return sizeof(Row) + (size_t)width * sizeof(double) + sizeof(Hash); }

int store_open(const char *dir, const char *crew, int k)
{
    char name[ROWS_NAME_MAX], part[FILE_PART_MAX];
    OutDir workers;
    if (workers_enter(&workers, dir, NULL)) return -1;
    rows_name(name, crew, k);
    int fd = file_open_in(workers.at, name, O_RDWR | O_APPEND);
    if (fd < 0 && errno == ENOENT) {
        const int made = file_new_in(workers.at, name, part);
        if (made >= 0) close(made);
        if (made >= 0 && file_name_in(workers.at, part, workers.at, name))
            fd = file_open_in(workers.at, name, O_RDWR | O_APPEND);
    }
    const int number = errno;
    out_leave(&workers);
    errno = number;
    return fd;
}

int store_append(int fd, const Row *row, const double *value, int width)
{
    const size_t values = (size_t)width * sizeof *value, size = record_size(width);
    char record[RECORD_MAX];
    if (size > sizeof record) return EFBIG;
    memcpy(record, row, sizeof *row);
    memcpy(record + sizeof *row, value, values);
    const Hash h = hash_bytes(HASH_BEGIN, record, sizeof *row + values);
    memcpy(record + sizeof *row + values, &h, sizeof h);
    struct stat before;
    size_t done = 0;
    if (fstat(fd, &before)) return errno;
    while (done < size) {
        errno = 0;
        const ssize_t n = write(fd, record + done, size - done);
        if (n > 0) done += (size_t)n;
        if (n > 0 || errno == EINTR) continue;
        const int why = errno ? errno : ENOSPC;
        /* a part of a row would make all that are added later unreadable */
        return done > 0 && ftruncate(fd, before.st_size) ? errno : why;
    }
    return 0;
}

/* Whether a record is as it was written. */
static int record_is_sound(const char *record, size_t size)
{
    Hash h;
    memcpy(&h, record + size - sizeof h, sizeof h);
    return h == hash_bytes(HASH_BEGIN, record, size - sizeof h);
}

static int within(int32_t value, int least, int most) { return value >= least && value <= most; }

/* Whether it says what a row can say: its sum only tells that it is as somebody wrote it. */
static int row_is_one(const Row *row)
{
    return within(row->state, ROW_OPEN, ROW_DIED) && within(row->verdict, VERDICT_NONE, VERDICTS - 1) &&
           within(row->theory_verdict, VERDICT_NONE, VERDICTS - 1) && within(row->answered, BY_THEORY, BY_RUN) &&
           within(row->limited_by, -1, LIMIT_KINDS - 1) && memchr(row->reason, 0, sizeof row->reason);
}

/* Takes a record in; an answer weighs more than none, else the first counts. */
static void record_take(const char *record, Rows *rows)
{
    Row row;
    memcpy(&row, record, sizeof row);
    if (row.sample < 0 || row.sample >= rows->n || !row_is_one(&row)) return; /* of a longer study */
    Row *const to = &rows->row[row.sample];
    if (to->state == ROW_DONE || (to->state != ROW_OPEN && row.state != ROW_DONE)) return;
    *to = row;
    const size_t q = (size_t)rows->width;
    memcpy(rows->value + (size_t)row.sample * q, record + sizeof row, q * sizeof *rows->value);
}

int store_mend(int fd, int width)
{
    struct stat info;
    if (fstat(fd, &info)) return errno;
    const off_t cut = info.st_size % (off_t)record_size(width);
    return cut && ftruncate(fd, info.st_size - cut) ? errno : 0;
}

/* A record that begins there; 0: the file ends before it does. < 0: errno says why nobody knows. */
static int record_read(int fd, off_t at, size_t size, char record[RECORD_MAX])
{
    const ssize_t n = whole_pread(fd, record, size, at);
    return n < 0 ? -1 : n == (ssize_t)size;
}

int store_ends_with(int fd, int width, long sample, int *number)
{
    char record[RECORD_MAX];
    struct stat info;
    Row row;
    const size_t size = record_size(width);
    const int known = !fstat(fd, &info);
    const int there = !known                       ? -1
                      : info.st_size < (off_t)size ? 0
                                                   : record_read(fd, info.st_size - (off_t)size, size, record);
    *number = there < 0 ? errno : 0;
    if (there <= 0 || !record_is_sound(record, size)) return 0;
    memcpy(&row, record, sizeof row);
    return row.sample == sample;
}

/* All sound records of a file. One that is cut off in its end may be on its way: who appends there next cuts it. */
static int records_take(void *user, const OutDir *workers, const char *name)
{
    Rows *const rows = user;
    char record[RECORD_MAX];
    const size_t size = record_size(rows->width);
    const int fd = file_open_in(workers->at, name, O_RDONLY);
    if (fd < 0) return errno == ENOENT ? 0 : errno;
    int there = record_read(fd, 0, size, record);
    for (off_t at = (off_t)size; there > 0; at += (off_t)size) {
        if (record_is_sound(record, size)) record_take(record, rows);
        there = record_read(fd, at, size, record);
    }
    const int number = there < 0 ? errno : 0;
    close(fd);
    return number;
}

/* ----------------------------------------------------------------------------------------------------- the folder */

/* workers/study; *text NULL: it is not there. Errors: INPUT, MEMORY. */
static hawser_status owner_read(const char *dir, char **text, hawser_error *err)
{
    OutDir workers;
    OutSpot spot;
    size_t size;
    *text = NULL;
    if (workers_enter(&workers, dir, NULL))
        return errno == ENOENT ? HAWSER_OK : file_unread(dir, file_reason(errno), err);
    hawser_status status = out_spot(&spot, &workers, "study", err);
    if (!status) status = file_whole_in(workers.at, "study", spot.path, OWNER_MOST, text, &size, err);
    out_leave(&workers);
    return status;
}

/* Whose the files are: 1 this study's, 0 there are none, -1 another's. */
static hawser_status owner_find(const Study *s, const char *dir, int *own, hawser_error *err)
{
    char mine[IDENTITY_MAX], *text;
    hawser_status status = identity_say(s, mine, err);
    if (!status) status = owner_read(dir, &text, err);
    if (status) return status;
    *own = text ? -1 : 0;
    if (text && strncmp(text, mine, strlen(mine)) == 0) *own = 1;
    free(text);
    return status;
}

/* A row of a search at a point that the study does not have is not computed yet: a choice is one of its choices. */
static void points_look(const Study *s, Rows *rows)
{
    for (long i = 0; i < rows->n; i++) {
        const double *const x = rows->value + (size_t)i * (size_t)rows->width + s->n_quantities;
        for (int k = 0; rows->row[i].state != ROW_OPEN && k < s->n_parameters; k++) {
            const Parameter *const p = &s->parameter[k];
            const int ok = isfinite(x[k]) && (!p->chosen || (x[k] >= 0 && x[k] < p->n_choices));
            if (!ok) rows->row[i].state = ROW_OPEN;
        }
    }
}

hawser_status store_read(const Study *s, const char *dir, Rows *rows, hawser_error *err)
{
    int own;
    hawser_status status = owner_find(s, dir, &own, err);
    if (status || own == 0) return status;
    if (own < 0) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "'%.400s' holds the samples of another study (or the case has changed since): take another "
                         "folder, or begin anew with --fresh",
                         dir);
    }
    status = files_each(dir, "read", records_take, rows, err);
    if (!status && study_searches(s)) points_look(s, rows);
    return status;
}

hawser_status store_take(const char *dir, const char *crew, int k, Rows *rows, hawser_error *err)
{
    char path[OUT_PATH_MAX], name[ROWS_NAME_MAX];
    OutDir workers;
    const hawser_status status = store_path(path, dir, crew, k, err);
    if (status) return status;
    if (workers_enter(&workers, dir, NULL)) return errno == ENOENT ? HAWSER_OK : rows_error("read", path, errno, err);
    rows_name(name, crew, k);
    const int number = records_take(rows, &workers, name);
    out_leave(&workers);
    return number ? rows_error("read", path, number, err) : HAWSER_OK;
}

static int file_remove(void *user, const OutDir *workers, const char *name)
{
    (void)user;
    return file_remove_in(workers->at, name) ? 0 : errno;
}

/* workers/study: whose rows these are, and which file that was. */
static hawser_status owner_write(const Study *s, const OutDir *workers, hawser_error *err)
{
    char text[IDENTITY_MAX], path[PATH_MAX], whole[IDENTITY_MAX + PATH_MAX];
    if (!realpath(s->path, path)) return out_error(s->path, errno, err);
    const hawser_status status = identity_say(s, text, err);
    snprintf(whole, sizeof whole, "%s%s\n", text, path);
    return status ? status : out_whole_in(workers, "study", whole, err);
}

hawser_status store_begin(const Study *s, const char *dir, int fresh, hawser_error *err)
{
    OutDir outer, workers = {.at = -1};
    hawser_status status = out_enter(&outer, dir, err);
    if (!status && !folder_make_in(outer.at, "workers")) status = out_error(dir, errno, err);
    out_leave(&outer);
    if (!status) status = workers_enter(&workers, dir, err);
    if (!status && fresh) status = files_each(dir, "write", file_remove, NULL, err);
    static const char *const names[] = {"study", "sheet", "task.sh"};
    if (!status) out_sweep(&workers, sizeof names / sizeof *names, names);
    if (!status) status = owner_write(s, &workers, err);
    out_leave(&workers);
    return status;
}

hawser_status store_spare(const Study *s, const char *dir, hawser_error *err)
{
    static const char *const names[] = {"samples.csv", "study.h5", "study.html", "summary.json"};
    char folder[OUT_PATH_MAX], path[OUT_PATH_MAX];
    hawser_status status = out_join(folder, dir, "workers", err);
    for (size_t k = 0; k < sizeof names / sizeof *names && !status; k++) {
        status = out_join(path, dir, names[k], err);
        if (!status) status = file_marks_spare(&s->files, path, err);
    }
    OutDir inner = {.at = -1};
    struct dirent **list = NULL;
    const int n = status || workers_enter(&inner, dir, NULL) ? 0 : scandirat(inner.at, ".", &list, NULL, NULL);
    for (int k = 0; k < n; k++) {
        if (!status) status = out_join(path, folder, list[k]->d_name, err);
        if (!status) status = file_marks_spare(&s->files, path, err);
        free(list[k]);
    }
    free(list);
    out_leave(&inner);
    return status;
}

hawser_status store_study(const char *dir, char path[], hawser_error *err)
{
    char *text;
    const hawser_status status = owner_read(dir, &text, err);
    if (status) return status;
    const char *const second = text ? strchr(text, '\n') : NULL;
    const int found = second && second[1] && strcspn(second + 1, "\n") < OUT_PATH_MAX;
    if (found) snprintf(path, OUT_PATH_MAX, "%.*s", (int)strcspn(second + 1, "\n"), second + 1);
    free(text);
    return found ? HAWSER_OK : error_set(err, HAWSER_ERR_INPUT, "'%.400s' holds no study", dir);
}

hawser_status store_name(const Study *s, const char *dir, char name[STORE_NAME_MAX], hawser_error *err)
{
    uint64_t h = 0;
    const hawser_status status = study_identity(s, dir, &h, err);
    snprintf(name, STORE_NAME_MAX, "hawser-%016llx", (unsigned long long)h);
    return status;
}
