/* The kernels of core/planar.h for one instruction set. Letters as in docs/theory.md, "Planar chain". */
#include "core/planar.h"
#include "core/plane_lanes.h"

static void kernel_kinematics(const PlanarChain *chain, const double *y, int from, int to, PlanarKinematics *kin)
{
    const int stride = chain->stride;
    for (int i = from; i < to; i += LANES) {
        const double *const at = y + i;
        const Lane angle = lane_load(at + PLANAR_ANGLE * stride);
        const Lane2 h = lane_direction(0.5 * angle);
        lane_store(kin->p[0] + i, lane_load(at));
        lane_store(kin->p[1] + i, lane_load(at + stride));
        lane_store(kin->angle + i, angle);
        l2_store(kin->h, i, h);
        l2_store(kin->a, i, (Lane2){h.x * h.x - h.z * h.z, 2 * h.x * h.z}); /* (PL3) */
        lane_store(kin->v[0] + i, lane_load(at + PLANAR_V * stride));
        lane_store(kin->v[1] + i, lane_load(at + (PLANAR_V + 1) * stride));
        lane_store(kin->w + i, lane_load(at + PLANAR_W * stride));
    }
}

/* LANES joints: A the segment before, B the one after. */
typedef struct PlanarJoint {
    Lane share;     /* s (PL4) */
    Lane2 frame;    /* first axis of F */
    Lane2 ra, rb;   /* half-length vectors along the axes of A and B */
    Lane2 d, e;     /* gap and its rate relative to F, along the plane's axes (PL5) */
    Lane wa, wb, w; /* angular velocities of A, B and F */
    Lane2 law;      /* axial force and shear force (PL6) */
    Lane2 force;    /* the same along the plane's axes */
    Lane bending;   /* moment of the law */
    Lane damping;   /* W, power of the damping (BA4) */
    Lane c;         /* d x force */
} PlanarJoint;

/* Geometry and motion (PL4), (PL5). */
LANE_INLINE PlanarJoint joint_motion(const PlanarChain *chain, const PlanarKinematics *kin, int jj)
{
    PlanarJoint j;
    const int a = jj - 1, b = jj;
    const Lane2 ha = l2_load(kin->h, a), hb = l2_load(kin->h, b), axis_a = l2_load(kin->a, a);
    const Lane2 axis_b = l2_load(kin->a, b);
    const int symmetric = chain->share < 1;
    j.share = lane_set(chain->share);
    j.frame = symmetric ? (Lane2){ha.x * hb.x - ha.z * hb.z, ha.z * hb.x + ha.x * hb.z} : axis_b;
    j.ra = l2_scale(lane_load(chain->half + a), axis_a);
    j.rb = l2_scale(lane_load(chain->half + b), axis_b);
    j.wa = lane_load(kin->w + a);
    j.wb = lane_load(kin->w + b);
    j.w = j.wa + j.share * (j.wb - j.wa);
    const Lane2 apart = l2_sub(l2_load(kin->p, b), l2_load(kin->p, a));
    const Lane2 drift = l2_sub(l2_load(kin->v, b), l2_load(kin->v, a));
    const Lane2 ends = l2_axpy(l2_scale(j.wa, j.ra), j.wb, j.rb); /* J times this is the contribution of the rotation of
                                                                   * the ends */
    j.d = l2_sub(apart, l2_add(j.ra, j.rb));
    j.e = l2_sub(drift, l2_turn(l2_axpy(ends, j.w, j.d)));
    return j;
}

/* Adds the law and the forces (PL6), (PL7). */
LANE_INLINE PlanarJoint joint_at(const PlanarChain *chain, const PlanarKinematics *kin, int jj)
{
    PlanarJoint j = joint_motion(chain, kin, jj);
    const Lane2 d = l2_in(j.frame, j.d), e = l2_in(j.frame, j.e);
    const Lane2 kd = {lane_load(chain->stiffness[0] + jj) * d.x, lane_load(chain->stiffness[1] + jj) * d.z};
    const Lane2 ce = {lane_load(chain->damping[0] + jj) * e.x, lane_load(chain->damping[1] + jj) * e.z};
    j.law = l2_add(l2_add(kd, ce), l2_load(chain->preload, jj));
    j.force = l2_out(j.frame, j.law);
    const Lane theta = lane_load(kin->angle + jj) - lane_load(kin->angle + jj - 1);
    j.bending = lane_load(chain->stiffness[2] + jj) * theta + lane_load(chain->damping[2] + jj) * (j.wb - j.wa) +
                lane_load(chain->preload[2] + jj);
    /* squares first: a product shared with the law would no longer be fused with its sum, and round differently */
    j.damping = l2_dot((Lane2){e.x * e.x, e.z * e.z}, l2_load(chain->damping, jj)) +
                (j.wb - j.wa) * (j.wb - j.wa) * lane_load(chain->damping[2] + jj);
    j.c = l2_cross(j.d, j.force);
    return j;
}

