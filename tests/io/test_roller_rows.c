/* Rows of grooved rollers and of guides as cases describe them: where they stand, how they sit, what is refused. The
 * two example cases against what can be said about them by hand. */
#include "tests/io/case_fixture.h"

#include "tests/io/example_fixture.h"

static const double RADIUS = 0.04365; /* of the cable in data_text("smallest"), m */

static const char BENDS[] = "{pieces: [{straight: 5 m}, {bend: 30 deg, radius: 6 m, plane: left}, "
                            "{bend: 20 deg, radius: 6 m, plane: up}, {straight: 4 m}, "
                            "{bend: 40 deg, radius: 5 m, plane: right, grade: plane}, {straight: 3 m}]}";

/* A case on that route with one row. */
static void row_read(const char *row, SceneDef *def)
{
    CaseTree *tree;
    hawser_error err;
    assert_int_equal(case_tree_parse(data_text("smallest"), NAME, &tree, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "route", BENDS, &err), HAWSER_OK);
    assert_int_equal(case_tree_set(tree, "rollers.along", row, &err), HAWSER_OK);
    if (case_read(tree, def, &err)) fail_msg("%s", err.message);
    case_tree_free(tree);
}

/* Bends and straights share the route between them: places never meet and no gap is longer than the larger spacing. */
TEST(bends_and_straights)
{
    SceneDef def;
    row_read("[{where: bends, spacing: 600 mm}, {where: straights, spacing: 2 m, from: -3 m, to: 21 m}]", &def);
    Route route = route_of(&def);
    int n = 0;
    double s[100];
    for (int k = 0; k < def.n_rollers; k++) {
        const RoutePoint at = route_at(&route, def.rollers[k].s);
        const int bend = v3_norm(at.curvature) > 0;
        assert_int_equal(bend, k < 15); /* 5.24 m in 9 parts, 3.49 m in 6 */
        s[n++] = def.rollers[k].s;
    }
    for (int i = 0; i < n; i++) {
        double next = INFINITY;
        for (int k = 0; k < n; k++) {
            if (s[k] > s[i]) next = smaller_of(next, s[k] - s[i]);
        }
        check_above(next, 0.29);
        if (!isinf(next)) check_at_most(next, 2 + 1e-9);
    }
    check_share(def.rollers[0].s, 5 + (M_PI + 2 * M_PI / 3) / 18, 1e-12);
    check_share(def.rollers[15].s, -3 + 1, 1e-12);
    route_clear(&route);
    scene_def_clear(&def);
    row_read("{where: [[1 m, 2 m], [9 m, 9.5 m]], spacing: 500 mm}", &def);
    assert_int_equal(def.n_rollers, 3);
    check_share(def.rollers[1].s, 1.75, 1e-12);
    check_share(def.rollers[2].s, 9.25, 1e-12);
    scene_def_clear(&def);
}

/* Guides stand upright beside the line, on the side of the bend's centre, by gap and radii away; none in the bend
 * upward. */
TEST(guides_inside)
{
    SceneDef def;
    row_read("{guide: inside, spacing: 500 mm, gap: 15 mm, radius: 70 mm, width: 200 mm, rating: 3 kN}", &def);
    Route route = route_of(&def);
    assert_int_equal(def.n_rollers, 14); /* 3.14 m in 7 parts, 3.49 m in 7 */
    for (int k = 0; k < 14; k++) {
        const RollerDef *roller = &def.rollers[k];
        const RoutePoint at = route_at(&route, roller->s);
        const Vec3 away = v3_sub(roller->centre, at.position);
        check_share(v3_norm(away), 0.07 + RADIUS + 0.015, 1e-12);
        /* the second bend is on a slope, where level and toward the centre part by a little */
        check_share(v3_dot(away, at.curvature), v3_norm(away) * v3_norm(at.curvature), k < 7 ? 1e-12 : 0.1);
        check_close(v3_dot(roller->axis, at.tangent), 0, 1e-12);
        check_close(v3_dot(roller->axis, away), 0, 1e-12);
        assert_string_equal(strchr(roller->name, ' '), k < 7 ? " left" : " right");
        check_share(roller->rating, 3e3, 0);
    }
    route_clear(&route);
    scene_def_clear(&def);
    row_read("{guide: both, where: straights, spacing: 3 m}", &def);
    assert_int_equal(def.n_rollers, 2 * (2 + 2 + 1));
    assert_string_equal(def.rollers[0].name, "R1 left");
    assert_string_equal(def.rollers[1].name, "R1 right");
    scene_def_clear(&def);
    /* askew: only bends to the side have an inside */
    row_read("{guide: inside, where: [[0 m, 8.5 m]], spacing: 500 mm}", &def);
    assert_in_range(def.n_rollers, 6, 7);
    scene_def_clear(&def);
}

