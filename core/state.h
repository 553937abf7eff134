/* The state vector y of a chain of n segments, as CVODE sees it: 13 arrays of n, one after the other,
 * px py pz qw qx qy qz vx vy vz wx wy wz; m, unit quaternion, m/s, rad/s, world components. */
#ifndef HAWSER_CORE_STATE_H
#define HAWSER_CORE_STATE_H

enum { STATE_P = 0, STATE_Q = 3, STATE_V = 7, STATE_W = 10, STATE_SIZE = 13 };

#endif
