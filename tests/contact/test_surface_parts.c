/* Surfaces in small, and along curves: bends tighter than a metre, stretches shorter than one, where sides and
 * stretches end, who is a candidate, and what the details say. */
#include <stdlib.h>

#include "tests/support/touch.h"

/* The one patch that owns p near its surface. */
static SurfaceProbe probe_of(const SurfaceScene *s, Vec3 p)
{
    SurfaceProbe found = {.distance = NAN};
    int owners = 0;
    for (int f = 0; f < s->model.n_patches; ++f) {
        const SurfaceProbe at = surface_probe(&s->patch[f], p);
        if (!at.owned || fabs(at.distance) > 0.15) continue;
        found = at;
        ++owners;
    }
    assert_int_equal(owners, 1);
    return found;
}

/* A duct of 0.1 m along bends of 0.3 to 0.9 m, which may be the first piece: everywhere as far as it is wide. */
TEST(test_tight_bends)
{
    for (int k = 0; k < 6; ++k) {
        const double radius = 0.3 + 0.3 * (k % 3);
        const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 1},
                                     {.kind = ROUTE_BEND, .radius = radius, .angle = 2, .plane = 0.4 * k},
                                     {.kind = ROUTE_STRAIGHT, .length = 1}};
        const int first = k / 3; /* without the first straight */
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 3 - first, def + first, 0);
        SurfaceShape duct = surfaces_shape(SURFACE_DUCT, 0.2, s.route.length - 0.2);
        surfaces_add(&s, &duct);
        for (double at = 0.01; at < s.route.length - 0.01; at += 0.0137) {
            const RoutePoint on = route_at(&s.route, at);
            const Vec3 left = route_left(&s.route, at), up = v3_cross(on.tangent, left);
            const double inside = at < 0.4                    ? (at < 0 ? 0 : at / 0.4)
                                  : at > s.route.length - 0.4 ? (s.route.length - at) / 0.4
                                                              : 1;
            for (int side = 0; side < 5; ++side) {
                const Vec3 off = side == 0 ? V3_ZERO : v3_scale(side % 2 ? 0.06 : -0.06, side < 3 ? left : up);
                const SurfaceProbe found = probe_of(&s, v3_add(on.position, off));
                check_close(found.distance, side == 0 ? 0.1 : 0.04, 1e-12);
                if (side) check_vec(found.normal, v3_scale(-1 / 0.06, off), 1e-9);
                check_close(found.share, inside * inside * (3 - 2 * inside), 1e-9);
            }
        }
        surfaces_free(&s);
    }
}

/* A floor with walls along a straight, and a plane with ends: what is where, by the shape's own numbers. */
TEST(test_ends_of_sections)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    SurfaceScene s;
    surfaces_new(&s, 2, 0.5);
    surfaces_route(&s, 1, &straight, 0);
    SurfaceShape floor = surfaces_shape(SURFACE_FLAT, 2, 18);
    floor.height = 0.1;
    surfaces_add(&s, &floor);
    assert_int_equal(s.model.n_patches, 3);
    const double half = floor.width / 2, band = floor.cable_radius;
    for (int k = -60; k <= 60; ++k) {
        const double y = 0.005 * k, x = 10, out = (fabs(y) - half + band / 2) / band;
        const double gone = out < 0 ? 0 : out > 1 ? 1 : out * out * (3 - 2 * out);
        const Vec3 p = v3(x, y, 0.01);
        const SurfaceProbe bottom = surface_probe(&s.patch[0], p);
        check_close(bottom.distance, floor.depth + 0.01, 1e-15);
        check_close(bottom.share, 1 - gone, 1e-12);
        for (int w = 0; w < 2; ++w) {
            const SurfaceProbe wall = surface_probe(&s.patch[1 + w], p);
            check_close(wall.distance, half + (w ? y : -y), 1e-15);
            check_vec(wall.normal, v3(0, w ? 1 : -1, 0), 1e-15);
            check_equal(wall.share, 1);
            const double top = floor.height - floor.depth;
            check_equal(surface_probe(&s.patch[1 + w], v3(x, y, top - 1e-9)).share, 1);
            check_close(surface_probe(&s.patch[1 + w], v3(x, y, top + band / 2)).share, 0.5, 1e-12);
            check_equal(surface_probe(&s.patch[1 + w], v3(x, y, top + band + 1e-9)).share, 0);
        }
    }
    surfaces_free(&s);
}

