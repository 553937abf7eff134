/* Selects the usable readings of a log: numbers in a rising course of times. It is the longest such course; it deals
 * with stamps coarser than the readings, and with counters that run down, are reset or wrong once. */
#include <assert.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

#include "core/error.h"
#include "io/api/api_handles.h"
#include "io/report/folder.h"
#include "io/results/results_file.h"
#include "study/log.h"
#include "study/maths.h"
#include "study/page.h"

/* (LO1a): excess in metres, and in steps of the neighbours, of a wrong single length; a fall of the length that is
 * reported. Share of lost readings that is reported first. */
static const double LENGTH_OFF_M = 0.5, LENGTH_OFF_STEPS = 5, LOST_SHARE = 0.03;

void log_kept_free(LogKept *k)
{
    free(k->at);
    free(k->x);
    free(k->v);
}

/* ---------------------------------------------------------------------------------------------------------- courses */

/* Finds the longest course of readings at[n] in which x does not fall, with the smallest end for each length. */
static hawser_status course_find(const double *x, long *n, long *at, hawser_error *err)
{
    const size_t bytes = ((size_t)*n + 1) * sizeof(long);
    long *const end = malloc(bytes), *const before = malloc(bytes), longest = 0;
    const hawser_status status = end && before ? HAWSER_OK : error_memory(err);
    for (long i = 0; i < *n && !status; i++) {
        long low = 0, high = longest;
        while (low < high) {
            const long middle = (low + high) / 2;
            if (x[at[end[middle]]] <= x[at[i]]) {
                low = middle + 1;
            } else {
                high = middle;
            }
        }
        before[i] = low > 0 ? end[low - 1] : -1;
        end[low] = i;
        if (low == longest) longest++;
    }
    for (long m = longest - 1, i = longest > 0 && !status ? end[longest - 1] : -1; i >= 0; m--) {
        const long next = before[i];
        end[m] = i; /* ends of shorter courses are no longer needed */
        i = next;
    }
    for (long m = 0; m < longest && !status; m++) at[m] = at[end[m]];
    *n = longest;
    free(end);
    free(before);
    return status;
}

/* Removes single lengths far off both neighbours. */
static void lengths_check(PullLog *log, LogKept *k)
{
    long kept = 0, wrong = 0;
    int line = 0;
    for (long m = 0; m < k->n; m++) {
        const long i = k->at[m];
        if (m > 0 && m < k->n - 1) {
            const double a = log->length[k->at[m - 1]], c = log->length[k->at[m + 1]],
                         off = fmax(log->length[i] - fmax(a, c), fmin(a, c) - log->length[i]);
            const int astray = off > LENGTH_OFF_M && off > LENGTH_OFF_STEPS * fabs(c - a);
            log->use[i] = astray ? LOG_LOST : log->use[i];
            if (astray && wrong++ == 0) line = log->line[i];
        }
        k->x[m] = log->use[i] == LOG_LOST;
    }
    for (long m = 0; m < k->n; m++) {
        if (k->x[m] == 0) k->at[kept++] = k->at[m];
    }
    k->n = kept;
    if (wrong > 0)
        log_say(log, "Single lengths far off their neighbours are lost: %ld, the first in line %d", wrong, line);
}

/* Spreads readings of equal time evenly up to the next stamp, or over the usual distance of stamps. */
static void times_spread(PullLog *log, LogKept *k)
{
    int n = 0;
    long equal = 0, last = 0;
    for (long m = 1; m < k->n; m++) {
        const double step = log->time[k->at[m]] - log->time[k->at[m - 1]];
        if (step > 0) k->x[n++] = step;
        equal += step == 0;
    }
    if (equal == 0) return;
    const double usual = quantile_of_sorted(sort_finite(n, k->x), k->x, 0.5);
    if (n == 0) { /* time never rises */
        for (long m = 1; m < k->n; m++) log->use[k->at[m]] = LOG_LOST;
        k->n = 1;
        return;
    }
    for (long m = 0; m < k->n; m = last) {
        const double from = log->time[k->at[m]];
        for (last = m; last < k->n && log->time[k->at[last]] == from; last++) continue;
        const double next = last < k->n ? log->time[k->at[last]] : INFINITY;
        for (long j = m + 1; j < last; j++)
            log->time[k->at[j]] = from + fmin(usual, next - from) * (double)(j - m) / (double)(last - m);
    }
    log_say(log, "Readings with the time of the one before are spread evenly up to the next stamp: %ld", equal);
}

/* ------------------------------------------------------------------------------------------------------------ signs */

