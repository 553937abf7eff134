/* The relaxation: it balances the fixture, the start from it is free of motion, and it says when it did not get there.
 */
#include "sim/solve/relax.h"
#include "tests/sim/room_fixture.h"
#include "tests/support/rig.h"

static Rig *rig_new(SceneDef *def)
{
    Rig *const r = rig_make(def, NULL);
    rig_refresh(r);
    return r;
}

static hawser_relaxation rig_relax(Rig *r)
{
    hawser_relaxation out;
    hawser_error err = {0};
    if (relax_to_equilibrium(&r->scene, &r->ws, &r->newton, 0, r->y, &out, &err)) fail_msg("%s", err.message);
    for (int k = 0; k < STATE_SIZE * r->scene.chain.n; ++k) check_finite(r->y[k]);
    return out;
}

/* The largest entry of y over segments' velocities and angular velocities, m/s and rad/s. */
static double fastest(const Rig *r, const double *y)
{
    const int n = r->scene.chain.n;
    double largest = 0;
    for (int k = STATE_V * n; k < STATE_SIZE * n; ++k) largest = larger_of(largest, fabs(y[k]));
    return largest;
}

/* Both geometries: balanced, at rest, and no farther from the route than what is soft gives way. */
TEST(test_reached)
{
    for (int geometry = 0; geometry < 2; ++geometry) {
        SceneDef def;
        fixture_pull(&def, &(FixtureChoice){.geometry = geometry ? GEOMETRY_CYLINDER : GEOMETRY_SMOOTH});
        Rig *const r = rig_new(&def);
        const hawser_relaxation out = rig_relax(r);
        print_message("%d iterations, residual %.2g of %.2g N, moved %.3f m\n", out.iterations, out.residual_N,
                      out.tolerance_N, out.moved_m);
        assert_true(out.reached);
        check_at_most(out.residual_N, out.tolerance_N);
        check_between(out.iterations, 2, 60);
        check_between(out.moved_m, 0, 0.5);
        check_at_most(fastest(r, r->y), 0);
        /* friction or not: at rest there is none */
        const int n = r->scene.chain.n;
        dynamics_rates(&r->scene, &r->ws, 0, r->y, 1, r->rate);
        for (int i = 0; i < n; ++i) {
            const double force = r->scene.chain.mass[i] * v3_norm(state_vec(r->rate, n, STATE_V, i));
            check_at_most(force, out.tolerance_N * (1 + 1e-9));
        }
        rig_free(r);
    }
}

/* What holds the chain at rest adds up to its weight and the tail's pull: rollers and winch. */
TEST(test_total_balance)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    def.lead_in.present = 0;
    def.head_at = 12.3; /* all of the cable is on rollers */
    Rig *const r = rig_new(&def);
    const hawser_relaxation out = rig_relax(r);
    const int n = r->scene.chain.n;
    assert_true(out.reached);
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    bushing_kernels()->loads(&r->scene.chain, &r->ws.kin, 0, n + 1, &r->ws.joints);
    Vec3 sum = vec_load(r->ws.joints.force, n);
    for (int i = 0; i < n; ++i) sum = v3_axpy(sum, r->scene.chain.mass[i], r->scene.weight.gravity);
    sum = v3_axpy(sum, -profile_value(&r->scene.tail, 0), r->scene.weight.direction);
    room_look(&ROLLERS_ROOM, &r->scene, &r->ws);
    for (int k = 0; k < r->scene.contact.n_rollers; ++k) sum = v3_sub(sum, r->ws.on_roller[k]);
    print_message("forces on the whole chain add up to %.2g N\n", v3_norm(sum));
    check_below(v3_norm(sum), n * out.tolerance_N);
    rig_free(r);
}

/* A light rope on the line of a thick cable: it falls 36 mm onto stiff rollers, which Newton's method alone does not
 * survive (E5). */