/* Planes 0.3 to 3 m long and wide about their point: full within, half at their ends, nothing beyond. */
TEST(test_planes)
{
    for (int k = 0; k < 4; ++k) {
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        SurfaceShape plane = surfaces_shape(SURFACE_PLANE, 0, 0);
        plane.point = v3(7, -2, 0.5);
        plane.fade = 0.1;
        plane.length = k < 2 ? 0.3 : 3;
        plane.width = k % 2 ? 0.5 : 2;
        surfaces_add(&s, &plane);
        for (int side = -1; side <= 1; side += 2) {
            static const double off[] = {0.9, 1, 1.1};
            for (int d = 0; d < 2; ++d) {
                const double half = (d ? plane.width : plane.length) / 2;
                const double at[] = {half - 0.0501, half, half + 0.0501}, share[] = {1, 0.5, 0};
                for (int i = 0; i < 3; ++i) {
                    const double x = d ? 0 : side * at[i], y = d ? side * at[i] : 0;
                    const SurfaceProbe found = surface_probe(&s.patch[0], v3_add(plane.point, v3(x, y, 0.02 * off[i])));
                    check_close(found.share, share[i], 1e-9);
                    check_close(found.distance, 0.02 * off[i], 1e-14);
                    check_vec(found.normal, v3(0, 0, 1), 1e-15);
                    assert_int_equal(found.owned, d || i < 2);
                }
            }
        }
        surfaces_free(&s);
    }
}

/* (DU13): the elements with a point within reach of the patch, and no others, for stretches from 0.3 m on. */
TEST(test_candidates)
{
    enum { N = 70 };
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 40};
    for (int k = 0; k < 6; ++k) {
        const double from = 3 + 4.7 * k, length = k % 2 ? 0.3 : 4;
        SurfaceScene s;
        surfaces_new(&s, N, 0.5);
        surfaces_points(&s, k % 3 ? GEOMETRY_SMOOTH : GEOMETRY_CYLINDER);
        surfaces_route(&s, 1, &straight, 0);
        SurfaceShape floor = surfaces_shape(SURFACE_FLAT, from, from + length);
        floor.fade = 0.1;
        surfaces_add(&s, &floor);
        s.model.reach = 0.07;
        for (int i = 0; i < N; ++i) s.kin.p[2][i] = 0.069 - 0.004 * i; /* from within reach to far behind */
        for (int half = 0; half < 2; ++half) {                         /* elements of the second half alone */
            surface_pairs_init(&s.pairs, half ? N / 2 : 0, s.points.elements);
            surfaces_refresh(&s);
            int count = 0;
            for (int e = 0; e < s.points.elements; ++e) {
                int near = 0, there = 0;
                for (int q = 0; q < SURFACE_POINTS; ++q) {
                    Vec3 p = V3_ZERO;
                    const double alpha[2] = {1 - s.points.alpha[q][e], s.points.alpha[q][e]};
                    for (int b = 0; b < 2; ++b) {
                        const int i = e - 1 + b;
                        if (i < 0 || i >= N) continue;
                        p = v3_axpy(v3_axpy(p, alpha[b], vec_load(s.kin.p, i)),
                                    s.points.beta[q][b][e] * s.chain.half[i], vec_load(s.kin.a, i));
                    }
                    const double g = p.z + floor.depth, on = p.x - (from - 0.05);
                    near |= g < CABLE_RADIUS + 0.07 && g > -SURFACE_DEPTH_MAX - 0.07 && on >= -0.07 &&
                            on < length + 0.1 + 0.07;
                }
                for (int r = 0; r < s.pairs.n_ranges; ++r) {
                    const SurfaceRange *const range = &s.pairs.range[r];
                    there += e >= range->first && e < range->first + range->count;
                }
                assert_int_equal(there, near && e >= s.pairs.from);
                count += there;
            }
            assert_int_equal(count, s.pairs.candidates);
            if (!half && k < 5) check_above(count, 0);
            surface_pairs_free(&s.pairs);
        }
        surfaces_free(&s);
    }
}

