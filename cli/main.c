/* hawser, the program: written against the public interface alone. What a process has to see to stands here, what it
 * says and does in program.c. */
#include "cli/commands.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <string.h>
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

int main(int argc, char **argv)
{
    static char room[BUFSIZ]; /* without a buffer of its own standard output drops what it is given */
    if (!take_descriptors()) {
        complain("cannot open /dev/null: %s", strerror(errno));
        return EXIT_OUTPUT;
    }
    setvbuf(stdout, room, isatty(STDOUT_FILENO) ? _IOLBF : _IOFBF, sizeof room);
    return program(argc, argv);
}
