#include "sim/run/quasi_run.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/clock.h"
#include "core/base/error.h"
#include "core/state.h"
#include "sim/equipment/winch.h"
#include "sim/run/look.h"

/* What the pull may swing by, and a position differ from its mean, for positions to go on: shares of it (QS2), (QS3).
 */
static const double SWING = 0.01, APART = 0.01;
static const double STRETCH = 3; /* windows, that a stretch of positions must last to be worth it */
/* Longest segments between two positions: golden, so that they meet every phase of a segment's ripple (QS4). */
static const double GOLDEN = 2.6180339887498949;
enum { POSITIONS_LEAST = 40, CHECKS = 4 }; /* of a stretch: positions; of a run: how often motion is asked again */
static const double TOLERANCE = 5e-3;      /* of the pull, that rows between positions may be off by (QS5) */
static const double SHORTEST = 1.0 / 16;   /* of the longest step */
static const double TRIP = 0.9;            /* of the pull at which a winch trips: motion decides from there on */
static const double HANG =
    4e-4; /* of half a segment, by which one that passes the winch may hang elsewhere than thought */
enum { TRIES = 4, WAIT_MOST = 64, HANG_MOST = 8, HANG_RARELY = 16, NEAR_FRONT = 4 };

/* ------------------------------------------------------------------------------------------------------------ life */

hawser_status quasi_run_new(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const hawser_status status = quasi_new(&q->stage, &s->positions, &s->stage, err);
    q->window.from = -1;
    q->said.why = q->stage.why;
    if (status || !q->stage.damping) return status;
    q->numbers = quasi_numbers(s);
    q->memory = calloc(QUASI_KEPT * (size_t)q->numbers, sizeof *q->memory);
    for (int k = 0; q->memory && k < QUASI_KEPT; ++k) q->look[k] = q->memory + k * (ptrdiff_t)q->numbers;
    return q->memory ? quasi_peaks_new(q, &s->stage.scene.def, err) : error_memory(err);
}

void quasi_run_free(QuasiRun *q)
{
    quasi_free(&q->stage);
    free(q->memory);
    free(q->top);
    free(q->y);
    *q = (QuasiRun){0};
}

static int room_for(QuasiRun *q, int size)
{
    if (size == q->size) return 1;
    double *const y = realloc(q->y, (size_t)size * sizeof *y);
    if (!y) return 0;
    q->y = y;
    q->size = size;
    return 1;
}

/* s, in which the longest segment passes a point. */
static double passing_time(const Scene *scene, double speed)
{
    double longest = 0;
    for (int i = 0; i < scene->chain.n; ++i) longest = fmax(longest, 2 * scene->chain.half[i]);
    return longest / speed;
}

/* ------------------------------------------------------------------------------------------------------- positions */

/* The last position's state as it was when the winch had hauled in less, (QS7). */
static void state_at(Sim *s, double t)
{
    const QuasiRun *const q = &s->quasi;
    Stage *const st = &s->stage;
    const int n = st->scene.chain.n;
    const double back = t - q->t[QUASI_KEPT - 1];
    memcpy(st->y, q->y, (size_t)q->size * sizeof *st->y);
    st->t = t;
    for (int c = 0; c < 3 * n && back < 0; ++c) st->y[c] += back * st->y[STATE_V * n + c];
}

/* A position has been found: it is the last one now. */
static hawser_status keep(Sim *s, const hawser_relaxation *found, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    double *const oldest = q->look[0];
    if (!room_for(q, s->stage.motion->size)) return error_memory(err);
    for (int k = 1; k < QUASI_KEPT; ++k) {
        q->t[k - 1] = q->t[k];
        q->look[k - 1] = q->look[k];
    }
    q->t[QUASI_KEPT - 1] = s->stage.t;
    q->look[QUASI_KEPT - 1] = oldest;
    const hawser_sample *const look = sim_look(s, SAMPLE_FIELDS);
    quasi_take(s, oldest);
    quasi_peaks_seen(q, &s->stage.scene, look);
    q->active = look->active_contacts;
    memcpy(q->y, s->stage.y, (size_t)q->size * sizeof *q->y);
    ++q->known;
    ++q->said.positions;
    q->said.iterations += found->iterations;
    double push = 0, most = 0;
    for (int j = look->first; j <= look->first + look->active; ++j) {
        push = fmax(push, -look->tension[j]);
        most = fmax(most, look->tension[j]);
    }
    if (most > 0) s->positions.push_share = fmax(s->positions.push_share, push / most);
    return HAWSER_OK;
}