/* On one plane as on forty in the same place, of which each presses as much; the details are the points that carry
 * force, where they are, and add up. */
TEST(test_details)
{
    enum { N = 21, MANY = 40 };
    for (int geometry = 0; geometry < 2; ++geometry) {
        SurfaceScene s;
        double before = 0;
        surfaces_new(&s, N, 0.5);
        surfaces_points(&s, geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH);
        SurfaceShape plane = surfaces_shape(SURFACE_PLANE, 0, 0);
        plane.point = v3(0, 0, -CABLE_RADIUS);
        plane.length = plane.width = 0;
        surfaces_add(&s, &plane);
        for (int i = 0; i < N; ++i) {
            s.kin.p[2][i] = -2e-4 + 4e-5 * i; /* a few press */
            s.kin.v[1][i] = 0.1;
        }
        for (int many = 1; many <= MANY; many += MANY - 1) {
            for (int k = 1; k < many; ++k) s.patch[k] = s.patch[0];
            s.model.n_patches = many;
            surfaces_refresh(&s);
            surfaces_refresh(&s); /* into the same memory */
            assert_int_equal(s.pairs.n_ranges, many);
            assert_int_equal(s.pairs.candidates, many * s.points.elements);
            surfaces_forces(&s, 1);
            const double normal = s.tally[0].normal;
            if (many > 1) check_share(normal, many * before, 1e-12);
            before = normal;
            SurfaceDetail detail[MANY * (N + 1) * SURFACE_POINTS];
            Loads scratch;
            assert_true(chain_struct_alloc(&scratch, N));
            const int count = surface_details(&s.model, &s.chain, &s.kin, &s.pairs, &scratch, detail);
            assert_int_equal(count, s.pairs.active);
            check_between(count, 3 * many, 2 * N * many);
            Vec3 force = V3_ZERO;
            double sum = 0;
            for (int k = 0; k < count; ++k) {
                const SurfaceDetail *const d = &detail[k];
                const int e = d->element, q = d->point_number;
                const double alpha = s.points.alpha[q][e];
                double z = 0, x = 0;
                for (int b = 0; b < 2; ++b) {
                    const int i = e - 1 + b;
                    if (i < 0 || i >= N) continue;
                    z += (b ? alpha : 1 - alpha) * s.kin.p[2][i];
                    x += (b ? alpha : 1 - alpha) * s.kin.p[0][i] + s.points.beta[q][b][e] * s.chain.half[i];
                }
                check_close(d->gap, z, 1e-15);
                check_vec(d->point, v3(x, 0, z), 1e-12);
                check_vec(d->toward, v3(0, 0, 1), 1e-15);
                check_share(d->normal, s.points.length[q][e] * 3e8 * pow(-z, 1.5), 1e-9);
                check_share(d->force.y, -0.2 * d->normal, 1e-9);
                assert_int_equal(d->surface, 0);
                force = v3_add(force, d->force);
                sum += d->normal;
            }
            check_share(sum, normal, 1e-12);
            check_vec(force, v3_scale(-1, s.tally[0].force), 1e-9 * normal);
            chain_struct_free(&scratch);
        }
        surfaces_free(&s);
    }
}

/* What the patch of a part of the way that owns p says; exactly one does. */
static SurfaceProbe probe_all(int n, const SurfacePatch *patch, Vec3 p, double near)
{
    SurfaceProbe found = {.distance = NAN};
    int owners = 0;
    for (int i = 0; i < n; ++i) {
        const SurfaceProbe at = surface_probe(&patch[i], p);
        if (!at.owned || fabs(at.distance - near) > 0.1) continue; /* a part elsewhere on the way */
        found = at;
        ++owners;
    }
    assert_int_equal(owners, 1);
    return found;
}

