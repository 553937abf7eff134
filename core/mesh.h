/* Triangles of a model, with the layer of each. */
#ifndef HAWSER_CORE_MESH_H
#define HAWSER_CORE_MESH_H

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

#endif
