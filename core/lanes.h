/* Vectors of LANES doubles: the type in which the kernels over segments are written, once, for every instruction set.
 * The compiler splits a lane into the machine's registers (one of 512 bits, two of 256 or four of 128). */
#ifndef HAWSER_CORE_LANES_H
#define HAWSER_CORE_LANES_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#include "core/vec3.h"

enum { LANES = 8 };

typedef double Lane __attribute__((vector_size(LANES * sizeof(double))));

typedef int64_t LaneMask __attribute__((vector_size(LANES * sizeof(double))));

/* Three-vectors of lanes. */
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

/* Sum in a fixed order. */
LANE_INLINE double lane_sum(Lane a) { return ((a[0] + a[4]) + (a[2] + a[6])) + ((a[1] + a[5]) + (a[3] + a[7])); }

/* One bit per lane, lane 0 the lowest: 1 where the mask is set. */
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

/* Functions of lanes that the vector types of core/lanes.h do not have as operators. */

LANE_INLINE Lane lane_sqrt(Lane x)
{
    Lane r;
    for (int k = 0; k < LANES; ++k) r[k] = sqrt(x[k]);
    return r;
}

LANE_INLINE Lane lane_abs(Lane x) { return lane_select(x < lane_set(0), -x, x); }

/* max(x, floor). */
LANE_INLINE Lane lane_at_least(Lane x, double floor) { return lane_select(x > lane_set(floor), x, lane_set(floor)); }

/* STEP from 0 at x0 to 1 at x1 > x0 with its derivative (P1): step_cubic of core/profile.h in lanes. */
typedef struct LaneStep {
    Lane value, slope;
} LaneStep;

/* D = (x - x0)/(x1 - x0), clamped to 0..1; per = 1/(x1 - x0). */
LANE_INLINE Lane lane_ramp(Lane x, Lane x0, Lane per)
{
    const Lane d = (x - x0) * per, zero = lane_set(0), one = lane_set(1);
    return lane_select(d > zero, lane_select(d < one, d, one), zero);
}

LANE_INLINE LaneStep lane_step(Lane x, Lane x0, Lane x1)
{
    const Lane per = 1 / (x1 - x0), d = lane_ramp(x, x0, per);
    return (LaneStep){d * d * (3 - 2 * d), 6 * d * (1 - d) * per};
}

/* Horner's rule, c[0] + c[1] x + ... */
LANE_INLINE Lane lane_poly(const double *c, int terms, Lane x)
{
    Lane sum = lane_set(c[terms - 1]);
    for (int k = terms - 2; k >= 0; --k) sum = sum * x + lane_set(c[k]);
    return sum;
}

LANE_INLINE int lane_any(LaneMask m)
{
    int64_t any = 0;
    for (int k = 0; k < LANES; ++k) any |= m[k];
    return any != 0;
}

/* asin(sqrt(x)) / sqrt(x) for 0 <= x < 1: the series where it converges to rounding (x < 0.062, a joint bent by less
 * than 1 rad), the library elsewhere. */
LANE_INLINE Lane lane_asin_ratio(Lane x)
{
    static const double c[] = {1.0,
                               1.0 / 6,
                               3.0 / 40,
                               5.0 / 112,
                               35.0 / 1152,
                               63.0 / 2816,
                               231.0 / 13312,
                               143.0 / 10240,
                               6435.0 / 557056,
                               12155.0 / 1245184,
                               46189.0 / 5505024,
                               88179.0 / 12058624,
                               676039.0 / 104857600};
    Lane ratio = lane_poly(c, sizeof c / sizeof *c, x);
    const LaneMask far = x > lane_set(0.0612);
    if (lane_any(far)) {
        for (int k = 0; k < LANES; ++k) {
            const double root = sqrt(x[k] < 1 ? x[k] : 1);
            if (far[k]) ratio[k] = asin(root) / root;
        }
    }
    return ratio;
}

#endif
