#include "io/report/folder.h"

#include <ctype.h>
#include <errno.h>
#include <fcntl.h>
#include <jansson.h>
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "core/error.h"
#include "core/file.h"
#include "io/results/results_file.h"

/* Largest size of a text file, bytes: far above that of a run for a page. */
static const size_t file_most = (size_t)1 << 30;

void folder_say(Folder *folder, const char *format, ...)
{
    va_list args;
    if (folder->n_notes == FOLDER_NOTES_MAX) return;
    va_start(args, format);
    vsnprintf(folder->note[folder->n_notes++], FOLDER_NOTE_MAX, format, args);
    va_end(args);
}

char *folder_path(const Folder *folder, const char *name)
{
    const size_t size = strlen(folder->dir) + strlen(name) + 2;
    char *const path = malloc(size);
    if (path) snprintf(path, size, "%s/%s", folder->dir, name);
    return path;
}

/* Reads a whole file of text, malloc'ed. A missing file is NULL with HAWSER_OK. Errors: INPUT, MEMORY. */
static hawser_status file_read(const Folder *folder, const char *name, const char *path, char **text, hawser_error *err)
{
    size_t size;
    const hawser_status status = file_whole_in(folder->home.at, name, path, file_most, text, &size, err);
    if (!*text || strlen(*text) == size) return status;
    free(*text);
    *text = NULL;
    return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': it is no text", path);
}

/* Reads a table beside the summary. A missing, wrong or too large one is left out with a note; a read error of the
 * system is an error, since the table would otherwise be taken for missing. */
static hawser_status table_read(Folder *folder, const char *name, Sheet *sheet, hawser_error *err)
{
    hawser_error why = {HAWSER_OK, ""};
    struct stat info;
    size_t size = 0;
    char *text = NULL, *const path = folder_path(folder, name);
    if (!path) return error_memory(err);
    const int fd = file_open_in(folder->home.at, name, O_RDONLY), number = fd < 0 ? errno : 0;
    const int strange = number == ELOOP || number == ENOTBLK,
              large = fd >= 0 && !fstat(fd, &info) && (size_t)info.st_size > file_most;
    if (fd >= 0) close(fd);
    hawser_status status =
        strange || large ? HAWSER_OK : file_whole_in(folder->home.at, name, path, file_most, &text, &size, err);
    if (strange || large) {
        folder_say(folder, "cannot read '%.300s': %s", path, strange ? file_reason(number) : "it is too large");
    } else if (text && strlen(text) != size) {
        folder_say(folder, "cannot read '%.300s': it is no text", path);
        free(text);
    } else if (text) {
        const hawser_status parsed = sheet_parse(text, path, sheet, &why);
        if (parsed == HAWSER_ERR_INPUT) folder_say(folder, "%.350s", why.message);
        if (parsed == HAWSER_ERR_MEMORY) status = error_memory(err);
    }
    free(path);
    return status;
}

/* Reads the only file that is required. */
static hawser_status summary_read(Folder *folder, hawser_error *err)
{
    json_error_t where;
    int lack = 0;
    const char *const dir = folder->dir;
    char *const path = folder_path(folder, "summary.json");
    if (!path) return error_memory(err);
    hawser_status status = file_read(folder, "summary.json", path, &folder->summary_text, err);
    if (!status && !folder->summary_text)
        status = error_set(err, HAWSER_ERR_INPUT,
                           "'%.700s' holds no results: there is no summary.json, which hawser run writes", dir);
    if (!status) folder->summary = text_as_json(folder->summary_text, &where, &lack);
    if (lack) status = error_memory(err);
    if (!status && !json_is_object(folder->summary))
        status = error_set(err, HAWSER_ERR_INPUT, "%.500s:%d: not a summary of a run: %.200s", path, where.line,
                           folder->summary ? "no object" : where.text);
    free(path);
    return status;
}

/* Opens the folder itself, which the user has named. */
static hawser_status folder_enter(const char *dir, Folder *folder, hawser_error *err)
{
    *folder = (Folder){.dir = dir};
    folder->opened = !out_enter(&folder->home, dir, NULL);
    if (folder->opened) return HAWSER_OK;
    if (errno == ENOTDIR)
        return error_set(err, HAWSER_ERR_INPUT, "'%.700s' is no folder: give one that hawser run has written", dir);
    return file_unread(dir, strerror(errno), err);
}

