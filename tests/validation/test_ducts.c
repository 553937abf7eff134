/* Cables in ducts and on floors against what is known exactly: the closed forms of bends in both planes, the reference
 * theory in three dimensions, the weight, a slope, rest. Bending stiffness and clearance are small, since the theory
 * knows neither (model: "Against the pulling theory"). */
#include "sim/run/sim.h"
#include "tests/support/scene.h"
#include "theory/closed_form.h"

static const double MASS = 10, G = 9.81, RADIUS = 0.03; /* kg/m, m/s2, m */

/* A thin cable of `length` from the route's start plus 1 m on, clamped to a winch, 2 kN at its tail. */
static void duct_scene(SceneDef *def, int n_route, const RoutePieceDef *route, double length, double segment)
{
    scene_def_defaults(def);
    def->friction = (FrictionLaw){.mu_s = 0.25, .mu_d = 0.25, .v_s = 1e-3, .v_d = 2e-3};
    def->n_cables = def->n_pieces = def->n_surfaces = 1;
    def->cables = fixture_array(1, sizeof *def->cables);
    def->pieces = fixture_array(1, sizeof *def->pieces);
    def->surfaces = fixture_array(1, sizeof *def->surfaces);
    def->cables[0] = fixture_cable(1, MASS, 2 * RADIUS);
    def->cables[0].ei_y = def->cables[0].ei_z = 20;
    def->cables[0].gj = 500;
    def->pieces[0] = (ChainPieceDef){.length = length, .segments = (int)ceil(length / segment - 1e-9)};
    def->n_route = n_route;
    def->route = fixture_array(n_route, sizeof *def->route);
    memcpy(def->route, route, (size_t)n_route * sizeof *route);
    def->head_at = length + 1;
    def->surfaces[0] = (SurfaceDef){.name = "duct", .friction = def->friction};
    def->surfaces[0].shape = (SurfaceShape){
        .kind = SURFACE_DUCT, .to = length + 2, .fade = 0.5, .cable_radius = RADIUS, .radius = 0.031, .lift = 0.001};
    def->winch = (WinchDef){.present = 1, .speed = {.kind = PROFILE_STEP, .t1 = 0.5, .v1 = 0.1}};
    def->tail.tension = (Profile){.kind = PROFILE_CONSTANT, .v1 = 2000};
    def->output.steady_from = 2;
    def->duration = 6;
}

/* Stations; their names are of no matter. */
static void scene_stations(SceneDef *def, int n, const double *s)
{
    def->n_stations = n;
    def->stations = fixture_array(n, sizeof *def->stations);
    for (int i = 0; i < n; ++i) def->stations[i] = (StationDef){.name = "station", .s = s[i]};
}

/* Relaxes, runs to the end, records every 50 ms. The definition is taken apart. */
static Sim *pull(SceneDef *def, int threads)
{
    hawser_relaxation relaxation;
    hawser_error err = {0};
    const double end = def->duration;
    Sim *const s = sim_made(def, threads);
    assert_int_equal(sim_relax(s, &relaxation, &err), HAWSER_OK);
    check_at_most(relaxation.residual_N, relaxation.tolerance_N);
    hawser_sim_record(s);
    for (int k = 1; k * 0.05 <= end + 1e-9; ++k) {
        if (sim_advance(s, k * 0.05, 0, &err)) fail_msg("%s", err.message);
        hawser_sim_record(s);
    }
    return s;
}

/* Straight, bend, straight: the tension where the bend begins and ends. The closed form is taken from the simulated
 * tension that enters, and the entering tension against the straight's. */
static void bend_check(RoutePieceDef bend, double (*exact)(double T1, double R, double turn))
{
    const RoutePieceDef route[] = {{.kind = ROUTE_STRAIGHT, .length = 6}, bend, {.kind = ROUTE_STRAIGHT, .length = 4}};
    const double out = 6 + bend.radius * bend.angle, stations[] = {3, 5, out, out + 1.5};
    SceneDef def;
    const hawser_station *found;
    duct_scene(&def, 3, route, out + 2, 0.25);
    scene_stations(&def, 4, stations);
    Sim *const s = pull(&def, 1);
    assert_int_equal(hawser_sim_stations(s, &found), 4);
    const double w = MASS * G;
    check_share(found[1].mean_N - found[0].mean_N, slope_tension(0, w, 0.25, 2, 0), 0.01);
    const double enters = slope_tension(found[1].mean_N, w, 0.25, 1, 0);
    check_share(found[2].mean_N, exact(enters, bend.radius, bend.angle), 0.006);
    for (int i = 0; i < 4; ++i) check_share(found[i].mean_N, found[i].reference_N, 0.006);
    sim_free(s);
}

