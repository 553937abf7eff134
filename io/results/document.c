/* One content, three forms. Facts become lines, a JSON object or rows of key, value, unit; tables become columns
 * (page.c), lists of objects or CSV. */
#define _GNU_SOURCE /* fopencookie */
#include "io/results/column.h"

#include "core/base/error.h"

#include <assert.h>
#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { DIGITS = 10 };

Cell column_cell(const Column *column, const void *row)
{
    const char *const at = (const char *)row + column->offset;
    if (column->text) return cell_text(column->text(row));
    if (column->number) return cell_number(column->number(row));
    switch (column->kind) {
    case COLUMN_NUMBER:
        return cell_number(*(const double *)(const void *)at);
    case COLUMN_COUNT:
        return cell_number(*(const int *)(const void *)at);
    case COLUMN_LONG:
        return cell_number((double)*(const long *)(const void *)at);
    case COLUMN_TEXT:
        return cell_text(*(const char *const *)(const void *)at);
    default:
        assert(column->kind == COLUMN_CHARS);
        return cell_text(at);
    }
}

static Cell cell_at(const Table *t, int row, int column)
{
    return column_cell(&t->columns.column[column], (const char *)t->rows + (size_t)row * t->columns.size);
}

/* Text of a case must command no spreadsheet and no terminal: what a spreadsheet would take for a formula begins with
 * an apostrophe, which it does not show, and control characters are question marks. RFC 4180: quotes where they are
 * needed. */
static void csv_text(FILE *f, const char *text)
{
    const int formula = text[0] && strchr("=+-@", text[0]), quoted = strpbrk(text, ",\"") != NULL;
    if (quoted) fputc('"', f);
    if (formula) fputc('\'', f);
    for (const unsigned char *p = (const unsigned char *)text; *p; p++) {
        if (*p == '"') fputc('"', f);
        fputc(*p < ' ' || *p == 0x7F ? '?' : *p, f);
    }
    if (quoted) fputc('"', f);
}

/* Readers of CSV disagree about "nan"; an empty cell is understood by all. */
void csv_cell(FILE *f, Cell cell, int digits)
{
    if (cell.text)
        csv_text(f, cell.text);
    else if (isfinite(cell.value))
        fprintf(f, "%.*g", digits > 0 ? digits : 9, cell.value);
}

/* Keys in the first row, then the rows. */
static void print_csv_table(FILE *f, const Table *t)
{
    for (int c = 0; c < t->columns.n; c++) fprintf(f, "%s%s", c ? "," : "", t->columns.column[c].key);
    fputc('\n', f);
    for (int r = 0; r < t->n; r++) {
        for (int c = 0; c < t->columns.n; c++) {
            if (c) fputc(',', f);
            csv_cell(f, cell_at(t, r, c), DIGITS);
        }
        fputc('\n', f);
    }
}

/* A fact a row. */
static void print_csv_facts(FILE *f, const Document *doc)
{
    fprintf(f, "key,value,unit\n");
    for (int i = 0; i < doc->n_facts; i++) {
        fprintf(f, "%s,", doc->fact[i].key);
        csv_cell(f, doc->fact[i].cell, DIGITS);
        fprintf(f, ",%s\n", doc->fact[i].unit);
    }
}

/* Text that is not UTF-8 becomes null, like a number that is not finite; NULL without memory. Where there was none for
 * a text there is none a moment later. */
static json_t *json_cell(Cell cell)
{
    if (!cell.text) return isfinite(cell.value) ? json_real(cell.value) : json_null();
    json_t *text = json_string(cell.text);
    if (!text) text = json_string(cell.text);
    return text ? text : json_null();
}

void growing_add(Growing *g, const char *more, size_t n)
{
    if (!g->bad && g->size + n >= g->room) {
        const size_t room = g->size + n + g->room / 2 + 256;
        char *const wider = realloc(g->text, room);
        g->bad = !wider;
        if (wider) {
            g->text = wider;
            g->room = room;
        }
    }
    if (g->bad) return;
    memcpy(g->text + g->size, more, n);
    g->size += n;
    g->text[g->size] = 0;
}

