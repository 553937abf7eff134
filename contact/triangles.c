/* The tree of boxes over triangles and the exact distances below it. docs/theory/98-environment.md. */
#include "contact/triangles.h"

#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* Bounds relative to the tree's origin, m, rounded outward: single numbers halve the memory, and coordinates of a
 * survey would lose their millimetres in them. */
typedef struct Box {
    float low[3], high[3];
} Box;

/* count 0: an inner node, whose children are nodes `first` and first + 1; else a leaf with order[first ..]. */
typedef struct TreeNode {
    Box box;
    int first, count;
} TreeNode;

struct TriangleTree {
    const Mesh *mesh;
    Vec3 origin; /* m, middle of the mesh */
    int n_nodes;
    TreeNode *node; /* [n_nodes], node 0 is the root */
    int *order;     /* [n_triangles], by leaf */
};

enum {
    LEAF = 4,  /* triangles of a leaf, at most, where they can be parted */
    BINS = 16, /* places tried for a cut, on each axis */
    DEEP = 48, /* below this depth a node is cut in the middle of its list, so that depth stays below STACK */
    STACK = DEEP + 32
};

static const Box EMPTY = {{FLT_MAX, FLT_MAX, FLT_MAX}, {-FLT_MAX, -FLT_MAX, -FLT_MAX}};

static void box_join(Box *box, const Box *with)
{
    for (int c = 0; c < 3; ++c) {
        if (with->low[c] < box->low[c]) box->low[c] = with->low[c];
        if (with->high[c] > box->high[c]) box->high[c] = with->high[c];
    }
}

/* Half the surface, in proportion to which a segment that is placed at random meets the box. */
static double box_area(const Box *box)
{
    const double x = box->high[0] - box->low[0], y = box->high[1] - box->low[1], z = box->high[2] - box->low[2];
    return x < 0 ? 0 : x * y + y * z + z * x;
}

static float middle(const Box *box, int axis) { return (box->low[axis] + box->high[axis]) / 2; }

static float float_below(double x) { return (double)(float)x > x ? nextafterf((float)x, -FLT_MAX) : (float)x; }

static float float_above(double x) { return (double)(float)x < x ? nextafterf((float)x, FLT_MAX) : (float)x; }

static Vec3 corner_of(const Mesh *mesh, int triangle, int k)
{
    return v3_get(mesh->vertex[mesh->triangle[triangle][k]]);
}

static Box box_of(const Mesh *mesh, Vec3 origin, int triangle)
{
    Box box = EMPTY;
    for (int k = 0; k < 3; ++k) {
        double at[3];
        v3_put(at, v3_sub(corner_of(mesh, triangle, k), origin));
        for (int c = 0; c < 3; ++c) {
            box.low[c] = fminf(box.low[c], float_below(at[c]));
            box.high[c] = fmaxf(box.high[c], float_above(at[c]));
        }
    }
    return box;
}

/* A tree being built: the boxes of the triangles, which only the building needs. */
typedef struct Builder {
    TriangleTree *tree;
    const Box *box; /* [n_triangles] */
} Builder;

/* A plane between two bins of the triangles' middles. */
typedef struct Cut {
    int axis, bin;  /* axis -1: there is none */
    float low, per; /* of the first bin; bins per metre */
} Cut;

static int bin_of(const Cut *cut, const Box *box)
{
    const int bin = (int)((middle(box, cut->axis) - cut->low) * cut->per);
    return bin < BINS ? bin : BINS - 1;
}

/* The cut with the least sum of areas times triangles: that many boxes a segment meets. */
static Cut best_cut(const Builder *b, int first, int count, const Box *middles)
{
    Cut best = {.axis = -1};
    double least = INFINITY;
    for (int axis = 0; axis < 3; ++axis) {
        const float width = middles->high[axis] - middles->low[axis];
        Cut cut = {axis, 0, middles->low[axis], (float)BINS / width};
        if (!(width > 0) || !(cut.per < FLT_MAX)) continue;
        Box bin[BINS], run = EMPTY;
        int number[BINS] = {0}, before[BINS], sum = 0;
        double area[BINS];
        for (int k = 0; k < BINS; ++k) bin[k] = EMPTY;
        for (int i = first; i < first + count; ++i) {
            const Box *const box = &b->box[b->tree->order[i]];
            const int k = bin_of(&cut, box);
            box_join(&bin[k], box);
            ++number[k];
        }
        for (int k = 0; k < BINS; ++k) {
            before[k] = sum;
            area[k] = box_area(&run);
            box_join(&run, &bin[k]);
            sum += number[k];
        }
        run = EMPTY;
        for (int k = BINS - 1; k > 0; --k) {
            box_join(&run, &bin[k]);
            const double cost = before[k] * area[k] + (count - before[k]) * box_area(&run);
            if (before[k] == 0 || before[k] == count || !(cost < least)) continue;
            least = cost;
            cut.bin = k;
            best = cut;
        }
    }
    return best;
}

