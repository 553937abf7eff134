/* How a run ends before its time. A signal asks; the library is told at its next step or iteration and ends with what
 * there is. Where it does not listen soon enough, as within the factorisation of a large dense matrix, the program ends
 * all the same: every file is then as at its last flush, which is what readers of a run that goes on see, too. */
#include "cli/commands.h"

#include <signal.h>
#include <stdio.h>
#include <string.h>
#include <sys/time.h>
#include <unistd.h>

/* How long the library has to notice: us of its own processor time, so that on a busy machine it gets as far as on an
 * idle one, and s of wall time for what waits without using any. */
enum { PATIENCE = 450000, LONGEST_WAIT = 20 };

static const int ends[] = {SIGINT, SIGTERM, SIGHUP};

/* Set by a signal: the only thing that a handler may touch. */
static volatile sig_atomic_t interrupted;

/* Both times; 0, 0: it has noticed. */
static void set_timers(long processor_us, long wall_s)
{
    const struct itimerval processor = {.it_value = {.tv_usec = processor_us}}, wall = {.it_value = {.tv_sec = wall_s}};
    setitimer(ITIMER_PROF, &processor, NULL);
    setitimer(ITIMER_REAL, &wall, NULL);
}

/* The first signal ends the run at its next step, a second one at once. */
static void on_signal(int number)
{
    interrupted = 1;
    signal(number, SIG_DFL);
    set_timers(PATIENCE, LONGEST_WAIT);
}

/* Nobody has looked at `interrupted`. */
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
        /* under nohup a hang-up stays ignored; a script's background job is to end when it is told so */
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
