/* Simplification by libmeshoptimizer, layer by layer. Its own statement of error is 4 to 24 times too small on real
 * models; the distance is measured here. */
#include "contact/simplify.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "contact/triangles.h"
#include "core/error.h"
#include "core/vec3.h"

#ifdef HAWSER_MESHOPTIMIZER
#include <meshoptimizer.h>

/* Triangles that every layer keeps, if it has them. */
enum { LEAST = 12 };

/* What the layers share: their vertices, numbered anew in each layer. */
typedef struct Thinning {
    const Mesh *mesh;
    double middle[3];
    int *local;                 /* [n_vertices] a layer's number of a vertex, -1: it has none */
    int *global;                /* [n_vertices] the vertex of a layer's number */
    float (*at)[3];             /* [n_vertices] about the middle, by the layer's numbers */
    unsigned *corner, *simpler; /* [3 n_triangles] by the layer's numbers */
    MeshBuild made;
} Thinning;

static int is_point(const int t[3]) { return t[0] == t[1] && t[1] == t[2]; }

static int triangle_put(Thinning *w, int a, int b, int c, int layer)
{
    const double(*const v)[3] = (const double(*)[3])w->mesh->vertex;
    const int corner[3] = {mesh_add_vertex(&w->made, v[a]), mesh_add_vertex(&w->made, v[b]),
                           mesh_add_vertex(&w->made, v[c])};
    return corner[0] >= 0 && corner[1] >= 0 && corner[2] >= 0 &&
           mesh_add_triangle(&w->made, corner[0], corner[1], corner[2], layer) >= 0;
}

static unsigned number_of(Thinning *w, int vertex, int *n)
{
    if (w->local[vertex] < 0) {
        for (int k = 0; k < 3; k++) w->at[*n][k] = (float)(w->mesh->vertex[vertex][k] - w->middle[k]);
        w->global[*n] = vertex;
        w->local[vertex] = (*n)++;
    }
    return (unsigned)w->local[vertex];
}

/* Simplifies the triangles that `order` names, all of one layer, to `share` of them; of its points every so many stays.
 * 0: no memory. */
static int layer_simplify(Thinning *w, int n, const int *order, double share, int layer)
{
    const Mesh *const m = w->mesh;
    size_t count = 0;
    int vertices = 0, points = 0;
    for (int k = 0; k < n; k++) {
        const int *const t = m->triangle[order[k]];
        if (!is_point(t)) {
            for (int j = 0; j < 3; j++) w->corner[count++] = number_of(w, t[j], &vertices);
            continue;
        }
        const int stays = floor(share * (points + 1)) > floor(share * points);
        points++;
        if (stays && !triangle_put(w, t[0], t[0], t[0], layer)) return 0;
    }
    const size_t least = count < 3 * LEAST ? count : 3 * LEAST;
    const size_t goal = 3 * (size_t)(share * (double)(count / 3)), target = goal > least ? goal : least;
    const unsigned *const corner = w->corner;
    size_t left =
        meshopt_simplify(w->simpler, corner, count, w->at[0], (size_t)vertices, sizeof *w->at, target, 1e9F, 0, NULL);
    if (left > target + target / 4) /* many small parts that cannot lose triangles without being joined */
        left = meshopt_simplifySloppy(w->simpler, corner, count, w->at[0], (size_t)vertices, sizeof *w->at, target,
                                      1e9F, NULL);
    int ok = 1;
    for (size_t k = 0; k + 2 < left && ok; k += 3)
        ok = triangle_put(w, w->global[w->simpler[k]], w->global[w->simpler[k + 1]], w->global[w->simpler[k + 2]],
                          layer);
    for (int k = 0; k < vertices; k++) w->local[w->global[k]] = -1;
    return ok;
}

/* Indices of the triangles, sorted by their layers: those of layer i from first[i] on. NULL without memory. */
static int *by_layer(const Mesh *m, int *first)
{
    int *const order = malloc((size_t)m->n_triangles * sizeof *order);
    if (!order) return NULL;
    memset(first, 0, ((size_t)m->n_layers + 2) * sizeof *first);
    for (int i = 0; i < m->n_triangles; i++) first[m->layer[i] + 2]++;
    for (int i = 0; i < m->n_layers; i++) first[i + 2] += first[i + 1];
    for (int i = 0; i < m->n_triangles; i++) order[first[m->layer[i] + 1]++] = i;
    return order;
}

