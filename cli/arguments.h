/* The parsed command line: command, case, options. */
#ifndef HAWSER_CLI_ARGUMENTS_H
#define HAWSER_CLI_ARGUMENTS_H

#include "hawser/hawser.h"

/* Exit statuses besides those of hawser_status with the same meaning: 0, 2, 3, 4, 5. */
enum {
    EXIT_NOT_HELD = 1,
    EXIT_USAGE = 2,
    EXIT_OUTPUT = 4,
    EXIT_INTERNAL = 5,
    EXIT_NOT_TRUSTED = 6,
    EXIT_NOT_CERTIFIED = 7,
    EXIT_INTERRUPTED = 130
};
/* Return value of arguments_parse if the command is to be run. */
enum { ARGUMENTS_GO_ON = -1 };

/* Path of standard input, which `-` stands for. */
#define STDIN_PATH "/dev/stdin"

/* One --set; the strings are parts of the command line. */
typedef struct Setting {
    const char *key, *value;
} Setting;

typedef struct Arguments {
    const char *case_path; /* or the file of routes; standard input is STDIN_PATH */
    const char *dir;       /* NULL: from the case's name */
    Setting *settings;     /* [n_settings], in the order given */
    int n_settings;
    char **words; /* [n_words] remaining words of the command line, for commands with '*' */
    int n_words;
    int threads; /* 0: the case's choice */
    int quiet;
    int strict;     /* a broken limit is an error */
    int keep_going; /* even if the cable has left its supports */
    int certify;
    int sensitivities; /* for theory */
    char *sensitive;   /* keys for derivatives of a run, with commas between; NULL: none */
    int report, pdf;   /* a page about the results; the same as PDF */
    double tolerance;  /* share; 0: the library's choice */
    double effort;     /* runs of the case; 0: the library's choice */
    int verbose;       /* also shows the cost of the computation */
    hawser_format format;
    const char *tables; /* tables below the answer, by name; NULL: none */
    const char *kind;   /* kind of the catalogue; NULL: all */
    hawser_units units; /* units of the shown values */
    const char *filter; /* NULL: none */
    int fast;
    hawser_fmi fmi;  /* for the command fmu */
    int jobs;        /* 0: the library's choice */
    int fresh;       /* earlier samples are dropped */
    int mpi, slurm;  /* kind of cluster for a study */
    int tasks, task; /* for a Slurm array: number of tasks, 0: the library's choice; this task + 1, 0: none */
    hawser_compare_options compare; /* for the command compare */
    const char *resume;             /* folder of the run to be resumed; NULL: a new run */
    const char *crew;               /* file for the list of equipment; NULL: none */
    const char *workbook;           /* file for the tables of a job; NULL: none */
    const char *picture;            /* page of a route; NULL: none */
    hawser_place_options place;     /* for the command place */
    hawser_convert_options convert; /* for the command convert */
    hawser_route_options route;     /* for the command route; its texts are parts of the command line */
} Arguments;

typedef struct Command {
    const char *name;
    const char *summary; /* a line for the list of commands */
    const char *options; /* letters of its options, see arguments.c; '-': it takes no case; '+': a kind and a pattern,
                          * or add and words; '/': a file of routes; '?': a case or none; 'J': a study; '*': words of
                          * its own, at least one; '#': -o cannot be standard output */
    const char *help;    /* the text of --help */
    int (*run)(const Arguments *args); /* returns the exit status */
} Command;

/* Parses the words after the command's name (argv[0] is that name). Returns ARGUMENTS_GO_ON, or the exit status after
 * --help, --version or an error message. arguments_clear must follow. */
int arguments_parse(const Command *command, int argc, char **argv, Arguments *args);
void arguments_clear(Arguments *args);

/* Prints one line with words of the command line to standard output, as complain does. */
void tell(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Prints "hawser: message" to standard error. */
void complain(const char *format, ...) __attribute__((format(printf, 1, 2)));
/* Prints that `what` ("command", "option") `given` is not known, with the nearest of the n known ones if one is near.
 */
void complain_unknown(const char *what, const char *given, int n, const char *const *known);
/* Checks whether a name stands for standard output; NULL does not. */
int is_stdout(const char *name);
/* Returns which of the n known words `given` is; -1 after a message that names all, and the nearest if one is near. */
int choose(const char *option, const char *given, int n, const char *const *known);
/* Prints the message of a failed library call, and returns the exit status of the shell. */
int exit_status(hawser_status status, const hawser_error *err);
/* Flushes standard output; a failure (a full disk) turns success into EXIT_OUTPUT with a message. */
int finish_stdout(int status);

#endif
