/* All equipment kinds (sim/room.h), in the order in which they act. The head of each file describes its kind. */
#ifndef HAWSER_SIM_EQUIPMENT_ROOMS_H
#define HAWSER_SIM_EQUIPMENT_ROOMS_H

#include "sim/room.h"

/* The list of equipment kinds: ROOM(kind) for each. Kinds with contacts come last, because their time is measured
 * apart. */
#define ROOMS(ROOM)                                                                                                    \
    ROOM(LAUNCH_ROOM)                                                                                                  \
    ROOM(MEDIUM_ROOM)                                                                                                  \
    ROOM(ENDS_ROOM)                                                                                                    \
    ROOM(WINCH_ROOM)                                                                                                   \
    ROOM(FORCES_ROOM)                                                                                                  \
    ROOM(ROD_ROOM)                                                                                                     \
    ROOM(REEL_ROOM)                                                                                                    \
    ROOM(CONVEYOR_ROOM)                                                                                                \
    ROOM(JAM_ROOM)                                                                                                     \
    ROOM(ROLLERS_ROOM)                                                                                                 \
    ROOM(MOTORS_ROOM)                                                                                                  \
    ROOM(CHAINS_ROOM)                                                                                                  \
    ROOM(SELF_ROOM)                                                                                                    \
    ROOM(SURFACES_ROOM)                                                                                                \
    ROOM(DRUM_ROOM)

#define ROOM_DECLARED(kind) extern const RoomKind kind;
ROOMS(ROOM_DECLARED)

#endif
