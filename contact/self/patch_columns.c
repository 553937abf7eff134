/* Derivatives of a patch's wrenches, one coordinate of one segment at a time: what the coordinate does to the ends of
 * the piece, from there to the forces, and on to the segments. docs/model.md, "Cable on cable", (CC13)-(CC17). */
#include "contact/self/patch.h"

/* What a coordinate changes at the piece's two ends, and of the radius. */
typedef struct Ends {
    double v[2];      /* the feet's parameters */
    Vec3 w[2];        /* separations, m */
    Vec3 speed[2];    /* m/s */
    Vec3 omega[2][2]; /* [side][a], rad/s */
    double radius;    /* m */
} Ends;

/* What that does to the forces. */
typedef struct Forces {
    Vec3 end[2];       /* f_a, N */
    Vec3 couple[2][2]; /* [side][a], N m */
} Forces;

/* A shift or a turn of slot s: the feet follow (CC13), (CC14). turned: the change of the segment's arm, m. */
static Ends ends_of_place(const Patch *p, const PatchSlot *slot, int c, Vec3 *turned)
{
    const double sign = slot->side ? -1 : 1;
    const Vec3 axis = v3_axis(c % 3);
    Ends by = {.radius = 0};
    *turned = c < 3 ? v3(0, 0, 0) : v3_cross(axis, slot->r);
    for (int a = 0; a < 2; ++a) {
        const Vec3 moved = c < 3 ? v3_scale(slot->alpha[a], axis) : v3_scale(slot->beta[a], *turned);
        const Vec3 along = c < 3 ? v3_scale(slot->alpha1[a], axis) : v3_scale(slot->beta1[a], *turned);
        by.w[a] = v3_scale(sign, moved);
        if (c >= 3) by.speed[a] = v3_scale(sign * slot->beta[a], v3_cross(slot->w, *turned));
        if (!(p->curvature[a] > 0)) continue;
        by.v[a] = (v3_dot(by.w[a], p->foot1[a]) + v3_dot(p->w[a], along)) / p->curvature[a];
        by.w[a] = v3_axpy(by.w[a], -by.v[a], p->foot1[a]);
        by.speed[a] = v3_axpy(by.speed[a], by.v[a], p->speed1[a]);
        by.omega[1][a] = v3_scale(by.v[a], p->omega1[a]);
        by.radius += p->radius1[a] * by.v[a] / 2;
    }
    return by;
}

/* value_0 (1 - xi) + value_1 xi, varied with xi. */
static Vec3 between(const Patch *p, const Vec3 value[2], const Vec3 by[2], double centre_by)
{
    const Vec3 mixed = v3_axpy(v3_scale(1 - p->centre, by[0]), p->centre, by[1]);
    return v3_axpy(mixed, centre_by, v3_sub(value[1], value[0]));
}

/* The change of the sum of rho omega; the feet's side carries the change of the radius. */
static Vec3 spin_vary(const Patch *p, const Ends *by, double centre_by, const double share_by[2])
{
    Vec3 sum = v3(0, 0, 0);
    for (int side = 0; side < 2; ++side) {
        const Vec3 *const omega = p->omega[side];
        sum = v3_axpy(sum, p->share[side], between(p, omega, by->omega[side], centre_by));
        sum = v3_axpy(sum, share_by[side], v3_axpy(v3_scale(1 - p->centre, omega[0]), p->centre, omega[1]));
    }
    return sum;
}

/* The change of the friction with the normal force and the sliding velocity. */
static Vec3 friction_vary(const Patch *p, double force_by, Vec3 slide_by)
{
    const double phi_by = p->phi_over * v3_dot(p->slide, slide_by);
    return v3_axpy(v3_scale(-(force_by * p->phi + p->force * phi_by), p->slide), -p->force * p->phi, slide_by);
}

/* (CC16): from the ends to the forces. */
static Forces forces_vary(const Patch *p, const PatchLaw *law, const Ends *by)
{
    Vec3 g_by[2];
    double m0_by, m1_by;
    bed_vary(p, by->w, by->radius, g_by, &m0_by, &m1_by);
    const double centre_by = (m1_by - p->centre * m0_by) / p->m0;
    const double share_by[2] = {-p->share[0] * by->radius / p->radius, p->share[0] * by->radius / p->radius};

    /* normal direction, gap rate */
    const Vec3 arm_by = between(p, p->w, by->w, centre_by);
    const Vec3 normal_by = v3_scale(1 / p->distance, v3_reject(arm_by, p->normal));
    const Vec3 drift_by = between(p, p->speed, by->speed, centre_by);
    const double damped_by = -law->dissipation * (v3_dot(normal_by, p->drift) + v3_dot(p->normal, drift_by));
    const double force_by = damped_by * p->elastic + p->damped * v3_dot(p->normal, v3_add(g_by[0], g_by[1]));

    /* slip of the surfaces, and friction */
    Vec3 slip_by = v3_sub(drift_by, v3_cross(spin_vary(p, by, centre_by, share_by), p->arm));
    slip_by = v3_sub(slip_by, v3_cross(p->spin, arm_by));
    const double along_by = v3_dot(normal_by, p->slip) + v3_dot(p->normal, slip_by);
    const Vec3 slide_by = v3_axpy(v3_axpy(slip_by, -along_by, p->normal), -v3_dot(p->normal, p->slip), normal_by);
    const Vec3 friction_by = friction_vary(p, force_by, slide_by);
    const Vec3 couple_by = v3_add(v3_cross(friction_by, p->arm), v3_cross(p->friction, arm_by));

    /* their shares at the two ends */
    Forces out;
    for (int a = 0; a < 2; ++a) {
        const double part = a ? p->centre : 1 - p->centre, part_by = a ? centre_by : -centre_by;
        out.end[a] = v3_axpy(v3_scale(damped_by, p->g[a]), p->damped, g_by[a]);
        out.end[a] = v3_axpy(v3_axpy(out.end[a], part, friction_by), part_by, p->friction);
        for (int side = 0; side < 2; ++side) {
            out.couple[side][a] = v3_scale(part * p->share[side], couple_by);
            out.couple[side][a] =
                v3_axpy(out.couple[side][a], part_by * p->share[side] + part * share_by[side], p->couple);
        }
    }
    return out;
}

