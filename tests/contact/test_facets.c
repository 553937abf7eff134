/* The smooth surface over facets, its edges, and which places count as touched. */
#include "contact/facets.h"

#include <math.h>
#include <stdlib.h>

#include "contact/shape.h"
#include "tests/support/chain.h"
#include "tests/support/check.h"
#include "tests/support/lack.h"
#include "tests/support/tessellated.h"

enum { NEAR_MOST = 4000, LAYERS = 8 };

static const int LAW[LAYERS] = {0, 1, 2, 3, 4, 5, 6, 7};

/* All feet of a point within reach, with a list made for a place 10 mm away. */
static int feet_of(const Facets *f, Vec3 p, double radius, Foot out[FEET_MAX])
{
    static FacetNear work[NEAR_MOST];
    TriangleNear *list = NULL;
    int n = 0, room = 0;
    const Vec3 other = v3_axpy(p, 0.01, v3_unit(v3(1, -2, 0.5)));
    assert_true(triangle_tree_near(f->tree, other, radius + f->bulge + 0.01, &list, &n, &room));
    assert_true(n <= NEAR_MOST);
    const int feet = facets_feet(f, list, n, 0.01, p, radius, work, out);
    free(list);
    return feet;
}

/* The derivatives of every foot by differences. */
static double derivatives_off(const Facets *f, Vec3 p, double radius, double *turn_off)
{
    const double step = 1e-6;
    Foot foot[FEET_MAX], side[2][FEET_MAX];
    const int n = feet_of(f, p, radius, foot);
    double off = 0;
    for (int c = 0; c < 3; ++c) {
        const int plus = feet_of(f, v3_axpy(p, step, v3_axis(c)), radius, side[0]);
        const int minus = feet_of(f, v3_axpy(p, -step, v3_axis(c)), radius, side[1]);
        for (int i = 0; i < n && plus == n && minus == n; ++i) {
            const double slope = (side[0][i].distance - side[1][i].distance) / (2 * step);
            const Vec3 turn = v3_scale(1 / (2 * step), v3_sub(side[0][i].normal, side[1][i].normal));
            if (side[0][i].triangle != side[1][i].triangle) continue;
            off = larger_of(off, fabs(slope - v3_dot(foot[i].gradient, v3_axis(c))));
            *turn_off = larger_of(*turn_off, v3_norm(v3_sub(turn, m3_mul(&foot[i].turn, v3_axis(c)))));
        }
    }
    return off;
}

/* What a point feels in a tessellated tube, around once at several depths, against the tube itself. */
typedef struct Ripple {
    double distance; /* m, largest error */
    double lean;     /* largest part of the normal along the wall */
    double jump;     /* m and 1, largest change of distance or normal from one place to the next */
    double slope, turn, gradient;
    int feet; /* largest number */
} Ripple;

static Ripple tube_ripple(int facets, double uneven, double radius)
{
    const double R = 0.1;
    MeshBuild m = {0};
    const TubeShape tube = {.radius = R, .length = 0.4, .facets = facets, .uneven = uneven};
    mesh_tube(&m, &tube, 4);
    Facets *f = facets_new(&m.mesh, LAW);
    Ripple r = {0};
    const int places = 90 * facets;
    Vec3 last = V3_ZERO;
    for (int depth = 0; depth < 3; ++depth) {
        for (int i = 0; i < places; ++i) {
            const double rho = R - radius + (double[]){1e-4, 5e-4, 2e-3}[depth];
            const double angle = 6.283185307179586 * (i + 0.31) / places;
            const Vec3 in = v3(0, -cos(angle), -sin(angle)), p = v3_axpy(v3(0.17, 0, 0), -rho, in);
            Foot foot[FEET_MAX];
            const int n = feet_of(f, p, radius, foot);
            r.feet = n > r.feet ? n : r.feet;
            check_equal(n, 1);
            r.distance = larger_of(r.distance, fabs(foot[0].distance - (R - rho)));
            r.lean = larger_of(r.lean, v3_norm(v3_reject(foot[0].normal, in)));
            r.gradient = larger_of(r.gradient, v3_norm(v3_sub(foot[0].gradient, foot[0].normal)));
            const double turned = 6.283185307179586 / places;
            if (i > 0) r.jump = larger_of(r.jump, v3_norm(v3_sub(foot[0].normal, last)) - turned);
            last = foot[0].normal;
            if (i % 7 == 0) r.slope = larger_of(r.slope, derivatives_off(f, p, radius, &r.turn));
        }
    }
    print_message("%d facets, uneven %.2f: distance %.2e m, normal %.2e, jump %.2e, gradient %.2e, slope %.1e, turn "
                  "%.1e; bulge %.2e m, %d edges\n",
                  facets, uneven, r.distance, r.lean, r.jump, r.gradient, r.slope, r.turn, f->bulge, f->n_edges);
    facets_free(f);
    mesh_done(&m);
    return r;
}

