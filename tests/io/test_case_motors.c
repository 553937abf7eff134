/* Motors of rollers as cases describe them: what is read and refused, and the example case against its theory, with set
 * torques and set speeds, and against the figures that a hand can reckon. */
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

TEST(what_is_read)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers",
                "{along: [{count: 2, spin: {inertia: 1, motor: {torque: 20 N m, ramp: none, speed_limit: 30 m/min}}}, "
                "{from: 1 m, count: 1, spin: {inertia: 1, motor: {speed: 6 m/min, from: 1 s, to: 3 s, limit: 5 N m, "
                "droop: 1 mm/s}}}], list: [{centre: [5, 0, -3], axis: [0, 1, 0], spin: {inertia: 1}}]}",
                &def);
    const MotorDef *const torque = &def.rollers[1].spin.motor, *const speed = &def.rollers[2].spin.motor;
    assert_int_equal(torque->kind, MOTOR_TORQUE);
    assert_int_equal(torque->set.kind, PROFILE_CONSTANT);
    check_share(torque->set.v1, 20, 1e-15);
    check_share(torque->speed_limit, 0.5, 1e-12);
    check_share(torque->droop, 5e-3, 1e-12);
    check_equal(torque->factor, 0);
    assert_int_equal(speed->kind, MOTOR_SPEED);
    assert_int_equal(speed->set.kind, PROFILE_STEP);
    check_share(speed->set.v1, 0.1, 1e-12);
    check_share(speed->set.t1, 3, 1e-15);
    check_share(speed->limit, 5, 1e-15);
    check_share(speed->droop, 1e-3, 1e-12);
    check_equal(speed->speed_limit, 0);
    assert_int_equal(def.rollers[3].spin.motor.kind, MOTOR_NONE);
    scene_def_clear(&def);
}

TEST(what_is_refused)
{
    static const char *const bad[][2] = {
        {"{}", "motor.torque': missing: give one of 'torque', 'speed' and 'factor'"},
        {"{torque: 1, speed: 1, limit: 1}", "motor.torque': given twice: give one of"},
        {"{speed: 1}", "motor.limit': missing: the largest torque of a motor with a set speed"},
        {"{factor: 1}", "motor.limit': missing"},
        {"{torque: 1, limit: 1}", "motor.limit': not allowed beside 'torque'"},
        {"{speed: 1, limit: 1, speed_limit: 1}", "motor.speed_limit': not allowed beside 'speed'"},
        {"{factor: 1, limit: 1, ramp: none}", "motor.ramp': not allowed beside 'factor'"},
        {"{torque: 1, from: 3 s, to: 2 s}", "motor.to': value 2 s is out of range: must be above 'from', 3 s"},
        {"{torque: -1}", "motor.torque': value '-1' is out of range"},
        {"{speed: 1 rad/s, limit: 1}", "which is not that of a speed"},
        {"{torque: 1, table: []}", "motor.table': unknown"},
    };
    char value[200];
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        snprintf(value, sizeof value, "{count: 3, spin: {inertia: 1, motor: %s}}", bad[k][0]);
        expect_bad(data_text("smallest"), "rollers.along", value, bad[k][1]);
    }
    /* a motor stands in `spin`, which says what it has to speed up */
    expect_bad(data_text("smallest"), "rollers.along", "{count: 3, spin: {motor: {torque: 1}}}",
               "spin.inertia': missing");
}

