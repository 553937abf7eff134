/* Archives: spreadsheets, .xlsx (ECMA-376) and .ods (OpenDocument 1.2), the cells of one sheet as text, a row per line,
 * read like any table; and KMZ, whose KML is read like any KML. */
#define _GNU_SOURCE /* locale_t, fdopen */
#include <expat.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>
#include <unistd.h>
#include <zip.h>

#include "core/error.h"
#include "survey/table.h"

enum {
    CHUNK = 1 << 16,
    CELL_MOST = 4000, /* characters of a cell; longer notes are cut */
    CELLS_MOST = 5000000,
    ROWS_MOST = 1 << 24,
    COLUMNS_MOST = 1 << 14,
    MERGES_MOST = 100000,
    NAMES_SHOWN = 400
};
static const size_t UNPACKED_MOST = (size_t)300 << 20, STORE_MOST = (size_t)200 << 20;

/* ---------------------------------------------------------------------------------------------------------- the book
 */

typedef struct Cell {
    int row, column; /* from 0 */
    size_t text;     /* its place in the store */
} Cell;

/* Rows and columns of a merged cell. */
typedef struct Merge {
    int row, column, last;
} Merge;

typedef struct Sheet {
    size_t name, id; /* in the store; id: of the relation to its file */
} Sheet;

/* Display of a number by a style of .xlsx. */
typedef struct Format {
    int id; /* of a code defined by the file */
    enum { SHOWN_PLAIN, SHOWN_DATE, SHOWN_PERCENT } shown;
    char unit[16]; /* text after the number; "": none */
} Format;

typedef struct Book {
    SurveyInput *in;
    zip_t *zip;
    XML_Parser parser;
    hawser_status status;
    size_t left;    /* bytes that may still be unpacked */
    char *store;    /* texts, each with its 0 */
    int stored;     /* bytes of it */
    size_t room;    /* of the store */
    Sheet *sheet;   /* [n_sheets] */
    size_t *shared; /* [n_shared] texts that cells refer to by number */
    Format *format, *style;
    Cell *cell;
    Merge *merge;
    int n_sheets, n_shared, n_formats, n_styles, n_cells, n_merges;
    int from_1904; /* days count from 1904 */
    int chosen;    /* the sheet being read */
    const char *id;
    char target[300], strings[300], styles[300]; /* files inside the archive */
    /* position of the reader */
    int row, column, last_row, last_column, repeated, rows_repeated, first; /* first: cell of the row */
    int skip, taken, sheets_seen, formula, style_at, in_styles, shown_row, percent, paragraphs;
    char type[20], value[64];
    char text[CELL_MOST + 8];
    size_t size;
} Book;

static void stop(Book *b, hawser_status status)
{
    b->status = status;
    if (b->parser) XML_StopParser(b->parser, XML_FALSE);
}

/* Stores a text; returns its place. 0: there is no memory, or too much text. */
static size_t keep(Book *b, const char *text)
{
    const size_t size = strlen(text) + 1, at = (size_t)b->stored;
    if (at + size > STORE_MOST) return stop(b, input_error(b->in, "more than %zu MB of text", STORE_MOST >> 20)), 0;
    if (at + size > b->room) {
        const size_t room = 2 * (at + size);
        char *const grown = realloc(b->store, room);
        if (!grown) return stop(b, error_memory(b->in->err)), 0;
        b->store = grown;
        b->room = room;
    }
    memcpy(b->store + at, text, size);
    b->stored += (int)size;
    return at;
}

static const char *local(const char *name)
{
    const char *const colon = strchr(name, ':');
    return colon ? colon + 1 : name;
}
static int is(const char *name, const char *what) { return !strcmp(local(name), what); }
static const char *attribute(const char **atts, const char *name)
{
    for (; *atts; atts += 2)
        if (is(*atts, name)) return atts[1];
    return NULL;
}
static int whole(const char *text, int most)
{
    const long value = text ? strtol(text, NULL, 10) : 0;
    return value < 0 ? 0 : value > most ? most : (int)value;
}

