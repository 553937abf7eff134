/* Notes of a measured pull, and its points. */
#include "study/log.h"

#include <ctype.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/error.h"
#include "io/case/yaml.h"

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

/* Lines, cells and numbers of a logger's file: separators, decimal marks, marks between thousands. */

/* ----------------------------------------------------------------------------------------------------------- lines */

/* Returns the next line without its end, and advances *at; NULL: there are no more. */
static char *line_next(char **at)
{
    char *const line = *at;
    if (!line || !*line) return NULL;
    const size_t n = strcspn(line, "\r\n");
    *at = line + n + (line[n] != 0) + (line[n] == '\r' && line[n + 1] == '\n');
    line[n] = 0;
    return line;
}

/* Number of cells of a line that ends with a line end or the text, without empty ones at its end. */
static int cells_of(const char *line, char separator)
{
    int n = 1, filled = 0, quoted = 0;
    for (; *line && (quoted || (*line != '\n' && *line != '\r')); line++) {
        quoted ^= *line == '"';
        n += *line == separator && !quoted;
        if (*line != separator && *line != ' ') filled = n;
    }
    return filled;
}

/* Checks for a separator in a line outside quotes. */
static int has_separator(const char *line, char separator)
{
    int quoted = 0;
    for (; *line; line++) {
        quoted ^= *line == '"';
        if (*line == separator && !quoted) return 1;
    }
    return 0;
}

/* Finds the separator of a line's cells: of ';', tab, '|' and ',' outside quotes the first with equal counts in this
 * line and the next one of `rest`, else the first that occurs; commas may be decimal, or part of names. */
static char separator_of(const char *line, const char *rest)
{
    static const char all[] = ";\t|,";
    char first = ',';
    rest += strspn(rest, "\r\n");
    for (const char *s = all + 3; s >= all; s--) {
        if (has_separator(line, *s)) first = *s;
    }
    for (const char *s = all; *s; s++) {
        if (has_separator(line, *s) && cells_of(line, *s) > 1 && cells_of(line, *s) == cells_of(rest, *s)) return *s;
    }
    return first;
}

int line_cut(char *line, char separator, char *cell[CELLS_MAX])
{
    char *at = line;
    int n = 0;
    for (int more = 1; more && n < CELLS_MAX; n++) {
        while (*at == ' ' || (*at == '\t' && separator != '\t')) at++;
        const int quoted = *at == '"';
        char *const from = at += quoted, *end = at;
        while (*end && *end != (quoted ? '"' : separator)) end++;
        at = end + (quoted && *end);
        while (*at && *at != separator) at++;
        more = *at != 0;
        at += more;
        *end = 0;
        while (!quoted && end > from && isspace((unsigned char)end[-1])) *--end = 0;
        cell[n] = from;
    }
    return n;
}

/* Number of cells up to the last that is not empty. */
static int cells_filled(int n, char *const *cell)
{
    while (n > 0 && !*cell[n - 1]) n--;
    return n;
}

/* --------------------------------------------------------------------------------------------------------- numbers */

/* Notation of a number. */
typedef struct Shape {
    char text[WORD_MAX];        /* sign, digits, marks; ' for blanks and apostrophes */
    size_t body;                /* its first digit or mark */
    size_t end;                 /* its exponent, or its end */
    char decimal, mark, either; /* '.' or ',': the decimal mark, the thousands mark, one that may be either; 0: none */
    int digits;
} Shape;

/* Matches a substitute for a thousands mark or a minus: returns its number of bytes; *as is the replacement. */
static size_t sign_at(const char *c, char *as)
{
    static const struct {
        const char *bytes;
        char as;
    } signs[] = {{"\xc2\xa0", '\''},     {"\xe2\x80\xaf", '\''}, {"\xe2\x80\x89", '\''},
                 {"\xe2\x80\x99", '\''}, {"\xe2\x88\x92", '-'},  {" ", '\''}};
    for (size_t k = 0; k < sizeof signs / sizeof *signs; k++) {
        const size_t n = strlen(signs[k].bytes);
        if (strncmp(c, signs[k].bytes, n) != 0) continue;
        *as = signs[k].as;
        return n;
    }
    *as = *c;
    return 1;
}

/* Checks whether n bytes are groups of three digits, the first of one to three and not beginning with 0, separated by
 * the mark. */
static int is_grouped(const char *text, size_t n, char mark)
{
    size_t in = 0, groups = 0;
    if (*text == '0') return 0;
    for (size_t i = 0; i < n; i++) {
        if (isdigit((unsigned char)text[i])) {
            if (++in > 3) return 0;
            continue;
        }
        if (text[i] != mark || in == 0 || (groups > 0 && in != 3)) return 0;
        groups++;
        in = 0;
    }
    return groups > 0 && in == 3;
}

