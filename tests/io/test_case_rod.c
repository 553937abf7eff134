/* Rods in case files: what they become, mistakes that no table of keys can see, and the cases of cases/. */
#include "hawser/hawser.h"
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

TEST(a_rod_is_read)
{
    SceneDef def;
    expect_good(data_text("full-rod"), NULL, NULL, &def);
    const RodDef *const rod = &def.rod;
    assert_int_equal(rod->shape, ROD_HELIX);
    assert_int_equal(rod->stress_free, 0);
    check_share(rod->pitch, 0.5, 1e-15);
    check_share(rod->roll_rate, 40.0 / 6 * 3.14159265358979 / 180, 1e-12);
    const RodEndDef *const tail = &rod->end[ROD_TAIL], *const head = &rod->end[ROD_HEAD];
    const int held[2][6] = {{1, 1, 1, 1, 0, 0}, {0, 1, 1, 1, 1, 1}};
    assert_memory_equal(tail->held, held[0], sizeof held[0]);
    assert_memory_equal(head->held, held[1], sizeof held[1]);
    assert_int_equal(tail->n_motions, 4);
    check_share(profile_value(&tail->motions[0].by.size, 0.3), 0.02, 1e-15);
    check_share(profile_value(&tail->motions[1].by.size, 0.25), 0.2617993877991494, 1e-12);
    assert_true(tail->motions[2].rates && !tail->motions[2].turns && !tail->motions[0].rates);
    assert_true(tail->motions[3].rates && tail->motions[3].turns);
    check_share(profile_value(&tail->motions[2].by.size, 0.25), 0.01, 1e-15);
    assert_int_equal(rod->n_loads, 2);
    assert_int_equal(rod->loads[0].follower, 1);
    assert_int_equal(rod->loads[1].moment, 1);
    check_share(rod->loads[1].at, 6, 1e-15); /* the head's end */
    check_share(profile_value(&rod->loads[1].by.size, 0.5), 2, 1e-12);
    assert_int_equal(def.analysis.kind, ANALYSIS_MODES);
    assert_int_equal(def.output.n_probes, 1);
    check_share(def.output.interval, 0.05, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("full-rod-polyline"), NULL, NULL, &def);
    assert_true(def.rod.end[ROD_TAIL].pivot && !def.rod.end[ROD_HEAD].held[0]);
    assert_true(def.rod.stress_free);
    scene_def_clear(&def);
}

/* Without a ramp a load is there from the start; in load steps it grows with time. */
TEST(loads_grow_in_load_steps)
{
    SceneDef def;
    const char *const load = "[{direction: [0, 0, 1], force: 8 N}]";
    expect_good(data_text("full-rod-polyline"), "rod.loads", load, &def);
    check_share(profile_value(&def.rod.loads[0].by.size, 0), 8, 1e-15);
    scene_def_clear(&def);
    expect_good(data_text("full-rod"), "rod.loads", load, &def);
    check_share(profile_value(&def.rod.loads[0].by.size, 0.25), 2, 1e-15);
    scene_def_clear(&def);
}

TEST(wrong_rods)
{
    const char *const corners = data_text("full-rod-polyline"), *const helix = data_text("full-rod");
    expect_bad(corners, "rod.points", "[[0, 0, 0], [2 m, 0, 0]]", "6 m long together");
    expect_bad(corners, "rod.points", "[[0, 0, 0]]", "expected two at least");
    expect_bad(corners, "rod.points", "[[0, 0, 0], [0, 0, 0], [6 m, 0, 0]]", "another place");
    expect_bad(corners, "rod.shape", "arc", "'rod.radius': missing: 'shape: arc' needs it");
    expect_bad(corners, "rod.heading", "3 deg", "'rod.heading': not allowed with 'shape: polyline'");
    expect_bad(helix, "rod.radius", "100 mm", "the length of a segment at least");
    expect_bad(helix, "rod.head.hold", "[axial]", "only with 'fixing: held'");
    expect_bad(helix, "rod.tail.hold", "[axial, bend]", "expected axial, shear_y");
    expect_bad(helix, "rod.head", "{fixing: held}", "'rod.head.hold': missing");
    expect_bad(helix, "rod.head", "{fixing: free, motion: []}", "not allowed with 'fixing: free'");
    expect_bad(helix, "rod.tail.motion.0.turn", "1 rad", "too much: give one of 'move', 'turn', 'speed' and 'spin'");
    expect_bad(helix, "rod.loads.0.moment", "1 N m", "give either 'force' or 'moment'");
    expect_bad(helix, "rod.loads.0.direction", "[0, 0, 0]", "not zero");
    expect_bad(helix, "rod.loads.0.at", "7 m", "must be on the chain, at most 6 m");
    expect_bad(helix, "rod.loads.0.to", "0 s", "must be above 'from'");
    expect_bad(helix, "rod.loads.1.ramp", "step", "not allowed beside 'table'");
    expect_bad(helix, "rod.masses.0.at", "6.1 m", "must be on the chain");
    expect_bad(helix, "output.probes.0.at", "6.1 m", "must be on the chain");
}

