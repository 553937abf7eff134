/* A logger's CSV: any of the usual separators, decimal commas, lines before the head, units in the head or below it,
 * times as numbers or as a clock. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "io/yaml/units.h"
#include "io/yaml/yaml_tree.h"
#include "study/log/log.h"

enum { CELLS_MAX = 256, HEAD_WITHIN = 100, WORD_MAX = 64, UNIT_TEXT_MAX = 32 };

/* What a column may be, in the order in which it is asked: "pull_t" is a force. */
typedef enum LogColumn { OF_FORCE, OF_SPEED, OF_LENGTH, OF_TIME, LOG_COLUMNS } LogColumn;

static const struct {
    const char *name;
    Dimension dimension;
    const char *words; /* with blanks around each */
} kinds[LOG_COLUMNS] = {
    {"force", DIM_FORCE,
     " force pull tension load f zugkraft kraft zug zuglast traction effort fuerza tiro forza tiro trekkracht kracht "},
    {"speed", DIM_SPEED, " speed velocity v geschwindigkeit vitesse velocidad snelheid "},
    {"length", DIM_LENGTH,
     " length distance travel position head meterage chainage station len dist laenge l\xc3\xa4nge weg strecke "
     "longueur "
     "distancia lengte "},
    {"time", DIM_TIME, " time t zeit uhrzeit timestamp datetime elapsed seconds temps tiempo tijd "},
};
/* Of several forces that of the winch. */
static const char rather[] = " winch pull zugkraft winde ";

/* A file being read. */
typedef struct Reader {
    const char *path;
    Units *units;
    char separator;
    int line;
    char *cell[CELLS_MAX];
    int n;
    int column[LOG_COLUMNS]; /* -1: there is none */
    double scale[LOG_COLUMNS];
    int minutes; /* clocks of two fields have minutes and seconds */
    hawser_error *err;
} Reader;

static void say(PullLog *log, const char *format, const char *a, const char *b)
{
    if (log->n_notes < LOG_NOTES) snprintf(log->note[log->n_notes++], LOG_NOTE_MAX, format, a, b);
}

/* ----------------------------------------------------------------------------------------------------------- cells */

/* Cuts a line into cells where it stands; blanks around them go. */
static void line_cut(Reader *r, char *at)
{
    r->n = 0;
    for (int more = 1; more && r->n < CELLS_MAX; r->n++) {
        while (*at == ' ' || (*at == '\t' && r->separator != '\t')) at++;
        const int quoted = *at == '"';
        char *const from = at += quoted, *end = at;
        while (*end && *end != (quoted ? '"' : r->separator)) end++;
        at = end + (quoted && *end);
        while (*at && *at != r->separator) at++;
        more = *at != 0;
        at += more;
        *end = 0;
        while (!quoted && end > from && isspace((unsigned char)end[-1])) *--end = 0;
        r->cell[r->n] = from;
    }
}

/* Whichever separator stands most often in the line. */
static char separator_of(const char *line)
{
    static const char all[] = ";\t,|";
    char best = ',';
    int most = 0;
    for (const char *s = all; *s; s++) {
        int n = 0;
        for (const char *c = line; *c; c++) n += *c == *s;
        if (n > most) best = *s;
        if (n > most) most = n;
    }
    return best;
}

/* A number, with a decimal comma where commas do not separate; NAN: none. */
static double cell_value(const Reader *r, const char *cell)
{
    char text[WORD_MAX], why[UNITS_WHY_MAX];
    double value;
    if (!*cell || strlen(cell) >= sizeof text) return NAN;
    strcpy(text, cell);
    char *const comma = strchr(text, ',');
    if (comma && r->separator != ',') *comma = '.';
    return units_read(r->units, text, DIM_NONE, &value, why) ? value : NAN;
}

/* Of a clock of twelve hours that `text` follows: 1 "am", 2 "pm", "p.m.", in either case; 0: it is none. */
static int half_of_day(const char *text)
{
    char word[3] = "";
    size_t n = 0;
    text += strspn(text, " \t");
    for (; isalpha((unsigned char)*text) || (*text == '.' && n > 0); text++) {
        if (*text == '.') continue;
        if (n == 2) return 0;
        word[n++] = (char)tolower((unsigned char)*text);
    }
    return strcmp(word, "am") == 0 ? 1 : strcmp(word, "pm") == 0 ? 2 : 0;
}

/* "10:31:07.5", "1:05 PM", also behind a date, in s; NAN: no clock. minutes: of two fields the first has minutes, not
 * hours, as it has where the second has a fraction, "05:07.5". */
