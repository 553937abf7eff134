/* The drum's forces on the tail: derivatives against differences, limits of the brake laws, and the cable drawn from a
 * drum by a constant pull against the balance of angular momentum. */
#include "sim/equipment/reel.h"
#include "sim/equipment/winch.h"
#include "sim/run/stage.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/scene.h"

/* A scene whose window is made, with a drum of every choice. */
static Stage *stage_for(const ReelChoice *choice)
{
    SceneDef def;
    Stage *const st = fixture_array(1, sizeof *st);
    hawser_error err = {0};
    reel_pull(&def, choice);
    if (stage_new(st, &def, NULL, &err)) fail_msg("%s", err.message);
    scene_def_clear(&def);
    return st;
}

static void stage_done(Stage *st)
{
    stage_free(st);
    free(st);
}

static const BrakeLaw LAWS[] = {BRAKE_CONSTANT, BRAKE_PROPORTIONAL, BRAKE_SPEED};

/* d(resistance) by free length and speed, for every law, in the middle of the drum's layers, at rest, at speed, where a
 * free end is let go and where a fixed one is caught. */
TEST(test_resistance_slopes)
{
    for (int k = 0; k < 12; ++k) {
        Stage *const st = stage_for(&(ReelChoice){.payout = 1,
                                                  .brake = LAWS[k % 3],
                                                  .torque = 300,
                                                  .bearing = 80,
                                                  .tension = 900,
                                                  .fixed = k >= 9,
                                                  .cable = 40});
        Reel r = *st->scene.reel;
        r.last = k >= 6;
        if (k >= 6) r.wound = 0.3;
        if (k >= 3 && k < 6) r.wound = winding_capacity(&r.winding, 0.68) + 1; /* on the climb to the second layer */
        const double speeds[] = {-0.003, 0, 0.0004, 0.0015, 0.196, 0.2037};
        const double h = 1e-7, length = r.half * (k >= 9 ? 3.01 : 1.7);
        for (int i = 0; i < 6; ++i) {
            double by_l, by_v;
            const double v = speeds[i], t = 2;
            reel_resistance(&r, length, v, t, 1, &by_l, &by_v);
            const double l = (reel_resistance(&r, length + h, v, t, 1, NULL, NULL) -
                              reel_resistance(&r, length - h, v, t, 1, NULL, NULL)) /
                             (2 * h);
            const double s = (reel_resistance(&r, length, v + h, t, 1, NULL, NULL) -
                              reel_resistance(&r, length, v - h, t, 1, NULL, NULL)) /
                             (2 * h);
            check_close(l, by_l, 3e-7 * (fabs(l) + 100));
            check_close(s, by_v, 5e-7 * (fabs(s) + 100));
        }
        stage_done(st);
    }
}

/* Force and moment on the tail for the state y. */
static void tail_load(Stage *st, const double *y, double load[6])
{
    Loads *const loads = &st->ws.loads[0];
    loads_zero(loads, st->scene.chain.n);
    dynamics_kinematics(&st->scene, &st->ws, 0.8, y);
    room_loads(&REEL_ROOM, &st->scene, &st->ws, 0.8, 1);
    for (int c = 0; c < 3; ++c) {
        load[c] = loads->f[c][0];
        load[3 + c] = loads->m[c][0];
    }
}

/* The blocks of a tail that is askew, twisted, moving and turning. */
TEST(test_blocks)
{
    Stage *const st = stage_for(
        &(ReelChoice){.payout = 1, .brake = BRAKE_PROPORTIONAL, .torque = 300, .bearing = 80, .tension = 900});
    const int n = st->scene.chain.n;
    const double h = 1e-6;
    double *const y = fixture_array(STATE_SIZE * n, sizeof *y);
    BlockChain k, d;
    assert_true(block_chain_alloc(&k, n, 6) && block_chain_alloc(&d, n, 6));
    block_chain_zero(&k);
    block_chain_zero(&d);
    uint64_t seed = 5;
    state_shake(st->y, n, 0.1, 0.3, 0.2, 0.3, &seed);
    dynamics_kinematics(&st->scene, &st->ws, 0.8, st->y);
    room_blocks(&REEL_ROOM, &st->scene, &st->ws, 0.8, 1, &k, &d);
    for (int c = 0; c < 12; ++c) {
        double plus[6], minus[6];
        memcpy(y, st->y, sizeof *y * (size_t)(STATE_SIZE * n));
        state_nudge(y, n, 0, c, h);
        tail_load(st, y, plus);
        memcpy(y, st->y, sizeof *y * (size_t)(STATE_SIZE * n));
        state_nudge(y, n, 0, c, -h);
        tail_load(st, y, minus);
        for (int row = 0; row < 6; ++row) {
            const double found = (c < 6 ? k.diag + 6 * c : d.diag + 6 * (c - 6))[row];
            const double slope = (plus[row] - minus[row]) / (2 * h);
            check_close(found, slope, 2e-8 * (fabs(slope) + 1e3));
        }
    }
    block_chain_free(&k);
    block_chain_free(&d);
    free(y);
    stage_done(st);
}

