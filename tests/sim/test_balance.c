/* Balances of energy and momentum of whole runs: they close, better the more accurate the run; the same in the plane,
 * in space and on two threads; and their terms are what can be said by hand. */
#include "sim/run/sim.h"
#include "sim/solve/planar.h"
#include "tests/support/scene.h"

/* A run to the definition's end, with its balance. */
static hawser_balance balance_of(SceneDef *def, int threads, int relax)
{
    hawser_error err = {0};
    hawser_summary summary;
    const double end = def->duration;
    Sim *const s = sim_made(def, threads);
    if (relax) assert_int_equal(sim_relax(s, NULL, &err), HAWSER_OK);
    hawser_sim_summary(s, &summary);
    assert_null(summary.balance);
    if (sim_advance(s, end, 0, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(s, &summary);
    assert_non_null(summary.balance);
    const hawser_balance balance = *summary.balance;
    sim_free(s);
    return balance;
}

/* A term by its name; 0 where there is none. */
static double term(const hawser_balance *b, hawser_balance_kind kind, const char *name)
{
    for (int k = 0; k < b->n_terms; ++k) {
        if (b->term[k].kind == kind && !strcmp(b->term[k].name, name)) return b->term[k].J;
    }
    return 0;
}

static hawser_balance pulled(PlanarChoice planar, int threads, double accuracy)
{
    SceneDef def;
    fixture_planar(&def, &(FixtureChoice){.heading = 0.6, .accuracy = accuracy});
    def.solver.planar = planar;
    return balance_of(&def, threads, 1);
}

/* The residual falls with the accuracy: it is the run's own error, not the books'. Four decades of accuracy gain at
 * least two of the residual, as the rule of the integral over a step allows (BA9). */
TEST(test_convergence)
{
    const double accuracy[] = {1e-2, 1e-3, 1e-4, 1e-5, 1e-6};
    double share[5], impulse[5];
    for (int planar = 0; planar < 2; ++planar) {
        for (int k = 0; k < 5; ++k) {
            const hawser_balance b = pulled(planar ? PLANAR_ON : PLANAR_OFF, 1, accuracy[k]);
            share[k] = b.residual_share;
            impulse[k] = b.impulse_residual_share;
            print_message("accuracy %.0e: energy %.2e of %.4g J, momentum %.2e\n", accuracy[k], share[k], b.turnover_J,
                          impulse[k]);
        }
        check_below(share[1], 1e-4);
        check_below(share[4], 1e-6);
        check_below(share[4], share[0] / 100);
        check_below(impulse[1], 1e-4);
        check_below(impulse[4], 1e-6);
        check_below(impulse[4], impulse[0] / 100);
    }
}

/* Term by term. */
TEST(test_planar)
{
    const hawser_balance flat = pulled(PLANAR_ON, 1, 1e-5), full = pulled(PLANAR_OFF, 1, 1e-5);
    assert_int_equal(flat.n_terms, full.n_terms);
    for (int k = 0; k < flat.n_terms; ++k) {
        const hawser_balance_term *const a = &flat.term[k], *const b = &full.term[k];
        assert_string_equal(a->name, b->name);
        if (a->kind != HAWSER_BALANCE_IMPULSE) check_close(a->J, b->J, 2e-5 * flat.turnover_J);
        for (int c = 0; c < 3; ++c)
            check_close(a->N_s[c], b->N_s[c], 1e-4 * fabs(term(&flat, HAWSER_BALANCE_WORK, "winch")));
    }
    check_above(term(&flat, HAWSER_BALANCE_LOSS, "roller_friction"), 1);
    check_above(term(&flat, HAWSER_BALANCE_LOSS, "rope_drag"), 1);
    check_differs(term(&flat, HAWSER_BALANCE_WORK, "lead_in"), 0);
}

TEST(test_threads)
{
    for (int planar = 0; planar < 2; ++planar) {
        const hawser_balance one = pulled(planar ? PLANAR_ON : PLANAR_OFF, 1, 1e-3);
        const hawser_balance two = pulled(planar ? PLANAR_ON : PLANAR_OFF, 2, 1e-3);
        assert_int_equal(one.n_terms, two.n_terms);
        for (int k = 0; k < one.n_terms; ++k) {
            if (one.term[k].kind != HAWSER_BALANCE_IMPULSE) check_equal(one.term[k].J, two.term[k].J);
            assert_memory_equal(one.term[k].N_s, two.term[k].N_s, sizeof one.term[k].N_s);
        }
        check_equal(one.residual_J, two.residual_J);
    }
}

/* A level row: what the winch does is the rope's drag and the friction of the whole weight over the way, and the motion
 * in the end. */
TEST(test_level_row)
{
    SceneDef def;
    fixture_planar(&def, &(FixtureChoice){.accuracy = 1e-4});
    def.route_slope = 0;
    def.n_route = 1;
    def.route[0].length = 14.5;
    def.head_at = 12;
    def.n_pieces = 1;
    def.drag.force = 0;
    def.lead_in.present = 0;
    def.winch.axial_only = 1; /* a clamp would carry half a metre's weight */
    def.tail.tension = (Profile){0};
    for (int r = 0; r < def.n_rollers; ++r) def.rollers[r].centre = v3(0.25 + r, 0, -0.1 - def.cables[0].diameter / 2);
    def.duration = 6;
    const double weight = 20 * 12 * 9.80665, mu = def.friction.mu_d, way = 0.1 * 5.5, speed = 0.1;
    const double gravity = v3_norm(def.gravity);
    const hawser_balance b = balance_of(&def, 1, 1);
    const double friction = term(&b, HAWSER_BALANCE_LOSS, "roller_friction");
    const double expected = mu * weight / 9.80665 * gravity * way, moving = 20 * 12 * speed * speed / 2;
    print_message("friction %.3f J, by hand %.3f J; motion %.4f J, by hand %.4f J\n", friction, expected,
                  term(&b, HAWSER_BALANCE_STORED, "motion"), moving);
    check_share(friction, expected, 2e-3);
    check_share(term(&b, HAWSER_BALANCE_STORED, "motion"), moving, 2e-3);
    check_below(b.residual_share, 1e-4);
}

/* A chain that nothing touches falls: what it loses of height it has in motion; m g t is its impulse. */
TEST(test_fall)
{
    SceneDef def;
    fixture_free_chain(&def, 12);
    def.gravity = v3(0, 0, -9.8);
    def.duration = 1;
    const hawser_balance b = balance_of(&def, 1, 0);
    const double mass = 12 * 0.5 * 8, height = term(&b, HAWSER_BALANCE_STORED, "height");
    check_share(height, -mass * 9.8 * 9.8 / 2, 1e-4);
    check_below(b.residual_share, 1e-4);
    check_below(b.impulse_residual_share, 1e-12);
    check_share(b.impulse_N_s[2], -mass * 9.8, 1e-13);
    check_equal(b.work_J, 0);
    check_equal(b.lost_J, 0);
    check_equal(b.carried_J, 0);
}

/* (BA11) of a roller that spins and stands on a mount, by hand: springs of force and moment on the mount, whose loss is
 * what motion and springs have less of, and a torque that does not change on the spin. */
TEST(test_rollers_method_loss)
{
    enum { E = 1 + STATE_SIZE };
    const double m = 3, turning = 0.2, inertia = 0.5, k = 40, c = 7, h = 0.1, torque = 2;
    const double x[2] = {0.3, 0.5}, v[2] = {1, 0.2}, w[2] = {-0.1, 0.4}, angle[2] = {0, 2e-3}, speed[2] = {5, 6};
    MovingRoller item = {.spin = 0, .mount = 0, .inertia = inertia, .mass = m, .turning = turning};
    const Equipment q = {.n = 1, .spins = 1, .mounts = 1, .item = &item};
    double past[2 + BODY_PAST] = {0};
    MethodLoss loss = {0, 0};
    for (int i = 0; i < 2; ++i) {
        double e[E] = {0}, rates[E] = {0};
        e[0] = speed[i];
        rates[0] = h * torque / inertia;
        e[1 + STATE_P] = x[i];
        e[1 + STATE_Q] = cos(angle[i] / 2);
        e[1 + STATE_Q + 3] = sin(angle[i] / 2);
        e[1 + STATE_V] = v[i];
        e[1 + STATE_W + 2] = w[i];
        rates[1 + STATE_V] = h * -k * x[i] / m;
        rates[1 + STATE_W + 2] = h * -c * angle[i] / turning;
        loss = equipment_method_loss(&q, e, rates, 1 / h, past);
    }
    double held[2];
    for (int i = 0; i < 2; ++i)
        held[i] = (m * v[i] * v[i] + turning * w[i] * w[i] + k * x[i] * x[i] + c * angle[i] * angle[i]) / 2;
    const double spun = torque * h * (speed[0] + speed[1]) / 2 - inertia * (36 - 25) / 2;
    check_close(loss.lost, held[0] - held[1] + spun, 1e-9);
    check_close(loss.moving, (m * v[1] * v[1] + turning * w[1] * w[1] + inertia * 36) / 2, 1e-12);
}