/* Refuses inverted signs: pulls and speeds below 0, a length that runs down. */
static hawser_status signs_check(const PullLog *log, hawser_error *err)
{
    long force[2] = {0}, speed[2] = {0}, length[2] = {0}, last = -1, first = -1;
    for (long i = 0; i < log->n; i++) {
        force[log->force[i] < 0] += log->force[i] != 0 && isfinite(log->force[i]);
        speed[log->speed[i] < 0] += log->speed[i] != 0 && isfinite(log->speed[i]);
        if (!isfinite(log->length[i])) continue;
        if (last >= 0) length[log->length[i] < log->length[last]] += log->length[i] != log->length[last];
        if (first < 0) first = i;
        last = i;
    }
    if (force[1] > 2 * force[0] && force[1] > 2)
        return error_set(err, HAWSER_ERR_INPUT, "the log: %ld of its forces are below 0: pulls must be above 0",
                         force[1]);
    if (log->has_speed && speed[1] > 2 * speed[0] && speed[1] > 2)
        return error_set(err, HAWSER_ERR_INPUT,
                         "the log: %ld of its speeds are below 0: speeds of a pull must be above 0", speed[1]);
    if (log->has_length && length[1] > 2 * length[0] && length[1] > 2) {
        return error_set(
            err, HAWSER_ERR_INPUT,
            "the log: its length runs down, from %.6g m in line %d to %.6g m in line %d: the length pulled must rise",
            log->length[first], log->line[first], log->length[last], log->line[last]);
    }
    return HAWSER_OK;
}

/* Reports falls of the length: places are the counter's. */
static void falls_say(PullLog *log, const LogKept *k)
{
    long falls = 0, first = 0;
    for (long m = 1; m < k->n; m++) {
        if (!(log->length[k->at[m]] < log->length[k->at[m - 1]] - LENGTH_OFF_M)) continue;
        if (falls++ == 0) first = m;
    }
    if (falls == 0) return;
    log_say(log,
            "The length falls as if its counter was set back, %ld in all, first from %.4g m to %.4g m in line %d: "
            "places are used unchanged",
            falls, log->length[k->at[first - 1]], log->length[k->at[first]], log->line[k->at[first]]);
}

/* Reports first that many readings are lost. */
static void losses_say(PullLog *log)
{
    long lost = 0, forces = 0, times = 0, first = -1;
    const double *const axis = log->has_time ? log->time : log->length;
    for (long i = 0; i < log->n; i++) {
        if (log->use[i] != LOG_LOST) continue;
        if (lost++ == 0) first = i;
        forces += !isfinite(log->force[i]);
        times += isfinite(log->force[i]) && !isfinite(axis[i]);
    }
    if (!((double)lost > LOST_SHARE * (double)log->n)) return;
    log_say_first(log,
                  "BEWARE: %ld of %ld readings are lost: %ld without a force, %ld without a %s, %ld that do not go on; "
                  "the first in line %d",
                  lost, log->n, forces, times, log->has_time ? "time" : "length", lost - forces - times,
                  log->line[first]);
}

hawser_status log_kept_find(PullLog *log, LogKept *k, hawser_error *err)
{
    const size_t n = (size_t)log->n + 1;
    const double *const axis = log->has_time ? log->time : log->length;
    *k = (LogKept){.at = malloc(n * sizeof *k->at), .x = malloc(n * sizeof *k->x), .v = malloc(n * sizeof *k->v)};
    if (!k->at || !k->x || !k->v) return error_memory(err);
    hawser_status status = signs_check(log, err);
    if (status) return status;
    for (long i = 0; i < log->n; i++) {
        log->use[i] = LOG_LOST;
        if (isfinite(log->force[i]) && isfinite(axis[i])) k->at[k->n++] = i;
    }
    status = course_find(axis, &k->n, k->at, err);
    if (status) return status;
    for (long m = 0; m < k->n; m++) log->use[k->at[m]] = LOG_MOVING;
    if (log->has_time && log->has_length) lengths_check(log, k);
    if (log->has_time) times_spread(log, k);
    if (log->has_length) falls_say(log, k);
    losses_say(log);
    return HAWSER_OK;
}

/* Classifies readings: those that are none, rest of the winch, break-away, drop-outs and spikes. */

/* (LO1): number of neighbours on each side; robust deviations, and share of their median, beyond which a reading is a
 * spike; share of the usual force below which a reading in motion is a drop-out; ratio to both neighbours of a single
 * reading in a start, at break-away and later. (LO2): share of the usual speed or force that counts as motion; number
 * of readings that may be wrongly fast. (LO3): metres or, without lengths, seconds of a start; readings before it that
 * may contain its peak. A gap in time that is reported: seconds, and usual steps. */
enum { NEIGHBOURS = 5, PEAK_BEFORE = 3, WRONG_SPEEDS = 3 };

static const double SPIKE_DEVIATIONS = 6, SPIKE_SHARE = 0.1, DROP_SHARE = 0.05, BREAK_TIMES = 3, LONE_TIMES = 1.5,
                    MOVES_BY_SPEED = 0.2, MOVES_BY_FORCE = 0.3, RUN_UP_M = 0.5, RUN_UP_S = 5, GAP_S = 60,
                    GAP_STEPS = 20;

/* Median of x[n], which is sorted; NAN: nothing is finite. */
static double median_of(int n, double *x) { return quantile_of_sorted(sort_finite(n, x), x, 0.5); }

/* Median of the forces of the kept readings around reading m, and their robust deviation from it. */
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

/* Finds the number of neighbours for speeds: twice the usual number of readings between two steps of the counter
 * (LO2a). */
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

/* Finds speeds: the file's, or differences of its lengths over the neighbours, since lengths are rounded; without
 * either the smoothed force. */
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

