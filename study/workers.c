/* Workers' files: rows of one size, each with a checksum, appended and never changed. A truncated or damaged row counts
 * as missing. */
#define _GNU_SOURCE /* scandirat */
/* Worker processes. They take samples one by one from a shared counter; the parent waits, restarts workers that died,
 * ends those that take too long, and writes the row for them. A worker ends with its parent in any case. */
#define _GNU_SOURCE /* prctl */
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "core/machine.h"
#include "io/results/results_file.h"
#include "study/evaluate.h"

enum { IDENTITY_MAX = 128, RECORD_MAX = 1 << 16, OWNER_MOST = 1 << 16 };

/* Writes the line that identifies a folder's study. */
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

/* Sets the error of a file of rows that cannot be "read" or "written". */
static hawser_status rows_error(const char *what, const char *path, int number, hawser_error *err)
{
    return error_set(err, HAWSER_ERR_OUTPUT, "cannot %s '%.700s': %s", what, path, file_reason(number));
}

/* Calls `with` on every file of rows in dir/workers, by name, until one returns an error number, which becomes the
 * reason; `what`: the failed operation. Errors: OUTPUT, MEMORY. */
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
        /* a partial row would make all later ones unreadable */
        return done > 0 && ftruncate(fd, before.st_size) ? errno : why;
    }
    return 0;
}

/* Checks a record's checksum. */
static int record_is_sound(const char *record, size_t size)
{
    Hash h;
    memcpy(&h, record + size - sizeof h, sizeof h);
    return h == hash_bytes(HASH_BEGIN, record, size - sizeof h);
}

static int within(int32_t value, int least, int most) { return value >= least && value <= most; }

/* Checks that a row's values are possible: its checksum only shows that it is unchanged. */
static int row_is_one(const Row *row)
{
    return within(row->state, ROW_OPEN, ROW_DIED) && within(row->verdict, VERDICT_NONE, VERDICTS - 1) &&
           within(row->theory_verdict, VERDICT_NONE, VERDICTS - 1) && within(row->answered, BY_THEORY, BY_RUN) &&
           within(row->limited_by, -1, LIMIT_KINDS - 1) && memchr(row->reason, 0, sizeof row->reason);
}

/* Takes a record in; an answer takes precedence over none, else the first counts. */
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

/* Reads the record at a place. Returns 0 if the file ends before the record's end; < 0: error in errno. */
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

/* Takes all intact records of a file. A truncated one at its end may still be written: the next writer removes it. */
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

/* Reads workers/study; *text NULL: it does not exist. Errors: INPUT, MEMORY. */
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

/* Finds the owner of the files: 1 this study, 0 no files, -1 another study. */
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

/* Resets rows of a search at impossible points to not computed: a choice must be one of its choices. */
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

/* Writes workers/study: the identity of the rows' study, and its file. */
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

/* s: interval of checks of the workers, of calls to the caller, of syncs of a worker's file. */
static const double LOOK = 0.01, TELL = 0.25, SYNC = 1;

enum { JOBS_MAX = 1024, WORKER_OUTPUT = 4, WORKER_MEMORY = 5, WORKER_OTHER = 6, IDLE_DEATHS_MAX = 10 };

/* Shared data of a worker and the parent. */
typedef struct Slot {
    _Atomic long unit;                   /* the present search; -1: none */
    _Atomic long sample;                 /* the present sample; -1: none */
    double point[PARAMETERS_MAX];        /* its point */
    _Atomic long done, failed, not_safe; /* in this start of the study */
    _Atomic double since;                /* clock_now() at its start */
    _Atomic double busy;                 /* s of wall time in samples */
    _Atomic int number;                  /* errno of a row that could not be written */
} Slot;

typedef struct Board {
    _Atomic uint64_t range; /* available units: the next one, shifted by 32, and the end */
    _Atomic int closed;     /* there will be no more */
    Slot slot[];            /* [jobs] */
} Board;

