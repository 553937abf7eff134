/* hawser, the program: written with the public interface alone. The set-up of the process is here, its output and
 * actions are in program.c. */
#include "cli/commands.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* Occupies closed standard descriptors. A program may be started with standard input, output or error closed. The next
 * file that it opens, a file of results, would then take that number, and progress or the report would be written into
 * it. Writing must fail: the descriptor gets a file that can only be read. Returns 0 if that fails. */
static int take_descriptors(void)
{
    int fd;
    do fd = open("/dev/null", O_RDONLY);
    while (fd >= 0 && fd <= 2);
    if (fd > 2) close(fd);
    return fd > 2;
}

/* Checks the stack: with less the program would end by a signal at some time. Returns 0 if it is too small. */
static int stack_suffices(void)
{
    enum { LEAST = 512 }; /* KiB */
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= LEAST * 1024) return 1;
    complain("the stack is limited to %lu KiB (RLIMIT_STACK, ulimit -s): at least %d are needed",
             (unsigned long)(limit.rlim_cur / 1024), LEAST);
    return 0;
}

/* Removes empty and relative elements from the path: called programs (a browser, Slurm's) must not be found in the
 * current folder. 0: no memory. */
static int path_settle(void)
{
    const char *at = getenv("PATH");
    char *const kept = at ? malloc(strlen(at) + 1) : NULL, *to = kept;
    if (!kept) return !at;
    for (size_t n; *at; at += n + (at[n] == ':')) {
        n = strcspn(at, ":");
        if (*at != '/') continue;
        if (to > kept) *to++ = ':';
        memcpy(to, at, n);
        to += n;
    }
    *to = 0;
    const int set = !setenv("PATH", to > kept ? kept : "/usr/bin:/bin", 1);
    free(kept);
    return set;
}

int main(int argc, char **argv)
{
    static char room[BUFSIZ]; /* without a buffer of its own standard output drops its data */
    if (!take_descriptors()) {
        complain("cannot open /dev/null: %s", strerror(errno));
        return EXIT_OUTPUT;
    }
    if (!stack_suffices()) return EXIT_INTERNAL;
    if (!path_settle()) {
        complain("out of memory");
        return EXIT_INTERNAL;
    }
    interrupt_end();
    signal(SIGXFSZ, SIG_IGN); /* the size limit of a file is a failed write, as on a full disk */
    setvbuf(stdout, room, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, sizeof room);
    return program(argc, argv);
}