/* Finds the possible roles of a number's marks. Returns 0 if it is not a number. */
static int marks_find(Shape *s)
{
    const char *const body = s->text + s->body;
    const size_t n = s->end - s->body;
    size_t count[3] = {0}, last[3] = {0};
    static const char all[] = ".,'";
    for (size_t i = 0; i < n; i++) {
        const char *const k = strchr(all, body[i]);
        if (!k) continue;
        count[k - all]++;
        last[k - all] = i;
    }
    const int both = count[0] > 0 && count[1] > 0;
    if (count[2] > 0 || both) { /* the last is the decimal mark, the other the thousands mark */
        const int d = both ? last[1] > last[0] : count[1] > 0, t = count[2] > 0 ? 2 : !d;
        if ((both && count[2] > 0) || count[d] > 1) return 0;
        s->mark = all[t];
        s->decimal = count[d] > 0 ? all[d] : 0;
        return is_grouped(body, count[d] > 0 ? last[d] : n, all[t]);
    }
    const int m = count[1] > 0;
    if (count[m] == 0) return 1;
    const int grouped = is_grouped(body, n, all[m]);
    if (count[m] > 1) s->mark = all[m];
    if (count[m] == 1 && grouped && !s->text[s->end]) s->either = all[m];
    if (count[m] == 1 && !s->either) s->decimal = all[m];
    return count[m] == 1 || grouped;
}

/* Analyses a cell; returns 0 if it is not a number. */
static int shape_of(const char *cell, Shape *s)
{
    size_t n = 0;
    *s = (Shape){.digits = 0};
    while (*cell && n < sizeof s->text - 1) {
        cell += sign_at(cell, &s->text[n]);
        if (s->text[n] != '\'' || (n > 0 && isdigit((unsigned char)s->text[n - 1]))) n++;
    }
    while (n > 0 && s->text[n - 1] == '\'') n--;
    s->text[n] = 0;
    s->body = s->text[0] == '-' || s->text[0] == '+';
    s->end = s->body + strspn(s->text + s->body, "0123456789.,'");
    for (size_t i = s->body; i < s->end; i++) s->digits += isdigit((unsigned char)s->text[i]) != 0;
    const char *e = s->text + s->end;
    if (*cell || s->digits == 0) return 0;
    if (*e == 'e' || *e == 'E') {
        e += 1 + (e[1] == '-' || e[1] == '+');
        if (!*e) return 0;
        e += strspn(e, "0123456789");
    }
    return !*e && marks_find(s);
}

/* Counts a cell. Returns whether it is a number: a sign, digits with marks, an exponent. Blanks (also non-breaking
 * ones) and apostrophes are thousands marks. */
static int marks_see(Marks *m, const char *cell, int line)
{
    Shape s;
    if (!shape_of(cell, &s)) return 0;
    for (int k = 0; k < 2; k++) {
        const char mark = k ? ',' : '.';
        m->decimal[k] += s.decimal == mark;
        m->thousands[k] += s.mark == mark;
        if (s.either != mark) continue;
        if (m->either[k]++ > 0) continue;
        m->first[k] = cell;
        m->line[k] = line;
    }
    m->plain += !s.decimal && !s.mark && !s.either;
    m->digits += !s.decimal && !s.mark && !s.either && s.digits > 3;
    return 1;
}

/* Number in a cell; thousands[2]: whether a mark that may be either is a thousands mark. NAN: not a number. */
static double log_cell_number(const Units *units, const char *cell, const int thousands[2])
{
    char why[UNITS_WHY_MAX];
    double value;
    size_t n = 0;
    Shape s;
    if (!shape_of(cell, &s)) return NAN;
    const char drop = s.either && thousands[s.either == ','] ? s.either : s.mark;
    for (const char *c = s.text + (s.text[0] == '+'); *c; c++) {
        if (drop && *c == drop) continue;
        s.text[n++] = *c;
        if (s.text[n - 1] == ',') s.text[n - 1] = '.';
    }
    s.text[n] = 0;
    return units_read(units, s.text, DIM_NONE, &value, why) ? value : NAN;
}

/* Clocks and dates of a logger's file: seconds of the day, days of the calendar, and midnights. */

/* Falls of a clock by more than this are midnights, s; a rise within it is a continuation. */
static const double FALL = 300, HOUR = 3600, DAY = 86400;

/* Half of the day after a twelve-hour clock: 1 "am", 2 "pm", "p.m.", in either case; 0: none. */
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

