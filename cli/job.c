/* hawser job: many pulls calculated by theory in one go. */
#include "cli/commands.h"
#include "hawser/hawser.h"

#include <stdio.h>
#include <string.h>

static const char help[] =
    "Usage: hawser job JOB [options]\n"
    "\n"
    "Calculates the pulls that the file JOB lists (docs/jobs.md), each in both directions, by theory. Prints a table\n"
    "with verdict, direction, forces, least margin, trip setting and reel of each pull, the reels and the joint bays.\n"
    "\n"
    "      --report            writes the tables and the calculation of every pull as one page\n"
    "      --pdf               prints that page too, by an installed Chromium; implies --report\n"
    "  -o, --output FILE       where the page goes (default: JOB's name with -job.html)\n"
    "      --crew FILE         writes the crew's sheets, one side of paper for each pull (HTML, and PDF where FILE "
    "ends in\n"
    "                          .pdf)\n"
    "      --xlsx FILE         writes the tables as a workbook, in SI\n"
    "      --format FORMAT     table (default), json, or csv, which is the table of pulls\n"
    "      --units UNITS       of table and page: si (default) or us; json, csv and xlsx are in SI\n"
    "  -q, --quiet             prints nothing but errors\n"
    "      --strict            the exit status says whether all pulls are safe\n"
    "  -h, --help              this text\n"
    "  -V, --version           the version\n"
    "\n"
    "Exit status: 0 done; 2 the job or a case is wrong; 4 a file cannot be written; 5 no memory; with --strict\n"
    "1 a pull is not SAFE, 6 one is NOT TRUSTED and none is worse.\n";

/* The job whose page is written. */
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
    hawser_status status = hawser_job_load(args->case_path, &made, &err);
    if (!status) status = hawser_job_answer(made, args->format, &text, &word, &err);
    if (!status && !args->quiet) print_answer(text);
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

const Command command_job = {"job", "many pulls in one table, page and workbook, by theory", "fuoePqS/XW", help, job};