static double cell_clock(const char *cell, int minutes)
{
    const char *const colon = strchr(cell, ':');
    int h, m, used = 0;
    double s = 0, place = 1;
    if (!colon) return NAN;
    const char *from = colon;
    while (from > cell && isdigit((unsigned char)from[-1]) && colon - from < (minutes ? 4 : 2)) from--;
    if (from == colon || sscanf(from, "%4d:%2d%n", &h, &m, &used) < 2) return NAN;
    const char *c = from + used;
    const int two = *c != ':', fraction = (*c == '.' || *c == ',') && isdigit((unsigned char)c[1]);
    if (!two)
        for (c++; isdigit((unsigned char)*c); c++) s = 10 * s + (*c - '0');
    if (*c == '.' || *c == ',')
        for (c++; isdigit((unsigned char)*c); c++) s += (place /= 10) * (*c - '0');
    if (two && (minutes || fraction)) return m < 60 ? 60.0 * h + m + s : NAN;
    const int half = half_of_day(c);
    if (half && (h < 1 || h > 12)) return NAN;
    if (half) h = h % 12 + (half == 2 ? 12 : 0);
    return h < 24 && m < 60 && s < 61 ? 3600.0 * h + 60.0 * m + s : NAN;
}

/* ------------------------------------------------------------------------------------------------------------ head */

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
    {"kg", "kgf", 1},       {"kp", "kgf", 1},        {"lb", "lbf", 1},       {"lbs", "lbf", 1},
    {"kn", "kN", 1},        {"sec", "s", 1},         {"secs", "s", 1},       {"second", "s", 1},
    {"seconds", "s", 1},    {"sekunden", "s", 1},    {"min", "min", 1},      {"mins", "min", 1},
    {"minute", "min", 1},   {"minutes", "min", 1},   {"minuten", "min", 1},  {"hr", "h", 1},
    {"hrs", "h", 1},        {"hour", "h", 1},        {"hours", "h", 1},      {"stunden", "h", 1},
    {"metre", "m", 1},      {"metres", "m", 1},      {"meter", "m", 1},      {"meters", "m", 1},
    {"ft", "ft", 1},        {"foot", "ft", 1},       {"feet", "ft", 1},      {"inch", "in", 1},
    {"inches", "in", 1},    {"yd", "ft", 3},         {"yard", "ft", 3},      {"yards", "ft", 3},
    {"kilometre", "km", 1}, {"kilometres", "km", 1}, {"kilometer", "km", 1}, {"kilometers", "km", 1},
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

/* How many SI units a unit of a kind is; 0: it is none. */
static double unit_scale(const Reader *r, const char *unit, LogColumn kind)
{
    char text[2 * UNIT_TEXT_MAX + 8] = "1 ", why[UNITS_WHY_MAX];
    double scale, times = 1;
    size_t n = 2;
    if (!*unit || strlen(unit) >= UNIT_TEXT_MAX) return 0;
    if (kind == OF_FORCE && strcmp(unit, "daN") == 0) return 10;
    if (kind == OF_FORCE && (strcmp(unit, "t") == 0 || strcmp(unit, "to") == 0)) return 1000 * UNIT_GRAVITY;
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
    return units_read(r->units, text, kinds[kind].dimension, &scale, why) && scale > 0 ? times * scale : 0;
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
static double words_scale(const Reader *r, const char *name, LogColumn kind)
{
    char unit[UNIT_TEXT_MAX];
    double last = unit_scale(r, name, kind);
    for (const char *at = strpbrk(name, parts); at && !(last > 0); at = strpbrk(at + 1, parts)) {
        size_t n = 0;
        for (const char *c = at + 1; *c && n < sizeof unit - 1; n++) {
            const int per = strncmp(c, "_per_", 5) == 0;
            unit[n] = per ? '/' : *c;
            c += per ? 5 : 1;
        }
        unit[n] = 0;
        last = unit_scale(r, unit, kind);
    }
    if (last > 0) return last;
    for (const char *at = strpbrk(name, parts); at; at = strpbrk(at + 1, parts)) {
        unit_trim(at + 1, strcspn(at + 1, parts), unit);
        const double scale = unit_scale(r, unit, kind);
        if (scale > 0) last = scale;
    }
    return last;
}

/* The unit in a name: in the last of its brackets that has one, behind "/" or "in", or among its words. 0: there is
 * none; -1: what stands there as `unit` is none that is known. */
static double head_scale(const Reader *r, const char *name, LogColumn kind, char unit[UNIT_TEXT_MAX])
{
    double found = 0;
    for (const char *at = strpbrk(name, "[("); at; at = strpbrk(at + 1, "[(")) {
        char inside[UNIT_TEXT_MAX];
        unit_trim(at + 1, strcspn(at + 1, "])"), inside);
        const double scale = unit_scale(r, inside, kind);
        if (scale > 0) found = scale;
        if (found > 0 || !*inside) continue;
        strcpy(unit, inside);
        found = -1;
    }
    if (found != 0) return found;
    const char *const in = strstr(name, " in "), *const slash = strstr(name, " / ");
    if (!in && !slash) return words_scale(r, name, kind);
    const char *const behind = in ? in + 4 : slash + 3;
    unit_trim(behind, strlen(behind), unit);
    found = unit_scale(r, unit, kind);
    return found > 0 ? found : -1;
}

/* Which column is what; whether there is a force and something that it is over. */
static int head_read(Reader *r)
{
    for (int k = 0; k < LOG_COLUMNS; k++) r->column[k] = -1;
    for (int c = 0; c < r->n; c++) {
        int kind = 0;
        while (kind < LOG_COLUMNS && !has_word(r->cell[c], kinds[kind].words)) kind++;
        if (kind == LOG_COLUMNS) continue;
        const int taken = r->column[kind];
        const int better =
            taken >= 0 && kind == OF_FORCE && has_word(r->cell[c], rather) && !has_word(r->cell[taken], rather);
        if (taken < 0 || better) r->column[kind] = c;
    }
    return r->column[OF_FORCE] >= 0 && (r->column[OF_TIME] >= 0 || r->column[OF_LENGTH] >= 0);
}

/* Head and units as they stand. */
typedef struct Head {
    int line, names, units; /* cells of the row of names, of that of units; 0: not there */
    char *name[CELLS_MAX], *unit[CELLS_MAX];
} Head;

/* What a column's unit may be. */
static hawser_status unit_refuse(const Reader *r, const Head *h, LogColumn kind, const char *unit)
{
    static const char *const known[LOG_COLUMNS] = {"N, daN, kN, kgf, t, lbf, kip", "m/s, m/min, km/h, ft/min",
                                                   "mm, cm, m, km, in, ft, yd", "ms, s, min, h"};
    static const char *const example[LOG_COLUMNS] = {"kN", "m/min", "m", "s"};
    char place[CASE_PLACE_MAX], has[UNIT_TEXT_MAX + 40] = "has no unit";
    if (*unit) snprintf(has, sizeof has, "has the unit '%s', which is not known", unit);
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: column '%.100s' %s: write it into the head, as in '%s [%s]'; %s",
                     case_place(r->path, h->line, place), h->name[r->column[kind]], has, kinds[kind].name,
                     example[kind], known[kind]);
}

