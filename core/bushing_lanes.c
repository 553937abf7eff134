/* The kernels of core/bushing.h for one instruction set. */
#include "core/bushing.h"
#include "core/joint_lanes.h"

/* The kernels that are compiled: everything, for both frames; without sliders, and for the symmetric frame without
 * parts that most chains, or all, lack. More kernels would only cost program size. */
enum {
    FULL = JOINT_DAMPED | JOINT_PRELOADED,
    ADAMS_SLIDING = FULL | JOINT_SLIDING,
    SYMMETRIC = JOINT_SYMMETRIC | FULL,
    SYMMETRIC_SLIDING = SYMMETRIC | JOINT_SLIDING,
    SYMMETRIC_DAMPED = JOINT_SYMMETRIC | JOINT_DAMPED,
    SYMMETRIC_BARE = JOINT_SYMMETRIC
};

/* Kernel with the least work that the chain needs. */
static int traits_of(const Chain *chain)
{
    const int sliding = chain->sliders.count > 0;
    if (chain->frame != FRAME_SYMMETRIC) return sliding ? ADAMS_SLIDING : FULL;
    if (sliding) return SYMMETRIC_SLIDING;
    if (!(chain->lacks & CHAIN_NO_PRELOAD)) return SYMMETRIC;
    return chain->lacks & CHAIN_NO_DAMPING ? SYMMETRIC_BARE : SYMMETRIC_DAMPED;
}

LANE_INLINE JointPower loads_of(const Chain *chain, const Kinematics *kin, int from, int to, JointLoads *out,
                                int traits)
{
    Lane damping = lane_set(0), sliding = lane_set(0);
    for (int jj = from; jj < to; jj += LANES) {
        const Joint j = joint_at(chain, kin, jj, traits);
        const LaneMask mine = lane_index() < lane_set(to - jj);
        if (traits & JOINT_DAMPED) damping += lane_select(mine, joint_damping(&j, chain, jj), lane_set(0));
        if (traits & JOINT_SLIDING) sliding += lane_select(mine, joint_sliding(&j, chain, kin, jj), lane_set(0));
        l3_store(out->force, jj, frame_out(&j.frame, j.force));
        l3_store(out->torque_a, jj, frame_out(&j.frame, j.torque_a));
        l3_store(out->torque_b, jj, frame_out(&j.frame, j.torque_b));
    }
    return (JointPower){lane_sum(damping), lane_sum(sliding)};
}

static JointPower kernel_loads(const Chain *chain, const Kinematics *kin, int from, int to, JointLoads *out)
{
    switch (traits_of(chain)) { /* each case compiled separately */
    case SYMMETRIC_DAMPED:
        return loads_of(chain, kin, from, to, out, SYMMETRIC_DAMPED);
    case SYMMETRIC_BARE:
        return loads_of(chain, kin, from, to, out, SYMMETRIC_BARE);
    case SYMMETRIC_SLIDING:
        return loads_of(chain, kin, from, to, out, SYMMETRIC_SLIDING);
    case SYMMETRIC:
        return loads_of(chain, kin, from, to, out, SYMMETRIC);
    case ADAMS_SLIDING:
        return loads_of(chain, kin, from, to, out, ADAMS_SLIDING);
    default:
        return loads_of(chain, kin, from, to, out, FULL);
    }
}

