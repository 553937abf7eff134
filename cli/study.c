/* hawser study: many samples of a case, and their statistics. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "cli/commands.h"
#include "hawser/hawser.h"

static const char help[] = "Usage: hawser study STUDY [options]\n"
                           "\n"
                           "Computes many variants of a case, as the file STUDY says\n"
                           "(docs/guide/studies-and-measured-pulls.md): a grid, a list, samples drawn from\n"
                           "distributions, a sensitivity analysis, or a search for the best; by theory, by\n"
                           "runs, or by runs where theory is close to a limit. Prints how likely the pull\n"
                           "is not safe and which limit it is, or the best design, and writes all samples\n"
                           "as a table. A study that was stopped or killed goes on where it was.\n"
                           "\n"
                           "  -o, --output DIR        where the results go (default: results/NAME, NAME\n"
                           "                          from STUDY)\n"
                           "      --jobs N            worker processes (default: one for each processor);\n"
                           "                          results do not depend on it\n"
                           "      --slurm             computes on a cluster, as an array of Slurm; --jobs\n"
                           "                          is of each task\n"
                           "      --tasks N           of the array (default: by the number of samples)\n"
                           "      --mpi               computes on all ranks that mpirun has started; --jobs\n"
                           "                          is of each rank\n"
                           "      --fresh             begins anew where DIR has samples already\n"
                           "      --format FORMAT     of what is printed: table (default), or json, which\n"
                           "                          is what summary.json holds\n"
                           "      --units UNITS       of what is printed: si (default) or us; files are in\n"
                           "                          SI\n"
                           "  -q, --quiet             prints nothing but errors\n"
                           "  -h, --help              this text\n"
                           "  -V, --version           the version\n"
                           "      --task N            what the array's tasks are started with\n"
                           "\n"
                           "Exit status: 0 done, whatever the samples say; 2 the study, its case or the\n"
                           "command line is wrong; 4 results could not be written; 5 no memory; 130\n"
                           "interrupted (the samples so far are in DIR).\n";

static int show_progress(void *user, const hawser_study_state *state)
{
    progress_study(user, state);
    return interrupt_wanted();
}

/* Returns this program's file, which a cluster's tasks start; NULL where the system does not give it. */
static const char *own_path(void)
{
    static char path[4096];
    const ssize_t n = readlink("/proc/self/exe", path, sizeof path - 1);
    return n > 0 ? path : NULL;
}

/* Runs the study; of several ranks only the first prints. */
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

