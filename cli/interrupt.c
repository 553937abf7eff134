/* Ends a run early. After a signal the library stops at its next step or iteration and keeps the results so far. Where
 * it does not check soon enough, as within the factorisation of a large dense matrix, the program ends all the same:
 * every file is then as at its last flush, as for readers of a run in progress. */
#include "cli/commands.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/* Time for the library to stop: us of its own processor time, so that on a busy machine it gets as far as on an idle
 * one, and s of wall time for waiting without processor time. */
enum { PATIENCE = 450000, LONGEST_WAIT = 20 };

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};

/* Set by a signal: the only variable that a handler may use. */
static volatile sig_atomic_t interrupted;

/* Sets both times; 0, 0: the library has stopped. */
static void set_timers(long processor_us, long wall_s)
{
    const struct itimerval processor = {.it_value = {.tv_usec = processor_us}}, wall = {.it_value = {.tv_sec = wall_s}};
    setitimer(ITIMER_PROF, &processor, NULL);
    setitimer(ITIMER_REAL, &wall, NULL);
}

/* Ends the run at its next step after the first signal, at once after a second one. */
static void on_signal(int number)
{
    interrupted = 1;
    signal(number, SIG_DFL);
    set_timers(PATIENCE, LONGEST_WAIT);
}

/* Ends the program: `interrupted` was not checked in time. */
static void on_alarm(int number)
{
    static const char says[] = "hawser: stopped within a step that takes long; results are those of the last flush\n";
    (void)number;
    if (write(STDERR_FILENO, says, sizeof says - 1) < 0) _exit(EXIT_OUTPUT);
    _exit(EXIT_INTERRUPTED);
}

static void on_end(int number)
{
    static const char says[] = "hawser: stopped\n";
    (void)number;
    if (write(STDERR_FILENO, says, sizeof says - 1) < 0) _exit(EXIT_INTERRUPTED);
    _exit(EXIT_INTERRUPTED);
}

void interrupt_end(void)
{
    struct sigaction old;
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        if (!sigaction(ends[k], NULL, &old) && old.sa_handler == SIG_DFL) signal(ends[k], on_end);
    }
}

void interrupt_watch(void)
{
    struct sigaction action = {.sa_handler = on_signal, .sa_flags = SA_RESTART}, old;
    sigemptyset(&action.sa_mask);
    for (size_t k = 0; k < sizeof ends / sizeof *ends; k++) {
        /* under nohup a hang-up stays ignored; a script's background job ends on a signal */
        const int kept = ends[k] == SIGHUP && !sigaction(ends[k], NULL, &old) && old.sa_handler == SIG_IGN;
        if (!kept) sigaction(ends[k], &action, NULL);
    }
    signal(SIGPROF, on_alarm);
    signal(SIGALRM, on_alarm);
    signal(SIGPIPE, SIG_IGN);
}

int interrupt_wanted(void)
{
    if (interrupted) set_timers(0, 0);
    return interrupted;
}