/* A grooved roller is as far below the line as the cable sits in it, a hold-down as far above. */
TEST(grooves_are_sat_in)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers.along",
                "{count: 3, radius: 80 mm, profile: v, groove: {angle: 60 deg}, hold_down: [[9 m, 11 m]]}", &def);
    assert_int_equal(def.n_rollers, 4);
    check_share(def.rollers[0].centre.z, -0.08 - RADIUS / 0.5, 1e-12);
    check_share(def.rollers[2].centre.z, 0.08 + RADIUS / 0.5, 1e-12);
    assert_int_equal(def.rollers[0].profile, SHAPE_V_GROOVE);
    check_share(def.rollers[0].groove.depth, 2 * RADIUS, 1e-12);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along",
                "{count: 3, radius: 80 mm, gap: 12 mm, hold_down: [[9 m, 11 m]]}", &def);
    check_share(def.rollers[0].centre.z, -0.08 - RADIUS, 1e-12); /* a gap is above the cable only */
    check_share(def.rollers[2].centre.z, 0.08 + RADIUS + 0.012, 1e-12);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along", "{count: 3, profile: u, radius: 80 mm}", &def);
    check_share(def.rollers[0].centre.z, -0.08 - RADIUS, 1e-12);
    check_share(def.rollers[0].groove.radius, 1.25 * RADIUS, 1e-12);
    check_share(def.rollers[0].groove.lip, 1.25 * RADIUS, 1e-12);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.list",
                "[{centre: [18, 0, -130 mm], axis: [0, 1, 0], radius: 80 mm, profile: u, groove: {depth: 40 mm}}]",
                &def);
    assert_int_equal(def.rollers[0].profile, SHAPE_U_GROOVE);
    scene_def_clear(&def);
}

TEST(bad_rows)
{
    static const char *const bad[][2] = {
        {"{count: 3, groove: {angle: 90 deg}}", "key 'rollers.along.groove': only for 'profile: v' or 'profile: u'"},
        {"{count: 3, profile: v, groove: {radius: 60 mm}}", "key 'rollers.along.groove.radius': only for 'profile: u'"},
        {"{count: 3, profile: u, groove: {angle: 60 deg}}", "key 'rollers.along.groove.angle': only for 'profile: v'"},
        {"{count: 3, profile: v, groove: {depth: 20 mm}}",
         "key 'rollers.along.groove.depth': out of range: the thickest"},
        {"{count: 3, profile: v, groove: {angle: 25 deg}}", "key 'rollers.along.groove.depth': out of range"},
        {"{count: 3, profile: v, width: 100 mm}", "key 'rollers.along.width': 0.1 m is out of range"},
        {"{count: 3, profile: u, groove: {radius: 43 mm}}",
         "key 'rollers.along.groove.radius': out of range: must be above"},
        {"{count: 3, profile: u, groove: {depth: 60 mm}}",
         "key 'rollers.along.groove.depth': out of range: must be at most"},
        {"{count: 3, guide: inside}", "key 'rollers.along.count': given: rows of guides"},
        {"{where: bends}", "key 'rollers.along.spacing': missing: rows of guides"},
        {"{where: bends, spacing: 1 m, count: 3}", "key 'rollers.along.count': given"},
        {"{spacing: 1 m, guide: both, hold_down: sag}", "key 'rollers.along.hold_down': not for guides"},
        {"{spacing: 1 m, gap: 5 mm}", "key 'rollers.along.gap': only with 'guide', 'hold_down' or 'rule'"},
        {"{spacing: 1 m, where: [[3 m, 2 m]]}", "expected [from, to] with to >= from"},
        {"{spacing: 1e-6, where: straights}", "too many rollers"},
        {"{count: 60000, hold_down: [[0 m, 20 m]]}", "a run with 120000 rollers"},
        {"{spacing: 1 m, from: 5 m, to: 2 m, where: straights}", "out of range: must be at least 'from'"},
    };
    for (size_t k = 0; k < sizeof bad / sizeof *bad; k++)
        expect_bad(data_text("smallest"), "rollers.along", bad[k][0], bad[k][1]);
    /* in a groove that is there but where the cable does not fit in */
    expect_bad(data_text("smallest"), "rollers.list",
               "[{centre: [18, 0, -100 mm], axis: [0, 1, 0], radius: 80 mm, profile: v, name: it}]",
               "roller 'it' is inside the cable");
}

