/* A rope wound on a drum, made in code. */
#ifndef HAWSER_TESTS_SIM_DRUM_FIXTURE_H
#define HAWSER_TESTS_SIM_DRUM_FIXTURE_H

#include "sim/equipment/drum.h"

#include "sim/dynamics.h"
#include "sim/newton/newton.h"
#include "sim/newton/newton_extra.h"
#include "sim/run/sim.h"
#include "tests/sim/scene_fixture.h"

static const double D = 0.05, H = 0.125, TORQUE = 100, RIGIDITY = 5; /* m, m, N m, N m2 */

/* A rope, most of it on a drum of half a metre, `turns` a layer. */
static inline void wound_case(SceneDef *def, int n, double turns, double pulled)
{
    fixture_free_chain(def, n);
    def->gravity = v3(0, 0, 0);
    def->cables[0] = fixture_cable(1, 2, D);
    def->cables[0].ea = 1e6;
    def->cables[0].ga = 4e5;
    def->cables[0].gj = def->cables[0].ei_y = def->cables[0].ei_z = RIGIDITY;
    def->cables[0].damping = 5e-3;
    def->pieces[0].length = n * H;
    def->route[0].length = 3;
    def->head_at = 2;
    def->geometry = GEOMETRY_CYLINDER;
    def->impact = (ImpactLaw){.k = 1e7, .e = 1.5, .c = 2e3, .d = 1e-3};
    def->friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.3, .v_s = 5e-3, .v_d = 1e-2};
    def->cable_friction = def->friction;
    def->cable_on_cable = 1;
    def->drum = (DrumDef){.present = 1,
                          .distance = 1,
                          .barrel = 0.5,
                          .flange = 1.2,
                          .width = (1.03 * turns + 2) * D + 1e-6,
                          .inertia = 5,
                          .torque = TORQUE};
    def->winch.present = 1;
    def->winch.axial_only = 0;
    def->winch.speed = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = pulled};
    def->solver.relax = 0;
    def->duration = 4;
    def->output.steady_from = 2;
    def->output.interval = 0.02;
}

/* The pull that the drum asks for at this radius (CC25): the brake's torque per length of cable that a turn of the drum
 * gives, and the work of straightening the joints, which rest as they lay. */
static inline double pull_at(double radius)
{
    const double turn = 2 * atan(H / (2 * radius));
    return TORQUE * turn / H + RIGIDITY * turn * turn / (2 * H * H);
}

/* The mean pull from `from` to `until` (s) of a cable of n segments that is pulled off at 0.2 m/s. */
static inline double payout_pull(int n, int turns, double from, double until)
{
    SceneDef def;
    Sim *sim;
    hawser_error err = {0};
    double mean = 0;
    int count = 0;
    wound_case(&def, n, turns, 0.2);
    if (sim_new(&def, 1, &sim, &err)) fail_msg("%s", err.message);
    for (double t = 0.02; t < until; t += 0.02) {
        if (sim_advance(sim, t, 0, &err)) fail_msg("%s", err.message);
        if (t <= from) continue;
        mean += sim_sample(sim)->winch_force;
        ++count;
    }
    sim_free(sim);
    scene_def_clear(&def);
    return mean / count;
}

#endif
