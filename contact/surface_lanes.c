/* The kernels of contact/surface.h for one instruction set: forces. */
#include "contact/surface_lanes.h"

/* Adds to LANES entries of three arrays. */
LANE_INLINE void lanes_add(double *const a[3], int i, Lane3 v) { l3_store(a, i, l3_add(l3_load(a, i), v)); }

/* Effect of the point on the motion (BA5), (BA6). */
LANE_INLINE void work_add(const SurfaceContact *c, LaneMask near, ContactTally *work)
{
    const Lane zero = lane_set(0), share = c->share.value * c->length, held = c->length * c->push.energy;
    const Lane toward = l3_dot(c->normal, c->pdot), rate = l3_dot(c->gradient, c->pdot);
    work->friction += lane_sum(lane_select(c->push.touches, c->load * rub_loss(&c->rub, c->slide), zero));
    work->damping += lane_sum(lane_select(near, share * c->push.loss, zero));
    work->energy += lane_sum(lane_select(near, share * c->push.energy, zero));
    /* the weight multiplies the force only (DU8): its work on the springs where it rises along the way (BA10) */
    const Lane rise = held * l3_dot(c->share.slope, c->pdot);
    work->edges += lane_sum(lane_select(near, rise + c->load * (toward - rate), zero));
    const Lane3 force = lanes_keep(c->push.touches, c->force);
    work->force[0] += lane_sum(force.x);
    work->force[1] += lane_sum(force.y);
    work->force[2] += lane_sum(force.z);
}

/* One point of every element of the strip; returns whether any is in contact. */
LANE_INLINE int push_point(const SurfaceStrip *strip, const StripBodies *s, int q, int sticks, Loads *loads,
                           SurfacePush *out, ContactTally *work)
{
    SurfaceContact c;
    contact_point(strip, s, q, &c);
    const LaneMask near = contact_gap(strip, s, q, &c);
    if (!lane_any(near)) return 0;
    contact_force(strip, s, q, near, sticks, &c);
    work_add(&c, near, work);
    /* by virtual work (C15); the entries of the two bodies overlap, so they are added one after the other */
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
        const LaneMask here = contact_here(strip, &s, q, &c);
        lane_store(gap[q], lane_select(here, c.section.g - c.radius, lane_set(INFINITY)));
    }
}

/* A point in contact belongs to one patch of a face, so that the sums have one term each. */
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

/* The derivatives of the surfaces' forces for one instruction set. The points are fixed on the line, so the force is a
 * function of the point's position, its velocity and the line's angular velocity alone: three 3x3 matrices (DU11), from
 * which the columns of the two bodies follow by the chain rule (DU12). */

/* Second derivatives of the distance along T, A, B (DU10). */
typedef struct SurfaceHessian {
    Lane tt, ta, tb, aa, ab, bb;
} SurfaceHessian;

/* Derivatives by the motion of a point (DU11). */
typedef struct PointSlopes {
    Lane3 normal[3]; /* dn by each component of P */
    Lane3 force[3];  /* dF by each component of P, */
    Lane3 speed[3];  /* of P' */
    Lane3 spin[3];   /* and of omega */
} PointSlopes;

/* (DU10). */
LANE_INLINE SurfaceHessian surface_hessian(const SurfacePatch *patch, const SurfacePlace *at, const SurfaceSection *g)
{
    const Lane ga = g->gy * at->cos - g->gz * at->sin, gb = g->gy * at->sin + g->gz * at->cos;
    SurfaceHessian h = {.tt = -at->curvature * ga, .ta = lane_set(0), .tb = lane_set(0)};
    h.aa = g->k * gb * gb;
    h.ab = -g->k * ga * gb;
    h.bb = g->k * ga * ga;
    if (!patch->twisted) return h;
    /* effect of the section's rotation on the distance: Q = dG/dtheta and its derivatives */
    const Lane y = at->y, z = at->z, ty = -g->gz, tz = g->gy, lever = ty * z - tz * y;
    const Lane q = g->gy * z - g->gz * y;
    const Lane q_turn = g->k * lever * lever - g->gy * y - g->gz * z;
    const Lane qy = g->k * ty * lever - g->gz, qz = g->k * tz * lever + g->gy;
    const Lane qa = qy * at->cos - qz * at->sin, qb = qy * at->sin + qz * at->cos;
    h.tt += (at->roll2 * q + at->roll1 * at->roll1 * q_turn) / (at->m * at->m);
    h.ta = at->roll1 * (qa + q * at->curvature) / at->m;
    h.tb = at->roll1 * qb / at->m;
    return h;
}

