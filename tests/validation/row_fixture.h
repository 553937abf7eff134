/* A straight row of rollers, level or on a slope, under a cable whose ends are free across: what it takes to pull it is
 * known exactly. And a pull that is run and recorded. */
#ifndef HAWSER_TESTS_VALIDATION_ROW_FIXTURE_H
#define HAWSER_TESTS_VALIDATION_ROW_FIXTURE_H

#include "sim/run/sim.h"
#include "tests/sim/scene_fixture.h"

typedef struct RowChoice {
    int segments; /* of 0.5 m */
    double slope; /* rad */
    double pitch; /* m between rollers */
    double mu;
    ContactGeometry geometry;
} RowChoice;

static const double ROW_MASS = 46.67, ROW_G = 9.81; /* kg/m, m/s2 */

/* Weight of the whole cable, N. */
static inline double row_weight(const RowChoice *c) { return ROW_MASS * ROW_G * 0.5 * c->segments; }

/* The paper's heavy cable with EI = 300 kN m2; rollers from before its tail to 6 m past its head. */
static inline void row_scene(SceneDef *def, const RowChoice *c)
{
    const double length = 0.5 * c->segments;
    scene_def_defaults(def);
    def->geometry = c->geometry;
    def->solver.accuracy = 3e-4; /* the ripple of the smooth line is finer than what 1e-3 resolves */
    def->friction = (FrictionLaw){.mu_s = c->mu, .mu_d = c->mu, .v_s = 1e-3, .v_d = 2e-3};
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = fixture_cable(30, ROW_MASS, 0.0873);
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = c->segments};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = length};
    def->route_slope = c->slope;
    def->head_at = length;
    const Vec3 along = v3(cos(c->slope), 0, sin(c->slope)), up = v3(-sin(c->slope), 0, cos(c->slope));
    def->rollers = fixture_array((int)((length + 8) / c->pitch) + 2, sizeof *def->rollers);
    for (double s = -c->pitch / 2; s < length + 6; s += c->pitch) {
        RollerDef *const roller = &def->rollers[def->n_rollers++];
        *roller = fixture_roller(def, v3_scale(s, along), v3_scale(-1, up), v3(0, 1, 0));
    }
    def->winch = (WinchDef){.present = 1, .axial_only = 1, .speed = {.kind = PROFILE_STEP, .t1 = 1, .v1 = 0.1}};
    def->output.steady_from = 2;
}

/* Relaxes, pulls for `duration` (s) and records every 50 ms; the definition is taken apart. */
static inline void pull_record(SceneDef *def, double duration, hawser_summary *out)
{
    Sim *s = NULL;
    hawser_relaxation relaxation;
    hawser_error err = {0};
    def->duration = duration;
    if (sim_new(def, 1, &s, &err)) fail_msg("%s", err.message);
    scene_def_clear(def);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    assert_true(relaxation.reached);
    sim_record(s);
    for (int k = 1; k * 0.05 <= duration + 1e-9; ++k) {
        if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
        sim_record(s);
    }
    sim_summary(s, out);
    out->linear_solver = out->linear_solver_why = out->ordering = out->planar_why = NULL; /* the simulation's */
    sim_free(s);
}

#endif
