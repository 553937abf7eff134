/* Vectors of LANES doubles: the type in which the kernels over segments are written, once, for every instruction set.
 * The compiler splits a lane into what the machine has (one 512-bit, two 256-bit or four 128-bit registers). */
#ifndef HAWSER_CORE_BASE_LANES_H
#define HAWSER_CORE_BASE_LANES_H

#include <stdint.h>
#include <string.h>

#include "core/base/vec3.h"

enum { LANES = 8 };

typedef double Lane __attribute__((vector_size(LANES * sizeof(double))));
typedef int64_t LaneMask __attribute__((vector_size(LANES * sizeof(double))));

/* Three-vectors of lanes, and symmetric use of one letter a component. */
typedef struct Lane3 {
    Lane x, y, z;
} Lane3;

#define LANE_INLINE static inline __attribute__((always_inline, unused))

LANE_INLINE Lane lane_load(const double *p)
{
    Lane v;
    memcpy(&v, p, sizeof v);
    return v;
}
LANE_INLINE void lane_store(double *p, Lane v) { memcpy(p, &v, sizeof v); }
LANE_INLINE Lane lane_set(double s) { return (Lane){s, s, s, s, s, s, s, s}; }
/* a where the mask is set (all ones), b elsewhere. */
LANE_INLINE Lane lane_select(LaneMask mask, Lane a, Lane b)
{
    return (Lane)(((LaneMask)a & mask) | ((LaneMask)b & ~mask));
}

LANE_INLINE Lane3 l3_select(LaneMask mask, Lane3 a, Lane3 b)
{
    return (Lane3){lane_select(mask, a.x, b.x), lane_select(mask, a.y, b.y), lane_select(mask, a.z, b.z)};
}

LANE_INLINE Lane lane_index(void) { return (Lane){0, 1, 2, 3, 4, 5, 6, 7}; }
/* In a fixed order. */
LANE_INLINE double lane_sum(Lane a) { return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7])); }

/* One bit a lane, lane 0 the lowest: 1 where the mask is set. */
LANE_INLINE unsigned lane_bits(LaneMask mask)
{
    typedef int64_t Four __attribute__((vector_size(4 * sizeof(int64_t))));
    const LaneMask bit = mask & (LaneMask){1, 2, 4, 8, 16, 32, 64, 128};
    const Four four = __builtin_shufflevector(bit, bit, 0, 1, 2, 3) | __builtin_shufflevector(bit, bit, 4, 5, 6, 7);
    return (unsigned)((four[0] | four[1]) | (four[2] | four[3]));
}

LANE_INLINE Lane3 l3_load(double *const p[3], int i)
{
    return (Lane3){lane_load(p[0] + i), lane_load(p[1] + i), lane_load(p[2] + i)};
}
LANE_INLINE void l3_store(double *const p[3], int i, Lane3 v)
{
    lane_store(p[0] + i, v.x);
    lane_store(p[1] + i, v.y);
    lane_store(p[2] + i, v.z);
}
/* The same vector in every lane. */
LANE_INLINE Lane3 l3_spread(Vec3 a) { return (Lane3){lane_set(a.x), lane_set(a.y), lane_set(a.z)}; }
/* World axis 0, 1 or 2. */
LANE_INLINE Lane3 l3_axis(int c) { return (Lane3){lane_set(c == 0), lane_set(c == 1), lane_set(c == 2)}; }
LANE_INLINE Lane3 l3_zero(void) { return (Lane3){lane_set(0), lane_set(0), lane_set(0)}; }
LANE_INLINE Lane3 l3_add(Lane3 a, Lane3 b) { return (Lane3){a.x + b.x, a.y + b.y, a.z + b.z}; }
LANE_INLINE Lane3 l3_sub(Lane3 a, Lane3 b) { return (Lane3){a.x - b.x, a.y - b.y, a.z - b.z}; }
LANE_INLINE Lane3 l3_neg(Lane3 a) { return (Lane3){-a.x, -a.y, -a.z}; }
LANE_INLINE Lane3 l3_scale(Lane s, Lane3 a) { return (Lane3){s * a.x, s * a.y, s * a.z}; }
LANE_INLINE Lane3 l3_axpy(Lane3 a, Lane s, Lane3 b) { return (Lane3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z}; }
/* Component by component. */
LANE_INLINE Lane3 l3_times(Lane3 a, Lane3 b) { return (Lane3){a.x * b.x, a.y * b.y, a.z * b.z}; }
LANE_INLINE Lane l3_dot(Lane3 a, Lane3 b) { return a.x * b.x + a.y * b.y + a.z * b.z; }
LANE_INLINE Lane3 l3_cross(Lane3 a, Lane3 b)
{
    return (Lane3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

#endif
