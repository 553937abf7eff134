/* The head of a logger's file: words of many languages, and units that stand anywhere in a name or below it. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "study/log/log_head.h"

/* Words with blanks around each: such as can only be this, and such as another word beside them explains: "pull speed"
 * is a speed. */
static const struct {
    const char *name;
    Dimension dimension;
    const char *words, *vague;
} kinds[LOG_COLUMNS] = {
    {"force", DIM_FORCE, " force tension zugkraft kraft zuglast fuerza forza trekkracht kracht ",
     " pull load f zug traction effort tiro "},
    {"speed", DIM_SPEED, " speed velocity geschwindigkeit vitesse velocidad snelheid ", " v "},
    {"length", DIM_LENGTH,
     " length distance travel meterage chainage len dist laenge l\xc3\xa4nge weg strecke longueur distancia lengte ",
     " position head station "},
    {"time", DIM_TIME, " time zeit uhrzeit timestamp datetime elapsed seconds temps tiempo tijd ", " t "},
    {"date", DIM_NONE, " date datum fecha ", " "},
};
/* Of several forces that of the winch; of several columns none of what was wanted, or of extremes. */
static const char rather[] = " winch pull zugkraft winde ",
                  rather_not[] = " setpoint set target soll sollwert command limit alarm max maximum peak average ";

/* The next word of a name in small letters; *at moves behind it. 0: there is none. */
static int word_next(const char **at, char word[WORD_MAX])
{
    size_t n = 0;
    while (**at && !isalnum((unsigned char)**at) && (unsigned char)**at < 0x80) ++*at;
    for (; (isalnum((unsigned char)**at) || (unsigned char)**at >= 0x80) && n < WORD_MAX - 1; ++*at)
        word[n++] = (char)tolower((unsigned char)**at);
    word[n] = 0;
    return n > 0;
}

/* Whether one of a name's words is in a list. */
static int has_word(const char *name, const char *list)
{
    char word[WORD_MAX], framed[WORD_MAX + 2];
    while (word_next(&name, word)) {
        snprintf(framed, sizeof framed, " %s ", word);
        if (strstr(list, framed)) return 1;
    }
    return 0;
}

/* Units by other names than a case takes, whatever their letters; loggers weigh forces. */
static const struct UnitName {
    const char *name, *unit;
    double times;
} unit_names[] = {
    {"kg", "kgf", 1},       {"kp", "kgf", 1},        {"lb", "lbf", 1},        {"lbs", "lbf", 1},
    {"newton", "N", 1},     {"newtons", "N", 1},     {"kilonewton", "kN", 1}, {"kilonewtons", "kN", 1},
    {"pound", "lbf", 1},    {"pounds", "lbf", 1},    {"kn", "kN", 1},         {"sec", "s", 1},
    {"secs", "s", 1},       {"second", "s", 1},      {"seconds", "s", 1},     {"sekunden", "s", 1},
    {"min", "min", 1},      {"mins", "min", 1},      {"minute", "min", 1},    {"minutes", "min", 1},
    {"minuten", "min", 1},  {"hr", "h", 1},          {"hrs", "h", 1},         {"hour", "h", 1},
    {"hours", "h", 1},      {"stunden", "h", 1},     {"metre", "m", 1},       {"metres", "m", 1},
    {"meter", "m", 1},      {"meters", "m", 1},      {"ft", "ft", 1},         {"foot", "ft", 1},
    {"feet", "ft", 1},      {"inch", "in", 1},       {"inches", "in", 1},     {"yd", "ft", 3},
    {"yard", "ft", 3},      {"yards", "ft", 3},      {"kilometre", "km", 1},  {"kilometres", "km", 1},
    {"kilometer", "km", 1}, {"kilometers", "km", 1},
};

/* The entry of a word; NULL: there is none. */
static const struct UnitName *unit_name_of(const char *word, size_t length)
{
    for (size_t k = 0; k < sizeof unit_names / sizeof *unit_names; k++) {
        if (strlen(unit_names[k].name) == length && strncasecmp(word, unit_names[k].name, length) == 0)
            return &unit_names[k];
    }
    return NULL;
}

/* Whether a force is weighed in tonnes. */
static int is_tonne(const char *unit)
{
    static const char *const names[] = {"t", "to", "tonne", "tonnes", "tonnen"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (k < 2 ? strcmp(unit, names[k]) == 0 : strcasecmp(unit, names[k]) == 0) return 1;
    }
    return 0;
}

