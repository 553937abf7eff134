/* The kernels of contact/roller.h for one instruction set: forces. */
#include "contact/roller_lanes.h"

/* The same as below for shapes other than cylinders: slopes, or distances. */
static void nodes_by_kind(const Shape *shape, int face, const Kinematics *kin, int from, int to, int slopes,
                          double *node)
{
    const LaneShape s = shape_spread(shape);
    const LaneForm form = form_spread(shape, face);
    for (int i = from; i < to; i += LANES) {
        const Lane3 p = l3_load(kin->p, i);
        LaneProbe probe;
        shape_by_kind(shape->kind, &s, &form, &p, &probe);
        lane_store(node + i,
                   slopes ? shape_slope(shape->kind, &s, &form, p, &probe, l3_load(kin->a, i)) : probe.distance);
    }
}

/* One shape against many nodes: unit stride, no branches. */
static void kernel_slopes(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node)
{
    if (shape->kind != SHAPE_CYLINDER) {
        nodes_by_kind(shape, face, kin, from, to, 1, node);
        return;
    }
    const LaneShape s = shape_spread(shape);
    for (int i = from; i < to; i += LANES) {
        lane_store(node + i, shape_cylinder_slope(&s, l3_load(kin->p, i), l3_load(kin->a, i)));
    }
}

static void kernel_distances(const Shape *shape, int face, const Kinematics *kin, int from, int to, double *node)
{
    if (shape->kind != SHAPE_CYLINDER) {
        nodes_by_kind(shape, face, kin, from, to, 0, node);
        return;
    }
    const LaneShape s = shape_spread(shape);
    for (int i = from; i < to; i += LANES) {
        lane_store(node + i, shape_cylinder(&s, l3_load(kin->p, i)).distance);
    }
}

/* Generalized forces by virtual work (C15). */
LANE_INLINE void push_of(const ContactBatch *batch, ContactPush *out, Variant is)
{
    const Line line = line_load(batch, is.grooved);
    const Contact c = contact_at(batch, &line, is);
    for (int b = 0; b < 2; ++b) {
        batch_vector_store(out->force[b], l3_scale(c.at.weight.alpha[b], c.force));
        batch_vector_store(out->moment[b], l3_cross(c.arm[b], c.force));
    }
    batch_vector_store(out->total, c.force);
    batch_vector_store(out->point, c.at.p);
    lane_store(out->normal, c.push.force);
    lane_store(out->friction, is.rubs == FRICTION_NONE ? lane_set(0) : c.push.force * rub_loss(&c.rub, c.slide));
    lane_store(out->damping, c.push.loss);
    lane_store(out->energy, c.push.energy);
    lane_store(out->u, c.u);
    lane_store(out->gap, c.gap);
    if (is.rubs == FRICTION_STICK) {
        const LaneFriction law = friction_gather(batch->friction);
        batch_vector_store(out->kept, rub_keep(&c.rub, &law, c.at.probe.normal, c.slide));
    }
    if (is.moving) batch_vector_store(out->roller_moment, l3_cross(c.force, contact_roller_arm(&c)));
}

#define PUSH(name, which)                                                                                              \
    static void name(const ContactBatch *batch, ContactPush *out) { push_of(batch, out, variant_of(which)); }

PUSH(push_plain, VARIANT_PLAIN)
PUSH(push_smooth, VARIANT_SMOOTH)
PUSH(push_general, VARIANT_GENERAL)
PUSH(push_stick, VARIANT_STICK)
PUSH(push_moving, VARIANT_MOVING)
PUSH(push_moving_stick, VARIANT_MOVING_STICK)

const ContactKernels ISA_NAME(contact_kernels) = {
    .slopes = kernel_slopes,
    .distances = kernel_distances,
    .push = {push_plain, push_smooth, push_general, push_stick, push_moving, push_moving_stick},
    .columns = {ISA_NAME(contact_columns_plain), ISA_NAME(contact_columns_smooth), ISA_NAME(contact_columns_general),
                ISA_NAME(contact_columns_stick), ISA_NAME(contact_columns_moving),
                ISA_NAME(contact_columns_moving_stick)}};

/* The derivatives of the contacts' forces for one instruction set: one directional derivative (C16),
 * evaluated over the 12 columns of configuration and the 12 of velocity. */

