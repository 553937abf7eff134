/* The scalar side of the shapes: distances for the candidates' tree and for input, and one lane of the kernels'
 * functions for tests. */
#include "contact/shape.h"

#include <assert.h>
#include <string.h>

#include "contact/shape_lanes.h"

/* A V's lips are as far apart as its flanks make them at the depth. */
Groove groove_v(double half_angle, double depth)
{
    return (Groove){.depth = depth, .lip = depth * tan(half_angle), .cosine = cos(half_angle), .sine = sin(half_angle)};
}

/* The arc ends where it has risen by the depth. */
Groove groove_u(double radius, double depth)
{
    assert(depth <= radius);
    const double cosine = (radius - depth) / radius, sine = sqrt(1 - cosine * cosine);
    return (Groove){.depth = depth, .lip = radius * sine, .cosine = cosine, .sine = sine, .radius = radius};
}

double groove_flank(ShapeKind kind, const Groove *groove)
{
    if (kind == SHAPE_V_GROOVE) return groove->cosine / groove->sine;
    if (kind == SHAPE_U_GROOVE) return groove->cosine > 0 ? groove->sine / groove->cosine : INFINITY;
    return 0;
}

int shape_faces(ShapeKind kind) { return kind == SHAPE_V_GROOVE ? 2 : 1; }

/* (C7) in the half plane: a quarter plane, rounded outside its corner. The rim is farther than either of the two
 * surfaces that meet there. */
static double corner_distance(double q_rho, double q_z)
{
    if (q_rho > 0 && q_z > 0) return sqrt(q_rho * q_rho + q_z * q_z);
    return fmax(q_rho, q_z);
}

/* (GR2), zeta toward the flank's own side. */
static double flank_distance(const Shape *shape, double rho, double zeta)
{
    const Groove *const g = &shape->groove;
    const double q_rho = rho - shape->radius;
    const double along = q_rho * g->cosine + zeta * g->sine, out = q_rho * g->sine - zeta * g->cosine;
    const double q_lip = q_rho - g->depth, q_rim = zeta - shape->half_width;
    if (along * g->cosine > g->depth && zeta < g->lip) return hypot(q_lip, zeta - g->lip);
    if (along < 0 && q_rho > 0) return hypot(q_rho, zeta);
    const double cylinder = corner_distance(q_lip, q_rim);
    if (zeta >= g->lip && cylinder > 0) return cylinder;
    return fmax(fmax(out, -zeta), cylinder);
}

/* (GR3), zeta = |z|. */
static double hollow_distance(const Shape *shape, double rho, double zeta)
{
    const Groove *const g = &shape->groove;
    const double q_rho = rho - (shape->radius + g->radius);
    const double from_arc = g->radius - hypot(q_rho, zeta);
    const double q_lip = rho - (shape->radius + g->depth), q_rim = zeta - shape->half_width;
    const int before_arc = q_rho * g->sine + zeta * g->cosine <= 0;
    if (before_arc && from_arc > 0) return from_arc;
    if (!before_arc && zeta < g->lip) return hypot(q_lip, zeta - g->lip);
    const double cylinder = corner_distance(q_lip, q_rim);
    return cylinder > 0 ? cylinder : fmax(cylinder, from_arc);
}

/* (OB1). */
static double box_distance(const Shape *shape, Vec3 from_centre)
{
    const BoxSection *const b = &shape->box;
    const double at[3] = {v3_dot(from_centre, shape->axis), v3_dot(from_centre, b->side),
                          v3_dot(from_centre, v3_cross(shape->axis, b->side))};
    const double half[3] = {shape->half_width, b->half[0], b->half[1]};
    double square = 0, deep = -INFINITY;
    for (int c = 0; c < 3; ++c) {
        const double q = fabs(at[c]) - (half[c] - b->edge);
        if (q > 0) square += q * q;
        deep = fmax(deep, q);
    }
    return (square > 0 ? sqrt(square) : deep) - b->edge;
}

double shape_face_distance(const Shape *shape, int face, Vec3 p)
{
    const Vec3 from_centre = v3_sub(p, shape->centre);
    const double z = v3_dot(from_centre, shape->axis);
    const double rho = v3_norm(v3_axpy(from_centre, -z, shape->axis));
    if (shape->kind == SHAPE_V_GROOVE) return flank_distance(shape, rho, face == 0 ? z : -z);
    if (shape->kind == SHAPE_BOX) return box_distance(shape, from_centre);
    if (shape->kind == SHAPE_BELL) return hypot(rho - shape->bell.ring, z) - shape->radius; /* (OB4) */
    if (shape->kind == SHAPE_U_GROOVE) return hollow_distance(shape, rho, fabs(z));
    return corner_distance(rho - shape->radius, fabs(z) - shape->half_width);
}

double shape_distance(const Shape *shape, Vec3 p)
{
    const double first = shape_face_distance(shape, 0, p);
    return shape_faces(shape->kind) == 1 ? first : fmin(first, shape_face_distance(shape, 1, p));
}

double shape_seat(const Shape *shape, double cable_radius)
{
    const Groove *const g = &shape->groove;
    const int fits = shape->kind == SHAPE_V_GROOVE ? cable_radius * g->cosine * g->cosine <= g->depth * g->sine
                                                   : shape->kind == SHAPE_CYLINDER || cable_radius <= g->radius;
    if (!fits && cable_radius > g->lip) {
        return shape->radius + g->depth + sqrt(cable_radius * cable_radius - g->lip * g->lip);
    }
    return shape->radius + (shape->kind == SHAPE_V_GROOVE ? cable_radius / g->sine : cable_radius);
}

void shape_form(const Shape *shape, int face, double form[SHAPE_FORM])
{
    const Groove *const g = &shape->groove;
    const BoxSection *const b = &shape->box;
    if (shape->kind == SHAPE_BOX) {
        const double boxed[SHAPE_FORM] = {b->side.x, b->side.y, b->side.z, b->half[0], b->half[1], b->edge};
        memcpy(form, boxed, sizeof boxed);
    } else if (shape->kind == SHAPE_BELL) {
        const double ringed[SHAPE_FORM] = {shape->bell.ring};
        memcpy(form, ringed, sizeof ringed);
    } else {
        const double grooved[SHAPE_FORM] = {g->depth, g->lip, g->cosine, g->sine, g->radius, face == 0 ? 1 : -1};
        memcpy(form, grooved, sizeof grooved);
    }
}

static Vec3 lane3_first(Lane3 a) { return v3(a.x[0], a.y[0], a.z[0]); }

/* matrix += k t t^T */
static void outer_add(Mat3 *matrix, double k, Vec3 t)
{
    const double c[3] = {t.x, t.y, t.z};
    for (int i = 0; i < 9; ++i) matrix->m[i] += k * c[i / 3] * c[i % 3];
}

/* One lane of the kernels' function, with the Hessian put together from its principal directions. */
ShapeProbe shape_probe(const Shape *shape, int face, Vec3 p)
{
    const LaneShape s = shape_spread(shape);
    const LaneForm form = form_spread(shape, face);
    const Lane3 at = l3_spread(p);
    LaneProbe lanes = shape_cylinder(&s, at);
    if (shape->kind != SHAPE_CYLINDER) shape_by_kind(shape->kind, &s, &form, &at, &lanes);
    ShapeProbe probe = {.distance = lanes.distance[0], .normal = lane3_first(lanes.normal)};
    outer_add(&probe.hessian, lanes.k1[0], lane3_first(lanes.t1));
    outer_add(&probe.hessian, lanes.k2[0], lane3_first(lanes.t2));
    return probe;
}
