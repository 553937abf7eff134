/* The integrals run over the pressed part of the piece, where the integrand is a polynomial of degree 4 at most: three
 * Gauss points give them exactly, without the cancellation of closed forms in the limits. */
#include "contact/self/patch.h"

enum { POINTS = 3 };

/* Points and weights on [0, 1]. */
static const double AT[POINTS] = {0.11270166537925831, 0.5, 0.88729833462074169};
static const double WEIGHT[POINTS] = {5.0 / 18, 8.0 / 18, 5.0 / 18};

/* The part of [0, 1] where |w| < R (CC4): between the roots of a xi^2 + 2 b xi + c. Returns 0 if there is none. */
static int pressed_part(Patch *p)
{
    const Vec3 along = v3_sub(p->w[1], p->w[0]);
    const double a = v3_dot(along, along), b = v3_dot(p->w[0], along);
    const double c = v3_dot(p->w[0], p->w[0]) - p->radius * p->radius;
    p->from = 0;
    p->to = 1;
    /* parallel to rounding: pressed everywhere or nowhere */
    if (a <= 1e-24 * p->radius * p->radius) return c < 0;
    const double root = b * b - a * c;
    if (!(root > 0)) return 0;
    /* the root that adds up first, the other from their product */
    const double sum = b >= 0 ? -b - sqrt(root) : -b + sqrt(root);
    const double one = sum / a, other = sum != 0 ? c / sum : 0;
    p->from = fmax(0, fmin(one, other));
    p->to = fmin(1, fmax(one, other));
    return p->from < p->to;
}

/* Separation at xi. */
static Vec3 separation(const Vec3 w[2], double xi) { return v3_axpy(v3_scale(1 - xi, w[0]), xi, w[1]); }

int bed_integrate(Patch *p, const PatchLaw *law)
{
    if (!pressed_part(p)) return 0;
    p->modulus = law->bed * p->length / (p->radius * sqrt(p->radius));
    for (int k = 0; k < POINTS; ++k) {
        const double xi = p->from + (p->to - p->from) * AT[k];
        const Vec3 w = separation(p->w, xi);
        const double q = (p->radius * p->radius - v3_dot(w, w)) / (2 * p->radius);
        const double share = WEIGHT[k] * (p->to - p->from) * q;
        p->m0 += share;
        p->m1 += share * xi;
        p->energy += p->modulus * p->radius / 2 * share * q;
        p->g[0] = v3_axpy(p->g[0], p->modulus * share * (1 - xi), w);
        p->g[1] = v3_axpy(p->g[1], p->modulus * share * xi, w);
    }
    if (!(p->m0 > 1e-30)) return 0;
    p->centre = p->m1 / p->m0;
    p->elastic = v3_norm(v3_add(p->g[0], p->g[1]));
    return p->elastic > 0;
}

/* The limits move too, but q is zero there, or they are the piece's own ends: nothing comes from them. */
void bed_vary(const Patch *p, const Vec3 w_by[2], double radius_by, Vec3 g_by[2], double *m0_by, double *m1_by)
{
    const double stretch = -1.5 * radius_by / p->radius; /* of the modulus */
    *m0_by = *m1_by = 0;
    for (int a = 0; a < 2; ++a) g_by[a] = v3_scale(stretch, p->g[a]);
    for (int k = 0; k < POINTS; ++k) {
        const double xi = p->from + (p->to - p->from) * AT[k], weight = WEIGHT[k] * (p->to - p->from);
        const Vec3 w = separation(p->w, xi), dw = separation(w_by, xi);
        const double ww = v3_dot(w, w), q = (p->radius * p->radius - ww) / (2 * p->radius);
        const double dq = -v3_dot(w, dw) / p->radius + radius_by * (0.5 + ww / (2 * p->radius * p->radius));
        *m0_by += weight * dq;
        *m1_by += weight * dq * xi;
        const Vec3 change = v3_scale(p->modulus * weight, v3_axpy(v3_scale(dq, w), q, dw));
        g_by[0] = v3_axpy(g_by[0], 1 - xi, change);
        g_by[1] = v3_axpy(g_by[1], xi, change);
    }
}