enum { ROLLER = 2 }; /* the third body, where rollers move */

/* A variation of one body's configuration, and its effect at fixed u. */
typedef struct Shift {
    int body;
    Lane3 p;      /* of P, m */
    Lane3 p1;     /* of P' */
    Lane3 r;      /* of the body's arm */
    Lane3 pdot;   /* of the velocity at P */
    Lane3 centre; /* of the roller's centre, m */
    Lane3 turn;   /* of the roller, rad */
} Shift;

/* Effect of any variation on the contact: on u, the normal, the velocities, the gap and its rate. */
typedef struct Variation {
    Lane u;
    Lane3 normal, pdot, omega;
    Lane gap, rate;
    Lane3 p; /* of P with everything that moves it, less the roller's centre (SP5); where rollers move, of its lever */
} Variation;

/* dF (C16) for a variation of normal, velocities and gap: F = N (n - phi v_t), so both factors vary. */
LANE_INLINE Lane3 vary_force(const Contact *c, const Variation *by, Variant is)
{
    const Lane3 n = c->at.probe.normal;
    const Lane radius = c->at.radius, radius_by = c->at.radius1 * by->u;
    /* dv_s */
    Lane3 slip = l3_axpy(by->pdot, -radius_by, l3_cross(c->omega, n));
    slip = l3_axpy(slip, -radius, l3_add(l3_cross(by->omega, n), l3_cross(c->omega, by->normal)));
    /* dN from the law's slopes */
    const Lane normal = c->push.gap * by->gap + c->push.rate * by->rate;
    Lane3 direction_by = by->normal;
    if (is.rubs != FRICTION_NONE) {
        direction_by = rub_direction_by(&c->rub, n, c->slip, c->slip_normal, c->slide, by->normal, slip,
                                        is.rubs == FRICTION_STICK);
    }
    return l3_axpy(l3_scale(normal, contact_direction(c, is)), c->push.force, direction_by);
}

/* The variation that follows from a shift: the nearest point moves along the line by du (C16). */
LANE_INLINE Variation vary_shift(const Contact *c, const Line *line, const Shift *s, Variant is)
{
    const Lane zero = lane_set(0);
    const LinePoint *at = &c->at;
    const Lane3 n = at->probe.normal;
    /* displacement seen from the roller: a roller that moves and turns carries its distance field along (SP4) */
    const Lane3 seen = is.moving ? l3_sub(s->p, l3_add(s->centre, l3_cross(s->turn, c->lever))) : s->p;
    /* g' = 0 remains true: dg'|u + g'' du = 0 */
    Lane push = l3_dot(probe_hessian_times(&at->probe, seen), at->p1) + l3_dot(n, s->p1);
    if (is.moving) push += l3_dot(l3_cross(s->turn, n), at->p1);
    Variation by;
    by.u = lane_select(c->interior & (at->curvature > zero), -push / at->curvature, zero);
    /* the normal follows the point, both by the shift and along the line */
    by.normal = probe_hessian_times(&at->probe, l3_axpy(seen, by.u, at->p1));
    if (is.moving) by.normal = l3_add(by.normal, l3_cross(s->turn, n));
    const LaneBody *j = &line->body[0], *k = &line->body[1];
    const Lane3 pdot1 = weighted(&at->weight1, j->v, l3_cross(j->w, j->r), k->v, l3_cross(k->w, k->r));
    by.pdot = l3_axpy(s->pdot, by.u, pdot1);
    if (is.moving) {
        by.p = l3_sub(l3_axpy(s->p, by.u, at->p1), s->centre);
        by.pdot = l3_sub(by.pdot, l3_cross(c->roller_w, by.p));
    }
    by.omega = l3_scale(by.u * at->weight1.alpha[1], l3_sub(k->w, j->w));
    /* moving along the line changes no gap: g' = 0 inside, du = 0 at a clamped end */
    by.gap = l3_dot(n, seen);
    by.rate = l3_dot(by.normal, c->pdot) + l3_dot(n, by.pdot);
    return by;
}

/* Force and moment rows of one body into a column. */
LANE_INLINE void rows_store(double rows[][LANES], int body, Lane3 force, Lane3 moment)
{
    batch_vector_store(rows + 6 * body, force);
    batch_vector_store(rows + 6 * body + 3, moment);
}

