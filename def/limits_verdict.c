/* The verdict in one line: public, for every front end. */
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>

#include "core/base/error.h"
#include "def/limits.h"

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

/* "sidewall by 22 % at bend"; of a run-away what is missing. */
static void add_broken(Line *line, const hawser_limit *l, int first)
{
    if (l->kind == HAWSER_LIMIT_RUN_AWAY) {
        add(line, "%s %s", first ? ":" : ",", l->source);
        return;
    }
    const double over = 100 * fabs(l->value / l->limit - 1);
    add(line, "%s %s by %.3g %%%s%s", first ? ":" : ",", l->name, over, *l->where ? " at " : "", l->where);
}

int limits_essential(hawser_limit_kind kind) { return kind == HAWSER_LIMIT_PULL || kind == HAWSER_LIMIT_SIDEWALL; }

/* "; 2 not judged: rope, winch". */
static void add_not_judged(Line *line, int n, const hawser_limit *limit, int unknown)
{
    add(line, "; %d not judged", unknown);
    for (int i = 0, first = 1; i < n; i++) {
        if (!limit[i].judged) add(line, "%s %s", first ? ":" : ",", limit[i].name), first = 0;
    }
}

/* What the limits come to. */
typedef struct Tally {
    int judged, broken;
    const hawser_limit *least;   /* the one with the smallest margin; NULL: none is judged */
    const hawser_limit *missing; /* the first that a pull cannot be called safe without, and that is not judged */
} Tally;

static Tally tally_of(int n, const hawser_limit *limit)
{
    Tally t = {0};
    for (int i = 0; i < n; i++) {
        const hawser_limit *const l = &limit[i];
        if (!l->judged && !t.missing && limits_essential(l->kind)) t.missing = l;
        if (!l->judged) continue;
        t.judged++;
        t.broken += !l->ok;
        if (!t.least || l->margin < t.least->margin) t.least = l;
    }
    return t;
}

int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size)
{
    if (!text || size == 0 || (n > 0 && !limit)) return -1;
    const Tally t = tally_of(n, limit);
    *text = 0;
    Line line = {text, size};
    if (t.judged == 0) {
        add(&line, "NOT JUDGED: %s", n ? "no limit could be judged" : "the case has no section 'limits'");
        return -1;
    }
    if (t.broken > 0) {
        add(&line, "NOT SAFE: %d of %d limits broken", t.broken, t.judged);
        for (int i = 0, first = 1; i < n; i++) {
            if (limit[i].judged && !limit[i].ok) add_broken(&line, &limit[i], first), first = 0;
        }
    } else if (t.missing) {
        const int one = t.judged == 1;
        add(&line, "NOT JUDGED: %s: %s; the %d limit%s that could be judged hold%s", t.missing->name, t.missing->source,
            t.judged, one ? "" : "s", one ? "s" : "");
    } else {
        add(&line, "SAFE: all %d limits hold, smallest margin %.3g %% (%s%s%s)", t.judged, 100 * t.least->margin,
            t.least->name, *t.least->where ? " at " : "", t.least->where);
    }
    if (n > t.judged) add_not_judged(&line, n, limit, n - t.judged);
    return t.broken > 0 ? t.broken : t.missing ? -1 : 0;
}

/* The first that fails stands for all: the others are counted. */
int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size)
{
    if (!text || size == 0 || (n_conditions > 0 && !condition)) return -1;
    const int broken = hawser_limits_verdict(n, limit, text, size);
    const hawser_condition *first = NULL;
    int more = 0;
    for (int i = 0; i < n_conditions; i++) {
        if (condition[i].holds) continue;
        more += first != NULL;
        if (!first) first = &condition[i];
    }
    if (!first) return broken;
    *text = 0;
    Line line = {text, size};
    add(&line, "NOT TRUSTED: %s", first->remedy);
    if (more) add(&line, "; and %d more reason%s", more, more > 1 ? "s" : "");
    if (broken > 0) add(&line, "; besides, %d of the limits would be broken", broken);
    text_make_utf8(text); /* a name in a remedy may have been cut */
    return -2;
}
