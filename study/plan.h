/* A study as its file defines it: a base case, parameters and their variation, quantities; and sample i of it, which is
 * a function of the study and i alone. docs/reference/study-keys.md describes every key. */
#ifndef HAWSER_STUDY_PLAN_H
#define HAWSER_STUDY_PLAN_H

#include "def/limits.h"
#include "io/case/schema.h"
#include "study/log.h"
#include "study/maths.h"

typedef enum StudyKind {
    STUDY_GRID,
    STUDY_LIST,
    STUDY_MONTE_CARLO,
    STUDY_MORRIS,
    STUDY_SOBOL,
    STUDY_OPTIMISE,
    STUDY_CALIBRATE
} StudyKind;

/* Source of a sample's answer: the pulling calculation, a simulation, or the first and, near a limit, the second. */
typedef enum Fidelity { BY_THEORY, BY_RUN, BY_BOTH } Fidelity;

enum { UNIT_MAX = 24, PARAMETERS_MAX = 256, SETTING_MAX = 200 };

/* A varied parameter: a number of its law, or one of a row of choices. */
typedef struct Parameter {
    const CaseNode *node; /* node of its section; its key is the name; NULL: a column of a list */
    const char *name;
    int n_keys;
    const char **key;    /* [n_keys] of the case, dotted; owned, the texts are not */
    char unit[UNIT_MAX]; /* of all its numbers, as in the case; "": bare */
    int numbered;        /* a number has set the unit */
    int chosen;          /* by choices, not by the law */
    Distribution law;
    int whole;    /* of a range: whole numbers, or indices of choices */
    double start; /* of a range: start of a search */
    int n_choices;
    char **choice;  /* [n_choices] owned; NULL: the base case's own value */
    double *number; /* [n_choices] owned, in `unit`; NAN: not a number, or not convertible */
    double *weight; /* [n_choices] owned */
} Parameter;

/* A requested quantity. */
typedef struct Quantity {
    const CaseNode *node; /* its path in the answer, dotted; NULL: a default quantity */
    const char *path;
    Fidelity of; /* BY_THEORY or BY_RUN: the answer that contains it */
} Quantity;

/* A value used by a search: a parameter, or a quantity; the other is -1. */
typedef struct Asked {
    int parameter, quantity;
} Asked;

/* A term of the objective. */
typedef struct Term {
    Asked of;
    double weight;
} Term;

/* A constraint: infinite ends do not bind. */
typedef struct Constraint {
    Asked of;
    double least, most;
} Constraint;

/* Aim of a search and its method. Sample i is point i % evaluations of search i / evaluations. */
typedef struct Aim {
    int n_terms;
    Term *term;       /* [n_terms] their weighted sum is the objective */
    const char *name; /* of the sum, owned: "reference_total_N", "2 rollers + conveyors" */
    int most;         /* the maximum is sought, not the minimum */
    int limits;       /* limits must hold */
    int n_constraints;
    Constraint *constraint; /* [n_constraints] */
    SearchMethod method;
    int searches;
    long evaluations; /* of each search */
    double tolerance;
} Aim;

/* Reference of a calibration: forces by the place of the cable's head along the route. */
typedef struct Measured {
    int n;
    LogPoint *point; /* [n] by rising place */
    double *weight;  /* [n] of a residual */
    long lost, starts;
    double width; /* m: of the parts that readings are averaged over */
    int n_notes;
    char note[LOG_NOTES][LOG_NOTE_MAX]; /* of the log: columns used, assumptions */
    char notes[LOG_NOTES_MAX];          /* all of them joined */
} Measured;

