/* The sliders of LANES joints at once: moment, tangent and slip of bending with hysteresis; docs/model.md, "Bending
 * with hysteresis". Rotations and moments are the two bending components, y and z, in the bushing's frame. */
#ifndef HAWSER_CORE_SLIDER_LANES_H
#define HAWSER_CORE_SLIDER_LANES_H

#include "core/base/lane_math.h"
#include "core/chain.h"

/* One slider of LANES joints: the rotation of its spring as if it had not slipped since the last accepted step, and
 * what the slider lets it keep. */
typedef struct Slider {
    Lane k, limit;
    Lane y, z;  /* theta - slip, rad (HY5) */
    Lane size2; /* its square */
    Lane keeps; /* share that the spring keeps: 1 while it holds, limit / size where it slips (HY5) */
    LaneMask slips;
} Slider;

LANE_INLINE Slider slider_at(const Chain *chain, const Kinematics *kin, int s, int jj, Lane3 theta)
{
    Slider x;
    x.k = lane_load(chain->sliders.stiffness[s] + jj);
    x.limit = lane_load(chain->sliders.limit[s] + jj);
    x.y = theta.y - lane_load(kin->slip[2 * s] + jj);
    x.z = theta.z - lane_load(kin->slip[2 * s + 1] + jj);
    x.size2 = x.y * x.y + x.z * x.z;
    x.slips = x.size2 > x.limit * x.limit;
    const Lane size = lane_sqrt(lane_select(x.slips, x.size2, lane_set(1)));
    x.keeps = lane_select(x.slips, x.limit / size, lane_set(1));
    return x;
}

/* Adds the sliders' moments to the law's (HY6). */
LANE_INLINE void sliders_moment(const Chain *chain, const Kinematics *kin, int jj, Lane3 theta, Lane3 *mu)
{
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        mu->y += x.k * x.keeps * x.y;
        mu->z += x.k * x.keeps * x.z;
    }
}

/* What their springs hold, J (BA7). */
LANE_INLINE Lane sliders_energy(const Chain *chain, const Kinematics *kin, int jj, Lane3 theta)
{
    Lane sum = lane_set(0);
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        sum += 0.5 * x.k * x.keeps * x.keeps * x.size2;
    }
    return sum;
}

/* A symmetric 2 x 2 matrix a joint: the derivative of the sliders' moments by the bending rotations. */
typedef struct SliderTangent {
    Lane yy, yz, zz;
} SliderTangent;

/* k where a slider holds; k limit/size (1 - n n^T), n the direction of its spring, where it slips (HY7). */
LANE_INLINE SliderTangent sliders_tangent(const Chain *chain, const Kinematics *kin, int jj, Lane3 theta)
{
    SliderTangent t = {lane_set(0), lane_set(0), lane_set(0)};
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        const Lane k = x.k * x.keeps;
        const Lane along = lane_select(x.slips, k / x.size2, lane_set(0));
        t.yy += k - along * x.y * x.y;
        t.yz -= along * x.y * x.z;
        t.zz += k - along * x.z * x.z;
    }
    return t;
}

LANE_INLINE Lane3 slider_tangent_times(const SliderTangent *t, Lane3 a)
{
    return (Lane3){lane_set(0), t->yy * a.y + t->yz * a.z, t->yz * a.y + t->zz * a.z};
}

/* The slips move on to where the springs are at their limits: the return mapping (HY8). */
LANE_INLINE void sliders_slip(const Chain *chain, Kinematics *kin, int jj, Lane3 theta)
{
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        const Lane by = 1 - x.keeps;
        lane_store(kin->slip[2 * s] + jj, lane_load(kin->slip[2 * s] + jj) + by * x.y);
        lane_store(kin->slip[2 * s + 1] + jj, lane_load(kin->slip[2 * s + 1] + jj) + by * x.z);
    }
}

#endif
