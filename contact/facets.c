/* Smooth faces and edges over the triangles of a mesh, and the places at which a point touches them.
 * docs/theory/98-environment.md, "Smooth facets". */
#include "contact/facets.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

/* ------------------------------------------------------------------------------------------------------ building */

static const double SHARP = 0.766044443118978; /* cosine of 40 degrees: facets at a larger angle meet at an edge */
static const double FLAT = 0.9999619230641713; /* cosine of half a degree: facets are smooth, whatever their widths */
static const double UNEVEN = 3;                /* facets whose widths differ by more do not approximate one arc */

/* A mesh being prepared. A side has the number 3 t + k: of triangle t, from corner k to the next one. */
typedef struct Sides {
    Facets *facets;
    int n;              /* 3 n_triangles */
    int *mate;          /* [n] the other triangle's side; ALONE; SHARED by three triangles or more */
    int *root;          /* [n] a forest over corners, numbered as the sides that leave them */
    int *queue;         /* [n_triangles] */
    char *turned;       /* [n_triangles] corners are to change their order; -1: not known yet */
    int *slot;          /* [slots] a hash table of sides + 1 */
    signed char *way;   /* [slots] sides there that run to the higher corner less those that run to the lower one */
    unsigned int slots; /* a power of two */
} Sides;

enum { ALONE = -1, SHARED = -2 };

static int side_next(int side) { return side % 3 == 2 ? side - 2 : side + 1; }

static int corner_at(const Sides *s, int side) { return s->facets->mesh.triangle[side / 3][side % 3]; }

static Vec3 corner_place(const Mesh *mesh, int triangle, int k)
{
    return v3_get(mesh->vertex[mesh->triangle[triangle][k]]);
}

/* Twice the area, along the triangle's outside. */
static Vec3 area_of(const Mesh *mesh, int triangle)
{
    const Vec3 a = corner_place(mesh, triangle, 0);
    return v3_cross(v3_sub(corner_place(mesh, triangle, 1), a), v3_sub(corner_place(mesh, triangle, 2), a));
}

/* The place in the table of the side's two corners, in either order. */
static unsigned int side_slot(const Sides *s, int side)
{
    const int a = corner_at(s, side), b = corner_at(s, side_next(side));
    const int low = a < b ? a : b, high = a < b ? b : a;
    unsigned int at = ((unsigned int)low * 2654435761u) ^ ((unsigned int)high * 2246822519u);
    for (at = (at ^ at >> 15) & (s->slots - 1); s->slot[at]; at = (at + 1) & (s->slots - 1)) {
        const int p = corner_at(s, s->slot[at] - 1), q = corner_at(s, side_next(s->slot[at] - 1));
        if ((p < q ? p : q) == low && (p < q ? q : p) == high) break;
    }
    return at;
}

/* Pairs the sides that have the same two corners. */
static void mates_find(Sides *s)
{
    memset(s->slot, 0, s->slots * sizeof *s->slot);
    memset(s->way, 0, s->slots);
    for (int side = 0; side < s->n; ++side) {
        const unsigned int at = side_slot(s, side);
        s->way[at] = (signed char)(s->way[at] + (corner_at(s, side) < corner_at(s, side_next(side)) ? 1 : -1));
        s->mate[side] = ALONE;
        if (!s->slot[at]) {
            s->slot[at] = side + 1;
            continue;
        }
        const int first = s->slot[at] - 1, second = s->mate[first];
        if (second == ALONE) {
            s->mate[first] = side;
            s->mate[side] = first;
            continue;
        }
        if (second >= 0) s->mate[second] = SHARED;
        s->mate[first] = s->mate[side] = SHARED;
    }
}

/* Triangles that go the same way round run along their common side in opposite directions. */
static int sides_agree(const Sides *s, int side)
{
    return corner_at(s, side) == corner_at(s, side_next(s->mate[side]));
}