/* Largest v except a hundredth of them and a few, which may be wrong. */
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

/* Judges a beginning with low force: by the force alone it is rest, unless the force rises steadily, which is the start
 * of a pull. Reports the choice. */
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

/* Marks rest of the winch (LO2). Returns 0 if it never moves. */
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
        const int rest = k->v[m] < moves; /* an unknown reading counts as motion */
        log->use[k->at[m]] = rest ? LOG_AT_REST : LOG_MOVING;
        moving += !rest;
    }
    if (by_force && moving > 0) rise_judge(log, k);
    return moving > 0;
}

/* Finds spikes and drop-outs among readings in motion (LO1). */
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

/* Speed at a kept reading, as the median of three, which removes a single wrong one. */
static double speed_around(const PullLog *log, const LogKept *k, long m)
{
    double v[3];
    int n = 0;
    for (long j = m - 1; j <= m + 1; j++) {
        if (j >= 0 && j < k->n) v[n++] = log->speed[k->at[j]];
    }
    return n < 3 ? log->speed[k->at[m]] : median_of(n, v);
}

/* Reports gaps in time over which lengths are computed. */
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

/* Computes lengths from the speed and the time in motion if the file has none. */
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

/* Finds where the log begins to pull: the last reading that has not moved from the median place of the first half of
 * its first rest. Speeds over neighbours show motion some readings early or late. */
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

/* Checks whether a reading of the start at m is a single one, far above both its neighbours and therefore no break-away
 * peak, which is less sharp the later it comes. */
static int is_lone(const PullLog *log, const LogKept *k, long m, long j)
{
    if (j == 0 || j + 1 >= k->n) return 0;
    const double around = fmax(log->force[k->at[j - 1]], log->force[k->at[j + 1]]);
    return around > 0 && log->force[k->at[j]] > (j < m + 2 * k->reach ? BREAK_TIMES : LONE_TIMES) * around;
}

/* Judges the start at reading m, after a rest: its largest force is the break-away force, the rest of it is not steady
 * pull (LO3). Returns the first reading after it. */
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

/* Marks the readings just before a rest at reading m: the force falls while rounded lengths still show motion. */
static void stop_judge(PullLog *log, const LogKept *k, long m)
{
    for (long j = m > k->reach ? m - k->reach : 0; j < m; j++) {
        if (log->use[k->at[j]] == LOG_MOVING) log->use[k->at[j]] = LOG_AT_REST;
    }
}

/* Finds all starts and stops. */
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

/* Compares a measured pull with a plan, by a run and theory or by theory alone: figures of agreement, planned against
 * pulled by the place of the head, and a page. */

enum { BINS = 200, PLANNED_PARTS = 12, NAME_BYTES = 160 };

/* Force of a model over the axis: columns of series.csv. */
typedef struct Model {
    const char *name;
    int n;
    double *at, *force; /* [n] owned; rising, NAN where unknown */
} Model;

/* Agreement of a model with the log, (LO4)-(LO7). */
typedef struct Agreement {
    const char *name;
    long points;
    double bias, bias_pct, rms, rms_pct, correlation, within_pct;
    double peak_log, peak_model, peak_pct;
} Agreement;

/* Planned and pulled force with the head on one part of its path. */
typedef struct PlannedPart {
    double from, to; /* m, or s with by_start */
    long readings;
    double pulled, pulled_most, planned, ratio; /* N, means in motion; pulled over planned */
} PlannedPart;

/* A largest force and its place. */
typedef struct PlannedPeak {
    double force, at; /* NAN: there is none */
} PlannedPeak;

/* Data of a comparison. */
typedef struct Comparison {
    hawser_compare_options options;
    int unended; /* the run's results have no end state */
    PullLog log;
    double *axis; /* [log.n] place of each reading on the models' axis */
    double from, to;
    int n_models, n_points;
    Model model[2];
    LogPoint *point;
    Agreement agreement[2];
    CaseHeads heads; /* of a case; theory NULL: of results */
    int n_parts;
    PlannedPart part[PLANNED_PARTS];
    PlannedPeak planned, pulled;
    double share; /* of the planned friction, with which theory has the mean of the pulled force; NAN: from results, or
                     there is none */
} Comparison;

/* Force at a place of the axis; NAN: the model does not reach it. */
static double model_at(const Model *m, double at)
{
    int low = 0, high = m->n - 1;
    if (m->n < 2 || !(at >= m->at[0] && at <= m->at[high])) return NAN;
    while (high - low > 1) {
        const int middle = (low + high) / 2;
        *(m->at[middle] <= at ? &low : &high) = middle;
    }
    const double width = m->at[high] - m->at[low];
    return width > 0 ? m->force[low] + (m->force[high] - m->force[low]) * (at - m->at[low]) / width : m->force[low];
}

