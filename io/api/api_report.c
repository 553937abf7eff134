/* Pages and figures of results: reads folders and writes files. */
#define _GNU_SOURCE /* asprintf */
#include "core/error.h"
#include "core/file.h"
#include "hawser/hawser.h"
#include "io/case/library.h"
#include "io/case/yaml.h"
#include "io/report/report.h"
#include "io/report/text.h"
#include "io/results/results_file.h"

#include <jansson.h>
#include <locale.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Switches this thread to a locale with a decimal point, whatever that of the calling program is, until locale_back. 0:
 * no memory. */
static locale_t locale_plain(locale_t *before)
{
    const locale_t plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    if (plain) *before = uselocale(plain);
    return plain;
}

static void locale_back(locale_t plain, locale_t before)
{
    uselocale(before);
    freelocale(plain);
}

/* Reads the chains that are pulled together with a folder's, from the folders of their names within it, behind it; as
 * many as a page shows. *n: how many there are then. Errors: as folder_read. */
static hawser_status chains_read(Folder *folder, size_t *n, char **dir, hawser_error *err)
{
    const json_t *const chains = json_object_get(folder[0].summary, "chains");
    const json_t *chain;
    size_t k;
    hawser_status status = HAWSER_OK;
    json_array_foreach(chains, k, chain)
    {
        const char *const name = json_string_value(json_object_get(chain, "name"));
        if (status || !name || strchr(name, '/') || *name == '.' || *n == REPORT_RUNS_MAX) continue;
        int there; /* otherwise its own, or the common one */
        dir[*n] = folder_path(&folder[0], name);
        if (!dir[*n]) return error_memory(err);
        status = folder_read_within(&folder[0], name, dir[*n], &folder[*n], &there, err);
        if (!there) {
            free(dir[*n]);
            dir[*n] = NULL;
            continue;
        }
        ++*n;
    }
    if (*n == REPORT_RUNS_MAX && json_array_size(chains) > REPORT_RUNS_MAX + 1)
        folder_say(&folder[0], "A page shows %d chains; the others are in the folders of their names.",
                   REPORT_RUNS_MAX);
    return status;
}

static hawser_status report_make(const char *const *dirs, size_t n, const char *path, hawser_error *err)
{
    Folder folder[REPORT_RUNS_MAX] = {0};
    char *beside[REPORT_RUNS_MAX] = {NULL};
    Text data = {0}, page = {0};
    FileMarks files = {0};
    hawser_status status = HAWSER_OK;
    for (size_t i = 0; i < n && !status; i++) status = folder_read(dirs[i], &folder[i], err);
    if (!status && n == 1) status = chains_read(folder, &n, beside, err);
    for (size_t i = 0; i < n && !status; i++) status = folder_files(&folder[i], &files, err);
    if (!status) status = file_marks_spare(&files, path, err);
    if (!status) status = data_write(n, folder, &data, err);
    if (!status) status = page_write(n, folder, &data, &page, err);
    text_clear(&data);
    if (!status) status = out_file(path, page.at, page.size, err);
    text_clear(&page);
    file_marks_free(&files);
    for (size_t i = 0; i < n; i++) folder_clear(&folder[i]);
    for (size_t i = 0; i < REPORT_RUNS_MAX; i++) free(beside[i]);
    return status;
}

hawser_status hawser_results_check(const char *folder, hawser_error *err)
{
    Folder found;
    if (!folder) return error_argument(err, "folder");
    const hawser_status status = folder_open(folder, &found, err);
    folder_clear(&found);
    return status;
}

hawser_status hawser_report_write(const char *const *folders, size_t n, const char *path, hawser_error *err)
{
    locale_t before;
    if (!folders || !path) return error_argument(err, folders ? "path" : "folders");
    for (size_t i = 0; i < n && n <= REPORT_RUNS_MAX; i++)
        if (!folders[i]) return error_argument(err, "folders");
    if (n < 1 || n > REPORT_RUNS_MAX)
        return error_set(err, HAWSER_ERR_INPUT, "%zu results: a page shows 1 to %d", n, REPORT_RUNS_MAX);
    const locale_t plain = locale_plain(&before);
    if (!plain) return error_memory(err);
    const hawser_status status = report_make(folders, n, path, err);
    locale_back(plain, before);
    return status;
}

/* Returns the number of a figure; FIGURES if none has that name. */
static int figure_named(const char *name)
{
    int k = 0;
    while (k < FIGURES && strcmp(name, figures[k].name) != 0) k++;
    return k;
}

