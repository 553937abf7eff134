#include "contact/shape.h"

#include "contact/shape_lanes.h"

/* (C7). The rim is farther than either of the two surfaces that meet there. */
double shape_distance(const Shape *shape, Vec3 p)
{
    const Vec3 from_centre = v3_sub(p, shape->centre);
    const double z = v3_dot(from_centre, shape->axis);
    const double q_rho = v3_norm(v3_axpy(from_centre, -z, shape->axis)) - shape->radius;
    const double q_z = fabs(z) - shape->half_width;
    if (q_rho > 0 && q_z > 0) return sqrt(q_rho * q_rho + q_z * q_z);
    return fmax(q_rho, q_z);
}

/* Between scalars and lanes. */
static Lane3 lane3_set(Vec3 a) { return (Lane3){lane_set(a.x), lane_set(a.y), lane_set(a.z)}; }
static Vec3 lane3_first(Lane3 a) { return v3(a.x[0], a.y[0], a.z[0]); }

/* matrix += k t t^T */
static void outer_add(Mat3 *matrix, double k, Vec3 t)
{
    const double c[3] = {t.x, t.y, t.z};
    for (int i = 0; i < 9; ++i) matrix->m[i] += k * c[i / 3] * c[i % 3];
}

/* One lane of the kernels' function, with the Hessian put together from its principal directions. */
ShapeProbe shape_probe(const Shape *shape, Vec3 p)
{
    const LaneShape s = {lane3_set(shape->centre), lane3_set(shape->axis), lane_set(shape->radius),
                         lane_set(shape->half_width)};
    const LaneProbe lanes = shape_cylinder(&s, lane3_set(p));
    ShapeProbe probe = {.distance = lanes.distance[0], .normal = lane3_first(lanes.normal)};
    outer_add(&probe.hessian, lanes.k1[0], lane3_first(lanes.t1));
    outer_add(&probe.hessian, lanes.k2[0], lane3_first(lanes.t2));
    return probe;
}