static double level(double T1, double R, double turn)
{
    double T2 = NAN;
    assert_int_equal(bend_level_tension(T1, MASS * G, 0.25, R, turn, &T2, NULL), HAWSER_OK);
    return T2;
}

static double upward(double T1, double R, double turn)
{
    double T2 = NAN;
    assert_int_equal(bend_vertical_tension(SAG_LEVEL_UP, T1, MASS * G, 0.25, R, turn, &T2, NULL), HAWSER_OK);
    return T2;
}

static double downward(double T1, double R, double turn)
{
    double T2 = NAN;
    assert_int_equal(bend_vertical_tension(CREST_LEVEL_DOWN, T1, MASS * G, 0.25, R, turn, &T2, NULL), HAWSER_OK);
    return T2;
}

TEST(test_level_bend) { bend_check((RoutePieceDef){.kind = ROUTE_BEND, .radius = 5, .angle = 1.2, .plane = 0}, level); }

TEST(test_upward_bend)
{
    bend_check((RoutePieceDef){.kind = ROUTE_BEND, .radius = 5, .angle = 0.6, .plane = M_PI / 2}, upward);
}

TEST(test_downward_bend)
{
    bend_check((RoutePieceDef){.kind = ROUTE_BEND, .radius = 5, .angle = 0.5, .plane = 1.5 * M_PI}, downward);
}

/* An S in three dimensions: up to the left, then down to the right. */
TEST(test_s_bend)
{
    const RoutePieceDef route[] = {{.kind = ROUTE_STRAIGHT, .length = 4},
                                   {.kind = ROUTE_BEND, .radius = 5, .angle = 0.8, .plane = 0.6},
                                   {.kind = ROUTE_BEND, .radius = 6, .angle = 0.9, .plane = M_PI + 0.4},
                                   {.kind = ROUTE_STRAIGHT, .length = 5}};
    const double stations[] = {3, 6, 8, 10.5, 13.4, 14.5};
    SceneDef def;
    const hawser_station *found;
    duct_scene(&def, 4, route, 15, 0.25);
    scene_stations(&def, 6, stations);
    Sim *const s = pull(&def, 1);
    hawser_sim_stations(s, &found);
    for (int i = 0; i < 6; ++i) check_share(found[i].mean_N, found[i].reference_N, 0.006);
    sim_free(s);
}

/* Longer segments, the same pull: two points a segment are enough. */
TEST(test_segments)
{
    const RoutePieceDef route[] = {{.kind = ROUTE_STRAIGHT, .length = 6},
                                   {.kind = ROUTE_BEND, .radius = 5, .angle = 1.2, .plane = 0},
                                   {.kind = ROUTE_STRAIGHT, .length = 4}};
    const double segment[] = {0.5, 0.25, 0.125};
    double pulled[3];
    for (int k = 0; k < 3; ++k) {
        SceneDef def;
        hawser_summary summary;
        duct_scene(&def, 3, route, 14, segment[k]);
        def.surfaces[0].shape.radius = 0.035; /* room for what an arc of 0.5 m deviates from a circle */
        def.surfaces[0].shape.lift = 0.005;
        def.cables[0].ei_y = def.cables[0].ei_z = 100;
        def.duration = 4;
        Sim *const s = pull(&def, 1);
        hawser_sim_summary(s, &summary);
        pulled[k] = summary.pull_mean_N;
        print_message("%.3f m: %.2f N\n", segment[k], pulled[k]);
        sim_free(s);
    }
    check_share(pulled[1], pulled[2], 1e-3);
    check_share(pulled[0], pulled[2], 3e-3);
}

