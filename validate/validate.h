/* The validation suite: scenes made in code, run, and held against what is known of them from elsewhere.
 * A case is a function that adds rows to a log; the cases of one subject are in one file and one table. */
#ifndef HAWSER_VALIDATE_VALIDATE_H
#define HAWSER_VALIDATE_VALIDATE_H

#include "hawser/hawser.h"

enum { VALIDATION_QUANTITY_MAX = 64 };

/* How far `found` may be from `expected`: a share of it, as it is, or as an upper limit that `expected` then is. */
typedef enum ValidationKind { WITHIN_SHARE, WITHIN, AT_MOST } ValidationKind;

typedef struct ValidationCase ValidationCase;

/* One quantity of a case. */
typedef struct ValidationRow {
    const ValidationCase *of;
    char quantity[VALIDATION_QUANTITY_MAX];
    const char *unit;
    ValidationKind kind;
    double expected, found;
    double tolerance; /* %, or the quantity's unit */
    double error;     /* likewise, with its sign */
    int ok;
} ValidationRow;

typedef struct ValidationLog {
    int n, room;
    ValidationRow *row;                                         /* [n], owned */
    const ValidationCase *now;                                  /* the case that is running */
    char failure[VALIDATION_QUANTITY_MAX + HAWSER_MESSAGE_MAX]; /* of the last case that could not be run */
    int no_memory;
} ValidationLog;

struct ValidationCase {
    const char *name;   /* lower case, words joined by dashes */
    const char *proves; /* in a few words */
    const char *source; /* of what is expected */
    int fast;           /* takes a moment: part of the default tests */
    const void *setup;  /* what `run` gets, for cases that share it */
    /* Adds the case's rows. An error is that of a scene that could not be built or run. */
    hawser_status (*run)(const void *setup, ValidationLog *log, hawser_error *err);
};

/* The tables of cases, one a subject. */
typedef struct ValidationGroup {
    int n;
    const ValidationCase *cases; /* [n] */
} ValidationGroup;

/* A group of all the cases of an array. */
#define VALIDATION_GROUP(array)                                                                                        \
    {                                                                                                                  \
        .n = (int)(sizeof(array) / sizeof(array)[0]), .cases = (array)                                                 \
    }

extern const ValidationGroup rod_group, stability_group, frequency_group, paper_group, row_group, duct_group,
    roller_group, wave_group, motion_group, flight_group, frame_group, slip_group, buckling_group, convergence_group;

/* Adds a quantity of the running case. Tolerance: per cent of `expected`. */
void log_share(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
               double percent);
/* Tolerance in the quantity's unit. */
void log_near(ValidationLog *log, const char *quantity, const char *unit, double expected, double found,
              double tolerance);
/* Something that should be small: at most `limit`. */
void log_limit(ValidationLog *log, const char *quantity, const char *unit, double found, double limit);

/* Orders of convergence by regression. docs/model.md, "Validation" (VA2). */
/* The slope of log y over log x, least squares over n points. */
double order_of(int n, const double *x, const double *y);
/* Adds the relative errors of n refinements, of which nothing is asked, and their order over x (`of`: what x is), which
 * should be near `expected`. */
void order_log(ValidationLog *log, int n, const double *x, const double *error, const char *of, double expected,
               double tolerance);

/* Case number i of the suite, in its order; NULL behind the last. */
const ValidationCase *validation_case(int i);

/* Runs the cases whose names hold `filter` (NULL: all), only the fast ones if `fast`, in the suite's order. A case that
 * fails adds a row that is not ok. Returns how many ran. Errors: MEMORY. */
hawser_status validation_run(const char *filter, int fast, ValidationLog *log, int *ran, hawser_error *err);
void validation_clear(ValidationLog *log);
/* Quantities that are not ok. */
int validation_outside(const ValidationLog *log);

#endif
