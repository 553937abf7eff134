/* A study on several ranks. Rank 0 gives out ranges of the units that are open, half of what is left over all ranks at
 * a time, so that the last ones are short; it computes too, since workers are processes beside the one that talks. Each
 * rank appends to files of its own. What a rank that dies leaves open is computed by the next start. */
#include <limits.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "study/engine/engine.h"

/* s: between words of a rank about how far it is; between looks for a message, where there is nothing else to do. */
static const double TELL = 0.25, LOOK = 0.01;

/* message[0]; then done, failed, not safe of ASK, TELL and OVER; from, to of RANGE; a status of OVER. */
typedef enum Say { SAY_TELL, SAY_ASK, SAY_OVER, SAY_RANGE, SAY_CLOSED, SAY_STOP, SAY_PART } Say;
enum { SAID_STATE = 1, SAID_STATUS = 4, SAID_RANGE = 1 };

/* What rank 0 knows of another. */
typedef struct Mate {
    int asks, over, stopped;
    hawser_status status;
    int64_t state[3];
} Mate;

typedef struct Ranked {
    const hawser_ranks *ranks;
    const Units *units;
    long next;                  /* rank 0: of the units that nobody has */
    int single;                 /* units are long: one at a time */
    Mate *mate;                 /* rank 0: [count]; its own is not used */
    int asked, closed, stopped; /* another rank */
    double told;
} Ranked;

static void say(const Ranked *r, int to, Say what, int64_t a, int64_t b)
{
    const int64_t message[HAWSER_RANK_WORDS] = {(int64_t)what, a, b};
    r->ranks->send(r->ranks->user, to, message);
}

static void say_state(const Ranked *r, Say what, const hawser_study_state *own, hawser_status status)
{
    const int64_t message[HAWSER_RANK_WORDS] = {what, own->done, own->failed, own->not_safe, (int64_t)status};
    r->ranks->send(r->ranks->user, 0, message);
}

/* ---------------------------------------------------------------------------------------------------------- rank 0 */

/* Places from .. to-1 of the list of what is open; their units follow each other without a gap. */
static Fed range_take(Ranked *r, long *from, long *to)
{
    const Units *const u = r->units;
    const long left = u->n - r->next, share = r->single ? 1 : left / (2 * r->ranks->count);
    if (left == 0) return FED_NO_MORE;
    *from = r->next++;
    while (r->next - *from < share && u->unit[r->next] == u->unit[r->next - 1] + 1) r->next++;
    *to = r->next;
    return FED_MORE;
}

/* Every message that is there, and an answer to who asks. */
static void messages_serve(Ranked *r)
{
    int64_t message[HAWSER_RANK_WORDS];
    int from;
    while (r->ranks->receive(r->ranks->user, &from, message)) {
        Mate *const m = &r->mate[from];
        memcpy(m->state, message + SAID_STATE, sizeof m->state);
        if (message[0] == SAY_ASK) m->asks = 1;
        if (message[0] == SAY_OVER) m->over = 1;
        if (message[0] == SAY_OVER) m->status = (hawser_status)message[SAID_STATUS];
    }
    for (int k = 1; k < r->ranks->count; k++) {
        long a = 0, b = 0;
        if (!r->mate[k].asks || r->mate[k].over) continue;
        const Fed fed = range_take(r, &a, &b);
        if (fed == FED_MORE) say(r, k, SAY_RANGE, r->units->unit[a], r->units->unit[b - 1] + 1);
        if (fed == FED_NO_MORE) say(r, k, SAY_CLOSED, 0, 0);
        r->mate[k].asks = 0;
    }
}

/* The state of all. */
static void state_add(const Ranked *r, hawser_study_state *state)
{
    const long before = r->units->before.done;
    for (int k = 1; k < r->ranks->count; k++) {
        state->done += r->mate[k].state[0];
        state->failed += r->mate[k].state[1];
        state->not_safe += r->mate[k].state[2];
    }
    const long mine = state->done - before;
    state->jobs *= r->ranks->count;
    state->left_s = mine > 0 ? state->wall_s / (double)mine * (double)(state->samples - state->done) : NAN;
}