static void rope_over_rollers(SceneDef *def, int rollers)
{
    scene_def_defaults(def);
    def->n_cables = def->n_pieces = def->n_route = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->route = fixture_array(1, sizeof *def->route);
    def->cables[0] = fixture_cable(0.01, 0.7, 0.014);
    def->pieces[0] = (ChainPieceDef){.cable = 0, .length = 2.5 * rollers, .segments = 5 * rollers / 2};
    def->route[0] = (RoutePieceDef){.kind = ROUTE_STRAIGHT, .length = 2.5 * rollers};
    def->head_at = 2.5 * rollers;
    def->winch = (WinchDef){.present = 1, .speed = {.kind = PROFILE_CONSTANT}};
    def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = 2900};
    def->impact = (ImpactLaw){.k = 3.4e8, .e = 1.5, .c = 1e4, .d = 1e-4};
    def->rollers = fixture_array(rollers, sizeof *def->rollers);
    for (int r = 0; r < rollers; ++r) {
        RollerDef *const roller = &def->rollers[def->n_rollers++];
        *roller = fixture_roller(def, v3(2.5 * (r + 0.5), 0, -0.036), v3(0, 0, -1), v3(0, 1, 0));
    }
}

TEST(test_light_rope)
{
    SceneDef def;
    rope_over_rollers(&def, 60);
    Rig *const r = rig_new(&def);
    const hawser_relaxation out = rig_relax(r);
    print_message("%d iterations, residual %.2g of %.2g N, moved %.4f m\n", out.iterations, out.residual_N,
                  out.tolerance_N, out.moved_m);
    assert_true(out.reached);
    check_above(out.iterations, r->scene.def.solver.relax_iterations); /* the first attempt did not do it */
    const int n = r->scene.chain.n;
    check_close(r->y[2 * n + n / 2], -0.036, 0.003); /* it lies on its rollers, sagging by millimetres */
    /* the contacts have their stiffness back: with the winch they carry the weight */
    dynamics_kinematics(&r->scene, &r->ws, 0, r->y);
    bushing_kernels()->loads(&r->scene.chain, &r->ws.kin, 0, n + 1, &r->ws.joints);
    double load = r->ws.joints.force[2][n];
    room_look(&ROLLERS_ROOM, &r->scene, &r->ws);
    for (int k = 0; k < r->scene.contact.n_rollers; ++k) load -= r->ws.on_roller[k].z;
    print_message("carried %.2f N of %.2f N\n", load, 0.7 * 9.81 * 150);
    check_share(load, 0.7 * 9.81 * 150, 1e-6);
    check_at_least(r->ws.contact[0].model.impact.k, r->scene.contact.impact.k);
    rig_free(r);
}

/* With winch and tail at rest nothing moves for a second, friction on. */
TEST(test_start_is_still)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    def.winch.speed = (Profile){.kind = PROFILE_CONSTANT};
    def.tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = 500};
    def.solver.relax_tolerance = 1e-12;
    Rig *const r = rig_new(&def);
    assert_true(rig_relax(r).reached);
    Integrator *in;
    double t = 0, largest = 0;
    hawser_error err = {0};
    assert_int_equal(integrator_new(spatial_init(&r->spatial, &r->scene, &r->ws, &r->newton), 0, r->y, &in, &err),
                     HAWSER_OK);
    while (t < 1) {
        if (integrator_step(in, 1, &t, &err)) fail_msg("%s", err.message);
        largest = larger_of(largest, fastest(r, r->y));
    }
    print_message("fastest motion in 1 s: %.2g m/s or rad/s\n", largest);
    check_below(largest, 1e-8);
    integrator_free(in);
    rig_free(r);
}

/* One iteration in each of the two attempts is not enough, and it says so. */
TEST(test_too_few_iterations)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    def.solver.relax_iterations = 1;
    Rig *const r = rig_new(&def);
    const hawser_relaxation out = rig_relax(r);
    assert_false(out.reached);
    assert_int_equal(out.iterations, 2);
    check_above(out.residual_N, out.tolerance_N);
    check_finite(out.residual_N);
    check_at_least(out.segment, 0);
    check_below(out.segment, r->scene.chain.n);
    rig_free(r);
}

