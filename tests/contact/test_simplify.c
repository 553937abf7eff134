/* Meshes of fewer triangles: a flat one and a cylinder, whose distances are known, layers, and points of a cloud. */
#include "contact/simplify.h"

#include <math.h>

#include "core/vec3.h"
#include "tests/support/check.h"

/* Adds a net of n x m quadrangles, closed in its second direction or not, whose corners `at` gives. */
static void net_add(MeshBuild *b, int n, int m, void (*at)(int i, int j, double p[3]), const char *layer)
{
    const int name = mesh_add_layer(b, layer);
    for (int i = 0; i < n; ++i)
        for (int j = 0; j < m; ++j) {
            double p[4][3];
            int corner[4];
            at(i, j, p[0]), at(i + 1, j, p[1]), at(i + 1, j + 1, p[2]), at(i, j + 1, p[3]);
            for (int k = 0; k < 4; ++k) corner[k] = mesh_add_vertex(b, p[k]);
            assert_int_equal(mesh_add_triangle(b, corner[0], corner[1], corner[2], name), 1);
            assert_int_equal(mesh_add_triangle(b, corner[0], corner[2], corner[3], name), 1);
        }
}

/* A floor of 10 m x 10 m, far from the origin. */
static void floor_at(int i, int j, double p[3])
{
    p[0] = 1000 + 0.1 * i;
    p[1] = 0.1 * j;
    p[2] = -3;
}

enum { ROUND = 200 };
/* A wall of radius 2 m and 10 m long beside it. */
static void wall_at(int i, int j, double p[3])
{
    const double angle = 2 * M_PI * (j % ROUND) / ROUND;
    p[0] = 1020 + 0.1 * i;
    p[1] = 2 * cos(angle);
    p[2] = 2 * sin(angle);
}

static double farthest_from_wall(const Mesh *m)
{
    double most = 0;
    for (int i = 0; i < m->n_triangles; ++i) {
        double y = 0, z = 0;
        for (int k = 0; k < 3; ++k) y += m->vertex[m->triangle[i][k]][1] / 3, z += m->vertex[m->triangle[i][k]][2] / 3;
        most = larger_of(most, 2 - hypot(y, z));
    }
    return most;
}

TEST(a_small_mesh_is_copied)
{
    MeshBuild b = {0};
    Mesh out;
    double error;
    hawser_error err;
    net_add(&b, 2, 2, floor_at, "floor");
    assert_int_equal(mesh_simplify(&b.mesh, 8, &out, &error, &err), HAWSER_OK);
    assert_int_equal(out.n_triangles, 8);
    assert_string_equal(out.layer_name[0], "floor");
    check_close(mesh_area(&out), 0.04, 1e-9);
    assert_true(error == 0);
    mesh_build_end(&b);
    mesh_free(&b.mesh);
    mesh_free(&out);
}

TEST(layers_keep_their_shapes)
{
    MeshBuild b = {0}, floor = {0}, wall = {0};
    Mesh out;
    double error = 0;
    hawser_error err;
    if (!mesh_can_simplify()) skip();
    net_add(&b, 100, 100, floor_at, "floor");
    net_add(&b, 100, ROUND, wall_at, "wall");
    const int points = mesh_add_layer(&b, "cloud");
    for (int i = 0; i < 1000; ++i) {
        const int at = mesh_add_vertex(&b, (const double[3]){1000 + 0.01 * i, 0, -1});
        assert_int_equal(mesh_add_triangle(&b, at, at, at, points), 1);
    }
    assert_int_equal(mesh_simplify(&b.mesh, 6100, &out, &error, &err), HAWSER_OK);
    assert_true(out.n_triangles > 1000 && out.n_triangles <= 6150);
    assert_int_equal(out.n_layers, 3);
    int cloud = 0;
    for (int i = 0; i < out.n_triangles; ++i) {
        MeshBuild *const of = out.layer[i] == 0 ? &floor : &wall;
        int corner[3];
        if (out.layer[i] == points) ++cloud;
        if (out.layer[i] == points) continue;
        for (int k = 0; k < 3; ++k) corner[k] = mesh_add_vertex(of, out.vertex[out.triangle[i][k]]);
        mesh_add_triangle(of, corner[0], corner[1], corner[2], 0);
    }
    check_close(cloud, 100, 1);
    /* The floor loses nothing. The area of the wall grows by 2 %: its triangles are as slim as those of Schwarz's
     * lantern. */
    check_close(mesh_area(&floor.mesh), 100, 1e-4);
    /* of ten points, 10 mm apart, the last one stays: the first point of all is 90 mm from it, which is the largest
     * distance here */
    check_at_most(farthest_from_wall(&wall.mesh), error);
    check_close(error, 0.09, 1e-9);
    mesh_build_end(&b), mesh_build_end(&floor), mesh_build_end(&wall);
    mesh_free(&b.mesh), mesh_free(&floor.mesh), mesh_free(&wall.mesh);
    mesh_free(&out);
}
