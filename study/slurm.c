/* Ranks by MPI, whose functions are in a separate library beside the program. */
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/error.h"
#include "core/machine.h"
#include "hawser/hawser.h"
#include "io/case/library.h"
#include "io/results/results_file.h"
#include "study/evaluate.h"

/* Loads the library with global symbols: MPI loads parts of itself that need its functions. */
hawser_status hawser_ranks_open(hawser_ranks *ranks, hawser_error *err)
{
    if (!ranks) return error_argument(err, "ranks");
    char *const path = shipped_find(HAWSER_MPI_PLACE);
    *ranks = (hawser_ranks){0};
    if (!path) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%s is not beside the program: hawser was built where there is no MPI "
                         "(docs/guide/studies-and-measured-pulls.md)",
                         HAWSER_MPI_PLACE);
    }
    void *const library = dlopen(path, RTLD_NOW | RTLD_GLOBAL);
    free(path);
    if (!library) return error_set(err, HAWSER_ERR_INPUT, "MPI cannot be loaded: %s", dlerror());
    void *const found = dlsym(library, "hawser_mpi_open");
    int (*begin)(hawser_ranks *) = NULL;
    *(void **)&begin = found;
    if (!begin || begin(ranks)) return error_set(err, HAWSER_ERR_INPUT, "MPI cannot be started");
    return HAWSER_OK;
}

void hawser_ranks_close(hawser_ranks *ranks)
{
    if (!ranks) return;
    if (ranks->end) ranks->end(ranks->user);
    *ranks = (hawser_ranks){0};
}

/* A study on several ranks. Rank 0 distributes ranges of the open units, half of the remainder over all ranks at a
 * time, so that the last ones are short; it computes too, since workers are separate processes. Each rank appends to
 * its own files. Units left open by a rank that died are computed by the next start. */

/* s: interval of a rank's progress messages; interval of polling for messages when there is nothing else to do. */
static const double TELL = 0.25, LOOK = 0.01;

/* message[0]; then done, failed, not safe for ASK, TELL and OVER; from, to for RANGE; a status for OVER. */
typedef enum Say { SAY_TELL, SAY_ASK, SAY_OVER, SAY_RANGE, SAY_CLOSED, SAY_STOP, SAY_PART } Say;

enum { SAID_STATE = 1, SAID_STATUS = 4, SAID_RANGE = 1 };

/* State of another rank, as known to rank 0. */
typedef struct Mate {
    int asks, over, stopped;
    hawser_status status;
    int64_t state[3];
} Mate;

typedef struct Ranked {
    const hawser_ranks *ranks;
    const Units *units;
    long next;                  /* rank 0: the first unit that is not assigned */
    int single;                 /* units are long: assigned one at a time */
    Mate *mate;                 /* rank 0: [count]; its own is not used */
    int asked, closed, stopped; /* another rank */
    double told;
} Ranked;

static void say(const Ranked *r, int to, Say what, int64_t a, int64_t b)
{
    const int64_t message[HAWSER_RANK_WORDS] = {(int64_t)what, a, b};
    r->ranks->send(r->ranks->user, to, message);
}

static void say_state(const Ranked *r, Say what, const hawser_study_state *own, hawser_status status)
{
    const int64_t message[HAWSER_RANK_WORDS] = {what, own->done, own->failed, own->not_safe, (int64_t)status};
    r->ranks->send(r->ranks->user, 0, message);
}

/* ---------------------------------------------------------------------------------------------------------- rank 0 */

/* Takes places from .. to-1 of the list of open units; their units are contiguous. */
static Fed range_take(Ranked *r, long *from, long *to)
{
    const Units *const u = r->units;
    const long left = u->n - r->next, share = r->single ? 1 : left / (2 * r->ranks->count);
    if (left == 0) return FED_NO_MORE;
    *from = r->next++;
    while (r->next - *from < share && u->unit[r->next] == u->unit[r->next - 1] + 1) r->next++;
    *to = r->next;
    return FED_MORE;
}

