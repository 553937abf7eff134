/* Derivatives of a patch's wrenches, the coordinates of one segment in lanes: from the coordinate to the ends of the
 * piece, from there to the forces, and on to the segments. docs/theory.md, "Cable on cable", (CC13)-(CC17). */
#include "contact/self.h"
#include "core/lanes.h"
#include "core/machine.h"

/* Lanes 0..2 are displacements or velocities along the world's axes, 3..5 rotations or angular velocities about them;
 * the others stay zero. */
#define MOVES                                                                                                          \
    (Lane) { 1, 1, 1, 0, 0, 0, 0, 0 }
#define AXES                                                                                                           \
    (Lane3)                                                                                                            \
    {                                                                                                                  \
        {1, 0, 0, 1, 0, 0, 0, 0}, {0, 1, 0, 0, 1, 0, 0, 0}, { 0, 0, 1, 0, 0, 1, 0, 0 }                                 \
    }

/* a scaled by a number, and a + s b. */
LANE_INLINE Lane3 scaled(double s, Lane3 a) { return l3_scale(lane_set(s), a); }
LANE_INLINE Lane3 plus(Lane3 a, double s, Lane3 b) { return l3_axpy(a, lane_set(s), b); }
LANE_INLINE Lane3 rejected(Lane3 a, Lane3 unit) { return l3_axpy(a, -l3_dot(unit, a), unit); }

/* Change of the piece's two ends and of the radius. */
typedef struct Ends {
    Lane v[2];            /* the feet's parameters */
    Lane3 w[2], speed[2]; /* separations, m; m/s */
    Lane3 omega[2];       /* of the feet's side, rad/s; the piece's own does not change */
    Lane radius;          /* m */
} Ends;

/* Forces on the two ends and couples on one side, which all slots of that side share by their weights. */
typedef struct Shares {
    Lane3 end[2], couple[2]; /* changes, N and N m */
    Lane3 on[2], turn[2];    /* the present ones times the feet's changes; 0 where feet do not move */
} Shares;

/* A shift of a slot or a turn of its arm, m: the feet follow (CC13), (CC14). */
LANE_INLINE Ends ends_vary(const Patch *p, const PatchSlot *slot, Lane3 shift, Lane3 turned)
{
    const double sign = slot->side ? -1 : 1;
    Ends by = {.radius = lane_set(0)};
    for (int a = 0; a < 2; ++a) {
        by.w[a] = scaled(sign, plus(scaled(slot->alpha[a], shift), slot->beta[a], turned));
        by.speed[a] = scaled(sign * slot->beta[a], l3_cross(l3_spread(slot->w), turned));
        by.v[a] = lane_set(0);
        by.omega[a] = l3_zero();
        if (!(p->curvature[a] > 0)) continue;
        const Lane3 along = plus(scaled(slot->alpha1[a], shift), slot->beta1[a], turned);
        const Lane3 foot1 = l3_spread(p->foot1[a]);
        by.v[a] = (l3_dot(by.w[a], foot1) + l3_dot(l3_spread(p->w[a]), along)) / p->curvature[a];
        by.w[a] = l3_axpy(by.w[a], -by.v[a], foot1);
        by.speed[a] = l3_axpy(by.speed[a], by.v[a], l3_spread(p->speed1[a]));
        by.omega[a] = l3_scale(by.v[a], l3_spread(p->omega1[a]));
        by.radius += p->radius1[a] / 2 * by.v[a];
    }
    return by;
}

/* The limits of the pressed part move too, but q is zero there, or they are the piece's own ends: they contribute
 * nothing. */
LANE_INLINE void bed_vary(const Patch *p, const Ends *by, Lane3 g_by[2], Lane *m0_by, Lane *m1_by)
{
    const Lane stretch = -1.5 / p->radius * by->radius; /* of the modulus */
    *m0_by = *m1_by = lane_set(0);
    for (int a = 0; a < 2; ++a) g_by[a] = l3_scale(stretch, l3_spread(p->g[a]));
    for (int k = 0; k < BED_POINTS; ++k) {
        const double xi = p->from + (p->to - p->from) * BED_AT[k], weight = BED_WEIGHT[k] * (p->to - p->from);
        const Vec3 at = v3_axpy(v3_scale(1 - xi, p->w[0]), xi, p->w[1]);
        const double ww = v3_dot(at, at), q = (p->radius * p->radius - ww) / (2 * p->radius);
        const Lane3 w = l3_spread(at), dw = plus(scaled(1 - xi, by->w[0]), xi, by->w[1]);
        const Lane dq = by->radius * (0.5 + ww / (2 * p->radius * p->radius)) - l3_dot(w, dw) / p->radius;
        *m0_by += weight * dq;
        *m1_by += weight * xi * dq;
        const Lane3 change = scaled(p->modulus * weight, plus(l3_scale(dq, w), q, dw));
        g_by[0] = plus(g_by[0], 1 - xi, change);
        g_by[1] = plus(g_by[1], xi, change);
    }
}

