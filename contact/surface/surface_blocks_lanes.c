/* The derivatives of the surfaces' forces for one instruction set. The points are fixed on the line, so the force is a
 * function of the point's position, its velocity and the line's angular velocity alone: three 3x3 matrices (DU11), from
 * which the columns of the two bodies follow by the chain rule (DU12). */
#include "contact/surface/surface_lanes.h"

/* Second derivatives of the distance along T, A, B (DU10). */
typedef struct SurfaceHessian {
    Lane tt, ta, tb, aa, ab, bb;
} SurfaceHessian;

/* What moving a point does (DU11). */
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
    /* how the section's turning changes the distance: Q = dG/dtheta and its derivatives */
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

/* (DU11), one world axis at a time. */
LANE_INLINE void point_slopes(const SurfacePatch *patch, const SurfaceContact *c, int sticks, PointSlopes *out)
{
    const SurfaceHessian h = surface_hessian(patch, &c->place, &c->section);
    const Lane3 n = c->normal;
    const Lane flat = 1 / c->steep, share = c->share.value * c->length;
    for (int axis = 0; axis < 3; ++axis) {
        const Lane3 e = l3_axis(axis);
        /* of the position: the normal turns, gap, its rate and the weight change */
        const Lane3 bent = hessian_times(&h, &c->place, e);
        const Lane3 turned = l3_scale(flat, l3_axpy(bent, -l3_dot(n, bent), n));
        const Lane gap = c->steep * l3_dot(n, e), rate = l3_dot(bent, c->pdot);
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

/* Adds force and moment rows of one body to a column, where something touches. */
LANE_INLINE void rows_add(double rows[CONTACT_ROWS][LANES], int body, LaneMask mask, Lane3 force, Lane3 moment)
{
    force = lanes_keep(mask, force);
    moment = lanes_keep(mask, moment);
    batch_vector_store(rows + 6 * body, l3_add(batch_vector(rows + 6 * body), force));
    batch_vector_store(rows + 6 * body + 3, l3_add(batch_vector(rows + 6 * body + 3), moment));
}

/* One column: dF, and what it does to the levers through dn and through the turning of body `own` (dr). */
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

/* The twelve columns of body b (DU12): three shifts, three turns, three velocities, three angular velocities. */
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
        /* the same contact as in the force kernel, from the same state: nothing is kept between the two */
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
        point_slopes(strip->patch, &c, sticks, &slopes);
        for (int b = 0; b < 2; ++b) body_columns(&s, &c, &slopes, b, k, d);
    }
    return any;
}

int ISA_NAME(surface_columns)(const SurfaceStrip *strip, ContactMatrix *k, ContactMatrix *d)
{
    return strip->bed ? columns_of(strip, 1, k, d) : columns_of(strip, 0, k, d);
}