/* Ducts along curves: how far their arcs lie beside the route. */
TEST(test_curves)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_CUBIC, .cubic = {{10, 0, 4.2279}, {0, 6, -1}, {1, -5, 2}}},
        {.kind = ROUTE_STRAIGHT, .length = 5},
        {.kind = ROUTE_CURVE, .length = 8, .curvature = {0, 0.2}, .upright = 1},
        {.kind = ROUTE_CURVE, .length = 7, .curvature = {0.2, 0.2}, .upright = 1},
        {.kind = ROUTE_CURVE,
         .length = 9,
         .curvature = {0.2, -0.1},
         .upright = 1,
         .profile = PROFILE_ARC,
         .slope_end = 0},
        {.kind = ROUTE_CURVE, .length = 9, .upright = 1, .profile = PROFILE_PARABOLA, .slope_end = 0.4},
    };
    Route route;
    assert_int_equal(route_build(&route, 6, def, V3_ZERO, 0, 0.4, NULL), HAWSER_OK);
    const SurfaceShape shapes[3] = {
        {.kind = SURFACE_DUCT, .from = 1, .to = route.length - 1, .fade = 0.5, .cable_radius = 0.02, .radius = 0.1},
        {.kind = SURFACE_FLAT,
         .from = 1,
         .to = route.length - 1,
         .fade = 0.5,
         .cable_radius = 0.02,
         .width = 0.4,
         .depth = 0.1},
        /* from the very beginning, which is a curve */
        {.kind = SURFACE_DUCT, .from = 0.25, .to = 7, .fade = 0.5, .cable_radius = 0.02, .radius = 0.1},
    };
    for (int k = 0; k < 3; ++k) {
        const int n = surface_patch_count(&shapes[k], &route);
        SurfacePatch *const patch = malloc((size_t)n * sizeof *patch);
        surface_patches(&shapes[k], &route, 0, patch);
        double worst = 0, tilt = 0;
        for (double s = k == 2 ? 0 : 1.3; s < (k == 2 ? 7.2 : route.length - 1.3); s += 0.00731) {
            const SurfaceProbe at = probe_all(n, patch, route_at(&route, s).position, 0.1);
            worst = larger_of(worst, fabs(at.distance - 0.1));
            if (k != 1) continue;
            const Vec3 up = v3_cross(route_at(&route, s).tangent, route_left(&route, s));
            tilt = larger_of(tilt, v3_norm(v3_sub(at.normal, up)));
        }
        check_at_most(worst, 1e-4);
        check_at_most(tilt, 0.03);
        free(patch);
    }
    route_clear(&route);
}

/* Curves that stand upright, where nothing is level on the left: a duct is as far all around, a floor lies beside the
 * way, square to it; also where they lean out of it in any direction. */
TEST(test_upright_curves)
{
    for (int k = 0; k < 9; ++k) {
        const double lean = k ? 0.8 : 0, turn = 0.7 * k, ways[2] = {lean * cos(turn), lean * sin(turn)};
        const RoutePieceDef up = {.kind = ROUTE_CUBIC, .cubic = {{0, 0, 10}, {ways[0], ways[1], 0}, {0, 0, 0}}};
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 1, &up, 0);
        SurfaceShape shape = surfaces_shape(SURFACE_DUCT, -1, s.route.length + 1);
        surfaces_add(&s, &shape);
        for (double at = 0.01; at < s.route.length; at += 0.37) {
            const RoutePoint on = route_at(&s.route, at);
            for (int side = 0; side < 8; ++side) {
                const Vec3 level = v3(cos(0.8 * side), sin(0.8 * side), 0);
                const Vec3 off = v3_scale(0.06, v3_unit(v3_reject(level, on.tangent)));
                const SurfaceProbe found = probe_of(&s, v3_add(on.position, off));
                check_close(found.distance, 0.04, 1e-4);
                check_vec(found.normal, v3_scale(-1 / 0.06, off), 2e-3);
            }
        }
        surfaces_free(&s);
        if (k) continue;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 1, &up, 0);
        shape = surfaces_shape(SURFACE_FLAT, -1, s.route.length + 1);
        surfaces_add(&s, &shape);
        for (double at = 0.01; at < s.route.length; at += 0.37) {
            const SurfaceProbe found = probe_of(&s, route_at(&s.route, at).position);
            check_close(found.distance, shape.depth, 1e-12);
            check_close(v3_norm(found.normal), 1, 1e-12);
            check_close(found.normal.z, 0, 1e-12);
        }
        surfaces_free(&s);
    }
}

/* A V's planes are as far from a cable that lies in it as it is thick, wherever its bottom is; from there on the
 * distance grows by the planes' slopes. */
