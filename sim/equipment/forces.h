/* External loads on segments: forces given by commands, and a force law of the caller. docs/theory.md, "Control"
 * (K7)-(K10). */
#ifndef HAWSER_SIM_EQUIPMENT_FORCES_H
#define HAWSER_SIM_EQUIPMENT_FORCES_H

#include "sim/scene.h"

/* A force that fades in and out. It has no pointers: it is saved as it is. */
typedef struct OutsideForce {
    int segment;             /* index in the whole chain */
    int follows;             /* force and moment turn with it */
    Vec3 force, moment, arm; /* N, N m; m, of the segment's axes */
    Profile share;           /* share of it that acts, over time */
} OutsideForce;

enum { OUTSIDE_MAX = 256 }; /* at a time, including those that fade out */

/* The caller's force law on segments from .. to-1 of the whole chain. */
typedef struct OutsideLaw {
    hawser_law call; /* NULL: none */
    void *user;
    int from, to, has_derivatives;
} OutsideLaw;

typedef struct Outside {
    int n;
    OutsideForce force[OUTSIDE_MAX]; /* [n] */
    OutsideLaw law;
    int stopped; /* 1: the law requested the end of the run */
    int calls;   /* number of calls of the law that have not returned */
    int bad;     /* 1: the law has returned NAN or infinity since the last accepted step: for `segment` at `t`, s */
    int segment;
    double t;
} Outside;

/* The scene's, as RoomKind.self of FORCES_ROOM. */
Outside *outside_of(Scene *scene);
/* Sets the law from now on; 1: done. Errors: INPUT (no such segments). */
hawser_status outside_law_set(Scene *scene, const OutsideLaw *law, hawser_error *err);
/* Marks the kind as present if there are forces, or with `law` also if there is a law. */
void outside_attend(Scene *scene, int law);

#endif