/* Writes nothing before the study is read. */
static int study(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_ranks ranks = {0};
    hawser_study *s = NULL;
    if (args->format == HAWSER_CSV) {
        complain("--format csv: the table of a study is samples.csv in its folder; 'table' or 'json' can be used");
        return EXIT_USAGE;
    }
    if (!strcmp(args->case_path, STDIN_PATH)) {
        complain("study: its file is read again when it goes on and by its tasks: standard input cannot be used");
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

const Command command_study = {"study", "many variants of a case: how likely a limit breaks, what matters",
                               "oufqKNmcky#", help, study};

/* hawser job: many pulls calculated by theory together. */

static const char job_help[] = "Usage: hawser job JOB [options]\n"
                               "\n"
                               "Calculates the pulls that the file JOB lists (docs/guide/jobs-and-sheets.md),\n"
                               "each in both directions, by theory. Prints a table with verdict, direction,\n"
                               "forces, least margin, trip setting and reel of each pull, the reels and the\n"
                               "joint bays.\n"
                               "\n"
                               "      --report            writes the tables and the calculation of every pull\n"
                               "                          as one page\n"
                               "      --pdf               prints that page too, by an installed Chromium;\n"
                               "                          implies --report\n"
                               "  -o, --output FILE       where the page goes (default: JOB's name with\n"
                               "                          -job.html)\n"
                               "      --crew FILE         writes the crew's sheets, one side of paper for each\n"
                               "                          pull (HTML, and PDF where FILE ends in .pdf)\n"
                               "      --xlsx FILE         writes the tables as a workbook, in SI\n"
                               "      --format FORMAT     table (default), json, or csv, which is the table of\n"
                               "                          pulls\n"
                               "      --units UNITS       of table and page: si (default) or us; json, csv and\n"
                               "                          xlsx are in SI\n"
                               "  -q, --quiet             prints nothing but errors\n"
                               "      --strict            the exit status says whether all pulls are safe\n"
                               "  -h, --help              this text\n"
                               "  -V, --version           the version\n"
                               "\n"
                               "Exit status: 0 done; 2 the job or a case is wrong; 4 a file cannot be written;\n"
                               "5 no memory; with --strict 1 a pull is not SAFE, 6 one is NOT TRUSTED and none\n"
                               "is worse.\n";

/* Writes a page of a job. */
typedef struct Sheet {
    hawser_status (*write)(const hawser_job *job, hawser_units units, const char *path, hawser_error *err);
    const hawser_job *job;
    hawser_units units;
} Sheet;

static hawser_status sheet_write(void *what, const char *path, hawser_error *err)
{
    const Sheet *const sheet = what;
    return sheet->write(sheet->job, sheet->units, path, err);
}

static int job(const Arguments *args)
{
    hawser_error err = {HAWSER_OK, ""};
    hawser_word word = HAWSER_SAFE;
    hawser_job *made = NULL;
    char *text = NULL, path[PAGE_PATH];
    if (args->dir && !args->report) {
        complain("job: -o is of --report, which is not given");
        return EXIT_USAGE;
    }
    if (args->workbook && args->dir && !strcmp(args->workbook, args->dir)) {
        complain("job: --xlsx and -o name the same file");
        return EXIT_USAGE;
    }
    const int output = is_stdout(args->dir) || is_stdout(args->crew);
    hawser_status status = hawser_job_load(args->case_path, &made, &err);
    if (!status) status = hawser_job_answer(made, args->format, &text, &word, &err);
    if (!status && !output) print_answer(args, text);
    const hawser_units units = args->format == HAWSER_TABLE_US ? HAWSER_US : HAWSER_SI;
    Sheet page = {hawser_job_page, made, units}, crew = {hawser_job_crew_sheets, made, units};
    const int quiet = args->quiet || args->format == HAWSER_JSON || args->format == HAWSER_CSV;
    if (!status && args->workbook) status = hawser_job_workbook(made, args->workbook, &err);
    if (!status && args->workbook && !quiet) tell("Workbook: %s", args->workbook);
    if (!status && args->crew) status = page_make_of(sheet_write, &crew, args->crew, 0, quiet, &err);
    if (!status && args->report)
        status = page_make_of(sheet_write, &page, page_path(args, "job", path), args->pdf, quiet, &err);
    hawser_text_free(text);
    hawser_job_free(made);
    return finish_stdout(status ? exit_status(status, &err) : held_status(args, word));
}

const Command command_job = {"job", "many pulls in one table, page and workbook, by theory", "fuoePqS/XW", job_help,
                             job};

/* hawser compare: a measured pull against results or a case. */

static const char compare_help[] = "Usage: hawser compare RESULTS|CASE LOG.csv [options]\n"
                                   "\n"
                                   "Lays the winch's force that a logger has written (over time or length, with\n"
                                   "units in its head) beside what was planned: by the run in the folder RESULTS\n"
                                   "and theory, or by theory of the file CASE with the head's place as the log's\n"
                                   "length. Planned against pulled by parts of the way, peaks, for a CASE the\n"
                                   "friction that would explain the mean; bias, RMS, correlation, and how much\n"
                                   "agrees within a band. Readings at rest, starts, drop-outs and spikes are told\n"
                                   "apart (docs/guide/studies-and-measured-pulls.md).\n"
                                   "\n"
                                   "      --align WAY         length: by the winch's travel (default); start: by\n"
                                   "                          the time since the pull began\n"
                                   "      --shift X           added to where the log is: m, or s with --align start\n"
                                   "      --band P            what counts as agreement (default: 10%)\n"
                                   "      --raw               takes spikes and drop-outs as they are\n"
                                   "      --page FILE         writes a page with figures (HTML)\n"
                                   "      --report            the same, into LOG's name with -compare.html\n"
                                   "      --format FORMAT     table (default), json or csv\n"
                                   "      --json              the same as --format json\n"
                                   "      --units UNITS       of the table: si (default) or us; json and csv are in\n"
                                   "                          SI\n"
                                   "  -q, --quiet             prints nothing but errors, and requested json or csv\n"
                                   "  -h, --help              this text\n"
                                   "  -V, --version           the version\n"
                                   "\n"
                                   "Exit status: 0 compared, whatever it says; 2 no results, no log, or nothing in\n"
                                   "common; 4 the page could not be written; 5 no memory.\n";

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
        int n;
        const char *const log = args->words[1], *const name = file_stem(log, &n);
        n += (int)(name - log);
        snprintf(page, sizeof page, "%.*s-compare.html", n < 4000 ? n : 4000, log);
        options.page = page;
    }
    const hawser_status status = hawser_compare(args->words[0], args->words[1], &options, &text, &err);
    if (!status && !is_stdout(options.page)) print_answer(args, text);
    if (!status && args->report && !args->quiet) tell("Report: %s", options.page);
    hawser_text_free(text);
    return finish_stdout(exit_status(status, &err));
}

const Command command_compare = {"compare", "a measured pull against what was planned", "fjqAHBwgeu*", compare_help,
                                 compare};