/* Turns the triangles of a connected piece over until neighbours agree. A piece along whose every side as many
 * triangles run one way as the other, as given, is the skin of a solid, which is touched from outside only; all others
 * are sheets. */
static void piece_orient(Sides *s, int from)
{
    int n = 0, solid = 1;
    s->queue[n++] = from;
    s->turned[from] = 0;
    for (int i = 0; i < n; ++i) {
        for (int k = 0; k < 3; ++k) {
            const int side = 3 * s->queue[i] + k, mate = s->mate[side];
            solid &= s->way[side_slot(s, side)] == 0;
            if (mate < 0 || s->turned[mate / 3] >= 0) continue;
            s->turned[mate / 3] = (char)(s->turned[side / 3] ^ !sides_agree(s, side));
            s->queue[n++] = mate / 3;
        }
    }
    for (int i = 0; i < n && solid; ++i) s->facets->of[s->queue[i]] |= FACET_ONE_SIDED;
}

static void triangles_orient(Sides *s)
{
    Mesh *const mesh = &s->facets->mesh;
    memset(s->turned, -1, (size_t)mesh->n_triangles);
    for (int t = 0; t < mesh->n_triangles; ++t) {
        if (s->turned[t] < 0) piece_orient(s, t);
    }
    for (int t = 0; t < mesh->n_triangles; ++t) {
        if (!s->turned[t]) continue;
        const int corner = mesh->triangle[t][1];
        mesh->triangle[t][1] = mesh->triangle[t][2];
        mesh->triangle[t][2] = corner;
    }
}

/* Whether the surface is smooth across a side. */
static int side_smooth(const Sides *s, int side)
{
    const Mesh *const mesh = &s->facets->mesh;
    const int mate = s->mate[side];
    if (mate < 0 || !sides_agree(s, side)) return 0;
    const int a = side / 3, b = mate / 3;
    if (s->facets->law[mesh->layer[a]] != s->facets->law[mesh->layer[b]]) return 0;
    const Vec3 p = area_of(mesh, a), q = area_of(mesh, b);
    const double pp = v3_norm(p), qq = v3_norm(q), cosine = v3_dot(p, q);
    if (!(cosine > SHARP * pp * qq)) return 0;
    /* the widths across their common side are as the areas */
    return cosine > FLAT * pp * qq || (pp < UNEVEN * qq && qq < UNEVEN * pp);
}

static int root_of(int *root, int i)
{
    while (root[i] != i) i = root[i] = root[root[i]];
    return i;
}

static void corners_join(Sides *s, int a, int b)
{
    const int p = root_of(s->root, a), q = root_of(s->root, b);
    s->root[p > q ? p : q] = p > q ? q : p;
}

/* Corners around a vertex that are connected by smooth sides have one normal. */
static int normals_number(Sides *s)
{
    Facets *const f = s->facets;
    for (int i = 0; i < s->n; ++i) s->root[i] = i;
    for (int side = 0; side < s->n; ++side) {
        if (!side_smooth(s, side)) {
            f->of[side / 3] |= (unsigned char)(1 << side % 3);
            ++f->n_edges;
            continue;
        }
        corners_join(s, side, side_next(s->mate[side]));
        corners_join(s, side_next(side), s->mate[side]);
    }
    int *const number = s->mate; /* is not needed any more */
    for (int i = 0; i < s->n; ++i) {
        const int root = root_of(s->root, i); /* not behind i */
        number[i] = root == i ? f->n_normals++ : number[root];
        f->corner[i / 3][i % 3] = number[i];
    }
    f->normal = calloc((size_t)f->n_normals + 1, sizeof *f->normal);
    return f->normal != NULL;
}