/* (BA7), for either frame, since the two differ in d and theta alone. */
LANE_INLINE JointEnergy energy_of(const Chain *chain, const Kinematics *kin, int from, int to, int traits)
{
    Lane elastic = lane_set(0), sliding = lane_set(0);
    for (int jj = from; jj < to; jj += LANES) {
        const Joint j = joint_at(chain, kin, jj, traits);
        const LaneMask mine = lane_index() < lane_set(to - jj);
        const Lane3 force =
            l3_axpy(l3_load(chain->preload, jj), lane_set(0.5), l3_times(l3_load(chain->stiffness, jj), j.d));
        const Lane3 moment = l3_axpy(l3_load(chain->preload + 3, jj), lane_set(0.5),
                                     l3_times(l3_load(chain->stiffness + 3, jj), j.theta));
        elastic += lane_select(mine, l3_dot(force, j.d) + l3_dot(moment, j.theta), lane_set(0));
        if (traits & JOINT_SLIDING) {
            sliding += lane_select(mine, sliders_energy(chain, kin, jj, j.theta), lane_set(0));
        }
    }
    return (JointEnergy){lane_sum(elastic), lane_sum(sliding)};
}

static JointEnergy kernel_energy(const Chain *chain, const Kinematics *kin, int from, int to)
{
    const int sliding = chain->sliders.count > 0, symmetric = chain->frame == FRAME_SYMMETRIC;
    if (sliding)
        return symmetric ? energy_of(chain, kin, from, to, SYMMETRIC_SLIDING)
                         : energy_of(chain, kin, from, to, ADAMS_SLIDING);
    return symmetric ? energy_of(chain, kin, from, to, SYMMETRIC) : energy_of(chain, kin, from, to, FULL);
}

LANE_INLINE void law_of(const Chain *chain, const Kinematics *kin, int from, int to, double *const law[6], int traits)
{
    for (int jj = from; jj < to; jj += LANES) {
        const Joint j = joint_at(chain, kin, jj, traits);
        l3_store(law, jj, j.force);
        l3_store(law + 3, jj, j.mu);
    }
}

static void kernel_law(const Chain *chain, const Kinematics *kin, int from, int to, double *const law[6])
{
    switch (traits_of(chain)) {
    case SYMMETRIC_SLIDING:
        law_of(chain, kin, from, to, law, SYMMETRIC_SLIDING);
        break;
    case ADAMS_SLIDING:
        law_of(chain, kin, from, to, law, ADAMS_SLIDING);
        break;
    case FULL:
        law_of(chain, kin, from, to, law, FULL);
        break;
    default:
        law_of(chain, kin, from, to, law, SYMMETRIC);
    }
}

/* Only rotations are needed, those of every joint's two segments. */
static void kernel_slip(const Chain *chain, Kinematics *kin, int from, int to)
{
    for (int jj = from; jj < to; jj += LANES) {
        Joint j;
        joint_rotation(&j, kin, jj - 1, jj, chain->frame == FRAME_SYMMETRIC);
        sliders_slip(chain, kin, jj, j.theta);
    }
}

/* Data of a variation of the joint besides the joint itself. */
typedef struct JointSlopes {
    Lane t0, t1, h;       /* (d./dtheta)/theta of t0, t1, h (B10) */
    Lane3 kt, kr, ct, cr; /* stiffness and damping of the law */
    SliderTangent slider; /* if it has sliders (HY7) */
} JointSlopes;

LANE_INLINE JointSlopes joint_slopes(const Joint *j, const Chain *chain, const Kinematics *kin, int jj, int traits)
{
    JointSlopes g;
    g.t0 = joint_t0_slope(j->t0, j->cos_half, j->theta2);
    g.t1 = joint_t1_slope(g.t0, j->t1, j->theta2);
    g.h = joint_h_slope(j->h, j->theta2);
    g.kt = l3_load(chain->stiffness, jj);
    g.kr = l3_load(chain->stiffness + 3, jj);
    g.ct = l3_load(chain->damping, jj);
    g.cr = l3_load(chain->damping + 3, jj);
    if (traits & JOINT_SLIDING) g.slider = sliders_tangent(chain, kin, jj, j->theta);
    return g;
}

/* The variation of a joint's three vectors, components in F. */
typedef struct JointVariation {
    Lane3 force, torque_a, torque_b;
} JointVariation;