/* value_0 (1 - xi) + value_1 xi, varied with xi. */
LANE_INLINE Lane3 between(const Patch *p, const Vec3 value[2], const Lane3 by[2], Lane centre_by)
{
    const Lane3 mixed = plus(scaled(1 - p->centre, by[0]), p->centre, by[1]);
    return l3_axpy(mixed, centre_by, l3_spread(v3_sub(value[1], value[0])));
}

/* Change of the friction with the normal force and the sliding velocity. */
LANE_INLINE Lane3 friction_vary(const Patch *p, Lane force_by, Lane3 slide_by)
{
    const Lane3 slide = l3_spread(p->slide);
    const Lane phi_by = p->phi_over * l3_dot(slide, slide_by);
    return plus(l3_scale(-(force_by * p->phi + p->force * phi_by), slide), -p->force * p->phi, slide_by);
}

/* Change of the sum of rho omega; the feet's side carries the change of the radius. */
LANE_INLINE Lane3 spin_vary(const Patch *p, const Ends *by, Lane centre_by, Lane share_by)
{
    Lane3 sum = l3_zero();
    const Lane3 none[2] = {l3_zero(), l3_zero()};
    for (int side = 0; side < 2; ++side) {
        const Vec3 *const omega = p->omega[side];
        const Vec3 here = v3_axpy(v3_scale(1 - p->centre, omega[0]), p->centre, omega[1]);
        sum = plus(sum, p->share[side], between(p, omega, side ? by->omega : none, centre_by));
        sum = l3_axpy(sum, side ? share_by : -share_by, l3_spread(here));
    }
    return sum;
}

/* (CC16): from the ends to the forces. */
LANE_INLINE void forces_vary(const Patch *p, const PatchLaw *law, const Ends *by, Shares out[2])
{
    Lane3 g_by[2];
    Lane m0_by, m1_by;
    bed_vary(p, by, g_by, &m0_by, &m1_by);
    const Lane centre_by = (m1_by - p->centre * m0_by) / p->m0;
    const Lane share_by = p->share[0] / p->radius * by->radius; /* of the feet's side; that of the piece is opposite */
    const Lane3 normal = l3_spread(p->normal), arm = l3_spread(p->arm), friction = l3_spread(p->friction);

    /* normal direction, gap rate */
    const Lane3 arm_by = between(p, p->w, by->w, centre_by);
    const Lane3 normal_by = scaled(1 / p->distance, rejected(arm_by, normal));
    const Lane3 drift_by = between(p, p->speed, by->speed, centre_by);
    const Lane damped_by = -law->dissipation * (l3_dot(normal_by, l3_spread(p->drift)) + l3_dot(normal, drift_by));
    const Lane force_by = damped_by * p->elastic + p->damped * l3_dot(normal, l3_add(g_by[0], g_by[1]));

    /* slip of the surfaces, and friction */
    Lane3 slip_by = l3_sub(drift_by, l3_cross(spin_vary(p, by, centre_by, share_by), arm));
    slip_by = l3_sub(slip_by, l3_cross(l3_spread(p->spin), arm_by));
    const Lane along_by = l3_dot(normal_by, l3_spread(p->slip)) + l3_dot(normal, slip_by);
    const Lane3 slide_by = plus(l3_axpy(slip_by, -along_by, normal), -v3_dot(p->normal, p->slip), normal_by);
    const Lane3 friction_by = friction_vary(p, force_by, slide_by);
    const Lane3 couple_by = l3_add(l3_cross(friction_by, arm), l3_cross(friction, arm_by));

    /* their shares at the two ends */
    for (int a = 0; a < 2; ++a) {
        const double part = a ? p->centre : 1 - p->centre;
        const Lane part_by = a ? centre_by : -centre_by;
        const Lane3 end = plus(l3_scale(damped_by, l3_spread(p->g[a])), p->damped, g_by[a]);
        for (int side = 0; side < 2; ++side) {
            const Lane more = part_by * p->share[side] + (side ? part : -part) * share_by;
            out[side].end[a] = l3_axpy(plus(end, part, friction_by), part_by, friction);
            out[side].couple[a] = l3_axpy(scaled(part * p->share[side], couple_by), more, l3_spread(p->couple));
        }
        out[1].on[a] = l3_scale(by->v[a], l3_spread(p->on[a]));
        out[1].turn[a] = l3_scale(part * p->share[1] * by->v[a], l3_spread(p->couple));
    }
}

