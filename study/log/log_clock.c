/* Clocks and dates of a logger's file: seconds of the day, days of the calendar, and midnights. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "core/base/error.h"
#include "study/log/log_cells.h"

/* Falls of a clock beyond this are midnights, s; what goes on within it, goes on. */
static const double FALL = 300, HOUR = 3600, DAY = 86400;

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

double cell_clock(const char *cell, int minutes)
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

/* 1 to 12 for the name of a month, English or German, by its first three letters; 0: it is none. */
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

/* Days of the calendar up to a date; NAN: there is none such. */
static double days_of(int year, int month, int day)
{
    static const int before[] = {0, 31, 59, 90, 120, 151, 181, 212, 243, 273, 304, 334, 365};
    if (year < 0 || year > 9999 || month < 1 || month > 12 || day < 1) return NAN;
    if (year < 100) year += 2000;
    const int leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0, y = year - 1;
    if (day > before[month] - before[month - 1] + (leap && month == 2)) return NAN;
    return 365.0 * y + y / 4 - y / 100 + y / 400 + before[month - 1] + (leap && month > 2) + day;
}

/* The day of a date such as 2026-11-26, 26.11.2026, 26-Nov-2026, 20261126, or 11/26/2026 and 26/11/2026, of which
 * month_first tells what the first is. NAN: it is none. */
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

/* How dates fit an order of day and month. */
typedef struct DateFit {
    long read, falls;
    double first, span; /* the first day; from the least to the largest */
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

/* Where clocks have come to. */
typedef struct Course {
    double last, offset; /* s: the last time that goes on; what clocks are behind */
    long midnights, halves;
} Course;

/* Whether the clock behind reading i goes on from the last time and not from reading i. */
static int is_astray(const PullLog *log, const Course *c, long i)
{
    const double t = c->offset + log->time[i];
    long j = i + 1;
    while (j < log->n && isnan(log->time[j])) j++;
    if (j == log->n || isnan(c->last) || isnan(t)) return 0;
    const double next = c->offset + log->time[j];
    return next >= c->last && next - c->last < FALL && (t < c->last - FALL || t > next + FALL);
}

/* A clock that has fallen goes on behind midnight, one of twelve hours behind noon, one of minutes behind the hour. */
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

/* What has been made of the clock. */
static void course_say(const Course *c, PullLog *log)
{
    if (c->midnights > 0)
        log_say(log, "Falls of the clock without a later date are taken for midnights: %ld", c->midnights);
    if (c->halves > 0)
        log_say(log, "The clock is taken for one of twelve hours: times it falls by them and goes on: %ld", c->halves);
}

hawser_status clocks_go_on(PullLog *log, const char *const *date, int minutes, hawser_error *err)
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