/* Reads a column of forces over the axis, from the first row in motion; rows without progress are left out. */
static hawser_status model_make(const Sheet *series, const char *column, const char *name, int by_start, Model *m,
                                hawser_error *err)
{
    const int f = sheet_column(series, column), l = sheet_column(series, by_start ? "time_s" : "winch_travel_m"),
              v = sheet_column(series, "winch_travel_m");
    const size_t n = (size_t)series->rows + 1;
    *m = (Model){name, 0, malloc(n * sizeof(double)), malloc(n * sizeof(double))};
    if (!m->at || !m->force) return error_memory(err);
    double zero = NAN;
    for (int i = 0; i < series->rows && f >= 0 && l >= 0 && v >= 0; i++) {
        const double force = sheet_number(series, i, f), at = sheet_number(series, i, l);
        if (by_start && isnan(zero) && sheet_number(series, i, v) > 0)
            zero = i > 0 ? sheet_number(series, i - 1, l) : at; /* the last row at rest */
        if (!isfinite(force) || !isfinite(at) || (by_start && isnan(zero))) continue;
        const double here = by_start ? at - zero : at;
        if (m->n > 0 && here <= m->at[m->n - 1]) continue;
        m->at[m->n] = here;
        m->force[m->n++] = force;
    }
    return HAWSER_OK;
}

/* Checks whether any reading has a place on the axis. */
static int has_places(const PullLog *log, const double *axis)
{
    for (long i = 0; i < log->n; i++) {
        if ((log->use[i] == LOG_MOVING || log->use[i] == LOG_RESTART) && isfinite(axis[i])) return 1;
    }
    return 0;
}

/* Places the readings on the models' axis: lengths as they are, times from the last reading at rest, as the models'
 * are; both moved by `shift`. */
static hawser_status axis_make(Comparison *c, hawser_error *err)
{
    const int by_start = c->options.by_start;
    const double *const from = by_start ? c->log.time : c->log.length;
    if (by_start ? !c->log.has_time : !has_places(&c->log, from))
        return error_set(err, HAWSER_ERR_INPUT, "the log has no %s: align it by %s",
                         by_start ? "time" : "length, and no speed to compute it from", by_start ? "length" : "start");
    c->axis = malloc(((size_t)c->log.n + 1) * sizeof *c->axis);
    if (!c->axis) return error_memory(err);
    const double zero = by_start && c->log.begin >= 0 ? from[c->log.begin] : 0;
    for (long i = 0; i < c->log.n; i++) c->axis[i] = from[i] - zero + c->options.shift;
    if (by_start && !c->log.from_rest)
        log_say_first(&c->log, "The log does not begin at rest: the run's start is aligned with its first reading");
    return HAWSER_OK;
}

/* Compares readings with the model's values at their places; bins both. */
static hawser_status agreement_find(Comparison *c, const Model *m, Agreement *a, hawser_error *err)
{
    const double width = (c->to - c->from) / BINS;
    double log[BINS] = {0}, model[BINS] = {0}, sum[5] = {0};
    long readings[BINS] = {0}, n = 0, inside = 0;
    *a = (Agreement){.name = m->name, .peak_log = NAN, .peak_model = NAN};
    for (long i = 0; i < c->log.n; i++) {
        const double y = c->log.use[i] == LOG_MOVING ? model_at(m, c->axis[i]) : NAN;
        if (isnan(y)) continue;
        const int b = (int)fmin(fmax((c->axis[i] - c->from) / width, 0), BINS - 1);
        log[b] += c->log.force[i];
        model[b] += y;
        readings[b]++;
        a->peak_log = fmax(c->log.force[i], isnan(a->peak_log) ? -INFINITY : a->peak_log);
        a->peak_model = fmax(y, isnan(a->peak_model) ? -INFINITY : a->peak_model);
    }
    for (int b = 0; b < BINS; b++) {
        if (readings[b] == 0) continue;
        const double of = (double)readings[b], x = log[b] /= of, y = model[b] /= of;
        n++;
        sum[0] += x;
        sum[1] += y;
        sum[2] += (y - x) * (y - x);
        inside += fabs(y - x) <= c->options.band * fabs(x);
    }
    if (n < 2) return error_set(err, HAWSER_ERR_INPUT, "the log and the results have no stretch in common");
    const double mean = sum[0] / (double)n, other = sum[1] / (double)n;
    for (int b = 0; b < BINS; b++) {
        if (readings[b] == 0) continue;
        sum[3] += (log[b] - mean) * (log[b] - mean);
        sum[4] += (model[b] - other) * (model[b] - other);
        a->correlation += (log[b] - mean) * (model[b] - other);
    }
    a->points = n;
    a->bias = other - mean;
    a->bias_pct = 100 * a->bias / mean;
    a->rms = sqrt(sum[2] / (double)n);
    a->rms_pct = 100 * a->rms / mean;
    a->correlation = sum[3] > 0 && sum[4] > 0 ? a->correlation / sqrt(sum[3] * sum[4]) : NAN;
    a->within_pct = 100 * (double)inside / (double)n;
    a->peak_pct = 100 * (a->peak_model / a->peak_log - 1);
    return HAWSER_OK;
}

/* ------------------------------------------------------------------------------------------- planned and pulled */

/* The model of the plan: theory if it is known. */
static const Model *planned_by(const Comparison *c) { return &c->model[c->n_models - 1]; }

