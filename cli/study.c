/* hawser study: many samples of a case, and what they say together. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "cli/commands.h"

static const char help[] =
    "Usage: hawser study STUDY [options]\n"
    "\n"
    "Computes many variants of a case, as the file STUDY says (docs/studies.md): a grid, a list, samples drawn from\n"
    "distributions, a sensitivity analysis, or a search for the best; by theory, by runs, or by runs where theory is\n"
    "close to a limit. Prints how likely the pull is not safe and which limit it is, or the best design, and writes "
    "all\n"
    "samples as a table. A study that was stopped or killed goes on where it was.\n"
    "\n"
    "  -o, --output DIR        where the results go (default: results/NAME, NAME from STUDY)\n"
    "      --jobs N            worker processes (default: one for each processor); results do not depend on it\n"
    "      --fresh             begins anew where DIR has samples already\n"
    "      --units UNITS       of what is printed: si (default) or us; files are in SI\n"
    "  -q, --quiet             prints nothing but errors\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 done, whatever the samples say; 2 the study, its case or the command line is wrong; 4 results\n"
    "could not be written; 5 no memory; 130 interrupted (the samples so far are in DIR).\n";

static int show_progress(void *user, const hawser_study_state *state)
{
    progress_study(user, state);
    return interrupt_wanted();
}

static int run_study(const Arguments *args, hawser_study *s, const char *dir, hawser_error *err)
{
    Progress progress;
    const hawser_study_options options = {
        .jobs = args->jobs, .fresh = args->fresh, .progress = show_progress, .user = &progress};
    char *text = NULL;
    interrupt_watch();
    progress_start(&progress, args->quiet);
    const hawser_status status = hawser_study_run(s, dir, &options, err);
    progress_end(&progress);
    const int kept = status == HAWSER_OK || status == HAWSER_STOPPED;
    hawser_error late;
    if (kept && !args->quiet && !hawser_study_answer(s, args->units, &text, &late)) {
        fputs(text, stdout);
        printf("\nResults in %s/\n", dir);
    }
    fflush(stdout);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, err));
}

/* Nothing is written before the study is read. */
static int study(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_study *s = NULL;
    const hawser_status status = hawser_study_load(args->case_path, &s, &err);
    if (status) return exit_status(status, &err);
    char *const made = args->dir ? NULL : default_dir(args->case_path);
    const char *const dir = args->dir ? args->dir : made;
    int result = EXIT_INTERNAL;
    if (!dir) complain("out of memory");
    if (dir) result = run_study(args, s, dir, &err);
    free(made);
    hawser_study_free(s);
    return result;
}

const Command command_study = {"study", "many variants of a case: how likely is a broken limit, and what matters",
                               "ouqKN", help, study};