/* (EN22) */
static void normals_mean(Facets *f)
{
    for (int t = 0; t < f->mesh.n_triangles; ++t) {
        const Vec3 area = area_of(&f->mesh, t);
        for (int k = 0; k < 3; ++k) {
            const Vec3 at = corner_place(&f->mesh, t, k);
            const Vec3 e = v3_sub(corner_place(&f->mesh, t, (k + 1) % 3), at);
            const Vec3 d = v3_sub(corner_place(&f->mesh, t, (k + 2) % 3), at);
            const double weight = 1 / (v3_dot(e, e) * v3_dot(d, d));
            double *const normal = f->normal[f->corner[t][k]];
            if (weight < INFINITY) v3_put(normal, v3_axpy(v3_get(normal), weight, area));
        }
    }
    for (int i = 0; i < f->n_normals; ++i) v3_put(f->normal[i], v3_unit(v3_get(f->normal[i])));
}

static const double APART = 1e-5; /* m: corners and faces that are nearer to each other meet */

/* A hash table of vertices by cells of twice that size. */
typedef struct Weld {
    const Mesh *mesh;
    int *slot;          /* [slots] vertices + 1 */
    unsigned int slots; /* a power of two */
} Weld;

static unsigned int cell_slot(const Weld *w, const double at[3])
{
    uint64_t mixed = 0;
    for (int c = 0; c < 3; ++c) mixed = (mixed ^ (uint64_t)(int64_t)at[c]) * 0x9E3779B97F4A7C15u;
    return (unsigned int)(mixed >> 32) & (w->slots - 1);
}

/* The first vertex within APART of this one, which is in one of the eight cells around it; itself if there is none. */
static int vertex_weld(Weld *w, int vertex)
{
    const double *const p = w->mesh->vertex[vertex];
    double cell[3], own[3];
    for (int c = 0; c < 3; ++c) {
        own[c] = floor(p[c] / (2 * APART));
        cell[c] = floor(p[c] / (2 * APART) - 0.5);
    }
    for (int k = 0; k < 8; ++k) {
        const double at[3] = {cell[0] + (k & 1), cell[1] + (k >> 1 & 1), cell[2] + (k >> 2)};
        for (unsigned int i = cell_slot(w, at); w->slot[i]; i = (i + 1) & (w->slots - 1)) {
            const int other = w->slot[i] - 1;
            if (v3_norm(v3_sub(v3_get(w->mesh->vertex[other]), v3_get(p))) <= APART) return other;
        }
    }
    unsigned int i = cell_slot(w, own);
    while (w->slot[i]) i = (i + 1) & (w->slots - 1);
    w->slot[i] = vertex + 1;
    return vertex;
}

/* Copies the triangles that can be touched, with corners that meet made one. */
static int touched_copy(const Mesh *mesh, Facets *f)
{
    Mesh *const m = &f->mesh;
    Weld weld = {mesh, NULL, 16};
    while (weld.slots < 2 * (unsigned int)mesh->n_vertices) weld.slots *= 2;
    weld.slot = calloc(weld.slots, sizeof *weld.slot);
    int *const now = calloc((size_t)mesh->n_vertices + 1, sizeof *now); /* + 1; 0: not needed yet */
    m->triangle = malloc(((size_t)mesh->n_triangles + 1) * sizeof *m->triangle);
    m->layer = malloc(((size_t)mesh->n_triangles + 1) * sizeof *m->layer);
    const int ok = weld.slot && now && m->triangle && m->layer;
    for (int t = 0; t < mesh->n_triangles && ok; ++t) {
        int *const to = m->triangle[m->n_triangles];
        if (f->law[mesh->layer[t]] < 0) continue;
        for (int k = 0; k < 3; ++k) {
            const int vertex = mesh->triangle[t][k];
            if (!now[vertex]) now[vertex] = 1 + vertex_weld(&weld, vertex);
            to[k] = now[vertex] - 1;
        }
        if (to[0] == to[1] || to[1] == to[2] || to[2] == to[0]) continue; /* a sliver, or a point of a cloud */
        m->layer[m->n_triangles++] = mesh->layer[t];
    }
    free(weld.slot);
    free(now);
    return ok;
}