/* How many SI units a unit of a kind is; 0: it is none. */
static double unit_scale(const Units *u, const char *unit, LogColumn kind)
{
    char text[2 * UNIT_TEXT_MAX + 8] = "1 ", why[UNITS_WHY_MAX];
    double scale, times = 1;
    size_t n = 2;
    if (!*unit || strlen(unit) >= UNIT_TEXT_MAX) return 0;
    if (kind == OF_FORCE && strcmp(unit, "daN") == 0) return 10;
    if (kind == OF_FORCE && is_tonne(unit)) return 1000 * UNIT_GRAVITY;
    for (const char *at = unit; *at;) {
        size_t length = 0;
        while (isalpha((unsigned char)at[length])) length++;
        const struct UnitName *const name = unit_name_of(at, length);
        if (name && name->times != 1 && at != unit) return 0;
        if (name) times = name->times * times;
        const size_t size = name ? strlen(name->unit) : length > 0 ? length : 1;
        memcpy(text + n, name ? name->unit : at, size);
        n += size;
        at += length > 0 ? length : 1;
    }
    text[n] = 0;
    return units_read(u, text, kinds[kind].dimension, &scale, why) && scale > 0 ? times * scale : 0;
}

/* A text without blanks around it, and no more than n of it. */
static void unit_trim(const char *text, size_t n, char unit[UNIT_TEXT_MAX])
{
    while (n > 0 && *text == ' ') text++, n--;
    while (n > 0 && text[n - 1] == ' ') n--;
    snprintf(unit, UNIT_TEXT_MAX, "%.*s", (int)n, text);
}

static const char parts[] = "_ /-,:";

/* The unit among a name's words: its end from some word on, "per" a "/"; else one word, "length_ft_raw". 0: none. */
static double words_scale(const Units *u, const char *name, LogColumn kind)
{
    char unit[UNIT_TEXT_MAX] = "";
    double last = unit_scale(u, name, kind);
    for (const char *at = strpbrk(name, parts); at && !(last > 0); at = strpbrk(at + 1, parts)) {
        size_t n = 0;
        for (const char *c = at + 1; *c && n < sizeof unit - 1; n++) {
            const int per = strncmp(c, "_per_", 5) == 0;
            unit[n] = per ? '/' : *c;
            c += per ? 5 : 1;
        }
        unit[n] = 0;
        last = unit_scale(u, unit, kind);
    }
    if (last > 0) return last;
    for (const char *at = strpbrk(name, parts); at; at = strpbrk(at + 1, parts)) {
        unit_trim(at + 1, strcspn(at + 1, parts), unit);
        const double scale = unit_scale(u, unit, kind);
        if (scale > 0) last = scale;
    }
    return last;
}

/* The unit in a name: in the last of its brackets that has one, behind "/" or "in", or among its words. 0: there is
 * none; -1: what stands there as `unit` is none that is known. */
static double head_scale(const Units *u, const char *name, LogColumn kind, char unit[UNIT_TEXT_MAX])
{
    double found = 0;
    for (const char *at = strpbrk(name, "[("); at; at = strpbrk(at + 1, "[(")) {
        char inside[UNIT_TEXT_MAX];
        unit_trim(at + 1, strcspn(at + 1, "])"), inside);
        const double scale = unit_scale(u, inside, kind);
        if (scale > 0) found = scale;
        if (found > 0 || !*inside) continue;
        strcpy(unit, inside);
        found = -1;
    }
    if (found != 0) return found;
    const char *const in = strstr(name, " in "), *const slash = strstr(name, " / ");
    if (!in && !slash) return words_scale(u, name, kind);
    const char *const behind = in ? in + 4 : slash + 3;
    unit_trim(behind, strlen(behind), unit);
    found = unit_scale(u, unit, kind);
    return found > 0 ? found : -1;
}

/* Whether the words of a name are a kind's, and what stands as its unit does not contradict that. */
static int is_kind(const Units *u, const char *name, int kind, const char *words, int with_unit)
{
    char unit[UNIT_TEXT_MAX];
    if (!has_word(name, words)) return 0;
    return !with_unit || (kind != OF_DATE && head_scale(u, name, (LogColumn)kind, unit) > 0);
}

/* What a name is: words that can only be that and have its unit, vague words with their unit, the same without. */
static int kind_of(const Units *u, const char *name)
{
    for (int pass = 0; pass < 4; pass++) {
        for (int k = 0; k < LOG_COLUMNS; k++) {
            if (is_kind(u, name, k, pass % 2 ? kinds[k].vague : kinds[k].words, pass < 2)) return k;
        }
    }
    return LOG_COLUMNS;
}

static int rank_of(const char *name, int kind)
{
    if (has_word(name, rather_not)) return 0;
    return 1 + (kind == OF_FORCE && has_word(name, rather));
}