static Fed first_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Ranked *const r = user;
    messages_serve(r);
    state_add(r, state);
    for (int k = 1; k < r->ranks->count; k++) {
        if (r->mate[k].over && r->mate[k].status) return FED_STOP;
    }
    return empty ? range_take(r, from, to) : FED_NOT_YET;
}

/* After its own workers: until all others are over, who stop where `status` is not OK. Returns what went wrong first.
 */
static hawser_status others_wait(Ranked *r, const hawser_study_options *options, hawser_study_state *own,
                                 hawser_status status, hawser_error *err)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
    const double start = clock_now() - own->wall_s;
    double told = 0;
    for (int open = 1; open;) {
        open = 0;
        messages_serve(r);
        for (int k = 1; k < r->ranks->count; k++) {
            Mate *const m = &r->mate[k];
            open += !m->over;
            if (m->over && m->status && !status)
                status = error_set(err, m->status, "rank %d could not go on: the same command does", k);
            if (status && !m->over && !m->stopped) say(r, k, SAY_STOP, 0, 0);
            m->stopped |= status && !m->over;
        }
        const double now = clock_now();
        if (open) nanosleep(&pause, NULL);
        if (!options->progress || (open && now - told < TELL)) continue;
        hawser_study_state state = *own;
        state.wall_s = now - start;
        state_add(r, &state);
        told = now;
        if (options->progress(options->user, &state) && open && !status)
            status = error_set(err, HAWSER_STOPPED, "stopped with %ld of %ld samples: the same command goes on",
                               state.done, state.samples);
    }
    return status;
}

/* ------------------------------------------------------------------------------------------------------ the others */

static Fed other_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Ranked *const r = user;
    int64_t message[HAWSER_RANK_WORDS];
    int sender;
    const double now = clock_now();
    if (empty && !r->asked && !r->closed) {
        say_state(r, SAY_ASK, state, HAWSER_OK);
        r->asked = 1;
        r->told = now;
    } else if (now - r->told >= TELL) {
        say_state(r, SAY_TELL, state, HAWSER_OK);
        r->told = now;
    }
    while (r->ranks->receive(r->ranks->user, &sender, message)) {
        if (message[0] == SAY_STOP) return FED_STOP;
        r->asked = 0;
        if (message[0] == SAY_CLOSED) r->closed = 1;
        if (message[0] != SAY_RANGE) continue;
        *from = (long)message[SAID_RANGE];
        *to = (long)message[SAID_RANGE + 1];
        return FED_MORE;
    }
    return r->closed ? FED_NO_MORE : FED_NOT_YET;
}

/* Sleeps until rank 0 says that the next part begins or the study is over: a collective call would spin. */
static void part_wait(const Ranked *r)
{
    const struct timespec pause = {.tv_nsec = (long)(1e9 * LOOK)};
    int64_t message[HAWSER_RANK_WORDS] = {SAY_TELL};
    int sender;
    while (!r->ranks->receive(r->ranks->user, &sender, message) || message[0] != SAY_PART) nanosleep(&pause, NULL);
}

/* -------------------------------------------------------------------------------------------------------- together */

hawser_status ranks_agree(const hawser_ranks *ranks, hawser_status status, hawser_error *err)
{
    int64_t first = status;
    ranks->share(ranks->user, &first, sizeof first);
    if (ranks->rank == 0 || first == HAWSER_OK) return status;
    return error_set(err, (hawser_status)first, "the first rank could not go on");
}

