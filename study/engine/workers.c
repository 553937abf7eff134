/* Worker processes. They take samples one after the other from a counter that all share; the parent waits, restarts
 * workers that died, ends those that take too long, and writes the row for them. A worker ends with its parent, however
 * that ends. */
#define _GNU_SOURCE /* prctl */
#include <errno.h>
#include <math.h>
#include <signal.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "io/results/results_file.h"
#include "study/engine/engine.h"

/* s: between looks at the workers, between words to the caller, between syncs of a worker's file. */
static const double LOOK = 0.01, TELL = 0.25, SYNC = 1;
enum { JOBS_MAX = 1024, WORKER_OUTPUT = 4, IDLE_DEATHS_MAX = 10 };

/* What a worker and the parent tell each other. */
typedef struct Slot {
    _Atomic long sample;                 /* being computed; -1: none */
    _Atomic long done, failed, not_safe; /* in this start of the study */
    _Atomic double since;                /* clock_now() when it was begun */
    _Atomic double busy;                 /* s of wall time with samples */
    _Atomic int number;                  /* errno of a row that could not be written */
} Slot;

typedef struct Board {
    _Atomic long next; /* of `open` */
    Slot slot[];       /* [jobs] */
} Board;

typedef struct Engine {
    const Study *study;
    const char *dir;
    int jobs;
    long n_open, *open; /* [n_open] samples to be computed */
    Board *board;
    size_t board_size;
    pid_t pid[JOBS_MAX], parent; /* 0: this worker is over */
    int killed[JOBS_MAX];        /* because of the time limit */
    int idle_deaths;             /* workers that ended without a sample and without a reason */
} Engine;

/* ------------------------------------------------------------------------------------------------------ in a worker */

/* Nothing but the parent ends a worker; its memory is limited where the study says so. */
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

/* Sample after sample until there are no more. */
static _Noreturn void work(const Engine *e, int k)
{
    Slot *const slot = &e->board->slot[k];
    double *const value = malloc(((size_t)e->study->n_quantities + 1) * sizeof *value);
    const int fd = value ? store_open(e->dir, k) : -1;
    int number = fd < 0 ? value ? errno : ENOMEM : store_mend(fd, e->study->n_quantities);
    double synced = clock_now();
    for (long at; !number && (at = atomic_fetch_add(&e->board->next, 1)) < e->n_open;) {
        Row row;
        const double start = clock_now();
        slot->since = start;
        slot->sample = e->open[at];
        sample_evaluate(e->study, e->open[at], &row, value);
        number = store_append(fd, &row, value, e->study->n_quantities);
        const double now = clock_now();
        slot->busy = slot->busy + now - start;
        if (number) break;
        count_row(slot, &row);
        slot->sample = -1;
        if (now - synced < SYNC) continue;
        fdatasync(fd);
        synced = now;
    }
    if (!number && fdatasync(fd) && errno != EINVAL) number = errno; /* pipes and the like know no sync */
    slot->number = number;
    _exit(number ? WORKER_OUTPUT : 0);
}

/* ------------------------------------------------------------------------------------------------------ in the parent
 */

static hawser_status worker_start(Engine *e, int k, hawser_error *err)
{
    e->board->slot[k].sample = -1;
    e->killed[k] = 0;
    fflush(NULL); /* nothing is written twice */
    e->pid[k] = fork();
    if (e->pid[k] == 0) {
        worker_settle(e);
        work(e, k);
    }
    if (e->pid[k] > 0) return HAWSER_OK;
    e->pid[k] = 0;
    return error_set(err, HAWSER_ERR_MEMORY, "no process can be started: %s", strerror(errno));
}

/* The row of a sample that ended its worker. */
static int row_for(const Engine *e, int k, int wait_status)
{
    Slot *const slot = &e->board->slot[k];
    const int q = e->study->n_quantities;
    double *const value = malloc(((size_t)q + 1) * sizeof *value);
    const int fd = value ? store_open(e->dir, k) : -1;
    int number = fd < 0 ? value ? errno : ENOMEM : store_mend(fd, q);
    Row row;
    memset(&row, 0, sizeof row);
    row.sample = slot->sample;
    row.state = e->killed[k] ? ROW_TIME : ROW_DIED;
    row.limited_by = -1;
    for (int i = 0; i < LIMIT_KINDS; i++) row.margin[i] = NAN;
    for (int i = 0; i < q && value; i++) value[i] = NAN;
    if (e->killed[k]) {
        snprintf(row.reason, sizeof row.reason, "took longer than %g s", e->study->time_limit);
    } else if (WIFSIGNALED(wait_status)) {
        snprintf(row.reason, sizeof row.reason, "its process was ended by signal %d (%s)", WTERMSIG(wait_status),
                 strsignal(WTERMSIG(wait_status)));
    } else {
        snprintf(row.reason, sizeof row.reason, "its process ended with status %d", WEXITSTATUS(wait_status));
    }
    if (!number) number = store_append(fd, &row, value, q);
    if (!number) count_row(slot, &row);
    if (fd >= 0) close(fd);
    free(value);
    return number;
}

