/* One content in three forms. Facts become lines, a JSON object or rows of key, value, unit; tables become columns
 * (page.c), lists of objects or CSV. */
#define _GNU_SOURCE /* fopencookie */
#include <assert.h>
#include <jansson.h>
#include <locale.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "core/error.h"
#include "io/results/column.h"
#include "io/results/words.h"

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

/* Writes text of a case so that it controls no spreadsheet and no terminal: an apostrophe, which a spreadsheet hides,
 * before what it would take for a formula, and question marks for control characters. RFC 4180: quotes where needed. */
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

/* Leaves the cell empty for a number that is not known: readers of CSV disagree about "nan". */
void csv_cell(FILE *f, Cell cell, int digits)
{
    if (cell.text)
        csv_text(f, cell.text);
    else if (isfinite(cell.value))
        fprintf(f, "%.*g", digits > 0 ? digits : 9, cell.value);
}

/* Prints keys in the first row, then the rows. */
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

/* Prints a row for each fact. */
static void print_csv_facts(FILE *f, const Document *doc)
{
    fprintf(f, "key,value,unit\n");
    for (int i = 0; i < doc->n_facts; i++) {
        fprintf(f, "%s,", doc->fact[i].key);
        csv_cell(f, doc->fact[i].cell, DIGITS);
        fprintf(f, ",%s\n", doc->fact[i].unit);
    }
}

/* Returns null for text that is not UTF-8, as for a number that is not finite; NULL without memory. If there was no
 * memory for a text a second attempt has none either. */
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

/* Returns a table as a list of objects, one a row; NULL without memory. */
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

/* Returns the whole document as text, NULL without memory. */
static char *json_document(const Document *doc)
{
    json_t *const o = document_json(doc, NULL);
    char *const body = o ? json_text(o) : NULL;
    json_decref(o);
    return body;
}

/* Prints the same content in each form; CSV can hold one table only. 0 without memory. */
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

/* Prints under the "C" locale, so that a program with decimal commas gets valid CSV and JSON too. */
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

/* Documents for readers: facts one a line, tables in columns that fit a page. Units are chosen here, by column, by row
 * or by fact; quantities in sentences are converted by hawser_show_text. */

enum { CELL_MAX = 640, COLUMNS_MAX = 32, PAGE = 118, WRAP_MIN = 30, PAGE_DIGITS = 5 };

/* A column of a table as it is shown. */
typedef struct ColumnShape {
    const Column *column;
    Scale scale;      /* for all its cells, if none of them has a unit of its own */
    int unit_at;      /* the column with each row's unit; -1: none */
    int is_unit;      /* it is such a column itself */
    int decimals;     /* < 0: as many as needed */
    int left;         /* text to the left, numbers to the right */
    int label, width; /* bytes of the label without its unit; bytes of the widest cell */
} ColumnShape;

typedef struct Page {
    const Table *table;
    hawser_units units;
    int n, lead;                    /* the first `lead` columns identify a row */
    ColumnShape shape[COLUMNS_MAX]; /* [n] the shown columns */
} Page;

/* Returns the column behind c in a piece of the table that has the leading columns and those from `from` on. */
static int next_column(const Page *page, int c, int from) { return c + 1 == page->lead ? from : c + 1; }

static Cell cell_of(const Page *page, int row, const Column *column)
{
    return column_cell(column, (const char *)page->table->rows + (size_t)row * page->table->columns.size);
}

static const Column *column_of_key(const Table *t, const char *key)
{
    for (int c = 0; key && c < t->columns.n; ++c) {
        if (!strcmp(t->columns.column[c].key, key)) return &t->columns.column[c];
    }
    return NULL;
}

/* Returns the largest size in a row of the values whose unit is in the column `unit`. */
static double row_size(const Page *page, int row, const Column *unit)
{
    double size = 0;
    for (int c = 0; c < page->table->columns.n; ++c) {
        const Column *const column = &page->table->columns.column[c];
        const Cell cell = cell_of(page, row, column);
        if (!column->unit_by || strcmp(column->unit_by, unit->key) != 0 || cell.text) continue;
        if (isfinite(cell.value)) size = fmax(size, fabs(cell.value));
    }
    return size;
}

