/* Distance, normal and curvature of LANES points against LANES shapes of one kind. docs/theory.md, "Contact". */
#ifndef HAWSER_CONTACT_SHAPE_LANES_H
#define HAWSER_CONTACT_SHAPE_LANES_H

#include <math.h>

#include "contact/shape.h"
#include "core/lanes.h"

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
    const double tiny = 1e-60; /* avoids a division by zero on the axis: the normal vanishes there */
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

/* Slope of the distance at p along `direction`, times a positive factor (rho, 1 or rho times the distance): the sign
 * costs one root and no division. Regions as above. */
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

/* Distance, normal and curvature of LANES points against grooved rollers: the counterpart of shape_cylinder for
 * profiles with a groove. docs/theory.md, "Grooved rollers".
 *
 * Everything happens in the half plane through the axis that holds the point: rho and zeta are the point's distance
 * from the axis and along it. Its nearest surface point is in the same half plane, on one of: the groove's wall (a
 * straight flank or an arc), a corner, the shoulder beyond the lips, the end face. */

typedef struct LaneGroove {
    Lane depth, lip, cosine, sine, radius; /* as in Groove */
    Lane side;                             /* V: +1 or -1, the face */
} LaneGroove;

/* A point against a profile: distance, gradient and curvature in the half plane. */
typedef struct LaneProfile {
    Lane distance, n_rho, n_zeta, k;
} LaneProfile;

/* Sets, where mask is set, the corner at (rho, zeta) = (c_rho, c_zeta) as nearest, a point around which the cable
 * bends. */
LANE_INLINE void profile_corner(LaneProfile *to, LaneMask mask, Lane q_rho, Lane q_zeta)
{
    const Lane distance = lane_sqrt(lane_at_least(q_rho * q_rho + q_zeta * q_zeta, 1e-60));
    const Lane inverse = 1 / distance;
    to->distance = lane_select(mask, distance, to->distance);
    to->n_rho = lane_select(mask, q_rho * inverse, to->n_rho);
    to->n_zeta = lane_select(mask, q_zeta * inverse, to->n_zeta);
    to->k = lane_select(mask, inverse, to->k);
}

/* Sets, where mask is set, a straight edge with this normal as nearest. */
LANE_INLINE void profile_edge(LaneProfile *to, LaneMask mask, Lane distance, Lane n_rho, Lane n_zeta)
{
    to->distance = lane_select(mask, distance, to->distance);
    to->n_rho = lane_select(mask, n_rho, to->n_rho);
    to->n_zeta = lane_select(mask, n_zeta, to->n_zeta);
    to->k = lane_select(mask, lane_set(0), to->k);
}

/* The outside beyond the lip, which both grooves share: lip, shoulder, rim and face (GR4). `beyond`: the point is not
 * before the groove's wall. */
LANE_INLINE void profile_outside(LaneProfile *to, LaneMask beyond, const LaneShape *s, const LaneGroove *g, Lane rho,
                                 Lane zeta)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane q_rho = rho - (s->radius + g->depth), over_lip = zeta - g->lip, over_rim = zeta - s->half_width;
    profile_edge(to, (q_rho > zero) & (over_lip >= zero), q_rho, one, zero);
    profile_corner(to, beyond & (over_lip < zero), q_rho, over_lip);
    profile_edge(to, (over_rim > zero) & (q_rho <= zero), over_rim, zero, one);
    profile_corner(to, (over_rim > zero) & (q_rho > zero), q_rho, over_rim);
}

/* One flank of a V with all that lies behind it, a convex body (GR2): zeta counts toward the flank's own side. */
LANE_INLINE LaneProfile profile_v(const LaneShape *s, const LaneGroove *g, Lane rho, Lane zeta)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane q_rho = rho - s->radius;
    /* along the flank from the bottom, and out of it */
    const Lane along = q_rho * g->cosine + zeta * g->sine, out = q_rho * g->sine - zeta * g->cosine;
    LaneProfile p = {out, g->sine, -g->cosine, zero};
    /* deep inside and below the bottom, the farthest of the body's planes */
    profile_edge(&p, q_rho - g->depth > p.distance, q_rho - g->depth, one, zero);
    profile_edge(&p, zeta - s->half_width > p.distance, zeta - s->half_width, zero, one);
    profile_edge(&p, -zeta > p.distance, -zeta, zero, -one);
    profile_outside(&p, along * g->cosine > g->depth, s, g, rho, zeta);
    /* on the other side of the groove: its bottom, as this flank's edge */
    profile_corner(&p, (along < zero) & (q_rho > zero), q_rho, zeta);
    return p;
}