/* Computes means in motion over equal parts of the common range, and the peaks of both there. */
static void parts_find(Comparison *c)
{
    const Model *const m = planned_by(c);
    const double width = (c->to - c->from) / PLANNED_PARTS;
    PlannedPart part[PLANNED_PARTS] = {{0}};
    c->planned = c->pulled = (PlannedPeak){NAN, NAN};
    for (int p = 0; p < PLANNED_PARTS; p++) part[p].from = c->from + p * width, part[p].to = c->from + (p + 1) * width;
    for (long i = 0; i < c->log.n; i++) {
        const double at = c->axis[i], force = c->log.force[i],
                     planned = c->log.use[i] == LOG_MOVING ? model_at(m, at) : NAN;
        if (isnan(planned)) continue;
        PlannedPart *const p = &part[(int)fmin(fmax((at - c->from) / width, 0), PLANNED_PARTS - 1)];
        p->readings++;
        p->pulled += force;
        p->planned += planned;
        p->pulled_most = fmax(p->pulled_most, force);
        if (!(force <= c->pulled.force)) c->pulled = (PlannedPeak){force, at};
        if (!(planned <= c->planned.force)) c->planned = (PlannedPeak){planned, at};
    }
    c->n_parts = 0;
    for (int p = 0; p < PLANNED_PARTS; p++) {
        if (part[p].readings == 0) continue;
        part[p].pulled /= (double)part[p].readings;
        part[p].planned /= (double)part[p].readings;
        part[p].ratio = part[p].planned > 0 ? part[p].pulled / part[p].planned : NAN;
        c->part[c->n_parts++] = part[p];
    }
}

/* Computes the excess of theory's force over the log's with that share of friction, N: the mean over the parts (LO11).
 */
static hawser_status share_more(const Comparison *c, double share, double *more, hawser_error *err)
{
    double head[PLANNED_PARTS], force[PLANNED_PARTS];
    for (int p = 0; p < c->n_parts; p++) head[p] = (c->part[p].from + c->part[p].to) / 2;
    const hawser_status status = case_heads_force(&c->heads, share, c->n_parts, head, force, err);
    *more = 0;
    for (int p = 0; p < c->n_parts && !status; p++) {
        const double middle = model_at(planned_by(c), head[p]);
        *more += (force[p] + c->part[p].planned - middle - c->part[p].pulled) / c->n_parts;
    }
    return status;
}

/* Finds the share of the planned friction with which theory has the log's mean (LO11). */
static hawser_status share_find(Comparison *c, hawser_error *err)
{
    static const double MOST = 8, NEAR = 1e-5;
    double low = 0, high = MOST, less, more;
    c->share = NAN;
    if (!c->heads.theory) return HAWSER_OK;
    hawser_status status = share_more(c, low, &less, err);
    if (!status) status = share_more(c, high, &more, err);
    if (status == HAWSER_ERR_INPUT) status = HAWSER_OK, more = INFINITY; /* the force grew past all bounds */
    if (status || less > 0 || more < 0) return status;
    while (!status && high - low > NEAR) {
        const double middle = (low + high) / 2;
        status = share_more(c, middle, &more, err);
        if (status == HAWSER_ERR_INPUT) status = HAWSER_OK, more = INFINITY;
        *(more > 0 ? &high : &low) = middle;
    }
    c->share = (low + high) / 2;
    return status;
}

/* ------------------------------------------------------------------------------------------------------------ output
 */

#define FIGURE(key_, what, member, places)                                                                             \
    {                                                                                                                  \
        COLUMN(key_, NUMBER, Agreement, member), .label = what, .decimals = places                                     \
    }

static const Column agreement_columns[] = {
    {COLUMN("model", TEXT, Agreement, name), .label = "against"},
    FIGURE("bias_N", "bias, N", bias, 0),
    FIGURE("bias_pct", "that is, %", bias_pct, 1),
    FIGURE("rms_N", "RMS, N", rms, 0),
    FIGURE("rms_pct", "that is, %", rms_pct, 1),
    FIGURE("correlation", "correlation", correlation, 3),
    FIGURE("within_pct", "in the band, %", within_pct, 1),
    FIGURE("peak_log_N", "log's peak, N", peak_log, 0),
    FIGURE("peak_N", "peak, N", peak_model, 0),
    FIGURE("peak_pct", "that is, %", peak_pct, 1),
    {COLUMN("points", LONG, Agreement, points), .label = "parts"},
};

#define PART_COLUMNS(unit)                                                                                             \
    {                                                                                                                  \
        {COLUMN("from_" unit, NUMBER, PlannedPart, from), .label = "from, " unit, .decimals = 1},                      \
            {COLUMN("to_" unit, NUMBER, PlannedPart, to), .label = "to, " unit, .decimals = 1},                        \
            {COLUMN("planned_N", NUMBER, PlannedPart, planned), .label = "planned, N", .decimals = 0},                 \
            {COLUMN("pulled_N", NUMBER, PlannedPart, pulled), .label = "pulled, N", .decimals = 0},                    \
            {COLUMN("ratio", NUMBER, PlannedPart, ratio), .label = "pulled over planned", .decimals = 3},              \
            {COLUMN("pulled_most_N", NUMBER, PlannedPart, pulled_most), .label = "pulled at most, N", .decimals = 0},  \
            {COLUMN("readings", LONG, PlannedPart, readings), .label = "readings"},                                    \
    }

