/* The straight row of rollers of cases/straight.yaml made in code, of any length: the scene of the benchmarks that need
 * more than the program gives. tests/bench/test_straight_scene.c holds the two together. */
#ifndef HAWSER_BENCH_STRAIGHT_SCENE_H
#define HAWSER_BENCH_STRAIGHT_SCENE_H

#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "def/scene_def.h"

enum { STRAIGHT_SEGMENTS = 370 }; /* of the case */

/* Table 1 of the paper as a solid bar, 11 kg a segment of half a metre. */
static inline CableDef straight_cable(void)
{
    const double E = 115e9, G = 41.5e9, A = 5982.7e-6, d = 87.3e-3; /* Pa, Pa, m2, m */
    const double J = M_PI * pow(d, 4) / 32;                         /* m4 */
    CableDef c = {.name = "power",
                  .ea = E * A,
                  .ga = G * A,
                  .gj = G * J,
                  .ei_y = E * J / 2,
                  .ei_z = E * J / 2,
                  .mass = 22,
                  .diameter = d,
                  .damping = 1e-3};
    for (int k = 0; k < 6; ++k) c.damping_factor[k] = 1;
    return c;
}

/* The roller under route coordinate s (m); the route runs along x from the origin. */
static inline RollerDef straight_roller(const SceneDef *def, int number, double s)
{
    const double radius = 0.1;
    RollerDef r = {.centre = v3(s, 0, -radius - def->cables[0].diameter / 2),
                   .axis = v3(0, 1, 0),
                   .radius = radius,
                   .width = 0.4,
                   .s = s,
                   .friction = def->friction};
    snprintf(r.name, sizeof r.name, "R%d", number);
    return r;
}

/* Winch, contact and run as in the case. */
static inline void straight_settings(SceneDef *def)
{
    def->impact = (ImpactLaw){.k = 3.4e8, .e = 1.5, .c = 1e4, .d = 1e-4};
    def->friction = (FrictionLaw){.mu_s = 0.2, .mu_d = 0.2, .v_s = 1e-3, .v_d = 2e-3};
    def->contact_reach = 4.1;
    def->winch = (WinchDef){.present = 1, .axial_only = 1, .speed = {.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.1}};
    def->duration = 30;
    def->output.steady_from = 10;
}

/* Fills *def for `segments` >= 1 segments of 0.5 m; the tail lies at `tail` (m), `rollers` >= 1 rollers stand `spacing`
 * (m) apart from the origin on. scene_def_clear() frees it. Returns 0 without memory (then *def is cleared). */
static inline int straight_row(SceneDef *def, int segments, int rollers, double spacing, double tail)
{
    const double length = 0.5 * segments;
    scene_def_defaults(def);
    def->cables = malloc(sizeof *def->cables);
    def->pieces = malloc(sizeof *def->pieces);
    def->route = calloc(1, sizeof *def->route);
    def->rollers = malloc((size_t)rollers * sizeof *def->rollers);
    if (!def->cables || !def->pieces || !def->route || !def->rollers) {
        scene_def_clear(def);
        return 0;
    }
    straight_settings(def);
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables[0] = straight_cable();
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = segments};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .name = "row", .length = length + tail + 6.5};
    def->head_at = length + tail;
    for (int k = 0; k < rollers; ++k) def->rollers[def->n_rollers++] = straight_roller(def, k + 1, spacing * k);
    return 1;
}

/* The same with the tail at 2.5 m and rollers every 2 m up to 6.5 m ahead of the head. */
static inline int straight_scene(SceneDef *def, int segments)
{
    return straight_row(def, segments, (int)floor((0.5 * segments + 9) / 2 + 1e-9) + 1, 2, 2.5);
}

#endif