/* Whether a head or a unit says "mm:ss". */
static int says_minutes(const char *text)
{
    const char *const colon = strchr(text, ':');
    const int before = colon && colon > text ? tolower((unsigned char)colon[-1]) : 0;
    return (before == 'm' || before == 'n') && tolower((unsigned char)colon[1]) == 's';
}

/* Times that are a clock, by its first reading. */
static int clock_find(Reader *r, const Head *h, PullLog *log)
{
    const int c = r->column[OF_TIME];
    const char *const cell = c < r->n ? r->cell[c] : "", *const colon = strchr(cell, ':');
    r->minutes = says_minutes(h->name[c]) || (c < h->units && says_minutes(h->unit[c]));
    const double clock = cell_clock(cell, r->minutes);
    if (isnan(clock)) return 0;
    if (!strchr(colon + 1, ':') && !r->minutes && clock == cell_clock(cell, 0) && clock != cell_clock(cell, 1))
        say(log,
            "Times like '%.20s' are taken as hours and minutes: 'mm:ss' in the head makes them minutes and seconds%s",
            cell, "");
    return 1;
}

/* The scale of a column from the head, or the row of units. A clock needs none, whatever stands there. */
static hawser_status unit_find(Reader *r, const Head *h, LogColumn kind, PullLog *log)
{
    char unit[UNIT_TEXT_MAX] = "", below[UNIT_TEXT_MAX] = "";
    const int c = r->column[kind], clock = kind == OF_TIME && clock_find(r, h, log);
    double *const scale = &r->scale[kind];
    *scale = head_scale(r, h->name[c], kind, unit);
    if (*scale > 0) return HAWSER_OK;
    if (c < h->units && isnan(cell_value(r, h->unit[c])) && isnan(cell_clock(h->unit[c], 0))) {
        const char *const text = h->unit[c] + strspn(h->unit[c], "[( ");
        unit_trim(text, strcspn(text, "])"), below);
    }
    *scale = unit_scale(r, below, kind);
    if (*scale > 0) return HAWSER_OK;
    *scale = 1;
    if (clock) return HAWSER_OK;
    if (*unit || *below || kind == OF_FORCE || kind == OF_SPEED) return unit_refuse(r, h, kind, *unit ? unit : below);
    say(log, "Column '%.100s' names no unit: taken as %s", h->name[c], kind == OF_TIME ? "s" : "m");
    return HAWSER_OK;
}

