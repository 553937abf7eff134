/* A logger's CSV: any of the usual separators, decimal commas, lines before the head, units in the head or below it,
 * times as numbers or as a clock. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

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

/* "10:31:07.5", "1:05 PM", also behind a date, in s; NAN: no clock. */
static double cell_clock(const char *cell)
{
    const char *const colon = strchr(cell, ':');
    int h, m, used = 0;
    double s = 0;
    if (!colon || colon == cell || !isdigit((unsigned char)colon[-1])) return NAN;
    const char *from = colon - 1;
    if (from > cell && isdigit((unsigned char)from[-1])) from--;
    if (sscanf(from, "%2d:%2d%n", &h, &m, &used) < 2) return NAN;
    const char *c = from + used;
    if (*c == ':') {
        double place = 1;
        c++;
        for (; isdigit((unsigned char)*c); c++) s = 10 * s + (*c - '0');
        if (*c == '.' || *c == ',')
            for (c++; isdigit((unsigned char)*c); c++) s += (place /= 10) * (*c - '0');
    }
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

/* How many SI units a unit of a kind is; 0: it is none. Loggers weigh forces. */
static double unit_scale(const Reader *r, const char *unit, LogColumn kind)
{
    static const char *const other[][2] = {{"kg", "kgf"},  {"kp", "kgf"},  {"lb", "lbf"}, {"lbs", "lbf"},
                                           {"KN", "kN"},   {"kn", "kN"},   {"sec", "s"},  {"Sekunden", "s"},
                                           {"meter", "m"}, {"metres", "m"}};
    char text[UNIT_TEXT_MAX + 8], why[UNITS_WHY_MAX];
    double scale;
    if (!*unit || strlen(unit) >= UNIT_TEXT_MAX) return 0;
    if (kind == OF_FORCE && strcmp(unit, "daN") == 0) return 10;
    if (kind == OF_FORCE && (strcmp(unit, "t") == 0 || strcmp(unit, "to") == 0)) return 1000 * UNIT_GRAVITY;
    for (size_t k = 0; k < sizeof other / sizeof *other; k++) {
        if (strcmp(unit, other[k][0]) == 0) unit = other[k][1];
    }
    snprintf(text, sizeof text, "1 %s", unit);
    return units_read(r->units, text, kinds[kind].dimension, &scale, why) && scale > 0 ? scale : 0;
}

/* The unit in a name: in brackets, behind "/" or "in", or its last words behind "_", "per" a "/"; 0: there is none. */
static double head_scale(const Reader *r, const char *name, LogColumn kind)
{
    char unit[UNIT_TEXT_MAX] = "";
    const size_t open = strcspn(name, "[(");
    if (name[open]) {
        snprintf(unit, sizeof unit, "%.*s", (int)strcspn(name + open + 1, "])"), name + open + 1);
        return unit_scale(r, unit, kind);
    }
    const char *const in = strstr(name, " in "), *const slash = strstr(name, " / ");
    if (in || slash) return unit_scale(r, in ? in + 4 : slash + 3, kind);
    for (const char *at = strpbrk(name, "_ "); at; at = strpbrk(at + 1, "_ ")) {
        size_t n = 0;
        for (const char *c = at + 1; *c && n < sizeof unit - 1; n++) {
            const int per = strncmp(c, "_per_", 5) == 0;
            unit[n] = per ? '/' : *c;
            c += per ? 5 : 1;
        }
        unit[n] = 0;
        const double scale = unit_scale(r, unit, kind);
        if (scale > 0) return scale;
    }
    return 0;
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

/* The units of the columns from the head, or from the row below it where that has no number; *below: it was read so. */
static hawser_status units_find(Reader *r, char *const name[CELLS_MAX], int names, PullLog *log, int *below)
{
    char place[CASE_PLACE_MAX];
    const int force = r->column[OF_FORCE];
    *below = force < r->n && isnan(cell_value(r, r->cell[force])) && *r->cell[force];
    for (int k = 0; k < LOG_COLUMNS; k++) {
        const int c = r->column[k];
        if (c < 0 || c >= names) continue;
        char unit[UNIT_TEXT_MAX] = "";
        if (*below && c < r->n) {
            const char *const text = r->cell[c] + strspn(r->cell[c], "[( ");
            snprintf(unit, sizeof unit, "%.*s", (int)strcspn(text, "])"), text);
        }
        r->scale[k] = head_scale(r, name[c], (LogColumn)k);
        if (r->scale[k] == 0) r->scale[k] = unit_scale(r, unit, (LogColumn)k);
        if (r->scale[k] > 0) continue;
        r->scale[k] = 1;
        if (k == OF_TIME && c < r->n && !*below && isfinite(cell_clock(r->cell[c]))) continue;
        if (k == OF_FORCE || k == OF_SPEED) {
            return error_set(r->err, HAWSER_ERR_INPUT,
                             "%s: column '%.100s' has no unit that is known: write it into the head, as in '%s [%s]'",
                             case_place(r->path, r->line, place), name[c], kinds[k].name, k ? "m/min" : "kN");
        }
        say(log, "Column '%.100s' names no unit: taken as %s", name[c], k == OF_TIME ? "s" : "m");
    }
    say(log, "Force from column '%.80s'%s", name[force], "");
    return HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------------- readings */

static double column_value(const Reader *r, LogColumn kind)
{
    const int c = r->column[kind];
    if (c < 0 || c >= r->n) return NAN;
    const double clock = kind == OF_TIME ? cell_clock(r->cell[c]) : NAN;
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

/* All lines: head, units, readings. */
static hawser_status lines_read(Reader *r, char *text, PullLog *log)
{
    char *name[CELLS_MAX], *line, place[CASE_PLACE_MAX];
    int names = 0, units = 0, below = 0;
    hawser_status status = HAWSER_OK;
    while (!status && (line = line_next(&text))) {
        r->line++;
        if (!*line || *line == '#') continue;
        if (names == 0 && r->line > HEAD_WITHIN) break;
        if (names == 0) r->separator = separator_of(line);
        line_cut(r, line);
        if (names == 0 && head_read(r)) {
            names = r->n;
            memcpy(name, r->cell, sizeof name);
        } else if (names > 0 && !units) {
            units = 1;
            status = units_find(r, name, names, log, &below);
            if (!status && !below) reading_take(r, log);
        } else if (names > 0) {
            reading_take(r, log);
        }
    }
    if (status) return status;
    if (names == 0) {
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