/* What belongs to a pull is refused beside a rod, and the other way round. */
TEST(rods_are_no_pulls)
{
    const char *const base = data_text("full-rod-polyline"), *const beside = "not allowed beside 'rod'";
    expect_bad(base, "route", "{pieces: [{straight: 3 m}]}", beside);
    expect_bad(base, "drive", "{winch: {speed: 1 m/s}}", beside);
    expect_bad(base, "lead_in", "{}", beside);
    expect_bad(base, "conveyors", "[]", beside);
    expect_bad(base, "limits", "{}", beside);
    expect_bad(base, "rollers", "{along: {spacing: 1 m}}", beside);
    expect_bad(base, "surfaces", "{ducts: [{radius: 1 m}]}", beside);
    expect_bad(base, "output.stations", "{spacing: 1 m}", beside);
    expect_bad(base, "cables.strip",
               "{d: 10 mm, EA: 1 MN, GA: 1 MN, GJ: 1 kN m2, mass: 1 kg/m, bending: {table: [[1, 1], [2, 1.5]]}}",
               "bends elastically");
    expect_bad(data_text("smallest"), "run.analysis", "static", "'run.analysis': only a 'rod' can be analysed so");
    expect_bad(base, "run.load_steps", "3", "only with 'analysis: static' or 'modes'");
    expect_bad(base, "run", "{}", "'run.duration': missing");
}

/* Runs a case of cases/ and returns what its probe says at the end. */
static hawser_probe probe_of(const char *name, const char *probe)
{
    char path[512];
    hawser_error err = {0};
    hawser_case *c = NULL;
    hawser_sim *sim = NULL;
    hawser_summary summary;
    hawser_probe out = {0};
    snprintf(path, sizeof path, "%s/cases/%s.yaml", HAWSER_SOURCE_DIR, name);
    assert_int_equal(hawser_case_load(path, &c, &err), HAWSER_OK);
    if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(sim, &summary);
    assert_true(summary.rod && summary.relaxation.reached);
    assert_string_equal(summary.analysis, "static");
    for (int i = 0; i < summary.n_probes; ++i) {
        if (strcmp(summary.probes[i].name, probe) == 0) out = summary.probes[i];
    }
    char *text = NULL;
    assert_int_equal(hawser_sim_summary_json(sim, &text, &err), HAWSER_OK);
    check_has(text, probe);
    hawser_text_free(text);
    assert_int_equal(hawser_case_theory(c, HAWSER_TABLE, &text, &err), HAWSER_ERR_INPUT);
    check_has(err.message, "needs a route");
    assert_int_equal(hawser_case_describe(c, HAWSER_JSON, &text, &err), HAWSER_OK);
    hawser_text_free(text);
    hawser_case_free(c);
    hawser_sim_free(sim);
    return out;
}

TEST(cases_run)
{
    const hawser_probe tip = probe_of("rod-cantilever", "tip"), root = probe_of("rod-cantilever", "root");
    check_share(tip.displacement[2], -0.8106090, 0.001);
    check_share(tip.displacement[0], -0.5549956, 0.001);
    check_share(tip.rotation[1], 1.4302855, 0.001);
    check_share(root.force[2], -10e3, 1e-10);
    check_share(root.moment[1], 10e3 * tip.position[0], 5e-8);
    const hawser_probe end = probe_of("rod-rollup", "tip"), middle = probe_of("rod-rollup", "middle");
    for (int c = 0; c < 3; ++c) check_close(end.position[c], 0, 1e-8);
    check_share(middle.position[2], 0.5 / sin(3.14159265358979 / 20), 5e-10);
    check_share(middle.moment[1], -628.3185307, 2e-9);
}

/* Three modes in each direction, the frequencies of the summary, against the closed form within 0.5 %. */
TEST(modes_run)
{
    hawser_error err = {0};
    const hawser_mode *mode;
    const double expected[6] = {8.957, 2 * 8.957, 56.13, 2 * 56.13, 157.2, 2 * 157.2};
    hawser_sim *const sim = example_sim("rod-modes", NULL);
    assert_int_equal(hawser_sim_modes(sim, &mode), 0);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    assert_int_equal(hawser_sim_modes(sim, &mode), 6);
    for (int k = 0; k < 5; ++k) check_share(mode[k].frequency_Hz, expected[k], 0.005);
    check_share(mode[5].frequency_Hz, expected[5], 0.03); /* shear takes 2.4 % */
    hawser_sim_free(sim);
}

/* An elastic catenary, its head pinned and led up by 30 m: the joint there has the tension along the cable, in every
 * load step (it had 6130 N at the end, by a frame half way to the ground's, and 10 273 N before it, with the damper of
 * an end that moves in no time), and is the largest. */
TEST(a_pinned_end_that_turns)
{
    static const char text[] =
        "cables: {c: {d: 30 mm, mass: 5 kg/m, EI: 0.5, EA: 200 kN, GA: 80 kN, GJ: 0.5}}\n"
        "chain: [{cable: c, length: 100 m, segment: 500 mm}]\n"
        "rod: {tail: {fixing: pinned}, head: {fixing: pinned, motion: [{direction: [0,0,1], move: 30 m}, "
        "{direction: [-1,0,0], move: 5 m}]}}\nrun: {analysis: static, load_steps: 20, stability: ignore}\n";
    hawser_error err = {0};
    hawser_sim *const sim = sim_of(text, NULL);
    for (int k = 0; k < 2; k++) {
        if (hawser_sim_advance(sim, k ? 1 : 0.95, 0, &err)) fail_msg("%s", err.message);
        const hawser_sample *const now = hawser_sim_sample(sim);
        check_share(now->tension[200], k ? 6514.95 : 6381.59, 1e-5);
        assert_int_equal(now->max_tension_joint, 200);
        if (!k) continue;
        /* H and V at the head, w = 5 * 9.81, unstretched length 100, span 95, rise 30 */
        for (int j = 1; j <= 200; ++j)
            check_share(now->tension[j], hypot(5027.614, 4143.456 - 49.05 * 0.5 * (200 - j)), 2e-4);
    }
    hawser_sim_free(sim);
}
