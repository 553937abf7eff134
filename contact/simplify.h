/* A mesh of fewer triangles in place of another one, with the distance between the two. docs/theory/98-environment.md.
 */
#ifndef HAWSER_CONTACT_SIMPLIFY_H
#define HAWSER_CONTACT_SIMPLIFY_H

#include "core/mesh.h"
#include "hawser/hawser.h"

/* Checks whether this build can simplify (libmeshoptimizer). */
int mesh_can_simplify(void);
/* Makes a mesh of about `most` triangles and points of the same layers, whose vertices are some of the given ones; each
 * layer keeps its share, and at least a few triangles. A mesh that is small enough is copied. *error, m: the largest
 * distance (EN60) between the two; 0 for a copy; that of a cloud is the one to its nearest point that is kept.
 * mesh_free follows. Errors: INPUT (this build cannot simplify), MEMORY. */
hawser_status mesh_simplify(const Mesh *mesh, int most, Mesh *out, double *error, hawser_error *err);

#endif
