/* A command as data: action, target, value and ramp; and the rows of a case's script. */
#ifndef HAWSER_DEF_COMMAND_DEF_H
#define HAWSER_DEF_COMMAND_DEF_H

#include "core/vec3.h"
#include "def/cable_def.h"
#include "hawser/hawser.h"

/* In addition to those of hawser_control: a force on a segment, which has its own call. */
enum { COMMAND_FORCE = HAWSER_EVENT_FORCE - HAWSER_EVENT_COMMAND };

/* Every kind: its number, its word in a script, the key and unit of its value (NULL: no value; "": a pure number),
 * least and largest value, whether it needs a target's name (2: optional), target of the command. */
#define COMMANDS(COMMAND)                                                                                              \
    COMMAND(HAWSER_WINCH_SPEED, "winch_speed", "speed", "m/s", -1e4, 1e4, 0, "winch")                                  \
    COMMAND(HAWSER_WINCH_TENSION, "winch_tension", "tension", "N", 0, 1e9, 0, "winch")                                 \
    COMMAND(HAWSER_WINCH_BRAKE, "winch_brake", NULL, NULL, 0, 0, 0, "winch")                                           \
    COMMAND(HAWSER_WINCH_PAUSE, "winch_pause", NULL, NULL, 0, 0, 0, "winch")                                           \
    COMMAND(HAWSER_WINCH_RESTART, "winch_restart", NULL, NULL, 0, 0, 0, "winch")                                       \
    COMMAND(HAWSER_CONVEYOR_SPEED, "conveyor_speed", "speed", "m/s", -1e4, 1e4, 1, "conveyor")                         \
    COMMAND(HAWSER_CONVEYOR_CLAMP, "conveyor_clamp", "clamp", "N", 0, 1e9, 1, "conveyor")                              \
    COMMAND(HAWSER_REEL_BRAKE, "reel_brake", "torque", "N m", 0, 1e9, 0, "reel that pays out")                         \
    COMMAND(HAWSER_JAM, "jam", NULL, NULL, 0, 0, 1, "thing that can jam")                                              \
    COMMAND(HAWSER_RELEASE, "release", NULL, NULL, 0, 0, 1, "thing that can jam")                                      \
    COMMAND(HAWSER_FRICTION, "friction", "factor", "", 0, 100, 2, "roller or surface")                                 \
    COMMAND(COMMAND_FORCE, "force", NULL, NULL, 0, 0, 0, "segment")

typedef struct CommandKind {
    int kind; /* hawser_control or COMMAND_FORCE */
    const char *says, *key, *unit;
    double least, most;
    int named;
    const char *thing;
} CommandKind;
enum { COMMAND_KINDS = 12 };
extern const CommandKind command_kinds[COMMAND_KINDS];
extern const char *const command_words[]; /* in the same order, with NULL at the end */
/* Returns the kind, or NULL if there is none. */
const CommandKind *command_kind(int kind);

#define COMMAND_RAMP_USUAL 0.2 /* s */
#define COMMAND_RAMP_LEAST 1e-3
#define COMMAND_RAMP_MOST  1e6

typedef struct Command {
    int kind;
    char what[NAME_MAX_LENGTH]; /* ""; of friction: all */
    double value, ramp;         /* unit by kind; s */
    int segment;                /* of COMMAND_FORCE, of the whole chain */
    int follows;                /* force and moment rotate with it */
    Vec3 force, moment, arm;    /* N, N m; m, in the segment's axes */
} Command;

/* One row of drive.script, by rising time. */
typedef struct ScriptDef {
    double at;    /* s */
    double place; /* m from the tail, of a force */
    Command command;
} ScriptDef;

#endif
