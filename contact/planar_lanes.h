/* Contact of LANES elements of a planar line with a circle each: nearest point, motion, force. Letters and numbers as
 * in docs/theory.md, "Contact line" and "Planar chain". */
#ifndef HAWSER_CONTACT_PLANAR_LANES_H
#define HAWSER_CONTACT_PLANAR_LANES_H

#include <math.h>

#include "contact/law_lanes.h"
#include "contact/planar.h"
#include "contact/shape_lanes.h"
#include "core/lanes.h"
#include "core/plane_lanes.h"

/* One of an element's two segments: centre, arm to the front end, velocities, contact radius. */
typedef struct PlanarBody {
    Lane2 x, r, v;
    Lane w, radius;
} PlanarBody;

typedef struct PlanarLine {
    PlanarBody body[2];
    LaneShares shares;
    Lane2 centre;
    Lane circle;
} PlanarLine;

/* A point of the line against its circle. */
typedef struct PlanarPoint {
    LaneWeights weight, weight1;   /* at u, and their first derivatives */
    Lane2 p, p1, p2;               /* from the circle's centre to P; P' and P'', m */
    Lane radius, radius1, radius2; /* rc, rc' and rc'', m */
    Lane rho;                      /* distance from the circle's centre, m */
    Lane2 normal;
    Lane curvature; /* g'' (C10), m */
} PlanarPoint;

LANE_INLINE Lane2 pair_load(const double a[2][LANES]) { return (Lane2){lane_load(a[0]), lane_load(a[1])}; }
LANE_INLINE void pair_store(double a[2][LANES], Lane2 v)
{
    lane_store(a[0], v.x);
    lane_store(a[1], v.z);
}

LANE_INLINE PlanarLine planar_line_load(const PlanarBatch *batch)
{
    PlanarLine line;
    for (int b = 0; b < 2; ++b) {
        line.body[b] = (PlanarBody){pair_load(batch->x[b]), pair_load(batch->r[b]), pair_load(batch->v[b]),
                                    lane_load(batch->w[b]), lane_load(batch->radius[b])};
    }
    line.shares = shares_load(batch->arc, batch->alpha, batch->beta);
    line.centre = pair_load(batch->centre);
    line.circle = lane_load(batch->circle);
    return line;
}

/* sum of alpha_i a_i + beta_i b_i over the two bodies */
LANE_INLINE Lane2 planar_weighted(const LaneWeights *w, Lane2 a0, Lane2 b0, Lane2 a1, Lane2 b1)
{
    return l2_axpy(l2_axpy(l2_axpy(l2_scale(w->alpha[0], a0), w->beta[0], b0), w->alpha[1], a1), w->beta[1], b1);
}

/* P - c, P', P'' and the radius with its derivatives at u: (C1), (C4). */
LANE_INLINE PlanarPoint planar_point_at(const PlanarLine *line, Lane u)
{
    const PlanarBody *j = &line->body[0], *k = &line->body[1];
    PlanarPoint at;
    weights_at(&line->shares, u, &at.weight, &at.weight1);
    const LaneWeights weight2 = weights_second(&line->shares, u);
    at.p = l2_sub(planar_weighted(&at.weight, j->x, j->r, k->x, k->r), line->centre);
    at.p1 = planar_weighted(&at.weight1, j->x, j->r, k->x, k->r);
    at.p2 = planar_weighted(&weight2, j->x, j->r, k->x, k->r);
    const Lane thinner = k->radius - j->radius;
    at.radius = at.weight.alpha[0] * j->radius + at.weight.alpha[1] * k->radius;
    at.radius1 = at.weight1.alpha[1] * thinner;
    at.radius2 = weight2.alpha[1] * thinner;
    return at;
}

/* Distance from the circle's centre; at the centre itself it is positive too, so that nothing is divided by zero. */
LANE_INLINE Lane planar_rho(Lane2 p)
{
    const Lane square = l2_dot(p, p), tiny = lane_set(1e-60);
    return lane_sqrt(lane_select(square > tiny, square, tiny));
}

/* Adds the normal and the curvature of the gap: (C10) with the circle's H = t t^T / rho (PL11). */
LANE_INLINE void planar_point_gap(PlanarPoint *at)
{
    at->rho = planar_rho(at->p);
    const Lane inverse = 1 / at->rho;
    at->normal = l2_scale(inverse, at->p);
    const Lane across = l2_cross(at->normal, at->p1);
    at->curvature = inverse * across * across + l2_dot(at->normal, at->p2) - at->radius2;
}