static double kernel_joint_loads(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                                 PlanarJointLoads *loads)
{
    Lane damping = lane_set(0);
    for (int jj = from; jj < to; jj += LANES) {
        const PlanarJoint j = joint_at(chain, kin, jj);
        const Lane c_b = j.share * j.c;
        l2_store(loads->force, jj, j.force);
        lane_store(loads->torque_a + jj, l2_cross(j.ra, j.force) + (j.c - c_b) + j.bending);
        lane_store(loads->torque_b + jj, l2_cross(j.rb, j.force) + c_b - j.bending);
        damping += lane_select(lane_index() < lane_set(to - jj), j.damping, lane_set(0));
    }
    return lane_sum(damping);
}

static void kernel_tension(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to, double *tension)
{
    for (int jj = from; jj < to; jj += LANES) lane_store(tension + jj, joint_at(chain, kin, jj).law.x);
}

static int kernel_rates(const PlanarChain *chain, const PlanarKinematics *kin, const PlanarJointLoads *joints,
                        const PlanarLoads loads[2], int from, int to, double *ydot)
{
    const int stride = chain->stride;
    Lane sum = lane_set(0); /* x 0 is 0, or NaN where x is not finite */
    for (int i = from; i < to; i += LANES) {
        const Lane2 force = l2_add(l2_sub(l2_load(joints->force, i + 1), l2_load(joints->force, i)),
                                   l2_add(l2_load(loads[0].f, i), l2_load(loads[1].f, i)));
        const Lane moment = (lane_load(joints->torque_a + i + 1) + lane_load(joints->torque_b + i)) +
                            (lane_load(loads[0].m + i) + lane_load(loads[1].m + i));
        const Lane inverse_mass = lane_load(chain->inverse_mass + i);
        /* the padding of the state does not move: there is nothing behind the chain, whatever the ghost in that place
         * does */
        const LaneMask inside = inverse_mass > lane_set(0);
        const Lane zero = lane_set(0);
        const Lane rate[PLANAR_SIZE] = {lane_select(inside, lane_load(kin->v[0] + i), zero),
                                        lane_select(inside, lane_load(kin->v[1] + i), zero),
                                        lane_select(inside, lane_load(kin->w + i), zero),
                                        inverse_mass * force.x,
                                        inverse_mass * force.z,
                                        lane_load(chain->inverse_inertia + i) * moment};
        for (int c = 0; c < PLANAR_SIZE; ++c) {
            lane_store(ydot + c * stride + i, rate[c]);
            sum += rate[c] * zero;
        }
    }
    double total = 0;
    for (int k = 0; k < LANES; ++k) total += sum[k];
    return total == 0;
}

/* ---------------------------------------------------------------------------------------------- derivatives */

/* The variation of a joint's force and moments. */
typedef struct PlanarVariation {
    Lane2 force;
    Lane torque_a, torque_b;
} PlanarVariation;

/* R diag(k) R^T v: a diagonal law in F, along the plane's axes. */
LANE_INLINE Lane2 law_times(Lane2 frame, Lane2 k, Lane2 v)
{
    const Lane2 in = l2_in(frame, v);
    return l2_out(frame, (Lane2){k.x * in.x, k.z * in.z});
}

/* Variation that follows from those of force, gap and bending moment, with fixed lever arms (PL9). */
LANE_INLINE PlanarVariation vary_wrench(const PlanarJoint *j, Lane2 force, Lane2 gap, Lane bending)
{
    const Lane c = l2_cross(gap, j->force) + l2_cross(j->d, force), c_b = j->share * c;
    return (PlanarVariation){force, l2_cross(j->ra, force) + (c - c_b) + bending,
                             l2_cross(j->rb, force) + c_b - bending};
}

/* Coefficients of the law. */
typedef struct PlanarLaw {
    Lane2 k, c;
    Lane k_bend, c_bend;
} PlanarLaw;

/* A displacement of B against A (PL8). */
LANE_INLINE PlanarVariation vary_shift(const PlanarJoint *j, const PlanarLaw *law, Lane2 shift)
{
    const Lane2 rate = l2_scale(-j->w, l2_turn(shift));
    const Lane2 force = l2_add(law_times(j->frame, law->k, shift), law_times(j->frame, law->c, rate));
    return vary_wrench(j, force, shift, lane_set(0));
}

