/* Tables as a workbook (.xlsx): Office Open XML (ECMA-376, part 1, section 18) with a sheet for each table, its
 * columns' labels in a row that stays in view, numbers as numbers in SI units, texts as texts, so that no cell is a
 * formula. */
#include "io/results/workbook.h"

#include "core/base/error.h"

#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <zip.h>

/* What libzip and its random numbers may take, bytes: they do not survive an allocation that fails. */
enum { ZIP_ROOM = 4 << 20 };

#define MAIN "http://schemas.openxmlformats.org/"
static const char xml[] = "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n";

static void plain_add(Growing *g, const char *text) { growing_add(g, text, strlen(text)); }

/* A text of XML 1.0, which has no control characters. */
static void words_add(Growing *g, const char *words)
{
    for (const char *at = words; *at; ++at) {
        const char *const by = *at == '<'   ? "&lt;"
                               : *at == '>' ? "&gt;"
                               : *at == '&' ? "&amp;"
                               : *at == '"' ? "&quot;"
                                            : NULL;
        if (by) plain_add(g, by);
        if (!by) growing_add(g, (unsigned char)*at < ' ' || *at == 0x7F ? "?" : at, 1);
    }
}

static void number_add(Growing *g, const char *before, double value, const char *behind)
{
    char text[40];
    snprintf(text, sizeof text, "%.10g", value);
    plain_add(g, before);
    plain_add(g, text);
    plain_add(g, behind);
}

/* style 1: bold. */
static void cell_add(Growing *g, Cell cell, int style)
{
    if (!cell.text && !isfinite(cell.value)) {
        plain_add(g, "<c/>");
    } else if (!cell.text) {
        number_add(g, "<c><v>", cell.value, "</v></c>");
    } else {
        plain_add(g, style ? "<c t=\"inlineStr\" s=\"1\"><is><t xml:space=\"preserve\">"
                           : "<c t=\"inlineStr\"><is><t xml:space=\"preserve\">");
        words_add(g, cell.text);
        plain_add(g, "</t></is></c>");
    }
}

static void sheet_make(Growing *g, const Table *t)
{
    plain_add(g, xml);
    plain_add(g,
              "<worksheet xmlns=\"" MAIN "spreadsheetml/2006/main\"><sheetViews><sheetView workbookViewId=\"0\"><pane "
              "ySplit=\"1\" topLeftCell=\"A2\" activePane=\"bottomLeft\" state=\"frozen\"/></sheetView></sheetViews>");
    number_add(g, "<cols><col min=\"1\" max=\"", t->columns.n,
               "\" width=\"16\" customWidth=\"1\"/></cols><sheetData><row>");
    for (int c = 0; c < t->columns.n; ++c) {
        const Column *const column = &t->columns.column[c];
        cell_add(g, cell_text(column->label ? column->label : column->key), 1);
    }
    plain_add(g, "</row>");
    for (int r = 0; r < t->n; ++r) {
        const char *const row = (const char *)t->rows + (size_t)r * t->columns.size;
        plain_add(g, "<row>");
        for (int c = 0; c < t->columns.n; ++c) cell_add(g, column_cell(&t->columns.column[c], row), 0);
        plain_add(g, "</row>");
    }
    plain_add(g, "</sheetData></worksheet>\n");
}

/* The parts around the sheets: what the package holds, and the list of its sheets. */
static void parts_make(const Document *doc, Growing *types, Growing *book, Growing *links)
{
    char line[512];
    plain_add(types, xml);
    plain_add(
        types,
        "<Types xmlns=\"" MAIN "package/2006/content-types\"><Default Extension=\"rels\" ContentType=\"application/"
        "vnd.openxmlformats-package.relationships+xml\"/><Default Extension=\"xml\" ContentType=\"application/"
        "vnd.openxmlformats-officedocument.spreadsheetml.worksheet+xml\"/><Override PartName=\"/xl/workbook.xml\" "
        "ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml.sheet.main+xml\"/><Override "
        "PartName=\"/xl/styles.xml\" ContentType=\"application/vnd.openxmlformats-officedocument.spreadsheetml."
        "styles+xml\"/></Types>\n");
    plain_add(book, xml);
    plain_add(book, "<workbook xmlns=\"" MAIN "spreadsheetml/2006/main\" xmlns:r=\"" MAIN
                    "officeDocument/2006/relationships\"><sheets>");
    plain_add(links, xml);
    plain_add(links, "<Relationships xmlns=\"" MAIN "package/2006/relationships\">");
    for (int k = 0; k < doc->n_tables; ++k) {
        snprintf(line, sizeof line, "<sheet name=\"%.30s\" sheetId=\"%d\" r:id=\"rId%d\"/>", doc->table[k].key, k + 1,
                 k + 1);
        plain_add(book, line);
        snprintf(line, sizeof line,
                 "<Relationship Id=\"rId%d\" Type=\"" MAIN
                 "officeDocument/2006/relationships/worksheet\" Target=\"worksheets/sheet%d.xml\"/>",
                 k + 1, k + 1);
        plain_add(links, line);
    }
    plain_add(book, "</sheets></workbook>\n");
    snprintf(line, sizeof line,
             "<Relationship Id=\"rId%d\" Type=\"" MAIN
             "officeDocument/2006/relationships/styles\" Target=\"styles.xml\"/></Relationships>\n",
             doc->n_tables + 1);
    plain_add(links, line);
}