/* Reads "10:31:07.5", "1:05 PM", also after a date, in s; NAN: not a clock. minutes: the first of two fields is
 * minutes, not hours, as it is if the second has a fraction, "05:07.5". */
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
    const int half = half_of_day(c);
    if (isalpha((unsigned char)*c) && *c != 'Z' && !half) return NAN;
    if (two && (minutes || fraction)) return m < 60 ? 60.0 * h + m + s : NAN;
    if (half && (h < 1 || h > 12)) return NAN;
    if (half) h = h % 12 + (half == 2 ? 12 : 0);
    return h < 24 && m < 60 && s < 61 ? HOUR * h + 60.0 * m + s : NAN;
}

/* ----------------------------------------------------------------------------------------------------------- dates */

/* Number of a month, 1 to 12, by the first three letters of its English or German name; 0: none. */
static int month_of(const char *word)
{
    static const char *const names[] = {"jan", "feb", "mar", "apr", "may", "jun", "jul", "aug",
                                        "sep", "oct", "nov", "dec", "mrz", "mai", "okt", "dez"};
    static const int month[] = {1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 3, 5, 10, 12};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (strncasecmp(word, names[k], 3) == 0) return month[k];
    }
    return 0;
}

/* Calendar days up to a date; NAN: there is no such date. */
static double days_of(int year, int month, int day)
{
    static const int before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};
    if (year < 0 || year > 9999 || month < 1 || month > 12 || day < 1) return NAN;
    if (year < 100) year += 2000;
    const int leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0, y = year - 1;
    if (day > before[month] - before[month - 1] + (leap && month == 2)) return NAN;
    return 365.0 * y + y / 4 - y / 100 + y / 400 + before[month - 1] + (leap && month > 2) + day;
}

/* Day of a date such as 2026-11-26, 26.11.2026, 26-Nov-2026, 20261126, or 11/26/2026 and 26/11/2026, for which
 * month_first gives the order. NAN: not a date. */
static double date_days(const char *text, int month_first)
{
    int number[3], n = 0, month = 0, digits[3], point = 0;
    const char *const colon = strchr(text, ':');
    const char *end = colon ? colon : text + strlen(text);
    while (colon && end > text && isdigit((unsigned char)end[-1])) end--;
    for (const char *c = text; c < end;) {
        const char *const from = c;
        while (c < end && isdigit((unsigned char)*c)) c++;
        if (c > from) {
            if (n == 3 || c - from > 8) return NAN;
            digits[n] = (int)(c - from);
            number[n] = (int)strtol(from, NULL, 10);
            if (n++ == 0) point = *c == '.';
            continue;
        }
        while (c < end && isalpha((unsigned char)*c)) c++;
        if (c - from >= 3 && month == 0) month = month_of(from);
        if (c == from) c++;
    }
    if (n == 1 && digits[0] == 8) return days_of(number[0] / 10000, number[0] / 100 % 100, number[0] % 100);
    if (n == 2 && month && digits[0] == 4) return days_of(number[0], month, number[1]);
    if (n == 2 && month) return days_of(number[1], month, number[0]);
    if (n != 3) return NAN;
    if (digits[0] == 4) return days_of(number[0], number[1], number[2]);
    if (point || !month_first) return days_of(number[2], number[1], number[0]);
    return days_of(number[2], number[0], number[1]);
}

/* Agreement of dates with an order of day and month. */
typedef struct DateFit {
    long read, falls;
    double first, span; /* the first day; days from the least to the largest */
} DateFit;

static DateFit dates_fit(long n, const char *const *date, int month_first)
{
    DateFit f = {0, 0, NAN, 0};
    double last = NAN, least = INFINITY, most = -INFINITY;
    for (long i = 0; i < n; i++) {
        const double day = date_days(date[i], month_first);
        if (isnan(day)) continue;
        if (f.read++ == 0) f.first = day;
        f.falls += day < last;
        last = day;
        least = fmin(least, day);
        most = fmax(most, day);
    }
    f.span = f.read > 0 ? most - least : 0;
    return f;
}

/* -------------------------------------------------------------------------------------------------------- midnights */

/* Progress of the clock. */
typedef struct Course {
    double last, offset; /* s: the last valid time; offset of the clock */
    long midnights, halves;
} Course;

/* Checks whether the time after reading i continues the last time but not reading i. */
static int is_astray(const PullLog *log, const Course *c, long i)
{
    const double t = c->offset + log->time[i];
    long j = i + 1;
    while (j < log->n && isnan(log->time[j])) j++;
    if (j == log->n || isnan(c->last) || isnan(t)) return 0;
    const double next = c->offset + log->time[j];
    return next >= c->last && next - c->last < FALL && (t < c->last - FALL || t > next + FALL);
}

