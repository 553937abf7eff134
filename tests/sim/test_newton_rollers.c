/* Newton's matrix with rollers that spin and stand on mounts, as test_newton.c has it for the chain: newton_solve must
 * solve (1 - gamma J) x = b with J x by differences of the rates, whatever is leaf and whatever is border. */
#include <stdio.h>

#include "sim/dynamics.h"
#include "sim/equipment/rollers.h"
#include "sim/equipment/rooms.h"
#include "sim/solve/newton.h"
#include "tests/support/rig.h"

static const double T = 0.7; /* s: the winch is speeding up, the tail tension rising */

typedef struct RigChoice {
    int spins, mounts, sheave, cylinder, jams, motors;
    LinKind kind;
} RigChoice;

/* On rollers that spin, by turns with a set torque that its speed limit cuts and a set speed; wide enough that the
 * speeds of equipment_shake, a few rad/s, are on the slopes. */
static void motors_add(SceneDef *def)
{
    for (int k = 0; k < def->n_rollers; ++k) {
        SpinDef *const spin = &def->rollers[k].spin;
        const MotorKind kind = k % 4 == 1 ? MOTOR_TORQUE : MOTOR_SPEED;
        if (!(spin->inertia > 0)) continue;
        spin->motor = (MotorDef){.kind = kind, .limit = 20, .speed_limit = 0.2, .droop = 0.4};
        spin->motor.set = (Profile){.kind = PROFILE_STEP, .t1 = 1, .v1 = kind == MOTOR_TORQUE ? 30 : 0.1};
    }
}

/* Every roller jams at 0.5 s over 0.4 s, so that all are half-way at T. */
static void jams_define(SceneDef *def)
{
    def->n_jams = def->n_rollers;
    def->jams = fixture_array(def->n_jams, sizeof *def->jams);
    for (int i = 0; i < def->n_jams; ++i) {
        JamDef *const jam = &def->jams[i];
        *jam =
            (JamDef){.at = 0.5, .head_at = NAN, .release = NAN, .release_head_at = NAN, .ramp = 0.4, .friction = 0.5};
        snprintf(jam->what, sizeof jam->what, "R%d", i);
        snprintf(def->rollers[i].name, sizeof def->rollers[i].name, "R%d", i);
    }
}

static void jams_begin(Scene *scene)
{
    const Occasion now = {.t = 0.5, .front = NAN};
    Room *const jams = room_of(scene, &JAM_ROOM);
    for (int i = 0; i < scene->def.n_jams; ++i) check_has(JAM_ROOM.happen(jams, &now).what, "jams");
    assert_null(JAM_ROOM.happen(jams, &now).what);
}

static Rig *rig_new(const RigChoice *choice, uint64_t seed)
{
    SceneDef def;
    const ContactGeometry geometry = choice->cylinder ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH;
    fixture_pull(&def, &(FixtureChoice){.soft = 1, .geometry = geometry, .heading = 1.1});
    if (choice->sheave) fixture_sheave(&def, 0.02);
    fixture_moving_rollers(&def, choice->spins, choice->mounts);
    if (choice->sheave) roller_spin(&def.rollers[def.n_rollers - 1]);
    if (choice->sheave) roller_mount(&def.rollers[def.n_rollers - 1]);
    if (choice->jams) jams_define(&def);
    if (choice->motors) motors_add(&def);
    Rig *const r = rig_make(&def, &(LinOptions){.kind = choice->kind, .threads = 1});
    if (choice->jams) jams_begin(&r->scene);
    r->seed = seed;
    r->t = T;
    state_shake(r->y, r->n, 3e-3, 0.02, 0.05, 5, &r->seed);
    equipment_shake(&r->scene, r->y, 2e-3, 0.02, 0.05, 2, &r->seed);
    rig_refresh(r);
    rig_linearise(r);
    return r;
}

/* The better of two steps and right-hand sides: a larger step crosses a contact's kink now and then, a smaller one has
 * more rounding. */
static double solve_error(Rig *r, double gamma)
{
    return smaller_of(rig_solve_error(r, gamma, 1.5e-5), rig_solve_error(r, gamma, 4e-6));
}

static double gammas_error(Rig *r)
{
    double worst = 0;
    for (int k = -6; k <= 0; ++k) {
        newton_form(&r->newton, pow(10, k));
        assert_int_equal(newton_factor(&r->newton), 0);
        worst = larger_of(worst, solve_error(r, pow(10, k)));
    }
    return worst;
}

