/* Plane vectors of lanes, and the sine and cosine of lanes. docs/theory.md, "Planar chain". */
#ifndef HAWSER_CORE_PLANE_LANES_H
#define HAWSER_CORE_PLANE_LANES_H

#include "core/lanes.h"

/* A vector by its components along the plane's two axes. */
typedef struct Lane2 {
    Lane x, z;
} Lane2;

LANE_INLINE Lane2 l2_load(double *const p[2], int i) { return (Lane2){lane_load(p[0] + i), lane_load(p[1] + i)}; }
LANE_INLINE void l2_store(double *const p[2], int i, Lane2 v)
{
    lane_store(p[0] + i, v.x);
    lane_store(p[1] + i, v.z);
}
LANE_INLINE Lane2 l2_add(Lane2 a, Lane2 b) { return (Lane2){a.x + b.x, a.z + b.z}; }
LANE_INLINE Lane2 l2_sub(Lane2 a, Lane2 b) { return (Lane2){a.x - b.x, a.z - b.z}; }
LANE_INLINE Lane2 l2_neg(Lane2 a) { return (Lane2){-a.x, -a.z}; }
LANE_INLINE Lane2 l2_scale(Lane s, Lane2 a) { return (Lane2){s * a.x, s * a.z}; }
LANE_INLINE Lane2 l2_axpy(Lane2 a, Lane s, Lane2 b) { return (Lane2){a.x + s * b.x, a.z + s * b.z}; }
LANE_INLINE Lane l2_dot(Lane2 a, Lane2 b) { return a.x * b.x + a.z * b.z; }
/* a x b, which is along the plane's normal. */
LANE_INLINE Lane l2_cross(Lane2 a, Lane2 b) { return a.x * b.z - a.z * b.x; }
/* J a (PL1): a quarter turn from the first axis toward the second. */
LANE_INLINE Lane2 l2_turn(Lane2 a) { return (Lane2){-a.z, a.x}; }
/* From components along and across the unit vector f to components along the plane's axes, and back. */
LANE_INLINE Lane2 l2_out(Lane2 f, Lane2 v) { return (Lane2){f.x * v.x - f.z * v.z, f.z * v.x + f.x * v.z}; }
LANE_INLINE Lane2 l2_in(Lane2 f, Lane2 v) { return (Lane2){f.x * v.x + f.z * v.z, f.x * v.z - f.z * v.x}; }

/* (cos x, sin x) for |x| below about 1e6: x less the nearest multiple of pi/2, then the Taylor series, which at pi/4
 * are exact to rounding with nine terms; the multiple determines which of the two is which, and their signs. */
LANE_INLINE Lane2 lane_direction(Lane x)
{
    static const double odd[] = {1,
                                 -1.0 / 6,
                                 1.0 / 120,
                                 -1.0 / 5040,
                                 1.0 / 362880,
                                 -1.0 / 39916800,
                                 1.0 / 6227020800.0,
                                 -1.0 / 1307674368000.0,
                                 1.0 / 355687428096000.0};
    static const double even[] = {1,
                                  -1.0 / 2,
                                  1.0 / 24,
                                  -1.0 / 720,
                                  1.0 / 40320,
                                  -1.0 / 3628800,
                                  1.0 / 479001600,
                                  -1.0 / 87178291200.0,
                                  1.0 / 20922789888000.0};
    /* pi/2 in two parts, the first short enough for its multiples to be exact; 1.5 2^52 rounds to whole numbers */
    const Lane rounding = lane_set(6755399441055744.0);
    const Lane marked = x * lane_set(0.63661977236758134308) + rounding, times = marked - rounding;
    const Lane r = (x - times * lane_set(1.57079632673412561417)) - times * lane_set(6.07710050650619224932e-11);
    const Lane square = r * r, sine = r * lane_poly(odd, 9, square), cosine = lane_poly(even, 9, square);
    const LaneMask quarter = (LaneMask)marked, swap = -(quarter & 1), zero = {0};
    const LaneMask sine_turns = zero - ((quarter >> 1) & 1), cosine_turns = zero - (((quarter + 1) >> 1) & 1);
    const Lane s = lane_select(swap, cosine, sine), c = lane_select(swap, sine, cosine);
    return (Lane2){lane_select(cosine_turns, -c, c), lane_select(sine_turns, -s, s)};
}

#endif