/* With the half angle a of a facet: the distance is wrong by 3/8 R a^4 (EN23), the normal by the third order, and
 * neither jumps: a flat facet would be wrong by R a^2/2, 390 times as much for 32 facets, with normals that turn by 2
 * a. */
TEST(test_tube)
{
    double lean[2][3];
    for (int i = 0; i < 3; ++i) {
        const int facets = 16 << i;
        const double a = 3.141592653589793 / facets, wide = 1.15 * a;
        const Ripple even = tube_ripple(facets, 0, 0.03), uneven = tube_ripple(facets, 0.15, 0.03);
        const Ripple thick = tube_ripple(facets, 0, 0.09);
        const Ripple *const all[3] = {&even, &uneven, &thick};
        check_at_most(even.distance, 0.375 * 0.1 * pow(a, 4));
        check_at_most(uneven.distance, 0.375 * 0.1 * pow(wide, 4));
        check_at_most(thick.distance, 0.375 * 0.1 * pow(a, 4));
        lean[0][i] = uneven.lean;
        lean[1][i] = thick.lean;
        for (int k = 0; k < 3; ++k) {
            check_at_most(all[k]->jump, 0.15 * pow(a, 3));
            check_at_most(all[k]->slope, 1e-8);
            check_at_most(all[k]->turn, 2e-5);
        }
    }
    for (int k = 0; k < 2; ++k) {
        check_between(lean[k][0] / lean[k][1], 7.5, 8.5);
        check_between(lean[k][1] / lean[k][2], 7.5, 8.5);
    }
}

/* The ring of a bell-mouth, closed. */
static Vec3 ring_at(const void *of, double u, double v)
{
    const int facets = *(const int *)of;
    const double step = 6.283185307179586 / facets, around = step * (int)(2 * u * facets + 0.5) / 2;
    const double across = step * ((int)(v * facets + 0.5) % facets), rho = 0.15 + 0.05 * cos(across);
    const int last = (int)(2 * u * facets + 0.5) == 2 * facets;
    return v3(rho * (last ? 1 : cos(around)), rho * (last ? 0 : sin(around)), 0.05 * sin(across));
}

/* A tessellated bell-mouth against its distance function (OB4): curved in two directions, the distance is of the third
 * order and the normal of the second. */
TEST(test_bell_mouth)
{
    const Shape bell = {.kind = SHAPE_BELL, .axis = {0, 0, 1}, .radius = 0.05, .half_width = 0.05, .bell = {0.15}};
    double off[3], normal[3];
    for (int i = 0; i < 3; ++i) {
        const int facets = 16 << i;
        MeshBuild m = {0};
        mesh_grid(&m, "bell", ring_at, &facets, 2 * facets, facets);
        Facets *f = facets_new(&m.mesh, LAW);
        uint64_t seed = 2;
        int feet = 0;
        off[i] = normal[i] = 0;
        check_equal(f->n_edges, 0);
        for (int k = 0; k < 2000; ++k) {
            const double around = 3.14 * fixture_random(&seed), rho = 0.095 + 0.02 * fixture_random(&seed);
            const Vec3 p = v3(rho * cos(around), rho * sin(around), 0.06 * fixture_random(&seed));
            const double d = shape_distance(&bell, p);
            Foot foot[FEET_MAX];
            if (!(d > 0) || d > 0.03) continue;
            check_equal(feet_of(f, p, 0.04, foot), 1);
            ++feet;
            off[i] = larger_of(off[i], fabs(foot[0].distance - d));
            normal[i] = larger_of(normal[i], v3_norm(v3_sub(foot[0].normal, shape_probe(&bell, 0, p).normal)));
        }
        check_above(feet, 500);
        print_message("bell-mouth of %d facets: distance %.2e m, normal %.2e; the flat facets' depth %.1e m\n", facets,
                      off[i], normal[i], 0.05 * (1 - cos(3.141592653589793 / facets)));
        facets_free(f);
        mesh_done(&m);
    }
    for (int i = 0; i < 2; ++i) {
        check_above(off[i] / off[i + 1], 8);
        check_above(normal[i] / normal[i + 1], 3.9);
    }
    check_at_most(off[0], 1e-4);
}

static Vec3 seam_at(const void *of, double u, double v)
{
    const double angle = 6.283185307179586 * v;
    (void)of;
    return v3(0.4 * u, 0.031 * cos(angle) + 2e-6 * v, 0.031 * sin(angle));
}