/* By how much a straight line between the last two positions may miss the pull, in tolerances (QS5). */
static double line_error(const QuasiRun *q)
{
    const double *const t = q->t;
    const double h1 = t[1] - t[0], h2 = t[2] - t[1], d1 = q->look[1][0] - q->look[0][0],
                 d2 = q->look[2][0] - q->look[1][0];
    const double allowed = TOLERANCE * fmax(fabs(q->look[1][0]), fabs(q->look[2][0]));
    return h2 / (4 * (h1 + h2)) * fabs(d2 - d1 * h2 / h1) / fmax(allowed, 1e-300);
}

hawser_status quasi_find(Sim *s, double t, hawser_relaxation *found, hawser_error *err)
{
    const double start = clock_now();
    *found = (hawser_relaxation){0};
    const hawser_status status = positions_advance(&s->positions, &s->stage, t, found, err);
    s->relax_s += clock_now() - start;
    return status;
}

/* Whether the winch might trip before the next position. */
static int may_trip(const Sim *s, double pull)
{
    const double trip = s->stage.scene.winch->trip_force;
    return trip > 0 && pull > TRIP * trip;
}

/* Until when positions may go on, s; the time of now: they end here. */
static double goes_until(Sim *s, double t)
{
    const QuasiRun *const q = &s->quasi;
    const Scene *const scene = &s->stage.scene;
    const double now = s->stage.t, end = fmax(t, scene->def.duration);
    const double apart = (scene->def.duration - q->said.first_s) / (CHECKS + 1);
    if (s->calls.law || s->calls.stop || may_trip(s, q->look[QUASI_KEPT - 1][0])) return now;
    if (apart > STRETCH * passing_time(scene, winch_speed(scene->winch, now)) && now > q->checked + apart) return now;
    return quasi_steady_until(scene, now, scene_next_stop(scene, now, end));
}

/* The next position, ahead of the time of now; no more than a step on. Where there is none nearer and nearer either,
 * *on is 0, and the state that of now. */
static hawser_status next_position(Sim *s, double until, int *on, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const double now = s->stage.t, speed = winch_speed(s->stage.scene.winch, now);
    const double longest = fmin(GOLDEN * passing_time(&s->stage.scene, speed),
                                (s->stage.scene.def.duration - q->said.first_s) / POSITIONS_LEAST);
    hawser_status status = HAWSER_OK;
    *on = 0;
    q->step = fmin(q->step > 0 ? q->step : longest, longest);
    for (int tries = 0; !status && !*on && tries < TRIES; ++tries) {
        const double rest = until - now, h = q->step < 0.7 * rest ? q->step : q->step < rest ? rest / 2 : rest;
        hawser_relaxation found;
        status = quasi_find(s, now + h, &found, err);
        if (status == HAWSER_ERR_RUN) {
            status = HAWSER_OK;
            q->step = h / 4;
            continue;
        }
        if (status) break;
        sim_relaxation_take(s, &found);
        status = keep(s, &found, err);
        *on = 1;
        if (q->known < QUASI_KEPT) break;
        const double off = line_error(q);
        q->step = fmax(SHORTEST * longest, h * fmin(2, fmax(0.3, 0.8 / sqrt(off + 1e-9))));
    }
    return status;
}

/* How the segments hang by which the winch holds the rope: it is asked of the next one to pass, and of those behind it
 * until one hangs as was thought (QS15). The stage is anywhere then. */
static hawser_status hang(Sim *s, double until, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    Stage *const st = &s->stage;
    const double near = HANG * st->scene.chain.half[st->scene.chain.n - 1], start = clock_now();
    double off = INFINITY, t = 0;
    PositionsKept kept = {0};
    hawser_status status = positions_keep(&s->positions, &kept, err);
    for (int k = 0; !status && k < HANG_MOST && off > near; ++k) {
        const int next = positions_passing(&s->positions, st, &t);
        if (!(t < until)) break;
        hawser_relaxation found = {0};
        status = positions_pass(&s->positions, st, next, t, &found, &off, err);
        q->said.iterations += found.iterations;
        if (k == 0) q->hangs = off > near ? q->hangs / 2 : 2 * q->hangs;
        q->hangs = q->hangs < 1 ? 1 : q->hangs < HANG_RARELY ? q->hangs : HANG_RARELY;
    }
    positions_back_to(&s->positions, &kept);
    s->relax_s += clock_now() - start;
    return status == HAWSER_ERR_RUN ? HAWSER_OK : status;
}