char *growing_end(Growing *g)
{
    if (!g->bad && g->text) return g->text;
    free(g->text);
    return NULL;
}

static int add_json(const char *more, size_t n, void *growing)
{
    Growing *const g = growing;
    growing_add(g, more, n);
    return g->bad ? -1 : 0;
}

static ssize_t add_printed(void *growing, const char *more, size_t n)
{
    return add_json(more, n, growing) ? 0 : (ssize_t)n;
}

char *json_dumped(const struct json_t *o, size_t flags)
{
    Growing g = {0};
    g.bad |= json_dump_callback(o, add_json, &g, flags) != 0;
    return growing_end(&g);
}

char *json_text(const struct json_t *o) { return json_dumped(o, JSON_INDENT(2) | JSON_REAL_PRECISION(10)); }

/* A table is a list of objects, one a row; NULL without memory. */
static json_t *json_table(const Table *t)
{
    json_t *const rows = json_array();
    int bad = !rows;
    for (int r = 0; r < t->n && !bad; r++) {
        json_t *const row = json_object();
        bad = !row;
        for (int c = 0; c < t->columns.n && !bad; c++) {
            bad = json_object_set_new(row, t->columns.column[c].key, json_cell(cell_at(t, r, c)));
        }
        bad |= json_array_append_new(rows, row);
    }
    if (!bad) return rows;
    json_decref(rows);
    return NULL;
}

static int is_wanted(const char *key, const char *const *wanted)
{
    if (!wanted) return 1;
    while (*wanted && strcmp(*wanted, key) != 0) wanted++;
    return *wanted != NULL;
}

json_t *document_json(const Document *doc, const char *const *wanted)
{
    json_t *const o = json_object();
    int bad = !o || json_object_set_new(o, "title", json_cell(cell_text(doc->title)));
    for (int i = 0; i < doc->n_facts && !bad; i++) {
        bad = json_object_set_new(o, doc->fact[i].key, json_cell(doc->fact[i].cell));
    }
    for (int i = 0; i < doc->n_tables && !bad; i++) {
        const Table *const t = &doc->table[i];
        if (is_wanted(t->key, wanted)) bad = json_object_set_new(o, t->key, json_table(t));
    }
    if (!bad) return o;
    json_decref(o);
    return NULL;
}

/* The whole document as text, NULL without memory. */
static char *json_document(const Document *doc)
{
    json_t *const o = document_json(doc, NULL);
    char *const body = o ? json_text(o) : NULL;
    json_decref(o);
    return body;
}

/* The same content in each form; CSV can hold one table only. 0 without memory. */
static int print_document(FILE *f, const Document *doc, int format)
{
    if (format == HAWSER_CSV) {
        if (doc->csv) print_csv_table(f, doc->csv);
        if (!doc->csv) print_csv_facts(f, doc);
    } else if (format == HAWSER_JSON) {
        char *const body = json_document(doc);
        if (!body) return 0;
        fprintf(f, "%s\n", body);
        free(body);
    } else {
        document_print(f, doc, format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI);
    }
    return !ferror(f);
}

/* Written under the "C" locale, so that a program with decimal commas gets valid CSV and JSON too. */
static hawser_status print_whole(int (*print)(FILE *f, const Document *doc, int how), const Document *doc, int how,
                                 char **text, hawser_error *err)
{
    Growing g = {0};
    const locale_t c = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    FILE *const f = c ? fopencookie(&g, "w", (cookie_io_functions_t){.write = add_printed}) : NULL;
    g.bad = !f;
    if (f) {
        const locale_t before = uselocale(c);
        const int whole = print(f, doc, how);
        uselocale(before);
        g.bad |= fclose(f) || !whole;
    }
    if (c) freelocale(c);
    *text = growing_end(&g);
    return *text ? HAWSER_OK : error_memory(err);
}

hawser_status document_write(const Document *doc, hawser_format format, char **text, hawser_error *err)
{
    return print_whole(print_document, doc, (int)format, text, err);
}

hawser_status document_html(const Document *doc, hawser_units units, char **text, hawser_error *err)
{
    return print_whole(document_print_html, doc, (int)units, text, err);
}
