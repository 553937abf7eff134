/* Obstacles: what their words become, what is refused; a flare's friction against the capstan's formula; and what
 * happens to a winch whose rope or cable catches. */
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

static const double CABLE_R = 0.04, FLARE = 1, PI = 3.14159265358979323846;

/* A box along the route, an edge across it, a bell-mouth at either end of a duct; names say the kind. */
TEST(words_become_shapes)
{
    SceneDef def;
    expect_good(
        data_text("surfaces"), "obstacles",
        "[{box: kerb, at: 3 m, offset: [0, 1 m, -2 m], size: [300 mm, 200 mm, 100 mm], round: 10 mm, rating: 2 kN},"
        " {edge: lip, centre: [0, 0, -6 m], axis: [0, 2, 0], length: 2 m, radius: 20 mm, friction: {mu: 0.4}}]",
        &def);
    Route route = route_of(&def);
    const RollerDef *const box = &def.rollers[def.n_rollers - 2], *const edge = box + 1;
    const RoutePoint at = route_at(&route, 3);
    const Vec3 left = route_left(&route, 3), up = v3_cross(at.tangent, left);
    assert_string_equal(box->name, "box kerb");
    assert_int_equal(box->profile, SHAPE_BOX);
    check_vec(box->centre, v3_axpy(v3_axpy(at.position, 1, left), -2, up), 1e-12);
    check_vec(box->axis, at.tangent, 1e-15);
    check_close(box->box.side.z, 0, 1e-15);
    check_equal(box->radius, 0.05);
    check_equal(box->width, 0.3);
    check_equal(box->box.half[0], 0.1);
    check_equal(box->box.half[1], 0.05);
    check_equal(box->box.edge, 0.01);
    check_equal(box->rating, 2000);
    check_nan(box->s);
    assert_string_equal(edge->name, "edge lip");
    /* a bar is round: the same distance on all sides of it, and at its ends */
    const Shape bar = roller_def_shape(edge);
    check_close(shape_distance(&bar, v3(0.1, 0.5, -6)), 0.08, 1e-15);
    check_close(shape_distance(&bar, v3(0.06, 0.9, -5.92)), 0.08, 1e-15);
    check_close(shape_distance(&bar, v3(0, 1.1, -6)), 0.1, 1e-15);
    check_equal(edge->friction.mu_d, 0.4);
    route_clear(&route);
    scene_def_clear(&def);
}

TEST(bad_obstacles)
{
    static const char *const bad[][2] = {
        {"[{at: 3 m}]", "key 'obstacles.0': expected one of 'box', 'edge' and 'bell'"},
        {"[{box: a, edge: b, at: 3 m}]", "expected one of 'box', 'edge' and 'bell'"},
        {"[{box: a, at: 3 m}]", "key 'obstacles.0.size': missing"},
        {"[{edge: a, at: 3 m}]", "key 'obstacles.0.radius': missing"},
        {"[{edge: a, at: 3 m, radius: 1 cm, end: exit}]",
         "key 'obstacles.0.end': not allowed for an obstacle of kind 'edge'"},
        {"[{box: a, size: [1, 1, 1]}]", "key 'obstacles.0.at': missing"},
        {"[{box: a, size: [1, 1, 1], at: 3 m, centre: [0, 0, 0]}]", "key 'obstacles.0.at': given beside centre"},
        {"[{box: a, size: [1, 1, 1], centre: [0, 0, -9 m]}]", "key 'obstacles.0.axis': missing"},
        {"[{box: a, size: [1, 1, 1], centre: [0, 0, -9 m], axis: [0, 0, 0]}]",
         "key 'obstacles.0.axis': expected a direction"},
        {"[{box: a, size: [1, 1, 1], centre: [0, 0, -9 m], axis: [1, 0, 0], offset: [0, 0, 1]}]",
         "'obstacles.0.offset': only with 'at'"},
        {"[{box: a, size: [1, 0, 1], at: 3 m}]", "key 'obstacles.0.size': out of range"},
        {"[{box: a, size: [1, 8 mm, 1], at: 3 m}]",
         "key 'obstacles.0.round': 0.005 m is out of range: must be at most half"},
        {"[{box: kerb, at: 3 m, size: [1, 1, 100 mm]}]", "obstacle 'box kerb' is inside the cable: "},
        {"[{bell: nothing, radius: 1 m}]", "key 'obstacles.0.bell': value 'nothing' is not the name of a duct"},
        {"[{bell: duct, radius: 40 mm}]",
         "key 'obstacles.0.radius': value '40 mm' is out of range: must be above the largest"},
        {"[{bell: duct, radius: 45 mm}]", "must be at least the duct's 'fade'"},
        {"[{bell: duct, radius: 1 m, at: 3 m}]", "key 'obstacles.0.at': not allowed for an obstacle of kind 'bell'"},
    };
    char path[512];
    snprintf(path, sizeof path, "%s/cases/bell-mouth.yaml", HAWSER_SOURCE_DIR);
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++) {
        hawser_case *c = NULL;
        hawser_sim *sim = NULL;
        hawser_error err = {0};
        if (hawser_case_load(path, &c, &err) || hawser_case_set(c, "obstacles", bad[k][0], &err))
            fail_msg("%s", err.message);
        assert_int_equal(hawser_sim_new(c, NULL, &sim, &err), HAWSER_ERR_INPUT);
        check_has(err.message, bad[k][1]);
        hawser_case_free(c);
    }
}

