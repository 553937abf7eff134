/* The state vector y of a chain of n segments, as CVODE sees it: 13 arrays of n, one after the other,
 * px py pz qw qx qy qz vx vy vz wx wy wz; m, unit quaternion, m/s, rad/s, world components. */
#ifndef HAWSER_CORE_STATE_H
#define HAWSER_CORE_STATE_H

#include "core/vec3.h"

enum { STATE_P = 0, STATE_Q = 3, STATE_V = 7, STATE_W = 10, STATE_SIZE = 13 };

/* Three numbers of segment i from component `part` on, and its unit quaternion. */
static inline Vec3 state_vector(const double *y, int n, int part, int i)
{
    const double *const from = y + part * n + i;
    return v3(from[0], from[n], from[2 * n]);
}

static inline Quat state_attitude(const double *y, int n, int i)
{
    const double *const q = y + STATE_Q * n + i;
    return quat_unit((Quat){q[0], q[n], q[2 * n], q[3 * n]});
}

/* Power and force of something on the motion of the chain. */

typedef struct Push {
    double power; /* W */
    Vec3 force;   /* N */
} Push;

static inline Push push_sum(Push a, Push b) { return (Push){a.power + b.power, v3_add(a.force, b.force)}; }

#endif
