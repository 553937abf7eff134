#include "sim/equipment/rooms.h"

#include <stddef.h>

#define ROOM_LISTED(kind) &kind,
const RoomKind *const ROOM_KINDS[] = {ROOMS(ROOM_LISTED) NULL};