/* Everything but the tree and the bulge. */
static int facets_prepare(Facets *f)
{
    const size_t n = (size_t)f->mesh.n_triangles;
    Sides s = {.facets = f, .n = 3 * (int)n, .slots = 16};
    while (s.slots < 3 * n) s.slots *= 2; /* a closed mesh has 1.5 n different ones */
    f->of = calloc(n + 1, sizeof *f->of);
    f->corner = malloc((n + 1) * sizeof *f->corner);
    s.mate = malloc((3 * n + 1) * sizeof *s.mate);
    s.root = malloc((3 * n + 1) * sizeof *s.root);
    s.queue = malloc((n + 1) * sizeof *s.queue);
    s.turned = malloc(n + 1);
    s.slot = malloc(s.slots * sizeof *s.slot);
    s.way = malloc(s.slots);
    int ok = f->of && f->corner && s.mate && s.root && s.queue && s.turned && s.slot && s.way;
    if (ok) {
        mates_find(&s);
        triangles_orient(&s);
        mates_find(&s);
        ok = normals_number(&s);
    }
    free(s.mate);
    free(s.root);
    free(s.queue);
    free(s.turned);
    free(s.slot);
    free(s.way);
    if (ok) normals_mean(f);
    return ok;
}

/* ------------------------------------------------------------------------------------------- the smooth surface */

/* A triangle with its smooth surface (EN23). */
typedef struct Patch {
    Vec3 x[3], n[3];
    Vec3 xu, xv;
    int flat; /* all normals are that of its plane */
} Patch;

/* The surface at (u, v): place and normal with their derivatives. */
typedef struct PatchPoint {
    Vec3 flat, at, at_u, at_v, normal, normal_u, normal_v;
} PatchPoint;

/* Relative to `origin`, so that the coordinates of a survey do not cost digits. */
static Patch patch_of(const Facets *f, int triangle, Vec3 origin)
{
    Patch p = {.flat = 1};
    for (int k = 0; k < 3; ++k) {
        p.x[k] = v3_sub(corner_place(&f->mesh, triangle, k), origin);
        p.n[k] = v3_get(f->normal[f->corner[triangle][k]]);
    }
    p.xu = v3_sub(p.x[1], p.x[0]);
    p.xv = v3_sub(p.x[2], p.x[0]);
    const Vec3 area = v3_cross(p.xu, p.xv);
    const double size = v3_norm(area);
    for (int k = 0; k < 3; ++k) p.flat &= v3_dot(area, p.n[k]) > (1 - 1e-14) * size;
    return p;
}

/* (EN23) */
static PatchPoint patch_at(const Patch *p, double u, double v)
{
    const double w[3] = {1 - u - v, u, v}, wu[3] = {-1, 1, 0}, wv[3] = {-1, 0, 1};
    PatchPoint q = {.flat = v3_axpy(v3_axpy(p->x[0], u, p->xu), v, p->xv), .at_u = p->xu, .at_v = p->xv};
    Vec3 sum = V3_ZERO, sum_u = V3_ZERO, sum_v = V3_ZERO;
    q.at = q.flat;
    for (int k = 0; k < 3; ++k) {
        const Vec3 n = p->n[k];
        const double h = v3_dot(n, v3_sub(q.flat, p->x[k])), hu = v3_dot(n, p->xu), hv = v3_dot(n, p->xv);
        q.at = v3_axpy(q.at, -0.5 * w[k] * h, n);
        q.at_u = v3_axpy(q.at_u, -0.5 * (wu[k] * h + w[k] * hu), n);
        q.at_v = v3_axpy(q.at_v, -0.5 * (wv[k] * h + w[k] * hv), n);
        sum = v3_axpy(sum, w[k], n);
        sum_u = v3_axpy(sum_u, wu[k], n);
        sum_v = v3_axpy(sum_v, wv[k], n);
    }
    const double size = v3_norm(sum);
    q.normal = v3_scale(1 / size, sum);
    q.normal_u = v3_scale(1 / size, v3_reject(sum_u, q.normal));
    q.normal_v = v3_scale(1 / size, v3_reject(sum_v, q.normal));
    return q;
}