/* The units of all columns, at the first reading. */
static hawser_status units_find(Reader *r, const Head *h, PullLog *log)
{
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < LOG_COLUMNS && !status; k++) {
        if (r->column[k] >= 0) status = unit_find(r, h, (LogColumn)k, log);
    }
    say(log, "Force from column '%.80s'%s", h->name[r->column[OF_FORCE]], "");
    return status;
}

/* -------------------------------------------------------------------------------------------------------- readings */

static double column_value(const Reader *r, LogColumn kind)
{
    const int c = r->column[kind];
    if (c < 0 || c >= r->n) return NAN;
    const double clock = kind == OF_TIME ? cell_clock(r->cell[c], r->minutes) : NAN;
    return isnan(clock) ? cell_value(r, r->cell[c]) * r->scale[kind] : clock;
}

static void reading_take(const Reader *r, PullLog *log)
{
    const long i = log->n++;
    log->force[i] = column_value(r, OF_FORCE);
    log->time[i] = column_value(r, OF_TIME);
    log->length[i] = column_value(r, OF_LENGTH);
    log->speed[i] = column_value(r, OF_SPEED);
    /* past midnight */
    if (i > 0 && log->time[i - 1] - log->time[i] > 43200 && log->time[i] < 43200) log->time[i] += 86400;
}

static hawser_status log_alloc(PullLog *log, long n, hawser_error *err)
{
    const size_t bytes = ((size_t)n + 1) * sizeof(double);
    log->time = malloc(bytes);
    log->length = malloc(bytes);
    log->speed = malloc(bytes);
    log->force = malloc(bytes);
    log->use = calloc((size_t)n + 1, 1);
    return log->time && log->length && log->speed && log->force && log->use ? HAWSER_OK : error_memory(err);
}

void log_free(PullLog *log)
{
    free(log->time);
    free(log->length);
    free(log->speed);
    free(log->force);
    free(log->use);
    *log = (PullLog){.n = 0};
}

/* The next line, without its end; NULL: there are no more. */
static char *line_next(char **at)
{
    char *const line = *at;
    if (!line || !*line) return NULL;
    const size_t n = strcspn(line, "\r\n");
    *at = line + n + (line[n] != 0) + (line[n] == '\r' && line[n + 1] == '\n');
    line[n] = 0;
    return line;
}

/* Whether a row below the head has the units: a text where the force is. */
static int has_units(const Reader *r)
{
    const int force = r->column[OF_FORCE];
    return force < r->n && isnan(cell_value(r, r->cell[force])) && *r->cell[force];
}

/* All lines: head, units, readings. */
static hawser_status lines_read(Reader *r, char *text, PullLog *log)
{
    char *line, place[CASE_PLACE_MAX];
    Head h = {.names = 0};
    hawser_status status = HAWSER_OK;
    while (!status && (line = line_next(&text))) {
        r->line++;
        if (!*line || *line == '#') continue;
        if (h.names == 0 && r->line > HEAD_WITHIN) break;
        if (h.names == 0) r->separator = separator_of(line);
        line_cut(r, line);
        if (h.names == 0) {
            if (!head_read(r)) continue;
            h.line = r->line;
            h.names = r->n;
            memcpy(h.name, r->cell, sizeof h.name);
        } else if (log->n == 0 && h.units == 0 && has_units(r)) {
            h.units = r->n;
            memcpy(h.unit, r->cell, sizeof h.unit);
        } else {
            if (log->n == 0) status = units_find(r, &h, log);
            if (!status) reading_take(r, log);
        }
    }
    if (status) return status;
    if (h.names == 0) {
        return error_set(r->err, HAWSER_ERR_INPUT,
                         "%.700s: no row names a force and a time or a length, as 'time [s]; pull [kN]' does", r->path);
    }
    if (log->n > 0) return HAWSER_OK;
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: no readings below the head", case_place(r->path, r->line, place));
}

hawser_status log_read(const char *path, PullLog *log, hawser_error *err)
{
    Reader r = {.path = path, .units = units_new(), .err = err};
    char *text = NULL;
    size_t size;
    long lines = 1;
    *log = (PullLog){.n = 0};
    hawser_status status = r.units ? case_file_read(path, &text, &size, err) : error_memory(err);
    for (const char *c = text; !status && *c; c++) lines += *c == '\n' || *c == '\r';
    if (!status) status = log_alloc(log, lines, err);
    if (!status) status = lines_read(&r, text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0), log);
    if (!status) {
        log->has_time = r.column[OF_TIME] >= 0;
        log->has_length = r.column[OF_LENGTH] >= 0;
        log->has_speed = r.column[OF_SPEED] >= 0;
    }
    free(text);
    units_free(r.units);
    if (status) log_free(log);
    return status;
}
