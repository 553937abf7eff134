/* Runs a test and records its processor time.
 * Usage: timed NAME COMMAND [ARGUMENT...]
 * Appends "NAME seconds" to the file that HAWSER_TEST_TIMES names (absolute path); without it, it becomes the command.
 */
#define _DEFAULT_SOURCE /* wait4 */
#include <signal.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

static double seconds(struct timeval t) { return (double)t.tv_sec + 1e-6 * (double)t.tv_usec; }

int main(int argc, char **argv)
{
    const char *const times = getenv("HAWSER_TEST_TIMES");
    if (argc < 3) return 2;
    const pid_t child = times ? fork() : 0;
    if (child < 0) return perror("fork"), 2;
    if (child == 0) {
        execvp(argv[2], argv + 2);
        perror(argv[2]);
        _exit(127);
    }
    int status = 0;
    struct rusage used; /* with all that it has waited for */
    if (wait4(child, &status, 0, &used) != child) return perror("wait4"), 2;
    FILE *const file = fopen(times, "a");
    if (file) fprintf(file, "%s %.3f\n", argv[1], seconds(used.ru_utime) + seconds(used.ru_stime)), fclose(file);
    if (WIFSIGNALED(status)) raise(WTERMSIG(status));
    return WEXITSTATUS(status);
}
