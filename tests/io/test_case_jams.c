/* Jams in case files: what they become, mistakes that no table of keys can see, and the example. */
#include "tests/io/case_fixture.h"
#include "tests/io/example_fixture.h"

TEST(jams)
{
    SceneDef def, copy;
    expect_good(data_text("full-ramps"), NULL, NULL, &def);
    assert_int_equal(scene_def_copy(&def, &copy, NULL), HAWSER_OK);
    scene_def_clear(&def);
    assert_int_equal(copy.n_jams, 2);
    const JamDef *const jam = copy.jams;
    assert_string_equal(jam[0].what, "P3");
    check_close(jam[0].at, 20, 1e-15);
    check_close(jam[0].release, 25, 1e-15);
    check_close(jam[0].ramp, 0.2, 1e-15);
    check_close(jam[0].friction, 0.5, 1e-15);
    check_nan(jam[0].head_at);
    check_nan(jam[0].release_head_at);
    assert_string_equal(jam[1].what, "front");
    check_close(jam[1].head_at, 26, 1e-15);
    check_close(jam[1].release_head_at, 27, 1e-15);
    check_close(jam[1].ramp, 0.1, 1e-15);
    check_nan(jam[1].at);
    check_nan(jam[1].release);
    check_nan(jam[1].friction);
    scene_def_clear(&copy);
}

TEST(wrong_jams)
{
    static const struct {
        const char *value, *part;
    } cases[] = {
        {"[{what: P99, at: 1 s}]",
         "'jams.0.what': value 'P99' is not the name of anything that can jam: there is 'P1'"},
        {"[{what: P1}]", "'jams.0.at': missing: give it, or 'head_at'"},
        {"[{at: 1 s}]", "'jams.0.what': missing"},
        {"[{what: P1, at: 1 s, head_at: 26 m}]", "'jams.0.head_at': not allowed beside 'at'"},
        {"[{what: P1, head_at: 25 m}]",
         "'jams.0.head_at': value '25 m' is out of range: must be above 'route.head_at'"},
        {"[{what: P1, at: 1 s, release: 1.05 s}]",
         "'jams.0.release': value '1.05 s' is out of range: must be at least"},
        {"[{what: P1, at: 1 s, release: 3 s, release_head_at: 27 m}]",
         "'jams.0.release_head_at': not allowed beside 'release'"},
        {"[{what: P1, head_at: 27 m, release_head_at: 26 m}]",
         "'jams.0.release_head_at': value '26 m' is out of range"},
        {"[{what: P1, at: 1 s, ramp: 0 s}]", "'jams.0.ramp': value '0 s' is out of range"},
        {"[{what: front, at: 1 s, friction: 0.5}]", "'jams.0.friction': not allowed: it is a roller's"},
        {"[{what: P1, at: 1 s}, {what: P1, at: 9 s}]", "'jams.1.what': value 'P1' jams already"},
    };
    for (size_t k = 0; k < sizeof cases / sizeof *cases; k++) {
        expect_bad(data_text("full-ramps"), "jams", cases[k].value, cases[k].part);
    }
    expect_bad(data_text("full-ramps"), "conveyors.0.name", "P3",
               "'jams.0.what': value 'P3' is the name of 2 things that can jam");
    expect_bad(data_text("winch-route"), "jams", "[{what: P1, at: 1 s}]", "there is nothing that can jam");
}

/* The example: the pull with rollers that turn, 0.4 W of 2 m more while one stands, and as before. */
TEST(example)
{
    const double weight = 46.67 * 9.81, free = 0.1 * weight * 20, more = 0.4 * weight * 2;
    hawser_error err = {0};
    hawser_relaxation relaxation;
    hawser_sim *const s = example_sim("jam", NULL);
    if (hawser_sim_relax(s, &relaxation, &err)) fail_msg("%s", err.message);
    double mean[3] = {0};
    int count[3] = {0};
    for (int k = 1; k <= 400; ++k) {
        if (hawser_sim_advance(s, 0.05 * k, 0, &err)) fail_msg("%s", err.message);
        const int state_now = k <= 80 ? -1 : k <= 160 ? 0 : k <= 168 ? -1 : k <= 280 ? 1 : k <= 288 ? -1 : 2;
        if (state_now < 0) continue;
        mean[state_now] += hawser_sim_sample(s)->winch_force;
        ++count[state_now];
    }
    for (int w = 0; w < 3; ++w) mean[w] /= count[w];
    check_share(mean[0], free, 1e-3);
    check_share(mean[1], free + more, 0.01);
    check_share(mean[2], free, 1e-3);
    const hawser_event *event;
    assert_int_equal(hawser_sim_events(s, &event), 2);
    assert_string_equal(event[0].what, "roller G6 jams");
    check_close(event[0].t, 8, 1e-9);
    check_close(event[1].t, 14, 1e-9);
    hawser_sim_free(s);
}