static const Column part_columns[] = PART_COLUMNS("m"), time_columns[] = PART_COLUMNS("s");

/* Builds both tables, for text and page. */
static void tables_make(const Comparison *c, Table table[2])
{
    const Columns by_place = COLUMNS(PlannedPart, part_columns), by_time = COLUMNS(PlannedPart, time_columns);
    table[0] = (Table){"planned", "Planned against pulled, means at speed", c->options.by_start ? by_time : by_place,
                       c->n_parts, c->part};
    table[1] = (Table){"agreement", "Agreement", COLUMNS(Agreement, agreement_columns), c->n_models, c->agreement};
}

/* Writes the peaks, and the friction that would explain the pull. */
static int planned_say(const Comparison *c, char *text, size_t size)
{
    const char *const unit = c->options.by_start ? "s" : "m";
    int n = snprintf(text, size,
                     "  peak      planned %.4g kN at %.1f %s, pulled %.4g kN at %.1f %s: %.3g of what was planned\n",
                     c->planned.force / 1e3, c->planned.at, unit, c->pulled.force / 1e3, c->pulled.at, unit,
                     c->pulled.force / c->planned.force);
    if (!c->heads.theory) return n;
    if (isnan(c->share))
        return n + snprintf(text + n, size - (size_t)n,
                            "  friction  no friction explains what was pulled: check weight and back tension\n");
    const int one = c->heads.friction - c->heads.friction_least < 1e-9;
    if (one)
        n += snprintf(text + n, size - (size_t)n,
                      "  friction  %.3g would explain the mean, planned %.3g: %.3g times as much\n",
                      c->share * c->heads.friction, c->heads.friction, c->share);
    else
        n += snprintf(text + n, size - (size_t)n,
                      "  friction  %.3g to %.3g would explain the mean, planned %.3g to %.3g: %.3g times as much\n",
                      c->share * c->heads.friction_least, c->share * c->heads.friction, c->heads.friction_least,
                      c->heads.friction, c->share);
    return n;
}

static const char *answer_say(const Comparison *c, char *text, size_t size)
{
    const Agreement *const a = &c->agreement[0];
    const long *const k = c->log.count;
    int n = snprintf(text, size,
                     "%s pulls %.1f %% %s than the log, RMS %.1f %%; %.0f %% lie within %.3g %%\n"
                     "  compared  %.4g to %.4g %s, %ld readings at speed; %ld starts\n",
                     c->heads.theory ? "Theory" : "The run", fabs(a->bias_pct), a->bias < 0 ? "less" : "more",
                     a->rms_pct, a->within_pct, 100 * c->options.band, c->from, c->to, c->options.by_start ? "s" : "m",
                     k[LOG_MOVING], c->log.starts);
    n += planned_say(c, text + n, size - (size_t)n);
    n += snprintf(text + n, size - (size_t)n,
                  "  left out  %ld at rest or starting, %ld no reading, %ld drop-outs, %ld spikes\n",
                  k[LOG_AT_REST] + k[LOG_RESTART], k[LOG_LOST], k[LOG_DROPPED], k[LOG_SPIKE]);
    if (c->unended)
        n += snprintf(text + n, size - (size_t)n, "  results   the run has not ended: as far as it had come\n");
    for (int i = 0; i < c->log.n_notes && (size_t)n < size; i++)
        n += snprintf(text + n, size - (size_t)n, "  log       %s\n", c->log.note[i]);
    return text;
}

static hawser_status document_make(const Comparison *c, const char *results, const char *log, char **text,
                                   hawser_error *err)
{
    char answer[4096], notes[LOG_NOTES_MAX];
    const long *const k = c->log.count;
    log_notes(c->log.n_notes, c->log.note, notes);
    const Fact fact[] = {{"results", NULL, "", cell_text(results)},
                         {"log", NULL, "", cell_text(log)},
                         {"aligned_by", NULL, "", cell_text(c->options.by_start ? "start" : "length")},
                         {"shift", NULL, "", cell_number(c->options.shift)},
                         {"from", NULL, "", cell_number(c->from)},
                         {"to", NULL, "", cell_number(c->to)},
                         {"band_pct", NULL, "%", cell_number(100 * c->options.band)},
                         {"readings", NULL, "", cell_number((double)c->log.n)},
                         {"moving", NULL, "", cell_number((double)k[LOG_MOVING])},
                         {"starts", NULL, "", cell_number((double)c->log.starts)},
                         {"at_rest", NULL, "", cell_number((double)k[LOG_AT_REST])},
                         {"lost", NULL, "", cell_number((double)k[LOG_LOST])},
                         {"dropped", NULL, "", cell_number((double)k[LOG_DROPPED])},
                         {"spikes", NULL, "", cell_number((double)k[LOG_SPIKE])},
                         {"planned_peak_N", NULL, "N", cell_number(c->planned.force)},
                         {"planned_peak_at", NULL, "", cell_number(c->planned.at)},
                         {"pulled_peak_N", NULL, "N", cell_number(c->pulled.force)},
                         {"pulled_peak_at", NULL, "", cell_number(c->pulled.at)},
                         {"friction_planned", NULL, "", cell_number(c->heads.theory ? c->heads.friction : NAN)},
                         {"friction_share", NULL, "", cell_number(c->share)},
                         {"notes", NULL, "", cell_text(notes)}};
    Table table[2];
    tables_make(c, table);
    const Document doc = {.title = "A measured pull",
                          .n_facts = sizeof fact / sizeof *fact,
                          .n_tables = 2,
                          .fact = fact,
                          .table = table,
                          .answer = answer_say(c, answer, sizeof answer)};
    return document_write(&doc, c->options.format, text, err);
}

