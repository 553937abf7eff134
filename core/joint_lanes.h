/* The sliders of LANES joints at once: moment, tangent and slip of bending with hysteresis; docs/theory.md, "Bending
 * with hysteresis". Rotations and moments are the two bending components, y and z, in the bushing's frame. */
#ifndef HAWSER_CORE_JOINT_LANES_H
#define HAWSER_CORE_JOINT_LANES_H

#include "core/chain.h"
#include "core/lanes.h"

/* One slider of LANES joints: the rotation of its spring without further slip since the last accepted step, and the
 * share of it that the slider allows. */
typedef struct Slider {
    Lane k, limit;
    Lane y, z;  /* theta - slip, rad (HY5) */
    Lane size2; /* its square */
    Lane keeps; /* share that the spring keeps: 1 while the slider holds, limit / size where it slips (HY5) */
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

/* Energy stored in their springs, J (BA7). */
LANE_INLINE Lane sliders_energy(const Chain *chain, const Kinematics *kin, int jj, Lane3 theta)
{
    Lane sum = lane_set(0);
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        sum += 0.5 * x.k * x.keeps * x.keeps * x.size2;
    }
    return sum;
}

/* A symmetric 2 x 2 matrix per joint: the derivative of the sliders' moments by the bending rotations. */
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

/* Moves the slips so that the springs are at their limits: the return mapping (HY8). */
LANE_INLINE void sliders_slip(const Chain *chain, Kinematics *kin, int jj, Lane3 theta)
{
    for (int s = 0; s < chain->sliders.count; ++s) {
        const Slider x = slider_at(chain, kin, s, jj, theta);
        const Lane by = 1 - x.keeps;
        lane_store(kin->slip[2 * s] + jj, lane_load(kin->slip[2 * s] + jj) + by * x.y);
        lane_store(kin->slip[2 * s + 1] + jj, lane_load(kin->slip[2 * s + 1] + jj) + by * x.z);
    }
}

/* Geometry and wrench of LANES bushings at once, for the force and the derivative kernels; docs/theory.md, "Bushing".
 * Letters as there: A the segment before the joint, B the one after; vectors are in the frame F, or world (_w). */

/* Columns of a rotation: R e_x, R e_y, R e_z. */
typedef struct LaneFrame {
    Lane3 x, y, z;
} LaneFrame;

typedef struct Joint {
    LaneFrame frame;          /* F in the world */
    Lane3 theta;              /* relative rotation vector, the same components in A, F and B */
    Lane theta2;              /* its square */
    Lane t0, t1;              /* T = t0 1 + t1 theta theta^T (B5) */
    Lane h;                   /* tan(theta/4) / (2 theta) (B6) */
    Lane cos_half;            /* cos(theta/2) */
    Lane3 la, lb;             /* half-length vectors toward the joint's side: rA along A's axis, rB along B's */
    Lane3 d, e;               /* gap and its world rate in F (B1), (B7) */
    Lane3 wa, wb, rho;        /* angular velocities, rho = wb - wa */
    Lane3 omega;              /* angular velocity of F (B6) */
    Lane3 d_rate;             /* rate of d in F: e - omega x d (B7) */
    Lane3 theta_rate;         /* rate of theta as the law takes it (B7) */
    Lane3 force, mu;          /* law: K d + C d' + f0 and K theta + C theta' + m0 (B8) */
    Lane3 moment;             /* T mu (symmetric) or mu (adams) (B9) */
    Lane3 c;                  /* d x force */
    Lane3 torque_a, torque_b; /* moments about the centres of A and B (B9) */
} Joint;

/* Features for which a kernel is compiled, bits of `traits`: absent ones cost nothing. */
enum {
    JOINT_SYMMETRIC = 1, /* the mid-frame (B3); otherwise marker J's */
    JOINT_DAMPED = 2,    /* damping and the rates that it needs */
    JOINT_PRELOADED = 4, /* a wrench at rest */
    JOINT_SLIDING = 8,   /* sliders beside the bending springs (HY4) */
};

/* World to frame and back. */
LANE_INLINE Lane3 frame_in(const LaneFrame *f, Lane3 v)
{
    return (Lane3){l3_dot(f->x, v), l3_dot(f->y, v), l3_dot(f->z, v)};
}

LANE_INLINE Lane3 frame_out(const LaneFrame *f, Lane3 v)
{
    return l3_axpy(l3_axpy(l3_scale(v.x, f->x), v.y, f->y), v.z, f->z);
}

LANE_INLINE LaneFrame frame_of_quaternion(Lane w, Lane3 u)
{
    const Lane one = lane_set(1), two = lane_set(2);
    return (LaneFrame){{one - two * (u.y * u.y + u.z * u.z), two * (u.x * u.y + w * u.z), two * (u.x * u.z - w * u.y)},
                       {two * (u.x * u.y - w * u.z), one - two * (u.x * u.x + u.z * u.z), two * (u.y * u.z + w * u.x)},
                       {two * (u.x * u.z + w * u.y), two * (u.y * u.z - w * u.x), one - two * (u.x * u.x + u.y * u.y)}};
}