typedef struct Engine {
    const Study *study;
    const char *dir, *crew;
    int jobs;
    Rows *rows;
    const Units *units;
    const Feed *feed; /* NULL: all units are available */
    Board *board;
    size_t board_size;
    pid_t pid[JOBS_MAX], parent; /* 0: this worker is over */
    int killed[JOBS_MAX];        /* because of the time limit */
    int idle_deaths;             /* number of workers that ended without a sample and without a reason */
} Engine;

/* ------------------------------------------------------------------------------------------------------ in a worker */

/* Prepares a worker: only the parent ends it, and its memory is limited if the study gives a limit. */
static void worker_settle(const Engine *e)
{
    const int ends[] = {SIGINT, SIGTERM, SIGHUP, SIGPIPE};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    if (getppid() != e->parent) _exit(0);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) signal(ends[k], SIG_IGN);
    if (e->study->memory == 0) return;
    const rlim_t bytes = (rlim_t)e->study->memory << 20;
    setrlimit(RLIMIT_AS, &(struct rlimit){bytes, bytes});
}

static void count_row(Slot *slot, const Row *row)
{
    slot->done++;
    if (row->state != ROW_DONE) slot->failed++;
    if (row->verdict == VERDICT_NOT_SAFE) slot->not_safe++;
}

/* State of a worker. */
typedef struct Worker {
    const Engine *engine;
    Slot *slot;
    int fd, number; /* its file; errno of an error */
    double synced;
} Worker;

/* Computes sample i at x and writes its row. Returns 0 on failure. */
static int sample_compute(void *user, long i, const double *x, Row *row, double *value)
{
    Worker *const w = user;
    Slot *const slot = w->slot;
    const Study *const s = w->engine->study;
    const double start = clock_now();
    memcpy(slot->point, x, (size_t)s->n_parameters * sizeof *x);
    slot->since = start;
    slot->sample = i;
    sample_evaluate(s, i, x, row, value);
    w->number = store_append(w->fd, row, value, row_width(s));
    const double now = clock_now();
    slot->busy = slot->busy + now - start;
    if (w->number) return 0;
    count_row(slot, row);
    slot->sample = -1;
    if (now - w->synced < SYNC) return 1;
    fdatasync(w->fd);
    w->synced = now;
    return 1;
}

static uint64_t range_of(long from, long to) { return (uint64_t)from << 32 | (uint64_t)to; }

static int range_is_empty(uint64_t range) { return range >> 32 == (range & UINT32_MAX); }

/* Claims the place of a unit in the list; < 0: there are no more. Waits while more may come. */
static long unit_claim(Board *b)
{
    const struct timespec pause = {.tv_nsec = 1000000};
    uint64_t range = b->range;
    for (;;) {
        if (!range_is_empty(range)) {
            if (atomic_compare_exchange_weak(&b->range, &range, range + ((uint64_t)1 << 32)))
                return (long)(range >> 32);
            continue;
        }
        const int closed = b->closed; /* read before the range, which may have been filled just before */
        range = b->range;
        if (!range_is_empty(range)) continue;
        if (closed) return -1;
        nanosleep(&pause, NULL);
    }
}

/* Computes a sample, or a search with all its open samples. */
static void unit_compute(Worker *w, long unit, double *value)
{
    const Engine *const e = w->engine;
    double x[PARAMETERS_MAX];
    Row row;
    int other = 0;
    if (!study_searches(e->study)) {
        study_point(e->study, unit, x);
        sample_compute(w, unit, x, &row, value);
        return;
    }
    w->slot->unit = unit;
    FitResult fit;
    const int ok = e->study->kind == STUDY_CALIBRATE
                       ? fit_samples(e->study, e->rows, sample_compute, w, &other, &fit)
                       : search_samples(e->study, unit, e->rows, sample_compute, w, &other);
    if (!ok) _exit(WORKER_MEMORY);
    if (other) _exit(WORKER_OTHER);
    if (!w->number) w->slot->unit = -1;
}

