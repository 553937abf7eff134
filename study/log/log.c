/* A measured pull's notes, and its points. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "study/log/log.h"

void log_free(PullLog *log)
{
    free(log->time);
    free(log->length);
    free(log->speed);
    free(log->force);
    free(log->line);
    free(log->use);
    *log = (PullLog){.n = 0};
}

void log_say(PullLog *log, const char *format, ...)
{
    va_list list;
    if (log->n_notes == LOG_NOTES) return;
    va_start(list, format);
    vsnprintf(log->note[log->n_notes++], LOG_NOTE_MAX, format, list);
    va_end(list);
}

void log_say_first(PullLog *log, const char *format, ...)
{
    va_list list;
    if (log->n_notes < LOG_NOTES) log->n_notes++;
    memmove(log->note[1], log->note[0], (LOG_NOTES - 1) * sizeof log->note[0]);
    va_start(list, format);
    vsnprintf(log->note[0], LOG_NOTE_MAX, format, list);
    va_end(list);
}
void log_notes(int n, const char note[][LOG_NOTE_MAX], char text[LOG_NOTES_MAX])
{
    size_t at = 0;
    *text = 0;
    for (int i = 0; i < n; i++)
        at += (size_t)snprintf(text + at, LOG_NOTES_MAX - at, "%s%s", i > 0 ? "; " : "", note[i]);
}

static int compare_points(const void *a, const void *b)
{
    const LogPoint *const p = a, *const q = b;
    if (p->at != q->at) return p->at < q->at ? -1 : 1;
    return p->restart - q->restart;
}

int log_points(const PullLog *log, const double *axis, double from, double to, int bins, LogPoint **point)
{
    const long starts = log->count[LOG_RESTART];
    LogPoint *const all = calloc((size_t)(bins + starts) + 1, sizeof *all);
    int n = bins, kept = 0;
    *point = all;
    if (!all) return -1;
    for (long i = 0; i < log->n; i++) {
        if (!(axis[i] >= from && axis[i] <= to)) continue;
        if (log->use[i] == LOG_RESTART) all[n++] = (LogPoint){axis[i], log->force[i], 1, 1};
        if (log->use[i] != LOG_MOVING) continue;
        const int b = to > from ? (int)fmin((axis[i] - from) / (to - from) * bins, bins - 1) : 0;
        all[b].at += axis[i];
        all[b].force += log->force[i];
        all[b].readings++;
    }
    for (int b = 0; b < n; b++) {
        if (all[b].readings == 0) continue;
        const double of = (double)all[b].readings;
        all[kept++] = (LogPoint){all[b].at / of, all[b].force / of, all[b].restart, all[b].readings};
    }
    qsort(all, (size_t)kept, sizeof *all, compare_points);
    return kept;
}