/* Even functions of the angle, by series in theta^2 below 1 rad and in closed form above (B5), (B10). */
LANE_INLINE Lane even_function(const double *c, int terms, Lane theta2, Lane closed_form)
{
    return lane_select(theta2 < lane_set(1), lane_poly(c, terms, theta2), closed_form);
}

/* (1 - t0) / theta^2 */
LANE_INLINE Lane joint_t1(Lane t0, Lane theta2)
{
    static const double c[] = {-1.0 / 24,
                               -7.0 / 5760,
                               -31.0 / 967680,
                               -8.202608300264551e-07,
                               -2.0835982071876168e-08,
                               -5.281609967721337e-10,
                               -1.3380902920268335e-11,
                               -3.389576851489321e-13,
                               -8.585996549822947e-15};
    return even_function(c, 9, theta2, (1 - t0) / theta2);
}

/* (dt0/dtheta) / theta = t0 (1 - t0 cos(theta/2)) / theta^2 */
LANE_INLINE Lane joint_t0_slope(Lane t0, Lane cos_half, Lane theta2)
{
    static const double c[] = {1.0 / 12,
                               1.0 / 720,
                               1.0 / 30240,
                               8.267195767195768e-07,
                               2.08767569878681e-08,
                               5.284190138687493e-10,
                               1.3382536530684679e-11,
                               3.3896802963225827e-13,
                               8.586062056277845e-15};
    return t0 * even_function(c, 9, theta2, (1 - t0 * cos_half) / theta2);
}

/* (dt1/dtheta) / theta = -(t0'/theta + 2 t1) / theta^2 */
LANE_INLINE Lane joint_t1_slope(Lane t0_slope, Lane t1, Lane theta2)
{
    static const double c[] = {-0.0024305555555555556,  -0.00012814153439153438, -4.92156498015873e-06,
                               -1.6668785657500935e-07, -5.2816099677213374e-09, -1.6057083504322002e-10,
                               -4.7454075920850495e-12, -1.3737594479716716e-13, -3.9147561905854015e-15};
    return even_function(c, 9, theta2, -(t0_slope + 2 * t1) / theta2);
}

/* (dh/dtheta) / theta = (1/8 + h^2 theta^2 / 2 - h) / theta^2 */
LANE_INLINE Lane joint_h_slope(Lane h, Lane theta2)
{
    static const double c[] = {1.0 / 192,
                               1.0 / 3840,
                               9.881882440476191e-06,
                               3.3370191247795415e-07,
                               1.0565800106408831e-08,
                               3.211612734114362e-10,
                               9.490960006936665e-12,
                               2.7475293769761266e-13,
                               7.829519847989912e-15};
    return even_function(c, 9, theta2, (0.125 + 0.5 * h * h * theta2 - h) / theta2);
}

/* T r (B5). */
LANE_INLINE Lane3 joint_t_times(const Joint *j, Lane3 r)
{
    return l3_axpy(l3_scale(j->t0, r), j->t1 * l3_dot(j->theta, r), j->theta);
}

/* Relative rotation of B against A and the frame F (B2)-(B4). */
LANE_INLINE void joint_rotation(Joint *j, const Kinematics *kin, int ja, int jb, int symmetric)
{
    const Lane aw = lane_load(kin->q[0] + ja), bw = lane_load(kin->q[0] + jb);
    const Lane3 au = l3_load(kin->q + 1, ja), bu = l3_load(kin->q + 1, jb);
    Lane s = aw * bw + l3_dot(au, bu);
    Lane3 v = l3_sub(l3_axpy(l3_scale(aw, bu), -bw, au), l3_cross(au, bu));
    const LaneMask flip = s < lane_set(0); /* q and -q are the same rotation: takes the shorter one */
    s = lane_select(flip, -s, s);
    v = (Lane3){lane_select(flip, -v.x, v.x), lane_select(flip, -v.y, v.y), lane_select(flip, -v.z, v.z)};

    const Lane inv = 1 / lane_sqrt(2 * (1 + s)); /* the half rotation (hw, hv) */
    const Lane hw = (1 + s) * inv;
    const Lane3 hv = l3_scale(inv, v);
    const Lane ratio = lane_asin_ratio(l3_dot(hv, hv));
    j->theta = l3_scale(4 * ratio, hv);
    j->theta2 = l3_dot(j->theta, j->theta);
    j->t0 = 2 * ratio * inv;
    j->t1 = joint_t1(j->t0, j->theta2);
    j->h = 1 / (8 * ratio * hw);
    j->cos_half = s;
    if (symmetric) {
        const Lane mw = aw * hw - l3_dot(au, hv);
        const Lane3 mu = l3_add(l3_axpy(l3_scale(aw, hv), hw, au), l3_cross(au, hv));
        j->frame = frame_of_quaternion(mw, mu);
    } else {
        j->frame = frame_of_quaternion(bw, bu);
    }
}