/* Computes units until there are no more; first the one that an earlier worker left unfinished. */
static _Noreturn void work(const Engine *e, int k)
{
    Slot *const slot = &e->board->slot[k];
    const int width = row_width(e->study);
    double *const value = malloc(((size_t)width + 1) * sizeof *value);
    Worker w = {.engine = e, .slot = slot, .fd = value ? store_open(e->dir, e->crew, k) : -1, .synced = clock_now()};
    w.number = w.fd < 0 ? value ? errno : ENOMEM : store_mend(w.fd, width);
    if (!w.number && slot->unit >= 0) unit_compute(&w, slot->unit, value);
    for (long at; !w.number && (at = unit_claim(e->board)) >= 0;)
        unit_compute(&w, e->units->unit ? e->units->unit[at] : at, value);
    if (!w.number && fdatasync(w.fd) && errno != EINVAL) w.number = errno; /* pipes and the like do not support sync */
    slot->number = w.number;
    _exit(w.number ? WORKER_OUTPUT : 0);
}

/* ------------------------------------------------------------------------------------------------------ in the parent
 */

static hawser_status worker_start(Engine *e, int k, hawser_error *err)
{
    e->board->slot[k].sample = -1;
    e->killed[k] = 0;
    fflush(NULL); /* avoids duplicate output */
    e->pid[k] = fork();
    if (e->pid[k] == 0) {
        worker_settle(e);
        work(e, k);
    }
    if (e->pid[k] > 0) return HAWSER_OK;
    e->pid[k] = 0;
    return error_set(err, HAWSER_ERR_MEMORY, "no process can be started: %s", strerror(errno));
}

/* Writes the row of a sample that ended its worker, unless it has just been written. */
static int row_for(const Engine *e, int k, int wait_status)
{
    Slot *const slot = &e->board->slot[k];
    const int q = e->study->n_quantities, width = row_width(e->study);
    double *const value = malloc(((size_t)width + 1) * sizeof *value);
    const int fd = value ? store_open(e->dir, e->crew, k) : -1;
    int number = fd < 0 ? value ? errno : ENOMEM : store_mend(fd, width);
    Row row;
    memset(&row, 0, sizeof row);
    row.sample = slot->sample;
    row.state = e->killed[k] ? ROW_TIME : ROW_DIED;
    row.limited_by = -1;
    for (int i = 0; i < LIMIT_KINDS; i++) row.margin[i] = row.theory[i] = NAN;
    for (int i = 0; i < width && value; i++)
        value[i] = i < q || i >= q + e->study->n_parameters ? NAN : slot->point[i - q];
    if (e->killed[k]) {
        snprintf(row.reason, sizeof row.reason, "took longer than %g s", e->study->time_limit);
    } else if (WIFSIGNALED(wait_status)) {
        snprintf(row.reason, sizeof row.reason, "its process was ended by signal %d (%s)", WTERMSIG(wait_status),
                 strsignal(WTERMSIG(wait_status)));
    } else {
        snprintf(row.reason, sizeof row.reason, "its process ended with status %d", WEXITSTATUS(wait_status));
    }
    const int there = !number && store_ends_with(fd, width, slot->sample, &number);
    if (!number && !there) number = store_append(fd, &row, value, width);
    if (!number && !there) count_row(slot, &row);
    if (fd >= 0) close(fd);
    free(value);
    return number;
}

