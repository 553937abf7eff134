#define _GNU_SOURCE
#include "core/team.h"

#include <assert.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>
#include <unistd.h>

/* Number of checks of a waiting thread before it sleeps: some 150 microseconds, longer than the gaps in a step. */
enum { SPINS = 6000, CACHE_LINE = 64 };
/* After so many jobs in a row for which the helper came too late (its core is busy), the caller works alone for a
 * number of jobs, without the cost of waking the helper. */
enum { MISSES = 4, REST = 64 };

/* A count that one thread raises and the other awaits. */
typedef struct Signal {
    _Alignas(CACHE_LINE) atomic_ulong count;
    atomic_int awaited; /* the other thread sleeps until `count` grows */
    pthread_mutex_t lock;
    pthread_cond_t woken;
} Signal;

struct Team {
    int size;
    pid_t process; /* process in which the helper runs */
    pthread_t helper;
    int missed, rest;  /* the caller's: jobs in a row that the helper missed; jobs still to be done alone */
    cpu_set_t cores;   /* cores allowed for the process */
    atomic_int core;   /* core of the caller */
    atomic_int ending; /* 1: the helper has to end */
    atomic_int pin;    /* 1: the helper may restrict itself to other cores */
    TeamJob job;       /* of the job counted by `given` */
    void *arg;
    Signal given;                            /* number of jobs so far */
    Signal done;                             /* the last job whose second share the helper has finished */
    _Alignas(CACHE_LINE) atomic_ulong taken; /* the last job whose second share was taken */
};

static inline void cpu_relax(void)
{
#ifdef HAWSER_X86
    __builtin_ia32_pause();
#endif
}

static void signal_init(Signal *s)
{
    atomic_init(&s->count, 0);
    atomic_init(&s->awaited, 0);
    pthread_mutex_init(&s->lock, NULL);
    pthread_cond_init(&s->woken, NULL);
}

static void signal_drop(Signal *s)
{
    pthread_mutex_destroy(&s->lock);
    pthread_cond_destroy(&s->woken);
}

static void signal_raise(Signal *s, unsigned long to)
{
    atomic_store(&s->count, to);
    if (!atomic_load(&s->awaited)) return;
    pthread_mutex_lock(&s->lock);
    pthread_cond_signal(&s->woken);
    pthread_mutex_unlock(&s->lock);
}

/* Waits until the count is at least `goal`. Either this thread sees the new count after it has announced its sleep, or
 * the other sees the announcement after it has raised the count (both are sequentially consistent): no wake-up is
 * lost. */
static unsigned long signal_await(Signal *s, unsigned long goal, int spins)
{
    for (int k = 0; k < spins; ++k) {
        const unsigned long count = atomic_load_explicit(&s->count, memory_order_acquire);
        if (count >= goal) return count;
        cpu_relax();
    }
    pthread_mutex_lock(&s->lock);
    atomic_store(&s->awaited, 1);
    while (atomic_load(&s->count) < goal) pthread_cond_wait(&s->woken, &s->lock);
    atomic_store(&s->awaited, 0);
    pthread_mutex_unlock(&s->lock);
    return atomic_load(&s->count);
}

/* Takes the second share of job number `job`, if it is the latest and not taken yet. */
static int share_take(Team *t, unsigned long job)
{
    unsigned long before = job - 1;
    return atomic_compare_exchange_strong(&t->taken, &before, job);
}

/* On a busy machine the helper may be woken on the caller's own core, where it only delays the caller. */
static int in_the_way(Team *t) { return sched_getcpu() == atomic_load_explicit(&t->core, memory_order_relaxed); }

/* Restricts the helper to the other cores allowed for the process. */
static void move_away(Team *t)
{
    cpu_set_t others = t->cores;
    CPU_CLR((size_t)atomic_load_explicit(&t->core, memory_order_relaxed), &others);
    if (CPU_COUNT(&others) > 0) sched_setaffinity(0, sizeof others, &others);
}

static void *helper_main(void *team)
{
    Team *const t = team;
    for (unsigned long job = 0;;) {
        job = signal_await(&t->given, job + 1, in_the_way(t) ? 0 : SPINS);
        if (atomic_load(&t->ending)) return NULL;
        if (in_the_way(t)) {
            if (atomic_load_explicit(&t->pin, memory_order_relaxed)) move_away(t);
            continue; /* the caller does it, or has done it */
        }
        if (!share_take(t, job)) continue;
        t->job(t->arg, 1);
        signal_raise(&t->done, job);
    }
}

static Team *team_drop(Team *t)
{
    signal_drop(&t->given);
    signal_drop(&t->done);
    free(t);
    return NULL;
}

Team *team_new(int threads)
{
    assert(threads == 1 || threads == 2);
    Team *const t = aligned_alloc(CACHE_LINE, sizeof *t);
    if (!t) return NULL;
    *t = (Team){.size = 1, .process = getpid()};
    if (threads == 2 && sched_getaffinity(0, sizeof t->cores, &t->cores) == 0 && CPU_COUNT(&t->cores) > 1) t->size = 2;
    signal_init(&t->given);
    signal_init(&t->done);
    atomic_init(&t->taken, 0);
    atomic_init(&t->core, -1);
    atomic_init(&t->ending, 0);
    atomic_init(&t->pin, 0);
    if (t->size == 2 && pthread_create(&t->helper, NULL, helper_main, t)) return team_drop(t);
    return t;
}

void team_pin(Team *t, int pin) { atomic_store(&t->pin, pin != 0); }

void team_settle(Team *t)
{
    if (t && t->process != getpid()) t->size = 1;
}

/* In a forked process the objects on which the lost thread waited can neither be woken nor destroyed: glibc would wait
 * for it. */
Team *team_free(Team *t)
{
    if (!t) return NULL;
    if (t->process != getpid()) {
        free(t);
        return NULL;
    }
    if (t->size == 2) {
        atomic_store(&t->ending, 1);
        signal_raise(&t->given, atomic_load(&t->given.count) + 1);
        pthread_join(t->helper, NULL);
    }
    return team_drop(t);
}

int team_size(const Team *t) { return t ? t->size : 1; }

int team_ready(Team *t)
{
    if (team_size(t) == 1) return 0;
    if (t->rest > 0) --t->rest;
    return t->rest == 0;
}

void team_run(Team *t, TeamJob job, void *arg)
{
    assert(job);
    if (!team_ready(t)) {
        job(arg, 0);
        job(arg, 1);
        return;
    }
    const unsigned long number = atomic_load(&t->given.count) + 1;
    t->job = job;
    t->arg = arg;
    atomic_store_explicit(&t->core, sched_getcpu(), memory_order_relaxed);
    signal_raise(&t->given, number);
    job(arg, 0);
    if (share_take(t, number)) {
        job(arg, 1);
        t->missed = (t->missed + 1) % MISSES;
        if (!t->missed) t->rest = REST;
    } else {
        signal_await(&t->done, number, SPINS);
        t->missed = 0;
    }
}
