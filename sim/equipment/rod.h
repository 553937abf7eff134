/* A rod as it is simulated: its initial state, the ground bodies at its ends, the loads on it. docs/model.md, "Rods"
 * (RD1)-(RD9). */
#ifndef HAWSER_SIM_EQUIPMENT_ROD_H
#define HAWSER_SIM_EQUIPMENT_ROD_H

#include "core/chain.h"
#include "core/vec3.h"
#include "def/rod_def.h"
#include "hawser/hawser.h"

/* The ground body at an end at t = 0: where the end's cross-section is. */
typedef struct RodEnd {
    const RodEndDef *def;
    Vec3 place; /* m */
    Quat attitude;
} RodEnd;

typedef struct RodLoad {
    const RodLoadDef *def;
    int segment;
    double arm;     /* m from the segment's centre, along its axis */
    Vec3 direction; /* unit; of a follower in the segment's own axes, otherwise in the world's */
} RodLoad;

typedef struct Rod {
    int present;
    double *start; /* [13 n], owned: the state at t = 0 (core/state.h) */
    RodEnd end[2];
    int n_loads;
    RodLoad *load; /* [n_loads], owned */
    int still;     /* equilibria are looked for: ends that are led are where they are, without a velocity */
    double lag; /* share of their motions that the ends are behind: 0, but while the first equilibrium is looked for */
} Rod;

/* What a load does: the arm from its segment's centre, force, moment about that centre; m, N, N m, world (RD5). */
typedef struct RodWrench {
    Vec3 arm, force, moment;
} RodWrench;

RodWrench rod_wrench(const RodLoad *load, const Kinematics *kin, double t);

/* The attitude of segment i at t = 0; -1 and n: of the ends' ground bodies. */
Quat rod_attitude(const Rod *rod, int n, int i);

/* The largest of the loads at time t, N; moments count over half a segment. */
double rod_load_size(const Rod *rod, const Chain *chain, double t);
/* How many of the two ends are held in some way. */
int rod_ends_held(const Rod *rod);

/* Whether a load of time t has no potential: a follower, or a moment (RD6). */
int rod_circulates(const Rod *rod, double t);
/* In how many parts the ends are led to where they are at time t, so that no part turns one by more than 1 rad; 0: they
 * are not turned. */
int rod_led_parts(const Rod *rod, double t);
/* The latest time up to `next` by which no end is led by more than 1 rad from where it is at t, s: a turn that is led
 * at once cannot be told from none. */
double rod_led_until(const Rod *rod, double t, double next);
/* There is a rod, and nothing keeps it in its place: no end is held, and there is nothing on which it could come to
 * lie.
 */
struct Scene;
int rod_is_loose(const struct Scene *scene);

/* The segment that holds the place `at` (m from the tail, a joint belongs to the segment before it) and how far the
 * place is from its centre, along its axis (m). */
int rod_segment_at(const Chain *chain, double at, double *arm);

#endif