/* The inverse of the matrix with columns a, b, n: its rows; returns its determinant. */
static double rows_of(Vec3 a, Vec3 b, Vec3 n, Vec3 row[3])
{
    const Vec3 across = v3_cross(a, b);
    const double det = v3_dot(across, n);
    row[0] = v3_scale(1 / det, v3_cross(b, n));
    row[1] = v3_scale(1 / det, v3_cross(n, a));
    row[2] = v3_scale(1 / det, across);
    return det;
}

static Mat3 outer_sum(Vec3 a, Vec3 b, Vec3 c, Vec3 d)
{
    const double p[3] = {a.x, a.y, a.z}, q[3] = {b.x, b.y, b.z}, r[3] = {c.x, c.y, c.z}, s[3] = {d.x, d.y, d.z};
    Mat3 m;
    for (int i = 0; i < 9; ++i) m.m[i] = p[i / 3] * q[i % 3] + r[i / 3] * s[i % 3];
    return m;
}

static double triple_least(double a, double b, double c) { return fmin(a, fmin(b, c)); }

/* Foot of the origin on a triangle's smooth surface by Newton's method on (EN24), from its foot on the plane; returns
 * whether it is there. Half open would lose or double a foot by rounding on a side that two triangles share: each takes
 * a little more, and feet that are the same are found afterwards. */
static int patch_foot(const Patch *patch, Foot *out)
{
    enum { MOST = 20 };
    const double beyond = -1e-9, done = 1e-10;
    const Vec3 area = v3_cross(patch->xu, patch->xv), off = v3_scale(-1, patch->x[0]);
    const double square = v3_dot(area, area);
    double u = v3_dot(v3_cross(off, patch->xv), area) / square, v = v3_dot(v3_cross(patch->xu, off), area) / square;
    double g = v3_dot(area, off) / sqrt(square), moved = patch->flat ? 0 : INFINITY;
    PatchPoint q = patch_at(patch, u, v);
    Vec3 row[3];
    double det = rows_of(v3_axpy(q.at_u, g, q.normal_u), v3_axpy(q.at_v, g, q.normal_v), q.normal, row);
    for (int i = 0; i < MOST && moved > done; ++i) {
        const Vec3 miss = v3_scale(-1, v3_axpy(q.at, g, q.normal));
        const double du = v3_dot(row[0], miss), dv = v3_dot(row[1], miss);
        u += du;
        v += dv;
        g += v3_dot(row[2], miss);
        /* far outside its triangle the surface means nothing */
        if (!(triple_least(u, v, 1 - u - v) > -2)) return 0;
        q = patch_at(patch, u, v);
        det = rows_of(v3_axpy(q.at_u, g, q.normal_u), v3_axpy(q.at_v, g, q.normal_v), q.normal, row);
        moved = fabs(du) + fabs(dv);
    }
    /* behind the centre of curvature it is the farthest place, not the nearest */
    if (!(moved <= done) || !(det > 0) || !(triple_least(u, v, 1 - u - v) >= beyond)) return 0;
    const double side = g < 0 ? -1 : 1;
    *out = (Foot){.distance = side * g,
                  .normal = v3_scale(side, q.normal),
                  .gradient = v3_scale(side, row[2]),
                  .turn = outer_sum(v3_scale(side, q.normal_u), row[0], v3_scale(side, q.normal_v), row[1]),
                  .flat = q.flat};
    return 1;
}

/* Foot of the origin on an edge from corner k, whose curve is the smooth surface's border (EN25); `flat`: its foot on
 * the chord; returns whether it is the nearest place. */
