/* hawser plot: main figures of results as SVG, for documents. */
#include "cli/commands.h"

#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: hawser plot RESULTS [FIGURE ...] [options]\n"
    "\n"
    "Draws main figures of the results in the folder RESULTS as SVG files: tension (along the route, against theory),\n"
    "series (forces and speed over time), rollers (their loads), plan (plan and profile of the route). Without names\n"
    "all of them for which there is something to draw.\n"
    "\n"
    "  -o, --output DIR        where they go (default: RESULTS)\n"
    "      --units UNITS       si (default: kN, m) or us (lbf, ft)\n"
    "  -q, --quiet             prints nothing but errors\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 drawn; 2 no results, or nothing for a figure that was named; 4 a file could not be written.\n";

static int plot(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    char *const results = args->words[0];
    for (size_t n = strlen(results); n > 1 && results[n - 1] == '/'; n--) results[n - 1] = 0;
    const char *const dir = args->dir ? args->dir : results;
    int drawn;
    const hawser_status status = hawser_plot_write(results, dir, (size_t)args->n_words - 1,
                                                   (const char *const *)(args->words + 1), args->units, &drawn, &err);
    if (!status && !args->quiet) tell("Drawn: %d figure%s in %s", drawn, drawn == 1 ? "" : "s", dir);
    return finish_stdout(exit_status(status, &err));
}

const Command command_plot = {"plot", "main figures of results as SVG", "oqu*", help, plot};
