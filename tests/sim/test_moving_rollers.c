/* What rollers that spin and rollers on mounts do, against closed forms: slowing down, being driven by a cable, hanging
 * down under a load, swinging, and precessing; and what they must not do: notice threads or the world's directions. */
#include "sim/equipment/rollers.h"
#include "sim/run/sim.h"
#include "sim/solve/relax.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

static Rig *rig_new(SceneDef *def)
{
    Rig *const r = rig_make(def, NULL);
    rig_refresh(r);
    return r;
}

/* The equipment's part of the state. */
static double *rig_equipment(const Rig *r) { return r->y + STATE_SIZE * r->n; }

/* Entry of mount 0, component as in core/state.h. */
static double *mount_entry(Rig *r, int c) { return rig_equipment(r) + equipment_at(r->scene.equipment, c, 0); }

/* A free chain far from one roller at the origin, axis along y, that spins, stands on a mount, or both. */
static void lonely_roller(SceneDef *def, int spins, int mounted, double accuracy)
{
    fixture_free_chain(def, 3);
    def->route_start = v3(0, 0, 50);
    def->rollers = fixture_array(1, sizeof *def->rollers);
    def->n_rollers = 1;
    def->rollers[0] =
        (RollerDef){.axis = v3(0, 1, 0), .radius = 0.1, .width = 0.4, .s = NAN, .friction = def->friction};
    if (spins) roller_spin(&def->rollers[0]);
    if (mounted) roller_mount(&def->rollers[0]);
    def->solver.accuracy = accuracy;
    def->solver.max_step = 0.05;
}

/* Constant torque: the speed falls along a straight line; friction at the journal needs a load. */
TEST(test_slows_down)
{
    SceneDef def;
    lonely_roller(&def, 1, 0, 1e-5);
    const SpinDef spin = def.rollers[0].spin;
    Rig *const r = rig_new(&def);
    const double start = 4;
    rig_equipment(r)[0] = start;
    for (int k = 1; k <= 8; ++k) {
        rig_advance(r, 0.4 * k);
        const double expected = start - spin.torque / spin.inertia * r->t;
        check_close(rig_equipment(r)[0], expected, 1e-10);
    }
    rig_advance(r, 12); /* would be backward by then; the bearing only stops it */
    check_close(rig_equipment(r)[0], 0, 1e-9);
    rig_free(r);
}

/* A cable that coasts over a roller at rest drags it along until the rim runs with it: v = v0 m/(m + I/R^2), as bodies
 * have after an inelastic impact; energy only falls. */
TEST(test_cable_drives_roller)
{
    const double v0 = 0.1;
    SceneDef def;
    fixture_free_chain(&def, 12);
    def.cables[0] = fixture_cable(30, 20, 0.08); /* so stiff that its ends do not droop */
    def.gravity = v3(0, 0, -9.81);
    def.friction = (FrictionLaw){.mu_s = 0.3, .mu_d = 0.3, .v_s = 1e-3, .v_d = 2e-3};
    def.n_rollers = 3;
    def.rollers = fixture_array(3, sizeof *def.rollers);
    for (int k = 0; k < 3; ++k) {
        def.rollers[k] = fixture_roller(&def, v3(1 + 2 * k, 0, 0), v3(0, 0, -1), v3(0, 1, 0));
        if (k != 1) def.rollers[k].friction.mu_s = def.rollers[k].friction.mu_d = 0;
    }
    def.rollers[1].spin = (SpinDef){.inertia = 0.6, .speed = 0.1};
    def.solver.accuracy = 1e-5;
    Rig *const r = rig_new(&def);
    hawser_error err = {0};
    hawser_relaxation relaxed;
    assert_int_equal(relax_to_equilibrium(&r->scene, &r->ws, &r->newton, 0, r->y, &relaxed, &err), HAWSER_OK);
    assert_true(relaxed.reached);
    double mass = 0, momentum = 0, speed = 0;
    for (int i = 0; i < r->n; ++i) {
        r->y[STATE_V * r->n + i] = v0;
        mass += r->scene.chain.mass[i];
    }
    rig_advance(r, 0.2);
    for (int i = 0; i < r->n; ++i) momentum += r->scene.chain.mass[i] * r->y[STATE_V * r->n + i];
    speed = momentum / mass;
    const double expected = v0 * mass / (mass + 0.6 / 0.01);
    print_message("v %.5f, rim %.5f, expected %.5f m/s\n", speed, 0.1 * rig_equipment(r)[0], expected);
    check_share(speed, expected, 2e-3);
    check_share(0.1 * rig_equipment(r)[0], expected, 5e-3);
    rig_free(r);
}