static int edge_foot(const Patch *patch, int k, Vec3 flat, Foot *out)
{
    enum { MOST = 20 };
    const Vec3 a = patch->x[k], d = v3_sub(patch->x[(k + 1) % 3], a), na = patch->n[k], nb = patch->n[(k + 1) % 3];
    const Vec3 c = v3_sub(v3_scale(v3_dot(na, d) / 2, na), v3_scale(v3_dot(nb, d) / 2, nb));
    double s = v3_dot(v3_sub(flat, a), d) / v3_dot(d, d), slope = 0;
    Vec3 at = V3_ZERO, tangent = d, from = V3_ZERO;
    for (int i = 0; i < MOST; ++i) {
        at = v3_axpy(v3_axpy(a, s, d), -s * (1 - s), c);
        tangent = v3_axpy(d, 2 * s - 1, c);
        from = v3_scale(-1, at);
        slope = v3_dot(tangent, tangent) - 2 * v3_dot(from, c);
        if (!(slope > 0)) return 0;
        const double next = fmax(0, fmin(1, s + v3_dot(from, tangent) / slope)), moved = fabs(next - s);
        s = next;
        if (!(moved > 1e-13)) break;
    }
    const double g = v3_norm(from);
    if (!(g > 0)) return 0;
    const Vec3 n = v3_scale(1 / g, from);
    const int end = s <= 0 || s >= 1; /* at a corner the foot stays */
    Mat3 turn = outer_sum(v3_scale(-1 / g, n), n, v3_scale(end ? 0 : -1 / (g * slope), tangent), tangent);
    for (int i = 0; i < 9; i += 4) turn.m[i] += 1 / g;
    *out = (Foot){.distance = g, .normal = n, .gradient = n, .turn = turn, .bend = v3_norm(c), .flat = flat};
    return 1;
}

/* The largest shift of the smooth surface at the middles of triangles and of their sides. */
static double bulge_of(const Facets *f)
{
    static const double at[4][2] = {{0.5, 0}, {0.5, 0.5}, {0, 0.5}, {1.0 / 3, 1.0 / 3}};
    double most = 0;
    for (int t = 0; t < f->mesh.n_triangles; ++t) {
        const Patch patch = patch_of(f, t, corner_place(&f->mesh, t, 0));
        for (int i = 0; i < 4 && !patch.flat; ++i) {
            const PatchPoint q = patch_at(&patch, at[i][0], at[i][1]);
            most = fmax(most, v3_norm(v3_sub(q.at, q.flat)));
        }
    }
    return most;
}

Facets *facets_new(const Mesh *mesh, const int *law)
{
    Facets *const f = calloc(1, sizeof *f);
    if (!f) return NULL;
    *f = (Facets){.mesh = {.n_vertices = mesh->n_vertices, .n_layers = mesh->n_layers, .vertex = mesh->vertex},
                  .law = law};
    if (!touched_copy(mesh, f) || !facets_prepare(f)) return facets_free(f);
    f->bulge = 1.1 * bulge_of(f);
    f->tree = triangle_tree_new(&f->mesh);
    return f->tree ? f : facets_free(f);
}

Facets *facets_free(Facets *f)
{
    if (!f) return NULL;
    triangle_tree_free(f->tree);
    free(f->mesh.triangle);
    free(f->mesh.layer);
    free(f->corner);
    free(f->normal);
    free(f->of);
    free(f);
    return NULL;
}

/* ---------------------------------------------------------------------------------------------------------- feet */

static const double SAME = 5e-5; /* m: feet that are nearer to each other are the same one */

static double between(Vec3 a, Vec3 b) { return v3_norm(v3_sub(a, b)); }

/* An edge or a corner counts where none of the triangles that meet there is nearer: p lies in the wedge between them.
 */
static int edge_free(const Facets *f, const FacetNear *near, int n, double distance, Vec3 flat)
{
    for (int i = 0; i < n; ++i) {
        if (!(near[i].distance < distance) || between(near[i].at, flat) <= APART) continue;
        if (between(triangle_nearest(&f->mesh, near[i].triangle, flat), flat) <= APART) return 0;
    }
    return 1;
}