/* Leaves: each kind of roller, with and without motors, both geometries, two solvers. */
TEST(test_leaves)
{
    const LinKind kind[] = {LIN_AUTO, LIN_KLU};
    double worst = 0;
    for (int k = 0; k < 24; ++k) {
        const int which = k % 3; /* spins, mounts, both */
        const RigChoice choice = {.spins = which != 1,
                                  .mounts = which != 0,
                                  .cylinder = k / 3 % 2,
                                  .motors = k / 12,
                                  .kind = kind[(k + k / 3) % 2]};
        Rig *const r = rig_new(&choice, 90 + (uint64_t)(k % 12));
        const double error = gammas_error(r);
        print_message("spins %d mounts %d cylinder %d motors %d: %.2g\n", choice.spins, choice.mounts, choice.cylinder,
                      choice.motors, error);
        worst = larger_of(worst, error);
        rig_free(r);
    }
    check_below(worst, 1e-6);
}

/* The same with every roller half-way into a jam: its friction or its bearing is another, and changes with time. */
TEST(test_jammed)
{
    double worst = 0;
    for (int k = 0; k < 4; ++k) {
        const RigChoice choice = {.spins = k & 1, .mounts = k > 1, .cylinder = k > 2, .kind = LIN_AUTO, .jams = 1};
        Rig *const r = rig_new(&choice, 50 + (uint64_t)k);
        const double error = gammas_error(r);
        print_message("jammed: spins %d mounts %d: %.2g\n", choice.spins, choice.mounts, error);
        for (int i = 0; i < r->scene.equipment->n; ++i) {
            const MovingRoller *const item = &r->scene.equipment->item[i];
            const double journal = item->bearing.friction * item->bearing.journal;
            if (item->spin >= 0) check_above(r->ws.equipment->q->item[i].bearing.journal, 100 * journal);
        }
        worst = larger_of(worst, error);
        rig_free(r);
    }
    check_below(worst, 1e-6);
}

/* A sheave that capsules touch side by side: as a leaf it is not exact, and it says so; in the border it is. */
TEST(test_border)
{
    const LinKind kind[] = {LIN_AUTO, LIN_KLU, LIN_BORDERED};
    for (int k = 0; k < 3; ++k) {
        const RigChoice choice = {.spins = k > 0, .mounts = k > 1, .sheave = 1, .cylinder = 1, .kind = kind[k]};
        Rig *const r = rig_new(&choice, 70 + (uint64_t)k);
        hawser_error err = {0};
        LinStats stats;
        const double before = gammas_error(r);
        for (int i = 0; i < 2; ++i) { /* and once when the rig was made */
            assert_int_equal(r->newton.matrix.border, 0);
            rig_linearise(r);
            assert_int_equal(newton_renew(&r->newton, r->ws.equipment, &err), HAWSER_OK);
        }
        assert_int_equal(r->newton.matrix.border, 7);
        rig_linearise(r);
        const double after = gammas_error(r);
        newton_stats(&r->newton, &stats);
        print_message("%s: %.2g as a leaf, %.2g in the border (touches %d)\n", stats.why, before, after,
                      r->newton.leaves->item[r->scene.equipment->n - 1].touched);
        check_above(r->newton.leaves->item[r->scene.equipment->n - 1].touched, 2);
        check_above(before, 1e-3);
        check_below(after, 3e-6); /* the 20 m of the sheave cost differences a digit */
        rig_free(r);
    }
}

/* Solvers agree on the solution. */
TEST(test_solvers_agree)
{
    const LinKind kind[] = {LIN_BORDERED, LIN_KLU};
    double *x[2], size = 0, apart = 0;
    int length = 0;
    for (int k = 0; k < 2; ++k) {
        Rig *const r = rig_new(&(RigChoice){.spins = 1, .mounts = 1, .kind = kind[k]}, 6);
        length = r->size;
        newton_form(&r->newton, 5e-3);
        assert_int_equal(newton_factor(&r->newton), 0);
        x[k] = fixture_array(length, sizeof(double));
        for (int c = 0; c < length; ++c) x[k][c] = fixture_random(&r->seed);
        assert_int_equal(newton_solve(&r->newton, x[k]), 0);
        rig_free(r);
    }
    for (int c = 0; c < length; ++c) {
        size = larger_of(size, fabs(x[0][c]));
        apart = larger_of(apart, fabs(x[0][c] - x[1][c]));
    }
    check_below(apart, 5e-12 * size);
    for (int k = 0; k < 2; ++k) free(x[k]);
}

/* What cannot hold such a scene says so. */
TEST(test_refused)
{
    SceneDef def;
    Scene scene;
    Newton newton;
    hawser_error err = {0};
    fixture_pull(&def, &(FixtureChoice){.soft = 1});
    fixture_moving_rollers(&def, 1, 0);
    fixture_build(&def, &scene);
    const LinOptions options = {.kind = LIN_BLOCK, .threads = 1};
    assert_int_equal(newton_new(&newton, &scene, &options, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "'block'");
    scene_clear(&scene);
}