hawser_status folder_open(const char *dir, Folder *folder, hawser_error *err)
{
    hawser_status status = folder_enter(dir, folder, err);
    if (!status) status = summary_read(folder, err);
    return status ? status : belong_check(&folder->home, folder->summary, err);
}

static hawser_status tables_read(Folder *folder, hawser_error *err)
{
    hawser_status status = HAWSER_OK;
    if (is_running(folder->summary)) folder_say(folder, "%s", FOLDER_UNFINISHED);
    if (!status) status = table_read(folder, "stations.csv", &folder->stations, err);
    if (!status) status = table_read(folder, "rollers.csv", &folder->rollers, err);
    if (!status) status = table_read(folder, "series.csv", &folder->series, err);
    if (!status) status = table_read(folder, "inputs.csv", &folder->inputs, err);
    if (!status) status = table_read(folder, "route.csv", &folder->route, err);
    return status;
}

hawser_status folder_read(const char *dir, Folder *folder, hawser_error *err)
{
    const hawser_status status = folder_open(dir, folder, err);
    return status ? status : tables_read(folder, err);
}

hawser_status folder_read_within(const Folder *outer, const char *name, const char *dir, Folder *folder, int *there,
                                 hawser_error *err)
{
    *folder = (Folder){.dir = dir};
    folder->opened = *there = out_within(&folder->home, &outer->home, name);
    if (!*there) return HAWSER_OK;
    hawser_status status = summary_read(folder, err);
    if (!status) status = belong_check(&folder->home, folder->summary, err);
    return status ? status : tables_read(folder, err);
}

hawser_status folder_files(const Folder *folder, FileMarks *files, hawser_error *err)
{
    static const char *const names[] = {"summary.json",     "stations.csv",      "rollers.csv", "series.csv",
                                        "inputs.csv",       "route.csv",         "results.h5",  "states.hawser",
                                        "certificate.json", "sensitivities.json"};
    hawser_status status = HAWSER_OK;
    for (size_t k = 0; k < sizeof names / sizeof *names && !status; k++) {
        char *const path = folder_path(folder, names[k]);
        status = path ? file_marks_add(files, path, err) : error_memory(err);
        free(path);
    }
    return status;
}

void folder_clear(Folder *folder)
{
    Sheet *const sheet[] = {&folder->stations, &folder->rollers, &folder->series, &folder->inputs, &folder->route};
    for (size_t k = 0; k < sizeof sheet / sizeof *sheet; ++k) sheet_clear(sheet[k]);
    json_decref(folder->summary);
    free(folder->summary_text);
    if (folder->opened) out_leave(&folder->home);
    *folder = (Folder){0};
}

double folder_figure(const Folder *folder, const char *path)
{
    char key[64];
    const json_t *at = folder->summary;
    for (; *path && at; path += *path == '.') {
        const size_t n = strcspn(path, ".");
        snprintf(key, sizeof key, "%.*s", (int)n, path);
        at = json_object_get(at, key);
        path += n;
    }
    return json_is_number(at) ? json_number_value(at) : NAN;
}

const char *folder_text(const Folder *folder, const char *key)
{
    const char *const text = json_string_value(json_object_get(folder->summary, key));
    return text ? text : "";
}

const char *folder_title(const Folder *folder)
{
    const char *const title = folder_text(folder, "title");
    return *title ? title : folder->dir;
}

enum { COLUMNS_MAX = 100000 };

void sheet_clear(Sheet *sheet)
{
    free(sheet->text);
    free(sheet->name);
    free(sheet->cell);
    *sheet = (Sheet){0};
}

/* Cuts one cell out of the text in place: *p moves behind it and behind its end, which is returned: ',' '\n' or 0. -1:
 * a quote is not closed. Removes the apostrophe that keeps spreadsheets from computing. */
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

/* Counts columns of the head, and lines: more than rows where quotes contain line ends. */
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

/* Cuts one line into the cells of a row [columns]; 0: a quote is not closed. */
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
    return !*t && isfinite(strtod(text, NULL)); /* 1e999 is not a finite number */
}

double sheet_number(const Sheet *sheet, int row, int column)
{
    if (column < 0) return NAN;
    const char *const text = sheet_cell(sheet, row, column);
    return is_json_number(text) ? strtod(text, NULL) : NAN;
}

/* Checks whether all cells of a column are numbers or empty. */
static int sheet_is_numeric(const Sheet *sheet, int column)
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
