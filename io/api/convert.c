/* Models of other programs as GLB, by the converter of the desk (web/src/convert), which node runs in a child process:
 * what a broken model does to it ends that process alone, and its memory and time have limits. */
#define _GNU_SOURCE /* pipe2 */
#include <errno.h>
#include <fcntl.h>
#include <poll.h>
#include <signal.h>
#include <spawn.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <time.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "hawser/hawser.h"
#include "io/case/library.h"
#include "io/results/results_file.h"

extern char **environ;

/* The child's descriptor for the GLB; what it may say, bytes; time between two looks at its memory, ms. */
enum { GLB = 3, SAID_MOST = 1 << 16, LOOK_MS = 20 };
static const double memory_default = 4096e6 /* bytes */, time_default = 300 /* s */;

/* What the child is, what it has said, and why it was ended. */
typedef struct Child {
    pid_t pid;
    int from; /* its lines */
    char *said;
    size_t size;
    int status;
    const char *ended; /* NULL: by itself */
} Child;

/* Returns 0 or the error's number; 127 in the child's status where there is no node comes back as ENOENT. */
static int child_start(Child *child, const char *script, const char *model, int glb,
                       const hawser_convert_options *options)
{
    int lines[2];
    posix_spawn_file_actions_t files;
    const char *const args[] = {
        "node", script, model, "/dev/fd/3", options->unit ? options->unit : "", options->up ? options->up : "", NULL};
    if (pipe2(lines, O_CLOEXEC)) return errno;
    int number = posix_spawn_file_actions_init(&files);
    if (!number) {
        number = posix_spawn_file_actions_addopen(&files, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
        if (!number) number = posix_spawn_file_actions_addopen(&files, STDERR_FILENO, "/dev/null", O_WRONLY, 0);
        if (!number) number = posix_spawn_file_actions_adddup2(&files, lines[1], STDOUT_FILENO);
        if (!number) number = posix_spawn_file_actions_adddup2(&files, glb, GLB);
        if (!number) number = posix_spawnp(&child->pid, "node", &files, NULL, (char *const *)(size_t)args, environ);
        posix_spawn_file_actions_destroy(&files);
    }
    close(lines[1]);
    child->from = lines[0];
    if (number) close(lines[0]);
    return number;
}

/* Resident memory of a process by its open statm, bytes; 0: it has ended. */
static double resident(int statm)
{
    char text[64] = "";
    long all, pages;
    if (whole_pread(statm, text, sizeof text - 1, 0) <= 0 || sscanf(text, "%ld %ld", &all, &pages) != 2) return 0;
    return (double)pages * (double)sysconf(_SC_PAGESIZE);
}

static double now(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return (double)t.tv_sec + 1e-9 * (double)t.tv_nsec;
}

/* Reads what the child says until it ends, or has taken too much. */
static void child_wait(Child *child, double memory, double seconds)
{
    const double end = now() + seconds;
    struct pollfd lines = {child->from, POLLIN, 0};
    char path[64];
    snprintf(path, sizeof path, "/proc/%d/statm", (int)child->pid);
    const int statm = file_open_named(path);
    for (int open = 1; open && !child->ended;) {
        const int ready = poll(&lines, 1, LOOK_MS);
        if (ready > 0) {
            const ssize_t n = read(child->from, child->said + child->size, SAID_MOST - 1 - child->size);
            open = n > 0 || (n < 0 && errno == EINTR);
            child->size += n > 0 ? (size_t)n : 0;
        }
        if (resident(statm) > memory) child->ended = "memory";
        if (now() > end) child->ended = "time";
    }
    child->said[child->size] = 0;
    if (child->ended) kill(child->pid, SIGKILL);
    while (waitpid(child->pid, &child->status, 0) < 0 && errno == EINTR) {
    }
    close(child->from);
    if (statm >= 0) close(statm);
}

/* Turns the lines "note: ..." and "done: ..." into sentences in place; returns the text behind "error: ", or NULL. */
static const char *lines_take(char *said)
{
    char *to = said;
    for (char *line = said, *next; *line; line = next) {
        next = line + strcspn(line, "\n");
        if (*next) *next++ = 0;
        if (!strncmp(line, "error: ", 7)) return line + 7;
        const char *const text = strchr(line, ' ');
        const size_t n = text ? strlen(text + 1) : 0;
        if (n) memmove(to, text + 1, n), to[n] = '\n', to += n + 1;
    }
    *to = 0;
    return NULL;
}

static hawser_status child_judge(Child *child, const char *model, const hawser_convert_options *options,
                                 hawser_error *err)
{
    const char *const wrong = lines_take(child->said);
    if (child->ended && *child->ended == 'm')
        return error_set(err, HAWSER_ERR_INPUT, "%.600s: to convert it takes more than %.0f MB of memory (--memory)",
                         model, options->memory / 1e6);
    if (child->ended)
        return error_set(err, HAWSER_ERR_INPUT, "%.600s: to convert it takes more than %.0f s (--time)", model,
                         options->seconds);
    if (wrong) return error_set(err, HAWSER_ERR_INPUT, "%.600s: %.800s", model, wrong);
    if (WIFSIGNALED(child->status) || WEXITSTATUS(child->status))
        return error_set(err, HAWSER_ERR_INPUT, "%.600s: the converter did not survive it (%s %d)", model,
                         WIFSIGNALED(child->status) ? "signal" : "status",
                         WIFSIGNALED(child->status) ? WTERMSIG(child->status) : WEXITSTATUS(child->status));
    return HAWSER_OK;
}

/* Writes the bytes of an open file to a path. */
static hawser_status glb_name(int glb, const char *path, hawser_error *err)
{
    struct stat info;
    if (fstat(glb, &info)) return out_error(path, errno, err);
    if (info.st_size == 0) return error_set(err, HAWSER_ERR_INPUT, "the converter has written nothing");
    void *const bytes = mmap(NULL, (size_t)info.st_size, PROT_READ, MAP_PRIVATE, glb, 0);
    if (bytes == MAP_FAILED) return error_memory(err);
    const hawser_status status = out_file(path, bytes, (size_t)info.st_size, err);
    munmap(bytes, (size_t)info.st_size);
    return status;
}

static hawser_status convert(const char *script, const char *model, const char *path,
                             const hawser_convert_options *options, Child *child, hawser_error *err)
{
    FILE *const glb = tmpfile();
    child->said = malloc(SAID_MOST);
    hawser_status status = HAWSER_OK;
    if (!glb) status = error_set(err, HAWSER_ERR_OUTPUT, "cannot make a temporary file: %s", strerror(errno));
    if (glb && !child->said) status = error_memory(err);
    const int number = status ? 0 : child_start(child, script, model, fileno(glb), options);
    if (number == ENOENT)
        status =
            error_set(err, HAWSER_ERR_INPUT,
                      "there is no node on the path, which runs the converter (on Debian: apt-get install nodejs); "
                      "the desk converts models without it");
    else if (number)
        status = error_set(err, HAWSER_ERR_MEMORY, "node cannot be started: %s", strerror(number));
    else if (!status) {
        child_wait(child, options->memory, options->seconds);
        status = child_judge(child, model, options, err);
        if (!status) status = glb_name(fileno(glb), path, err);
    }
    if (glb) fclose(glb);
    return status;
}

hawser_status hawser_model_convert(const char *model, const char *path, const hawser_convert_options *options,
                                   char **text, hawser_error *err)
{
    static const char place[] = "share/hawser/convert.cjs";
    hawser_convert_options with = options ? *options : (hawser_convert_options){0};
    FileMarks marks = {0};
    Child child = {0};
    if (text) *text = NULL;
    if (!model || !path || !text) return error_argument(err, !model ? "model" : !path ? "path" : "text");
    if (!(with.memory > 0)) with.memory = memory_default;
    if (!(with.seconds > 0)) with.seconds = time_default;
    char *const script = shipped_find(place);
    hawser_status status = HAWSER_OK;
    if (!script) status = error_set(err, HAWSER_ERR_INPUT, "there is no %s beside the program", place);
    if (!status && access(model, R_OK)) status = error_set(err, HAWSER_ERR_INPUT, "%.600s: %s", model, strerror(errno));
    if (!status) status = file_marks_add(&marks, model, err);
    if (!status) status = file_marks_add(&marks, script, err);
    if (!status) status = file_marks_spare(&marks, path, err);
    if (!status) status = convert(script, model, path, &with, &child, err);
    file_marks_free(&marks);
    free(script);
    if (!status) *text = child.said;
    if (status) free(child.said);
    return status;
}
