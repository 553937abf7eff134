/* The readings of a log that are numbers and go on: the longest course of times, stamps that are coarser than the
 * readings, counters that run down, are set back or are wrong once. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "study/log/log.h"
#include "study/maths/estimate.h"

/* (LO1a): metres, and steps of the neighbours, beyond which a single length is wrong; a fall that is said. Share of
 * readings beyond which their loss is said first. */
static const double LENGTH_OFF_M = 0.5, LENGTH_OFF_STEPS = 5, LOST_SHARE = 0.03;

void log_kept_free(LogKept *k)
{
    free(k->at);
    free(k->x);
    free(k->v);
}

/* ---------------------------------------------------------------------------------------------------------- courses */

/* Of readings at[n] the most whose x does not fall: the longest course, by the least end of each length. */
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
        end[m] = i; /* ends of shorter courses are not needed any more */
        i = next;
    }
    for (long m = 0; m < longest && !status; m++) at[m] = at[end[m]];
    *n = longest;
    free(end);
    free(before);
    return status;
}

/* Leaves out single lengths far off both neighbours. */
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

/* Readings of equal time go evenly up to the next stamp, or as far as stamps usually are apart. */
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
    if (n == 0) { /* no time goes on */
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

/* Errors for what is written the other way round: pulls and speeds below 0, a length that runs down. */
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
        return error_set(err, HAWSER_ERR_INPUT, "the log: %ld of its forces are below 0: write a pull above 0",
                         force[1]);
    if (log->has_speed && speed[1] > 2 * speed[0] && speed[1] > 2)
        return error_set(err, HAWSER_ERR_INPUT, "the log: %ld of its speeds are below 0: write that of a pull above 0",
                         speed[1]);
    if (log->has_length && length[1] > 2 * length[0] && length[1] > 2) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "the log: its length runs down, from %.6g m in line %d to %.6g m in line %d: write what has "
                         "been pulled, which rises",
                         log->length[first], log->line[first], log->length[last], log->line[last]);
    }
    return HAWSER_OK;
}

/* Lengths that fall: places are the counter's. */
static void falls_say(PullLog *log, const LogKept *k)
{
    long falls = 0, first = 0;
    for (long m = 1; m < k->n; m++) {
        if (!(log->length[k->at[m]] < log->length[k->at[m - 1]] - LENGTH_OFF_M)) continue;
        if (falls++ == 0) first = m;
    }
    if (falls == 0) return;
    log_say(
        log,
        "The length falls as if its counter was set back, %ld in all, first from %.4g m to %.4g m in line %d: places "
        "are taken as they stand",
        falls, log->length[k->at[first - 1]], log->length[k->at[first]], log->line[k->at[first]]);
}

/* Says first that many readings are lost. */
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