TEST(test_v_at_any_depth)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    for (int k = 0; k < 12; ++k) {
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 1, &straight, 0);
        SurfaceShape v = surfaces_shape(SURFACE_V, 2, 18);
        v.depth = 0.02 + 0.015 * k;
        v.angle = 1 + 0.1 * k;
        surfaces_add(&s, &v);
        assert_int_equal(s.model.n_patches, 2);
        const double r = v.cable_radius, sine = sin(v.angle / 2), cosine = cos(v.angle / 2);
        for (int i = -5; i <= 5; ++i) {
            const double y = 0.002 * i, up = 0.003 * i, z = r - v.depth + up;
            for (int side = 0; side < 2; ++side) {
                const SurfaceProbe found = surface_probe(&s.patch[side], v3(10, y, z));
                const double toward = side ? 1 : -1; /* as walls: checkpoints keep what sticks by faces' numbers */
                check_close(found.distance, r + toward * cosine * y + sine * up, 1e-14);
                check_vec(found.normal, v3(0, toward * cosine, sine), 1e-14);
            }
        }
        surfaces_free(&s);
    }
}

/* Candidates are the same ones along any way across the country: along x, along y, aslant. */
TEST(test_candidates_along_any_way)
{
    enum { N = 70, WAYS = 8 };
    for (int k = 0; k < WAYS; ++k) {
        const double turn = 2 * 3.14159265358979 * k / WAYS;
        const Vec3 along = v3(cos(turn), sin(turn), 0);
        for (int from = 1; from < N - 4; from += 7) {
            SurfaceScene s;
            surfaces_new(&s, N, 0.5);
            surfaces_points(&s, GEOMETRY_SMOOTH);
            s.model.reach = 0.07;
            SurfaceShape plane = surfaces_shape(SURFACE_PLANE, 0, 0);
            plane.point = v3_axpy(v3(3, -2, -CABLE_RADIUS), 0.5 * from, along);
            plane.along = along;
            plane.length = 0.9;
            plane.width = 1;
            surfaces_add(&s, &plane);
            for (int i = 0; i < N; ++i) {
                vec_store(s.kin.p, i, v3_axpy(v3(3, -2, 0), 0.5 * i, along));
                vec_store(s.kin.a, i, along);
            }
            surface_pairs_init(&s.pairs, 0, s.points.elements);
            surfaces_refresh(&s);
            assert_int_equal(s.pairs.n_ranges, 1);
            const SurfaceRange *const range = &s.pairs.range[0];
            assert_true(range->first <= from && from < range->first + range->count);
            check_between(range->count, 1, 5);
            surface_pairs_free(&s.pairs);
            surfaces_free(&s);
        }
    }
}

/* Where a straight cable is pressed evenly on one floor after the other, each is said to carry its own spring's force,
 * whatever the one before carries; what was known before and is more stays. */
TEST(test_pressed)
{
    enum { N = 40 };
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 40};
    SurfaceScene s;
    surfaces_new(&s, N, 0.5);
    surfaces_points(&s, GEOMETRY_SMOOTH);
    s.model.reach = 0.07;
    surfaces_route(&s, 1, &straight, 0);
    const double depth[] = {2e-3, 5e-3, 1e-3};
    for (int k = 0; k < 3; ++k) {
        SurfaceShape floor = surfaces_shape(SURFACE_FLAT, 1 + 6 * k, 5 + (k == 0 ? 1 : 6 * k));
        floor.depth = CABLE_RADIUS - depth[k];
        surfaces_add(&s, &floor);
    }
    assert_int_equal(s.model.n_patches, 3);
    for (int i = 0; i < N; ++i) vec_store(s.kin.p, i, v3(0.25 + 0.5 * i, 0, 0));
    surface_pairs_init(&s.pairs, 0, s.points.elements);
    surfaces_refresh(&s);
    double pressed[3] = {0, 0, 1e9};
    surface_pressed(&s.model, &s.chain, &s.kin, &s.pairs, pressed);
    for (int k = 0; k < 2; ++k) check_share(pressed[k], s.model.impact.k * pow(depth[k], s.model.impact.e), 1e-9);
    check_equal(pressed[2], 1e9);
    surface_pairs_free(&s.pairs);
    surfaces_free(&s);
}