/* Handles the end of a worker: by itself, or with its sample, and then another one takes its place. */
static hawser_status worker_over(Engine *e, int k, int wait_status, hawser_error *err)
{
    Slot *const slot = &e->board->slot[k];
    e->pid[k] = 0;
    int number = slot->number;
    const int fine = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0;
    if (!number && !fine && slot->sample >= 0) number = row_for(e, k, wait_status);
    if (number) {
        char path[OUT_PATH_MAX];
        const hawser_status status = store_path(path, e->dir, e->crew, k, err);
        return status ? status : out_error(path, number, err);
    }
    if (fine) return HAWSER_OK;
    if (WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == WORKER_MEMORY) return error_memory(err);
    if (WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == WORKER_OTHER) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the search does not reproduce the samples in '%.400s', which another machine has computed: "
                         "take another folder, or begin anew with --fresh",
                         e->dir);
    }
    if (slot->sample < 0 && ++e->idle_deaths > IDLE_DEATHS_MAX)
        return error_set(err, HAWSER_ERR_MEMORY, "workers end before their first sample: is 'memory' too small?");
    const int over = e->board->closed && range_is_empty(e->board->range);
    if (slot->unit < 0) return over ? HAWSER_OK : worker_start(e, k, err);
    const hawser_status status = store_take(e->dir, e->crew, k, e->rows, err);
    return status ? status : worker_start(e, k, err);
}

/* Checks all workers once. *running: their number afterwards. */
static hawser_status workers_look(Engine *e, int *running, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    *running = 0;
    for (int k = 0; k < e->jobs && !status; k++) {
        int how;
        if (!e->pid[k]) continue;
        const Slot *const slot = &e->board->slot[k];
        const int late =
            slot->sample >= 0 && e->study->time_limit > 0 && clock_now() - slot->since > e->study->time_limit;
        if (late && !e->killed[k]) {
            e->killed[k] = 1;
            kill(e->pid[k], SIGKILL);
        }
        if (waitpid(e->pid[k], &how, WNOHANG) == e->pid[k]) status = worker_over(e, k, how, err);
        *running += e->pid[k] != 0;
    }
    return status;
}

static void workers_end(Engine *e)
{
    for (int k = 0; k < e->jobs; k++) {
        if (e->pid[k]) kill(e->pid[k], SIGKILL);
    }
    for (int k = 0; k < e->jobs; k++) {
        if (e->pid[k]) waitpid(e->pid[k], NULL, 0);
        e->pid[k] = 0;
    }
}

/* Present state; `before`: rows of earlier starts. */
static hawser_study_state state_now(const Engine *e, const hawser_study_state *before, double wall)
{
    hawser_study_state now = *before;
    for (int k = 0; k < e->jobs; k++) {
        now.done += e->board->slot[k].done;
        now.failed += e->board->slot[k].failed;
        now.not_safe += e->board->slot[k].not_safe;
    }
    const long mine = now.done - before->done;
    now.wall_s = wall;
    now.left_s = mine > 0 ? wall / (double)mine * (double)(now.samples - now.done) : NAN;
    return now;
}

/* Makes further units available if several engines share them. */
static hawser_status workers_feed(Engine *e, hawser_study_state *state, hawser_error *err)
{
    long from, to;
    if (!e->feed) return HAWSER_OK;
    const Fed fed =
        e->feed->more(e->feed->user, !e->board->closed && range_is_empty(e->board->range), state, &from, &to);
    if (fed == FED_MORE) e->board->range = range_of(from, to);
    if (fed == FED_NO_MORE) e->board->closed = 1;
    return fed == FED_STOP ? error_set(err, HAWSER_STOPPED, "stopped by another rank") : HAWSER_OK;
}

/* Waits until all workers are over, or the caller stops them. */
static hawser_status wait_all(Engine *e, const hawser_study_options *options, const hawser_study_state *before,
                              hawser_error *err)
{
    const double start = clock_now();
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
    double told = start;
    int running = 1;
    hawser_status status = HAWSER_OK;
    while (running && !status) {
        nanosleep(&pause, NULL);
        status = workers_look(e, &running, err);
        const double now = clock_now();
        hawser_study_state state = state_now(e, before, now - start);
        if (!status) status = workers_feed(e, &state, err);
        if (status || !options->progress || (running && now - told < TELL)) continue;
        told = now;
        if (options->progress(options->user, &state) && running)
            status = error_set(err, HAWSER_STOPPED, "stopped with %ld of %ld samples: the same command continues",
                               state.done, state.samples);
    }
    workers_end(e);
    return status;
}

