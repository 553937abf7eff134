#include "core/mesh.h"

#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "core/vec3.h"

void mesh_free(Mesh *mesh)
{
    for (int k = 0; k < mesh->n_layers; ++k) free(mesh->layer_name[k]);
    free(mesh->layer_name);
    free(mesh->layer);
    free(mesh->triangle);
    free(mesh->vertex);
    *mesh = (Mesh){0};
}

static Vec3 vertex_at(const Mesh *m, int v) { return v3(m->vertex[v][0], m->vertex[v][1], m->vertex[v][2]); }

/* Twice the area of the triangle a, b, c, as a vector outward. */
static Vec3 doubled(const Mesh *m, int a, int b, int c)
{
    const Vec3 from = vertex_at(m, a);
    return v3_cross(v3_sub(vertex_at(m, b), from), v3_sub(vertex_at(m, c), from));
}

static Vec3 doubled_of(const Mesh *m, int t)
{
    return doubled(m, m->triangle[t][0], m->triangle[t][1], m->triangle[t][2]);
}

double mesh_area(const Mesh *mesh)
{
    double sum = 0;
    for (int t = 0; t < mesh->n_triangles; ++t) sum += v3_norm(doubled_of(mesh, t));
    return sum / 2;
}

/* The first vertex is the origin: a model far from the world's loses no digits. */
double mesh_volume(const Mesh *mesh)
{
    double sum = 0;
    for (int t = 0; t < mesh->n_triangles; ++t)
        sum += v3_dot(doubled_of(mesh, t), v3_sub(vertex_at(mesh, mesh->triangle[t][0]), vertex_at(mesh, 0)));
    return sum / 6;
}

/* ---------------------------------------------------------------------------------------------------- building */

/* Makes space for one more item of an array, which has space for a power of two. 0: no memory. */
static int widen(void *array, int n, size_t size)
{
    void **const list = array;
    if (n >= MESH_MOST) return 0;
    if ((n & (n - 1)) != 0) return 1;
    void *const wider = realloc(*list, (n ? 2 * (size_t)n : 1) * size);
    if (wider) *list = wider;
    return wider != NULL;
}

/* FNV-1a over words of 8 bytes, mixed so that the low bits depend on all. */
static uint64_t hash_of(const void *bytes, size_t size)
{
    uint64_t h = 0xCBF29CE484222325u;
    for (size_t i = 0; i < size; i += sizeof h) {
        uint64_t word = 0;
        memcpy(&word, (const char *)bytes + i, size - i < sizeof word ? size - i : sizeof word);
        h = (h ^ word) * 0x100000001B3u;
        h ^= h >> 29;
    }
    return h * 0x9E3779B97F4A7C15u >> 20;
}

typedef uint64_t HashAt(const Mesh *m, int i);

static uint64_t vertex_hash(const Mesh *m, int i) { return hash_of(m->vertex[i], sizeof m->vertex[i]); }

static uint64_t name_hash(const Mesh *m, int i) { return hash_of(m->layer_name[i], strlen(m->layer_name[i])); }

/* Doubles a table that is half full. 0: no memory. */
static int table_widen(int **table, size_t *size, int n, const Mesh *m, HashAt *hash)
{
    if (2 * (size_t)n < *size) return 1;
    const size_t wider = *size ? 2 * *size : 64;
    int *const slots = calloc(wider, sizeof *slots);
    if (!slots) return 0;
    for (int i = 0; i < n; ++i) {
        size_t k = hash(m, i) & (wider - 1);
        while (slots[k]) k = (k + 1) & (wider - 1);
        slots[k] = i + 1;
    }
    free(*table);
    *table = slots;
    *size = wider;
    return 1;
}

int mesh_add_vertex(MeshBuild *build, const double at[3])
{
    Mesh *const m = &build->mesh;
    const double own[3] = {at[0] + 0.0, at[1] + 0.0, at[2] + 0.0}; /* -0 is 0 */
    if (!table_widen(&build->slot, &build->n_slots, m->n_vertices, m, vertex_hash)) return -1;
    size_t k = hash_of(own, sizeof own) & (build->n_slots - 1);
    for (; build->slot[k]; k = (k + 1) & (build->n_slots - 1))
        if (!memcmp(m->vertex[build->slot[k] - 1], own, sizeof own)) return build->slot[k] - 1;
    if (!widen(&m->vertex, m->n_vertices, sizeof *m->vertex)) return -1;
    memcpy(m->vertex[m->n_vertices], own, sizeof own);
    build->slot[k] = ++m->n_vertices;
    return m->n_vertices - 1;
}

int mesh_append_layer(Mesh *mesh, const char *name)
{
    char *const own = widen(&mesh->layer_name, mesh->n_layers, sizeof *mesh->layer_name) ? strdup(name) : NULL;
    if (own) mesh->layer_name[mesh->n_layers++] = own;
    return own != NULL;
}

int mesh_add_layer(MeshBuild *build, const char *name)
{
    Mesh *const m = &build->mesh;
    if (!table_widen(&build->name, &build->n_names, m->n_layers, m, name_hash)) return -1;
    size_t k = hash_of(name, strlen(name)) & (build->n_names - 1);
    for (; build->name[k]; k = (k + 1) & (build->n_names - 1))
        if (!strcmp(m->layer_name[build->name[k] - 1], name)) return build->name[k] - 1;
    if (!mesh_append_layer(m, name)) return -1;
    build->name[k] = m->n_layers;
    return m->n_layers - 1;
}

int mesh_add_triangle(MeshBuild *build, int a, int b, int c, int layer)
{
    Mesh *const m = &build->mesh;
    if (!(a == b && b == c) && !(v3_norm(doubled(m, a, b, c)) > 0)) return 0;
    if (!widen(&m->triangle, m->n_triangles, sizeof *m->triangle) ||
        !widen(&m->layer, m->n_triangles, sizeof *m->layer))
        return -1;
    memcpy(m->triangle[m->n_triangles], (int[3]){a, b, c}, sizeof *m->triangle);
    m->layer[m->n_triangles++] = layer;
    return 1;
}

int mesh_add_polygon(MeshBuild *build, int n, const int corner[], int layer)
{
    const Mesh *const m = &build->mesh;
    Vec3 whole = V3_ZERO;
    int added = 0;
    for (int i = 2; i < n; ++i) whole = v3_add(whole, doubled(m, corner[0], corner[i - 1], corner[i]));
    if (!(v3_norm(whole) > 0)) return 0;
    const double least = -1e-9 * v3_dot(whole, whole);
    for (int from = 0; from < n; ++from) {
        int sees = 1;
        for (int i = 2; i < n && sees; ++i)
            sees = v3_dot(doubled(m, corner[from], corner[(from + i - 1) % n], corner[(from + i) % n]), whole) >= least;
        for (int i = 2; i < n && sees && added >= 0; ++i)
            added = mesh_add_triangle(build, corner[from], corner[(from + i - 1) % n], corner[(from + i) % n], layer);
        if (sees) return added < 0 ? -1 : 1;
    }
    return -2;
}

void mesh_build_end(MeshBuild *build)
{
    free(build->slot);
    free(build->name);
    build->slot = build->name = NULL;
    build->n_slots = build->n_names = 0;
}