/* Moves a clock that has fallen past midnight, a twelve-hour clock past noon, one of minutes past the hour. */
static void course_go_on(Course *c, double clock, int minutes)
{
    const double fall = c->last - c->offset - clock;
    if (!(fall > FALL)) return;
    if (minutes) {
        if (fall <= HOUR && HOUR - fall < FALL) c->offset += HOUR;
    } else if (fall <= DAY / 2 && DAY / 2 - fall < FALL) {
        c->offset += DAY / 2;
        c->halves++;
    } else {
        c->offset += ceil(fall / DAY) * DAY;
        c->midnights++;
    }
}

/* Reports the interpretation of the clock. */
static void course_say(const Course *c, PullLog *log)
{
    if (c->midnights > 0)
        log_say(log, "Falls of the clock without a later date are taken for midnights: %ld", c->midnights);
    if (c->halves > 0)
        log_say(log, "The clock is taken for one of twelve hours: times it falls by them and goes on: %ld", c->halves);
}

/* Adds days to log->time, which has clocks, by date[n] ("" if there is none, or text before the clock): times continue
 * over midnights, by the dates if they change, else by falls of the clock. A stamp that the next one does not continue
 * is left unchanged. minutes: as above, then by hours. Errors: MEMORY. */
static hawser_status clocks_go_on(PullLog *log, const char *const *date, int minutes, hawser_error *err)
{
    double *const time = malloc(((size_t)log->n + 1) * sizeof *time);
    if (!time) return error_memory(err);
    const DateFit fit[2] = {dates_fit(log->n, date, 0), dates_fit(log->n, date, 1)};
    const DateFit *const a = &fit[0], *const b = &fit[1];
    const int month_first = a->read != b->read     ? b->read > a->read
                            : a->falls != b->falls ? b->falls < a->falls
                                                   : b->span < a->span;
    const int dated = fit[month_first].span > 0;
    if (dated && a->read == b->read && a->span != b->span) {
        long i = 0;
        while (isnan(date_days(date[i], 0))) i++;
        log_say(log, "Dates like '%.20s' are taken as %s first", date[i], month_first ? "month" : "day");
    }
    Course c = {.last = NAN};
    for (long i = 0; i < log->n; i++) {
        const double day = dated ? date_days(date[i], month_first) - fit[month_first].first : NAN;
        time[i] = NAN;
        if (isnan(log->time[i])) continue;
        if (!isnan(day)) c.offset = day * DAY;
        const int astray = isnan(day) && is_astray(log, &c, i);
        if (isnan(day) && !astray) course_go_on(&c, log->time[i], minutes);
        time[i] = c.offset + log->time[i];
        if (!astray) c.last = time[i];
    }
    course_say(&c, log);
    memcpy(log->time, time, (size_t)log->n * sizeof *time);
    free(time);
    return HAWSER_OK;
}

/* The head of a logger's file: words of many languages, and units anywhere in a name or below it. */

/* Words with blanks around each: unambiguous ones, and vague ones that another word may override: "pull speed" is a
 * speed. */
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

/* Words that mark the winch's force among several forces; words for setpoints and extremes, which are avoided among
 * several columns. */
static const char rather[] = " winch pull zugkraft winde ",
                  rather_not[] = " setpoint set target soll sollwert command limit alarm max maximum peak average ";

/* Reads the next word of a name in lower case and advances *at. Returns 0 if there is none. */
static int word_next(const char **at, char word[WORD_MAX])
{
    size_t n = 0;
    while (**at && !isalnum((unsigned char)**at) && (unsigned char)**at < 0x80) ++*at;
    for (; (isalnum((unsigned char)**at) || (unsigned char)**at >= 0x80) && n < WORD_MAX - 1; ++*at)
        word[n++] = (char)tolower((unsigned char)**at);
    word[n] = 0;
    return n > 0;
}

/* Checks whether one of a name's words is in a list. */
static int has_word(const char *name, const char *list)
{
    char word[WORD_MAX], framed[WORD_MAX + 2];
    while (word_next(&name, word)) {
        snprintf(framed, sizeof framed, " %s ", word);
        if (strstr(list, framed)) return 1;
    }
    return 0;
}

/* Other names for units of a case, in either case of letters; loggers give forces as weights. */
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

