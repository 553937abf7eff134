/* The command line taken apart: which command, which case, which options. */
#ifndef HAWSER_CLI_ARGUMENTS_H
#define HAWSER_CLI_ARGUMENTS_H

#include "hawser/hawser.h"

/* Exit statuses beside those of hawser_status that mean the same: 0, 2, 3, 4, 5. */
enum {
    EXIT_NOT_HELD = 1,
    EXIT_USAGE = 2,
    EXIT_OUTPUT = 4,
    EXIT_INTERNAL = 5,
    EXIT_NOT_TRUSTED = 6,
    EXIT_NOT_CERTIFIED = 7,
    EXIT_INTERRUPTED = 130
};
/* What arguments_parse returns when the command is to go on. */
enum { ARGUMENTS_GO_ON = -1 };

/* One --set; the strings are parts of the command line. */
typedef struct Setting {
    const char *key, *value;
} Setting;

typedef struct Arguments {
    const char *case_path; /* or the file of routes */
    const char *dir;       /* NULL: by the case's name */
    Setting *settings;     /* [n_settings], in the order given */
    int n_settings;
    char **words; /* [n_words] what is left of the command line, of commands with '*' */
    int n_words;
    int threads; /* 0: the case's choice */
    int quiet;
    int strict;     /* a broken limit is an error */
    int keep_going; /* though the cable has left what carries it */
    int certify;
    int sensitivities; /* of theory */
    char *sensitive;   /* keys of a run, with commas between; NULL: none */
    int report, pdf;   /* a page about the results; the same printed */
    double tolerance;  /* share; 0: the library's choice */
    double effort;     /* runs of the case; 0: the library's choice */
    int verbose;       /* what it cost to compute is shown too */
    hawser_format format;
    const char *tables; /* below the answer, by name; NULL: none */
    const char *kind;   /* of the catalogue; NULL: all */
    hawser_units units; /* of what is shown */
    const char *filter; /* NULL: none */
    int fast;
    hawser_fmi fmi;                 /* of the command fmu */
    int jobs;                       /* 0: the library's choice */
    int fresh;                      /* earlier samples do not count */
    int mpi, slurm;                 /* what a study is spread by */
    int tasks, task;                /* of a Slurm array: how many, 0: the library's choice; which + 1, 0: none */
    hawser_compare_options compare; /* of the command compare */
    const char *resume;             /* folder of the run to go on with; NULL: a new one */
    const char *crew;               /* file for the list of equipment; NULL: none */
    const char *workbook;           /* file for the tables of a job; NULL: none */
    const char *picture;            /* page of a route; NULL: none */
    hawser_place_options place;     /* of the command place */
    hawser_route_options route;     /* of the command route; its texts are parts of the command line */
} Arguments;

typedef struct Command {
    const char *name;
    const char *summary; /* a line for the list of commands */
    const char *options; /* the letters of the options it takes, see arguments.c; '-': it takes no case; '+': a kind and
                            a pattern, or add and words; '/': a file of routes; '?': a case or none; 'J': a study; '*':
                            words of its own, one at least */
    const char *help;    /* the text of --help */
    int (*run)(const Arguments *args); /* returns the exit status */
} Command;

/* Reads what follows the command's name (argv[0] is that name). Returns ARGUMENTS_GO_ON, or the exit status
 * after --help,
 * --version or a message about what is wrong. arguments_clear must follow. */
int arguments_parse(const Command *command, int argc, char **argv, Arguments *args);
void arguments_clear(Arguments *args);

/* One line on standard output that has words of the command line in it, as complain. */
void tell(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Prints "hawser: message" to standard error. */
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Prints that `what` ("command", "option") `given` is not known, naming the nearest of the n known ones if
 * one is near. */
void complain_unknown(const char *what, const char *given, int n, const char *const *known);
/* What a library call's status means for the shell: prints the message and returns the exit status. */
int exit_status(hawser_status status, const hawser_error *err);
/* Flushes standard output; a failure (a full disk) turns success into EXIT_OUTPUT with a message. */
int finish_stdout(int status);

#endif
