/* A rod as simulated: its initial state, the ground bodies at its ends, and its loads. docs/theory.md, "Rods"
 * (RD1)-(RD9). */
#ifndef HAWSER_SIM_EQUIPMENT_ROD_H
#define HAWSER_SIM_EQUIPMENT_ROD_H

#include "core/chain.h"
#include "core/vec3.h"
#include "def/rod_def.h"
#include "hawser/hawser.h"

/* The ground body of an end at t = 0, at the end's cross-section. */
typedef struct RodEnd {
    const RodEndDef *def;
    Vec3 place; /* m */
    Quat attitude;
} RodEnd;

typedef struct RodLoad {
    const RodLoadDef *def;
    int segment;
    double arm;     /* m from the segment's centre, along its axis */
    Vec3 direction; /* unit; in the segment's own axes for a follower, otherwise in the world's */
} RodLoad;

typedef struct Rod {
    int present;
    double *start; /* [13 n], owned: the state at t = 0 (core/state.h) */
    RodEnd end[2];
    int n_loads;
    RodLoad *load; /* [n_loads], owned */
    int still;     /* 1: an equilibrium is sought: led ends have their places of that time but no velocity */
    double lag; /* share by which the ends lag behind their motions: 0, except while the first equilibrium is sought */
} Rod;

/* Arm, force and moment of a load: arm from its segment's centre, moment about that centre; m, N, N m, world (RD5). */
typedef struct RodWrench {
    Vec3 arm, force, moment;
} RodWrench;

RodWrench rod_wrench(const RodLoad *load, const Kinematics *kin, double t);

/* Attitude of segment i at t = 0; of the ends' ground bodies for -1 and n. */
Quat rod_attitude(const Rod *rod, int n, int i);

/* Size of the largest load at time t, N; moments are divided by half a segment's length. */
double rod_load_size(const Rod *rod, const Chain *chain, double t);
/* Number of ends, of the two, that are held in some way. */
int rod_ends_held(const Rod *rod);

/* Checks whether a load at time t has no potential: a follower, or a moment (RD6). */
int rod_circulates(const Rod *rod, double t);
/* Number of parts in which the ends are led to their state at time t so that no part rotates one by more than 1 rad; 0:
 * they are not rotated. */
int rod_led_parts(const Rod *rod, double t);
/* Latest time up to `next` until which no end is led by more than 1 rad from its state at t, s: a full turn in one part
 * would be indistinguishable from none. */
double rod_led_until(const Rod *rod, double t, double next);
/* Checks for a rod without any constraint: no end is held, and there is nothing on which it could come to rest. */
struct Scene;
int rod_is_loose(const struct Scene *scene);

/* Segment at the place `at` (m from the tail; a joint belongs to the segment before it) and the distance of the place
 * from its centre, along its axis (m). */
int rod_segment_at(const Chain *chain, double at, double *arm);

#endif