static const hawser_roller *obstacle(hawser_sim *sim, const char *name)
{
    const hawser_roller *r;
    const int n = hawser_sim_rollers(sim, &r);
    for (int i = 0; i < n; ++i) {
        if (strcmp(r[i].name, name) == 0) return r + i;
    }
    fail_msg("no obstacle %s", name);
    return NULL;
}

/* The pull behind the flare is T exp(mu theta F/(F + r)) (OB7); what the flare carries is the resultant of T/(F + r)
 * for each metre, which is that of the two tensions. */
TEST(flare_is_a_capstan)
{
    Outcome o = example_run("bell-mouth", NULL);
    const double t1 = 2000, t2 = t1 * exp(0.2 * PI / 6 * FLARE / (FLARE + CABLE_R));
    check_share(o.summary.pull_mean_N, t2, 1e-3);
    check_share(o.summary.reference_total_N, t1 * exp(0.2 * PI / 6), 1e-3); /* theory sees the route's bend */
    const double load = obstacle(o.sim, "bell duct entry")->steady_N;
    check_share(load, sqrt(t1 * t1 + t2 * t2 - 2 * t1 * t2 * cos(PI / 6)), 2e-3);
    check_equal(obstacle(o.sim, "box kerb")->peak_N, 0);
    hawser_sim_free(o.sim);
}

/* The rope's end meets a wall: a winch of set tension stands, and the wall carries what the winch pulls with. */
TEST(end_stops_at_a_face)
{
    const char *const wall[] = {"obstacles", "[{box: wall, at: 58 m, size: [1 m, 2 m, 2 m]}]", NULL};
    Outcome o = example_run("winch-tension", wall);
    Outcome same = example_run("winch-tension", NULL);
    print_message("stands at %g m/s with %g N on the wall\n", o.summary.steady_speed_m_per_s,
                  obstacle(o.sim, "box wall")->steady_N);
    check_below(fabs(o.summary.steady_speed_m_per_s), 1e-3); /* what friction of speed lets creep */
    /* but for what friction holds in the cable behind, as pull or as push */
    const double held = 0.15 * 9.81 * (14 * 40 + 0.68 * 15);
    check_close(obstacle(o.sim, "box wall")->steady_N, 1000, held);
    check_above(same.summary.steady_speed_m_per_s, 0.09);
    hawser_sim_free(o.sim);
    hawser_sim_free(same.sim);
}

/* A cable's eye in front of an opening that only the rope passes: the pull rises until the winch trips, and stays. */
TEST(eye_catches_and_trips)
{
    const char *const gate[] = {"obstacles",
                                "[{edge: sill, at: 42 m, offset: [0, 0, -130 mm], length: 1 m, radius: 100 mm},"
                                " {edge: lintel, at: 42 m, offset: [0, 0, 130 mm], length: 1 m, radius: 100 mm}]",
                                "drive.tail.table",
                                "[[0 s, 0 N], [1 s, 300 N], [2 s, 300 N]]",
                                "drive.winch.trip.brake",
                                "50 ms",
                                "drive.winch.trip.restarts",
                                "0",
                                "run.steady_from",
                                "25 s",
                                NULL};
    Outcome o = example_run("winch-trip", gate);
    const hawser_event *event;
    const int n = hawser_sim_events(o.sim, &event);
    check_at_least(n, 1);
    print_message("%d events, first at %g s with %g N; sill %g N, lintel %g N\n", n, event[0].t, event[0].pull_N,
                  obstacle(o.sim, "edge sill")->peak_N, obstacle(o.sim, "edge lintel")->peak_N);
    check_above(event[0].pull_N, 1.5 * o.summary.reference_total_N);
    check_below(fabs(o.summary.steady_speed_m_per_s), 1e-3);
    check_above(obstacle(o.sim, "edge lintel")->peak_N, 500);
    hawser_sim_free(o.sim);
}
