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