/* (CC17): the changed forces by the weights of `slot`, and the forces by the change of its weights; arm_by: the change
 * of its own arm, m; NULL: none. */
LANE_INLINE void wrench_vary(const Patch *p, const PatchSlot *slot, const Shares *by, const Lane3 *arm_by,
                             double row[6][LANES])
{
    Lane3 push = plus(scaled(slot->alpha[0], by->end[0]), slot->alpha[1], by->end[1]);
    Lane3 lever = plus(scaled(slot->beta[0], by->end[0]), slot->beta[1], by->end[1]);
    Lane3 moment = plus(scaled(slot->alpha[0], by->couple[0]), slot->alpha[1], by->couple[1]);
    if (slot->side) {
        push = l3_neg(plus(plus(push, slot->alpha1[0], by->on[0]), slot->alpha1[1], by->on[1]));
        lever = l3_neg(plus(plus(lever, slot->beta1[0], by->on[0]), slot->beta1[1], by->on[1]));
        moment = plus(plus(moment, slot->alpha1[0], by->turn[0]), slot->alpha1[1], by->turn[1]);
    }
    moment = l3_add(moment, l3_cross(l3_spread(slot->r), lever));
    if (arm_by) {
        const Vec3 held = v3_axpy(v3_scale(slot->beta[0], p->on[0]), slot->beta[1], p->on[1]);
        moment = l3_add(moment, l3_cross(*arm_by, l3_spread(slot->side ? v3_scale(-1, held) : held)));
    }
    const Lane value[6] = {push.x, push.y, push.z, moment.x, moment.y, moment.z};
    for (int r = 0; r < 6; ++r) lane_store(row[r], value[r]);
}

/* A velocity of a slot, or an angular velocity, which moves its arm's end: places stay, the bed's pressure is
 * unchanged, and of (CC16) and (CC17) only damping and friction are left. */
LANE_INLINE void motion_vary(const Patch *p, const PatchLaw *law, const PatchSlot *slot, Lane3 shift, Lane3 turned,
                             Shares out[2])
{
    const double sign = slot->side ? -1 : 1, part[2] = {1 - p->centre, p->centre};
    const Lane3 normal = l3_spread(p->normal), arm = l3_spread(p->arm), turn = l3_scale(1 - MOVES, AXES);
    Lane3 drift_by = l3_zero(), spin_by = l3_zero();
    for (int a = 0; a < 2; ++a) {
        drift_by = plus(plus(drift_by, sign * part[a] * slot->alpha[a], shift), sign * part[a] * slot->beta[a], turned);
        spin_by = plus(spin_by, p->share[slot->side] * part[a] * slot->alpha[a], turn);
    }
    const Lane damped_by = -law->dissipation * l3_dot(normal, drift_by);
    const Lane3 slide_by = rejected(l3_sub(drift_by, l3_cross(spin_by, arm)), normal);
    const Lane3 friction_by = friction_vary(p, damped_by * p->elastic, slide_by), couple = l3_cross(friction_by, arm);
    for (int a = 0; a < 2; ++a) {
        for (int side = 0; side < 2; ++side) {
            out[side].end[a] = plus(l3_scale(damped_by, l3_spread(p->g[a])), part[a], friction_by);
            out[side].couple[a] = scaled(part[a] * p->share[side], couple);
            out[side].on[a] = out[side].turn[a] = l3_zero();
        }
    }
}

static void kernel_columns(const Patch *p, const PatchLaw *law, int s, PatchColumns *by_place, PatchColumns *by_motion)
{
    const PatchSlot *const slot = &p->slot[s];
    const Lane3 shift = l3_scale(MOVES, AXES), turned = l3_cross(l3_scale(1 - MOVES, AXES), l3_spread(slot->r));
    const Ends by = ends_vary(p, slot, shift, turned);
    Shares place[2], motion[2];
    forces_vary(p, law, &by, place);
    motion_vary(p, law, slot, shift, turned, motion);
    for (int t = 0; t < p->slots; ++t) {
        const PatchSlot *const on = &p->slot[t];
        wrench_vary(p, on, &place[on->side], t == s ? &turned : NULL, by_place->row[t]);
        wrench_vary(p, on, &motion[on->side], NULL, by_motion->row[t]);
    }
}

const SelfKernels ISA_NAME(self_kernels) = {kernel_columns};
