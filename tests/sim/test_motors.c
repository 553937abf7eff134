/* Motors of rollers: the law and its slope, the way they turn wherever a roller stands around the cable, and what they
 * do to rollers without a cable, against closed forms. */
#include <stdlib.h>

#include "sim/equipment/rollers.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

static const double RADIUS = 0.1;

/* The slope by central differences, values at the ends, and never uphill; a torque without a limit has no slope. */
TEST(test_law)
{
    const MotorNow motor = {-0.5, 2.5, 30, -12}, constant = {0, 0, 7, 7}, none = {0};
    double slope, unused, before = 31;
    for (int k = 0; k <= 200; ++k) {
        const double om = -2 + 0.03 * k, h = 1e-5;
        const double here = motor_torque(&motor, om, &slope);
        const double difference =
            (motor_torque(&motor, om + h, &unused) - motor_torque(&motor, om - h, &unused)) / (2 * h);
        check_close(slope, difference, 1e-4); /* the kinks of the slope at both ends: 56 N m s2 times h */
        check_at_most(here, before);
        before = here;
    }
    check_equal(motor_torque(&motor, -0.5, &slope), 30);
    check_equal(motor_torque(&motor, 2.5, &slope), -12);
    check_share(motor_torque(&motor, 1, &slope), 9, 1e-15);
    check_share(slope, -1.5 * 42 / 3, 1e-15);
    check_equal(motor_torque(&constant, 99, &slope), 7);
    check_equal(slope, 0);
    check_equal(motor_torque(&none, 1, &slope), 0);
}

static RollerDef driven_roller(Vec3 centre, Vec3 axis, double s)
{
    return (RollerDef){.centre = centre,
                       .axis = axis,
                       .radius = RADIUS,
                       .width = 0.4,
                       .s = s,
                       .friction = {.mu_s = 0.2, .mu_d = 0.2, .v_s = 1e-3, .v_d = 2e-3},
                       .spin = {.inertia = 0.05, .speed = 1},
                       .mount = {0}};
}

/* A free chain of 3 segments along x at height z, and n rollers around the origin. */
static void scene_of(SceneDef *def, int n, const RollerDef *roller, double z)
{
    fixture_free_chain(def, 3);
    def->route_start = v3(0, 0, z);
    def->rollers = fixture_array(n, sizeof *def->rollers);
    for (int k = 0; k < n; ++k) def->rollers[k] = roller[k];
    def->n_rollers = n;
    def->solver.accuracy = 1e-6;
    def->solver.max_step = 0.05;
}

/* Below, above, to the left and to the right of the cable, and both ways of its axis: the rim beside the cable is
 * driven along the pull. One that is listed turns about its axis. */
TEST(test_ways)
{
    const Vec3 side[] = {{0, 0, -1}, {0, 0, 1}, {0, 1, 0}, {0, -1, 0}}; /* where the roller stands */
    RollerDef roller[9];
    for (int k = 0; k < 8; ++k) {
        const Vec3 axis = v3_scale(k % 2 ? -1 : 1, k < 4 ? v3(0, 1, 0) : v3(0, 0, 1));
        roller[k] = driven_roller(v3_axpy(v3(1, 0, 5), 0.5, side[k / 2]), axis, 1);
        roller[k].spin.motor = (MotorDef){.kind = k % 2 ? MOTOR_SPEED : MOTOR_TORQUE, .limit = 9, .droop = 0.01};
        roller[k].spin.motor.set.v1 = k % 2 ? 0.3 : 9;
    }
    roller[8] = roller[0];
    roller[8].s = NAN;
    roller[8].axis = v3(1, 0, 0);
    SceneDef def;
    scene_of(&def, 9, roller, 5);
    Rig *const r = rig_make(&def, NULL);
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    for (int k = 0; k < 9; ++k) {
        double slope;
        const double torque = motor_torque(&r->ws.equipment->motor[k], 0, &slope);
        const Vec3 rim = v3_cross(roller[k].axis, v3_scale(-1, side[k / 2 % 4]));
        check_close(k < 8 ? torque * rim.x : torque, 9, 1e-12);
    }
    assert_int_equal(r->scene.setup.n_pushers, 8);
    rig_free(r);
}

/* In a bend to the left, with motors stronger than friction: in theory a carrier bears the weight of half the way to
 * its neighbours, a guide on the inside what the tension presses, one above or on the outside nothing; each pushes with
 * mu times that, beside the fixed roller that the theory has there. */