/* The roller's rows: the force turned round, and its moment about the roller's centre (SP6). */
LANE_INLINE void roller_rows(const Contact *c, Lane3 arm_by, Lane3 force, double rows[][LANES])
{
    const Lane3 moment = l3_add(l3_cross(arm_by, c->force), l3_cross(contact_roller_arm(c), force));
    rows_store(rows, ROLLER, l3_neg(force), l3_neg(moment));
}

/* A configuration column: both bodies' force and moment (C17), and the roller's where it moves. */
LANE_INLINE void column_shift(const Contact *c, const Line *line, const Shift *s, double rows[][LANES], Variant is)
{
    const Variation by = vary_shift(c, line, s, is);
    const Lane3 force = vary_force(c, &by, is);
    const Lane3 n = c->at.probe.normal;
    for (int b = 0; b < 2; ++b) {
        const Lane alpha = c->at.weight.alpha[b], alpha_by = c->at.weight1.alpha[b] * by.u;
        /* d(beta_i r_i - alpha_i rc n), product rule with everything that du moves */
        const Lane lever_by = alpha_by * c->at.radius + alpha * c->at.radius1 * by.u; /* of alpha_i rc */
        Lane3 arm = l3_scale(c->at.weight1.beta[b] * by.u, line->body[b].r);
        arm = l3_axpy(l3_axpy(arm, -lever_by, n), -alpha * c->at.radius, by.normal);
        if (b == s->body) arm = l3_axpy(arm, c->at.weight.beta[b], s->r);
        rows_store(rows, b, l3_axpy(l3_scale(alpha, force), alpha_by, c->force),
                   l3_add(l3_cross(arm, c->force), l3_cross(c->arm[b], force)));
    }
    if (!is.moving) return;
    const Lane3 off = l3_axpy(l3_scale(c->at.radius1 * by.u, n), c->at.radius, by.normal); /* d(rc n) */
    roller_rows(c, l3_sub(by.p, off), force, rows);
}

/* A velocity column: nothing moves, only velocities change. */
LANE_INLINE void column_speed(const Contact *c, Lane3 pdot, Lane3 omega, double rows[][LANES], Variant is)
{
    const Variation by = {.pdot = pdot, .omega = omega, .rate = l3_dot(c->at.probe.normal, pdot)};
    const Lane3 force = vary_force(c, &by, is);
    for (int b = 0; b < 2; ++b) {
        rows_store(rows, b, l3_scale(c->at.weight.alpha[b], force), l3_cross(c->arm[b], force));
    }
    if (is.moving) roller_rows(c, l3_zero(), force, rows);
}

/* Targets of a contact's columns, and their variables. */
typedef struct Columns {
    double (*k)[LANES], (*d)[LANES];
    int speeds; /* 1: forces depend on velocities; 0: d is not written */
} Columns;

/* Four columns of body b: displacement along and rotation about one axis, velocity and angular velocity likewise. */
LANE_INLINE void axis_columns(const Contact *c, const Line *line, int b, int axis, Variant is, const Columns *out)
{
    const int rows = is.moving ? MOVING_ROWS : CONTACT_ROWS;
    const LaneBody *body = &line->body[b];
    const Lane alpha = c->at.weight.alpha[b], beta = c->at.weight.beta[b];
    const Lane alpha1 = c->at.weight1.alpha[b], beta1 = c->at.weight1.beta[b];
    const Lane3 e = l3_axis(axis);
    const Lane3 turned = l3_cross(e, body->r);
    const Lane3 none = l3_zero();
    const Shift shift = {b, l3_scale(alpha, e), l3_scale(alpha1, e), none, none, none, none};
    const Shift turn = {
        b,   l3_scale(beta, turned), l3_scale(beta1, turned), turned, l3_scale(beta, l3_cross(body->w, turned)), none,
        none};
    const int first = rows * (6 * b + axis), second = first + rows * 3;
    column_shift(c, line, &shift, out->k + first, is);
    column_shift(c, line, &turn, out->k + second, is);
    if (!out->speeds) return;
    column_speed(c, l3_scale(alpha, e), none, out->d + first, is);
    column_speed(c, l3_scale(beta, turned), l3_scale(alpha, e), out->d + second, is);
}

