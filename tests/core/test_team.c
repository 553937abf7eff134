/* Two threads: every share is done once, what they write is seen, and they wait for nobody for ever. */
#include <time.h>

#include "core/team.h"
#include "tests/support/check.h"

enum { VALUES = 1000 };

typedef struct Work {
    long runs[2];
    long value[2][VALUES];
    long work; /* rounds, to make a share long */
} Work;

static void share(void *arg, int rank)
{
    Work *const w = arg;
    ++w->runs[rank];
    for (long k = 0; k < VALUES + w->work; ++k) w->value[rank][k % VALUES] += rank + 1;
}

static void pause_ns(long ns)
{
    const struct timespec t = {.tv_nsec = ns};
    nanosleep(&t, NULL);
}

/* The shares of `jobs` jobs, each checked as soon as team_run returns. */
static void run_jobs(Team *t, int jobs, long work, long pause)
{
    static Work w;
    w = (Work){.work = work};
    for (int job = 1; job <= jobs; ++job) {
        team_run(t, share, &w);
        for (int rank = 0; rank < 2; ++rank) {
            assert_int_equal(w.runs[rank], job);
            assert_int_equal(w.value[rank][VALUES - 1], (rank + 1) * job * (1 + work / VALUES));
        }
        if (pause) pause_ns(pause);
    }
}

TEST(two_threads)
{
    Team *t = team_new(2);
    assert_non_null(t);
    run_jobs(t, 5000, 0, 0);
    run_jobs(t, 300, 50 * VALUES, 0);
    t = team_free(t);
    assert_null(t);
}

/* The helper falls asleep between jobs and is woken, or is not there in time and the caller does its share. */
TEST(sleeping_helper)
{
    Team *t = team_new(2);
    run_jobs(t, 100, 100 * VALUES, 300000);
    run_jobs(t, 100, 0, 300000);
    team_free(t);
}

TEST(one_thread)
{
    Team *t = team_new(1);
    assert_int_equal(team_size(t), 1);
    assert_int_equal(team_size(NULL), 1);
    assert_false(team_ready(t));
    assert_false(team_ready(NULL));
    run_jobs(t, 10, 0, 0);
    run_jobs(NULL, 10, 0, 0);
    assert_null(team_free(t));
    assert_null(team_free(NULL));
}

/* Teams come and go, used or not. */
TEST(many_teams)
{
    for (int k = 0; k < 50; ++k) {
        Team *const t = team_new(2), *const other = team_new(2);
        assert_int_equal(team_ready(t), team_size(t) == 2); /* a new one does not rest */
        if (k % 2) run_jobs(t, 3, 0, 0);
        if (k % 3) run_jobs(other, 3, 0, 0);
        team_free(t);
        team_free(other);
    }
}