TEST(test_theory)
{
    const double turn = 6, tension = 2000, mu = 0.2, mu_case = 0.05;
    const RoutePieceDef bend = {.kind = ROUTE_BEND, .radius = turn, .angle = 1.5};
    RollerDef roller[12];
    Route route;
    assert_int_equal(route_build(&route, 1, &bend, v3(0, 0, 5), 0, 0, NULL), HAWSER_OK);
    for (int k = 0; k < 12; ++k) {
        const double s = 3 + 1.5 * (k / 4);
        const Vec3 left = route_left(&route, s), up = v3(0, 0, 1);
        const Vec3 side[] = {v3_scale(-1, up), up, left, v3_scale(-1, left)};
        const Vec3 place = v3_axpy(route_at(&route, s).position, 0.5, side[k % 4]);
        roller[k] = driven_roller(place, k % 4 < 2 ? left : up, s);
        roller[k].spin.motor = (MotorDef){.kind = MOTOR_TORQUE, .set = {.v1 = 1e4}, .droop = 0.01};
    }
    route_clear(&route);
    SceneDef def;
    scene_of(&def, 12, roller, 5);
    def.route[0] = bend;
    def.gravity = v3(0, 0, -9.81);
    def.friction.mu_d = mu_case;
    const double weight = def.cables[0].mass * 9.81;
    Scene scene;
    fixture_build(&def, &scene);
    assert_int_equal(scene.setup.n_pushers, 12);
    int carriers = 0, guides = 0, idle = 0;
    for (int k = 0; k < 12; ++k) {
        const double load = setup_push(&scene.setup, k, tension, INFINITY) / (mu + mu_case);
        const int carries = fabs(load / (1.5 * weight) - 1) < 1e-12;
        const int guided = fabs(load / (1.5 * tension / turn) - 1) < 1e-12;
        carriers += carries;
        guides += guided;
        idle += fabs(load) < 1e-9;
    }
    assert_int_equal(carriers, 3);
    assert_int_equal(guides, 3);
    assert_int_equal(idle, 6);
    scene_clear(&scene);
}

/* Without a cable: a set torque speeds its roller up by torque over inertia, up to the speed limit; a set speed is
 * reached, over the ramp with the torque that this takes, and held. */
TEST(test_free_run)
{
    RollerDef roller[3];
    for (int k = 0; k < 3; ++k) roller[k] = driven_roller(v3(k, 0, 0), v3(0, 1, 0), NAN);
    roller[0].spin.motor = (MotorDef){.kind = MOTOR_TORQUE, .set = {.v1 = 0.2}, .droop = 0.01};
    roller[1].spin.motor = (MotorDef){.kind = MOTOR_TORQUE, .set = {.v1 = 0.2}, .speed_limit = 0.5, .droop = 0.05};
    roller[2].spin.motor =
        (MotorDef){.kind = MOTOR_SPEED, .set = {.kind = PROFILE_STEP, .t1 = 4, .v1 = 0.4}, .limit = 5, .droop = 0.01};
    SceneDef def;
    scene_of(&def, 3, roller, 50);
    Rig *const r = rig_make(&def, NULL);
    rig_refresh(r);
    const double *const e = r->y + STATE_SIZE * r->n;
    for (int k = 1; k <= 4; ++k) {
        rig_advance(r, 0.25 * k);
        check_share(e[0], 4 * r->t, 1e-6); /* 0.2 N m on 0.05 kg m2 */
        check_share(e[1], 4 * r->t, 1e-6);
    }
    rig_advance(r, 2);
    /* in the middle of the ramp I s' = 0.05 * 1.5 * 4 rad/s / 4 s = 0.075 N m, which the law gives at a lag of the
     * speed */
    double slope;
    check_share(motor_torque(&r->ws.equipment->motor[2], e[2], &slope), 0.075, 0.02);
    rig_advance(r, 12);
    check_share(e[0], 48, 1e-6);
    check_between(e[1], 4.5, 5);
    check_close(e[2], 4, 1e-5);
    rig_free(r);
}

/* On a mount the reaction turns the mount back, by torque over stiffness about the axis. */
TEST(test_reaction)
{
    RollerDef roller = driven_roller(v3(0, 0, 0), v3(0, 1, 0), NAN);
    roller.spin.motor = (MotorDef){.kind = MOTOR_TORQUE, .set = {.v1 = 3}, .droop = 0.01};
    roller_mount(&roller);
    roller.mount.damping = 0.02;
    SceneDef def;
    scene_of(&def, 1, &roller, 50);
    Rig *const r = rig_make(&def, NULL);
    rig_refresh(r);
    const Equipment *const q = r->scene.equipment;
    rig_advance(r, 3);
    const double *const e = r->y + STATE_SIZE * r->n;
    const Quat ground = {q->ground.q[0][0], q->ground.q[1][0], q->ground.q[2][0], q->ground.q[3][0]};
    const Quat turned = quat_mul(quat_conj(ground), state_quat(e + q->spins, q->mounts, 0));
    check_share(2 * asin(turned.x), -3 / roller.mount.stiffness[3], 1e-4);
    check_share(e[0], 3 * r->t / 0.05, 1e-3); /* its whole speed, that of the mount included */
    rig_free(r);
}
