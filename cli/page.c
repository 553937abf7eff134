/* hawser report: results as one page. The page's program is in the library; here are the words around it. */
#include "cli/commands.h"
#include "hawser/hawser.h"

#include <assert.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static const char help[] =
    "Usage: hawser report RESULTS [RESULTS2 ...] [options]\n"
    "\n"
    "Writes one HTML page about the results that hawser run has left in the folder RESULTS: verdict and remedies,\n"
    "figures along the route and over time, loads, limits, inputs, and the pull in three dimensions. Two to six\n"
    "folders are compared on one page. Of a folder of hawser study it is the study's page. The page needs no network "
    "and no other file; any browser of today opens it.\n"
    "\n"
    "  -o, --output FILE       where the page goes (default: RESULTS/report.html; of several ./report.html)\n"
    "      --pdf               also prints the page to FILE with .pdf in place of .html, by an installed Chromium;\n"
    "                          implied where FILE ends in .pdf, the page is then FILE with .html\n"
    "  -q, --quiet             prints nothing but errors\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 written; 2 a folder holds no results; 4 the page could not be written or printed; 5 no memory.\n";

static int ends_in(const char *name, const char *ending)
{
    const size_t n = strlen(name), e = strlen(ending);
    return n > e && strcmp(name + n - e, ending) == 0;
}

/* "DIR/report" and `ending` of "DIR/report.html", "DIR/report.pdf" or "DIR/report"; malloc'ed. */
static char *name_ending(const char *name, const char *ending)
{
    const size_t end = strlen(name) - (ends_in(name, ".html") ? 5 : ends_in(name, ".pdf") ? 4 : 0);
    char *const path = malloc(end + strlen(ending) + 1);
    if (path) sprintf(path, "%.*s%s", (int)end, name, ending);
    return path;
}

static int study_is_in(const char *folder)
{
    char path[4096];
    snprintf(path, sizeof path, "%.4000s/workers/study", folder);
    return access(path, F_OK) == 0;
}

/* What a page is of. */
typedef struct Folders {
    const char *const *folder; /* [n] */
    size_t n;
} Folders;

static hawser_status folders_write(void *what, const char *path, hawser_error *err)
{
    const Folders *const f = what;
    const int study = f->n == 1 && study_is_in(f->folder[0]);
    return study ? hawser_study_report(f->folder[0], path, err) : hawser_report_write(f->folder, f->n, path, err);
}

static hawser_status page_write(PageWrite write, void *what, const char *path, int quiet, hawser_error *err)
{
    const hawser_status status = write(what, path, err);
    if (!status && !quiet) tell("Report: %s", path);
    return status;
}

hawser_status page_make(const char *const *folders, size_t n, const char *path, int pdf, int quiet, hawser_error *err)
{
    Folders what = {folders, n};
    return page_make_of(folders_write, &what, path, pdf, quiet, err);
}

/* A browser prints only what is named as a page, and never over the page. */
hawser_status page_make_of(PageWrite write, void *what, const char *path, int pdf, int quiet, hawser_error *err)
{
    if (!pdf && !ends_in(path, ".pdf")) return page_write(write, what, path, quiet, err);
    char *const page = name_ending(path, ".html"), *const printed = name_ending(path, ".pdf");
    hawser_status status = page && printed ? HAWSER_OK : HAWSER_ERR_MEMORY;
    if (status) *err = (hawser_error){HAWSER_ERR_MEMORY, "out of memory"};
    if (!status) status = page_write(write, what, page, quiet, err);
    interrupt_watch(); /* the browser does not outlive us */
    fflush(stdout);
    if (!status) status = pdf_print(page, printed, err);
    if (!status && !quiet) tell("Printed: %s", printed);
    free(page);
    free(printed);
    return status;
}

const char *page_path(const Arguments *args, const char *kind, char path[PAGE_PATH])
{
    const char *const slash = strrchr(args->case_path, '/'), *const name = slash ? slash + 1 : args->case_path,
                      *const dot = strrchr(name, '.');
    snprintf(path, PAGE_PATH, "%.*s-%s.html", dot ? (int)(dot - name) : (int)strlen(name), name, kind);
    return args->dir ? args->dir : path;
}

int held_status(const Arguments *args, hawser_word word)
{
    if (!args->strict || word == HAWSER_SAFE) return 0;
    return word == HAWSER_NOT_TRUSTED ? EXIT_NOT_TRUSTED : EXIT_NOT_HELD;
}

static int report(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    if (args->n_words > HAWSER_REPORT_RUNS_MAX) {
        complain("report compares up to %d results; these are %d", HAWSER_REPORT_RUNS_MAX, args->n_words);
        return EXIT_USAGE;
    }
    const char *folders[HAWSER_REPORT_RUNS_MAX];
    for (int i = 0; i < args->n_words; i++) {
        char *const dir = args->words[i];
        for (size_t n = strlen(dir); n > 1 && dir[n - 1] == '/'; n--) dir[n - 1] = 0;
        folders[i] = dir;
    }
    assert(args->n_words > 0);
    const size_t size = strlen(folders[0]) + sizeof "/report.html";
    char *const beside = malloc(size);
    if (!beside) {
        complain("out of memory");
        return EXIT_INTERNAL;
    }
    snprintf(beside, size, "%s/report.html", folders[0]);
    const char *const path = args->dir ? args->dir : args->n_words > 1 ? "report.html" : beside;
    const hawser_status status = page_make(folders, (size_t)args->n_words, path, args->pdf, args->quiet, &err);
    free(beside);
    return finish_stdout(exit_status(status, &err));
}

const Command command_report = {"report", "one HTML page about results, or comparing some", "oqP*", help, report};
