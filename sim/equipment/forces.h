/* What acts on segments from outside: forces that the simulation was told, and a law of force of the caller's.
 * docs/model.md, "Control" (K7)-(K10). */
#ifndef HAWSER_SIM_EQUIPMENT_FORCES_H
#define HAWSER_SIM_EQUIPMENT_FORCES_H

#include "sim/scene.h"

/* A force that comes and goes. Plain: it is saved as it is. */
typedef struct OutsideForce {
    int segment;             /* of the whole chain */
    int follows;             /* force and moment turn with it */
    Vec3 force, moment, arm; /* N, N m; m, of the segment's axes */
    Profile share;           /* of it that acts */
} OutsideForce;

enum { OUTSIDE_MAX = 256 }; /* at a time, those that go among them */

/* A law of the caller's on segments from .. to-1 of the whole chain. */
typedef struct OutsideLaw {
    hawser_law call; /* NULL: none */
    void *user;
    int from, to, has_derivatives;
} OutsideLaw;

typedef struct Outside {
    int n;
    OutsideForce force[OUTSIDE_MAX]; /* [n] */
    OutsideLaw law;
    int stopped; /* the law asked for an end */
    int calls;   /* of the law that have not returned */
    int bad;     /* it has given what is no number since the last step that was accepted: for `segment` at `t`, s */
    int segment;
    double t;
} Outside;

/* The scene's, as RoomKind.self of FORCES_ROOM. */
Outside *outside_of(Scene *scene);
/* From now on; 1: done. Errors: INPUT (no such segments). */
hawser_status outside_law_set(Scene *scene, const OutsideLaw *law, hawser_error *err);
/* Whether the room is there: with forces; with `law` for that too, if there is one. */
void outside_attend(Scene *scene, int law);

#endif
