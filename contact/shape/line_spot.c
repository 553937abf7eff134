#include "contact/shape/element.h"

/* First and second derivatives of (C2), (C3) by u. */
static void weights_by(const Element *e, double u, LineWeights *w1, LineWeights *w2)
{
    const double v = 1 - u, arc = e->arc;
    *w1 = (LineWeights){.alpha = {-arc * 6 * u * v, arc * 6 * u * v},
                        .beta = {arc * 2 * v * (1 - 3 * u) + e->beta[0][1], arc * 2 * u * (3 * u - 2) + e->beta[1][1]}};
    *w2 = (LineWeights){.alpha = {-arc * (6 - 12 * u), arc * (6 - 12 * u)},
                        .beta = {arc * (12 * u - 8), arc * (12 * u - 4)}};
}

LineSpot line_spot(const Chain *chain, const Kinematics *kin, int e, double u)
{
    const Element element = element_at(GEOMETRY_SMOOTH, chain->n, e);
    LineSpot at = {.body = {element.body[0], element.body[1]}, .weight = element_weights(&element, u)};
    LineWeights w2;
    weights_by(&element, u, &at.weight1, &w2);
    for (int b = 0; b < 2; ++b) {
        const int i = at.body[b];
        if (i < 0 || i >= chain->n) continue;
        const Vec3 x = v3_load(kin->p, i);
        const Vec3 r = v3_scale(chain->half[i], v3_load(kin->a, i));
        at.p = v3_axpy(v3_axpy(at.p, at.weight.alpha[b], x), at.weight.beta[b], r);
        at.p1 = v3_axpy(v3_axpy(at.p1, at.weight1.alpha[b], x), at.weight1.beta[b], r);
        at.p2 = v3_axpy(v3_axpy(at.p2, w2.alpha[b], x), w2.beta[b], r);
        at.radius += at.weight.alpha[b] * chain->radius[i];
        at.radius1 += at.weight1.alpha[b] * chain->radius[i];
    }
    return at;
}

double line_slope(const Chain *chain, const Kinematics *kin, int i, Vec3 p)
{
    if (i < 0) return -1;
    if (i >= chain->n) return 1;
    return (kin->p[0][i] - p.x) * kin->a[0][i] + (kin->p[1][i] - p.y) * kin->a[1][i] +
           (kin->p[2][i] - p.z) * kin->a[2][i];
}

/* What an element's place is made of, without its radius: for a foot, it is looked at many times. */
typedef struct Curve {
    Element element;
    Vec3 x[2], r[2]; /* m: centres, and arms to the front ends; zero where there is no segment */
} Curve;

static Curve curve_of(const Chain *chain, const Kinematics *kin, int e)
{
    Curve c = {.element = element_at(GEOMETRY_SMOOTH, chain->n, e)};
    for (int b = 0; b < 2; ++b) {
        const int i = c.element.body[b];
        if (i < 0 || i >= chain->n) continue;
        c.x[b] = v3_load(kin->p, i);
        c.r[b] = v3_scale(chain->half[i], v3_load(kin->a, i));
    }
    return c;
}

/* A point of it, or a derivative of the point, by its weights. */
static inline Vec3 curve_at(const Curve *c, const LineWeights *w)
{
    const Vec3 one = v3_axpy(v3_scale(w->alpha[0], c->x[0]), w->beta[0], c->r[0]);
    return v3_axpy(v3_axpy(one, w->alpha[1], c->x[1]), w->beta[1], c->r[1]);
}

/* (Q - p).Q' at u, and its derivative. */
static inline double foot_slope(const Curve *c, double u, Vec3 p, double *derivative)
{
    const LineWeights w = element_weights(&c->element, u);
    LineWeights w1, w2;
    weights_by(&c->element, u, &w1, &w2);
    const Vec3 to = v3_sub(curve_at(c, &w), p), along = curve_at(c, &w1);
    *derivative = v3_dot(along, along) + v3_dot(to, curve_at(c, &w2));
    return v3_dot(to, along);
}

/* Newton's method kept inside a shrinking bracket, with bisection where it would leave it. */
double line_foot(const Chain *chain, const Kinematics *kin, int e, Vec3 p, int *inside)
{
    enum { NEWTON = 20, MOST = 80 };
    double derivative;
    const Curve curve = curve_of(chain, kin, e);
    const double first = foot_slope(&curve, 0, p, &derivative);
    const double last = foot_slope(&curve, 1, p, &derivative);
    *inside = first < 0 && last >= 0;
    if (!*inside) return first < 0 ? 1 : 0;
    double low = 0, high = 1, u = first / (first - last);
    for (int i = 0; i < MOST; ++i) {
        const double slope = foot_slope(&curve, u, p, &derivative);
        if (slope < 0) low = u;
        if (slope >= 0) high = u;
        const double newton = u - slope / derivative;
        const double next = i < NEWTON && newton >= low && newton <= high ? newton : (low + high) / 2;
        const double moved = fabs(next - u);
        u = next;
        if (!(moved > 1e-13)) break;
    }
    return u;
}