/* At rest each mount gives way by force over stiffness, component by component. */
TEST(test_deflection)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    for (int k = 0; k < def.n_rollers; ++k) roller_mount(&def.rollers[k]);
    Rig *const r = rig_new(&def);
    hawser_error err = {0};
    hawser_relaxation out;
    assert_int_equal(relax_to_equilibrium(&r->scene, &r->ws, &r->newton, 0, r->y, &out, &err), HAWSER_OK);
    print_message("%d iterations, residual %.2g of %.2g N\n", out.iterations, out.residual_N, out.tolerance_N);
    assert_true(out.reached);
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    room_look(&ROLLERS_ROOM, &r->scene, &r->ws);
    const Equipment *const q = r->scene.equipment;
    double farthest = 0;
    for (int m = 0; m < q->mounts; ++m) {
        const Quat from = {q->ground.q[0][2 * m], q->ground.q[1][2 * m], q->ground.q[2][2 * m], q->ground.q[3][2 * m]};
        const Quat turned = quat_mul(quat_conj(from), state_quat(rig_equipment(r) + q->spins, q->mounts, m));
        /* the bushing's components are those of the frame halfway between ground and mount */
        const Quat half = quat_unit((Quat){1 + turned.w, turned.x, turned.y, turned.z});
        const Quat back = quat_conj(quat_mul(from, half));
        const Vec3 at = state_vec(rig_equipment(r) + q->spins, q->mounts, STATE_P, m);
        const Vec3 moved = v3_sub(at, v3(q->ground.p[0][2 * m], q->ground.p[1][2 * m], q->ground.p[2][2 * m]));
        const Vec3 force = quat_rotate(back, r->ws.on_roller[q->item[m].roller]);
        const Vec3 expected = v3(force.x / 2e5, force.y / 3e5, force.z / 4e5);
        check_vec(quat_rotate(back, moved), expected, 1e-5 * v3_norm(expected) + 1e-9);
        farthest = larger_of(farthest, v3_norm(moved));
    }
    print_message("up to %.2f mm\n", 1e3 * farthest);
    check_above(farthest, 1e-4);
    rig_free(r);
}

/* Left alone a mount swings at sqrt(k/M) and sqrt(k/J): after a period it is back. */
TEST(test_frequencies)
{
    const double pi = 3.14159265358979323846;
    for (int c = 0; c < 6; ++c) {
        SceneDef def;
        lonely_roller(&def, 0, 1, 1e-6);
        MountDef *const mount = &def.rollers[0].mount;
        mount->damping = 0;
        const double stiffness = mount->stiffness[c], inertia = c < 3 ? mount->mass : mount->inertia;
        const double period = 2 * pi * sqrt(inertia / stiffness), size = 1e-3;
        Rig *const r = rig_new(&def);
        const Quat at = {r->scene.equipment->ground.q[0][0], r->scene.equipment->ground.q[1][0],
                         r->scene.equipment->ground.q[2][0], r->scene.equipment->ground.q[3][0]};
        const Vec3 way = quat_rotate(at, v3(c % 3 == 0, c % 3 == 1, c % 3 == 2));
        const double along[3] = {way.x, way.y, way.z};
        /* set off from the middle with the speed of an amplitude of 1e-3 */
        for (int k = 0; k < 3; ++k)
            *mount_entry(r, (c < 3 ? STATE_V : STATE_W) + k) = along[k] * size * 2 * pi / period;
        rig_advance(r, period / 4);
        double out = 0, back = 0;
        for (int k = 0; k < 3; ++k) out += along[k] * *mount_entry(r, (c < 3 ? STATE_V : STATE_W) + k);
        rig_advance(r, period);
        for (int k = 0; k < 3; ++k) back += along[k] * *mount_entry(r, (c < 3 ? STATE_V : STATE_W) + k);
        const double fastest = size * 2 * pi / period;
        print_message("component %d: %.1f Hz, at a quarter %.4f, at the end %.4f of the speed\n", c, 1 / period,
                      out / fastest, back / fastest);
        check_close(out, 0, 0.01 * fastest);
        check_share(back, fastest, 0.01);
        rig_free(r);
    }
}