/* Writes one figure and counts it in *drawn; results without data for it are an error if it was requested by name. */
static hawser_status figure_write(const Folder *folder, const char *dir, const Figure *figure, hawser_units units,
                                  int wanted, int *drawn, hawser_error *err)
{
    char name[64];
    Text text = {0};
    const int some = figure->draw(folder, units, &text);
    hawser_status status = some < 0 || text.failed ? error_memory(err) : HAWSER_OK;
    if (!status && !some && wanted)
        status = error_set(err, HAWSER_ERR_INPUT, "'%.600s' has nothing for the figure '%s': it needs %s", folder->dir,
                           figure->name, figure->needs);
    if (!status && some) {
        snprintf(name, sizeof name, "%s.svg", figure->name);
        status = out_make_dir(dir, err);
        if (!status) status = out_whole(dir, name, text.at, err);
        *drawn += !status;
    }
    text_clear(&text);
    return status;
}

/* Checks before drawing that no figure would overwrite a file of the results. */
static hawser_status figures_spare(const Folder *folder, const char *dir, hawser_error *err)
{
    char path[OUT_PATH_MAX];
    FileMarks files = {0};
    hawser_status status = folder_files(folder, &files, err);
    for (int k = 0; k < FIGURES && !status; k++) {
        if (snprintf(path, sizeof path, "%s/%s.svg", dir, figures[k].name) < (int)sizeof path)
            status = file_marks_spare(&files, path, err);
    }
    file_marks_free(&files);
    return status;
}

static hawser_status plot_make(const char *results, const char *dir, size_t n, const char *const *names,
                               hawser_units units, int *drawn, hawser_error *err)
{
    Folder folder;
    hawser_status status = folder_read(results, &folder, err);
    if (!status) status = figures_spare(&folder, dir, err);
    for (int k = 0; k < FIGURES && !status; k++) {
        int wanted = 0;
        for (size_t i = 0; i < n; i++) wanted |= figure_named(names[i]) == k;
        if (n == 0 || wanted) status = figure_write(&folder, dir, &figures[k], units, wanted, drawn, err);
    }
    if (!status && *drawn == 0)
        status = error_set(err, HAWSER_ERR_INPUT,
                           "'%.700s' holds nothing to draw: no stations, series, rollers or route", results);
    folder_clear(&folder);
    return status;
}

hawser_status hawser_plot_write(const char *folder, const char *dir, size_t n, const char *const *names,
                                hawser_units units, int *drawn, hawser_error *err)
{
    int count = 0;
    locale_t before;
    if (!folder || !dir) return error_argument(err, folder ? "dir" : "folder");
    for (size_t i = 0; i < n; i++) {
        if (!names || !names[i]) return error_argument(err, "names");
        char hint[HINT_MAX];
        if (figure_named(names[i]) == FIGURES)
            return error_set(err, HAWSER_ERR_INPUT,
                             "'%.100s' is no figure: there are tension, series, rollers and plan%s", names[i],
                             case_hint(names[i], "tension, series, rollers, plan", hint));
    }
    const locale_t plain = locale_plain(&before);
    if (!plain) return error_memory(err);
    const hawser_status status = plot_make(folder, dir, n, names, units, &count, err);
    locale_back(plain, before);
    if (drawn) *drawn = count;
    return status;
}

/* A page of the desk with a case in it, as it is filled. */
typedef struct DeskPage {
    Text page;
    const char *folder; /* of the case, with its slash; "": the working folder */
    FileMarks marks;    /* files that were read */
    int files;          /* those that are in the page */
    hawser_error *err;
} DeskPage;

static hawser_status desk_files(DeskPage *in, const char *text, const char *path, const char *from);

/* The name's folder with its slash, as so many characters. */
static int folder_length(const char *name)
{
    const char *const slash = strrchr(name, '/');
    return slash ? (int)(slash - name) + 1 : 0;
}

/* Puts a file into the page, once, under its name from the case's folder. from: the name of the file that names it.
 * includes: it may name others. */