/* (dT) r for the variation dtheta of theta, with theta . dtheta given (B10). */
LANE_INLINE Lane3 vary_t_times(const Joint *j, const JointSlopes *g, Lane3 dtheta, Lane along, Lane3 r)
{
    const Lane tr = l3_dot(j->theta, r);
    const Lane3 stretch = l3_scale(g->t0 * along, r);
    const Lane on_theta = g->t1 * along * tr + j->t1 * l3_dot(dtheta, r);
    return l3_axpy(l3_axpy(stretch, on_theta, j->theta), j->t1 * tr, dtheta);
}

/* The moments that follow from a variation of the law's force and of its lever arms (B13). */
LANE_INLINE JointVariation vary_wrench(const Joint *j, Lane3 force, Lane3 moment, Lane3 twist, Lane3 dd, int symmetric)
{
    JointVariation v = {.force = force};
    const Lane3 c = l3_add(l3_cross(dd, j->force), l3_cross(j->d, force));
    v.torque_a = l3_add(l3_cross(j->la, force), moment);
    v.torque_b = l3_sub(l3_cross(j->lb, force), moment);
    if (symmetric) {
        const Lane3 t = l3_add(twist, l3_scale(j->h, l3_cross(c, j->theta)));
        const Lane3 half_c = l3_scale(lane_set(0.5), c);
        v.torque_a = l3_add(v.torque_a, l3_add(half_c, t));
        v.torque_b = l3_add(v.torque_b, l3_sub(half_c, t));
    } else {
        v.torque_b = l3_add(v.torque_b, c);
    }
    return v;
}

/* A relative displacement `shift` of B against A, without rotation (B11). */
LANE_INLINE JointVariation vary_shift(const Joint *j, const JointSlopes *g, Lane3 shift, int traits)
{
    Lane3 force;
    if (traits & JOINT_DAMPED) {
        const Lane3 rate = l3_neg(l3_cross(j->omega, shift));
        force = l3_add(l3_times(g->kt, shift), l3_times(g->ct, rate));
    } else {
        force = l3_times(g->kt, shift);
    }
    return vary_wrench(j, force, l3_zero(), l3_zero(), shift, traits & JOINT_SYMMETRIC);
}

/* Rotation vectors of A, B and the frame for a small rotation of A or of B (B6), and the change of theta. */
typedef struct Turn {
    Lane3 a, b, frame, relative, theta;
    Lane along; /* theta . dtheta */
} Turn;

LANE_INLINE Turn turn_of(const Joint *j, Lane3 a, Lane3 b, int symmetric)
{
    Turn t = {.a = a, .b = b, .relative = l3_sub(b, a)};
    const Lane3 bent = l3_cross(j->theta, t.relative);
    t.along = l3_dot(j->theta, t.relative);
    if (symmetric) {
        t.frame = l3_axpy(l3_scale(lane_set(0.5), l3_add(a, b)), -j->h, bent);
        t.theta = joint_t_times(j, t.relative);
    } else { /* the inverse right Jacobian of the rotation vector (B4) */
        const Lane cot = j->t0 * j->cos_half;
        const Lane beside = (1 - cot) / lane_select(j->theta2 > lane_set(0), j->theta2, lane_set(1)) * t.along;
        t.frame = b;
        t.theta = l3_axpy(l3_axpy(l3_scale(cot, t.relative), beside, j->theta), lane_set(0.5), bent);
    }
    return t;
}

/* Change of the frame's angular velocity, in F (B12). */
LANE_INLINE Lane3 vary_omega(const Joint *j, const JointSlopes *g, const Turn *t, int symmetric)
{
    if (!symmetric) return l3_neg(l3_cross(t->frame, j->wb));
    const Lane3 mean = l3_scale(lane_set(0.5), l3_add(j->wa, j->wb));
    Lane3 d = l3_neg(l3_cross(t->frame, mean));
    d = l3_axpy(d, -g->h * t->along, l3_cross(j->theta, j->rho));
    d = l3_axpy(d, -j->h, l3_cross(t->theta, j->rho));
    return l3_axpy(d, j->h, l3_cross(j->theta, l3_cross(t->frame, j->rho)));
}

