#include "tests/support/tessellated.h"

#include <math.h>

#include "tests/support/check.h"

static int vertex_at(MeshBuild *m, Vec3 p)
{
    double at[3];
    v3_put(at, p);
    const int i = mesh_add_vertex(m, at);
    assert_true(i >= 0);
    return i;
}

void mesh_grid(MeshBuild *m, const char *layer, Parametric at, const void *of, int rows, int columns)
{
    const int number = mesh_add_layer(m, layer);
    for (int i = 0; i < rows; ++i) {
        for (int j = 0; j < columns; ++j) {
            int c[2][2];
            for (int k = 0; k < 4; ++k) {
                c[k / 2][k % 2] = vertex_at(m, at(of, (double)(i + k / 2) / rows, (double)(j + k % 2) / columns));
            }
            assert_true(mesh_add_triangle(m, c[0][0], c[1][0], c[1][1], number) >= 0);
            assert_true(mesh_add_triangle(m, c[0][0], c[1][1], c[0][1], number) >= 0);
        }
    }
}

/* Toward the middle is outside: u runs along the tube, v around it, from y toward z. */
static Vec3 tube_at(const void *of, double u, double v)
{
    const TubeShape *const t = of;
    const int k = (int)(v * t->facets + 0.5) % t->facets;
    const double step = 6.283185307179586 / t->facets, angle = step * (k + t->uneven * (k % 2));
    const double arc = t->bend * t->angle, s = u * (t->length + arc), over = s > t->length ? s - t->length : 0;
    const double turn = arc > 0 ? over / t->bend : 0, off = t->radius * cos(angle), up = t->radius * sin(angle);
    return v3(s - over + (t->bend - off) * sin(turn), t->bend - (t->bend - off) * cos(turn), up);
}

void mesh_tube(MeshBuild *m, const TubeShape *tube, int rows)
{
    mesh_grid(m, "tube", tube_at, tube, rows, tube->facets);
}

void mesh_box(MeshBuild *m, const char *layer, Vec3 low, Vec3 high)
{
    static const int quad[6][4] = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    const int number = mesh_add_layer(m, layer);
    int c[8];
    for (int i = 0; i < 8; ++i)
        c[i] = vertex_at(m, v3(i & 1 ? high.x : low.x, i & 2 ? high.y : low.y, i & 4 ? high.z : low.z));
    for (int i = 0; i < 6; ++i) {
        const int *const q = quad[i];
        assert_true(mesh_add_triangle(m, c[q[0]], c[q[1]], c[q[2]], number) > 0);
        assert_true(mesh_add_triangle(m, c[q[0]], c[q[2]], c[q[3]], number) > 0);
    }
}

void mesh_done(MeshBuild *m)
{
    mesh_build_end(m);
    mesh_free(&m->mesh);
}