static void XMLCALL text_add(void *data, const XML_Char *text, int n)
{
    Book *const b = data;
    for (int i = 0; i < n && b->taken && !b->skip && b->size < CELL_MOST; ++i) {
        const unsigned char c = (unsigned char)text[i];
        b->text[b->size++] = c < 0x20 ? ' ' : (char)c;
    }
    while (b->size == CELL_MOST && ((unsigned char)b->text[b->size - 1] & 0x80)) --b->size; /* no partial characters */
    b->text[b->size] = 0;
}
static void text_begin(Book *b)
{
    b->taken = 1;
    b->size = 0;
    *b->text = 0;
}

static void XMLCALL doctype(void *data, const XML_Char *name, const XML_Char *system, const XML_Char *public_, int own)
{
    (void)name, (void)system, (void)public_, (void)own;
    Book *const b = data;
    stop(b, input_error(b->in, "a DOCTYPE, which no spreadsheet has"));
}

/* Reads a file of the archive. Returns 0 if there is none of that name. */
static int part_read(Book *b, const char *name, XML_StartElementHandler begin, XML_EndElementHandler end)
{
    zip_file_t *const file = zip_fopen(b->zip, name, ZIP_FL_NOCASE);
    if (!file) return 0;
    b->taken = b->skip = 0;
    b->parser = XML_ParserCreate(NULL);
    if (!b->parser) b->status = error_memory(b->in->err);
    if (b->parser) {
        XML_SetUserData(b->parser, b);
        XML_SetElementHandler(b->parser, begin, end);
        XML_SetCharacterDataHandler(b->parser, text_add);
        XML_SetStartDoctypeDeclHandler(b->parser, doctype);
    }
    for (int last = 0; !last && !b->status;) {
        void *const buffer = XML_GetBuffer(b->parser, CHUNK);
        const zip_int64_t n = buffer ? zip_fread(file, buffer, CHUNK) : 0;
        if (!buffer)
            stop(b, error_memory(b->in->err));
        else if (n < 0)
            stop(b, input_error(b->in, "'%.100s' in it cannot be unpacked: %s", name, zip_file_strerror(file)));
        else if ((size_t)n > b->left)
            stop(b, input_error(b->in, "more than %zu MB when it is unpacked", UNPACKED_MOST >> 20));
        if (b->status) break;
        b->left -= (size_t)n;
        last = n == 0;
        if (XML_ParseBuffer(b->parser, (int)n, last) == XML_STATUS_OK || b->status) continue;
        stop(b, input_error(b->in, "'%.100s' in it: line %lu is no XML: %s", name,
                            (unsigned long)XML_GetCurrentLineNumber(b->parser),
                            XML_ErrorString(XML_GetErrorCode(b->parser))));
    }
    if (b->parser) XML_ParserFree(b->parser);
    b->parser = NULL;
    zip_fclose(file);
    return 1;
}

/* ---------------------------------------------------------------------------------------------------------- cells */

static void cell_add(Book *b, int row, int column, size_t text)
{
    if (row >= ROWS_MOST || column >= COLUMNS_MOST || b->n_cells >= CELLS_MOST) {
        stop(b, input_error(b->in, "a sheet of more than %d rows, %d columns or %d cells", ROWS_MOST, COLUMNS_MOST,
                            CELLS_MOST));
        return;
    }
    Cell *const cell = survey_one_more(&b->cell, &b->n_cells, sizeof *b->cell);
    if (!cell)
        stop(b, error_memory(b->in->err));
    else
        *cell = (Cell){row, column, text};
}

/* Refuses a formula without a value, written by a program that does not calculate. */
static void valueless(Book *b)
{
    stop(b, input_error(b->in, "a formula without its value: open the file with a spreadsheet program, and save it"));
}

static int is_number(const Book *b, const char *text)
{
    double value;
    return input_number_whole(b->in, text, &value);
}

/* Reads the unit displayed after a number, if it is known: " ft" of "0.0 ft". */
static void unit_take(const char *text, size_t size, char unit[16])
{
    while (size && *text == ' ') ++text, --size;
    while (size && text[size - 1] == ' ') --size;
    *unit = 0;
    if (size && size < 14 && unit_find(text, size)) snprintf(unit, 16, " %.*s", (int)size, text);
}

