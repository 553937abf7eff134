/* The commands: each takes the arguments and returns the exit status. */
#ifndef HAWSER_CLI_COMMANDS_H
#define HAWSER_CLI_COMMANDS_H

#include "cli/arguments.h"

extern const Command command_run, command_check, command_upgrade, command_job, command_place, command_desk,
    command_schema, command_theory, command_validate, command_library, command_route, command_report, command_plot,
    command_study, command_compare, command_fmu;

/* The whole program behind `main`: the words of the command line, argv[0] the program's own name; some of them are cut
 * in two. Returns the exit status, which says how it ended: see run.c's help. Without any word the usage goes to
 * standard error, since a script that forgot its arguments did something wrong. */
int program(int argc, char **argv);

/* Loads the case and applies the settings of the command line. *out is NULL on failure. */
hawser_status load_case(const Arguments *args, hawser_case **out, hawser_error *err);

/* "results/NAME" of "some/where/NAME.yaml"; the caller frees it. NULL without memory. */
char *default_dir(const char *case_path);

/* What the user sees while a run goes on, on standard error: one live line on a terminal, else a line every
 * tenth of the run. */
typedef struct Progress {
    int quiet;                /* say nothing */
    int live;                 /* standard error is a terminal that can rewrite its line */
    int drawn;                /* a live line stands there */
    int tenths;               /* of the run said so far */
    int pass;                 /* of the run; 0: not begun */
    double last_t, last_wall; /* s, of the last call */
    double next_held;         /* s, when what holds the run up may be said again */
    double speed;             /* smoothed simulated seconds a second; 0: not known yet */
} Progress;

void progress_start(Progress *p, int quiet);
/* Shows sample after wall_s seconds of a run that ends at end_s. */
void progress_show(Progress *p, const hawser_sample *sample, double wall_s, double end_s);
/* The same for a certificate; in a log a line for each run that ends. */
void progress_certify(Progress *p, const hawser_certify_state *state);
/* The same for a study. */
void progress_study(Progress *p, const hawser_study_state *state);
/* Clears the live line. */
void progress_end(Progress *p);

/* From now on SIGINT, SIGTERM and SIGHUP, where they are not ignored, end the program at once with EXIT_INTERRUPTED:
 * what only prints has nothing to leave in order. */
void interrupt_end(void);
/* From now on SIGINT, SIGTERM and SIGHUP ask for an orderly end, and standard output or error that nobody reads any
 * more is a write that fails. If interrupt_wanted is not called within half a second of processor time after the
 * signal, or 20 s, the program ends. */
void interrupt_watch(void);
int interrupt_wanted(void);

/* What is about to be run: the case, with --verbose its counts. */
void report_scene(const hawser_sim *s, const Arguments *args);
/* The answer, then pull, machines, events, rollers, limits; with --verbose work and where the time went. `dir`: where
 * the results are. */
void report_run(hawser_sim *s, const Arguments *args, const char *dir);
/* Whether a run has all tables of a list; complains of the first that it has not. NULL: none is asked for. */
int report_tables_check(const char *list);

/* What the case did not say itself: how many values, and what an estimated EI is worth; nothing if it said all. */
void report_assumptions(const hawser_sim *s, hawser_units units);

/* Writes the page about results to `path`; with `pdf` also what a browser prints of it, beside it as NAME.pdf. Prints
 * both paths unless `quiet`. *err says what went wrong; a browser that is missing or fails is OUTPUT. */
hawser_status page_make(const char *const *folders, size_t n, const char *path, int pdf, int quiet, hawser_error *err);
/* The same of what `write` makes a page of. */
typedef hawser_status (*PageWrite)(void *what, const char *path, hawser_error *err);
hawser_status page_make_of(PageWrite write, void *what, const char *path, int pdf, int quiet, hawser_error *err);
/* Where a page about a case goes: what -o says, or "NAME-KIND.html" of "some/where/NAME.yaml". Returns it. */
enum { PAGE_PATH = 512 };
const char *page_path(const Arguments *args, const char *kind, char path[PAGE_PATH]);
/* With --strict, what the exit status says of a verdict's word. */
int held_status(const Arguments *args, hawser_word word);
/* Prints a page to a file by an installed Chromium. Errors: OUTPUT (none is there, it fails, it takes too long). */
hawser_status pdf_print(const char *page, const char *pdf, hawser_error *err);

/* Computes the case again with finer settings, until its figures hold or `stopped` says something else than 0; writes
 * certificate.json into dir and prints its table. Returns whether the run is certified; *status: as hawser_certify. */
int certify_run(const Arguments *args, hawser_case *c, hawser_sim *sim, const char *dir, int (*stopped)(void),
                hawser_error *err, hawser_status *status);

/* Columns of the terminal that standard output is, at most 120; 80 where it is none. */
int terminal_width(void);
/* An answer on standard output, the words of verdicts in colour where that is a terminal and NO_COLOR does not forbid
 * it. */
void print_answer(const char *text);

#endif