/* Returns the largest size in a column; all forces of a table use the largest of them all, so that they can be
 * compared. */
static double column_size(const Page *page, const Column *of)
{
    const char *const unit = unit_of_key(of->key);
    double size = 0;
    for (int c = 0; c < page->table->columns.n; ++c) {
        const Column *const column = &page->table->columns.column[c];
        if (column != of && (strcmp(unit, "N") != 0 || strcmp(unit_of_key(column->key), "N") != 0)) continue;
        for (int r = 0; r < page->table->n; ++r) {
            const Cell cell = cell_of(page, r, column);
            if (!cell.text && isfinite(cell.value)) size = fmax(size, fabs(cell.value));
        }
    }
    return size;
}

/* Checks whether a name is the default name of a station, "30 m" at 30 m. */
static int is_plain_place(const Page *page, int row, const char *name)
{
    char metres[HAWSER_SHOWN_MAX] = "";
    for (int c = 0; c < page->table->columns.n; ++c) {
        const Column *const column = &page->table->columns.column[c];
        if (!strcmp(column->key, "s_m")) snprintf(metres, sizeof metres, "%g m", cell_of(page, row, column).value);
    }
    return strcmp(metres, name) == 0;
}

/* Writes the text of a cell: the user's names stay; quantities elsewhere are converted. */
static const char *say_words(const Page *page, const Column *column, int row, const char *words, char *text)
{
    static const char *const names[] = {"name",       "piece",     "layer", "chain", "cable",
                                        "max_roller", "parameter", "key",   "file",  "case"};
    static const char *const places[] = {"ends_at"};
    char marked[CELL_MAX];
    for (size_t k = 0; k < sizeof names / sizeof *names; ++k) {
        if (!strcmp(column->key, names[k]) && !is_plain_place(page, row, words)) return words;
    }
    for (size_t k = 0; k < sizeof places / sizeof *places; ++k) {
        if (!strcmp(column->key, places[k])) words = place_mark(words, marked, sizeof marked);
    }
    return hawser_show_text(words, page->units, text, CELL_MAX);
}

/* Writes so many decimals, without the sign of a value that rounds to 0. */
static void say_fixed(double value, int decimals, char *text)
{
    snprintf(text, CELL_MAX, "%.*f", decimals, value);
    if (*text == '-' && !text[1 + strspn(text + 1, "0.")]) snprintf(text, CELL_MAX, "%.*f", decimals, 0.0);
}

/* Writes a cell for readers; `text` has CELL_MAX bytes. */
static const char *say_cell(const Page *page, const ColumnShape *shape, int row, char *text)
{
    const Cell cell = cell_of(page, row, shape->column);
    if (cell.text && shape->is_unit) {
        const char *const unit = scale_of(cell.text, row_size(page, row, shape->column), page->units).unit;
        return strcmp(unit, "1") ? unit : "";
    }
    if (cell.text) return say_words(page, shape->column, row, cell.text, text);
    if (!isfinite(cell.value)) return "-";
    if (shape->unit_at >= 0) {
        const Column *const by = &page->table->columns.column[shape->unit_at];
        const char *const unit = cell_of(page, row, by).text;
        const double factor = scale_of(unit ? unit : "", row_size(page, row, by), page->units).factor;
        if (shape->decimals >= 0 && factor == 1) say_fixed(cell.value, shape->decimals, text);
        if (shape->decimals < 0 || factor != 1) say_digits(cell.value * factor, PAGE_DIGITS, text);
        return text;
    }
    const double value = cell.value * shape->scale.factor;
    if (shape->decimals < 0) say_digits(value, PAGE_DIGITS, text);
    if (shape->decimals >= 0) say_fixed(value, shape->decimals, text);
    return text;
}