/* ----------------------------------------------------------------------------------------------------------- page */

/* Draws all forces over the axis, and the difference of each model. */
static void figures_add(Text *page, const Comparison *c, double *scratch)
{
    assert(c->n_models <= 2);
    const int n = c->n_points;
    double *const x = scratch, *const y = x + n, *const off[2] = {y + n, y + 2 * n};
    Curve curve[4], difference[2];
    for (int i = 0; i < n; i++) {
        x[i] = c->point[i].at;
        y[i] = c->point[i].force / 1000;
        for (int k = 0; k < c->n_models; k++)
            off[k][i] = c->point[i].restart ? NAN : model_at(&c->model[k], x[i]) / 1000 - y[i];
    }
    const SvgStyle styles[2] = {SVG_FIRST, SVG_THIRD};
    curve[0] = (Curve){"measured", n, x, y, SVG_SECOND, 0, 1};
    for (int k = 0; k < c->n_models; k++) {
        for (int i = 0; i < c->model[k].n; i++) c->model[k].force[i] /= 1000;
        curve[k + 1] = (Curve){c->model[k].name, c->model[k].n, c->model[k].at, c->model[k].force, styles[k], 1, 0};
        difference[k] = (Curve){c->model[k].name, n, x, off[k], styles[k], 1, 0};
    }
    const char *const axis = c->options.by_start ? "time since the start, s"
                             : c->heads.theory   ? "place of the head along the route, m"
                                                 : "winch's travel, m";
    page_chart(page, &(Chart){"Force at the winch", axis, "force, kN", c->n_models + 1, curve, 960, 420, NAN, ""});
    page_chart(page, &(Chart){"Model less log", axis, "difference, kN", c->n_models, difference, 960, 300, 0, "none"});
}

static hawser_status page_write_to(const Comparison *c, const char *results, const char *log, hawser_error *err)
{
    char answer[4096], title[NAME_BYTES];
    Table table[2];
    double *const scratch = malloc(((size_t)c->n_points * 4 + 1) * sizeof *scratch);
    Text page = {0};
    if (!scratch) return error_memory(err);
    snprintf(title, sizeof title, "%.70s against %.70s", log, results);
    page_begin(&page, title);
    page_lines(&page, answer_say(c, answer, sizeof answer));
    tables_make(c, table);
    for (int k = 0; k < 2; k++) page_table(&page, &table[k]);
    figures_add(&page, c, scratch);
    page_end(&page);
    const hawser_status status = page.failed ? error_memory(err) : out_file(c->options.page, page.at, page.size, err);
    text_clear(&page);
    free(scratch);
    return status;
}

/* ---------------------------------------------------------------------------------------------------------- as a whole
 */

/* Builds theory's force by the place of the head. */
static hawser_status heads_model(const CaseHeads *heads, Model *m, hawser_error *err)
{
    *m = (Model){"theory", BINS + 1, malloc((BINS + 1) * sizeof(double)), malloc((BINS + 1) * sizeof(double))};
    if (!m->at || !m->force) return error_memory(err);
    for (int i = 0; i <= BINS; i++) m->at[i] = heads->begins + (heads->ends - heads->begins) * i / BINS;
    return case_heads_force(heads, 1, m->n, m->at, m->force, err);
}

/* Finds the common range of log and models. */
static hawser_status range_find(Comparison *c, hawser_error *err)
{
    c->from = INFINITY;
    c->to = -INFINITY;
    for (long i = 0; i < c->log.n; i++) {
        if (c->log.use[i] != LOG_MOVING || isnan(model_at(&c->model[0], c->axis[i]))) continue;
        c->from = fmin(c->from, c->axis[i]);
        c->to = fmax(c->to, c->axis[i]);
    }
    if (c->to > c->from) return HAWSER_OK;
    return error_set(err, HAWSER_ERR_INPUT,
                     "the log and %s have no stretch in common: try another alignment, or shift it",
                     c->heads.theory ? "the case" : "the results");
}

/* Builds the models on the axis, and the common range of run and log. */
static hawser_status models_make(Comparison *c, const Folder *folder, hawser_error *err)
{
    const char *const column[2] = {"winch_force_N", "reference_N"}, *const name[2] = {"run", "theory"};
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < 2 && !status; k++) {
        status = model_make(&folder->series, column[k], name[k], c->options.by_start, &c->model[k], err);
        if (!status && c->model[k].n < 2 && k == 0)
            status = error_set(err, HAWSER_ERR_INPUT, "'%.400s' has no force over %s in series.csv", folder->dir,
                               c->options.by_start ? "time" : "the winch's travel");
    }
    if (status) return status;
    c->n_models = c->model[1].n < 2 ? 1 : 2;
    return range_find(c, err);
}