static const char root_links[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<Relationships xmlns=\"" MAIN
    "package/2006/relationships\"><Relationship Id=\"rId1\" Type=\"" MAIN
    "officeDocument/2006/relationships/officeDocument\" Target=\"xl/workbook.xml\"/></Relationships>\n";
static const char styles[] =
    "<?xml version=\"1.0\" encoding=\"UTF-8\" standalone=\"yes\"?>\n<styleSheet xmlns=\"" MAIN
    "spreadsheetml/2006/main\"><fonts count=\"2\"><font><sz val=\"11\"/><name val=\"Calibri\"/></font><font><b/><sz "
    "val=\"11\"/><name val=\"Calibri\"/></font></fonts><fills count=\"1\"><fill><patternFill "
    "patternType=\"none\"/></fill>"
    "</fills><borders count=\"1\"><border/></borders><cellStyleXfs count=\"1\"><xf/></cellStyleXfs><cellXfs "
    "count=\"2\"><xf "
    "fontId=\"0\"/><xf fontId=\"1\" applyFont=\"1\"/></cellXfs></styleSheet>\n";

/* Adds a part, whose bytes stay until the archive is closed; the same date in every archive. Returns whether it could.
 */
static int part_add(zip_t *zip, const char *name, const char *bytes, size_t size)
{
    static const time_t date = 631152000; /* 1990-01-01 */
    zip_source_t *const source = bytes ? zip_source_buffer(zip, bytes, size, 0) : NULL;
    const zip_int64_t at = source ? zip_file_add(zip, name, source, ZIP_FL_ENC_UTF_8) : -1;
    if (at < 0) zip_source_free(source);
    return at >= 0 && !zip_file_set_mtime(zip, (zip_uint64_t)at, date, 0);
}

/* The archive's bytes, malloc'ed; NULL: no memory. */
static char *archive_bytes(zip_source_t *source, size_t *size)
{
    char *bytes = NULL;
    if (zip_source_open(source)) return NULL;
    const int sought = zip_source_seek(source, 0, SEEK_END);
    const zip_int64_t n = sought ? -1 : zip_source_tell(source);
    if (n > 0 && !zip_source_seek(source, 0, SEEK_SET)) bytes = malloc((size_t)n);
    if (bytes && zip_source_read(source, bytes, (zip_uint64_t)n) != n) {
        free(bytes);
        bytes = NULL;
    }
    zip_source_close(source);
    *size = (size_t)n;
    return bytes;
}

/* [n_tables + 3] parts into an archive. */
static char *archive_make(const Document *doc, const Growing *part, size_t *size)
{
    char name[64];
    zip_source_t *const source = zip_source_buffer_create(NULL, 0, 0, NULL);
    zip_t *zip = source ? zip_open_from_source(source, ZIP_TRUNCATE, NULL) : NULL;
    if (!zip) {
        zip_source_free(source);
        return NULL;
    }
    zip_source_keep(source);
    const Growing *const types = &part[doc->n_tables], *const book = types + 1, *const links = types + 2;
    int ok = part_add(zip, "[Content_Types].xml", types->text, types->size) &&
             part_add(zip, "_rels/.rels", root_links, sizeof root_links - 1) &&
             part_add(zip, "xl/workbook.xml", book->text, book->size) &&
             part_add(zip, "xl/_rels/workbook.xml.rels", links->text, links->size) &&
             part_add(zip, "xl/styles.xml", styles, sizeof styles - 1);
    for (int k = 0; ok && k < doc->n_tables; ++k) {
        snprintf(name, sizeof name, "xl/worksheets/sheet%d.xml", k + 1);
        ok = part_add(zip, name, part[k].text, part[k].size);
    }
    if (!ok || zip_close(zip)) {
        zip_discard(zip);
        zip_source_free(source);
        return NULL;
    }
    char *const bytes = archive_bytes(source, size);
    zip_source_free(source);
    return bytes;
}

hawser_status workbook_make(const Document *doc, char **bytes, size_t *size, hawser_error *err)
{
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    const int n = doc->n_tables + 3;
    Growing *const part = calloc((size_t)n, sizeof *part);
    int bad = !part || !plain || !memory_room(ZIP_ROOM);
    *bytes = NULL;
    if (!bad) {
        const locale_t before = uselocale(plain);
        for (int k = 0; k < doc->n_tables; ++k) sheet_make(&part[k], &doc->table[k]);
        parts_make(doc, &part[n - 3], &part[n - 2], &part[n - 1]);
        uselocale(before);
    }
    for (int k = 0; part && k < n; ++k) bad |= part[k].bad;
    if (!bad) *bytes = archive_make(doc, part, size);
    for (int k = 0; part && k < n; ++k) free(part[k].text);
    free(part);
    if (plain) freelocale(plain);
    return *bytes ? HAWSER_OK : error_memory(err);
}