/* Returns as many decimals as keep the resolution, at most three where there were fewer. */
static int decimals_of(const Column *column, double factor)
{
    if (column->decimals < 0 || factor == 1) return column->decimals;
    const int wanted = column->decimals - (int)log10(factor), most = column->decimals > 3 ? column->decimals : 3;
    return wanted < 0 ? 0 : wanted > most ? most : wanted;
}

/* Returns the length of the label without the unit behind its comma, which is shown below it. */
static int label_length(const char *label, const char *unit)
{
    const size_t n = strlen(label), u = strlen(unit);
    if (u == 0 || n < u || strcmp(label + n - u, unit) != 0) return (int)n;
    if (n == u) return 0;
    return n > u + 2 && !strncmp(label + n - u - 2, ", ", 2) ? (int)(n - u - 2) : (int)n;
}

/* Returns the form of a column; its width is found later. */
static ColumnShape shape_of(const Page *page, const Column *column)
{
    const Table *const t = page->table;
    const char *const unit = unit_of_key(column->key);
    ColumnShape shape = {.column = column, .unit_at = -1, .label = label_length(column->label, unit)};
    const Column *const by = column_of_key(t, column->unit_by);
    if (by) shape.unit_at = (int)(by - t->columns.column);
    shape.scale =
        by || column->kind == COLUMN_TEXT ? (Scale){1, ""} : scale_of(unit, column_size(page, column), page->units);
    shape.decimals = decimals_of(column, shape.scale.factor);
    for (int c = 0; c < t->columns.n; ++c) {
        const char *const names = t->columns.column[c].unit_by;
        shape.is_unit |= names && !strcmp(names, column->key);
    }
    shape.left = t->n > 0 && cell_of(page, 0, column).text != NULL;
    return shape;
}

/* Adds a column unless none of its values is known. Widths are in bytes: names with accents appear a little narrower.
 */
static void add_column(Page *page, const Column *column)
{
    char text[CELL_MAX];
    ColumnShape shape = shape_of(page, column);
    int known = page->table->n == 0;
    for (int r = 0; r < page->table->n; ++r) {
        const char *const said = say_cell(page, &shape, r, text);
        const int width = (int)strlen(said);
        known |= strcmp(said, "-") != 0;
        if (width > shape.width) shape.width = width;
    }
    const int unit = (int)strlen(shape.scale.unit);
    if (shape.label > shape.width) shape.width = shape.label;
    if (unit > shape.width) shape.width = unit;
    assert(page->n < COLUMNS_MAX);
    if (known) page->shape[page->n++] = shape;
}

/* Prints labels, and their units below them. */
static void print_head(FILE *f, const Page *page, int from, int to)
{
    int units = 0;
    for (int line = 0; line < 1 + units; ++line) {
        int owed = 0; /* blanks before the next word */
        for (int c = 0; c < to; c = next_column(page, c, from)) {
            const ColumnShape *const s = &page->shape[c];
            const char *const word = line ? s->scale.unit : s->column->label;
            const int length = line ? (int)strlen(word) : s->label, pad = s->width - length;
            units |= *s->scale.unit != 0;
            if (length > 0) fprintf(f, "%*s%.*s", owed + 2 + (s->left ? 0 : pad), "", length, word);
            owed = length > 0 ? (s->left ? pad : 0) : owed + 2 + s->width;
        }
        fputc('\n', f);
    }
}

/* Prints text wrapped at blanks into lines of `width` bytes, the second and later ones indented. */
static void print_wrapped(FILE *f, const char *text, int indent, int width)
{
    while ((int)strlen(text) > width) {
        int n = width;
        while (n > 0 && text[n] != ' ') --n;
        if (n == 0) break; /* a word that is too long is not cut */
        fprintf(f, "%.*s\n%*s", n, text, indent, "");
        text += n + 1;
    }
    fputs(text, f);
}