/* A chain that nothing holds falls: its weight remains unbalanced, on some segment, and nothing breaks. */
TEST(test_free_fall)
{
    SceneDef def;
    fixture_free_chain(&def, 12);
    def.gravity = v3(0, 0, -9.81);
    Rig *const r = rig_new(&def);
    const hawser_relaxation out = rig_relax(r);
    assert_false(out.reached);
    assert_int_equal(out.iterations, r->scene.def.solver.relax_iterations);
    check_close(out.residual_N, 9.81 * r->scene.chain.mass[0], 1e-11);
    check_above(out.moved_m, 0.1);
    check_at_least(out.segment, 0);
    check_below(out.segment, 12);
    rig_free(r);
}

/* The residual is measured with the largest of the segments' weights and the tail's tension. */
TEST(test_scale)
{
    const double tension[] = {0, 5000};
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        fixture_pull(&def, &(FixtureChoice){0});
        def.tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = tension[k]};
        def.solver.relax_tolerance = 1e-4;
        def.solver.relax_iterations = 0;
        Rig *const r = rig_new(&def);
        const hawser_relaxation out = rig_relax(r);
        const double load = fmax(tension[k], 20 * 0.5 * 9.81);
        check_close(out.tolerance_N, 1e-4 * load, 1e-9);
        assert_int_equal(out.iterations, 0);
        rig_free(r);
    }
}

/* A preload draws a free chain together by f0/k a joint, where the two cables' half-springs in series say so. */
TEST(test_preload)
{
    enum { SEGMENTS = 10 };
    const double f0 = 3; /* N */
    SceneDef def;
    fixture_free_chain(&def, SEGMENTS);
    def.cables[0].preload[0] = f0;
    Rig *const r = rig_new(&def);
    const double stiffness = r->scene.chain.stiffness[0][1], first = r->y[0], last = r->y[SEGMENTS - 1];
    check_close(r->scene.chain.preload[0][1], f0, 1e-12);
    assert_true(rig_relax(r).reached);
    const double shorter = fabs(last - first) - fabs(r->y[SEGMENTS - 1] - r->y[0]);
    check_close(shorter, (SEGMENTS - 1) * f0 / stiffness, 1e-6 * shorter);
    rig_free(r);
}

/* Asks nine times to go on, then to stop. */
static int nine_times(void *user)
{
    int *const asked = user;
    return ++*asked > 9;
}

/* A relaxation that takes long ends when it is asked to, in space and in a plane, and leaves numbers. */
TEST(test_stopped)
{
    for (int planar = 0; planar < 2; ++planar) {
        SceneDef def;
        hawser_relaxation out = {0};
        hawser_error err = {0};
        int asked = 0;
        fixture_planar(&def, &(FixtureChoice){0});
        def.solver.planar = planar ? PLANAR_ON : PLANAR_OFF;
        def.solver.relax_tolerance = 1e-300;
        Stage stage;
        assert_int_equal(stage_new(&stage, &def, NULL, &err), HAWSER_OK);
        scene_def_clear(&def);
        stage.ws.stop = (StopCheck){.ask = nine_times, .user = &asked};
        assert_int_equal(stage.motion->ops->relax(stage.motion, 0, stage.y, &out, &err), HAWSER_STOPPED);
        check_has(err.message, "stopped on the way to equilibrium");
        assert_int_equal(out.iterations, 9);
        for (int k = 0; k < stage.motion->size; ++k) check_finite(stage.y[k]);
        stage_free(&stage);
    }
}

/* What thin rollers ask for bounds an iteration's move, and so does the turn of a long segment (E2). */
TEST(test_stride)
{
    SceneDef def;
    fixture_pull(&def, &(FixtureChoice){0});
    for (int r = 0; r < def.n_rollers; ++r) def.rollers[r].radius = 0.01;
    for (int c = 0; c < def.n_cables; ++c) def.cables[c].diameter = 0.02;
    Rig *const r = rig_new(&def);
    const RelaxStride most = relax_stride(&r->scene);
    check_close(most.move, 0.01, 1e-15);
    check_close(relax_shorten(&most, 1, 0.02, 0, 0.25), 0.5, 1e-12);
    check_close(relax_shorten(&most, 1, 0, 0.08, 0.25), 0.5, 1e-12);
    check_close(relax_shorten(&most, 1, 0.005, 0.02, 0.25), 1, 0);
    rig_free(r);
}