static void comparison_clear(Comparison *c)
{
    for (int k = 0; k < 2; k++) {
        free(c->model[k].at);
        free(c->model[k].force);
    }
    free(c->axis);
    free(c->point);
    case_heads_free(&c->heads);
    log_free(&c->log);
}

/* Checks that the page does not overwrite one of the compared files. */
static hawser_status page_spare(const Folder *folder, const char *log, const char *page, hawser_error *err)
{
    FileMarks files = {0};
    hawser_status status = folder_files(folder, &files, err);
    if (!status) status = file_marks_add(&files, log, err);
    if (!status) status = file_marks_spare(&files, page, err);
    file_marks_free(&files);
    return status;
}

/* Usual speed of the run's winch, for a log with neither length nor speed. NAN: unknown. */
static double usual_speed(const Folder *folder)
{
    const int v = sheet_column(&folder->series, "winch_speed_m_per_s");
    double most = NAN;
    for (int i = 0; i < folder->series.rows && v >= 0; i++) most = fmax(most, sheet_number(&folder->series, i, v));
    return most;
}

/* Completes the comparison once log and models are read. */
static hawser_status compared(Comparison *c, const char *with, const char *log, char **text, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < c->n_models && !status; k++) status = agreement_find(c, &c->model[k], &c->agreement[k], err);
    parts_find(c);
    if (!status) status = share_find(c, err);
    if (!status) {
        c->n_points = log_points(&c->log, c->axis, c->from, c->to, BINS, &c->point);
        if (c->n_points < 0) status = error_memory(err);
    }
    if (!status && c->options.page) status = page_write_to(c, with, log, err);
    return status ? status : document_make(c, with, log, text, err);
}

/* Compares with theory alone, whose head begins at the case's place; the log's lengths count from there. */
static hawser_status compare_case(Comparison *c, const char *path, const char *log, char **text, hawser_error *err)
{
    FileMarks files = {0};
    hawser_case *planned = NULL;
    if (c->options.by_start)
        return error_set(err, HAWSER_ERR_INPUT, "%.400s: a case has no times: align the log by length", path);
    hawser_status status = hawser_case_load(path, &planned, err);
    if (!status) status = case_heads_new(planned, &c->heads, err);
    if (!status) status = log_read(log, &c->log, err);
    if (!status) status = log_judge(&c->log, NAN, c->options.raw, err);
    c->options.shift += c->heads.begins;
    if (!status) status = axis_make(c, err);
    if (!status) status = heads_model(&c->heads, &c->model[0], err);
    c->n_models = 1;
    if (!status) status = range_find(c, err);
    if (!status && c->options.page) status = file_marks_add(&files, log, err);
    if (!status && c->options.page) status = file_marks_add(&files, path, err);
    if (!status && c->options.page) status = file_marks_spare(&files, c->options.page, err);
    file_marks_free(&files);
    if (!status) status = compared(c, path, log, text, err);
    case_heads_free(&c->heads); /* heads borrow from the case */
    hawser_case_free(planned);
    return status;
}

static hawser_status compare_results(Comparison *c, const char *results, const char *log, char **text,
                                     hawser_error *err)
{
    Folder folder = {0};
    hawser_status status = folder_read(results, &folder, err);
    c->unended = !status && is_running(folder.summary);
    if (!status) status = log_read(log, &c->log, err);
    if (!status) status = log_judge(&c->log, usual_speed(&folder), c->options.raw, err);
    if (!status) status = axis_make(c, err);
    if (!status) status = models_make(c, &folder, err);
    if (!status && c->options.page) status = page_spare(&folder, log, c->options.page, err);
    if (!status) status = compared(c, results, log, text, err);
    folder_clear(&folder);
    return status;
}

/* Adds the file name to an error of the log. */
static hawser_status name_log(hawser_status status, const char *log, hawser_error *err)
{
    static const char of_log[] = "the log";
    const hawser_error why = *err;
    if (status != HAWSER_ERR_INPUT || strncmp(why.message, of_log, strlen(of_log)) != 0) return status;
    return error_set(err, status, "%.400s: %s", log, why.message);
}

hawser_status hawser_compare(const char *results, const char *log, const hawser_compare_options *options, char **text,
                             hawser_error *err)
{
    hawser_error local;
    hawser_error *const e = err ? err : &local;
    struct stat what;
    Comparison c = {.options = options ? *options : (hawser_compare_options){0}};
    if (!results || !log || !text) return error_argument(err, !results ? "results" : !log ? "log" : "text");
    *text = NULL;
    if (c.options.band == 0) c.options.band = 0.1;
    const int file = stat(results, &what) == 0 && !S_ISDIR(what.st_mode);
    const hawser_status status =
        file ? compare_case(&c, results, log, text, e) : compare_results(&c, results, log, text, e);
    comparison_clear(&c);
    return name_log(status, log, e);
}
