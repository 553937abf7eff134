/* hawser compare: a measured pull against results or a case. */
#include <stdio.h>
#include <string.h>

#include "cli/commands.h"

static const char help[] =
    "Usage: hawser compare RESULTS|CASE LOG.csv [options]\n"
    "\n"
    "Lays the winch's force that a logger has written (over time or length, with units in its head) beside what was\n"
    "planned: by the run in the folder RESULTS and theory, or by theory of the file CASE with the head's place as the\n"
    "log's length. Planned against pulled by parts of the way, peaks, for a CASE the friction that would explain the\n"
    "mean; bias, RMS, correlation, and how much agrees within a band.\n"
    "Readings at rest, starts, drop-outs and spikes are told apart (docs/studies.md, \"Measured pulls\").\n"
    "\n"
    "      --align WAY         length: by the winch's travel (default); start: by the time since the pull began\n"
    "      --shift X           added to where the log is: m, or s with --align start\n"
    "      --band P            what counts as agreement (default: 10%)\n"
    "      --raw               takes spikes and drop-outs as they are\n"
    "      --page FILE         writes a page with figures (HTML)\n"
    "      --report            the same, into LOG's name with -compare.html\n"
    "      --json              prints the figures as JSON\n"
    "      --units UNITS       of what is printed: si (default) or us\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 compared, whatever it says; 2 no results, no log, or nothing in common; 4 the page could not be\n"
    "written; 5 no memory.\n";

static int compare(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *text = NULL;
    if (args->n_words != 2) {
        complain("compare needs results or a case, and a log, as in: hawser compare results/huangjiahu log.csv");
        return EXIT_USAGE;
    }
    hawser_compare_options options = args->compare;
    char page[4096];
    options.format = args->format;
    if (args->report && !options.page) {
        const char *const log = args->words[1], *const slash = strrchr(log, '/'), *const dot = strrchr(log, '.');
        const size_t n = dot && dot > (slash ? slash + 1 : log) ? (size_t)(dot - log) : strlen(log);
        snprintf(page, sizeof page, "%.*s-compare.html", (int)(n < 4000 ? n : 4000), log);
        options.page = page;
    }
    const hawser_status status = hawser_compare(args->words[0], args->words[1], &options, &text, &err);
    if (!status) fputs(text, stdout);
    if (!status && args->report) tell("Report: %s", options.page);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, &err));
}

const Command command_compare = {"compare", "a measured pull against what was planned", "jAHBwgeu*", help, compare};
