/* Triangles of a model, with the layer of each. */
#ifndef HAWSER_CORE_MESH_H
#define HAWSER_CORE_MESH_H

#include <stddef.h>

/* A triangle with three equal corners is a point of a cloud: it has a distance, and no side that could be touched. */
typedef struct Mesh {
    int n_vertices, n_triangles, n_layers;
    double (*vertex)[3]; /* [n_vertices], m, world */
    int (*triangle)[3];  /* [n_triangles], vertices counter-clockwise from outside */
    int *layer;          /* [n_triangles] */
    char **layer_name;   /* [n_layers]: node, IFC name or DXF layer */
} Mesh;

/* Frees the arrays and empties the mesh. */
void mesh_free(Mesh *mesh);
/* Area, m2, and the volume inside, m3, which is that of a closed surface only: (EN1), (EN2). */
double mesh_area(const Mesh *mesh);
double mesh_volume(const Mesh *mesh);

/* A mesh that grows; equal vertices become one. Zeroed: empty. */
enum { MESH_MOST = 20000000 }; /* vertices, and triangles */
typedef struct MeshBuild {
    Mesh mesh;
    int *slot, *name;        /* hash tables of indices + 1, 0: empty: [n_slots] vertices, [n_names] layers */
    size_t n_slots, n_names; /* powers of 2 */
} MeshBuild;

/* Index of the vertex or layer, added if there is none like it. -1: no memory, or more than MESH_MOST. */
int mesh_add_vertex(MeshBuild *build, const double at[3]);
int mesh_add_layer(MeshBuild *build, const char *name);
/* Adds a layer, even if there is one of that name. 0: no memory. */
int mesh_append_layer(Mesh *mesh, const char *name);
/* Adds a triangle: 1; one without an area is left out: 0; -1 as above. Three equal corners are a point of a cloud. */
int mesh_add_triangle(MeshBuild *build, int a, int b, int c, int layer);
/* Adds a plane polygon of n corners as triangles from one of them. Returns 1; 0: no area; -1 as above; -2: no corner
 * sees all others, so that it is left out. */
int mesh_add_polygon(MeshBuild *build, int n, const int corner[], int layer);
/* Frees the tables. The mesh stays. */
void mesh_build_end(MeshBuild *build);

#endif
