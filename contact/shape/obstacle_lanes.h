/* Distance, normal and curvature of LANES points against obstacles: boxes with rounded edges and bell-mouths.
 * docs/model.md, "Boxes, edges and bell-mouths". */
#ifndef HAWSER_CONTACT_SHAPE_OBSTACLE_LANES_H
#define HAWSER_CONTACT_SHAPE_OBSTACLE_LANES_H

#include "contact/shape/shape_lanes.h"

/* As in BoxSection and BellRing; centre, axis, radius and half width are in LaneShape. */
typedef struct LaneBox {
    Lane3 side;
    Lane half[2], edge;
} LaneBox;
typedef struct LaneBell {
    Lane ring;
} LaneBell;

/* A box, grown by its edges' radius from a smaller one, the core (OB1)-(OB3). A function of its own, and vectors by
 * address, as shape_grooved. */
static __attribute__((noinline, unused)) void shape_box(const LaneShape *s, const LaneBox *box, const Lane3 *p,
                                                        LaneProbe *out)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane3 frame[3] = {s->axis, box->side, l3_cross(s->axis, box->side)};
    const Lane half[3] = {s->half_width, box->half[0], box->half[1]};
    const Lane3 from_centre = l3_sub(*p, s->centre);
    /* against each pair of the core's faces, and how far outside of it */
    Lane sign[3], q[3], beyond[3];
    for (int c = 0; c < 3; ++c) {
        const Lane z = l3_dot(from_centre, frame[c]);
        sign[c] = lane_select(z < zero, -one, one);
        q[c] = sign[c] * z - (half[c] - box->edge);
        beyond[c] = lane_at_least(q[c], 0);
    }
    const Lane square = beyond[0] * beyond[0] + beyond[1] * beyond[1] + beyond[2] * beyond[2];
    const LaneMask outside = square > zero;
    const Lane length = lane_sqrt(lane_at_least(square, 1e-60)), inverse = 1 / length;

    /* away from the core's nearest point; inside the core, through its nearest face */
    const LaneMask first = (q[0] >= q[1]) & (q[0] >= q[2]), second = ~first & (q[1] >= q[2]);
    const LaneMask face[3] = {first, second, ~first & ~second};
    const Lane deep = lane_select(first, q[0], lane_select(second, q[1], q[2]));
    out->distance = lane_select(outside, length, deep) - box->edge;
    Lane n[3];
    for (int c = 0; c < 3; ++c) {
        n[c] = sign[c] * lane_select(outside, beyond[c] * inverse, lane_select(face[c], one, zero));
    }
    out->normal = l3_axpy(l3_axpy(l3_scale(n[0], frame[0]), n[1], frame[1]), n[2], frame[2]);

    /* the core's direction that the normal has least of gives the first tangent: along an edge, that edge */
    const LaneMask low = (beyond[0] <= beyond[1]) & (beyond[0] <= beyond[2]), mid = beyond[1] <= beyond[2];
    const Lane least = lane_select(low, beyond[0], lane_select(mid, beyond[1], beyond[2]));
    const Lane slant = lane_select(low, n[0], lane_select(mid, n[1], n[2]));
    const Lane3 along = l3_select(low, frame[0], l3_select(mid, frame[1], frame[2]));
    out->t1 = l3_scale(1 / lane_sqrt(lane_at_least(1 - slant * slant, 1e-60)), l3_axpy(along, -slant, out->normal));
    out->t2 = l3_cross(out->normal, out->t1);
    /* a face does not curve, an edge does in one direction, a corner in both */
    const LaneMask edge = ((beyond[0] > zero) & (beyond[1] > zero)) | ((beyond[0] > zero) & (beyond[2] > zero)) |
                          ((beyond[1] > zero) & (beyond[2] > zero));
    out->k1 = lane_select(least > zero, inverse, zero);
    out->k2 = lane_select(edge, inverse, zero);
    out->scale = lane_select(outside, length, one);
}

/* A bell-mouth: a ring of round section, in whose hole the flare is (OB4), (OB5). */
static __attribute__((noinline, unused)) void shape_bell(const LaneShape *s, const LaneBell *bell, const Lane3 *p,
                                                         LaneProbe *out)
{
    const double tiny = 1e-60; /* keeps the axis, and the middle of the section, from dividing by zero */
    const Lane3 from_centre = l3_sub(*p, s->centre);
    const Lane z = l3_dot(from_centre, s->axis);
    const Lane3 radial = l3_axpy(from_centre, -z, s->axis);
    const Lane rho = lane_sqrt(lane_at_least(l3_dot(radial, radial), tiny));
    const Lane3 e_rho = l3_scale(1 / rho, radial);
    const Lane q_rho = rho - bell->ring;
    const Lane r = lane_sqrt(lane_at_least(q_rho * q_rho + z * z, tiny)), inverse = 1 / r;
    const Lane n_rho = q_rho * inverse, n_z = z * inverse;
    out->distance = r - s->radius;
    out->normal = l3_axpy(l3_scale(n_rho, e_rho), n_z, s->axis);
    out->t1 = l3_cross(s->axis, e_rho);
    out->k1 = n_rho / rho;
    out->t2 = l3_axpy(l3_scale(-n_z, e_rho), n_rho, s->axis);
    out->k2 = inverse;
    out->scale = r;
}

#endif
