/* Functions of lanes: what the vector types of core/base/lanes.h do not have as operators. */
#ifndef HAWSER_CORE_BASE_LANE_MATH_H
#define HAWSER_CORE_BASE_LANE_MATH_H

#include <math.h>

#include "core/base/lanes.h"

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
