/* cases/drum-contact.yaml through the public interface, and what a reel with `model: contact` refuses. */
#include "tests/io/example_fixture.h"

static hawser_status open_case(const char *key, const char *value, hawser_sim **sim, hawser_error *err)
{
    const char *const settings[] = {key, value, NULL};
    return example_open("drum-contact", key ? settings : NULL, sim, err);
}

/* Torque over radius and the work of straightening, for the polygon of segments (CC25), and the tray's friction. */
TEST(test_pull)
{
    hawser_sim *sim = NULL;
    hawser_error err = {0};
    hawser_summary s;
    if (open_case(NULL, NULL, &sim, &err)) fail_msg("%s", err.message);
    if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
    hawser_sim_summary(sim, &s);
    const double turn = 2 * atan(0.03125 / 0.275) / 0.0625, expected = 100 * turn + 5 * turn * turn / 2 + 1.2;
    print_message("pull %.2f N, expected %.2f N\n", s.pull_mean_N, expected);
    check_share(s.pull_mean_N, expected, 0.01);
    hawser_sim_free(sim);
}

/* The same rope from the reel that only pays out: what the two models differ by is the work of straightening, and the
 * polygon of segments that lies on the drum. */
TEST(test_beside_payout)
{
    const char *const set[][2] = {{"reel.model", "payout"},
                                  {"reel.brake", "{law: constant, torque: 100 N m}"},
                                  {"contact.geometry", "smooth"},
                                  {"contact.cable_on_cable", "false"},
                                  {"solver.relax", "true"}};
    double pull[2];
    for (int payout = 0; payout < 2; ++payout) {
        hawser_case *c = NULL;
        hawser_sim *sim = NULL;
        hawser_error err = {0};
        hawser_summary s;
        assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/drum-contact.yaml", &c, &err), HAWSER_OK);
        for (int k = 0; payout && k < 5; ++k) {
            if (hawser_case_set(c, set[k][0], set[k][1], &err)) fail_msg("%s", err.message);
        }
        if (hawser_sim_new(c, NULL, &sim, &err)) fail_msg("%s", err.message);
        if (hawser_sim_run(sim, NULL, NULL, NULL, &err)) fail_msg("%s", err.message);
        hawser_sim_summary(sim, &s);
        pull[payout] = s.pull_mean_N;
        check_share(s.pull_mean_N, s.reference_total_N, (payout ? 1e-3 : 0.015)); /* polygon: 0.4 % */
        hawser_sim_free(sim);
        hawser_case_free(c);
    }
    const double turn = 2 * atan(0.03125 / 0.275) / 0.0625, more = 100 * (turn - 1 / 0.275) + 5 * turn * turn / 2;
    print_message("contact %.2f N, payout %.2f N: %.2f N more, expected %.2f N\n", pull[0], pull[1], pull[0] - pull[1],
                  more);
    check_close(pull[0] - pull[1], more, 0.01 * pull[1]);
}

static void refused(const char *key, const char *value, const char *named, const char *part)
{
    hawser_sim *sim = NULL;
    hawser_error err = {0};
    if (!open_case(key, value, &sim, &err)) fail_msg("accepted: %s = %s", key, value);
    assert_int_equal(err.status, HAWSER_ERR_INPUT);
    if (!strstr(err.message, named) || !strstr(err.message, part)) fail_msg("%s", err.message);
    assert_null(sim);
}

TEST(test_refused)
{
    refused("contact.cable_on_cable", "false", "contact.cable_on_cable", "needs 'contact.cable_on_cable: true'");
    refused("contact.geometry", "smooth", "contact.geometry", "needs 'contact.geometry: cylinder'");
    refused("solver.relax", "true", "solver.relax", "needs 'solver.relax: false'");
    refused("lead_in", "{weight: full}", "lead_in", "not allowed beside a reel");
    refused("reel.end", "fixed", "reel.end", "not allowed with 'model: contact'");
    refused("reel.back_tension", "{tension: 5 N}", "reel.back_tension", "not allowed with 'model: contact'");
    refused("reel.brake", "{law: proportional, torque: 5 N m, speed: 1}", "reel.brake.law", "'law: constant' only");
    refused("reel.flange", "520 mm", "reel.flange", "more cable than fits");
    refused("reel.width", "150 mm", "reel.width", "too narrow");
    refused("reel.distance", "500 mm", "reel.distance", "flange's radius");
    refused("reel.distance", "20 m", "reel", "no cable is left for the drum");
    refused("chain.0.length", "60 m", "reel.width", "more cable than fits");
}

/* Theory lays no cable, and refuses what a run refuses: it gave 398.3 N with status 0. */
TEST(test_refused_by_theory)
{
    static const char *const set[][3] = {{"reel.flange", "520 mm", "more cable than fits"},
                                         {"reel.width", "150 mm", "too narrow"},
                                         {"reel.distance", "500 mm", "flange's radius"},
                                         {"reel.distance", "20 m", "no cable is left for the drum"},
                                         {"chain.0.length", "60 m", "more cable than fits"}};
    for (size_t k = 0; k < sizeof set / sizeof *set; ++k) {
        hawser_case *c = NULL;
        char *text = NULL;
        hawser_error err = {0};
        assert_int_equal(hawser_case_load(HAWSER_SOURCE_DIR "/cases/drum-contact.yaml", &c, &err), HAWSER_OK);
        assert_int_equal(hawser_case_set(c, set[k][0], set[k][1], &err), HAWSER_OK);
        assert_int_equal(hawser_case_theory(c, HAWSER_JSON, &text, &err), HAWSER_ERR_INPUT);
        check_has(err.message, set[k][2]);
        assert_null(text);
        hawser_case_free(c);
    }
}
