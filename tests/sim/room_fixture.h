/* One room of a scene by itself, as the corridor calls it. */
#ifndef HAWSER_TESTS_SIM_ROOM_FIXTURE_H
#define HAWSER_TESTS_SIM_ROOM_FIXTURE_H

#include "sim/dynamics.h"
#include "sim/equipment/rooms.h"

/* Adds its loads to ws->loads of both parts, for the kinematics in the workspace. */
static inline void room_loads(const RoomKind *kind, Scene *scene, Workspace *ws, double t, double friction)
{
    const Moment m = {scene, ws, t, friction};
    for (int part = 0; part < PARTS; ++part) kind->loads(room_of(scene, kind), &m, part);
}

/* Adds their derivatives. */
static inline void room_blocks(const RoomKind *kind, Scene *scene, Workspace *ws, double t, double friction,
                               BlockChain *k, BlockChain *d)
{
    const Moment m = {scene, ws, t, friction};
    kind->blocks(room_of(scene, kind), &m, k, d);
}

/* What a sample reads of it; how many contacts carry force. */
static inline int room_look(const RoomKind *kind, Scene *scene, Workspace *ws)
{
    const Moment m = {scene, ws, 0, 1};
    return kind->look(room_of(scene, kind), &m);
}

#endif