/* Potential of the bushing and kinetic energy of a roller that spins on a mount, J. */
static double energy_of(Rig *r)
{
    const MovingRoller *const item = &r->scene.equipment->item[0];
    double v2 = 0, w2 = 0, p2 = 0;
    for (int k = 0; k < 3; ++k) {
        v2 += pow(*mount_entry(r, STATE_V + k), 2);
        w2 += pow(*mount_entry(r, STATE_W + k), 2);
        p2 += pow(*mount_entry(r, STATE_P + k), 2);
    }
    const Equipment *const q = r->scene.equipment;
    const Quat from = {q->ground.q[0][0], q->ground.q[1][0], q->ground.q[2][0], q->ground.q[3][0]};
    const Quat to = {*mount_entry(r, STATE_Q), *mount_entry(r, STATE_Q + 1), *mount_entry(r, STATE_Q + 2),
                     *mount_entry(r, STATE_Q + 3)};
    const Quat turned = quat_mul(to, quat_conj(from));
    const double sine = sqrt(turned.x * turned.x + turned.y * turned.y + turned.z * turned.z);
    const double angle = 2 * atan2(sine, fabs(turned.w));
    return (item->mass * v2 + item->turning * w2 + item->inertia * rig_equipment(r)[0] * rig_equipment(r)[0] +
            3e5 * p2 + 3e3 * angle * angle) /
           2;
}

/* A fast roller on an even mount precesses: energy stays, the spin stays, and the moment of the spin shows. */
TEST(test_gyroscope)
{
    SceneDef def;
    lonely_roller(&def, 1, 1, 1e-7);
    MountDef *const mount = &def.rollers[0].mount;
    mount->damping = 0;
    for (int c = 0; c < 6; ++c) mount->stiffness[c] = c < 3 ? 3e5 : 3e3;
    def.rollers[0].spin.friction = def.rollers[0].spin.torque = 0;
    Rig *const r = rig_new(&def);
    const double fast = 400;
    rig_equipment(r)[0] = fast;
    *mount_entry(r, STATE_W) = 0.5; /* about x, across the axis */
    const double before = energy_of(r);
    double most = 0;
    for (int k = 1; k <= 20; ++k) {
        rig_advance(r, 0.005 * k);
        most = larger_of(most, fabs(*mount_entry(r, STATE_W + 2))); /* about z: by the spin alone */
    }
    const double swing = 0.5 * 0.4 * 0.5 * 0.5; /* J, what the disturbance brought */
    print_message("energy changed by %.2g of the disturbance's, turned about z at up to %.3f rad/s\n",
                  (energy_of(r) - before) / swing, most);
    check_close(energy_of(r), before, 2e-4 * swing);
    check_close(rig_equipment(r)[0], fast, 1e-9);
    check_above(most, 0.1);
    rig_free(r);
}

/* At rest a roller that could move pushes the chain as a fixed one. */
TEST(test_at_rest_as_fixed)
{
    double rate[2][STATE_SIZE * FIXTURE_SEGMENTS];
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        uint64_t seed = 4;
        fixture_pull(&def, &(FixtureChoice){0});
        if (k) fixture_moving_rollers(&def, 1, 1);
        Rig *const r = rig_new(&def);
        double *const all = fixture_array(scene_state_size(&r->scene), sizeof(double));
        state_shake(r->y, r->n, 1e-3, 0.01, 0.05, 0.5, &seed);
        dynamics_rates(&r->scene, &r->ws, 0.7, r->y, 1, all);
        memcpy(rate[k], all, sizeof rate[k]);
        free(all);
        rig_free(r);
    }
    double size = 0, apart = 0;
    for (int i = 0; i < STATE_SIZE * FIXTURE_SEGMENTS; ++i) {
        size = larger_of(size, fabs(rate[0][i]));
        apart = larger_of(apart, fabs(rate[0][i] - rate[1][i]));
    }
    check_below(apart, 1e-14 * size);
}