/* Change of the rate of d by a small rotation (B12); moved: change of the lever arms, dd: of d. */
LANE_INLINE Lane3 vary_d_rate(const Joint *j, const JointSlopes *g, const Turn *t, Lane3 moved_a, Lane3 moved_b,
                              Lane3 dd, int symmetric)
{
    const Lane3 de =
        l3_neg(l3_add(l3_add(l3_cross(j->wa, moved_a), l3_cross(j->wb, moved_b)), l3_cross(t->frame, j->e)));
    const Lane3 domega = vary_omega(j, g, t, symmetric);
    return l3_sub(de, l3_add(l3_cross(domega, j->d), l3_cross(j->omega, dd)));
}

/* Change of the rate of theta. */
LANE_INLINE Lane3 vary_theta_rate(const Joint *j, const JointSlopes *g, const Turn *t, int symmetric)
{
    const Lane3 drho = l3_neg(l3_cross(t->frame, j->rho));
    if (!symmetric) return drho;
    return l3_add(vary_t_times(j, g, t->theta, t->along, j->rho), joint_t_times(j, drho));
}

/* A small rotation a of A and b of B: the full variation (B12), (B13). */
LANE_INLINE JointVariation vary_turn(const Joint *j, const JointSlopes *g, Lane3 a, Lane3 b, int traits)
{
    const int symmetric = traits & JOINT_SYMMETRIC;
    const Turn t = turn_of(j, a, b, symmetric);
    const Lane3 moved_a = l3_cross(a, j->la), moved_b = l3_cross(b, j->lb);
    const Lane3 dd = l3_neg(l3_add(l3_add(moved_a, moved_b), l3_cross(t.frame, j->d)));
    Lane3 force, dmu, moment;
    if (traits & JOINT_DAMPED) {
        const Lane3 drate = vary_d_rate(j, g, &t, moved_a, moved_b, dd, symmetric);
        force = l3_add(l3_times(g->kt, dd), l3_times(g->ct, drate));
        const Lane3 dtheta_rate = vary_theta_rate(j, g, &t, symmetric);
        dmu = l3_add(l3_times(g->kr, t.theta), l3_times(g->cr, dtheta_rate));
    } else {
        force = l3_times(g->kt, dd);
        dmu = l3_times(g->kr, t.theta);
    }
    if (traits & JOINT_SLIDING) dmu = l3_add(dmu, slider_tangent_times(&g->slider, t.theta));
    Lane3 twist = l3_zero();
    if (symmetric) {
        moment = l3_add(vary_t_times(j, g, t.theta, t.along, j->mu), joint_t_times(j, dmu));
        twist = l3_axpy(l3_scale(g->h * t.along, l3_cross(j->c, j->theta)), j->h, l3_cross(j->c, t.theta));
    } else {
        moment = dmu;
    }
    JointVariation v = vary_wrench(j, force, moment, twist, dd, symmetric);
    /* the lever arms rotate with their segments, and all components with the frame (B13) */
    v.torque_a = l3_add(v.torque_a, l3_cross(l3_cross(l3_sub(a, t.frame), j->la), j->force));
    v.torque_b = l3_add(v.torque_b, l3_cross(l3_cross(l3_sub(b, t.frame), j->lb), j->force));
    v.force = l3_add(v.force, l3_cross(t.frame, j->force));
    v.torque_a = l3_add(v.torque_a, l3_cross(t.frame, j->torque_a));
    v.torque_b = l3_add(v.torque_b, l3_cross(t.frame, j->torque_b));
    return v;
}

