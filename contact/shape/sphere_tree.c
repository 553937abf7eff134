#include "contact/shape/element.h"

#include <stdlib.h>
#include <string.h>

int sphere_tree_alloc(SphereTree *tree, int n)
{
    /* one leaf an element, filled up to a power of two */
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