/* Reads all pending messages, and answers requests. */
static void messages_serve(Ranked *r)
{
    int64_t message[HAWSER_RANK_WORDS];
    int from;
    while (r->ranks->receive(r->ranks->user, &from, message)) {
        Mate *const m = &r->mate[from];
        memcpy(m->state, message + SAID_STATE, sizeof m->state);
        if (message[0] == SAY_ASK) m->asks = 1;
        if (message[0] == SAY_OVER) m->over = 1;
        if (message[0] == SAY_OVER) m->status = (hawser_status)message[SAID_STATUS];
    }
    for (int k = 1; k < r->ranks->count; k++) {
        long a = 0, b = 0;
        if (!r->mate[k].asks || r->mate[k].over) continue;
        const Fed fed = range_take(r, &a, &b);
        if (fed == FED_MORE) say(r, k, SAY_RANGE, r->units->unit[a], r->units->unit[b - 1] + 1);
        if (fed == FED_NO_MORE) say(r, k, SAY_CLOSED, 0, 0);
        r->mate[k].asks = 0;
    }
}

/* Adds the state of all ranks. */
static void state_add(const Ranked *r, hawser_study_state *state)
{
    const long before = r->units->before.done;
    for (int k = 1; k < r->ranks->count; k++) {
        state->done += r->mate[k].state[0];
        state->failed += r->mate[k].state[1];
        state->not_safe += r->mate[k].state[2];
    }
    const long mine = state->done - before;
    state->jobs *= r->ranks->count;
    state->left_s = mine > 0 ? state->wall_s / (double)mine * (double)(state->samples - state->done) : NAN;
}

static Fed first_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Ranked *const r = user;
    messages_serve(r);
    state_add(r, state);
    for (int k = 1; k < r->ranks->count; k++) {
        if (r->mate[k].over && r->mate[k].status) return FED_STOP;
    }
    return empty ? range_take(r, from, to) : FED_NOT_YET;
}

/* Waits after its own workers until all other ranks are over; they stop if `status` is not OK. Returns the first error.
 */
static hawser_status others_wait(Ranked *r, const hawser_study_options *options, hawser_study_state *own,
                                 hawser_status status, hawser_error *err)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
    const double start = clock_now() - own->wall_s;
    double told = 0;
    for (int open = 1; open;) {
        open = 0;
        messages_serve(r);
        for (int k = 1; k < r->ranks->count; k++) {
            Mate *const m = &r->mate[k];
            open += !m->over;
            if (m->over && m->status && !status)
                status = error_set(err, m->status, "rank %d failed: the same command continues the study", k);
            if (status && !m->over && !m->stopped) say(r, k, SAY_STOP, 0, 0);
            m->stopped |= status && !m->over;
        }
        const double now = clock_now();
        if (open) nanosleep(&pause, NULL);
        if (!options->progress || (open && now - told < TELL)) continue;
        hawser_study_state state = *own;
        state.wall_s = now - start;
        state_add(r, &state);
        told = now;
        if (options->progress(options->user, &state) && open && !status)
            status = error_set(err, HAWSER_STOPPED, "stopped with %ld of %ld samples: the same command continues",
                               state.done, state.samples);
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------------ the others */

static Fed other_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Ranked *const r = user;
    int64_t message[HAWSER_RANK_WORDS];
    int sender;
    const double now = clock_now();
    if (empty && !r->asked && !r->closed) {
        say_state(r, SAY_ASK, state, HAWSER_OK);
        r->asked = 1;
        r->told = now;
    } else if (now - r->told >= TELL) {
        say_state(r, SAY_TELL, state, HAWSER_OK);
        r->told = now;
    }
    while (r->ranks->receive(r->ranks->user, &sender, message)) {
        if (message[0] == SAY_STOP) return FED_STOP;
        r->asked = 0;
        if (message[0] == SAY_CLOSED) r->closed = 1;
        if (message[0] != SAY_RANGE) continue;
        *from = (long)message[SAID_RANGE];
        *to = (long)message[SAID_RANGE + 1];
        return FED_MORE;
    }
    return r->closed ? FED_NO_MORE : FED_NOT_YET;
}

/* Sleeps until rank 0 announces the next part or the end of the study: a collective call would use processor time. */
static void part_wait(const Ranked *r)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
    int64_t message[HAWSER_RANK_WORDS] = {SAY_TELL};
    int sender;
    while (!r->ranks->receive(r->ranks->user, &sender, message) || message[0] != SAY_PART) nanosleep(&pause, NULL);
}