/* A U, both sides at once: zeta is |z| (GR3). The arc is concave: its curvature is negative. */
LANE_INLINE LaneProfile profile_u(const LaneShape *s, const LaneGroove *g, Lane rho, Lane zeta)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    /* from the arc's centre */
    const Lane q_rho = rho - (s->radius + g->radius);
    const Lane r = lane_sqrt(lane_at_least(q_rho * q_rho + zeta * zeta, 1e-60)), inverse = 1 / r;
    const LaneMask before_arc = q_rho * g->sine + zeta * g->cosine <= zero;
    LaneProfile p = {g->radius - r, -q_rho * inverse, -zeta * inverse, -inverse};
    /* inside the body the nearest surface visible from there */
    const Lane deep = rho - (s->radius + g->depth), over_rim = zeta - s->half_width;
    const LaneMask inside = (p.distance < zero) | ~before_arc;
    profile_edge(&p, inside & (deep > p.distance), deep, one, zero);
    profile_edge(&p, inside & (over_rim > p.distance), over_rim, zero, one);
    profile_outside(&p, ~before_arc, s, g, rho, zeta);
    return p;
}

/* Probe of a grooved shape: its profile, revolved (GR5). A separate function, with vectors by address, since it is long
 * and called from many places. */
static __attribute__((noinline, unused)) void shape_grooved(ShapeKind kind, const LaneShape *s, const LaneGroove *g,
                                                            const Lane3 *p, LaneProbe *out)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const int v = kind == SHAPE_V_GROOVE;
    const Lane3 from_centre = l3_sub(*p, s->centre);
    const Lane z = l3_dot(from_centre, s->axis);
    const Lane3 radial = l3_axpy(from_centre, -z, s->axis);
    const Lane rho = lane_sqrt(lane_at_least(l3_dot(radial, radial), 1e-60));
    const Lane3 e_rho = l3_scale(1 / rho, radial);
    const Lane side = v ? g->side : lane_select(z < zero, -one, one);
    const LaneProfile profile = v ? profile_v(s, g, rho, side * z) : profile_u(s, g, rho, side * z);
    const Lane n_z = side * profile.n_zeta;
    out->distance = profile.distance;
    out->normal = l3_axpy(l3_scale(profile.n_rho, e_rho), n_z, s->axis);
    out->t1 = l3_cross(s->axis, e_rho);
    out->k1 = profile.n_rho / rho;
    out->t2 = l3_axpy(l3_scale(-n_z, e_rho), profile.n_rho, s->axis);
    out->k2 = profile.k;
    out->scale = rho;
}

/* Distance, normal and curvature of LANES points against obstacles: boxes with rounded edges and bell-mouths.
 * docs/theory.md, "Boxes, edges and bell-mouths". */

/* Members as in BoxSection and BellRing; centre, axis, radius and half width are in LaneShape. */
typedef struct LaneBox {
    Lane3 side;
    Lane half[2], edge;
} LaneBox;

typedef struct LaneBell {
    Lane ring;
} LaneBell;

/* A box: a smaller one, the core, grown by the radius of the edges (OB1)-(OB3). A separate function, with vectors by
 * address, as shape_grooved. */
static __attribute__((noinline, unused)) void shape_box(const LaneShape *s, const LaneBox *box, const Lane3 *p,
                                                        LaneProbe *out)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    const Lane3 frame[3] = {s->axis, box->side, l3_cross(s->axis, box->side)};
    const Lane half[3] = {s->half_width, box->half[0], box->half[1]};
    const Lane3 from_centre = l3_sub(*p, s->centre);
    /* relative to each pair of the core's faces, and the distance outside of it */
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

    /* the core's direction with the least component of the normal gives the first tangent: along an edge, that edge */
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

