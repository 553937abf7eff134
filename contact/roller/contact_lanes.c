/* The force kernels of contact_kernels.h for one instruction set. */
#include "contact/roller/contact_lanes.h"

/* The same as below for the kinds beside the cylinder: slopes, or distances. */
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