/* Writes a number of days as a date, or below one as a time of day. */
static void date_print(double days, char *text, size_t room)
{
    if (!(days >= 0 && days < 3e6)) {
        snprintf(text, room, "(no date)");
        return;
    }
    if (days < 1) {
        const int s = (int)(days * 86400 + 0.5);
        snprintf(text, room, "%02d:%02d:%02d", s / 3600, s / 60 % 60, s % 60);
        return;
    }
    /* the Gregorian calendar by eras of 400 years, from 0000-03-01, which is 693 899 days before 1899-12-30 */
    const long z = (long)days + 693899, era = z / 146097, day = z % 146097;
    const long year = (day - day / 1460 + day / 36524 - day / 146096) / 365,
               in_year = day - (365 * year + year / 4 - year / 100);
    const long m = (5 * in_year + 2) / 153, month = m < 10 ? m + 3 : m - 9;
    snprintf(text, room, "%04ld-%02ld-%02ld", year + era * 400 + (month <= 2), month, in_year - (153 * m + 2) / 5 + 1);
}

/* Writes a number as its style displays it. */
static void number_show(const Book *b, const Format *format, char *text, size_t room)
{
    double value;
    char plain[64];
    if (!input_number_whole(b->in, text, &value)) return;
    snprintf(plain, sizeof plain, "%.40s", text);
    if (format->shown == SHOWN_DATE)
        date_print(value + (b->from_1904 ? 1462 : 0), text, room);
    else if (format->shown == SHOWN_PERCENT)
        snprintf(text, room, "%.15g%%", value * 100);
    else if (*format->unit)
        snprintf(text, room, "%s%s", plain, format->unit);
}

static int by_place(const void *a, const void *b)
{
    const Cell *const x = a, *const y = b;
    return x->row != y->row ? (x->row > y->row) - (x->row < y->row) : (x->column > y->column) - (x->column < y->column);
}

/* Copies the text of a cell merged over several rows to each of them, since a head may be two rows high. The cells stay
 * sorted. */
static void merges_spread(Book *b)
{
    const size_t n = (size_t)b->n_cells;
    for (int i = 0; i < b->n_merges && !b->status; ++i) {
        const Merge *const m = &b->merge[i];
        const Cell key = {.row = m->row, .column = m->column};
        const Cell *const of = bsearch(&key, b->cell, n, sizeof *b->cell, by_place);
        if (!of || is_number(b, b->store + of->text)) continue;
        const size_t text = of->text;
        const int end = m->last < b->last_row ? m->last : b->last_row;
        for (int row = m->row + 1; row <= end && !b->status; ++row) cell_add(b, row, m->column, text);
    }
    qsort(b->cell, (size_t)b->n_cells, sizeof *b->cell, by_place);
}

/* Converts the sheet to text, a row per line, cells separated by a special character; the input reads it from now on.
 */
static hawser_status sheet_hold(Book *b)
{
    enum { SEPARATOR = '\x1F' };
    size_t size = 2;
    int row = 0, column = -1;
    if (b->n_cells == 0) return input_error(b->in, "the sheet '%.100s' is empty", b->store + b->sheet[b->chosen].name);
    qsort(b->cell, (size_t)b->n_cells, sizeof *b->cell, by_place);
    merges_spread(b);
    if (b->status) return b->status;
    for (int i = 0; i < b->n_cells; ++i) {
        const Cell *const c = &b->cell[i];
        if (c->row > row) size += (size_t)(c->row - row) * 2, column = -1;
        size += strlen(b->store + c->text) + (size_t)(c->column - (c->row > row ? -1 : column)) + 2;
        row = c->row;
        column = c->column;
        if (size > STORE_MOST) return input_error(b->in, "more than %zu MB of text", STORE_MOST >> 20);
    }
    char *const text = malloc(size), *to = text;
    if (!text) return error_memory(b->in->err);
    *to++ = SEPARATOR;
    row = 0;
    column = 0;
    for (int i = 0; i < b->n_cells; ++i) {
        const Cell *const c = &b->cell[i];
        if (i && c->row == b->cell[i - 1].row && c->column == b->cell[i - 1].column) continue;
        for (; row < c->row; ++row, column = 0) *to++ = '\n', *to++ = SEPARATOR;
        for (; column < c->column; ++column) *to++ = SEPARATOR;
        const size_t n = strlen(b->store + c->text);
        memcpy(to, b->store + c->text, n);
        to += n;
    }
    *to++ = '\n';
    return input_hold(b->in, text, (size_t)(to - text));
}

