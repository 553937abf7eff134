/* Meshes of known shapes for tests. */
#ifndef HAWSER_TESTS_SUPPORT_TESSELLATED_H
#define HAWSER_TESTS_SUPPORT_TESSELLATED_H

#include "core/mesh.h"
#include "core/vec3.h"

/* A point of a surface by two numbers from 0 to 1; the outside is where d/du x d/dv points. */
typedef Vec3 (*Parametric)(const void *of, double u, double v);

/* Adds rows x columns cells of two triangles with corners on the surface. */
void mesh_grid(MeshBuild *m, const char *layer, Parametric at, const void *of, int rows, int columns);

/* A tube of this radius about x from 0 to `length`, seen from inside, with `facets` of widths that differ by up to
 * (1 + uneven)/(1 - uneven); a duct from `length` over a bend of this radius and angle in the xy plane if radius > 0.
 */
typedef struct TubeShape {
    double radius, length;
    int facets;
    double uneven;
    double bend, angle; /* m, rad; 0: it ends before */
} TubeShape;

void mesh_tube(MeshBuild *m, const TubeShape *tube, int rows);

/* A box, closed. */
void mesh_box(MeshBuild *m, const char *layer, Vec3 low, Vec3 high);

/* Frees both. */
void mesh_done(MeshBuild *m);

#endif
