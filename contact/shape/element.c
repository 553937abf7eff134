/* The scalar side of the contact line: numbering, points, spheres. The kernels hold the same weights in lanes
 * (line_lanes.h); tests compare the two. */
#include "contact/shape/element.h"

#include <assert.h>

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

/* alpha_1 (C2), (C3). */
static double element_alpha(const Element *element, double u)
{
    return element->arc * u * u * (3 - 2 * u) + element->alpha;
}

/* Whether `body` is a segment at all: an element at an end has only one. */
static int carries(const Chain *chain, int body) { return body >= 0 && body < chain->n; }
/* r_i: from the centre of segment i to its front end. */
static Vec3 body_arm(const Chain *chain, const Kinematics *kin, int i)
{
    return v3_scale(chain->half[i], v3_load(kin->a, i));
}

/* (C1), term by term: missing bodies have no weight. */
Vec3 element_point(const Element *element, const Chain *chain, const Kinematics *kin, double u)
{
    const double alpha = element_alpha(element, u);
    const double weight[2] = {1 - alpha, alpha};
    const double arc[2] = {element->arc * 2 * u * (1 - u) * (1 - u), -element->arc * 2 * u * u * (1 - u)};
    Vec3 p = v3(0, 0, 0);
    for (int b = 0; b < 2; ++b) {
        const int i = element->body[b];
        if (!carries(chain, i)) continue;
        p = v3_axpy(p, weight[b], v3_load(kin->p, i));
        p = v3_axpy(p, arc[b] + element->beta[b][0] + element->beta[b][1] * u, body_arm(chain, kin, i));
    }
    return p;
}

/* (C4). */
double element_radius(const Element *element, const Chain *chain, double u)
{
    const double alpha = element_alpha(element, u);
    double radius = 0;
    if (carries(chain, element->body[0])) radius += (1 - alpha) * chain->radius[element->body[0]];
    if (carries(chain, element->body[1])) radius += alpha * chain->radius[element->body[1]];
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
