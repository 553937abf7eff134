/* A study as Slurm arrays. Who asked writes a sheet of what is open, submits an array of tasks, each of which computes
 * every so many-th unit of the sheet on processes of its own, and waits; what is open after that goes into another
 * array. The array's name is the study's and the folder's, so that whoever asks again finds it and waits for it. */
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

#include "core/base/clock.h"
#include "core/base/error.h"
#include "io/results/results_file.h"
#include "study/engine/engine.h"

/* s: between looks at the interrupt; between questions to Slurm, at first and at most; a reading of the rows may take
 * this share of the time. */
static const double LOOK = 0.05, ASK_FIRST = 0.5, ASK_MOST = 10, READ_SHARE = 0.05;
enum { TASKS_MAX = 1000, CHUNK = 16, SAID_MAX = 4096, SILENCES_MAX = 20, IDLE_ARRAYS_MAX = 2 };

/* ------------------------------------------------------------------------------------------------------- the sheet */

/* sheet: "tasks N", "close B ..." (bands about 0 where runs are made, exact), "units FROM TO" a line. */
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

/* The task's share of the sheet: with its bands in s->close. */
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

/* What of the units is not in `rows`. */
static void units_left(const Study *s, const Rows *rows, Units *units)
{
    long n = 0;
    if (study_searches(s)) return;
    for (long k = 0; k < units->n; k++) {
        if (rows->row[units->unit[k]].state == ROW_OPEN) units->unit[n++] = units->unit[k];
    }
    units->n = n;
}

/* A task that Slurm has started once more finds what it has computed before in its own files; a search needs those of
 * all. */
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

/* Runs a program; what it says on both of its outputs, cut, in said[SAID_MAX]. Returns its exit status; < 0: it could
 * not be run. */
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

/* Whether an array of that name waits or runs: 1, 0; < 0: Slurm does not say. */
static int array_is_there(const char *name)
{
    char named[STORE_NAME_MAX + 10], said[SAID_MAX];
    snprintf(named, sizeof named, "--name=%s", name);
    char *const argv[] = {(char[]){"squeue"}, (char[]){"--noheader"}, named, (char[]){"--format=%A"}, NULL};
    return program_ask(argv, said) == 0 ? said[0] != 0 : -1;
}

/* A text as one word of the shell. */
static hawser_status word_print(OutFile *out, const char *text, hawser_error *err)
{
    hawser_status status = out_print(out, err, "'");
    for (; *text && !status; text++) status = out_print(out, err, *text == '\'' ? "'\\''" : "%c", *text);
    return status ? status : out_print(out, err, "'");
}

/* task.sh: what each task does. */
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

/* What tasks say goes into slurm.log, which Slurm opens itself, by its name: it must be no link by then. */
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

/* ----------------------------------------------------------------------------------------------------- who asked */

typedef struct Slurm {
    const Study *study;
    const char *dir;
    const hawser_study_options *options;
    const hawser_study_cluster *cluster;
    char name[STORE_NAME_MAX], folder[OUT_PATH_MAX];
    double start;
    long before; /* rows that were there at the start */
    int workers; /* of the array, if Slurm has room for all at once */
    Rows *rows;
} Slurm;

/* Looks for an interrupt for a while. */
static hawser_status wait_a_while(const Slurm *w, double until, const hawser_study_state *state, hawser_error *err)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
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

/* What is open, and how far that is. */
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

/* Until Slurm knows no array of the study, which it must have; `open` afterwards. */
static hawser_status array_wait(const Slurm *w, int pilots, Units *open, hawser_error *err)
{
    double ask = ASK_FIRST, reading = 0;
    int there = 1, silences = 0;
    hawser_status status = HAWSER_OK;
    while (there != 0 && !status) {
        const double pause = fmax(ask, reading / READ_SHARE);
        status = wait_a_while(w, clock_now() + pause, &open->before, err);
        if (status) break;
        there = array_is_there(w->name); /* before the rows: what an array that is over has written is in them */
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