/* Entry of a word; NULL: there is none. */
static const struct UnitName *unit_name_of(const char *word, size_t length)
{
    for (size_t k = 0; k < sizeof unit_names / sizeof *unit_names; k++) {
        if (strlen(unit_names[k].name) == length && strncasecmp(word, unit_names[k].name, length) == 0)
            return &unit_names[k];
    }
    return NULL;
}

/* Checks for a force in tonnes. */
static int is_tonne(const char *unit)
{
    static const char *const names[] = {"t", "to", "tonne", "tonnes", "tonnen"};
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (k < 2 ? strcmp(unit, names[k]) == 0 : strcasecmp(unit, names[k]) == 0) return 1;
    }
    return 0;
}

/* Factor from a unit to SI for a kind; 0: not a unit of it. */
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

/* Copies at most n bytes of a text without surrounding blanks. */
static void unit_trim(const char *text, size_t n, char unit[UNIT_TEXT_MAX])
{
    while (n > 0 && *text == ' ') text++, n--;
    while (n > 0 && text[n - 1] == ' ') n--;
    snprintf(unit, UNIT_TEXT_MAX, "%.*s", (int)n, text);
}

static const char parts[] = "_ /-,:";

/* Scale of the unit among a name's words: its end from some word on, with "per" as "/"; else one word, "length_ft_raw".
 * 0: none. */
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

/* Scale of the unit in a name: in the last of its brackets that has one, after "/" or "in", or among its words. 0:
 * there is none; -1: the text in `unit` is an unknown unit. */
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

/* Checks whether a name has words of a kind, and no unit that contradicts it. */
static int is_kind(const Units *u, const char *name, int kind, const char *words, int with_unit)
{
    char unit[UNIT_TEXT_MAX];
    if (!has_word(name, words)) return 0;
    return !with_unit || (kind != OF_DATE && head_scale(u, name, (LogColumn)kind, unit) > 0);
}

/* Finds the kind of a name: by unambiguous words with their unit, vague words with their unit, then both without. */
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

/* Refuses a column's unit and lists the possible ones. */
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

/* Checks for "mm:ss" in a head or a unit. */
static int says_minutes(const char *text)
{
    const char *const colon = strchr(text, ':');
    const int before = colon && colon > text ? tolower((unsigned char)colon[-1]) : 0;
    return (before == 'm' || before == 'n') && tolower((unsigned char)colon[1]) == 's';
}

/* Checks whether the head or the row of units gives times as "mm:ss". */
static int head_has_minutes(const LogHead *h)
{
    const int c = h->column[OF_TIME];
    return c >= 0 && (says_minutes(h->name[c]) || (c < h->units && says_minutes(h->unit[c])));
}

/* Scale from the row of units below a name, 0 if there is no unit; `below` ("" on entry) is its text unless that is a
 * number or a clock. */
static double below_scale(const Units *u, const LogHead *h, LogColumn kind, char below[UNIT_TEXT_MAX])
{
    Marks marks = {.plain = 0};
    const int c = h->column[kind];
    if (c >= h->units || marks_see(&marks, h->unit[c], 0) || !isnan(cell_clock(h->unit[c], 0))) return 0;
    const char *const text = h->unit[c] + strspn(h->unit[c], "[( ");
    unit_trim(text, strcspn(text, "])"), below);
    return unit_scale(u, below, kind);
}

/* Compares the unit in a name with the text below it: another unit is an error; another word is only reported, since it
 * may not be a unit. */
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

/* Finds the scale of a column from its name, or the row of units; clock: a time needs no unit. `place` is the head's
 * "file:line". Errors: INPUT (a force or speed without a unit, an unknown unit). */