/* What only the built scene knows. */
TEST(needs_a_winch)
{
    const char *const settings[] = {"rollers.along.1.spin.motor", "{factor: 1.1, limit: 5 N m}", "drive.winch",
                                    "{grip: axial, tension: {force: 1 kN, speed_limit: 0.1 m/s}}", NULL};
    hawser_error err = {0};
    hawser_sim *sim = NULL;
    assert_int_equal(example_open("rollers-motorised", settings, &sim, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "'rollers.along.spin.motor.factor': roller 'driven10'");
}

static const double PITCH_LOAD = 2 * 22 * 9.81; /* N, on a roller */

/* 1.2 kN behind, bearings, and what eight motors push with; the theory has the same number, and the books close with
 * the motors' work in them. */
static void example(void **state, const char *motor, double torque, double speed)
{
    (void)state;
    const char *const settings[] = {"rollers.along.1.spin.motor", motor, NULL};
    Outcome o = example_run("rollers-motorised", motor ? settings : NULL);
    const hawser_summary *const s = &o.summary;
    const double expected = 1200 + 0.0144 * 30 * 22 * 9.81 - 8 * torque / 0.1;
    print_message("%s: pull %.2f N, theory %.2f N, by hand %.2f N; energy %.1e\n", motor ? motor : "as it is",
                  s->pull_mean_N, s->reference_total_N, expected, s->balance->residual_share);
    check_share(s->pull_mean_N, s->reference_total_N, 1e-3);
    check_share(s->pull_mean_N, expected, 2e-3);
    check_below(s->balance->residual_share, 5e-4);
    check_below(s->balance->impulse_residual_share, 2e-4);
    assert_int_equal(s->n_machines, 8);
    for (int i = 0; i < 8; ++i) {
        const hawser_machine *const m = &s->machines[i];
        assert_string_equal(m->kind, "motors");
        check_share(hawser_machine_figure(m, "at_m"), 2 + 4 * i, 1e-12);
        check_share(hawser_machine_figure(m, "steady_mean_N_m"), torque, 0.03); /* those at the ends bear otherwise */
        check_share(hawser_machine_figure(m, "reference_N"), torque / 0.1, 0.03);
        check_share(hawser_machine_figure(m, "surface_m_per_s"), speed, 0.01);
        check_share(hawser_machine_figure(m, "power_W"), torque * speed / 0.1, 0.03);
    }
    hawser_sim_free(o.sim);
}

TEST(set_torque) { example(state, NULL, 6, 0.1); }
/* Faster than the cable: pushes with its limit. Slower, or a brake: holds back with it. */
TEST(faster) { example(state, "{speed: 0.12 m/s, limit: 5 N m}", 5, 0.1); }
TEST(slower) { example(state, "{speed: 0.08 m/s, limit: 5 N m}", -5, 0.1); }
TEST(brake) { example(state, "{speed: 0, limit: 5 N m}", -5, 0.1); }

/* Within the droop the creep of the contact (0.12 mm/s) and what its spring takes of the radius (0.12 mm) count: the
 * theory's torque is the number. */
TEST(within_droop)
{
    static const char *const motor[] = {"{speed: 0.1025 m/s, limit: 5 N m}", "{factor: 1.02, limit: 8 N m}",
                                        "{torque: 6 N m, speed_limit: 0.102 m/s}"};
    for (size_t k = 0; k < sizeof motor / sizeof *motor; ++k) {
        const char *const settings[] = {"rollers.along.1.spin.motor", motor[k], NULL};
        Outcome o = example_run("rollers-motorised", settings);
        const hawser_machine *const m = &o.summary.machines[3];
        const double push = hawser_machine_figure(m, "reference_N");
        print_message("%s: pull %.2f N, theory %.2f N, a motor %.3f N m, theory %.2f N\n", motor[k],
                      o.summary.pull_mean_N, o.summary.reference_total_N, hawser_machine_figure(m, "steady_mean_N_m"),
                      push);
        check_share(o.summary.pull_mean_N, o.summary.reference_total_N, 1e-3);
        check_share(hawser_machine_figure(m, "steady_mean_N_m"), push * 0.1, 5e-3);
        check_between(push, 10, 60);
        check_equal(hawser_machine_figure(m, "at_limit"), k == 2);
        hawser_sim_free(o.sim);
    }
}

/* More torque than friction carries: the rollers slip under the cable, and it takes mu times the load from them, the
 * bearing the rest. Against a tail that holds more than that. */
TEST(slips)
{
    const char *const settings[] = {"rollers.along.1.spin.motor", "{torque: 40 N m, speed_limit: 0.2 m/s}",
                                    "drive.tail.tension", "2.5 kN", NULL};
    Outcome o = example_run("rollers-motorised", settings);
    print_message("slipping: pull %.2f N, theory %.2f N\n", o.summary.pull_mean_N, o.summary.reference_total_N);
    for (int i = 2; i < 6; ++i) { /* the cable's ends are heavier and lighter on the rollers near them */
        const hawser_machine *const m = &o.summary.machines[i];
        check_share(hawser_machine_figure(m, "reference_N"), 0.4144 * PITCH_LOAD, 1e-3);
        check_share(hawser_machine_figure(m, "steady_mean_N_m"), 0.04144 * PITCH_LOAD, 0.01);
        check_between(hawser_machine_figure(m, "surface_m_per_s"), 0.195, 0.2);
        check_equal(hawser_machine_figure(m, "at_limit"), 1);
    }
    hawser_sim_free(o.sim);
}