LANE_INLINE Lane3 hessian_times(const SurfaceHessian *h, const SurfacePlace *at, Lane3 v)
{
    const Lane t = l3_dot(at->axis[0], v), a = l3_dot(at->axis[1], v), b = l3_dot(at->axis[2], v);
    const Lane out[3] = {h->tt * t + h->ta * a + h->tb * b, h->ta * t + h->aa * a + h->ab * b,
                         h->tb * t + h->ab * a + h->bb * b};
    return surface_vector(at, out);
}

/* dF for a change of the normal, of the velocity of the surface's material and of the normal force (C16). */
LANE_INLINE Lane3 vary_contact(const SurfaceContact *c, int sticks, Lane3 normal_by, Lane3 slip_by, Lane load_by)
{
    const Lane3 n = c->normal;
    const Lane3 direction_by =
        rub_direction_by(&c->rub, n, c->slip, c->slip_normal, c->slide, normal_by, slip_by, sticks);
    return l3_axpy(l3_scale(load_by, rub_direction(&c->rub, n)), c->load, direction_by);
}

/* Column `axis` of the second derivatives of the distance; of a mesh that of dn, by (EN24). */
LANE_INLINE Lane3 contact_bent(const SurfaceStrip *strip, int q, const SurfaceHessian *h, const SurfaceContact *c,
                               int axis)
{
    if (!strip->foot) return hessian_times(h, &c->place, l3_axis(axis));
    double *const *const turn = strip->foot->turn[q] + axis;
    return (Lane3){lane_load(turn[0] + strip->first), lane_load(turn[3] + strip->first),
                   lane_load(turn[6] + strip->first)};
}

/* (DU11), one world axis at a time. */
LANE_INLINE void point_slopes(const SurfaceStrip *strip, int q, const SurfaceContact *c, int sticks, PointSlopes *out)
{
    const SurfaceHessian h = surface_hessian(strip->patch, &c->place, &c->section);
    const Lane3 n = c->normal;
    const Lane flat = 1 / c->steep, share = c->share.value * c->length;
    for (int axis = 0; axis < 3; ++axis) {
        const Lane3 e = l3_axis(axis);
        /* of the position: the normal turns, gap, its rate and the weight change */
        const Lane3 bent = contact_bent(strip, q, &h, c, axis);
        const Lane3 turned = l3_scale(flat, l3_axpy(bent, -l3_dot(n, bent), n));
        const Lane gap = l3_dot(c->gradient, e), rate = l3_dot(bent, c->pdot);
        const Lane load =
            share * (c->push.gap * gap + c->push.rate * rate) + c->length * c->push.force * l3_dot(c->share.slope, e);
        out->normal[axis] = turned;
        out->force[axis] = vary_contact(c, sticks, turned, l3_scale(-c->radius, l3_cross(c->omega, turned)), load);
        /* of the velocities: the normal stays */
        out->speed[axis] = vary_contact(c, sticks, l3_zero(), e, share * c->push.rate * gap);
        out->spin[axis] = vary_contact(c, sticks, l3_zero(), l3_scale(-c->radius, l3_cross(e, n)), lane_set(0));
    }
}

/* Three columns times a vector. */
LANE_INLINE Lane3 slopes_times(const Lane3 column[3], Lane3 v)
{
    return l3_axpy(l3_axpy(l3_scale(v.x, column[0]), v.y, column[1]), v.z, column[2]);
}