/* A bell-mouth: a ring of round section, with the flare in its hole (OB4), (OB5). */
static __attribute__((noinline, unused)) void shape_bell(const LaneShape *s, const LaneBell *bell, const Lane3 *p,
                                                         LaneProbe *out)
{
    const double tiny = 1e-60; /* avoids a division by zero on the axis and in the middle of the section */
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

/* Distance, normal and curvature of LANES points against the shapes other than cylinders: calls the function of the
 * kind. */

/* Result of shape_form, in lanes. */
typedef union LaneForm {
    Lane row[SHAPE_FORM];
    LaneGroove groove;
    LaneBox box;
    LaneBell bell;
} LaneForm;

/* One face of a shape in every lane. */
LANE_INLINE LaneForm form_spread(const Shape *shape, int face)
{
    double value[SHAPE_FORM];
    LaneForm form;
    shape_form(shape, face, value);
    for (int i = 0; i < SHAPE_FORM; ++i) form.row[i] = lane_set(value[i]);
    return form;
}

LANE_INLINE LaneShape shape_spread(const Shape *shape)
{
    return (LaneShape){l3_spread(shape->centre), l3_spread(shape->axis), lane_set(shape->radius),
                       lane_set(shape->half_width)};
}

/* Probe of any kind but the cylinder. */
LANE_INLINE void shape_by_kind(ShapeKind kind, const LaneShape *s, const LaneForm *form, const Lane3 *p, LaneProbe *out)
{
    if (kind == SHAPE_BOX) {
        shape_box(s, &form->box, p, out);
    } else if (kind == SHAPE_BELL) {
        shape_bell(s, &form->bell, p, out);
    } else {
        shape_grooved(kind, s, &form->groove, p, out);
    }
}

/* Largest steepness of a U's wall in the search for the nearest point: least n_rho of (GR15). */
static const double LEAST_N_RHO = 0.2;

/* Share of the arc's radius: a cable farther than this from a U does not touch it (GR16). */
static const double OUT_OF_GROOVE = 0.9;

/* Slope of the distance along `direction` at p, by which lines are searched for the nearest place: that of the distance
 * itself except in a U beside upright walls (GR15), and above its lips (GR16). */
LANE_INLINE Lane shape_slope(ShapeKind kind, const LaneShape *s, const LaneForm *form, Lane3 p, const LaneProbe *probe,
                             Lane3 direction)
{
    const Lane slope = l3_dot(probe->normal, direction);
    if (kind != SHAPE_U_GROOVE) return slope;
    const LaneGroove *const g = &form->groove;
    const Lane zeta = lane_abs(l3_dot(l3_sub(p, s->centre), s->axis)), n_rho = probe->k1 * probe->scale;
    const LaneMask above = (probe->scale - s->radius - g->radius) * g->sine + zeta * g->cosine > lane_set(0);
    const Lane least =
        lane_select(above & (probe->distance > OUT_OF_GROOVE * g->radius), lane_set(1), lane_set(LEAST_N_RHO));
    const Lane more = lane_select((zeta < g->lip) & (n_rho < least), least - n_rho, lane_set(0));
    return slope + more * l3_dot(l3_cross(probe->t1, s->axis), direction);
}

/* Weights of an element's two segments at a point of the contact line, for LANES elements at once, the same in space
 * and in a plane. docs/theory.md, "Contact line". */

/* The weights of the two bodies (C2), or their derivatives by u. */
typedef struct LaneWeights {
    Lane alpha[2], beta[2];
} LaneWeights;

/* An element's coefficients: of its arc, and of its other part (C3). */
typedef struct LaneShares {
    Lane arc, alpha, beta[2][2];
} LaneShares;

LANE_INLINE LaneShares shares_load(const double arc[LANES], const double alpha[LANES], const double beta[2][2][LANES])
{
    LaneShares s = {.arc = lane_load(arc), .alpha = lane_load(alpha)};
    for (int b = 0; b < 2; ++b) {
        s.beta[b][0] = lane_load(beta[b][0]);
        s.beta[b][1] = lane_load(beta[b][1]);
    }
    return s;
}

/* Weights (C2), (C3) and their first derivatives. */
LANE_INLINE void weights_at(const LaneShares *s, Lane u, LaneWeights *w, LaneWeights *w1)
{
    const Lane v = 1 - u;
    w->alpha[1] = s->arc * u * u * (3 - 2 * u) + s->alpha;
    w->alpha[0] = 1 - w->alpha[1];
    w->beta[0] = s->arc * (2 * u * v * v) + s->beta[0][0] + s->beta[0][1] * u;
    w->beta[1] = s->beta[1][0] + s->beta[1][1] * u - s->arc * (2 * u * u * v);
    w1->alpha[1] = s->arc * (6 * u * v);
    w1->alpha[0] = -w1->alpha[1];
    w1->beta[0] = s->arc * (2 * v * (1 - 3 * u)) + s->beta[0][1];
    w1->beta[1] = s->arc * (2 * u * (3 * u - 2)) + s->beta[1][1];
}

/* Second derivatives of the weights: only the arc has them. */
LANE_INLINE LaneWeights weights_second(const LaneShares *s, Lane u)
{
    LaneWeights w2;
    w2.alpha[1] = s->arc * (6 - 12 * u);
    w2.alpha[0] = -w2.alpha[1];
    w2.beta[0] = s->arc * (12 * u - 8);
    w2.beta[1] = s->arc * (12 * u - 4);
    return w2;
}

#endif