/* The section's axis that is level on the left where the route has this tangent, by its definition (R2). */
static Vec3 level(Vec3 tangent) { return v3_unit(v3(-tangent.y, tangent.x, 0)); }

/* Trays along what bends and climbs at once: at both ends of every arc the section stands level (DU6). */
TEST(test_level_at_both_ends)
{
    const RoutePieceDef def[] = {
        {.kind = ROUTE_CUBIC, .cubic = {{10, 0, 4.2279}, {0, 6, -1}, {1, -5, 2}}},
        {.kind = ROUTE_STRAIGHT, .length = 5},
        {.kind = ROUTE_BEND, .radius = 4, .angle = 2.5, .plane = 0.7},
        {.kind = ROUTE_STRAIGHT, .length = 5},
    };
    Route route;
    assert_int_equal(route_build(&route, 4, def, V3_ZERO, 0, 0.4, NULL), HAWSER_OK);
    SurfaceShape tray = surfaces_shape(SURFACE_FLAT, 0.5, route.length - 0.5);
    const int n = surface_patch_count(&tray, &route);
    SurfacePatch *const patch = malloc((size_t)n * sizeof *patch);
    surface_patches(&tray, &route, 0, patch);
    int twisted = 0;
    for (int i = 0; i < n; ++i) {
        const SurfacePatch *const p = &patch[i];
        if (!p->twisted) continue;
        for (int end = 0; end < 2; ++end) {
            const double turn = end ? p->length / p->bend : 0;
            const Vec3 side = v3_axpy(v3_scale(cos(turn), p->side), -sin(turn), p->tangent);
            const Vec3 axis = v3_axpy(v3_scale(cos(p->roll[end]), side), sin(p->roll[end]), p->up);
            /* arcs meet their ends' tangents to rounding over a length of metres */
            check_vec(axis, level(end ? p->end_tangent : p->tangent), 1e-10);
        }
        ++twisted;
    }
    check_above(twisted, 8);
    free(patch);
    route_clear(&route);
}

/* Where a cable in a bent duct presses most is said along the route: between the two points of the element that does,
 * weighted by what they carry, at the bend's radius times the angle about its centre. */
TEST(test_most_pressed_in_bends)
{
    enum { N = 4 };
    const double radius = 3, first = 1, deep = 2e-3;
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = first},
                                 {.kind = ROUTE_BEND, .radius = radius, .angle = 3},
                                 {.kind = ROUTE_STRAIGHT, .length = 1}};
    for (int k = 0; k < 12; ++k) {
        SurfaceScene s;
        SurfaceDetail detail[SURFACE_POINTS * (N + 1) * 4];
        surfaces_new(&s, N, 0.2);
        surfaces_points(&s, GEOMETRY_SMOOTH);
        surfaces_route(&s, 3, def, 0);
        SurfaceShape duct = surfaces_shape(SURFACE_DUCT, 0.2, s.route.length - 0.2);
        surfaces_add(&s, &duct);
        surfaces_lay(&s, first + 0.6 * k, 0, -(duct.radius - CABLE_RADIUS)); /* on the bottom, */
        for (int i = 0; i < N; ++i) s.kin.p[2][i] -= deep * (i + 1) / N;     /* and deeper toward the head */
        surfaces_refresh(&s);
        surfaces_forces(&s, 0);
        Loads scratch;
        assert_true(chain_struct_alloc(&scratch, N));
        const int count = surface_details(&s.model, &s.chain, &s.kin, &s.pairs, &scratch, detail);
        double sum = 0, moment = 0;
        for (int d = 0; d < count; ++d) {
            if (detail[d].element != N) continue; /* the head's half */
            const Vec3 off = v3_sub(detail[d].point, v3(first, radius, 0));
            sum += detail[d].normal;
            moment += detail[d].normal * (first + radius * atan2(off.x, -off.y));
        }
        check_above(sum, 0);
        check_close(s.tally[0].at, moment / sum, 1e-12);
        check_between(s.tally[0].at, first + 0.6 * k + 0.7, first + 0.6 * k + 0.8);
        chain_struct_free(&scratch);
        surfaces_free(&s);
    }
}