/* Chooses the sheet: the first, or by name or number; the others are reported as unread. */
static hawser_status sheet_choose(Book *b)
{
    const char *const sheet = b->in->options.sheet;
    char names[NAMES_SHOWN + 1] = "", *rest;
    size_t n = 0;
    b->chosen = sheet ? -1 : 0;
    for (int i = 0; i < b->n_sheets; ++i) {
        const char *const name = b->store + b->sheet[i].name;
        if (sheet && b->chosen < 0 && !strcasecmp(name, sheet)) b->chosen = i;
        if (n < NAMES_SHOWN) n += (size_t)snprintf(names + n, NAMES_SHOWN - n, "%s'%.60s'", i ? ", " : "", name);
    }
    const long number = sheet ? strtol(sheet, &rest, 10) : 0;
    if (b->chosen < 0 && rest > sheet && !*rest && number >= 1 && number <= b->n_sheets) b->chosen = (int)number - 1;
    if (b->n_sheets == 0) return input_error(b->in, "a workbook without a sheet of cells");
    if (b->chosen < 0) return input_error(b->in, "no sheet '%.60s'; there are %s", sheet, names);
    for (int i = 0; i < b->n_sheets; ++i) {
        char what[SURVEY_NAME_MAX];
        snprintf(what, sizeof what, "the sheet '%.80s'", b->store + b->sheet[i].name);
        if (i != b->chosen) survey_ignore(b->in->out, what);
    }
    return HAWSER_OK;
}

/* -------------------------------------------------------------------------------------------------------------- .xlsx
 */

static void XMLCALL workbook_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    const char *const given = attribute(atts, "name"), *const id = attribute(atts, "id");
    const char *const from_1904 = is(name, "workbookPr") ? attribute(atts, "date1904") : NULL;
    if (from_1904) b->from_1904 = !strcmp(from_1904, "1") || !strcmp(from_1904, "true");
    if (!is(name, "sheet") || !given || !id) return;
    const size_t kept = keep(b, given), kept_id = keep(b, id);
    Sheet *const sheet = b->status ? NULL : survey_one_more(&b->sheet, &b->n_sheets, sizeof *b->sheet);
    if (sheet)
        *sheet = (Sheet){kept, kept_id};
    else if (!b->status)
        stop(b, error_memory(b->in->err));
}
static void XMLCALL nothing(void *data, const XML_Char *name) { (void)data, (void)name; }

static int ends(const char *text, const char *with)
{
    const size_t n = strlen(text), m = strlen(with);
    return n >= m && !strcmp(text + n - m, with);
}

/* Reads a relation: finds the files of the chosen sheet, of texts and of styles; sheets without cells are removed
 * first. */
static void XMLCALL relation_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    const char *const type = attribute(atts, "Type"), *const target = attribute(atts, "Target");
    const char *const id = attribute(atts, "Id");
    if (!is(name, "Relationship") || !type || !target || !id) return;
    char *const to = ends(type, "/sharedStrings")                              ? b->strings
                     : ends(type, "/styles")                                   ? b->styles
                     : b->id && !strcmp(id, b->id) && ends(type, "/worksheet") ? b->target
                                                                               : NULL;
    if (to) snprintf(to, sizeof b->target, "%s%.250s", *target == '/' ? "" : "xl/", target + (*target == '/'));
    for (int i = 0; i < b->n_sheets && !b->id; ++i) {
        if (strcmp(b->store + b->sheet[i].id, id) || ends(type, "/worksheet")) continue;
        memmove(&b->sheet[i], &b->sheet[i + 1], (size_t)(b->n_sheets - i - 1) * sizeof *b->sheet);
        --b->n_sheets;
        break;
    }
}

