/* Every kind of room (sim/room.h), by name. What each is stands at the head of its file. */
#ifndef HAWSER_SIM_EQUIPMENT_ROOMS_H
#define HAWSER_SIM_EQUIPMENT_ROOMS_H

#include "sim/room.h"

extern const RoomKind ENDS_ROOM, WINCH_ROOM, ROD_ROOM, REEL_ROOM, CONVEYOR_ROOM, ROLLERS_ROOM, MOTORS_ROOM, SELF_ROOM,
    SURFACES_ROOM, DRUM_ROOM;

#endif