/* Prints the rows of the leading columns and of columns from .. to, the last of which may be wrapped. */
static void print_rows(FILE *f, const Page *page, int from, int to)
{
    char text[CELL_MAX];
    for (int r = 0; r < page->table->n; ++r) {
        int at = 0;
        for (int c = 0; c < to; c = next_column(page, c, from)) {
            const ColumnShape *const s = &page->shape[c];
            const int last = next_column(page, c, from) >= to;
            const char *const said = say_cell(page, s, r, text);
            fputs("  ", f);
            if (last && s->left) print_wrapped(f, said, at + 2, PAGE - at - 2 > WRAP_MIN ? PAGE - at - 2 : WRAP_MIN);
            if (!last || !s->left) fprintf(f, "%*s", s->left ? -s->width : s->width, said);
            at += 2 + s->width;
        }
        fputc('\n', f);
    }
}

/* Returns where the columns from `from` on are cut: before the first that does not fit, or before the last group that
 * begins before it. A last column of text fits if a few words do. */
static int page_end(const Page *page, int from)
{
    int width = 0, group = 0;
    for (int c = 0; c < page->lead; ++c) width += 2 + page->shape[c].width;
    for (int c = from; c < page->n; ++c) {
        const ColumnShape *const s = &page->shape[c];
        const int wraps = s->left && c + 1 == page->n && s->width > WRAP_MIN;
        if (c > from && s->column->group) group = c;
        width += 2 + (wraps ? WRAP_MIN : s->width);
        if (width > PAGE && c > from) return group ? group : c;
    }
    return page->n;
}

/* Prints a table that is too wide in pieces below each other, each with the leading columns: the first, and the second
 * where both are text. */
static void print_table(FILE *f, const Table *t, hawser_units units)
{
    Page page = {.table = t, .units = units};
    char heading[CELL_MAX];
    for (int c = 0; c < t->columns.n; ++c) add_column(&page, &t->columns.column[c]);
    fprintf(f, "\n%s\n", hawser_show_text(t->heading, units, heading, sizeof heading));
    page.lead = page.n > 2 && page.shape[0].left && page.shape[1].left ? 2 : 1;
    for (int from = page.lead, first = 1; first || from < page.n; first = 0) {
        const int to = page_end(&page, from);
        if (!first) fputc('\n', f);
        print_head(f, &page, from, to);
        print_rows(f, &page, from, to);
        from = to;
    }
}

enum { FACT_MAX = 2048 };

/* Writes value and unit: the key's, which may continue with words, "m along the route". `text` has FACT_MAX bytes. */
static const char *say_fact(const Fact *fact, hawser_units units, char *text)
{
    char digits[HAWSER_SHOWN_MAX];
    const char *const unit = unit_of_key(fact->key);
    const size_t n = strncmp(fact->unit, unit, strlen(unit)) ? 0 : strlen(unit);
    const Scale scale = scale_of(n ? unit : "", fact->cell.value, units);
    if (fact->cell.text) return hawser_show_text(fact->cell.text, units, text, FACT_MAX);
    if (!isfinite(fact->cell.value)) return "-";
    snprintf(text, FACT_MAX, "%s%s%s%s%s", say_digits(fact->cell.value * scale.factor, PAGE_DIGITS, digits),
             *scale.unit ? " " : "", scale.unit, !n && *fact->unit ? " " : "", fact->unit + n);
    return text;
}

static void print_fact(FILE *f, const Fact *fact, int width, hawser_units units)
{
    char text[FACT_MAX];
    fprintf(f, "  %-*s  ", width, fact->label);
    print_wrapped(f, say_fact(fact, units, text), width + 4, PAGE - width - 4);
    fputc('\n', f);
}

/* Aligns the values below each other. */
static void print_facts(FILE *f, const Document *doc, hawser_units units)
{
    int width = 0;
    for (int i = 0; i < doc->n_facts; i++) {
        const int w = doc->fact[i].label ? (int)strlen(doc->fact[i].label) : 0;
        if (w > width) width = w;
    }
    for (int i = 0; i < doc->n_facts; i++) {
        if (doc->fact[i].label) print_fact(f, &doc->fact[i], width, units);
    }
}