/* Records that a search needs a sample, so that it is open. */
static int note_open(void *user, long i, const double *x, Row *row, double *value)
{
    (void)i, (void)x, (void)row, (void)value;
    *(int *)user = 1;
    return 0;
}

/* Checks whether a search is incomplete, by repeating it with the available samples; one that finds another search's
 * samples is open too, so that it is computed and reports it. */
static int search_is_open(const Study *s, long c, const Rows *rows)
{
    int open = 0, other = 0;
    FitResult fit;
    const int ok = s->kind == STUDY_CALIBRATE ? fit_samples(s, rows, note_open, &open, &other, &fit)
                                              : search_samples(s, c, rows, note_open, &open, &other);
    return open || other || !ok;
}

hawser_status units_open(const Study *s, int pilots, const Rows *rows, Units *open, hawser_error *err)
{
    const int searches = study_searches(s);
    const long n = searches ? s->blocks : rows->n;
    *open =
        (Units){.unit = malloc(((size_t)n + 1) * sizeof *open->unit), .before = {.samples = rows->n, .left_s = NAN}};
    if (!open->unit) return error_memory(err);
    for (long i = 0; i < rows->n; i++) {
        open->before.done += rows->row[i].state != ROW_OPEN;
        open->before.failed += rows->row[i].state > ROW_DONE;
        open->before.not_safe += rows->row[i].verdict == VERDICT_NOT_SAFE;
    }
    for (long i = 0; i < n; i++) {
        const int is_open =
            searches ? search_is_open(s, i, rows) : rows->row[i].state == ROW_OPEN && (!pilots || study_is_pilot(s, i));
        if (is_open) open->unit[open->n++] = i;
    }
    return HAWSER_OK;
}

static hawser_status board_make(Engine *e, hawser_error *err)
{
    e->board_size = sizeof(Board) + (size_t)e->jobs * sizeof(Slot);
    e->board = mmap(NULL, e->board_size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (e->board == MAP_FAILED) e->board = NULL;
    if (!e->board) return error_memory(err);
    for (int k = 0; k < e->jobs; k++) e->board->slot[k].unit = -1;
    if (e->feed) return HAWSER_OK;
    e->board->range = range_of(0, e->units->n);
    e->board->closed = 1;
    return HAWSER_OK;
}

static int jobs_of(const hawser_study_options *options, long units)
{
    long jobs = options->jobs > 0 ? options->jobs : sysconf(_SC_NPROCESSORS_ONLN);
    jobs = jobs < 1 ? 1 : jobs > JOBS_MAX ? JOBS_MAX : jobs;
    return (int)(jobs > units ? units : jobs);
}

hawser_status engine_run(const Study *s, const char *dir, const char *crew, const hawser_study_options *options,
                         const Units *units, const Feed *feed, Rows *rows, double *efficiency, hawser_error *err)
{
    Engine e = {.study = s, .dir = dir, .crew = crew, .rows = rows, .units = units, .feed = feed, .parent = getpid()};
    hawser_study_state before = units->before;
    *efficiency = NAN;
    if (units->n == 0) return HAWSER_OK;
    before.jobs = e.jobs = jobs_of(options, units->n);
    hawser_status status = board_make(&e, err);
    const double start = clock_now();
    for (int k = 0; k < e.jobs && !status; k++) status = worker_start(&e, k, err);
    if (status) workers_end(&e);
    if (!status) status = wait_all(&e, options, &before, err);
    double busy = 0;
    for (int k = 0; k < e.jobs && e.board; k++) busy += e.board->slot[k].busy;
    if (busy > 0) *efficiency = busy / ((clock_now() - start) * e.jobs);
    if (e.board) munmap(e.board, e.board_size);
    return status;
}
