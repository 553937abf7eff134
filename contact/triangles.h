/* Distances to the triangles of a mesh. docs/theory/98-environment.md. */
#ifndef HAWSER_CONTACT_TRIANGLES_H
#define HAWSER_CONTACT_TRIANGLES_H

#include "core/mesh.h"
#include "core/vec3.h"

/* A binary tree of boxes over the triangles of a mesh. It does not change after it was built, so threads may share it.
 * Points of a cloud (core/mesh.h) are in it as well. */
typedef struct TriangleTree TriangleTree;

/* Builds the tree; the mesh is borrowed and must not change. NULL without memory. */
TriangleTree *triangle_tree_new(const Mesh *mesh);
TriangleTree *triangle_tree_free(TriangleTree *tree);
/* Least distance of the segment from a to b (m, world; a equal to b: a point) from the mesh (EN20), or `bound` if it is
 * not below. *triangle: the nearest one, -1 if none is within the bound; foot: its nearest point, unchanged then. Both
 * may be NULL. */
double triangle_tree_distance(const TriangleTree *tree, const double a[3], const double b[3], double bound,
                              int *triangle, double foot[3]);
/* A triangle at a distance, m. */
typedef struct TriangleNear {
    int triangle;
    float distance; /* rounded down */
} TriangleNear;

/* All triangles within `reach` of a point, without those of a cloud, in the order of their distances, behind the *n
 * that *list [*room] holds; grows the list. 0 without memory. */
int triangle_tree_near(const TriangleTree *tree, Vec3 p, double reach, TriangleNear **list, int *n, int *room);
/* Nearest point of one triangle to p. */
Vec3 triangle_nearest(const Mesh *mesh, int triangle, Vec3 p);

#endif
