/* A logger's CSV: any of the usual separators, decimal commas, marks between thousands, lines before the head, units in
 * the head or below it, times as numbers or as a clock with or without dates. */
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/base/error.h"
#include "io/yaml/yaml_tree.h"
#include "study/log/log_head.h"

enum { HEAD_WITHIN = 100 };

/* A row of readings: "" where it has no cell. */
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
    int thousands[LOG_COLUMNS][2]; /* whether points, commas that may be decimal stand between thousands */
    int clock, minutes;            /* times are a clock; of which two fields are minutes and seconds */
    hawser_error *err;
} Reader;

/* ------------------------------------------------------------------------------------------------------------ rows */

/* Whether a line is a head, by its own separator, which becomes the file's. */
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

/* Whether a row among the readings is a head once more. Errors: INPUT if it is another one. */
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

/* A row of as many cells as the head, or fewer. Errors: INPUT, for a comma may be decimal and separate nothing. */
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

/* A line below a head: a better head, units, or readings. */
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

/* All lines: what stands before the head, head, units, readings. */
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

/* Whether times are a clock, as most of them are; a date that holds the time is one. */
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

/* The units of all columns. */
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

/* What a mark is that each cell of a column leaves open: 0 decimal, 1 between thousands, -1: nothing tells, -2: it is
 * both. k: 0 the point, 1 the comma; all: the marks of the whole file. */
static int mark_is(const Marks *m, const Marks *all, int k)
{
    const int decimal = m->decimal[k] > 0, thousands = m->thousands[k] > 0 || m->decimal[!k] > 0;
    if (decimal && thousands) return -2;
    if (decimal || thousands) return thousands;
    if (m->digits > 0) return 0;
    const int decimals = all->decimal[k] > 0, between = all->thousands[k] > 0 || all->decimal[!k] > 0;
    return decimals != between ? between : -1;
}

/* The marks of a column by its other cells, else by the other columns; where these say nothing and each cell has one,
 * they are decimal. Errors: INPUT, where both may be. */
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

/* What points and commas are, in all columns. */
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
    return cell_number(r->units, cell, r->thousands[kind]) * r->head.scale[kind];
}

/* Forces with digits that are no numbers are not lost in silence. Errors: INPUT, if most are so. */
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

/* Times of a clock go on over midnights. */
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

/* Numbers out of all cells. */
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
