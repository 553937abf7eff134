#include "def/environment_def.h"

#include <stdlib.h>
#include <string.h>

hawser_status environment_share(EnvironmentDef *e, hawser_error *err)
{
    const Mesh *const all = &e->mesh;
    int n = 0;
    if (all->n_layers == 0) return HAWSER_OK;
    e->users = malloc(sizeof *e->users);
    if (!e->users) return error_memory(err);
    atomic_init(e->users, 1);
    for (int t = 0; t < all->n_triangles; ++t) n += e->clear[all->layer[t]];
    if (n == 0) return HAWSER_OK;
    Mesh *const kept = e->kept = malloc(sizeof *kept); /* the tree's, wherever the definition is moved to */
    if (!kept) return error_memory(err);
    *kept = *all;
    kept->n_triangles = 0;
    kept->triangle = malloc((size_t)n * sizeof *kept->triangle);
    kept->layer = malloc((size_t)n * sizeof *kept->layer);
    if (!kept->triangle || !kept->layer) return error_memory(err);
    for (int t = 0; t < all->n_triangles; ++t) {
        if (!e->clear[all->layer[t]]) continue;
        memcpy(kept->triangle[kept->n_triangles], all->triangle[t], sizeof *all->triangle);
        kept->layer[kept->n_triangles++] = all->layer[t];
    }
    e->tree = triangle_tree_new(kept);
    return e->tree ? HAWSER_OK : error_memory(err);
}

EnvironmentDef environment_copy(const EnvironmentDef *e)
{
    if (e->users) atomic_fetch_add(e->users, 1);
    return *e;
}

void environment_clear(EnvironmentDef *e)
{
    if (!e->users || atomic_fetch_sub(e->users, 1) == 1) {
        triangle_tree_free(e->tree);
        if (e->kept) free(e->kept->triangle);
        if (e->kept) free(e->kept->layer);
        free(e->kept);
        mesh_free(&e->mesh);
        free(e->friction);
        free(e->clear);
        free(e->users);
    }
    *e = (EnvironmentDef){0};
}