static void XMLCALL strings_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    (void)atts;
    if (is(name, "si")) text_begin(b), b->taken = 0;
    if (is(name, "t")) b->taken = 1;
    if (is(name, "rPh")) ++b->skip; /* pronunciation */
}
static void XMLCALL strings_end(void *data, const XML_Char *name)
{
    Book *const b = data;
    if (is(name, "t")) b->taken = 0;
    if (is(name, "rPh")) --b->skip;
    if (!is(name, "si")) return;
    const size_t kept = keep(b, b->text);
    size_t *const one = b->status ? NULL : survey_one_more(&b->shared, &b->n_shared, sizeof *b->shared);
    if (one)
        *one = kept;
    else if (!b->status)
        stop(b, error_memory(b->in->err));
}

/* Interprets the code of a number's format: its first section, without colours and conditions. */
static Format code_read(int id, const char *code)
{
    Format f = {.id = id};
    for (const char *c = code; *c && *c != ';'; ++c) {
        if (*c == '"') {
            const char *const end = strchr(c + 1, '"');
            if (!end) break;
            unit_take(c + 1, (size_t)(end - c - 1), f.unit);
            c = end;
        } else if (*c == '[') {
            if (!strncasecmp(c, "[h", 2) || !strncasecmp(c, "[m", 2) || !strncasecmp(c, "[s", 2)) f.shown = SHOWN_DATE;
            c += strcspn(c, "]");
            if (!*c) break;
        } else if (*c == '\\' || *c == '_' || *c == '*') {
            if (c[1]) ++c;
        } else if (!strncasecmp(c, "general", 7)) {
            c += 6;
        } else if (strchr("yYmMdDhHsS", *c)) {
            f.shown = SHOWN_DATE;
        } else if (*c == '%' && f.shown == SHOWN_PLAIN) {
            f.shown = SHOWN_PERCENT;
        }
    }
    return f;
}

static Format format_of(const Book *b, int id)
{
    for (int i = 0; i < b->n_formats; ++i)
        if (b->format[i].id == id) return b->format[i];
    const int date =
        (id >= 14 && id <= 22) || (id >= 27 && id <= 36) || (id >= 45 && id <= 47) || (id >= 50 && id <= 58);
    return (Format){.id = id, .shown = date ? SHOWN_DATE : id == 9 || id == 10 ? SHOWN_PERCENT : SHOWN_PLAIN};
}

static void XMLCALL styles_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    const char *const code = attribute(atts, "formatCode"), *const id = attribute(atts, "numFmtId");
    if (is(name, "cellXfs")) b->in_styles = 1;
    if (is(name, "numFmt") && code) {
        Format *const one = survey_one_more(&b->format, &b->n_formats, sizeof *b->format);
        if (one) *one = code_read(whole(id, 1 << 30), code);
    } else if (is(name, "xf") && b->in_styles) {
        const Format format = format_of(b, whole(id, 1 << 30));
        Format *const one = survey_one_more(&b->style, &b->n_styles, sizeof *b->style);
        if (one) *one = format;
    }
}
static void XMLCALL styles_end(void *data, const XML_Char *name)
{
    Book *const b = data;
    if (is(name, "cellXfs")) b->in_styles = 0;
}

/* Reads "AB12" as row and column from 0. Returns 0 if it is not a place. */
static int place_read(const char *text, int *row, int *column)
{
    int letters = 0;
    *column = 0;
    for (; (*text | 32) >= 'a' && (*text | 32) <= 'z' && letters < 4; ++text, ++letters)
        *column = 26 * *column + (*text | 32) - 'a' + 1;
    *row = whole(text, ROWS_MOST) - 1;
    --*column;
    return letters && *row >= 0;
}

