/* Runs of one case with finer settings, side by side: each on a thread of its own with a simulation of its own, which
 * share nothing. The caller's thread waits and tells how far they are. */
#include <math.h>
#include <pthread.h>
#include <stdio.h>
#include <string.h>
#include <time.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "io/certify/certify.h"

enum { THREADS_MAX = 2 };
static const double TELL = 0.2;         /* s between two words to the caller */
static const double SHARE_KNOWN = 0.02; /* of a run, from which its speed says when it will end */

typedef struct Pool {
    const SceneDef *def;
    int n, next, over; /* runs; the next to be taken; those that have ended */
    Companion *const *companion;
    int stop;             /* the caller wants no more */
    hawser_status status; /* MEMORY is the round's; all else is the run's own */
    pthread_mutex_t lock; /* around what changes: the above, `share` and `seconds` of the companions */
    pthread_cond_t ended;
} Pool;

void companion_describe(const hawser_sim *s, Companion *out)
{
    const SceneDef *const def = &s->stage.scene.def;
    hawser_summary sum;
    hawser_sim_summary(s, &sum);
    hawser_certify_run *const about = &out->about;
    about->accuracy = def->solver.accuracy;
    about->interval_s = def->output.interval;
    about->segments = sum.segments;
    about->friction = refinement_slower(def, about->level[HAWSER_TIME]);
    about->steps = sum.steps;
    /* statics have no rates: a Newton step a load step and a segment */
    out->evaluations = (sum.rhs_evals > 0 ? (double)sum.rhs_evals : def->analysis.load_steps) * sum.segments;
}

/* A run's own progress function: notes how far it is, and whether it may go on. */
typedef struct Note {
    Pool *pool;
    Companion *companion;
    double started; /* clock_now() */
    int too_much;   /* it was given up */
} Note;

/* After each step: whether the run has done more than all that it may, so that it ends at the same one however fast the
 * machine is. Finer settings can make a scene endless. */
static int too_much(void *user, hawser_sim *sim, double t)
{
    Note *const note = user;
    IntegratorStats now = {0};
    (void)t;
    integrator_stats(sim->stage.integrator, &now);
    note->too_much = (double)now.rhs_evals * sim->stage.scene.total > note->companion->most;
    return note->too_much;
}

static int note_progress(void *user, const hawser_sample *sample, double wall_s, double end_s)
{
    const Note *const note = user;
    (void)wall_s;
    pthread_mutex_lock(&note->pool->lock);
    note->companion->share = end_s > 0 ? fmin(sample->t / end_s, 1) : 0;
    note->companion->seconds = clock_now() - note->started;
    const int stop = note->pool->stop;
    pthread_mutex_unlock(&note->pool->lock);
    return stop;
}

/* From the definition to the figures. */
static hawser_status run_one(const SceneDef *def, Companion *c, Note *note, hawser_error *err)
{
    SceneDef finer;
    hawser_sim *sim = NULL;
    hawser_status status = scene_def_copy(def, &finer, err);
    if (status) return status;
    scene_def_refine(&finer, c->about.level);
    status = sim_new(&finer, 1, &sim, err);
    scene_def_clear(&finer);
    if (!status) hawser_sim_on_step(sim, too_much, note);
    if (!status) status = hawser_sim_run(sim, NULL, note_progress, note, err);
    c->given_up = note->too_much && status == HAWSER_STOPPED;
    if (c->given_up)
        status = error_set(err, HAWSER_ERR_RUN, "given up at t = %.4g s: it was taking too long (see --effort)",
                           hawser_sim_time(sim));
    if (sim) companion_describe(sim, c);
    if (!status) status = figures_take(sim, &c->figures, err);
    sim_free(sim);
    return status;
}

