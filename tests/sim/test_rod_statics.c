/* Equilibria of rods against closed forms and published figures. */
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

/* A cantilever along x with one load at its head. */
static void cantilever(Stage *stage, RodFixture f, int moment, int follower, Vec3 direction, double size)
{
    SceneDef def;
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, f.length, moment, follower, direction, size);
    rod_define(&def, &f);
    rod_stage(&def, stage);
    rod_solve(stage);
}

/* P L^3/3EI (1 + 1/2N^2), with the shear of all springs but the last half segment, for any N. The load is a thousandth
 * of EI/L^2: what is not linear is below 1e-7. */
TEST(linear_cantilever_is_exact_in_n)
{
    const int counts[] = {1, 2, 5, 16, 40};
    for (int k = 0; k < 5; ++k) {
        const int n = counts[k];
        Stage stage;
        cantilever(&stage, (RodFixture){.n = n, .length = 1, .steps = 1}, 0, 0, v3(0, 0, -1), 1);
        const double shear = (1 - 0.5 / n) / 1e6, tip = 1.0 / 3e3 * (1 + 0.5 / n / n) + shear;
        check_close(rod_front(&stage, n - 1).z, -tip, 1e-6 * tip);
        stage_free(&stage);
    }
}

/* EI_y resists a load along z, EI_z one along y; a section rolled by 90 degrees has them changed over. */
TEST(sections_have_two_stiffnesses)
{
    for (int rolled = 0; rolled < 2; ++rolled) {
        for (int up = 0; up < 2; ++up) {
            RodFixture f = {.n = 10, .length = 1, .steps = 1, .ei_y = 1e3, .ei_z = 4e3};
            Stage stage;
            f.rod.roll = rolled * M_PI / 2;
            cantilever(&stage, f, 0, 0, v3(0, !up, up), 1);
            const double ei = rolled != up ? 1e3 : 4e3, tip = 1 / (3 * ei) * 1.005 + 0.95e-6;
            const Vec3 end = rod_front(&stage, 9);
            check_share(up ? end.z : end.y, tip, 2e-6);
            check_close(up ? end.y : end.z, 0, 1e-12);
            stage_free(&stage);
        }
    }
}

/* Twisted by 90 degrees from end to end: u'' = M (cos^2/EI_y + sin^2/EI_z) along the load, integrated in closed form.
 */
TEST(twisted_section)
{
    RodFixture f = {.n = 60, .length = 1, .steps = 1, .ei_y = 1e3, .ei_z = 4e3, .ga = 1e9, .ea = 1e7};
    Stage stage;
    f.rod.roll_rate = M_PI / 2;
    f.rod.stress_free = 1;
    cantilever(&stage, f, 0, 0, v3(0, 0, 1), 1);
    /* integral of (1-s)^2 (a + b cos(pi s)): a/3 + b 2/pi^2, with a, b half the sum and half the difference of 1/EI */
    const double a = (1 / 1e3 + 1 / 4e3) / 2, b = (1 / 1e3 - 1 / 4e3) / 2;
    const double tip = a / 3 + 2 * b / (M_PI * M_PI);
    check_share(rod_front(&stage, 59).z, tip, 5e-4);
    check_above(fabs(rod_front(&stage, 59).y), 0.1 * tip); /* and it gives way to the side */
    stage_free(&stage);
}

/* A moment 2 pi EI/L makes a regular polygon: the tip comes back to the root, dead moment or follower. */
TEST(roll_up_closes)
{
    for (int follower = 0; follower < 2; ++follower) {
        Stage stage;
        cantilever(&stage, (RodFixture){.n = 20, .length = 10, .steps = 10}, 1, follower, v3(0, -1, 0),
                   2 * M_PI * 1e3 / 10);
        check_close(v3_norm(rod_front(&stage, 19)), 0, 1e-8);
        /* the vertex across: twice the radius of the circle through the corners */
        check_close(v3_norm(rod_front(&stage, 9)), 0.5 / sin(M_PI / 20), 1e-8);
        stage_free(&stage);
    }
}

/* Sinking and drawing back of the tip over L, and its angle, from elliptic integrals. */
typedef struct Elastica {
    double load, sink, back, angle;
} Elastica;
static const Elastica ELASTICA[] = {
    {1, 0.3017208, 0.0564332, 0.4613519}, {3, 0.6032534, 0.2544202, 0.9860169}, {10, 0.8106090, 0.5549956, 1.4302855}};