/* Adds force and moment rows of one body to a column, where there is contact. */
LANE_INLINE void rows_add(double rows[CONTACT_ROWS][LANES], int body, LaneMask mask, Lane3 force, Lane3 moment)
{
    force = lanes_keep(mask, force);
    moment = lanes_keep(mask, moment);
    batch_vector_store(rows + 6 * body, l3_add(batch_vector(rows + 6 * body), force));
    batch_vector_store(rows + 6 * body + 3, l3_add(batch_vector(rows + 6 * body + 3), moment));
}

/* One column: dF, and the change of the levers through dn and through the rotation of body `own` (dr). */
LANE_INLINE void column_add(const StripBodies *s, const SurfaceContact *c, Lane3 force, Lane3 normal, int own, Lane3 dr,
                            double rows[CONTACT_ROWS][LANES])
{
    for (int b = 0; b < 2; ++b) {
        Lane3 arm = l3_scale(-c->weight.alpha[b] * c->radius, normal);
        if (b == own) arm = l3_axpy(arm, c->weight.beta[b], dr);
        rows_add(rows, b, c->push.touches, l3_scale(c->weight.alpha[b], force),
                 l3_add(l3_cross(arm, c->force), l3_cross(contact_arm(s, c, b), force)));
    }
}

/* The twelve columns of body b (DU12): three displacements, three rotations, three velocities, three angular
 * velocities. */
LANE_INLINE void body_columns(const StripBodies *s, const SurfaceContact *c, const PointSlopes *by, int b,
                              ContactMatrix *k, ContactMatrix *d)
{
    const LaneBody *const body = &s->body[b];
    const Lane alpha = c->weight.alpha[b], beta = c->weight.beta[b];
    const Lane3 none = l3_zero();
    for (int axis = 0; axis < 3; ++axis) {
        const Lane3 turned = l3_cross(l3_axis(axis), body->r), moved = l3_scale(beta, turned);
        const Lane3 swept = l3_scale(beta, l3_cross(body->w, turned));
        const int first = CONTACT_ROWS * (6 * b + axis), second = first + CONTACT_ROWS * 3;
        column_add(s, c, l3_scale(alpha, by->force[axis]), l3_scale(alpha, by->normal[axis]), -1, none,
                   k->entry + first);
        column_add(s, c, l3_add(slopes_times(by->force, moved), slopes_times(by->speed, swept)),
                   slopes_times(by->normal, moved), b, turned, k->entry + second);
        column_add(s, c, l3_scale(alpha, by->speed[axis]), none, -1, none, d->entry + first);
        column_add(s, c, l3_axpy(slopes_times(by->speed, moved), alpha, by->spin[axis]), none, -1, none,
                   d->entry + second);
    }
}

LANE_INLINE int columns_of(const SurfaceStrip *strip, int sticks, ContactMatrix *k, ContactMatrix *d)
{
    const StripBodies s = strip_load(strip);
    int any = 0;
    for (int q = 0; q < SURFACE_POINTS; ++q) {
        /* the same contact as in the force kernel, from the same state: nothing is stored between the two */
        SurfaceContact c;
        contact_point(strip, &s, q, &c);
        const LaneMask near = contact_gap(strip, &s, q, &c);
        if (!lane_any(near)) continue;
        contact_force(strip, &s, q, near, sticks, &c);
        if (!lane_any(c.push.touches)) continue;
        if (!any) {
            memset(k, 0, CONTACT_ROWS * CONTACT_ROWS * sizeof *k->entry);
            memset(d, 0, CONTACT_ROWS * CONTACT_ROWS * sizeof *d->entry);
        }
        any = 1;
        PointSlopes slopes;
        point_slopes(strip, q, &c, sticks, &slopes);
        for (int b = 0; b < 2; ++b) body_columns(&s, &c, &slopes, b, k, d);
    }
    return any;
}

int ISA_NAME(surface_columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d)
{
    return strip->bed ? columns_of(strip, 1, k, d) : columns_of(strip, 0, k, d);
}
