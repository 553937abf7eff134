/* What readings are good for: what is no reading, where the winch stood, where it broke away, what is a drop-out or a
 * spike. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/log/log.h"
#include "study/maths/estimate.h"

/* (LO1): neighbours either way, robust deviations, and share of their median, beyond which a reading is a spike; share
 * of the usual force below which one in motion is a drop-out. (LO2): share of the usual speed or force that is motion.
 * (LO3): metres or, without lengths, seconds that a start takes; readings before it that may hold its peak. */
enum { NEIGHBOURS = 5, PEAK_BEFORE = 3 };
static const double SPIKE_DEVIATIONS = 6, SPIKE_SHARE = 0.1, DROP_SHARE = 0.05, MOVES_BY_SPEED = 0.2,
                    MOVES_BY_FORCE = 0.3, RUN_UP_M = 0.5, RUN_UP_S = 5;

/* The median of x[n], which is sorted; NAN: nothing is finite. */
static double median_of(int n, double *x) { return quantile_of_sorted(sort_finite(n, x), x, 0.5); }

/* The readings that are numbers, in the order of time. */
typedef struct Kept {
    long n, *at; /* [n] readings */
    double *x;   /* [n] scratch */
    double *v;   /* [n] speed, or what stands for it; NAN: not known */
} Kept;

static void kept_free(Kept *k)
{
    free(k->at);
    free(k->x);
    free(k->v);
}

/* Marks what is no reading: no force, a time or a length that does not go on. */
static hawser_status kept_find(PullLog *log, Kept *k, hawser_error *err)
{
    const size_t n = (size_t)log->n + 1;
    double last = -INFINITY;
    *k = (Kept){0, malloc(n * sizeof *k->at), malloc(n * sizeof *k->x), malloc(n * sizeof *k->v)};
    if (!k->at || !k->x || !k->v) return error_memory(err);
    for (long i = 0; i < log->n; i++) {
        const double now = log->has_time ? log->time[i] : log->length[i];
        log->use[i] = LOG_LOST;
        if (!isfinite(log->force[i]) || !(now > last || (!log->has_time && now == last))) continue;
        last = now;
        log->use[i] = LOG_MOVING;
        k->at[k->n++] = i;
    }
    return HAWSER_OK;
}

/* The median of the forces around reading m of those that are kept, and their robust deviation about it. */
static double local_median(const PullLog *log, const Kept *k, long m, double *deviation)
{
    double x[2 * NEIGHBOURS + 1];
    int n = 0;
    for (long j = m - NEIGHBOURS; j <= m + NEIGHBOURS; j++) {
        if (j >= 0 && j < k->n) x[n++] = log->force[k->at[j]];
    }
    const double middle = median_of(n, x);
    for (int j = 0; j < n; j++) x[j] = fabs(x[j] - middle);
    *deviation = 1.4826 * median_of(n, x);
    return middle;
}

/* Speeds: the file's, or differences of its lengths over the neighbours, since lengths are rounded; without either the
 * smoothed force stands for them. */
static void speeds_find(const PullLog *log, Kept *k)
{
    double deviation;
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m], a = k->at[m > NEIGHBOURS ? m - NEIGHBOURS : 0],
                   b = k->at[m + NEIGHBOURS < k->n ? m + NEIGHBOURS : k->n - 1];
        if (log->has_speed) {
            k->v[m] = log->speed[i];
        } else if (log->has_length && log->has_time) {
            k->v[m] = b > a ? (log->length[b] - log->length[a]) / (log->time[b] - log->time[a]) : NAN;
        } else if (log->has_length) {
            k->v[m] = b == a || log->length[b] > log->length[a] ? 1 : 0;
        } else {
            k->v[m] = local_median(log, k, m, &deviation);
        }
    }
}

/* Marks where the winch stands (LO2). Returns 0 if it never moves. */
static int rests_find(PullLog *log, Kept *k)
{
    const int by_force = !log->has_speed && !log->has_length;
    double most = 0;
    for (long m = 0; m < k->n; m++) most = fmax(most, k->v[m]);
    int n = 0;
    for (long m = 0; m < k->n; m++) {
        if (k->v[m] > 0.05 * most) k->x[n++] = k->v[m];
    }
    const double usual = median_of(n, k->x), moves = (by_force ? MOVES_BY_FORCE : MOVES_BY_SPEED) * usual;
    long moving = 0;
    for (long m = 0; m < k->n; m++) {
        const int rest = k->v[m] < moves; /* what is not known is taken for motion */
        log->use[k->at[m]] = rest ? LOG_AT_REST : LOG_MOVING;
        moving += !rest;
    }
    return moving > 0;
}