/* Whether the segment at the head is so far behind the last that was asked; less far as the front comes to the winch.
 */
static int hang_due(const Sim *s)
{
    const Scene *const scene = &s->stage.scene;
    const int head = scene->first + scene->chain.n - 1, known = s->positions.hanging.segment;
    const int near = (head - scene->eye) / NEAR_FRONT, after = near < s->quasi.hangs ? near : s->quasi.hangs;
    return scene->winch->take_in.present && (known < 0 || known - head >= after);
}

static hawser_status look_ahead(Sim *s, double until, int *on, hawser_error *err)
{
    const double now = s->stage.t;
    Moving here;
    hawser_status status = moving_keep(&here, &s->stage, err);
    if (!status && hang_due(s)) {
        status = hang(s, until, err);
        if (!status) status = moving_restore(&s->stage, &here, err);
    }
    if (!status) status = next_position(s, until, on, err);
    if (!status && !*on) status = moving_restore(&s->stage, &here, err);
    if (!status && *on && s->quasi.known > 1) status = quasi_peaks(s, err);
    if (!status && *on) state_at(s, now);
    moving_free(&here);
    return status;
}

/* ------------------------------------------------------------------------------------------- from one to the other */

static void window_begin(QuasiRun *q) { q->window.from = -1; }

hawser_status quasi_end(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.on) return HAWSER_OK;
    hawser_status status = HAWSER_OK;
    hawser_relaxation found;
    if (quasi_between(s)) {
        status = quasi_find(s, s->stage.t, &found, err);
        if (!status) status = quasi_books_position(s, err);
    }
    if (!status) status = quasi_leave(&q->stage, &s->stage, err);
    s->stats.swings.steps = s->stats.swings.downward = 0;
    s->stats.swings.third = s->stats.swings.bound = 0;
    q->known = 0;
    window_begin(q);
    return status;
}

hawser_status quasi_move(Sim *s, double t, int *arrived, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    const double now = s->stage.t;
    hawser_status status = HAWSER_OK;
    *arrived = 0;
    if (!quasi_between(s)) {
        const double until = goes_until(s, t);
        int on = 0;
        if (until > now) status = look_ahead(s, until, &on, err);
        if (status || !on) return status ? status : quasi_end(s, err);
    }
    const double ahead = q->t[QUASI_KEPT - 1], to = fmin(t, ahead);
    state_at(s, to);
    q->said.time_s += to - now;
    *arrived = !(to < ahead);
    return *arrived ? quasi_books_position(s, err) : HAWSER_OK;
}

/* Takes the last step in; 1: a window has ended (QS1). */
static int window_step(QuasiRun *q, const Scene *scene, double t, double pull)
{
    PullWindow *const w = &q->window;
    const double speed = winch_speed(scene->winch, t), until = quasi_steady_until(scene, t, scene->def.duration);
    const double lasts = speed > 0 ? passing_time(scene, speed) : INFINITY;
    if (!(until - t > STRETCH * lasts)) {
        w->from = -1;
        return 0;
    }
    if (w->from < 0 || !(fabs(speed - w->speed) <= 1e-6 * speed)) {
        *w = (PullWindow){.from = t, .last = t, .speed = speed, .least = pull, .most = pull, .before = pull};
        return 0;
    }
    w->sum += (t - w->last) * (w->before + pull) / 2;
    w->last = t;
    w->before = pull;
    w->least = fmin(w->least, pull);
    w->most = fmax(w->most, pull);
    return t - w->from >= lasts;
}

/* Positions from here on, if the first of them is what the motion came to (QS3). */
static hawser_status attempt(Sim *s, double mean, double swing, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    Moving from = {0};
    hawser_relaxation found;
    hawser_status status = quasi_enter(&q->stage, &s->positions, &s->stage, &from, err);
    if (status == HAWSER_OK) status = quasi_find(s, s->stage.t, &found, err);
    int fits = status == HAWSER_OK;
    if (status == HAWSER_ERR_RUN && q->stage.on) status = HAWSER_OK;
    if (!status && fits) {
        if (!(q->said.stretches > 0)) q->said.first_s = s->stage.t;
        status = keep(s, &found, err);
        const double apart = fabs(q->look[QUASI_KEPT - 1][0] / mean - 1);
        fits = apart <= APART;
        if (fits) {
            sim_relaxation_take(s, &found);
            q->said.apart = fmax(q->said.apart, apart);
            q->said.swing = fmax(q->said.swing, swing);
            q->said.stretches++;
            q->checked = s->stage.t;
            q->step = 0;
            q->hangs = 1;
            q->known = 1;
            q->failed = 0;
            if (!status) status = quasi_books_begin(s, err);
        }
    }
    if (!status && !fits) {
        status = quasi_undo(&q->stage, &s->stage, &from, err);
        q->waits = q->failed < 6 ? 1 << q->failed : WAIT_MOST;
        q->failed++;
        q->said.refused++;
    }
    moving_free(&from);
    return status;
}

