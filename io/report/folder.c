#include "io/report/folder.h"

#include "core/base/error.h"
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
static const long file_most = 1L << 30;

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

/* Up to `size` bytes of a descriptor and a NUL behind them; a file that has become shorter is as long as it is. */
static hawser_status bytes_read(int fd, const char *path, size_t size, char **text, hawser_error *err)
{
    size_t done = 0;
    *text = malloc(size + 1);
    if (!*text) return error_memory(err);
    while (done < size) {
        const ssize_t n = read(fd, *text + done, size - done);
        if (n == 0) break;
        if (n > 0) done += (size_t)n;
        if (n > 0 || errno == EINTR) continue;
        free(*text);
        *text = NULL;
        return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, strerror(errno));
    }
    (*text)[done] = 0;
    if (strlen(*text) == done) return HAWSER_OK;
    free(*text);
    *text = NULL;
    return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': it is no text", path);
}

/* A whole file, malloc'ed. One that is not there is NULL with HAWSER_OK. Errors: INPUT, MEMORY. */
static hawser_status file_read(const char *path, char **text, hawser_error *err)
{
    struct stat info;
    *text = NULL;
    const int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd < 0 && errno == ENOENT) return HAWSER_OK;
    if (fd < 0) return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", path, strerror(errno));
    hawser_status status = HAWSER_OK;
    if (fstat(fd, &info) || !S_ISREG(info.st_mode))
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': not a file", path);
    else if (info.st_size > file_most)
        status = error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': it is too large", path);
    if (!status) status = bytes_read(fd, path, (size_t)info.st_size, text, err);
    close(fd);
    return status;
}

/* A table beside the summary. */
static hawser_status table_read(Folder *folder, const char *name, Sheet *sheet, hawser_error *err)
{
    hawser_error why = {HAWSER_OK, ""};
    char *text = NULL, *const path = folder_path(folder, name);
    if (!path) return error_memory(err);
    hawser_status status = file_read(path, &text, &why);
    if (!status && text) status = sheet_parse(text, path, sheet, &why);
    free(path);
    if (status == HAWSER_ERR_INPUT) folder_say(folder, "%.350s", why.message);
    return status == HAWSER_ERR_MEMORY ? error_memory(err) : HAWSER_OK;
}

/* The one file that must be there. */
static hawser_status summary_read(Folder *folder, hawser_error *err)
{
    json_error_t where;
    int lack = 0;
    struct stat info;
    const char *const dir = folder->dir;
    if (stat(dir, &info)) return error_set(err, HAWSER_ERR_INPUT, "cannot read '%.700s': %s", dir, strerror(errno));
    if (!S_ISDIR(info.st_mode))
        return error_set(err, HAWSER_ERR_INPUT, "'%.700s' is no folder: give one that hawser run has written", dir);
    char *const path = folder_path(folder, "summary.json");
    if (!path) return error_memory(err);
    hawser_status status = file_read(path, &folder->summary_text, err);
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

hawser_status folder_open(const char *dir, Folder *folder, hawser_error *err)
{
    *folder = (Folder){.dir = dir};
    const hawser_status status = summary_read(folder, err);
    return status ? status : belong_check(dir, folder->summary, err);
}

hawser_status folder_read(const char *dir, Folder *folder, hawser_error *err)
{
    hawser_status status = folder_open(dir, folder, err);
    if (!status && is_running(folder->summary)) folder_say(folder, "%s", FOLDER_UNFINISHED);
    if (!status) status = table_read(folder, "stations.csv", &folder->stations, err);
    if (!status) status = table_read(folder, "rollers.csv", &folder->rollers, err);
    if (!status) status = table_read(folder, "series.csv", &folder->series, err);
    if (!status) status = table_read(folder, "inputs.csv", &folder->inputs, err);
    if (!status) status = table_read(folder, "route.csv", &folder->route, err);
    return status;
}

hawser_status folder_files(const Folder *folder, FileMarks *files, hawser_error *err)
{
    static const char *const names[] = {"summary.json", "stations.csv",     "rollers.csv",
                                        "series.csv",   "inputs.csv",       "route.csv",
                                        "results.h5",   "certificate.json", "sensitivities.json"};
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