/* A worker is over: by itself, or with the sample that it had, and then another takes its place. */
static hawser_status worker_over(Engine *e, int k, int wait_status, hawser_error *err)
{
    Slot *const slot = &e->board->slot[k];
    e->pid[k] = 0;
    int number = slot->number;
    const int fine = WIFEXITED(wait_status) && WEXITSTATUS(wait_status) == 0;
    if (!number && !fine && slot->sample >= 0) number = row_for(e, k, wait_status);
    if (number) {
        char name[OUT_PATH_MAX];
        snprintf(name, sizeof name, "%.4000s/workers/worker-%d.rows", e->dir, k);
        return out_error(name, number, err);
    }
    if (fine) return HAWSER_OK;
    if (slot->sample < 0 && ++e->idle_deaths > IDLE_DEATHS_MAX)
        return error_set(err, HAWSER_ERR_MEMORY, "workers end before they begin: is 'memory' too small?");
    return e->board->next >= e->n_open ? HAWSER_OK : worker_start(e, k, err);
}

/* One look at all workers. *running: how many there are afterwards. */
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

/* What is there by now; `before`: rows of earlier starts. */
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

/* Until all workers are over, or the caller has enough. */
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
        if (status || !options->progress || (running && now - told < TELL)) continue;
        const hawser_study_state state = state_now(e, before, now - start);
        told = now;
        if (options->progress(options->user, &state) && running)
            status = error_set(err, HAWSER_STOPPED, "stopped with %ld of %ld samples: the same command goes on",
                               state.done, state.samples);
    }
    workers_end(e);
    return status;
}

/* Which samples are open, and what the others were. */
static hawser_status open_find(Engine *e, const Rows *rows, hawser_study_state *before, hawser_error *err)
{
    e->open = malloc(((size_t)rows->n + 1) * sizeof *e->open);
    if (!e->open) return error_memory(err);
    for (long i = 0; i < rows->n; i++) {
        const Row *const row = &rows->row[i];
        if (row->state == ROW_OPEN) e->open[e->n_open++] = i;
        before->done += row->state != ROW_OPEN;
        before->failed += row->state > ROW_DONE;
        before->not_safe += row->verdict == VERDICT_NOT_SAFE;
    }
    return HAWSER_OK;
}

static hawser_status board_make(Engine *e, hawser_error *err)
{
    e->board_size = sizeof(Board) + (size_t)e->jobs * sizeof(Slot);
    e->board = mmap(NULL, e->board_size, PROT_READ | PROT_WRITE, MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (e->board != MAP_FAILED) return HAWSER_OK;
    e->board = NULL;
    return error_memory(err);
}

static int jobs_of(const hawser_study_options *options, long n_open)
{
    long jobs = options->jobs > 0 ? options->jobs : sysconf(_SC_NPROCESSORS_ONLN);
    jobs = jobs < 1 ? 1 : jobs > JOBS_MAX ? JOBS_MAX : jobs;
    return (int)(jobs > n_open ? n_open : jobs);
}

hawser_status engine_run(const Study *s, const char *dir, const hawser_study_options *options, Rows *rows,
                         double *efficiency, hawser_error *err)
{
    Engine e = {.study = s, .dir = dir, .parent = getpid()};
    hawser_study_state before = {.samples = rows->n};
    *efficiency = NAN;
    hawser_status status = open_find(&e, rows, &before, err);
    before.jobs = e.jobs = status ? 0 : jobs_of(options, e.n_open);
    if (!status && e.n_open > 0) status = board_make(&e, err);
    const double start = clock_now();
    for (int k = 0; k < e.jobs && !status; k++) status = worker_start(&e, k, err);
    if (status) workers_end(&e);
    if (!status && e.n_open > 0) status = wait_all(&e, options, &before, err);
    double busy = 0;
    for (int k = 0; k < e.jobs && e.board; k++) busy += e.board->slot[k].busy;
    if (e.n_open > 0) *efficiency = busy / ((clock_now() - start) * e.jobs);
    if (e.board) munmap(e.board, e.board_size);
    free(e.open);
    hawser_error late;
    const hawser_status read = store_read(s, dir, rows, &late);
    if (read && !status) status = error_set(err, read, "%s", late.message);
    return status;
}