/* Counts of this engine alone, as the last call of its feed had them. */
typedef struct Counted {
    Fed (*more)(void *user, int empty, hawser_study_state *state, long *from, long *to);
    Ranked *ranked;
    hawser_study_state own;
} Counted;
static Fed counted_more(void *user, int empty, hawser_study_state *state, long *from, long *to)
{
    Counted *const c = user;
    c->own = *state;
    return c->more(c->ranked, empty, state, from, to);
}

static hawser_status first_run(const Study *s, const char *dir, const hawser_study_options *mine, Ranked *r, Rows *rows,
                               double *efficiency, hawser_error *err)
{
    hawser_error late;
    Counted counted = {first_more, r, r->units->before};
    const Feed feed = {counted_more, &counted};
    hawser_status status = engine_run(s, dir, "rank-0", mine, r->units, &feed, rows, efficiency, err);
    counted.own.jobs = mine->jobs;
    for (int k = 1; k < r->ranks->count && status == HAWSER_STOPPED; k++) {
        if (r->mate[k].status) status = HAWSER_OK; /* it is why, and others_wait says so */
    }
    status = others_wait(r, mine, &counted.own, status, status ? &late : err);
    for (int k = 1; k < r->ranks->count; k++) say(r, k, SAY_PART, 0, 0);
    const hawser_status read = store_read(s, dir, rows, &late);
    return read && !status ? error_set(err, read, "%s", late.message) : status;
}

/* Units are their own numbers here: rank 0 has the list. A search needs the rows of earlier starts. */
static hawser_status other_run(const Study *s, const char *dir, const hawser_study_options *mine, Ranked *r, Rows *rows,
                               double *efficiency, hawser_error *err)
{
    char crew[CREW_MAX];
    Counted counted = {other_more, r, {0}};
    const Feed feed = {counted_more, &counted};
    snprintf(crew, sizeof crew, "rank-%d", r->ranks->rank);
    hawser_status status = HAWSER_OK;
    if (study_searches(s)) status = store_read(s, dir, rows, err);
    if (!status) status = engine_run(s, dir, crew, mine, r->units, &feed, rows, efficiency, err);
    say_state(r, SAY_OVER, &counted.own, status);
    part_wait(r);
    return status;
}

/* Once over what is open; *left: how much that was. */
static hawser_status round_run(Study *s, const char *dir, const hawser_study_options *mine, const hawser_ranks *ranks,
                               int pilots, Rows *rows, long *left, double *efficiency, hawser_error *err)
{
    Units units = {0};
    Ranked r = {.ranks = ranks, .units = &units, .single = study_searches(s)};
    hawser_status status = ranks->rank ? HAWSER_OK : units_open(s, pilots, rows, &units, err);
    r.mate = ranks->rank ? NULL : calloc((size_t)ranks->count, sizeof *r.mate);
    if (!status && !ranks->rank && !r.mate) status = error_memory(err);
    status = ranks_agree(ranks, status, err);
    if (!status) {
        ranks->share(ranks->user, &units.n, sizeof units.n);
        ranks->share(ranks->user, s->close, sizeof s->close);
    }
    const int more = !status && units.n > 0 && units.n < *left;
    *left = more ? units.n : 0;
    if (more) {
        status = (ranks->rank ? other_run : first_run)(s, dir, mine, &r, rows, efficiency, err);
        status = ranks_agree(ranks, status, err);
    }
    free(r.mate);
    free(units.unit);
    return status;
}

/* Again for what a worker took along that died before it said so. */
hawser_status ranks_run(Study *s, const char *dir, const hawser_study_options *options, const hawser_ranks *ranks,
                        int pilots, Rows *rows, double *efficiency, hawser_error *err)
{
    hawser_study_options mine = *options;
    mine.jobs = options->jobs > 0 ? options->jobs : 1;
    hawser_status status = HAWSER_OK;
    for (long left = LONG_MAX; left > 0 && !status;)
        status = round_run(s, dir, &mine, ranks, pilots, rows, &left, efficiency, err);
    return status;
}