/* As many rollers as a case may have, one at each of their places. */
TEST(most_rollers)
{
    SceneDef def;
    expect_good(data_text("smallest"), "rollers.along", "{count: 100000}", &def);
    assert_int_equal(def.n_rollers, 100000);
    scene_def_clear(&def);
}

/* Each roller's own law wins over the case's, and takes from it what it does not say. */
TEST(friction_that_sticks)
{
    SceneDef def;
    expect_good(data_text("smallest"), "friction", "{mu: 0.3}", &def);
    check_equal(def.friction.d_s, 0);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "friction", "{mu: 0.3, law: stick}", &def);
    check_equal(def.friction.d_s, 1e-4);
    check_equal(def.cable_friction.d_s, 0);
    scene_def_clear(&def);
    expect_good(data_text("smallest"), "rollers.along",
                "[{count: 1, friction: {law: stick, d_s: 0.3 mm}}, {from: 9 m, count: 1, friction: {law: adams}}]",
                &def);
    check_equal(def.rollers[0].friction.d_s, 3e-4);
    check_equal(def.rollers[1].friction.d_s, 0);
    scene_def_clear(&def);
    expect_bad(data_text("smallest"), "friction", "{d_s: 0.1 mm}", "key 'friction.d_s': only for 'law: stick'");
    expect_bad(data_text("smallest"), "friction", "{law: adams, d_s: 0.1 mm}",
               "key 'friction.d_s': only for 'law: stick'");
    expect_bad(data_text("smallest"), "friction", "{law: sticky}", "expected adams or stick");
    expect_bad(data_text("smallest"), "contact", "{cable_on_cable: true, cable_friction: {law: stick}}",
               "cable on cable does not stick");
}

/* Runs an example case with settings, and returns its pull. */
static double pull_of(const char *name, const char *const *settings, hawser_summary *summary)
{
    const Outcome out = example_run(name, settings);
    *summary = out.summary;
    hawser_sim_free(out.sim);
    return summary->pull_mean_N;
}

/* The wedge makes mu into mu/sin(half angle); one and two threads give the same bits. */
TEST(v_groove_case)
{
    const char *const steep[] = {"rollers.along.groove.angle",
                                 "60 deg",
                                 "rollers.along.groove.depth",
                                 "80 mm",
                                 "rollers.along.friction.mu",
                                 "0.1",
                                 "run.duration",
                                 "14 s",
                                 NULL};
    const char *const two[] = {"solver.threads", "2", NULL};
    hawser_summary summary;
    const double weight = 22 * 9.81 * 20;
    const double found = pull_of("rollers-v-groove", NULL, &summary);
    check_share(found, 0.2 * weight, 2e-3);
    assert_true(summary.relaxation.reached);
    check_equal(pull_of("rollers-v-groove", two, &summary), found);
    check_share(pull_of("rollers-v-groove", steep, &summary), 0.1 / 0.5 * weight, 5e-3);
}

/* Weight on the carriers, T/R on the guides: what the case's comment derives, at the middle of the window. */
TEST(guide_case)
{
    hawser_summary summary;
    const double found = pull_of("guide-rollers", NULL, &summary);
    const double w = 22 * 9.81, mu = 0.2, R = 10, arc = M_PI / 3 * R, travel = 0.1 * (9.5 - 2);
    const double in = 10 - (1 + travel), out = 31 + travel - (10 + arc);
    const double T1 = 3000 + mu * w * in, T2 = (T1 + w * R) * exp(mu * M_PI / 3) - w * R;
    check_share(found, T2 + mu * w * out, 0.015);
    /* and the theory knows that supports are separate there; the chain's chords put the tail 0.3 mm ahead */
    check_share(summary.reference_total_N, T2 + mu * w * out, 1e-5);
}