static hawser_status head_unit(const Units *u, LogHead *h, LogColumn kind, int clock, const char *place, PullLog *log,
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

/* A logger's CSV: any of the usual separators, decimal commas, thousands marks, lines before the head, units in
 * the head or below it, times as numbers or as a clock with or without dates. */

enum { HEAD_WITHIN = 100 };

/* A row of readings: "" for a missing cell. */
typedef struct LogRow {
    int line;
    const char *cell[LOG_COLUMNS];
} LogRow;

/* A file being read. */
typedef struct Reader {
    const char *path;
    Units *units;
    char separator;
    int line, n; /* cells of the line */
    char *cell[CELLS_MAX], *scratch;
    LogHead head;
    LogRow *row;
    long rows;
    int thousands[LOG_COLUMNS][2]; /* whether points, commas that may be decimal are thousands marks */
    int clock, minutes;            /* times are a clock; two fields are minutes and seconds */
    hawser_error *err;
} Reader;

/* ------------------------------------------------------------------------------------------------------------ rows */

/* Checks whether a line is a head, by its own separator, which becomes the file's. */
static int head_take(Reader *r, char *line, const char *rest)
{
    char *cell[CELLS_MAX];
    LogHead h = {.line = r->line};
    const char separator = separator_of(line, rest);
    strcpy(r->scratch, line);
    if (!head_columns(r->units, line_cut(r->scratch, separator, cell), cell, h.column)) return 0;
    r->separator = separator;
    h.names = line_cut(line, separator, h.name);
    r->head = h;
    return 1;
}

/* Checks whether a row among the readings repeats the head. Errors: INPUT if it is another head. */
static hawser_status head_again(Reader *r, int *again)
{
    int column[LOG_COLUMNS];
    char place[CASE_PLACE_MAX];
    const LogHead *const h = &r->head;
    *again = head_columns(r->units, r->n, r->cell, column);
    int same = r->n == h->names;
    for (int c = 0; c < r->n && same; c++) same = strcmp(r->cell[c], h->name[c]) == 0;
    if (!*again || same) return HAWSER_OK;
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: another head than that of line %d: make two files of it",
                     case_place(r->path, r->line, place), h->line);
}

/* Checks that a row has at most as many cells as the head. Errors: INPUT, since a comma may be decimal and not a
 * separator. */
static hawser_status row_check(const Reader *r)
{
    char place[CASE_PLACE_MAX];
    const LogHead *const h = &r->head;
    const int commas = r->separator == ',', has = cells_filled(r->n, r->cell),
              names = commas ? cells_filled(h->names, h->name) : h->names;
    if (has <= names) return HAWSER_OK;
    return error_set(
        r->err, HAWSER_ERR_INPUT, "%s: %d cells, where the head in line %d has %d%s",
        case_place(r->path, r->line, place), has, h->line, names,
        commas ? ": are there decimal commas? Then separate by semicolons or tabs, or put the numbers in quotes"
               : ": name each column, or leave out what has no name");
}

static void row_take(Reader *r)
{
    LogRow *const row = &r->row[r->rows++];
    row->line = r->line;
    for (int k = 0; k < LOG_COLUMNS; k++) {
        const int c = r->head.column[k];
        row->cell[k] = c >= 0 && c < r->n ? r->cell[c] : "";
    }
}

/* Reads a line below a head: a better head, units, or readings. */
static hawser_status line_take(Reader *r, char *line, const char *rest)
{
    LogHead *const h = &r->head;
    Marks marks = {.plain = 0};
    int again = 0;
    if (r->rows == 0 && head_take(r, line, rest)) return HAWSER_OK;
    r->n = line_cut(line, r->separator, r->cell);
    const int force = h->column[OF_FORCE];
    const int text = force < r->n && *r->cell[force] && !marks_see(&marks, r->cell[force], 0);
    if (text && r->rows == 0 && h->units == 0) {
        h->units = r->n;
        memcpy(h->unit, r->cell, sizeof h->unit);
        return HAWSER_OK;
    }
    hawser_status status = text ? head_again(r, &again) : HAWSER_OK;
    if (status || again) return status;
    if (!text) status = row_check(r);
    if (!status) row_take(r);
    return status;
}

/* Reads all lines: text before the head, head, units, readings. */
static hawser_status lines_read(Reader *r, char *text)
{
    char *line, place[CASE_PLACE_MAX];
    hawser_status status = HAWSER_OK;
    while (!status && (line = line_next(&text))) {
        r->line++;
        if (!*line || *line == '#') continue;
        if (r->head.names == 0 && r->line > HEAD_WITHIN) break;
        if (r->head.names == 0) {
            head_take(r, line, text);
        } else {
            status = line_take(r, line, text);
        }
    }
    if (status) return status;
    if (r->head.names == 0) {
        return error_set(r->err, HAWSER_ERR_INPUT,
                         "%.700s: no row names a force and a time or a length, as 'time [s]; pull [kN]' does", r->path);
    }
    if (r->rows > 0) return HAWSER_OK;
    return error_set(r->err, HAWSER_ERR_INPUT, "%s: no readings below the head", case_place(r->path, r->line, place));
}

/* ----------------------------------------------------------------------------------------------------------- clock */

