/* Distances from the tree over a mesh, against closed forms and against every triangle of a random mesh. */
#include "contact/triangles.h"

#include <math.h>
#include <stdlib.h>

#include "tests/support/chain.h"
#include "tests/support/check.h"

static void triangle_put(MeshBuild *m, Vec3 a, Vec3 b, Vec3 c)
{
    const Vec3 corner[3] = {a, b, c};
    int at[3];
    for (int k = 0; k < 3; ++k) {
        double p[3];
        v3_put(p, corner[k]);
        at[k] = mesh_add_vertex(m, p);
    }
    assert_true(mesh_add_triangle(m, at[0], at[1], at[2], mesh_add_layer(m, "all")) >= 0);
}

/* Triangles of about `size` around `middle`, within 3 m of it; every tenth is a point of a cloud. */
static void mesh_random(MeshBuild *m, int n, Vec3 middle, double size)
{
    uint64_t seed = 5;
    for (int i = 0; i < n; ++i) {
        const Vec3 at = v3_add(middle, fixture_vector(&seed, 3));
        const double s = i % 10 == 9 ? 0 : size;
        triangle_put(m, v3_add(at, fixture_vector(&seed, s)), v3_add(at, fixture_vector(&seed, s)),
                     v3_add(at, fixture_vector(&seed, s)));
    }
}

static double distance_of(const TriangleTree *tree, Vec3 a, Vec3 b, double bound, int *triangle, Vec3 *foot)
{
    double p[3], q[3], at[3] = {0, 0, 0};
    v3_put(p, a);
    v3_put(q, b);
    const double d = triangle_tree_distance(tree, p, q, bound, triangle, at);
    *foot = v3_get(at);
    return d;
}

/* The tree of one triangle is the distance itself: from an end inside, past an edge, at a corner, through it, parallel
 * to an edge; 10 mm beside the true value the bound is returned. */
TEST(test_one_triangle)
{
    static const struct {
        Vec3 a, b, foot;
        double d;
    } known[] = {{{0.2, 0.2, 0.5}, {0.2, 0.2, 0.9}, {0.2, 0.2, 0}, 0.5},
                 {{0.2, 0.2, 0.5}, {0.2, 0.2, -0.9}, {0.2, 0.2, 0}, 0},
                 {{0.5, -0.3, -1}, {0.5, -0.3, 1}, {0.5, 0, 0}, 0.3},
                 {{-3, -4, 0}, {-3, -4, 0}, {0, 0, 0}, 5},
                 {{2, 2, 0.1}, {1, 1, 0.1}, {0.5, 0.5, 0}, 0.71414284285428498},
                 {{0.2, -1, 0.3}, {0.2, 1, 0.3}, {0.2, 0, 0}, 0.3}};
    MeshBuild m = {0};
    triangle_put(&m, v3(0, 0, 0), v3(1, 0, 0), v3(0, 1, 0));
    TriangleTree *tree = triangle_tree_new(&m.mesh);
    for (size_t i = 0; i < sizeof known / sizeof *known; ++i) {
        int triangle;
        Vec3 foot;
        check_close(distance_of(tree, known[i].a, known[i].b, 10, &triangle, &foot), known[i].d, 1e-15);
        check_equal(triangle, 0);
        /* a segment parallel to the plane has many nearest points */
        if (i + 1 < sizeof known / sizeof *known) check_at_most(v3_norm(v3_sub(foot, known[i].foot)), 1e-15);
        if (!(known[i].d > 0)) continue;
        check_equal(distance_of(tree, known[i].a, known[i].b, known[i].d - 0.01, &triangle, &foot), known[i].d - 0.01);
        check_equal(triangle, -1);
    }
    triangle_tree_free(tree);
    mesh_build_end(&m);
    mesh_free(&m.mesh);
}

/* The tree against trees of one triangle each, and these against points along the segment, also with the coordinates of
 * a survey. */
