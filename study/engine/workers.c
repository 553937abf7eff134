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
enum { JOBS_MAX = 1024, WORKER_OUTPUT = 4, WORKER_MEMORY = 5, WORKER_OTHER = 6, IDLE_DEATHS_MAX = 10 };

/* What a worker and the parent tell each other. */
typedef struct Slot {
    _Atomic long unit;                   /* a search that is on its way; -1: none */
    _Atomic long sample;                 /* being computed; -1: none */
    double point[PARAMETERS_MAX];        /* where that is */
    _Atomic long done, failed, not_safe; /* in this start of the study */
    _Atomic double since;                /* clock_now() when it was begun */
    _Atomic double busy;                 /* s of wall time with samples */
    _Atomic int number;                  /* errno of a row that could not be written */
} Slot;

typedef struct Board {
    _Atomic uint64_t range; /* of the units that are to be had: the next one, shifted by 32, and the end */
    _Atomic int closed;     /* there will be no more */
    Slot slot[];            /* [jobs] */
} Board;

typedef struct Engine {
    const Study *study;
    const char *dir, *crew;
    int jobs;
    Rows *rows;
    const Units *units;
    const Feed *feed; /* NULL: all units at once */
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

/* A worker at work. */
typedef struct Worker {
    const Engine *engine;
    Slot *slot;
    int fd, number; /* its file; errno of what went wrong */
    double synced;
} Worker;

/* Computes sample i at x and writes its row. Returns 0 if that cannot be done. */
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

/* The place in the list of a unit that nobody else gets; < 0: there are no more. Waits where there may be. */
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
        const int closed = b->closed; /* before the range, which may have been filled just before */
        range = b->range;
        if (!range_is_empty(range)) continue;
        if (closed) return -1;
        nanosleep(&pause, NULL);
    }
}

/* A sample, or a search with all of its samples that are open. */
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

/* Unit after unit until there are no more; first that which a worker before left unfinished. */
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
    if (!w.number && fdatasync(w.fd) && errno != EINVAL) w.number = errno; /* pipes and the like know no sync */
    slot->number = w.number;
    _exit(w.number ? WORKER_OUTPUT : 0);
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

/* The row of a sample that ended its worker, unless it has just been written. */
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

/* A worker is over: by itself, or with the sample that it had, and then another takes its place. */
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
                         "the search does not meet the samples in '%.400s' again, which another machine has computed: "
                         "take another folder, or begin anew with --fresh",
                         e->dir);
    }
    if (slot->sample < 0 && ++e->idle_deaths > IDLE_DEATHS_MAX)
        return error_set(err, HAWSER_ERR_MEMORY, "workers end before they begin: is 'memory' too small?");
    const int over = e->board->closed && range_is_empty(e->board->range);
    if (slot->unit < 0) return over ? HAWSER_OK : worker_start(e, k, err);
    const hawser_status status = store_take(e->dir, e->crew, k, e->rows, err);
    return status ? status : worker_start(e, k, err);
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

/* What the workers may take next, where several engines share the units. */
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
        hawser_study_state state = state_now(e, before, now - start);
        if (!status) status = workers_feed(e, &state, err);
        if (status || !options->progress || (running && now - told < TELL)) continue;
        told = now;
        if (options->progress(options->user, &state) && running)
            status = error_set(err, HAWSER_STOPPED, "stopped with %ld of %ld samples: the same command goes on",
                               state.done, state.samples);
    }
    workers_end(e);
    return status;
}

/* A search that asks for a sample has one open. */
static int note_open(void *user, long i, const double *x, Row *row, double *value)
{
    (void)i, (void)x, (void)row, (void)value;
    *(int *)user = 1;
    return 0;
}

/* Whether a search is not at its end, by going through the samples that are there; one that meets another's is open
 * too, so that it is computed and complains. */
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