/* -------------------------------------------------------------------------------------------------------- all ranks */

hawser_status ranks_agree(const hawser_ranks *ranks, hawser_status status, hawser_error *err)
{
    int64_t first = status;
    ranks->share(ranks->user, &first, sizeof first);
    if (ranks->rank == 0 || first == HAWSER_OK) return status;
    return error_set(err, (hawser_status)first, "the first rank failed");
}

/* Counts of this engine alone, as of the last call of its feed. */
typedef struct Counted {
    Fed (*more)(void *user, int empty, hawser_study_state *state, long *from, long *to);
    Ranked *ranked;
    hawser_study_state own;
} Counted;

static Fed counted_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Counted *const c = user;
    c->own = *state;
    return c->more(c->ranked, empty, state, from, to);
}

static hawser_status first_run(const Study *s, const char *dir, const hawser_study_options *mine, Ranked *r, Rows *rows,
                               double *efficiency, hawser_error *err)
{
    hawser_error late;
    Counted counted = {first_more, r, r->units->before};
    const Feed feed = {counted_more, &counted};
    hawser_status status = engine_run(s, dir, "rank-0", mine, r->units, &feed, rows, efficiency, err);
    counted.own.jobs = mine->jobs;
    for (int k = 1; k < r->ranks->count && status == HAWSER_STOPPED; k++) {
        if (r->mate[k].status) status = HAWSER_OK; /* this rank's error is the reason, and others_wait reports it */
    }
    status = others_wait(r, mine, &counted.own, status, status ? &late : err);
    for (int k = 1; k < r->ranks->count; k++) say(r, k, SAY_PART, 0, 0);
    const hawser_status read = store_read(s, dir, rows, &late);
    return read && !status ? error_set(err, read, "%s", late.message) : status;
}

/* Runs another rank's engine. Units are their own numbers here: rank 0 has the list. A search needs the rows of earlier
 * starts. */
static hawser_status other_run(const Study *s, const char *dir, const hawser_study_options *mine, Ranked *r, Rows *rows,
                               double *efficiency, hawser_error *err)
{
    char crew[CREW_MAX];
    Counted counted = {other_more, r, {0}};
    const Feed feed = {counted_more, &counted};
    snprintf(crew, sizeof crew, "rank-%d", r->ranks->rank);
    hawser_status status = HAWSER_OK;
    if (study_searches(s)) status = store_read(s, dir, rows, err);
    if (!status) status = engine_run(s, dir, crew, mine, r->units, &feed, rows, efficiency, err);
    say_state(r, SAY_OVER, &counted.own, status);
    part_wait(r);
    return status;
}

/* Runs the open units once; *left: their number. */
static hawser_status round_run(Study *s, const char *dir, const hawser_study_options *mine, const hawser_ranks *ranks,
                               int pilots, Rows *rows, long *left, double *efficiency, hawser_error *err)
{
    Units units = {0};
    Ranked r = {.ranks = ranks, .units = &units, .single = study_searches(s)};
    hawser_status status = ranks->rank ? HAWSER_OK : units_open(s, pilots, rows, &units, err);
    r.mate = ranks->rank ? NULL : calloc((size_t)ranks->count, sizeof *r.mate);
    if (!status && !ranks->rank && !r.mate) status = error_memory(err);
    status = ranks_agree(ranks, status, err);
    if (!status) {
        ranks->share(ranks->user, &units.n, sizeof units.n);
        ranks->share(ranks->user, s->close, sizeof s->close);
    }
    const int more = !status && units.n > 0 && units.n < *left;
    *left = more ? units.n : 0;
    if (more) {
        status = (ranks->rank ? other_run : first_run)(s, dir, mine, &r, rows, efficiency, err);
        status = ranks_agree(ranks, status, err);
    }
    free(r.mate);
    free(units.unit);
    return status;
}

