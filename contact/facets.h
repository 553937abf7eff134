/* The surface that a cable touches of a mesh: smooth over the facets by which a round thing was approximated, sharp
 * where its edges are. docs/theory/98-environment.md, "Smooth facets". */
#ifndef HAWSER_CONTACT_FACETS_H
#define HAWSER_CONTACT_FACETS_H

#include "contact/triangles.h"

/* Does not change after it was built: threads may share it. */
typedef struct Facets {
    Mesh mesh;              /* of the layers that can be touched; vertices are borrowed, triangle and layer are owned */
    const int *law;         /* [mesh.n_layers] friction of each layer, borrowed */
    TriangleTree *tree;     /* owned */
    int (*corner)[3];       /* [n_triangles] the normal at each corner */
    double (*normal)[3];    /* [n_normals] unit (EN22) */
    unsigned char *of;      /* [n_triangles] FACET_ bits */
    int n_normals, n_edges; /* n_edges: sides of triangles that are edges */
    double bulge;           /* m: the smooth surface is nowhere farther from its triangles */
} Facets;

/* Bit k, from 0 to 2: the side from corner k to the next one is an edge. */
enum { FACET_EDGES = 7, FACET_ONE_SIDED = 8 };

/* Layers with law -1 are left out. NULL without memory. */
Facets *facets_new(const Mesh *mesh, const int *law);
Facets *facets_free(Facets *facets);

/* A place at which a point touches: its nearest one on a smooth face, or on an edge. */
typedef struct Foot {
    double distance; /* m, > 0 */
    Vec3 normal;     /* unit, toward the point */
    Vec3 gradient;   /* of the distance: nearly the normal (EN24) */
    Mat3 turn;       /* derivative of the normal by the point, 1/m */
    int law;
    int triangle;
    double bend; /* m, of an edge: shift of its curve; 0: straight, or a face */
    Vec3 flat;   /* m from the point: where it would be without the smoothing; tells feet apart */
} Foot;

enum { FEET_MAX = 3 }; /* the nearest ones of a point that are kept: three walls meet in a corner */

/* A triangle's exact distance from a point, work space of facets_feet. */
typedef struct FacetNear {
    int triangle;
    double distance;
    Vec3 at;
} FacetNear;

/* All feet of p below `radius` on the listed triangles, nearest first; returns their number, at most FEET_MAX. The list
 * [n] is that of triangle_tree_near for a place from which p has moved by at most `moved`; work [n]. */
int facets_feet(const Facets *facets, const TriangleNear *list, int n, double moved, Vec3 p, double radius,
                FacetNear *work, Foot out[FEET_MAX]);

#endif
