/* The scalar side of the contact line: numbering, points, spheres. The kernels hold the same weights in lanes
 * (line_lanes.h); tests compare the two. */
#include "contact/shape.h"

#include <assert.h>
#include <stdlib.h>
#include <string.h>

int element_count(ContactGeometry geometry, int n) { return geometry == GEOMETRY_SMOOTH ? n + 1 : n; }

Element element_at(ContactGeometry geometry, int n, int e)
{
    assert(e >= 0 && e < element_count(geometry, n));
    /* capsule (C3): P = x + (2u - 1) r */
    if (geometry == GEOMETRY_CYLINDER) return (Element){.body = {e, -1}, .beta = {{-1, 2}}};
    Element element = {.body = {e - 1, e}};
    if (e == 0) {
        /* tail half: P = x - (1 - u) r, on the second body */
        element.alpha = 1;
        element.beta[1][0] = -1;
        element.beta[1][1] = 1;
    } else if (e == n) {
        /* head half: P = x + u r, on the first body */
        element.beta[0][1] = 1;
    } else {
        element.arc = 1;
    }
    return element;
}

LineWeights element_weights(const Element *e, double u)
{
    const double v = 1 - u, alpha = e->arc * u * u * (3 - 2 * u) + e->alpha;
    return (LineWeights){.alpha = {1 - alpha, alpha},
                         .beta = {e->arc * 2 * u * v * v + e->beta[0][0] + e->beta[0][1] * u,
                                  -e->arc * 2 * u * u * v + e->beta[1][0] + e->beta[1][1] * u}};
}

/* Checks whether `body` is a segment: an element at an end has only one. */
static int carries(const Chain *chain, int body) { return body >= 0 && body < chain->n; }

/* (C4). */
double element_radius(const Element *element, const Chain *chain, double u)
{
    const LineWeights w = element_weights(element, u);
    double radius = 0;
    for (int b = 0; b < 2; ++b) {
        if (carries(chain, element->body[b])) radius += w.alpha[b] * chain->radius[element->body[b]];
    }
    return radius;
}

/* Around the middle of an arc, |P - middle| <= |x_k - x_j|/2 + 8/27 (half_j + half_k), since 8/27 is the
 * largest value of the weights beta; around the centre of a segment for the other elements. */
Sphere element_sphere(const Element *element, const Chain *chain, const Kinematics *kin)
{
    const int j = element->body[0], k = element->body[1];
    if (!carries(chain, j)) return (Sphere){v3_load(kin->p, k), chain->half[k] + chain->radius[k]};
    if (!carries(chain, k)) return (Sphere){v3_load(kin->p, j), chain->half[j] + chain->radius[j]};
    const Vec3 xj = v3_load(kin->p, j), xk = v3_load(kin->p, k);
    const double radius = fmax(chain->radius[j], chain->radius[k]);
    return (Sphere){v3_scale(0.5, v3_add(xj, xk)),
                    v3_norm(v3_sub(xk, xj)) / 2 + 8.0 / 27 * (chain->half[j] + chain->half[k]) + radius};
}

void line_stand(const Kinematics *kin, int n, double *const at_p[3], double *const at_a[3])
{
    for (int c = 0; c < 3; ++c) {
        memcpy(at_p[c], kin->p[c], (size_t)n * sizeof(double));
        memcpy(at_a[c], kin->a[c], (size_t)n * sizeof(double));
    }
}

/* Length of the change of a vector of segment i. */
static double vector_moved(double *const now[3], double *const then[3], int i)
{
    const double x = now[0][i] - then[0][i], y = now[1][i] - then[1][i], z = now[2][i] - then[2][i];
    return sqrt(x * x + y * y + z * z);
}

/* The sum of its components' sizes, which is no less. */
static double vector_moved_most(double *const now[3], double *const then[3], int i)
{
    return fabs(now[0][i] - then[0][i]) + fabs(now[1][i] - then[1][i]) + fabs(now[2][i] - then[2][i]);
}

enum { MOVED_TOGETHER = 64 };

/* No point of the line moves farther than the largest |dx_i| + |dr_i|. Segments are checked together, without roots,
 * while the sums of components are within the limit by more than rounding: then the lengths are too. */
int line_moved(const Chain *chain, const Kinematics *kin, double *const at_p[3], double *const at_a[3], double limit)
{
    const double safe = (1 - 1e-12) * limit;
    for (int from = 0; from < chain->n; from += MOVED_TOGETHER) {
        const int to = from + MOVED_TOGETHER < chain->n ? from + MOVED_TOGETHER : chain->n;
        int near = 1, far = 0;
        for (int i = from; i < to; ++i) {
            const double most =
                vector_moved_most(kin->p, at_p, i) + chain->half[i] * vector_moved_most(kin->a, at_a, i);
            near &= most <= safe;
        }
        for (int i = from; !near && i < to; ++i) {
            const double moved = vector_moved(kin->p, at_p, i) + chain->half[i] * vector_moved(kin->a, at_a, i);
            far |= !(moved <= limit); /* a NaN counts as far */
        }
        if (far) return 1;
    }
    return 0;
}

int sphere_tree_alloc(SphereTree *tree, int n)
{
    /* one leaf per element, padded to a power of two */
    tree->leaves = 1;
    while (tree->leaves < n + 1) tree->leaves *= 2;
    tree->node = malloc(2 * (size_t)tree->leaves * sizeof *tree->node);
    return tree->node != NULL;
}

void sphere_tree_free(SphereTree *tree)
{
    free(tree->node);
    memset(tree, 0, sizeof *tree);
}

/* The smallest sphere around two spheres; a negative radius marks an empty one. */
static Sphere sphere_around(Sphere a, Sphere b)
{
    if (a.radius < 0) return b;
    if (b.radius < 0) return a;
    const Vec3 between = v3_sub(b.centre, a.centre);
    const double distance = v3_norm(between);
    /* one inside the other */
    if (distance + b.radius <= a.radius) return a;
    if (distance + a.radius <= b.radius) return b;
    /* else it spans from the far side of one to the far side of the other */
    const double radius = (distance + a.radius + b.radius) / 2;
    return (Sphere){v3_axpy(a.centre, (radius - a.radius) / distance, between), radius};
}

/* Leaves are the elements' spheres; a node holds its two children (C19). */
void sphere_tree_build(SphereTree *tree, ContactGeometry geometry, const Chain *chain, const Kinematics *kin)
{
    const int elements = element_count(geometry, chain->n);
    for (int e = 0; e < tree->leaves; ++e) {
        Sphere sphere = {.radius = -1};
        if (e < elements) {
            const Element element = element_at(geometry, chain->n, e);
            sphere = element_sphere(&element, chain, kin);
        }
        tree->node[tree->leaves + e] = sphere;
    }
    for (int i = tree->leaves - 1; i > 0; --i) {
        tree->node[i] = sphere_around(tree->node[2 * i], tree->node[2 * i + 1]);
    }
}

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

/* Data of an element's line without its radius: for a foot, it is evaluated many times. */
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
