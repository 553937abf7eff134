#include "sim/def/command_def.h"

#include <stddef.h>

const CommandKind command_kinds[COMMAND_KINDS] = {
    {HAWSER_WINCH_SPEED, "winch_speed", "m/s", -1e4, 1e4, 0, "winch"},
    {HAWSER_WINCH_TENSION, "winch_tension", "N", 0, 1e9, 0, "winch"},
    {HAWSER_WINCH_BRAKE, "winch_brake", NULL, 0, 0, 0, "winch"},
    {HAWSER_WINCH_PAUSE, "winch_pause", NULL, 0, 0, 0, "winch"},
    {HAWSER_WINCH_RESTART, "winch_restart", NULL, 0, 0, 0, "winch"},
    {HAWSER_CONVEYOR_SPEED, "conveyor_speed", "m/s", -1e4, 1e4, 1, "conveyor"},
    {HAWSER_CONVEYOR_CLAMP, "conveyor_clamp", "N", 0, 1e9, 1, "conveyor"},
    {HAWSER_REEL_BRAKE, "reel_brake", "N m", 0, 1e9, 0, "reel that pays out"},
    {HAWSER_JAM, "jam", NULL, 0, 0, 1, "thing that can jam"},
    {HAWSER_RELEASE, "release", NULL, 0, 0, 1, "thing that can jam"},
    {HAWSER_FRICTION, "friction", "", 0, 100, 2, "roller or surface"},
    {COMMAND_FORCE, "force", NULL, 0, 0, 0, "segment"},
};

const CommandKind *command_kind(int kind)
{
    for (int k = 0; k < COMMAND_KINDS; ++k) {
        if (command_kinds[k].kind == kind) return &command_kinds[k];
    }
    return NULL;
}
