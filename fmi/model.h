/* The variables of a case's FMU, in the order of their value references. They follow from the case alone, so that the
 * archive's description and the library inside it, which reads the case again, have the same. docs/guide/fmi.md lists
 * them.
 */
#ifndef HAWSER_FMI_MODEL_MODEL_H
#define HAWSER_FMI_MODEL_MODEL_H

#include <stddef.h>
#include <stdlib.h>

#include "core/error.h"
#include "hawser/hawser.h"

typedef enum VariableType {
    VARIABLE_REAL,
    VARIABLE_INTEGER,
    VARIABLE_BOOLEAN,
    VARIABLE_TEXT,
    VARIABLE_VERDICT
} VariableType;

typedef enum VariableRole { ROLE_TIME, ROLE_PARAMETER, ROLE_TUNABLE, ROLE_INPUT, ROLE_OUTPUT } VariableRole;

/* Source of an output's value. */
typedef enum OutputFrom {
    FROM_SAMPLE,     /* a double of hawser_sample, `at` bytes from its beginning */
    FROM_CONTACTS,   /* number of segments with contact */
    FROM_ROLLER,     /* load of roller `item`; -1: the largest of all */
    FROM_NORMAL,     /* normal force on surface `item` */
    FROM_FRICTION,   /* friction force on it */
    FROM_LINE_LOAD,  /* largest line load on it */
    FROM_FIGURE,     /* figure `item` of the machines */
    FROM_PROBE,      /* a double of probe `item`, `at` bytes from its beginning */
    FROM_PULL_MEAN,  /* mean over the steady window so far */
    FROM_PULL_PEAK,  /* peak of the run so far */
    FROM_MARGIN,     /* margin of limit `item` */
    FROM_WORST,      /* least margin of the judged limits */
    FROM_BROKEN,     /* number of broken limits */
    FROM_EVENTS,     /* number of events so far */
    FROM_EVENT_TEXT, /* the last event as text */
    FROM_VERDICT,
    FROM_VERDICT_TEXT
} OutputFrom;

/* Effect of an input. */
typedef enum InputTo {
    TO_COMMAND, /* gives `command`, with `what`, when the value has changed */
    TO_BRAKE,   /* the winch's brake: on and off */
    TO_PAUSE,   /* the winch's pause: on and off */
    TO_JAM      /* jams and frees `what` */
} InputTo;

typedef struct Variable {
    char *name; /* owned; hierarchical: "rollers.'P 28'.load" */
    char *key;  /* owned; of a parameter: as --set takes it, "conveyors.0.clamp"; NULL: no parameter of the case */
    char *description; /* owned */
    VariableType type;
    VariableRole role;
    const char *unit;    /* one of unit_rows; NULL: none */
    double start;        /* for all but outputs; for booleans 0 or 1 */
    double least, most;  /* for inputs; NAN: any */
    const char *written; /* for a parameter: its unit as a case writes it, "N m" */
    InputTo to;
    hawser_control command;
    char *what; /* owned; NULL: none */
    OutputFrom from;
    int item;
    size_t at;
} Variable;

typedef struct Variables {
    int n, room;
    Variable *row; /* [n] owned; row i has the value reference i, the first is the time */
} Variables;

/* Writes a step of a hierarchical name: itself if it is an identifier of C, otherwise in quotes by the standard
 * (FMI 2.0, 2.2.9; 3.0, 2.4.7.5.1), with %XX for each forbidden byte. Returns `to`. */
enum { VARIABLE_STEP_MAX = 3 * 256 };

/* A unit by its name in a description, as powers of kg, m, s and rad. */
typedef struct UnitRow {
    const char *name;
    int kg, m, s, rad;
} UnitRow;

extern const UnitRow unit_rows[];

enum { UNIT_ROWS = 25 };

/* Makes a number that changes with the case's text or with any name, type, role or start of the list: 36 characters in
 * the form of a GUID without braces, and a NUL. */
enum { TOKEN_SIZE = 37 };

/* A case in an FMU: its text with all parts that it refers to, its variables and a simulation of it. */

/* The name of the case among an FMU's resources. */
#define MODEL_CASE "case.yaml"
typedef struct Model {
    char *text;   /* owned; text of the case */
    char *folder; /* owned; folder of the files that it refers to */
    Variables variables;
    char token[TOKEN_SIZE];
    double interval, duration; /* s: time between samples of the statistics; duration of the run */
} Model;

/* Makes a model. Takes the text over (also if it fails) and copies the folder. *sim (may be NULL) gets the simulation
 * that was built for it, not relaxed. Errors: INPUT, MEMORY; *out is cleared then. */
hawser_status model_make(char *text, const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
/* Does the same with the file MODEL_CASE of a folder. */
hawser_status model_load(const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
void model_clear(Model *m);
/* Builds a simulation of the case with other parameters: value[n of variables]. Errors: INPUT (with the impossible
 * value), MEMORY. */
hawser_status model_build(const Model *m, const double *value, hawser_sim **sim, hawser_error *err);

#endif