static hawser_status desk_file(DeskPage *in, const CaseNode *node, const char *from, int includes)
{
    char *name = NULL, *path = NULL, *bytes = NULL;
    size_t size = 0;
    hawser_error why = {HAWSER_OK, ""};
    if (asprintf(&name, "%.*s%s", *node->text == '/' ? 0 : folder_length(from), from, node->text) < 0) name = NULL;
    if (!name || asprintf(&path, "%s%s", *name == '/' ? "" : in->folder, name) < 0) path = NULL;
    hawser_status status = path ? case_file_read(path, &bytes, &size, &why) : error_memory(&why);
    if (status) status = case_key_cause(in->err, node, NULL, "", &why);
    const int before = in->marks.n;
    if (!status) status = file_marks_add(&in->marks, path, in->err);
    if (!status && in->marks.n > before) {
        text_add(&in->page, in->files++ ? "," : "");
        text_json(&in->page, name);
        text_add(&in->page, ":\"");
        text_base64(&in->page, (const unsigned char *)bytes, size);
        text_add(&in->page, "\"");
        if (includes) status = desk_files(in, bytes, path, name);
    }
    free(bytes);
    free(path);
    free(name);
    return status;
}

/* The texts below a node that name files: those of a key `file`, or all of `include`. */
static hawser_status desk_named(DeskPage *in, const CaseNode *node, const char *from, int includes)
{
    hawser_status status = HAWSER_OK;
    if (node->kind == NODE_TEXT && *node->text && (includes || (node->key && !strcmp(node->key, "file"))))
        status = desk_file(in, node, from, includes);
    for (const CaseNode *below = node->first; below && !status; below = below->next)
        status = desk_named(in, below, from, includes);
    return status;
}

/* The files that a case, or a file that it includes, names. */
static hawser_status desk_files(DeskPage *in, const char *text, const char *path, const char *from)
{
    static const char *const sections[] = {"include", "route", "drawing", "environment"};
    CaseTree *tree = NULL;
    hawser_status status = case_tree_parse(text, path, &tree, in->err);
    for (size_t k = 0; k < sizeof sections / sizeof *sections && !status; ++k) {
        const CaseNode *const node = case_node_key(tree->root, sections[k]);
        if (node) status = desk_named(in, node, from, k == 0);
    }
    case_tree_free(tree);
    return status;
}

/* Puts a case's text and its files into the desk in place of the empty one. */
static hawser_status desk_fill(DeskPage *in, const char *desk, const char *case_path, const char *text)
{
    static const char place[] = "id=\"case\">";
    const char *const at = strstr(desk, place), *const rest = at ? strstr(at, "</script>") : NULL;
    if (!rest) return error_set(in->err, HAWSER_ERR_INPUT, "the desk beside the program is not this version's");
    text_bytes(&in->page, desk, (size_t)(at - desk) + sizeof place - 1);
    text_add(&in->page, "{\"name\":");
    text_json(&in->page, case_path + folder_length(case_path));
    text_add(&in->page, ",\"text\":");
    text_json(&in->page, text);
    text_add(&in->page, ",\"files\":{");
    const hawser_status status = desk_files(in, text, case_path, "");
    text_add(&in->page, "}}");
    text_add(&in->page, rest);
    return status || !in->page.failed ? status : error_memory(in->err);
}

hawser_status hawser_desk_write(const char *case_path, const char *path, hawser_error *err)
{
    static const char place[] = "share/hawser/desk.html";
    char *desk = NULL, *text = NULL, *folder = NULL;
    size_t size = 0, length = 0;
    DeskPage in = {.err = err};
    if (!path) return error_argument(err, "path");
    char *const shipped = shipped_find(place);
    hawser_status status = HAWSER_OK;
    if (!shipped) status = error_set(err, HAWSER_ERR_INPUT, "there is no %s beside the program", place);
    if (!status) status = case_file_read(shipped, &desk, &size, err);
    if (!status) status = file_marks_add(&in.marks, shipped, err);
    if (!status && case_path) status = case_file_read(case_path, &text, &length, err);
    if (!status && case_path) status = file_marks_add(&in.marks, case_path, err);
    if (!status && text && strlen(text) != length)
        status = error_set(err, HAWSER_ERR_INPUT, "%.300s: no text: it has a NUL character", case_path);
    if (!status && text) {
        folder = strndup(case_path, (size_t)folder_length(case_path));
        in.folder = folder;
        status = folder ? desk_fill(&in, desk, case_path, text) : error_memory(err);
    }
    if (!status) status = file_marks_spare(&in.marks, path, err);
    if (!status) status = out_file(path, text ? in.page.at : desk, text ? in.page.size : size, err);
    file_marks_free(&in.marks);
    text_clear(&in.page);
    free(folder);
    free(shipped);
    free(desk);
    free(text);
    return status;
}
