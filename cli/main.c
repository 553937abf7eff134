/* hawser, the program: written against the public interface alone. What a process has to see to stands here, what it
 * says and does in program.c. */
#include "cli/commands.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/resource.h>
#include <unistd.h>

/* A program may be started with standard input, output or error closed. The next file that it opens, a file of results,
 * would then take that number, and progress or the report would be written into it. What cannot be written stays an
 * error: the place is taken by a file that can only be read. Returns 0 if that cannot be
 * prevented. */
static int take_descriptors(void)
{
    int fd;
    do fd = open("/dev/null", O_RDONLY);
    while (fd >= 0 && fd <= 2);
    if (fd > 2) close(fd);
    return fd > 2;
}

/* Less than this and the program would end by a signal somewhere on its way. Returns 0 if there is less. */
static int stack_suffices(void)
{
    enum { LEAST = 512 }; /* KiB */
    struct rlimit limit;
    if (getrlimit(RLIMIT_STACK, &limit) || limit.rlim_cur == RLIM_INFINITY || limit.rlim_cur >= LEAST * 1024) return 1;
    complain("the stack is limited to %lu KiB (RLIMIT_STACK, ulimit -s): at least %d are needed",
             (unsigned long)(limit.rlim_cur / 1024), LEAST);
    return 0;
}

/* Programs that are called (a browser, Slurm's) are looked for where the path says, but not in the current folder,
 * whatever that is: elements that are empty or relative are left out. 0: no memory. */
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
    static char room[BUFSIZ]; /* without a buffer of its own standard output drops what it is given */
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
    signal(SIGXFSZ, SIG_IGN); /* a file that may not grow is a write that fails: as a disk that is full */
    setvbuf(stdout, room, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, sizeof room);
    return program(argc, argv);
}