/* A rotation of A alone (after = 0) or of B alone (after = 1) by a unit angle (PL9). */
LANE_INLINE PlanarVariation vary_turn(const PlanarJoint *j, const PlanarLaw *law, int after)
{
    const Lane turn = after ? j->share : 1 - j->share; /* of F */
    const Lane2 arm = after ? j->rb : j->ra;
    const Lane spin = after ? j->wb : j->wa;
    const Lane2 gap = l2_neg(l2_turn(arm));
    /* relative to F, which rotates too */
    const Lane2 shift = l2_axpy(gap, -turn, l2_turn(j->d));
    const Lane2 rate = l2_axpy(l2_axpy(l2_scale(spin, arm), -j->w, l2_turn(gap)), -turn, l2_turn(j->e));
    Lane2 force = l2_add(law_times(j->frame, law->k, shift), law_times(j->frame, law->c, rate));
    force = l2_axpy(force, turn, l2_turn(j->force));
    PlanarVariation v = vary_wrench(j, force, gap, after ? law->k_bend : -law->k_bend);
    /* the lever arm rotates with its segment */
    const Lane moved = -l2_dot(arm, j->force);
    if (after) {
        v.torque_b += moved;
    } else {
        v.torque_a += moved;
    }
    return v;
}

/* A change of the relative velocity (PL10). */
LANE_INLINE PlanarVariation vary_speed(const PlanarJoint *j, const PlanarLaw *law, Lane2 speed)
{
    const Lane2 none = {lane_set(0), lane_set(0)};
    return vary_wrench(j, law_times(j->frame, law->c, speed), none, lane_set(0));
}

/* A change of the angular velocity of A or of B by one (PL10). */
LANE_INLINE PlanarVariation vary_spin(const PlanarJoint *j, const PlanarLaw *law, int after)
{
    const Lane turn = after ? j->share : 1 - j->share;
    const Lane2 none = {lane_set(0), lane_set(0)};
    const Lane2 rate = l2_neg(l2_turn(l2_axpy(after ? j->rb : j->ra, turn, j->d)));
    return vary_wrench(j, law_times(j->frame, law->c, rate), none, after ? law->c_bend : -law->c_bend);
}

/* A column of LANES 3x3 blocks from row i on: force on top, moment below. */
LANE_INLINE void column_store(double *const block[9], int column, int i, Lane2 force, Lane moment)
{
    lane_store(block[3 * column] + i, force.x);
    lane_store(block[3 * column + 1] + i, force.z);
    lane_store(block[3 * column + 2] + i, moment);
}

/* A moves by -shift, B by +shift; B gets minus the force. */
LANE_INLINE void shift_store(PlanarBlocks *out, int jj, int column, PlanarVariation v)
{
    const Lane2 back = l2_neg(v.force);
    column_store(out->front, column, jj, back, -v.torque_a);
    column_store(out->upper, column, jj - 1, v.force, v.torque_a);
    column_store(out->lower, column, jj, v.force, -v.torque_b);
    column_store(out->diag, column, jj, back, v.torque_b);
}

LANE_INLINE void turn_store(PlanarBlocks *out, int jj, PlanarVariation of_a, PlanarVariation of_b)
{
    column_store(out->front, 2, jj, of_a.force, of_a.torque_a);
    column_store(out->upper, 2, jj - 1, of_b.force, of_b.torque_a);
    column_store(out->lower, 2, jj, l2_neg(of_a.force), of_a.torque_b);
    column_store(out->diag, 2, jj, l2_neg(of_b.force), of_b.torque_b);
}

/* Separate from the joints' loop, where the sums would have to wait for what was just stored. */
static void kernel_blocks_join(PlanarBlocks *blocks, int from, int to)
{
    for (int i = from; i < to; i += LANES) {
        for (int e = 0; e < 9; ++e) {
            double *const diag = blocks->diag[e] + i;
            lane_store(diag, lane_load(diag) + lane_load(blocks->front[e] + i + 1));
        }
    }
}

static void kernel_joint_blocks(const PlanarChain *chain, const PlanarKinematics *kin, int from, int to,
                                PlanarBlocks *k, PlanarBlocks *d)
{
    const Lane2 unit[2] = {{lane_set(1), lane_set(0)}, {lane_set(0), lane_set(1)}};
    for (int jj = from; jj < to; jj += LANES) {
        const PlanarJoint j = joint_at(chain, kin, jj);
        const PlanarLaw law = {l2_load(chain->stiffness, jj), l2_load(chain->damping, jj),
                               lane_load(chain->stiffness[2] + jj), lane_load(chain->damping[2] + jj)};
        for (int c = 0; c < 2; ++c) {
            shift_store(k, jj, c, vary_shift(&j, &law, unit[c]));
            shift_store(d, jj, c, vary_speed(&j, &law, unit[c]));
        }
        turn_store(k, jj, vary_turn(&j, &law, 0), vary_turn(&j, &law, 1));
        turn_store(d, jj, vary_spin(&j, &law, 0), vary_spin(&j, &law, 1));
    }
}

const PlanarKernels ISA_NAME(planar_kernels) = {kernel_kinematics, kernel_joint_loads,  kernel_tension,
                                                kernel_rates,      kernel_joint_blocks, kernel_blocks_join};
