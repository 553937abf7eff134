/* The line at the end of a judgement. It is part of the public interface, since every front end needs it. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "theory/limits.h"

/* Text that grows, cut at its end. */
typedef struct Line {
    char *text;
    size_t size;
} Line;

static void add(Line *line, const char *format, ...) __attribute__((format(printf, 2, 3)));

static void add(Line *line, const char *format, ...)
{
    const size_t used = strlen(line->text);
    va_list args;
    va_start(args, format);
    vsnprintf(line->text + used, line->size - used, format, args);
    va_end(args);
}

/* "sidewall 22 % over at bend". */
static void add_broken(Line *line, const hawser_limit *l, int first)
{
    const double over = 100 * (strcmp(l->unit, "m") ? l->value / l->limit - 1 : 1 - l->value / l->limit);
    add(line, "%s %s by %.3g %%%s%s", first ? ":" : ",", l->name, over, *l->where ? " at " : "", l->where);
}

int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size)
{
    int judged = 0, broken = 0, least = -1;
    for (int i = 0; i < n; i++) {
        if (!limit[i].judged) continue;
        judged++;
        broken += !limit[i].ok;
        if (least < 0 || limit[i].margin < limit[least].margin) least = i;
    }
    *text = 0;
    Line line = {text, size};
    if (broken > 0) {
        add(&line, "NOT SAFE: %d of %d limits broken", broken, judged);
        int first = 1;
        for (int i = 0; i < n; i++) {
            if (limit[i].judged && !limit[i].ok) add_broken(&line, &limit[i], first), first = 0;
        }
    } else if (judged > 0) {
        const hawser_limit *l = &limit[least];
        add(&line, "SAFE: all %d limits hold, smallest margin %.3g %% (%s%s%s)", judged, 100 * l->margin, l->name,
            *l->where ? " at " : "", l->where);
    } else {
        add(&line, "NOT JUDGED: %s", n ? "no limit could be judged" : "the case has no section 'limits'");
    }
    if (n > judged && judged > 0) add(&line, "; %d not judged", n - judged);
    return judged > 0 ? broken : -1;
}

int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size)
{
    const int broken = hawser_limits_verdict(n, limit, text, size);
    int failed = 0;
    Line line = {text, size};
    for (int i = 0; i < n_conditions; i++) {
        if (condition[i].holds) continue;
        if (failed++ == 0) *text = 0;
        add(&line, failed == 1 ? "NOT TRUSTED: %s" : "; %s", condition[i].remedy);
    }
    if (failed && broken > 0) add(&line, "; besides, %d of the limits would be broken", broken);
    return failed ? -2 : broken;
}
