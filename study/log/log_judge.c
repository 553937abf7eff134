/* What readings are good for: what is no reading, where the winch stood, where it broke away, what is a drop-out or a
 * spike. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/log/log.h"
#include "study/maths/estimate.h"

/* (LO1): neighbours either way, robust deviations, and share of their median, beyond which a reading is a spike; share
 * of the usual force below which one in motion is a drop-out; how many times both neighbours a single reading of a
 * start is, as it breaks away and behind that. (LO2): share of the usual speed or force that is motion; readings that
 * may be wrongly fast. (LO3): metres or, without lengths, seconds that a start takes; readings before it that may hold
 * its peak. A gap in time that is said: seconds, and usual steps. */
enum { NEIGHBOURS = 5, PEAK_BEFORE = 3, WRONG_SPEEDS = 3 };
static const double SPIKE_DEVIATIONS = 6, SPIKE_SHARE = 0.1, DROP_SHARE = 0.05, BREAK_TIMES = 3, LONE_TIMES = 1.5,
                    MOVES_BY_SPEED = 0.2, MOVES_BY_FORCE = 0.3, RUN_UP_M = 0.5, RUN_UP_S = 5, GAP_S = 60,
                    GAP_STEPS = 20;

/* The median of x[n], which gets sorted; NAN: nothing is finite. */
static double median_of(int n, double *x) { return quantile_of_sorted(sort_finite(n, x), x, 0.5); }

/* The median of the forces around reading m of those that are kept, and their robust deviation about it. */
static double local_median(const PullLog *log, const LogKept *k, long m, double *deviation)
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

/* Neighbours over which speeds are taken: twice as many as there usually are between two steps of the counter (LO2a).
 */
static void reach_find(const PullLog *log, LogKept *k)
{
    int n = 0;
    k->reach = NEIGHBOURS;
    if (!log->has_length || log->has_speed) return;
    for (long m = 1, from = 0; m < k->n; m++) {
        if (log->length[k->at[m]] == log->length[k->at[m - 1]]) continue;
        k->x[n++] = (double)(m - from);
        from = m;
    }
    const double usual = median_of(n, k->x);
    if (n > 2 && 2 * usual > NEIGHBOURS) k->reach = (long)(2 * usual);
}

/* Speeds: the file's, or differences of its lengths over the neighbours, since lengths are rounded; without either the
 * smoothed force stands for them. */
static void speeds_find(const PullLog *log, LogKept *k)
{
    double deviation;
    reach_find(log, k);
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m], a = k->at[m > k->reach ? m - k->reach : 0],
                   b = k->at[m + k->reach < k->n ? m + k->reach : k->n - 1];
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

/* The largest of v but for a hundredth of them and a few, which may be wrong. */
static double largest_usual(const LogKept *k)
{
    int n = 0;
    for (long m = 0; m < k->n; m++) {
        if (k->v[m] > 0) k->x[n++] = k->v[m];
    }
    n = sort_finite(n, k->x);
    const int wrong = n / 100 + (n >= 10 ? WRONG_SPEEDS : 0);
    return n > 0 ? k->x[n - 1 - wrong] : 0;
}

/* A log that begins with a low force is at rest there by its force alone, unless that rises steadily: then it begins to
 * pull. Says so either way. */
static void rise_judge(PullLog *log, const LogKept *k)
{
    long low = 0, all = 0;
    for (long m = 0; m < k->n; m++) {
        all += log->use[k->at[m]] == LOG_AT_REST;
        low += m == low && log->use[k->at[m]] == LOG_AT_REST;
    }
    const double *const axis = log->has_time ? log->time : log->length;
    const double lasts = low > 0 && low < k->n ? axis[k->at[low]] - axis[k->at[0]] : 0;
    double third[3] = {0};
    for (int t = 0; t < 3; t++) {
        int n = 0;
        for (long m = t * low / 3; m < (t + 1) * low / 3; m++) k->x[n++] = log->force[k->at[m]];
        third[t] = median_of(n, k->x);
    }
    const double least = 0.15 * third[2];
    if (low >= 2 * NEIGHBOURS && third[1] - third[0] > least && third[2] - third[1] > least) {
        for (long m = 0; m < low; m++) log->use[k->at[m]] = LOG_MOVING;
        log_say(log, "The force of the first %.4g s is low but rises steadily: they were taken for a pull", lasts);
    } else if (low > 0) {
        log_say(log, "The first %.4g s were taken for a rest, by their force alone", lasts);
    } else if (all > 0) {
        log_say(log, "%ld readings were taken for rests, by their force alone", all);
    }
}

/* Marks where the winch stands (LO2). Returns 0 if it never moves. */
static int rests_find(PullLog *log, LogKept *k)
{
    const int by_force = !log->has_speed && !log->has_length;
    const double most = largest_usual(k);
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
    if (by_force && moving > 0) rise_judge(log, k);
    return moving > 0;
}

/* Spikes and drop-outs among readings in motion (LO1). */
static void spikes_find(PullLog *log, LogKept *k)
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

/* The speed at a kept reading, without a single wrong one: the median of three. */
static double speed_around(const PullLog *log, const LogKept *k, long m)
{
    double v[3];
    int n = 0;
    for (long j = m - 1; j <= m + 1; j++) {
        if (j >= 0 && j < k->n) v[n++] = log->speed[k->at[j]];
    }
    return n < 3 ? log->speed[k->at[m]] : median_of(n, v);
}

