#include "io/report/folder.h"

#include "core/base/error.h"
#include "core/base/file.h"
#include "io/results/results_file.h"

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

/* Of a file of text, bytes: far above what a run writes that one would want to look at on a page. */
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

/* A whole file of text, malloc'ed. One that is not there is NULL with HAWSER_OK. Errors: INPUT, MEMORY. */
static hawser_status file_read(const Folder *folder, const char *name, const char *path, char **text, hawser_error *err)
{
    size_t size;
    const hawser_status status = file_whole_in(folder->home.at, name, path, file_most, text, &size, err);
    if (!*text || strlen(*text) == size) return status;
    free(*text);
    *text = NULL;
    return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': it is no text", path);
}

/* A table beside the summary. One that is none, or too large, is left out with a note; not one that the system does not
 * give: who asked would take it for one that is not there. */
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

/* The one file that must be there. */
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

/* The folder itself, which the user has named. */
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