/* Gap (B1); with damping, rates and the frame's angular velocity (B6), (B7). */
LANE_INLINE void joint_rates(Joint *j, const Chain *chain, const Kinematics *kin, int ja, int jb, int traits)
{
    const int symmetric = traits & JOINT_SYMMETRIC, damped = traits & JOINT_DAMPED;
    const LaneFrame *f = &j->frame;
    const Lane3 la_w = l3_scale(lane_load(chain->half + ja), l3_load(kin->a, ja));
    const Lane3 lb_w = l3_scale(lane_load(chain->half + jb), l3_load(kin->a, jb));
    const Lane3 dx_w = l3_sub(l3_load(kin->p, jb), l3_load(kin->p, ja));
    const Lane3 dv_w = damped ? l3_sub(l3_load(kin->v, jb), l3_load(kin->v, ja)) : l3_zero();
    j->la = frame_in(f, la_w);
    j->lb = frame_in(f, lb_w);
    if (damped) {
        j->wa = frame_in(f, l3_load(kin->w, ja));
        j->wb = frame_in(f, l3_load(kin->w, jb));
        j->rho = l3_sub(j->wb, j->wa);
    }
    j->d = frame_in(f, l3_sub(dx_w, l3_add(la_w, lb_w)));
    if (!damped) {
        j->wa = j->wb = j->rho = j->e = j->omega = j->d_rate = j->theta_rate = l3_zero();
        return;
    }
    j->e = l3_sub(frame_in(f, dv_w), l3_add(l3_cross(j->wa, j->la), l3_cross(j->wb, j->lb)));
    const Lane3 mean = l3_scale(lane_set(0.5), l3_add(j->wa, j->wb));
    j->omega = symmetric ? l3_axpy(mean, -j->h, l3_cross(j->theta, j->rho)) : j->wb;
    j->d_rate = l3_sub(j->e, l3_cross(j->omega, j->d));
    j->theta_rate = symmetric ? joint_t_times(j, j->rho) : j->rho;
}

/* The law (B8) and the wrench on both segments (B9). */
LANE_INLINE void joint_wrench(Joint *j, const Chain *chain, const Kinematics *kin, int jj, int traits)
{
    const int symmetric = traits & JOINT_SYMMETRIC;
    const Lane3 kt = l3_load(chain->stiffness, jj), kr = l3_load(chain->stiffness + 3, jj);
    const Lane3 ct = l3_load(chain->damping, jj), cr = l3_load(chain->damping + 3, jj);
    j->force = l3_add(l3_times(kt, j->d), l3_times(ct, j->d_rate));
    j->mu = l3_add(l3_times(kr, j->theta), l3_times(cr, j->theta_rate));
    if (traits & JOINT_PRELOADED) {
        j->force = l3_add(j->force, l3_load(chain->preload, jj));
        j->mu = l3_add(j->mu, l3_load(chain->preload + 3, jj));
    }
    if (traits & JOINT_SLIDING) sliders_moment(chain, kin, jj, j->theta, &j->mu);
    j->moment = symmetric ? joint_t_times(j, j->mu) : j->mu;
    j->c = l3_cross(j->d, j->force);
    const Lane3 pull_a = l3_add(l3_cross(j->la, j->force), j->moment);
    const Lane3 pull_b = l3_sub(l3_cross(j->lb, j->force), j->moment);
    if (symmetric) {
        const Lane3 half_c = l3_scale(lane_set(0.5), j->c);
        const Lane3 twist = l3_scale(j->h, l3_cross(j->c, j->theta));
        j->torque_a = l3_add(pull_a, l3_add(half_c, twist));
        j->torque_b = l3_add(pull_b, l3_sub(half_c, twist));
    } else {
        j->torque_a = pull_a;
        j->torque_b = l3_add(pull_b, j->c);
    }
}

/* Power of the damping (BA4): a quadratic form in the rates, exactly that of the wrench (B9). */
LANE_INLINE Lane joint_damping(const Joint *j, const Chain *chain, int jj)
{
    const Lane3 ct = l3_load(chain->damping, jj), cr = l3_load(chain->damping + 3, jj);
    /* squares first: a product shared with the law would no longer be fused with its sum, and round differently */
    return l3_dot(ct, l3_times(j->d_rate, j->d_rate)) + l3_dot(cr, l3_times(j->theta_rate, j->theta_rate));
}

/* Power of the sliders' moments, including the energy stored in their springs (BA4). */
LANE_INLINE Lane joint_sliding(const Joint *j, const Chain *chain, const Kinematics *kin, int jj)
{
    Lane3 moment = l3_zero();
    sliders_moment(chain, kin, jj, j->theta, &moment);
    return l3_dot(moment, j->theta_rate);
}

/* Computes everything about joints jj .. jj + LANES - 1. */
LANE_INLINE Joint joint_at(const Chain *chain, const Kinematics *kin, int jj, int traits)
{
    const int symmetric = traits & JOINT_SYMMETRIC;
    Joint j;
    joint_rotation(&j, kin, jj - 1, jj, symmetric);
    joint_rates(&j, chain, kin, jj - 1, jj, traits);
    joint_wrench(&j, chain, kin, jj, traits);
    return j;
}

#endif