static double elastica_sink(int n, double load)
{
    Stage stage;
    cantilever(&stage, (RodFixture){.n = n, .length = 1, .steps = 10, .ea = 1e9, .ga = 1e9}, 0, 0, v3(0, 0, -1),
               1e3 * load);
    const double sink = -rod_front(&stage, n - 1).z;
    stage_free(&stage);
    return sink;
}

TEST(elastica_within_two_per_mille)
{
    for (int k = 0; k < 3; ++k) {
        const Elastica *const e = &ELASTICA[k];
        Stage stage;
        cantilever(&stage, (RodFixture){.n = 50, .length = 1, .steps = 10, .ea = 1e9, .ga = 1e9}, 0, 0, v3(0, 0, -1),
                   1e3 * e->load);
        const Vec3 tip = rod_front(&stage, 49);
        const Vec3 axis = quat_rotate(state_quat(stage.y, 50, 49), v3(1, 0, 0));
        check_share(-tip.z, e->sink, 0.0005);
        check_share(1 - tip.x, e->back, 0.0015);
        check_share(atan2(-axis.z, axis.x), e->angle, 0.0005);
        stage_free(&stage);
    }
}

/* Halving the segments quarters the error. */
TEST(elastica_is_of_second_order)
{
    double error[3];
    for (int k = 0; k < 3; ++k) error[k] = elastica_sink(10 << k, 3) - ELASTICA[1].sink;
    for (int k = 0; k < 2; ++k) check_close(error[k] / error[k + 1], 4, 0.15);
}

/* The bend of Bathe and Bolourchi: 45 degrees of radius 100, square section 1 x 1, E = 1e7, nu = 0. */
TEST(forty_five_degree_bend)
{
    const double force[2] = {300, 600};
    const Vec3 expected[2] = {{58.779, 22.245, 40.192}, {47.150, 15.685, 53.476}};
    for (int k = 0; k < 2; ++k) {
        RodFixture f = {.n = 50,
                        .length = 100 * M_PI / 4,
                        .steps = 6,
                        .ea = 1e7,
                        .ga = 5e6,
                        .gj = 5e6 / 6,
                        .ei_y = 1e7 / 12,
                        .ei_z = 1e7 / 12};
        Stage stage;
        f.rod.shape = ROD_ARC;
        f.rod.radius = 100;
        f.rod.stress_free = 1;
        cantilever(&stage, f, 0, 0, v3(0, 0, 1), force[k]);
        check_close(v3_norm(v3_sub(rod_front(&stage, 49), expected[k])), 0, 0.0002 * 100);
        stage_free(&stage);
    }
}

/* Span 10, length 12: sag 2.923438, tension at the ends 7.618853 times the weight per length. It starts from a V. */
TEST(catenary)
{
    RodFixture f = {.n = 60, .length = 12, .steps = 1, .gravity = {0, 0, -10}, .ei_y = 1e-3, .ei_z = 1e-3, .gj = 1e-3};
    SceneDef def;
    Stage stage;
    f.rod.shape = ROD_POLYLINE;
    f.rod.n_points = 3;
    f.rod.points = fixture_array(3, sizeof *f.rod.points);
    f.rod.points[1] = v3(5, 0, -sqrt(11));
    f.rod.points[2] = v3(10, 0, 0);
    rod_hold(&f.rod.end[ROD_TAIL], 1);
    rod_hold(&f.rod.end[ROD_HEAD], 1);
    rod_define(&def, &f);
    rod_stage(&def, &stage);
    rod_solve(&stage);
    dynamics_look(&stage.scene, &stage.ws, 1, stage.y);
    bushing_kernels()->loads(&stage.scene.chain, &stage.ws.kin, 0, 61, &stage.ws.joints);
    const JointLoads *const j = &stage.ws.joints;
    check_close(rod_front(&stage, 29).z, -2.923438, 0.001 * 2.923438);
    check_share(v3_norm(v3(j->force[0][60], j->force[1][60], j->force[2][60])), 76.18853, 0.002);
    check_close(j->force[2][60] - j->force[2][0], 120, 1e-8); /* both ends together carry the weight */
    stage_free(&stage);
}

/* The moment at the root is that of all forces about it, and the force their sum: dead and follower loads, large
 * rotations in space. */
