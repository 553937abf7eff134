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

/* (e1 x e2), twice the area with the direction outward, and the corner from which e1 and e2 go. */
static Vec3 doubled(const Mesh *m, int t, Vec3 *corner)
{
    const double *const a = m->vertex[m->triangle[t][0]], *const b = m->vertex[m->triangle[t][1]],
                        *const c = m->vertex[m->triangle[t][2]];
    *corner = v3(a[0], a[1], a[2]);
    return v3_cross(v3(b[0] - a[0], b[1] - a[1], b[2] - a[2]), v3(c[0] - a[0], c[1] - a[1], c[2] - a[2]));
}

double mesh_area(const Mesh *mesh)
{
    double sum = 0;
    Vec3 corner;
    for (int t = 0; t < mesh->n_triangles; ++t) sum += v3_norm(doubled(mesh, t, &corner));
    return sum / 2;
}

double mesh_volume(const Mesh *mesh)
{
    double sum = 0;
    Vec3 corner, origin = V3_ZERO; /* the first vertex: a model far from the origin loses no digits */
    if (mesh->n_vertices > 0) origin = v3(mesh->vertex[0][0], mesh->vertex[0][1], mesh->vertex[0][2]);
    for (int t = 0; t < mesh->n_triangles; ++t) {
        const Vec3 n = doubled(mesh, t, &corner);
        sum += v3_dot(n, v3_sub(corner, origin));
    }
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

int mesh_add_layer(MeshBuild *build, const char *name)
{
    Mesh *const m = &build->mesh;
    if (!table_widen(&build->name, &build->n_names, m->n_layers, m, name_hash)) return -1;
    size_t k = hash_of(name, strlen(name)) & (build->n_names - 1);
    for (; build->name[k]; k = (k + 1) & (build->n_names - 1))
        if (!strcmp(m->layer_name[build->name[k] - 1], name)) return build->name[k] - 1;
    char *const own = widen(&m->layer_name, m->n_layers, sizeof *m->layer_name) ? strdup(name) : NULL;
    if (!own) return -1;
    m->layer_name[m->n_layers] = own;
    build->name[k] = ++m->n_layers;
    return m->n_layers - 1;
}

int mesh_add_triangle(MeshBuild *build, int a, int b, int c, int layer)
{
    Mesh *const m = &build->mesh;
    const int point = a == b && b == c;
    Vec3 corner;
    if (!point && (a == b || b == c || c == a)) return 0;
    if (!widen(&m->triangle, m->n_triangles, sizeof *m->triangle) ||
        !widen(&m->layer, m->n_triangles, sizeof *m->layer))
        return -1;
    memcpy(m->triangle[m->n_triangles], (int[3]){a, b, c}, sizeof *m->triangle);
    if (!point && !(v3_norm(doubled(m, m->n_triangles, &corner)) > 0)) return 0;
    m->layer[m->n_triangles++] = layer;
    return 1;
}

void mesh_build_end(MeshBuild *build)
{
    free(build->slot);
    free(build->name);
    build->slot = build->name = NULL;
    build->n_slots = build->n_names = 0;
}