/* A tube whose first and last corners differ by rounding has no edge there: with an edge a cable that lies on it had
 * two feet, 21 degrees apart, and a pull around a bend came out 0.4 % too high. */
TEST(test_seam)
{
    MeshBuild m = {0};
    mesh_grid(&m, "tube", seam_at, NULL, 8, 64);
    Facets *f = facets_new(&m.mesh, LAW);
    check_equal(f->n_edges, 2 * 64);
    for (int i = -50; i <= 50; ++i) {
        Foot foot[FEET_MAX];
        check_equal(feet_of(f, v3(0.2, 0.00113, 1e-5 * i), 0.03, foot), 1);
        check_close(foot[0].distance, 0.031 - hypot(0.00113, 1e-5 * i), 3e-6);
    }
    facets_free(f);
    mesh_done(&m);
}

/* A closed box against its distance function: faces, edges and corners, one foot each, and nothing inside. */
TEST(test_box)
{
    MeshBuild m = {0};
    mesh_box(&m, "box", v3(-0.2, -0.1, -0.05), v3(0.2, 0.1, 0.05));
    Facets *f = facets_new(&m.mesh, LAW);
    const Shape box = {.kind = SHAPE_BOX,
                       .axis = {1, 0, 0},
                       .half_width = 0.2,
                       .radius = 0.05,
                       .box = {.side = {0, 1, 0}, .half = {0.1, 0.05}, .edge = 1e-12}};
    uint64_t seed = 3;
    double off = 0, slope = 0, turn = 0;
    int kinds[3] = {0};
    check_equal(f->bulge, 0);
    for (int i = 0; i < 4000; ++i) {
        const Vec3 p = v3(0.3 * fixture_random(&seed), 0.2 * fixture_random(&seed), 0.15 * fixture_random(&seed));
        const double d = shape_distance(&box, p);
        Foot foot[FEET_MAX];
        const int n = feet_of(f, p, 0.06, foot);
        check_equal(n, d > 0 && d < 0.06);
        if (n == 0) continue;
        off = larger_of(off, fabs(foot[0].distance - d));
        off = larger_of(off, v3_norm(v3_sub(foot[0].normal, shape_probe(&box, 0, p).normal)) * 0.01);
        if (d > 0.005) slope = larger_of(slope, derivatives_off(f, p, 0.06, &turn));
        int beyond = -1;
        beyond += (fabs(p.x) > 0.2) + (fabs(p.y) > 0.1) + (fabs(p.z) > 0.05);
        ++kinds[beyond];
    }
    print_message("box: off %.2e, slope %.2e, turn %.2e; %d faces, %d edges, %d corners\n", off, slope, turn, kinds[0],
                  kinds[1], kinds[2]);
    check_at_most(off, 1e-11);
    check_at_most(slope, 2e-8);
    check_at_most(turn, 1e-5);
    for (int k = 0; k < 3; ++k) check_above(kinds[k], 30);
    facets_free(f);
    mesh_done(&m);
}

/* One point of the surface that a sheet has. */
static Vec3 corner_sheet(const void *of, double u, double v)
{
    const double half = *(const double *)of; /* a floor from y = -1 to 0 and a wall from z = 0 to 1 */
    const double way = 2 * v - 1 + 0 * half;
    return way < 0 ? v3(u, way, 0) : v3(u, 0, way);
}

/* A sheet with a corner: in the corner both walls are touched, on its back the edge; from both sides. */
TEST(test_corner)
{
    MeshBuild m = {0};
    const double half = 0;
    mesh_grid(&m, "sheet", corner_sheet, &half, 4, 8);
    Facets *f = facets_new(&m.mesh, LAW);
    Foot foot[FEET_MAX];
    check_equal(feet_of(f, v3(0.3, -0.02, 0.03), 0.05, foot), 2);
    check_close(foot[0].distance, 0.02, 1e-15);
    check_vec(foot[0].normal, v3(0, -1, 0), 1e-15);
    check_close(foot[1].distance, 0.03, 1e-15);
    check_vec(foot[1].normal, v3(0, 0, 1), 1e-15);
    check_equal(feet_of(f, v3(0.3, 0.03, -0.04), 0.06, foot), 1);
    check_close(foot[0].distance, 0.05, 1e-15);
    check_vec(foot[0].normal, v3(0, 0.6, -0.8), 1e-14);
    check_equal(feet_of(f, v3(0.3, 0.03, 0.04), 0.06, foot), 1);
    check_vec(foot[0].normal, v3(0, 1, 0), 1e-15);
    check_equal(feet_of(f, v3(0.3, -0.04, -0.03), 0.06, foot), 1);
    check_vec(foot[0].normal, v3(0, 0, -1), 1e-15);
    /* beyond the free end of the wall, and its corner */
    check_equal(feet_of(f, v3(0.3, 0.03, 1.04), 0.06, foot), 1);
    check_vec(foot[0].normal, v3(0, 0.6, 0.8), 1e-14);
    check_equal(feet_of(f, v3(-0.03, 0, 1.04), 0.06, foot), 1);
    check_vec(foot[0].normal, v3(-0.6, 0, 0.8), 1e-14);
    facets_free(f);
    mesh_done(&m);
}