/* The same as functions, one for each variant but the plain one: inlining them six times would only enlarge the
 * program. */
#define AXIS_COLUMNS(name, which)                                                                                      \
    static __attribute__((noinline)) void name(const Contact *c, const Line *line, int b, int axis,                    \
                                               const Columns *out)                                                     \
    {                                                                                                                  \
        axis_columns(c, line, b, axis, variant_of(which), out);                                                        \
    }

AXIS_COLUMNS(axis_smooth, VARIANT_SMOOTH)
AXIS_COLUMNS(axis_general, VARIANT_GENERAL)
AXIS_COLUMNS(axis_stick, VARIANT_STICK)
AXIS_COLUMNS(axis_moving, VARIANT_MOVING)
AXIS_COLUMNS(axis_moving_stick, VARIANT_MOVING_STICK)

/* The twelve columns of body b: three displacements, three rotations, three velocities, three angular velocities. */
LANE_INLINE void body_columns(const Contact *c, const Line *line, int b, ContactVariant which, const Columns *out)
{
    for (int axis = 0; axis < 3; ++axis) {
        switch (which) {
        case VARIANT_PLAIN:
            axis_columns(c, line, b, axis, variant_of(VARIANT_PLAIN), out);
            break;
        case VARIANT_SMOOTH:
            axis_smooth(c, line, b, axis, out);
            break;
        case VARIANT_GENERAL:
            axis_general(c, line, b, axis, out);
            break;
        case VARIANT_STICK:
            axis_stick(c, line, b, axis, out);
            break;
        case VARIANT_MOVING:
            axis_moving(c, line, b, axis, out);
            break;
        case VARIANT_MOVING_STICK:
            axis_moving_stick(c, line, b, axis, out);
            break;
        }
    }
}

/* The twelve columns of the roller (SP4), (SP5): it moves, turns, and its surface runs. */
LANE_INLINE void roller_columns(const Contact *c, const Line *line, Variant is, const Columns *out)
{
    const Lane3 none = l3_zero();
    for (int axis = 0; axis < 3; ++axis) {
        const Lane3 e = l3_axis(axis), back = l3_neg(e);
        const Shift shift = {ROLLER, none, none, none, none, e, none};
        const Shift turn = {ROLLER, none, none, none, none, none, e};
        const int first = MOVING_ROWS * (6 * ROLLER + axis), second = first + MOVING_ROWS * 3;
        column_shift(c, line, &shift, out->k + first, is);
        column_shift(c, line, &turn, out->k + second, is);
        column_speed(c, back, none, out->d + first, is);
        column_speed(c, l3_cross(back, c->lever), back, out->d + second, is);
    }
}

/* Without friction and damping no force depends on a velocity: then d is not written, and 2 is returned; for rollers
 * that move it is always written. */
LANE_INLINE int columns_of(const ContactBatch *batch, ContactMatrix *k, ContactMatrix *d, double normal[LANES],
                           ContactVariant which)
{
    const Variant is = variant_of(which);
    /* the same contact as in the force kernel, from the same state: nothing is stored between the two */
    const Line line = line_load(batch, is.grooved);
    const Contact c = contact_at(batch, &line, is);
    lane_store(normal, c.push.force);
    if (!lane_any(c.push.touches)) return 0;
    const Columns out = {k->entry, d->entry, is.moving || is.rubs != FRICTION_NONE || batch->impact->c > 0};
    for (int b = 0; b < 2; ++b) body_columns(&c, &line, b, which, &out);
    if (is.moving) roller_columns(&c, &line, is, &out);
    return out.speeds ? 1 : 2;
}

COLUMNS(contact_columns_plain) { return columns_of(batch, k, d, normal, VARIANT_PLAIN); }

COLUMNS(contact_columns_smooth) { return columns_of(batch, k, d, normal, VARIANT_SMOOTH); }

COLUMNS(contact_columns_general) { return columns_of(batch, k, d, normal, VARIANT_GENERAL); }

COLUMNS(contact_columns_stick) { return columns_of(batch, k, d, normal, VARIANT_STICK); }

COLUMNS(contact_columns_moving) { return columns_of(batch, k, d, normal, VARIANT_MOVING); }

COLUMNS(contact_columns_moving_stick) { return columns_of(batch, k, d, normal, VARIANT_MOVING_STICK); }
