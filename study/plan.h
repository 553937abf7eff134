/* A study as its file says it: a base case, what is varied and how, what is looked at; and sample i of it, which is a
 * function of the study and i alone. docs/reference/study-keys.md describes every key. */
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

/* By what a sample is answered: the pulling calculation, a simulation, or the first and, near a limit, the second. */
typedef enum Fidelity { BY_THEORY, BY_RUN, BY_BOTH } Fidelity;

enum { UNIT_MAX = 24, PARAMETERS_MAX = 256, SETTING_MAX = 200 };

/* Something that is varied: a number of its law, or one of a row of choices. */
typedef struct Parameter {
    const CaseNode *node; /* where it was written; its key is the name; NULL: a column of a list */
    const char *name;
    int n_keys;
    const char **key;    /* [n_keys] of the case, dotted; owned, the texts are not */
    char unit[UNIT_MAX]; /* of all its numbers, as the case takes it; "": bare */
    int numbered;        /* a number has said what the unit is */
    int chosen;          /* by choices, not by the law */
    Distribution law;
    int whole;    /* of a range: whole numbers, or the numbers of choices */
    double start; /* of a range: where a search begins */
    int n_choices;
    char **choice;  /* [n_choices] owned; NULL: the base case's own value */
    double *number; /* [n_choices] owned, in `unit`; NAN: no number, or none that can be had in it */
    double *weight; /* [n_choices] owned */
} Parameter;

/* Something that is looked at. */
typedef struct Quantity {
    const CaseNode *node; /* its path in the answer, dotted; NULL: looked at without being asked for */
    const char *path;
    Fidelity of; /* BY_THEORY or BY_RUN: in whose answer */
} Quantity;

/* What a search asks of: a parameter, or a quantity; the other is -1. */
typedef struct Asked {
    int parameter, quantity;
} Asked;

/* A term of what is sought. */
typedef struct Term {
    Asked of;
    double weight;
} Term;

/* A constraint: infinite ends do not bind. */
typedef struct Constraint {
    Asked of;
    double least, most;
} Constraint;

/* What is sought, and how. Sample i is point i % evaluations of search i / evaluations. */
typedef struct Aim {
    int n_terms;
    Term *term;       /* [n_terms] their weighted sum is sought */
    const char *name; /* of the sum, owned: "reference_total_N", "2 rollers + conveyors" */
    int most;         /* the largest is sought, not the least */
    int limits;       /* limits must hold */
    int n_constraints;
    Constraint *constraint; /* [n_constraints] */
    SearchMethod method;
    int searches;
    long evaluations; /* of each */
    double tolerance;
} Aim;

/* What a calibration is held against: forces by the place of the cable's head along the route. */
typedef struct Measured {
    int n;
    LogPoint *point; /* [n] by rising place */
    double *weight;  /* [n] of a residual */
    long lost, starts;
    double width; /* m: of the parts that readings are averaged over */
    int n_notes;
    char note[LOG_NOTES][LOG_NOTE_MAX]; /* of the log: which columns were taken, what was assumed */
    char notes[LOG_NOTES_MAX];          /* all of them */
} Measured;

typedef struct Study {
    CaseTree *tree;
    char *path;      /* of the file */
    FileMarks files; /* from which it was read, with those of its base case */
    char title[256];
    hawser_case *base; /* with what the study sets */
    StudyKind kind;
    Fidelity fidelity;
    double close[LIMIT_KINDS]; /* BY_BOTH: a run is made where a margin of theory is within this of 0 */
    long pilot; /* BY_BOTH: so many samples are run anyway, and say what `close` is; 0: the study says it */
    uint64_t seed;
    PointKind points;
    long samples; /* rows of the study in all */
    long blocks;  /* of a sensitivity: trajectories, or blocks of d+2 samples; else samples */
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
/* The columns of a CSV file as parameters whose choices are the rows; names that `s` has as parameters stand for their
 * keys, others are keys. Errors: INPUT with file and line, MEMORY. */
hawser_status list_read(Study *s, const CaseNode *file, const char *path, hawser_error *err);
/* Number and unit of a text: 1, or 0 if no decimal number begins it or the unit is too long. */
int value_split(const Units *units, const char *text, double *value, char unit[UNIT_MAX]);
/* Whether a sample's point follows from what came of others, so that the sample itself says where it was. */
int study_searches(const Study *s);
/* Sample i, 0 <= i < samples, of a study that does not search: x[n_parameters], each a number in the parameter's unit
 * or the number of a choice. */
void study_point(const Study *s, long i, double *x);
/* What stands for every parameter in the middle: the median of its law, its first choice. */
void study_middle(const Study *s, double *x);
/* The box of a study that searches; x[3 * n_parameters], whole[n_parameters]: where it stands. */
SearchBox study_box(const Study *s, double *x, unsigned char *whole);
/* By what sample i is answered: with both, a calibration's first half by theory, the second by runs. */
Fidelity study_fidelity(const Study *s, long i);
/* Whether sample i is run whatever theory says of it. */
int study_is_pilot(const Study *s, long i);
/* The value as the case takes it, in `text`; NULL: the base case's own. */
const char *parameter_text(const Parameter *p, double x, char text[SETTING_MAX]);
/* The value as a number in the parameter's unit; NAN: it is none. */
double parameter_number(const Parameter *p, double x);
/* Whether all of its values are numbers. */
int parameter_is_number(const Parameter *p);
/* The base case with a point set; *out is freed by the caller, before the study. Errors: INPUT, MEMORY. */
hawser_status study_case(const Study *s, const double *x, hawser_case **out, hawser_error *err);
/* The whole file, for its documentation and tests. */
extern const CaseSection study_top;

/* The study file's sections as tables of keys, and what they are first read into. For study/plan alone. */

enum { STUDY_TEXT_MAX = 1024 };

/* What the tables fill. */
typedef struct StudyRecord {
    char title[256], base[STUDY_TEXT_MAX], list[STUDY_TEXT_MAX];
    int fidelity, points, method, limits, starts, raw;
    double close, time_limit, tolerance, at_least, at_most, speed, head, from, to;
    long pilot, samples, memory, seed, searches, evaluations;
} StudyRecord;

/* A law's numbers, with units of the user's: in the order a, b, c, low, high of a Distribution. */
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