/* Gaps in time over which lengths are reckoned. */
static void gaps_say(PullLog *log, const LogKept *k)
{
    int n = 0;
    long gaps = 0, first = 0;
    for (long m = 1; m < k->n; m++) k->x[n++] = log->time[k->at[m]] - log->time[k->at[m - 1]];
    const double gap = fmax(GAP_S, GAP_STEPS * median_of(n, k->x));
    for (long m = 1; m < k->n; m++) {
        const long i = k->at[m], before = k->at[m - 1];
        if (!(log->time[i] - log->time[before] > gap) || !(log->length[i] > log->length[before])) continue;
        if (gaps++ == 0) first = m;
    }
    if (gaps == 0) return;
    const long i = k->at[first], before = k->at[first - 1];
    log_say_first(log,
                  "BEWARE: gaps in time are taken for motion at the speed around them: %ld, such as %.4g s and %.4g m "
                  "before line %d",
                  gaps, log->time[i] - log->time[before], log->length[i] - log->length[before], log->line[i]);
}

/* Lengths by the speed and the time in motion, where the file has none. */
static void lengths_fill(PullLog *log, const LogKept *k, double speed)
{
    double length = 0;
    if (log->has_length || !log->has_time || (!log->has_speed && isnan(speed))) return;
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m], last = m > 0 ? m - 1 : 0;
        const double v = log->has_speed ? (speed_around(log, k, m) + speed_around(log, k, last)) / 2 : speed;
        if (log->use[i] != LOG_AT_REST && v > 0) length += v * (log->time[i] - log->time[k->at[last]]);
        log->length[i] = length;
    }
    gaps_say(log, k);
}

/* Where the log begins to pull: the last reading that has not moved from where the first half of its first rest was.
 * Speeds over neighbours see motion some readings early or late. */
static void begin_find(PullLog *log, const LogKept *k)
{
    const double *const x = log->has_length ? log->length : log->speed;
    long m = 0;
    int n = 0;
    while (m < k->n && log->use[k->at[m]] == LOG_AT_REST) m++;
    log->from_rest = m > 0 && m < k->n;
    log->begin = k->n > 0 ? k->at[m > 0 ? m - 1 : 0] : -1;
    if (!log->from_rest || !(log->has_length || log->has_speed)) return;
    for (long j = 0; j < (m + 1) / 2; j++) k->x[n++] = x[k->at[j]];
    const double rest = median_of(n, k->x);
    for (long j = 0; j < k->n && j < m + 2 * k->reach; j++) {
        if (x[k->at[j]] <= rest) log->begin = k->at[j];
        if (x[k->at[j]] > rest && j >= m) break;
    }
}

/* Whether a reading of the start at m is a single one, far above both its neighbours: no peak of breaking away, which
 * is the less sharp the later it comes. */
static int is_lone(const PullLog *log, const LogKept *k, long m, long j)
{
    if (j == 0 || j + 1 >= k->n) return 0;
    const double around = fmax(log->force[k->at[j - 1]], log->force[k->at[j + 1]]);
    return around > 0 && log->force[k->at[j]] > (j < m + 2 * k->reach ? BREAK_TIMES : LONE_TIMES) * around;
}

/* The start at reading m, behind a rest: its largest force is what it takes to break away, the rest of it is no pull at
 * speed (LO3). Returns the first reading behind it. */
static long start_judge(PullLog *log, const LogKept *k, long m, int raw)
{
    const int by_length = isfinite(log->length[k->at[m]]) != 0;
    const double *const axis = by_length ? log->length : log->time,
                        end = axis[k->at[m]] + (by_length ? RUN_UP_M : RUN_UP_S);
    long peak = -1, j = m > PEAK_BEFORE ? m - PEAK_BEFORE : 0;
    for (; j <= m || (j < k->n && axis[k->at[j]] <= end && log->use[k->at[j]] != LOG_AT_REST); j++) {
        const long i = k->at[j];
        if (log->use[i] != LOG_MOVING && log->use[i] != LOG_AT_REST) continue;
        log->use[i] = LOG_AT_REST;
        if (!raw && is_lone(log, k, m, j)) {
            log->use[i] = LOG_SPIKE;
        } else if (peak < 0 || log->force[i] > log->force[peak]) {
            peak = i;
        }
    }
    if (peak >= 0) log->use[peak] = LOG_RESTART;
    return j;
}

/* The readings just before a rest at reading m: the force falls while lengths are still rounded to motion. */
static void stop_judge(PullLog *log, const LogKept *k, long m)
{
    for (long j = m > k->reach ? m - k->reach : 0; j < m; j++) {
        if (log->use[k->at[j]] == LOG_MOVING) log->use[k->at[j]] = LOG_AT_REST;
    }
}

/* All starts and stops. */
static void starts_find(PullLog *log, const LogKept *k, int raw)
{
    log->starts = 0;
    for (long m = 1; m < k->n; m++) {
        const int rested = log->use[k->at[m - 1]] == LOG_AT_REST, rests = log->use[k->at[m]] == LOG_AT_REST;
        if (rests && !rested) stop_judge(log, k, m);
        if (rests || !rested) continue;
        m = start_judge(log, k, m, raw);
        log->starts++;
    }
}

hawser_status log_judge(PullLog *log, double speed, int raw, hawser_error *err)
{
    LogKept k = {0};
    hawser_status status = log_kept_find(log, &k, err);
    if (!status) {
        speeds_find(log, &k);
        if (!rests_find(log, &k)) status = error_set(err, HAWSER_ERR_INPUT, "the log: nothing moves in it");
    }
    if (!status) {
        lengths_fill(log, &k, speed);
        begin_find(log, &k);
        starts_find(log, &k, raw);
        if (!raw) spikes_find(log, &k);
        memset(log->count, 0, sizeof log->count);
        for (long i = 0; i < log->n; i++) log->count[log->use[i]]++;
    }
    log_kept_free(&k);
    return status;
}
