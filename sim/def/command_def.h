/* A command as data: what to do, with what, over how long; and what a case's script has of them. */
#ifndef HAWSER_SIM_DEF_COMMAND_DEF_H
#define HAWSER_SIM_DEF_COMMAND_DEF_H

#include "core/base/vec3.h"
#include "hawser/hawser.h"
#include "sim/def/cable_def.h"

/* Beside those of hawser_control: a force on a segment, which has a call of its own. */
enum { COMMAND_FORCE = HAWSER_EVENT_FORCE - HAWSER_EVENT_COMMAND };

/* What there is to say of a kind of command. */
typedef struct CommandKind {
    int kind;           /* hawser_control or COMMAND_FORCE */
    const char *says;   /* in a script as well */
    const char *unit;   /* of its value; "": a number; NULL: it has none */
    double least, most; /* of its value */
    int named;          /* 1: it needs a name; 2: it may have one */
    const char *thing;  /* that it is for */
} CommandKind;
enum { COMMAND_KINDS = 12 };
extern const CommandKind command_kinds[COMMAND_KINDS];
/* NULL: there is no such kind. */
const CommandKind *command_kind(int kind);

#define COMMAND_RAMP_USUAL 0.2 /* s */
#define COMMAND_RAMP_LEAST 1e-3
#define COMMAND_RAMP_MOST  1e6

typedef struct Command {
    int kind;
    char what[NAME_MAX_LENGTH]; /* ""; of friction: all */
    double value, ramp;         /* unit by kind; s */
    int segment;                /* of COMMAND_FORCE, of the whole chain */
    int follows;                /* force and moment turn with it */
    Vec3 force, moment, arm;    /* N, N m; m, of the segment's axes */
} Command;

/* One row of drive.script, by rising time. */
typedef struct ScriptDef {
    double at;    /* s */
    double place; /* m from the tail, of a force */
    Command command;
} ScriptDef;

#endif
