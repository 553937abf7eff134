#include "core/mesh.h"

#include <stdlib.h>

void mesh_free(Mesh *mesh)
{
    for (int k = 0; k < mesh->n_layers; ++k) free(mesh->layer_name[k]);
    free(mesh->layer_name);
    free(mesh->layer);
    free(mesh->triangle);
    free(mesh->vertex);
    *mesh = (Mesh){0};
}