/* Repeats for units of workers that died before they reported. */
hawser_status ranks_run(Study *s, const char *dir, const hawser_study_options *options, const hawser_ranks *ranks,
                        int pilots, Rows *rows, double *efficiency, hawser_error *err)
{
    hawser_study_options mine = *options;
    mine.jobs = options->jobs > 0 ? options->jobs : 1;
    hawser_status status = HAWSER_OK;
    for (long left = LONG_MAX; left > 0 && !status;)
        status = round_run(s, dir, &mine, ranks, pilots, rows, &left, efficiency, err);
    return status;
}

/* A study as Slurm arrays. The caller writes a sheet of open units, submits an array of tasks, each of which computes
 * every n-th unit of the sheet on its own processes, and waits; units still open after that go into another array. The
 * array's name contains the study and the folder, so that a repeated call finds it and waits for it. */

/* s: interval of checks for an interrupt; first and largest interval of Slurm queries; largest share of time for
 * reading the rows. */
static const double SLURM_LOOK = 0.05, ASK_FIRST = 0.5, ASK_MOST = 10, READ_SHARE = 0.05;

enum { TASKS_MAX = 1000, CHUNK = 16, SAID_MAX = 4096, SILENCES_MAX = 20, IDLE_ARRAYS_MAX = 2 };

/* ------------------------------------------------------------------------------------------------------- the sheet */

/* Writes the sheet: "tasks N", "close B ..." (bands about 0 where runs are made, exact), "units FROM TO" per line. */
static hawser_status sheet_write(const Study *s, const OutDir *workers, int tasks, const Units *units,
                                 hawser_error *err)
{
    OutFile out;
    hawser_status status = out_open_late(&out, workers, "sheet", err);
    if (status) return status;
    status = out_print(&out, err, "tasks %d\nclose", tasks);
    for (int k = 0; k < LIMIT_KINDS && !status; k++) status = out_print(&out, err, " %a", s->close[k]);
    for (long a = 0, b; a < units->n && !status; a = b) {
        for (b = a + 1; b < units->n && units->unit[b] == units->unit[b - 1] + 1;) b++;
        status = out_print(&out, err, "\nunits %ld %ld", units->unit[a], units->unit[b - 1]);
    }
    if (!status) status = out_print(&out, err, "\nend\n");
    return out_named(&out, workers, status, err);
}

/* Reads the task's share of the sheet, and its bands into s->close. */
static hawser_status sheet_lines(FILE *f, const char *path, Study *s, int task, Units *units, hawser_error *err)
{
    int tasks = 0, fine = fscanf(f, "tasks %d close", &tasks) == 1 && tasks > task;
    long from, to, seen = 0, room = 0;
    for (int k = 0; k < LIMIT_KINDS && fine; k++) fine = fscanf(f, "%la", &s->close[k]) == 1;
    while (fine && fscanf(f, " units %ld %ld", &from, &to) == 2) {
        fine = from >= 0 && from <= to && to < s->samples;
        if (!fine) break;
        for (long i = from; i <= to; i++, seen++) {
            if (seen % tasks != task) continue;
            if (units->n == room) {
                room = 2 * room + 64;
                long *const more = realloc(units->unit, (size_t)room * sizeof *more);
                if (!more) return error_memory(err);
                units->unit = more;
            }
            units->unit[units->n++] = i;
        }
    }
    char end[8] = "";
    if (fine && fscanf(f, "%7s", end) == 1 && strcmp(end, "end") == 0) return HAWSER_OK;
    if (ferror(f)) return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.400s': %s", path, strerror(errno));
    return error_set(err, HAWSER_ERR_INPUT, "'%.400s' has no task %d: hawser study --slurm writes it", path, task);
}

/* Removes units whose rows are in `rows`. */
static void units_left(const Study *s, const Rows *rows, Units *units)
{
    long n = 0;
    if (study_searches(s)) return;
    for (long k = 0; k < units->n; k++) {
        if (rows->row[units->unit[k]].state == ROW_OPEN) units->unit[n++] = units->unit[k];
    }
    units->n = n;
}

/* Computes one task. If Slurm has restarted it, its own files have its earlier results; a search needs those of all
 * tasks. */