int head_columns(const Units *u, int n, char *const *name, int column[LOG_COLUMNS])
{
    for (int k = 0; k < LOG_COLUMNS; k++) column[k] = -1;
    for (int c = 0; c < n; c++) {
        const int kind = kind_of(u, name[c]);
        if (kind == LOG_COLUMNS) continue;
        const int taken = column[kind];
        if (taken < 0 || rank_of(name[c], kind) > rank_of(name[taken], kind)) column[kind] = c;
    }
    return column[OF_FORCE] >= 0 && (column[OF_TIME] >= 0 || column[OF_LENGTH] >= 0 || column[OF_DATE] >= 0);
}

/* What a column's unit may be. */
static hawser_status unit_refuse(const LogHead *h, LogColumn kind, const char *unit, const char *place,
                                 hawser_error *err)
{
    static const char *const known[] = {"N, daN, kN, kgf, t, lbf, kip", "m/s, m/min, km/h, ft/min",
                                        "mm, cm, m, km, in, ft, yd", "ms, s, min, h"};
    static const char *const example[] = {"kN", "m/min", "m", "s"};
    char has[UNIT_TEXT_MAX + 40] = "has no unit";
    if (*unit) snprintf(has, sizeof has, "has the unit '%s', which is not known", unit);
    return error_set(err, HAWSER_ERR_INPUT, "%s: column '%.100s' %s: write it into the head, as in '%s [%s]'; %s",
                     place, h->name[h->column[kind]], has, kinds[kind].name, example[kind], known[kind]);
}

/* Whether a head or a unit says "mm:ss". */
static int says_minutes(const char *text)
{
    const char *const colon = strchr(text, ':');
    const int before = colon && colon > text ? tolower((unsigned char)colon[-1]) : 0;
    return (before == 'm' || before == 'n') && tolower((unsigned char)colon[1]) == 's';
}

int head_has_minutes(const LogHead *h)
{
    const int c = h->column[OF_TIME];
    return c >= 0 && (says_minutes(h->name[c]) || (c < h->units && says_minutes(h->unit[c])));
}

/* What stands below a name in the row of units: its scale, 0 where it is no unit; `below`, "" before, is its text if it
 * is no number and no clock. */
static double below_scale(const Units *u, const LogHead *h, LogColumn kind, char below[UNIT_TEXT_MAX])
{
    Marks marks = {.plain = 0};
    const int c = h->column[kind];
    if (c >= h->units || marks_see(&marks, h->unit[c], 0) || !isnan(cell_clock(h->unit[c], 0))) return 0;
    const char *const text = h->unit[c] + strspn(h->unit[c], "[( ");
    unit_trim(text, strcspn(text, "])"), below);
    return unit_scale(u, below, kind);
}

/* A name with a unit and what stands below it: another unit is an error, a word is said, for the name may be none. */
static hawser_status units_agree(const LogHead *h, LogColumn kind, const char *below, double scale, const char *place,
                                 PullLog *log, hawser_error *err)
{
    const char *const name = h->name[h->column[kind]];
    const double other = h->scale[kind];
    if (scale > 0 && fabs(scale - other) > 1e-9 * other) {
        return error_set(err, HAWSER_ERR_INPUT,
                         "%s: column '%.100s' has the unit '%s' below it, and another in its name", place, name, below);
    }
    const int word = strlen(below) > 1 && isalpha((unsigned char)below[0]);
    if (!(scale > 0) && word && kind == OF_FORCE)
        log_say(log, "BEWARE: below '%.80s' stands '%s', which is no unit: is that row the head?", name, below);
    return HAWSER_OK;
}

hawser_status head_unit(const Units *u, LogHead *h, LogColumn kind, int clock, const char *place, PullLog *log,
                        hawser_error *err)
{
    char unit[UNIT_TEXT_MAX] = "", below[UNIT_TEXT_MAX] = "";
    const char *const name = h->name[h->column[kind]];
    const double under = below_scale(u, h, kind, below);
    double *const scale = &h->scale[kind];
    *scale = head_scale(u, name, kind, unit);
    if (*scale > 0) return units_agree(h, kind, below, under, place, log, err);
    *scale = under > 0 ? under : 1;
    if (under > 0 || clock) return HAWSER_OK;
    if (*unit || *below || kind == OF_FORCE || kind == OF_SPEED)
        return unit_refuse(h, kind, *unit ? unit : below, place, err);
    log_say(log, "Column '%.100s' names no unit: taken as %s", name, kind == OF_TIME ? "s" : "m");
    return HAWSER_OK;
}