/* One thread and two: the same state to the last bit. */
TEST(test_threads)
{
    const RoutePieceDef route[] = {{.kind = ROUTE_STRAIGHT, .length = 4},
                                   {.kind = ROUTE_BEND, .radius = 5, .angle = 0.8, .plane = 0.6},
                                   {.kind = ROUTE_STRAIGHT, .length = 4}};
    const hawser_sample *look[2];
    Sim *s[2];
    for (int k = 0; k < 2; ++k) {
        SceneDef def;
        duct_scene(&def, 3, route, 10, 0.25);
        def.duration = 1;
        s[k] = pull(&def, 1 + k);
        look[k] = hawser_sim_sample(s[k]);
    }
    assert_memory_equal(look[0]->position, look[1]->position, 3 * (size_t)look[0]->segments * sizeof(double));
    assert_memory_equal(look[0]->velocity, look[1]->velocity, 3 * (size_t)look[0]->segments * sizeof(double));
    check_equal(look[0]->winch_force, look[1]->winch_force);
    check_equal(look[0]->surface_normal[0], look[1]->surface_normal[0]);
    sim_free(s[0]);
    sim_free(s[1]);
}

/* A cable of 10 m over a plane with this normal, its skin `above` it; nothing holds it. */
static void plane_scene(SceneDef *def, double slope, double above, double mu)
{
    const RoutePieceDef route[] = {{.kind = ROUTE_STRAIGHT, .length = 10}};
    duct_scene(def, 1, route, 10, 0.5);
    def->head_at = 10;
    def->route_slope = slope;
    def->winch.present = 0;
    def->tail.tension.v1 = 0;
    const Vec3 normal = v3(-sin(slope), 0, cos(slope));
    def->surfaces[0].friction = (FrictionLaw){.mu_s = mu, .mu_d = mu, .v_s = 1e-3, .v_d = 2e-3};
    def->surfaces[0].shape = (SurfaceShape){.kind = SURFACE_PLANE,
                                            .fade = 0.1,
                                            .cable_radius = RADIUS,
                                            .point = v3_scale(-RADIUS - above, normal),
                                            .normal = normal,
                                            .along = v3(cos(slope), 0, sin(slope))};
    def->output.steady_from = 0;
}

/* Runs without relaxing. */
static Sim *release(SceneDef *def, double end)
{
    hawser_error err = {0};
    def->duration = end;
    Sim *const s = sim_made(def, 1);
    if (sim_advance(s, end, 0, &err)) fail_msg("%s", err.message);
    return s;
}

/* Let go 50 mm above a floor the cable comes to rest on it, and the floor bears its weight. */
TEST(test_fall)
{
    SceneDef def;
    plane_scene(&def, 0, 0.05, 0.3);
    const double k = def.line_impact.k;
    Sim *const s = release(&def, 3);
    const hawser_sample *const look = hawser_sim_sample(s);
    double fastest = 0;
    for (int i = 0; i < 3 * look->segments; ++i) fastest = larger_of(fastest, fabs(look->velocity[i]));
    const double middle = look->position[3 * (look->segments / 2) + 2], settled = pow(MASS * G / k, 1 / 1.5);
    print_message("fastest %.2e m/s, depth %.4e m, exact %.4e\n", fastest, -0.05 - middle, settled);
    check_below(fastest, 1e-10);
    check_share(look->surface_normal[0], MASS * G * 10, 1e-10);
    check_share(-0.05 - middle, settled, 1e-3);
    sim_free(s);
}

/* Down a slope steeper than its friction it slides with g (sin - mu cos). */
TEST(test_slide)
{
    SceneDef def;
    const double slope = 0.4, mu = 0.2, exact = -G * (sin(slope) - mu * cos(slope));
    plane_scene(&def, slope, 0, mu);
    Sim *const s = release(&def, 0.5);
    const double before = hawser_sim_sample(s)->axial_speed[10];
    hawser_error err;
    assert_int_equal(sim_advance(s, 1, 0, &err), HAWSER_OK);
    const double after = hawser_sim_sample(s)->axial_speed[10];
    check_share((after - before) / 0.5, exact, 1e-5);
    sim_free(s);
}