static void XMLCALL cells_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    const char *const at = attribute(atts, "r"), *const type = attribute(atts, "t"), *const s = attribute(atts, "s");
    const char *const ref = attribute(atts, "ref");
    if (is(name, "row")) {
        b->row = at ? whole(at, ROWS_MOST) - 1 : b->row + 1;
        b->column = -1;
    } else if (is(name, "c")) {
        if (!at || !place_read(at, &b->row, &b->column)) ++b->column;
        snprintf(b->type, sizeof b->type, "%s", type ? type : "n");
        b->style_at = whole(s, 1 << 30);
        b->formula = 0;
        text_begin(b);
        b->taken = 0;
    } else if (is(name, "v") || is(name, "t")) {
        b->taken = 1;
    } else if (is(name, "f")) {
        b->formula = 1;
    } else if (is(name, "rPh")) {
        ++b->skip;
    } else if (is(name, "mergeCell") && ref) {
        const char *const to = strchr(ref, ':');
        Merge m;
        int column;
        if (!to || !place_read(ref, &m.row, &m.column) || !place_read(to + 1, &m.last, &column) || m.last <= m.row)
            return;
        Merge *const one =
            b->n_merges < MERGES_MOST ? survey_one_more(&b->merge, &b->n_merges, sizeof *b->merge) : NULL;
        if (one) *one = m;
    }
}

static void XMLCALL cells_end(void *data, const XML_Char *name)
{
    Book *const b = data;
    if (is(name, "v") || is(name, "t")) b->taken = 0;
    if (is(name, "rPh")) --b->skip;
    if (!is(name, "c")) return;
    b->in->line = b->row + 1;
    if (!*b->text && b->formula && strcmp(b->type, "str")) valueless(b);
    if (!*b->text || b->status) return;
    size_t text = 0;
    if (!strcmp(b->type, "s")) {
        const int i = whole(b->text, 1 << 30);
        if (i >= b->n_shared || !is_number(b, b->text)) {
            stop(b, input_error(b->in, "a cell of text %.20s, and there are %d", b->text, b->n_shared));
            return;
        }
        text = b->shared[i];
    } else {
        if (!strcmp(b->type, "b")) snprintf(b->text, sizeof b->text, "%s", *b->text == '1' ? "TRUE" : "FALSE");
        if (!strcmp(b->type, "n") && b->style_at < b->n_styles)
            number_show(b, &b->style[b->style_at], b->text, sizeof b->text);
        text = keep(b, b->text);
    }
    if (b->status || !b->store[text]) return;
    if (b->row > b->last_row) b->last_row = b->row;
    cell_add(b, b->row, b->column, text);
}

static hawser_status xlsx_read(Book *b)
{
    static const char relations[] = "xl/_rels/workbook.xml.rels";
    part_read(b, "xl/workbook.xml", workbook_begin, nothing);
    if (!b->status && !part_read(b, relations, relation_begin, nothing) && !b->status)
        return input_error(b->in, "a workbook without '%s'", relations);
    if (!b->status) b->status = sheet_choose(b);
    if (b->status) return b->status;
    char id[300];
    snprintf(id, sizeof id, "%.290s", b->store + b->sheet[b->chosen].id);
    b->id = id;
    part_read(b, relations, relation_begin, nothing);
    b->id = NULL;
    if (!b->status && *b->strings) part_read(b, b->strings, strings_begin, strings_end);
    if (!b->status && *b->styles) part_read(b, b->styles, styles_begin, styles_end);
    b->row = -1;
    if (!b->status && !part_read(b, b->target, cells_begin, cells_end) && !b->status)
        return input_error(b->in, "a workbook without the file '%.100s' of its sheet", b->target);
    return b->status;
}

/* --------------------------------------------------------------------------------------------------------------- .ods
 */

