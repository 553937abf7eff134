#include "sim/equipment/rooms.h"

#include <stddef.h>

/* The list of rooms. Those that touch the cable come last: their time is told apart. */
const RoomKind *const ROOM_KINDS[] = {&ENDS_ROOM,     &WINCH_ROOM,   &ROD_ROOM,    &REEL_ROOM,
                                      &CONVEYOR_ROOM, &ROLLERS_ROOM, &MOTORS_ROOM, &SELF_ROOM,
                                      &SURFACES_ROOM, &DRUM_ROOM,    NULL};
