/* Distance, normal and curvature of LANES points against LANES shapes of one kind. docs/model.md, "Contact".
 */
#ifndef HAWSER_CONTACT_SHAPE_SHAPE_LANES_H
#define HAWSER_CONTACT_SHAPE_SHAPE_LANES_H

#include <math.h>

#include "contact/shape/shape.h"
#include "core/base/lane_math.h"

typedef struct LaneShape {
    Lane3 centre, axis;
    Lane radius, half_width;
} LaneShape;

/* The distance function near a point. Its Hessian has the normal in its null space, hence two principal
 * directions: H = k1 t1 t1^T + k2 t2 t2^T. */
typedef struct LaneProbe {
    Lane distance;
    Lane3 normal;
    Lane3 t1, t2; /* unit, perpendicular to the normal and to each other */
    Lane k1, k2;  /* 1/m */
    Lane scale;   /* m, > 0: scale times the normal is nearly linear in the point; a good start for Newton */
} LaneProbe;

/* The finite cylinder (C7), (C8). rho, z: cylindrical coordinates of p; the regions are the lateral surface,
 * the end faces and, outside both, the rim. Distance and normal are continuous outside the body; the
 * curvature is not. */
LANE_INLINE LaneProbe shape_cylinder(const LaneShape *s, Lane3 p)
{
    const double tiny = 1e-60; /* keeps the axis itself from dividing by zero: the normal vanishes there */
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane3 from_centre = l3_sub(p, s->centre);
    const Lane z = l3_dot(from_centre, s->axis);
    const Lane side = lane_select(z < zero, -one, one);
    const Lane3 radial = l3_axpy(from_centre, -z, s->axis);
    const Lane rho = lane_sqrt(lane_at_least(l3_dot(radial, radial), tiny));
    const Lane3 e_rho = l3_scale(1 / rho, radial);

    /* how far outside the lateral surface and beyond the faces */
    const Lane q_rho = rho - s->radius, q_z = side * z - s->half_width;
    const LaneMask rim = (q_rho > zero) & (q_z > zero);
    const LaneMask face = (q_z > q_rho) & ~rim;
    const Lane rim_distance = lane_sqrt(lane_at_least(q_rho * q_rho + q_z * q_z, tiny));
    const Lane inverse = 1 / rim_distance;

    /* normal = n_rho e_rho + n_z axis */
    const Lane n_rho = lane_select(rim, q_rho * inverse, lane_select(face, zero, one));
    const Lane n_z = side * lane_select(rim, q_z * inverse, lane_select(face, one, zero));
    LaneProbe probe;
    probe.distance = lane_select(rim, rim_distance, lane_select(face, q_z, q_rho));
    probe.normal = l3_axpy(l3_scale(n_rho, e_rho), n_z, s->axis);
    probe.t1 = l3_cross(s->axis, e_rho);
    probe.k1 = n_rho / rho;
    probe.t2 = l3_axpy(l3_scale(-n_z, e_rho), n_rho, s->axis);
    probe.k2 = lane_select(rim, inverse, zero);
    probe.scale = rho;
    return probe;
}

/* Slope of the distance at p along `direction`, times a positive factor (rho, 1 or rho times the distance):
 * its sign costs one root and no division. Regions as above. */
LANE_INLINE Lane shape_cylinder_slope(const LaneShape *s, Lane3 p, Lane3 direction)
{
    const Lane zero = lane_set(0);
    const Lane3 from_centre = l3_sub(p, s->centre);
    const Lane z = l3_dot(from_centre, s->axis);
    const Lane3 radial = l3_axpy(from_centre, -z, s->axis);
    const Lane rho = lane_sqrt(l3_dot(radial, radial));
    const Lane along_axis = l3_dot(s->axis, direction);
    const Lane along_radius = l3_dot(radial, direction);
    const Lane outward = lane_select(z < zero, -along_axis, along_axis);

    const Lane q_rho = rho - s->radius, q_z = lane_select(z < zero, -z, z) - s->half_width;
    const LaneMask rim = (q_rho > zero) & (q_z > zero);
    const LaneMask face = (q_z > q_rho) & ~rim;
    return lane_select(rim, q_rho * along_radius + q_z * rho * outward, lane_select(face, outward, along_radius));
}

/* H v. */
LANE_INLINE Lane3 probe_hessian_times(const LaneProbe *probe, Lane3 v)
{
    return l3_axpy(l3_scale(probe->k1 * l3_dot(probe->t1, v), probe->t1), probe->k2 * l3_dot(probe->t2, v), probe->t2);
}

#endif
