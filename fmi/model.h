/* What an FMU of a case shows: its variables, in the order of their value references. They follow from the case alone,
 * so that the archive's description and the library inside it, which reads the case again, have the same.
 * docs/guide/fmi.md lists them. */
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

/* Where an output's value comes from. */
typedef enum OutputFrom {
    FROM_SAMPLE,     /* a double of hawser_sample, `at` bytes from its beginning */
    FROM_CONTACTS,   /* segments that touch something */
    FROM_ROLLER,     /* the load of roller `item`; -1: the largest of all */
    FROM_NORMAL,     /* of surface `item` */
    FROM_FRICTION,   /* likewise */
    FROM_LINE_LOAD,  /* likewise */
    FROM_FIGURE,     /* figure `item` of the machines */
    FROM_PROBE,      /* a double of probe `item`, `at` bytes from its beginning */
    FROM_PULL_MEAN,  /* of the steady window so far */
    FROM_PULL_PEAK,  /* of the run so far */
    FROM_MARGIN,     /* of limit `item` */
    FROM_WORST,      /* the least margin of those that are judged */
    FROM_BROKEN,     /* how many limits are */
    FROM_EVENTS,     /* how many there were */
    FROM_EVENT_TEXT, /* the last of them in words */
    FROM_VERDICT,
    FROM_VERDICT_TEXT
} OutputFrom;

/* What an input is told to. */
typedef enum InputTo {
    TO_COMMAND, /* `command`, with `what`, when the value has changed */
    TO_BRAKE,   /* the winch's brake: on, and off again */
    TO_PAUSE,   /* likewise */
    TO_JAM      /* jams and frees `what` */
} InputTo;

typedef struct Variable {
    char *name; /* owned; hierarchical: "rollers.'P 28'.load" */
    char *key;  /* owned; of a parameter: as --set takes it, "conveyors.0.clamp"; NULL: no parameter of the case */
    char *description; /* owned */
    VariableType type;
    VariableRole role;
    const char *unit;    /* of unit_rows; NULL: none */
    double start;        /* of all but outputs; of booleans 0 or 1 */
    double least, most;  /* of inputs; NAN: any */
    const char *written; /* of a parameter: its unit as a case writes it, "N m" */
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

/* A step of a hierarchical name: itself if it is a name of C's, otherwise in quotes as the standard has them (FMI 2.0,
 * 2.2.9; 3.0, 2.4.7.5.1), with %XX for each byte that may not stand there. Returns `to`. */
enum { VARIABLE_STEP_MAX = 3 * 256 };

/* A unit by its name in a description, as powers of kg, m, s and rad. */
typedef struct UnitRow {
    const char *name;
    int kg, m, s, rad;
} UnitRow;

extern const UnitRow unit_rows[];

enum { UNIT_ROWS = 25 };

/* A number that changes with the case's text or with any name, type, role or start of the list: 36 characters in the
 * form of a GUID without braces, and a NUL. */
enum { TOKEN_SIZE = 37 };

/* A case as an FMU has it: its text with everything that it refers to, its variables and a simulation of it. */

/* The name of the case among an FMU's resources. */
#define MODEL_CASE "case.yaml"
typedef struct Model {
    char *text;   /* owned; of the case */
    char *folder; /* owned; where the files are that it refers to */
    Variables variables;
    char token[TOKEN_SIZE];
    double interval, duration; /* s: between samples of the statistics; of the run */
} Model;

/* Takes the text over (also if it fails) and copies the folder. *sim (may be NULL) gets the simulation that was built
 * for it, not relaxed. Errors: INPUT, MEMORY; *out is cleared then. */
hawser_status model_make(char *text, const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
/* The same from the file MODEL_CASE of a folder. */
hawser_status model_load(const char *folder, Model *out, hawser_sim **sim, hawser_error *err);
void model_clear(Model *m);
/* A simulation of the case with other parameters: value[n of variables]. Errors: INPUT (says which value cannot be),
 * MEMORY. */
hawser_status model_build(const Model *m, const double *value, hawser_sim **sim, hawser_error *err);

#endif