/* A change `dv` of the relative velocity and a, b of the angular velocities: only the damping changes (B14). */
LANE_INLINE JointVariation vary_rates(const Joint *j, const JointSlopes *g, Lane3 dv, Lane3 a, Lane3 b, int symmetric)
{
    const Turn t = turn_of(j, a, b, symmetric);
    const Lane3 de = l3_sub(dv, l3_add(l3_cross(a, j->la), l3_cross(b, j->lb)));
    const Lane3 force = l3_times(g->ct, l3_sub(de, l3_cross(t.frame, j->d)));
    const Lane3 dtheta_rate = symmetric ? joint_t_times(j, t.relative) : t.relative;
    const Lane3 dmu = l3_times(g->cr, dtheta_rate);
    const Lane3 moment = symmetric ? joint_t_times(j, dmu) : dmu;
    return vary_wrench(j, force, moment, l3_zero(), l3_zero(), symmetric);
}

/* Columns of a joint's derivative: 0..2 relative displacement, 3..5 rotation of A, 6..8 rotation of B; rows: force,
 * moment on A, moment on B. One matrix for the configuration, one for the velocities. */

LANE_INLINE void column_store(const Joint *j, JointVariation v, double (*out)[LANES])
{
    const Lane3 part[3] = {frame_out(&j->frame, v.force), frame_out(&j->frame, v.torque_a),
                           frame_out(&j->frame, v.torque_b)};
    for (int p = 0; p < 3; ++p) {
        lane_store(out[3 * p], part[p].x);
        lane_store(out[3 * p + 1], part[p].y);
        lane_store(out[3 * p + 2], part[p].z);
    }
}

LANE_INLINE void columns_of(const Chain *chain, const Kinematics *kin, int jj, JointMatrix *k, JointMatrix *d,
                            int traits)
{
    const int symmetric = traits & JOINT_SYMMETRIC;
    const Joint j = joint_at(chain, kin, jj, traits);
    const JointSlopes g = joint_slopes(&j, chain, kin, jj, traits);
    const Lane3 none = l3_zero();
    const LaneFrame *f = &j.frame; /* the world's unit vectors in components of F */
    const Lane3 unit[3] = {{f->x.x, f->y.x, f->z.x}, {f->x.y, f->y.y, f->z.y}, {f->x.z, f->y.z, f->z.z}};
    for (int c = 0; c < 3; ++c) {
        column_store(&j, vary_shift(&j, &g, unit[c], traits), k->entry[c]);
        column_store(&j, vary_turn(&j, &g, unit[c], none, traits), k->entry[3 + c]);
        column_store(&j, vary_turn(&j, &g, none, unit[c], traits), k->entry[6 + c]);
        if (!(traits & JOINT_DAMPED)) continue;
        column_store(&j, vary_rates(&j, &g, unit[c], none, none, symmetric), d->entry[c]);
        column_store(&j, vary_rates(&j, &g, none, unit[c], none, symmetric), d->entry[3 + c]);
        column_store(&j, vary_rates(&j, &g, none, none, unit[c], symmetric), d->entry[6 + c]);
    }
}

static void kernel_columns(const Chain *chain, const Kinematics *kin, int jj, JointMatrix *k, JointMatrix *d)
{
    switch (traits_of(chain)) { /* a preload alone makes no difference that justifies a kernel */
    case SYMMETRIC_BARE:
        columns_of(chain, kin, jj, k, d, SYMMETRIC_BARE);
        break;
    case SYMMETRIC_SLIDING:
        columns_of(chain, kin, jj, k, d, SYMMETRIC_SLIDING);
        break;
    case SYMMETRIC_DAMPED:
    case SYMMETRIC:
        columns_of(chain, kin, jj, k, d, SYMMETRIC);
        break;
    case ADAMS_SLIDING:
        columns_of(chain, kin, jj, k, d, ADAMS_SLIDING);
        break;
    default:
        columns_of(chain, kin, jj, k, d, FULL);
    }
}

const BushingKernels ISA_NAME(bushing_kernels) = {kernel_loads, kernel_law, kernel_columns, kernel_energy, kernel_slip};