/* One thread and two give the same bits. */
TEST(test_threads)
{
    Sim *sim[2];
    const hawser_sample *look[2];
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        hawser_error err = {0};
        fixture_pull(&def, &(FixtureChoice){0});
        fixture_moving_rollers(&def, 1, 1);
        sim[k] = sim_at_rest(&def, k + 1);
        if (sim_advance(sim[k], 1.5, 0, &err)) fail_msg("%s", err.message);
        look[k] = hawser_sim_sample(sim[k]);
    }
    assert_memory_equal(look[0]->position, look[1]->position, 3 * FIXTURE_SEGMENTS * sizeof(double));
    assert_memory_equal(look[0]->roller_load, look[1]->roller_load, (size_t)look[0]->rollers * sizeof(double));
    for (int k = 0; k < 2; ++k) sim_free(sim[k]);
}

/* Turning chain, rollers and mounts together turns the rates. */
TEST(test_objectivity)
{
    uint64_t seed = 12;
    const Quat turn = quat_unit((Quat){0.3, -0.5, 0.7, 0.2});
    const Vec3 shift = v3(3, -2, 5);
    Rig *r[2];
    double *rate[2];
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        fixture_pull(&def, &(FixtureChoice){.soft = 1});
        def.gravity = v3(0, 0, 0);
        def.lead_in.present = def.winch.present = 0;
        def.tail.tension = (Profile){0};
        fixture_moving_rollers(&def, 1, 1);
        r[k] = rig_new(&def);
        rate[k] = fixture_array(scene_state_size(&r[k]->scene), sizeof(double));
    }
    Scene *const scene = &r[1]->scene;
    const Equipment *const q = scene->equipment;
    const int n = r[0]->n, size = scene_state_size(scene), m = q->mounts;
    state_shake(r[0]->y, n, 2e-3, 0.02, 0.05, 0.5, &seed);
    equipment_shake(&r[0]->scene, r[0]->y, 1e-3, 0.02, 0.05, 2, &seed);
    memcpy(r[1]->y, r[0]->y, (size_t)size * sizeof(double));
    for (int k = 0; k < scene->contact.n_rollers; ++k) {
        Shape *const shape = &scene->rollers[k].shape;
        shape->centre = v3_add(quat_rotate(turn, shape->centre), shift);
        shape->axis = quat_rotate(turn, shape->axis);
    }
    for (int i = 0; i < 2 * m; i += 2) {
        const Kinematics *const g = &q->ground;
        const Vec3 p = v3_add(quat_rotate(turn, v3(g->p[0][i], g->p[1][i], g->p[2][i])), shift);
        const Quat a = quat_mul(turn, (Quat){g->q[0][i], g->q[1][i], g->q[2][i], g->q[3][i]});
        const double place[3] = {p.x, p.y, p.z}, attitude[4] = {a.w, a.x, a.y, a.z};
        for (int c = 0; c < 3; ++c) g->p[c][i] = place[c];
        for (int c = 0; c < 4; ++c) g->q[c][i] = attitude[c];
    }
    double *const part[2] = {r[1]->y, rig_equipment(r[1]) + q->spins};
    const int count[2] = {n, m};
    for (int g = 0; g < 2; ++g) {
        for (int i = 0; i < count[g]; ++i) {
            const Vec3 p = quat_rotate(turn, state_vec(part[g], count[g], STATE_P, i));
            state_set_vec(part[g], count[g], STATE_P, i, v3_add(p, shift));
            state_set_quat(part[g], count[g], i, quat_mul(turn, state_quat(part[g], count[g], i)));
            for (int at = STATE_V; at < STATE_SIZE; at += 3) {
                state_set_vec(part[g], count[g], at, i, quat_rotate(turn, state_vec(part[g], count[g], at, i)));
            }
        }
    }
    workspace_free(&r[1]->ws);
    assert_true(workspace_alloc(&r[1]->ws, scene, NULL));
    for (int k = 0; k < 2; ++k) {
        assert_int_equal(dynamics_refresh(&r[k]->scene, &r[k]->ws, 0, r[k]->y, 1, NULL), HAWSER_OK);
        dynamics_rates(&r[k]->scene, &r[k]->ws, 0, r[k]->y, 1, rate[k]);
    }
    for (int i = 0; i < q->spins; ++i) {
        const double a = rate[0][STATE_SIZE * n + i], b = rate[1][STATE_SIZE * n + i];
        check_close(a, b, 1e-9 * (1 + fabs(a)));
    }
    const int offset[2] = {0, STATE_SIZE * n + q->spins};
    for (int g = 0; g < 2; ++g) {
        double apart = 0, largest = 0;
        for (int i = 0; i < count[g]; ++i) {
            for (int at = STATE_V; at < STATE_SIZE; at += 3) {
                const Vec3 expected = quat_rotate(turn, state_vec(rate[0] + offset[g], count[g], at, i));
                apart = larger_of(apart, v3_norm(v3_sub(expected, state_vec(rate[1] + offset[g], count[g], at, i))));
                largest = larger_of(largest, v3_norm(expected));
            }
        }
        check_above(largest, 1);
        check_below(apart, 1e-11 * largest);
    }
    for (int k = 0; k < 2; ++k) {
        free(rate[k]);
        rig_free(r[k]);
    }
}