static void XMLCALL ods_begin(void *data, const XML_Char *name, const XML_Char **atts)
{
    Book *const b = data;
    if (b->skip || is(name, "annotation") || !strncmp(name, "draw:", 5)) {
        ++b->skip;
        return;
    }
    const char *const type = attribute(atts, "value-type");
    const char *const date = attribute(atts, "date-value"), *const value = attribute(atts, "value");
    if (is(name, "table")) {
        const char *const given = attribute(atts, "name");
        if (b->chosen < 0) { /* the first pass reads the names */
            const size_t kept = keep(b, given ? given : "");
            Sheet *const sheet = b->status ? NULL : survey_one_more(&b->sheet, &b->n_sheets, sizeof *b->sheet);
            if (sheet) *sheet = (Sheet){kept, kept};
        }
        b->shown_row = b->sheets_seen++ == b->chosen;
        b->row = 0;
    }
    if (!b->shown_row) return;
    if (is(name, "table-row")) {
        const char *const times = attribute(atts, "number-rows-repeated");
        b->rows_repeated = times ? whole(times, ROWS_MOST) : 1;
        b->first = b->n_cells;
        b->column = 0;
    } else if (is(name, "table-cell") || is(name, "covered-table-cell")) {
        const char *const times = attribute(atts, "number-columns-repeated");
        const int rows = whole(attribute(atts, "number-rows-spanned"), ROWS_MOST);
        b->repeated = times ? whole(times, COLUMNS_MOST) : 1;
        b->formula = attribute(atts, "formula") && !type;
        b->percent = type && !strcmp(type, "percentage");
        snprintf(b->value, sizeof b->value, "%.60s", date ? date : value ? value : "");
        b->paragraphs = 0;
        text_begin(b);
        b->taken = 0;
        if (rows > 1 && b->n_merges < MERGES_MOST) {
            Merge *const one = survey_one_more(&b->merge, &b->n_merges, sizeof *b->merge);
            if (one) *one = (Merge){b->row, b->column, b->row + rows - 1};
        }
    } else if (is(name, "p")) {
        b->taken = 1;
        if (b->paragraphs++) text_add(b, " ", 1);
    } else if (is(name, "s") || is(name, "tab") || is(name, "line-break")) {
        text_add(b, " ", 1);
    }
}

/* Stores the value of a numeric cell, with the unit that it displays. */
static void ods_value(Book *b)
{
    char unit[16], text[96];
    double value;
    const char *const last = b->text + strcspn(b->text, "0123456789");
    const char *const behind = last + strspn(last, "0123456789.,' ");
    unit_take(behind, strlen(behind), unit);
    if (b->percent && input_number_whole(b->in, b->value, &value))
        snprintf(text, sizeof text, "%.15g%%", value * 100);
    else
        snprintf(text, sizeof text, "%s%s", b->value, is_number(b, b->value) ? unit : "");
    snprintf(b->text, sizeof b->text, "%s", text);
}

static void XMLCALL ods_end(void *data, const XML_Char *name)
{
    Book *const b = data;
    if (b->skip) {
        --b->skip;
        return;
    }
    if (is(name, "table")) b->shown_row = 0;
    if (!b->shown_row) return;
    if (is(name, "p")) b->taken = 0;
    if (is(name, "table-cell") || is(name, "covered-table-cell")) {
        if (*b->value) ods_value(b);
        b->in->line = b->row + 1;
        if (b->formula) valueless(b);
        const size_t kept = *b->text && is(name, "table-cell") ? keep(b, b->text) : 0;
        for (int i = 0; i < b->repeated && *b->text && is(name, "table-cell") && !b->status; ++i)
            cell_add(b, b->row, b->column + i, kept);
        b->column = b->column + b->repeated < COLUMNS_MOST ? b->column + b->repeated : COLUMNS_MOST;
    }
    if (!is(name, "table-row")) return;
    const int last = b->n_cells;
    for (int k = 1; k < b->rows_repeated && last > b->first; ++k)
        for (int i = b->first; i < last && !b->status; ++i) cell_add(b, b->row + k, b->cell[i].column, b->cell[i].text);
    if (last > b->first) b->last_row = b->row + b->rows_repeated - 1;
    b->row = b->row + b->rows_repeated < ROWS_MOST ? b->row + b->rows_repeated : ROWS_MOST;
}

static hawser_status ods_read(Book *b)
{
    b->chosen = -1;
    part_read(b, "content.xml", ods_begin, ods_end);
    if (!b->status) b->status = sheet_choose(b);
    b->sheets_seen = 0;
    if (!b->status) part_read(b, "content.xml", ods_begin, ods_end);
    return b->status;
}

/* -------------------------------------------------------------------------------------------------------------- both
 * formats */