/* (CC17): one slot's wrench, with what the moving feet do to its weights; arm_by: the change of its own arm, m; moves:
 * 0: neither its weights nor its arm change. */
static PatchWrench wrench_vary(const Patch *p, const PatchSlot *slot, const Ends *by, const Forces *force, Vec3 arm_by,
                               int moves)
{
    const double sign = slot->side ? -1 : 1;
    PatchWrench out = {{0, 0, 0}, {0, 0, 0}};
    for (int a = 0; a < 2; ++a) {
        const double part = a ? p->centre : 1 - p->centre, v_by = by->v[a];
        const double alpha_by = slot->alpha1[a] * v_by, beta_by = slot->beta1[a] * v_by;
        out.force = v3_axpy(out.force, sign * slot->alpha[a], force->end[a]);
        if (moves) {
            const Vec3 lever_by = v3_axpy(v3_scale(slot->beta[a], arm_by), beta_by, slot->r);
            out.force = v3_axpy(out.force, sign * alpha_by, p->on[a]);
            out.moment = v3_axpy(out.moment, sign, v3_cross(lever_by, p->on[a]));
        }
        out.moment = v3_axpy(out.moment, sign * slot->beta[a], v3_cross(slot->r, force->end[a]));
        out.moment = v3_axpy(out.moment, slot->alpha[a], force->couple[slot->side][a]);
        if (moves) out.moment = v3_axpy(out.moment, alpha_by * part * p->share[slot->side], p->couple);
    }
    return out;
}

/* A velocity or an angular velocity of slot s: nothing moves, the bed stays as it is pressed, and of (CC16) and (CC17)
 * only damping and friction are left. */
static void column_of_motion(const Patch *p, const PatchLaw *law, const PatchSlot *slot, int c,
                             PatchWrench out[PATCH_SLOTS])
{
    const double sign = slot->side ? -1 : 1, part[2] = {1 - p->centre, p->centre};
    const Vec3 axis = v3_axis(c % 3), turned = v3_cross(axis, slot->r);
    Vec3 drift_by = V3_ZERO, spin_by = V3_ZERO;
    for (int a = 0; a < 2; ++a) {
        const Vec3 speed = c < 9 ? v3_scale(sign * slot->alpha[a], axis) : v3_scale(sign * slot->beta[a], turned);
        drift_by = v3_axpy(drift_by, part[a], speed);
        if (c >= 9) spin_by = v3_axpy(spin_by, part[a], v3_scale(slot->alpha[a], axis));
    }
    spin_by = v3_scale(p->share[slot->side], spin_by);
    const double damped_by = -law->dissipation * v3_dot(p->normal, drift_by);
    const Vec3 slip_by = v3_sub(drift_by, v3_cross(spin_by, p->arm));
    const Vec3 slide_by = v3_axpy(slip_by, -v3_dot(p->normal, slip_by), p->normal);
    const Vec3 friction_by = friction_vary(p, damped_by * p->elastic, slide_by), couple = v3_cross(friction_by, p->arm);
    Vec3 end[2];
    for (int a = 0; a < 2; ++a) end[a] = v3_axpy(v3_scale(damped_by, p->g[a]), part[a], friction_by);
    for (int t = 0; t < p->slots; ++t) {
        const PatchSlot *const on = &p->slot[t];
        const double way = on->side ? -1 : 1;
        out[t] = (PatchWrench){V3_ZERO, V3_ZERO};
        for (int a = 0; a < 2; ++a) {
            out[t].force = v3_axpy(out[t].force, way * on->alpha[a], end[a]);
            out[t].moment = v3_axpy(out[t].moment, way * on->beta[a], v3_cross(on->r, end[a]));
            out[t].moment = v3_axpy(out[t].moment, on->alpha[a], v3_scale(part[a] * p->share[on->side], couple));
        }
    }
}

void patch_column(const Patch *p, const PatchLaw *law, int s, int c, PatchWrench out[PATCH_SLOTS])
{
    if (c >= 6) {
        column_of_motion(p, law, &p->slot[s], c, out);
        return;
    }
    Vec3 turned;
    const Ends by = ends_of_place(p, &p->slot[s], c, &turned);
    const Forces force = forces_vary(p, law, &by);
    for (int t = 0; t < p->slots; ++t) {
        const int moves = t == s || p->slot[t].side == 1;
        out[t] = wrench_vary(p, &p->slot[t], &by, &force, t == s ? turned : V3_ZERO, moves);
    }
}