void document_print(FILE *f, const Document *doc, hawser_units units)
{
    fprintf(f, "%s\n", doc->title);
    if (doc->answer) fprintf(f, "\n%s%s", doc->answer, doc->n_facts > 0 ? "\n" : "");
    print_facts(f, doc, units);
    for (int i = 0; i < doc->n_tables; i++) print_table(f, &doc->table[i], units);
}

/* -------------------------------------------------------------------------------------------------- parts of a page */

static void print_escaped(FILE *f, const char *text, int length)
{
    for (int i = 0; i < length && text[i]; ++i) {
        const char *const by = text[i] == '<' ? "&lt;" : text[i] == '>' ? "&gt;" : text[i] == '&' ? "&amp;" : NULL;
        if (by) fputs(by, f);
        if (!by) fputc(text[i], f);
    }
}

/* Prints a text of the program in the page's language. */
static void print_words(FILE *f, Language language, const char *english)
{
    char text[WORDS_MAX];
    print_escaped(f, words_in(language, english, text), WORDS_MAX);
}

/* Checks whether a column holds names of the case, which stay as they are; other columns may hold words. */
static int has_names(const Column *column)
{
    static const char *const labels[] = {"piece", "duct", "pushed by", "of"};
    int names = !strcmp(column->key, "piece") || !strcmp(column->key, "where");
    for (size_t k = 0; k < sizeof labels / sizeof *labels; ++k) names |= !strcmp(column->label, labels[k]);
    return names;
}

/* Prints numbers in classless cells to the right, words in cells of class "w". */
static void print_html_table(FILE *f, const Table *t, hawser_units units, Language language)
{
    Page page = {.table = t, .units = units};
    char text[CELL_MAX];
    for (int c = 0; c < t->columns.n; ++c) add_column(&page, &t->columns.column[c]);
    fputs("<h2>", f);
    print_words(f, language, hawser_show_text(t->heading, units, text, sizeof text));
    fputs("</h2>\n<div class=\"wide\"><table><thead><tr>", f);
    for (int c = 0; c < page.n; ++c) {
        const ColumnShape *const s = &page.shape[c];
        snprintf(text, sizeof text, "%.*s", s->label, s->column->label);
        fputs(s->left ? "<th class=\"w\">" : "<th>", f);
        print_words(f, language, text);
        if (*s->scale.unit) fprintf(f, "<br><small>%s</small>", s->scale.unit);
    }
    fputs("</tr></thead><tbody>\n", f);
    for (int r = 0; r < t->n; ++r) {
        fputs("<tr>", f);
        for (int c = 0; c < page.n; ++c) {
            const ColumnShape *const s = &page.shape[c];
            fputs(s->left ? "<td class=\"w\">" : "<td>", f);
            const char *const said = say_cell(&page, s, r, text);
            const int name = !s->left || (has_names(s->column) && strncmp(said, "the ", 4) != 0);
            print_words(f, name ? LANGUAGE_ENGLISH : language, said);
        }
        fputs("</tr>\n", f);
    }
    fputs("</tbody></table></div>\n", f);
}

int document_print_html(FILE *f, const Document *doc, int units)
{
    char text[FACT_MAX];
    if (doc->n_facts > 0) fputs("<dl>\n", f);
    for (int i = 0; i < doc->n_facts; ++i) {
        if (!doc->fact[i].label) continue;
        fputs("<dt>", f);
        print_words(f, doc->language, doc->fact[i].label);
        fputs("</dt><dd>", f);
        print_words(f, doc->language, say_fact(&doc->fact[i], (hawser_units)units, text));
        fputs("</dd>\n", f);
    }
    if (doc->n_facts > 0) fputs("</dl>\n", f);
    for (int i = 0; i < doc->n_tables; ++i) print_html_table(f, &doc->table[i], (hawser_units)units, doc->language);
    return !ferror(f);
}
