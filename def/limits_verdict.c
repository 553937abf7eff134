/* The verdict in one line: public, for every front end. */
#include <math.h>
#include <stdarg.h>
#include <stddef.h>
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

static const struct {
    const char *text, *code;
} words[HAWSER_WORDS] = {[HAWSER_SAFE] = {"SAFE", "safe"},
                         [HAWSER_NOT_SAFE] = {"NOT SAFE", "not_safe"},
                         [HAWSER_NOT_JUDGED] = {"NOT JUDGED", "not_judged"},
                         [HAWSER_NOT_TRUSTED] = {"NOT TRUSTED", "not_trusted"},
                         [HAWSER_SAFE_ONLY_IF] = {"SAFE ONLY IF", "safe_if"}};
enum { NONE_JUDGED = -1, NONE_TRUSTED = -2, ONLY_IF = -3 }; /* what verdicts return beside a count */

hawser_word hawser_verdict_word(int found)
{
    if (found > 0) return HAWSER_NOT_SAFE;
    return found == NONE_TRUSTED  ? HAWSER_NOT_TRUSTED
           : found == NONE_JUDGED ? HAWSER_NOT_JUDGED
           : found == ONLY_IF     ? HAWSER_SAFE_ONLY_IF
                                  : HAWSER_SAFE;
}

const char *hawser_word_text(hawser_word word) { return words[word].text; }
const char *hawser_word_code(hawser_word word) { return words[word].code; }

/* Of words that begin alike the longest. */
hawser_word hawser_word_of(const char *verdict)
{
    int found = HAWSER_WORDS;
    size_t longest = 0;
    for (int w = 0; verdict && w < HAWSER_WORDS; w++) {
        const size_t n = strlen(words[w].text);
        if (n <= longest || strncmp(verdict, words[w].text, n) != 0) continue;
        found = w;
        longest = n;
    }
    return (hawser_word)found;
}

static const double TIMES = 10; /* of what is allowed, from which on a share in % says nothing */

/* "sidewall by 22 % at bend"; of a run-away what is missing. */
static void add_broken(Line *line, const hawser_limit *l, int first)
{
    if (l->kind == HAWSER_LIMIT_RUN_AWAY) {
        add(line, "%s %s", first ? ":" : ",", l->source);
        return;
    }
    const double share = l->value / l->limit;
    add(line, "%s %s ", first ? ":" : ",", l->name);
    if (share < TIMES)
        add(line, "by %.3g %%", 100 * fabs(share - 1));
    else
        add(line, "%.0f times too large", share);
    add(line, "%s%s", *l->where ? " at " : "", l->where);
}

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
        if (!l->judged && !t.missing && (limits_is(l->kind, LIMIT_ESSENTIAL) || l->at_speed)) t.missing = l;
        if (!l->judged) continue;
        t.judged++;
        t.broken += !l->ok;
        if (!t.least || l->margin < t.least->margin) t.least = l;
    }
    return t;
}

/* The bounds of what is assumed, and how a verdict says them. */
static const struct BoundRow {
    const char *text, *unit;
    size_t offset; /* in a limit */
    int least;
} bounds[] = {{"friction <=", "", offsetof(hawser_limit, friction_most), 0},
              {"friction >=", "", offsetof(hawser_limit, friction_least), 1},
              {"friction at rest <=", "", offsetof(hawser_limit, rest_most), 0},
              {"back tension <=", " N", offsetof(hawser_limit, back_most), 0},
              {"radius at changes of slope >=", " m", offsetof(hawser_limit, slope_radius_least), 1}};

/* What the limit says of a bound; NAN: nothing. */
static double bound_of(const hawser_limit *l, const struct BoundRow *row)
{
    return l->judged && l->assumed ? *(const double *)(const void *)((const char *)l + row->offset) : NAN;
}

/* In three digits, rounded to the safe side. */
static double rounded(double value, int least)
{
    const double step = value > 0 ? pow(10, floor(log10(value)) - 2) : 1;
    return step * (least ? ceil(value / step - 1e-9) : floor(value / step + 1e-9));
}