/* The bearing's law: odd in the speed, the whole of it from `speed` on, three halves of the slope at rest; the
 * journal's friction grows with the load. Derivatives by differences. */
TEST(test_bearing)
{
    const Bearing b = {.friction = 0.1, .journal = 0.02, .torque = 0.5, .speed = 4};
    const double load = 300, most = 0.5 + 0.1 * 0.02 * 300, h = 1e-6;
    double by_om, by_load, unused;
    check_close(bearing_torque(&b, load, 40, &by_om, &by_load), -most, 1e-15);
    check_close(bearing_torque(&b, load, -4.001, &by_om, &by_load), most, 1e-15);
    check_close(by_om, 0, 1e-15);
    check_close(bearing_torque(&b, load, 0, &by_om, &by_load), 0, 1e-15);
    check_close(by_om, -1.5 * most / 4, 1e-15);
    check_close(bearing_torque(&b, load, 2, &by_om, &by_load), -most * 11. / 16, 1e-15);
    for (double om = -5; om <= 5; om += 0.37) {
        bearing_torque(&b, load, om, &by_om, &by_load);
        const double up = bearing_torque(&b, load, om + h, &unused, &unused),
                     down = bearing_torque(&b, load, om - h, &unused, &unused),
                     more = bearing_torque(&b, load + 1, om, &unused, &unused),
                     less = bearing_torque(&b, load - 1, om, &unused, &unused);
        check_close(by_om, (up - down) / (2 * h), 1e-6);
        check_close(by_load, (more - less) / 2, 1e-12);
    }
}

/* Whose error is the largest: any component of any mount, and any spin, is the one to be named, with its weighted
 * square. */
TEST(test_worst)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    for (int k = 0; k < def.n_rollers; ++k) {
        roller_mount(&def.rollers[k]);
        roller_spin(&def.rollers[k]);
    }
    Rig *const r = rig_new(&def);
    const Equipment *const q = r->scene.equipment;
    const int size = q->spins + STATE_SIZE * q->mounts;
    double *const error = calloc(2 * (size_t)size, sizeof *error), *const weight = error + size, largest;
    for (int i = 0; i < size; ++i) {
        error[i] = 1e-3;
        weight[i] = 2;
    }
    for (int k = 0; k < q->n; ++k) {
        for (int c = -1; c < STATE_SIZE; ++c) {
            const int at = c < 0 ? q->item[k].spin : equipment_at(q, c, q->item[k].mount);
            error[at] = 3;
            assert_int_equal(equipment_worst(q, error, weight, &largest), k);
            check_share(largest, 4 * (9 + STATE_SIZE * 1e-6), 1e-12);
            error[at] = 1e-3;
        }
    }
    free(error);
    rig_free(r);
}