/* Foot of the origin on the chord of an edge. */
static Vec3 chord_foot(const Patch *patch, int k)
{
    const Vec3 a = patch->x[k], d = v3_sub(patch->x[(k + 1) % 3], a);
    return v3_axpy(a, fmax(0, fmin(1, -v3_dot(a, d) / v3_dot(d, d))), d);
}

/* A normal of the smooth surface leans from that of the plane no more than those of the corners do: a point whose
 * projection is farther from the triangle has no foot on it. */
static int patch_within(const Patch *patch, const FacetNear *near, double most)
{
    const Vec3 area = v3_cross(patch->xu, patch->xv);
    const double square = v3_dot(area, area), h = v3_dot(area, patch->x[0]);
    double least = 1;
    for (int k = 0; k < 3; ++k) {
        const double along = v3_dot(area, patch->n[k]);
        least = fmin(least, along > 0 ? along * along / square : 0);
    }
    const double lean = patch->flat ? 0 : most * most * (1 - least);
    return near->distance * near->distance - h * h / square <= lean + 1e-12;
}

/* Of two feet that are the same one stays: that on a curve, else the lower triangle's. */
static int foot_stays(const Foot *a, const Foot *b)
{
    return a->bend > b->bend || (!(a->bend < b->bend) && a->triangle < b->triangle);
}

/* Adds a foot to the nearest ones. */
static int foot_add(Foot out[FEET_MAX], int n, const Foot *foot)
{
    int same = -1;
    for (int i = 0; i < n && same < 0; ++i) {
        if (between(out[i].flat, foot->flat) < SAME) same = i;
    }
    if (same >= 0 && foot_stays(&out[same], foot)) return n;
    if (same >= 0) {
        memmove(&out[same], &out[same + 1], (size_t)(n - 1 - same) * sizeof *out);
        --n;
    }
    int at = n;
    while (at > 0 && out[at - 1].distance > foot->distance) --at;
    if (at == FEET_MAX) return n;
    if (n == FEET_MAX) --n;
    memmove(&out[at + 1], &out[at], (size_t)(n - at) * sizeof *out);
    out[at] = *foot;
    return n + 1;
}

int facets_feet(const Facets *f, const TriangleNear *list, int n, double moved, Vec3 p, double radius, FacetNear *work,
                Foot out[FEET_MAX])
{
    const double most = radius + f->bulge;
    int near = 0, feet = 0;
    for (int i = 0; i < n && list[i].distance - moved < most; ++i) {
        const Vec3 at = triangle_nearest(&f->mesh, list[i].triangle, p);
        const double distance = between(p, at);
        if (distance < most) work[near++] = (FacetNear){list[i].triangle, distance, at};
    }
    for (int i = 0; i < near; ++i) {
        const int t = work[i].triangle, sides = f->of[t];
        const Patch patch = patch_of(f, t, p);
        for (int k = 0; k < 4; ++k) { /* three edges and the face */
            Foot foot;
            if (k < 3) {
                if (!(sides & 1 << k)) continue;
                const Vec3 flat = chord_foot(&patch, k);
                const double distance = v3_norm(flat);
                if (!(distance < most) || !edge_free(f, work, near, distance, v3_add(p, flat))) continue;
                if (!edge_foot(&patch, k, flat, &foot)) continue;
            } else {
                if (!patch_within(&patch, &work[i], most) || !patch_foot(&patch, &foot)) continue;
                if ((sides & FACET_ONE_SIDED) && v3_dot(foot.normal, patch.n[0]) < 0) continue;
            }
            if (!(foot.distance < radius)) continue;
            foot.triangle = t;
            foot.law = f->law[f->mesh.layer[t]];
            feet = foot_add(out, feet, &foot);
        }
    }
    return feet;
}