/* A thread: takes runs until there are none. */
static void *work(void *arg)
{
    Pool *const pool = arg;
    pthread_mutex_lock(&pool->lock);
    while (pool->next < pool->n && !pool->stop && !pool->status) {
        Companion *const c = pool->companion[pool->next++];
        pthread_mutex_unlock(&pool->lock);
        Note note = {.pool = pool, .companion = c, .started = clock_now()};
        hawser_error err = {HAWSER_OK, ""};
        const hawser_status status = run_one(pool->def, c, &note, &err);
        pthread_mutex_lock(&pool->lock);
        c->about.status = status;
        if (status) snprintf(c->about.message, sizeof c->about.message, "%.255s", err.message);
        if (status == HAWSER_ERR_MEMORY) pool->status = status;
        c->share = 1;
        c->seconds = clock_now() - note.started;
        pool->over++;
        pthread_cond_signal(&pool->ended);
    }
    pthread_mutex_unlock(&pool->lock);
    return NULL;
}

/* What is being computed, and when the round will be over: runs that have not begun will take as long as the others on
 * average. The lock is held. */
static void state_fill(const Pool *pool, int threads, CertifyRound *round, char *what, size_t size)
{
    hawser_certify_state *const state = &round->state;
    double whole = 0, left = 0, known = 0, share = 0;
    what[0] = 0;
    for (int i = 0; i < pool->n; ++i) {
        const Companion *const c = pool->companion[i];
        const int *const level = c->about.level;
        const size_t used = strlen(what);
        share += c->share;
        if (i < pool->next && c->share < 1) {
            snprintf(what + used, size - used, "%stime %d, length %d", used ? "; " : "", level[HAWSER_TIME],
                     level[HAWSER_LENGTH]);
        }
        if (c->share < SHARE_KNOWN) continue;
        whole += c->seconds / c->share;
        left += c->seconds / c->share - c->seconds;
        known++;
    }
    left += (round->runs - round->over - known) * whole / fmax(known, 1);
    state->what = what;
    state->runs = round->runs;
    state->over = round->over + pool->over;
    state->done = (round->over + share) / round->runs;
    state->left_s = known > 0 ? left / threads : NAN;
}

/* Until all have ended; the caller is told a few times a second, without the lock. */
static void wait_for_all(Pool *pool, CertifyRound *round, int threads)
{
    char what[160];
    pthread_mutex_lock(&pool->lock);
    while (pool->over < pool->n && !(pool->over == pool->next && (pool->stop || pool->status))) {
        struct timespec until;
        clock_gettime(CLOCK_REALTIME, &until);
        const long ns = until.tv_nsec + (long)(1e9 * TELL);
        until.tv_sec += ns / 1000000000L;
        until.tv_nsec = ns % 1000000000L;
        pthread_cond_timedwait(&pool->ended, &pool->lock, &until);
        state_fill(pool, threads, round, what, sizeof what);
        if (!round->progress) continue;
        pthread_mutex_unlock(&pool->lock);
        const int stop = round->progress(round->user, &round->state);
        pthread_mutex_lock(&pool->lock);
        pool->stop |= stop != 0;
    }
    pthread_mutex_unlock(&pool->lock);
}

hawser_status companions_run(CertifyRound *round, int n, Companion *const *companion, hawser_error *err)
{
    Pool pool = {.def = round->def,
                 .n = n,
                 .companion = companion,
                 .lock = PTHREAD_MUTEX_INITIALIZER,
                 .ended = PTHREAD_COND_INITIALIZER};
    pthread_t thread[THREADS_MAX];
    int threads = 0;
#ifdef HAWSER_THREADS
    while (threads < round->threads && threads < THREADS_MAX && threads < n &&
           !pthread_create(&thread[threads], NULL, work, &pool))
        ++threads;
#endif
    if (threads > 0) wait_for_all(&pool, round, threads);
    if (threads == 0) work(&pool); /* no thread is to be had: in this one, and without a word */
    for (int k = 0; k < threads; ++k) pthread_join(thread[k], NULL);
    pthread_mutex_destroy(&pool.lock);
    pthread_cond_destroy(&pool.ended);
    if (pool.status) return error_memory(err);
    return pool.stop ? error_set(err, HAWSER_STOPPED, "stopped while the figures were being certified") : HAWSER_OK;
}