/* rho g' at the start and at the end of the element; the radius does not change there (C4). */
LANE_INLINE void planar_end_slopes(const PlanarLine *line, Lane *start, Lane *end)
{
    const PlanarBody *j = &line->body[0], *k = &line->body[1];
    const LaneShares *const s = &line->shares;
    const Lane(*const beta)[2] = s->beta;
    const Lane low = s->alpha, high = s->arc + s->alpha, chord = 2 * s->arc;
    const LaneWeights first = {{1 - low, low}, {beta[0][0], beta[1][0]}};
    const LaneWeights last = {{1 - high, high}, {beta[0][0] + beta[0][1], beta[1][0] + beta[1][1]}};
    const Lane2 at_first = l2_sub(planar_weighted(&first, j->x, j->r, k->x, k->r), line->centre);
    const Lane2 at_last = l2_sub(planar_weighted(&last, j->x, j->r, k->x, k->r), line->centre);
    *start = l2_dot(at_first, l2_axpy(l2_scale(beta[0][1] + chord, j->r), beta[1][1], k->r));
    *end = l2_dot(at_last, l2_axpy(l2_scale(beta[0][1], j->r), beta[1][1] + chord, k->r));
}

/* Parameter of the nearest point (C11): Newton between shrinking bounds, bisection where it leaves them. Unlike in
 * space, the root is that of rho g' = (P - c).P' - rho rc': for a straight line it is linear in u, so that the start,
 * which is the secant's, is exact; and only where the radius changes does it need a square root. A lane that has
 * converged is left alone. */
LANE_INLINE Lane planar_nearest(const PlanarLine *line, LaneMask *interior)
{
    enum { NEWTON = 20, MOST = 80 };
    const Lane zero = lane_set(0), one = lane_set(1), close = lane_set(1e-10);
    const unsigned tapers = lane_bits(line->body[0].radius != line->body[1].radius);
    Lane start, end;
    planar_end_slopes(line, &start, &end);
    *interior = (start < zero) & (end >= zero);
    Lane u = lane_select(*interior, start / (start - end), lane_select(start < zero, one, zero));
    Lane low = zero, high = one;
    LaneMask running = *interior;
    for (int i = 0; i < MOST && lane_bits(running); ++i) {
        const PlanarPoint at = planar_point_at(line, u);
        Lane slope = l2_dot(at.p, at.p1), rise = l2_dot(at.p1, at.p1) + l2_dot(at.p, at.p2);
        if (tapers) {
            const Lane rho = planar_rho(at.p);
            rise -= slope / rho * at.radius1 + rho * at.radius2;
            slope -= rho * at.radius1;
        }
        low = lane_select(slope < zero, u, low);
        high = lane_select(slope < zero, high, u);
        const Lane newton = u - slope / rise;
        const LaneMask inside = (newton >= low) & (newton <= high);
        const Lane middle = (low + high) / 2;
        const Lane next = i < NEWTON ? lane_select(inside, newton, middle) : middle;
        const Lane step = next - u;
        const LaneMask moving = running & ((step > close) | (step < -close));
        u = lane_select(running, next, u);
        running = moving;
    }
    return u;
}

/* A contact with its force. */
typedef struct PlanarContact {
    LaneMask interior; /* the minimum is inside the element: the contact moves along it */
    PlanarPoint at;
    Lane2 tangent;   /* J n */
    Lane2 pdot;      /* velocity of the line's material at P, m/s */
    Lane omega;      /* angular velocity there, rad/s */
    Lane gap, rate;  /* m, m/s */
    Lane slide;      /* sliding speed along the tangent, m/s (PL11) */
    LaneImpact push; /* normal force (C12) */
    LaneRub rub;     /* phi = mu/v, and by_lean, its derivative over v (C14) */
    Lane drag;       /* T = N phi s, N (PL12) */
    Lane2 force;     /* N */
    Lane2 arm[2];    /* lever of the force about the centres (C15), m */
} PlanarContact;

/* Nearest point, velocities, laws, force (PL11), (PL12). */
LANE_INLINE PlanarContact planar_contact_at(const PlanarBatch *batch, const PlanarLine *line)
{
    const PlanarBody *j = &line->body[0], *k = &line->body[1];
    PlanarContact c;
    c.at = planar_point_at(line, planar_nearest(line, &c.interior));
    planar_point_gap(&c.at);
    const LaneWeights *w = &c.at.weight;
    c.tangent = l2_turn(c.at.normal);
    c.pdot = planar_weighted(w, j->v, l2_scale(j->w, l2_turn(j->r)), k->v, l2_scale(k->w, l2_turn(k->r)));
    c.omega = w->alpha[0] * j->w + w->alpha[1] * k->w;
    c.gap = c.at.rho - line->circle - c.at.radius;
    c.rate = l2_dot(c.at.normal, c.pdot);
    c.slide = l2_dot(c.tangent, c.pdot) - c.at.radius * c.omega;
    c.push = impact_at(batch->impact, c.gap, c.rate, ~(LaneMask){0});
    const LaneFriction law = friction_gather(batch->friction);
    friction_at(&law, batch->friction_scale, lane_abs(c.slide), lane_abs(c.slide), &c.rub);
    c.rub.by_lean += c.rub.by_slide;
    c.drag = c.push.force * c.rub.phi * c.slide;
    c.force = l2_axpy(l2_scale(c.push.force, c.at.normal), -c.drag, c.tangent);
    for (int b = 0; b < 2; ++b) {
        c.arm[b] = l2_axpy(l2_scale(w->beta[b], line->body[b].r), -w->alpha[b] * c.at.radius, c.at.normal);
    }
    return c;
}

#endif