/* Orders the triangles of a node by the cut; returns the number before it. */
static int part(const Builder *b, int first, int count, const Cut *cut)
{
    int *const order = b->tree->order;
    int i = first, j = first + count - 1;
    while (i <= j) {
        if (bin_of(cut, &b->box[order[i]]) < cut->bin) {
            ++i;
            continue;
        }
        const int swap = order[i];
        order[i] = order[j];
        order[j--] = swap;
    }
    return i - first;
}

static void node_build(const Builder *b, int at, int first, int count, int depth)
{
    TriangleTree *const tree = b->tree;
    TreeNode *const node = &tree->node[at];
    Box middles = EMPTY;
    *node = (TreeNode){EMPTY, first, count};
    for (int i = first; i < first + count; ++i) {
        const Box *const box = &b->box[tree->order[i]];
        const float m[3] = {middle(box, 0), middle(box, 1), middle(box, 2)};
        const Box point = {{m[0], m[1], m[2]}, {m[0], m[1], m[2]}};
        box_join(&node->box, box);
        box_join(&middles, &point);
    }
    if (count <= LEAF) return;
    const Cut cut = best_cut(b, first, count, &middles);
    const int before = cut.axis < 0 || depth >= DEEP ? count / 2 : part(b, first, count, &cut);
    const int child = tree->n_nodes;
    tree->n_nodes += 2;
    node->first = child;
    node->count = 0;
    node_build(b, child, first, before, depth + 1);
    node_build(b, child + 1, first + before, count - before, depth + 1);
}

static Vec3 mesh_middle(const Mesh *mesh)
{
    Vec3 low = v3(INFINITY, INFINITY, INFINITY), high = v3_scale(-1, low);
    for (int i = 0; i < mesh->n_vertices; ++i) {
        const Vec3 p = v3_get(mesh->vertex[i]);
        low = v3(fmin(low.x, p.x), fmin(low.y, p.y), fmin(low.z, p.z));
        high = v3(fmax(high.x, p.x), fmax(high.y, p.y), fmax(high.z, p.z));
    }
    return mesh->n_vertices > 0 ? v3_scale(0.5, v3_add(low, high)) : V3_ZERO;
}

TriangleTree *triangle_tree_new(const Mesh *mesh)
{
    const int n = mesh->n_triangles;
    TriangleTree *const tree = calloc(1, sizeof *tree);
    Box *const box = malloc(((size_t)n + 1) * sizeof *box);
    if (tree) *tree = (TriangleTree){.mesh = mesh, .origin = mesh_middle(mesh)};
    if (tree) tree->node = malloc((2 * (size_t)n + 1) * sizeof *tree->node);
    if (tree) tree->order = malloc(((size_t)n + 1) * sizeof *tree->order);
    if (!tree || !box || !tree->node || !tree->order) {
        free(box);
        return triangle_tree_free(tree);
    }
    for (int i = 0; i < n; ++i) {
        tree->order[i] = i;
        box[i] = box_of(mesh, tree->origin, i);
    }
    tree->n_nodes = 1;
    node_build(&(Builder){tree, box}, 0, 0, n, 0);
    free(box);
    TreeNode *const fits = realloc(tree->node, (size_t)tree->n_nodes * sizeof *fits);
    if (fits) tree->node = fits;
    return tree;
}

TriangleTree *triangle_tree_free(TriangleTree *tree)
{
    if (!tree) return NULL;
    free(tree->node);
    free(tree->order);
    free(tree);
    return NULL;
}

/* -------------------------------------------------------------------------------------------------- exact distances */

/* A triangle with its normal, of twice its area. */
typedef struct Flat {
    Vec3 corner[3], normal;
} Flat;

