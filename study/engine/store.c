/* Workers' files: rows of one size, each with a check sum, appended and never changed. A row that is cut
 * off or damaged counts as not there. */
#define _DEFAULT_SOURCE /* scandir */
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

/* dir/workers, and a file in it. */
static hawser_status workers_path(char path[OUT_PATH_MAX], const char *dir, const char *name, hawser_error *err)
{
    char folder[OUT_PATH_MAX];
    const hawser_status status = out_join(folder, dir, "workers", err);
    return status ? status : out_join(path, folder, name, err);
}

static const char ENDING[] = ".rows";

hawser_status store_path(char path[], const char *dir, const char *crew, int k, hawser_error *err)
{
    char name[CREW_MAX + 20];
    snprintf(name, sizeof name, "%.*s-%d%s", CREW_MAX, crew, k, ENDING);
    return workers_path(path, dir, name, err);
}

static int is_rows(const struct dirent *entry)
{
    const size_t n = strlen(entry->d_name), end = sizeof ENDING - 1;
    return n > end && strcmp(entry->d_name + n - end, ENDING) == 0;
}

/* A file of rows that cannot be "read" or "written". */
static hawser_status rows_error(const char *what, const char *path, int number, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot %s '%.700s': %s", what, path, strerror(number));
}

/* Calls `with` on every file of rows in dir/workers, in the order of their names, until one returns another number than
 * 0, which is why the file cannot be done `what` with. Errors: OUTPUT, MEMORY. */
typedef int (*RowsFile)(void *user, const char *path);
static hawser_status files_each(const char *dir, const char *what, RowsFile with, void *user, hawser_error *err)
{
    char folder[OUT_PATH_MAX], path[OUT_PATH_MAX];
    struct dirent **list = NULL;
    hawser_status status = out_join(folder, dir, "workers", err);
    const int n = status ? 0 : scandir(folder, &list, is_rows, alphasort);
    if (n < 0 && errno == ENOMEM) return error_memory(err);
    if (n < 0 && errno != ENOENT) return rows_error("read", folder, errno, err);
    for (int k = 0; k < n; k++) {
        if (!status) status = out_join(path, folder, list[k]->d_name, err);
        const int number = status ? 0 : with(user, path);
        if (number) status = rows_error(what, path, number, err);
        free(list[k]);
    }
    free(list);
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
    char path[OUT_PATH_MAX];
    if (store_path(path, dir, crew, k, NULL)) {
        errno = ENAMETOOLONG;
        return -1;
    }
    return open(path, O_RDWR | O_CREAT | O_APPEND | O_CLOEXEC, 0666);
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
    return within(row->state, ROW_OPEN, ROW_DIED) && within(row->verdict, VERDICT_NONE, VERDICT_NOT_TRUSTED) &&
           within(row->theory_verdict, VERDICT_NONE, VERDICT_NOT_TRUSTED) && within(row->answered, BY_THEORY, BY_RUN) &&
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
static int records_take(void *user, const char *path)
{
    Rows *const rows = user;
    char record[RECORD_MAX];
    const size_t size = record_size(rows->width);
    const int fd = open(path, O_RDONLY | O_CLOEXEC);
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

/* Whose the files are: 1 this study's, 0 there are none, -1 another's. */
static hawser_status owner_find(const Study *s, const char *dir, int *own, hawser_error *err)
{
    char path[OUT_PATH_MAX], mine[IDENTITY_MAX];
    hawser_status status = workers_path(path, dir, "study", err);
    if (!status) status = identity_say(s, mine, err);
    if (status) return status;
    char *text;
    size_t size;
    status = file_whole(path, OWNER_MOST, &text, &size, err);
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
    char path[OUT_PATH_MAX];
    const hawser_status status = store_path(path, dir, crew, k, err);
    const int number = status ? 0 : records_take(rows, path);
    return number ? rows_error("read", path, number, err) : status;
}

static int file_remove(void *user, const char *path)
{
    (void)user;
    return unlink(path) ? errno : 0;
}

/* workers/study: whose rows these are, and which file that was. */
static hawser_status owner_write(const Study *s, const char *folder, hawser_error *err)
{
    char text[IDENTITY_MAX], path[PATH_MAX], whole[IDENTITY_MAX + PATH_MAX];
    if (!realpath(s->path, path)) return out_error(s->path, errno, err);
    const hawser_status status = identity_say(s, text, err);
    snprintf(whole, sizeof whole, "%s%s\n", text, path);
    return status ? status : out_whole(folder, "study", whole, err);
}

hawser_status store_begin(const Study *s, const char *dir, int fresh, hawser_error *err)
{
    char folder[OUT_PATH_MAX];
    hawser_status status = out_join(folder, dir, "workers", err);
    if (!status) status = out_make_dir(folder, err);
    if (!status && fresh) status = files_each(dir, "write", file_remove, NULL, err);
    return status ? status : owner_write(s, folder, err);
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
    DIR *const workers = status ? NULL : opendir(folder);
    for (const struct dirent *each; workers && !status && (each = readdir(workers));) {
        status = out_join(path, folder, each->d_name, err);
        if (!status) status = file_marks_spare(&s->files, path, err);
    }
    if (workers) closedir(workers);
    return status;
}

hawser_status store_study(const char *dir, char path[], hawser_error *err)
{
    char from[OUT_PATH_MAX], *text;
    size_t size;
    hawser_status status = workers_path(from, dir, "study", err);
    if (!status) status = file_whole(from, OWNER_MOST, &text, &size, err);
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