static hawser_status book_open(Book *b)
{
    zip_error_t why;
    zip_error_init(&why);
    const int fd = dup(fileno(b->in->file));
    FILE *const own = fd < 0 ? NULL : fdopen(fd, "rb");
    zip_source_t *const source = own ? zip_source_filep_create(own, 0, -1, &why) : NULL;
    if (own && !source) fclose(own);
    b->zip = source ? zip_open_from_source(source, ZIP_RDONLY, &why) : NULL;
    if (source && !b->zip) zip_source_free(source);
    const hawser_status status =
        b->zip ? HAWSER_OK : input_error(b->in, "an archive that cannot be opened: %s", zip_error_strerror(&why));
    zip_error_fini(&why);
    return status;
}

/* Lets the input read the first KML of a KMZ, preferably one outside its folders; the others are reported as unread.
 * Returns 0 if there is none. */
static int kml_hold(Book *b)
{
    const zip_int64_t n = zip_get_num_entries(b->zip, 0);
    zip_int64_t chosen = -1;
    zip_stat_t stat;
    for (zip_int64_t i = 0; i < n; ++i) {
        const char *const name = zip_get_name(b->zip, (zip_uint64_t)i, 0);
        const size_t size = name ? strlen(name) : 0;
        if (size < 4 || strcasecmp(name + size - 4, ".kml")) continue;
        if (chosen >= 0) survey_ignore(b->in->out, "another KML of the archive");
        if (chosen < 0 || (!strchr(name, '/') && strchr(zip_get_name(b->zip, (zip_uint64_t)chosen, 0), '/')))
            chosen = i;
    }
    if (chosen < 0) return 0;
    zip_file_t *const file = zip_fopen_index(b->zip, (zip_uint64_t)chosen, 0);
    const int known = !zip_stat_index(b->zip, (zip_uint64_t)chosen, 0, &stat) && stat.valid & ZIP_STAT_SIZE;
    char *const text = known && stat.size > 0 && stat.size <= UNPACKED_MOST ? malloc(stat.size) : NULL;
    if (known && stat.size > UNPACKED_MOST)
        b->status = input_error(b->in, "more than %zu MB when it is unpacked", UNPACKED_MOST >> 20);
    else if (!file || !known || stat.size == 0)
        b->status = input_error(b->in, "its KML cannot be unpacked");
    else if (!text)
        b->status = error_memory(b->in->err);
    else if (zip_fread(file, text, stat.size) != (zip_int64_t)stat.size)
        b->status = input_error(b->in, "its KML cannot be unpacked: %s", zip_file_strerror(file));
    if (file) zip_fclose(file);
    if (b->status)
        free(text);
    else
        b->status = input_hold(b->in, text, stat.size);
    return 1;
}

hawser_status sheet_read(SurveyInput *in)
{
    Book *const b = calloc(1, sizeof *b);
    if (!b) return error_memory(in->err);
    int kmz = 0;
    b->in = in;
    b->left = UNPACKED_MOST;
    keep(b, ""); /* place 0 */
    if (!b->status) b->status = book_open(b);
    if (!b->status) {
        if (zip_name_locate(b->zip, "xl/workbook.xml", ZIP_FL_NOCASE) >= 0)
            b->status = xlsx_read(b);
        else if (zip_name_locate(b->zip, "content.xml", 0) >= 0)
            b->status = ods_read(b);
        else if (!(kmz = kml_hold(b)))
            b->status = input_error(
                in, "an archive that is no spreadsheet (.xlsx, .ods) and no KMZ: unpack it, and name a file");
    }
    if (!b->status && kmz && (in->options.sheet || in->options.ignore))
        b->status = input_error(in, "'sheet' and 'ignore' are about a spreadsheet, which a KMZ is not");
    hawser_status status = b->status;
    in->line = 0;
    if (!status && !kmz) status = sheet_hold(b);
    if (b->zip) zip_discard(b->zip);
    free(b->store);
    free(b->sheet);
    free(b->shared);
    free(b->format);
    free(b->style);
    free(b->cell);
    free(b->merge);
    free(b);
    return status ? status : kmz ? tracks_read(in) : table_read(in);
}
