/* A pull in a vertical plane of any heading, with everything that the planar equations know; and random states in it.
 */
#ifndef HAWSER_TESTS_SIM_PLANAR_FIXTURE_H
#define HAWSER_TESTS_SIM_PLANAR_FIXTURE_H

#include "sim/planar/plane.h"
#include "tests/sim/scene_fixture.h"

/* fixture_pull, but the route's bend to the left becomes a sag, and all rollers lie below the route, some off centre.
 */
static inline void fixture_planar(SceneDef *def, const FixtureChoice *choice)
{
    Route route;
    fixture_pull(def, choice);
    def->route[2].plane = M_PI / 2;
    def->n_rollers = 0;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, NULL),
        HAWSER_OK);
    for (double s = 0.5; s < 12; s += 1) {
        const RoutePoint at = route_at(&route, s);
        const Vec3 left = route_left(&route, s), up = v3_cross(at.tangent, left);
        RollerDef *const roller = &def->rollers[def->n_rollers];
        *roller = fixture_roller(def, at.position, v3_scale(-1, up), v3_scale(def->n_rollers % 2 ? 1 : -1, left));
        roller->centre = v3_axpy(roller->centre, 0.05 * (def->n_rollers++ % 4), left);
    }
    route_clear(&route);
}

/* Shakes a planar state, as state_shake does one in space. */
static inline void planar_shake(double *y, int n, double shift, double turn, double speed, double spin, uint64_t *seed)
{
    const double size[PLANAR_SIZE] = {shift, shift, turn, speed, speed, spin};
    for (int c = 0; c < PLANAR_SIZE; ++c) {
        for (int i = 0; i < n; ++i) {
            double *const at = &y[c * planar_stride(n) + i];
            *at = (c < PLANAR_V ? *at : 0) + size[c] * fixture_random(seed);
        }
    }
}

#endif
