/* The scalar side of the contact line: numbering, points, spheres. The kernels hold the same weights in lanes
 * (line_lanes.h); tests compare the two. */
#include "contact/shape/element.h"

#include <assert.h>
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

/* Whether `body` is a segment at all: an element at an end has only one. */
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

/* No point of the line moves farther than the largest |dx_i| + |dr_i|. Segments go together, without roots, while the
 * sums of components are within the limit by more than rounding: then so is that. */
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
