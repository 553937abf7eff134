#include "io/report/sheet.h"

#include "core/base/error.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 100000 };

void sheet_clear(Sheet *sheet)
{
    free(sheet->text);
    free(sheet->name);
    free(sheet->cell);
    *sheet = (Sheet){0};
}

/* One cell, cut out of the text in place: *p moves behind it and behind what ends it, which is returned: ',' '\n' or 0.
 * -1: a quote is not closed. The apostrophe that keeps spreadsheets from computing is taken off. */
static int cell_cut(char **p, const char **cell)
{
    char *from = *p, *to = from;
    *cell = to;
    if (*from == '"') {
        for (++from; *from; ++from) {
            if (*from == '"' && *++from != '"') break;
            *to++ = *from;
        }
        if (from[-1] != '"') return -1;
    }
    while (*from && *from != ',' && *from != '\n') *to++ = *from++;
    const int end = (unsigned char)*from;
    *p = end ? from + 1 : from;
    if (to > *cell && to[-1] == '\r') --to;
    *to = 0;
    if (**cell == '\'' && strchr("=+-@", (*cell)[1]) && (*cell)[1]) ++*cell;
    return end;
}

/* Columns of the head, and lines: more than rows where quotes hide the ends of some. */
static void count(const char *text, int *columns, int *lines)
{
    int head = 1, quoted = 0;
    *columns = 1;
    *lines = 0;
    for (const char *c = text; *c; ++c) {
        if (*c == '"') quoted = !quoted;
        if (head && !quoted && *c == ',') ++*columns;
        if (*c != '\n') continue;
        if (!quoted) head = 0;
        ++*lines;
    }
    if (*text && text[strlen(text) - 1] != '\n') ++*lines;
}

/* One line into the cells of a row [columns]; 0: a quote is not closed. */
static int row_cut(char **p, int columns, const char **row)
{
    for (int k = 0, end = ','; end == ','; ++k) {
        const char *cell;
        end = cell_cut(p, &cell);
        if (end < 0) return 0;
        if (k < columns) row[k] = cell;
    }
    return 1;
}

hawser_status sheet_parse(char *text, const char *name, Sheet *sheet, hawser_error *err)
{
    int columns, lines;
    char *p = text;
    *sheet = (Sheet){.text = text};
    if (!*text) {
        sheet_clear(sheet);
        return HAWSER_OK;
    }
    count(text, &columns, &lines);
    if (columns > COLUMNS_MAX || (size_t)lines * (size_t)columns > (size_t)1 << 28) {
        sheet_clear(sheet);
        return error_set(err, HAWSER_ERR_INPUT, "%.700s: too large a table", name);
    }
    sheet->name = calloc((size_t)columns, sizeof *sheet->name);
    sheet->cell = calloc((size_t)lines * (size_t)columns + 1, sizeof *sheet->cell);
    hawser_status status = sheet->name && sheet->cell ? HAWSER_OK : error_memory(err);
    for (int k = 0; k < columns && !status; ++k) sheet->name[k] = "";
    for (size_t k = 0; k < (size_t)lines * (size_t)columns && !status; ++k) sheet->cell[k] = "";
    sheet->columns = columns;
    if (!status && !row_cut(&p, columns, sheet->name)) status = HAWSER_ERR_INPUT;
    for (; !status && *p; ++sheet->rows) {
        if (!row_cut(&p, columns, sheet->cell + (size_t)sheet->rows * (size_t)columns)) status = HAWSER_ERR_INPUT;
    }
    if (status == HAWSER_ERR_INPUT) error_set(err, status, "%.700s: a quote is not closed", name);
    if (status) sheet_clear(sheet);
    return status;
}

int sheet_column(const Sheet *sheet, const char *name)
{
    for (int k = 0; k < sheet->columns; ++k) {
        if (strcmp(sheet->name[k], name) == 0) return k;
    }
    return -1;
}

int is_json_number(const char *text)
{
    const char *t = text;
    t += *t == '-';
    if (*t == '0' && isdigit((unsigned char)t[1])) return 0;
    if (!isdigit((unsigned char)*t)) return 0;
    t += strspn(t, "0123456789");
    if (*t == '.') {
        if (!isdigit((unsigned char)*++t)) return 0;
        t += strspn(t, "0123456789");
    }
    if (*t == 'e' || *t == 'E') {
        ++t;
        t += *t == '-' || *t == '+';
        if (!isdigit((unsigned char)*t)) return 0;
        t += strspn(t, "0123456789");
    }
    return !*t && isfinite(strtod(text, NULL)); /* 1e999 is none */
}

double sheet_number(const Sheet *sheet, int row, int column)
{
    if (column < 0) return NAN;
    const char *const text = sheet_cell(sheet, row, column);
    return is_json_number(text) ? strtod(text, NULL) : NAN;
}

int sheet_is_numeric(const Sheet *sheet, int column)
{
    if (strcmp(sheet->name[column], "name") == 0) return 0;
    for (int i = 0; i < sheet->rows; ++i) {
        const char *const text = sheet_cell(sheet, i, column);
        if (*text && !is_json_number(text)) return 0;
    }
    return 1;
}

void sheet_json(const Sheet *sheet, int n, const int *row, Text *out)
{
    const int rows = row ? n : sheet->rows;
    text_add(out, "{");
    for (int k = 0; k < sheet->columns; ++k) {
        const int numeric = sheet_is_numeric(sheet, k);
        if (k) text_add(out, ",");
        text_json(out, sheet->name[k]);
        text_add(out, ":[");
        for (int i = 0; i < rows; ++i) {
            const char *const text = sheet_cell(sheet, row ? row[i] : i, k);
            if (i) text_add(out, ",");
            if (!numeric) text_json(out, text);
            if (numeric) text_add(out, *text ? text : "null");
        }
        text_add(out, "]");
    }
    text_add(out, "}");
}

int sheet_thin(const Sheet *sheet, int column, int most, int *row)
{
    int n = 0;
    const int buckets = most / 3;
    if (sheet->rows <= most) {
        for (; n < sheet->rows; ++n) row[n] = n;
        return n;
    }
    for (int b = 0; b < buckets; ++b) {
        const int from = (int)((long)sheet->rows * b / buckets), to = (int)((long)sheet->rows * (b + 1) / buckets);
        int least = from, largest = from;
        for (int i = from; i < to; ++i) {
            const double v = sheet_number(sheet, i, column);
            if (v < sheet_number(sheet, least, column) || isnan(sheet_number(sheet, least, column))) least = i;
            if (v > sheet_number(sheet, largest, column) || isnan(sheet_number(sheet, largest, column))) largest = i;
        }
        const int second = least < largest ? least : largest, third = least < largest ? largest : least;
        row[n++] = from;
        if (second > from) row[n++] = second;
        if (third > second) row[n++] = third;
    }
    if (row[n - 1] != sheet->rows - 1) row[n++] = sheet->rows - 1;
    return n;
}