/* Spikes and drop-outs among readings in motion (LO1). */
static void spikes_find(PullLog *log, Kept *k)
{
    double deviation;
    int n = 0;
    for (long m = 0; m < k->n; m++) {
        if (log->use[k->at[m]] == LOG_MOVING && log->force[k->at[m]] > 0) k->x[n++] = log->force[k->at[m]];
    }
    const double usual = median_of(n, k->x);
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m];
        if (log->use[i] != LOG_MOVING) continue;
        const double middle = local_median(log, k, m, &deviation), off = fabs(log->force[i] - middle);
        if (off > SPIKE_DEVIATIONS * deviation && off > SPIKE_SHARE * fabs(middle)) log->use[i] = LOG_SPIKE;
        if (log->force[i] < DROP_SHARE * usual) log->use[i] = LOG_DROPPED;
    }
}

/* Lengths by the speed and the time in motion, where the file has none. */
static void lengths_fill(PullLog *log, const Kept *k, double speed)
{
    double length = 0;
    if (log->has_length || !log->has_time || (!log->has_speed && isnan(speed))) return;
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m], before = k->at[m > 0 ? m - 1 : 0];
        const double v = log->has_speed ? (log->speed[i] + log->speed[before]) / 2 : speed;
        if (log->use[i] != LOG_AT_REST && v > 0) length += v * (log->time[i] - log->time[before]);
        log->length[i] = length;
    }
}

/* The start at reading m, behind a rest: its largest force is what it takes to break away, the rest of it is no pull at
 * speed (LO3). Returns the first reading behind it. */
static long start_judge(PullLog *log, const Kept *k, long m)
{
    const int by_length = isfinite(log->length[k->at[m]]) != 0;
    const double *const axis = by_length ? log->length : log->time,
                        end = axis[k->at[m]] + (by_length ? RUN_UP_M : RUN_UP_S);
    long peak = -1, j = m > PEAK_BEFORE ? m - PEAK_BEFORE : 0;
    for (; j <= m || (j < k->n && axis[k->at[j]] <= end && log->use[k->at[j]] != LOG_AT_REST); j++) {
        const long i = k->at[j];
        const int good = log->use[i] == LOG_MOVING || log->use[i] == LOG_AT_REST;
        if (good && (peak < 0 || log->force[i] > log->force[peak])) peak = i;
        if (good) log->use[i] = LOG_AT_REST;
    }
    if (peak >= 0) log->use[peak] = LOG_RESTART;
    return j;
}

/* The readings just before a rest at reading m: the force falls while lengths are still rounded to motion. */
static void stop_judge(PullLog *log, const Kept *k, long m)
{
    for (long j = m > NEIGHBOURS ? m - NEIGHBOURS : 0; j < m; j++) {
        if (log->use[k->at[j]] == LOG_MOVING) log->use[k->at[j]] = LOG_AT_REST;
    }
}

hawser_status log_judge(PullLog *log, double speed, int raw, hawser_error *err)
{
    Kept k = {0};
    hawser_status status = kept_find(log, &k, err);
    if (!status) {
        speeds_find(log, &k);
        if (!rests_find(log, &k)) status = error_set(err, HAWSER_ERR_INPUT, "the log: nothing moves in it");
    }
    if (!status) {
        if (!raw) spikes_find(log, &k);
        lengths_fill(log, &k, speed);
        log->starts = 0;
        for (long m = 1; m < k.n; m++) {
            if (log->use[k.at[m]] == LOG_AT_REST) stop_judge(log, &k, m);
            if (log->use[k.at[m - 1]] != LOG_AT_REST || log->use[k.at[m]] == LOG_AT_REST) continue;
            m = start_judge(log, &k, m);
            log->starts++;
        }
        memset(log->count, 0, sizeof log->count);
        for (long i = 0; i < log->n; i++) log->count[log->use[i]]++;
    }
    kept_free(&k);
    return status;
}
