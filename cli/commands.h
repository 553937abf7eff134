/* The commands: each takes the arguments and returns the exit status. */
#ifndef HAWSER_CLI_COMMANDS_H
#define HAWSER_CLI_COMMANDS_H

#include "cli/arguments.h"

extern const Command command_run, command_check, command_upgrade, command_job, command_place, command_desk,
    command_schema, command_theory, command_validate, command_library, command_route, command_report, command_plot,
    command_study, command_compare, command_fmu, command_convert;

/* Runs the whole program behind `main`: the words of the command line, argv[0] the program's own name; some of them are
 * cut in two. Returns the exit status; run.c's help lists them. Without any word the usage goes to standard error,
 * since a script that forgot its arguments is wrong. */
int program(int argc, char **argv);

/* Loads the case and applies the settings of the command line. *out is NULL on failure. */
hawser_status load_case(const Arguments *args, hawser_case **out, hawser_error *err);

/* Returns "results/NAME" for "some/where/NAME.yaml"; the caller frees it. NULL without memory. */
char *default_dir(const char *case_path);

/* Progress of a run on standard error: one live line on a terminal, otherwise a line every tenth of the run. */
typedef struct Progress {
    int quiet;                /* nothing is printed */
    int live;                 /* standard error is a terminal that can rewrite its line */
    int drawn;                /* a live line is shown */
    int tenths;               /* tenths of the run that were printed */
    int pass;                 /* pass of the run; 0: not begun */
    double last_t, last_wall; /* s, at the last call */
    double next_held;         /* s, next time to show the cause of short steps */
    double speed;             /* smoothed simulated seconds a second; 0: not known yet */
} Progress;

void progress_start(Progress *p, int quiet);
/* Shows sample after wall_s seconds of a run that ends at end_s. */
void progress_show(Progress *p, const hawser_sample *sample, double wall_s, double end_s);
/* Does the same for a certificate; in a log a line for each run that ends. */
void progress_certify(Progress *p, const hawser_certify_state *state);
/* Does the same for a study. */
void progress_study(Progress *p, const hawser_study_state *state);
/* Clears the live line. */
void progress_end(Progress *p);

/* Makes SIGINT, SIGTERM and SIGHUP, where they are not ignored, end the program at once with EXIT_INTERRUPTED: a
 * command that only prints has nothing to clean up. */
void interrupt_end(void);
/* Makes SIGINT, SIGTERM and SIGHUP request an orderly end, and turns closed readers of standard output or error into
 * failed writes. If interrupt_wanted is not called within half a second of processor time after the signal, or 20 s,
 * the program ends. */
void interrupt_watch(void);
int interrupt_wanted(void);

/* Prints the case that is about to be run, with --verbose its counts. */
void report_scene(const hawser_sim *s, const Arguments *args);
/* Prints the answer, then pull, machines, events, rollers, limits; with --verbose work and wall time by phase. `dir`:
 * folder of the results. */
void report_run(hawser_sim *s, const Arguments *args, const char *dir);
/* Checks that a run has all tables of a list; reports the first that it does not have. NULL: none is requested. */
int report_tables_check(const char *list);

/* Prints the assumptions: how many values, and the accuracy of an estimated EI; nothing if the case gives all. */
void report_assumptions(const hawser_sim *s, hawser_units units);

/* Writes the page about results to `path`; with `pdf` also a browser's print of it, beside it as NAME.pdf. Prints both
 * paths unless `quiet`. *err has the error; a browser that is missing or fails is OUTPUT. */
hawser_status page_make(const char *const *folders, size_t n, const char *path, int pdf, int quiet, hawser_error *err);
/* Does the same for a page made by `write`. */
typedef hawser_status (*PageWrite)(void *what, const char *path, hawser_error *err);
hawser_status page_make_of(PageWrite write, void *what, const char *path, int pdf, int quiet, hawser_error *err);
/* Returns the path of a page about a case: that of -o, or "NAME-KIND.html" for "some/where/NAME.yaml". */
enum { PAGE_PATH = 512 };
const char *page_path(const Arguments *args, const char *kind, char path[PAGE_PATH]);
/* Returns the exit status for a verdict's word, with --strict. */
int held_status(const Arguments *args, hawser_word word);
/* Prints a page to a file by an installed Chromium. Errors: OUTPUT (there is none, it fails, it takes too long). */
hawser_status pdf_print(const char *page, const char *pdf, hawser_error *err);

/* Computes the case again with finer settings, until its figures hold or `stopped` returns anything but 0; writes
 * certificate.json into dir and prints its table. Returns whether the run is certified; *status: as hawser_certify. */
int certify_run(const Arguments *args, hawser_case *c, hawser_sim *sim, const char *dir, int (*stopped)(void),
                hawser_error *err, hawser_status *status);

/* Returns the columns of the terminal on standard output, at most 120; 80 where it is no terminal. */
int terminal_width(void);
/* Checks whether a command's answer is printed: --quiet drops tables, not the JSON or CSV that --format requests. */
int is_shown(const Arguments *args);
/* Prints an answer to standard output if it is shown, with the words of verdicts in colour on a terminal unless
 * NO_COLOR forbids it. */
void print_answer(const Arguments *args, const char *text);
/* Returns the name in a path, and the length of that name without its ending. */
const char *file_stem(const char *path, int *length);

#endif
