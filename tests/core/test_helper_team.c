/* A team whose second thread cannot be had, has no core of its own, or is woken where it is in the way: both shares of
 * every job are done once all the same. The system's answers are this file's. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <string.h>
#include <time.h>

#include "core/team.h"
#include "tests/support/check.h"

static int replaced;     /* the system's answers are those below: during the tests of this file */
static int cores = 2;    /* that the process may use */
static int no_thread;    /* none can be made */
static int one_core;     /* every thread is told that it runs on core 0 */
static atomic_int moved; /* threads that have confined themselves to other cores than 0 */

int sched_getcpu(void)
{
    int (*const real)(void) = (int (*)(void))dlsym(RTLD_NEXT, "sched_getcpu");
    return one_core ? 0 : real();
}

int sched_getaffinity(pid_t thread, size_t size, cpu_set_t *set)
{
    if (!replaced) {
        return ((int (*)(pid_t, size_t, cpu_set_t *))dlsym(RTLD_NEXT, "sched_getaffinity"))(thread, size, set);
    }
    memset(set, 0, size);
    if (cores < 0) return -1;
    for (int k = 0; k < cores; ++k) CPU_SET((size_t)k, set);
    return 0;
}

int sched_setaffinity(pid_t thread, size_t size, const cpu_set_t *set)
{
    if (!replaced) {
        return ((int (*)(pid_t, size_t, const cpu_set_t *))dlsym(RTLD_NEXT, "sched_setaffinity"))(thread, size, set);
    }
    if (!CPU_ISSET(0, set) && CPU_COUNT(set) == cores - 1) atomic_fetch_add(&moved, 1);
    return 0;
}

int pthread_create(pthread_t *thread, const pthread_attr_t *attr, void *(*begin)(void *), void *arg)
{
    int (*const real)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *) =
        (int (*)(pthread_t *, const pthread_attr_t *, void *(*)(void *), void *))dlsym(RTLD_NEXT, "pthread_create");
    return no_thread ? EAGAIN : real(thread, attr, begin, arg);
}

/* How often each share has been done. */
static atomic_int done[2];
static void share(void *arg, int rank)
{
    (void)arg;
    atomic_fetch_add(&done[rank], 1);
}

static void jobs(Team *t, int count)
{
    for (int k = 0; k < 2; ++k) atomic_store(&done[k], 0);
    for (int k = 0; k < count; ++k) team_run(t, share, NULL);
    for (int k = 0; k < 2; ++k) assert_int_equal(atomic_load(&done[k]), count);
}

TEST(test_no_thread)
{
    no_thread = 1;
    assert_null(team_new(2));
    Team *t = team_new(1);
    assert_non_null(t);
    jobs(t, 10);
    team_free(t);
    no_thread = 0;
}

TEST(test_one_core)
{
    for (cores = -1; cores < 2; ++cores) {
        Team *const t = team_new(2);
        assert_int_equal(team_size(t), 1);
        jobs(t, 10);
        team_free(t);
    }
    cores = 2;
}

/* Woken where the caller is the helper does nothing; it moves away only if it may. */
TEST(test_in_the_way)
{
    one_core = 1;
    for (int pin = 0; pin < 2; ++pin) {
        atomic_store(&moved, 0);
        Team *const t = team_new(2);
        assert_int_equal(team_size(t), 2);
        team_pin(t, pin);
        const struct timespec wait = {.tv_nsec = 1000000};
        for (int k = 0; k < 5000 && (k < 100 || (pin && !atomic_load(&moved))); ++k) {
            jobs(t, 1);
            nanosleep(&wait, NULL);
        }
        team_free(t);
        if (pin) check_above(atomic_load(&moved), 0);
        if (!pin) assert_int_equal(atomic_load(&moved), 0);
    }
    one_core = 0;
}

static int replace(void **state)
{
    (void)state;
    replaced = 1;
    return 0;
}

static int restore(void **state)
{
    (void)state;
    replaced = 0;
    return 0;
}

TEST_GROUP(replace, restore)