/* Decides whether times are a clock, by the majority; a date that includes the time counts as one. */
static void clock_find(Reader *r, PullLog *log)
{
    int *const column = r->head.column;
    long clocks = 0, numbers = 0;
    const char *first = NULL;
    Marks marks = {.plain = 0};
    const int from = column[OF_TIME] >= 0 ? OF_TIME : OF_DATE;
    r->minutes = head_has_minutes(&r->head);
    for (long i = 0; i < r->rows; i++) {
        const char *const cell = r->row[i].cell[from];
        numbers += marks_see(&marks, cell, 0);
        if (isnan(cell_clock(cell, r->minutes))) continue;
        if (clocks++ == 0) first = cell;
    }
    r->clock = clocks > numbers;
    if (from == OF_DATE && r->clock) {
        column[OF_TIME] = column[OF_DATE];
        for (long i = 0; i < r->rows; i++) r->row[i].cell[OF_TIME] = r->row[i].cell[OF_DATE];
    }
    if (!r->clock || !first || strchr(strchr(first, ':') + 1, ':') || r->minutes) return;
    const char *const point = strpbrk(strchr(first, ':'), ".,");
    r->minutes = point && isdigit((unsigned char)point[1]);
    if (cell_clock(first, 0) == cell_clock(first, 1)) return;
    log_say(log,
            "Times like '%.20s' are taken as hours and minutes: 'mm:ss' in the head makes them minutes and seconds",
            first);
}

/* Finds the units of all columns. */
static hawser_status units_find(Reader *r, PullLog *log)
{
    char place[CASE_PLACE_MAX];
    hawser_status status = HAWSER_OK;
    case_place(r->path, r->head.line, place);
    for (int k = 0; k < OF_DATE && !status; k++) {
        if (r->head.column[k] < 0) continue;
        status = head_unit(r->units, &r->head, (LogColumn)k, k == OF_TIME && r->clock, place, log, r->err);
    }
    if (!status) log_say(log, "Force from column '%.80s'", r->head.name[r->head.column[OF_FORCE]]);
    return status;
}

/* ----------------------------------------------------------------------------------------------------------- marks */

/* Role of a mark that is ambiguous in each cell of a column: 0 decimal, 1 thousands, -1: undecided, -2: contradictory.
 * k: 0 the point, 1 the comma; all: the marks of the whole file. */
static int mark_is(const Marks *m, const Marks *all, int k)
{
    const int decimal = m->decimal[k] > 0, thousands = m->thousands[k] > 0 || m->decimal[!k] > 0;
    if (decimal && thousands) return -2;
    if (decimal || thousands) return thousands;
    if (m->digits > 0) return 0;
    const int decimals = all->decimal[k] > 0, between = all->thousands[k] > 0 || all->decimal[!k] > 0;
    return decimals != between ? between : -1;
}

/* Decides the marks of a column by its other cells, else by the other columns; if these leave it open and each cell has
 * one, they are decimal. Errors: INPUT, if both are possible. */
static hawser_status marks_decide(Reader *r, LogColumn kind, const Marks *m, const Marks *all, PullLog *log)
{
    char place[CASE_PLACE_MAX];
    const char *const name = r->head.name[r->head.column[kind]];
    for (int k = 0; k < 2; k++) {
        if (m->either[k] == 0) continue;
        const int is = mark_is(m, all, k), english = k == 0 && r->separator == ',';
        r->thousands[kind][k] = is == 1;
        if (is == -2 || (is == -1 && m->plain > 0 && !english)) {
            return error_set(r->err, HAWSER_ERR_INPUT,
                             "%s: column '%.100s' has '%.20s', of which the %s may be decimal or stand between "
                             "thousands: write numbers without marks between thousands",
                             case_place(r->path, m->line[k], place), name, m->first[k], k ? "comma" : "point");
        }
        if (is == 1 || (is == -1 && !english)) {
            log_say(log, "Column '%.80s': the %s in '%.20s' is taken as %s", name, k ? "comma" : "point", m->first[k],
                    is == 1 ? "a mark between thousands" : "the decimal mark");
        }
    }
    return HAWSER_OK;
}

/* Decides the roles of points and commas in all columns. */
static hawser_status marks_find_all(Reader *r, PullLog *log)
{
    Marks marks[OF_DATE] = {{.plain = 0}}, all = {.plain = 0};
    hawser_status status = HAWSER_OK;
    for (int k = 0; k < OF_DATE; k++) {
        if (r->head.column[k] < 0 || (k == OF_TIME && r->clock)) continue;
        for (long i = 0; i < r->rows; i++) marks_see(&marks[k], r->row[i].cell[k], r->row[i].line);
        for (int m = 0; m < 2; m++) {
            all.decimal[m] += marks[k].decimal[m];
            all.thousands[m] += marks[k].thousands[m];
        }
    }
    for (int k = 0; k < OF_DATE && !status; k++) {
        if (r->head.column[k] >= 0) status = marks_decide(r, (LogColumn)k, &marks[k], &all, log);
    }
    return status;
}