hawser_status quasi_begin(Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.damping || q->stage.on || q->told || s->calls.law) return HAWSER_OK;
    const double pull = s->stats.swings.pull[SWINGS_STEPS - 1];
    if (!window_step(q, &s->stage.scene, s->stage.t, pull)) return HAWSER_OK;
    const PullWindow *const w = &q->window;
    const double mean = w->sum / (w->last - w->from), swing = (w->most - w->least) / 2 / fmax(mean, 1e-300);
    const int settled = mean > 0 && swing <= SWING && !may_trip(s, (1 + 2 * swing) * mean);
    window_begin(q);
    if (!settled) return HAWSER_OK;
    if (q->waits > 0) {
        --q->waits;
        return HAWSER_OK;
    }
    return attempt(s, mean, swing, err);
}

/* ----------------------------------------------------------------------------------------------------- checkpoints */

void quasi_checkpoint_before(Checkpoint *c, Sim *s)
{
    QuasiRun *const q = &s->quasi;
    int on = q->stage.on;
    CHECKPOINT(c, on);
    if (!checkpoint_check(c, on == 0 || (on == 1 && q->stage.damping), "positions move what they cannot")) return;
    if (c->reading && !c->status && q->stage.damping && on != q->stage.on) quasi_damping(&q->stage, &s->stage, !on);
    q->stage.on = on;
}

hawser_status quasi_checkpoint(Checkpoint *c, Sim *s, hawser_error *err)
{
    QuasiRun *const q = &s->quasi;
    if (!q->stage.damping) return HAWSER_OK;
    int books = q->stage.on && s->stage.balance;
    CHECKPOINT(c, q->stage.so_far);
    CHECKPOINT(c, q->t);
    CHECKPOINT(c, q->known);
    CHECKPOINT(c, q->active);
    CHECKPOINT(c, q->booked_first);
    CHECKPOINT(c, q->booked_n);
    CHECKPOINT(c, q->booked_drum);
    CHECKPOINT(c, q->step);
    CHECKPOINT(c, q->hangs);
    CHECKPOINT(c, q->checked);
    CHECKPOINT(c, q->peak);
    checkpoint_put(c, "q->top", q->top, (size_t)s->stage.scene.def.n_rollers * sizeof *q->top);
    CHECKPOINT(c, q->window);
    CHECKPOINT(c, q->told);
    CHECKPOINT(c, q->waits);
    CHECKPOINT(c, q->failed);
    CHECKPOINT_UP_TO(c, &q->said, hawser_quasi_static, why);
    const hawser_quasi_static *const said = &q->said;
    checkpoint_counts(c, 4, (const int[]){q->known, q->waits, q->failed, q->peak.rollers});
    checkpoint_longs(c, 4, (const long[]){said->positions, said->iterations, said->stretches, said->refused});
    CHECKPOINT(c, s->positions.back);
    CHECKPOINT(c, s->positions.hanging);
    const int hung = s->positions.hanging.segment;
    checkpoint_check(c, hung >= -1 && hung < s->stage.scene.total, "a rope of another chain");
    CHECKPOINT(c, s->positions.soft);
    checkpoint_counts(c, 1, &s->positions.soft);
    CHECKPOINT(c, s->positions.push_share);
    CHECKPOINT(c, books);
    lie_checkpoint(c, &s->positions.lie, &s->stage.scene);
    if (c->status || !q->stage.on) return HAWSER_OK;
    for (int k = 0; k < QUASI_KEPT; ++k) checkpoint_put(c, "q->look", q->look[k], (size_t)q->numbers * sizeof(double));
    if (!room_for(q, s->stage.motion->size)) return error_memory(err);
    checkpoint_put(c, "q->y", q->y, (size_t)q->size * sizeof *q->y);
    if (books) balance_checkpoint(c, &s->stage.balance, s->stage.motion);
    return HAWSER_OK;
}
