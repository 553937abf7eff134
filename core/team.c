#define _GNU_SOURCE
#include "core/team.h"

#include <assert.h>
#include <pthread.h>
#include <sched.h>
#include <stdatomic.h>
#include <stdlib.h>

/* How often a waiting thread looks before it sleeps: some tens of microseconds, longer than the gaps in a step. */
enum { SPINS = 2000, CACHE_LINE = 64 };

/* What one member says and the other hears: a count of events. The members meet at every event (a job's start and end, a
 * barrier), so a count is all that is needed. */
typedef struct Member {
    _Alignas(CACHE_LINE) atomic_ulong said;
    atomic_int other_sleeps; /* until `said` grows */
    pthread_mutex_t lock;
    pthread_cond_t woken;
    _Alignas(CACHE_LINE) unsigned long heard; /* events of the other member, own use */
} Member;

struct Team {
    int size;
    TeamJob job; /* NULL: the helper is to end */
    void *arg;
    pthread_t helper;
    Member member[2];
};

static inline void cpu_relax(void)
{
#ifdef HAWSER_X86
    __builtin_ia32_pause();
#endif
}

static void member_say(Member *self)
{
    atomic_fetch_add(&self->said, 1);
    if (!atomic_load(&self->other_sleeps)) return;
    pthread_mutex_lock(&self->lock);
    pthread_cond_signal(&self->woken);
    pthread_mutex_unlock(&self->lock);
}

/* Waits for the other member's next event. Either this thread sees `said` after it announced its sleep, or the other
 * sees the announcement after it spoke (both are sequentially consistent): no wake-up is lost. */
static void member_hear(Member *self, Member *other)
{
    const unsigned long next = ++self->heard;
    for (int k = 0; k < SPINS; ++k) {
        if (atomic_load_explicit(&other->said, memory_order_acquire) >= next) return;
        cpu_relax();
    }
    pthread_mutex_lock(&other->lock);
    atomic_store(&other->other_sleeps, 1);
    while (atomic_load(&other->said) < next) pthread_cond_wait(&other->woken, &other->lock);
    atomic_store(&other->other_sleeps, 0);
    pthread_mutex_unlock(&other->lock);
}

static void *helper_main(void *team)
{
    Team *const t = team;
    for (;;) {
        member_hear(&t->member[1], &t->member[0]);
        if (!t->job) return NULL;
        t->job(t->arg, 1);
        member_say(&t->member[1]);
    }
}

/* Cores that this process may run on. */
static int cores_available(void)
{
    cpu_set_t set;
    CPU_ZERO(&set);
    return sched_getaffinity(0, sizeof set, &set) == 0 ? CPU_COUNT(&set) : 1;
}

static void members_init(Team *t)
{
    for (int rank = 0; rank < 2; ++rank) {
        atomic_init(&t->member[rank].said, 0);
        atomic_init(&t->member[rank].other_sleeps, 0);
        pthread_mutex_init(&t->member[rank].lock, NULL);
        pthread_cond_init(&t->member[rank].woken, NULL);
    }
}

static Team *team_drop(Team *t)
{
    for (int rank = 0; rank < 2; ++rank) {
        pthread_mutex_destroy(&t->member[rank].lock);
        pthread_cond_destroy(&t->member[rank].woken);
    }
    free(t);
    return NULL;
}

Team *team_new(int threads)
{
    assert(threads == 1 || threads == 2);
    Team *const t = aligned_alloc(CACHE_LINE, sizeof *t);
    if (!t) return NULL;
    *t = (Team){.size = threads == 2 && cores_available() > 1 ? 2 : 1};
    members_init(t);
    if (t->size == 2 && pthread_create(&t->helper, NULL, helper_main, t)) return team_drop(t);
    return t;
}

Team *team_free(Team *t)
{
    if (!t) return NULL;
    if (t->size == 2) {
        t->job = NULL;
        member_say(&t->member[0]);
        pthread_join(t->helper, NULL);
    }
    return team_drop(t);
}

int team_size(const Team *t) { return t ? t->size : 1; }

void team_run(Team *t, TeamJob job, void *arg)
{
    assert(job);
    if (team_size(t) == 1) {
        job(arg, 0);
        return;
    }
    t->job = job;
    t->arg = arg;
    member_say(&t->member[0]);
    job(arg, 0);
    member_hear(&t->member[0], &t->member[1]);
}

void team_barrier(Team *t, int rank)
{
    if (team_size(t) == 1) return;
    member_say(&t->member[rank]);
    member_hear(&t->member[rank], &t->member[1 - rank]);
}
