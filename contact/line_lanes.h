/* The contact line of LANES elements at once: its points, and the one nearest to a shape. Derivation and
 * equation numbers: docs/theory.md, "Contact line"; letters as there. */
#ifndef HAWSER_CONTACT_LINE_LANES_H
#define HAWSER_CONTACT_LINE_LANES_H

#include "contact/roller.h"
#include "contact/shape_lanes.h"

/* One of an element's two segments: centre, arm to the front end, velocities, contact radius. */
typedef struct LaneBody {
    Lane3 x, r, v, w;
    Lane radius;
} LaneBody;

/* A batch in lanes. */
typedef struct Line {
    LaneBody body[2];
    LaneShares shares;
    LaneShape shape;
    LaneForm form; /* of shapes other than cylinders */
    ShapeKind kind;
} Line;

/* A point of the line against its shape. */
typedef struct LinePoint {
    LaneWeights weight, weight1; /* at u, and their first derivatives */
    Lane3 p, p1;                 /* P and P', m */
    Lane radius, radius1;        /* rc and rc', m */
    LaneProbe probe;
    Lane slope;     /* g' (C9), m */
    Lane curvature; /* g'' (C10), m */
} LinePoint;

/* Vectors in and out of a batch. */
LANE_INLINE Lane3 batch_vector(const double a[3][LANES])
{
    return (Lane3){lane_load(a[0]), lane_load(a[1]), lane_load(a[2])};
}
LANE_INLINE void batch_vector_store(double a[3][LANES], Lane3 v)
{
    lane_store(a[0], v.x);
    lane_store(a[1], v.y);
    lane_store(a[2], v.z);
}

/* The batch's numbers as lanes; they stay in memory until used. grooved is a constant. */
LANE_INLINE Line line_load(const ContactBatch *batch, int grooved)
{
    Line line;
    for (int b = 0; b < 2; ++b) {
        line.body[b] = (LaneBody){batch_vector(batch->x[b]), batch_vector(batch->r[b]), batch_vector(batch->v[b]),
                                  batch_vector(batch->w[b]), lane_load(batch->radius[b])};
    }
    line.shares = shares_load(batch->arc, batch->alpha, batch->beta);
    line.shape = (LaneShape){batch_vector(batch->centre), batch_vector(batch->axis), lane_load(batch->shape_radius),
                             lane_load(batch->shape_half_width)};
    for (int i = 0; grooved && i < SHAPE_FORM; ++i) line.form.row[i] = lane_load(batch->form[i]);
    line.kind = batch->kind;
    return line;
}

/* sum of alpha_i a_i + beta_i b_i over the two bodies. */
LANE_INLINE Lane3 weighted(const LaneWeights *w, Lane3 a0, Lane3 b0, Lane3 a1, Lane3 b1)
{
    const Lane3 first = l3_axpy(l3_scale(w->alpha[0], a0), w->beta[0], b0);
    return l3_axpy(l3_axpy(first, w->alpha[1], a1), w->beta[1], b1);
}

/* Everything at parameter u: (C1), (C4), (C9), (C10). grooved is a constant. */
LANE_INLINE LinePoint line_at(const Line *line, int grooved, Lane u)
{
    const LaneBody *j = &line->body[0], *k = &line->body[1];
    LinePoint at;
    weights_at(&line->shares, u, &at.weight, &at.weight1);
    const LaneWeights weight2 = weights_second(&line->shares, u);
    at.p = weighted(&at.weight, j->x, j->r, k->x, k->r);
    at.p1 = weighted(&at.weight1, j->x, j->r, k->x, k->r);
    const Lane3 p2 = weighted(&weight2, j->x, j->r, k->x, k->r);
    at.radius = at.weight.alpha[0] * j->radius + at.weight.alpha[1] * k->radius;
    at.radius1 = at.weight1.alpha[1] * (k->radius - j->radius);
    const Lane radius2 = weight2.alpha[1] * (k->radius - j->radius);
    if (grooved && line->kind != SHAPE_CYLINDER) {
        shape_by_kind(line->kind, &line->shape, &line->form, &at.p, &at.probe);
    } else {
        at.probe = shape_cylinder(&line->shape, at.p);
    }
    at.slope = (grooved ? shape_slope(line->kind, &line->shape, &line->form, at.p, &at.probe, at.p1)
                        : l3_dot(at.probe.normal, at.p1)) -
               at.radius1;
    at.curvature = l3_dot(at.p1, probe_hessian_times(&at.probe, at.p1)) + l3_dot(at.probe.normal, p2) - radius2;
    return at;
}

/* Parameter of the element's point nearest to the shape (C11). The slope is negative at `low` and not at
 * `high`, always; Newton's step where it stays between them, bisection where not. The start is exact for a
 * straight line on a cylinder's lateral surface. A lane that has converged is left alone, so that it does not
 * depend on its neighbours. */
LANE_INLINE Lane line_nearest(const Line *line, int grooved, LaneMask *interior)
{
    enum { NEWTON = 20, MOST = 80 };
    const Lane zero = lane_set(0), one = lane_set(1), close = lane_set(1e-10);
    const LinePoint start = line_at(line, grooved, zero), end = line_at(line, grooved, one);
    /* where the sign does not change the point is clamped: to the end where the gap is least */
    *interior = (start.slope < zero) & (end.slope >= zero);
    const Lane s0 = start.probe.scale * start.slope, s1 = end.probe.scale * end.slope;
    Lane u = lane_select(*interior, s0 / (s0 - s1), lane_select(start.slope < zero, one, zero));

    /* the root stays in [low, high], which shrinks at every step */
    Lane low = zero, high = one;
    LaneMask running = *interior;
    for (int i = 0; i < MOST && lane_any(running); ++i) {
        const LinePoint at = line_at(line, grooved, u);
        low = lane_select(at.slope < zero, u, low);
        high = lane_select(at.slope < zero, high, u);
        const Lane newton = u - at.slope / at.curvature;
        LaneMask inside = (newton >= low) & (newton <= high);
        /* before a concave wall the gap may have a maximum between two minima, which is not a contact (GR7) */
        if (grooved) inside &= at.curvature > zero;
        const Lane middle = (low + high) / 2;
        const Lane next = i < NEWTON ? lane_select(inside, newton, middle) : middle;
        const LaneMask moving = running & (lane_abs(next - u) > close);
        u = lane_select(running, next, u);
        running = moving;
    }
    return u;
}

#endif
