/* The fixture's scene with rollers that spin, stand on mounts, or both. */
#ifndef HAWSER_TESTS_SIM_ROLLER_FIXTURE_H
#define HAWSER_TESTS_SIM_ROLLER_FIXTURE_H

#include "sim/equipment/moving_rollers.h"
#include "tests/sim/scene_fixture.h"

static inline void roller_spin(RollerDef *roller)
{
    roller->spin = (SpinDef){.inertia = 0.05, .friction = 0.1, .journal = 0.02, .torque = 0.05, .speed = 0.5};
}

static inline void roller_mount(RollerDef *roller)
{
    roller->mount = (MountDef){
        .present = 1, .stiffness = {2e5, 3e5, 4e5, 2e3, 3e3, 4e3}, .damping = 2e-3, .mass = 15, .inertia = 0.4};
}

/* Rollers in turn: fixed, spinning, mounted, both. Nothing if neither is wanted. */
static inline void fixture_moving_rollers(SceneDef *def, int spins, int mounts)
{
    for (int k = 0; k < def->n_rollers; ++k) {
        if (spins && k % 2) roller_spin(&def->rollers[k]);
        if (mounts && k % 4 >= 2) roller_mount(&def->rollers[k]);
    }
}

/* A roller of 20 m below the cable between the others: capsules touch it side by side. */
static inline void fixture_sheave(SceneDef *def, double depth)
{
    const double radius = 20, s = 6.5;
    Route route;
    assert_int_equal(
        route_build(&route, def->n_route, def->route, def->route_start, def->route_heading, def->route_slope, NULL),
        HAWSER_OK);
    const RoutePoint at = route_at(&route, s);
    const Vec3 left = route_left(&route, s), up = v3_cross(at.tangent, left);
    RollerDef *const roller = &def->rollers[def->n_rollers++];
    *roller = fixture_roller(def, at.position, v3_scale(-1, up), left);
    roller->radius = radius;
    roller->centre = v3_axpy(at.position, -(radius + def->cables[0].diameter / 2 - depth), up);
    route_clear(&route);
}

/* The equipment in disorder, as state_shake does it to segments. */
static inline void equipment_shake(const Scene *scene, double *y, double shift, double turn, double speed, double spin,
                                   uint64_t *seed)
{
    const Equipment *const q = scene->equipment;
    double *const e = y + STATE_SIZE * scene->chain.n;
    for (int i = 0; i < q->spins; ++i) e[i] = spin * fixture_random(seed);
    if (q->mounts) state_shake(e + q->spins, q->mounts, shift, turn, speed, spin, seed);
}

#endif