static Flat flat_of(const Mesh *mesh, int triangle)
{
    Flat f = {.corner = {corner_of(mesh, triangle, 0), corner_of(mesh, triangle, 1), corner_of(mesh, triangle, 2)}};
    f.normal = v3_cross(v3_sub(f.corner[1], f.corner[0]), v3_sub(f.corner[2], f.corner[0]));
    return f;
}

/* Checks whether a point of the triangle's plane is in the triangle: on the inner side of every edge. */
static int flat_holds(const Flat *f, Vec3 p)
{
    int in = v3_dot(f->normal, f->normal) > 0;
    for (int k = 0; k < 3; ++k) {
        const Vec3 from = f->corner[k], edge = v3_sub(f->corner[(k + 1) % 3], from);
        in &= v3_dot(v3_cross(edge, v3_sub(p, from)), f->normal) >= 0;
    }
    return in;
}

static double share_clamped(double x) { return x < 0 ? 0 : x > 1 ? 1 : x; }

/* Squared distance of the segments a-b and c-d; either may be a point. at: the nearest point of c-d. */
static double segments_apart(Vec3 a, Vec3 b, Vec3 c, Vec3 d, Vec3 *at)
{
    const Vec3 u = v3_sub(b, a), v = v3_sub(d, c), w = v3_sub(a, c);
    const double uu = v3_dot(u, u), uv = v3_dot(u, v), vv = v3_dot(v, v), uw = v3_dot(u, w), vw = v3_dot(v, w);
    const double square = uu * vv - uv * uv; /* of the area between the directions: rounding if they are parallel */
    double s = square > 1e-14 * uu * vv ? share_clamped((uv * vw - vv * uw) / square) : 0;
    double t = vv > 0 ? (uv * s + vw) / vv : 0;
    if (!(vv > 0) || t < 0 || t > 1) {
        t = t > 1 ? 1 : 0;
        s = uu > 0 ? share_clamped((uv * t - uw) / uu) : 0;
    }
    *at = v3_axpy(c, t, v);
    const Vec3 apart = v3_sub(v3_axpy(a, s, u), *at);
    return v3_dot(apart, apart);
}

/* Lowers *least, a squared distance, by that of an end of the segment inside the triangle, along its normal. */
static void end_apart(const Flat *f, Vec3 p, double *least, Vec3 *at)
{
    const double nn = v3_dot(f->normal, f->normal), h = v3_dot(f->normal, v3_sub(p, f->corner[0]));
    const Vec3 below = v3_axpy(p, -h / nn, f->normal);
    if (!(nn > 0) || !(h * h / nn < *least) || !flat_holds(f, below)) return;
    *least = h * h / nn;
    *at = below;
}

/* (EN20): lowers *least to the squared distance of the segment a-b from the triangle if it is smaller, and sets its
 * nearest point; returns whether it is. */
static int flat_apart(const Flat *f, Vec3 a, Vec3 b, double *least, Vec3 *at)
{
    const double start = *least, nn = v3_dot(f->normal, f->normal);
    const double ha = v3_dot(f->normal, v3_sub(a, f->corner[0])), hb = v3_dot(f->normal, v3_sub(b, f->corner[0]));
    /* all of the segment is farther than that on one side of the plane */
    if (ha * hb > 0 && fmin(ha * ha, hb * hb) >= start * nn) return 0;
    if ((ha > 0 && hb < 0) || (ha < 0 && hb > 0)) {
        const Vec3 crossing = v3_axpy(a, ha / (ha - hb), v3_sub(b, a));
        if (flat_holds(f, crossing)) {
            *least = 0;
            *at = crossing;
            return start > 0;
        }
    }
    end_apart(f, a, least, at);
    end_apart(f, b, least, at);
    for (int k = 0; k < 3; ++k) {
        Vec3 on;
        const double apart = segments_apart(a, b, f->corner[k], f->corner[(k + 1) % 3], &on);
        if (!(apart < *least)) continue;
        *least = apart;
        *at = on;
    }
    return *least < start;
}

Vec3 triangle_nearest(const Mesh *mesh, int triangle, Vec3 p)
{
    const Flat f = flat_of(mesh, triangle);
    double least = INFINITY;
    Vec3 at = f.corner[0];
    flat_apart(&f, p, p, &least, &at);
    return at;
}

/* --------------------------------------------------------------------------------------------------- ways down */

/* Bounds of a segment relative to the origin. */
typedef struct Span {
    double low[3], high[3];
} Span;