/* At speed the laws give what they say at the drum's radius; at rest they give nothing, and nothing pushes. */
TEST(test_laws)
{
    for (int k = 0; k < 3; ++k) {
        Stage *const st = stage_for(&(ReelChoice){.payout = 1, .brake = LAWS[k], .torque = 300, .bearing = 50});
        const Reel *const r = st->scene.reel;
        const double radius = winding_radius(&r->winding, r->wound, NULL);
        const double full = winding_radius(&r->winding, r->total, NULL);
        const double expected[3] = {350 / radius, (50 + 300 * full / radius) / radius, 350 / radius};
        /* well above the set speed of 0.2 m/s, or at it */
        const double v = k == 2 ? 0.22 : 0.2, at = reel_resistance(r, r->half, v, 5, 1, NULL, NULL);
        check_share(at, expected[k], 1e-12);
        check_close(reel_resistance(r, r->half, 0, 5, 1, NULL, NULL), 0, 1e-12);
        if (k == 2) check_close(reel_resistance(r, r->half, 0.19, 5, 1, NULL, NULL), 50 / radius, 1e-12);
        check_close(reel_resistance(r, r->half, v, 5, 0, NULL, NULL), 0, 1e-12); /* friction off */
        stage_done(st);
    }
}

/* A constant pull on a cable without friction, all of it in one layer: drum and cable together are a mass that does not
 * change while segments join, m + I/R^2, against which the proportional brake is a dashpot: v = F/c (1 - exp(-c t/M)).
 */
TEST(test_momentum)
{
    for (int braked = 0; braked < 2; ++braked) {
        const double F = 200, t_end = 4;
        SceneDef def;
        Stage st;
        hawser_error err = {0};
        reel_pull(&def,
                  &(ReelChoice){
                      .payout = 1, .mu = -1, .brake = BRAKE_PROPORTIONAL, .torque = braked ? 100 : 0, .at_speed = 1});
        def.winch.mode = WINCH_TENSION;
        def.winch.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = F};
        assert_int_equal(stage_new(&st, &def, NULL, &err), HAWSER_OK);
        st.scene.winch->phase.held = 0;
        const Reel *const r = st.scene.reel;
        const double R = winding_radius(&r->winding, r->wound, NULL), c = r->brake.viscous / (R * R);
        const double mass = r->winding.inertia / (R * R) + 12 * 20 + 1.5 * 10;
        while (st.t < t_end && !err.status) stage_step(&st, t_end, &err);
        if (err.status) fail_msg("%s", err.message);
        const int n = st.scene.chain.n;
        const double expected = braked ? F / c * (1 - exp(-c * t_end / mass)) : F * t_end / mass;
        double momentum = st.y[STATE_V * n] * st.scene.reel->mass, v;
        for (int i = 0; i < n; ++i) momentum += st.y[STATE_V * n + i] * (st.scene.chain.mass[i] - (i ? 0 : r->mass));
        v = momentum / (r->mass + 12 * 20 + 1.5 * 10 - r->wound * 12);
        print_message("%ld segments joined; speed %.6f, %.6f m/s expected\n", st.joined, v, expected);
        /* the work of the pull is in the motion of cable and drum */
        double kinetic = 0;
        for (int i = 0; i < n; ++i) {
            const Vec3 u = state_vec(st.y, n, STATE_V, i);
            kinetic += st.scene.chain.mass[i] * v3_dot(u, u) / 2;
        }
        dynamics_kinematics(&st.scene, &st.ws, st.t, st.y);
        const double work = F * winch_motion(st.scene.winch, &st.scene.chain, &st.ws.kin, st.t).travel;
        if (!braked) check_share(kinetic, work, 5e-3);
        check_at_least(st.joined, 5);
        check_share(v, expected, 2e-3);
        stage_free(&st);
        scene_def_clear(&def);
    }
}