static void against_all(Vec3 middle)
{
    enum { TRIANGLES = 600, SEGMENTS = 60, STEPS = 400 };
    MeshBuild m = {0};
    mesh_random(&m, TRIANGLES, middle, 0.4);
    TriangleTree *tree = triangle_tree_new(&m.mesh);
    uint64_t seed = 9;
    double off = 0, sampled = 0, foot_off = 0, rounded = v3_norm(middle) * 1e-15 + 1e-14;
    for (int i = 0; i < SEGMENTS; ++i) {
        const Vec3 a = v3_add(middle, fixture_vector(&seed, 3)), b = v3_add(a, fixture_vector(&seed, i % 3 * 0.2));
        int triangle;
        Vec3 foot;
        const double d = distance_of(tree, a, b, 50, &triangle, &foot);
        double least = INFINITY, along = INFINITY, from_foot = INFINITY;
        for (int k = 0; k < TRIANGLES; ++k) {
            Mesh one = m.mesh;
            one.n_triangles = 1;
            one.triangle += k;
            TriangleTree *single = triangle_tree_new(&one);
            Vec3 at;
            least = fmin(least, distance_of(single, a, b, 50, NULL, &at));
            triangle_tree_free(single);
        }
        for (int k = 0; k <= STEPS; ++k) {
            const Vec3 p = v3_axpy(a, (double)k / STEPS, v3_sub(b, a));
            from_foot = fmin(from_foot, v3_norm(v3_sub(p, foot)));
            along = fmin(along, v3_norm(v3_sub(p, triangle_nearest(&m.mesh, triangle, p))));
        }
        off = larger_of(off, fabs(d - least));
        sampled = larger_of(sampled, fabs(along - d));
        foot_off = larger_of(foot_off, fabs(from_foot - d));
    }
    check_at_most(off, 1e-15);
    /* where a segment passes through a triangle the nearest of the points is up to half their spacing away */
    check_at_most(sampled, 9e-4 + rounded);
    check_at_most(foot_off, 9e-4 + rounded);
    triangle_tree_free(tree);
    mesh_build_end(&m);
    mesh_free(&m.mesh);
}

TEST(test_tree) { against_all(V3_ZERO); }

TEST(test_tree_far_away) { against_all(v3(500000, 5700000, 120)); }

/* The list of near triangles is complete, in order, and without points of the cloud. */
TEST(test_near)
{
    MeshBuild m = {0};
    mesh_random(&m, 600, V3_ZERO, 0.4);
    TriangleTree *tree = triangle_tree_new(&m.mesh);
    TriangleNear *list = NULL;
    int n = 0, room = 0, first = 0;
    for (int i = 0; i < 20; ++i) {
        const Vec3 p = v3(0.1 * i, 0, 0);
        assert_true(triangle_tree_near(tree, p, 0.7, &list, &n, &room));
        int all = 0;
        for (int k = 0; k < m.mesh.n_triangles; ++k) {
            all += k % 10 != 9 && v3_norm(v3_sub(p, triangle_nearest(&m.mesh, k, p))) < 0.7;
        }
        check_equal(n - first, all);
        for (int k = first; k < n; ++k) {
            const double d = v3_norm(v3_sub(p, triangle_nearest(&m.mesh, list[k].triangle, p)));
            check_at_most(list[k].distance, d + 1e-15);
            check_at_least(list[k].distance, d - 1e-7);
            if (k > first) check_at_most(list[k - 1].distance, list[k].distance);
        }
        first = n;
    }
    check_above(n, 80);
    free(list);
    triangle_tree_free(tree);
    mesh_build_end(&m);
    mesh_free(&m.mesh);
}

/* Equal triangles cannot be parted, and triangles that halve in size at every step are parted one by one: the tree's
 * depth is bounded in both cases. */
TEST(test_bad_meshes)
{
    MeshBuild m = {0};
    for (int i = 0; i < 500; ++i) triangle_put(&m, v3(0, 0, 0), v3(1, 0, 0), v3(0, 1, 0));
    for (int i = 0; i < 900; ++i) {
        const double x = ldexp(1, -i);
        triangle_put(&m, v3(x, 2, 0), v3(1.5 * x, 2, 0), v3(x, 2 + x / 2, 0));
    }
    TriangleTree *tree = triangle_tree_new(&m.mesh);
    int triangle;
    Vec3 foot;
    check_close(distance_of(tree, v3(0.2, 0.2, 3), v3(0.3, 0.3, 2), 50, &triangle, &foot), 2, 1e-15);
    check_close(distance_of(tree, v3(0.5, 2, 3), v3(0.5, 2, 2.5), 50, &triangle, &foot), 2.5, 1e-15);
    triangle_tree_free(tree);
    mesh_build_end(&m);
    mesh_free(&m.mesh);
    Mesh none = {0};
    tree = triangle_tree_new(&none);
    check_equal(distance_of(tree, V3_ZERO, V3_ZERO, 7, &triangle, &foot), 7);
    check_equal(triangle, -1);
    triangle_tree_free(tree);
}
