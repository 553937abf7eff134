/* The force kernels of surface_kernels.h for one instruction set. */
#include "contact/surface/surface_lanes.h"

/* Adds to LANES entries of three arrays. */
LANE_INLINE void lanes_add(double *const a[3], int i, Lane3 v) { l3_store(a, i, l3_add(l3_load(a, i), v)); }

/* What the point does to the motion (BA5), (BA6). */
LANE_INLINE void work_add(const SurfaceContact *c, LaneMask near, ContactTally *work)
{
    const Lane zero = lane_set(0), share = c->share.value * c->length, held = c->length * c->push.energy;
    const Lane toward = l3_dot(c->normal, c->pdot), rate = c->steep * toward;
    work->friction += lane_sum(lane_select(c->push.touches, c->load * rub_loss(&c->rub, c->slide), zero));
    work->damping += lane_sum(lane_select(near, share * c->push.loss, zero));
    work->energy += lane_sum(lane_select(near, share * c->push.energy, zero));
    /* the weight multiplies the force only (DU8): what it lends to the springs where it rises along the way (BA10) */
    const Lane rise = held * l3_dot(c->share.slope, c->pdot);
    work->edges += lane_sum(lane_select(near, rise + c->load * (toward - rate), zero));
    const Lane3 force = lanes_keep(c->push.touches, c->force);
    work->force[0] += lane_sum(force.x);
    work->force[1] += lane_sum(force.y);
    work->force[2] += lane_sum(force.z);
}

/* One point of every element of the strip; returns whether any touches. */
LANE_INLINE int push_point(const SurfaceStrip *strip, const StripBodies *s, int q, int sticks, Loads *loads,
                           SurfacePush *out, ContactTally *work)
{
    SurfaceContact c;
    contact_point(strip, s, q, &c);
    const LaneMask near = contact_gap(strip, s, q, &c);
    if (!lane_any(near)) return 0;
    contact_force(strip, s, q, near, sticks, &c);
    work_add(&c, near, work);
    /* by virtual work (C15); the two bodies' entries overlap, so one after the other */
    for (int b = 0; b < 2; ++b) {
        const int i = strip->first - 1 + b;
        lanes_add(loads->f, i, lanes_keep(c.push.touches, l3_scale(c.weight.alpha[b], c.force)));
        lanes_add(loads->m, i, lanes_keep(c.push.touches, l3_cross(contact_arm(s, &c, b), c.force)));
    }
    if (!out) return 1;
    batch_vector_store(out->force[q], lanes_keep(c.push.touches, c.force));
    lane_store(out->normal[q], lane_select(c.push.touches, c.load, lane_set(0)));
    lane_store(out->along[q], surface_along(strip->patch, c.p, &c.place));
    return 1;
}

static int kernel_push(const SurfaceStrip *strip, Loads *loads, SurfacePush *out, ContactTally *work)
{
    const StripBodies s = strip_load(strip);
    if (out) memset(out, 0, sizeof *out);
    int any = 0;
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        any |=
            strip->bed ? push_point(strip, &s, q, 1, loads, out, work) : push_point(strip, &s, q, 0, loads, out, work);
    }
    return any;
}

/* (DU13): within reach of the patch's part of the way, and neither far above nor far behind its surface. */
static void kernel_near(const SurfaceStrip *strip, double reach, int near[LANES])
{
    const SurfacePatch *const patch = strip->patch;
    const StripBodies s = strip_load(strip);
    LaneMask any = s.live & ~s.live;
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        SurfaceContact c;
        contact_point(strip, &s, q, &c);
        const SurfacePlace at = surface_place(patch, c.p);
        const Lane g = surface_section(patch, &at).g;
        LaneMask here = (g < c.radius + reach) & (g > lane_set(-patch->depth - reach));
        if (patch->length > 0) {
            here &= l3_dot(l3_sub(c.p, l3_spread(patch->start)), l3_spread(patch->tangent)) >= lane_set(-reach);
            here &= l3_dot(l3_sub(c.p, l3_spread(patch->end)), l3_spread(patch->end_tangent)) < lane_set(reach);
        }
        any |= here & s.live;
    }
    for (int l = 0; l < LANES; ++l) near[l] = any[l] != 0;
}

static void kernel_gaps(const SurfaceStrip *strip, double gap[SURFACE_POINTS][LANES])
{
    const StripBodies s = strip_load(strip);
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        SurfaceContact c;
        contact_point(strip, &s, q, &c);
        const LaneMask here = contact_here(strip, &s, &c);
        lane_store(gap[q], lane_select(here, c.section.g - c.radius, lane_set(INFINITY)));
    }
}

/* A point that touches belongs to one patch of a face, so that the sums have one term each. */
static void kernel_keep(const SurfaceStrip *strip)
{
    const StripBodies s = strip_load(strip);
    const LaneFriction law = friction_spread(strip->friction);
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        SurfaceContact c;
        contact_point(strip, &s, q, &c);
        const LaneMask near = contact_gap(strip, &s, q, &c);
        if (!lane_any(near)) continue;
        contact_force(strip, &s, q, near, 1, &c);
        lanes_add(strip->bed->fresh[q], strip->first,
                  lanes_keep(c.push.touches, rub_keep(&c.rub, &law, c.normal, c.slide)));
    }
}

static void kernel_probe(const SurfacePatch *patch, Vec3 p, SurfaceProbe *out)
{
    const SurfacePlace at = surface_place(patch, l3_spread(p));
    const SurfaceSection section = surface_section(patch, &at);
    Lane gradient[3];
    surface_gradient(&at, &section, gradient);
    const Lane3 n = surface_vector(&at, gradient);
    *out = (SurfaceProbe){.distance = section.g[0],
                          .normal = v3_unit(v3(n.x[0], n.y[0], n.z[0])),
                          .share = surface_share(patch, &at).value[0],
                          .owned = at.owned[0] != 0};
}

const SurfaceKernels ISA_NAME(surface_kernels) = {
    kernel_push, ISA_NAME(surface_columns), kernel_near, kernel_gaps, kernel_keep, kernel_probe};