hawser_status slurm_task(Study *s, const char *dir, int task, const hawser_study_options *options, hawser_error *err)
{
    char crew[CREW_MAX];
    OutDir workers;
    OutSpot sheet;
    Units units = {.before = {.left_s = NAN}};
    Rows rows = {0};
    double efficiency;
    hawser_study_options mine = *options;
    mine.jobs = options->jobs > 0 ? options->jobs : 1;
    snprintf(crew, sizeof crew, "task-%d", task);
    if (workers_enter(&workers, dir, NULL))
        return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.400s/workers': %s", dir, strerror(errno));
    hawser_status status = out_spot(&sheet, &workers, "sheet", err);
    const int fd = status ? -1 : file_open_in(workers.at, "sheet", O_RDONLY);
    FILE *const f = fd >= 0 ? fdopen(fd, "r") : NULL;
    if (!status && !f) status = file_unread(sheet.path, file_reason(errno), err);
    if (!status) status = sheet_lines(f, sheet.path, s, task, &units, err);
    if (f) fclose(f);
    if (!f && fd >= 0) close(fd);
    out_leave(&workers);
    if (!status) status = rows_make(s, &rows, err);
    if (!status && study_searches(s)) status = store_read(s, dir, &rows, err);
    for (int k = 0; k < mine.jobs && !status; k++) status = store_take(dir, crew, k, &rows, err);
    if (!status) units_left(s, &rows, &units);
    if (!status) status = engine_run(s, dir, crew, &mine, &units, NULL, &rows, &efficiency, err);
    rows_free(&rows);
    free(units.unit);
    return status;
}

/* ------------------------------------------------------------------------------------------------- Slurm's programs */

/* Runs a program and stores its output of both streams, truncated, in said[SAID_MAX]. Returns its exit status; < 0: it
 * could not be run. */
static int program_ask(char *const *argv, char *said)
{
    int ends[2], how;
    size_t n = 0;
    ssize_t got;
    said[0] = 0;
    if (pipe(ends)) return -1;
    fflush(NULL);
    const pid_t pid = fork();
    if (pid == 0) {
        dup2(ends[1], STDOUT_FILENO);
        dup2(ends[1], STDERR_FILENO);
        close(ends[0]);
        close(ends[1]);
        execvp(argv[0], argv);
        _exit(127);
    }
    close(ends[1]);
    char spare[256];
    while (pid > 0 && (got = n + 1 < SAID_MAX ? read(ends[0], said + n, SAID_MAX - 1 - n)
                                              : read(ends[0], spare, sizeof spare)) > 0) {
        if (n + 1 < SAID_MAX) n += (size_t)got;
    }
    said[n] = 0;
    said[strcspn(said, "\n")] = 0; /* the first line is enough */
    close(ends[0]);
    if (pid < 0 || waitpid(pid, &how, 0) != pid || !WIFEXITED(how) || WEXITSTATUS(how) == 127) return -1;
    return WEXITSTATUS(how);
}

/* Checks whether an array of that name waits or runs: 1, 0; < 0: Slurm gives no answer. */
static int array_is_there(const char *name)
{
    char named[STORE_NAME_MAX + 10], said[SAID_MAX];
    snprintf(named, sizeof named, "--name=%s", name);
    char *const argv[] = {(char[]){"squeue"}, (char[]){"--noheader"}, named, (char[]){"--format=%A"}, NULL};
    return program_ask(argv, said) == 0 ? said[0] != 0 : -1;
}

/* Writes a text as one word for the shell. */
static hawser_status word_print(OutFile *out, const char *text, hawser_error *err)
{
    hawser_status status = out_print(out, err, "'");
    for (; *text && !status; text++) status = out_print(out, err, *text == '\'' ? "'\\''" : "%c", *text);
    return status ? status : out_print(out, err, "'");
}

/* Writes task.sh, the script of each task. */
static hawser_status script_write(const Study *s, const char *dir, const OutDir *workers, const char *program, int jobs,
                                  hawser_error *err)
{
    OutFile out;
    char study[PATH_MAX];
    if (!realpath(s->path, study)) return out_error(s->path, errno, err);
    hawser_status status = out_open_late(&out, workers, "task.sh", err);
    if (status) return status;
    status = out_print(&out, err, "#!/bin/sh\nexec ");
    if (!status) status = word_print(&out, program, err);
    if (!status) status = out_print(&out, err, " study ");
    if (!status) status = word_print(&out, study, err);
    if (!status) status = out_print(&out, err, " --output ");
    if (!status) status = word_print(&out, dir, err);
    if (!status)
        status = out_print(&out, err, " --jobs %d --task \"$SLURM_ARRAY_TASK_ID\" --quiet\n", jobs > 0 ? jobs : 1);
    return out_named(&out, workers, status, err);
}

