/* HDF5 does not survive every file: of some it reads beyond its memory, calls exit, or never ends, and no check before
 * it is opened would find all of them. So what may be somebody else's is read in a process of its own, which is forked
 * for it and gives back plain bytes. The process that calls goes on whatever becomes of the other one. */
#define _GNU_SOURCE /* pipe2 */
#include "io/results/results_h5.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "core/base/error.h"

/* Processor time of one reading, s: far above that of the largest results. */
enum { SECONDS_MOST = 900 };

/* What stands behind the bytes of a work that has come to its end. */
typedef struct End {
    char mark[16];
    hawser_status status;
    hawser_error err;
} End;
static const char end_mark[16] = "hawser: an end\n";

typedef struct Apart {
    ApartWork *work;
    void *user;
    int pipe[2];
    pid_t pid;
} Apart;

/* Before all that the program has registered: that is not this process's to do. */
static void leave(void) { _exit(1); }

static _Noreturn void child_do(const Apart *a)
{
    static const int own[] = {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGPIPE};
    struct rlimit none = {0, 0}, time;
    End end = {.status = HAWSER_OK};
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    for (size_t k = 0; k < sizeof own / sizeof *own; k++) signal(own[k], SIG_DFL);
    setrlimit(RLIMIT_CORE, &none);
    if (!getrlimit(RLIMIT_CPU, &time)) {
        if (time.rlim_cur > SECONDS_MOST) time.rlim_cur = SECONDS_MOST;
        setrlimit(RLIMIT_CPU, &time);
    }
    FILE *const out = atexit(leave) ? NULL : fdopen(a->pipe[1], "wb");
    if (!out) _exit(1);
    memcpy(end.mark, end_mark, sizeof end.mark);
    end.status = a->work(a->user, out, &end.err);
    const int whole = fwrite(&end, sizeof end, 1, out) == 1 && !fflush(out);
    _exit(!whole);
}

/* Called by HDF5, which is locked meanwhile: no other thread is within it as the process is copied, and the copy, in
 * which there is this thread alone, can go on with it. */
static herr_t fork_locked(hid_t list, const char *name, void *data)
{
    Apart *const a = data;
    (void)list, (void)name;
    a->pid = fork();
    if (!a->pid) child_do(a);
    return 1; /* no further property */
}

/* All that comes out of the pipe: *bytes [*size], malloc'ed; 0: without memory, errno says so. */
static int pipe_read(int fd, char **bytes, size_t *size)
{
    size_t room = 0;
    for (ssize_t n = 1; n != 0;) {
        if (*size == room) {
            char *const more = realloc(*bytes, room = 2 * room + 65536);
            if (!more) return 0;
            *bytes = more;
        }
        n = read(fd, *bytes + *size, room - *size);
        if (n < 0 && errno != EINTR) return 0;
        if (n > 0) *size += (size_t)n;
        if (n < 0) n = 1;
    }
    return 1;
}

hawser_status apart_do(ApartWork *work, void *user, char **bytes, size_t *size, int *died, hawser_error *err)
{
    Apart a = {work, user, {-1, -1}, -1};
    End end;
    int first = 0;
    *bytes = NULL;
    *size = 0;
    *died = 1;
    if (!memory_room(1 << 20) || pipe2(a.pipe, O_CLOEXEC)) return error_memory(err);
    H5E_BEGIN_TRY
    {
        const hid_t list = H5Pcreate(H5P_FILE_ACCESS);
        if (list >= 0) H5Piterate(list, &first, fork_locked, &a);
        H5Pclose(list);
    }
    H5E_END_TRY
    close(a.pipe[1]);
    int ok = a.pid > 0 && pipe_read(a.pipe[0], bytes, size);
    close(a.pipe[0]);
    while (a.pid > 0 && waitpid(a.pid, NULL, 0) < 0 && errno == EINTR) {
    }
    if (ok && *size >= sizeof end) {
        memcpy(&end, *bytes + (*size - sizeof end), sizeof end);
        *died = memcmp(end.mark, end_mark, sizeof end.mark) != 0;
    }
    if (ok && !*died) {
        *size -= sizeof end;
        if (end.status && err) *err = end.err;
        return end.status;
    }
    free(*bytes);
    *bytes = NULL;
    *size = 0;
    return ok ? HAWSER_OK : error_memory(err);
}