static Span span_of(const TriangleTree *tree, Vec3 a, Vec3 b)
{
    double p[3], q[3];
    Span span;
    v3_put(p, v3_sub(a, tree->origin));
    v3_put(q, v3_sub(b, tree->origin));
    for (int c = 0; c < 3; ++c) {
        span.low[c] = fmin(p[c], q[c]);
        span.high[c] = fmax(p[c], q[c]);
    }
    return span;
}

/* Squared distance between the bounds: no point of the two is nearer. */
static double span_apart(const Span *span, const Box *box)
{
    double sum = 0;
    for (int c = 0; c < 3; ++c) {
        const double gap = fmax(fmax(box->low[c] - span->high[c], span->low[c] - box->high[c]), 0);
        sum += gap * gap;
    }
    return sum;
}

/* A node to be visited, and how far it is. */
typedef struct Visit {
    int node;
    double apart; /* m2 */
} Visit;

/* Pushes both children, the nearer one last, so that it is visited first. */
static int children_push(const TriangleTree *tree, const Span *span, int first, double most, Visit stack[STACK], int n)
{
    Visit v[2];
    for (int k = 0; k < 2; ++k) v[k] = (Visit){first + k, span_apart(span, &tree->node[first + k].box)};
    const int near = v[1].apart < v[0].apart;
    if (v[!near].apart <= most) stack[n++] = v[!near];
    if (v[near].apart <= most) stack[n++] = v[near];
    return n;
}

double triangle_tree_distance(const TriangleTree *tree, const double a[3], const double b[3], double bound,
                              int *triangle, double foot[3])
{
    const Vec3 p = v3_get(a), q = v3_get(b);
    const Span span = span_of(tree, p, q);
    Visit stack[STACK];
    int n = 0, nearest = -1;
    double least = bound * bound;
    Vec3 at = p;
    if (tree->mesh->n_triangles > 0) stack[n++] = (Visit){0, 0};
    while (n > 0) {
        const Visit visit = stack[--n];
        const TreeNode *const node = &tree->node[visit.node];
        if (visit.apart > least) continue;
        if (node->count == 0) {
            n = children_push(tree, &span, node->first, least, stack, n);
            continue;
        }
        for (int i = node->first; i < node->first + node->count; ++i) {
            const Flat f = flat_of(tree->mesh, tree->order[i]);
            if (flat_apart(&f, p, q, &least, &at)) nearest = tree->order[i];
        }
    }
    if (triangle) *triangle = nearest;
    if (nearest < 0) return bound;
    if (foot) v3_put(foot, at);
    return sqrt(least);
}

static int nearer_first(const void *a, const void *b)
{
    const TriangleNear *const p = a, *const q = b;
    if (p->distance != q->distance) return p->distance < q->distance ? -1 : 1;
    return (p->triangle > q->triangle) - (p->triangle < q->triangle);
}

static int near_add(TriangleNear near, TriangleNear **list, int *n, int *room)
{
    if (*n == *room) {
        const int more = 2 * *room + 64;
        TriangleNear *const grown = realloc(*list, (size_t)more * sizeof *grown);
        if (!grown) return 0;
        *list = grown;
        *room = more;
    }
    (*list)[(*n)++] = near;
    return 1;
}

int triangle_tree_near(const TriangleTree *tree, Vec3 p, double reach, TriangleNear **list, int *n, int *room)
{
    const Span span = span_of(tree, p, p);
    const double most = reach * reach;
    const int first = *n;
    Visit stack[STACK];
    int waiting = 0;
    if (tree->mesh->n_triangles > 0) stack[waiting++] = (Visit){0, 0};
    while (waiting > 0) {
        const TreeNode *const node = &tree->node[stack[--waiting].node];
        if (node->count == 0) {
            waiting = children_push(tree, &span, node->first, most, stack, waiting);
            continue;
        }
        for (int i = node->first; i < node->first + node->count; ++i) {
            const Flat f = flat_of(tree->mesh, tree->order[i]);
            double least = most;
            Vec3 at;
            if (!(v3_dot(f.normal, f.normal) > 0) || !flat_apart(&f, p, p, &least, &at)) continue;
            if (!near_add((TriangleNear){tree->order[i], float_below(sqrt(least))}, list, n, room)) return 0;
        }
    }
    if (*n > first) qsort(*list + first, (size_t)(*n - first), sizeof **list, nearer_first);
    return 1;
}