/* A part that begins where the beginning has faded in, and ends where the end begins to fade, needs no weight; those
 * before and behind it do. */
TEST(test_parts_between_the_fades)
{
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 2},
                                 {.kind = ROUTE_STRAIGHT, .length = 3},
                                 {.kind = ROUTE_STRAIGHT, .length = 2}};
    SurfaceScene s;
    surfaces_new(&s, 2, 0.5);
    surfaces_route(&s, 3, def, 0);
    SurfaceShape duct = surfaces_shape(SURFACE_DUCT, 1.75, 5.25);
    duct.fade = 0.5; /* numbers without rounding */
    surfaces_add(&s, &duct);
    assert_int_equal(s.model.n_patches, 3);
    for (int k = 0; k < 3; ++k) assert_int_equal(s.patch[k].along.used, k != 1);
    for (double x = 1.375; x < 5.75; x += 0.125) {
        const double in = (x - 1.5) / 0.5, out = (5.5 - x) / 0.5, least = fmax(0, fmin(1, fmin(in, out)));
        double share = 0;
        for (int k = 0; k < 3; ++k) {
            const SurfaceProbe at = surface_probe(&s.patch[k], v3(x, 0, 0));
            if (at.owned) share += at.share;
        }
        check_close(share, least * least * (3 - 2 * least), 1e-15);
    }
    surfaces_free(&s);
}

/* What the points are presumed to press with does not depend on how many parts the way has: each point is one part's,
 * though its element is a candidate of the next one too. */
TEST(test_presumed_across_parts)
{
    enum { N = 17, PARTS = 4 };
    const RoutePieceDef def[PARTS] = {{.kind = ROUTE_STRAIGHT, .length = 2.1},
                                      {.kind = ROUTE_STRAIGHT, .length = 1.7},
                                      {.kind = ROUTE_STRAIGHT, .length = 2.3},
                                      {.kind = ROUTE_STRAIGHT, .length = 3}};
    const Presume gaps = {.from = PRESUME_GAPS}, last = {.from = PRESUME_LAST, .gravity = 10};
    const double depth = 1e-3, carried[PARTS] = {40, 50, 60, 70}; /* N/m, by part */
    SurfaceScene s;
    surfaces_new(&s, N, 0.5);
    surfaces_points(&s, GEOMETRY_SMOOTH);
    surfaces_route(&s, PARTS, def, 0);
    SurfaceShape floor = surfaces_shape(SURFACE_FLAT, -1, 9.5);
    floor.depth = CABLE_RADIUS - depth;
    surfaces_add(&s, &floor);
    assert_int_equal(s.model.n_patches, PARTS + 2); /* before and behind the route too */
    surfaces_refresh(&s);
    check_above(s.pairs.candidates, N + 1);
    for (int k = 0; k < 2; ++k) {
        const double before[PARTS + 2] = {30, carried[0], carried[1], carried[2], carried[3], 80};
        SurfacePresumed out = {0};
        assert_true(surface_presume(&s.model, &s.chain, &s.kin, &s.pairs, k ? &last : &gaps, before, &out));
        for (int e = 0; e <= N; ++e) {
            for (int q = 0; q < SURFACE_POINTS; ++q) {
                const Element element = element_at(GEOMETRY_SMOOTH, N, e);
                const double gauss = 0.5 + (q ? 1 : -1) / sqrt(12);
                const double u = e == 0 ? (q ? 2.0 / 3 : 0) : e == N ? (q ? 1 : 1.0 / 3) : gauss;
                const double x = element_point(&element, &s.chain, &s.kin, u).x;
                const int part = (x >= 2.1) + (x >= 3.8) + (x >= 6.1);
                const double expected = k ? carried[part] : 3e8 * pow(depth, 1.5);
                check_share(out.bed[0][q][e], expected, 1e-11); /* the depth is known to 1e-17 m */
            }
        }
        surface_presumed_free(&out);
    }
    surfaces_free(&s);
}