/* Two boxes side by side, whose sides do not share corners and are 5 um apart, bear like one; a thin plate is touched
 * on the side from which the cable comes, though the other one is within its radius. */
TEST(test_boxes_that_meet)
{
    MeshBuild m = {0};
    mesh_box(&m, "plate", v3(-1, -1, -0.002), v3(0, 1, 0));
    mesh_box(&m, "plate", v3(5e-6, -1, -0.002), v3(1, 1, 0));
    mesh_box(&m, "left out", v3(-1, -1, 0.01), v3(1, 1, 0.02));
    const int law[3] = {0, -1};
    Facets *f = facets_new(&m.mesh, law);
    for (int i = -200; i <= 200; ++i) {
        Foot foot[FEET_MAX];
        check_equal(feet_of(f, v3(1e-7 * i, 0.1, 0.03), 0.05, foot), 1);
        check_close(foot[0].distance, 0.03, 1.7e-9);
        check_vec(foot[0].normal, v3(0, 0, 1), 3.4e-4); /* over the gap it is an edge, up to 10 um away */
    }
    facets_free(f);
    mesh_done(&m);
}

/* Triangles in any order of their corners: a sheet of them is smooth all the same. */
TEST(test_corners_in_any_order)
{
    MeshBuild m = {0};
    const TubeShape tube = {.radius = 0.1, .length = 0.4, .facets = 32};
    mesh_tube(&m, &tube, 4);
    uint64_t seed = 8;
    for (int t = 0; t < m.mesh.n_triangles; ++t) {
        int *const c = m.mesh.triangle[t], swap = c[0];
        if (fixture_random(&seed) < 0) continue;
        c[0] = c[1];
        c[1] = swap;
    }
    Facets *f = facets_new(&m.mesh, LAW);
    Foot foot[FEET_MAX];
    for (int i = 0; i < 100; ++i) {
        const Vec3 p = v3(0.2, 0.06 * cos(i), 0.06 * sin(i));
        check_equal(feet_of(f, p, 0.05, foot), 1);
        check_close(foot[0].distance, 0.04, 3.5e-6);
    }
    check_equal(f->n_edges, 2 * 32);
    facets_free(f);
    mesh_done(&m);
}

/* A trough of two walls and a round bottom that is narrower than the cable: it touches both walls, not the bottom. */
static Vec3 trough_at(const void *of, double u, double v)
{
    const double r = *(const double *)of, way = v * 12 - 6, turn = fmax(-1, fmin(1, way / 3)) * 0.78539816339744831;
    const double along = fmax(0, fabs(way) - 3) * 0.06 * (way < 0 ? -1 : 1), c = cos(turn), s = sin(turn);
    return v3(u, r * s + along * c, -r * c + along * s * 1);
}

TEST(test_trough)
{
    MeshBuild m = {0};
    const double r = 0.02;
    mesh_grid(&m, "trough", trough_at, &r, 4, 12);
    Facets *f = facets_new(&m.mesh, LAW);
    Foot foot[FEET_MAX];
    const int n = feet_of(f, v3(0.4, 0.001, 0.04), 0.05, foot);
    check_equal(n, 2);
    check_close(foot[0].distance, 0.02 + 0.04 * sqrt(0.5) - 0.001 * sqrt(0.5), 1e-9);
    check_close(foot[1].distance, 0.02 + 0.04 * sqrt(0.5) + 0.001 * sqrt(0.5), 1e-9);
    facets_free(f);
    mesh_done(&m);
}

/* Every allocation fails once: no mesh is built, nothing is left, and the next try succeeds. */
TEST(test_lack)
{
    MeshBuild m = {0};
    mesh_box(&m, "box", v3(0, 0, 0), v3(1, 1, 1));
    if (!lack_works()) {
        mesh_done(&m);
        skip();
    }
    const long live = lack_live();
    int met = 1, lacked = 0;
    for (int k = 0; met; ++k) {
        lack_after(k);
        Facets *const f = facets_new(&m.mesh, LAW);
        met = lack_end();
        assert_true(met || f);
        lacked += !f;
        facets_free(f);
        check_equal(lack_live(), live);
    }
    check_between(lacked, 12, 20);
    mesh_done(&m);
}