TEST(reactions_balance_the_loads)
{
    RodFixture f = {.n = 12, .length = 2, .steps = 8, .gravity = {0, 0, -20}};
    SceneDef def;
    Stage stage;
    rod_hold(&f.rod.end[ROD_TAIL], 0);
    f.rod.loads = fixture_array(3, sizeof *f.rod.loads);
    rod_load(&f.rod, 2, 0, 1, v3(0, 1, 1), 900);
    rod_load(&f.rod, 0.7, 0, 0, v3(1, 0, 2), 400);
    rod_load(&f.rod, 1.3, 1, 1, v3(1, 1, 0), 300);
    rod_define(&def, &f);
    rod_stage(&def, &stage);
    rod_solve(&stage);
    Workspace *const ws = &stage.ws;
    dynamics_look(&stage.scene, ws, 1, stage.y);
    bushing_kernels()->loads(&stage.scene.chain, &ws->kin, 0, 13, &ws->joints);
    loads_zero(&ws->loads[0], 12);
    room_loads(&ROD_ROOM, &stage.scene, ws, 1, 1);
    Vec3 force = v3(0, 0, 0), moment = v3(0, 0, 0);
    for (int i = 0; i < 12; ++i) {
        const Vec3 p = state_vec(stage.y, 12, STATE_P, i), weight = v3(0, 0, -20.0 / 6);
        const Loads *const l = &ws->loads[0];
        const Vec3 all = v3_add(weight, v3(l->f[0][i], l->f[1][i], l->f[2][i]));
        force = v3_add(force, all);
        moment = v3_add(moment, v3_add(v3_cross(p, all), v3(l->m[0][i], l->m[1][i], l->m[2][i])));
    }
    const JointLoads *const j = &ws->joints;
    check_close(v3_norm(v3_sub(force, v3(j->force[0][0], j->force[1][0], j->force[2][0]))), 0, 5e-9);
    check_close(v3_norm(v3_sub(moment, v3(j->torque_a[0][0], j->torque_a[1][0], j->torque_a[2][0]))), 0, 1e-6);
    check_above(v3_norm(v3_sub(rod_front(&stage, 11), v3(2, 0, 0))), 0.5); /* it has bent far */
    stage_free(&stage);
}

/* An end that is led to where a moment would bring it carries that moment: a half turn of the head. */
TEST(a_led_end_bends_the_rod)
{
    RodFixture f = {.n = 20, .length = 10, .steps = 20};
    SceneDef def;
    Stage stage;
    for (int e = 0; e < 2; ++e) rod_hold(&f.rod.end[e], 0);
    RodEndDef *const head = &f.rod.end[ROD_HEAD];
    head->held[0] = head->held[1] = head->held[2] = 0;
    RodDef lent = {.loads = fixture_array(1, sizeof(RodLoadDef))};
    rod_load(&lent, 0, 0, 0, v3(0, -1, 0), 0.9 * M_PI);
    head->n_motions = 1;
    head->motions = fixture_array(1, sizeof *head->motions);
    head->motions[0] = (RodMotionDef){.turns = 1, .by = lent.loads[0].by};
    free(lent.loads);
    rod_define(&def, &f);
    rod_stage(&def, &stage);
    rod_solve(&stage);
    dynamics_look(&stage.scene, &stage.ws, 1, stage.y);
    bushing_kernels()->loads(&stage.scene.chain, &stage.ws.kin, 0, 21, &stage.ws.joints);
    for (int j = 0; j <= 20; ++j) check_close(stage.ws.joints.torque_a[1][j], -0.9 * M_PI * 1e3 / 10, 1e-7);
    stage_free(&stage);
}

/* Nothing holds it: no equilibrium, and the message says so. */
TEST(a_loose_rod_is_reported)
{
    RodFixture f = {.n = 4, .length = 1, .steps = 1};
    SceneDef def;
    Stage stage;
    hawser_error err = {0};
    hawser_relaxation out = {0};
    f.rod.loads = fixture_array(1, sizeof *f.rod.loads);
    rod_load(&f.rod, 1, 0, 0, v3(0, 0, 1), 5);
    rod_define(&def, &f);
    def.solver.relax_iterations = 5;
    rod_stage(&def, &stage);
    assert_int_equal(statics_advance(&stage, 1, &out, &err), HAWSER_ERR_RUN);
    check_has(err.message, "no equilibrium was found");
    stage_free(&stage);
}
