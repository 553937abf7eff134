/* Where the second thread of a team runs, and who does the second share then: on a core of its own it takes shares; on
 * the caller's core it keeps out of the way, and leaves that core for good if it may. */
#define _GNU_SOURCE
#include <dirent.h>
#include <pthread.h>
#include <sched.h>
#include <stdlib.h>
#include <time.h>
#include <unistd.h>

#include "core/team.h"
#include "tests/support/check.h"

typedef struct Work {
    pthread_t by[2]; /* who did each share last */
    long runs[2];
    double sum[2];
} Work;

static void pause_ms(long ms)
{
    const struct timespec t = {.tv_sec = ms / 1000, .tv_nsec = ms % 1000 * 1000000};
    nanosleep(&t, NULL);
}

static void share(void *arg, int rank)
{
    Work *const w = arg;
    w->by[rank] = pthread_self();
    w->sum[rank] += (double)++w->runs[rank];
    if (rank == 0) pause_ms(2); /* time for the other */
}

/* The thread of this process that is not the caller, by its number; 0: there is none. */
static pid_t other_thread(void)
{
    DIR *const threads = opendir("/proc/self/task");
    assert_non_null(threads);
    pid_t found = 0;
    for (const struct dirent *e = readdir(threads); e; e = readdir(threads)) {
        const pid_t number = (pid_t)atol(e->d_name);
        if (number > 0 && number != gettid()) found = number;
    }
    closedir(threads);
    return found;
}

/* Runs jobs, each of at least 2 ms, until the helper has done `wanted` second shares, or `most` jobs; every job is
 * checked. Returns how many it did. */
static int helped(Team *t, int wanted, long most)
{
    Work w = {{0}, {0}, {0}};
    int by_helper = 0;
    for (long job = 1; by_helper < wanted && job <= most; ++job) {
        team_run(t, share, &w);
        for (int rank = 0; rank < 2; ++rank) {
            assert_int_equal(w.runs[rank], job);
            check_equal(w.sum[rank], (double)job * (double)(job + 1) / 2);
        }
        assert_true(pthread_equal(w.by[0], pthread_self()));
        by_helper += !pthread_equal(w.by[1], pthread_self());
    }
    return by_helper;
}

TEST(keeps_out_of_the_way)
{
    cpu_set_t all, mine, others, found;
    if (sched_getaffinity(0, sizeof all, &all) || CPU_COUNT(&all) < 2 || other_thread()) skip();
    const int here = sched_getcpu();
    CPU_ZERO(&mine);
    CPU_SET((size_t)here, &mine);
    others = all;
    CPU_CLR((size_t)here, &others);
    Team *const t = team_new(2);
    assert_non_null(t);
    assert_int_equal(team_size(t), 2);
    const pid_t helper = other_thread();
    assert_true(helper > 0);
    assert_int_equal(sched_setaffinity(0, sizeof mine, &mine), 0);
    /* apart from the caller: it helps */
    assert_int_equal(sched_setaffinity(helper, sizeof others, &others), 0);
    assert_true(helped(t, 5, 20000) > 0);
    /* on the caller's core it soon does nothing (on a busy machine it comes there late), and stays if nothing moves it
     */
    assert_int_equal(sched_setaffinity(helper, sizeof mine, &mine), 0);
    for (int tries = 0; helped(t, 1, 100) > 0;) assert_true(++tries < 200);
    assert_int_equal(sched_getaffinity(helper, sizeof found, &found), 0);
    assert_true(CPU_EQUAL(&found, &mine));
    /* unpinned, it goes to all others, and helps again */
    team_pin(t, 1);
    assert_true(helped(t, 5, 20000) > 0);
    assert_int_equal(sched_getaffinity(helper, sizeof found, &found), 0);
    assert_true(CPU_EQUAL(&found, &others));
    assert_null(team_free(t));
    /* where the process may use one core there is no second thread */
    Team *const alone = team_new(2);
    assert_int_equal(team_size(alone), 1);
    assert_int_equal(other_thread(), 0);
    team_free(alone);
    sched_setaffinity(0, sizeof all, &all);
}
