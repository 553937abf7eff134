/* hawser study: many samples of a case, and what they say together. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "cli/commands.h"
#include "hawser/hawser.h"

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
    "      --slurm             computes on a cluster, as an array of Slurm (docs/studies.md); --jobs is of each task\n"
    "      --tasks N           of the array (default: by the number of samples)\n"
    "      --mpi               computes on all ranks that mpirun has started; --jobs is of each rank\n"
    "      --fresh             begins anew where DIR has samples already\n"
    "      --format FORMAT     of what is printed: table (default), or json, which is what summary.json holds\n"
    "      --units UNITS       of what is printed: si (default) or us; files are in SI\n"
    "  -q, --quiet             prints nothing but errors\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "      --task N            what the array's tasks are started with\n"
    "\n"
    "Exit status: 0 done, whatever the samples say; 2 the study, its case or the command line is wrong; 4 results\n"
    "could not be written; 5 no memory; 130 interrupted (the samples so far are in DIR).\n";

static int show_progress(void *user, const hawser_study_state *state)
{
    progress_study(user, state);
    return interrupt_wanted();
}

/* This program's file, which a cluster's tasks start; NULL where the system does not say. */
static const char *own_path(void)
{
    static char path[4096];
    const ssize_t n = readlink("/proc/self/exe", path, sizeof path - 1);
    return n > 0 ? path : NULL;
}

/* Of several ranks the first talks. */
static int run_study(const Arguments *args, hawser_study *s, const char *dir, const hawser_ranks *ranks,
                     hawser_error *err)
{
    Progress progress;
    const int first = !ranks || ranks->rank == 0, json = args->format == HAWSER_JSON;
    const int quiet = args->quiet || json || !first;
    const hawser_study_options options = {
        .jobs = args->jobs, .fresh = args->fresh, .progress = show_progress, .user = &progress};
    const hawser_study_cluster cluster = {
        .ranks = ranks, .slurm = args->slurm ? own_path() : NULL, .tasks = args->tasks};
    char *text = NULL;
    interrupt_watch();
    progress_start(&progress, quiet);
    const hawser_status status = args->task ? hawser_study_task(s, dir, args->task - 1, &options, err)
                                            : hawser_study_run_on(s, dir, &options, &cluster, err);
    progress_end(&progress);
    const int kept = (status == HAWSER_OK || status == HAWSER_STOPPED) && !args->task;
    hawser_error late;
    if (kept && first && (json || !quiet) && !hawser_study_answer(s, args->format, &text, &late)) {
        fputs(text, stdout);
        if (!json) printf("\n");
        if (!json) tell("Results in %s/", dir);
    }
    fflush(stdout);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, err));
}

/* Nothing is written before the study is read. */
static int study(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_ranks ranks = {0};
    hawser_study *s = NULL;
    if (args->format == HAWSER_CSV) {
        complain("--format csv: the table of a study is samples.csv in its folder; 'table' or 'json' can be used");
        return EXIT_USAGE;
    }
    hawser_status status = args->mpi ? hawser_ranks_open(&ranks, &err) : HAWSER_OK;
    if (!status) status = hawser_study_load(args->case_path, &s, &err);
    char *const made = args->dir || status ? NULL : default_dir(args->case_path);
    const char *const dir = args->dir ? args->dir : made;
    int result = status ? exit_status(status, &err) : EXIT_INTERNAL;
    if (!status && !dir) complain("out of memory");
    if (!status && dir) result = run_study(args, s, dir, args->mpi ? &ranks : NULL, &err);
    free(made);
    hawser_study_free(s);
    hawser_ranks_close(&ranks);
    return result;
}

const Command command_study = {"study", "many variants of a case: how likely is a broken limit, and what matters",
                               "oufqKNmcky", help, study};