/* Prepares slurm.log for the tasks' output. Slurm opens it by name: it must not be a link. */
static hawser_status log_begin(const OutDir *workers, hawser_error *err)
{
    OutSpot spot;
    const hawser_status status = out_spot(&spot, workers, "slurm.log", err);
    if (status) return status;
    const int fd = file_open_in(workers->at, "slurm.log", O_WRONLY | O_APPEND);
    if (fd >= 0) close(fd);
    return fd >= 0 || errno == ENOENT ? HAWSER_OK : out_error(spot.path, errno, err);
}

static hawser_status array_submit(const char *folder, const char *name, int tasks, int jobs, hawser_error *err)
{
    char array[40], named[STORE_NAME_MAX + 20], each[40], chdir[OUT_PATH_MAX + 10], script[OUT_PATH_MAX],
        said[SAID_MAX];
    const hawser_status status = out_join(script, folder, "task.sh", err);
    if (status) return status;
    snprintf(array, sizeof array, "--array=0-%d", tasks - 1);
    snprintf(named, sizeof named, "--job-name=%s", name);
    snprintf(each, sizeof each, "--cpus-per-task=%d", jobs > 0 ? jobs : 1);
    snprintf(chdir, sizeof chdir, "--chdir=%s", folder);
    char *const argv[] = {(char[]){"sbatch"},
                          (char[]){"--parsable"},
                          array,
                          named,
                          each,
                          chdir,
                          (char[]){"--output=slurm.log"},
                          (char[]){"--open-mode=append"},
                          script,
                          NULL};
    const int how = program_ask(argv, said);
    if (how == 0) return HAWSER_OK;
    if (how < 0) return error_set(err, HAWSER_ERR_INPUT, "there is no sbatch here: --slurm needs Slurm's programs");
    return error_set(err, HAWSER_ERR_INPUT, "Slurm does not take the array: %.400s", said);
}

/* ----------------------------------------------------------------------------------------------------- the caller */

typedef struct Slurm {
    const Study *study;
    const char *dir;
    const hawser_study_options *options;
    const hawser_study_cluster *cluster;
    char name[STORE_NAME_MAX], folder[OUT_PATH_MAX];
    double start;
    long before; /* rows that were there at the start */
    int workers; /* of the array, if all its tasks run at once */
    Rows *rows;
} Slurm;

/* Waits until a time, and checks for an interrupt. */
static hawser_status wait_a_while(const Slurm *w, double until, const hawser_study_state *state, hawser_error *err)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * SLURM_LOOK)};
    double told = 0;
    do {
        nanosleep(&pause, NULL);
        const double now = clock_now();
        if (!w->options->progress || now - told < 0.25) continue;
        told = now;
        if (w->options->progress(w->options->user, state)) {
            return error_set(err, HAWSER_STOPPED,
                             "stopped with %ld of %ld samples: the array goes on, and the same command waits for it "
                             "(scancel --name=%s ends it)",
                             state->done, state->samples, w->name);
        }
    } while (clock_now() < until);
    return HAWSER_OK;
}

/* Finds the open units and the progress. */
static hawser_status look(const Slurm *w, int pilots, Units *open, hawser_error *err)
{
    free(open->unit);
    open->unit = NULL;
    hawser_status status = store_read(w->study, w->dir, w->rows, err);
    if (!status) status = units_open(w->study, pilots, w->rows, open, err);
    hawser_study_state *const state = &open->before;
    state->wall_s = clock_now() - w->start;
    state->jobs = w->workers;
    const long mine = state->done - w->before;
    if (mine > 0) state->left_s = state->wall_s / (double)mine * (double)(state->samples - state->done);
    return status;
}