typedef struct Study {
    CaseTree *tree;
    char *path;      /* of the file */
    FileMarks files; /* files it was read from, with those of its base case */
    char title[256];
    hawser_case *base; /* with the keys that the study sets */
    StudyKind kind;
    Fidelity fidelity;
    double close[LIMIT_KINDS]; /* BY_BOTH: a run is made where a margin of theory is within this of 0 */
    long pilot; /* BY_BOTH: number of samples that are run in any case, and determine `close`; 0: the study gives it */
    uint64_t seed;
    PointKind points;
    long samples; /* rows of the study in all */
    long blocks;  /* for a sensitivity: trajectories, or blocks of d+2 samples; else samples */
    int n_parameters;
    Parameter *parameter; /* [n_parameters] */
    double *factor;       /* [n_parameters^2], of the correlations; NULL: there are none */
    int n_quantities;
    Quantity *quantity; /* [n_quantities] */
    Aim aim;            /* STUDY_OPTIMISE */
    Measured measured;  /* STUDY_CALIBRATE */
    double time_limit;  /* s of wall time for a sample; 0: none */
    long memory;        /* MiB of address space of a worker; 0: no limit */
} Study;

/* Reads and checks the file and its base case. Errors: INPUT with file, line and key, MEMORY; *out is NULL then. */
hawser_status study_read(const char *path, Study **out, hawser_error *err);
Study *study_free(Study *s);
/* Reads the columns of a CSV file as parameters whose choices are the rows; names of parameters of `s` stand for their
 * keys, others are keys. Errors: INPUT with file and line, MEMORY. */
hawser_status list_read(Study *s, const CaseNode *file, const char *path, hawser_error *err);
/* Splits a text into number and unit; returns 0 if no decimal number begins it or the unit is too long. */
int value_split(const Units *units, const char *text, double *value, char unit[UNIT_MAX]);
/* Checks whether a sample's point depends on earlier results, so that the sample itself stores it. */
int study_searches(const Study *s);
/* Computes sample i, 0 <= i < samples, of a study that does not search: x[n_parameters], each a number in the
 * parameter's unit or the index of a choice. */
void study_point(const Study *s, long i, double *x);
/* Computes the middle of every parameter: the median of its law, its first choice. */
void study_middle(const Study *s, double *x);
/* The box of a study that searches; x[3 * n_parameters], whole[n_parameters]: memory for it. */
SearchBox study_box(const Study *s, double *x, unsigned char *whole);
/* Source of the answer of sample i: with both, a calibration's first half is by theory, the second by runs. */
Fidelity study_fidelity(const Study *s, long i);
/* Checks whether sample i is run whatever theory's result. */
int study_is_pilot(const Study *s, long i);
/* The value as the case takes it, in `text`; NULL: the base case's own. */
const char *parameter_text(const Parameter *p, double x, char text[SETTING_MAX]);
/* The value as a number in the parameter's unit; NAN: not a number. */
double parameter_number(const Parameter *p, double x);
/* Checks whether all of its values are numbers. */
int parameter_is_number(const Parameter *p);
/* Builds the base case with a point set; the caller frees *out before the study. Errors: INPUT, MEMORY. */
hawser_status study_case(const Study *s, const double *x, hawser_case **out, hawser_error *err);
/* The whole file, for its documentation and tests. */
extern const CaseSection study_top;

/* The study file's sections as tables of keys, and the record that they are first read into. For study/plan.c alone. */

enum { STUDY_TEXT_MAX = 1024 };

/* The record that the tables fill. */
typedef struct StudyRecord {
    char title[256], base[STUDY_TEXT_MAX], list[STUDY_TEXT_MAX];
    int fidelity, points, method, limits, starts, raw;
    double close, time_limit, tolerance, at_least, at_most, speed, head, from, to;
    long pilot, samples, memory, seed, searches, evaluations;
} StudyRecord;

/* Numbers of a law, with the user's units: in the order a, b, c, low, high of a Distribution. */
typedef struct LawKeys {
    const char *name;
    DistributionKind kind;
    const CaseSection *section;
    const char *key[5]; /* NULL: the law has none */
} LawKeys;

enum { STUDY_LAWS = 4 };

extern const CaseSection study_parameter, study_discrete, study_steps, study_range, study_whole, study_list_section,
    study_monte_carlo, study_correlation, study_sensitivity, study_optimise, study_constraint, study_calibrate;

#endif