static int all_simplify(Thinning *w, int most)
{
    const Mesh *const m = w->mesh;
    const size_t n = (size_t)m->n_vertices, corners = 3 * (size_t)m->n_triangles;
    int *const first = malloc(((size_t)m->n_layers + 2) * sizeof *first);
    int *const order = first ? by_layer(m, first) : NULL;
    w->local = malloc(n * sizeof *w->local);
    w->global = malloc(n * sizeof *w->global);
    w->at = malloc(n * sizeof *w->at);
    w->corner = malloc(corners * sizeof *w->corner);
    w->simpler = malloc(corners * sizeof *w->simpler);
    int ok = order && w->local && w->global && w->at && w->corner && w->simpler;
    for (size_t i = 0; i < n && ok; i++) {
        w->local[i] = -1;
        for (int k = 0; k < 3; k++) w->middle[k] += m->vertex[i][k] / (double)n;
    }
    const double share = (double)most / m->n_triangles;
    for (int i = 0; i < m->n_layers && ok; i++) {
        ok = mesh_add_layer(&w->made, m->layer_name[i]) == i; /* the names of a mesh differ */
        ok = ok && layer_simplify(w, first[i + 1] - first[i], order + first[i], share, i);
    }
    free(first);
    free(order);
    free(w->local);
    free(w->global);
    free(w->at);
    free(w->corner);
    free(w->simpler);
    mesh_build_end(&w->made);
    return ok;
}

/* (EN60) from the vertices and middles of one mesh's triangles to the other mesh. */
static double farthest(const Mesh *from, const TriangleTree *to)
{
    double most = 0;
    for (int i = 0; i < from->n_triangles; i++) {
        const int *const t = from->triangle[i];
        double middle[3] = {0, 0, 0};
        for (int j = 0; j < 3; j++) {
            const double *const v = from->vertex[t[j]];
            for (int k = 0; k < 3; k++) middle[k] += v[k] / 3;
            most = fmax(most, triangle_tree_distance(to, v, v, INFINITY, NULL, NULL));
        }
        most = fmax(most, triangle_tree_distance(to, middle, middle, INFINITY, NULL, NULL));
    }
    return most;
}

static int error_measure(const Mesh *given, const Mesh *made, double *error)
{
    TriangleTree *to_given = triangle_tree_new(given), *to_made = triangle_tree_new(made);
    const int ok = to_given && to_made;
    if (ok) *error = fmax(farthest(given, to_made), farthest(made, to_given));
    triangle_tree_free(to_given);
    triangle_tree_free(to_made);
    return ok;
}

int mesh_can_simplify(void) { return 1; }

static hawser_status simplify(const Mesh *mesh, int most, Mesh *out, double *error, hawser_error *err)
{
    Thinning w = {.mesh = mesh};
    const int ok = all_simplify(&w, most) && error_measure(mesh, &w.made.mesh, error);
    if (ok) *out = w.made.mesh;
    if (!ok) mesh_free(&w.made.mesh);
    return ok ? HAWSER_OK : error_memory(err);
}
#else
int mesh_can_simplify(void) { return 0; }

static hawser_status simplify(const Mesh *mesh, int most, Mesh *out, double *error, hawser_error *err)
{
    (void)out;
    (void)error;
    return error_set(err, HAWSER_ERR_INPUT,
                     "%d triangles or points, of which this build shows %d: build hawser with "
                     "libmeshoptimizer (libmeshoptimizer-dev)",
                     mesh->n_triangles, most);
}
#endif

/* Returns a copy of an array; NULL without memory. */
static void *copied(const void *from, size_t size)
{
    void *const to = malloc(size + 1);
    if (to) memcpy(to, from, size);
    return to;
}

static hawser_status copy(const Mesh *mesh, Mesh *out, hawser_error *err)
{
    *out = (Mesh){mesh->n_vertices, mesh->n_triangles, 0, NULL, NULL, NULL, NULL};
    out->vertex = copied(mesh->vertex, (size_t)mesh->n_vertices * sizeof *mesh->vertex);
    out->triangle = copied(mesh->triangle, (size_t)mesh->n_triangles * sizeof *mesh->triangle);
    out->layer = copied(mesh->layer, (size_t)mesh->n_triangles * sizeof *mesh->layer);
    out->layer_name = calloc((size_t)mesh->n_layers + 1, sizeof *out->layer_name);
    int ok = out->vertex && out->triangle && out->layer && out->layer_name;
    for (; ok && out->n_layers < mesh->n_layers; out->n_layers++)
        ok = (out->layer_name[out->n_layers] = strdup(mesh->layer_name[out->n_layers])) != NULL;
    if (ok) return HAWSER_OK;
    mesh_free(out);
    return error_memory(err);
}

hawser_status mesh_simplify(const Mesh *mesh, int most, Mesh *out, double *error, hawser_error *err)
{
    *out = (Mesh){0};
    *error = 0;
    return mesh->n_triangles <= most ? copy(mesh, out, err) : simplify(mesh, most, out, error, err);
}