/* Waits until Slurm has no array of the study, which must exist at first; `open` is updated afterwards. */
static hawser_status array_wait(const Slurm *w, int pilots, Units *open, hawser_error *err)
{
    double ask = ASK_FIRST, reading = 0;
    int there = 1, silences = 0;
    hawser_status status = HAWSER_OK;
    while (there != 0 && !status) {
        const double pause = fmax(ask, reading / READ_SHARE);
        status = wait_a_while(w, clock_now() + pause, &open->before, err);
        if (status) break;
        there = array_is_there(
            w->name); /* query before reading the rows: those of an array that is over are then complete */
        silences = there < 0 ? silences + 1 : 0;
        if (silences > SILENCES_MAX) {
            status = error_set(err, HAWSER_ERR_INPUT, "squeue does not answer: the same command goes on when it does");
            break;
        }
        const double begun = clock_now();
        status = look(w, pilots, open, err);
        reading = clock_now() - begun;
        ask = fmin(2 * ask, ASK_MOST);
    }
    return status;
}

static int tasks_of(const hawser_study_cluster *cluster, long units, int searches)
{
    const long usual = searches ? units : (units + CHUNK - 1) / CHUNK, most = cluster->tasks ? cluster->tasks : 256,
               wanted = cluster->tasks ? cluster->tasks : usual;
    const long tasks = wanted > most ? most : wanted, cut = tasks > TASKS_MAX ? TASKS_MAX : tasks;
    return (int)(cut > units ? units : cut);
}

static hawser_status arrays_run(Slurm *w, int pilots, Units *open, hawser_error *err)
{
    int idle = 0;
    hawser_status status = look(w, pilots, open, err);
    while (!status && open->n > 0) {
        const long before = open->before.done;
        const int there = array_is_there(w->name);
        if (there < 0) return error_set(err, HAWSER_ERR_INPUT, "squeue does not answer: --slurm needs Slurm");
        const int tasks = tasks_of(w->cluster, open->n, study_searches(w->study));
        w->workers = tasks * (w->options->jobs > 0 ? w->options->jobs : 1);
        OutDir workers = {.at = -1};
        if (!there) status = workers_enter(&workers, w->dir, err);
        if (!there && !status) status = sheet_write(w->study, &workers, tasks, open, err);
        if (!there && !status)
            status = script_write(w->study, w->dir, &workers, w->cluster->slurm, w->options->jobs, err);
        if (!there && !status) status = log_begin(&workers, err);
        out_leave(&workers);
        if (!there && !status) status = array_submit(w->folder, w->name, tasks, w->options->jobs, err);
        if (!status) status = array_wait(w, pilots, open, err);
        if (status || open->before.done > before) continue;
        if (!there && ++idle == IDLE_ARRAYS_MAX && open->n > 0) {
            return error_set(err, HAWSER_ERR_OUTPUT, "%d arrays in a row have computed nothing: see '%.400s/slurm.log'",
                             idle, w->folder);
        }
    }
    return status;
}

hawser_status slurm_idle(const Study *s, const char *dir, hawser_error *err)
{
    char whole[PATH_MAX], name[STORE_NAME_MAX];
    if (!realpath(dir, whole)) return out_error(dir, errno, err);
    const hawser_status status = store_name(s, whole, name, err);
    if (status || array_is_there(name) <= 0) return status;
    return error_set(err, HAWSER_ERR_INPUT, "an array of this study is at work: scancel --name=%s ends it", name);
}

hawser_status slurm_run(const Study *s, const char *dir, const hawser_study_options *options,
                        const hawser_study_cluster *cluster, int pilots, Rows *rows, hawser_error *err)
{
    char whole[PATH_MAX];
    Units open = {0};
    if (!realpath(dir, whole)) return out_error(dir, errno, err);
    Slurm w = {.study = s, .dir = whole, .options = options, .cluster = cluster, .start = clock_now(), .rows = rows};
    for (long i = 0; i < rows->n; i++) w.before += rows->row[i].state != ROW_OPEN;
    hawser_status status = store_name(s, whole, w.name, err);
    if (!status) status = out_join(w.folder, whole, "workers", err);
    if (!status) status = arrays_run(&w, pilots, &open, err);
    if (!status && options->progress) options->progress(options->user, &open.before);
    free(open.unit);
    return status;
}