/* "friction <= 0.27 (restart) and back tension <= 600 N (pull)": of each the strictest. Returns how many there are. */
static int add_bounds(Line *line, int n, const hawser_limit *limit)
{
    int said = 0;
    for (size_t k = 0; k < sizeof bounds / sizeof *bounds; k++) {
        const struct BoundRow *const row = &bounds[k];
        const hawser_limit *by = NULL;
        double strictest = row->least ? -INFINITY : INFINITY;
        for (int i = 0; i < n; i++) {
            const double bound = bound_of(&limit[i], row);
            if (!(row->least ? bound > strictest : bound < strictest)) continue;
            strictest = bound;
            by = &limit[i];
        }
        if (!by) continue;
        add(line, "%s%s %.4g%s (%s)", said++ ? " and " : "", row->text, rounded(strictest, row->least), row->unit,
            by->name);
    }
    return said;
}

int limits_only_if(int n, const hawser_limit *limit, char *text, size_t size)
{
    Line line = {text, size};
    snprintf(text, size, "%s ", words[HAWSER_SAFE_ONLY_IF].text);
    const int said = add_bounds(&line, n, limit);
    if (!said) snprintf(text, size, "%s", words[HAWSER_SAFE].text);
    return said;
}

static int limits_say(int n, const hawser_limit *limit, int open, char *text, size_t size)
{
    if (!text || size == 0 || (n > 0 && !limit)) return NONE_JUDGED;
    const Tally t = tally_of(n, limit);
    int only_if = 0;
    *text = 0;
    Line line = {text, size};
    if (t.judged == 0 && !t.missing) {
        add(&line, "%s: %s", words[HAWSER_NOT_JUDGED].text,
            n ? "no limit could be judged" : "the case has no section 'limits'");
        return NONE_JUDGED;
    }
    if (t.broken > 0) {
        add(&line, "%s: %d of %d limits broken", words[HAWSER_NOT_SAFE].text, t.broken, t.judged);
        for (int i = 0, first = 1; i < n; i++) {
            if (limit[i].judged && !limit[i].ok) add_broken(&line, &limit[i], first), first = 0;
        }
    } else if (t.missing) {
        const int one = t.judged == 1;
        add(&line, "%s: %s: %s", words[HAWSER_NOT_JUDGED].text, t.missing->name, t.missing->source);
        if (t.judged > 0)
            add(&line, "; the %d limit%s that could be judged hold%s", t.judged, one ? "" : "s", one ? "s" : "");
    } else {
        only_if = limits_only_if(n, limit, text, size);
        add(&line, ": all %d limits hold%s, smallest margin %.3g %% (%s%s%s)", t.judged,
            only_if ? " with what is assumed" : "", 100 * t.least->margin, t.least->name, *t.least->where ? " at " : "",
            t.least->where);
    }
    if (n > t.judged && open) add_not_judged(&line, n, limit, n - t.judged);
    return t.broken > 0 ? t.broken : t.missing ? NONE_JUDGED : only_if ? ONLY_IF : 0;
}

int hawser_limits_verdict(int n, const hawser_limit *limit, char *text, size_t size)
{
    return limits_say(n, limit, 1, text, size);
}

/* The first that fails stands for all: the others are counted. */
int verdict_say(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, int open,
                char *text, size_t size)
{
    if (!text || size == 0 || (n_conditions > 0 && !condition)) return NONE_JUDGED;
    const int broken = limits_say(n, limit, open, text, size);
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
    add(&line, "%s: %s", words[HAWSER_NOT_TRUSTED].text, first->remedy);
    if (more) add(&line, "; and %d more reason%s", more, more > 1 ? "s" : "");
    if (broken > 0) add(&line, "; besides, %d of the limits would be broken", broken);
    text_make_utf8(text); /* a name in a remedy may have been cut */
    return NONE_TRUSTED;
}

int hawser_verdict(int n_conditions, const hawser_condition *condition, int n, const hawser_limit *limit, char *text,
                   size_t size)
{
    return verdict_say(n_conditions, condition, n, limit, 1, text, size);
}
