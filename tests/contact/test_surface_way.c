/* Ducts along curves: how far their arcs lie beside the route. */
#include <stdlib.h>

#include "contact/surface/surface_patch.h"
#include "core/base/worst.h"
#include "tests/support/check.h"

/* What the patch that owns p says; exactly one does. */
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

static void ducts_follow_curves(void **state)
{
    (void)state;
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
    const SurfaceShape shapes[2] = {
        {.kind = SURFACE_DUCT, .from = 1, .to = route.length - 1, .fade = 0.5, .cable_radius = 0.02, .radius = 0.1},
        {.kind = SURFACE_FLAT,
         .from = 1,
         .to = route.length - 1,
         .fade = 0.5,
         .cable_radius = 0.02,
         .width = 0.4,
         .depth = 0.1},
    };
    for (int k = 0; k < 2; ++k) {
        const int n = surface_patch_count(&shapes[k], &route);
        SurfacePatch *const patch = malloc((size_t)n * sizeof *patch);
        surface_patches(&shapes[k], &route, 0, patch);
        double worst = 0, tilt = 0;
        for (double s = 1.3; s < route.length - 1.3; s += 0.00731) {
            const SurfaceProbe at = probe_all(n, patch, route_at(&route, s).position, 0.1);
            worst = larger_of(worst, fabs(at.distance - 0.1));
            if (k == 0) continue;
            const Vec3 up = v3_cross(route_at(&route, s).tangent, route_left(&route, s));
            tilt = larger_of(tilt, v3_norm(v3_sub(at.normal, up)));
        }
        check_at_most(worst, 1e-4);
        check_at_most(tilt, 0.03);
        free(patch);
    }
    route_clear(&route);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(ducts_follow_curves)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