/* As many patches are written as are counted, and nothing behind them. */
TEST(test_as_many_as_counted)
{
    static const SurfaceKind kinds[] = {SURFACE_DUCT, SURFACE_FLAT, SURFACE_V, SURFACE_U, SURFACE_PLANE};
    const RoutePieceDef def[] = {{.kind = ROUTE_STRAIGHT, .length = 3},
                                 {.kind = ROUTE_BEND, .radius = 4, .angle = 1.2},
                                 {.kind = ROUTE_CUBIC, .cubic = {{10, 0, 0}, {0, 6, 0}, {1, -5, 0}}}};
    for (int k = 0; k < 6; ++k) { /* the last: a floor with walls */
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 3, def, 0);
        SurfaceShape shape = surfaces_shape(kinds[k < 5 ? k : 1], 1, s.route.length + 1);
        if (k == 5) shape.height = 0.1;
        const int n = surface_patch_count(&shape, &s.route);
        const size_t size = (size_t)n * sizeof(SurfacePatch), behind = 3 * sizeof(SurfacePatch);
        unsigned char *const bytes = malloc(size + behind);
        memset(bytes, 0x5a, size + behind);
        surface_patches(&shape, &s.route, 3, (SurfacePatch *)(void *)bytes);
        for (size_t i = size; i < size + behind; ++i) assert_int_equal(bytes[i], 0x5a);
        for (int i = 0; i < n; ++i) assert_int_equal(((const SurfacePatch *)(const void *)bytes)[i].surface, 3);
        free(bytes);
        surfaces_free(&s);
    }
}

/* A trough is the lower half of a tube that touches its bottom, with upright sides from its centre on. */
TEST(test_u_at_any_depth)
{
    const RoutePieceDef straight = {.kind = ROUTE_STRAIGHT, .length = 20};
    for (int k = 0; k < 8; ++k) {
        SurfaceScene s;
        surfaces_new(&s, 2, 0.5);
        surfaces_route(&s, 1, &straight, 0);
        SurfaceShape u = surfaces_shape(SURFACE_U, 2, 18);
        u.depth = 0.02 + 0.02 * k;
        u.radius = 0.08 + 0.01 * k;
        surfaces_add(&s, &u);
        assert_int_equal(s.model.n_patches, 1);
        const double centre = u.radius - u.depth; /* above the route */
        check_close(surface_probe(&s.patch[0], V3_ZERO).distance, centre > 0 ? u.depth : u.radius, 1e-15);
        for (int i = -6; i <= 6; ++i) {
            for (int j = -6; j <= 6; ++j) {
                const double y = 0.01 * i + 0.003, z = 0.01 * j + 0.002, off = hypot(y, z);
                const SurfaceProbe found = surface_probe(&s.patch[0], v3(10, y, centre + z));
                check_close(found.distance, u.radius - (z > 0 ? fabs(y) : off), 1e-14);
                check_vec(found.normal, z > 0 ? v3(0, y > 0 ? -1 : 1, 0) : v3(0, -y / off, -z / off), 1e-12);
            }
        }
        surfaces_free(&s);
    }
}

/* Behind a route that ends in a curve, as before one that begins with one, the way is one straight. */
TEST(test_way_beyond_curves)
{
    const RoutePieceDef def = {.kind = ROUTE_CUBIC, .cubic = {{10, 0, 1}, {0, 6, 0}, {1, -5, 0}}};
    Route route;
    assert_int_equal(route_build(&route, 1, &def, V3_ZERO, 0, 0, NULL), HAWSER_OK);
    const double ends[2][2] = {{-2, 0}, {route.length, route.length + 2}};
    for (int k = 0; k < 2; ++k) {
        SurfacePatch way[SURFACE_WAY_MAX];
        double s = ends[k][0];
        assert_int_equal(surface_way(&route, &s, ends[k][1], 1, way), 1);
        check_equal(s, ends[k][1]);
        check_equal(way[0].bend, 0);
        check_equal(way[0].length, 2);
        const RoutePoint at = route_at(&route, k ? route.length : 0);
        check_vec(way[0].tangent, at.tangent, 1e-15);
        check_vec(k ? way[0].start : way[0].end, at.position, 1e-15);
    }
    double s = 0;
    SurfacePatch way[SURFACE_WAY_MAX];
    assert_int_equal(surface_way(&route, &s, route.length, 1, way), 2);
    route_clear(&route);
}