/* -------------------------------------------------------------------------------------------------------- readings */

static double row_value(const Reader *r, long i, LogColumn kind)
{
    const char *const cell = r->row[i].cell[kind];
    if (kind == OF_TIME && r->clock) return cell_clock(cell, r->minutes);
    return log_cell_number(r->units, cell, r->thousands[kind]) * r->head.scale[kind];
}

/* Reports forces that have digits but are not numbers. Errors: INPUT, if most are so. */
static hawser_status forces_check(const Reader *r, PullLog *log)
{
    char place[CASE_PLACE_MAX];
    long odd = 0, first = -1;
    for (long i = 0; i < r->rows; i++) {
        if (!isnan(log->force[i]) || !strpbrk(r->row[i].cell[OF_FORCE], "0123456789")) continue;
        if (odd++ == 0) first = i;
    }
    if (odd == 0) return HAWSER_OK;
    const char *const cell = r->row[first].cell[OF_FORCE];
    if (2 * odd > r->rows) {
        return error_set(r->err, HAWSER_ERR_INPUT,
                         "%s: column '%.100s' has '%.40s', which is no number: write numbers alone, such as 12.5",
                         case_place(r->path, r->row[first].line, place), r->head.name[r->head.column[OF_FORCE]], cell);
    }
    log_say(log, "Forces that are no numbers are lost: %ld, such as '%.40s' in line %d", odd, cell, r->row[first].line);
    return HAWSER_OK;
}

/* Continues times of a clock over midnights. */
static hawser_status days_add(const Reader *r, PullLog *log)
{
    const char **const date = malloc(((size_t)r->rows + 1) * sizeof *date);
    if (!date) return error_memory(r->err);
    for (long i = 0; i < r->rows; i++) {
        const LogRow *const row = &r->row[i];
        date[i] = *row->cell[OF_DATE] ? row->cell[OF_DATE] : row->cell[OF_TIME];
    }
    const hawser_status status = clocks_go_on(log, date, r->minutes, r->err);
    free(date);
    return status;
}

static hawser_status log_alloc(PullLog *log, long n, hawser_error *err)
{
    const size_t bytes = ((size_t)n + 1) * sizeof(double);
    log->time = malloc(bytes);
    log->length = malloc(bytes);
    log->speed = malloc(bytes);
    log->force = malloc(bytes);
    log->line = malloc(((size_t)n + 1) * sizeof *log->line);
    log->use = calloc((size_t)n + 1, 1);
    return log->time && log->length && log->speed && log->force && log->line && log->use ? HAWSER_OK
                                                                                         : error_memory(err);
}

/* Converts all cells to numbers. */
static hawser_status readings_take(Reader *r, PullLog *log)
{
    clock_find(r, log);
    hawser_status status = units_find(r, log);
    if (!status) status = marks_find_all(r, log);
    if (!status) status = log_alloc(log, r->rows, r->err);
    if (status) return status;
    log->n = r->rows;
    log->begin = -1;
    log->has_time = r->head.column[OF_TIME] >= 0;
    log->has_length = r->head.column[OF_LENGTH] >= 0;
    log->has_speed = r->head.column[OF_SPEED] >= 0;
    for (long i = 0; i < log->n; i++) {
        log->line[i] = r->row[i].line;
        log->force[i] = row_value(r, i, OF_FORCE);
        log->time[i] = row_value(r, i, OF_TIME);
        log->length[i] = row_value(r, i, OF_LENGTH);
        log->speed[i] = row_value(r, i, OF_SPEED);
    }
    status = forces_check(r, log);
    if (!status && r->clock) status = days_add(r, log);
    return status;
}

hawser_status log_read(const char *path, PullLog *log, hawser_error *err)
{
    Reader r = {.path = path, .units = units_new(), .err = err};
    char *text = NULL;
    size_t size = 0, lines = 2;
    *log = (PullLog){.n = 0};
    hawser_status status = r.units ? case_file_read(path, &text, &size, err) : error_memory(err);
    for (const char *c = text; !status && *c; c++) lines += *c == '\n' || *c == '\r';
    if (!status) {
        r.scratch = malloc(size + 1);
        r.row = malloc(lines * sizeof *r.row);
        status = r.scratch && r.row ? HAWSER_OK : error_memory(err);
    }
    if (!status) status = lines_read(&r, text + (strncmp(text, "\xef\xbb\xbf", 3) == 0 ? 3 : 0));
    if (!status) status = readings_take(&r, log);
    free(r.row);
    free(r.scratch);
    free(text);
    units_free(r.units);
    if (status) log_free(log);
    return status;
}
