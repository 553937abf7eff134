/* Distance, normal and curvature of LANES points against grooved rollers: the counterpart of shape_cylinder for
 * profiles with a groove. docs/model.md, "Grooved rollers".
 *
 * Everything happens in the half plane through the axis that holds the point: rho and zeta are the point's distance
 * from the axis and along it. Its nearest surface point is in the same half plane, on one of: the groove's wall (a
 * straight flank or an arc), a corner, the shoulder beyond the lips, the end face. */
#ifndef HAWSER_CONTACT_SHAPE_GROOVE_LANES_H
#define HAWSER_CONTACT_SHAPE_GROOVE_LANES_H

#include "contact/shape/shape_lanes.h"

typedef struct LaneGroove {
    Lane depth, lip, cosine, sine, radius; /* as in Groove */
    Lane side;                             /* V: +1 or -1, the face */
} LaneGroove;

/* A point against a profile: distance, gradient and curvature in the half plane. */
typedef struct LaneProfile {
    Lane distance, n_rho, n_zeta, k;
} LaneProfile;

/* Where mask is set: the corner at (rho, zeta) = (c_rho, c_zeta) is nearest, a point that the cable rounds. */
LANE_INLINE void profile_corner(LaneProfile *to, LaneMask mask, Lane q_rho, Lane q_zeta)
{
    const Lane distance = lane_sqrt(lane_at_least(q_rho * q_rho + q_zeta * q_zeta, 1e-60));
    const Lane inverse = 1 / distance;
    to->distance = lane_select(mask, distance, to->distance);
    to->n_rho = lane_select(mask, q_rho * inverse, to->n_rho);
    to->n_zeta = lane_select(mask, q_zeta * inverse, to->n_zeta);
    to->k = lane_select(mask, inverse, to->k);
}

/* Where mask is set: a straight edge with this normal is nearest. */
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

/* A U, both sides at once: zeta is |z| (GR3). The arc is hollow: its curvature is negative. */
LANE_INLINE LaneProfile profile_u(const LaneShape *s, const LaneGroove *g, Lane rho, Lane zeta)
{
    const Lane zero = lane_set(0), one = lane_set(1);
    /* from the arc's centre */
    const Lane q_rho = rho - (s->radius + g->radius);
    const Lane r = lane_sqrt(lane_at_least(q_rho * q_rho + zeta * zeta, 1e-60)), inverse = 1 / r;
    const LaneMask before_arc = q_rho * g->sine + zeta * g->cosine <= zero;
    LaneProfile p = {g->radius - r, -q_rho * inverse, -zeta * inverse, -inverse};
    /* inside the body the nearest of what can be seen from there */
    const Lane deep = rho - (s->radius + g->depth), over_rim = zeta - s->half_width;
    const LaneMask inside = (p.distance < zero) | ~before_arc;
    profile_edge(&p, inside & (deep > p.distance), deep, one, zero);
    profile_edge(&p, inside & (over_rim > p.distance), over_rim, zero, one);
    profile_outside(&p, ~before_arc, s, g, rho, zeta);
    return p;
}

/* Probe of a grooved shape: its profile, revolved (GR5). A function of its own, and vectors by address, since it is
 * long and called from many places. */
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

#endif
